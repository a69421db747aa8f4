// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QWidget>
#include <functional>
#include <optional>

#include "glisson/ui/common/engine_bridge.h"

class QComboBox;
class QLabel;
class QPushButton;
class QStackedLayout;
class QVBoxLayout;

namespace glisson::ui {

/// How a step of the work stands, for the step bar and the panel's head.
enum class StepState { waiting, to_review, done, stale, refused, running };

/// One module of the window: controls on the right, and optionally a view of its own in the middle (otherwise
/// the linked slices stay).
class Panel : public QWidget {
  Q_OBJECT
 public:
  Panel(EngineBridge& engine, const QString& title, const QString& purpose, QWidget* parent = nullptr);

  const QString& title() const { return title_; }
  /// Shown in the middle of the window while this panel is open; null: the linked views.
  virtual QWidget* view() { return nullptr; }
  /// The panel comes to the front, or leaves it.
  virtual void activate() {}
  virtual void deactivate() {}
  StepState step_state() const { return step_state_; }
  /// Ends what the panel does beside the engine and must not be cut short.
  /// @return what a person waits for, until wound_up(); empty: there is nothing of the kind.
  virtual QString wind_up() { return {}; }

 signals:
  void wound_up(const QString& problem);  ///< empty: it went well
  void step_state_changed();

 protected:
  /// Where a panel puts its controls.
  QVBoxLayout* content() const { return content_; }
  /// A heading with a line of explanation (may be empty) above what follows.
  QVBoxLayout* add_section(const QString& heading, const QString& explanation = {});
  /// The part that this step makes: its state is the step's, which is `running` while a command that writes
  /// the part waits or runs. @param is_open whether a person has yet to look at what is current.
  void watch(engine::Part part, std::function<bool(const engine::CaseState&)> is_open = {});
  EngineBridge& engine() const { return engine_; }
  /// A button in place of the line on the panel's purpose, while a person has something to read that may lie
  /// below what is in sight; nothing moves by it. Its text is given by call_attention().
  QPushButton* add_attention(const QString& tip);
  /// Empty: the purpose again. @pre add_attention()
  void call_attention(const QString& text);

 private:
  void update_step_state();

  EngineBridge& engine_;
  QString title_;
  QVBoxLayout* content_;
  QLabel* chip_;
  QStackedLayout* purpose_;  ///< or what calls for attention
  QPushButton* attention_ = nullptr;
  std::optional<engine::Part> part_;
  std::function<bool(const engine::CaseState&)> is_open_;
  StepState step_state_ = StepState::waiting;
};

/// Sets a property that the style sheet reads, and lets it be read again.
void set_style_property(QWidget* widget, const char* name, const QVariant& value);
/// A disc of the structure's colour, for lists.
QIcon structure_icon(Label structure);
/// A label for explanations: small, grey, wrapped.
QLabel* make_explanation(const QString& text, QWidget* parent = nullptr);
/// A label for what a person must see before going on: amber, wrapped, hidden while it is empty.
QLabel* make_warning(QWidget* parent);
void show_warning(QLabel& warning, const QString& text);
/// A choice that fits its column: long texts are cut short in it and whole in its list.
QComboBox* make_narrow_combo(QWidget* parent);

}  // namespace glisson::ui
