// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/segmentation/segment.h"

namespace glisson::segmentation {

/// Up to five seeds for a liver that nobody has clicked, far from each other and from its border. Of the
/// tissues of the CT, the liver is the one with the most compact body on the patient's right (4 cm off his
/// middle, where no heart, stomach or spleen lies); what looks alike is parted from it at its necks. Only a
/// proposal: a person has to look at what is segmented from it. Deterministic.
/// @return CT frame, metres. @throws InputError not a CT; nothing in it is as large, compact and even as a
///   liver.
Cancellable<PointsIn<CtFrame>> propose_liver_seeds(const Image& image, const RunContext& context);

}  // namespace glisson::segmentation
