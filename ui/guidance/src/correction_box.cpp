// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/correction_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "box_layout.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

CorrectionBox::CorrectionBox(CorrectionModel& model, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("correction_box"));
  QVBoxLayout* box = make_box_layout(this);
  auto* correct = new QPushButton(tr("Correct by hand"), this);
  correct->setObjectName(QStringLiteral("correct_by_hand"));
  correct->setCheckable(true);
  correct->setToolTip(tr(
      "Drag a place of the drawn organ (margin, notch, vessel, surface) to where the picture shows it (C, or "
      "drag with Shift)."));
  auto* undo = new QPushButton(tr("Undo"), this);
  undo->setObjectName(QStringLiteral("undo_correction"));
  undo->setToolTip(tr("Take the last correction back (Ctrl+Z in the picture)"));
  auto* row = new QHBoxLayout;
  row->addWidget(correct);
  row->addWidget(undo);
  box->addLayout(row);
  auto* said = new QLabel(this);
  said->setObjectName(QStringLiteral("correction_said"));
  said->setWordWrap(true);
  box->addWidget(said);

  connect(correct, &QPushButton::toggled, &model, [&model](bool on) { model.is_correcting = on; });
  connect(undo, &QPushButton::clicked, &model, &CorrectionModel::undo);
  couplings_.add(model.is_offered, [correct](bool is) { correct->setEnabled(is); });
  couplings_.add(model.is_correcting, [correct](bool is) { correct->setChecked(is); });
  couplings_.add(model.can_undo, [undo](bool can) { undo->setEnabled(can); });
  couplings_.add(model.said, [said](const QString& text) {
    said->setText(text);
    said->setVisible(!text.isEmpty());
  });
  couplings_.add(model.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
}

}  // namespace glisson::ui
