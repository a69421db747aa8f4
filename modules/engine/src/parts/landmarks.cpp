// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/landmarks.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "case_files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/model.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  write_landmarks(folder.path / "landmarks.json", *state[part::landmarks]);
  return json::object();
}

void load(CaseState& state, const json&, const CaseFolder& folder) {
  state[part::landmarks] = std::make_shared<const Landmarks>(read_landmarks(folder.path / "landmarks.json"));
}

bool same(const CaseState& written, const CaseState& read) {
  const Landmarks &a = *written[part::landmarks], &b = *read[part::landmarks];
  return same_points(a.anterior_margin, b.anterior_margin) &&
         a.margin_deviation.size() == b.margin_deviation.size() &&
         (a.margin_deviation.size() == 0 ||
          (a.margin_deviation - b.margin_deviation).cwiseAbs().maxCoeff() < 1e-9) &&
         std::abs(a.notch_deviation - b.notch_deviation) < 1e-9 &&
         same_points(a.umbilical_notch, b.umbilical_notch) && same_points(a.vena_cava, b.vena_cava);
}

}  // namespace

const PartOf<Landmarks> part::landmarks{{.code = "landmarks",
                                         .made_of = {part::model},
                                         .remedy = "Place or accept the landmarks first",
                                         .files = {"landmarks.json"},
                                         .save = save,
                                         .load = load,
                                         .same = same}};

}  // namespace glisson::engine
