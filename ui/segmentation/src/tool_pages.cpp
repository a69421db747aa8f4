// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/tool_pages.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "glisson/ui/common/number_box.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/label_rows.h"

namespace glisson::ui {
namespace {

/// A row of a form that starts with the widget's name; a check box has its name beside it.
bool has_name_before(const PageField& field) {
  return field.kind == PageField::Kind::number || field.kind == PageField::Kind::choice ||
         field.kind == PageField::Kind::label;
}

}  // namespace

ToolPages::ToolPages(EditSession& session, QWidget* parent, const EditTools& tools)
    : QWidget(parent), session_(session), tools_(tools) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (const EditTool tool : tools_) add_page(tool);
  connect(&session_, &EditSession::tool_changed, this, &ToolPages::show_tool);
  connect(&session_, &EditSession::settings_changed, this, &ToolPages::show_settings);
  connect(&session_, &EditSession::changed, this, &ToolPages::show_settings);  // labels that can be chosen
  show_tool();
  show_settings();
}

void ToolPages::add_page(EditTool tool) {
  if (tool->page_of != nullptr) {
    pages_[tool] = pages_.at(edit_tool(tool->page_of, tools_));
    return;
  }
  if (tool->page.empty()) return;
  auto* page = new QWidget(this);
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(5);
  layout()->addWidget(page);
  pages_[tool] = page;
  for (const PageField& field : tool->page) {
    QWidget* widget = make(field);
    widget->setObjectName(QLatin1String(field.object));
    if (field.tip != nullptr) widget->setToolTip(tr(field.tip));
    if (has_name_before(field))
      form->addRow(tr(field.text), widget);
    else
      form->addRow(widget);
  }
}

QWidget* ToolPages::make(const PageField& field) {
  switch (field.kind) {
    case PageField::Kind::number:
      return make_number(field);
    case PageField::Kind::slider:
      return make_slider(field);
    case PageField::Kind::choice:
      return make_choice(field);
    case PageField::Kind::check:
      return make_check(field);
    case PageField::Kind::label:
      return make_labels(field);
    case PageField::Kind::button:
      break;
  }
  return make_button(field);
}

QString ToolPages::suffix_of(const std::string& unit) const {
  if (unit == "HU") return session_.shows_hounsfield() ? tr(" HU") : QString();
  return unit == "mm" ? tr(" mm") : unit == "ml" ? tr(" ml") : QString();
}

void ToolPages::change(const std::function<void(EditSettings&)>& how) {
  EditSettings next = session_.settings();
  how(next);
  session_.set_settings(next);
}

QWidget* ToolPages::make_number(const PageField& field) {
  auto* box = new NumberBox(this);
  box->setRange(field.range.low, field.range.high);
  box->setSingleStep(field.range.step);
  box->setDecimals(field.range.decimals);
  box->setSuffix(suffix_of(field.range.unit));
  box->setKeyboardTracking(!field.whole_numbers);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, set = field.set](double value) {
    change([&](EditSettings& settings) { set(settings, value); });
  });
  refresh_.emplace_back([this, box, get = field.get, unit = field.range.unit](const EditSettings& settings) {
    show_suffix(*box, suffix_of(unit));
    const QSignalBlocker quiet(box);
    if (std::abs(box->value() - get(settings)) > 1e-9) box->setValue(get(settings));
  });
  return box;
}

QWidget* ToolPages::make_slider(const PageField& field) {
  auto* slider = new QSlider(Qt::Horizontal, this);
  slider->setRange(static_cast<int>(field.range.low), static_cast<int>(field.range.high));
  connect(slider, &QSlider::valueChanged, this, [this, set = field.set](int value) {
    change([&](EditSettings& settings) { set(settings, value); });
  });
  refresh_.emplace_back([slider, get = field.get](const EditSettings& settings) {
    const QSignalBlocker quiet(slider);
    slider->setValue(static_cast<int>(get(settings)));
  });
  return slider;
}

QWidget* ToolPages::make_choice(const PageField& field) {
  auto* box = make_narrow_combo(this);
  for (const char* choice : field.choices) box->addItem(tr(choice));
  connect(box, &QComboBox::currentIndexChanged, this, [this, set = field.set](int index) {
    change([&](EditSettings& settings) { set(settings, index); });
  });
  refresh_.emplace_back([box, get = field.get](const EditSettings& settings) {
    const QSignalBlocker quiet(box);
    box->setCurrentIndex(static_cast<int>(get(settings)));
  });
  return box;
}

QWidget* ToolPages::make_check(const PageField& field) {
  auto* box = new QCheckBox(tr(field.text), this);
  connect(box, &QCheckBox::toggled, this, [this, set = field.set](bool on) {
    change([&](EditSettings& settings) { set(settings, on ? 1.0 : 0.0); });
  });
  refresh_.emplace_back([box, get = field.get](const EditSettings& settings) {
    const QSignalBlocker quiet(box);
    box->setChecked(get(settings) != 0.0);
  });
  return box;
}

QWidget* ToolPages::make_labels(const PageField& field) {
  auto* box = make_narrow_combo(this);
  connect(box, &QComboBox::currentIndexChanged, this, [this, box, set = field.set](int index) {
    if (index >= 0) change([&](EditSettings& settings) { set(settings, box->itemData(index).toDouble()); });
  });
  refresh_.emplace_back([this, box, get = field.get](const EditSettings& settings) {
    const QSignalBlocker quiet(box);
    const int wanted = static_cast<int>(get(settings));
    std::vector<Label> labels = session_.present();
    if (std::find(labels.begin(), labels.end(), static_cast<Label>(wanted)) == labels.end())
      labels.push_back(static_cast<Label>(wanted));
    bool same = box->count() == static_cast<int>(labels.size());
    for (int i = 0; same && i < box->count(); ++i)
      same = box->itemData(i).toInt() == labels[static_cast<std::size_t>(i)];
    if (!same) {
      box->clear();
      for (const Label label : labels) box->addItem(structure_icon(label), structure_text(label), int{label});
    }
    box->setCurrentIndex(box->findData(wanted));
  });
  return box;
}

QWidget* ToolPages::make_button(const PageField& field) {
  auto* button = new QPushButton(tr(field.text), this);
  connect(button, &QPushButton::clicked, this, [this, set = field.set, then = field.then] {
    if (then != nullptr) session_.set_tool(edit_tool(then, tools_));
    change([&](EditSettings& settings) { set(settings, 0.0); });
  });
  return button;
}

void ToolPages::show_tool() {
  for (const auto& [tool, page] : pages_) page->hide();
  if (const auto page = pages_.find(session_.tool()); page != pages_.end()) page->second->show();
}

void ToolPages::show_settings() {
  for (const auto& refresh : refresh_) refresh(session_.settings());
}

}  // namespace glisson::ui
