// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/moments.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case_files.h"
#include "case_manifest.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/keep_moment.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "moment_files.h"
#include "ranged.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  const KeptMoments& kept = *state[part::moments];
  json numbers = json::array();
  for (const auto& moment : kept.moments) {
    write_moment(folder.path, folder.home, *moment);
    numbers.push_back(moment->number);
  }
  return {{"numbers", numbers}, {"last", kept.last}};
}

/// @throws InputError they are not what a save writes.
std::vector<int> numbers_in(const json& entry, const CaseFolder& folder) {
  const auto refuse = [&folder](const std::string& problem) {
    throw InputError((folder.path / kCaseFile).string(), "moments.numbers", problem,
                     "Restore the case from a copy");
  };
  const json& list = entry.at("numbers");
  if (!list.is_array() || list.empty() || list.size() > kMostMoments) refuse("is not of the right kind");
  std::vector<int> numbers;
  for (const json& number : list) {
    if (!number.is_number_integer() || number < 1 || number > 1000000) refuse("is not of the right kind");
    numbers.push_back(number.get<int>());
  }
  std::vector<int> sorted = numbers;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) refuse("names a moment twice");
  return numbers;
}

/// Each moment by itself: one that is damaged is named and left out, the others open.
void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  KeptMoments kept;
  const bool is_listed = or_lost(folder, "case.moment_lost", [&] {
    kept.last = ranged<int>(folder.path, entry, "last", 0.0, 1e6);
    for (const int number : numbers_in(entry, folder)) {
      if (folder.context.cancelled()) return;
      or_lost(folder, "case.moment_lost", [&] {
        kept.moments.push_back(std::make_shared<const KeptMoment>(read_moment(folder.path, number)));
      });
      kept.last = std::max(kept.last, number);
    }
  });
  if (!is_listed || folder.context.cancelled() || kept.moments.empty()) return;
  state[part::moments] = std::make_shared<const KeptMoments>(std::move(kept));
}

bool same(const CaseState& written, const CaseState& read) {
  const KeptMoments &a = *written[part::moments], &b = *read[part::moments];
  return a.last == b.last &&
         std::equal(a.moments.begin(), a.moments.end(), b.moments.begin(), b.moments.end(),
                    [](const auto& one, const auto& other) { return same_moment(*one, *other); });
}

}  // namespace

const PartOf<KeptMoments> part::moments{{.code = "moments",
                                         .remedy = "Keep a moment of the live view first",
                                         .files = {"moments/*.json", "moments/*.jsonl", "moments/*.png"},
                                         .save = save,
                                         .load = load,
                                         .same = same,
                                         .stands_alone = true,
                                         .is_input = false}};

std::shared_ptr<const KeptMoment> moment_of(const CaseState& state, int number) {
  if (!state[part::moments]) return nullptr;
  for (const auto& moment : state[part::moments]->moments)
    if (moment->number == number) return moment;
  return nullptr;
}

bool is_drawn_as_it_was(const CaseState& state, const KeptMoment& moment) {
  const auto& model = state[part::model];
  if (!model || !state[part::rig]) return false;
  const Eigen::Index nodes = moment.overlay.nodes_in_camera.rows();
  return state.stamp(part::model).revision == moment.model_revision &&
         state.stamp(part::rig).revision == moment.rig_revision &&
         (nodes == 0 || nodes == model->model.mesh.vertex_count());
}

}  // namespace glisson::engine
