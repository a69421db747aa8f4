// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/calibration_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "glisson/engine/commands/calibrate_rig.h"
#include "glisson/ui/common/number_box.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

constexpr double kMillimetre = 1e-3;

constexpr int kFormWidth = 400;

/// A dialog that has grown is brought back over its window, and wholly onto the screen.
void centre_on_screen(QWidget& dialog) {
  const QRect room = dialog.screen()->availableGeometry();
  QRect place = dialog.frameGeometry();
  place.moveCenter(dialog.parentWidget() ? dialog.parentWidget()->window()->frameGeometry().center()
                                         : room.center());
  dialog.move(std::clamp(place.left(), room.left(), std::max(room.left(), room.right() - place.width())),
              std::clamp(place.top(), room.top(), std::max(room.top(), room.bottom() - place.height())));
}

QString pixels(double value) {
  return std::isfinite(value) ? CalibrationDialog::tr("%1 px").arg(value, 0, 'f', 2) : QStringLiteral("–");
}

}  // namespace

CalibrationDialog::CalibrationDialog(EngineBridge& engine, QWidget* parent) : TaskDialog(parent) {
  setWindowTitle(tr("Calibrate from boards"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(16);
  columns->addLayout(make_form(engine));
  results_ = new CalibrationResults(this);
  results_->hide();
  columns->addWidget(results_, 1);
  auto* box = new QVBoxLayout(this);
  box->addLayout(columns, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  box->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(folder_, &QLineEdit::textChanged, this, &CalibrationDialog::change_request);
  connect(kind_, &QComboBox::currentIndexChanged, this, &CalibrationDialog::change_request);
  for (QSpinBox* count : {columns_, rows_})
    connect(count, &QSpinBox::valueChanged, this, &CalibrationDialog::change_request);
  for (QDoubleSpinBox* length : {square_, marker_})
    connect(length, &QDoubleSpinBox::valueChanged, this, &CalibrationDialog::change_request);
  connect(results_, &CalibrationResults::ticks_changed, this, &CalibrationDialog::show_state);
  for (TaskButton* task : {run_, again_}) {
    come_back_for(*task);
    connect(task, &TaskButton::done, this, &CalibrationDialog::show_outcome);
  }
  connect(&engine, &EngineBridge::tasks_changed, this, &CalibrationDialog::show_state);
  show_state();
}

QWidget* CalibrationDialog::make_fields() {
  auto* fields = new QWidget(this);
  auto* form = new QFormLayout(fields);
  form->setContentsMargins({});
  form->setLabelAlignment(Qt::AlignLeft);
  auto* row = new QHBoxLayout;
  folder_ = new QLineEdit(this);
  folder_->setObjectName(QStringLiteral("board_folder"));
  folder_->setPlaceholderText(tr("folder of left and right pictures"));
  auto* choose = new QPushButton(tr("Choose…"), this);
  choose->setObjectName(QStringLiteral("choose_boards"));
  connect(choose, &QPushButton::clicked, this, &CalibrationDialog::choose_folder);
  row->addWidget(folder_, 1);
  row->addWidget(choose);
  form->addRow(tr("Pictures"), row);
  kind_ = new QComboBox(this);
  kind_->setObjectName(QStringLiteral("board_kind"));
  kind_->addItem(tr("Chessboard"), QString());
  for (const char* name : {"DICT_4X4_50", "DICT_5X5_50", "DICT_5X5_100", "DICT_6X6_50", "DICT_6X6_250"})
    kind_->addItem(tr("ChArUco, %1").arg(QLatin1String(name)), QString::fromLatin1(name));
  form->addRow(tr("Board"), kind_);
  auto* corners = new QHBoxLayout;
  const stereo::Board usual;
  const auto add_count = [&](int value, const QString& name) {
    auto* box = new QSpinBox(this);
    box->setRange(3, 50);
    box->setValue(value);
    box->setObjectName(name);
    corners->addWidget(box);
    return box;
  };
  columns_ = add_count(usual.columns, QStringLiteral("board_columns"));
  corners->addWidget(new QLabel(QStringLiteral("×"), this));
  rows_ = add_count(usual.rows, QStringLiteral("board_rows"));
  form->addRow(tr("Inner corners"), corners);
  const auto add_length = [&](const QString& label, double value, const QString& name) {
    auto* box = new NumberBox(this);
    box->setRange(0.1, 100.0);
    box->setDecimals(3);
    box->setSuffix(tr(" mm"));
    box->setValue(value);
    box->setObjectName(name);
    form->addRow(label, box);
    return box;
  };
  square_ = add_length(tr("Side of a square"), usual.square / kMillimetre, QStringLiteral("board_square"));
  marker_ =
      add_length(tr("Side of a marker"), 0.75 * usual.square / kMillimetre, QStringLiteral("board_marker"));
  return fields;
}

QLayout* CalibrationDialog::make_form(EngineBridge& engine) {
  auto* form = new QVBoxLayout;
  form->addWidget(
      make_explanation(tr("Ten pairs of pictures or more of a chessboard or a ChArUco board, near and "
                          "far, slanted to all sides, up to the pictures' borders."),
                       this));
  fields_ = make_fields();
  form->addWidget(fields_);
  run_ = new TaskButton(
      engine, tr("Calibrate"), [this] { return engine::Command(command()); }, this);
  run_->setObjectName(QStringLiteral("calibrate"));
  run_->setFixedWidth(kFormWidth);
  form->addWidget(run_);
  again_ = new TaskButton(
      engine, tr("Calibrate with the views ticked"),
      [this] {
        engine::CalibrateRig again = command();
        again.found = results_->sheet()->views;
        again.options.without = results_->unticked();
        return engine::Command(again);
      },
      this);
  again_->setObjectName(QStringLiteral("calibrate_again"));
  form->addWidget(again_);
  figures_ = new FiguresTable(this);
  form->addWidget(figures_);
  notes_ = new QLabel(this);
  notes_->setWordWrap(true);
  set_style_property(notes_, "role", "muted");
  form->addWidget(notes_);
  notes_->hide();
  form->addStretch(1);
  return form;
}

engine::CalibrateRig CalibrationDialog::command() const {
  engine::CalibrateRig command;
  command.search.left = folder_->text().trimmed().toStdString();
  stereo::Board& board = command.search.board;
  board.columns = columns_->value();
  board.rows = rows_->value();
  board.square = square_->value() * kMillimetre;
  board.dictionary = kind_->currentData().toString().toStdString();
  if (board.charuco()) board.marker = marker_->value() * kMillimetre;
  return command;
}

void CalibrationDialog::choose_folder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Folder of left and right pictures"));
  if (!path.isEmpty()) folder_->setText(path);
}

void CalibrationDialog::change_request() {
  if (results_->sheet()) results_->set_sheet(nullptr);
  figures_->clear();
  notes_->hide();
  show_state();
}

void CalibrationDialog::show_state() {
  // What comes out belongs to what was asked for.
  const bool is_running = run_->is_running() || again_->is_running();
  fields_->setDisabled(is_running);
  results_->setDisabled(is_running);
  marker_->setEnabled(!kind_->currentData().toString().isEmpty());
  run_->set_obstacle(folder_->text().trimmed().isEmpty() ? tr("Choose the folder of pictures first.")
                                                         : QString());
  again_->setVisible(results_->sheet() != nullptr);
  if (results_->sheet())
    again_->set_obstacle(results_->differs() ? QString()
                                             : tr("This is the calibration with the views ticked."));
}

void CalibrationDialog::show_outcome(const engine::Outcome& outcome) {
  show_state();
  const auto sheet = outcome.result.as<engine::CalibrationSheet>();
  if (outcome.status != engine::Status::done || !sheet) return;  // the button says why
  const stereo::Calibration& made = sheet->calibration;
  const stereo::BoardViews& views = *sheet->views;
  const auto used =
      std::count_if(made.views.begin(), made.views.end(), [](const auto& view) { return view.used; });
  figures_->set_rows({{tr("Views used"), tr("%1 of %2 pairs").arg(used).arg(views.pairs())},
                      {tr("Error, both cameras"), pixels(made.rms)},
                      {tr("Rows off, view left out"), pixels(made.epipolar_left_out)},
                      {tr("Picture covered"), tr("%1 % left, %2 % right")
                                                  .arg(100.0 * made.left_coverage, 0, 'f', 0)
                                                  .arg(100.0 * made.right_coverage, 0, 'f', 0)},
                      {tr("Baseline"), tr("%1 mm").arg(1e3 * made.rig.baseline(), 0, 'f', 2)}});
  QStringList lines;
  if (!outcome.notes.empty()) lines << notes_text(outcome.notes);
  if (views.too_alike() > 0)
    lines << tr("Views of the board that were not needed, because the others differ more: %1.")
                 .arg(views.too_alike());
  QStringList without;
  for (const std::string& name : views.not_found()) without << QString::fromStdString(name);
  if (!without.isEmpty())
    lines << tr("The board was not found in both pictures of: %1.").arg(without.join(QStringLiteral(", ")));
  notes_->setText(lines.join(QLatin1Char('\n')));
  notes_->setVisible(!lines.isEmpty());
  const bool first = !results_->sheet();
  results_->set_sheet(sheet);
  if (!first) return;
  adjustSize();
  centre_on_screen(*this);
}

}  // namespace glisson::ui
