// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace glisson::ui {

/// A field for a number, in which a comma is a decimal point, too. Numbers look the same in every language
/// here, with a point; a hand that writes "2,5" would have its comma passed over otherwise, and 25 taken.
class NumberBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  QValidator::State validate(QString& text, int& cursor) const override {
    text.replace(QLatin1Char(','), QLatin1Char('.'));
    return QDoubleSpinBox::validate(text, cursor);
  }
};

/// Whoever types is not interrupted: a suffix that is set anew, be it the same, writes the whole field anew.
inline void show_suffix(QDoubleSpinBox& box, const QString& suffix) {
  if (box.suffix() != suffix) box.setSuffix(suffix);
}

}  // namespace glisson::ui
