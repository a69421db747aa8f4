// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/again_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "box_layout.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

AgainBox::AgainBox(AgainModel& model, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("again_box"));
  QVBoxLayout* box = make_box_layout(this);
  auto* start = new QPushButton(this);
  start->setObjectName(QStringLiteral("register_again"));
  auto* exchange = new QPushButton(this);
  exchange->setObjectName(QStringLiteral("exchange_registration"));
  auto* row = new QHBoxLayout;
  row->addWidget(start);
  row->addWidget(exchange);
  box->addLayout(row);
  auto* said = new QLabel(this);
  said->setObjectName(QStringLiteral("again_said"));
  said->setWordWrap(true);
  box->addWidget(said);

  connect(start, &QPushButton::clicked, &model, &AgainModel::start_or_cancel);
  connect(exchange, &QPushButton::clicked, &model, &AgainModel::exchange);
  couplings_.add(model.is_offered, [start](bool is) { start->setEnabled(is); });
  couplings_.add(model.is_running, [start](bool is) {
    start->setText(is ? tr("Cancel") : tr("Register again"));
    start->setToolTip(
        is ? tr("The picture stays as it is (R)")
           : tr("Registers with all that was seen of the organ since, while it is followed (R). "
                "Taken if it is better by tissue that neither has used."));
  });
  couplings_.add(model.can_exchange, [exchange](bool can) { exchange->setEnabled(can); });
  couplings_.add(model.is_former, [exchange](bool is) {
    exchange->setText(is ? tr("Former one") : tr("Take it"));
    exchange->setToolTip(
        is ? tr("Back to the registration that there was before")
           : tr("Goes over to the new registration although it is no better by its evidence"));
  });
  couplings_.add(model.said, [said](const QString& text) {
    said->setText(text);
    said->setVisible(!text.isEmpty());
  });
  couplings_.add(model.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
}

}  // namespace glisson::ui
