// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/shell/series_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "glisson/ui/common/series_texts.h"

namespace glisson::ui {
namespace {

constexpr int kPicture = 72;  ///< pixels a side
enum Column { name, phase, slices, spacing, date, remark, column_count };

/// On black, in the shape that the slice has in the patient.
QPixmap pixmap_of(const SeriesPicture& picture) {
  QPixmap all(kPicture, kPicture);
  all.fill(Qt::black);
  if (picture.grey.empty()) return all;
  const QImage grey(picture.grey.data(), picture.width, picture.height, picture.width,
                    QImage::Format_Grayscale8);
  const double width = picture.width, height = picture.height * picture.pixel_aspect;
  const double scale = kPicture / std::max(width, height);
  const QRectF place(0.5 * (kPicture - scale * width), 0.5 * (kPicture - scale * height), scale * width,
                     scale * height);
  QPainter painter(&all);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place, grey);
  return all;
}

QString patient_of(const DicomSeries& series) {
  const QString patient = QString::fromStdString(series.patient),
                id = QString::fromStdString(series.patient_id);
  if (patient.isEmpty()) return id;
  return id.isEmpty() || id == patient ? patient : patient + QStringLiteral(" (%1)").arg(id);
}

QString in_lines(const QStringList& parts) {
  QStringList said;
  for (const QString& part : parts)
    if (!part.isEmpty()) said << part;
  return said.join(QLatin1Char('\n'));
}

}  // namespace

SeriesDialog::SeriesDialog(std::vector<DicomSeries> series, QWidget* parent)
    : QDialog(parent), series_(std::move(series)) {
  setObjectName(QStringLiteral("choose_series"));
  setWindowTitle(tr("Several series"));
  build();
}

std::string SeriesDialog::chosen_uid() const {
  QTreeWidgetItem* item = list_->currentItem();
  if (item == nullptr || !item->flags().testFlag(Qt::ItemIsEnabled)) return {};
  return series_[static_cast<std::size_t>(list_->indexOfTopLevelItem(item))].uid;
}

bool SeriesDialog::is_one_patient() const {
  return std::ranges::all_of(series_, [this](const DicomSeries& each) {
    return each.patient == series_.front().patient && each.patient_id == series_.front().patient_id;
  });
}

void SeriesDialog::build() {
  auto* layout = new QVBoxLayout(this);
  auto* text = new QLabel(tr("This folder holds %n series. Which one shows the liver in the portal venous "
                             "phase? The likeliest is "
                             "at the top.",
                             nullptr, static_cast<int>(series_.size())),
                          this);
  text->setWordWrap(true);
  layout->addWidget(text);
  if (!series_.empty() && is_one_patient() && !patient_of(series_.front()).isEmpty()) {
    auto* patient = new QLabel(tr("Patient: %1").arg(patient_of(series_.front())), this);
    patient->setObjectName(QStringLiteral("series_patient"));
    patient->setTextFormat(Qt::PlainText);
    layout->addWidget(patient);
  }
  list_ = new QTreeWidget(this);
  list_->setObjectName(QStringLiteral("series"));
  list_->setColumnCount(column_count);
  list_->setHeaderLabels(
      {tr("Series"), tr("Phase"), tr("Slices"), tr("Pixels and spacing"), tr("Date"), tr("Remarks")});
  list_->setRootIsDecorated(false);
  list_->setAllColumnsShowFocus(true);
  list_->setIconSize({kPicture, kPicture});
  list_->setWordWrap(true);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  for (std::size_t n = 0; n < series_.size(); ++n) add_row(series_[n], n == 0);
  bool has_phases = false;
  for (int row = 0; row < list_->topLevelItemCount(); ++row)
    has_phases = has_phases || !list_->topLevelItem(row)->text(phase).isEmpty();
  list_->setColumnHidden(phase, !has_phases);
  list_->header()->setStretchLastSection(true);
  for (const int column : {phase, slices, date}) list_->resizeColumnToContents(column);
  list_->setColumnWidth(name, 330);
  list_->setColumnWidth(spacing, 190);
  layout->addWidget(list_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  layout->addWidget(buttons);
  QPushButton* open = buttons->button(QDialogButtonBox::Open);
  open->setDefault(true);
  const auto follow = [this, open] { open->setEnabled(!chosen_uid().empty()); };
  connect(list_, &QTreeWidget::currentItemChanged, this, follow);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, [this] {
    if (!chosen_uid().empty()) accept();
  });
  for (int row = 0; row < list_->topLevelItemCount() && chosen_uid().empty(); ++row)
    if (list_->topLevelItem(row)->flags().testFlag(Qt::ItemIsEnabled))
      list_->setCurrentItem(list_->topLevelItem(row));
  follow();
  resize(1120, 560);
}

void SeriesDialog::add_row(const DicomSeries& series, bool likeliest) {
  auto* row = new QTreeWidgetItem(list_);
  const QString modality = QString::fromStdString(series.modality);
  const QString number = QString::fromStdString(series.number);
  QIcon icon;
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected})
    icon.addPixmap(pixmap_of(series.picture), mode);
  row->setIcon(name, icon);
  row->setText(name, in_lines({description_text(series),
                               number.isEmpty()     ? modality
                               : modality.isEmpty() ? tr("series %1").arg(number)
                                                    : tr("%1, series %2").arg(modality, number),
                               is_one_patient() ? QString() : patient_of(series)}));
  row->setText(phase, in_lines({phase_text(phase_of(series)),
                                series.contrast_agent ? tr("contrast agent") : QString()}));
  row->setText(slices, QString::number(series.slices));
  row->setTextAlignment(slices, Qt::AlignRight | Qt::AlignVCenter);
  row->setText(spacing,
               in_lines({series.pixels.minCoeff() > 0
                             ? QStringLiteral("%1 × %2").arg(series.pixels.x()).arg(series.pixels.y())
                             : QString(),
                         spacing_text(series)}));
  row->setText(date, QString::fromStdString(series.date));
  const QString doubts = doubts_text(series);
  row->setText(remark, doubts.isEmpty() && likeliest ? tr("likeliest") : doubts);
  for (int column = 0; column < column_count; ++column) row->setToolTip(column, row->text(column));
  if (!can_be_read(series)) row->setFlags(row->flags() & ~(Qt::ItemIsEnabled | Qt::ItemIsSelectable));
}

}  // namespace glisson::ui
