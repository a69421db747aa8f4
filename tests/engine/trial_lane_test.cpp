// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine owes to a load that is tried live, by the inline and the threaded runner alike: newest
// wins, it ends at once, edits go on. The mechanics are a puppet's.
#include <QTest>

#include <chrono>
#include <limits>
#include <thread>

#include "gate.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/start_trial.h"
#include "glisson/engine/commands/stop_trial.h"
#include "glisson/engine/parts/model.h"
#include "runners.h"
#include "trial_patient.h"

using namespace glisson;
using namespace glisson::engine;
using test::both_runners;
using test::Gate;

namespace {

/// Mechanics that a test knows: every node where the pull wants its point.
class Puppet : public LoadTrial {
 public:
  using Do = std::function<void(const std::optional<TrialPull>&, TrialState&)>;
  explicit Puppet(Do act = {}) : act_(std::move(act)) {}
  TrialState step(const std::optional<TrialPull>& pull) override {
    TrialState state;
    state.pull = pull;
    if (pull) state.nodes = pull->target.transpose();
    if (act_) act_(pull, state);
    return state;
  }

 private:
  Do act_;
};

Engine::Options puppet(Runner runner, const Puppet::Do& act = {}) {
  Engine::Options made = options(runner);
  made.make_trial = [act](const CaseState&, const TrialOptions&, const RunContext&) {
    return std::make_unique<Puppet>(act);
  };
  return made;
}

}  // namespace

class TrialLaneTest : public QObject {
  Q_OBJECT
 private slots:
  void PullsThatAreNoneAreRefused_data();
  void PullsThatAreNoneAreRefused();
  void StopEndsItAndPullsAreIgnored_data() { both_runners(); }
  void StopEndsItAndPullsAreIgnored();
  void AnotherModelEndsIt_data() { both_runners(); }
  void AnotherModelEndsIt();
  void OtherLandmarksEndIt_data() { both_runners(); }
  void OtherLandmarksEndIt();
  void AStepThatFailsEndsItAndSaysWhy_data() { both_runners(); }
  void AStepThatFailsEndsItAndSaysWhy();
  void NewestPullWins();
  void StepsGoOnByThemselvesAndRest();
  void ACancelledStartLeavesNoTrial();
  void AStopIsNotOvertakenByItsStart();
  void EditsGoOnBesideIt();
  void TheDestructorJoinsInTheMiddleOfAStep();
};

void TrialLaneTest::PullsThatAreNoneAreRefused_data() {
  QTest::addColumn<Runner>("runner");
  QTest::addColumn<TrialPull>("pull");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TrialPull good = at(3, {0.0, 0.0, 0.1});
  for (const auto runner : {Runner::inline_, Runner::threaded}) {
    const QByteArray name = runner == Runner::inline_ ? "inline, " : "threaded, ";
    const auto row = [&](const char* what, auto change) {
      TrialPull bad = good;
      change(bad);
      QTest::newRow((name + what).constData()) << runner << bad;
    };
    row("target not a number", [&](TrialPull& p) { p.target.y() = nan; });
    row("target infinite", [&](TrialPull& p) { p.target.x() = std::numeric_limits<double>::infinity(); });
    row("weight not a number", [&](TrialPull& p) { p.weights.z() = nan; });
    row("weights of another point", [&](TrialPull& p) { p.weights *= 0.9; });
    row("negative weight", [&](TrialPull& p) { p.weights = {-0.5, 0.5, 1.0}; });
    row("no triangle", [&](TrialPull& p) { p.triangle = -1; });
    row("triangle that is not there", [&](TrialPull& p) { p.triangle = 1'000'000; });
  }
}

void TrialLaneTest::PullsThatAreNoneAreRefused() {
  QFETCH(Runner, runner);
  QFETCH(TrialPull, pull);
  Engine engine(puppet(runner));
  start(engine);
  const TrialPull good = at(3, {0.0, 0.0, 0.1});
  engine.submit_pull(good);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, engine.submit_pull(pull));
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial->pull == good);  // the former one stays
}

void TrialLaneTest::StopEndsItAndPullsAreIgnored() {
  QFETCH(Runner, runner);
  Engine engine(puppet(runner));
  start(engine);
  engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial->nodes.rows() > 0);
  QCOMPARE(engine.wait(engine.post(StopTrial{})).status, Status::done);
  QVERIFY(engine.snapshot()->trial == nullptr);
  engine.submit_pull(at(3, {0.0, 0.0, 0.2}));
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial == nullptr);
  // And it can be begun again.
  QCOMPARE(engine.wait(engine.post(StartTrial{})).status, Status::done);
  QCOMPARE(engine.snapshot()->trial->nodes.rows(), Eigen::Index{0});
}

void TrialLaneTest::AnotherModelEndsIt() {
  QFETCH(Runner, runner);
  Engine engine(puppet(runner));
  start(engine);
  engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
  engine.wait(engine.post(SetSeeds{}));
  QVERIFY(engine.snapshot()->trial != nullptr);  // seeds are another matter
  engine.wait(engine.post(BuildModel{}));
  QVERIFY(engine.snapshot()->trial == nullptr);
  engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial == nullptr);
}

void TrialLaneTest::OtherLandmarksEndIt() {
  QFETCH(Runner, runner);
  Engine engine(puppet(runner));
  start(engine);
  engine.wait(engine.post(SetLandmarks{}));
  QVERIFY(engine.snapshot()->trial == nullptr);  // the organ was held elsewhere
}

