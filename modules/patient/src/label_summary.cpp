// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_summary.h"

#include <algorithm>

#include "glisson/core/error.h"

namespace glisson {
namespace {

/// Codes that a table does not name are background.
Label meaning_of(Label code, const LabelCodes& codes) {
  if (codes.empty()) return code;
  const auto known = codes.find(code);
  return known == codes.end() ? structure::kBackground : known->second;
}

}  // namespace

LabelSummary::LabelSummary(const LabelVolume& labels) : grid_(labels.grid()) {
  const std::vector<Label> dense = labels.dense();
  std::size_t at = 0;
  for (int k = 0; k < grid_.size.z(); ++k)
    for (int j = 0; j < grid_.size.y(); ++j)
      for (int i = 0; i < grid_.size.x(); ++i, ++at) {
        if (dense[at] >= sums_.size()) sums_.resize(std::size_t{dense[at]} + 1);
        Sum& sum = sums_[dense[at]];
        sum.indices += Eigen::Vector3d(i, j, k);
        ++sum.count;
      }
}

/// Mean LPS x of the voxels of the wanted codes, mm.
std::optional<double> LabelSummary::mean_left_mm(const std::function<bool(Label)>& wanted) const {
  Sum all;
  for (std::size_t code = 0; code < sums_.size(); ++code) {
    if (!wanted(static_cast<Label>(code))) continue;
    all.indices += sums_[code].indices;
    all.count += sums_[code].count;
  }
  if (all.count == 0) return std::nullopt;
  return 1e3 * grid_.p_in_ct(all.indices / static_cast<double>(all.count)).xyz.x();
}

std::set<Label> LabelSummary::labels(const LabelCodes& codes) const {
  std::set<Label> labels;
  for (std::size_t code = 0; code < sums_.size(); ++code)
    if (sums_[code].count > 0) labels.insert(meaning_of(static_cast<Label>(code), codes));
  labels.erase(structure::kBackground);
  return labels;
}

double LabelSummary::ml(Label code) const {
  const long count = code < sums_.size() ? sums_[code].count : 0;
  return 1e-3 * static_cast<double>(count) * grid_.voxel_volume_mm3();
}

bool LabelSummary::look_mirrored(const LabelCodes& codes) const {
  // The vena cava runs near the midline, the bulk of the liver to the patient's right of it.
  const auto liver = mean_left_mm([&](Label code) { return is_liver_tissue(meaning_of(code, codes)); });
  const auto cava = mean_left_mm([&](Label code) { return meaning_of(code, codes) == structure::kVenaCava; });
  return liver && cava && *cava < *liver;
}

void require_not_mirrored(const LabelSummary& summary, const LabelCodes& codes, const std::string& name) {
  if (summary.look_mirrored(codes))
    throw InputError(name, "orientation",
                     "the liver lies to the left of the vena cava: the volume is mirrored, or the liver's "
                     "right part was removed",
                     "Correct the direction in the file's header if left and right are swapped; after a "
                     "right hepatectomy import it with 'glisson model --left-liver'");
}

LabelMap recode(const LabelFile& file, const LabelSummary& summary, const LabelCodes& codes,
                const std::string& name) {
  std::vector<Label> table(65536, structure::kBackground);
  for (const auto& [code, label] : codes) table[code] = label;
  std::vector<Label> dense = file.voxels.dense();
  for (Label& label : dense) label = table[label];
  LabelMap map;
  map.voxels = LabelVolume(file.voxels.grid(), dense);
  // Without a code in the table everything becomes background.
  const std::set<Label> labels = codes.empty() ? std::set<Label>() : summary.labels(codes);
  for (const Label label : labels) {
    map.infos.push_back(structure_info(label));
    for (const LabelInfo& info : file.infos)
      if (!info.terminology.empty() && codes.contains(info.code) && codes.at(info.code) == label)
        map.infos.back().terminology = info.terminology;
  }
  if (std::ranges::none_of(labels, is_liver_tissue))
    throw InputError(name, "labels", "nothing of the liver is left after the codes were applied",
                     "Give the codes of this file: which number is parenchyma, portal_vein and so on");
  return map;
}

}  // namespace glisson
