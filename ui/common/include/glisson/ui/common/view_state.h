// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/engine/parts/offer.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/common/grey_window.h"
#include "glisson/ui/common/hand.h"
#include "glisson/ui/common/measure_book.h"
#include "glisson/ui/scene/ellipsoid_mark.h"
#include "glisson/ui/scene/patient_scene.h"
#include "glisson/ui/scene/slice_picture.h"
#include "glisson/volume/image.h"

namespace glisson::ui {

/// What the linked views share: the volume, the crosshair, the grey window, the markers, what lies over the
/// slices, and what the mouse means.
class ViewState : public QObject {
  Q_OBJECT
 public:
  static constexpr double kThinnestSlab = 1e-3, kThickestSlab = 0.1;  ///< metres

  using QObject::QObject;

  const std::shared_ptr<const Image>& image() const { return image_; }
  const std::shared_ptr<const LabelMap>& labels() const { return labels_; }
  /// Another image puts the crosshair in its middle.
  void set_volume(std::shared_ptr<const Image> image, std::shared_ptr<const LabelMap> labels);

  const Point<CtFrame>& crosshair() const { return crosshair_; }
  /// Kept inside the volume.
  void set_crosshair(const Point<CtFrame>& p);

  const scene::SliceStyle& style() const { return style_; }
  /// As a person drags it: from then on it is the own one.
  void set_window(double level, double width);
  /// Which of the named windows is shown.
  WindowPreset preset() const { return preset_; }
  /// Shows it in all slices. One that does not apply changes nothing.
  void set_preset(WindowPreset preset);
  /// Hounsfield windows apply to a CT alone.
  bool applies(WindowPreset preset) const;
  /// Of a CT; the last one that was dragged.
  const GreyWindow& own_window() const { return own_; }
  /// As it was kept from an earlier sitting.
  void set_own_window(const GreyWindow& window);
  /// A drag has ended: its window is worth keeping.
  void keep_window() { emit window_kept(); }
  void set_label_opacity(double opacity);
  /// The brightest of a slab of the slab's thickness instead of the slice alone.
  bool shows_slab() const { return style_.slab > 0.0; }
  void set_shows_slab(bool on);
  double slab_thickness() const { return slab_thickness_; }  ///< metres
  /// Kept within kThinnestSlab and kThickestSlab.
  void set_slab_thickness(double metres);
  /// Labels that are not drawn, in the slices or in three dimensions.
  void set_hidden(std::vector<Label> labels);

  const std::vector<scene::Marker>& markers() const { return markers_; }
  void set_markers(std::vector<scene::Marker> markers);
  /// Places with what is doubted of them, over the slices only.
  const std::vector<scene::EllipsoidMark>& ellipsoids() const { return ellipsoids_; }
  void set_ellipsoids(std::vector<scene::EllipsoidMark> ellipsoids);

  /// Labels as they would become, hatched over the slices where they differ; null: none. Of the labels' grid.
  const std::shared_ptr<const LabelMap>& preview() const { return preview_; }
  void set_preview(std::shared_ptr<const LabelMap> labels);
  /// A new segmentation that a person decides about: what it would change is hatched over the slices instead
  /// of a preview; null: none.
  const std::shared_ptr<const engine::SegmentationOffer>& offer() const { return offer_; }
  void set_offer(std::shared_ptr<const engine::SegmentationOffer> offer);
  /// A segmentation that is still growing, outlined over the slices; null: none.
  const std::shared_ptr<const LabelVolume>& evolving() const { return evolving_; }
  void set_evolving(std::shared_ptr<const LabelVolume> labels);
  /// A line at the pointer; null: none.
  const std::shared_ptr<const SliceLine>& line() const { return line_; }
  void set_line(std::shared_ptr<const SliceLine> line);
  /// A box along the patient's axes, drawn over the slices; CT frame, metres. None: nothing is drawn.
  const std::optional<Eigen::AlignedBox3d>& box() const { return box_; }
  void set_box(const std::optional<Eigen::AlignedBox3d>& box);
  /// Whether the 3D view shows the labels' surfaces instead of the model.
  bool shows_labels() const { return shows_labels_; }
  void set_shows_labels(bool on);

  /// What is measured in the slices. While it has a tool, the left button is that tool's.
  MeasureBook& measures() { return *measures_; }
  const MeasureBook& measures() const { return *measures_; }
  bool is_measuring() const { return measures_->tool() != MeasureTool::none; }

  Hand hand() const { return hand_; }
  /// Another one than the crosshair's puts the measuring tool away.
  void set_hand(Hand hand);
  const BrushTip& brush() const { return brush_; }
  void set_brush(const BrushTip& brush);
  /// The pointer over a slice; none: it is elsewhere.
  const std::optional<PointerPlace>& pointer() const { return pointer_; }
  void set_pointer(const std::optional<PointerPlace>& pointer);

  /// Called by the views.
  void pick(const Point<CtFrame>& p);
  void gesture(const SliceGesture& gesture) { emit gestured(gesture); }
  void lasso_volume(const VolumeLasso& lasso) { emit volume_lassoed(lasso); }
  void turn_brush(double notches) { emit brush_turned(notches); }
  /// Lines that are being drawn are dropped by the views.
  void drop_gesture() { emit gesture_dropped(); }

 signals:
  void volume_changed();
  void labels_changed();  ///< and nothing else of the volume
  void crosshair_changed();
  void style_changed();
  void window_kept();
  void markers_changed();
  void ellipsoids_changed();
  void overlays_changed();
  void line_changed();
  void box_changed();
  void shows_labels_changed();
  void hand_changed();
  void brush_changed();
  void pointer_changed();
  void picked(const glisson::Point<glisson::CtFrame>& p);
  /// With Hand::point, span, brush, lasso and box.
  void gestured(const glisson::ui::SliceGesture& gesture);
  void volume_lassoed(const glisson::ui::VolumeLasso& lasso);
  void brush_turned(double notches);
  void gesture_dropped();

 private:
  std::shared_ptr<const Image> image_;
  std::shared_ptr<const LabelMap> labels_;
  std::shared_ptr<const LabelMap> preview_;
  std::shared_ptr<const engine::SegmentationOffer> offer_;
  std::shared_ptr<const LabelVolume> evolving_;
  std::shared_ptr<const SliceLine> line_;
  std::optional<Eigen::AlignedBox3d> box_;
  Point<CtFrame> crosshair_;
  void take_window(WindowPreset preset, const GreyWindow& window);
  void begin_window();  ///< that an image is opened with
  bool is_ct() const { return !image_ || image_->modality == Modality::ct; }

  scene::SliceStyle style_;
  double slab_thickness_ = 1e-2;
  WindowPreset preset_ = WindowPreset::abdomen;
  GreyWindow own_;       ///< of any CT
  GreyWindow own_grey_;  ///< of this image, where it is no CT
  std::vector<scene::Marker> markers_;
  std::vector<scene::EllipsoidMark> ellipsoids_;
  MeasureBook* measures_ = new MeasureBook(this);
  Hand hand_ = Hand::crosshair;
  BrushTip brush_;
  std::optional<PointerPlace> pointer_;
  bool shows_labels_ = false;
};

}  // namespace glisson::ui