void TrialLaneTest::AStepThatFailsEndsItAndSaysWhy() {
  QFETCH(Runner, runner);
  for (const bool throws : {false, true}) {
    Engine engine(puppet(runner, [throws](const std::optional<TrialPull>&, TrialState& state) {
      if (throws) throw NumericalError("no");
      state.nodes.resize(0, 3);
      state.termination = Termination::diverged;
      state.inverted_tetrahedra = 1;
    }));
    start(engine);
    engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
    engine.wait_for_trial();
    const auto trial = engine.snapshot()->trial;
    QVERIFY(trial != nullptr);
    QVERIFY(trial->termination == Termination::diverged);
    QCOMPARE(trial->inverted_tetrahedra, throws ? 0 : 1);
    QCOMPARE(trial->nodes.rows(), Eigen::Index{0});
    engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
    engine.wait_for_trial();
    QVERIFY(engine.snapshot()->trial == trial);  // no more steps
  }
}

void TrialLaneTest::NewestPullWins() {
  auto gate = std::make_shared<Gate>();
  std::mutex mutex;
  std::vector<double> seen;
  Engine engine(puppet(Runner::threaded, [&, gate](const std::optional<TrialPull>& pull, TrialState&) {
    gate->pass();
    const std::scoped_lock lock(mutex);
    seen.push_back(pull->target.z());
  }));
  start(engine);
  engine.submit_pull(at(3, {0.0, 0.0, 1.0}));
  gate->wait_for_arrival();
  for (int i = 2; i <= 50; ++i) engine.submit_pull(at(3, {0.0, 0.0, double(i)}));
  gate->open();
  engine.wait_for_trial();
  const std::scoped_lock lock(mutex);
  QCOMPARE(seen.front(), 1.0);
  QCOMPARE(seen.at(1), 50.0);  // those in between have come too late
}

void TrialLaneTest::StepsGoOnByThemselvesAndRest() {
  // Nobody asks again: the organ swings, settles, and then the thread sleeps.
  std::mutex mutex;
  std::condition_variable changed;
  int steps = 0;
  Engine engine(puppet(Runner::threaded, [&](const std::optional<TrialPull>&, TrialState& state) {
    const std::scoped_lock lock(mutex);
    if (++steps < 20) state.nodes = Points::Zero(1, 3);
    changed.notify_all();
  }));
  start(engine);
  engine.submit_pull(std::nullopt);
  {
    std::unique_lock lock(mutex);
    QVERIFY(changed.wait_for(lock, std::chrono::seconds(20), [&] { return steps == 20; }));
  }
  engine.wait(engine.post(SetSeeds{}));  // the lane has gone on to other things
  engine.wait(engine.post(SetSeeds{}));
  const std::scoped_lock lock(mutex);
  QCOMPARE(steps, 20);
}

void TrialLaneTest::ACancelledStartLeavesNoTrial() {
  auto gate = std::make_shared<Gate>();
  Engine::Options made = options(Runner::threaded);
  made.make_trial = [gate](const CaseState&, const TrialOptions&,
                           const RunContext& context) -> Cancellable<std::unique_ptr<LoadTrial>> {
    gate->pass();
    if (context.cancelled()) return {};
    return std::make_unique<Puppet>();
  };
  Engine engine(std::move(made));
  engine.wait(engine.post(ImportMesh{}));
  const CommandId id = engine.post(StartTrial{});
  gate->wait_for_arrival();
  engine.cancel(id);
  gate->open();
  QCOMPARE(engine.wait(id).status, Status::cancelled);
  QVERIFY(engine.snapshot()->trial == nullptr);
}

void TrialLaneTest::AStopIsNotOvertakenByItsStart() {
  // The start must wait for the model that is being built; the stop, which touches nothing, must wait for the
  // start.
  auto gate = std::make_shared<Gate>();
  Engine::Options made = puppet(Runner::threaded);
  made.apply = [gate](const CaseState& state, const Command& command, const RunContext& context,
                      const Services& services) {
    if ((command.as<BuildModel>() != nullptr)) gate->pass();
    return give_patient(state, command, context, services);
  };
  Engine engine(std::move(made));
  engine.post(BuildModel{});
  gate->wait_for_arrival();
  const CommandId begun = engine.post(StartTrial{});
  const CommandId stopped = engine.post(StopTrial{});
  gate->open();
  QCOMPARE(engine.wait(stopped).status, Status::done);
  QCOMPARE(engine.wait(begun).status, Status::done);
  QVERIFY(engine.snapshot()->trial == nullptr);
}

void TrialLaneTest::EditsGoOnBesideIt() {
  Engine engine(options(Runner::threaded));
  start(engine);
  engine.submit_pull(corner_pull(engine.snapshot()->state[part::model]->model));
  for (int i = 0; i < 20; ++i) QCOMPARE(engine.wait(engine.post(SetSeeds{})).status, Status::done);
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial->nodes.rows() > 0);
}

void TrialLaneTest::TheDestructorJoinsInTheMiddleOfAStep() {
  auto gate = std::make_shared<Gate>();
  std::thread opener;
  {
    Engine engine(
        puppet(Runner::threaded, [gate](const std::optional<TrialPull>&, TrialState&) { gate->pass(); }));
    start(engine);
    engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
    gate->wait_for_arrival();
    opener = std::thread([gate] { gate->open(); });
  }
  opener.join();
}

QTEST_APPLESS_MAIN(TrialLaneTest)
#include "trial_lane_test.moc"
