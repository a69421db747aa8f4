// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "glisson/stereo/source.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace glisson::ui {

/// How a video or a device holds its two views, where that is not left and right side by side. It is written
/// down as a small file, so that the case and the command line can open the source again.
class SourceDialog : public QDialog {
  Q_OBJECT
 public:
  explicit SourceDialog(QWidget* parent = nullptr);

  /// What the dialog says now.
  stereo::SourceOptions options() const;
  /// Writes it. @return whether it could; otherwise the dialog says why not, and stays.
  bool save_as(const QString& file);

 signals:
  /// The description was written.
  void described(const QString& file);

 private:
  void choose(QLineEdit* line);
  void ask_where();
  void show_state();

  QComboBox* layout_;
  QLineEdit* left_;
  QLineEdit* right_;
  QPushButton* choose_right_;
  QCheckBox* right_first_;
  QCheckBox* interlaced_;
  QSpinBox* crop_[4] = {};
  QLabel* problem_;
  QPushButton* save_;
};

}  // namespace glisson::ui
