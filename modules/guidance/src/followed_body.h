// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/fem/integrator.h"
#include "glisson/geometry/rigid.h"
#include "glisson/guidance/boundary_springs.h"
#include "glisson/guidance/tracker.h"
#include "glisson/registration/moving_surface.h"

namespace glisson::guidance {

/// The organ that is followed, as a body: its mechanics, what holds it, and where it is. Camera's frame,
/// metres.
class FollowedBody {
 public:
  /// At its start, the CT's shape at rest.
  FollowedBody(const PatientModel& model, const Points& start_in_camera, const TrackerOptions& options);

  const Points& positions() const { return integrator_.positions(); }
  const Points& velocities() const { return integrator_.velocities(); }
  const registration::MovingSurface& surface() const { return surface_; }
  const BoundarySprings& springs() const { return springs_; }

  /// From now on the present shape is the one at rest. @throws InputError it cannot be followed.
  void rest_here();
  /// The composite of this organ that is free of stress in another shape. @param what brought it there, and
  /// what to do when it cannot be followed there, for the error. @throws InputError it has elements inside
  /// out.
  std::shared_ptr<const fem::CompositeModel> resting_in(
      const Points& shape, const char* what = "start",
      const char* remedy = "Register again, from more of the surface") const;
  const std::shared_ptr<const fem::CompositeModel>& composite() const { return composite_; }

  /// Moves the whole patient rigidly in the camera's frame, boundary springs included, as a motion of the
  /// camera does.
  void move(const RigidMotion& motion);
  /// Puts the nodes somewhere, at rest.
  void place(const Points& positions);
  /// Goes on with another rest shape. Each node moves by its row of `motion` (metres) and keeps its speed;
  /// the boundary springs go along.
  void take(std::shared_ptr<const fem::CompositeModel> resting, const Points& motion);
  /// As it was, to the bit.
  void restore(const Points& positions, const Points& velocities, const BoundarySprings& springs);
  void stop() { integrator_.stop(); }

  /// One implicit step under loads that `pull` adds. Elements may turn inside out. @return false: the
  /// mechanics failed, nothing has moved.
  template <class Pull>
  bool step(const Pull& pull) {
    fem::Loads loads;
    springs_.add(positions(), loads.attached);
    pull(loads.attached);
    if (!integrator_.step(loads).ok) {
      stop();
      return false;
    }
    surface_.move(positions());
    return true;
  }
  /// Tetrahedra that are inside out: without a positive volume.
  int inverted() const;
  /// So many steps, after which no more elements are inside out than before: a registration may have left
  /// some. @return false: the mechanics failed, or elements were turned; nothing has moved.
  template <class Pull>
  bool advance(int steps, const Pull& pull) {
    const Points there = positions();
    const int before = inverted();
    bool is_good = true;
    for (int i = 0; i < steps && is_good; ++i) is_good = step(pull);
    if (is_good && inverted() <= before) return true;
    place(there);
    return false;
  }

 private:
  fem::CompositeOptions materials_;
  fem::IntegratorOptions integration_;
  PatientModel mechanics_;  ///< mesh and vessels as they are in the CT
  std::shared_ptr<const fem::CompositeModel> composite_;
  fem::Integrator integrator_;
  registration::MovingSurface surface_;
  BoundarySprings springs_;
};

}  // namespace glisson::guidance
