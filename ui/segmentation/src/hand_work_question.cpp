// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/hand_work_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

/// Context of these sentences for translators.
class HandWorkQuestion {
  Q_DECLARE_TR_FUNCTIONS(HandWorkQuestion)
};

}  // namespace

void ask_over_hand_work(QWidget* parent, const std::set<Label>& edited, const QString& told,
                        const std::function<void()>& then) {
  QStringList names;
  for (const Label label : edited) names << structure_text(label);
  auto* box = new QMessageBox(
      QMessageBox::Question, HandWorkQuestion::tr("Labels corrected by hand"),
      HandWorkQuestion::tr("You corrected by hand: %1.").arg(names.join(QStringLiteral(", "))),
      QMessageBox::NoButton, parent);
  box->setObjectName(QStringLiteral("hand_work_question"));
  box->setInformativeText(told);
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* replace = box->addButton(HandWorkQuestion::tr("Replace them"), QMessageBox::AcceptRole);
  replace->setObjectName(QStringLiteral("replace_hand_work"));
  QPushButton* keep = box->addButton(HandWorkQuestion::tr("Keep mine"), QMessageBox::RejectRole);
  keep->setObjectName(QStringLiteral("keep_hand_work"));
  box->setDefaultButton(keep);
  box->setEscapeButton(keep);
  QObject::connect(replace, &QPushButton::clicked, parent, [then] { then(); });
  box->open();
}

}  // namespace glisson::ui
