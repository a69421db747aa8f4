// SPDX-License-Identifier: GPL-3.0-or-later
// Registered again while the organ is followed: offered first, then taken, and back.
#include <QTest>
#include <cmath>
#include <functional>

#include "../registration/phantom.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/register_again.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/commands/take_registration.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/registration.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;

namespace {

Points somewhere(double x) { return Points::Constant(1, 3, x); }

/// Shows the registration that it has.
class Showing : public Follower {
 public:
  explicit Showing(const Registration& start) : nodes_(start.nodes_in_camera) {}
  OverlayFrame follow(const LiveInput& input) override {
    overlay_.index = std::get<StereoFrame>(input).index;
    return overlay();
  }
  OverlayFrame take(const Registration& registration) override {
    nodes_ = registration.nodes_in_camera;
    if (taken) taken();
    return overlay();
  }
  static inline std::function<void()> taken;  ///< called when it has gone over
  std::shared_ptr<const LabelledCloud> tissue_at_start() override {
    LabelledCloud tissue;
    tissue.points = Points::Ones(overlay_.index, 3);
    return std::make_shared<const LabelledCloud>(std::move(tissue));
  }

 private:
  OverlayFrame overlay() {
    overlay_.validity = Validity::valid;
    overlay_.nodes_in_camera = nodes_;
    return overlay_;
  }
  Points nodes_;
  OverlayFrame overlay_;
};

/// Puts a registration there, as a real one would.
struct Registered {
  double x = 0.0;
  CommandTraits traits() const { return {.code = "register", .writes = {part::registration}}; }
  Cancellable<Applied> apply(const CaseState& state, const RunContext&) const {
    Applied applied{state};
    Registration made;
    made.nodes_in_camera = somewhere(x);
    applied.state[part::registration] = std::make_shared<const Registration>(made);
    return applied;
  }
};

/// As RegisterAgain says of itself, without its hour's work.
struct Offered : RegisterAgain {
  double x = 0.0;
  std::vector<std::string> doubts;
  Cancellable<Applied> apply(const CaseState& state, const RunContext&) const {
    Applied applied{state};
    OtherRegistration offered;
    offered.registration.doubts = doubts;
    offered.registration.nodes_in_camera = somewhere(x);
    offered.is_better = true;
    applied.state[part::other_registration] = std::make_shared<const OtherRegistration>(offered);
    return applied;
  }
};

Engine::Options options(Runner runner) {
  Engine::Options options;
  options.runner = runner;
  options.apply = [](const CaseState& state, const Command& command, const RunContext& context,
                     const Services& services) { return command.apply(state, context, services); };
  options.make_follower = [](const CaseState& state, const StartTracking&) {
    return std::make_unique<Showing>(*state[part::registration]);
  };
  return options;
}

}  // namespace

class AgainTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsOfferedIsTakenAndNothingIsOutOfDate_data() { test::both_runners(); }
  void WhatIsOfferedIsTakenAndNothingIsOutOfDate();
  void WhoCancelsAfterItHasGoneOverComesTooLate_data() { test::both_runners(); }
  void WhoCancelsAfterItHasGoneOverComesTooLate();
  void OnlyWhatIsBetterIsTakenUnasked();
  void PointsOfAnotherMomentAreLeftOut();
  void ARefusedOneIsNotTaken_data() { test::both_runners(); }
  void ARefusedOneIsNotTaken();
  void AnOfferOfAFormerRegistrationIsOutOfDate_data() { test::both_runners(); }
  void AnOfferOfAFormerRegistrationIsOutOfDate();
  void TheLivePartTellsOfTheTissue_data() { test::both_runners(); }
  void TheLivePartTellsOfTheTissue();
  void WithoutAnythingFollowedNothingIsTaken_data() { test::both_runners(); }
  void WithoutAnythingFollowedNothingIsTaken();

 private:
  static void follow(Engine& engine, int index) {
    StereoFrame frame;
    frame.index = index;
    engine.submit_frame(std::move(frame));
    engine.wait_for_frames();
  }
  static Outcome ask(Engine& engine, Command command) { return engine.wait(engine.post(std::move(command))); }
  static Offered offer(double x) {
    Offered offered;
    offered.x = x;
    return offered;
  }
  /// Followed from 1, and 2 is offered.
  static void begin_with_offer(Engine& engine) {
    ask(engine, Registered{1.0});
    ask(engine, StartTracking{});
    follow(engine, 1);
    ask(engine, offer(2.0));
  }
  static double registered(const Engine& engine) {
    return engine.snapshot()->state[part::registration]->nodes_in_camera(0, 0);
  }
  static double shown(const Engine& engine) {
    return engine.snapshot()->state[part::live]->overlay.nodes_in_camera(0, 0);
  }
  static void current(const Engine& engine) {
    for (const Part part : {Part(part::registration), Part(part::other_registration), Part(part::live)})
      QCOMPARE(engine.snapshot()->stage(part), StageState::current);
  }
};

