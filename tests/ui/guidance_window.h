// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QElapsedTimer>
#include <QKeySequence>
#include <QLabel>
#include <QShortcut>
#include <QTest>
#include <algorithm>
#include <memory>
#include <utility>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

/// The window at its guidance step, with a quick operation, and what is read off the panel and its picture.
class GuidanceWindow {
 protected:
  void open_window() {
    folder_ = std::make_unique<TemporaryFolder>();
    operation_ = std::make_unique<FakeOperation>();
    make_box_operation(*operation_);
    window_ = std::make_unique<ui::MainWindow>(with_other_case());
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }
  void close_window() {
    window_.reset();
    moments_of_other_.reset();
    operation_.reset();
    folder_.reset();
  }
  /// FakeOperation opens no cases: here every one holds a CT and these moments, if any, and nothing else.
  engine::Engine::Options with_other_case() const {
    engine::Engine::Options options = operation_->options();
    options.apply = [this, apply = options.apply, ct = std::make_shared<const Image>(operation_->ct)](
                        const engine::CaseState& state, const engine::Command& command,
                        const RunContext& context,
                        const engine::Services& services) -> Cancellable<engine::Applied> {
      if (command.as<engine::OpenCase>() == nullptr) return apply(state, command, context, services);
      engine::Applied applied;
      applied.state[part::image] = ct;
      applied.state.stamp(part::image).revision = 1;
      if (moments_of_other_) {
        applied.state[part::moments] = moments_of_other_;
        applied.state.stamp(part::moments).revision = 1;
      }
      applied.keeps_stamps = true;
      return applied;
    };
    return options;
  }
  void post(engine::Command command) {
    window_->engine().post(std::move(command));
    QVERIFY(QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 20000));
  }
  void reach_registration(int frames) {
    operation_->film(folder_->path() / "scope.mkv", frames);
    post(engine::ImportImage{"ct.nii"});
    post(engine::SetSeeds{});
    post(engine::Segment{});
    post(engine::BuildModel{});
    post(engine::SetLandmarks{operation_->model.landmarks});
    post(engine::SetCalibration{"scope.yml"});
    post(engine::SetVideo{operation_->video, {}});
    post(engine::LoadVideoFrame{2});
    post(engine::SetRegions{});
    post(engine::Reconstruct{});
    post(engine::Register{});
    QCOMPARE(window_->engine().snapshot()->stage(part::registration), engine::StageState::current);
    window_->show_step(ui::MainWindow::guidance);
    QTRY_VERIFY_WITH_TIMEOUT(window_->drawables().drawable() != nullptr, 20000);
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("Registered frame 2, not live")), 20000);
  }

  ui::GuidancePanel& panel() const { return *window_->findChild<ui::GuidancePanel*>(); }
  const Picture& picture() const { return panel().picture().picture(); }
  bool is_tracking() const { return window_->engine().snapshot()->tracking; }
  ui::TaskButton* task(const char* name) const {
    return window_->findChild<ui::TaskButton*>(QString::fromLatin1(name));
  }
  void press(const char* name) const { QTest::mouseClick(task(name)->button(), Qt::LeftButton); }
  QCheckBox* lesions() const {
    const QList<QCheckBox*> boxes = panel().findChildren<QCheckBox*>();
    const auto box = std::find_if(boxes.begin(), boxes.end(), [](const QCheckBox* one) {
      return one->text() == QStringLiteral("Lesions");
    });
    return box == boxes.end() ? nullptr : *box;
  }

  static QString words_on(const QWidget& widget) {
    QStringList words;
    for (const QLabel* label : widget.findChildren<QLabel*>())
      if (!label->isHidden() && !label->text().isEmpty()) words << label->text();
    return words.join(QLatin1Char('\n'));
  }
  /// Above and below the picture.
  QString said() const { return words_on(live_view()); }
  ui::LiveView& live_view() const { return *panel().view()->findChild<ui::LiveView*>(); }
  /// Under the button; empty: it can be pressed.
  QString obstacle(const char* name) const {
    const QString words = words_on(*task(name));
    return task(name)->button()->isEnabled() ? QString() : words;
  }
  bool is_blank() const {
    for (const QLabel* label : live_view().findChildren<QLabel*>())
      if (label->property("fresh").isValid()) return false;
    const bool has_live_figures = words_on(panel()).contains(QStringLiteral("Drawing"));
    return picture().empty() && said().isEmpty() && !has_live_figures;
  }
  /// Also of what was on its way nothing comes.
  bool stays_blank() const {
    return !QTest::qWaitFor([this] { return !is_blank(); }, 500);
  }
  /// No picture is on its way any more.
  bool rests() const {
    int shown = -1;
    QElapsedTimer since;
    return QTest::qWaitFor(
        [&] {
          if (std::exchange(shown, panel().pictures_shown()) != panel().pictures_shown()) since.start();
          return since.elapsed() > 500;
        },
        20000);
  }
  /// Of both, the panel's and the picture's.
  bool do_keys_undo() const {
    const QList<QShortcut*> keys =
        panel().findChildren<QShortcut*>() + panel().view()->findChildren<QShortcut*>();
    return std::any_of(keys.begin(), keys.end(), [](const QShortcut* one) {
      return one->key() == QKeySequence(QKeySequence::Undo) && one->isEnabled();
    });
  }
  /// The next one, after the lesions were switched on or off. Empty: none came.
  Picture picture_with_other_style() const {
    const int before = panel().pictures_shown();
    lesions()->click();
    const bool came = QTest::qWaitFor([&] { return panel().pictures_shown() > before; }, 20000);
    return came ? picture() : Picture{};
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::MainWindow> window_;
  std::shared_ptr<const engine::KeptMoments> moments_of_other_;
};

}  // namespace glisson
