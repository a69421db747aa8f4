// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <optional>

#include "glisson/engine/parts/operations.h"
#include "glisson/ui/common/engine_bridge.h"

class QMainWindow;

namespace glisson::ui {

/// Simulates operations on a new model while nobody waits for anything, so that its registration need not.
/// Other work comes first: it ends the simulation, which begins again once the program is idle. What a person
/// cancels or what fails is left alone until model, landmarks or tissue are others. A case that was opened
/// and not touched stays untouched.
class OperationsAhead : public QObject {
  Q_OBJECT
 public:
  /// @param window isWindowModified() says whether the case is worked on.
  OperationsAhead(EngineBridge& engine, QMainWindow& window);

  /// How long nothing must have changed; two seconds unless said.
  void set_pause(std::chrono::milliseconds pause);

 private:
  void begin();
  void make_way(const engine::CommandTraits& work);
  void take(const engine::Outcome& outcome);

  EngineBridge& engine_;
  QMainWindow& window_;
  QTimer timer_;
  bool posting_ = false;  ///< its own command: its post is told before it has a number
  bool makes_way_ = false;
  std::optional<engine::CommandId> running_;
  /// What they were not to be, or could not be, simulated on.
  std::shared_ptr<const model::BuiltModel> given_up_model_;
  std::shared_ptr<const Landmarks> given_up_landmarks_;
  std::shared_ptr<const fem::Tissue> given_up_tissue_;
};

}  // namespace glisson::ui
