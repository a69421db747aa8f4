// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/fem/composite_model.h"

/// @file
/// How stiff one patient's liver is, as far as a person has said so: the parenchyma and each lesion.

namespace glisson::fem {

/// What is said of a lesion.
struct Stiffness {
  enum class Kind { as_liver, soft, stiff, given };
  static constexpr double kSoft = 1.0 / 3.0, kStiff = 5.0;  ///< over the parenchyma's Young's modulus
  Kind kind = Kind::as_liver;
  double young_modulus = 0.0;  ///< Pa, where it is given
  /// Young's modulus, Pa, in a liver of this one.
  double in(double parenchyma) const;
  bool operator==(const Stiffness&) const = default;
};

inline constexpr double kSoftestTissue = 100.0, kStiffestTissue = 1e6;  ///< Pa that may be given

/// What has been said of one liver's stiffness. A lesion's is its own entry, else `others`, else the liver's.
struct Tissue {
  std::optional<double> parenchyma;    ///< Young's modulus, Pa; empty: nobody has said
  std::map<Label, Stiffness> lesions;  ///< those that are not in it: `others`
  std::optional<Stiffness> others;     ///< empty: as the liver
  /// Whether nothing is said that changes anything.
  bool empty() const;
  /// As the liver where nothing is said of it. The label need not be in the model.
  Stiffness of(Label lesion) const;
  /// @throws InputError naming the structure.
  void validate() const;
  bool operator==(const Tissue&) const = default;
};

/// From a list with commas, "parenchyma=30,lesion_1=20,lesions=stiff": kilopascals or a word (as_liver, soft,
/// stiff; of the parenchyma healthy and cirrhotic, as composite_preset() has them); "lesions" are all that
/// are not named. @throws InputError naming the entry.
Tissue tissue_from(std::string_view list);
/// The same list; what is read from it is rounded() to the bit.
std::string tissue_list(const Tissue& tissue);
/// Every modulus to thousandths of a pascal, as tissue_from() gives it.
Tissue rounded(Tissue tissue);

/// What is said now over what was said before: all other lesions replace every former one.
Tissue said_over(Tissue former, const Tissue& now);

/// Lesions of which something is said and that the model does not have.
std::vector<Label> lesions_not_there(const Tissue& tissue, const PatientModel& model);
/// What was said before of a former model, without lesions that this one does not have.
Tissue still_there(Tissue former, const PatientModel& model);
/// All lesions of which something is said must be in the model. @throws InputError naming the
/// first of them and what there is.
void require_lesions_of(const Tissue& tissue, const PatientModel& model);
/// Lesions of which something is said and that have no elements of their own: it changes nothing.
std::vector<Label> lesions_without_elements(const Tissue& tissue, const PatientModel& model);

/// Materials with what is said of this mesh's lesions; where nothing is said they stay. Poisson's ratio is
/// the parenchyma's.
CompositeOptions with_tissue(CompositeOptions materials, const Tissue& tissue, const TetMesh& mesh);

/// Young's modulus of each tetrahedron over the parenchyma's.
std::vector<double> stiffness_over_parenchyma(const TetMesh& mesh, const CompositeOptions& materials);

}  // namespace glisson::fem
