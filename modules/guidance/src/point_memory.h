// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "anchored_points.h"
#include "patch.h"
#include "stereo_follower.h"

namespace glisson::guidance {

/// Every place of the tissue that was ever followed, with how it looked when it was bound to the surface.
/// Lucas-Kanade's small errors add up from frame to frame; finding a point in its first picture again removes
/// them (Matthews, Ishikawa and Baker, The template update problem, 2004). A place that comes back into sight
/// keeps its first binding, whatever lies there on the model now: so it does not drift either. The model says
/// how a patch has turned and stretched since.
class PointMemory {
 public:
  explicit PointMemory(const StereoRig& rig) : rig_(rig) {}

  /// Keeps how a newly bound point looks. @param frame number, ascending.
  void remember(const FollowedPoint& point, const Anchor& anchor, const StereoFollower& pictures,
                const registration::MovingSurface& surface, int frame);
  /// Moves points to where their kept looks are found, each point every sixth time. One that was not found
  /// in the last ninety times is let go, unless most are not found: then the whole picture has changed.
  /// Frames in which it is not called, as dark ones, say nothing of any point.
  /// @return one decision a point, false: let it go.
  std::vector<char> confirm(StereoFollower& follower, const registration::MovingSurface& surface);
  /// Follows places again that were lost and should be in sight. Oldest first: they were bound closest in
  /// time to the registration. @param spacing pixels between points. @return how many.
  int recall(StereoFollower& follower, AnchoredPoints& anchors, const registration::MovingSurface& surface,
             int wanted, double spacing, int frame);
  /// Forgets what was bound after that frame: the model was not where the organ is.
  void forget_since(int frame);
  /// Forgets places that are none of the organ's.
  void forget(const std::vector<int>& ids);
  /// Binds every place anew after the model was corrected: the same tissue belongs elsewhere on it. Places
  /// for which there is none are forgotten.
  /// @param before, after the surface in the present frame, uncorrected and corrected.
  void rebind(const Rebind& rebind, const registration::MovingSurface& before,
              const registration::MovingSurface& after);
  std::unordered_map<int, Anchor> anchors() const;
  std::size_t size() const { return places_.size(); }

 private:
  /// How a place looked once in one view.
  struct View {
    Patch patch;
    Eigen::Matrix2d surface_from_pixels;  ///< the surface's own coordinates there (barycentric), then
  };
  struct Look {
    View left, right;
  };
  struct Place {
    Anchor anchor;
    std::vector<Look> looks;
    int born = 0;       ///< frame
    int confirmed = 0;  ///< confirmations_ when it was found last
    int try_from = 0;   ///< frame from which recall() looks for it again
    int misses = 0;     ///< times in a row that it did so in vain
  };
  struct Seen {
    PatchFound left, right;
    double stretch = 0.0;  ///< the logarithm of how much the best look had to be stretched
  };
  /// @param most pixels off the guesses.
  std::optional<Seen> find(const Place& place, const Eigen::Vector2d& left, const Eigen::Vector2d& right,
                           double most, const StereoFollower& pictures,
                           const registration::MovingSurface& surface) const;
  void add_look(Place& place, const FollowedPoint& point, const StereoFollower& pictures,
                const registration::MovingSurface& surface) const;
  Eigen::Vector3d in_right(const Eigen::Vector3d& p_in_camera) const {
    return rig_.right_from_left.rotation * p_in_camera + rig_.right_from_left.translation;
  }
  /// Pixels from the surface's own coordinates, as it is now.
  Eigen::Matrix2d pixels_of(const Anchor& anchor, bool left,
                            const registration::MovingSurface& surface) const;
  void make_room();

  StereoRig rig_;
  std::map<int, Place> places_;  ///< by the point's id
  int confirmations_ = 0;        ///< calls of confirm()
};

}  // namespace glisson::guidance
