// SPDX-License-Identifier: GPL-3.0-or-later
// Where the panel's pictures come from: the dialogs.
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>

#include "glisson/core/error.h"
#include "glisson/engine/commands/load_stereo_pair.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/source.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/save_name.h"
#include "glisson/ui/stereo/calibration_dialog.h"
#include "glisson/ui/stereo/source_dialog.h"
#include "glisson/ui/stereo/stereo_panel.h"

namespace glisson::ui {
namespace {

QString pictures_filter() { return StereoPanel::tr("Pictures (*.png *.jpg *.jpeg *.bmp *.tif *.tiff)"); }
QString videos_filter() { return StereoPanel::tr("Videos (*.mkv *.mp4 *.avi *.mov)"); }

}  // namespace

void StereoPanel::fill_source_menu(QMenu* menu) {
  menu->addAction(tr("Stereo pair…"), this, &StereoPanel::open_pair);
  menu->addAction(tr("Video, side by side…"), this, &StereoPanel::open_video);
  menu->addAction(tr("Two videos…"), this, &StereoPanel::open_two_videos);
  menu->addAction(tr("Folder of pairs…"), this, &StereoPanel::open_folder);
  menu->addAction(tr("Live device…"), this, &StereoPanel::open_device);
  menu->addAction(tr("OpenIGTLink server…"), this, &StereoPanel::open_server);
  menu->addSeparator();
  menu->addAction(tr("Other arrangement…"), this, &StereoPanel::describe_source);
}

void StereoPanel::open_calibration() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Calibration"), {}, tr("OpenCV YAML (*.yml *.yaml)"));
  if (!path.isEmpty()) engine().post(engine::SetCalibration{path.toStdString()});
}

void StereoPanel::open_text_calibration() {
  const QString path =
      QFileDialog::getExistingDirectory(this, tr("Folder of 3 × 3 and 4 × 4 text files, millimetres"));
  if (!path.isEmpty()) engine().post(engine::SetCalibration{path.toStdString()});
}

void StereoPanel::calibrate_from_boards() {
  auto* dialog = new CalibrationDialog(engine(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();  // does not stop the window
}

void StereoPanel::save_calibration() {
  const auto rig = engine().state()[part::rig];
  const QString path =
      ask_where_to_save(this, tr("Save the calibration"), QStringLiteral("calibration.yaml"),
                        tr("OpenCV YAML (*.yml *.yaml)"), {QStringLiteral(".yaml"), QStringLiteral(".yml")});
  if (path.isEmpty() || !rig) return;
  try {
    stereo::write_calibration(path.toStdString(), *rig);
  } catch (const Error& error) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, tr("Glisson"), error_text(error.what()), QMessageBox::Ok, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();  // does not stop the window
  }
}

void StereoPanel::open_pair() {
  const QString left = QFileDialog::getOpenFileName(this, tr("Left picture"), {}, pictures_filter());
  if (left.isEmpty()) return;
  const QString right =
      QFileDialog::getOpenFileName(this, tr("Right picture"), QFileInfo(left).path(), pictures_filter());
  if (!right.isEmpty()) engine().post(engine::LoadStereoPair{left.toStdString(), right.toStdString(), {}});
}

void StereoPanel::open_source(const engine::SetVideo& source) {
  opening_ = engine().post(source);  // its first frame follows where it can be opened
}

void StereoPanel::open_video() {
  const QString path =
      QFileDialog::getOpenFileName(this, tr("Stereo video, both views side by side"), {}, videos_filter());
  if (!path.isEmpty()) open_source({path.toStdString(), {}});
}

void StereoPanel::open_two_videos() {
  const QString left =
      QFileDialog::getOpenFileName(this, tr("Video of the left camera"), {}, videos_filter());
  if (left.isEmpty()) return;
  const QString right = QFileDialog::getOpenFileName(this, tr("Video of the right camera"),
                                                     QFileInfo(left).path(), videos_filter());
  if (!right.isEmpty()) open_source({left.toStdString(), right.toStdString()});
}

void StereoPanel::open_folder() {
  const QString path = QFileDialog::getExistingDirectory(this, tr("Folder of left and right pictures"));
  if (!path.isEmpty()) open_source({path.toStdString(), {}});
}

void StereoPanel::open_device() {
  bool chosen = false;
  const int number =
      QInputDialog::getInt(this, tr("Live device"), tr("Number of the video device"), 0, 0, 63, 1, &chosen);
  if (chosen) open_source({stereo::device_source(std::to_string(number)), {}});
}

void StereoPanel::open_server() {
  bool chosen = false;
  const QString text = QInputDialog::getText(
      this, tr("OpenIGTLink server"),
      tr("Address and port of PLUS or another server, and its devices of the left and the right picture"),
      QLineEdit::Normal, QStringLiteral("127.0.0.1:18944/Left,Right"), &chosen);
  if (chosen) open_source({stereo::igtl_source(text.trimmed().toStdString()), {}});
}

void StereoPanel::describe_source() {
  auto* dialog = new SourceDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SourceDialog::described, this, [this](const QString& file) {
    open_source({file.toStdString(), {}});
  });
  dialog->open();  // does not stop the window
}

}  // namespace glisson::ui
