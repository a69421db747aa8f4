// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/openigtlink_model.h"

#include "glisson/core/error.h"
#include "glisson/engine/parts/live.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/scene/sent_model.h"

namespace glisson::ui {
namespace {

std::optional<std::pair<int, double>> frame_of(const engine::CaseState& state) {
  const auto& live = state[part::live];
  if (!live) return {};
  return std::pair(live->overlay.index, live->overlay.seconds);
}

}  // namespace

OpenIgtLinkModel::OpenIgtLinkModel(EngineBridge& engine, DrawableSource& drawables, QObject* parent)
    : QObject(parent), engine_(engine), drawables_(drawables) {
  connect(&engine_, &EngineBridge::live_changed, this, &OpenIgtLinkModel::read_live);
  connect(&engine_, &EngineBridge::case_changed, this, &OpenIgtLinkModel::read_live);
  connect(&drawables_, &DrawableSource::changed, this, &OpenIgtLinkModel::read_drawable);
  connect(&state_, &QTimer::timeout, this, &OpenIgtLinkModel::tell_state);
}

OpenIgtLinkModel::~OpenIgtLinkModel() = default;

void OpenIgtLinkModel::switch_on(const QString& wanted) {
  constexpr int kLook = 250;  // milliseconds
  switch_off();
  try {
    openigtlink::SenderOptions options;
    options.address = openigtlink::parse_address(wanted.trimmed().toStdString());
    sender_ = std::make_unique<openigtlink::Sender>(options);
  } catch (const Error& failure) {
    return say(error_text(failure.what()), QStringLiteral("error"));
  }
  address = QString::fromStdString(sender_->address().text());
  is_on = true;
  is_withdrawn_ = true;
  old_ = frame_of(engine_.state());
  state_.start(kLook);
  read_drawable();
  tell_state();
}

void OpenIgtLinkModel::switch_off() {
  state_.stop();
  sender_.reset();
  sent_.reset();
  is_on = false;
  say({}, {});
}

void OpenIgtLinkModel::read_drawable() {
  if (!sender_) return;
  sent_ = drawables_.drawable() ? scene::sent_model(*drawables_.drawable()) : nullptr;
  read_live();
}

void OpenIgtLinkModel::read_live() {
  if (!sender_) return;
  const engine::Snapshot& now = *engine_.snapshot();
  if (!now.tracking || !now.state[part::live] || !sent_) {
    if (!is_withdrawn_) sender_->withdraw(Validity::not_started);
    is_withdrawn_ = true;
    return;
  }
  OverlayFrame overlay = now.state[part::live]->overlay;
  if (old_ != frame_of(now.state)) old_.reset();
  if (old_ || now.stage(part::live) == engine::StageState::stale) overlay.validity = Validity::stale;
  is_withdrawn_ = false;
  sender_->tell(sent_, std::move(overlay));
}

void OpenIgtLinkModel::tell_state() {
  const openigtlink::SenderState state = sender_->state();
  QString text = state.peers == 0
                     ? tr("Listening at %1; no program is connected.").arg(address)
                     : tr("Listening at %1; programs connected: %2").arg(address).arg(state.peers);
  if (state.given_up > 0) text += QLatin1Char('\n') + tr("Given up, too slow: %1").arg(state.given_up);
  if (sender_->address().is_local()) return say(text, QStringLiteral("good"));
  text += QLatin1Char('\n') +
          tr("Other computers can connect and read where the organ is: nothing is encrypted.");
  say(text, QStringLiteral("warning"));
}

void OpenIgtLinkModel::say(const QString& text, const QString& how) {
  tone = how;
  said = text;
}

}  // namespace glisson::ui
