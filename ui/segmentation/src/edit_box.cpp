// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/edit_box.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/number_box.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/edit_texts.h"
#include "glisson/ui/segmentation/tool_pages.h"

namespace glisson::ui {
namespace {

using Area = editing::EditableRegion::Area;

constexpr int kToolsInRow = 7;
constexpr std::size_t kVolumesTold = 8;  ///< of labels that a preview changes

QIcon icon(const std::string& name) {
  return QIcon(QStringLiteral(":/glisson/icons/%1.svg").arg(QString::fromStdString(name)));
}

QVBoxLayout* column_of(QWidget* widget) { return static_cast<QVBoxLayout*>(widget->layout()); }

QLabel* heading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setProperty("role", "heading");
  return label;
}

}  // namespace

EditBox::EditBox(EditSession& session, QWidget& page, QWidget* parent, const EditTools& tools)
    : QWidget(parent), session_(session), known_(tools) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  build_history();
  build_tools(page);
  column->addWidget(new ToolPages(session_, this, known_));
  build_confirmation(page);
  build_region();
  connect(&session_, &EditSession::tool_changed, this, &EditBox::show_tool);
  connect(&session_, &EditSession::settings_changed, this, &EditBox::show_tool);
  connect(&session_, &EditSession::settings_changed, this, &EditBox::show_region);
  connect(&session_, &EditSession::changed, this, &EditBox::show_state);
  connect(&session_, &EditSession::settings_wanted, this, &EditBox::take_typed);
  show_tool();
  show_region();
}

void EditBox::add_below_settings(QWidget* widget) {
  // What an edit does is said above it: a long list would push it out of sight.
  column_of(this)->insertWidget(column_of(this)->indexOf(outcome_) + 1, widget);
}

void EditBox::build_history() {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const auto make = [&](const char* name, const QList<QKeySequence>& keys, auto act) {
    auto* action = new QAction(icon(name), {}, this);
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, &session_, act);
    addAction(action);
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromLatin1(name));
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    row->addWidget(button);
    return std::pair(action, button);
  };
  std::tie(undo_, undo_button_) = make("undo", {QKeySequence(Qt::CTRL | Qt::Key_Z)}, &EditSession::undo);
  std::tie(redo_, redo_button_) =
      make("redo", {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
           &EditSession::redo);
  // The step's name takes the room that there is.
  undo_button_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  redo_button_->setToolButtonStyle(Qt::ToolButtonIconOnly);
  row->setStretch(0, 1);
  column_of(this)->addLayout(row);
}

void EditBox::build_tools(QWidget& page) {
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  int cell = 0;
  for (const EditTool tool : known_) {
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("tool_%1").arg(QString::fromStdString(tool->code)));
    button->setProperty("role", "tool");
    button->setCheckable(true);
    button->setIcon(icon("tool_" + tool->code));
    button->setIconSize({18, 18});
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const QString key(QLatin1Char(tool->key));
    button->setText(key);
    button->setToolTip(QStringLiteral("%1 (%2)").arg(tool_text(tool), key));
    button->setAccessibleName(tool_text(tool));
    const auto choose = [this, tool] {
      session_.set_tool(session_.tool() == tool ? nullptr : tool);
      show_tool();  // a button that is pressed again goes up
    };
    connect(button, &QToolButton::clicked, this, choose);
    auto* shortcut = new QShortcut(QKeySequence(key), &page);
    connect(shortcut, &QShortcut::activated, this, [this, tool] { session_.set_tool(tool); });
    grid->addWidget(button, cell / kToolsInRow, cell % kToolsInRow);
    tools_[tool] = button;
    ++cell;
  }
  column_of(this)->addLayout(grid);
  tool_name_ = heading({}, this);
  tool_name_->setObjectName(QStringLiteral("tool_name"));
  hint_ = make_explanation({}, this);
  column_of(this)->addWidget(tool_name_);
  column_of(this)->addWidget(hint_);
}

