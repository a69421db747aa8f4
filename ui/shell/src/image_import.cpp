// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/image_import.h"

#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "glisson/core/files.h"
#include "glisson/engine/commands/list_series.h"
#include "glisson/engine/commands/read_image.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/patient_held.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/shell/series_dialog.h"

namespace glisson::ui {
namespace {

bool may_hold_series(const std::filesystem::path& path) {
  const std::string name = lower_name(path);
  return std::filesystem::is_directory(path) || name.ends_with(".tar.gz") || name.ends_with(".tgz") ||
         name.ends_with(".tar") || name.ends_with(".zip") || name == "dicomdir";
}

}  // namespace

ImageImport::ImageImport(EngineBridge& engine, QWidget* window)
    : QObject(window), engine_(engine), window_(window) {
  connect(&engine_, &EngineBridge::finished, this, &ImageImport::take);
}

void ImageImport::start(const std::filesystem::path& path) {
  image_ = {path};
  listing_.reset();
  reading_.reset();
  if (may_hold_series(path))
    listing_ = engine_.post(engine::ListSeries{path});
  else
    read({});
}

void ImageImport::read(const std::string& series) {
  image_.series = series;
  // It waits with its question where a patient is still on the way.
  if (engine::holds_patient(engine_.state()) || is_case_to_come(engine_))
    reading_ = engine_.post(engine::ReadImage{image_.path, series});
  else
    finish(image_);
}

void ImageImport::finish(const engine::ImportImage& image) {
  imported_ = image;
  importing_ = engine_.post(image);
}

void ImageImport::take(const engine::Outcome& outcome) {
  const bool done = outcome.status == engine::Status::done;
  if (importing_ == outcome.id) {
    importing_.reset();
    const auto& image = engine_.state()[engine::part::image];
    if (done && image && image->modality == Modality::other) ask_modality();
    imported_.scan.reset();
  } else if (reading_ == outcome.id) {
    reading_.reset();
    if (!done) return;
    image_.scan = outcome.result.as<engine::ReadImage::Result>();
    emit found(std::exchange(image_, {}));
  } else if (listing_ == outcome.id) {
    listing_.reset();
    if (done) take_series(outcome);
  }
}

void ImageImport::take_series(const engine::Outcome& outcome) {
  const auto series = outcome.result.as<engine::ListSeries::Result>();
  const auto images = series ? std::ranges::count_if(*series, &DicomSeries::images) : 0;
  if (images > 1)
    ask(*series);
  else
    read({});
}

void ImageImport::ask_modality() {
  auto* box = new QMessageBox(QMessageBox::Question, tr("CT or MRI?"),
                              tr("%1 does not say whether it is a CT or an MRI.")
                                  .arg(QString::fromStdString(imported_.path.filename().string())),
                              QMessageBox::NoButton, window_);
  box->setObjectName(QStringLiteral("modality_question"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, const char* name, Modality modality) {
    QPushButton* button = box->addButton(text, QMessageBox::AcceptRole);
    button->setObjectName(QLatin1String(name));
    connect(button, &QPushButton::clicked, this, [this, image = imported_, modality]() mutable {
      image.new_case = false;  // it is that already
      image.modality = modality;
      engine_.post(image);
    });
  };
  // What is said is of the image that is open: where another comes meanwhile, the question goes.
  connect(&engine_, &EngineBridge::case_changed, box,
          [this, box, asked = engine_.state()[engine::part::image]] {
            if (engine_.state()[engine::part::image] != asked) box->reject();
          });
  add(tr("MRI"), "modality_mr", Modality::mr);
  add(tr("CT"), "modality_ct", Modality::ct);
  box->addButton(tr("Neither"), QMessageBox::RejectRole);
  box->open();  // does not stop the window
}

void ImageImport::ask(const std::vector<DicomSeries>& series) {
  auto* dialog = new SeriesDialog(series, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, path = image_.path] {
    image_ = {path};
    if (const std::string uid = dialog->chosen_uid(); !uid.empty()) read(uid);
  });
  dialog->open();  // does not stop the window
}

}  // namespace glisson::ui
