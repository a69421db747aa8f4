// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/offer_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "glisson/engine/parts/labels.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/scene/difference_overlay.h"

namespace glisson::ui {
namespace {

using Choice = engine::DecideSegmentation::Choice;

QString ml_text(const engine::SegmentationOffer& offer, long voxels) {
  const double ml = 1e-3 * offer.image->grid.voxel_volume_mm3() * static_cast<double>(voxels);
  return QLocale().toString(ml, 'f', ml < 0.095 && voxels > 0 ? 2 : 1);
}

FigureRows rows_of(const engine::SegmentationOffer& offer) {
  FigureRows rows;
  for (const auto& [label, shift] : offer.difference.labels)
    rows.emplace_back(
        structure_text(label),
        OfferBox::tr("+%1 ml  −%2 ml").arg(ml_text(offer, shift.gained), ml_text(offer, shift.lost)));
  return rows;
}

}  // namespace

OfferBox::OfferBox(EngineBridge& engine, ViewState& views, QWidget* parent)
    : QWidget(parent), engine_(engine), views_(views) {
  setObjectName(QStringLiteral("offer_box"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* heading = new QLabel(tr("A new segmentation waits"), this);
  heading->setProperty("role", "heading");
  column->addWidget(heading);
  text_ = make_explanation({}, this);
  column->addWidget(text_);
  build_legend();
  figures_ = new FiguresTable(this);
  column->addWidget(figures_);
  hand_ = make_explanation({}, this);
  hand_->setObjectName(QStringLiteral("offer_hand"));
  column->addWidget(hand_);
  auto* go = new QPushButton(tr("Go to the largest change"), this);
  go->setObjectName(QStringLiteral("offer_go"));
  go->setProperty("role", "small");
  connect(go, &QPushButton::clicked, this, &OfferBox::go_to_most);
  column->addWidget(go);
  add_choice(tr("Keep mine where I corrected"), "offer_keep_hand", Choice::keep_hand)
      ->setToolTip(tr("The voxels that you corrected by hand stay, all else is taken from the new one."));
  add_choice(tr("Take the new one"), "offer_take", Choice::take)
      ->setToolTip(tr("Your corrections go; Undo brings them back."));
  add_choice(tr("Keep all mine"), "offer_keep_all", Choice::keep_all)
      ->setToolTip(tr("The new segmentation goes, nothing changes."));
  problem_ = new QLabel(this);
  problem_->setProperty("role", "error");
  problem_->setWordWrap(true);
  problem_->hide();
  column->addWidget(problem_);
  connect(&engine_, &EngineBridge::case_changed, this, &OfferBox::show_case);
  connect(&engine_, &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (outcome.id != deciding_) return;
    deciding_.reset();
    setEnabled(true);
    problem_->setText(error_text(outcome.error));
    problem_->setVisible(outcome.status == engine::Status::failed);
  });
  hide();
}

void OfferBox::build_legend() {
  auto* legend = new QGridLayout;
  legend->setHorizontalSpacing(8);
  legend->setVerticalSpacing(4);
  legend->setColumnStretch(1, 1);
  const auto add = [&](scene::Change change, bool by_hand, const QString& text) {
    const int row = legend->rowCount();
    auto* swatch = new QLabel(this);
    swatch->setPixmap(QPixmap::fromImage(scene::difference_swatch(change, by_hand, 26, 16)));
    legend->addWidget(swatch, row, 0);
    legend->addWidget(make_explanation(text, this), row, 1);
  };
  add(scene::Change::added, false, tr("Would be added"));
  add(scene::Change::removed, false, tr("Would be removed"));
  add(scene::Change::renamed, false, tr("Would be another structure"));
  add(scene::Change::removed, true, tr("White rim: you corrected it by hand"));
  static_cast<QVBoxLayout*>(layout())->addLayout(legend);
}

QPushButton* OfferBox::add_choice(const QString& text, const char* name, Choice choice) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QString::fromLatin1(name));
  connect(button, &QPushButton::clicked, this, [this, choice] { decide(choice); });
  layout()->addWidget(button);
  return button;
}

void OfferBox::decide(Choice choice) {
  if (!shown_ || deciding_) return;
  setEnabled(false);  // a second click would decide about nothing
  deciding_ = engine_.post(engine::DecideSegmentation{choice, shown_->keeps_labels, shown_});
}

void OfferBox::set_active(bool on) {
  active_ = on;
  show_in_views();
}

void OfferBox::show_in_views() { views_.set_offer(active_ ? shown_ : nullptr); }

void OfferBox::show_case() {
  const auto offer = engine_.state()[part::offer];
  if (offer == shown_) return;
  shown_ = offer;
  setVisible(offer != nullptr);
  problem_->hide();
  if (offer) show_offer(*offer);
  show_in_views();
  emit changed();
  if (offer && active_) go_to_most();
}

void OfferBox::show_offer(const engine::SegmentationOffer& offer) {
  QStringList names;
  for (const Label label : offer.edited) names << structure_text(label);
  text_->setText(
      tr("It would change what you corrected by hand: %1. Your labels stay as they are until you decide.")
          .arg(names.join(QStringLiteral(", "))));
  figures_->set_rows(rows_of(offer));
  const LabelDifference& difference = offer.difference;
  hand_->setText(tr("Of %1 voxels that you corrected, %2 would change (%3 of %4 ml).")
                     .arg(QLocale().toString(static_cast<qlonglong>(difference.hand_voxels)),
                          QLocale().toString(static_cast<qlonglong>(difference.hand_changed)),
                          ml_text(offer, difference.hand_changed), ml_text(offer, difference.hand_voxels)));
}

void OfferBox::go_to_most() {
  if (!shown_ || !shown_->difference.where_most) return;
  const VolumeGrid& grid = shown_->labels.voxels.grid();
  views_.set_crosshair(grid.p_in_ct(shown_->difference.where_most->cast<double>()));
}

}  // namespace glisson::ui