void EditBox::build_confirmation(QWidget& page) {
  confirmation_ = new QWidget(this);
  auto* row = new QHBoxLayout(confirmation_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  apply_ = new QPushButton(tr("Apply"), confirmation_);
  apply_->setObjectName(QStringLiteral("apply_edit"));
  apply_->setProperty("role", "run");
  apply_->setToolTip(tr("Enter"));
  preview_ = new QPushButton(tr("Preview"), confirmation_);
  preview_->setObjectName(QStringLiteral("preview_edit"));
  preview_->setToolTip(tr("Hatched in the slices: what would change"));
  cancel_ = new QPushButton(tr("Cancel"), confirmation_);
  cancel_->setObjectName(QStringLiteral("cancel_edit"));
  cancel_->setToolTip(tr("Esc"));
  row->addWidget(apply_, 2);
  row->addWidget(preview_, 1);
  row->addWidget(cancel_, 1);
  column_of(this)->addWidget(confirmation_);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  QSizePolicy keeps_its_place = progress_->sizePolicy();
  keeps_its_place.setRetainSizeWhenHidden(true);  // nothing below jumps under the pointer
  progress_->setSizePolicy(keeps_its_place);
  column_of(this)->addWidget(progress_);
  outcome_ = new QLabel(this);
  outcome_->setObjectName(QStringLiteral("edit_outcome"));
  outcome_->setWordWrap(true);
  column_of(this)->addWidget(outcome_);
  connect(apply_, &QPushButton::clicked, &session_, &EditSession::apply);
  connect(preview_, &QPushButton::clicked, &session_, &EditSession::preview);
  connect(cancel_, &QPushButton::clicked, &session_, &EditSession::cancel);
  for (const auto key : {Qt::Key_Return, Qt::Key_Enter}) {
    auto* shortcut = new QShortcut(key, &page);
    shortcut->setAutoRepeat(false);  // a margin would grow for as long as the key is held
    connect(shortcut, &QShortcut::activated, &session_, &EditSession::apply);
  }
}

void EditBox::build_region() {
  column_of(this)->addSpacing(4);
  column_of(this)->addWidget(heading(tr("Where tools may change anything"), this));
  auto* form = new QFormLayout;
  form->setVerticalSpacing(5);
  area_ = make_narrow_combo(this);
  area_->setObjectName(QStringLiteral("editable_area"));
  form->addRow(tr("Area"), area_);
  by_intensity_ = new QCheckBox(tr("Only these intensities"), this);
  by_intensity_->setObjectName(QStringLiteral("editable_by_intensity"));
  form->addRow(by_intensity_);
  intensities_ = new QWidget(this);
  auto* row = new QHBoxLayout(intensities_);
  row->setContentsMargins(0, 0, 0, 0);
  for (QDoubleSpinBox** box : {&low_, &high_}) {
    *box = new NumberBox(intensities_);
    (*box)->setRange(-2000.0, 5000.0);
    (*box)->setDecimals(0);
    (*box)->setSingleStep(5.0);
    (*box)->setKeyboardTracking(false);  // the ends push each other: not by the first digit of a number
    row->addWidget(*box, 1);
  }
  low_->setObjectName(QStringLiteral("editable_low"));
  high_->setObjectName(QStringLiteral("editable_high"));
  form->addRow(intensities_);
  column_of(this)->addLayout(form);
  connect(area_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index < 0) return;
    EditSettings next = session_.settings();
    const int choice = area_->itemData(index).toInt();
    next.region.area = static_cast<Area>(choice & 0xff);
    next.region.label = static_cast<Label>(choice >> 8);
    session_.set_settings(next);
  });
  connect(by_intensity_, &QCheckBox::toggled, this, [this](bool on) {
    EditSettings next = session_.settings();
    next.region.intensity =
        on ? std::optional(std::array<double, 2>{low_->value(), high_->value()}) : std::nullopt;
    session_.set_settings(next);
  });
  const auto set_range = [this](double low, double high) {
    EditSettings next = session_.settings();
    next.region.intensity = {low, high};
    session_.set_settings(next);
  };
  low_->setValue(0.0);
  high_->setValue(200.0);
  connect(low_, &QDoubleSpinBox::valueChanged, this,
          [this, set_range](double value) { set_range(value, std::max(value, high_->value())); });
  connect(high_, &QDoubleSpinBox::valueChanged, this,
          [this, set_range](double value) { set_range(std::min(value, low_->value()), value); });
}

void EditBox::take_typed() {
  auto* number = qobject_cast<QAbstractSpinBox*>(QApplication::focusWidget());
  if (number != nullptr && isAncestorOf(number)) number->interpretText();
}

void EditBox::show_tool() {
  for (const auto& [tool, button] : tools_) button->setChecked(tool == session_.tool());
  const EditTool tool = session_.tool();
  tool_name_->setText(tool == nullptr
                          ? tool_text(tool)
                          : tr("%1: %2").arg(tool_text(tool), structure_text(session_.settings().label)));
  hint_->setText(tool_hint(tool, session_.settings()));
  show_state();
}

