// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bodies.h"
#include "painting.h"
#include "vessels.h"

namespace glisson::segmentation {

/// A liver outside of these is told, ml.
constexpr double kSmallLiver = 400.0, kLargeLiver = 4000.0;

/// How a segmentation came about, as far as its report needs it.
struct Outcome {
  const Image& image;       ///< what was segmented, on the scale of a CT, on the painting's grid
  const Seeds& seeds;       ///< those in it
  const Seeds& all_seeds;   ///< by whose numbers a person knows them
  const Structures& anew;   ///< what was asked, of what has seeds
  const Structures& found;  ///< of it
  const Bodies& bodies;
  const Vessels& trees;
  const Painting& painting;
  const std::optional<Eigen::AlignedBox3d>& region;  ///< seeds outside were not asked
};

/// The volumes of the labels, and what a person should look at: codes with values.
/// @param whole the image of `labels`, of which the outcome's may be a part.
SegmentationReport report_on(const Image& whole, const LabelMap& labels, const Outcome& outcome);

}  // namespace glisson::segmentation
