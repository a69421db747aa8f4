// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/keep_look.h"

#include <algorithm>
#include <string>

#include "case_files.h"
#include "glisson/core/error.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"

namespace glisson::engine {
namespace {

std::shared_ptr<const LabelledCloud> look_in(const std::filesystem::path& path, LengthUnit unit) {
  auto look = std::make_shared<const LabelledCloud>(read_cloud(path, unit));
  require_liver_sized(*look, unit, path.string());
  return look;
}

/// @throws InputError it is kept already, or as many as can be are.
void require_room_for(const LabelledCloud& look, const EarlierLooks& kept, const std::string& name) {
  if (std::any_of(kept.clouds.begin(), kept.clouds.end(),
                  [&](const auto& other) { return same_points(other->points, look.points); }))
    throw InputError(name, "look", "is kept already", "Look from elsewhere and reconstruct again");
  if (kept.clouds.size() >= kMostLooks)
    throw InputError(name, "look", "is one more than the " + std::to_string(kMostLooks) + " that can be kept",
                     "Forget the earlier looks, or register with these");
}

/// Of the pair of pictures that the case's cloud was made of; empty: not known.
std::string pair_of(const CaseState& state, const std::shared_ptr<const LabelledCloud>& look) {
  return look == state[part::cloud] && state[part::points] ? state[part::points]->frame_identity
                                                           : std::string();
}

/// @param pair of the look. @param name of the look, for errors. @throws InputError as require_room_for().
EarlierLooks with_look(const EarlierLooks* before, std::shared_ptr<const LabelledCloud> look,
                       const std::string& pair, const std::string& name) {
  EarlierLooks kept;
  if (before != nullptr) kept = *before;
  require_room_for(*look, kept, name);
  kept.pairs.resize(kept.clouds.size());
  kept.clouds.push_back(std::move(look));
  kept.pairs.push_back(pair);
  return kept;
}

}  // namespace

CommandTraits KeepLook::traits() const {
  CommandTraits traits{.code = "keep_look", .reads = {part::earlier_looks}, .writes = {part::earlier_looks}};
  if (path) {
    traits.notice = Notice::files;
    return traits;
  }
  traits.lane = Lane::edits;  // at once, beside a reconstruction
  if (seen) return traits;
  traits.reads.add(part::cloud);
  traits.needs = {part::cloud};
  return traits;
}

Cancellable<Applied> KeepLook::apply(const CaseState& state, const RunContext&) const {
  auto look = path ? look_in(*path, unit) : seen ? seen : state[part::cloud];
  const std::string pair = pair_of(state, look);
  EarlierLooks kept =
      with_look(state[part::earlier_looks].get(), std::move(look), pair, path ? path->string() : "cloud");
  Applied applied{state, {{"looks_kept", static_cast<double>(kept.clouds.size())}}};
  applied.state[part::earlier_looks] = std::make_shared<const EarlierLooks>(std::move(kept));
  return applied;
}

}  // namespace glisson::engine
