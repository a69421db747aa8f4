// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/overlay_status.h"

#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"

namespace glisson::ui {

scene::OverlayStatus overlay_status(const engine::CaseState& state) {
  const engine::LandmarkReview landmarks = engine::landmark_review(state);
  scene::OverlayStatus status;
  status.model_unchecked = state[part::model] && !engine::is_model_checked(state);
  status.landmarks_open = landmarks.is_open;
  status.landmarks_from_statistics = landmarks.from_statistics;
  return status;
}

scene::OverlayStatus overlay_status(const engine::KeptMoment& moment) {
  scene::OverlayStatus status;
  status.stands = true;
  status.model_unchecked = moment.model_unchecked;
  status.landmarks_open = moment.landmarks_open;
  status.landmarks_from_statistics = moment.landmarks_from_statistics;
  return status;
}

}  // namespace glisson::ui
