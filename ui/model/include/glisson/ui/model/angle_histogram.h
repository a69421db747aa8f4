// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "glisson/model/quality.h"

namespace glisson::ui {

/// The dihedral angles of a mesh as bars of ten degrees; those below ten degrees in a warning colour.
class AngleHistogram : public QWidget {
  Q_OBJECT
 public:
  explicit AngleHistogram(QWidget* parent = nullptr);
  void set_counts(const std::array<int, model::kDihedralBins>& counts);
  QSize sizeHint() const override { return {200, 64}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::array<int, model::kDihedralBins> counts_{};
};

}  // namespace glisson::ui
