// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <filesystem>
#include <optional>

#include "glisson/engine/recovery.h"
#include "glisson/engine/saved_image.h"
#include "glisson/ui/common/engine_bridge.h"

class QMainWindow;

namespace glisson::ui {

/// Keeps a copy of what is not saved, every two minutes, before long work and before the video is followed,
/// until it is saved or thrown away; and offers at the start what a program left that ended otherwise. A copy
/// is made beside the live loop, which does not wait for it.
class Autosaver : public QObject {
  Q_OBJECT
 public:
  /// @param window isWindowModified() says whether there is anything to keep.
  /// @param root where copies lie; see engine::recovery_root(). @throws FileError.
  Autosaver(EngineBridge& engine, QMainWindow& window, const std::filesystem::path& root);

  void set_period(std::chrono::milliseconds period);
  std::chrono::milliseconds period() const { return timer_.intervalAsDuration(); }
  /// Asks about each copy that was left behind, one after the other.
  void offer_recovery();

 private:
  void keep();
  void keep_before_long_work(const engine::CommandTraits& work);
  void take(const engine::Outcome& outcome);
  void forget_what_is_saved();
  void ask(const engine::Recoverable& copy);

  EngineBridge& engine_;
  QMainWindow& window_;
  std::filesystem::path root_;
  engine::RecoveryFolder folder_;
  std::shared_ptr<engine::SavedImage> saved_ = std::make_shared<engine::SavedImage>();
  QTimer timer_;
  engine::Editions kept_{}, keeping_{};  ///< of the copy, and of the one on its way
  bool posting_ = false;                 ///< a copy: its post is told before it has a number
  std::optional<engine::CommandId> copying_, recovering_;
  engine::Recoverable recovered_;
  std::vector<engine::Recoverable> offered_;
};

}  // namespace glisson::ui
