// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/look_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QSlider>
#include <array>
#include <iterator>

#include "box_layout.h"

namespace glisson::ui {

LookBox::LookBox(LiveViewModel& model, QWidget* parent) : QWidget(parent) {
  QVBoxLayout* box = make_box_layout(this);
  auto* looks = new QComboBox(this);
  looks->setObjectName(QStringLiteral("look"));
  const std::array<std::pair<QString, QString>, std::size(scene::kLooks)> names = {
      {{tr("Tubes"), tr("Shaded, and fainter with depth")},
       {tr("Focus window"),
        tr("Around the pointer, or else the chosen lesion: opaque and in depth order; outlines elsewhere")},
       {tr("Depth contours"), tr("A line at every 10 mm of depth below the surface")},
       {tr("Outlines"), tr("They hide least of the tissue")}}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    looks->addItem(names[i].first);
    looks->setItemData(static_cast<int>(i), names[i].second, Qt::ToolTipRole);
  }
  looks->setCurrentIndex(static_cast<int>(model.style().look));
  auto* choice = new QFormLayout;
  choice->addRow(tr("Depth as"), looks);
  box->addLayout(choice);
  connect(looks, &QComboBox::currentIndexChanged, &model, [&model](int index) {
    scene::OverlayStyle style = model.style();
    style.look = scene::kLooks[index];
    model.set_style(style);
  });
  const std::array<std::pair<QString, bool scene::OverlayStyle::*>, 7> parts = {
      {{tr("Portal vein"), &scene::OverlayStyle::portal_vein},
       {tr("Hepatic veins"), &scene::OverlayStyle::hepatic_veins},
       {tr("Lesions"), &scene::OverlayStyle::lesions},
       {tr("Liver outline"), &scene::OverlayStyle::outline},
       {tr("Anterior margin"), &scene::OverlayStyle::anterior_margin},
       {tr("Thin branches"), &scene::OverlayStyle::thin_branches},
       {tr("Ruler"), &scene::OverlayStyle::ruler}}};
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
