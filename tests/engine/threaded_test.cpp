// SPDX-License-Identifier: GPL-3.0-or-later
// What the threaded runner promises: no cancel is lost, edits overtake only what they do not touch, the
// newest frame wins, and whoever waits is served.
#include <QTest>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include "gate.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/seeds.h"
#include "stand_in.h"

using namespace glisson;
using namespace glisson::engine;
using namespace glisson::test;

namespace {

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

}  // namespace

class ThreadedTest : public QObject {
  Q_OBJECT
 private slots:
  void WhoWaitsGetsTheResult();
  void ACancelBeforeTheStartIsNotLost();
  void ACancelDuringTheWorkIsNotLost();
  void ACancelThatComesBeforeTheCommitWins();
  void EditsOvertakeWorkThatTheyDoNotTouch();
  void EditsWaitForWorkThatTheyTouch();
  void NewestFrameWins();
  void LiveFramesGoOnBesideLongWork();
  void WhatFollowedAFormerCaseIsLetGo();
  void TheDestructorCancelsAndJoins();
  void ManyThreadsMayPostAndCancel();
};

/// However many commands end before a waiter has its turn.
void ThreadedTest::WhoWaitsGetsTheResult() {
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

void ThreadedTest::ACancelBeforeTheStartIsNotLost() {
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

void ThreadedTest::ACancelDuringTheWorkIsNotLost() {
  auto gate = std::make_shared<Gate>();
  Engine engine(gated<ImportImage>(gate));
  const CommandId id = engine.post(ImportImage{});
  gate->wait_for_arrival();
  engine.cancel(id);
  gate->open();
  QCOMPARE(engine.wait(id).status, Status::cancelled);
  QCOMPARE(engine.snapshot()->stage(part::image), StageState::absent);
}

void ThreadedTest::ACancelThatComesBeforeTheCommitWins() {
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

void ThreadedTest::EditsOvertakeWorkThatTheyDoNotTouch() {
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

void ThreadedTest::EditsWaitForWorkThatTheyTouch() {
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

void ThreadedTest::NewestFrameWins() {
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

void ThreadedTest::LiveFramesGoOnBesideLongWork() {
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

/// Its model, its memory and its network are not kept beside another patient.
void ThreadedTest::WhatFollowedAFormerCaseIsLetGo() {
  Engine::Options made = options(Runner::threaded);
  std::weak_ptr<int> alive;
  made.make_follower = [&alive](const CaseState&, const StartTracking&) {
    struct Follower : CountingFollower {
      std::shared_ptr<int> life = std::make_shared<int>(0);
    };
    auto follower = std::make_unique<Follower>();
    alive = follower->life;
    return follower;
  };
  Engine engine(std::move(made));
  QCOMPARE(engine.wait(engine.post(StartTracking{})).status, Status::done);
  QVERIFY(engine.snapshot()->tracking && !alive.expired());
  ImportImage other;
  other.new_case = true;
  QCOMPARE(engine.wait(engine.post(other)).status, Status::done);
  QVERIFY(!engine.snapshot()->tracking);
  engine.wait(engine.post(SetSeeds{}));  // the edits' thread has had its turn
  QVERIFY(alive.expired());
}

void ThreadedTest::TheDestructorCancelsAndJoins() {
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

void ThreadedTest::ManyThreadsMayPostAndCancel() {
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

QTEST_APPLESS_MAIN(ThreadedTest)
#include "threaded_test.moc"
