// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/network_box.h"

#include <QFileDialog>
#include <QPushButton>
#include <QVBoxLayout>

#include "glisson/engine/commands/segment_by_network.h"

namespace glisson::ui {

NetworkBox::NetworkBox(EngineBridge& engine, QWidget* parent) : QWidget(parent), engine_(engine) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  choose_ = new QPushButton(tr("Own network…"), this);
  choose_->setObjectName(QStringLiteral("choose_network"));
  choose_->setProperty("role", "small");
  choose_->setToolTip(
      tr("Your own segmentation network: an ONNX file with its sheet, MODEL.json, beside it."));
  connect(choose_, &QPushButton::clicked, this, &NetworkBox::choose);
  column->addWidget(choose_);
  run_ = new TaskButton(
      engine_, tr("Segment by this network"), [this] { return std::optional(command()); }, this);
  run_->setObjectName(QStringLiteral("segment_by_network"));
  run_->watch(command());
  run_->hide();
  column->addWidget(run_);
}

void NetworkBox::choose() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Own network"), {}, tr("Networks (*.onnx)"));
  if (!path.isEmpty()) set_network(path.toStdString());
}

void NetworkBox::set_network(const std::filesystem::path& path) {
  network_ = path;
  const QString name = QString::fromStdString(path.filename().string());
  choose_->setText(choose_->fontMetrics().elidedText(tr("Network: %1").arg(name), Qt::ElideMiddle, 260));
  run_->show();
}

engine::Command NetworkBox::command() const {
  return engine::SegmentByNetwork{network_, {locked_.begin(), locked_.end()}, engine::OverHandWork::offer};
}

}  // namespace glisson::ui
