// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/image_import.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/list_series.h"

namespace glisson::ui {
namespace {

bool may_hold_series(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return std::filesystem::is_directory(path) || name.ends_with(".tar.gz") || name.ends_with(".tgz") ||
         name.ends_with(".tar");
}

QString line_of(const DicomSeries& series) {
  const QString name = series.description.empty() ? ImageImport::tr("no description")
                                                  : QString::fromStdString(series.description);
  return ImageImport::tr("%1  %2  %3 slices  (series %4)")
      .arg(QString::fromStdString(series.modality), name)
      .arg(series.slices)
      .arg(series.number.empty() ? QStringLiteral("?") : QString::fromStdString(series.number));
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
    engine_.post(engine::ImportImage{path, {}, new_case_});
}

void ImageImport::take(const engine::Outcome& outcome) {
  if (listing_ != outcome.id) return;
  listing_.reset();
  if (outcome.status != engine::Status::done) return;
  const auto series = outcome.result.as<engine::ListSeries::Result>();
  if (series && series->size() > 1)
    ask(*series);
  else
    engine_.post(engine::ImportImage{path_, {}, new_case_});
}

void ImageImport::ask(const std::vector<DicomSeries>& series) {
  auto* dialog = new QDialog(window_);
  dialog->setObjectName(QStringLiteral("choose_series"));
  dialog->setWindowTitle(tr("Several series"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  auto* layout = new QVBoxLayout(dialog);
  auto* text =
      new QLabel(tr("This folder holds %n series. Which one shows the liver in the portal venous phase?",
                    nullptr, static_cast<int>(series.size())),
                 dialog);
  text->setWordWrap(true);
  layout->addWidget(text);
  auto* list = new QListWidget(dialog);
  std::size_t largest = 0;
  for (std::size_t n = 0; n < series.size(); ++n) {
    list->addItem(line_of(series[n]));
    if (series[n].slices > series[largest].slices) largest = n;
  }
  list->setCurrentRow(static_cast<int>(largest));
  layout->addWidget(list);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, dialog);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  connect(list, &QListWidget::itemDoubleClicked, dialog, &QDialog::accept);
  connect(dialog, &QDialog::accepted, this, [this, list, series] {
    if (list->currentRow() >= 0)
      engine_.post(
          engine::ImportImage{path_, series[static_cast<std::size_t>(list->currentRow())].uid, new_case_});
  });
  dialog->resize(560, 320);
  dialog->open();  // does not stop the window
}

}  // namespace glisson::ui
