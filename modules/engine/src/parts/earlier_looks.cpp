// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/earlier_looks.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "case_files.h"
#include "case_manifest.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/keep_look.h"
#include "glisson/engine/parts/cloud.h"

namespace glisson::engine {
namespace {
using nlohmann::json;
namespace fs = std::filesystem;

constexpr LengthUnit kUnit = LengthUnit::millimetre;

fs::path file_of(const CaseFolder& folder, std::size_t number) {
  return folder.path / "looks" / ("look_" + std::to_string(number + 1) + ".ply");
}

json save(const CaseState& state, const CaseFolder& folder) {
  const auto& clouds = state[part::earlier_looks]->clouds;
  fs::create_directories(folder.path / "looks");
  for (std::size_t k = 0; k < clouds.size(); ++k) write_cloud(file_of(folder, k), *clouds[k], kUnit);
  return {{"count", clouds.size()}, {"pairs", state[part::earlier_looks]->pairs}};
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  const auto count = entry.at("count").get<std::int64_t>();
  if (count < 1 || count > static_cast<std::int64_t>(kMostLooks))
    throw InputError((folder.path / kCaseFile).string(), "earlier_looks.count",
                     "is " + std::to_string(count) + ", not between 1 and " + std::to_string(kMostLooks),
                     "Restore the case from a copy");
  EarlierLooks looks;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
    looks.clouds.push_back(std::make_shared<const LabelledCloud>(read_cloud(file_of(folder, k), kUnit)));
  looks.pairs = entry.value("pairs", std::vector<std::string>());  // cases of before have none
  looks.pairs.resize(looks.clouds.size());
  state[part::earlier_looks] = std::make_shared<const EarlierLooks>(std::move(looks));
}

bool same(const CaseState& written, const CaseState& read) {
  const auto &a = written[part::earlier_looks]->clouds, &b = read[part::earlier_looks]->clouds;
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!same_points(a[k]->points, b[k]->points)) return false;
  return true;
}

}  // namespace

const PartOf<EarlierLooks> part::earlier_looks{{.code = "earlier_looks",
                                                .remedy = "Keep a cloud as an earlier look first",
                                                .files = {"looks/*.ply"},
                                                .save = save,
                                                .load = load,
                                                .same = same,
                                                .stands_alone = true}};

std::vector<std::shared_ptr<const LabelledCloud>> looks_to_join(const CaseState& state) {
  std::vector<std::shared_ptr<const LabelledCloud>> looks;
  if (!state[part::earlier_looks]) return looks;
  const EarlierLooks& kept = *state[part::earlier_looks];
  const std::string pair = state[part::points] ? state[part::points]->frame_identity : std::string();
  for (std::size_t k = 0; k < kept.clouds.size(); ++k) {
    const bool is_of_now = !pair.empty() && k < kept.pairs.size() && kept.pairs[k] == pair;
    if (!state[part::cloud] ||
        (!is_of_now && !same_points(kept.clouds[k]->points, state[part::cloud]->points)))
      looks.push_back(kept.clouds[k]);
  }
  return looks;
}

}  // namespace glisson::engine
