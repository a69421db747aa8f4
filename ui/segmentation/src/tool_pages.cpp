// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/tool_pages.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <cmath>

#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/label_rows.h"

namespace glisson::ui {
namespace {

using editing::Islands;
using editing::Logical;
using editing::Scissors;
using editing::Smooth;

constexpr double kMm = 1e3;  ///< millimetres in a metre
/// The brush's slider is logarithmic: a vessel's width and a lobe's are both a small move away.
constexpr int kSliderSteps = 200;

int slider_of(double radius) {
  return static_cast<int>(std::lround(kSliderSteps * std::log(radius / kSmallestBrush) /
                                      std::log(kLargestBrush / kSmallestBrush)));
}

double radius_of(int slider) {
  return kSmallestBrush *
         std::pow(kLargestBrush / kSmallestBrush, static_cast<double>(slider) / kSliderSteps);
}

/// A member of the settings as a number.
template <class Member>
std::pair<std::function<double(const EditSettings&)>, std::function<void(EditSettings&, double)>> member(
    Member EditSettings::*which, double factor = 1.0) {
  return {[=](const EditSettings& settings) { return factor * static_cast<double>(settings.*which); },
          [=](EditSettings& settings, double value) {
            if constexpr (std::is_same_v<Member, double>)
              settings.*which = value / factor;
            else
              settings.*which = static_cast<Member>(static_cast<int>(value));
          }};
}

}  // namespace

ToolPages::ToolPages(EditSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  build_brush();
  build_scissors();
  build_threshold();
  build_shapes();
  build_combinations();
  build_mouse_tools();
  connect(&session_, &EditSession::tool_changed, this, &ToolPages::show_tool);
  connect(&session_, &EditSession::settings_changed, this, &ToolPages::show_settings);
  connect(&session_, &EditSession::changed, this, &ToolPages::show_settings);  // labels that can be chosen
  show_tool();
  show_settings();
}

QFormLayout* ToolPages::add_page(const std::vector<EditTool>& tools) {
  auto* page = new QWidget(this);
  auto* form = new QFormLayout(page);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(5);
  layout()->addWidget(page);
  for (const EditTool tool : tools) pages_[tool] = page;
  return form;
}

void ToolPages::change(const std::function<void(EditSettings&)>& how) {
  EditSettings next = session_.settings();
  how(next);
  session_.set_settings(next);
}

QDoubleSpinBox* ToolPages::add_number(QFormLayout* form, const QString& name, const char* object,
                                      const Range& range, const Get& get, const Set& set) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(QLatin1String(object));
  box->setRange(range.low, range.high);
  box->setSingleStep(range.step);
  box->setDecimals(range.decimals);
  box->setSuffix(range.unit);
  form->addRow(name, box);
  connect(box, &QDoubleSpinBox::valueChanged, this,
          [this, set](double value) { change([&](EditSettings& settings) { set(settings, value); }); });
  refresh_.emplace_back([box, get](const EditSettings& settings) {
    const QSignalBlocker quiet(box);
    if (std::abs(box->value() - get(settings)) > 1e-9) box->setValue(get(settings));
  });
  return box;
}

void ToolPages::add_choice(QFormLayout* form, const QString& name, const char* object,
                           const QStringList& choices, const Get& get, const Set& set) {
  auto* box = make_narrow_combo(this);
  box->setObjectName(QLatin1String(object));
  box->addItems(choices);
  form->addRow(name, box);
  connect(box, &QComboBox::currentIndexChanged, this,
          [this, set](int index) { change([&](EditSettings& settings) { set(settings, index); }); });
  refresh_.emplace_back([box, get](const EditSettings& settings) {
    const QSignalBlocker quiet(box);
    box->setCurrentIndex(static_cast<int>(get(settings)));
  });
}

void ToolPages::add_check(QFormLayout* form, const QString& text, const char* object, const Get& get,
                          const Set& set) {
  auto* box = new QCheckBox(text, this);
  box->setObjectName(QLatin1String(object));
  form->addRow(box);
  connect(box, &QCheckBox::toggled, this,
          [this, set](bool on) { change([&](EditSettings& settings) { set(settings, on ? 1.0 : 0.0); }); });
  refresh_.emplace_back([box, get](const EditSettings& settings) {
    const QSignalBlocker quiet(box);
    box->setChecked(get(settings) != 0.0);
  });
}

