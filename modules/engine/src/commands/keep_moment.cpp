// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/keep_moment.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "glisson/core/error.h"

namespace glisson::engine {
namespace {

constexpr const char* kRemedy = "Delete moments that are not needed any more";

std::size_t bytes_of(const KeptMoment& moment) { return moment.left_png->size() + moment.right_png->size(); }

void require_room_for(const KeptMoment& moment, const KeptMoments& kept) {
  if (kept.moments.size() >= kMostMoments)
    throw InputError("moments", "moment",
                     "is one more than the " + std::to_string(kMostMoments) + " that can be kept", kRemedy);
  std::size_t bytes = bytes_of(moment);
  for (const auto& other : kept.moments) bytes += bytes_of(*other);
  if (bytes > kMostMomentBytes)
    throw InputError("moments", "moment", "finds no room: the pictures of all moments may take 1 GiB",
                     kRemedy);
}

/// A file has no place for what is not a number, and one moment that cannot be written would keep the whole
/// case from being saved.
void require_finite(const KeptMoment& moment) {
  const OverlayFrame& overlay = moment.overlay;
  const auto is_length = [](double value) { return std::isfinite(value) && value >= 0.0; };
  bool is_sound = overlay.nodes_in_camera.allFinite() && moment.margin.allFinite() &&
                  (!moment.camera_from_model || moment.camera_from_model->allFinite()) &&
                  (!moment.place || moment.place->weights.allFinite()) && std::isfinite(overlay.seconds) &&
                  is_length(overlay.residual) && is_length(overlay.milliseconds) &&
                  (!overlay.mask || (is_length(overlay.mask->share) && is_length(overlay.mask->age)));
  for (const LesionVerdict& one : overlay.lesions)
    is_sound = is_sound && one.centre.allFinite() && is_length(one.radius) && is_length(one.unseen) &&
               (!(one.reach > 0.0) ||
                (is_length(one.reach) && is_length(one.expected) && one.covariance.allFinite()));
  if (!is_sound)
    throw InputError("moments", "moment", "holds a number that is not finite", "Keep another frame");
}

void require_sound(const KeptMoment* moment) {
  require(moment != nullptr && moment->left_png && moment->right_png, "a moment has both pictures");
  require(moment->overlay.nodes_in_camera.rows() == 0 || moment->camera_from_model,
          "a moment with nodes has their pose");
  require_finite(*moment);
}

/// In the order of the numbers. @return its number. @throws InputError it is there already.
int put(const KeptMoment& moment, KeptMoments& kept) {
  auto made = std::make_shared<KeptMoment>(moment);
  const int number = made->number == 0 ? kept.last + 1 : made->number;
  made->number = number;
  const auto place = std::find_if(kept.moments.begin(), kept.moments.end(),
                                  [number](const auto& other) { return other->number >= number; });
  if (place != kept.moments.end() && (*place)->number == number)
    throw InputError("moments", "moment", "is kept already", "Choose it in the list");
  kept.last = std::max(kept.last, number);
  kept.moments.insert(place, std::move(made));
  return number;
}

}  // namespace

CommandTraits KeepMoment::traits() const {
  return {.code = "keep_moment", .reads = {part::moments}, .writes = {part::moments}, .lane = Lane::edits};
}

Cancellable<Applied> KeepMoment::apply(const CaseState& state, const RunContext&) const {
  KeptMoments kept;
  if (state[part::moments]) kept = *state[part::moments];
  require_sound(moment.get());
  require_room_for(*moment, kept);
  Applied applied{state};
  applied.figures["moment"] = put(*moment, kept);
  applied.state[part::moments] = std::make_shared<const KeptMoments>(std::move(kept));
  return applied;
}

}  // namespace glisson::engine
