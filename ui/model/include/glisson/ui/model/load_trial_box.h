// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QWidget>
#include <optional>

#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/linked_views.h"

class QLabel;
class QPushButton;
class QShortcut;

namespace glisson::ui {

/// "Try a load": while it is on, a point of the liver that is pressed in the 3D view can be dragged, in the
/// plane that faces the viewer, and the organ follows as the engine computes it. Nothing of the case changes;
/// when it ends the rest shape is drawn again. Presses beside the liver, and the other buttons, move the
/// camera as always.
class LoadTrialBox : public QWidget {
  Q_OBJECT
 public:
  LoadTrialBox(EngineBridge& engine, LinkedViews& views, QWidget* parent = nullptr);

  bool is_on() const { return on_; }
  QPushButton* button() const { return button_; }
  /// Ends a trial that is on, with a sentence that says why (may be empty).
  void end(const QString& why = {}, bool is_problem = false);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void begin();
  void take(const engine::Outcome& outcome);
  void show_trial();
  void show_figures(const engine::TrialState& trial);
  void show_message(const QString& sentence, bool is_problem);
  bool grab(const QPointF& at);
  void drag(const QPointF& at);
  void let_go();
  void draw(const engine::TrialState& trial);
  Eigen::Vector2d place(const QPointF& at) const;

  EngineBridge& engine_;
  LinkedViews& views_;
  QPushButton* button_ = nullptr;
  QLabel* message_ = nullptr;
  QLabel* rate_ = nullptr;
  QLabel* load_ = nullptr;
  QLabel* force_ = nullptr;  ///< in the 3D view, beside what pulls
  QShortcut* escape_ = nullptr;
  bool on_ = false, started_ = false;
  engine::CommandId start_ = 0;
  std::optional<engine::TrialPull> pull_;  ///< while a point is held
};

}  // namespace glisson::ui
