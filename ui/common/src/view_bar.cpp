// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/view_bar.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <cmath>

#include "glisson/ui/common/user_settings.h"

namespace glisson::ui {
namespace {

const auto kOwnLevel = QStringLiteral("views/own_window_level");
const auto kSlabThickness = QStringLiteral("views/slab_mm");
const auto kOwnWidth = QStringLiteral("views/own_window_width");

/// As the settings have it; the state's own default where they have none that is usable.
void read_own_window(ViewState& state) {
  const auto settings = user_settings();
  bool has_level = false, has_width = false;
  const GreyWindow kept{settings->value(kOwnLevel).toDouble(&has_level),
                        settings->value(kOwnWidth).toDouble(&has_width)};
  if (has_level && has_width && std::isfinite(kept.level) && std::isfinite(kept.width))
    state.set_own_window(kept);
}

void write_own_window(const ViewState& state) {
  const auto settings = user_settings();
  settings->setValue(kOwnLevel, state.own_window().level);
  settings->setValue(kOwnWidth, state.own_window().width);
}

const char* code_of(WindowPreset preset) {
  switch (preset) {
    case WindowPreset::abdomen:
      return "window_abdomen";
    case WindowPreset::liver:
      return "window_liver";
    case WindowPreset::vessels:
      return "window_vessels";
    case WindowPreset::lung:
      return "window_lung";
    case WindowPreset::bone:
      return "window_bone";
    case WindowPreset::own:
      return "window_own";
    case WindowPreset::whole:
      return "window_whole";
  }
  return "";
}

}  // namespace

ViewBar::ViewBar(ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setObjectName(QStringLiteral("view_bar"));
  setProperty("role", "viewbar");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->setSpacing(4);
  read_own_window(state_);
  build_windows();
  build_slab();
  build_measures();
  row->addStretch(1);
  build_layout();
  connect(&state_, &ViewState::window_kept, this, [this] { write_own_window(state_); });
  for (const auto signal : {&MeasureBook::changed, &MeasureBook::tool_changed})
    connect(&state_.measures(), signal, this, &ViewBar::show_state);
  for (const auto signal : {&ViewState::style_changed, &ViewState::volume_changed})
    connect(&state_, signal, this, &ViewBar::show_state);
  show_state();
}

QAction* ViewBar::add_action(const char* name, const QString& text, const QKeySequence& key,
                             const QString& explanation) {
  auto* action = new QAction(text, this);
  action->setObjectName(QString::fromLatin1(name));
  action->setShortcut(key);
  action->setToolTip(QStringLiteral("%1 (%2)").arg(explanation.isEmpty() ? text : explanation,
                                                   key.toString(QKeySequence::NativeText)));
  addAction(action);
  all_ << action;
  return action;
}

void ViewBar::add_line() {
  auto* line = new QAction(this);
  line->setSeparator(true);
  all_ << line;
}

QToolButton* ViewBar::add_button(QAction* action, const char* icon) {
  if (icon != nullptr)
    action->setIcon(QIcon(QStringLiteral(":/glisson/icons/%1.svg").arg(QLatin1String(icon))));
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setObjectName(action->objectName() + QStringLiteral("_button"));
  button->setAccessibleName(action->text());
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the views
  layout()->addWidget(button);
  return button;
}

void ViewBar::build_windows() {
  windows_ = new QToolButton(this);
  windows_->setObjectName(QStringLiteral("windows"));
  windows_->setPopupMode(QToolButton::InstantPopup);
  windows_->setFocusPolicy(Qt::TabFocus);
  windows_->setToolTip(tr("Which greys the slices show. Right drag in a slice changes them."));
  auto* menu = new QMenu(windows_);
  menu->setToolTipsVisible(true);
  windows_->setMenu(menu);
  layout()->addWidget(windows_);
  auto* group = new QActionGroup(this);
  int key = Qt::Key_F2;
  for (const WindowPreset preset : kWindowPresets) {
    QAction* action = add_action(code_of(preset), preset_text(preset), key++);
    action->setCheckable(true);
    group->addAction(action);
    menu->addAction(action);
    presets_[preset] = action;
    connect(action, &QAction::triggered, this, [this, preset] { state_.set_preset(preset); });
  }
  no_hounsfield_ = new QAction(tr("Hounsfield windows need a CT: an MRI's greys have no unit"), this);
  no_hounsfield_->setObjectName(QStringLiteral("no_hounsfield"));
  no_hounsfield_->setEnabled(false);
  menu->addAction(no_hounsfield_);
  all_ << no_hounsfield_;
}

void ViewBar::build_slab() {
  add_line();
  slab_ = add_action("slab_mip", tr("MIP"), Qt::Key_F9,
                     tr("The brightest of a slab about the slice, for vessels. Labels, values and tools stay "
                        "those of the slice."));
  slab_->setCheckable(true);
  add_button(slab_);
  thickness_ = new QSpinBox(this);
  thickness_->setObjectName(QStringLiteral("slab_thickness"));
  thickness_->setRange(qRound(1e3 * ViewState::kThinnestSlab), qRound(1e3 * ViewState::kThickestSlab));
  thickness_->setSuffix(tr(" mm"));
  thickness_->setToolTip(tr("How thick the slab is; also Shift + wheel in a slice"));
  thickness_->setAccessibleName(thickness_->toolTip());
  thickness_->setFocusPolicy(Qt::StrongFocus);
  layout()->addWidget(thickness_);
  const auto kept = user_settings()->value(kSlabThickness);
  if (kept.isValid()) state_.set_slab_thickness(1e-3 * kept.toInt());
  connect(slab_, &QAction::triggered, &state_, &ViewState::set_shows_slab);
  connect(thickness_, &QSpinBox::valueChanged, this, [this](int millimetres) {
    state_.set_slab_thickness(1e-3 * millimetres);
    user_settings()->setValue(kSlabThickness, millimetres);
  });
}

void ViewBar::build_measures() {
  add_line();
  const auto add_tool = [this](MeasureTool tool, const char* name, const QString& text, Qt::Key key,
                               const QString& explanation) {
    QAction* action = measures_[tool] = add_action(name, text, key, explanation);
    action->setCheckable(true);
    add_button(action, name);
    connect(action, &QAction::triggered, this,
            [this, tool](bool on) { state_.measures().set_tool(on ? tool : MeasureTool::none); });
  };
  add_tool(MeasureTool::distance, "measure_distance", tr("Measure a distance"), Qt::Key_R,
           tr("Drag from place to place in a slice. Esc ends."));
  add_tool(
      MeasureTool::diameters, "measure_diameters", tr("Measure two diameters"), Qt::Key_C,
      tr("Drag along the longest diameter in a slice, then along another one that crosses it. Esc ends."));
  undo_measure_ = add_action("undo_measure", tr("Take the last measure back"), Qt::Key_Backspace);
  wipe_measures_ =
      add_action("wipe_measures", tr("Wipe all measures"), QKeySequence(Qt::SHIFT | Qt::Key_Backspace));
  for (QAction* action : {undo_measure_, wipe_measures_})
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connect(undo_measure_, &QAction::triggered, &state_.measures(), &MeasureBook::undo);
  connect(wipe_measures_, &QAction::triggered, &state_.measures(), &MeasureBook::wipe);
  add_button(wipe_measures_, "wipe");
}

void ViewBar::build_layout() {
  add_line();
  whole_ = add_action("whole_picture", tr("Whole picture"), Qt::Key_Home,
                      tr("Takes zoom and shift of the slices away"));
  // Lists and numbers have a use for this key.
  whole_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  alone_ = add_action("view_alone", tr("One view alone"), Qt::Key_F11,
                      tr("The view under the pointer fills the place of all, as after a double click; Esc "
                         "goes back"));
  alone_->setCheckable(true);
  add_button(whole_, "whole_picture");
  add_button(alone_, "view_alone");
}

void ViewBar::set_live(bool live) {
  live_ = live;
  show_state();
}

void ViewBar::show_state() {
  const bool has_image = state_.image() && !state_.image()->empty();
  for (const auto& [preset, action] : presets_) {
    action->setEnabled(live_ && has_image && state_.applies(preset));
    action->setChecked(preset == state_.preset());
  }
  for (const auto& [tool, action] : measures_) {
    action->setEnabled(live_ && has_image);
    action->setChecked(tool == state_.measures().tool());
  }
  for (QAction* action : {undo_measure_, wipe_measures_})
    action->setEnabled(live_ && !state_.measures().measures().empty());
  slab_->setEnabled(live_ && has_image);
  slab_->setChecked(state_.shows_slab());
  thickness_->setEnabled(has_image);
  const QSignalBlocker quiet(thickness_);
  thickness_->setValue(qRound(1e3 * state_.slab_thickness()));
  for (QAction* action : {whole_, alone_}) action->setEnabled(live_);
  no_hounsfield_->setVisible(has_image && !state_.applies(WindowPreset::abdomen));
  windows_->setEnabled(has_image);
  windows_->setText(tr("Window: %1").arg(preset_text(state_.preset())));
}

}  // namespace glisson::ui
