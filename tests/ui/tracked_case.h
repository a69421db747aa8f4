// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <memory>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/ui/common/task_button.h"
#include "live_part.h"

namespace glisson {

/// A case from nothing to a registration, with a film of sixty frames, and its live part.
/// @tparam Guidance a LivePart and the boxes that are looked at.
template <class Guidance>
struct TrackedCase {
  std::unique_ptr<TemporaryFolder> folder = std::make_unique<TemporaryFolder>();
  std::unique_ptr<FakeOperation> operation = std::make_unique<FakeOperation>();
  std::unique_ptr<ui::EngineBridge> engine;
  std::unique_ptr<Guidance> guidance;

  void register_it() {
    make_box_operation(*operation);
    engine = std::make_unique<ui::EngineBridge>(operation->options());
    for (const engine::Command& step : operation->steps_to_cloud(folder->path() / "scope.mkv", 60))
      engine->post(step);
    engine->post(engine::Register{});
    QVERIFY(QTest::qWaitFor([this] { return engine->tasks().empty(); }, 20000));
    guidance = std::make_unique<Guidance>(*engine);
    QTRY_VERIFY_WITH_TIMEOUT(guidance->drawables.drawable() != nullptr, 20000);
  }
  /// And pauses.
  void begin_tracking() {
    guidance->playing.template findChild<ui::TaskButton*>(QStringLiteral("start_tracking"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(guidance->live.line.value().startsWith(QStringLiteral("LIVE")), 20000);
    guidance->playback.pause(true);
    QTest::qWait(200);
  }
};

}  // namespace glisson
