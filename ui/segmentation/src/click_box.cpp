// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/click_box.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include "glisson/engine/commands/correct_around.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/ui/common/being_made.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

ClickBox::ClickBox(EngineBridge& engine, QWidget* parent) : QWidget(parent), engine_(engine) {
  constexpr int kLines = 4;  // of the longest note in any language
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  at_once_ = new QCheckBox(tr("Clicks correct at once"), this);
  at_once_->setObjectName(QStringLiteral("correct_at_once"));
  at_once_->setToolTip(
      tr("Where there are labels, a click on the liver that they leave out, on what is not liver, on a vein "
         "or on a lesion changes them around it and nowhere else. One step back: Ctrl+Z."));
  at_once_->setChecked(true);
  column->addWidget(at_once_);
  words_ = make_explanation({}, this);
  words_->setObjectName(QStringLiteral("correction"));
  words_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  words_->setFixedHeight(kLines * words_->fontMetrics().lineSpacing());  // nothing below it moves
  column->addWidget(words_);
  const auto show_case = [this] {
    if (image_ && engine_.state()[part::image] == image_) return;
    image_ = engine_.state()[part::image];
    words_->setText(tr("With labels there: click what is missing, or too much."));
  };
  connect(&engine_, &EngineBridge::case_changed, this, show_case);
  connect(&engine_, &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (waiting_.erase(outcome.id) > 0 && waiting_.empty()) tell(outcome);
  });
  show_case();
}

void ClickBox::correct(Label structure, const Point<CtFrame>& p_in_ct, const segmentation::Seeds& seeds) {
  const auto& state = engine_.state();
  const bool there = state[part::labels] && state[part::image] &&
                     state[part::labels]->voxels.grid().same_as(state[part::image]->grid);
  const bool is_liver = structure == structure::kParenchyma || structure == structure::kBackground;
  if (!at_once_->isChecked() || !there || (!is_liver && !segmentation::grows_around(structure))) return;
  if (locked_.contains(structure::kParenchyma) || locked_.contains(structure)) return;
  if (is_being_replaced(engine_, part::labels) || engine_.state()[part::offer]) {
    words_->setText(
        tr("New labels are on their way, or wait for your decision: this click changes none now. "
           "It counts when you segment again."));
    return;
  }
  engine::CorrectAround command{{}, seeds, {locked_.begin(), locked_.end()}};
  if (is_liver)
    command.clicks.push_back({p_in_ct, structure == structure::kParenchyma});
  else
    command.grown.push_back({structure, p_in_ct});
  waiting_.insert(engine_.post(std::move(command)));
  words_->setText(tr("Correcting around the click…"));
}

void ClickBox::tell(const engine::Outcome& outcome) {
  const auto figure = [&](const char* name) { return outcome.figures.at(name); };
  if (outcome.status == engine::Status::failed)
    words_->setText(error_text(outcome.error));
  else if (outcome.status != engine::Status::done)
    words_->setText(tr("Not corrected."));
  else if (!outcome.notes.empty())
    words_->setText(notes_text(outcome.notes));
  else if (figure("voxels_changed") > 0.0)
    words_->setText(tr("Corrected around the click: %1 ml, up to %2 mm from it.")
                        .arg(figure("changed_ml"), 0, 'f', 1)
                        .arg(qRound(figure("reach_mm"))));
  else
    words_->setText(tr("The labels say already what the click says."));
  words_->setToolTip(words_->text());  // where a note is longer than the room for it
}

}  // namespace glisson::ui
