// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/save_name.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

namespace glisson::ui {
namespace {

/// Context of these sentences for translators.
class SaveName {
  Q_DECLARE_TR_FUNCTIONS(SaveName)
};

bool wants_to_replace(QWidget* parent, const QString& what, const QString& meaning) {
  QMessageBox box(QMessageBox::Warning, SaveName::tr("Save"), what, QMessageBox::NoButton, parent);
  box.setObjectName(QStringLiteral("replace"));
  box.setInformativeText(meaning);
  const QPushButton* replace = box.addButton(SaveName::tr("Replace"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == replace;
}

}  // namespace

QString with_ending(const QString& path, const QStringList& endings) {
  const bool has_one = std::any_of(endings.begin(), endings.end(), [&](const QString& ending) {
    return path.endsWith(ending, Qt::CaseInsensitive);
  });
  return has_one ? path : path + endings.front();
}

bool may_be_replaced(QWidget* parent, const QString& path) {
  const QFileInfo there(path);
  if (!there.exists() && !there.isSymLink()) return true;
  return wants_to_replace(parent, SaveName::tr("%1 is there already.").arg(there.fileName()),
                          SaveName::tr("Replacing it deletes what it holds."));
}

bool may_be_replaced(QWidget* parent, const QStringList& there) {
  if (there.isEmpty()) return true;
  QStringList names;
  for (const QString& path : there) names << QFileInfo(path).fileName();
  return wants_to_replace(parent,
                          SaveName::tr("In %1 there are already: %2.")
                              .arg(QFileInfo(there.front()).absolutePath(), names.join(QStringLiteral(", "))),
                          SaveName::tr("Replacing them deletes what they hold."));
}

QString ask_where_to_save(QWidget* parent, const QString& title, const QString& proposed,
                          const QString& filter, const QStringList& endings, const QString& own) {
  const QString chosen = QFileDialog::getSaveFileName(parent, title, proposed, filter, nullptr,
                                                      QFileDialog::DontConfirmOverwrite);
  if (chosen.isEmpty()) return {};
  const QString path = with_ending(chosen, endings);
  return path == own || may_be_replaced(parent, path) ? path : QString();
}

}  // namespace glisson::ui
