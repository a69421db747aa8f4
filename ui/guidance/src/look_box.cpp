// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/look_box.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QSlider>
#include <array>

#include "box_layout.h"

namespace glisson::ui {

LookBox::LookBox(LiveViewModel& model, QWidget* parent) : QWidget(parent) {
  QVBoxLayout* box = make_box_layout(this);
  const std::array<std::pair<QString, bool scene::OverlayStyle::*>, 5> parts = {
      {{tr("Portal vein"), &scene::OverlayStyle::portal_vein},
       {tr("Hepatic veins"), &scene::OverlayStyle::hepatic_veins},
       {tr("Lesions"), &scene::OverlayStyle::lesions},
       {tr("Liver outline"), &scene::OverlayStyle::outline},
       {tr("Anterior margin"), &scene::OverlayStyle::anterior_margin}}};
  auto* grid = new QGridLayout;
  int cell = 0;
  for (const auto& [name, member] : parts) {
    auto* check = new QCheckBox(name, this);
    check->setChecked(model.style().*member);
    grid->addWidget(check, cell / 2, cell % 2);
    ++cell;
    connect(check, &QCheckBox::toggled, &model, [&model, shown = member](bool on) {
      scene::OverlayStyle style = model.style();
      style.*shown = on;
      model.set_style(style);
    });
  }
  box->addLayout(grid);
  auto* opacity = new QSlider(Qt::Horizontal, this);
  opacity->setRange(10, 100);
  opacity->setValue(static_cast<int>(100 * model.style().opacity));
  auto* form = new QFormLayout;
  form->addRow(tr("Vessel opacity"), opacity);
  box->addLayout(form);
  connect(opacity, &QSlider::valueChanged, &model, [&model](int value) {
    scene::OverlayStyle style = model.style();
    style.opacity = value / 100.0;
    model.set_style(style);
  });
}

}  // namespace glisson::ui
