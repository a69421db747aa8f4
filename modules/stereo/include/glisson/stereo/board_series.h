// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/stereo/board.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_pairs.h"

namespace glisson::stereo {

/// Is told of each pair of pictures as soon as the board was looked for in it.
using BoardTold = std::function<void(const std::string& name, BoardViews::Found found)>;

/// Looks for the board in every pair. Progress "calibrate.find_board"; about 2 s for a pair at 1920x1080.
/// @return false: cancelled. @throws FileError, InputError as read_picture and BoardViews::add.
bool add_pairs(BoardViews& views, const std::vector<PicturePair>& pairs, const RunContext& context,
               const BoardTold& told = {});

/// Looks for the board in some 60 frames, spread over the video (of one without a known length: in all). The
/// views are named "frame N". @return false: cancelled. @throws as StereoVideo::read and BoardViews::add.
bool add_frames(BoardViews& views, StereoVideo& video, const RunContext& context, const BoardTold& told = {});

}  // namespace glisson::stereo
