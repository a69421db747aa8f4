// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "glisson/fem/composite_model.h"
#include "glisson/geometry/rigid.h"
#include "glisson/registration/moving_surface.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// A place of the surface's material.
struct Anchor {
  ClosestPoint at;      ///< triangle and weights
  double height = 0.0;  ///< along the surface's normal, metres

  /// Where it is on the surface as that is now.
  Eigen::Vector3d place(const registration::MovingSurface& surface) const {
    return surface.place(at) + height * surface.normal(at);
  }
};

/// Where a place of the material is after a correction; empty: nowhere.
using Rebind = std::function<std::optional<Anchor>(int id, const Anchor& anchor)>;

/// Where followed points sit on the model. A point is bound to a place of the surface when it is first seen,
/// and keeps that place: so it also tells how the tissue moves along the surface, which a closest point
/// cannot. Its height above the surface at that time (stereo's depth error, the coarse mesh) is kept, too, so
/// that only motion pulls.
class AnchoredPoints {
 public:
  /// Binds to the closest place of the surface as it is now. @return false, and nothing bound, farther than
  /// `radius` from it.
  bool bind(const FollowedPoint& point, const registration::MovingSurface& surface, double radius);
  /// A place that is known already.
  void bind(int id, const Anchor& anchor) { anchors_[id] = anchor; }
  /// @pre bound.
  const Anchor& anchor(int id) const { return anchors_.at(id); }
  /// Binds every point anew after the model was corrected: the same tissue belongs elsewhere on it.
  /// @return one decision a point, false: the model has no place for it, and it is forgotten.
  std::vector<char> rebind(const std::vector<FollowedPoint>& points, const Rebind& rebind);
  const std::unordered_map<int, Anchor>& anchors() const { return anchors_; }
  /// Forgets all that are not among `points`.
  void retain(const std::vector<FollowedPoint>& points);

  /// Measured minus modelled place of each point, metres. @pre all bound.
  std::vector<Eigen::Vector3d> gaps(const std::vector<FollowedPoint>& points,
                                    const registration::MovingSurface& surface) const;
  /// The rigid motion that brings the model's places nearest to where the points were seen. @pre all bound.
  RigidMotion common_motion(const std::vector<FollowedPoint>& points,
                            const registration::MovingSurface& surface) const;
  /// A spring from each point's place on the model to where it was seen, weaker along the line of sight.
  void add(const std::vector<FollowedPoint>& points, const registration::MovingSurface& surface,
           double stiffness, std::vector<fem::AttachedLoad>& loads) const;

  void clear() { anchors_.clear(); }

 private:
  std::unordered_map<int, Anchor> anchors_;
};

/// Which gaps agree with those of their neighbours: the difference from the neighbours' median, measured as
/// the points' information weighs it, is under `deviations` scaled MADs of all such differences, or under
/// `floor` metres. One decision a point.
std::vector<char> consistent(const std::vector<FollowedPoint>& points,
                             const std::vector<Eigen::Vector3d>& gaps, double deviations, double floor);

}  // namespace glisson::guidance
