// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>

#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/seeds.h"

/// Cases that are told apart by the place of one click.
namespace glisson::test {

inline engine::SetSeeds seeds(double x) {
  segmentation::Seeds clicked;
  clicked.liver = Eigen::RowVector3d(x, 0.0, 0.0);
  return {clicked};
}
/// To a micrometre, as files keep it.
inline double seed_of(const engine::CaseState& state) {
  return std::round(1e6 * state[part::seeds]->liver(0, 0)) / 1e6;
}
inline double seed_on_disk(const std::filesystem::path& path) {
  return seed_of(*engine::open_case(path, RunContext()));
}

}  // namespace glisson::test
