// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/video.h"

#include <iterator>
#include <nlohmann/json.hpp>

#include "glisson/stereo/source.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

/// Videos are large: the case says where they lie, relative to itself where they lie beside it, so that both
/// can move.
std::string place_of(const fs::path& video, const fs::path& home) {
  if (video.empty()) return {};
  if (stereo::is_device(video.string())) return video.string();
  const fs::path relative = fs::absolute(video).lexically_normal().lexically_relative(home);
  const bool beside = !relative.empty() && relative.begin() != relative.end() &&
                      std::next(relative.begin()) != relative.end() && *std::next(relative.begin()) != "..";
  return beside ? relative.string() : fs::absolute(video).lexically_normal().string();
}

json save(const CaseState& state, const CaseFolder& folder) {
  const VideoSource& video = *state[part::video];
  return {{"left", place_of(video.left, folder.home)}, {"right", place_of(video.right, folder.home)}};
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  const auto place = [&](const char* side) {
    const fs::path video = entry.at(side).get<std::string>();
    return video.empty() || video.is_absolute() || stereo::is_device(video.string())
               ? video
               : (folder.path / video).lexically_normal();
  };
  state[part::video] = std::make_shared<const VideoSource>(VideoSource{place("left"), place("right")});
}

}  // namespace

const PartOf<VideoSource> part::video{
    {.code = "video", .remedy = "Open a stereo video first", .save = save, .load = load}};

}  // namespace glisson::engine
