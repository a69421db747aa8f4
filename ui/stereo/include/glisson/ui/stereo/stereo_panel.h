// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/video.h"
#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/stereo/stereo_view.h"

class QAction;
class QComboBox;
class QLabel;
class QListWidget;
class QMenu;
class QPushButton;
class QSpinBox;

namespace glisson::ui {

/// Stereo pictures to a labelled cloud.
class StereoPanel : public Panel {
  Q_OBJECT
 public:
  explicit StereoPanel(EngineBridge& engine, QWidget* parent = nullptr);
  ~StereoPanel() override;

  QWidget* view() override { return view_; }
  void deactivate() override;
  StereoView& stereo_view() { return *view_; }
  /// From now on the case's video is this one, and its first frame the pair.
  void open_source(const engine::SetVideo& source);

 private:
  void build_input();
  void fill_source_menu(QMenu* menu);
  void build_regions();
  void build_reconstruction();
  void open_calibration();
  void open_text_calibration();
  void calibrate_from_boards();
  void save_calibration();
  void open_pair();
  void open_video();
  void open_two_videos();
  void open_folder();
  void open_device();
  void open_server();
  void describe_source();
  void take_outcome(const engine::Outcome& outcome);
  void choose(const std::optional<RegionDrawing::Tool>& tool);
  void store();
  /// Labels the points anew, where they are of this pair: regions have changed.
  void label();
  void show_case();
  /// The case's regions, and what is left of those of another frame.
  void take_regions(bool is_other_frame);
  void show_drawing();
  void show_region_list();
  void show_figures();
  QString obstacle() const;
  bool rig_fits() const;

  QPointer<StereoView> view_;  ///< belongs to whoever hosts it
  QLabel* calibration_ = nullptr;
  QAction* save_calibration_ = nullptr;
  QLabel* source_ = nullptr;
  QSpinBox* frame_ = nullptr;
  QPushButton* load_frame_ = nullptr;
  std::vector<std::pair<RegionDrawing::Tool, QPushButton*>> tools_;
  QListWidget* list_ = nullptr;
  QPushButton* undo_ = nullptr;
  QPushButton* redo_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* clear_ = nullptr;
  QComboBox* method_ = nullptr;
  QComboBox* kind_ = nullptr;
  TaskButton* run_ = nullptr;
  FiguresTable* figures_ = nullptr;
  QLabel* warnings_ = nullptr;
  std::set<engine::CommandId> storing_;
  std::optional<engine::CommandId> opening_;         ///< a source whose first frame is wanted
  std::optional<stereo::ReconstructOptions> again_;  ///< with which the points that are labelled were made
  QString faults_;            ///< what the last reconstruction found wrong with the pair
  bool label_again_ = false;  ///< regions changed while points were labelled
  std::shared_ptr<const engine::StereoInput> shown_frame_;
  std::shared_ptr<const StereoRig> shown_rig_;
  std::string identity_;                     ///< of that frame
  RegionDrawing::Regions of_another_frame_;  ///< as they stood when that frame came
  std::shared_ptr<const engine::VideoSource> shown_video_;
  std::shared_ptr<const stereo::Regions> taken_;
};

}  // namespace glisson::ui
