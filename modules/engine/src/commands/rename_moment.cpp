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
  KeptMoments kept = *state[part::moments];
  const auto found = std::find_if(kept.moments.begin(), kept.moments.end(),
                                  [this](const auto& one) { return one->number == number; });
  if (found == kept.moments.end())
    throw InputError("moments", "moment " + std::to_string(number), "is not kept", "Choose one of the list");
  auto renamed = std::make_shared<KeptMoment>(**found);
  renamed->title = title;
  *found = std::move(renamed);
  Applied applied{state};
  applied.state[part::moments] = std::make_shared<const KeptMoments>(std::move(kept));
  return applied;
}

}  // namespace glisson::engine
