// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRect>
#include <memory>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/slice_picture.h"

namespace glisson::scene {

/// A slice that is drawn again and again, as while labels are painted: it keeps its layers and draws only
/// what has changed. The picture is always that of slice_picture(). Not thread-safe.
class SliceDrawing {
 public:
  /// @param labels may be null. @pre image has voxels. @throws InputError as slice_picture().
  /// @return the pixels that were drawn anew; the whole picture when the slice, the image or the style is
  /// another; empty when nothing has changed.
  QRect draw(const std::shared_ptr<const Image>& image, const std::shared_ptr<const LabelMap>& labels,
             const SliceGeometry& geometry, const SliceStyle& style);
  void clear();

  /// Of the last draw(); empty before it. Earlier pictures stay as they were.
  const Picture& picture() const { return picture_; }
  const SliceGeometry& geometry() const { return geometry_; }

 private:
  std::shared_ptr<const Image> image_;
  std::shared_ptr<const LabelMap> labels_;
  SliceGeometry geometry_;
  SliceStyle style_;
  std::vector<std::uint8_t> grey_;  ///< without labels
  std::vector<Label> found_;        ///< label of each pixel
  Picture picture_;
};

/// What an edit would change on a slice, to be laid over its picture: hatched in the colour that it will have
/// (white where a label goes), with a yellow outline. Null when nothing changes there. @pre one grid.
QImage change_overlay(const LabelVolume& before, const LabelVolume& after, const SliceGeometry& geometry);

/// The outlines of labels alone, two pixels wide. Null when there is none on the slice.
QImage outline_overlay(const LabelVolume& labels, const SliceGeometry& geometry);

}  // namespace glisson::scene
