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
    if (waiting_.erase(outcome.id) > 0) tell(outcome);
  });
  show_case();
}

bool ClickBox::corrects(Label structure) {
  const auto& state = engine_.state();
  if (!state[part::labels]) return false;
  const bool fits =
      state[part::image] && state[part::labels]->voxels.grid().same_as(state[part::image]->grid);
  const bool can_grow = structure == structure::kParenchyma || structure == structure::kBackground ||
                        segmentation::grows_around(structure);
  const bool is_held = can_grow && locked_.contains(structure::kParenchyma);
  if (is_held || locked_.contains(structure))
    words_->setText(tr("Locked: this click changes nothing."));
  else if (!at_once_->isChecked() || !fits || !can_grow)
    words_->setText(tr("This click changes nothing now. It counts when you segment again."));
  else if (is_being_replaced(engine_, part::labels) || state[part::offer])
    words_->setText(
        tr("New labels are on their way, or wait for your decision: this click changes none now. "
           "It counts when you segment again."));
  else
    return true;
  return false;
}

void ClickBox::correct(Label structure, const Point<CtFrame>& p_in_ct, const segmentation::Seeds& seeds) {
  if (!corrects(structure)) return;
  const bool is_liver = structure == structure::kParenchyma || structure == structure::kBackground;
  engine::CorrectAround command{{}, seeds, {locked_.begin(), locked_.end()}};
  command.over_hand_work = engine::OverHandWork::offer;
  if (is_liver)
    command.clicks.push_back({p_in_ct, structure == structure::kParenchyma});
  else
    command.grown.push_back({structure, p_in_ct});
  if (waiting_.empty()) told_.clear();
  waiting_.insert(engine_.post(std::move(command)));
  words_->setText(tr("Correcting around the click…"));
}

void ClickBox::tell(const engine::Outcome& outcome) {
  const auto figure = [&](const char* name) { return outcome.figures.at(name); };
  if (outcome.status == engine::Status::failed) told_ << error_text(outcome.error);
  if (outcome.status == engine::Status::done && !outcome.notes.empty()) told_ << notes_text(outcome.notes);
  if (!waiting_.empty()) return;
  if (!told_.isEmpty())
    words_->setText(told_.join(QLatin1Char('\n')));
  else if (outcome.status != engine::Status::done)
    words_->setText(tr("Not corrected."));
  else if (figure("voxels_changed") > 0.0)
    words_->setText(tr("Corrected around the click: %1 ml, up to %2 mm from it.")
                        .arg(figure("changed_ml"), 0, 'f', 1)
                        .arg(qRound(figure("reach_mm"))));
  else if (outcome.figures.contains("hand_corrected_voxels"))
    words_->setText(tr("This click would replace what you have drawn: it waits for your decision."));
  else
    words_->setText(tr("The labels say already what the click says."));
  words_->setToolTip(words_->text());  // where a note is longer than the room for it
}

}  // namespace glisson::ui
