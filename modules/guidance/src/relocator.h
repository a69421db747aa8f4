// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "glisson/geometry/camera.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/picture.h"
#include "glisson/registration/moving_surface.h"

namespace glisson::guidance {

/// Finds the organ again after it was lost from sight. Key frames hold SIFT's descriptors of the left
/// picture, each bound to the material of the surface that it was seen on; a new picture's are matched to
/// those by brute force (as CudaSIFT-SLAM 2024 found places again inside the body), and the camera's pose is
/// the one that most of the matches agree on (RANSAC over perspective poses). Not thread-safe.
class Relocator {
 public:
  /// @param mask empty, or non-zero where tissue may be seen (left picture).
  Relocator(const StereoRig& rig, const Picture& mask);
  ~Relocator();

  /// A key frame: the surface is where the picture shows the organ. The first is kept for good, of the later
  /// ones the newest few. Returns at once: the work is done beside the live loop.
  void remember(const Picture& left, const registration::MovingSurface& surface);

  /// Binds the key frames anew after the model was corrected: the same tissue belongs elsewhere on it. Places
  /// for which `rebind` gives nothing are forgotten.
  void rebind(const std::function<std::optional<ClosestPoint>(const ClosestPoint&)>& rebind);
  /// The key frames as they are bound now. restore() binds these as they were, and those made since then by
  /// `rebind`.
  struct Saved;
  std::shared_ptr<const Saved> save();
  void restore(const Saved& saved,
               const std::function<std::optional<ClosestPoint>(const ClosestPoint&)>& rebind);

  /// @param surface where the model stands now, camera's frame.
  /// @return the motion (metres, camera's frame) that carries it to where the picture shows the organ; empty:
  /// the picture is not recognised.
  std::optional<RigidMotion> find(const Picture& left, const registration::MovingSurface& surface);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
