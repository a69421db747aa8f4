// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/calibration_io.h"
#include "rig_check.h"

namespace glisson::stereo {
namespace fs = std::filesystem;
namespace {

constexpr const char* kShape =
    "Expected calib.left.intrinsic.txt (3x3), calib.left.distortion.txt (4 or 5 numbers), the same for "
    "right, "
    "and calib.l2r.txt (4x4)";

bool has(const std::string& name, const char* word) { return name.find(word) != std::string::npos; }

std::vector<double> numbers(const fs::path& path) {
  constexpr std::size_t kMostBytes = 1U << 16;
  const std::string content = read_file(path, kMostBytes);
  std::istringstream text(content);
  std::vector<double> values;
  for (std::string word; text >> word;) {
    std::size_t used = 0;
    double value = 0.0;
    try {
      value = std::stod(word, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used != word.size() || !std::isfinite(value))
      throw InputError(path.string(), "number " + std::to_string(values.size() + 1),
                       "is \"" + word.substr(0, 20) + "\"", kShape);
    values.push_back(value);
  }
  return values;
}

/// What a folder holds.
struct Files {
  fs::path folder;
  fs::path intrinsics[2], distortion[2], transform;

  explicit Files(const fs::path& where) : folder(where) {
    std::error_code failure;
    if (!fs::is_directory(folder, failure))
      throw FileError(folder.string() + ": is no folder. Check the path.");
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, failure))
      if (entry.is_regular_file()) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      const std::string name = lower_name(file);
      if (!has(name, ".txt") && !has(name, ".4x4") && !has(name, ".3x4") && !has(name, ".dat")) continue;
      const int side = has(name, "left") && !has(name, "right") ? 0 : 1;
      if (has(name, "intrinsic"))
        take(intrinsics[side], file);
      else if (has(name, "distortion"))
        take(distortion[side], file);
      else if (has(name, "l2r") || has(name, "r2l") || has(name, "extrinsic") || has(name, "4x4") ||
               has(name, "left2right") || has(name, "right2left"))
        take(transform, file);
    }
    for (const fs::path* one : {&intrinsics[0], &intrinsics[1], &distortion[0], &distortion[1], &transform})
      if (one->empty())
        throw InputError(folder.string(), "",
                         "has no calibration in it that is whole (of cameras, distortions and the transform "
                         "between them, one file is missing)",
                         kShape);
  }

 private:
  static void take(fs::path& place, const fs::path& file) {
    if (!place.empty())
      throw InputError(file.string(), "", "is a second file of its kind beside " + place.filename().string(),
                       "Leave one of them in the folder");
    place = file;
  }
};

Camera camera_of(const fs::path& intrinsics, const fs::path& distortion, int width, int height) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  const std::vector<double> m = numbers(intrinsics), d = numbers(distortion);
  if (m.size() != 9)
    throw InputError(intrinsics.string(), "", "holds " + std::to_string(m.size()) + " numbers, not 3x3",
                     kShape);
  if (d.size() != 4 && d.size() != 5)
    throw InputError(distortion.string(), "", "holds " + std::to_string(d.size()) + " numbers, not 4 or 5",
                     kShape);
  for (int i = 0; i < 9; ++i) camera.matrix(i / 3, i % 3) = m[static_cast<std::size_t>(i)];
  check_camera(intrinsics.string(), "", camera);
  camera = without_skew(intrinsics.string(), "", camera);
  for (std::size_t i = 0; i < d.size(); ++i) camera.distortion[static_cast<Eigen::Index>(i)] = d[i];
  check_distortion(distortion.string(), "", camera);
  return camera;
}

/// Which way the file's name says that it maps; empty: it does not say.
std::optional<bool> left_to_right(const fs::path& transform) {
  const std::string name = lower_name(transform);
  if (has(name, "l2r") || has(name, "left2right")) return true;
  if (has(name, "r2l") || has(name, "right2left")) return false;
  return std::nullopt;
}

}  // namespace

StereoRig read_text_calibration(const fs::path& folder, int width, int height, LengthUnit unit) {
  require(width > 0 && height > 0, "pictures have a size");
  const Files files(folder);
  StereoRig rig;
  rig.left = camera_of(files.intrinsics[0], files.distortion[0], width, height);
  rig.right = camera_of(files.intrinsics[1], files.distortion[1], width, height);
  const std::string name = files.transform.string();
  const std::vector<double> t = numbers(files.transform);
  if (t.size() != 12 && t.size() != 16)
    throw InputError(name, "", "holds " + std::to_string(t.size()) + " numbers, not 3x4 or 4x4", kShape);
  if (t.size() == 16 && (t[12] != 0.0 || t[13] != 0.0 || t[14] != 0.0 || t[15] != 1.0))
    throw InputError(name, "last row", "is not 0 0 0 1", kShape);
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) rotation(r, c) = t[static_cast<std::size_t>(4 * r + c)];
    translation[r] = metres_per(unit) * t[static_cast<std::size_t>(4 * r + 3)];
  }
  rotation = checked_rotation(name, "rotation", rotation);
  const auto forward = left_to_right(files.transform);
  const bool maps_left_to_right = forward.value_or(-(rotation.transpose() * translation).x() > 0.0);
  rig.right_from_left.rotation = maps_left_to_right ? rotation : Eigen::Matrix3d(rotation.transpose());
  rig.right_from_left.translation =
      maps_left_to_right ? translation : Eigen::Vector3d(-(rotation.transpose() * translation));
  check_rig(name, rig);
  return rig;
}

}  // namespace glisson::stereo
