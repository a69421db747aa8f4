// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/fem/composite_model.h"
#include "glisson/geometry/camera.h"
#include "glisson/guidance/judge_options.h"
#include "glisson/guidance/lesion_judge.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/register_model.h"

namespace glisson::guidance {

/// How an organ is followed, and from when it is no longer shown. Defaults are for 30 frames a second.
struct TrackerOptions {
  int points = 200;                  ///< wanted; each is followed in both pictures
  double forward_backward_px = 1.0;  ///< gate on the disagreement
  double epipolar_px = 2.0;          ///< gate on how far a pair's rays pass by each other
  int window_px = 17, levels = 3;    ///< of Lucas-Kanade
  int minimum_pairs = 30;            ///< fewer: no overlay
  double most_masked = 0.5;          ///< share of the organ in sight from which a mask degrades the overlay
  double maximum_residual = 5e-3;    ///< m; more: no overlay
  /// A frame in which a smaller share of the points agrees with its neighbours shows no one motion.
  double minimum_consistent_share = 0.5;
  double time_step = 1.0 / 30.0;  ///< s, of the mechanics; the video's clock does not change it
  int steps_per_frame = 1;        ///< of the mechanics
  /// Factor of eq. 14, metres: all points together pull as the visible surface would with a stiffness of
  /// point_stiffness * E on each reference area, however many points there are.
  double point_stiffness = 1e-2;
  /// begin() takes the registered shape for the one at rest: what brought the organ there (gas, neighbours)
  /// goes on holding it, and no picture shows it. Clouds that are followed without begin() keep the model's
  /// own rest shape.
  bool hold_start = true;
  fem::CompositeOptions materials;
  double boundary_young_modulus = 20e6;  ///< vena cava, tree entrances, Pa; 0: none
  double boundary_length = 0.05;         ///< of those structures, m: k = E A / L
  /// N/m a structure, of what they hang on, which breathes with the diaphragm. Large: fixed ends, as in the
  /// paper. Why not: HOLDING.md.
  double boundary_tether = 100.0;
  /// A hand holds the laparoscope, and the patient breathes: the rigid motion that most of the organ in sight
  /// shows, near to that of the scene beside it, is the whole patient's before the camera, boundary springs'
  /// places included. False, or nodes are fixed: the camera stands, as in the paper.
  bool scope_moves = true;
  std::vector<int> fixed_nodes;  ///< 0-based, of the model's mesh; they stay where the start has them
  JudgeOptions judge;            ///< of pictures; clouds: see follow(cloud)
  LesionOptions lesions;
  /// For follow(cloud): form, s, surface stiffness, density, and of contact forces the lesions' stiffness.
  registration::ElasticOptions cloud;
  /// How clouds are followed; automatic as in register_model, by `fixed_nodes`.
  registration::Method cloud_method = registration::Method::automatic;
  /// Of its own, the materials', the judges' and the clouds'. @throws InputError naming the option.
  void validate() const;
};

/// Temporal registration (paper 2.2.3): points on the organ followed by pyramidal Lucas-Kanade forward and
/// backward in both images, triangulated, pulling at the model; one registration a frame. Not thread-safe.
class Tracker {
 public:
  /// @throws InputError options out of range, a start that is not of this model or not finite.
  Tracker(const PatientModel& model, const Registration& start, const TrackerOptions& options);
  ~Tracker();
  Tracker(Tracker&&) noexcept;
  Tracker& operator=(Tracker&&) noexcept;

  /// Gives the video its camera and its first frame: the one that `start` was registered to.
  /// @param mask optional, non-zero where tissue may be followed.
  /// @throws InputError pictures or mask of another size than the calibration's, or empty; a start that turns
  ///   elements inside out.
  void begin(const StereoRig& rig, const StereoFrame& first, const Picture& mask);
  /// What somebody else than the tracker says is not liver; also before begin(). Points there neither begin
  /// nor pull, from the next frame on, until another mask is given. Nothing else is changed by it: it can
  /// only silence points. Null: none. A mask of another size than the pictures is no mask.
  void see(std::shared_ptr<const PictureMask> not_liver);
  /// The next frame. Always returns; validity says whether it may be shown. Without begin(): not_started. A
  /// frame without a usable picture is too_few_points; the next good one is followed from the last good one.
  OverlayFrame follow(const StereoFrame& frame);
  /// The most that Evidence on the last frame said against its overlay, as a share of its limit: from 1 on a
  /// limit is reached, if not yet for long enough to be said. 0: nothing is judged.
  double evidence_strength() const;
  /// Registration to a cloud instead of pictures (no correspondences in time are assumed), labels unused: by
  /// contact forces (registration/force_follower.h), or eq. 14 on the whole surface at its final stiffness,
  /// `steps` implicit steps with new pairs each. Repeated points and those at the lens are left out. A cloud
  /// that would bring the organ 20 mm away, mean over the nodes, is surface_apart: closest points cannot tell
  /// it from another organ, unit or camera. So is one that only a shape explains which no tissue has
  /// (registration::is_beyond_tissue()). It is forgotten, the organ stays.
  OverlayFrame follow(const LabelledCloud& cloud, int index, double seconds, int steps);

  /// A hand says where a place of the organ is in the last frame. The registered shape goes there, as
  /// elasticity and the tissue that is tracked make most probable, with all that is bound to it: what is
  /// followed stays where it is, and shows other places of the model from now on. A piece of the last
  /// correction's gesture takes its place. No evidence is touched: a place that surfaces refuted is shown
  /// again only when they agree.
  /// @return the last frame's overlay as it is now. @throws InputError the organ was not followed in pictures
  ///   there, the place is out of sight, farther than 40 mm from where it is drawn, or no shape of the organ
  ///   meets it; nothing has changed.
  OverlayFrame correct(const Correction& correction);
  /// Takes the last correction back: registered shape, springs and bindings are what they were.
  /// @throws InputError there is none.
  OverlayFrame undo_correction();
  /// Those that stand, the oldest first.
  const std::vector<CorrectionMade>& corrections() const;

  /// The organ was registered again while it was followed: a better shape for the moment of `start`, in that
  /// moment's frame. All that is bound goes along, as for correct(); hands' corrections are kept in it, and
  /// can no longer be taken back. Of an organ that is drawn, the picture changes over a second.
  /// @return the last frame's overlay as it is now. @throws InputError the organ was not followed in pictures
  ///   there, one that is not of this model, not finite or inside out; nothing has changed.
  OverlayFrame take(const Registration& registration);
  /// Where fresh stereo has seen the tissue since begin(), all looks joined in the moment of `start`: its
  /// left camera's frame, metres, and from where it was seen. Null: three looks have not yet been had.
  std::shared_ptr<const LabelledCloud> tissue_at_start() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
