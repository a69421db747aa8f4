// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/notes_box.h"

#include <QLabel>
#include <QVBoxLayout>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

NotesBox::NotesBox(EngineBridge& engine, QWidget* parent) : QWidget(parent), engine_(engine) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  words_ = make_warning(this);
  words_->setObjectName(QStringLiteral("label_notes"));
  column->addWidget(words_);
  connect(&engine_, &EngineBridge::case_changed, this, &NotesBox::show_case);
  show_case();
}

void NotesBox::show_proposal(const std::vector<std::string>& notes) {
  proposal_ = notes;
  show_case();
}

void NotesBox::show_case() {
  const engine::CaseState& state = engine_.state();
  const auto& image = state[part::image];
  const auto& labels = state[part::labels];
  const auto& offer = state[part::offer];
  if (image != image_ || labels != labels_) proposal_.clear();
  image_ = image;
  labels_ = labels;
  const auto told = !proposal_.empty() ? proposal_ : offer ? offer->notes : engine::told_of_labels(state);
  show_warning(*words_, notes_text(told));
  setVisible(!words_->isHidden());
  count_ = told.size();
  emit changed();
}

}  // namespace glisson::ui
