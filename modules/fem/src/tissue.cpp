// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/fem/tissue.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "glisson/core/error.h"
#include "glisson/fem/materials.h"
#include "glisson/patient/label_map.h"

namespace glisson::fem {
namespace {

using Kind = Stiffness::Kind;

constexpr const char* kParenchyma = "parenchyma";
constexpr const char* kOthers = "lesions";
constexpr std::array<std::pair<const char*, Kind>, 3> kWords = {
    {{"as_liver", Kind::as_liver}, {"soft", Kind::soft}, {"stiff", Kind::stiff}}};

/// The shortest text that is read back as the same number.
std::string text_of(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

/// Thousandths of a pascal: what decimals of kilopascals are read as, whichever way they were computed.
double rounded(double pascals) { return std::round(1e3 * pascals) / 1e3; }

std::string kilopascals_of(double pascals) { return text_of(pascals / 1e3); }

[[noreturn]] void refuse(const std::string& name, const std::string& value, const std::string& words) {
  throw InputError("stiffness", name, "is \"" + value + "\"",
                   "Give Young's modulus in kPa, from " + kilopascals_of(kSoftestTissue) + " to " +
                       kilopascals_of(kStiffestTissue) + ", or " + words);
}

/// Pa; empty: no such number.
std::optional<double> modulus_from(std::string_view text) {
  double kilopascals = 0.0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), kilopascals);
  if (failure != std::errc() || end != text.data() + text.size()) return {};
  const double pascals = rounded(1e3 * kilopascals);
  if (!(pascals >= kSoftestTissue && pascals <= kStiffestTissue)) return {};
  return pascals;
}

double parenchyma_from(const std::string& value) {
  if (value == "healthy" || value == "cirrhotic") return composite_preset(value).parenchyma.young_modulus;
  const auto modulus = modulus_from(value);
  if (!modulus) refuse(kParenchyma, value, "healthy or cirrhotic");
  return *modulus;
}

Stiffness stiffness_from(const std::string& name, const std::string& value) {
  for (const auto& [word, kind] : kWords)
    if (value == word) return {kind, 0.0};
  const auto modulus = modulus_from(value);
  if (!modulus) refuse(name, value, "soft, as_liver or stiff");
  return {Kind::given, *modulus};
}

std::string word_of(const Stiffness& stiffness) {
  for (const auto& [word, kind] : kWords)
    if (stiffness.kind == kind) return word;
  return kilopascals_of(stiffness.young_modulus);
}

void check(double modulus, const std::string& name) {
  if (!(modulus >= kSoftestTissue && modulus <= kStiffestTissue))
    refuse(name, kilopascals_of(modulus), "none at all");
}

std::set<Label> lesions_of(const TetMesh& mesh) {
  std::set<Label> lesions;
  for (const int label : mesh.labels)
    if (is_lesion(label)) lesions.insert(static_cast<Label>(label));
  return lesions;
}

}  // namespace

double Stiffness::in(double parenchyma) const {
  switch (kind) {
    case Kind::as_liver:
      return parenchyma;
    case Kind::soft:
      return kSoft * parenchyma;
    case Kind::stiff:
      return kStiff * parenchyma;
    case Kind::given:
      break;
  }
  return young_modulus;
}

bool Tissue::empty() const {
  return !parenchyma && others.value_or(Stiffness()) == Stiffness() &&
         std::all_of(lesions.begin(), lesions.end(),
                     [](const auto& one) { return one.second == Stiffness(); });
}

Stiffness Tissue::of(Label lesion) const {
  const auto found = lesions.find(lesion);
  return found == lesions.end() ? others.value_or(Stiffness()) : found->second;
}

void Tissue::validate() const {
  if (parenchyma) check(*parenchyma, kParenchyma);
  if (others && others->kind == Kind::given) check(others->young_modulus, kOthers);
  for (const auto& [label, stiffness] : lesions) {
    if (!is_lesion(label))
      throw InputError("stiffness", structure_name(label), "is no lesion",
                       "Name lesion_1, lesion_2 and so on");
    if (stiffness.kind == Kind::given) check(stiffness.young_modulus, structure_name(label));
  }
}

