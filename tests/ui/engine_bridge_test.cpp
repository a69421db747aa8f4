// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does in the window is done to the case that the window shows.
#include "glisson/ui/common/engine_bridge.h"

#include <QSignalSpy>
#include <QTest>

#include "gate.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/parts/cloud.h"
#include "runners.h"
#include "seeded_case.h"

using namespace glisson;
using namespace glisson::engine;
using namespace glisson::ui;
using test::Gate;

class EngineBridgeTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsDoneWhileAnotherCaseOpensIsDropped();
};

void EngineBridgeTest::WhatIsDoneWhileAnotherCaseOpensIsDropped() {
  const TemporaryFolder folder;
  const std::filesystem::path other = folder.path() / "b.glisson", file = folder.path() / "cloud.ply";
  {
    Engine maker(test::options_of(Runner::inline_));
    maker.post(test::seeds(0.2));
    maker.post(SaveCase{other});
    LabelledCloud cloud;
    cloud.points = 0.05 * Points::Random(40, 3).array() + 0.1;
    write_cloud(file, cloud);
  }
  Gate gate;
  Engine::Options options;
  options.apply = [&gate](const CaseState& state, const Command& command, const RunContext& context,
                          const Services&) {
    if (command.as<OpenCase>() != nullptr) gate.pass();
    return apply(state, command, context);
  };
  EngineBridge bridge(std::move(options));
  bridge.post(test::seeds(0.1));
  QTRY_VERIFY_WITH_TIMEOUT(bridge.state()[part::seeds] && bridge.tasks().empty(), 20000);
  bridge.post(OpenCase{other});
  const CommandId click = bridge.post(test::seeds(0.3));
  const CommandId frame = bridge.post(LoadVideoFrame{3});  // of the video of the case that is left
  bridge.post(ImportCloud{file});                          // was dropped on the window together with the case
  QSignalSpy ends(&bridge, &EngineBridge::finished);
  gate.open();
  QTRY_VERIFY_WITH_TIMEOUT(bridge.tasks().empty(), 20000);
  QCOMPARE(test::seed_of(bridge.state()), 0.2);
  QVERIFY(bridge.state()[part::cloud] != nullptr);
  for (const CommandId id : {click, frame}) {
    const bool dropped = std::any_of(ends.begin(), ends.end(), [&](const QList<QVariant>& end) {
      const auto outcome = end.at(0).value<Outcome>();
      return outcome.id == id && outcome.status == Status::cancelled;
    });
    QVERIFY(dropped);
  }
  bridge.post(test::seeds(0.4));
  QTRY_COMPARE_WITH_TIMEOUT(test::seed_of(bridge.state()), 0.4, 20000);
}

QTEST_GUILESS_MAIN(EngineBridgeTest)
#include "engine_bridge_test.moc"
