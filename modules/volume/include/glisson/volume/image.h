// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "glisson/volume/grid.h"

namespace glisson {

/// What an image was taken with. Only a CT's values have a scale of their own.
enum class Modality { ct, mr, other };

/// A scalar volume, immutable and shared: copying it is cheap. CT voxels are Hounsfield units.
struct Image {
  VolumeGrid grid;
  Modality modality = Modality::ct;
  /// i fastest; grid.voxel_count() values.
  std::shared_ptr<const std::vector<std::int16_t>> voxels;
  std::string description;  ///< of the series, for people; may be empty

  bool empty() const { return !voxels || voxels->empty(); }
  std::int16_t at(const Eigen::Vector3i& v) const {
    return (*voxels)[static_cast<std::size_t>(grid.offset(v))];
  }
};

}  // namespace glisson
