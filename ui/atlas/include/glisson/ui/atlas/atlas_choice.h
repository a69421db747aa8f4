// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <memory>

#include "glisson/atlas/atlas.h"

namespace glisson::ui {

/// Which atlas this person works with: the built-in one, or a folder of their own, remembered from one start
/// to the next. A folder that is missing or damaged is said; another atlas takes its place only when the
/// person chooses one.
class AtlasChoice : public QObject {
  Q_OBJECT
 public:
  /// Takes up what was remembered.
  explicit AtlasChoice(QObject* parent = nullptr);

  /// Null: the chosen folder holds none that can be used, problem() says why.
  std::shared_ptr<const atlas::Atlas> atlas() const;
  bool is_built_in() const { return folder_.empty(); }
  const std::filesystem::path& folder() const { return folder_; }
  /// For people; empty: nothing is wrong.
  const QString& problem() const { return problem_; }

  /// @return false: it cannot be used. The choice stays as it was, and what is wrong is said in `problem`.
  bool choose(const std::filesystem::path& folder, QString& problem);
  void choose_built_in();

 signals:
  void changed();

 private:
  void keep(const std::filesystem::path& folder);

  std::filesystem::path folder_;             ///< empty: built in
  std::shared_ptr<const atlas::Atlas> own_;  ///< of the folder
  QString problem_;
};

}  // namespace glisson::ui
