// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/unit_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace glisson::ui {
namespace {

/// Context of these sentences for translators.
class UnitQuestion {
  Q_DECLARE_TR_FUNCTIONS(UnitQuestion)
};

}  // namespace

void ask_unit(QWidget* parent, const std::filesystem::path& path,
              const std::function<void(LengthUnit)>& then) {
  auto* box = new QMessageBox(QMessageBox::Question, UnitQuestion::tr("Unit of length"),
                              UnitQuestion::tr("In which unit are the lengths in %1?")
                                  .arg(QString::fromStdString(path.filename().string())),
                              QMessageBox::Cancel, parent);
  box->setObjectName(QStringLiteral("unit_question"));
  box->setInformativeText(UnitQuestion::tr("The file does not say. Glisson itself writes millimetres."));
  box->setAttribute(Qt::WA_DeleteOnClose);
  for (const LengthUnit unit : {LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::metre}) {
    const QString code = QString::fromLatin1(unit_code(unit));
    QPushButton* button = box->addButton(code, QMessageBox::AcceptRole);
    button->setObjectName(QStringLiteral("unit_") + code);
    if (unit == LengthUnit::millimetre) box->setDefaultButton(button);
    QObject::connect(button, &QPushButton::clicked, parent, [then, unit] { then(unit); });
  }
  box->open();
}

}  // namespace glisson::ui
