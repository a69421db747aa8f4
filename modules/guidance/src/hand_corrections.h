// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "anchored_points.h"
#include "corrector.h"
#include "glisson/geometry/camera.h"
#include "glisson/guidance/boundary_springs.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/registration.h"
#include "relocator.h"

namespace glisson::guidance {

/// Where points that are bound to the surface belong after the registered shape has changed.
struct BindingChange {
  Rebind of_followed, of_remembered;
  std::function<std::optional<ClosestPoint>(const ClosestPoint&)> of_surface;
};

/// Corrections by hand since tracking began. All are kept in the registered shape. In it, a followed piece of
/// tissue has one place, which no correction changes; a correction changes where the model lies there. So a
/// correction holds while the tissue moves, later ones are weighed with it, and it can be taken back.
class HandCorrections {
 public:
  /// @param at_rest free of stress in the registered shape, where the surface is.
  HandCorrections(const PatientModel& model, const StereoRig& rig,
                  std::shared_ptr<const fem::CompositeModel> at_rest, registration::MovingSurface surface);

  /// The registered shape with the corrections that stand.
  const Points& shape() const { return shape_; }
  const std::vector<CorrectionMade>& made() const { return made_; }
  /// Motions of the nodes in the registered shape (N x 3, metres), turned as the organ is at present.
  Points carried(const Points& motions, const Points& present) const;

  struct Proposal {
    Points shape;
    Correction correction;  ///< in pixels of the last frame
    SightPull pull;
    bool replaces = false;  ///< the last one, whose gesture goes on
  };
  /// @param present nodes, camera's frame. @param anchors of the points that are followed. @throws
  /// InputError.
  Proposal propose(const Correction& correction, const Points& present,
                   const std::unordered_map<int, Anchor>& anchors) const;

  /// What a correction changed, as it was.
  struct Step {
    Points shape, positions, velocities;
    BoundarySprings springs;
    std::unordered_map<int, Anchor> followed, remembered;
    std::shared_ptr<const Relocator::Saved> keys;
    int frame = 0;
  };
  /// @param former as it was before; of a gesture that goes on, what was before the gesture counts.
  void accept(const Proposal& proposal, Step former, const OverlayFrame& overlay);
  /// @pre there is one.
  const Step& last() const { return steps_.back(); }
  void take_back();

  /// The organ was registered again: another shape without corrections.
  struct Renewal {
    Corrector corrector;
    Points shape;  ///< with what hands have said so far
  };
  /// @param at_rest free of stress in the new shape, where the surface is. @param anchors of the points that
  /// are followed. @throws InputError where what hands have said cannot be met from there.
  Renewal renewed(std::shared_ptr<const fem::CompositeModel> at_rest, const Points& registered,
                  const std::unordered_map<int, Anchor>& anchors) const;
  /// What hands have said stays, but no correction can be taken back any more: what it changed is gone.
  void accept(Renewal renewal);

  BindingChange change_to(const Points& shape) const;
  /// What was bound then is bound as then.
  BindingChange change_back() const;

 private:
  /// Of followed tissue in the registered shape, bound to the model in `shape`.
  Points places(const std::unordered_map<int, Anchor>& anchors, const Points& shape) const;
  SightPull pull_of(const Correction& correction, const Points& present) const;

  PatientModel model_;
  StereoRig rig_;
  Corrector corrector_;
  registration::MovingSurface surface_;  ///< in shape_
  Points shape_;
  std::vector<CorrectionMade> made_;
  std::vector<SightPull> pulls_, before_;  ///< before_: made before the registration that is corrected now
  std::vector<Step> steps_;
};

}  // namespace glisson::guidance
