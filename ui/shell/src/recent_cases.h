// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QStringList>
#include <filesystem>

namespace glisson::ui {

/// File > Open recent: the cases that were opened or saved last, the latest first, at most ten. Kept in the
/// user's settings, or in the folder that GLISSON_SETTINGS names. Nothing is looked for before it is chosen:
/// a disk that is away would hold up the menu.
class RecentCases : public QMenu {
  Q_OBJECT
 public:
  explicit RecentCases(QWidget* parent = nullptr);
  /// Puts a case first. Other paths than those of cases on the disk are passed over.
  void add(const std::filesystem::path& path);
  QStringList paths() const;

 signals:
  void chosen(const QString& path);
  /// It is there no more, and not in the list any longer.
  void missing(const QString& path);

 private:
  void put(const QStringList& paths);
  void list();
  void choose(const QString& path);
};

}  // namespace glisson::ui
