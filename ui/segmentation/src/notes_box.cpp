// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/notes_box.h"

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/segmentation/kept_notes.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {

NotesBox::NotesBox(EngineBridge& engine, QWidget* parent) : QWidget(parent), engine_(engine) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  words_ = make_warning(this);
  words_->setObjectName(QStringLiteral("label_notes"));
  words_->setTextFormat(Qt::RichText);
  words_->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
  column->addWidget(words_);
  connect(words_, &QLabel::linkActivated, this, [this](const QString& number) {
    const auto n = static_cast<std::size_t>(number.toULongLong());
    if (const auto place = n < told_.size() ? segmentation::place_told(told_[n]) : std::nullopt)
      emit place_chosen(*place);
  });
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
  told_ = !proposal_.empty() ? proposal_ : offer ? offer->notes : engine::told_of_labels(state);
  show_warning(*words_, words());
  setVisible(!words_->isHidden());
  emit changed();
}

QString NotesBox::words() const {
  QStringList lines;
  for (std::size_t n = 0; n < told_.size(); ++n) {
    QString line = QStringLiteral("• ") + note_text(told_[n]).toHtmlEscaped();
    if (segmentation::place_told(told_[n]))
      line += QStringLiteral(" <a href=\"%1\" style=\"color: #9fc8de\">%2</a>")
                  .arg(n)
                  .arg(tr("Show it").toHtmlEscaped());
    lines << line;
  }
  return lines.join(QLatin1String("<br>"));
}

}  // namespace glisson::ui
