// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "glisson/patient/labelled_cloud.h"

namespace glisson::guidance {

/// Where fresh stereo has seen the followed tissue. All looks are joined in the registered shape, in which a
/// piece of tissue has the same place in every frame, however organ and scope have moved. Stereo's errors
/// differ from look to look and average out. What passes in front of the organ does not stay with its tissue,
/// and so is left out.
class TissueMap {
 public:
  /// One fresh surface. @param places in the registered shape, metres. @param eye the left camera's there.
  void add(const std::vector<Eigen::Vector3d>& places, const Eigen::Vector3d& eye);
  /// Fresh surfaces so far.
  int looks() const { return looks_; }
  /// The mean place in each cell of 4 mm that at least three looks have seen, and the mean eye that saw it:
  /// where a surface shows its face to several eyes it shows it to their mean, too. Metres, the registered
  /// shape's frame. The order is the same from run to run.
  LabelledCloud places() const;
  void clear();

 private:
  struct Cell {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), eye = Eigen::Vector3d::Zero();
    int points = 0, looks = 0, last_look = 0;
  };
  std::unordered_map<std::uint64_t, Cell> cells_;
  int looks_ = 0;
};

}  // namespace glisson::guidance
