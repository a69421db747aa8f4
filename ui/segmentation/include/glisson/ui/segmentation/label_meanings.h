// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <optional>
#include <vector>

#include "glisson/patient/label_map.h"
#include "glisson/patient/label_summary.h"

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace glisson::ui {

/// A label that a file holds, and what it is by the file's own word.
struct FoundLabel {
  LabelInfo info;                ///< where the file says nothing of it: the code alone
  double ml = 0.0;               ///< its volume
  std::optional<Label> meaning;  ///< none: the file does not say, or it is nothing of the liver
};

/// What a file holds, in the order of its codes.
struct FoundLabels {
  std::vector<FoundLabel> labels;
  /// No name says what a number stands for. Glisson's own plain files are so, and those of other programs.
  bool are_numbers = false;
  LabelSummary summary = {};  ///< of its voxels
  /// Which of them is the liver has to be asked: the file does not say, or says numbers only.
  bool must_be_asked() const;
  /// What the codes mean by the file's own word.
  LabelCodes meanings() const;
};

/// @param is_own written by Glisson: the codes are its own, whatever their names are.
FoundLabels found_labels(const LabelFile& file, bool is_own);

/// Asks what each label of a file means. What the file says itself is chosen already; the rest is not
/// imported unless the person says so.
class LabelMeanings : public QDialog {
  Q_OBJECT
 public:
  /// @param file its name, for people.
  LabelMeanings(FoundLabels found, const QString& file, QWidget* parent = nullptr);

  /// What was said. Lesions are numbered in the labels' order.
  LabelCodes codes() const;

 private:
  void add_row(const FoundLabel& label);
  void take_numbers();
  void show_state();

  FoundLabels found_;
  bool by_numbers_ = false;  ///< lesions keep the numbers that they have in the file
  QTreeWidget* list_ = nullptr;
  std::vector<QComboBox*> choices_;
  QLabel* missing_ = nullptr;
  QPushButton* import_ = nullptr;
};

}  // namespace glisson::ui
