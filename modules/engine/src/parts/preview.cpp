// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/preview.h"

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"

namespace glisson::engine {

const PartOf<EditPreview> part::preview{{.code = "preview",
                                         .made_of = {part::image, part::labels},
                                         .remedy = "Choose a tool and its settings first",
                                         .is_input = false}};

}  // namespace glisson::engine
