// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/lesion_box.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <algorithm>

#include "box_layout.h"
#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

constexpr int kMostInSight = 6;  ///< rows

QColor colour_of(Level level) {
  // As the words below the picture.
  return level == Level::valid ? QColor(142, 224, 176) : QColor(255, 207, 112);
}

}  // namespace

LesionBox::LesionBox(LiveViewModel& model, RegistrationModel& registration, QWidget* parent)
    : QWidget(parent),
      table_(new QTreeWidget(this)),
      why_(make_warning(this)),
      model_(model),
      registration_(registration) {
  setObjectName(QStringLiteral("lesion_box"));
  QVBoxLayout* box = make_box_layout(this);
  table_->setObjectName(QStringLiteral("lesion_table"));
  table_->setRootIsDecorated(false);
  table_->setUniformRowHeights(true);
  table_->setAllColumnsShowFocus(true);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setHeaderLabels({tr("Lesion, fork"), tr("State"), tr("Error"), tr("95 %")});
  table_->headerItem()->setToolTip(
      name, tr("Lesions, and the largest forks of portal vein and hepatic veins (1: the widest)."));
  table_->headerItem()->setToolTip(expected, tr("Mean error that the registration expects there."));
  table_->headerItem()->setTextAlignment(expected, Qt::AlignRight | Qt::AlignVCenter);
  table_->headerItem()->setToolTip(
      within, tr("How far from the place shown it may be in 95 of 100 cases, as the registration expects."));
  table_->headerItem()->setTextAlignment(within, Qt::AlignRight | Qt::AlignVCenter);
  table_->header()->setStretchLastSection(false);
  table_->header()->setSectionsClickable(false);
  table_->header()->setSectionResizeMode(name, QHeaderView::Stretch);
  table_->header()->setSectionResizeMode(state, QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(expected, QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(within, QHeaderView::ResizeToContents);
  box->addWidget(table_);
  why_->setObjectName(QStringLiteral("lesion_reasons"));
  box->addWidget(why_);
  auto* numbers = new FiguresTable(this);
  numbers->setObjectName(QStringLiteral("lesion_numbers"));
  box->addWidget(numbers);
  auto* hint = new QLabel(tr("Click a lesion, here or in the picture. Click with the right button where a "
                             "tool touches the organ: "
                             "the distance from there is told, too. Esc lets go."),
                          this);
  hint->setProperty("role", "explanation");
  hint->setWordWrap(true);
  box->addWidget(hint);
  connect(table_, &QTreeWidget::itemClicked, this, [this](const QTreeWidgetItem* item) {
    const Label lesion = static_cast<Label>(item->data(name, Qt::UserRole).toUInt());
    if (lesion == 0) return;  // a fork
    model_.choose(lesion == model_.chosen ? Label{0} : lesion);
  });
  couplings_.add(model.lesions, [this](const LesionRows&) { show_rows(); });
  couplings_.add(model.mark, [this](const QString&) { show_rows(); });
  couplings_.add(registration.spots, [this](const SpotRows&) { show_rows(); });
  couplings_.add(registration.holds, [this](bool) { show_rows(); });
  couplings_.add(model.chosen, [this](Label lesion) { show_choice(lesion); });
  couplings_.add(model.numbers, [numbers](const FigureRows& rows) { numbers->set_rows(rows); });
}

void LesionBox::show_rows() {
  // Lesions that are in the picture, those of which the registration alone knows, then the forks. Of a kept
  // moment the registration may be another one: all that is told of it is what it holds itself.
  std::vector<std::pair<LesionRow, SpotRow>> rows;
  for (const LesionRow& row : model_.lesions.value()) rows.emplace_back(row, SpotRow());
  const bool is_kept = shows_kept();
  for (const SpotRow& spot : is_kept ? SpotRows() : registration_.spots.value()) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) {
      return spot.lesion != 0 && one.first.lesion == spot.lesion;
    });
    if (row != rows.end()) {
      row->second = spot;
      continue;
    }
    LesionRow of_registration;
    of_registration.lesion = spot.lesion;
    of_registration.name = spot.name;
    of_registration.state = spot.kind;
    of_registration.within = spot.within;
    rows.emplace_back(of_registration, spot);
  }
  setVisible(!rows.empty());
  const int count = static_cast<int>(rows.size());
  if (table_->topLevelItemCount() != count) {
    table_->clear();
    for (int i = 0; i < count; ++i) table_->addTopLevelItem(new QTreeWidgetItem);
    const int row_height = table_->fontMetrics().height() + 7;
    table_->setFixedHeight(table_->header()->sizeHint().height() +
                           std::clamp(count, 1, kMostInSight) * row_height + 4);
  }
  QStringList reasons;
  for (int i = 0; i < count; ++i) {
    const auto& [row, spot] = rows[static_cast<std::size_t>(i)];
    show_row(table_->topLevelItem(i), row, spot);
    if (!row.why.isEmpty()) reasons << tr("%1: %2").arg(row.name, row.why);
  }
  show_warning(*why_, reasons.join(QLatin1Char('\n')));
  show_choice(model_.chosen);
}

bool LesionBox::shows_kept() const { return !model_.mark.value().isEmpty(); }

void LesionBox::show_row(QTreeWidgetItem* item, const LesionRow& row, const SpotRow& spot) const {
  item->setData(name, Qt::UserRole, static_cast<uint>(row.lesion));
  item->setText(name, row.name);
  item->setToolTip(name, row.name);  // some are longer than their column
  item->setText(state, row.state);
  item->setText(expected, shows_kept() ? row.expected : spot.expected);
  item->setText(within, shows_kept() || registration_.holds ? row.within : QStringLiteral("–"));
  for (const Column column : {expected, within})
    item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
  const bool is_fork = row.lesion == 0;
  item->setForeground(state, is_fork ? table_->palette().text().color() : colour_of(row.level));
  item->setToolTip(state, row.why);
}

void LesionBox::show_choice(Label lesion) {
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = table_->topLevelItem(i);
    item->setSelected(lesion != 0 && item->data(name, Qt::UserRole).toUInt() == static_cast<uint>(lesion));
  }
}

}  // namespace glisson::ui
