// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glisson/engine/parts/other_registration.h"
#include "glisson/registration/register_model.h"
#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/guidance/playback_model.h"

namespace glisson::ui {

/// Registers again while the organ is followed. What is better by its evidence is taken; what is not is left
/// to the person; the former one can be had back.
class AgainModel : public QObject {
  Q_OBJECT
 public:
  /// Both outlive this.
  AgainModel(EngineBridge& engine, PlaybackModel& playback, QObject* parent = nullptr);

  /// How the shape is found from now on.
  void set_method(registration::Method method) { method_ = method; }
  /// Begins, or cancels what is on its way.
  void start_or_cancel();
  /// The registration that is offered and the present one change places.
  void exchange();
  /// A line for each one that was made since tracking began (see again_line).
  const std::vector<std::string>& record() const { return record_; }

  // For widgets to read.
  QProperty<bool> is_offered{false};    ///< there is a live organ to be registered again
  QProperty<bool> is_running{false};    ///< one is on its way
  QProperty<bool> can_exchange{false};  ///< another registration is there, not a refused one
  QProperty<bool> is_former{false};     ///< the other one is the one that there was before
  QProperty<QString> said, tone;

 private:
  void read_case();
  void read_other();
  void finish(const engine::Outcome& outcome);
  void end_registering(const engine::Outcome& outcome);
  void end_exchange(const engine::Outcome& outcome);
  void tell_record(bool is_taken);
  void say(const QString& text, const QString& how = {});
  const engine::OtherRegistration* other() const;

  EngineBridge& engine_;
  PlaybackModel& playback_;
  Couplings couplings_;
  std::optional<engine::CommandId> registering_, exchanging_;
  std::vector<std::string> record_;
  std::uint64_t said_of_ = 0;  ///< the case's number
  registration::Method method_ = registration::Method::automatic;
};

}  // namespace glisson::ui
