// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/stereo_view.h"

#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <map>

#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/stereo/density.h"
#include "glisson/stereo/epipolar.h"
#include "glisson/stereo/source.h"
#include "glisson/ui/scene/colours.h"

namespace glisson::ui {
namespace {

using stereo::Side;
using Click = RegionDrawing::Click;

Side other(Side side) { return side == Side::left ? Side::right : Side::left; }

/// Darkens what is not used: where the mask is zero.
QImage veil_of(const Picture& mask) {
  QImage veil(mask.width, mask.height, QImage::Format_ARGB32);
  for (int y = 0; y < mask.height; ++y) {
    auto* row = reinterpret_cast<QRgb*>(veil.scanLine(y));
    for (int x = 0; x < mask.width; ++x) {
      const auto at = static_cast<std::size_t>((y * mask.width + x) * mask.channels);
      row[x] = (*mask.bytes)[at] != 0 ? qRgba(0, 0, 0, 0) : qRgba(60, 20, 20, 170);
    }
  }
  return veil;
}

/// Orange where points are missing (stronger: none at all), blue where there are enough.
QImage picture_of(const stereo::DensityMap& map) {
  QImage image(map.columns, map.rows, QImage::Format_ARGB32_Premultiplied);
  for (int row = 0; row < map.rows; ++row)
    for (int column = 0; column < map.columns; ++column) {
      const double density = map.at(column, row);
      const QColor colour = density < 0.0                  ? QColor(0, 0, 0, 0)
                            : density >= map.least_per_cm2 ? QColor(86, 180, 233, 70)
                            : density > 0.0                ? QColor(230, 159, 0, 110)
                                                           : QColor(213, 94, 0, 150);
      image.setPixelColor(column, row, colour);
    }
  return image.scaled(map.columns * map.cell, map.rows * map.cell);
}

/// What reconstruction leaves out by itself: everything outside the laparoscope's circle.
QImage circle_veil(const Picture& picture) {
  const auto circle = stereo::find_scope_circle(picture);
  return circle ? veil_of(stereo::circle_mask(*circle, picture.width, picture.height)) : QImage();
}

/// The veil with the cells over it, as large as the picture.
QImage with_cells(const QImage& veil, const QImage& cells, const Picture& picture) {
  if (cells.isNull() || picture.empty()) return veil;
  QImage both(picture.width, picture.height, QImage::Format_ARGB32_Premultiplied);
  both.fill(Qt::transparent);
  QPainter painter(&both);
  if (!veil.isNull()) painter.drawImage(0, 0, veil);
  painter.drawImage(0, 0, cells);
  return both;
}

}  // namespace

QString feature_name(Feature feature) {
  switch (feature) {
    case Feature::surface:
      return StereoView::tr("Surface");
    case Feature::anterior_margin:
      return StereoView::tr("Anterior margin");
    case Feature::umbilical_notch:
      return StereoView::tr("Umbilical notch");
  }
  return {};
}

StereoView::StereoView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("stereo_view"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* bar = new QWidget(this);
  layout->addWidget(bar);
  auto* rows = new QSplitter(Qt::Vertical, this);
  rows->setChildrenCollapsible(false);
  auto* pictures = new QSplitter(Qt::Horizontal, rows);
  pictures->setChildrenCollapsible(false);
  for (const Side side : {Side::left, Side::right}) {
    auto* editor = new RegionEditor(side, side == Side::left ? tr("Left") : tr("Right"), drawing_, pictures);
    editor->set_hint(tr("Load a stereo pair or a video, and the laparoscope's calibration."));
    editor->setObjectName(side == Side::left ? QStringLiteral("left_picture")
                                             : QStringLiteral("right_picture"));
    pictures->addWidget(editor);
    editors_[static_cast<std::size_t>(side)] = editor;
    follow(*editor);
  }
  cloud_ = new RenderView(rows);
  cloud_->set_title(tr("Reconstructed points"));
  cloud_->set_hint(tr("No points yet"));
  legend_ = new QLabel(cloud_);
  legend_->setObjectName(QStringLiteral("cloud_legend"));
  legend_->setAttribute(Qt::WA_TransparentForMouseEvents);
  legend_->setStyleSheet(QStringLiteral(
      "background: rgba(12, 16, 20, 170); color: #e1e6e9; padding: 4px 8px; border-radius: 3px;"));
  legend_->move(6, 34);
  legend_->hide();
  rows->addWidget(pictures);
  rows->addWidget(cloud_);
  rows->setStretchFactor(0, 1);
  rows->setStretchFactor(1, 1);
  build_bar(bar);
  layout->addWidget(rows, 1);
  refresh();
}

QToolButton* StereoView::add_toggle(QWidget* bar, const QString& text, const QString& tip,
                                    const QString& name, bool on) {
  auto* button = new QToolButton(bar);
  button->setText(text);
  button->setToolTip(tip);
  button->setCheckable(true);
  button->setChecked(on);
  button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard with the pictures
  button->setObjectName(name);
  bar->layout()->addWidget(button);
  return button;
}

void StereoView::build_bar(QWidget* bar) {
  bar->setProperty("role", "viewbar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(6, 3, 6, 3);
  row->setSpacing(6);
  epipolar_ = add_toggle(bar, tr("Epipolar lines"),
                         tr("Where the other picture can show what lies under the pointer. A click "
                            "keeps the line; another click next to it lets it go."),
                         QStringLiteral("show_epipolar"), false);
  points_ = add_toggle(bar, tr("Points"), tr("The reconstructed points in both pictures"),
                       QStringLiteral("show_points"), true);
  used_ = add_toggle(bar, tr("Area used"),
                     tr("Darkens what is not reconstructed: outside the mask, or outside the laparoscope's "
                        "circle."),
                     QStringLiteral("show_used"), false);
  lacking_ = add_toggle(bar, tr("Missing points"),
                        tr("Orange where the left picture has fewer points per cm² than registration needs, "
                           "blue where it has enough."),
                        QStringLiteral("show_missing"), false);
  loupe_ = add_toggle(bar, tr("Loupe"), tr("Enlarges what is under the pointer while you draw."),
                      QStringLiteral("show_loupe"), true);
  hint_ = new QLabel(bar);
  hint_->setProperty("role", "explanation");
  hint_->setObjectName(QStringLiteral("stereo_hint"));
  hint_->setContentsMargins(8, 0, 8, 3);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  static_cast<QVBoxLayout*>(layout())->addWidget(hint_);  // below the bar, which has no room for it
  row->addStretch(1);
  connect(epipolar_, &QToolButton::toggled, this, [this] {
    pinned_.reset();
    show_guide();
  });
  connect(points_, &QToolButton::toggled, this, &StereoView::show_points);
  connect(used_, &QToolButton::toggled, this, &StereoView::show_veil);
  connect(lacking_, &QToolButton::toggled, this, &StereoView::show_veil);
  connect(loupe_, &QToolButton::toggled, this, [this](bool on) {
    for (RegionEditor* editor : editors_) editor->set_loupe(on);
  });
}

void StereoView::follow(RegionEditor& editor) {
  connect(&editor, &RegionEditor::regions_edited, this, &StereoView::regions_edited);
  connect(&editor, &RegionEditor::drawing_changed, this, [this, &editor] {
    note_pointer(editor);
    refresh();
    emit drawing_changed();
  });
  connect(&editor, &RegionEditor::pointer_moved, this, [this, &editor] {
    note_pointer(editor);
    show_guide();
    hint_->setText(hint());
  });
  connect(&editor, &RegionEditor::zoomed, this, [this] { hint_->setText(hint()); });
  connect(&editor, &RegionEditor::pointed, this, [this, &editor] {
    if (!epipolar_->isChecked()) return;
    pinned_ = pinned_ ? std::nullopt : std::optional(editor.place_at(*editor.pointer()));
    show_guide();
  });
}

void StereoView::note_pointer(RegionEditor& editor) {
  if (editor.pointer())
    under_ = &editor;
  else if (under_ == &editor)
    under_ = nullptr;
}

void StereoView::set_pair(std::shared_ptr<const engine::StereoInput> frame,
                          std::shared_ptr<const StereoRig> rig) {
  if (frame == frame_ && rig == rig_) return;
  const bool other_frame = frame != frame_;
  frame_ = std::move(frame);
  rig_ = std::move(rig);
  pinned_.reset();
  if (other_frame) {
    editor(Side::left).set_picture(frame_ ? frame_->frame.left : Picture());
    editor(Side::right).set_picture(frame_ ? frame_->frame.right : Picture());
  }
  show_veil();
  epipolar_->setEnabled(frame_ && rig_);
  used_->setEnabled(frame_ != nullptr);
  show_guide();
  show_points();
  refresh();
}

void StereoView::set_cloud(std::shared_ptr<const LabelledCloud> cloud, bool stale,
                           std::shared_ptr<const engine::PairPoints> points) {
  const bool first = !shown_ && cloud;
  const bool changed = shown_ != cloud || pair_points_ != points;
  const bool other_age = stale_ != stale;
  shown_ = std::move(cloud);
  pair_points_ = std::move(points);
  stale_ = stale;
  if (changed) {
    cloud_->set_hint(shown_ ? QString() : tr("No points yet"));
    cloud_->patient().set_cloud(shown_ ? *shown_ : LabelledCloud());
    if (first) cloud_->patient().look_from(scene::ViewFrom::camera);
    cloud_->update();
    show_points();
    missing_ =
        pair_points_ && pair_points_->density.columns > 0 ? picture_of(pair_points_->density) : QImage();
    lacking_->setEnabled(!missing_.isNull());
    show_veil();
  } else if (other_age) {
    show_points();
  }
  show_legend();
}

void StereoView::refresh() {
  for (RegionEditor* editor : editors_) {
    editor->update_cursor();
    editor->update();
  }
  hint_->setText(hint());
}

void StereoView::show_guide() {
  for (RegionEditor* editor : editors_) editor->set_guide({}, std::nullopt);
  if (!epipolar_->isChecked() || !frame_ || !rig_) return;
  std::optional<RegionDrawing::Place> place = pinned_;
  if (!pinned_ && under_ != nullptr) place = under_->place_at(*under_->pointer());
  if (!place) return;
  editor(place->side).set_guide({}, place->pixel);
  editor(other(place->side))
      .set_guide(stereo::epipolar_line(*rig_, place->side, place->pixel).pixels, std::nullopt);
}

bool StereoView::are_of_this_pair() const {
  // An imported cloud goes by the pictures and the calibration that were there when it came.
  return pair_points_ ? pair_points_->frame == frame_ && pair_points_->rig == rig_ : !stale_;
}

void StereoView::show_points() {
  const bool shows = points_->isChecked() && shown_ && rig_ && are_of_this_pair();
  for (const Side side : {Side::left, Side::right}) {
    std::vector<Eigen::Vector2d> dots;
    std::vector<Feature> features;
    for (int i = 0; shows && i < shown_->size(); ++i) {
      const Point<CameraFrame> p(Eigen::Vector3d(shown_->points.row(i).transpose()));
      const Eigen::Vector3d seen = side == Side::left ? p.xyz : (rig_->right_from_left * p).xyz;
      const Camera& camera = side == Side::left ? rig_->left : rig_->right;
      if (!camera.shows(seen)) continue;
      dots.push_back(camera.project(seen));
      features.push_back(shown_->feature(i));
    }
    editor(side).set_dots(std::move(dots), std::move(features));
  }
}

void StereoView::show_veil() {
  QImage left, right;
  if (used_->isChecked() && frame_) {
    left = frame_->mask.empty() ? circle_veil(frame_->frame.left) : veil_of(frame_->mask);
    if (frame_->mask.empty()) right = circle_veil(frame_->frame.right);
  }
  if (lacking_->isChecked() && are_of_this_pair())
    left = with_cells(left, missing_, editor(Side::left).picture());
  editor(Side::left).set_veil(left);
  editor(Side::right).set_veil(right);
}

void StereoView::show_legend() {
  legend_->setVisible(shown_ != nullptr);
  if (!shown_) return;
  std::map<Feature, int> counts;
  for (int i = 0; i < shown_->size(); ++i) ++counts[shown_->feature(i)];
  QStringList lines;
  for (const auto& [feature, count] : counts)
    lines << QStringLiteral("<span style='color:%1'>●</span> %2: %3")
                 .arg(scene::colour_of(feature).name(), feature_name(feature).toHtmlEscaped())
                 .arg(count);
  if (pair_points_ && pair_points_->area_cm2 > 0.0)
    lines << tr("%1 points per cm²").arg(pair_points_->density_per_cm2, 0, 'f', 1);
  if (stale_) lines << QStringLiteral("<i>%1</i>").arg(tr("Out of date: reconstruct again").toHtmlEscaped());
  legend_->setText(lines.join(QStringLiteral("<br>")));
  legend_->adjustSize();
}

QString StereoView::hint() const {
  if (!frame_) return {};
  const stereo::Region* line = drawing_.unfinished();
  if (under_ == nullptr) {
    if (line != nullptr) return tr("Enter or a double click ends the line; Backspace takes a corner back.");
    if (drawing_.tool())
      return tr("Click around \"%1\" in either picture.").arg(feature_name(drawing_.tool()->feature));
    return tr(
        "Choose a feature on the right to label it. The wheel enlarges a picture, the middle button "
        "moves it.");
  }
  switch (drawing_.click_at(under_->place_at(*under_->pointer()))) {
    case Click::begin:
      return drawing_.tool()->closed ? tr("Click: the outline begins here. Esc: stop drawing.")
                                     : tr("Click: the line begins here. Esc: stop drawing.");
    case Click::add:
      return tr("Click: next corner. Enter, double click: end. Backspace: one back. Esc: drop.");
    case Click::close:
      return tr("Click: closes the outline.");
    case Click::end_curve:
      return tr("Click: ends the line here.");
    case Click::wrong_picture:
      return tr("The line was begun in the other picture. Enter ends it, Esc drops it.");
    case Click::drag:
      return tr("Drag: moves this corner.");
    case Click::insert:
      return tr("Click or drag: a new corner here. Delete: removes the region.");
    case Click::select:
      return tr("Click: selects this region. Right click: removes it.");
    case Click::nothing:
      return tr("Choose a feature on the right to label it.");
  }
  return {};
}

}  // namespace glisson::ui