void AgainTest::WhatIsOfferedIsTakenAndNothingIsOutOfDate() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  ask(engine, Registered{1.0});
  ask(engine, StartTracking{});
  follow(engine, 1);
  QCOMPARE(ask(engine, offer(2.0)).status, Status::done);
  QCOMPARE(shown(engine), 1.0);  // until it is taken
  QCOMPARE(registered(engine), 1.0);
  current(engine);
  QCOMPARE(ask(engine, TakeRegistration{}).status, Status::done);
  QCOMPARE(shown(engine), 2.0);  // without another frame
  QCOMPARE(registered(engine), 2.0);
  current(engine);
  QVERIFY(engine.snapshot()->state[part::other_registration]->is_former);
  follow(engine, 2);
  QCOMPARE(shown(engine), 2.0);
  QVERIFY(engine.snapshot()->state[part::live]->overlay.validity == Validity::valid);  // not stale
  QCOMPARE(ask(engine, TakeRegistration{}).status, Status::done);
  QCOMPARE(shown(engine), 1.0);
  QCOMPARE(registered(engine), 1.0);
  QVERIFY(!engine.snapshot()->state[part::other_registration]->is_former);
  current(engine);
}

void AgainTest::WhoCancelsAfterItHasGoneOverComesTooLate() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  begin_with_offer(engine);
  Showing::taken = [&engine] { engine.cancel_all(); };
  const Outcome outcome = ask(engine, TakeRegistration{});
  Showing::taken = {};
  follow(engine, 2);
  QCOMPARE(registered(engine), shown(engine));  // the case tells of what is drawn
  QCOMPARE(outcome.status, Status::done);
  current(engine);
}

void AgainTest::OnlyWhatIsBetterIsTakenUnasked() {
  Engine engine(options(Runner::inline_));
  QVERIFY(!take_if_better(engine.snapshot()->state));
  begin_with_offer(engine);
  const auto offered = engine.snapshot()->state[part::other_registration];
  const auto take = take_if_better(engine.snapshot()->state);
  QVERIFY(take && take->seen == offered);
  QCOMPARE(ask(engine, *take).status, Status::done);
  QCOMPARE(registered(engine), 2.0);
  QVERIFY(!take_if_better(engine.snapshot()->state));  // the former one
  CaseState state;
  auto worse = std::make_shared<OtherRegistration>(*offered);
  worse->is_better = false;
  state[part::other_registration] = worse;
  QVERIFY(!take_if_better(state));
}

void AgainTest::PointsOfAnotherMomentAreLeftOut() {
  // Another pair was loaded, and a registration to it imported; the cloud is still the former pair's.
  CaseState state;
  auto built = std::make_shared<model::BuiltModel>();
  built->model = phantom::model(6, 5, 3);
  Registration start;
  start.camera_from_ct = phantom::view();
  start.nodes_in_camera = start.camera_from_ct.apply(built->model.mesh.vertices);
  const LabelledCloud seen = phantom::patch(built->model, start.nodes_in_camera, {});
  LiveState live;
  LabelledCloud tissue;
  tissue.points = seen.points;
  live.tissue_at_start = std::make_shared<const LabelledCloud>(std::move(tissue));
  LabelledCloud former = seen;
  former.points(0, 0) = std::nan("");  // whoever looks at it refuses it
  state[part::model] = built;
  state[part::registration] = std::make_shared<const Registration>(start);
  state[part::live] = std::make_shared<const LiveState>(live);
  state[part::frame] = std::make_shared<const StereoInput>();
  state[part::cloud] = std::make_shared<const LabelledCloud>(former);
  state.stamp(part::frame).revision = 3;
  state.stamp(part::cloud) = {2, {{part::frame, 1}}};
  RegisterAgain command;
  command.operations = false;
  QVERIFY(command.apply(state, RunContext()).has_value());
  state.stamp(part::cloud).made_from = {{part::frame, 3}};
  QVERIFY_THROWS_EXCEPTION(InputError, command.apply(state, RunContext()));
}

void AgainTest::ARefusedOneIsNotTaken() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  ask(engine, Registered{1.0});
  ask(engine, StartTracking{});
  follow(engine, 1);
  Offered refused = offer(2.0);
  refused.doubts = {"refused"};
  QCOMPARE(ask(engine, refused).status, Status::done);
  const Outcome outcome = ask(engine, TakeRegistration{});
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY2(outcome.error.find("was refused") != std::string::npos, outcome.error.c_str());
  QCOMPARE(registered(engine), 1.0);
  QCOMPARE(shown(engine), 1.0);
  current(engine);
  follow(engine, 2);
  QCOMPARE(shown(engine), 1.0);
}

void AgainTest::AnOfferOfAFormerRegistrationIsOutOfDate() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  begin_with_offer(engine);
  ask(engine, Registered{3.0});
  const auto obstacle_now = obstacle(*engine.snapshot(), TakeRegistration{});
  QVERIFY(obstacle_now && obstacle_now->kind == Obstacle::Kind::stale);
}

void AgainTest::TheLivePartTellsOfTheTissue() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  ask(engine, Registered{1.0});
  ask(engine, StartTracking{});
  QVERIFY(!engine.snapshot()->state[part::live]->tissue_at_start);
  follow(engine, 7);
  QCOMPARE(engine.snapshot()->state[part::live]->tissue_at_start->size(), 7);
}

void AgainTest::WithoutAnythingFollowedNothingIsTaken() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  QVERIFY(obstacle(CaseState(), RegisterAgain{}));
  QVERIFY(obstacle(CaseState(), TakeRegistration{}));
  begin_with_offer(engine);
  ask(engine, StopTracking{});
  QCOMPARE(ask(engine, TakeRegistration{}).status, Status::failed);
  QCOMPARE(registered(engine), 1.0);
}

QTEST_APPLESS_MAIN(AgainTest)
#include "again_test.moc"
