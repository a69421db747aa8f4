// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/live_view.h"

#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

constexpr int kLinesHeight = 46;  ///< two lines of the live view's words, pixels

}  // namespace

LiveView::LiveView(LiveViewModel& model, QWidget* parent)
    : QWidget(parent), model_(model), picture_(new LivePicture(this)) {
  setObjectName(QStringLiteral("guidance_view"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* banner = new QLabel(this);
  banner->setProperty("role", "banner");
  banner->setWordWrap(true);
  layout->addWidget(banner);
  picture_->set_hint(
      tr("Register the model to a frame of the laparoscope; the augmented picture appears here."));
  layout->addWidget(picture_, 1);
  auto* line = new QLabel(this);
  line->setProperty("role", "probe");
  line->setContentsMargins(10, 4, 10, 4);
  // A reason takes a second line on small screens: there is always room for it, so that nothing jumps.
  line->setWordWrap(true);
  line->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  line->setMinimumHeight(kLinesHeight);
  layout->addWidget(line);

  connect(picture_, &LivePicture::clicked, &model, &LiveViewModel::choose_at);
  connect(picture_, &LivePicture::marked, &model, &LiveViewModel::mark_at);
  connect(&model, &LiveViewModel::picture_changed, picture_, &PictureView::set_picture);
  couplings_.add(model.banner, [banner](const QString& text) { show_warning(*banner, text); });
  couplings_.add(model.line, [line](const QString& text) { line->setText(text); });
  couplings_.add(model.is_fresh, [line](const QVariant& is) { set_style_property(line, "fresh", is); });
}

void LiveView::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
  model_.let_go();
}

}  // namespace glisson::ui
