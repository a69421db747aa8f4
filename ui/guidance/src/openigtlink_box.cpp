// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/openigtlink_box.h"

#include "server_rows.h"

namespace glisson::ui {

OpenIgtLinkBox::OpenIgtLinkBox(OpenIgtLinkModel& model, QWidget* parent) : QWidget(parent) {
  const ServerRows rows = add_server_rows(this, couplings_, model, QStringLiteral("openigtlink"),
                                          tr("Tell them by OpenIGTLink"), tr("Address and port"));
  rows.on->setToolTip(
      tr("Programs that connect are told of each frame: level, pose of the camera, surfaces."));
  rows.address->setToolTip(
      tr("127.0.0.1: only programs of this computer can connect. Another address of this computer lets in "
         "whoever reaches it."));
  couplings_.add(model.address, [rows](const QString& text) { rows.address->setText(text); });
}

}  // namespace glisson::ui
