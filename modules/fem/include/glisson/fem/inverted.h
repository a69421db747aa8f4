// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/fem/composite_model.h"

namespace glisson::fem {

/// Tetrahedra of the model without a positive volume at node positions x, metres. @pre one row a node.
int inverted_tetrahedra(const CompositeModel& model, const Points& x);

}  // namespace glisson::fem
