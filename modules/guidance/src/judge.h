// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "glisson/guidance/judge_options.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "stereo_follower.h"
#include "tissue_map.h"

namespace glisson::guidance {

/// Judges overlays by evidence that is not the tracker's own: a fresh stereo surface several times a second,
/// made beside the live loop; the pictures' contrast; whether they move, and together. The same frames give
/// the same verdicts, however fast the machine is. Not thread-safe.
class Judge {
 public:
  /// @param mask empty, or non-zero where tissue may be seen (left picture).
  Judge(const PatientModel& model, const StereoRig& rig, const Picture& mask, const JudgeOptions& options);
  ~Judge();

  /// Looks at once at how the start fits its frame. @throws InputError pictures of another size.
  void begin(const StereoFrame& first, const Points& nodes_in_camera);
  /// Fresh surfaces are kept in this shape, that of begin() from the start (see TissueMap).
  void keep_tissue_in(const Points& shape);
  /// What they have shown of the tissue while nothing but the place was in doubt.
  const TissueMap& tissue() const;
  /// The model was set elsewhere: what was seen of it before is no evidence, and it is not shown until fresh
  /// surfaces agree; they are made one after the other until then.
  void distrust();
  /// Surfaces speak against where the model is.
  bool refutes() const;
  /// Since distrust(), surfaces have neither confirmed nor refuted where the model is.
  bool is_undecided() const;
  /// @param points that were followed into this frame.
  /// @param overlay one that the tracker takes for valid; its evidence is filled in.
  /// @param not_liver empty, or a mask of the left picture: what it covers is not kept as tissue(). No
  /// evidence knows of it.
  /// @return what to say of it.
  Validity judge(const StereoFrame& frame, const std::vector<FollowedPoint>& points, OverlayFrame& overlay,
                 const Picture& not_liver = {});
  /// Of all that the last verdict rests on the most that was measured against the overlay, as a share of its
  /// limit: from 1 on one is reached, if not yet for as long as it takes to be said.
  double strength() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::guidance
