// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/review_model.h"

#include <algorithm>
#include <cmath>

#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"

namespace glisson::ui {

ReviewModel::ReviewModel(EngineBridge& engine, PlaybackModel& playback, QObject* parent)
    : QObject(parent), engine_(engine), playback_(playback) {
  connect(&engine_, &EngineBridge::live_changed, this, &ReviewModel::take_live);
  connect(&playback_, &PlaybackModel::case_read, this, &ReviewModel::read_case);
  connect(&playback_, &PlaybackModel::begun, this, [this] {
    leave();
    store_.clear();
  });
  connect(&store_, &MomentStore::changed, this, &ReviewModel::read_store);
  connect(&timer_, &QTimer::timeout, this, &ReviewModel::advance);
  couplings_.add(playback_.is_playing, [this](bool) { say_runs(); });
  couplings_.add(playback_.is_paused, [this](bool) { say_runs(); });
}

void ReviewModel::say_runs() {
  runs = is_reviewing ? timer_.isActive() : playback_.is_playing && !playback_.is_paused;
}

void ReviewModel::read_case() {
  // All that a former frame is drawn with: by another calibration or model it would not be as it was
  // followed.
  const engine::CaseState& now = engine_.state();
  const bool is_the_same = now[part::registration] == registration_ && now[part::rig] == rig_ &&
                           now[part::model] == model_ && now[part::landmarks] == landmarks_;
  if (is_the_same) return;
  registration_ = now[part::registration];
  rig_ = now[part::rig];
  model_ = now[part::model];
  landmarks_ = now[part::landmarks];
  leave();
  store_.clear();
}

void ReviewModel::take_live() {
  const auto& live = engine_.state()[part::live];
  if (!live || live->frame.left.empty() || !engine_.snapshot()->tracking) return;
  // What is out of date is never looked at as if it had been current.
  if (engine_.snapshot()->stage(part::live) == engine::StageState::stale) return;
  store_.add({live->frame.left, live->overlay});
  if (!is_reviewing) position = live->overlay.index;
}

void ReviewModel::read_store() {
  entries_ = store_.entries();
  is_offered = !entries_.empty();
  if (entries_.empty()) {
    marks = std::vector<LevelMark>();
    leave();
    return;
  }
  std::vector<LevelMark> changes;
  for (const MomentStore::Entry& entry : entries_)
    if (changes.empty() || changes.back().level != entry.level) changes.push_back({entry.index, entry.level});
  marks = std::move(changes);
  first = entries_.front().index;
  last = entries_.back().index;
}

std::size_t ReviewModel::place_of(int index) const {
  const auto after =
      std::lower_bound(entries_.begin(), entries_.end(), index,
                       [](const MomentStore::Entry& one, int wanted) { return one.index < wanted; });
  auto place = static_cast<std::size_t>(after - entries_.begin());
  if (place == entries_.size()) return place - 1;
  const bool is_before_nearer =
      place > 0 && index - entries_[place - 1].index < entries_[place].index - index;
  return is_before_nearer ? place - 1 : place;
}

void ReviewModel::show_at(std::size_t place) {
  const auto moment = store_.at(entries_[place].index);
  if (!moment) return;  // gone meanwhile
  position = entries_[place].index;
  is_reviewing = true;
  emit shown(*moment);
}

void ReviewModel::seek(int index) {
  if (entries_.empty()) return;
  playback_.pause(true);
  show_at(place_of(index));
  say_runs();
}

void ReviewModel::step(int by) {
  if (entries_.empty()) return;
  timer_.stop();
  playback_.pause(true);
  const std::size_t place = place_of(position);
  const bool is_last = place + 1 == entries_.size();
  if (by > 0 && is_last) {
    if (playback_.is_playing) {
      leave();
      playback_.step();
    }
  } else if (by > 0) {
    show_at(place + 1);
  } else if (place > 0) {
    show_at(place - 1);
  }
  say_runs();
}

void ReviewModel::toggle() {
  if (!is_reviewing && playback_.is_playing) {
    playback_.pause(!playback_.is_paused);
  } else if (timer_.isActive()) {
    timer_.stop();
  } else if (!entries_.empty()) {
    if (place_of(position) + 1 == entries_.size()) show_at(0);
    set_speed(speed_);
    timer_.start();
  }
  say_runs();
}

void ReviewModel::advance() {
  const std::size_t place = entries_.empty() ? 0 : place_of(position);
  if (place + 1 < entries_.size()) return show_at(place + 1);
  if (loops && !entries_.empty()) return show_at(0);
  timer_.stop();
  say_runs();
}

void ReviewModel::set_speed(double factor) {
  speed_ = factor;
  playback_.set_speed(factor);
  const double rate = std::max(1.0, playback_.feed().frames_per_second());
  timer_.setInterval(std::max(1, static_cast<int>(std::lround(1e3 / (rate * factor)))));
}

void ReviewModel::go_live() {
  emit live_wanted();
  leave();
  if (playback_.is_playing) playback_.pause(false);
  say_runs();
}

void ReviewModel::leave() {
  timer_.stop();
  if (is_reviewing) {
    is_reviewing = false;
    emit ended();
  }
  say_runs();
}

}  // namespace glisson::ui
