// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/offer.h"

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"

namespace glisson::engine {

bool SegmentationOffer::fits(const CaseState& state) const {
  return base == state[part::labels] && image == state[part::image] &&
         (!seeds || seeds == state[part::seeds]);
}

const PartOf<SegmentationOffer> part::offer{{.code = "offer",
                                             .made_of = {part::image, part::seeds, part::labels},
                                             .remedy = "Segment first",
                                             .is_input = false}};

}  // namespace glisson::engine
