// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/density.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "glisson/core/error.h"
#include "picture_cv.h"

namespace glisson::stereo {
namespace {

const double kRadius = 0.01 / std::sqrt(std::numbers::pi);  ///< of a disk of 1 cm2, metres

/// A point in the picture.
struct Spot {
  Eigen::Vector2d pixel;
  double depth = 0.0, facing = 1.0;  ///< metres; picture area at that depth over surface area
};

std::vector<Spot> spots_of(const LabelledCloud& cloud, const Camera& left) {
  std::vector<Spot> spots;
  for (Eigen::Index i = 0; i < cloud.points.rows(); ++i) {
    const Eigen::Vector3d p = cloud.points.row(i).transpose(), n = cloud.normals.row(i).transpose();
    if (p.z() <= 0.0) continue;
    spots.push_back({left.project(p), p.z(), std::clamp(std::abs(n.dot(p)) / p.z(), 0.2, 1.5)});
  }
  return spots;
}

/// Which cells are wanted.
cv::Mat wanted_cells(const Camera& left, const Picture& mask, const Regions& regions, const DensityMap& map) {
  cv::Mat wanted(map.rows, map.columns, CV_8U, cv::Scalar(255));
  const cv::Mat allowed = mask.empty() ? cv::Mat() : grey(mask);
  const bool bounded = std::any_of(regions.regions.begin(), regions.regions.end(),
                                   [](const Region& region) { return region.side == Side::left; });
  for (int row = 0; row < map.rows; ++row)
    for (int column = 0; column < map.columns; ++column) {
      const int x = std::min(left.width - 1, column * map.cell + map.cell / 2);
      const int y = std::min(left.height - 1, row * map.cell + map.cell / 2);
      if ((!allowed.empty() && allowed.at<std::uint8_t>(y, x) == 0) ||
          (bounded && !feature_at(regions, {x, y})))
        wanted.at<std::uint8_t>(row, column) = 0;
    }
  return wanted;
}

/// Share of the disk around a cell that is wanted: at a border fewer points are to be expected.
double wanted_share(const cv::Mat& wanted, int column, int row, double radius_cells) {
  const int reach = static_cast<int>(radius_cells) + 1;
  int inside = 0, all = 0;
  for (int y = row - reach; y <= row + reach; ++y)
    for (int x = column - reach; x <= column + reach; ++x) {
      if (std::hypot(x - column, y - row) > radius_cells && (x != column || y != row)) continue;
      ++all;
      inside += x >= 0 && y >= 0 && x < wanted.cols && y < wanted.rows && wanted.at<std::uint8_t>(y, x) != 0;
    }
  return std::max(0.2, static_cast<double>(inside) / all);
}

}  // namespace

void DensityOptions::validate() const {
  require(cell >= 2 && cell <= 200, "a cell has 2 to 200 pixels");
  require(least_per_cm2 > 0.0, "a density that is needed is positive");
}

DensityMap density_map(const LabelledCloud& cloud, const Camera& left, const Picture& mask,
                       const Regions& regions, const DensityOptions& options) {
  require(cloud.normals.rows() == cloud.points.rows(), "the points of a density map have normals");
  options.validate();
  require(mask.empty() || (mask.width == left.width && mask.height == left.height),
          "a mask has the size of the camera's pictures");
  DensityMap map;
  map.cell = options.cell;
  map.least_per_cm2 = options.least_per_cm2;
  map.columns = (left.width + map.cell - 1) / map.cell;
  map.rows = (left.height + map.cell - 1) / map.cell;
  map.per_cm2.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), -1.0F);
  const std::vector<Spot> spots = spots_of(cloud, left);
  const cv::Mat wanted = wanted_cells(left, mask, regions, map);
  if (spots.empty()) return map;
  const double focal = 0.5 * (left.matrix(0, 0) + left.matrix(1, 1));
  double covered = 0.0;
  for (int row = 0; row < map.rows; ++row)
    for (int column = 0; column < map.columns; ++column) {
      if (wanted.at<std::uint8_t>(row, column) == 0) continue;
      const Eigen::Vector2d middle((column + 0.5) * map.cell, (row + 0.5) * map.cell);
      const Spot* closest = &spots[0];
      for (const Spot& spot : spots)
        if ((spot.pixel - middle).squaredNorm() < (closest->pixel - middle).squaredNorm()) closest = &spot;
      const double radius = kRadius * focal / closest->depth;
      int count = 0;
      for (const Spot& spot : spots) count += (spot.pixel - middle).squaredNorm() <= radius * radius;
      const double share = wanted_share(wanted, column, row, radius / map.cell);
      const double density = count * closest->facing / share;
      map.per_cm2[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) +
                  static_cast<std::size_t>(column)] = static_cast<float>(density);
      const double area = std::pow(map.cell * closest->depth / focal, 2.0) / closest->facing;
      map.area_cm2 += 1e4 * area;
      if (density >= options.least_per_cm2) covered += 1e4 * area;
    }
  map.covered = map.area_cm2 > 0.0 ? covered / map.area_cm2 : 0.0;
  return map;
}

Figures density_figures(const DensityMap& map) { return {{"cloud_area_cm2", map.area_cm2}}; }

Picture density_picture(const DensityMap& map, const Picture& left) {
  // Told apart by people who do not tell red from green (Okabe and Ito 2008), blue green red.
  const cv::Scalar enough(178, 114, 0), few(0, 159, 230), none(0, 94, 213);
  cv::Mat image;
  cv::cvtColor(grey(left), image, cv::COLOR_GRAY2BGR);
  cv::Mat tint = image.clone();
  for (int row = 0; row < map.rows; ++row)
    for (int column = 0; column < map.columns; ++column) {
      const double density = map.at(column, row);
      if (density < 0.0) continue;
      const cv::Scalar& colour = density >= map.least_per_cm2 ? enough : density > 0.0 ? few : none;
      cv::rectangle(tint, cv::Rect(column * map.cell, row * map.cell, map.cell, map.cell), colour,
                    cv::FILLED);
    }
  cv::addWeighted(tint, 0.45, image, 0.55, 0.0, image);
  return to_picture(image);
}

}  // namespace glisson::stereo
