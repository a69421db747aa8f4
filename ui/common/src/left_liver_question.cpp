// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/left_liver_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace glisson::ui {
namespace {

/// Context of these sentences for translators.
class LeftLiverQuestion {
  Q_DECLARE_TR_FUNCTIONS(LeftLiverQuestion)
};

}  // namespace

void ask_left_liver(QWidget* parent, const std::filesystem::path& path, const std::function<void()>& then) {
  auto* box =
      new QMessageBox(QMessageBox::Warning, LeftLiverQuestion::tr("Liver left of the vena cava"),
                      LeftLiverQuestion::tr(
                          "In %1 the liver lies left of the vena cava: has it been operated on (right liver "
                          "removed), or is the image mirrored?")
                          .arg(QString::fromStdString(path.filename().string())),
                      QMessageBox::NoButton, parent);
  box->setTextFormat(Qt::PlainText);
  box->setObjectName(QStringLiteral("left_liver_question"));
  box->setInformativeText(
      LeftLiverQuestion::tr("In a mirrored image left and right are exchanged in all that follows. Where you "
                            "are not sure, import nothing: look at the image, and correct the direction in "
                            "the file's header if it is mirrored."));
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* operated =
      box->addButton(LeftLiverQuestion::tr("Operated on: import"), QMessageBox::AcceptRole);
  operated->setObjectName(QStringLiteral("left_liver_operated"));
  QPushButton* leave =
      box->addButton(LeftLiverQuestion::tr("Mirrored or not sure: do not import"), QMessageBox::RejectRole);
  leave->setObjectName(QStringLiteral("left_liver_leave"));
  box->setDefaultButton(leave);
  box->setEscapeButton(leave);
  QObject::connect(operated, &QPushButton::clicked, parent, [then] { then(); });
  box->open();
}

}  // namespace glisson::ui
