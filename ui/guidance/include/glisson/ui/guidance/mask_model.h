// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <filesystem>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/guidance/playback_model.h"

namespace glisson::engine {
struct LiveState;
}

namespace glisson::ui {

/// The person's own network that says what of the live picture is not liver. It is chosen for this computer,
/// whatever the case, and stays chosen until it is removed.
class MaskModel : public QObject {
  Q_OBJECT
 public:
  /// Both outlive this.
  MaskModel(EngineBridge& engine, PlaybackModel& playback, QObject* parent = nullptr);

  /// Takes this network, at once where the organ is followed; one whose sheet cannot be used is not taken,
  /// and why is said.
  void choose(const std::filesystem::path& network);
  void remove();

  // For widgets to read.
  QProperty<QString> name;  ///< of the file; empty: none is chosen
  QProperty<QString> said, tone;

 private:
  void use(const QString& network);
  void read_live();
  void tell(const engine::LiveState& live);
  void say(const QString& text, const QString& how = {});

  EngineBridge& engine_;
  PlaybackModel& playback_;
  bool tells_live_ = false;  ///< what is said is of the live picture
  Couplings couplings_;
};

}  // namespace glisson::ui
