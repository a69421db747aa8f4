// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "glisson/volume/series.h"

class QTreeWidget;

namespace glisson::ui {

/// Asks which DICOM series of a folder is to be opened: a row for each with a picture, in the order that they
/// come in, the first one chosen. Rows that cannot be read are grey; all say what speaks against them.
class SeriesDialog : public QDialog {
  Q_OBJECT
 public:
  SeriesDialog(std::vector<DicomSeries> series, QWidget* parent = nullptr);

  /// The chosen one's; empty: none is.
  std::string chosen_uid() const;

 private:
  void build();
  void add_row(const DicomSeries& series, bool likeliest);
  bool is_one_patient() const;

  std::vector<DicomSeries> series_;
  QTreeWidget* list_ = nullptr;
};

}  // namespace glisson::ui
