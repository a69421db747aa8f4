// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/engine/parts/video.h"

namespace glisson::engine {

/// Whether there is something to open where a video is said to lie: files, or the folders of patterns. Live
/// devices are tried when they are opened.
bool is_there(const VideoSource& video);

/// What would be opened if a person said so, for that person to judge: the views of part::named_video, and
/// what descriptions of them name that lie in the case's folder. Empty: the case names nothing unchosen.
std::vector<std::string> named_sources(const CaseState& state);

namespace part {
/// The video that a case names while nobody of this computer has chosen it: it is not opened. SetVideo, which
/// is a person's word, puts that person's video in its place. Kept with the case until then.
extern const PartOf<VideoSource> named_video;
}  // namespace part

}  // namespace glisson::engine
