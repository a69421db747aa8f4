// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/model/tissue_box.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <optional>

#include "glisson/engine/commands/set_tissue.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/fem/materials.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/common/number_box.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

using Kind = fem::Stiffness::Kind;

/// In the order of the choices.
constexpr std::array kKinds = {Kind::as_liver, Kind::soft, Kind::stiff, Kind::given};
constexpr int kByValue = 3;
constexpr int kHealthy = 0, kCirrhotic = 1, kParenchymaByValue = 2;

double modulus_of(const char* preset) { return fem::composite_preset(preset).parenchyma.young_modulus; }

void show_value(QDoubleSpinBox& box, double pascals, bool is_given) {
  const QSignalBlocker quiet(&box);
  box.setValue(1e-3 * pascals);
  box.setEnabled(is_given);
}

/// Whether this, rounded, is what the box says.
bool says(const QDoubleSpinBox& box, double pascals) {
  return box.textFromValue(1e-3 * pascals) == box.textFromValue(box.value());
}

/// Pascals: `former` to the bit where the box says it. @param former negative: there was none
double value_in(const QDoubleSpinBox& box, double former) {
  return former > 0.0 && says(box, former) ? former : 1e3 * box.value();
}

}  // namespace

TissueBox::TissueBox(EngineBridge& engine, QWidget* parent) : QWidget(parent), engine_(engine) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  form_ = new QFormLayout;
  column->addLayout(form_);
  notes_ = make_warning(this);
  notes_->setObjectName(QStringLiteral("stiffness_notes"));
  column->addWidget(notes_);
  parenchyma_ = add_row(structure_text(structure::kParenchyma), QStringLiteral("stiffness_parenchyma"),
                        {tr("Healthy"), tr("Cirrhotic"), tr("By value")});
  connect(&engine_, &EngineBridge::case_changed, this, &TissueBox::show_case);
  connect(&engine_, &EngineBridge::finished, this, [this](const engine::Outcome& outcome) {
    if (outcome.id == posted_) show_warning(*notes_, notes_text(outcome.notes));
  });
  show_case();
}

TissueBox::Row TissueBox::add_row(const QString& name, const QString& object, const QStringList& choices) {
  Row row;
  row.choice = make_narrow_combo(this);
  row.choice->setObjectName(object);
  row.choice->setMinimumContentsLength(6);  // beside it stands a number
  row.choice->addItems(choices);
  row.kilopascals = new NumberBox(this);
  row.kilopascals->setObjectName(object + QStringLiteral("_kpa"));
  row.kilopascals->setRange(1e-3 * fem::kSoftestTissue, 1e-3 * fem::kStiffestTissue);
  row.kilopascals->setDecimals(1);
  row.kilopascals->setSuffix(tr(" kPa"));
  row.kilopascals->setKeyboardTracking(false);  // not with every digit
  auto* both = new QHBoxLayout;
  both->addWidget(row.choice, 1);
  both->addWidget(row.kilopascals);
  form_->addRow(name, both);
  connect(row.choice, &QComboBox::activated, this, &TissueBox::post);
  connect(row.kilopascals, &QDoubleSpinBox::valueChanged, this, &TissueBox::post);
  return row;
}

void TissueBox::show_case() {
  const engine::CaseState& now = engine_.state();
  const bool is_new = now[part::model] != shown_ || now[part::tissue] != shown_tissue_;
  if (now[part::model] != shown_) {
    shown_ = now[part::model];
    notes_->hide();  // they were said of the former one
    show_rows();
  }
  shown_tissue_ = now[part::tissue];
  if (is_new) show_values(engine::tissue_of(now));
}

void TissueBox::show_rows() {
  while (form_->rowCount() > 1) form_->removeRow(1);
  lesions_.clear();
  if (!shown_) return;
  for (const auto& [lesion, centre] : lesion_centres(shown_->model)) {
    lesions_[lesion] =
        add_row(structure_text(lesion), QStringLiteral("stiffness_%1").arg(structure_name(lesion).c_str()),
                {tr("As liver"), tr("Soft"), tr("Stiff"), tr("By value")});
    QComboBox* choice = lesions_[lesion].choice;
    choice->setItemData(1, tr("A third of the liver's Young's modulus"), Qt::ToolTipRole);
    choice->setItemData(2, tr("Five times the liver's Young's modulus"), Qt::ToolTipRole);
  }
}

void TissueBox::show_values(const fem::Tissue& tissue) {
  const double healthy = modulus_of("healthy"), parenchyma = tissue.parenchyma.value_or(healthy);
  // By value somebody may want just what a healthy or a cirrhotic one has.
  const bool stays_by_value = parenchyma_.choice->currentIndex() == kParenchymaByValue && tissue.parenchyma &&
                              says(*parenchyma_.kilopascals, parenchyma);
  const int which = stays_by_value                          ? kParenchymaByValue
                    : parenchyma == healthy                 ? kHealthy
                    : parenchyma == modulus_of("cirrhotic") ? kCirrhotic
                                                            : kParenchymaByValue;
  parenchyma_.choice->setCurrentIndex(which);
  show_value(*parenchyma_.kilopascals, parenchyma, which == kParenchymaByValue);
  for (const auto& [lesion, row] : lesions_) {
    const fem::Stiffness said = tissue.of(lesion);
    const auto at = std::find(kKinds.begin(), kKinds.end(), said.kind);
    row.choice->setCurrentIndex(static_cast<int>(at - kKinds.begin()));
    show_value(*row.kilopascals, said.in(parenchyma), said.kind == Kind::given);
  }
  shown_values_ = tissue;
}

void TissueBox::post() {
  const fem::Tissue tissue = chosen();
  show_values(tissue);
  posted_ = engine_.post(engine::SetTissue{tissue});
}

fem::Tissue TissueBox::chosen() const {
  fem::Tissue tissue;
  const int which = parenchyma_.choice->currentIndex();
  if (which == kCirrhotic) tissue.parenchyma = modulus_of("cirrhotic");
  if (which == kParenchymaByValue)
    tissue.parenchyma = value_in(*parenchyma_.kilopascals, shown_values_.parenchyma.value_or(-1.0));
  for (const auto& [lesion, row] : lesions_) {
    const int choice = row.choice->currentIndex();
    if (choice == 0) continue;
    const fem::Stiffness shown = shown_values_.of(lesion);
    const double former = shown.kind == Kind::given ? shown.young_modulus : -1.0;
    tissue.lesions[lesion] = {kKinds.at(static_cast<std::size_t>(choice)),
                              choice == kByValue ? value_in(*row.kilopascals, former) : 0.0};
  }
  return tissue;
}

}  // namespace glisson::ui