void ToolPages::add_labels(QFormLayout* form, const QString& name, const char* object, const Get& get,
                           const Set& set) {
  auto* box = make_narrow_combo(this);
  box->setObjectName(QLatin1String(object));
  form->addRow(name, box);
  connect(box, &QComboBox::currentIndexChanged, this, [this, box, set](int index) {
    if (index >= 0) change([&](EditSettings& settings) { set(settings, box->itemData(index).toDouble()); });
  });
  refresh_.emplace_back([this, box, get](const EditSettings& settings) {
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
}

void ToolPages::build_brush() {
  QFormLayout* form = add_page({EditTool::paint, EditTool::erase});
  const auto [radius, set_radius] = member(&EditSettings::brush_radius, 2.0 * kMm);
  add_number(form, tr("Diameter"), "brush_diameter",
             {2.0 * kMm * kSmallestBrush, 2.0 * kMm * kLargestBrush, 1.0, 1, tr(" mm")}, radius, set_radius);
  auto* slider = new QSlider(Qt::Horizontal, this);
  slider->setObjectName(QStringLiteral("brush_slider"));
  slider->setRange(0, kSliderSteps);
  slider->setToolTip(tr("Size of the brush. In a slice: Shift + wheel."));
  form->addRow(slider);
  connect(slider, &QSlider::valueChanged, this, [this](int value) {
    change(
        [&](EditSettings& settings) { settings.brush_radius = 5e-5 * std::round(2e4 * radius_of(value)); });
  });
  refresh_.emplace_back([slider](const EditSettings& settings) {
    const QSignalBlocker quiet(slider);
    slider->setValue(slider_of(settings.brush_radius));
  });
  const auto [ball, set_ball] = member(&EditSettings::ball);
  add_choice(form, tr("Brush"), "brush_shape", {tr("Disc, this slice"), tr("Ball, all slices")}, ball,
             set_ball);
  const auto [any, set_any] = member(&EditSettings::erase_any);
  add_check(form, tr("Erase any label"), "erase_any", any, set_any);
}

void ToolPages::build_scissors() {
  QFormLayout* form = add_page({EditTool::scissors});
  const auto [cut, set_cut] = member(&EditSettings::cut);
  add_choice(form, tr("Does"), "scissors_operation",
             {tr("Fill inside"), tr("Erase inside"), tr("Erase outside")}, cut, set_cut);
  const auto [depth, set_depth] = member(&EditSettings::depth);
  add_choice(form, tr("In slices"), "scissors_depth",
             {tr("This slice only"), tr("A slab around it"), tr("Through the whole volume")}, depth,
             set_depth);
  const auto [slab, set_slab] = member(&EditSettings::slab, kMm);
  add_number(form, tr("Slab"), "scissors_slab", {1.0, 200.0, 1.0, 0, tr(" mm")}, slab, set_slab);
  const auto [any, set_any] = member(&EditSettings::cut_any);
  add_check(form, tr("Erase any label"), "scissors_any", any, set_any);
}

void ToolPages::build_threshold() {
  QFormLayout* form = add_page({EditTool::threshold});
  const auto [low, set_low] = member(&EditSettings::low);
  const auto [high, set_high] = member(&EditSettings::high);
  // The ends push each other, so that the range is never empty. Whole numbers do: the first digit of one that
  // is being typed would push the other end away.
  add_number(form, tr("From"), "threshold_low", {-2000.0, 5000.0, 5.0, 0, tr(" HU")}, low,
             [](EditSettings& settings, double value) {
               settings.low = value;
               settings.high = std::max(settings.high, value);
             })
      ->setKeyboardTracking(false);
  add_number(form, tr("To"), "threshold_high", {-2000.0, 5000.0, 5.0, 0, tr(" HU")}, high,
             [](EditSettings& settings, double value) {
               settings.high = value;
               settings.low = std::min(settings.low, value);
             })
      ->setKeyboardTracking(false);
  const auto [replace, set_replace] = member(&EditSettings::replace);
  add_check(form, tr("Forget what the label had before"), "threshold_replace", replace, set_replace);
  auto* mask = new QPushButton(tr("Use the range for painting"), this);
  mask->setObjectName(QStringLiteral("threshold_mask"));
  mask->setToolTip(tr("Tools then change only voxels of these intensities; paint comes next."));
  form->addRow(mask);
  connect(mask, &QPushButton::clicked, this, [this] {
    session_.set_tool(EditTool::paint);
    change([](EditSettings& settings) { settings.region.intensity = {settings.low, settings.high}; });
  });
}

void ToolPages::build_shapes() {
  QFormLayout* smooth = add_page({EditTool::smooth});
  const auto [method, set_method] = member(&EditSettings::smooth);
  add_choice(smooth, tr("Method"), "smooth_method",
             {tr("Median"), tr("Closing: fills gaps"), tr("Opening: takes spikes"), tr("Joint: all labels")},
             method, set_method);
  const auto [radius, set_radius] = member(&EditSettings::smooth_radius, kMm);
  add_number(smooth, tr("Radius"), "smooth_radius", {0.5, 20.0, 0.5, 1, tr(" mm")}, radius, set_radius);

  QFormLayout* margin = add_page({EditTool::margin});
  const auto [shrink, set_shrink] = member(&EditSettings::shrink);
  add_choice(margin, tr("Does"), "margin_direction", {tr("Grow"), tr("Shrink")}, shrink, set_shrink);
  const auto [distance, set_distance] = member(&EditSettings::margin, kMm);
  add_number(margin, tr("By"), "margin_distance", {0.5, 50.0, 0.5, 1, tr(" mm")}, distance, set_distance);

  QFormLayout* holes = add_page({EditTool::fill_holes});
  const auto [slices, set_slices] = member(&EditSettings::holes_in_slices);
  add_check(holes, tr("Holes of one slice, too"), "holes_in_slices", slices, set_slices);

  QFormLayout* between = add_page({EditTool::interpolate});
  const auto [plane, set_plane] = member(&EditSettings::between);
  add_choice(between, tr("Slices"), "interpolate_plane", {tr("Axial"), tr("Coronal"), tr("Sagittal")}, plane,
             set_plane);

  QFormLayout* islands = add_page({EditTool::islands});
  const auto [operation, set_operation] = member(&EditSettings::islands);
  add_choice(islands, tr("Does"), "islands_operation",
             {tr("Keep the largest"), tr("Remove small ones"), tr("Keep the one that is clicked"),
              tr("Remove the one that is clicked"), tr("Split: a label for each")},
             operation, set_operation);
  const auto [smallest, set_smallest] = member(&EditSettings::smallest_ml);
  add_number(islands, tr("Smaller than"), "islands_smallest", {0.01, 100.0, 0.1, 2, tr(" ml")}, smallest,
             set_smallest);
}

void ToolPages::build_combinations() {
  QFormLayout* logical = add_page({EditTool::logical});
  const auto [operation, set_operation] = member(&EditSettings::logical);
  add_choice(logical, tr("Does"), "logical_operation",
             {tr("Copy from"), tr("Add"), tr("Subtract"), tr("Keep what is also in"), tr("Invert"),
              tr("Clear"), tr("Fill everything")},
             operation, set_operation);
  const auto [other, set_other] = member(&EditSettings::other);
  add_labels(logical, tr("Other label"), "logical_other", other, set_other);

  QFormLayout* grow = add_page({EditTool::grow});
  const auto [reach, set_reach] = member(&EditSettings::reach, kMm);
  add_number(grow, tr("No farther than"), "grow_reach", {1.0, 200.0, 1.0, 0, tr(" mm")}, reach, set_reach);
}

void ToolPages::build_mouse_tools() {
  QFormLayout* branch = add_page({EditTool::move_branch});
  const auto [off, set_off] = member(&EditSettings::cut_branch_off);
  add_choice(branch, tr("The branch"), "branch_goes", {tr("goes to the other tree"), tr("is cut off")}, off,
             set_off);
}

void ToolPages::show_tool() {
  for (const auto& [tool, page] : pages_) page->hide();
  if (const auto page = pages_.find(session_.tool()); page != pages_.end()) page->second->show();
}

void ToolPages::show_settings() {
  for (const auto& refresh : refresh_) refresh(session_.settings());
}

}  // namespace glisson::ui
