// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

#include "dense.h"
#include "feature_detector.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/stereo/source.h"
#include "highlights.h"
#include "matching.h"
#include "picture_cv.h"
#include "rectification.h"
#include "refine.h"
#include "size_text.h"
#include "surface_fit.h"
#include "whole_pair.h"

namespace glisson::stereo {
namespace {

constexpr int kFewestPoints = 10;
constexpr double kLargestSigma = 0.5;  // pixels: less certain matches carry no depth
constexpr double kSamePoint = 2.0;     // pixels

void check_inputs(const Picture& left, const Picture& right, const StereoRig& rig, const Picture& mask) {
  const auto check = [&](const char* name, const Picture& picture, const Camera& camera) {
    if (picture.empty())
      throw InputError(std::string(name) + " image", "", "is empty", "Give a picture of each camera");
    if (picture.width != camera.width || picture.height != camera.height)
      throw InputError(std::string(name) + " image", "",
                       "is " + size_text(picture.width, picture.height) + " pixels, its calibration is for " +
                           size_text(camera.width, camera.height),
                       "Use the calibration of this laparoscope at this image size");
  };
  check("left", left, rig.left);
  check("right", right, rig.right);
  if (*left.bytes == *right.bytes)
    throw InputError("left and right images", "", "are the same picture",
                     "Give the picture of each camera; one of them may be lost");
  if (!mask.empty() && (mask.width != left.width || mask.height != left.height))
    throw InputError("mask", "",
                     "is " + size_text(mask.width, mask.height) + " pixels, the left image " +
                         size_text(left.width, left.height),
                     "Draw the mask on the left image");
}

/// What all steps share.
struct Pair {
  const StereoRig& rig;
  Rectification rectification;
  cv::Mat left, right;                        ///< grey, as taken
  cv::Mat left_highlights, right_highlights;  ///< as taken
  cv::Mat usable_left, usable_right;          ///< as taken
  MatchLimits limits;
};

/// Where the right picture can show what the left one shows in its usable part.
cv::Mat band_in_right(const Pair& pair, const ReconstructOptions& options) {
  constexpr int kStep = 6, kDepths = 24, kRadius = 10;
  cv::Mat band = cv::Mat::zeros(pair.right.size(), CV_8U);
  for (int y = 0; y < pair.left.rows; y += kStep)
    for (int x = 0; x < pair.left.cols; x += kStep) {
      if (pair.usable_left.at<std::uint8_t>(y, x) == 0) continue;
      const auto ray = pair.rig.left.mapped_ray({x, y});
      if (!ray) continue;
      for (int k = 0; k <= kDepths; ++k) {
        const double t = static_cast<double>(k) / kDepths;
        const double depth = 1.0 / ((1.0 - t) / options.far + t / options.near);
        const Eigen::Vector3d p =
            (pair.rig.right_from_left * Point<CameraFrame>(Eigen::Vector3d(depth * *ray))).xyz;
        if (!pair.rig.right.shows(p)) continue;
        const Eigen::Vector2d pixel = pair.rig.right.project(p);
        cv::rectangle(band,
                      cv::Point(static_cast<int>(pixel.x()) - kRadius, static_cast<int>(pixel.y()) - kRadius),
                      cv::Point(static_cast<int>(pixel.x()) + kRadius, static_cast<int>(pixel.y()) + kRadius),
                      cv::Scalar(255), cv::FILLED);
      }
    }
  return band;
}

/// Takes out what lies outside the laparoscope's circle: its rim is sharp, and stays where the camera is.
void keep_circle(const Picture& picture, cv::Mat& usable) {
  if (const auto circle = find_scope_circle(picture))
    usable.setTo(0, view(circle_mask(*circle, picture.width, picture.height)) == 0);
}

Pair prepare(const Picture& left, const Picture& right, const StereoRig& rig, const Picture& mask,
             const ReconstructOptions& options) {
  Pair pair{rig, Rectification(rig), grey(left), grey(right), highlights(left), highlights(right), {}, {},
            {}};
  pair.usable_left = pair.left_highlights == 0;
  if (!mask.empty()) pair.usable_left.setTo(0, grey(mask) == 0);
  pair.usable_right = pair.right_highlights == 0;
  if (options.find_circle && mask.empty()) {
    keep_circle(left, pair.usable_left);
    keep_circle(right, pair.usable_right);
  }
  if (!mask.empty()) pair.usable_right &= band_in_right(pair, options);
  pair.limits.ratio = options.ratio;
  pair.limits.rows = band_rows(options);
  pair.limits.least_disparity = pair.rectification.disparity_at(options.far);
  pair.limits.largest_disparity = pair.rectification.disparity_at(options.near);
  return pair;
}

/// Features of both pictures, matched; the pair is refused when it fits the other way round better.
std::vector<Match> match_features(const Pair& pair, const ReconstructOptions& options,
                                  ReconstructReport& report) {
  const Eigen::Matrix3d& r = pair.rig.right_from_left.rotation;
  const double roll = std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1));
  const auto detector = feature_detector(options.kind);
  auto in_left = detector->detect(pair.left, pair.usable_left, options.features, 0.0);
  auto in_right = detector->detect(pair.right, pair.usable_right, options.features, roll);
  report.features_left = static_cast<int>(in_left.size());
  report.features_right = static_cast<int>(in_right.size());
  const Rectification& rectification = pair.rectification;
  const int length = detector->descriptor_length();
  const Rectified left = rectify(rectification, Side::left, in_left, length);
  const Rectified right = rectify(rectification, Side::right, in_right, length);
  std::vector<Match> matches = match(left, right, pair.limits);
  const Fit fit = fit_of(rectification, matches, pair.limits);
  const Fit swapped =
      fit_of(rectification,
             match(rectify(rectification, Side::left, std::move(in_right), length),
                   rectify(rectification, Side::right, std::move(in_left), length), pair.limits),
             pair.limits);
  // Swapped views show depths of the wrong sign. Where converging cameras make both signs possible, rows that
  // agree far better the other way round decide.
  const bool by_sign = swapped.plausible > fit.plausible + fit.plausible / 2;
  const bool by_rows = swapped.plausible > fit.plausible / 5 * 4 && swapped.rows < 0.5 * fit.rows;
  if (swapped.plausible >= 20 && (by_sign || by_rows))
    throw InputError("left and right images", "",
                     "fit the calibration better when swapped (" + std::to_string(swapped.plausible) +
                         " matches in front of the cameras, " + std::to_string(fit.plausible) + " as given)",
                     "Swap the two images, or the calibration's cameras");
  std::erase_if(matches, [&](const Match& m) {
    const double d = rectification.disparity(m.left, m.right);
    return d < pair.limits.least_disparity || d > pair.limits.largest_disparity;
  });
  return matches;
}