void EditBox::show_region() {
  const editing::EditableRegion& region = session_.settings().region;
  const QSignalBlocker quiet_area(area_), quiet_check(by_intensity_), quiet_low(low_), quiet_high(high_);
  std::vector<std::pair<int, QString>> areas = {
      {static_cast<int>(Area::everywhere), tr("Everywhere")},
      {static_cast<int>(Area::unlabelled), tr("Nothing is overwritten")},
      {static_cast<int>(Area::labelled), tr("Inside any label")},
      {static_cast<int>(Area::inside_liver), tr("Inside the liver")}};
  std::vector<Label> labels = session_.present();
  if (region.area == Area::inside_label &&
      std::find(labels.begin(), labels.end(), region.label) == labels.end())
    labels.push_back(region.label);
  for (const Label label : labels)
    areas.emplace_back(static_cast<int>(Area::inside_label) + (int{label} << 8),
                       tr("Inside: %1").arg(structure_text(label)));
  bool same = area_->count() == static_cast<int>(areas.size());
  for (int i = 0; same && i < area_->count(); ++i)
    same = area_->itemData(i).toInt() == areas[static_cast<std::size_t>(i)].first;
  if (!same) {
    area_->clear();
    for (const auto& [choice, text] : areas) area_->addItem(text, choice);
  }
  const int label = region.area == Area::inside_label ? int{region.label} << 8 : 0;
  area_->setCurrentIndex(area_->findData(static_cast<int>(region.area) + label));
  by_intensity_->setChecked(region.intensity.has_value());
  intensities_->setVisible(region.intensity.has_value());
  for (QDoubleSpinBox* box : {low_, high_})
    show_suffix(*box, session_.shows_hounsfield() ? tr(" HU") : QString());
  const auto put = [](QDoubleSpinBox* box, double value) {
    if (std::abs(box->value() - value) > 0.5) box->setValue(value);  // who types is not interrupted
  };
  if (region.intensity) {
    put(low_, (*region.intensity)[0]);
    put(high_, (*region.intensity)[1]);
  }
}

QString EditBox::text_of(const BranchPreview::Shown& shown) const {
  if (!shown.problem.empty()) return error_text(shown.problem);
  const QString ml = QString::number(session_.ml_of(shown.result.voxels_changed), 'f', 2);
  QString text = foretold_text(session_.tool(), shown.edit.tool, ml);
  if (!shown.result.notes.empty()) text += QLatin1Char('\n') + notes_text(shown.result.notes);
  return text;
}

QString EditBox::volumes_text() const {
  QString text;
  std::size_t told = 0;
  const auto& changes = session_.volume_changes();
  for (const EditSession::VolumeChange& change : changes) {
    if (++told > kVolumesTold) break;
    const double before = session_.ml_of(change.before), after = session_.ml_of(change.after);
    const int digits = std::max(before, after) < 10.0 ? 2 : 1;
    text += QLatin1Char('\n') + tr("%1: %2 → %3 ml")
                                    .arg(structure_text(change.label))
                                    .arg(before, 0, 'f', digits)
                                    .arg(after, 0, 'f', digits);
  }
  if (changes.size() > kVolumesTold)
    text += QLatin1Char('\n') + tr("and %1 more").arg(changes.size() - kVolumesTold);
  return text;
}

void EditBox::show_state() {
  undo_->setEnabled(session_.is_active() && session_.can_undo());
  redo_->setEnabled(session_.is_active() && session_.can_redo());
  const auto& history = session_.history();
  const bool undo = history && history->can_undo(), redo = history && history->can_redo();
  undo_->setText(undo ? tr("Undo: %1").arg(step_text(history->undo_name(), known_)) : tr("Undo"));
  redo_->setText(redo ? tr("Redo: %1").arg(step_text(history->redo_name(), known_)) : tr("Redo"));
  undo_->setToolTip(undo_->text() + QStringLiteral(" (Ctrl+Z)"));
  redo_->setToolTip(redo_->text() + QStringLiteral(" (Ctrl+Shift+Z)"));
  show_region();

  const bool previewed = is_previewed(session_.tool(), session_.settings());
  const std::optional<double> progress = session_.progress();
  const EditObstacle obstacle = session_.obstacle();
  confirmation_->setVisible(previewed || progress.has_value());
  apply_->setVisible(previewed);
  preview_->setVisible(previewed);
  apply_->setEnabled(previewed && obstacle == EditObstacle::none);
  preview_->setEnabled(apply_->isEnabled() && !session_.shows_preview());
  cancel_->setEnabled(progress.has_value() || session_.shows_preview());
  progress_->setVisible(progress.has_value());
  if (progress) progress_->setValue(static_cast<int>(1000 * *progress));
  QString text;
  const char* role = "muted";
  if (session_.tool() != nullptr && obstacle != EditObstacle::none) {
    text = session_.why_not();
    role = "warning";
  } else if (!session_.problem().empty()) {
    text = error_text(session_.problem());
    role = "error";
  } else if (session_.shows_preview()) {
    const long voxels = session_.voxels_to_change();
    text = voxels == 0 ? tr("Nothing would change.")
                       : tr("%1 ml would change.").arg(session_.ml_of(voxels), 0, 'f', 2) + volumes_text();
  } else if (const auto branch = session_.branch()) {
    text = text_of(*branch);
  } else if (session_.clicked() > 0) {
    text = tr("Click the other end. Ctrl adds a point between, Esc drops the way.");
  } else {
    text = notes_text(session_.notes());
  }
  outcome_->setText(text);
  outcome_->setVisible(!text.isEmpty());
  set_style_property(outcome_, "role", QString::fromLatin1(role));
}

}  // namespace glisson::ui
