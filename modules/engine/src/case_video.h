// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "glisson/engine/parts/video.h"

/// @file
/// The video that a case names: what of it may be opened without asking.

namespace glisson::engine {

/// The file of a source that is not live, or the folder of a pattern.
std::filesystem::path place_on_disk(const std::filesystem::path& source);

/// Videos are large: the case says where they lie, relative to itself where they lie beside it, so that both
/// can move.
nlohmann::json video_entry(const VideoSource& video, const CaseFolder& folder);

/// Reads an entry. A case does not speak for its reader: it becomes the case's video (part::video) where both
/// views, and what a description of them names, lie below the case's folder or were entered by a person of
/// this computer before. Otherwise it is only named (part::named_video), and where it leads out of this
/// computer not even that; the note "case.video_lost SENTENCE" tells. With the stamp of the entry.
/// @param as the part that the entry is of: which one it becomes where it is this program's own.
/// @throws InputError instead of the note, see CaseFolder::lost.
void read_video_entry(CaseState& state, const PartOf<VideoSource>& as, const nlohmann::json& entry,
                      const CaseFolder& folder);

/// What would be opened: the views, and what descriptions among them name that lie in the case's folder;
/// others are not read. @param home that folder.
std::vector<std::string> sources_named_by(const VideoSource& video, const std::filesystem::path& home);

bool same_video(const VideoSource& a, const VideoSource& b);

/// Whether neither view, nor what a description of them names, leads out of this computer.
bool stays_here(const VideoSource& video);

/// A case that is saved here is worked on here: its views count as chosen, so that it opens them from another
/// folder, too. What descriptions name does not: they may have been changed since.
void remember(const VideoSource& video);

}  // namespace glisson::engine
