// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/units.h"
#include "glisson/geometry/mesh.h"

namespace glisson {

/// Which feature of the liver a point shows. The numbers are those of the PLY property "label".
enum class Feature : std::uint8_t { surface = 1, anterior_margin = 2, umbilical_notch = 3 };

/// What the stereo laparoscope sees of the liver: points in the left camera's frame (as calibrated, not
/// rectified), metres. Optional arrays are empty or as long as the points.
struct LabelledCloud {
  PointsIn<CameraFrame> points;
  PointsIn<CameraFrame> normals;  ///< unit, towards the camera
  std::vector<Feature> features;  ///< empty: all surface
  std::vector<double> sigma;      ///< standard deviation along the ray, metres
  /// Where several looks were joined (registration/looks.h): in which one each point was seen, from 0. Files
  /// do not hold them.
  std::vector<int> looks;
  PointsIn<CameraFrame> eyes;  ///< the left camera's centre in each look; no rows: one look, from the origin
  /// The same for each point, where one look was had by a camera that moved: tissue that was followed. No
  /// rows: `eyes`. Files do not hold them.
  PointsIn<CameraFrame> seen_from;

  int look(int i) const { return looks.empty() ? 0 : looks[static_cast<std::size_t>(i)]; }
  int look_count() const { return eyes.rows() == 0 ? 1 : static_cast<int>(eyes.rows()); }
  /// Where the camera was that saw point i.
  Eigen::Vector3d eye(int i) const {
    if (seen_from.rows() > 0) return seen_from.row(i).transpose();
    return eyes.rows() == 0 ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                            : Eigen::Vector3d(eyes.row(look(i)).transpose());
  }
  int size() const { return static_cast<int>(points.rows()); }
  Feature feature(int i) const {
    return features.empty() ? Feature::surface : features[static_cast<std::size_t>(i)];
  }
};

/// Some of its points, in this order. @pre each number is one of a point.
LabelledCloud rows_of(const LabelledCloud& cloud, const std::vector<int>& rows);

/// Reads a PLY (ascii or binary, either endianness; x y z, optional nx ny nz, label, sigma), by
/// geometry's parser: a malformed file is an InputError, never a crash.
/// @throws FileError; InputError naming the element: NaN, truncated, no vertices, a label that is none.
LabelledCloud read_cloud(const std::filesystem::path& path, LengthUnit unit = LengthUnit::millimetre);
/// Binary little-endian PLY, atomic.
void write_cloud(const std::filesystem::path& path, const LabelledCloud& cloud,
                 LengthUnit unit = LengthUnit::millimetre);

/// Refuses a cloud that was read in a wrong unit: what it shows is between a few millimetres of a liver and
/// all of it. The radius around its middle that holds half of the points must be 0.3 m at most and, with ten
/// points and more, 1 mm at least. An empty cloud passes.
/// @param unit in which it was read. @param name of its source, for the message.
/// @throws InputError it is not; says in which unit to read it instead, if one fits.
void require_liver_sized(const LabelledCloud& cloud, LengthUnit unit, const std::string& name);

}  // namespace glisson