/// Depths narrowed to what the features show, with room.
MatchLimits narrowed(const Pair& pair, const std::vector<Match>& features) {
  MatchLimits limits = pair.limits;
  if (features.size() < 30) return limits;
  std::vector<double> disparities;
  disparities.reserve(features.size());
  for (const Match& m : features) disparities.push_back(pair.rectification.disparity(m.left, m.right));
  const double low = at_rank(disparities, disparities.size() / 20),
               high = at_rank(disparities, disparities.size() * 19 / 20);
  const double room = std::max(8.0, 0.4 * (high - low));
  limits.least_disparity = std::max(limits.least_disparity, low - room);
  limits.largest_disparity = std::min(limits.largest_disparity, high + room);
  return limits;
}

/// By how much right rows exceed left ones: what the calibration leaves, from a sample of the matches.
double row_offset(const Refiner& refiner, const std::vector<Match>& matches) {
  constexpr std::size_t kSample = 300, kFewest = 20;
  std::vector<double> rows;
  for (std::size_t i = 0; i < matches.size(); i += matches.size() / kSample + 1)
    if (const auto match = refiner.refine(matches[i], 0.0))
      rows.push_back(match->right.y() - match->left.y());
  if (rows.size() < kFewest) return 0.0;
  return upper_median(std::move(rows));
}

