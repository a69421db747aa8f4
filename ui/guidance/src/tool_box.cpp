// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/tool_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "box_layout.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

ToolBox::ToolBox(ToolModel& model, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("tool_box"));
  QVBoxLayout* box = make_box_layout(this);
  auto* on = new QCheckBox(tr("Take a tool's tip from a server"), this);
  on->setObjectName(QStringLiteral("tool_on"));
  on->setToolTip(tr("While the tip is within 5 mm of the organ's surface it marks the place there."));
  box->addWidget(on);
  auto* address = new QLineEdit(QStringLiteral("127.0.0.1:18944/TipToLeftCamera"), this);
  address->setObjectName(QStringLiteral("tool_address"));
  address->setToolTip(
      tr("Address and port, and the name of the transform from the tool's tip to the left camera."));
  auto* form = new QFormLayout;
  form->setRowWrapPolicy(QFormLayout::WrapAllRows);  // the whole of it is to be read
  form->addRow(tr("Server and tool"), address);
  box->addLayout(form);
  auto* said = new QLabel(this);
  said->setObjectName(QStringLiteral("tool_said"));
  said->setWordWrap(true);
  box->addWidget(said);

  connect(on, &QCheckBox::clicked, &model, [&model, on, address](bool wanted) {
    wanted ? model.switch_on(address->text()) : model.switch_off();
    on->setChecked(model.is_on);  // it may not have come on
  });
  couplings_.add(model.is_on, [on, address](bool is) {
    on->setChecked(is);
    address->setEnabled(!is);
  });
  couplings_.add(model.said, [said](const QString& text) {
    said->setText(text);
    said->setVisible(!text.isEmpty());
  });
  couplings_.add(model.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
}

}  // namespace glisson::ui
