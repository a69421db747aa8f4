// SPDX-License-Identifier: GPL-3.0-or-later
#include "soak_film.h"

#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"

namespace glisson::experiments {

SoakFilm::SoakFilm(const engine::CaseState& state) {
  engine::require_parts(state, {part::video});
  stereo::StereoVideo video(state[part::video]->left, state[part::video]->right);
  constexpr std::size_t kMost = 60;
  for (StereoFrame frame; frames_.size() < kMost && video.read(frame);) frames_.push_back(frame);
  if (frames_.size() < 2) throw InputError("case", "video", "has fewer than two frames", "Give a longer one");
}

int SoakFilm::picture(int n) const {
  const int phase = n % (2 * last());
  return phase <= last() ? phase : 2 * last() - phase;
}

StereoFrame SoakFilm::at(int n) const {
  StereoFrame frame = frames_[static_cast<std::size_t>(picture(n))];
  frame.index = n;
  frame.seconds = n / 30.0;
  return frame;
}

void SoakLosses::add(int n, const OverlayFrame& overlay) {
  ++frames_;
  const std::string reason = overlay.level() == Level::valid ? "" : validity_code(overlay.validity);
  spell_ = reason == last_ ? spell_ + 1 : 1;
  const bool begins = reason != last_;
  last_ = reason;
  if (reason.empty()) return;
  Loss& loss = losses_[reason];
  loss.level = overlay.level();
  ++loss.frames;
  ++loss.pictures[film_.picture(n)];
  loss.longest = std::max(loss.longest, spell_);
  if (!begins) return;
  constexpr int kNear = 3;
  ++loss.spells;
  loss.at_turns += film_.picture(n) <= kNear || film_.picture(n) >= film_.last() - kNear;
}

Figures SoakLosses::figures() const {
  Figures figures;
  figures["soak_frames_withdrawn"] = figures["soak_frames_degraded"] = 0.0;
  for (const auto& [reason, loss] : losses_) {
    figures[loss.level == Level::withdrawn ? "soak_frames_withdrawn" : "soak_frames_degraded"] += loss.frames;
    figures["soak_frames_" + reason] = loss.frames;
    figures["soak_frames_" + reason + "_spells"] = loss.spells;
    figures["soak_frames_" + reason + "_spells_at_turns"] = loss.at_turns;
  }
  return figures;
}

std::string SoakLosses::table() const {
  if (losses_.empty()) return {};
  std::string text =
      "\nFrames that were not drawn in full, of " + std::to_string(frames_) +
      ". The film's pictures are counted from 0 to " + std::to_string(film_.last()) +
      "; it turns round at both ends.\n\n| reason | level | frames | spells | begun at a turn | longest "
      "| pictures most often |\n|---|---|---|---|---|---|---|\n";
  for (const auto& [reason, loss] : losses_) {
    std::vector<std::pair<int, int>> often;
    for (const auto& [picture, times] : loss.pictures) often.emplace_back(-times, picture);
    std::sort(often.begin(), often.end());
    std::string pictures;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, often.size()); ++i)
      pictures += (i > 0 ? ", " : "") + std::to_string(often[i].second) + " (" +
                  std::to_string(-often[i].first) + ")";
    text += "| " + reason + " | " + level_code(loss.level) + " | " + std::to_string(loss.frames) + " | " +
            std::to_string(loss.spells) + " | " + std::to_string(loss.at_turns) + " | " +
            std::to_string(loss.longest) + " | " + pictures + " |\n";
  }
  return text;
}

}  // namespace glisson::experiments
