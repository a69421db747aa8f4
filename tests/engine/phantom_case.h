// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../registration/phantom.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/simulate_operations.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"

namespace glisson::test {

/// The phantom with a lesion, its landmarks placed, and the part of it that a camera sees.
inline engine::CaseState phantom_case() {
  engine::CaseState state;
  auto built = std::make_shared<model::BuiltModel>();
  built->model = phantom::model(6, 5, 3);
  built->model.mesh.labels[200] = structure::kFirstLesion;
  state[part::model] = built;
  state[part::landmarks] = std::make_shared<const Landmarks>(phantom::landmarks());
  state[part::cloud] = std::make_shared<const LabelledCloud>(
      phantom::patch(built->model, phantom::view().apply(built->model.mesh.vertices), {}));
  return state;
}

/// Mild ones, and few: a second's work.
inline engine::SimulateOperations few_operations() {
  engine::SimulateOperations command;
  command.operations = 40;
  command.gravity = 1.0;
  command.gas_pa = 80.0;
  command.bed_m = 0.005;
  return command;
}

/// From where the phantom is, on few operations.
inline engine::Register register_on_few() {
  engine::Register command;
  command.start = engine::Register::Start::given;
  command.given = phantom::view();
  command.operation = few_operations();
  return command;
}

inline engine::CaseState after(const engine::CaseState& state, const engine::Command& command,
                               std::uint64_t seed = 1) {
  return engine::apply(state, command, RunContext({}, {}, seed)).value().state;
}

}  // namespace glisson::test
