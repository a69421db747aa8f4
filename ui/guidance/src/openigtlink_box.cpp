// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/openigtlink_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "box_layout.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

OpenIgtLinkBox::OpenIgtLinkBox(OpenIgtLinkModel& model, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("openigtlink_box"));
  QVBoxLayout* box = make_box_layout(this);
  auto* on = new QCheckBox(tr("Tell them by OpenIGTLink"), this);
  on->setObjectName(QStringLiteral("openigtlink_on"));
  on->setToolTip(tr("Programs that connect are told of each frame: level, pose of the camera, surfaces."));
  box->addWidget(on);
  auto* address = new QLineEdit(this);
  address->setObjectName(QStringLiteral("openigtlink_address"));
  address->setToolTip(
      tr("127.0.0.1: only programs of this computer can connect. Another address of this computer lets in "
         "whoever reaches it."));
  auto* form = new QFormLayout;
  form->addRow(tr("Address and port"), address);
  box->addLayout(form);
  auto* said = new QLabel(this);
  said->setObjectName(QStringLiteral("openigtlink_said"));
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
  couplings_.add(model.address, [address](const QString& text) { address->setText(text); });
  couplings_.add(model.said, [said](const QString& text) {
    said->setText(text);
    said->setVisible(!text.isEmpty());
  });
  couplings_.add(model.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
}

}  // namespace glisson::ui
