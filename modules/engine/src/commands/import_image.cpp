// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/import_image.h"

#include <algorithm>
#include <string>
#include <vector>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/source.h"
#include "glisson/volume/plausibility.h"
#include "told_modality.h"

namespace glisson::engine {
namespace {

/// "volume.files_missing 3: A/B, A/C, ...".
std::string note_of(const std::vector<std::string>& missing) {
  constexpr std::size_t kNamed = 5;
  std::string note = "volume.files_missing " + std::to_string(missing.size()) + ": ";
  for (std::size_t n = 0; n < std::min(missing.size(), kNamed); ++n) note += (n > 0 ? ", " : "") + missing[n];
  return missing.size() > kNamed ? note + ", ..." : note;
}

Figures figures_of(const VolumeGrid& grid) {
  Figures figures;
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, static_cast<char>('i' + k));
    figures["image_size_" + axis] = grid.size[k];
    figures["image_spacing_" + axis + "_mm"] = grid.spacing_mm[k];
  }
  return figures;
}

/// What is read, or was read before, of the modality that a person has told.
Cancellable<Scan> scan_of(const ImportImage& command, const RunContext& context) {
  Cancellable<Scan> found = command.scan ? *command.scan : read_scan(command.path, context, command.series);
  if (!found || !command.modality) return found;
  require_modality_untold(found->image, !found->source.empty(), *command.modality, command.path.string());
  found->image.modality = *command.modality;
  return found;
}

std::vector<std::string> notes_of(const Scan& scan) {
  std::vector<std::string> notes = image_doubts(scan.image);
  if (!scan.missing.empty()) notes.push_back(note_of(scan.missing));
  return notes;
}

}  // namespace

CommandTraits ImportImage::traits() const {
  return {.code = "import_image",
          .writes = new_case ? Parts::all() : Parts{part::image, part::source},
          .notice = Notice::files};
}

Cancellable<Applied> ImportImage::apply(const CaseState& state, const RunContext& context) const {
  Cancellable<Scan> found = scan_of(*this, context);
  if (!found) return {};
  Applied applied{new_case ? CaseState() : state, figures_of(found->image.grid), notes_of(*found)};
  applied.state[part::image] = std::make_shared<const Image>(std::move(found->image));
  applied.state[part::source] =
      found->source.empty() ? nullptr : std::make_shared<const DicomSource>(std::move(found->source));
  return applied;
}

}  // namespace glisson::engine
