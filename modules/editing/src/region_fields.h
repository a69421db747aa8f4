// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "describe.h"

namespace glisson::editing {

/// The editable region in scripts, where any tool may have one.
const Fields<EditableRegion>& region_fields();

}  // namespace glisson::editing
