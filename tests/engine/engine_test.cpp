// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's promises, kept by the inline and by the threaded runner alike. What threads alone can show is
// in threaded_test.cpp.
#include "glisson/engine/engine.h"

#include <QTest>

#include <atomic>
#include <set>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "runners.h"
#include "stand_in.h"

using namespace glisson;
using namespace glisson::engine;
using namespace glisson::test;

class EngineTest : public QObject {
  Q_OBJECT
 private slots:
  void TimesThatCannotBeAreRefused();
  void ADoneCommandIsInTheSnapshot_data() { both_runners(); }
  void ADoneCommandIsInTheSnapshot();
  void AFailureLeavesTheCaseAsItWas_data() { both_runners(); }
  void AFailureLeavesTheCaseAsItWas();
  void AnUnexpectedExceptionIsAFailureToo_data() { both_runners(); }
  void AnUnexpectedExceptionIsAFailureToo();
  void EveryCommandHasExactlyOneOutcome_data() { both_runners(); }
  void EveryCommandHasExactlyOneOutcome();
  void CancelFromWithinProgressLeavesTheCaseAsItWas_data() { both_runners(); }
  void CancelFromWithinProgressLeavesTheCaseAsItWas();
  void AnEditMarksOnlyWhatFollowsFromIt_data() { both_runners(); }
  void AnEditMarksOnlyWhatFollowsFromIt();
  void FramesAreIgnoredUnlessTracking_data() { both_runners(); }
  void FramesAreIgnoredUnlessTracking();
  void AStartThatFailsLeavesWhatIsFollowed_data() { both_runners(); }
  void AStartThatFailsLeavesWhatIsFollowed();
  void AStaleOverlayIsNeverValid_data() { both_runners(); }
  void AStaleOverlayIsNeverValid();
  void AFollowerThatThrowsGivesAnInvalidFrame_data() { both_runners(); }
  void AFollowerThatThrowsGivesAnInvalidFrame();
  void SnapshotsAreImmutable_data() { both_runners(); }
  void SnapshotsAreImmutable();
  void WaitingForAnUnknownCommandIsRefused();
  void OnlyTheLastResultsAreKept_data() { both_runners(); }
  void OnlyTheLastResultsAreKept();
};

void EngineTest::TimesThatCannotBeAreRefused() {
  Engine::Options made = options(Runner::inline_);
  made.frame_seconds = 0.0;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, Engine{made});
  made = options(Runner::threaded);
  made.trial_seconds = -1.0;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, Engine{made});
}

void EngineTest::ADoneCommandIsInTheSnapshot() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  QCOMPARE(engine.snapshot()->stage(part::image), StageState::absent);
  const Outcome outcome = engine.wait(engine.post(ImportImage{"somewhere"}));
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(outcome.command, std::string("import_image"));
  QCOMPARE(outcome.figures.at("answer"), 42.0);
  const auto snapshot = engine.snapshot();
  QCOMPARE(snapshot->stage(part::image), StageState::current);
  QCOMPARE(snapshot->cause, std::string("import_image"));
  QVERIFY(snapshot->revision > 0);
}

void EngineTest::AFailureLeavesTheCaseAsItWas() {
  QFETCH(Runner, runner);
  Engine::Options made = options(runner);
  made.apply = [](const CaseState& state, const Command& command, const RunContext& context,
                  const Services& services) -> Cancellable<Applied> {
    if ((command.as<Segment>() != nullptr))
      throw InputError("seeds.json", "liver", "there are none", "Click some");
    return write_parts(state, command, context, services);
  };
  Engine engine(std::move(made));
  engine.wait(engine.post(ImportImage{}));
  const auto before = engine.snapshot();
  const Outcome outcome = engine.wait(engine.post(Segment{}));
  QCOMPARE(outcome.status, Status::failed);
  QCOMPARE(outcome.error, std::string("seeds.json: liver: there are none. Click some."));
  QCOMPARE(engine.snapshot()->revision, before->revision);
  QVERIFY(engine.snapshot()->state.shares(part::image, before->state));
}

