// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

namespace glisson::guidance {

/// The views at the size at which they are followed: larger ones are made smaller (reduction_of()), each
/// pixel the mean of those that it stands for. What is followed, how it is judged and what it costs are those
/// of the smaller picture; the organ is told in the camera's frame, so that it is drawn at the picture's own
/// size.
class ReducedViews {
 public:
  /// @param rig of the views as they come.
  explicit ReducedViews(const StereoRig& rig);

  /// Of the reduced views: the same rays.
  const StereoRig& rig() const { return small_; }
  /// @throws InputError naming the view: it is not of the calibration's size.
  void require_frame(const StereoFrame& frame) const;
  /// A view that is not of the calibration's size is left out, for it shows nothing that is known.
  StereoFrame reduced(const StereoFrame& frame) const;
  /// One channel; non-zero where a pixel that it stands for is. @throws InputError another size than the left
  /// view's. Empty stays empty.
  Picture reduced_mask(const Picture& mask) const;
  /// Null, and one of another size than the left view's, which holds nothing out: null.
  std::shared_ptr<const PictureMask> reduced(const std::shared_ptr<const PictureMask>& mask) const;

 private:
  Picture reduced(const Picture& picture, const Camera& camera) const;

  StereoRig whole_, small_;
  int times_ = 1;
};

}  // namespace glisson::guidance
