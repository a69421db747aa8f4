// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/atlas/shape_model.h"
#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"

namespace glisson::atlas {

/// A template surface brought onto a liver: the same triangles with its vertices on the liver.
struct Correspondence {
  Points vertices;        ///< of the template, where they lie on the liver; the liver's frame, metres
  Similarity from_start;  ///< the similarity alone: template to liver
  double mean_distance = 0.0, max_distance = 0.0;  ///< metres, between the surfaces, the worse direction
  double turned_deg = 0.0;                         ///< of the similarity's rotation
  int folded = 0;  ///< triangles that face against the liver's surface beneath them
  /// How badly the similarity alone fits the liver, and its mirror image (without unit: distance, normals and
  /// bends), each in the orientation that suits it best.
  double misfit = 0.0, mirrored_misfit = 0.0;
  /// The same where it must lie as livers lie in a CT, within a few degrees: the liver, and the best of its
  /// images with left and right, front and back, or head and feet exchanged.
  double upright_misfit = 0.0, flipped_misfit = 0.0;
};

/// Brings a template onto a liver (README: "Correspondence"): similarity from 24 orientations, then the
/// model's modes where there is a model, then coherent point drift (Myronenko and Song 2010) with normals,
/// then closest points of both surfaces under as-rigid-as-possible regularisation (Sorkine and Alexa 2007),
/// coarse to fine.
/// @param model whose mean is the template's vertices; modes may be none.
/// @param triangles of the template. @param liver closed, outward normals, metres.
/// Empty: cancelled. @throws InputError the liver has no surface.
Cancellable<Correspondence> correspond(const ShapeModel& model, const Triangles& triangles,
                                       const TriangleMesh& liver, const RunContext& context);

}  // namespace glisson::atlas
