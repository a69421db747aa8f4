// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"
#include "glisson/volume/label_volume.h"

namespace glisson::scene {

/// One label's surface within one block of voxels. It meets those of the neighbouring blocks without a gap
/// or a seam. CT frame, metres; normals are unit and point out of the label.
struct BlockSurface {
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> vertices, normals;
  Triangles triangles;
};

/// The surfaces of all labels, for drawing: naive surface nets (Gibson 1998) on cells of about 1.6 mm for the
/// liver and 0.8 mm for all else, relaxed within their cells. Kept by blocks of two bricks a side, so that
/// after an edit only the blocks whose bricks changed, and their neighbours, are made again. The liver's
/// surface is that of the whole organ, without its borders to its own vessels and lesions. A value; copies
/// share blocks.
class LabelSurfaces {
 public:
  /// Which label, and which block: numbered with the first axis fastest.
  using Key = std::pair<Label, std::size_t>;

  LabelSurfaces() = default;
  /// Takes about a second for a whole liver at 0.7 mm: make it beside the window's thread. Empty: cancelled.
  /// @param former surfaces of an earlier state of the labels, or null.
  static Cancellable<LabelSurfaces> of(const LabelVolume& labels, const LabelSurfaces* former,
                                       const std::function<bool()>& cancelled = {});

  const std::map<Key, std::shared_ptr<const BlockSurface>>& blocks() const { return blocks_; }
  /// How many blocks were looked at anew.
  int blocks_made() const { return blocks_made_; }

 private:
  LabelVolume labels_;
  std::map<Key, std::shared_ptr<const BlockSurface>> blocks_;
  int blocks_made_ = 0;
};

}  // namespace glisson::scene
