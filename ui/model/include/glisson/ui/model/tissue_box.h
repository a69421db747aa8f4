// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <optional>

#include "glisson/engine/parts/model.h"
#include "glisson/fem/tissue.h"
#include "glisson/ui/common/engine_bridge.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace glisson::ui {

/// How stiff the parenchyma and each lesion of the case's model are. What is chosen goes to the case at once.
class TissueBox : public QWidget {
  Q_OBJECT
 public:
  explicit TissueBox(EngineBridge& engine, QWidget* parent = nullptr);

 private:
  /// A choice, and a number where it is by value.
  struct Row {
    QComboBox* choice = nullptr;
    QDoubleSpinBox* kilopascals = nullptr;
  };
  Row add_row(const QString& name, const QString& object, const QStringList& choices);
  void show_case();
  void show_rows();
  void show_values(const fem::Tissue& tissue);
  void post();
  fem::Tissue chosen() const;

  EngineBridge& engine_;
  QFormLayout* form_ = nullptr;
  QLabel* notes_ = nullptr;
  std::optional<engine::CommandId> posted_;  ///< the newest: its notes are shown
  Row parenchyma_;
  std::map<Label, Row> lesions_;
  std::shared_ptr<const model::BuiltModel> shown_;
  std::shared_ptr<const fem::Tissue> shown_tissue_;
  fem::Tissue shown_values_;  ///< to the bit, which the boxes for numbers round
};

}  // namespace glisson::ui
