// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "glisson/atlas/transfer.h"

namespace glisson::ui {

/// The atlas' mean liver, bent by one of its modes.
struct BentLiver {
  TriangleMesh surface;                                         ///< the patient's frame, metres
  std::vector<std::pair<atlas::Structure, Points>> structures;  ///< where they lie on such livers
};

/// How the mean liver is laid on the patient's: as the atlas was transferred to it; where nothing of this
/// atlas was, centre on centre and as large.
/// @param transfer may be null. @param liver the patient's surface, CT frame, metres
atlas::Similarity patient_from_mean(const atlas::Atlas& atlas, const atlas::Transfer* transfer,
                                    const TriangleMesh& liver);

/// mean + deviations * sqrt(variance) * mode, and the structures' places as they go along with it.
/// @param mode 0-based. @pre it is one of the atlas' modes
BentLiver bent_liver(const atlas::Atlas& atlas, int mode, double deviations,
                     const atlas::Similarity& patient_from_mean);

/// The share of the members' variance that a mode explains, in [0, 1].
double share_of_variance(const atlas::Atlas& atlas, int mode);

}  // namespace glisson::ui
