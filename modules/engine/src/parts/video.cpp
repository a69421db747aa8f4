// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/parts/video.h"

#include <iterator>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/reach.h"
#include "glisson/stereo/source.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;

/// Videos are large: the case says where they lie, relative to itself where they lie beside it, so that both
/// can move.
std::string place_of(const fs::path& video, const fs::path& home) {
  if (video.empty()) return {};
  if (stereo::is_live(video.string())) return video.string();
  const fs::path relative = fs::absolute(video).lexically_normal().lexically_relative(home);
  const bool beside = !relative.empty() && relative.begin() != relative.end() &&
                      std::next(relative.begin()) != relative.end() && *std::next(relative.begin()) != "..";
  return beside ? relative.string() : fs::absolute(video).lexically_normal().string();
}

json save(const CaseState& state, const CaseFolder& folder) {
  const VideoSource& video = *state[part::video];
  return {{"left", place_of(video.left, folder.home)}, {"right", place_of(video.right, folder.home)}};
}

/// Whether neither view, nor what a description of them names, leads out of this computer. A case does not
/// speak for its reader: only a person opens what lies elsewhere.
bool stays_here(const VideoSource& video) {
  for (const fs::path& place : {video.left, video.right}) {
    if (!stereo::stays_here(place.string())) return false;
    std::error_code failure;
    if (lower_extension(place) != ".json" || !fs::is_regular_file(place, failure)) continue;
    try {
      const stereo::SourceOptions source = stereo::read_source(place);
      if (!stereo::stays_here(source.left) || !stereo::stays_here(source.right)) return false;
    } catch (const Error&) {
      continue;  // told when it is opened
    }
  }
  return true;
}

void load(CaseState& state, const json& entry, const CaseFolder& folder) {
  const auto place = [&](const char* side) {
    const fs::path video = entry.at(side).get<std::string>();
    return video.empty() || video.is_absolute() || stereo::is_live(video.string())
               ? video
               : (folder.home / video).lexically_normal();
  };
  const VideoSource video{place("left"), place("right")};
  const VideoSource named{entry.at("left").get<std::string>(), entry.at("right").get<std::string>()};
  if (stays_here(named) && stays_here(video)) {
    state[part::video] = std::make_shared<const VideoSource>(video);
    return;
  }
  const InputError error((folder.path / "case.json").string(), "video",
                         "names a source outside this computer (" + named.left.string().substr(0, 200) + ")",
                         "Choose the source again");
  if (folder.lost == nullptr) throw error;
  folder.lost->push_back(std::string("case.video_lost ") + error.what());
}

bool same_place(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty() || stereo::is_live(a.string())) return a == b;
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

bool same(const CaseState& written, const CaseState& read) {
  const VideoSource &a = *written[part::video], &b = *read[part::video];
  return same_place(a.left, b.left) && same_place(a.right, b.right);
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
