// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "box_layout.h"
#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

/// A switch, the address that it works with, and what is said of it. Named after the box: NAME_on,
/// NAME_address, NAME_said.
struct ServerRows {
  QCheckBox* on;
  QLineEdit* address;
};

/// @param model switch_on(address), switch_off(), is_on, said, tone; outlives the box.
template <class Model>
ServerRows add_server_rows(QWidget* box, Couplings& couplings, Model& model, const QString& name,
                           const QString& switch_text, const QString& address_text) {
  box->setObjectName(name + QStringLiteral("_box"));
  QVBoxLayout* column = make_box_layout(box);
  auto* on = new QCheckBox(switch_text, box);
  on->setObjectName(name + QStringLiteral("_on"));
  column->addWidget(on);
  auto* address = new QLineEdit(box);
  address->setObjectName(name + QStringLiteral("_address"));
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapAllRows);  // the whole of it is to be read
  form->addRow(address_text, address);
  column->addLayout(form);
  auto* said = new QLabel(box);
  said->setObjectName(name + QStringLiteral("_said"));
  said->setWordWrap(true);
  column->addWidget(said);

  QObject::connect(on, &QCheckBox::clicked, &model, [&model, on, address](bool wanted) {
    wanted ? model.switch_on(address->text()) : model.switch_off();
    on->setChecked(model.is_on);  // it may not have come on
  });
  couplings.add(model.is_on, [on, address](bool is) {
    on->setChecked(is);
    address->setEnabled(!is);
  });
  couplings.add(model.said, [said](const QString& text) {
    said->setText(text);
    said->setVisible(!text.isEmpty());
  });
  couplings.add(model.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
  return {on, address};
}

}  // namespace glisson::ui
