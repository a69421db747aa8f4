// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/geometry/camera.h"
#include "glisson/geometry/rigid.h"
#include "glisson/insilico/theatre.h"

namespace glisson::insilico {

/// A stereo laparoscope: Brown distortion and slightly different lenses in both, the cameras turned a little
/// towards each other.
StereoRig make_rig(const TheatreOptions& options);

/// Where the laparoscope stands: among seeded views from the front and below, at the wanted distance and
/// clear of the liver, the one that sees most of the surface, of the margin and the notch.
/// @param liver as it lies in the first frame, CT axes. @param margin, notch carried likewise.
CameraFromCt place_camera(const TriangleMesh& liver, const Points& margin, const Points& notch,
                          const StereoRig& rig, const TheatreOptions& options);

/// @param seconds since frame 0.
Rigid<CameraFrame, CameraFrame> scope_motion(const ScopePath& path, double seconds);

/// What is behind the liver: a bumpy bowl about the optical centre, beyond all that is seen of the liver.
/// Left camera's frame, metres.
TriangleMesh make_wall(const TriangleMesh& liver_in_camera, const StereoRig& rig, std::uint64_t seed);

}  // namespace glisson::insilico
