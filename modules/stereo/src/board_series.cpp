// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/board_series.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "picture_pairs.h"

namespace glisson::stereo {
namespace {

constexpr const char* kStage = "calibrate.find_board";

void add(BoardViews& views, const std::string& name, const Picture& left, const Picture& right,
         const BoardTold& told) {
  const BoardViews::Found found = views.add(name, left, right);
  if (told.looked) told.looked(name, found);
}

/// @return false: cancelled.
bool add_pairs(BoardViews& views, const PicturePairs& files, const RunContext& context,
               const BoardTold& told) {
  if (told.alone)
    for (const std::filesystem::path& picture : files.alone) told.alone(picture);
  double done = 0.0;
  PictureReader reader;
  for (const PicturePair& pair : files.pairs) {
    if (context.cancelled()) return false;
    context.progress(done++ / static_cast<double>(files.pairs.size()), kStage);
    const Picture left = reader.read(pair.left), right = reader.read(pair.right);
    add(views, pair.name, left, right, told);
  }
  return true;
}

/// @return false: cancelled.
bool add_frames(BoardViews& views, StereoVideo& video, const RunContext& context, const BoardTold& told) {
  constexpr int kLooks = 60;  // a second each
  const int frames = video.frame_count();
  // Of a video that does not tell its length, a look a second.
  const int a_second = std::max(1, static_cast<int>(std::lround(video.frames_per_second())));
  const int step = frames > 0 ? std::max(1, frames / kLooks) : a_second;
  for (StereoFrame frame; video.read(frame);) {
    if (frame.index % step != 0) continue;
    if (context.cancelled()) return false;
    const double looked = frame.index / static_cast<double>(step);
    context.progress(
        frames > 0 ? std::min(1.0, frame.index / static_cast<double>(frames)) : looked / (looked + kLooks),
        kStage);
    add(views, "frame " + std::to_string(frame.index), frame.left, frame.right, told);
  }
  return true;
}

bool add_all(BoardViews& views, const BoardSearch& search, const RunContext& context, const BoardTold& told) {
  if (search.is_video) {
    StereoVideo video(search.left, search.right);
    return add_frames(views, video, context, told);
  }
  return add_pairs(
      views, search.right.empty() ? picture_pairs(search.left) : picture_pairs(search.left, search.right),
      context, told);
}

}  // namespace

void BoardSearch::validate() const {
  constexpr int kFewest = 3, kMost = 200;
  board.validate();
  OptionCheck("board search")(most_views >= kFewest && most_views <= kMost, "most_views", most_views,
                              "Give a number from 3 to 200");
}

Cancellable<BoardViews> find_views(const BoardSearch& search, const RunContext& context,
                                   const BoardTold& told) {
  search.validate();
  BoardViews views(search.board);
  if (!add_all(views, search, context, told)) return std::nullopt;
  views.keep_most_different(search.most_views);
  return views;
}

}  // namespace glisson::stereo
