// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/recording_box.h"

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>

#include "box_layout.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/save_name.h"

namespace glisson::ui {

RecordingBox::RecordingBox(RecordingModel& model, QWidget* parent)
    : QWidget(parent), model_(model), button_(new QPushButton(this)) {
  button_->setObjectName(QStringLiteral("record"));
  auto* said = new QLabel(this);
  said->setObjectName(QStringLiteral("recording_said"));
  said->setWordWrap(true);
  auto* what = new QComboBox(this);
  what->setObjectName(QStringLiteral("recorded"));
  what->addItems({tr("Record the overlay"), tr("Record the raw views"), tr("Record both")});
  what->setToolTip(tr(
      "Raw views, side by side, can be followed again. What was known of each picture is written beside."));
  QVBoxLayout* box = make_box_layout(this);
  box->addWidget(what);
  box->addWidget(said);
  connect(what, &QComboBox::currentIndexChanged, this,
          [this](int index) { model_.what = static_cast<Recorded>(index); });
  couplings_.add(model_.is_recording, [what](bool is) { what->setEnabled(!is); });

  connect(button_, &QPushButton::clicked, this, &RecordingBox::toggle);
  couplings_.add(model_.is_offered, [this](bool is) { button_->setEnabled(is); });
  couplings_.add(model_.is_recording, [this](bool is) {
    button_->setText(is ? tr("Stop recording") : tr("Record…"));
    set_style_property(button_, "role", is ? "recording" : "");
  });
  couplings_.add(model_.said, [said](const QString& text) { said->setText(text); });
  couplings_.add(model_.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
}

void RecordingBox::toggle() {
  if (model_.is_recording) return model_.stop();
  const QString path = ask_where_to_save(this, tr("Record the live view"), QStringLiteral("overlay.mkv"),
                                         tr("Video (*.mkv)"), {QStringLiteral(".mkv")});
  if (path.isEmpty()) return;
  if (model_.is_offered) return model_.start(path);
  QMessageBox::warning(this, tr("Record the live view"),
                       tr("The video has ended meanwhile: nothing is recorded."));
}

}  // namespace glisson::ui
