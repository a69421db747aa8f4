// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/guidance_view.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "glisson/ui/common/user_settings.h"

namespace glisson::ui {
namespace {

constexpr QLatin1String kBoth("guidance/both"), kShare("guidance/picture_share");  ///< in the settings
/// A room that is less wide, over its height, holds them one above the other.
constexpr double kWide = 1.3;

}  // namespace

GuidanceView::GuidanceView(LiveView* live, OrganView* organ_view, QWidget* parent)
    : QWidget(parent), live_(live), organ_(organ_view), splitter_(new QSplitter(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QWidget(this);
  bar->setProperty("role", "viewbar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  auto* group = new QButtonGroup(this);
  const auto add = [&](const QString& text, const char* name, Page page) {
    auto* button = new QPushButton(text, bar);
    button->setObjectName(QLatin1String(name));
    button->setCheckable(true);
    button->setProperty("role", "mode");
    button->setFocusPolicy(Qt::NoFocus);  // the keys belong to the picture
    group->addButton(button, page);
    row->addWidget(button);
    return button;
  };
  picture_ = add(tr("Picture"), "show_picture", picture);
  add(tr("Organ in 3D, expected error"), "show_organ", organ)
      ->setToolTip(tr("The organ as it was registered, in the colours of the error that is expected "
                      "at each place, with each lesion's region."));
  QPushButton* beside = add(tr("Both"), "show_both", both);
  beside->setToolTip(tr("Picture and organ. While a video is followed the organ goes with the picture."));
  row->addStretch(1);
  layout->addWidget(bar);
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(live_);
  splitter_->addWidget(organ_);
  layout->addWidget(splitter_, 1);
  connect(splitter_, &QSplitter::splitterMoved, this, [this] {
    const QList<int> sizes = splitter_->sizes();
    user_settings()->setValue(kShare, sizes[0] / std::max(1.0, static_cast<double>(sizes[0] + sizes[1])));
  });
  connect(group, &QButtonGroup::idClicked, this, [this](int page) {
    turn_to(page);
    // The organ alone is looked at for a moment: nobody wants to begin with it.
    if (page != organ) user_settings()->setValue(kBoth, page == both);
  });
  (user_settings()->value(kBoth).toBool() ? beside : picture_)->setChecked(true);
  turn_to(group->checkedId());
}

void GuidanceView::turn_to(int page) {
  live_->setVisible(page != organ);
  organ_->setVisible(page != picture);
  share_out();
}

void GuidanceView::share_out() {
  const double share = std::clamp(user_settings()->value(kShare, 0.6).toDouble(), 0.1, 0.9);
  splitter_->setSizes({static_cast<int>(1000 * share), static_cast<int>(1000 * (1.0 - share))});
}

void GuidanceView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const auto wanted = width() < kWide * height() ? Qt::Vertical : Qt::Horizontal;
  if (wanted == splitter_->orientation()) return;
  splitter_->setOrientation(wanted);
  share_out();
}

void GuidanceView::show_picture() {
  if (live_->isHidden()) picture_->click();
}

}  // namespace glisson::ui
