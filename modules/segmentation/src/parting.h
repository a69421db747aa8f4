// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "field.h"
#include "glisson/core/run_context.h"
#include "liver_start.h"

namespace glisson::segmentation {

/// Thin dark sheets: seams of fat between two organs that lie against each other. Smoothing against noise
/// would close them.
class DarkSheets {
 public:
  /// @param ct not smoothed. @param where is looked at.
  DarkSheets(const Field& ct, const Mask& where);
  /// What looks like tissue without seams. All of them are only nearly so: a fissure beside a click, a seam
  /// within what was found, make a limit larger, none makes it smaller. So the least one counts.
  void learn(const Mask& typical);
  /// Those darker, against what lies on both sides, than 95 % of such tissue; none before it is known.
  Mask sheets() const;

 private:
  Mask where_;
  std::vector<float> response_;  ///< HU; 0 where nothing is looked at
  float limit_ = std::numeric_limits<float>::infinity();
};

/// Tissue that falls apart where it narrows.
struct Sides {
  Mask own;      ///< what belongs to the clicks inside
  Mask rival;    ///< other parts that have a click, or are at least 5 mm deep
  Mask perhaps;  ///< of the doubtful body, see below, the largest piece that is one
  /// The largest body that nobody clicked and that hangs on what is owned, or on others that do, by more than
  /// seams, though not widely (parts that share wide faces are judged as one): it may be a lobe behind a
  /// tumour, or of another grey, as well as an organ that lies against it.
  double doubtful_ml = 0.0;                            ///< 0: there is none
  Eigen::Vector3i doubtful = Eigen::Vector3i::Zero();  ///< where that piece is deepest
};

/// What makes a part the clicks': its face with what they own, of the flat face of a half ball. A lobe that a
/// person has clicked beside is lost dearly, a place where nobody has clicked is chosen from what is certain.
constexpr double kLobeFace = 0.25, kCertainFace = 0.3;

/// Cuts `tissue` into parts at its necks and says which are the inside clicks'. Depth is the distance to what
/// is not tissue.
/// 1. A part is what drains to one place of greatest depth (Meyer 1994).
/// 2. Two neighbours become one part where the neck between them is at least 0.8 times as deep as the
///    shallower of them, unless together they hold clicks of both kinds.
/// 3. Parts with a click inside or in a lesion are owned, also if they hold one outside. So is every part
///    without a click whose face with owned parts is `wide` for its volume, in flat faces of a half ball,
///    counted where two voxels of tissue and more lie around it. The left lobe hangs on the right one
///    so; a pancreas or a stomach does not, for organs that lie against each other meet in strips.
/// 4. A part with clicks outside alone is owned where that face is 0.8 of it: whoever clicked did not mean
///    all of it.
Cancellable<Sides> part_at_necks(const Field& ct, const Mask& tissue, const LiverSeeds& seeds,
                                 const RunContext& context, double wide = kLobeFace);

}  // namespace glisson::segmentation
