// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>
#include <set>

#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/task_button.h"

class QPushButton;

namespace glisson::ui {

/// A person's own segmentation network: its file is chosen, then it labels the CT. Where that would change
/// what a hand has corrected, the person decides (OfferBox).
class NetworkBox : public QWidget {
  Q_OBJECT
 public:
  explicit NetworkBox(EngineBridge& engine, QWidget* parent = nullptr);

  /// The ONNX file, as if it had been chosen.
  void set_network(const std::filesystem::path& path);
  /// Labels that the network must leave as they are.
  void set_locked(const std::set<Label>& labels) { locked_ = labels; }

 private:
  void choose();
  engine::Command command() const;

  EngineBridge& engine_;
  std::filesystem::path network_;
  std::set<Label> locked_;
  QPushButton* choose_;
  TaskButton* run_;
};

}  // namespace glisson::ui
