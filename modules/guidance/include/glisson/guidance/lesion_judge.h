// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/operation_prior.h"

namespace glisson::guidance {

/// From when a lesion is no more drawn as itself. Metres, seconds.
struct LesionOptions {
  /// Reach of a lesion's 95 % region up to which it is drawn as a body: the margin with which it is usually
  /// resected.
  double margin = 10e-3;
  double useless = 30e-3;  ///< from that reach on its region is not drawn either: it says too little
  /// Forces that no simulation knew of move tissue that is out of sight. `unknown_forces`: that motion, rms.
  /// `reach`: the distance from tracked points over which it comes to act. Both are the registration's.
  double unknown_forces = registration::kUnforeseenMotion, reach = registration::kUnforeseenSpread;
  double settle = 2.0;  ///< within about this time they come to act where nothing is tracked
  double relief = 0.8;  ///< a limit counts again below this share of it, so that nothing flickers
  /// @throws InputError naming the option.
  void validate() const;
};

/// Judges each lesion of a model that is followed, from three things: the registration's error S at the
/// lesion, the distance d from it to the nearest tracked points, and the time t since any were near:
///     S_now = R S R^T + (D^2 w(d) + F^2 (1 - exp(-t / settle)) max(0, w(d) - w(d at first))) I / 3,
///     w(d) = 1 - exp(-d^2 / reach^2),
/// R is the organ's rotation since the registration, D the rms over nodes of its deformation since then (the
/// best rigid motion taken off), F `unknown_forces`. What was out of sight at first has them in S already, so
/// w(d at first) is taken off. Not thread-safe.
class LesionJudge {
 public:
  /// @throws InputError options out of range. @pre one node of the registration a node of the model.
  LesionJudge(const PatientModel& model, const Registration& start, const LesionOptions& options = {});
  ~LesionJudge();
  LesionJudge(LesionJudge&&) noexcept;
  LesionJudge& operator=(LesionJudge&&) noexcept;

  /// Goes on from another registration of the same model. When a lesion's surroundings were seen last, and
  /// how near, stays known: a new registration has seen nothing new. @pre as of the constructor.
  void take(const Registration& registration);
  /// Frames in their order. @param tracked places of the organ that were seen in this frame, camera frame.
  /// @return one verdict a lesion of the model, by label.
  std::vector<LesionVerdict> judge(const OverlayFrame& overlay, const PointsIn<CameraFrame>& tracked);
  /// Puts the lesions of an overlay where its organ is, when that is drawn elsewhere than it was judged.
  void carry(OverlayFrame& overlay) const;
  /// Of the registered frame itself, which is not followed.
  std::vector<LesionVerdict> at_start(Validity validity) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
