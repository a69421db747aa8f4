// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glisson/atlas/atlas.h"
#include "glisson/atlas/correspond.h"
#include "glisson/core/run_context.h"

namespace glisson::atlas {

/// What a liver's left and right look like.
enum class Handedness {
  right,      ///< the liver fits better than its mirror image
  uncertain,  ///< both fit alike
  no_liver,  ///< the mirror image fits better and is no more of a liver: something is missing or much changed
  mirrored   ///< the mirror image fits better, and has the shape of a liver
};
/// @param found the liver's correspondence with the model. Empty: cancelled.
Cancellable<Handedness> handedness(const ShapeModel& model, const Triangles& triangles,
                                   const TriangleMesh& liver, const Correspondence& found,
                                   const RunContext& context);

/// @throws InputError that says that the liver is mirrored.
[[noreturn]] void refuse_mirrored(const std::string& name);

}  // namespace glisson::atlas
