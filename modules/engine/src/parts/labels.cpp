// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/labels.h"

#include <nlohmann/json.hpp>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/review.h"
#include "glisson/segmentation/kept_notes.h"
#include "glisson/volume/io.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

bool has_steps(const CaseState& state) {
  return state[part::history] && !state[part::history]->steps().empty();
}

json save(const CaseState& state, const CaseFolder& folder) {
  write_labels(folder.path / "labels.seg.nrrd", state[part::labels]->voxels, reviewed_infos(state));
  if (has_steps(state)) {
    fs::create_directory(folder.path / "history");
    editing::write_history(folder.path / "history", *state[part::history]);
  }
  return {{"notes", kept_notes(state)}};
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  auto file = read_labels(folder.path / "labels.seg.nrrd", folder.context);
  if (!file) return;
  const auto labels =
      std::make_shared<const LabelMap>(LabelMap{std::move(file->voxels), std::move(file->infos)});
  state[part::labels] = labels;
  if (fs::exists(folder.path / "history/steps.json"))
    state[part::history] = std::make_shared<const editing::History>(
        editing::read_history(folder.path / "history", labels->voxels));
  if (const auto notes = entry.find("notes"); notes != entry.end())  // cases of before have none
    state[part::label_notes] =
        std::make_shared<const std::vector<std::string>>(notes->get<std::vector<std::string>>());
  const auto& image = state[part::image];
  const bool measurable = image && image->grid.same_as(labels->voxels.grid());
  state[part::statistics] =
      std::make_shared<const segmentation::LabelStatistics>(*labels, measurable ? image.get() : nullptr);
}

bool same(const CaseState& written, const CaseState& read) {
  return read[part::labels]->voxels == written[part::labels]->voxels &&
         kept_notes(read) == kept_notes(written) &&
         (!has_steps(written) ||
          (has_steps(read) && read[part::history]->steps().size() == written[part::history]->steps().size()));
}

}  // namespace

std::vector<std::string> kept_notes(const CaseState& state) {
  return state[part::label_notes] ? *state[part::label_notes] : std::vector<std::string>();
}

std::vector<std::string> told_of_labels(const CaseState& state) {
  const auto& seeds = state[part::seeds];
  return segmentation::with_numbers(kept_notes(state), seeds ? *seeds : segmentation::Seeds());
}

const PartOf<editing::History> part::history{{.code = "history"}};
const PartOf<segmentation::LabelStatistics> part::statistics{{.code = "statistics"}};
const PartOf<std::vector<std::string>> part::label_notes{{.code = "label_notes"}};
const PartOf<LabelMap> part::labels{{.code = "labels",
                                     .made_of = {part::image, part::seeds},
                                     .remedy = "Segment the CT or import labels first",
                                     .files = {"labels.seg.nrrd", "history/*.json", "history/*.nrrd"},
                                     .save = save,
                                     .load = load,
                                     .same = same,
                                     .companions = {&part::history, &part::statistics, &part::label_notes},
                                     // Labels that a hand has changed no longer follow from seeds alone.
                                     .changed_frees_from = {part::seeds}}};

}  // namespace glisson::engine