void EngineTest::AnUnexpectedExceptionIsAFailureToo() {
  QFETCH(Runner, runner);
  Engine::Options made = options(runner);
  made.apply = [](const CaseState&, const Command&, const RunContext&,
                  const Services&) -> Cancellable<Applied> { throw std::bad_alloc(); };
  Engine engine(std::move(made));
  const Outcome outcome = engine.wait(engine.post(ImportImage{}));
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY(outcome.error.find("import_image") != std::string::npos);
}

void EngineTest::EveryCommandHasExactlyOneOutcome() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  std::set<CommandId> posted;
  CommandId last = 0;
  for (int i = 0; i < 50; ++i) {
    last = i % 2 == 0 ? engine.post(ImportImage{}) : engine.post(SetSeeds{});
    posted.insert(last);
    if (i % 5 == 0) engine.cancel(last);
  }
  for (const CommandId id : posted) engine.wait(id);
  std::multiset<CommandId> seen;
  for (const Event& event : engine.take_events())
    if (const auto* outcome = std::get_if<Outcome>(&event)) seen.insert(outcome->id);
  QCOMPARE(seen.size(), posted.size());
  QCOMPARE(std::set<CommandId>(seen.begin(), seen.end()), posted);
}

void EngineTest::CancelFromWithinProgressLeavesTheCaseAsItWas() {
  QFETCH(Runner, runner);
  Engine::Options made = options(runner);
  Engine* self = nullptr;
  std::atomic<CommandId> posted{0};
  // Ids are given in order, so the first one is known before post() returns; inline it has to be.
  made.apply = [&](const CaseState& state, const Command& command, const RunContext& context,
                   const Services& services) -> Cancellable<Applied> {
    self->cancel(1);
    return write_parts(state, command, context, services);
  };
  Engine engine(std::move(made));
  self = &engine;
  posted = engine.post(ImportImage{});
  QCOMPARE(posted.load(), CommandId{1});
  QCOMPARE(engine.wait(1).status, Status::cancelled);
  QCOMPARE(engine.snapshot()->stage(part::image), StageState::absent);
}

void EngineTest::AnEditMarksOnlyWhatFollowsFromIt() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  engine.post(ImportImage{});
  engine.post(SetSeeds{});
  engine.post(Segment{});
  engine.post(BuildModel{});
  engine.post(ImportCloud{});
  engine.wait(engine.post(Register{}));
  QCOMPARE(engine.snapshot()->stage(part::registration), StageState::current);
  // A label edit leaves the cloud alone, and marks model and registration.
  engine.wait(engine.post(ImportLabels{}));
  const auto snapshot = engine.snapshot();
  QCOMPARE(snapshot->stage(part::labels), StageState::current);
  QCOMPARE(snapshot->stage(part::model), StageState::stale);
  QCOMPARE(snapshot->stage(part::registration), StageState::stale);
  QCOMPARE(snapshot->stage(part::cloud), StageState::current);
  engine.post(BuildModel{});
  engine.wait(engine.post(Register{}));
  QCOMPARE(engine.snapshot()->stage(part::registration), StageState::current);
}

void EngineTest::FramesAreIgnoredUnlessTracking() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  engine.submit_frame(numbered(1));
  engine.wait_for_frames();
  QVERIFY(engine.snapshot()->state[part::live] == nullptr);
  engine.wait(engine.post(StartTracking{}));
  QVERIFY(engine.snapshot()->tracking);
  engine.submit_frame(numbered(2));
  engine.wait_for_frames();
  QCOMPARE(engine.snapshot()->state[part::live]->overlay.index, 2);
  QCOMPARE(engine.snapshot()->state[part::live]->frames, 1);
  engine.wait(engine.post(StopTracking{}));
  QVERIFY(!engine.snapshot()->tracking);
  engine.submit_frame(numbered(3));
  engine.wait_for_frames();
  QVERIFY(engine.snapshot()->state[part::live] == nullptr);
}

