// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>
#include <set>

#include "glisson/ui/segmentation/label_rows.h"

namespace glisson::ui {

/// The labels: colour and name, whether they are shown and locked, how far a person has come with them, and
/// their figures. The chosen row is the label that is worked on.
class LabelTable : public QTreeWidget {
  Q_OBJECT
 public:
  enum Column { name = 0, shown = 1, locked = 2, review = 3, volume = 4, intensity = 5, diameter = 6 };

  explicit LabelTable(QWidget* parent = nullptr);
  /// @param hounsfield whether intensities are those of a CT; otherwise they have no unit.
  void set_rows(const std::vector<LabelRow>& rows, bool hounsfield = true);
  /// Labels that are hidden or locked, as the table shows them.
  void set_marks(const std::set<Label>& hidden, const std::set<Label>& locked);
  void choose(Label label);
  QTreeWidgetItem* row_of(Label label) const;
  QSize sizeHint() const override;

 signals:
  void label_chosen(glisson::Label label);
  void shown_toggled(glisson::Label label);
  void lock_toggled(glisson::Label label);
  void review_chosen(glisson::Label label, glisson::ReviewState state);

 private:
  void press(QTreeWidgetItem* item, int column);
  void ask_review(QTreeWidgetItem* item);

  std::set<Label> hidden_, locked_;
};

}  // namespace glisson::ui
