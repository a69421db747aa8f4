// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "glisson/core/termination.h"
#include "glisson/geometry/mesh.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/lesion_verdict.h"
#include "glisson/patient/sound_cloud.h"

namespace glisson {

/// Another place where the organ may be, by what the cloud tells.
struct RegistrationRival {
  Points nodes_in_camera;    ///< as Registration::nodes_in_camera
  double probability = 0.0;  ///< beside the registration's own and the other rivals'
};

/// A force that acts on the organ where the registration has put it.
struct FoundForce {
  int node = -1;                                    ///< of the model's mesh, where its patch has its middle
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< N for a Young's modulus of 1 kPa, camera frame
};

/// How far off a lesion is expected to be once more has been shown, metres.
struct LesionLooks {
  Label lesion = 0;
  double now = 0.0;  ///< as it is
  /// Once the surface around each node has been seen as well; `now` where no look is offered or none helps.
  Eigen::VectorXd seen;
  /// Once margin or notch have been marked where they are seen already; `now`: they are, or are not seen.
  double margin = 0.0, notch = 0.0;
};

/// Symmetric matrices, a row each: xx, yy, zz, xy, yz, xz (VTK's order).
using SymmetricRows = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;
/// Only the upper triangle is read; whether the matrix is symmetric is not checked.
Eigen::Matrix<double, 1, 6> symmetric_row(const Eigen::Matrix3d& matrix);
Eigen::Matrix3d symmetric_matrix(const Eigen::Matrix<double, 1, 6>& row);

/// Where a vessel tree forks, as far as it is known.
struct ForkSpread {
  Label tree = 0;                                    ///< structure of the vessel
  int order = 1;                                     ///< by radius among its tree's forks: the largest is 1
  double radius = 0.0;                               ///< metres
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< where it is thought to be, camera frame, metres
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of that, m2
};
/// For files and figures: "portal_vein_fork_1".
std::string fork_name(const ForkSpread& fork);
/// Tree and order of a name that fork_name() gives; empty: it is none.
std::optional<std::pair<Label, int>> fork_named(const std::string& name);

/// A model brought to what the camera sees.
struct Registration {
  /// The rigid part: where the undeformed model was put before it was deformed.
  CameraFromCt camera_from_ct;
  /// Every node of the model's mesh, camera frame, metres, in the model's order.
  Points nodes_in_camera;
  Termination termination = Termination::step_limit;
  int plateaus = 0, steps = 0;
  /// Mean distance of the cloud's points to the registered surface, metres. A residual, not an accuracy.
  double residual = 0.0;
  /// Share of the model's surface that the cloud shows.
  double seen_share = 0.0;
  /// What the method cannot vouch for; codes, not prose ("few_margin_points", "inverted_elements"). Empty:
  /// none.
  std::vector<std::string> doubts;
  /// What else was noted when it was made ("landmarks.not_reviewed"): codes, too.
  std::vector<std::string> notes;
  /// How far off each lesion may be; a lesion that is not in it: not known.
  std::vector<LesionSpread> lesions;
  /// What one more look would tell of them; a lesion that is not in it: not known, or refused.
  std::vector<LesionLooks> looks;
  /// The largest of portal vein and hepatic veins; none: there are none, or not known.
  std::vector<ForkSpread> forks;
  /// Mean error that is expected of each node, metres; empty: not known.
  Eigen::VectorXd expected;
  SymmetricRows covariances;  ///< of each node's place, m2, camera frame; no rows: not known
  /// Where else the organ may be, the most probable first: to be looked at by a person.
  std::vector<RegistrationRival> rivals;
  std::vector<FoundForce> forces;  ///< of tools, say; the strongest first
};

/// What is known of an overlay. All but `valid` are reasons why less than everything is drawn.
enum class Validity {
  valid,
  not_started,
  too_few_points,
  inconsistent_motion,
  residual_too_large,
  mechanics_failed,
  stale,
  // By evidence that is not the tracker's own:
  surface_apart,   ///< stereo sees the organ elsewhere than the model predicts
  picture_stands,  ///< the picture shows the same moment over and over
  views_apart,     ///< the two views do not show one moment of one scene
  partly_covered,  ///< a good part of where the organ should be shows something else, or nothing
  poor_picture,    ///< light or contrast is lost, as in smoke
  picture_still,   ///< nothing moves: the breath is held, or the picture is an old one; which cannot be told
  proposed,        ///< a place to be looked at: another one than the registered, or one that a hand has set
  // By a person's own network that masks what is not liver:
  mostly_masked,  ///< most of the organ in sight is masked
  masked_out,     ///< so much that too few points are left
  // Why too few points are left, where the pictures tell:
  view_lost,      ///< one of the two views shows nothing, or far less than the other
  views_swapped,  ///< the left view is the right camera's, and the other way round
  picture_lost    ///< too little can be made out: dark, in smoke, noise
};
inline constexpr Validity kValidities[] = {Validity::valid,
                                           Validity::not_started,
                                           Validity::too_few_points,
                                           Validity::inconsistent_motion,
                                           Validity::residual_too_large,
                                           Validity::mechanics_failed,
                                           Validity::stale,
                                           Validity::surface_apart,
                                           Validity::picture_stands,
                                           Validity::views_apart,
                                           Validity::partly_covered,
                                           Validity::poor_picture,
                                           Validity::picture_still,
                                           Validity::proposed,
                                           Validity::mostly_masked,
                                           Validity::masked_out,
                                           Validity::view_lost,
                                           Validity::views_swapped,
                                           Validity::picture_lost};
const char* validity_code(Validity validity);

/// What may be drawn: all (`valid`), the outline and the lesions' regions (`degraded`: partly_covered,
/// poor_picture, picture_still, proposed, mostly_masked) or nothing (`withdrawn`: all others).
Level level_of(Validity validity);
/// Whether tissue of the organ was followed into the frame, whatever evidence says of where the organ is.
bool is_followed(Validity validity);

/// What was measured to judge an overlay by, besides the tracker's own points. Standard deviations are what
/// is expected of a right overlay.
struct Evidence {
  bool judged = false;      ///< false: too early, or there are no pictures
  double supported = 0.0;   ///< share of the predicted organ's surface where fresh stereo sees it
  double missing = 0.0;     ///< share by which that is less than of the same places before: what hides them
  double gap = 0.0;         ///< rms over regions of stereo's distance from that surface, standard deviations
  double local = 0.0;       ///< the same distance of one part of the organ, on which two regions agree
  double behind = 0.0;      ///< share of the predicted organ where stereo sees something farther away
  double before = 0.0;      ///< likewise, something nearer
  double lifted = 0.0;      ///< of `before`, what is the organ itself: its surface goes on there
  double pull = 0.0;        ///< metres; rms motion of the organ that would reconcile it with stereo
  double pull_sigma = 0.0;  ///< metres, standard deviation of that motion: what stereo cannot tell
  double contrast = 1.0;    ///< of the picture, over its noise, as a share of what it was at the start
  double motion = 0.0;      ///< of the picture in the last moments, standard deviations; about 1: it stands
  double fresh = -1.0;  ///< share of the picture's noise that the one before did not have; 0: it is a copy;
                        ///< negative: not known
  double rows = 0.0;    ///< pixels by which the views have come apart across the epipolar lines
};

/// What a mask of what is not liver did in a frame (PictureMask).
struct MaskUse {
  double share = 0.0;  ///< of the organ's surface in sight that is masked
  double age = 0.0;    ///< seconds since the picture that was masked
  int held_out = 0;    ///< followed points that it kept from pulling
};

/// The model at one frame of the video. A withdrawn one is never drawn.
struct OverlayFrame {
  int index = 0;
  double seconds = 0.0;
  Validity validity = Validity::not_started;
  bool doubtful = false;   ///< the registration that this began with carries doubts: drawn, and said so
  Points nodes_in_camera;  ///< as Registration::nodes_in_camera
  int tracked_left = 0, tracked_right = 0, pairs = 0;
  double residual = 0.0;               ///< metres, mean over the pairs
  double milliseconds = 0.0;           ///< tracking, correspondence and mechanics of this frame
  Evidence evidence;                   ///< the last one
  std::optional<MaskUse> mask;         ///< empty: none was used
  CloudFaults cloud_faults;            ///< of all clouds that were followed until now
  std::vector<LesionVerdict> lesions;  ///< one a lesion of the model; a lesion without one is not drawn
  Level level() const { return level_of(validity); }
};

}  // namespace glisson
