// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/again_model.h"

#include "glisson/engine/commands/register_again.h"
#include "glisson/engine/commands/take_registration.h"
#include "glisson/engine/parts/live.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/registration/refusal.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

AgainModel::AgainModel(EngineBridge& engine, PlaybackModel& playback, QObject* parent)
    : QObject(parent), engine_(engine), playback_(playback) {
  connect(&engine_, &EngineBridge::finished, this, &AgainModel::finish);
  connect(&engine_, &EngineBridge::case_changed, this, &AgainModel::read_case);
  connect(&playback_, &PlaybackModel::begun, this, [this] {
    record_.clear();
    if (!registering_) say({});  // a video that begins again ends nothing
  });
  couplings_.add(playback_.is_playing, [this](bool) { read_case(); });
}

const engine::OtherRegistration* AgainModel::other() const {
  return engine_.state()[part::other_registration].get();
}

void AgainModel::read_case() {
  if (const std::uint64_t number = engine_.snapshot()->case_number; number != said_of_) {
    said_of_ = number;
    say({});
  }
  is_offered = playback_.is_playing.value();
  read_other();
}

void AgainModel::read_other() {
  const bool stands = other() != nullptr &&
                      engine_.snapshot()->stage(part::other_registration) == engine::StageState::current;
  can_exchange = is_offered && stands && !registering_ && !exchanging_ &&
                 !registration::is_refused(other()->registration);
  is_former = other() != nullptr && other()->is_former;
}

void AgainModel::start_or_cancel() {
  if (registering_) return engine_.cancel(*registering_);
  if (!is_offered || exchanging_) return;
  engine::RegisterAgain command;
  command.method = method_;
  registering_ = engine_.post(command);
  is_running = true;
  say(tr("Registering again; the picture stays until it is better."));
  read_other();
}

void AgainModel::exchange() {
  if (can_exchange)
    exchanging_ = engine_.post(engine::TakeRegistration{engine_.state()[part::other_registration]});
  read_other();
}

void AgainModel::finish(const engine::Outcome& outcome) {
  if (registering_ == outcome.id) {
    registering_.reset();
    is_running = false;
    end_registering(outcome);
    read_other();
  } else if (exchanging_ == outcome.id) {
    exchanging_.reset();
    end_exchange(outcome);
    read_other();
  }
}

void AgainModel::end_registering(const engine::Outcome& outcome) {
  if (outcome.status == engine::Status::cancelled)
    return say(tr("Cancelled: the former registration stays."));
  if (outcome.status == engine::Status::failed)
    return say(error_text(outcome.error), QStringLiteral("error"));
  if (other() == nullptr) return;
  if (const auto take = engine::take_if_better(engine_.state())) {
    if (!is_offered) return say(tr("Better, but the organ is not followed just now: take it then."));
    exchanging_ = engine_.post(*take);
    return;
  }
  tell_record(false);
  QString text = tr("Not taken: it lies %1 mm from tissue that neither has used, the former one %2 mm.")
                     .arg(1e3 * other()->gap, 0, 'f', 1)
                     .arg(1e3 * other()->former_gap, 0, 'f', 1);
  if (const QString doubts = notes_text(outcome.notes); !doubts.isEmpty()) text += QLatin1Char('\n') + doubts;
  say(text, QStringLiteral("warning"));
}

void AgainModel::end_exchange(const engine::Outcome& outcome) {
  if (outcome.status != engine::Status::done) return say(error_text(outcome.error), QStringLiteral("error"));
  if (other() == nullptr) return;
  tell_record(other()->is_former);
  if (!other()->is_former) return say(tr("The former registration is back."));
  say(tr("Registered again: the organ has moved by %1 mm on average. From tissue that neither has used: "
         "%2 mm, before %3 mm.")
          .arg(1e3 * other()->moved, 0, 'f', 1)
          .arg(1e3 * other()->gap, 0, 'f', 1)
          .arg(1e3 * other()->former_gap, 0, 'f', 1),
      QStringLiteral("good"));
}

void AgainModel::tell_record(bool is_taken) {
  const auto& live = engine_.state()[part::live];
  if (!live) return;
  record_.push_back(again_line({live->overlay.index, live->overlay.seconds, is_taken, other()->former_gap,
                                other()->gap, other()->moved}));
}

void AgainModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
