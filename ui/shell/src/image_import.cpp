// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/image_import.h"

#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/list_series.h"
#include "glisson/engine/parts/image.h"
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

void ImageImport::start(const std::filesystem::path& path, bool new_case) {
  path_ = path;
  new_case_ = new_case;
  listing_.reset();
  if (may_hold_series(path))
    listing_ = engine_.post(engine::ListSeries{path});
  else
    importing_ = engine_.post(engine::ImportImage{path, {}, new_case_});
}

void ImageImport::take(const engine::Outcome& outcome) {
  if (importing_ == outcome.id) {
    importing_.reset();
    const auto& image = engine_.state()[engine::part::image];
    if (outcome.status == engine::Status::done && image && image->modality == Modality::other) ask_modality();
    return;
  }
  if (listing_ != outcome.id) return;
  listing_.reset();
  if (outcome.status != engine::Status::done) return;
  const auto series = outcome.result.as<engine::ListSeries::Result>();
  const auto images = series ? std::ranges::count_if(*series, &DicomSeries::images) : 0;
  if (images > 1)
    ask(*series);
  else
    engine_.post(engine::ImportImage{path_, {}, new_case_});
}

void ImageImport::ask_modality() {
  auto* box = new QMessageBox(QMessageBox::Question, tr("CT or MRI?"),
                              tr("%1 does not say whether it is a CT or an MRI.")
                                  .arg(QString::fromStdString(path_.filename().string())),
                              QMessageBox::NoButton, window_);
  box->setObjectName(QStringLiteral("modality_question"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, const char* name, Modality modality) {
    QPushButton* button = box->addButton(text, QMessageBox::AcceptRole);
    button->setObjectName(QLatin1String(name));
    connect(button, &QPushButton::clicked, this, [this, modality] {
      engine_.post(engine::ImportImage{path_, {}, new_case_, modality});
    });
  };
  add(tr("MRI"), "modality_mr", Modality::mr);
  add(tr("CT"), "modality_ct", Modality::ct);
  box->addButton(tr("Neither"), QMessageBox::RejectRole);
  box->open();  // does not stop the window
}

void ImageImport::ask(const std::vector<DicomSeries>& series) {
  auto* dialog = new SeriesDialog(series, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    if (const std::string uid = dialog->chosen_uid(); !uid.empty())
      engine_.post(engine::ImportImage{path_, uid, new_case_});
  });
  dialog->open();  // does not stop the window
}

}  // namespace glisson::ui
