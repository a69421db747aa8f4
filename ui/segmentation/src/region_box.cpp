// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/region_box.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "glisson/segmentation/segment.h"
#include "glisson/ui/common/number_box.h"
#include "glisson/ui/common/panel.h"

namespace glisson::ui {
namespace {

constexpr double kMm = 1e3;              ///< millimetres in a metre
constexpr double kFinest = 0.3;          ///< mm, as SegmentationOptions has it
constexpr double kCoarsest = 5.0;        ///< mm
constexpr double kBytesPerVoxel = 60.0;  ///< of the region, as SegmentationOptions says
constexpr double kMostVoxels = 50e6;     ///< the same

}  // namespace

RegionBox::RegionBox(ViewState& views, QWidget* parent) : QWidget(parent), views_(views) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(1, 1);
  grid->addWidget(new QLabel(tr("Region"), this), 0, 0);
  draw_ = new QPushButton(tr("Draw box"), this);
  draw_->setObjectName(QStringLiteral("draw_region"));
  draw_->setCheckable(true);
  draw_->setToolTip(tr(
      "Drag a rectangle in a slice, then its edges in the others. Only what lies in the box is looked at and "
      "found anew; the labels outside stay."));
  clear_ = new QPushButton(tr("Whole CT"), this);
  clear_->setObjectName(QStringLiteral("clear_region"));
  clear_->setToolTip(tr("No box: everywhere"));
  for (QPushButton* button : {draw_, clear_}) button->setProperty("role", "small");
  grid->addWidget(draw_, 0, 1);
  grid->addWidget(clear_, 0, 2);
  build_bounds();
  build_resolution();
  size_ = make_explanation({}, this);
  size_->setObjectName(QStringLiteral("region_size"));
  grid->addWidget(size_, 3, 0, 1, 3);
  connect(draw_, &QPushButton::clicked, this, &RegionBox::set_drawing);
  connect(clear_, &QPushButton::clicked, this, [this] {
    set_drawing(false);
    set_region(std::nullopt);
  });
  connect(&views_, &ViewState::gestured, this, &RegionBox::hear);
  connect(&views_, &ViewState::volume_changed, this, &RegionBox::show_volume);
  show_volume();
}

void RegionBox::build_bounds() {
  bounds_ = new QWidget(this);
  auto* rows = new QGridLayout(bounds_);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setHorizontalSpacing(6);
  rows->setVerticalSpacing(4);
  // Low to high in LPS: the numbers of the command line and of other programs.
  const std::array<QString, 3> names = {tr("R to L"), tr("A to P"), tr("I to S")};
  static constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows->addWidget(new QLabel(names[axis], bounds_), static_cast<int>(axis), 0);
    for (std::size_t side = 0; side < 2; ++side) {
      auto* number = new NumberBox(bounds_);
      number->setObjectName(
          QStringLiteral("region_%1_%2")
              .arg(QLatin1String(kAxes[axis]), side == 0 ? QStringLiteral("low") : QStringLiteral("high")));
      number->setDecimals(0);
      number->setSuffix(tr(" mm"));
      number->setToolTip(tr("LPS: to the patient's left, to posterior and upwards is positive"));
      rows->addWidget(number, static_cast<int>(axis), 1 + static_cast<int>(side));
      rows->setColumnStretch(1 + static_cast<int>(side), 1);
      sides_[axis][side] = number;
      connect(number, &QDoubleSpinBox::valueChanged, this, &RegionBox::take_bounds);
      connect(number, &QDoubleSpinBox::editingFinished, this, &RegionBox::show_region);
    }
  }
  static_cast<QGridLayout*>(layout())->addWidget(bounds_, 1, 0, 1, 3);
}

void RegionBox::build_resolution() {
  resolution_ = new NumberBox(this);
  resolution_->setObjectName(QStringLiteral("segment_resolution"));
  resolution_->setRange(kFinest, kCoarsest);
  resolution_->setSingleStep(0.5);
  resolution_->setDecimals(2);
  resolution_->setSuffix(tr(" mm"));
  resolution_->setValue(segmentation::SegmentationOptions{}.working_spacing_mm);
  resolution_->setToolTip(tr("Resolution at which the liver's surface evolves. Finer is slower."));
  own_ = new QPushButton(tr("The CT's own"), this);
  own_->setObjectName(QStringLiteral("own_resolution"));
  own_->setProperty("role", "small");
  auto* grid = static_cast<QGridLayout*>(layout());
  grid->addWidget(new QLabel(tr("Resolution"), this), 2, 0);
  grid->addWidget(resolution_, 2, 1);
  grid->addWidget(own_, 2, 2);
  connect(own_, &QPushButton::clicked, this, [this] {
    resolution_->setValue(views_.image()->grid.spacing_mm.minCoeff());  // the range has its own limits
  });
  connect(resolution_, &QDoubleSpinBox::valueChanged, this, [this] {
    show_size();
    emit changed();
  });
}

