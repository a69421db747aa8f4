// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>

#include "glisson/engine/case_state.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/ui/common/render_view.h"
#include "glisson/ui/stereo/region_editor.h"

class QLabel;
class QToolButton;

namespace glisson::ui {

/// The middle of the window while stereo pictures are labelled: both pictures side by side, what is drawn on
/// them, and the labelled cloud in three dimensions.
class StereoView : public QWidget {
  Q_OBJECT
 public:
  explicit StereoView(QWidget* parent = nullptr);

  RegionDrawing& drawing() { return drawing_; }
  const RegionDrawing& drawing() const { return drawing_; }
  RegionEditor& editor(stereo::Side side) { return *editors_[static_cast<std::size_t>(side)]; }
  RenderView& cloud() { return *cloud_; }

  /// @param frame, rig may be null.
  void set_pair(std::shared_ptr<const engine::StereoInput> frame, std::shared_ptr<const StereoRig> rig);
  /// @param stale it was made of something that has changed since.
  /// @param points of the pair that it is part of: its density, and where points are missing; null: not
  /// known.
  void set_cloud(std::shared_ptr<const LabelledCloud> cloud, bool stale,
                 std::shared_ptr<const engine::PairPoints> points);
  /// Once the drawing was changed from outside.
  void refresh();
  /// What a click would do, in words.
  QString hint() const;

 signals:
  void regions_edited();
  /// The tool, an unfinished line or the selection.
  void drawing_changed();

 private:
  QToolButton* add_toggle(QWidget* bar, const QString& text, const QString& tip, const QString& name,
                          bool on);
  void build_bar(QWidget* bar);
  void show_guide();
  /// Whether the points were made of these pictures by this calibration. Others lie elsewhere in them, and
  /// are shown in three dimensions only.
  bool are_of_this_pair() const;
  void show_points();
  void show_veil();
  void show_legend();
  void follow(RegionEditor& editor);
  void note_pointer(RegionEditor& editor);

  RegionDrawing drawing_;
  std::array<RegionEditor*, 2> editors_{};
  RenderView* cloud_ = nullptr;
  RegionEditor* under_ = nullptr;  ///< the picture that the pointer is over
  QLabel* hint_ = nullptr;
  QLabel* legend_ = nullptr;
  QToolButton* epipolar_ = nullptr;
  QToolButton* points_ = nullptr;
  QToolButton* used_ = nullptr;
  QToolButton* lacking_ = nullptr;
  QToolButton* loupe_ = nullptr;
  std::shared_ptr<const engine::StereoInput> frame_;
  std::shared_ptr<const StereoRig> rig_;
  std::shared_ptr<const LabelledCloud> shown_;
  std::shared_ptr<const engine::PairPoints> pair_points_;
  bool stale_ = false;
  QImage missing_;  ///< over the left picture; null: not known
  /// Epipolar lines stay at a place that was clicked.
  std::optional<RegionDrawing::Place> pinned_;
};

/// Name of a feature for people.
QString feature_name(Feature feature);

}  // namespace glisson::ui
