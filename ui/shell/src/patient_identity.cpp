// SPDX-License-Identifier: GPL-3.0-or-later
#include "patient_identity.h"

#include <QStringList>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/source.h"

namespace glisson::ui {

PatientIdentity::PatientIdentity(QWidget* parent) : QLabel(parent) {
  setObjectName(QStringLiteral("patient_identity"));
  setTextFormat(Qt::PlainText);     // it comes from a foreign file
  setContentsMargins(8, 5, 12, 0);  // on the menus' line
}

void PatientIdentity::show_case(const engine::CaseState& state) {
  constexpr int kWidest = 640;  // pixels
  QStringList words;
  if (const auto& source = state[part::source]) {
    if (!source->patient.empty()) words << QString::fromStdString(source->patient);
    if (!source->patient_id.empty()) words << tr("ID %1").arg(QString::fromStdString(source->patient_id));
    if (!source->birth_date.empty()) words << tr("born %1").arg(QString::fromStdString(source->birth_date));
  }
  if (words.isEmpty() && (state[part::image] || state[part::labels] || state[part::model]))
    words << tr("Anonymous");
  const QString all = words.join(QStringLiteral("  ·  "));
  setText(fontMetrics().elidedText(all, Qt::ElideRight, kWidest));
  setToolTip(all.toHtmlEscaped());
  adjustSize();
}

}  // namespace glisson::ui
