// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/rig.h"

#include <nlohmann/json.hpp>

#include "glisson/stereo/calibration_io.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  stereo::write_calibration(folder.path / "calibration.yaml", *state[part::rig]);
  return json::object();
}

void load(CaseState& state, const json&, const CaseFolder& folder) {
  state[part::rig] =
      std::make_shared<const StereoRig>(stereo::read_calibration(folder.path / "calibration.yaml"));
}

}  // namespace

const PartOf<StereoRig> part::rig{{.code = "rig",
                                   .remedy = "Load the laparoscope's calibration first",
                                   .files = {"calibration.yaml"},
                                   .save = save,
                                   .load = load}};

}  // namespace glisson::engine
