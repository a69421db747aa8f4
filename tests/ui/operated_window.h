// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/segmentation/seed_book.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

/// The window and a hand at mouse and keyboard. The engine's scheduling is the real one; what its commands
/// compute is made by FakeOperation.
class OperatedWindow {
 protected:
  void open_window() {
    folder_ = std::make_unique<TemporaryFolder>();
    operation_ = std::make_unique<FakeOperation>();
    make_box_operation(*operation_);
    window_ = std::make_unique<ui::MainWindow>(operation_->options());
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }
  void close_window() {
    operation_->hold = false;
    window_.reset();
    operation_.reset();
    folder_.reset();
  }
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 20000);
  }
  ui::TaskButton* task(const char* name) {
    return window_->findChild<ui::TaskButton*>(QString::fromLatin1(name));
  }
  void press(const char* name) { QTest::mouseClick(task(name)->button(), Qt::LeftButton); }
  engine::StageState stage(engine::Part part) { return window_->engine().snapshot()->stage(part); }
  ui::SliceView& slice(scene::Plane plane) { return window_->views().slice(plane); }
  void click(ui::SliceView& view, const Point<CtFrame>& p) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.widget_point(p).toPoint());
  }
  void open_ct() {
    window_->open("ct.nii");
    QVERIFY(settle());
    QVERIFY(window_->engine().state()[part::image] != nullptr);
  }
  void reach_model() {
    open_ct();
    segmentation::Seeds seeds;
    ui::add_seed(seeds, structure::kParenchyma, {0, 0, 0});
    window_->engine().post(engine::SetSeeds{seeds});
    window_->engine().post(engine::Segment{});
    window_->engine().post(engine::BuildModel{});
    QVERIFY(settle());
  }
  void reach_registration(int frames = 40) {
    reach_model();
    operation_->film(folder_->path() / "scope.mkv", frames);
    window_->engine().post(engine::SetCalibration{"scope.yml"});
    window_->engine().post(engine::SetVideo{operation_->video, {}});
    window_->engine().post(engine::LoadVideoFrame{2});
    window_->engine().post(engine::SetRegions{});
    window_->engine().post(engine::Reconstruct{});
    window_->engine().post(engine::Register{});
    QVERIFY(settle());
    QCOMPARE(stage(part::registration), engine::StageState::current);
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::MainWindow> window_;
};

}  // namespace glisson
