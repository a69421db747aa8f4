// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_distance.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "cv_picture.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"

namespace glisson::experiments {
namespace {

constexpr int kBorder = 3;  ///< pixels of the picture's border; a smooth line along it reaches inside

void clear_border(cv::Mat1b& line) {
  const cv::Rect inside(kBorder, kBorder, line.cols - 2 * kBorder, line.rows - 2 * kBorder);
  cv::Mat1b kept = cv::Mat1b::zeros(line.size());
  line(inside).copyTo(kept(inside));
  line = kept;
}

cv::Mat1b drawn_line(const Picture& drawn) {
  cv::Mat1b grey;
  if (drawn.channels == 1)
    grey = view_of(drawn).clone();
  else
    cv::cvtColor(view_of(drawn), grey, cv::COLOR_BGR2GRAY);
  double brightest = 0.0;
  cv::minMaxLoc(grey, nullptr, &brightest);
  cv::Mat1b line = brightest > 0.0 ? cv::Mat1b(grey >= 0.5 * brightest) : cv::Mat1b::zeros(grey.size());
  clear_border(line);
  return line;
}

/// Pixels of the organ next to one that is not.
cv::Mat1b true_edge(const std::vector<float>& depth, const cv::Size& size) {
  const auto is_organ = [&](int row, int column) {
    return depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.width) +
                 static_cast<std::size_t>(column)] > 0.0F;
  };
  cv::Mat1b edge = cv::Mat1b::zeros(size);
  for (int v = 1; v + 1 < size.height; ++v)
    for (int u = 1; u + 1 < size.width; ++u)
      if (is_organ(v, u) &&
          !(is_organ(v - 1, u) && is_organ(v + 1, u) && is_organ(v, u - 1) && is_organ(v, u + 1)))
        edge(v, u) = 255;
  clear_border(edge);
  return edge;
}

/// From each pixel of `line` to the nearest of `other`.
void add_distances(const cv::Mat1b& line, const cv::Mat1b& other, std::vector<double>& distances) {
  cv::Mat1f away;
  cv::distanceTransform(other == 0, away, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  for (int v = 0; v < line.rows; ++v)
    for (int u = 0; u < line.cols; ++u)
      if (line(v, u) != 0) distances.push_back(away(v, u));
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

std::optional<OutlineDistance> outline_distance(const Picture& drawn, const std::vector<float>& true_depth) {
  const auto pixels = static_cast<std::size_t>(drawn.width) * static_cast<std::size_t>(drawn.height);
  if (drawn.empty() || true_depth.size() != pixels || std::min(drawn.width, drawn.height) <= 2 * kBorder)
    throw InputError("outline", "size", "is not that of the true depth", "Draw the frame's left picture");
  const cv::Mat1b line = drawn_line(drawn), edge = true_edge(true_depth, line.size());
  if (cv::countNonZero(line) == 0 || cv::countNonZero(edge) == 0) return std::nullopt;
  std::vector<double> distances;
  add_distances(line, edge, distances);
  add_distances(edge, line, distances);
  return OutlineDistance{mean_of(distances), lower_percentile(distances, 0.95)};
}

namespace {

using Line = std::vector<Eigen::Vector2d>;

/// Places along a line, a pixel apart at the most, that lie in the picture.
Line samples(const Line& line, int width, int height) {
  Line inside;
  const auto keep = [&](const Eigen::Vector2d& p) {
    if (p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= width - 1.0 && p.y() <= height - 1.0) inside.push_back(p);
  };
  if (line.size() == 1) keep(line.front());
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const int steps = std::max(1, static_cast<int>(std::ceil((line[i + 1] - line[i]).norm())));
    for (int k = i == 0 ? 0 : 1; k <= steps; ++k)
      keep(line[i] + (line[i + 1] - line[i]) * (static_cast<double>(k) / steps));
  }
  return inside;
}

double distance_to(const Line& line, const Eigen::Vector2d& p) {
  double nearest = (line.front() - p).norm();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Eigen::Vector2d along = line[i + 1] - line[i];
    const double length = along.squaredNorm();
    const double share = length > 0.0 ? std::clamp((p - line[i]).dot(along) / length, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (line[i] + share * along - p).norm());
  }
  return nearest;
}

}  // namespace

std::optional<OutlineDistance> line_distance(const Line& drawn, const Line& truth, int width, int height) {
  const Line of_drawn = samples(drawn, width, height), of_truth = samples(truth, width, height);
  if (of_truth.empty()) return std::nullopt;
  if (of_drawn.empty()) {  // drawn outside of the picture where it is to be seen: as wrong as can be
    const double most = std::hypot(width, height);
    return OutlineDistance{most, most};
  }
  // To the whole of the other line: what it goes on beyond the picture's border is no error.
  std::vector<double> distances;
  for (const Eigen::Vector2d& p : of_drawn) distances.push_back(distance_to(truth, p));
  for (const Eigen::Vector2d& p : of_truth) distances.push_back(distance_to(drawn, p));
  return OutlineDistance{mean_of(distances), lower_percentile(distances, 0.95)};
}

Figures OutlineTally::figures(const std::string& line) const {
  if (distances_.empty()) return {};
  std::vector<double> means, percentiles;
  for (const OutlineDistance& distance : distances_) {
    means.push_back(distance.mean);
    percentiles.push_back(distance.percentile_95);
  }
  return {{line + "_frames", static_cast<double>(distances_.size())},
          {line + "_mean_px", mean_of(means)},
          {line + "_p95_px", mean_of(percentiles)},
          {line + "_worst_mean_px", *std::max_element(means.begin(), means.end())}};
}

}  // namespace glisson::experiments