Tissue tissue_from(std::string_view list) {
  Tissue tissue;
  std::set<std::string> named;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view entry = list.substr(0, comma);
    list.remove_prefix(std::min(comma + 1, list.size()));
    const std::size_t sign = entry.find('=');
    const std::string name(entry.substr(0, sign));
    if (sign == std::string_view::npos)
      throw InputError("stiffness", name, "has no value", "Write NAME=KPA, as in lesion_1=20,lesions=12");
    const std::string value(entry.substr(sign + 1));
    if (!named.insert(name).second) throw InputError("stiffness", name, "is given twice", "Give it once");
    const auto label = structure_named(name);
    if (name == kParenchyma)
      tissue.parenchyma = parenchyma_from(value);
    else if (name == kOthers)
      tissue.others = stiffness_from(name, value);
    else if (label && is_lesion(*label))
      tissue.lesions[*label] = stiffness_from(name, value);
    else
      throw InputError("stiffness", name, "is no tissue of which stiffness can be said",
                       "Name parenchyma, lesions, or lesion_1, lesion_2 and so on");
  }
  return tissue;
}

std::string tissue_list(const Tissue& tissue) {
  std::string list;
  const auto add = [&](const std::string& name, const std::string& value) {
    list += (list.empty() ? "" : ",") + name + "=" + value;
  };
  if (tissue.parenchyma) add(kParenchyma, kilopascals_of(*tissue.parenchyma));
  for (const auto& [label, stiffness] : tissue.lesions) add(structure_name(label), word_of(stiffness));
  if (tissue.others) add(kOthers, word_of(*tissue.others));
  return list;
}

Tissue rounded(Tissue tissue) {
  if (tissue.parenchyma) tissue.parenchyma = rounded(*tissue.parenchyma);
  if (tissue.others) tissue.others->young_modulus = rounded(tissue.others->young_modulus);
  for (auto& [label, stiffness] : tissue.lesions) stiffness.young_modulus = rounded(stiffness.young_modulus);
  return tissue;
}

Tissue said_over(Tissue former, const Tissue& now) {
  if (now.parenchyma) former.parenchyma = now.parenchyma;
  if (now.others) {
    former.others = now.others;
    former.lesions.clear();
  }
  for (const auto& [label, stiffness] : now.lesions) former.lesions[label] = stiffness;
  return former;
}

std::vector<Label> lesions_not_there(const Tissue& tissue, const PatientModel& model) {
  std::set<Label> there;
  for (const auto& [label, centre] : lesion_centres(model)) there.insert(label);
  std::vector<Label> gone;
  for (const auto& [label, stiffness] : tissue.lesions)
    if (!there.contains(label)) gone.push_back(label);
  return gone;
}

Tissue still_there(Tissue former, const PatientModel& model) {
  for (const Label gone : lesions_not_there(former, model)) former.lesions.erase(gone);
  if (lesion_centres(model).empty()) former.others.reset();
  return former;
}

void require_lesions_of(const Tissue& tissue, const PatientModel& model) {
  std::string known;
  for (const auto& [label, centre] : lesion_centres(model))
    known += (known.empty() ? "" : ", ") + structure_name(label);
  const std::string remedy =
      known.empty() ? "This model has none: give the parenchyma's alone" : "Take of " + known;
  if (const auto gone = lesions_not_there(tissue, model); !gone.empty())
    throw InputError("stiffness", structure_name(gone.front()), "is no lesion of this model", remedy);
  if (known.empty() && tissue.others)
    throw InputError("stiffness", kOthers, "are none in this model", remedy);
}

std::vector<Label> lesions_without_elements(const Tissue& tissue, const PatientModel& model) {
  const std::set<Label> meshed = lesions_of(model.mesh);
  std::vector<Label> without;
  for (const auto& [label, centre] : lesion_centres(model))
    if (!meshed.contains(label) && tissue.of(label) != Stiffness()) without.push_back(label);
  return without;
}

CompositeOptions with_tissue(CompositeOptions materials, const Tissue& tissue, const TetMesh& mesh) {
  if (tissue.empty()) return materials;
  tissue.validate();
  if (tissue.parenchyma) materials.parenchyma.young_modulus = *tissue.parenchyma;
  for (const Label lesion : lesions_of(mesh))
    if (const Stiffness said = tissue.of(lesion); said != Stiffness())
      materials.by_label[lesion] = {said.in(materials.parenchyma.young_modulus),
                                    materials.parenchyma.poisson_ratio};
  return materials;
}

std::vector<double> stiffness_over_parenchyma(const TetMesh& mesh, const CompositeOptions& materials) {
  std::vector<double> stiffness;
  stiffness.reserve(mesh.labels.size());
  for (const int label : mesh.labels)
    stiffness.push_back(materials.of(label).young_modulus / materials.parenchyma.young_modulus);
  return stiffness;
}

}  // namespace glisson::fem
