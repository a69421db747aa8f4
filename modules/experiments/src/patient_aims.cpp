// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/patient_proof.h"

#include "aim_text.h"

namespace glisson::experiments {

const std::vector<Aim>& patient_aims() {
  using enum Aim::Sense;
  using enum Evidence;
  static const std::vector<Aim> kAims = {
      {"real_dice_liver", QT_TRANSLATE_NOOP("cli", "real CT: Dice of the liver"), real, at_least, 0.93, 3},
      {"real_dice_portal_vein_inside",
       QT_TRANSLATE_NOOP("cli", "real CT: Dice of the portal vein in the liver"), real, at_least, 0.5, 3},
      {"real_dice_hepatic_veins_inside",
       QT_TRANSLATE_NOOP("cli", "real CT: Dice of the hepatic veins in the liver"), real, at_least, 0.5, 3},
      {"real_edited_dice_portal_vein_inside",
       QT_TRANSLATE_NOOP("cli", "real CT: portal vein after the strokes"), real, at_least, 0.5, 3},
      {"real_edited_dice_hepatic_veins_inside",
       QT_TRANSLATE_NOOP("cli", "real CT: hepatic veins after the strokes"), real, at_least, 0.5, 3},
      {"real_model_vertices_to_fine_mean_mm",
       QT_TRANSLATE_NOOP("cli", "real CT: vertices to the fine surface, mean, mm"), real, at_most, 0.25, 2},
      {"real_model_min_dihedral_deg", QT_TRANSLATE_NOOP("cli", "real CT: least dihedral angle, degrees"),
       real, at_least, 10.0, 1},
      {"real_fine_model_tetrahedra", QT_TRANSLATE_NOOP("cli", "real CT: tetrahedra of the fine model"), real,
       at_least, 9000.0, 0},
      {"real_fine_model_min_dihedral_deg",
       QT_TRANSLATE_NOOP("cli", "real CT: least dihedral angle of the fine model, degrees"), real, at_least,
       10.0, 1},
      {"real_model_lesion_volume_error_max",
       QT_TRANSLATE_NOOP("cli", "real CT: volume error of lesions above 1 ml, largest"), real, at_most, 0.05,
       3},
      {"real_fine_model_volume_error_size",
       QT_TRANSLATE_NOOP("cli", "real CT: volume error of the fine model"), real, at_most, 0.01, 4},
      {"synthetic_dice_liver", QT_TRANSLATE_NOOP("cli", "in silico: Dice of the liver"), in_silico, at_least,
       0.96, 3},
      {"synthetic_true_labels_centreline_mean_voxels",
       QT_TRANSLATE_NOOP("cli", "in silico: centrelines to the true trees, mean, voxels"), in_silico, at_most,
       1.0, 2},
      {"synthetic_true_labels_branches_found_share",
       QT_TRANSLATE_NOOP("cli", "in silico: branches above 2 mm radius found"), in_silico, at_least, 0.95, 3},
      {"synthetic_true_labels_false_loops", QT_TRANSLATE_NOOP("cli", "in silico: false loops"), in_silico,
       at_most, 0.0, 0},
      {"synthetic_segmented_centreline_mean_voxels",
       QT_TRANSLATE_NOOP("cli",
                         "in silico, segmented by clicks: centrelines to the true trees, mean, voxels"),
       in_silico, at_most, 1.0, 2},
      {"synthetic_model_vertices_to_fine_mean_mm",
       QT_TRANSLATE_NOOP("cli", "in silico: vertices to the fine surface, mean, mm"), in_silico, at_most,
       0.25, 2},
      {"synthetic_model_min_dihedral_deg",
       QT_TRANSLATE_NOOP("cli", "in silico: least dihedral angle, degrees"), in_silico, at_least, 10.0, 1},
      {"synthetic_fine_model_volume_error_size",
       QT_TRANSLATE_NOOP("cli", "in silico: volume error of the fine model"), in_silico, at_most, 0.01, 4},
      {"trial_real_dice_liver_median",
       QT_TRANSLATE_NOOP("cli", "real CTs, ten clicks of a layperson: Dice of the liver, median"), real,
       at_least, 0.95, 3},
      {"trial_real_dice_liver_worst",
       QT_TRANSLATE_NOOP("cli", "real CTs, ten clicks of a layperson: Dice of the liver, worst"), real,
       at_least, 0.92, 3},
      {"trial_synthetic_dice_liver_median",
       QT_TRANSLATE_NOOP("cli",
                         "in silico, ill livers, ten clicks of a layperson: Dice of the liver, median"),
       in_silico, at_least, 0.95, 3},
      {"trial_synthetic_dice_liver_worst",
       QT_TRANSLATE_NOOP("cli", "in silico, ill livers, ten clicks of a layperson: Dice of the liver, worst"),
       in_silico, at_least, 0.92, 3},
      {"trial_real_dice_lesion_median",
       QT_TRANSLATE_NOOP("cli", "real CT, lesions above 1 ml, one click: Dice, median"), real, at_least, 0.8,
       3},
      {"trial_synthetic_dice_lesion_median",
       QT_TRANSLATE_NOOP("cli", "in silico, lesions above 1 ml, one click: Dice, median"), in_silico,
       at_least, 0.8, 3},
      {"trial_real_dice_drawn_lesion_median",
       QT_TRANSLATE_NOOP("cli", "real CT, lesions above 1 ml, a line drawn across: Dice, median"), real,
       at_least, 0.8, 3},
      {"trial_synthetic_dice_drawn_lesion_median",
       QT_TRANSLATE_NOOP("cli", "in silico, lesions above 1 ml, a line drawn across: Dice, median"),
       in_silico, at_least, 0.8, 3},
  };
  return kAims;
}

}  // namespace glisson::experiments
