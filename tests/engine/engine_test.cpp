// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's promises, kept by the inline and by the threaded runner alike. Commands are done by a stand-in
// for the modules, so that a test decides how long one takes and how it ends.
#include "glisson/engine/engine.h"

#include <QtTest>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "gate.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/seeds.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;
using test::both_runners;
using test::Gate;

namespace {

/// A stand-in for the modules: every command writes fresh values into the parts that it says it writes.
Cancellable<Applied> write_parts(const CaseState& state, const Command& command, const RunContext& context,
                                 const Services& services) {
  if (command.traits().live != LiveLane::none) return command.apply(state, context, services);
  context.progress(0.5, "half");
  if (context.cancelled()) return {};
  Applied applied;
  applied.state = state;
  const Parts parts = command.traits().writes;
  if (parts.has(part::image)) applied.state[part::image] = std::make_shared<Image>();
  if (parts.has(part::seeds)) applied.state[part::seeds] = std::make_shared<segmentation::Seeds>();
  if (parts.has(part::labels)) applied.state[part::labels] = std::make_shared<LabelMap>();
  if (parts.has(part::model)) applied.state[part::model] = std::make_shared<model::BuiltModel>();
  if (parts.has(part::landmarks)) applied.state[part::landmarks] = std::make_shared<Landmarks>();
  if (parts.has(part::cloud)) applied.state[part::cloud] = std::make_shared<LabelledCloud>();
  if (parts.has(part::registration)) applied.state[part::registration] = std::make_shared<Registration>();
  applied.figures["answer"] = 42.0;
  return applied;
}

class CountingFollower : public Follower {
 public:
  explicit CountingFollower(std::shared_ptr<Gate> gate = nullptr) : gate_(std::move(gate)) {}
  OverlayFrame follow(const LiveInput& input) override {
    if (gate_) gate_->pass();
    OverlayFrame overlay;
    overlay.index = std::get<StereoFrame>(input).index;
    overlay.validity = Validity::valid;
    return overlay;
  }

 private:
  std::shared_ptr<Gate> gate_;
};

Engine::Options options(Runner runner) {
  Engine::Options made;
  made.runner = runner;
  made.apply = write_parts;
  made.make_follower = [](const CaseState&, const StartTracking&) {
    return std::make_unique<CountingFollower>();
  };
  return made;
}

/// Threaded; a command T waits at the gate before it does anything.
template <class T>
Engine::Options gated(const std::shared_ptr<Gate>& gate) {
  Engine::Options made = options(Runner::threaded);
  made.apply = [gate](const CaseState& state, const Command& command, const RunContext& context,
                      const Services& services) {
    if ((command.as<T>() != nullptr)) gate->pass();
    return write_parts(state, command, context, services);
  };
  return made;
}

/// The same with a result.
Cancellable<Applied> with_result(const CaseState& state, const Command& command, const RunContext& context,
                                 const Services& services) {
  auto applied = write_parts(state, command, context, services);
  if (applied) applied->result = std::make_shared<const int>(7);
  return applied;
}

StereoFrame numbered(int index) {
  StereoFrame frame;
  frame.index = index;
  return frame;
}

}  // namespace

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
  void AStaleOverlayIsNeverValid_data() { both_runners(); }
  void AStaleOverlayIsNeverValid();
  void AFollowerThatThrowsGivesAnInvalidFrame_data() { both_runners(); }
  void AFollowerThatThrowsGivesAnInvalidFrame();
  void SnapshotsAreImmutable_data() { both_runners(); }
  void SnapshotsAreImmutable();
  void WaitingForAnUnknownCommandIsRefused();
  void OnlyTheLastResultsAreKept_data() { both_runners(); }
  void OnlyTheLastResultsAreKept();
  void WhoWaitsGetsTheResult();

  void ACancelBeforeTheStartIsNotLost();
  void ACancelDuringTheWorkIsNotLost();
  void ACancelThatComesBeforeTheCommitWins();
  void EditsOvertakeWorkThatTheyDoNotTouch();
  void EditsWaitForWorkThatTheyTouch();
  void NewestFrameWins();
  void LiveFramesGoOnBesideLongWork();
  void TheDestructorCancelsAndJoins();
  void ManyThreadsMayPostAndCancel();
};

