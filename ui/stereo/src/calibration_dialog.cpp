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
#include <QSpinBox>
#include <cmath>

#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

constexpr double kMillimetre = 1e-3;

QString pixels(const engine::Outcome& outcome, const char* figure) {
  const auto found = outcome.figures.find(figure);
  if (found == outcome.figures.end() || !std::isfinite(found->second)) return QStringLiteral("–");
  return CalibrationDialog::tr("%1 px").arg(found->second, 0, 'f', 2);
}

}  // namespace

CalibrationDialog::CalibrationDialog(EngineBridge& engine, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Calibrate from boards"));
  setMinimumWidth(480);
  auto* form = new QFormLayout(this);
  form->setLabelAlignment(Qt::AlignLeft);
  form->addRow(
      make_explanation(tr("Ten pairs of pictures or more of a chessboard or a ChArUco board, near and "
                          "far, slanted to all sides, up to the pictures' borders."),
                       this));
  auto* row = new QHBoxLayout;
  folder_ = new QLineEdit(this);
  folder_->setObjectName(QStringLiteral("board_folder"));
  folder_->setPlaceholderText(tr("folder of left and right pictures"));
  auto* choose = new QPushButton(tr("Choose…"), this);
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
    auto* box = new QDoubleSpinBox(this);
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
  run_ = new TaskButton(
      engine, tr("Calibrate"), [this] { return engine::Command(command()); }, this);
  run_->setObjectName(QStringLiteral("calibrate"));
  form->addRow(run_);
  figures_ = new FiguresTable(this);
  form->addRow(figures_);
  notes_ = new QLabel(this);
  notes_->setWordWrap(true);
  set_style_property(notes_, "role", "muted");
  form->addRow(notes_);
  notes_->hide();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(choose, &QPushButton::clicked, this, &CalibrationDialog::choose_folder);
  connect(folder_, &QLineEdit::textChanged, this, &CalibrationDialog::show_state);
  connect(kind_, &QComboBox::currentIndexChanged, this, &CalibrationDialog::show_state);
  connect(run_, &TaskButton::done, this, &CalibrationDialog::show_outcome);
  show_state();
}

engine::CalibrateRig CalibrationDialog::command() const {
  engine::CalibrateRig command;
  command.left = folder_->text().trimmed().toStdString();
  command.board.columns = columns_->value();
  command.board.rows = rows_->value();
  command.board.square = square_->value() * kMillimetre;
  command.board.dictionary = kind_->currentData().toString().toStdString();
  if (command.board.charuco()) command.board.marker = marker_->value() * kMillimetre;
  command.options.drop_outliers = true;
  return command;
}

void CalibrationDialog::choose_folder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Folder of left and right pictures"));
  if (!path.isEmpty()) folder_->setText(path);
}

void CalibrationDialog::show_state() {
  marker_->setEnabled(!kind_->currentData().toString().isEmpty());
  run_->set_obstacle(folder_->text().trimmed().isEmpty() ? tr("Choose the folder of pictures first.")
                                                         : QString());
}

void CalibrationDialog::show_outcome(const engine::Outcome& outcome) {
  std::vector<std::pair<QString, QString>> rows;
  if (outcome.status == engine::Status::done) {
    const auto figure = [&](const char* name) {
      const auto found = outcome.figures.find(name);
      return found == outcome.figures.end() ? 0.0 : found->second;
    };
    rows = {{tr("Views used"), tr("%1 of %2 pairs")
                                   .arg(figure("calibration_views") - figure("calibration_outliers"))
                                   .arg(figure("calibration_pairs"))},
            {tr("Error, both cameras"), pixels(outcome, "calibration_rms_px")},
            {tr("Rows off, view left out"), pixels(outcome, "calibration_epipolar_left_out_px")},
            {tr("Picture covered"), tr("%1 % left, %2 % right")
                                        .arg(100.0 * figure("calibration_coverage_left"), 0, 'f', 0)
                                        .arg(100.0 * figure("calibration_coverage_right"), 0, 'f', 0)},
            {tr("Baseline"), tr("%1 mm").arg(figure("calibration_baseline_mm"), 0, 'f', 2)}};
  }
  figures_->set_rows(rows);
  notes_->setText(notes_text(outcome.notes));
  notes_->setVisible(!outcome.notes.empty());
}

}  // namespace glisson::ui
