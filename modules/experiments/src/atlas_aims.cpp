// SPDX-License-Identifier: GPL-3.0-or-later
#include "atlas_proof.h"

#include "glisson/core/marked_text.h"

namespace glisson::experiments {

const std::vector<Aim>& atlas_aims() {
  using enum Aim::Sense;
  using enum Evidence;
  static const std::vector<Aim> kAims = {
      {"real_surface_mean_mm", QT_TRANSLATE_NOOP("cli", "real livers by the others: surface, mean, mm"), real,
       at_most, 1.5, 2},
      {"real_surface_worst_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: surface, worst liver, mm"), real, at_most, 3.0,
       2},
      {"real_vena_cava_area_mean_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: vena cava's contact, mean, mm"), real, at_most,
       6.0, 1},
      {"real_vena_cava_area_worst_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: vena cava's contact, worst liver, mm"), real,
       at_most, 10.0, 1},
      {"real_vena_cava_mean_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: vena cava's course, mean, mm"), real, at_most,
       6.0, 1},
      {"real_vena_cava_worst_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: vena cava's course, worst liver, mm"), real,
       at_most, 10.0, 1},
      {"real_portal_entrance_mean_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: portal vein's entrance, mean, mm"), real, at_most,
       8.0, 1},
      {"real_portal_entrance_worst_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: portal vein's entrance, worst liver, mm"), real,
       at_most, 14.0, 1},
      {"real_inside_share",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: truth within the 95 % ellipsoids, at least"),
       real, at_least, 0.90, 3},
      {"real_inside_share",
       QT_TRANSLATE_NOOP("cli", "real livers by the others: truth within the 95 % ellipsoids, at most"), real,
       at_most, 0.98, 3},
      {"built_in_vena_cava_area_mean_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the built-in atlas: vena cava's contact, mean, mm"), real,
       at_most, 12.0, 1},
      {"built_in_vena_cava_mean_mm",
       QT_TRANSLATE_NOOP("cli", "real livers by the built-in atlas: vena cava's course, mean, mm"), real,
       at_most, 12.0, 1},
      {"built_in_inside_share",
       QT_TRANSLATE_NOOP("cli", "real livers by the built-in atlas: truth within the 95 % ellipsoids"), real,
       at_least, 0.90, 3},
      {"mirrored_refused_share", QT_TRANSLATE_NOOP("cli", "real livers mirrored: share that is refused"),
       real, at_least, 1.0, 2},
      {"transfer_slowest_s", QT_TRANSLATE_NOOP("cli", "transfer to a real liver, slowest, s"), real, at_most,
       5.0, 1},
      {"real_build_s", QT_TRANSLATE_NOOP("cli", "building from the real livers, s"), real, at_most, 180.0, 0},
      {"synthetic_surface_mean_mm", QT_TRANSLATE_NOOP("cli", "in silico: surface, mean, mm"), in_silico,
       at_most, 1.5, 2},
      {"synthetic_umbilical_notch_mean_mm", QT_TRANSLATE_NOOP("cli", "in silico: umbilical notch, mean, mm"),
       in_silico, at_most, 8.0, 1},
      {"synthetic_umbilical_notch_worst_mm",
       QT_TRANSLATE_NOOP("cli", "in silico: umbilical notch, worst liver, mm"), in_silico, at_most, 12.0, 1},
      {"synthetic_anterior_margin_mean_mm", QT_TRANSLATE_NOOP("cli", "in silico: anterior margin, mean, mm"),
       in_silico, at_most, 8.0, 1},
      {"synthetic_inside_share",
       QT_TRANSLATE_NOOP("cli", "in silico: truth within the 95 % ellipsoids, at least"), in_silico, at_least,
       0.90, 3},
      {"synthetic_inside_share",
       QT_TRANSLATE_NOOP("cli", "in silico: truth within the 95 % ellipsoids, at most"), in_silico, at_most,
       0.98, 3},
      {"effect_atlas_over_none",
       QT_TRANSLATE_NOOP("cli", "registration with the atlas's landmarks: error over that with none"),
       in_silico, at_most, 1.0, 2},
  };
  return kAims;
}

}  // namespace glisson::experiments
