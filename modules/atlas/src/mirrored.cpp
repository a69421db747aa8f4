// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirrored.h"

#include "glisson/core/error.h"
#include "pose_search.h"

namespace glisson::atlas {
namespace {
/// The best flipped image's misfit over the liver's own below which left and right, or another pair, may be
/// exchanged; below kExchanged they are.
constexpr double kPerhapsFlipped = 1.1;
/// For livers that do not lie so. The mirror image's misfit over the liver's own below which left and right
/// must be mixed up, and below which they may be. On the ten maps of development it lies between 1.00
/// and 1.20.
constexpr double kMirrored = 0.97, kPerhaps = 1.03;
/// How unusual the mirror image's shape is over the liver's own, at most, if it is the liver: synthetic
/// livers have 0.3, halves of them 0.9 (the image of half a liver is half a liver).
constexpr double kMoreUsual = 0.8;

double unusual_as(const ShapeModel& model, const Correspondence& found) {
  return unusual(model, fit_similarity(found.vertices, model.mean).apply(found.vertices));
}
}  // namespace

Cancellable<Handedness> handedness(const ShapeModel& model, const Triangles& triangles,
                                   const TriangleMesh& liver, const Correspondence& found,
                                   const RunContext& context) {
  // A liver that lies otherwise than in a CT fits better turned than any of its images upright.
  const bool as_in_ct = found.flipped_misfit < found.misfit || found.upright_misfit <= found.misfit;
  const double flipped = found.flipped_misfit / found.upright_misfit;
  if (as_in_ct && flipped < kExchanged) return Handedness::mirrored;
  const double ratio = found.mirrored_misfit / found.misfit;
  if (as_in_ct && flipped >= kPerhapsFlipped) return Handedness::right;
  if (ratio >= kPerhaps) return Handedness::right;
  if (ratio >= kMirrored) return Handedness::uncertain;
  TriangleMesh image = liver;
  image.vertices.col(0) *= -1.0;
  image.triangles.col(1).swap(image.triangles.col(2));
  const auto reflected = correspond(model, triangles, image, context);
  if (!reflected) return {};
  return unusual_as(model, *reflected) < kMoreUsual * unusual_as(model, found) ? Handedness::mirrored
                                                                               : Handedness::no_liver;
}

void refuse_mirrored(const std::string& name) {
  throw InputError(name, "liver", "is mirrored: its mirror image looks like a liver and it does not",
                   "Mend left and right in the file's header, or leave this liver out");
}

}  // namespace glisson::atlas
