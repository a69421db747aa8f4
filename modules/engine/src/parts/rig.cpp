// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/rig.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case_files.h"
#include "glisson/stereo/calibration_io.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  stereo::write_calibration(folder.path / "calibration.yaml", *state[part::rig]);
  return json::object();
}

/// What an earlier program took (a skew, a transposed matrix) may be refused by now.
void load(CaseState& state, const json&, const CaseFolder& folder) {
  or_lost(folder, "case.calibration_lost", [&] {
    state[part::rig] =
        std::make_shared<const StereoRig>(stereo::read_calibration(folder.path / "calibration.yaml"));
  });
}

/// To a millionth of the largest number: a file rounds.
template <class A, class B>
bool close(const A& a, const B& b) {
  return (a - b).cwiseAbs().maxCoeff() <= 1e-6 * std::max(1e-6, a.cwiseAbs().maxCoeff());
}

bool same_camera(const Camera& a, const Camera& b) {
  return a.width == b.width && a.height == b.height && close(a.matrix, b.matrix) &&
         close(a.distortion, b.distortion);
}

bool same(const CaseState& written, const CaseState& read) {
  const StereoRig &a = *written[part::rig], &b = *read[part::rig];
  return same_camera(a.left, b.left) && same_camera(a.right, b.right) &&
         close(a.right_from_left.rotation, b.right_from_left.rotation) &&
         close(a.right_from_left.translation, b.right_from_left.translation);
}

}  // namespace

const PartOf<StereoRig> part::rig{{.code = "rig",
                                   .remedy = "Load the laparoscope's calibration first",
                                   .files = {"calibration.yaml"},
                                   .save = save,
                                   .load = load,
                                   .same = same}};

}  // namespace glisson::engine
