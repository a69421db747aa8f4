// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/pairs.h"

/// @file
/// Where one more look helps most: what is expected of a lesion's error once another piece of the surface has
/// been seen, or a landmark marked, before anybody has looked there.

namespace glisson::registration {

/// A look shows the surface within this of its middle, metres, as one stereo view does, where the normals'
/// cosine is above this (60 degrees).
inline constexpr double kLookReach = 30e-3, kLookFacing = 0.5;

/// For each lesion and each place of the surface what a look there would leave; none is offered at the
/// liver's back and around the vena cava, which no laparoscope sees before the liver is mobilised. With C = L
/// L^T the lesion's covariance and B the answers of the look's rows, of variance V, the posterior is C' = L
/// (I - B^T (V + B B^T)^-1 B) L^T: what the error model would say after it, whatever will be seen (linear,
/// Gaussian; Lindley 1956). What is seen already counts as nothing new. @param cloud that was registered to,
/// not empty; @param error what the registration does not know. Cancelled: none.
std::vector<LesionLooks> looks_of(const PatientModel& model, const LabelledCloud& cloud,
                                  const Registration& registration, const ErrorModel& error,
                                  const RunContext& context = {});

/// The look that tells most of a lesion.
struct NextLook {
  enum class Kind { surface, margin, notch } kind = Kind::surface;
  int node = -1;  ///< of the mesh, the middle of what is to be seen; -1: a landmark is to be marked
  double now = 0.0, after = 0.0;  ///< the lesion's expected error, metres
};
/// Empty: none lowers the expected error by a seventh and by half a millimetre.
std::optional<NextLook> best_look(const LesionLooks& looks);

/// A note a lesion whose error a look would lower: "look.surface lesion_1 left_underside 6.0 3.1" (where, and
/// its expected error now and then, mm), "look.margin lesion_1 6.0 3.1", "look.notch lesion_1 6.0 3.1".
std::vector<std::string> look_notes(const PatientModel& model, const Registration& registration);
/// Of one lesion alone; empty: no look helps much.
std::string look_note(const PatientModel& model, const LesionLooks& looks);

/// Where on the liver a node of its surface lies, as a code: lobe ("left", "right"; "liver" where notch and
/// vena cava do not tell them apart) and face ("dome", "underside", "front", "side", "back"), as in
/// "left_underside". Lobes are parted by the vertical plane through notch and vena cava. @pre a surface node.
std::string place_on_liver(const PatientModel& model, int node);
/// All codes that place_on_liver() gives.
std::vector<std::string> places_on_liver();

}  // namespace glisson::registration
