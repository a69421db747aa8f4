// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/guidance_view.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace glisson::ui {

GuidanceView::GuidanceView(LiveView* live, OrganView* organ, QWidget* parent)
    : QWidget(parent), live_(live), stack_(new QStackedWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QWidget(this);
  bar->setProperty("role", "viewbar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* group = new QButtonGroup(this);
  const auto add = [&](const QString& text, const char* name, QWidget* page) {
    auto* button = new QPushButton(text, bar);
    button->setObjectName(QLatin1String(name));
    button->setCheckable(true);
    button->setProperty("role", "mode");
    button->setFocusPolicy(Qt::NoFocus);  // the keys belong to the picture
    group->addButton(button, stack_->addWidget(page));
    row->addWidget(button);
    return button;
  };
  picture_ = add(tr("Picture"), "show_picture", live);
  QPushButton* organ_button = add(tr("Organ in 3D, expected error"), "show_organ", organ);
  organ_button->setToolTip(
      tr("The organ as it was registered, in the colours of the error that is expected "
         "at each place, with each lesion's region."));
  row->addStretch(1);
  layout->addWidget(bar);
  layout->addWidget(stack_, 1);
  connect(group, &QButtonGroup::idClicked, stack_, &QStackedWidget::setCurrentIndex);
  picture_->setChecked(true);
}

void GuidanceView::show_picture() { picture_->click(); }

}  // namespace glisson::ui
