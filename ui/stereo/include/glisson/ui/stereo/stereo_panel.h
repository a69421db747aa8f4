// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <map>
#include <set>

#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/render_view.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/stereo/region_editor.h"

class QLabel;
class QListWidget;
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
  RegionEditor& editor() { return *editor_; }

 private:
  void build_input();
  void build_regions();
  void build_view();
  void open_calibration();
  void open_pair();
  void open_video();
  void choose(std::optional<Feature> feature);
  void store();
  void show_case();
  void show_cloud();
  void show_region_list();
  QString obstacle() const;

  QPointer<QWidget> view_;  ///< belongs to whoever hosts it
  RegionEditor* editor_ = nullptr;
  PictureView* right_ = nullptr;
  RenderView* cloud_ = nullptr;
  QLabel* calibration_ = nullptr;
  QLabel* source_ = nullptr;
  QSpinBox* frame_ = nullptr;
  QPushButton* load_frame_ = nullptr;
  QPushButton* clear_ = nullptr;
  std::map<Feature, QPushButton*> features_;
  QListWidget* list_ = nullptr;
  TaskButton* run_ = nullptr;
  FiguresTable* figures_ = nullptr;
  std::set<engine::CommandId> storing_;
  std::shared_ptr<const engine::StereoInput> shown_frame_;
  std::shared_ptr<const LabelledCloud> shown_cloud_;
  std::shared_ptr<const stereo::Regions> taken_;
};

}  // namespace glisson::ui
