// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/reconstruct_pair.h"

#include <cmath>
#include <utility>

#include "glisson/core/error.h"
#include "rig_check.h"
#include "whole_pair.h"

namespace glisson::stereo {
namespace {

using Whole = std::shared_ptr<const Reconstructed>;

/// The pair is looked at once, when that is first asked for.
class Look {
 public:
  explicit Look(const PairInput& input) : input_(input) {}
  const PairCheck& check() {
    if (!made_) made_ = check_pair(input_.frame.left, input_.frame.right, input_.rig);
    return *made_;
  }
  const std::optional<PairCheck>& made() const { return made_; }

 private:
  const PairInput& input_;
  std::optional<PairCheck> made_;
};

Cancellable<Whole> whole_of(const PairInput& input, const ReconstructOptions& options,
                            const KnownPoints& known, const RunContext& context) {
  if (known.whole && known.options == options) return known.whole;
  const auto& [left, right, index, seconds] = input.frame;
  auto made = reconstruct_whole(left, right, input.rig, input.mask, options, context);
  if (!made) return {};
  return std::make_shared<const Reconstructed>(std::move(*made));
}

/// @throws InputError rows that lie too far from the calibration's for matches to be found, and not far
/// enough for it to be another scope's.
void require_rows(const PairCheck& check, const ReconstructOptions& options) {
  const double within = band_rows(options);
  if (check.rows_px <= within) return;
  throw InputError(kPair, "",
                   "gives too few points: what both views show lies " + number_text(check.rows_px) +
                       " pixels from its epipolar lines, and is looked for within " + number_text(within),
                   "Load this laparoscope's calibration, or calibrate it again");
}

/// Reconstructs as asked for. If that fails and the pair itself has a fault, the fault is thrown instead: it
/// says more.
Cancellable<Whole> asked_whole(const PairInput& input, const ReconstructOptions& options,
                               const KnownPoints& known, Look& look, const RunContext& context) {
  try {
    return whole_of(input, options, known, context);
  } catch (const InputError& failure) {
    require_sound(look.check());
    if (failure.file() == kPair) require_rows(look.check(), options);
    throw;
  }
}

/// Dense, where the sparse ones are too few; null: the pair has too few of those, too.
Cancellable<Whole> dense_whole(const PairInput& input, ReconstructOptions options, const KnownPoints& known,
                               const RunContext& context) {
  options.method = Method::dense;
  try {
    return whole_of(input, options, known, context);
  } catch (const InputError&) {
    return Whole();
  }
}

bool is_suspicious(const PairCloud& result, const ReconstructOptions& options) {
  constexpr double kRowsOff = 3.0;  // pixels
  return std::abs(result.whole->report.row_offset_px) > kRowsOff ||
         result.part.density_per_cm2 < options.least_density_per_cm2;
}

/// What follows from the points that were chosen.
PairCloud described(Whole whole, LabelledPart part, const PairInput& input, const ReconstructOptions& options,
                    Look& look) {
  if (part.cloud.size() == 0)
    throw InputError("regions", "",
                     "hold none of the pair's " + std::to_string(whole->cloud.size()) + " points",
                     "Draw them where the liver is reconstructed, or reconstruct densely");
  if (input.regions.regions.empty()) {
    part.area_cm2 = whole->report.area_cm2;
    part.density_per_cm2 = whole->report.density_per_cm2;
  }
  PairCloud result;
  result.whole = std::move(whole);
  result.part = std::move(part);
  result.density = density_map(result.part.cloud, input.rig.left, input.mask, input.regions);
  result.frame_identity = frame_identity(input.frame.left, input.frame.right);
  if (is_suspicious(result, options)) (void)look.check();
  result.check = look.made();
  return result;
}

}  // namespace

Cancellable<PairCloud> reconstruct_pair(const PairInput& input, const ReconstructOptions& options,
                                        const RunContext& context, const KnownPoints& known) {
  options.validate();
  require_rig_of(input.rig, input.frame.left);
  require_regions_of(input.regions, input.frame.left, input.frame.right);
  Look look(input);
  if (!known.whole) require_sound(look.check());
  const bool labels = !input.regions.regions.empty();
  const bool may_be_dense = labels && options.method == Method::automatic;
  auto whole = asked_whole(input, options, known, look, context.part(0.0, may_be_dense ? 0.6 : 1.0));
  if (!whole) return {};
  LabelledPart part = label((*whole)->cloud, input.rig, input.mask, input.regions);
  if (may_be_dense && (*whole)->report.method == Method::sparse &&
      part.density_per_cm2 < options.least_density_per_cm2) {
    const auto dense = dense_whole(input, options, known, context.part(0.6, 1.0));
    if (!dense) return {};
    if (*dense) {
      LabelledPart denser = label((*dense)->cloud, input.rig, input.mask, input.regions);
      if (denser.density_per_cm2 > part.density_per_cm2) whole = dense, part = std::move(denser);
    }
  }
  return described(std::move(*whole), std::move(part), input, options, look);
}

}  // namespace glisson::stereo
