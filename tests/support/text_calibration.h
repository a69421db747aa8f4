// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "glisson/geometry/camera.h"

namespace glisson::test {

/// Numbers to the last bit, a row a line.
inline void write_matrix(const std::filesystem::path& path, const Eigen::MatrixXd& matrix) {
  std::ofstream text(path);
  text.precision(17);
  text << matrix << "\n";
}

/// A calibration as read_text_calibration() reads it: calib.{left,right}.{intrinsics,distortion}.txt and
/// calib.l2r.txt, millimetres, in a folder that exists.
inline void write_text_calibration(const std::filesystem::path& folder, const StereoRig& rig) {
  for (const auto& [side, camera] : {std::pair{"left", &rig.left}, std::pair{"right", &rig.right}}) {
    const std::string start = std::string("calib.") + side;
    write_matrix(folder / (start + ".intrinsics.txt"), camera->matrix);
    write_matrix(folder / (start + ".distortion.txt"), camera->distortion.transpose());
  }
  Eigen::Matrix4d right_from_left = rig.right_from_left.matrix();
  right_from_left.topRightCorner<3, 1>() *= 1e3;
  write_matrix(folder / "calib.l2r.txt", right_from_left);
}

}  // namespace glisson::test
