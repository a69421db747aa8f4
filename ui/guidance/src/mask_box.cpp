// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/mask_box.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "box_layout.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {

MaskBox::MaskBox(MaskModel& model, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("mask_box"));
  QVBoxLayout* box = make_box_layout(this);
  auto* choose = new QPushButton(this);
  choose->setObjectName(QStringLiteral("choose_mask_network"));
  choose->setToolTip(
      tr("Your own network that says what of the picture is not liver: an ONNX file with its sheet, "
         "MODEL.json, beside it. It only keeps points from pulling the model."));
  auto* remove = new QPushButton(tr("Remove"), this);
  remove->setObjectName(QStringLiteral("remove_mask_network"));
  remove->setToolTip(tr("The organ is followed without the network, at once"));
  auto* row = new QHBoxLayout;
  row->addWidget(choose, 1);
  row->addWidget(remove);
  box->addLayout(row);
  auto* said = new QLabel(this);
  said->setObjectName(QStringLiteral("mask_said"));
  said->setWordWrap(true);
  box->addWidget(said);

  connect(choose, &QPushButton::clicked, &model, [this, &model] {
    const QString path = QFileDialog::getOpenFileName(this, tr("Mask network"), {}, tr("Networks (*.onnx)"));
    if (!path.isEmpty()) model.choose(path.toStdString());
  });
  connect(remove, &QPushButton::clicked, &model, &MaskModel::remove);
  couplings_.add(model.name, [choose, remove](const QString& name) {
    constexpr int kWidth = 190;  // pixels
    choose->setText(
        name.isEmpty() ? tr("Mask network…")
                       : choose->fontMetrics().elidedText(tr("Mask: %1").arg(name), Qt::ElideMiddle, kWidth));
    remove->setVisible(!name.isEmpty());
  });
  couplings_.add(model.said, [said](const QString& text) {
    said->setText(text);
    said->setVisible(!text.isEmpty());
  });
  couplings_.add(model.tone, [said](const QString& tone) { set_style_property(said, "role", tone); });
}

}  // namespace glisson::ui
