// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/source_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "glisson/core/error.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/save_name.h"

namespace glisson::ui {

SourceDialog::SourceDialog(QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Arrangement of a stereo source"));
  setMinimumWidth(520);
  auto* form = new QFormLayout(this);
  form->setLabelAlignment(Qt::AlignLeft);
  form->addRow(make_explanation(
      tr("What is said here is written into a small file, by which this source can be opened again."), this));
  layout_ = new QComboBox(this);
  layout_->setObjectName(QStringLiteral("source_layout"));
  layout_->addItem(tr("Side by side"), static_cast<int>(stereo::Layout::side_by_side));
  layout_->addItem(tr("One above the other"), static_cast<int>(stereo::Layout::top_bottom));
  layout_->addItem(tr("Row by row"), static_cast<int>(stereo::Layout::row_interleaved));
  layout_->addItem(tr("Two sources"), static_cast<int>(stereo::Layout::separate));
  form->addRow(tr("Views"), layout_);
  const auto add_source = [&](const QString& name, const QString& object, QPushButton*& button) {
    auto* row = new QHBoxLayout;
    auto* line = new QLineEdit(this);
    line->setObjectName(object);
    line->setPlaceholderText(tr("video, folder of pictures, or device:0"));
    button = new QPushButton(tr("Choose…"), this);
    row->addWidget(line, 1);
    row->addWidget(button);
    form->addRow(name, row);
    connect(button, &QPushButton::clicked, this, [this, line] { choose(line); });
    connect(line, &QLineEdit::textChanged, this, &SourceDialog::show_state);
    return line;
  };
  QPushButton* choose_left = nullptr;
  left_ = add_source(tr("Source"), QStringLiteral("source_left"), choose_left);
  right_ = add_source(tr("Right source"), QStringLiteral("source_right"), choose_right_);
  right_first_ = new QCheckBox(tr("The right view comes first"), this);
  right_first_->setObjectName(QStringLiteral("source_right_first"));
  form->addRow(QString(), right_first_);
  interlaced_ = new QCheckBox(tr("Interlaced: use the first field only"), this);
  interlaced_->setObjectName(QStringLiteral("source_interlaced"));
  form->addRow(QString(), interlaced_);
  auto* crop = new QHBoxLayout;
  const QString names[] = {tr("x "), tr("y "), tr("width "), tr("height ")};
  for (int i = 0; i < 4; ++i) {
    crop_[i] = new QSpinBox(this);
    crop_[i]->setRange(0, 16384);
    crop_[i]->setPrefix(names[i]);
    crop_[i]->setToolTip(tr("Pixels of each view that are kept; a width or height of 0: all"));
    crop->addWidget(crop_[i]);
  }
  form->addRow(tr("Crop"), crop);
  problem_ = new QLabel(this);
  problem_->setWordWrap(true);
  set_style_property(problem_, "role", "error");
  problem_->hide();
  form->addRow(problem_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  save_ = buttons->addButton(tr("Save and open…"), QDialogButtonBox::AcceptRole);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &SourceDialog::ask_where);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(layout_, &QComboBox::currentIndexChanged, this, &SourceDialog::show_state);
  show_state();
}

stereo::SourceOptions SourceDialog::options() const {
  stereo::SourceOptions options;
  options.layout = static_cast<stereo::Layout>(layout_->currentData().toInt());
  options.left = left_->text().trimmed().toStdString();
  if (options.layout == stereo::Layout::separate) options.right = right_->text().trimmed().toStdString();
  options.right_first = right_first_->isChecked();
  options.deinterlace = interlaced_->isChecked();
  options.crop = {crop_[0]->value(), crop_[1]->value(), crop_[2]->value(), crop_[3]->value()};
  return options;
}

bool SourceDialog::save_as(const QString& file) {
  try {
    const stereo::SourceOptions wanted = options();
    wanted.validate();
    stereo::write_source(file.toStdString(), wanted);
  } catch (const Error& error) {
    problem_->setText(error_text(error.what()));
    problem_->show();
    return false;
  }
  emit described(file);
  accept();
  return true;
}

void SourceDialog::choose(QLineEdit* line) {
  const QString path = QFileDialog::getOpenFileName(this, tr("Stereo source"), {},
                                                    tr("Videos (*.mkv *.mp4 *.avi *.mov);;All files (*)"));
  if (!path.isEmpty()) line->setText(path);
}

void SourceDialog::ask_where() {
  const QFileInfo source(left_->text());
  const QString file =
      ask_where_to_save(this, tr("Save the description"),
                        source.dir().filePath(source.completeBaseName() + QStringLiteral(".json")),
                        tr("Stereo source (*.json)"), {QStringLiteral(".json")});
  if (!file.isEmpty()) save_as(file);
}

void SourceDialog::show_state() {
  const bool separate = layout_->currentData().toInt() == static_cast<int>(stereo::Layout::separate);
  right_->setEnabled(separate);
  choose_right_->setEnabled(separate);
  save_->setEnabled(!left_->text().trimmed().isEmpty() && (!separate || !right_->text().trimmed().isEmpty()));
}

}  // namespace glisson::ui
