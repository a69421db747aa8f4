// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tissue.h"

namespace glisson::segmentation {

/// Where a lesion is looked for: one grid.
struct LesionScene {
  Field raw, ct;  ///< the surroundings of the click; ct is denoised
  Tissue liver;
  Mask organ;            ///< the liver found so far; no voxels: not known yet
  Mask bites;            ///< what is missing in it to be round; as many voxels as `organ`
  Mask barred;           ///< of no lesion
  Mask mixed = {};       ///< where the CT mixes the organ with what is outside; no voxels: nowhere
  double blur_mm = 0.0;  ///< sigma of what an abrupt border looks like in `raw`
};

struct LesionClick {
  Eigen::Vector3i place;     ///< voxel
  double diameter_mm = 0.0;  ///< as drawn by hand; 0: not known
};

struct GrownLesion {
  Field phi;  ///< mm, negative inside, on the scene's grid; no values: nothing there is unlike the liver
  bool bright = false;      ///< it enhances, or its rim does: what is bright in it is no vessel
  bool borderless = false;  ///< nothing was found where it was drawn: a ball of the diameter
  bool goes_on = false;     ///< it reaches as far as its border is looked for, and perhaps farther
  double unseen_mm = 0.0;   ///< much of it hangs on a layer so thick under the surface, which the CT mixes
  int clicks_in_vain = 0;   ///< of several, those where nothing was found and that are not in it either
};

/// How far from a click a lesion is looked for, mm.
double lesion_reach_mm(double diameter_mm);

/// A lesion from a click in it: the star-shaped body that best parts what is not this liver from what is
/// (grow_star()), by the log likelihood ratio of the two tissues, both read at the place. A bright rim
/// belongs to it where the median over all rays shows one; what only few rays meet is a vessel.
/// Its boundary is the edge in the CT that was not denoised (move_to_edge()).
/// Close under the organ's surface the CT says nothing: there its shape goes on as it comes.
/// @return with a diameter there is always something: where no border is seen, a ball of that diameter.
GrownLesion grow_lesion(const LesionScene& scene, const LesionClick& click);

/// What can be said of it before the liver is known: a ball that nearly all rays reach is sure; all that is
/// like the click and hangs together with it is likely.
struct LesionGuess {
  Field sure, likely;  ///< as GrownLesion::phi
};
LesionGuess guess_lesion(const LesionScene& scene, const LesionClick& click);

}  // namespace glisson::segmentation
