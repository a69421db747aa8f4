// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "glisson/core/run_context.h"
#include "glisson/stereo/board.h"

namespace glisson::stereo {

/// Which pictures are looked through for which board.
struct BoardSearch {
  /// A folder of pairs (subfolders "left" and "right", or names that differ in the side only), or with
  /// `right` two folders or patterns ("a/left-*.png"); of a video both views side by side, or with `right`
  /// the left one.
  std::filesystem::path left, right;
  bool is_video = false;
  Board board;
  /// So many views are kept, those that differ most (BoardViews::keep_most_different): the time of a
  /// calibration grows with their square, and many of a board that rests outvote the others.
  int most_views = 40;

  /// @throws InputError the board; most_views not from 3 to 200.
  void validate() const;
};

/// Who is told on the way what becomes of each picture; either may be empty.
struct BoardTold {
  std::function<void(const std::filesystem::path& picture)> alone;  ///< one without a partner
  std::function<void(const std::string& name, BoardViews::Found found)> looked;
};

/// Looks for the board in every pair, or in some 60 frames, spread over the video (of one without a known
/// length: a look a second). Pairs are named by what their files share, frames "frame N". Progress
/// "calibrate.find_board"; about 2 s for a pair at 1920x1080.
/// @throws InputError the search, no pair of pictures; FileError no such pictures; both as read_picture,
/// StereoVideo and BoardViews::add.
Cancellable<BoardViews> find_views(const BoardSearch& search, const RunContext& context,
                                   const BoardTold& told = {});

}  // namespace glisson::stereo
