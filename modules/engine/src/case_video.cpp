// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_video.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "case_manifest.h"
#include "case_reach.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/parts/named_video.h"
#include "glisson/stereo/reach.h"
#include "glisson/stereo/source.h"
#include "ranged.h"

namespace glisson::engine {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;
using Sources = std::vector<std::string>;

std::string place_of(const fs::path& video, const fs::path& home) {
  if (video.empty()) return {};
  if (stereo::is_live(video.string())) return video.string();
  const fs::path relative = fs::absolute(video).lexically_normal().lexically_relative(home);
  // In the case's folder, or in the one that holds it; at most one step up.
  const auto steps = std::distance(relative.begin(), relative.end());
  const bool beside =
      steps == 1 ? relative != "." && relative != ".." : steps > 1 && *std::next(relative.begin()) != "..";
  return beside ? relative.string() : fs::absolute(video).lexically_normal().string();
}

Sources views_of(const VideoSource& video) {
  Sources views = {video.left.string(), video.right.string()};
  std::erase(views, std::string());
  return views;
}

/// What descriptions among the views name.
Sources described_by(const VideoSource& video) {
  Sources named;
  for (const fs::path view : views_of(video)) {
    std::error_code failure;
    if (lower_extension(view) != ".json" || !fs::is_regular_file(view, failure)) continue;
    try {
      const stereo::SourceOptions source = stereo::read_source(view);
      named.insert(named.end(), {source.left, source.right});
    } catch (const Error&) {
      continue;  // told when it is opened
    }
  }
  std::erase(named, std::string());
  return named;
}

bool all_stay_here(const Sources& sources) {
  return std::all_of(sources.begin(), sources.end(),
                     [](const std::string& source) { return stereo::stays_here(source); });
}

/// @param home the case's folder.
bool all_are_chosen(const Sources& sources, const fs::path& home) {
  return std::all_of(sources.begin(), sources.end(), [&](const std::string& source) {
    if (stereo::is_entered(source)) return true;
    return !stereo::is_live(source) && lies_in_case(home, place_on_disk(source));
  });
}

enum class Standing { chosen, named, beyond };

/// What nobody has chosen is not read either. @param as_written before paths were made absolute.
Standing standing_of(const VideoSource& video, const VideoSource& as_written, const fs::path& home) {
  if (!all_stay_here(views_of(as_written)) || !all_stay_here(views_of(video))) return Standing::beyond;
  if (!all_are_chosen(views_of(video), home)) return Standing::named;
  const Sources described = described_by(video);
  if (!all_stay_here(described)) return Standing::beyond;
  return all_are_chosen(described, home) ? Standing::chosen : Standing::named;
}

InputError refusal(const VideoSource& video, Standing standing, const CaseFolder& folder) {
  const std::string file = (folder.path / kCaseFile).string();
  std::string named;
  for (const std::string& source : sources_named_by(video, folder.home))
    named += (named.empty() ? "" : ", ") + source.substr(0, 200);
  if (standing == Standing::beyond)
    return InputError(file, "video", "names a source outside this computer (" + named + ")",
                      "Choose the source again");
  return InputError(file, "video", "names pictures that nobody here has chosen (" + named + ")",
                    "Open them yourself if you trust the case");
}

void put(CaseState& state, const PartOf<VideoSource>& as, const VideoSource& video, const json& entry,
         const CaseFolder& folder) {
  state[as] = std::make_shared<const VideoSource>(video);
  state.stamp(as).revision = ranged<std::uint64_t>(folder.path, entry, "revision", 0.0, kMostRevisions);
}

bool same_place(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty() || stereo::is_live(a.string())) return a == b;
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

}  // namespace

fs::path place_on_disk(const fs::path& source) {
  return stereo::is_pattern(source.string()) ? source.parent_path() : source;
}

json video_entry(const VideoSource& video, const CaseFolder& folder) {
  return {{"left", place_of(video.left, folder.home)}, {"right", place_of(video.right, folder.home)}};
}

void read_video_entry(CaseState& state, const PartOf<VideoSource>& as, const json& entry,
                      const CaseFolder& folder) {
  const VideoSource as_written{entry.at("left").get<std::string>(), entry.at("right").get<std::string>()};
  const auto place = [&](const fs::path& view) {
    return view.empty() || view.is_absolute() || stereo::is_live(view.string())
               ? view
               : (folder.home / view).lexically_normal();
  };
  const VideoSource video{place(as_written.left), place(as_written.right)};
  if (folder.is_own) return put(state, as, video, entry, folder);
  const Standing standing = standing_of(video, as_written, folder.home);
  if (standing == Standing::chosen) return put(state, part::video, video, entry, folder);
  const InputError error = refusal(standing == Standing::beyond ? as_written : video, standing, folder);
  if (folder.lost == nullptr) throw error;
  folder.lost->push_back(std::string("case.video_lost ") + error.what());
  if (standing == Standing::named) put(state, part::named_video, video, entry, folder);
}

Sources sources_named_by(const VideoSource& video, const fs::path& home) {
  Sources sources = views_of(video);
  for (const std::string& view : views_of(video)) {
    if (stereo::is_live(view) || !lies_in_case(home, view)) continue;
    const Sources described = described_by({view, {}});
    sources.insert(sources.end(), described.begin(), described.end());
  }
  return sources;
}

bool same_video(const VideoSource& a, const VideoSource& b) {
  return same_place(a.left, b.left) && same_place(a.right, b.right);
}

bool stays_here(const VideoSource& video) {
  return all_stay_here(views_of(video)) && all_stay_here(described_by(video));
}

void remember(const VideoSource& video) { stereo::remember_sources(views_of(video)); }

}  // namespace glisson::engine
