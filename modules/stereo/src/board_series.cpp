// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/board_series.h"

#include <algorithm>
#include <cmath>

#include "glisson/stereo/picture_reader.h"

namespace glisson::stereo {
namespace {

constexpr const char* kStage = "calibrate.find_board";

void add(BoardViews& views, const std::string& name, const Picture& left, const Picture& right,
         const BoardTold& told) {
  const BoardViews::Found found = views.add(name, left, right);
  if (told) told(name, found);
}

}  // namespace

bool add_pairs(BoardViews& views, const std::vector<PicturePair>& pairs, const RunContext& context,
               const BoardTold& told) {
  double done = 0.0;
  PictureReader reader;
  for (const PicturePair& pair : pairs) {
    if (context.cancelled()) return false;
    context.progress(done++ / static_cast<double>(pairs.size()), kStage);
    const Picture left = reader.read(pair.left), right = reader.read(pair.right);
    add(views, pair.name, left, right, told);
  }
  return true;
}

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

}  // namespace glisson::stereo
