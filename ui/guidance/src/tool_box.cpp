// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/tool_box.h"

#include "server_rows.h"

namespace glisson::ui {

ToolBox::ToolBox(ToolModel& model, QWidget* parent) : QWidget(parent) {
  const ServerRows rows = add_server_rows(this, couplings_, model, QStringLiteral("tool"),
                                          tr("Take a tool's tip from a server"), tr("Server and tool"));
  rows.on->setToolTip(tr("While the tip is within 5 mm of the organ's surface it marks the place there."));
  rows.address->setText(QStringLiteral("127.0.0.1:18944/TipToLeftCamera"));
  rows.address->setToolTip(
      tr("Address and port, and the name of the transform from the tool's tip to the left camera."));
}

}  // namespace glisson::ui
