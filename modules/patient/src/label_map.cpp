// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_map.h"

#include <charconv>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/patient/label_summary.h"
#include "glisson/volume/morphology.h"

namespace glisson {
namespace {

bool is_liver_vessel(Label label) {
  return label == structure::kPortalVein || label == structure::kHepaticVeins || label == structure::kArtery;
}

std::optional<Label> code_from(const std::string& text) {
  unsigned value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc() || stop != end || value > 65535) return std::nullopt;
  return static_cast<Label>(value);
}

void set_united(Mask& mask, const Mask& more, const Mask& where) {
  for (std::size_t i = 0; i < mask.voxels.size(); ++i)
    if (more.voxels[i] != 0 && where.voxels[i] != 0) mask.voxels[i] = 1;
}

}  // namespace

LabelCodes read_label_codes(const std::filesystem::path& path) {
  const nlohmann::json document = read_json(path);
  if (!document.is_object() || document.empty())
    throw InputError(path.string(), "", "names no label code",
                     R"(Write a JSON object such as {"6": "parenchyma", "10": "portal_vein"})");
  LabelCodes codes;
  for (const auto& [key, value] : document.items()) {
    const std::optional<Label> code = code_from(key);
    if (!code)
      throw InputError(path.string(), "\"" + key + "\"", "is not a label code",
                       "Codes are whole numbers from 0 to 65535, in quotes");
    const std::optional<Label> label =
        value.is_string() ? structure_named(value.get<std::string>()) : std::nullopt;
    if (!label)
      throw InputError(
          path.string(), "\"" + key + "\"", "stands for " + value.dump() + ", which is no structure",
          "Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder or "
          "lesion_1 to lesion_240 (or other_1 to other_9)");
    if (!codes.emplace(*code, *label).second)  // "6" and "06"
      throw InputError(path.string(), "\"" + key + "\"", "stands twice", "Keep one of them");
  }
  return codes;
}

std::vector<std::uint8_t> inside_liver(const LabelMap& labels, double closing_mm) {
  require(closing_mm >= 0.0, "a closing has a radius of zero or more");
  const VolumeGrid& grid = labels.voxels.grid();
  std::vector<std::uint8_t> whole = labels.voxels.mask(is_liver_tissue);
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, whole, grid.spacing_mm.maxCoeff());
  if (box.empty()) return whole;
  Mask liver = crop(grid.size, grid.spacing_mm, whole, box);
  const Mask vessels = crop(grid.size, grid.spacing_mm, labels.voxels.mask(is_liver_vessel), box);
  // A thin vessel vanishes in the closing; of a thick one each cross-section is a hole in one of the slices.
  // Only vessel voxels are taken from either, so that fissures stay open.
  const Mask around = closing_mm > 0.0 ? closed(liver, closing_mm) : liver;
  set_united(liver, around, vessels);
  set_united(liver, slice_holes_filled(around), vessels);
  liver = holes_filled(liver);
  paste(liver, box, grid.size, whole);
  return whole;
}

bool looks_mirrored(const LabelVolume& labels) { return LabelSummary(labels).look_mirrored(); }

LabelMap recode(const LabelFile& file, const LabelCodes& codes, const std::string& name,
                LeftLiver left_liver) {
  const LabelSummary summary(file.voxels);
  LabelMap map = recode(file, summary, codes, name);
  if (left_liver == LeftLiver::refused) require_not_mirrored(summary, codes, name);
  return map;
}

}  // namespace glisson
