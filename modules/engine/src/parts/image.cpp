// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/image.h"

#include <nlohmann/json.hpp>

#include "../image_file.h"
#include "../ranged.h"
#include "glisson/volume/io.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json entry_of(const CaseState& state) {
  const Image& image = *state[part::image];
  return {{"modality", static_cast<int>(image.modality)}, {"description", image.description}};
}

json save(const CaseState& state, const CaseFolder& folder) {
  write_image(folder.path / kImageFile, *state[part::image]);
  return entry_of(state);
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  auto image = read_image(folder.path / kImageFile, folder.context);
  if (!image) return;
  image->modality = static_cast<Modality>(ranged<int>(folder.path, entry, "modality", 0.0, 2.0));
  image->description = entry.at("description");
  state[part::image] = std::make_shared<const Image>(std::move(*image));
}

bool same(const CaseState& written, const CaseState& read) {
  const Image &a = *written[part::image], &b = *read[part::image];
  return *a.voxels == *b.voxels && a.grid.same_as(b.grid);
}

}  // namespace

const PartOf<Image> part::image{{.code = "image",
                                 .remedy = "Import a CT first",
                                 .files = {kImageFile},
                                 .save = save,
                                 .entry = entry_of,
                                 .load = load,
                                 .reading_share = 0.6,
                                 .same = same}};

}  // namespace glisson::engine
