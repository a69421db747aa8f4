// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/live.h"

#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"

namespace glisson::engine {

const PartOf<LiveState> part::live{{.code = "live",
                                    .made_of = {part::registration, part::video},
                                    .remedy = "Start tracking first",
                                    .follows = {part::registration},
                                    .is_live = true,
                                    .is_input = false}};

}  // namespace glisson::engine