/// Refined matches through the epipolar and disparity gates, the best of each place.
std::vector<Match> refined(const Pair& pair, const Refiner& refiner, const std::vector<Match>& matches,
                           double row, const ReconstructOptions& options, const RunContext& context) {
  std::vector<Match> result;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (i % 64 == 0) {
      if (context.cancelled()) return {};
      context.progress(0.4 + 0.4 * static_cast<double>(i) / static_cast<double>(matches.size()),
                       "stereo.refine");
    }
    const auto match = refiner.refine(matches[i], row);
    if (!match || match->sigma > kLargestSigma) continue;
    const double d = pair.rectification.disparity(match->left, match->right);
    if (d < pair.limits.least_disparity || d > pair.limits.largest_disparity) continue;
    if (std::abs(match->right.y() - match->left.y() - row) > options.epipolar_px) continue;
    result.push_back(*match);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Match& a, const Match& b) { return a.sigma < b.sigma; });
  // Rounded to a raster first, so that the search for neighbours stays short.
  std::vector<Match> distinct;
  cv::Mat taken = cv::Mat::zeros(pair.left.size(), CV_8U);
  for (const Match& m : result) {
    const cv::Point at(static_cast<int>(std::lround(m.left.x())), static_cast<int>(std::lround(m.left.y())));
    if (at.x < 0 || at.y < 0 || at.x >= taken.cols || at.y >= taken.rows) continue;
    if (taken.at<std::uint8_t>(at) != 0) continue;
    cv::circle(taken, at, static_cast<int>(kSamePoint), cv::Scalar(255), cv::FILLED);
    distinct.push_back(m);
  }
  return distinct;
}

/// The picture moved up by `rows`.
cv::Mat shifted(const cv::Mat& image, double rows) {
  cv::Mat result;
  const cv::Mat move = (cv::Mat_<double>(2, 3) << 1, 0, 0, 0, 1, -rows);
  cv::warpAffine(image, result, move, image.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

cv::Mat eight_bit(const cv::Mat& image) {
  cv::Mat result;
  image.convertTo(result, CV_8U);
  return result;
}

/// A point that passed every gate.
struct Candidate {
  Match match;
  Eigen::Vector2d pixel;  ///< in the left picture as taken
  Eigen::Vector3d point;
};

/// @param row by how much right rows exceed left ones. Nobody knows which camera's calibration is off: each
/// view gives half, so that a point lies in the middle of its two rows.
std::vector<Candidate> triangulated(const Pair& pair, const std::vector<Match>& matches, double row,
                                    const ReconstructOptions& options) {
  const Rectification& rectification = pair.rectification;
  const std::vector<bool> agrees = agreeing(rectification, matches);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (!agrees[i]) continue;
    Candidate c{matches[i], {}, {}};
    const Eigen::Vector2d half(0.0, 0.5 * row);
    const auto seen = rectification.unrectify(Side::left, c.match.left);
    const auto left = rectification.unrectify(Side::left, c.match.left + half);
    const auto right = rectification.unrectify(Side::right, c.match.right - half);
    if (!seen || !left || !right) continue;
    c.pixel = *seen;
    const double d = rectification.disparity(c.match.left, c.match.right);
    c.point = rectification.triangulate(c.match.left, c.match.right.y(), d);
    const Eigen::Vector3d in_right = (pair.rig.right_from_left * Point<CameraFrame>(c.point)).xyz;
    if (c.point.z() <= 0.0 || in_right.z() <= 0.0) continue;
    if ((pair.rig.left.project(c.point) - *left).norm() > options.reprojection_px ||
        (pair.rig.right.project(in_right) - *right).norm() > options.reprojection_px)
      continue;
    candidates.push_back(c);
  }
  return candidates;
}

/// The area that the points stand for: cells of the left picture that may show points (the mask's; without
/// one, those near a point), each at the depth and slant of its closest point.
double area_cm2(const Pair& pair, const LabelledCloud& cloud, const std::vector<Candidate>& candidates,
                const Picture& mask) {
  constexpr int kCell = 8;
  std::vector<Eigen::Vector2d> pixels;
  pixels.reserve(candidates.size());
  for (const Candidate& c : candidates) pixels.push_back(c.pixel);
  std::vector<double> spacing;
  const auto nearest = nearest_in_picture(pixels, 3);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    spacing.push_back((pixels[static_cast<std::size_t>(nearest[i].back())] - pixels[i]).norm());
  const double near = std::max(1.5 * kCell, 3.0 * upper_median(std::move(spacing)));
  const cv::Mat allowed = mask.empty() ? cv::Mat() : cv::Mat(grey(mask) != 0);
  double area = 0.0;
  for (int y = kCell / 2; y < pair.left.rows; y += kCell)
    for (int x = kCell / 2; x < pair.left.cols; x += kCell) {
      if (!allowed.empty() && allowed.at<std::uint8_t>(y, x) == 0) continue;
      std::size_t best = 0;
      double distance = HUGE_VAL;
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double d = (pixels[i] - Eigen::Vector2d(x, y)).squaredNorm();
        if (d < distance) distance = d, best = i;
      }
      if (mask.empty() && distance > near * near) continue;
      const Eigen::Vector3d p = cloud.points.row(static_cast<Eigen::Index>(best)).transpose();
      const Eigen::Vector3d n = cloud.normals.row(static_cast<Eigen::Index>(best)).transpose();
      const double side = kCell * p.z() / pair.rectification.focal();
      area += side * side / std::max(0.2, std::abs(n.dot(p)) / p.z());
    }
  return 1e4 * area;
}

