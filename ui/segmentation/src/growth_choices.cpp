// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/growth_choices.h"

#include <initializer_list>

#include "glisson/ui/segmentation/seed_box.h"

namespace glisson::ui {

QString hindrance_text(segmentation::Hindrance hindrance) {
  switch (hindrance) {
    case segmentation::Hindrance::small_region:
      return SeedBox::tr("The box is too small.");
    case segmentation::Hindrance::no_liver_seed:
      return SeedBox::tr("Place at least one seed in the liver.");
    case segmentation::Hindrance::no_liver_seed_in_region:
      return SeedBox::tr("Place a seed in the liver inside the box.");
    case segmentation::Hindrance::no_kept_liver:
      return SeedBox::tr("There is no liver yet: find everything first.");
  }
  return {};
}

std::vector<Find> finds() {
  using Structures = segmentation::Structures;
  const auto only = [](std::initializer_list<bool Structures::*> which) {
    Structures structures{false, false, false, false, false, false};
    for (bool Structures::*one : which) structures.*one = true;
    return structures;
  };
  Structures all_but_liver;
  all_but_liver.liver = false;
  return {
      {SeedBox::tr("Everything"), {}},
      {SeedBox::tr("Portal and hepatic veins"), only({&Structures::portal_vein, &Structures::hepatic_veins})},
      {SeedBox::tr("Lesions"), only({&Structures::lesions})},
      {SeedBox::tr("All but the liver"), all_but_liver},
      {SeedBox::tr("Liver"), only({&Structures::liver})},
      {SeedBox::tr("Portal vein"), only({&Structures::portal_vein})},
      {SeedBox::tr("Hepatic veins"), only({&Structures::hepatic_veins})},
      {SeedBox::tr("Vena cava"), only({&Structures::vena_cava})},
      {SeedBox::tr("Gallbladder"), only({&Structures::gallbladder})}};
}

}  // namespace glisson::ui
