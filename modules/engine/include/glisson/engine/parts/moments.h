// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/guidance/lesion_meter.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// What a person saw in one frame of the live view and has kept: the pictures as they were taken, and all
/// that its overlay is drawn from. Lengths in metres.
struct KeptMoment {
  int number = 0;       ///< in its case, from 1; 0: KeepMoment gives one
  std::string title;    ///< a person's words; may be empty
  std::string kept_at;  ///< UTC, "2026-01-31T10:20:30Z"
  /// Both pictures, PNG files' bytes. Never null.
  std::shared_ptr<const std::string> left_png, right_png;
  /// Of that frame and no other. Its nodes are those of the model of `model_revision`.
  OverlayFrame overlay;
  /// The rigid motion that comes nearest to where the nodes are; empty: there are none.
  std::optional<Eigen::Matrix4d> camera_from_model;
  Label chosen = 0;                                  ///< the lesion whose numbers were told; 0: none
  std::optional<guidance::LesionMeasures> measures;  ///< of the chosen one; empty: they were not told
  std::optional<guidance::SurfacePlace> place;       ///< that was marked on the organ
  PointsIn<CtFrame> margin;                          ///< anterior margin as it was drawn
  // What the picture said of the case.
  bool model_unchecked = false, landmarks_open = false, landmarks_from_statistics = false;
  /// Editions of what it was drawn with.
  std::uint64_t model_revision = 0, rig_revision = 0;
};

/// In the order in which they were kept.
struct KeptMoments {
  std::vector<std::shared_ptr<const KeptMoment>> moments;
  int last = 0;  ///< the largest number that was ever given: none is given twice
};

namespace part {
extern const PartOf<KeptMoments> moments;
}  // namespace part

/// Null: there is none of this number.
std::shared_ptr<const KeptMoment> moment_of(const CaseState& state, int number);
/// Whether model and calibration are those that the moment was drawn with. With others its overlay would not
/// be what it was, and must not be drawn.
bool is_drawn_as_it_was(const CaseState& state, const KeptMoment& moment);

}  // namespace glisson::engine