Reconstructed assemble(const Pair& pair, double reach, const std::vector<Candidate>& candidates,
                       const Picture& mask, const ReconstructOptions& options, ReconstructReport report) {
  const Rectification& rectification = pair.rectification;
  std::vector<Match> matches;
  double rows = 0.0, row_spread = 0.0;
  for (const Candidate& c : candidates) {
    matches.push_back(c.match);
    rows += std::pow(c.match.left.y() - c.match.right.y(), 2);
    row_spread += std::pow(c.match.right.y() - c.match.left.y() - report.row_offset_px, 2);
  }
  const double row_sigma = std::sqrt(row_spread / static_cast<double>(candidates.size()));
  const Surface surface = fit_surface(rectification, matches, reach, options.smooth);
  const double scale = std::max(1.0, surface.misfit);
  report.misfit = surface.misfit;
  Reconstructed result;
  LabelledCloud& cloud = result.cloud;
  const auto n = static_cast<Eigen::Index>(candidates.size());
  cloud.points.resize(n, 3);
  cloud.normals.resize(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const SurfacePoint& p = surface.points[static_cast<std::size_t>(i)];
    const Candidate& c = candidates[static_cast<std::size_t>(i)];
    cloud.points.row(i) = rectification.triangulate(c.match.left, c.match.right.y(), p.disparity).transpose();
    cloud.normals.row(i) = p.normal.transpose();
    cloud.sigma.push_back(p.sigma * rectification.depth_per_pixel(c.match.left, p.disparity));
    cloud.features.push_back(Feature::surface);
    // The left end is exact, being where the match was asked for, but for half of what the rows disagree by.
    result.covariance.push_back(rectification.covariance(c.match.left,
                                                         rectification.disparity(c.match.left, c.match.right),
                                                         0.0, 0.5 * row_sigma, scale * c.match.sigma));
  }
  report.points = cloud.size();
  report.epipolar_rms_px = std::sqrt(rows / static_cast<double>(n));
  report.sigma_median = upper_median(cloud.sigma);
  report.area_cm2 = area_cm2(pair, cloud, candidates, mask);
  report.density_per_cm2 = report.area_cm2 > 0.0 ? report.points / report.area_cm2 : 0.0;
  result.report = report;
  return result;
}

}  // namespace