void EngineTest::TimesThatCannotBeAreRefused() {
  Engine::Options made = options(Runner::inline_);
  made.frame_seconds = 0.0;
  QVERIFY_EXCEPTION_THROWN(Engine{made}, PreconditionError);
  made = options(Runner::threaded);
  made.trial_seconds = -1.0;
  QVERIFY_EXCEPTION_THROWN(Engine{made}, PreconditionError);
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
  QVERIFY_EXCEPTION_THROWN(engine.wait(7), PreconditionError);
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

/// However many commands end before a waiter has its turn.
void EngineTest::WhoWaitsGetsTheResult() {
  auto gate = std::make_shared<Gate>();
  Engine::Options made = options(Runner::threaded);
  made.apply = [gate](const CaseState& state, const Command& command, const RunContext& context,
                      const Services& services) {
    gate->pass();
    return with_result(state, command, context, services);
  };
  Engine engine(std::move(made));
  std::vector<CommandId> posted;
  for (int i = 0; i < 12; ++i) posted.push_back(engine.post(SetSeeds{}));
  std::atomic<int> asking{0}, served{0};
  {
    std::vector<std::jthread> waiters;
    for (const CommandId id : posted)
      waiters.emplace_back([&, id] {
        ++asking;
        served += engine.wait(id).result.as<int>() != nullptr;
      });
    while (asking.load() < 12) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    gate->open();
  }
  QCOMPARE(served.load(), 12);
}

void EngineTest::ACancelBeforeTheStartIsNotLost() {
  auto gate = std::make_shared<Gate>();
  Engine::Options made = options(Runner::threaded);
  std::atomic<int> segmentations{0};
  made.apply = [&](const CaseState& state, const Command& command, const RunContext& context,
                   const Services& services) {
    if ((command.as<ImportImage>() != nullptr)) gate->pass();
    segmentations += (command.as<Segment>() != nullptr);
    return write_parts(state, command, context, services);
  };
  Engine engine(std::move(made));
  engine.post(ImportImage{});
  gate->wait_for_arrival();
  const CommandId waiting = engine.post(Segment{});
  engine.cancel(waiting);
  QCOMPARE(engine.wait(waiting).status, Status::cancelled);  // at once: it need not wait for its turn
  gate->open();
  engine.wait(engine.post(ImportImage{}));
  QCOMPARE(segmentations.load(), 0);
}

void EngineTest::ACancelDuringTheWorkIsNotLost() {
  auto gate = std::make_shared<Gate>();
  Engine engine(gated<ImportImage>(gate));
  const CommandId id = engine.post(ImportImage{});
  gate->wait_for_arrival();
  engine.cancel(id);
  gate->open();
  QCOMPARE(engine.wait(id).status, Status::cancelled);
  QCOMPARE(engine.snapshot()->stage(part::image), StageState::absent);
}

void EngineTest::ACancelThatComesBeforeTheCommitWins() {
  // The algorithm has looked at its context for the last time and finishes; the cancel comes after that.
  auto gate = std::make_shared<Gate>();
  Engine::Options made = options(Runner::threaded);
  made.apply = [&](const CaseState& state, const Command& command, const RunContext& context,
                   const Services& services) {
    auto applied = write_parts(state, command, context, services);
    gate->pass();
    return applied;
  };
  Engine engine(std::move(made));
  const CommandId id = engine.post(ImportImage{});
  gate->wait_for_arrival();
  engine.cancel(id);
  gate->open();
  QCOMPARE(engine.wait(id).status, Status::cancelled);
  QCOMPARE(engine.snapshot()->stage(part::image), StageState::absent);
}

void EngineTest::EditsOvertakeWorkThatTheyDoNotTouch() {
  auto gate = std::make_shared<Gate>();
  Engine engine(gated<ImportImage>(gate));
  const CommandId work = engine.post(ImportImage{});
  gate->wait_for_arrival();
  QCOMPARE(engine.wait(engine.post(SetSeeds{})).status,
           Status::done);  // would hang if it waited for the image
  gate->open();
  QCOMPARE(engine.wait(work).status, Status::done);
  const auto snapshot = engine.snapshot();
  QCOMPARE(snapshot->stage(part::image), StageState::current);
  QCOMPARE(snapshot->stage(part::seeds), StageState::current);  // the image's commit did not undo the edit
}

void EngineTest::EditsWaitForWorkThatTheyTouch() {
  auto gate = std::make_shared<Gate>();
  std::mutex mutex;
  std::vector<std::string> order;
  Engine::Options made = options(Runner::threaded);
  made.apply = [&](const CaseState& state, const Command& command, const RunContext& context,
                   const Services& services) {
    if ((command.as<BuildModel>() != nullptr)) gate->pass();
    {
      const std::scoped_lock lock(mutex);
      order.emplace_back(command.code());
    }
    return write_parts(state, command, context, services);
  };
  Engine engine(std::move(made));
  engine.post(BuildModel{});
  gate->wait_for_arrival();
  const CommandId landmarks = engine.post(SetLandmarks{});  // reads the model that is being built
  engine.wait(engine.post(SetSeeds{}));                     // overtakes both
  gate->open();
  engine.wait(landmarks);
  QCOMPARE(order, (std::vector<std::string>{"set_seeds", "build_model", "set_landmarks"}));
}

void EngineTest::NewestFrameWins() {
  auto gate = std::make_shared<Gate>();
  Engine::Options made = options(Runner::threaded);
  made.make_follower = [&](const CaseState&, const StartTracking&) {
    return std::make_unique<CountingFollower>(gate);
  };
  Engine engine(std::move(made));
  engine.wait(engine.post(StartTracking{}));
  engine.submit_frame(numbered(0));
  gate->wait_for_arrival();
  for (int i = 1; i <= 5; ++i) engine.submit_frame(numbered(i));
  gate->open();
  engine.wait_for_frames();
  const auto live = engine.snapshot()->state[part::live];
  QCOMPARE(live->overlay.index, 5);
  QCOMPARE(live->frames, 2);
  QCOMPARE(live->frames_dropped, 4);
}

void EngineTest::LiveFramesGoOnBesideLongWork() {
  auto gate = std::make_shared<Gate>();
  Engine engine(gated<ImportImage>(gate));
  engine.wait(engine.post(StartTracking{}));
  const CommandId work = engine.post(ImportImage{});
  gate->wait_for_arrival();
  engine.submit_frame(numbered(3));
  engine.wait_for_frames();
  QCOMPARE(engine.snapshot()->state[part::live]->overlay.index, 3);
  gate->open();
  QCOMPARE(engine.wait(work).status, Status::done);
  QCOMPARE(engine.snapshot()->state[part::live]->overlay.index, 3);
}

void EngineTest::TheDestructorCancelsAndJoins() {
  auto gate = std::make_shared<Gate>();
  std::atomic<bool> told{false};
  {
    Engine::Options made = options(Runner::threaded);
    made.apply = [&, gate](const CaseState&, const Command&, const RunContext& context,
                           const Services&) -> Cancellable<Applied> {
      gate->open();
      gate->pass();
      while (!context.cancelled()) std::this_thread::yield();
      told = true;
      return {};
    };
    Engine engine(std::move(made));
    engine.post(ImportImage{});
    engine.post(Segment{});
    gate->wait_for_arrival();
  }
  QVERIFY(told);
}

void EngineTest::ManyThreadsMayPostAndCancel() {
  Engine::Options made = options(Runner::threaded);
  std::atomic<int> wakes{0};
  made.wake = [&] { ++wakes; };
  Engine engine(std::move(made));
  engine.wait(engine.post(StartTracking{}));
  std::vector<std::jthread> threads;
  std::atomic<int> outcomes{0};
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 40; ++i) {
        const CommandId id = (i + t) % 2 == 0 ? engine.post(ImportImage{}) : engine.post(SetSeeds{});
        if (i % 3 == 0) engine.cancel(id);
        engine.submit_frame(numbered(i));
        engine.snapshot();
        engine.wait(id);
        ++outcomes;
      }
    });
  threads.clear();
  QCOMPARE(outcomes.load(), 160);
  QVERIFY(wakes > 0);
}

QTEST_APPLESS_MAIN(EngineTest)
#include "engine_test.moc"
