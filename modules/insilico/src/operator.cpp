// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/operator.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "operator_hand.h"

namespace glisson::insilico {
namespace {

constexpr int kMostCorners = 40, kFewestCorners = 20;
constexpr double kInsidePx = 5.0;    // a person stays inside the outline
constexpr double kBandMm = 5.0;      // half width of the margin's band
constexpr double kNotchMm = 9.0;     // radius about the notch
constexpr double kSmallestPx = 150;  // a region of less area is left out

Points shaken(const Points& points, double noise_mm, Hand& hand) {
  Points clicked = points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    clicked.row(i) += 1e-3 * noise_mm * hand.tremor3().transpose();
  return clicked;
}

/// Points at equal distances along a polyline.
Points along(const Points& line, int count) {
  if (line.rows() < 2) return line;
  std::vector<double> way{0.0};
  for (Eigen::Index i = 1; i < line.rows(); ++i)
    way.push_back(way.back() + (line.row(i) - line.row(i - 1)).norm());
  Points points(count, 3);
  std::size_t segment = 1;
  for (int i = 0; i < count; ++i) {
    const double at = way.back() * i / (count - 1);
    while (segment + 1 < way.size() && way[segment] < at) ++segment;
    const double length = std::max(way[segment] - way[segment - 1], 1e-12);
    const double t = std::clamp((at - way[segment - 1]) / length, 0.0, 1.0);
    const auto k = static_cast<Eigen::Index>(segment);
    points.row(i) = (1.0 - t) * line.row(k - 1) + t * line.row(k);
  }
  return points;
}

/// The mask shrunk by `pixels` from its outline; the picture's edge is no outline.
cv::Mat shrunk(const cv::Mat& mask, double pixels) {
  const int radius = std::max(1, static_cast<int>(std::lround(pixels)));
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * radius + 1, 2 * radius + 1));
  cv::Mat out;
  cv::erode(mask, out, disc, cv::Point(-1, -1), 1, cv::BORDER_REPLICATE);
  return out;
}

/// Straightens an outline to at most forty corners and gives it at least twenty.
std::vector<cv::Point2f> as_clicked(const std::vector<cv::Point>& outline) {
  std::vector<cv::Point> corners = outline;
  for (double tolerance = 1.0; static_cast<int>(corners.size()) > kMostCorners; tolerance *= 1.3)
    cv::approxPolyDP(outline, corners, tolerance, true);
  std::vector<cv::Point2f> polygon(corners.begin(), corners.end());
  while (static_cast<int>(polygon.size()) < kFewestCorners) {  // a click in the middle of the longest side
    std::size_t longest = 0;
    double length = -1.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const double side = cv::norm(polygon[(i + 1) % polygon.size()] - polygon[i]);
      if (side > length) length = side, longest = i;
    }
    polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(longest) + 1,
                   0.5F * (polygon[longest] + polygon[(longest + 1) % polygon.size()]));
  }
  return polygon;
}

/// One polygon for each piece of the mask that is worth a click.
void add_regions(const cv::Mat& mask, Feature feature, int pieces, const Camera& camera, double noise_px,
                 Hand& hand, stereo::Regions& regions) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask.clone(), outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  std::stable_sort(outlines.begin(), outlines.end(),
                   [](const auto& a, const auto& b) { return cv::contourArea(a) > cv::contourArea(b); });
  for (const auto& outline : outlines) {
    if (pieces-- <= 0 || cv::contourArea(outline) < kSmallestPx) break;
    stereo::Region region;
    region.feature = feature;
    for (const cv::Point2f& corner : as_clicked(outline)) {
      const Eigen::Vector2d p = Eigen::Vector2d(corner.x, corner.y) + noise_px * hand.tremor2();
      region.polygon.emplace_back(std::clamp(p.x(), 0.0, camera.width - 1.0),
                                  std::clamp(p.y(), 0.0, camera.height - 1.0));
    }
    regions.regions.push_back(std::move(region));
  }
}

/// Draws what the left camera sees of a line of the organ as a band of `half_mm` on either side.
cv::Mat band(const Theatre& theatre, int frame, const Points& line_in_ct, double half_mm) {
  const Camera& camera = theatre.rig().left;
  cv::Mat mask = cv::Mat::zeros(camera.height, camera.width, CV_8U);
  if (line_in_ct.rows() == 0) return mask;
  const Points line = theatre.carry(line_in_ct, frame);
  const std::vector<bool> seen = theatre.seen(line, frame);
  std::optional<cv::Point> before;
  for (Eigen::Index i = 0; i < line.rows(); ++i) {
    if (!seen[static_cast<std::size_t>(i)]) {
      before.reset();
      continue;
    }
    const Eigen::Vector2d pixel = camera.project(line.row(i).transpose());
    const cv::Point now(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
    const int radius =
        std::max(2, static_cast<int>(std::lround(1e-3 * half_mm * camera.matrix(0, 0) / line(i, 2))));
    cv::circle(mask, now, radius, 255, cv::FILLED);
    if (before) cv::line(mask, *before, now, 255, 2 * radius);
    before = now;
  }
  return mask;
}

}  // namespace

Landmarks click_landmarks(const Landmarks& truth, const OperatorOptions& options) {
  options.validate();
  Hand hand(options.seed + 1);
  Landmarks clicked;
  clicked.umbilical_notch = shaken(truth.umbilical_notch, options.click_noise_mm, hand);
  // Half a dozen points of the caval groove, not every vertex of it.
  Points cava = truth.vena_cava;
  constexpr Eigen::Index kCavaClicks = 8;
  if (cava.rows() > kCavaClicks) {
    Points few(kCavaClicks, 3);
    for (Eigen::Index i = 0; i < kCavaClicks; ++i)
      few.row(i) = cava.row(i * (cava.rows() - 1) / (kCavaClicks - 1));
    cava = few;
  }
  clicked.vena_cava = shaken(cava, options.click_noise_mm, hand);
  if (options.click_margin)
    clicked.anterior_margin = shaken(along(truth.anterior_margin, 15), options.click_noise_mm, hand);
  return clicked;
}

stereo::Regions click_regions(const Theatre& theatre, int frame, const OperatorOptions& options) {
  options.validate();
  Hand hand(options.seed + 2);
  const Camera& camera = theatre.rig().left;
  const std::vector<float> depth = theatre.depth(frame);
  cv::Mat liver(camera.height, camera.width, CV_8U);
  for (std::size_t i = 0; i < depth.size(); ++i) liver.data[i] = depth[i] > 0.0F ? 255 : 0;
  const double scale = camera.width / 960.0;
  const cv::Mat inner = shrunk(liver, kInsidePx * scale);
  stereo::Regions regions;
  regions.frame = frame;
  add_regions(inner, Feature::surface, 1, camera, options.click_noise_px, hand, regions);
  // Features are cut to the liver's outline.
  const cv::Mat close = shrunk(liver, 2.0 * scale);
  const cv::Mat margin = band(theatre, frame, theatre.landmarks().anterior_margin, kBandMm) & close;
  add_regions(margin, Feature::anterior_margin, 3, camera, 0.4 * options.click_noise_px, hand, regions);
  const cv::Mat notch = band(theatre, frame, theatre.landmarks().umbilical_notch, kNotchMm) & close;
  add_regions(notch, Feature::umbilical_notch, 1, camera, 0.6 * options.click_noise_px, hand, regions);
  return regions;
}

}  // namespace glisson::insilico
