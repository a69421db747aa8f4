// SPDX-License-Identifier: GPL-3.0-or-later
#include "recent_cases.h"

#include <QFileInfo>

#include "glisson/engine/case_io.h"
#include "glisson/ui/common/user_settings.h"

namespace glisson::ui {
namespace {

constexpr int kMost = 10;
const QString kKey = QStringLiteral("recent_cases");

/// "patient.glisson (/home/doe/cases)", its ampersands not taken for keys.
QString entry_of(const QString& path) {
  const QFileInfo file(path);
  return QStringLiteral("%1 (%2)").arg(file.fileName(), file.path()).replace('&', QStringLiteral("&&"));
}

}  // namespace

RecentCases::RecentCases(QWidget* parent) : QMenu(tr("Open &recent"), parent) {
  setObjectName(QStringLiteral("recent_cases"));
  // Other windows have opened others meanwhile.
  connect(this, &QMenu::aboutToShow, this, &RecentCases::list);
  list();
}

QStringList RecentCases::paths() const {
  QStringList paths = user_settings()->value(kKey).toStringList();
  paths.removeAll(QString());
  return paths.mid(0, kMost);
}

void RecentCases::put(const QStringList& paths) {
  user_settings()->setValue(kKey, paths.mid(0, kMost));
  list();
}

void RecentCases::add(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::path whole = std::filesystem::absolute(path, failure).lexically_normal();
  if (failure || !engine::is_case(whole)) return;
  QStringList all = paths();
  all.removeAll(QString::fromStdString(whole.string()));
  all.prepend(QString::fromStdString(whole.string()));
  put(all);
}

void RecentCases::list() {
  clear();
  const QStringList all = paths();
  for (const QString& path : all)
    connect(addAction(entry_of(path)), &QAction::triggered, this, [this, path] { choose(path); });
  menuAction()->setEnabled(!all.isEmpty());
  addSeparator();
  connect(addAction(tr("&Clear the list")), &QAction::triggered, this, [this] { put({}); });
}

void RecentCases::choose(const QString& path) {
  if (engine::is_case(path.toStdString())) {
    emit chosen(path);
    return;
  }
  QStringList all = paths();
  all.removeAll(path);
  put(all);
  emit missing(path);
}

}  // namespace glisson::ui
