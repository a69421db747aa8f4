// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands/rename_moment.h"

#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/engine/parts/moments.h"

namespace glisson::engine {
namespace {

constexpr std::size_t kMostLetters = 200;

void require_title(const std::string& title) {
  // A letter of UTF-8 begins with any byte but those of the form 10xxxxxx.
  const auto letters = static_cast<std::size_t>(std::count_if(
      title.begin(), title.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  if (letters > kMostLetters)
    throw InputError("moments", "title", "is longer than a title can be", "Shorten it to 200 letters");
}

/// @throws InputError no moment of this number is kept.
KeptMoments renamed(KeptMoments kept, int number, const std::string& title) {
  const auto found = std::ranges::find(kept.moments, number, [](const auto& one) { return one->number; });
  if (found == kept.moments.end())
    throw InputError("moments", "moment " + std::to_string(number), "is not kept", "Choose one of the list");
  auto moment = std::make_shared<KeptMoment>(**found);
  moment->title = title;
  *found = std::move(moment);
  return kept;
}

}  // namespace

CommandTraits RenameMoment::traits() const {
  return {.code = "rename_moment",
          .reads = {part::moments},
          .writes = {part::moments},
          .needs = {part::moments},
          .lane = Lane::edits,
          .notice = Notice::quiet};
}

Cancellable<Applied> RenameMoment::apply(const CaseState& state, const RunContext&) const {
  require_title(title);
  Applied applied{state};
  applied.state[part::moments] =
      std::make_shared<const KeptMoments>(renamed(*state[part::moments], number, title));
  return applied;
}

}  // namespace glisson::engine
