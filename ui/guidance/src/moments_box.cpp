// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/moments_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <algorithm>

#include "box_layout.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

constexpr int kMostInSight = 3, kRowHeight = 66;  ///< rows, pixels

QColor colour_of(Level level) {
  // As the words below the picture.
  return level == Level::valid ? QColor(142, 224, 176) : QColor(255, 207, 112);
}

QPushButton* make_button(QWidget* parent, const char* name, const QString& text, const QString& tip) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  return button;
}

}  // namespace

MomentsBox::MomentsBox(MomentsModel& model, QWidget* parent)
    : QWidget(parent), model_(model), list_(new QListWidget(this)), title_(new QLineEdit(this)) {
  setObjectName(QStringLiteral("moments_box"));
  QVBoxLayout* box = make_box_layout(this);
  auto* keep = make_button(this, "keep_moment", tr("Keep this moment"), {});
  auto* back = make_button(this, "leave_moment", tr("Back to live"), tr("Back to live (Esc in the picture)"));
  remove_ = make_button(this, "remove_moment", tr("Delete"), tr("Delete the chosen moment"));
  auto* undo = make_button(this, "undo_moments", tr("Undo"), tr("Take the last deletion or title back"));
  auto* said = new QLabel(this);
  said->setObjectName(QStringLiteral("moments_said"));
  said->setWordWrap(true);
  list_->setObjectName(QStringLiteral("moments"));
  list_->setIconSize({80, 52});
  list_->setUniformItemSizes(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setToolTip(tr("A click shows the moment as it was. The live video goes on meanwhile."));
  title_->setObjectName(QStringLiteral("moment_title"));
  title_->setMaxLength(200);
  title_->setPlaceholderText(tr("Title of the chosen moment"));
  auto* row = new QHBoxLayout;
  for (QWidget* button : {back, remove_, undo}) row->addWidget(button);
  box->addWidget(keep);
  box->addWidget(said);
  box->addWidget(list_);
  box->addWidget(title_);
  box->addLayout(row);

  connect(keep, &QPushButton::clicked, &model, &MomentsModel::keep);
  connect(back, &QPushButton::clicked, &model, &MomentsModel::go_live);
  connect(remove_, &QPushButton::clicked, &model, [this] { model_.remove(chosen()); });
  connect(undo, &QPushButton::clicked, &model, &MomentsModel::undo);
  connect(list_, &QListWidget::itemClicked, &model, [this] { model_.show(chosen()); });
  connect(list_, &QListWidget::itemActivated, &model, [this] { model_.show(chosen()); });
  connect(list_, &QListWidget::currentRowChanged, this, &MomentsBox::show_choice);
  connect(title_, &QLineEdit::editingFinished, &model, [this] { model_.rename(chosen(), title_->text()); });
  couplings_.add(model.obstacle, [keep](const QString& why) {
    keep->setEnabled(why.isEmpty());
    keep->setToolTip(why.isEmpty()
                         ? tr("Keep both pictures, the overlay and its numbers in the case (K in the "
                              "picture)")
                         : why);
  });
  couplings_.add(model.shown, [back](int number) { back->setEnabled(number != 0); });
  couplings_.add(model.can_undo, [undo](bool can) { undo->setEnabled(can); });
  couplings_.add(model.said, [said](const QString& text) {
    said->setText(text);
    said->setVisible(!text.isEmpty());
  });
  couplings_.add(model.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
  couplings_.add(model.case_number, [this](std::uint64_t) { forget(); });
  couplings_.add(model.rows, [this](const std::vector<MomentRow>&) { show_rows(); });
}

void MomentsBox::forget() {
  {
    const QSignalBlocker quiet(list_);
    list_->setCurrentRow(-1);
  }
  show_choice();
}

int MomentsBox::chosen() const {
  const QListWidgetItem* item = list_->currentItem();
  return item == nullptr ? 0 : item->data(Qt::UserRole).toInt();
}

void MomentsBox::show_rows() {
  const int former = chosen();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const MomentRow& row : model_.rows.value()) {
      auto* item = new QListWidgetItem(list_);
      item->setData(Qt::UserRole, row.number);
      const QString head =
          row.title.isEmpty() ? tr("Moment %1").arg(row.number) : tr("%1: %2").arg(row.number).arg(row.title);
      item->setText(head + QLatin1Char('\n') + row.state + QLatin1Char('\n') + row.time);
      item->setToolTip(item->text());
      item->setForeground(colour_of(row.level));
      if (!row.thumbnail.isNull()) item->setIcon(QIcon(QPixmap::fromImage(row.thumbnail)));
      item->setSizeHint({0, kRowHeight});
      if (row.number == former) list_->setCurrentItem(item);
    }
  }
  const int count = list_->count();
  list_->setFixedHeight(std::clamp(count, 1, kMostInSight) * kRowHeight + 4);
  list_->setVisible(count > 0);
  title_->setVisible(count > 0);
  show_choice();
}

void MomentsBox::show_choice() {
  const int number = chosen();
  remove_->setEnabled(number != 0);
  title_->setEnabled(number != 0);
  if (title_->hasFocus() && number != 0) return;  // who types is not interrupted
  const auto& rows = model_.rows.value();
  const auto row =
      std::find_if(rows.begin(), rows.end(), [number](const MomentRow& one) { return one.number == number; });
  title_->setText(row == rows.end() ? QString() : row->title);
}

}  // namespace glisson::ui