void EngineTest::AStartThatFailsLeavesWhatIsFollowed() {
  QFETCH(Runner, runner);
  bool fails = false;
  Engine::Options made = options(runner);
  made.make_follower = [&fails](const CaseState&, const StartTracking&) {
    if (fails) throw InputError("video", "source", "cannot be opened", "Choose another");
    return std::make_unique<CountingFollower>();
  };
  Engine engine(std::move(made));
  engine.wait(engine.post(StartTracking{}));
  engine.submit_frame(numbered(1));
  engine.wait_for_frames();
  fails = true;
  QCOMPARE(engine.wait(engine.post(StartTracking{})).status, Status::failed);
  QVERIFY(engine.snapshot()->tracking);
  engine.submit_frame(numbered(2));
  engine.wait_for_frames();
  QCOMPARE(engine.snapshot()->state[part::live]->overlay.index, 2);
  QCOMPARE(engine.snapshot()->state[part::live]->frames, 2);
}

void EngineTest::AStaleOverlayIsNeverValid() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  engine.post(ImportLabels{});
  engine.post(BuildModel{});
  engine.post(ImportCloud{});
  engine.post(Register{});
  engine.wait(engine.post(StartTracking{}));
  engine.submit_frame(numbered(1));
  engine.wait_for_frames();
  QCOMPARE(engine.snapshot()->state[part::live]->overlay.validity, Validity::valid);
  engine.wait(engine.post(ImportCloud{}));
  QCOMPARE(engine.snapshot()->stage(part::live), StageState::stale);
  engine.submit_frame(numbered(2));
  engine.wait_for_frames();
  QCOMPARE(engine.snapshot()->state[part::live]->overlay.validity, Validity::stale);
}

void EngineTest::AFollowerThatThrowsGivesAnInvalidFrame() {
  QFETCH(Runner, runner);
  struct Throwing : Follower {
    OverlayFrame follow(const LiveInput&) override { throw NumericalError("no"); }
  };
  Engine::Options made = options(runner);
  made.make_follower = [](const CaseState&, const StartTracking&) { return std::make_unique<Throwing>(); };
  Engine engine(std::move(made));
  engine.wait(engine.post(StartTracking{}));
  engine.submit_frame(numbered(7));
  engine.wait_for_frames();
  const auto live = engine.snapshot()->state[part::live];
  QCOMPARE(live->overlay.validity, Validity::mechanics_failed);
  QCOMPARE(live->overlay.index, 7);
  QCOMPARE(live->overlay.nodes_in_camera.rows(), Eigen::Index{0});
}

void EngineTest::SnapshotsAreImmutable() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  engine.wait(engine.post(ImportImage{}));
  const auto kept = engine.snapshot();
  const auto image = kept->state[part::image];
  engine.wait(engine.post(ImportImage{}));
  QCOMPARE(kept->state[part::image], image);
  QVERIFY(engine.snapshot()->state[part::image] != image);
}

void EngineTest::WaitingForAnUnknownCommandIsRefused() {
  Engine engine(options(Runner::inline_));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, engine.wait(7));
}

void EngineTest::OnlyTheLastResultsAreKept() {
  QFETCH(Runner, runner);
  Engine::Options made = options(runner);
  made.apply = with_result;
  Engine engine(std::move(made));
  std::vector<CommandId> posted;
  for (int i = 0; i < 12; ++i) posted.push_back(engine.post(SetSeeds{}));
  engine.wait(posted.back());
  for (std::size_t i = 0; i < posted.size(); ++i) {
    const Outcome outcome = engine.wait(posted[i]);
    QCOMPARE(outcome.status, Status::done);
    QCOMPARE(outcome.result.as<int>() != nullptr, i >= 8);
  }
}

QTEST_APPLESS_MAIN(EngineTest)
#include "engine_test.moc"
