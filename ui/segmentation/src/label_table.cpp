// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/label_table.h"

#include <QHeaderView>
#include <QMenu>
#include <cmath>

#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/edit_texts.h"

namespace glisson::ui {
namespace {

constexpr int kIconColumn = 21, kFigureColumn = 42, kIntensityColumn = 41, kRowsInSight = 8;

QIcon icon(const char* name) {
  return QIcon(QStringLiteral(":/glisson/icons/%1.svg").arg(QLatin1String(name)));
}

QIcon review_icon(ReviewState state) {
  switch (state) {
    case ReviewState::not_started:
      break;
    case ReviewState::in_progress:
      return icon("review_in_progress");
    case ReviewState::to_review:
      return icon("review_to_review");
    case ReviewState::approved:
      return icon("review_approved");
  }
  return icon("review_not_started");
}

constexpr std::array<ReviewState, 4> kStates = {ReviewState::not_started, ReviewState::in_progress,
                                                ReviewState::to_review, ReviewState::approved};

Label label_of(const QTreeWidgetItem* item) {
  return static_cast<Label>(item->data(LabelTable::name, Qt::UserRole).toUInt());
}

}  // namespace

LabelTable::LabelTable(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("label_table"));
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setAllColumnsShowFocus(true);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setIconSize({14, 14});
  setHeaderLabels({tr("Label"), {}, {}, {}, tr("ml"), tr("HU"), tr("⌀ mm")});
  headerItem()->setToolTip(volume, tr("Volume"));
  headerItem()->setToolTip(intensity, tr("Mean intensity"));
  headerItem()->setToolTip(diameter, tr("Longest diameter of a lesion"));
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(20);
  header()->setSectionsClickable(false);
  header()->setSectionResizeMode(name, QHeaderView::Stretch);
  for (const int column : {shown, locked, review}) {
    header()->setSectionResizeMode(column, QHeaderView::Fixed);
    header()->resizeSection(column, kIconColumn);
  }
  for (const int column : {volume, intensity, diameter}) {
    header()->setSectionResizeMode(column, QHeaderView::Fixed);
    header()->resizeSection(column, kFigureColumn);
    headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  header()->resizeSection(intensity, kIntensityColumn);
  setFixedHeight(sizeHint().height());
  connect(this, &QTreeWidget::itemClicked, this, &LabelTable::press);
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item != nullptr) emit label_chosen(label_of(item));
  });
}

QSize LabelTable::sizeHint() const {
  const int row = fontMetrics().height() + 7;
  return {300, header()->sizeHint().height() + kRowsInSight * row + 4};
}

QTreeWidgetItem* LabelTable::row_of(Label label) const {
  for (int i = 0; i < topLevelItemCount(); ++i)
    if (label_of(topLevelItem(i)) == label) return topLevelItem(i);
  return nullptr;
}

void LabelTable::set_rows(const std::vector<LabelRow>& rows, bool hounsfield) {
  headerItem()->setText(intensity, hounsfield ? tr("HU") : tr("Grey"));
  const QSignalBlocker quiet(this);
  const Label chosen = currentItem() != nullptr ? label_of(currentItem()) : structure::kParenchyma;
  while (topLevelItemCount() > static_cast<int>(rows.size()))
    delete takeTopLevelItem(topLevelItemCount() - 1);
  while (topLevelItemCount() < static_cast<int>(rows.size())) addTopLevelItem(new QTreeWidgetItem);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    const LabelRow& row = rows[static_cast<std::size_t>(i)];
    QTreeWidgetItem* item = topLevelItem(i);
    const bool empty = row.figures.voxels == 0;
    const bool other = item->icon(name).isNull() || label_of(item) != row.label;
    // Icons are drawn anew only where they change: rows follow every stretch of a stroke.
    if (other) item->setIcon(name, structure_icon(row.label));
    if (other || item->data(review, Qt::UserRole).toInt() != static_cast<int>(row.review))
      item->setIcon(review, review_icon(row.review));
    item->setData(name, Qt::UserRole, static_cast<unsigned>(row.label));
    const QString text = structure_text(row.label);
    item->setText(name, is_lesion(row.label) && empty ? QStringLiteral("+ %1").arg(text) : text);
    item->setToolTip(name, text);
    item->setForeground(name, empty ? QColor(0x8d, 0x9a, 0xa3) : QColor(0xe4, 0xe9, 0xec));
    item->setData(review, Qt::UserRole, static_cast<int>(row.review));
    item->setToolTip(review, tr("%1: click to change").arg(review_text(row.review)));
    item->setText(volume,
                  empty ? QString() : QString::number(row.figures.ml, 'f', row.figures.ml < 100 ? 1 : 0));
    item->setText(intensity, empty ? QString() : QString::number(qRound(row.figures.mean_hu)));
    item->setToolTip(intensity, empty ? QString() : intensity_text(row.figures, hounsfield));
    const bool measured = is_lesion(row.label) && !empty;
    item->setText(diameter, measured ? QString::number(row.figures.longest_diameter_mm, 'f', 1) : QString());
    for (const int column : {volume, intensity, diameter})
      item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  }
  set_marks(hidden_, locked_);
  QTreeWidgetItem* current = row_of(chosen);
  setCurrentItem(current != nullptr ? current : topLevelItem(0));
}

void LabelTable::set_marks(const std::set<Label>& hidden, const std::set<Label>& locks) {
  hidden_ = hidden;
  locked_ = locks;
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    const Label label = label_of(item);
    const bool is_hidden = hidden_.count(label) > 0, is_locked = locked_.count(label) > 0;
    const QVariant marks = (is_hidden ? 1 : 0) + (is_locked ? 2 : 0);
    if (item->data(shown, Qt::UserRole) == marks) continue;
    item->setData(shown, Qt::UserRole, marks);
    item->setIcon(shown, icon(is_hidden ? "eye_closed" : "eye"));
    item->setToolTip(shown, is_hidden ? tr("Hidden: click to show") : tr("Shown: click to hide"));
    item->setIcon(locked, icon(is_locked ? "lock" : "lock_open"));
    item->setToolTip(locked, is_locked ? tr("Locked: neither loses nor gains voxels. Click to unlock")
                                       : tr("Click to lock: it neither loses nor gains voxels"));
  }
}

void LabelTable::choose(Label label) {
  if (QTreeWidgetItem* item = row_of(label)) setCurrentItem(item);
}

void LabelTable::press(QTreeWidgetItem* item, int column) {
  if (column == shown) emit shown_toggled(label_of(item));
  if (column == locked) emit lock_toggled(label_of(item));
  if (column == review) ask_review(item);
}

void LabelTable::ask_review(QTreeWidgetItem* item) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const Label label = label_of(item);
  for (const ReviewState state : kStates)
    menu->addAction(review_icon(state), review_text(state), this,
                    [this, label, state] { emit review_chosen(label, state); });
  menu->popup(viewport()->mapToGlobal(visualItemRect(item).bottomRight() - QPoint(160, 0)));
}

}  // namespace glisson::ui