double band_rows(const ReconstructOptions& options) { return 2.0 * options.epipolar_px; }

void ReconstructOptions::validate() const {
  require(features >= 10 && features <= 100000, "features is from 10 to 100000");
  require(ratio > 0.0 && ratio <= 1.0, "ratio is in (0, 1]");
  require(epipolar_px > 0.0 && reprojection_px > 0.0, "gates are positive");
  require(near > 0.0 && far > near && std::isfinite(far), "depths are positive, far beyond near");
  require(points_per_cm2 > 0.0 && std::isfinite(points_per_cm2), "points_per_cm2 is positive");
  require(least_density_per_cm2 >= 0.0, "least_density_per_cm2 is not negative");
  require(patch >= 3 && patch <= 50, "patch is from 3 to 50 pixels");
}

Cancellable<Reconstructed> reconstruct_whole(const Picture& left, const Picture& right, const StereoRig& rig,
                                             const Picture& mask, const ReconstructOptions& options,
                                             const RunContext& context) {
  options.validate();
  check_inputs(left, right, rig, mask);
  if (context.cancelled()) return std::nullopt;
  context.progress(0.0, "stereo.detect");
  const Pair pair = prepare(left, right, rig, mask, options);
  ReconstructReport report;
  const std::vector<Match> features = match_features(pair, options, report);
  if (context.cancelled()) return std::nullopt;
  context.progress(0.2, "stereo.match");
  const cv::Mat rectified_left = pair.rectification.warp(Side::left, grey_float(left));
  const cv::Mat rectified_right = pair.rectification.warp(Side::right, grey_float(right));
  const Refiner refiner(pair.rectification, rectified_left, rectified_right,
                        pair.rectification.warp(Side::left, pair.left_highlights) > 127,
                        pair.rectification.warp(Side::right, pair.right_highlights) > 127, options.patch);
  report.row_offset_px = row_offset(refiner, features);
  std::optional<Reconstructed> result;
  const auto finish = [&](const std::vector<Match>& matches, Method method) {
    report.method = method;
    report.matches = static_cast<int>(matches.size());
    const std::vector<Match> precise =
        refined(pair, refiner, matches, report.row_offset_px, options, context);
    if (context.cancelled()) return;
    context.progress(0.8, "stereo.surface");
    const std::vector<Candidate> candidates = triangulated(pair, precise, report.row_offset_px, options);
    report.points = static_cast<int>(candidates.size());
    if (report.points >= kFewestPoints)
      result = assemble(pair, refiner.reach(), candidates, mask, options, report);
  };
  if (options.method != Method::dense) finish(features, Method::sparse);
  if (context.cancelled()) return std::nullopt;
  const bool thin = !result || result->report.density_per_cm2 < options.least_density_per_cm2;
  if (options.method == Method::dense || (options.method == Method::automatic && thin)) {
    const cv::Mat usable = pair.rectification.warp(Side::left, pair.usable_left) > 127;
    const std::optional<Reconstructed> sparse = std::exchange(result, std::nullopt);
    finish(dense_matches(pair.rectification, eight_bit(rectified_left),
                         eight_bit(shifted(rectified_right, report.row_offset_px)), usable,
                         narrowed(pair, features), options.points_per_cm2),
           Method::dense);
    if (sparse && (!result || result->report.density_per_cm2 <= sparse->report.density_per_cm2))
      result = sparse;
  }
  if (context.cancelled()) return std::nullopt;
  if (!result)
    throw InputError(kPair, "",
                     "gives " + std::to_string(report.points) + " points (" +
                         std::to_string(report.features_left) + " and " +
                         std::to_string(report.features_right) + " features, " +
                         std::to_string(report.matches) + " matches), too few for a surface",
                     "Check that both images show the same tissue sharply and lit, that a mask lies on "
                     "it, and that the calibration is of this laparoscope");
  context.progress(1.0, "stereo.done");
  return result;
}

}  // namespace glisson::stereo
