// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <memory>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/task_button.h"

namespace glisson {

/// For tests of single boxes of the guidance panel: an engine with a quick operation, and what is read off a
/// box.
class GuidanceBench {
 protected:
  void set_up() {
    folder_ = std::make_unique<TemporaryFolder>();
    operation_ = std::make_unique<FakeOperation>();
    make_box_operation(*operation_);
    engine_ = std::make_unique<ui::EngineBridge>(operation_->options());
  }
  void take_down() {
    engine_.reset();
    operation_.reset();
    folder_.reset();
  }
  void post(engine::Command command) {
    engine_->post(std::move(command));
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 20000));
  }
  void reach_cloud(int frames) {
    for (const engine::Command& step : operation_->steps_to_cloud(folder_->path() / "scope.mkv", frames))
      post(step);
  }
  void reach_registration(int frames) {
    reach_cloud(frames);
    post(engine::Register{});
    QCOMPARE(engine_->snapshot()->stage(part::registration), engine::StageState::current);
  }
  static QString words_on(const QWidget& widget) {
    QStringList words;
    for (const QLabel* label : widget.findChildren<QLabel*>())
      if (!label->isHidden() && !label->text().isEmpty()) words << label->text();
    return words.join(QLatin1Char('\n'));
  }
  static ui::TaskButton* task(const QWidget& box, const char* name) {
    return box.findChild<ui::TaskButton*>(QString::fromLatin1(name));
  }
  static QPushButton* button(const QWidget& box, const char* name) {
    return box.findChild<QPushButton*>(QString::fromLatin1(name));
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::EngineBridge> engine_;
};

}  // namespace glisson
