// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/model/build.h"
#include "glisson/patient/patient_model.h"

namespace glisson::engine {

namespace part {
/// The biomechanical model of this patient's liver.
extern const PartOf<model::BuiltModel> model;
}  // namespace part

/// The model's own landmarks, with what a person placed instead of them.
/// @pre the state has a model.
Landmarks effective_landmarks(const CaseState& state);
/// The model with its effective landmarks: what registration reads. @pre the state has a model.
PatientModel effective_model(const CaseState& state);

}  // namespace glisson::engine
