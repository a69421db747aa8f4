// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/named_video.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "case_video.h"
#include "glisson/stereo/source.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

json save(const CaseState& state, const CaseFolder& folder) {
  return video_entry(*state[part::named_video], folder);
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  read_video_entry(state, part::named_video, entry, folder);
}

bool same(const CaseState& written, const CaseState& read) {
  return same_video(*written[part::named_video], *read[part::named_video]);
}

}  // namespace

const PartOf<VideoSource> part::named_video{{.code = "named_video",
                                             .remedy = "Open a stereo video first",
                                             .save = save,
                                             .load = load,
                                             .same = same,
                                             .stands_alone = true,
                                             .is_input = false}};

std::vector<std::string> named_sources(const CaseState& state) {
  const auto& named = state[part::named_video];
  return named ? sources_named_by(*named, state.path) : std::vector<std::string>();
}

bool is_there(const VideoSource& video) {
  for (const fs::path& view : {video.left, video.right}) {
    if (view.empty() || stereo::is_live(view.string())) continue;
    std::error_code failure;
    if (!fs::exists(place_on_disk(view), failure)) return false;
  }
  return true;
}

}  // namespace glisson::engine