double RegionBox::resolution_mm() const { return resolution_->value(); }

Eigen::AlignedBox3d RegionBox::volume_box() const {
  if (!views_.image() || views_.image()->empty()) return {};
  const scene::VolumeBox box = scene::bounding_box(views_.image()->grid);
  return {box.low, box.high};
}

void RegionBox::show_volume() {
  drag_.reset();
  set_drawing(false);
  region_.reset();
  const Eigen::AlignedBox3d volume = volume_box();
  for (QPushButton* button : {draw_, own_}) button->setEnabled(!volume.isEmpty());
  if (!volume.isEmpty())
    for (int axis = 0; axis < 3; ++axis)
      for (QDoubleSpinBox* number : sides_[static_cast<std::size_t>(axis)]) {
        const QSignalBlocker quiet(number);
        number->setRange(std::floor(kMm * volume.min()[axis]), std::ceil(kMm * volume.max()[axis]));
      }
  show_region();
  emit changed();
}

void RegionBox::set_region(const std::optional<Eigen::AlignedBox3d>& region) {
  region_ = region;
  show_region();
  emit changed();
}

void RegionBox::show_region() {
  clear_->setEnabled(region_.has_value());
  bounds_->setVisible(region_.has_value());
  if (region_)
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t side = 0; side < 2; ++side) {
        QDoubleSpinBox* number = sides_[static_cast<std::size_t>(axis)][side];
        const QSignalBlocker quiet(number);
        const double mm = std::round(kMm * (side == 0 ? region_->min() : region_->max())[axis]);
        if (number->value() != mm) number->setValue(mm);  // who types is not interrupted
      }
  show_size();
  if (active_) views_.set_box(region_);
}

void RegionBox::show_size() {
  QString text;
  bool large = false;
  if (region_) {
    const Eigen::Vector3d mm = kMm * region_->sizes();
    const double voxels = mm.prod() / std::pow(resolution_mm(), 3);
    const double gigabytes = 1e-9 * kBytesPerVoxel * voxels;
    const bool fine = resolution_mm() < segmentation::SegmentationOptions{}.working_spacing_mm;
    large = fine && voxels > kMostVoxels;
    text = tr("%1 × %2 × %3 mm").arg(mm.x(), 0, 'f', 0).arg(mm.y(), 0, 'f', 0).arg(mm.z(), 0, 'f', 0);
    if (large)
      text =
          tr("%1: too fine for so large a box if the liver fills it. At most 50 million voxels.").arg(text);
    else if (fine && gigabytes > 0.1)
      text = tr("%1: up to %2 GB of memory").arg(text).arg(gigabytes, 0, 'f', 1);
  }
  size_->setText(text);
  size_->setVisible(!text.isEmpty());
  set_style_property(size_, "role", large ? QStringLiteral("warning") : QStringLiteral("explanation"));
}

void RegionBox::take_bounds() {
  if (!region_) return;
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& [low, high] = sides_[static_cast<std::size_t>(axis)];
    const auto side = [&](const QDoubleSpinBox* number, double drawn) {
      // What was not typed stays as it was drawn: the number is rounded.
      return std::round(kMm * drawn) == number->value() ? drawn : number->value() / kMm;
    };
    box.min()[axis] = side(low, region_->min()[axis]);
    box.max()[axis] = side(high, region_->max()[axis]);
  }
  if ((box.sizes().array() > 0.0).all()) set_region(box);  // while a number is being typed it may not be one
}

void RegionBox::set_active(bool on) {
  if (!on) set_drawing(false);
  active_ = on;
  views_.set_box(on ? region_ : std::nullopt);
}

void RegionBox::set_drawing(bool on) {
  draw_->setChecked(on);
  if (on == drawing_) return;
  drawing_ = on;
  drag_.reset();
  if (on) emit drawing_started();  // whoever has the mouse lets go
  views_.set_hand(on ? Hand::box : Hand::crosshair);
}

bool RegionBox::escape() {
  if (drag_) {
    const auto former = drag_->former();
    drag_.reset();
    views_.drop_gesture();
    set_region(former);
    return true;
  }
  if (!drawing_) return false;
  set_drawing(false);
  return true;
}

void RegionBox::hear(const SliceGesture& gesture) {
  if (!drawing_ || !active_) return;
  if (gesture.phase == SliceGesture::Phase::begin)
    drag_.emplace(region_, volume_box(), gesture.slice.plane, gesture.p.xyz, gesture.reach);
  if (!drag_) return;
  set_region(drag_->to(gesture.p.xyz));
  if (gesture.phase == SliceGesture::Phase::end) drag_.reset();
}

}  // namespace glisson::ui
