// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/video.h"

#include <nlohmann/json.hpp>

#include "case_video.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  remember(*state[part::video]);
  return video_entry(*state[part::video], folder);
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  read_video_entry(state, part::video, entry, folder);
}

bool same(const CaseState& written, const CaseState& read) {
  return same_video(*written[part::video], *read[part::video]);
}

}  // namespace

const PartOf<VideoSource> part::video{
    {.code = "video",
     .remedy = "Open a stereo video first",
     .save = save,
     .load = load,
     .same = same,
     .is_savable = [](const CaseState& state) { return stays_here(*state[part::video]); }}};

}  // namespace glisson::engine
