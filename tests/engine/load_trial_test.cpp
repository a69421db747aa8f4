// SPDX-License-Identifier: GPL-3.0-or-later
// A load tried live: what the mechanics owes (the static solution, the way back to rest), and what the engine
// owes (newest wins, ends at once, the case as it was), by the inline and the threaded runner alike.
#include "glisson/engine/load_trial.h"

#include <QtTest>

#include <condition_variable>
#include <limits>
#include <mutex>

#include "../fem/block_mesh.h"
#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/engine/engine.h"
#include "glisson/fem/integrator.h"
#include "glisson/guidance/boundary_springs.h"

using namespace glisson;
using namespace glisson::engine;

Q_DECLARE_METATYPE(glisson::engine::Runner)

namespace {

/// A block of 120 x 80 x 50 mm with a portal vein through it that enters on the left, tied to a vena cava
/// behind.
std::shared_ptr<const model::BuiltModel> patient() {
  auto built = std::make_shared<model::BuiltModel>();
  PatientModel& model = built->model;
  model.mesh = fem_test::block_mesh({6, 4, 3}, {0.12, 0.08, 0.05});
  model.mesh.labels.assign(static_cast<std::size_t>(model.mesh.tetrahedron_count()), structure::kParenchyma);
  model.surface = boundary_surface(model.mesh);
  model.vessels = {fem_test::straight_vessel({0.01, 0.041, 0.026}, {0.11, 0.039, 0.024}, 5, 4e-3)};
  model.landmarks.vena_cava.resize(4, 3);
  model.landmarks.vena_cava << 0.06, 0.08, 0.005, 0.06, 0.08, 0.02, 0.06, 0.08, 0.03, 0.06, 0.08, 0.045;
  return built;
}

/// The engine's only other command here gives it that patient; whatever it writes is new.
Cancellable<Applied> give_patient(const CaseState& state, const Command& command, const RunContext&) {
  Applied applied;
  applied.state = state;
  if (writes(command).has(Part::model)) applied.state.model = patient();
  if (writes(command).has(Part::landmarks)) applied.state.landmarks = std::make_shared<Landmarks>();
  if (writes(command).has(Part::seeds)) applied.state.seeds = std::make_shared<segmentation::Seeds>();
  return applied;
}

Engine::Options options(Runner runner) {
  Engine::Options made;
  made.runner = runner;
  made.apply = give_patient;
  made.trial_seconds = 0.0;  // tests do not wait
  return made;
}

/// Lets a thread wait until the test lets it go.
class Gate {
 public:
  void open() {
    const std::scoped_lock lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex_);
    ++arrived_;
    changed_.notify_all();
    changed_.wait(lock, [&] { return open_; });
  }
  void wait_for_arrival() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return arrived_ > 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
  int arrived_ = 0;
};

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

void start(Engine& engine) {
  engine.wait(engine.post(ImportMesh{}));
  QCOMPARE(engine.wait(engine.post(StartTrial{})).status, Status::done);
  QVERIFY(engine.snapshot()->trial != nullptr);
}

TrialPull at(int triangle, const Eigen::Vector3d& target) {
  return {triangle, Eigen::Vector3d(0.2, 0.3, 0.5), target};
}

std::array<int, 3> corners(const PatientModel& model, int triangle) {
  std::array<int, 3> nodes{};
  for (int k = 0; k < 3; ++k)
    nodes[static_cast<std::size_t>(k)] =
        model.surface.node_of_vertex[static_cast<std::size_t>(model.surface.mesh.triangles(triangle, k))];
  return nodes;
}

/// The pull by which the front's far corner is drawn 20 mm forwards and 10 mm up.
TrialPull corner_pull(const PatientModel& model) {
  int best = -1;
  double furthest = -1.0;
  for (int t = 0; t < model.surface.mesh.triangle_count(); ++t) {
    double forward = 0.0;
    for (const int node : corners(model, t))
      forward += model.mesh.vertices(node, 0) - model.mesh.vertices(node, 1) + model.mesh.vertices(node, 2);
    if (forward > furthest) best = t, furthest = forward;
  }
  TrialPull pull = at(best, Eigen::Vector3d(0.0, -0.02, 0.01));
  for (std::size_t k = 0; k < 3; ++k)
    pull.target += pull.weights[static_cast<Eigen::Index>(k)] *
                   model.mesh.vertices.row(corners(model, best)[k]).transpose();
  return pull;
}

/// The equilibrium under the same pull by the static solver; the loads are written down here once more.
Points equilibrium(const PatientModel& model, const TrialPull& pull, const TrialOptions& options) {
  const fem::CompositeModel composite(model.mesh, model.vessels, options.materials);
  const guidance::BoundarySprings springs(model, model.mesh.vertices, 20e6, 0.05, 1e9);
  const std::array<int, 3> nodes = corners(model, pull.triangle);
  const auto loads = [&](const Points& x) {
    fem::Loads all;
    springs.add(x, all.attached);
    fem::AttachedLoad load;
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      load.nodes[k] = nodes[k];
      load.weights[k] = pull.weights[static_cast<Eigen::Index>(k)];
      p += load.weights[k] * x.row(nodes[k]).transpose();
    }
    load.force = options.pull_stiffness * (pull.target - p);
    load.tangent = options.pull_stiffness * Eigen::Matrix3d::Identity();
    if (load.force.norm() > options.pull_limit) {
      const Eigen::Vector3d along = load.force.normalized();
      load.tangent = options.pull_limit / (pull.target - p).norm() *
                     (Eigen::Matrix3d::Identity() - along * along.transpose());
      load.force = options.pull_limit * along;
    }
    all.attached.push_back(load);
    return all;
  };
  fem::StaticOptions newton;
  newton.tolerance = 1e-10;
  const auto solved = fem::solve_static(composite, model.mesh.vertices, loads, newton, RunContext());
  return solved && solved->converged ? solved->positions : Points();
}

/// Steps until nothing moves any more, or the trial has ended.
std::shared_ptr<const TrialState> settle(Engine& engine, const std::optional<TrialPull>& pull) {
  Points before;
  for (int i = 0; i < 5000; ++i) {
    engine.submit_pull(pull);
    engine.wait_for_trial();
    const auto trial = engine.snapshot()->trial;
    if (!trial || trial->nodes.rows() == 0) return trial;
    if (before.rows() > 0 && (trial->nodes - before).cwiseAbs().maxCoeff() < 1e-10) return trial;
    before = trial->nodes;
  }
  return nullptr;
}

}  // namespace

class LoadTrialTest : public QObject {
  Q_OBJECT
  static void both_runners() {
    QTest::addColumn<Runner>("runner");
    QTest::newRow("inline") << Runner::inline_;
    QTest::newRow("threaded") << Runner::threaded;
  }

 private slots:
  void AHeldPullEndsInTheStaticSolution_data();
  void AHeldPullEndsInTheStaticSolution();
  void ThePullIsNoStrongerThanItsLimit();
  void AReleasedOrganReturnsToRest_data() { both_runners(); }
  void AReleasedOrganReturnsToRest();
  void ATrialChangesNothingOfTheCase_data() { both_runners(); }
  void ATrialChangesNothingOfTheCase();
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
  void ElementsInsideOutEndIt();
  void AnOrganThatNothingHoldsIsRefused();
  void OptionsOutOfRangeAreRefused_data();
  void OptionsOutOfRangeAreRefused();
  void NewestPullWins();
  void StepsGoOnByThemselvesAndRest();
  void ACancelledStartLeavesNoTrial();
  void AStopIsNotOvertakenByItsStart();
  void EditsGoOnBesideIt();
  void TheDestructorJoinsInTheMiddleOfAStep();
};

void LoadTrialTest::AHeldPullEndsInTheStaticSolution_data() {
  QTest::addColumn<Runner>("runner");
  QTest::addColumn<int>("fast_from");
  QTest::newRow("inline, direct") << Runner::inline_ << 1'000'000;
  QTest::newRow("threaded, direct") << Runner::threaded << 1'000'000;
  QTest::newRow("inline, fast") << Runner::inline_ << 0;
  QTest::newRow("threaded, fast") << Runner::threaded << 0;
}

void LoadTrialTest::AHeldPullEndsInTheStaticSolution() {
  QFETCH(Runner, runner);
  QFETCH(int, fast_from);
  Engine engine(options(runner));
  engine.wait(engine.post(ImportMesh{}));
  StartTrial command;
  command.options.fast_from = fast_from;
  engine.wait(engine.post(command));
  const PatientModel& model = engine.snapshot()->state.model->model;
  const TrialPull pull = corner_pull(model);
  const auto held = settle(engine, pull);
  QVERIFY(held != nullptr);
  QCOMPARE(held->end, TrialEnd::none);
  const Points expected = equilibrium(model, pull, command.options);
  QCOMPARE(expected.rows(), held->nodes.rows());
  // The organ moves by 15 mm; what is left is the last steps' way, far below what anybody sees.
  QVERIFY(held->displacement_max > 0.015);
  const double error = (held->nodes - expected).rowwise().norm().maxCoeff();
  QVERIFY2(error < 1e-6, qPrintable(QString::number(error)));
  // What is shown of the pull belongs to that shape.
  Eigen::Vector3d grabbed = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    grabbed += pull.weights[static_cast<Eigen::Index>(k)] *
               expected.row(corners(model, pull.triangle)[k]).transpose();
  QVERIFY((held->grabbed - grabbed).norm() < 1e-6);
  QVERIFY((held->force - command.options.pull_stiffness * (pull.target - grabbed)).norm() < 1e-3);
  QVERIFY(held->residual <= 1e-6);
  QCOMPARE(held->tetrahedra, model.mesh.tetrahedron_count());
  QVERIFY(held->milliseconds > 0.0 && held->hertz > 0.0 && held->steps > 1);
}

void LoadTrialTest::ThePullIsNoStrongerThanItsLimit() {
  Engine engine(options(Runner::inline_));
  engine.wait(engine.post(ImportMesh{}));
  StartTrial command;
  command.options.pull_limit = 2.0;
  engine.wait(engine.post(command));
  const PatientModel& model = engine.snapshot()->state.model->model;
  TrialPull pull = corner_pull(model);
  pull.target += Eigen::Vector3d(0.05, -0.2, 0.1);
  const auto held = settle(engine, pull);
  QVERIFY(held != nullptr);
  QCOMPARE(held->end, TrialEnd::none);
  QVERIFY(std::abs(held->force.norm() - 2.0) < 1e-9);
  const Points expected = equilibrium(model, pull, command.options);
  const double error = (held->nodes - expected).rowwise().norm().maxCoeff();
  QVERIFY2(error < 1e-6, qPrintable(QString::number(error)));
}

void LoadTrialTest::AReleasedOrganReturnsToRest() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  start(engine);
  const auto held = settle(engine, corner_pull(engine.snapshot()->state.model->model));
  QVERIFY(held && held->nodes.rows() > 0);
  const auto released = settle(engine, std::nullopt);
  QVERIFY(released != nullptr);
  QCOMPARE(released->end, TrialEnd::none);
  QCOMPARE(released->nodes.rows(), Eigen::Index{0});  // at rest, exactly
  QCOMPARE(released->displacement_max, 0.0);
  QVERIFY(!released->pull);
  // 5 s of the organ's time at the most: it swings back, it does not creep.
  QVERIFY(released->steps - held->steps < 300);
}

void LoadTrialTest::ATrialChangesNothingOfTheCase() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  engine.wait(engine.post(ImportMesh{}));
  const auto before = engine.snapshot();
  engine.wait(engine.post(StartTrial{}));
  engine.submit_pull(corner_pull(before->state.model->model));
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial->nodes.rows() > 0);
  engine.wait(engine.post(StopTrial{}));
  const auto after = engine.snapshot();
  QCOMPARE(after->revision, before->revision);  // no reason to save
  for (int i = 0; i < kPartCount; ++i) {
    QVERIFY(after->state.shares(static_cast<Part>(i), before->state));
    QCOMPARE(after->stages[static_cast<std::size_t>(i)], before->stages[static_cast<std::size_t>(i)]);
  }
}

void LoadTrialTest::PullsThatAreNoneAreRefused_data() {
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

void LoadTrialTest::PullsThatAreNoneAreRefused() {
  QFETCH(Runner, runner);
  QFETCH(TrialPull, pull);
  Engine engine(puppet(runner));
  start(engine);
  const TrialPull good = at(3, {0.0, 0.0, 0.1});
  engine.submit_pull(good);
  QVERIFY_EXCEPTION_THROWN(engine.submit_pull(pull), PreconditionError);
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial->pull == good);  // the former one stays
}

void LoadTrialTest::StopEndsItAndPullsAreIgnored() {
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

void LoadTrialTest::AnotherModelEndsIt() {
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

void LoadTrialTest::OtherLandmarksEndIt() {
  QFETCH(Runner, runner);
  Engine engine(puppet(runner));
  start(engine);
  engine.wait(engine.post(SetLandmarks{}));
  QVERIFY(engine.snapshot()->trial == nullptr);  // the organ was held elsewhere
}

void LoadTrialTest::AStepThatFailsEndsItAndSaysWhy() {
  QFETCH(Runner, runner);
  for (const bool throws : {false, true}) {
    Engine engine(puppet(runner, [throws](const std::optional<TrialPull>&, TrialState& state) {
      if (throws) throw NumericalError("no");
      state.nodes.resize(0, 3);
      state.end = TrialEnd::inverted;
    }));
    start(engine);
    engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
    engine.wait_for_trial();
    const auto trial = engine.snapshot()->trial;
    QVERIFY(trial != nullptr);
    QCOMPARE(trial->end, throws ? TrialEnd::diverged : TrialEnd::inverted);
    QCOMPARE(trial->nodes.rows(), Eigen::Index{0});
    engine.submit_pull(at(3, {0.0, 0.0, 0.1}));
    engine.wait_for_trial();
    QVERIFY(engine.snapshot()->trial == trial);  // no more steps
  }
}

void LoadTrialTest::ElementsInsideOutEndIt() {
  Engine engine(options(Runner::inline_));
  engine.wait(engine.post(ImportMesh{}));
  StartTrial command;
  command.options.pull_stiffness = 1e4;
  command.options.pull_limit = 100.0;
  engine.wait(engine.post(command));
  TrialPull pull = corner_pull(engine.snapshot()->state.model->model);
  pull.target = {0.0, 0.1, 0.0};  // through the organ
  const auto trial = settle(engine, pull);
  QVERIFY(trial != nullptr);
  QCOMPARE(trial->end, TrialEnd::inverted);
  QCOMPARE(trial->nodes.rows(), Eigen::Index{0});
}

void LoadTrialTest::AnOrganThatNothingHoldsIsRefused() {
  CaseState state;
  const auto complaint_of = [&] {
    return test::complaint([&] { make_load_trial(state, TrialOptions{}, RunContext()); });
  };
  QVERIFY(complaint_of().find("model") != std::string::npos);  // there is none
  auto built = std::make_shared<model::BuiltModel>(*patient());
  built->model.landmarks = {};
  built->model.vessels.clear();
  state.model = built;
  QVERIFY(complaint_of().find("Place the vena cava") != std::string::npos);
  // Doing so is a remedy.
  state.landmarks = std::make_shared<Landmarks>(patient()->model.landmarks);
  QVERIFY(make_load_trial(state, TrialOptions{}, RunContext()).has_value());
  built->model.mesh = {};
  QVERIFY(complaint_of().find("tetrahedra") != std::string::npos);
}

void LoadTrialTest::OptionsOutOfRangeAreRefused_data() {
  QTest::addColumn<QString>("field");
  for (const char* field : {"time_step", "pull_stiffness", "pull_limit", "target_speed",
                            "boundary_young_modulus", "boundary_length", "fast_from"})
    QTest::newRow(field) << QString::fromLatin1(field);
}

void LoadTrialTest::OptionsOutOfRangeAreRefused() {
  QFETCH(QString, field);
  TrialOptions options;
  options.validate();
  if (field == QLatin1String("time_step")) options.time_step = 0.0;
  if (field == QLatin1String("pull_stiffness")) options.pull_stiffness = -1.0;
  if (field == QLatin1String("pull_limit")) options.pull_limit = std::numeric_limits<double>::quiet_NaN();
  if (field == QLatin1String("target_speed")) options.target_speed = 0.0;
  if (field == QLatin1String("boundary_young_modulus")) options.boundary_young_modulus = 0.0;
  if (field == QLatin1String("boundary_length")) options.boundary_length = -0.05;
  if (field == QLatin1String("fast_from")) options.fast_from = -1;
  const std::string said = test::complaint([&] { options.validate(); });
  QVERIFY2(said.find(field.toStdString()) != std::string::npos, said.c_str());
}

void LoadTrialTest::NewestPullWins() {
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

void LoadTrialTest::StepsGoOnByThemselvesAndRest() {
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

void LoadTrialTest::ACancelledStartLeavesNoTrial() {
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

void LoadTrialTest::AStopIsNotOvertakenByItsStart() {
  // The start must wait for the model that is being built; the stop, which touches nothing, must wait for the
  // start.
  auto gate = std::make_shared<Gate>();
  Engine::Options made = puppet(Runner::threaded);
  made.apply = [gate](const CaseState& state, const Command& command, const RunContext& context) {
    if (std::holds_alternative<BuildModel>(command)) gate->pass();
    return give_patient(state, command, context);
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

void LoadTrialTest::EditsGoOnBesideIt() {
  Engine engine(options(Runner::threaded));
  start(engine);
  engine.submit_pull(corner_pull(engine.snapshot()->state.model->model));
  for (int i = 0; i < 20; ++i) QCOMPARE(engine.wait(engine.post(SetSeeds{})).status, Status::done);
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial->nodes.rows() > 0);
}

void LoadTrialTest::TheDestructorJoinsInTheMiddleOfAStep() {
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

QTEST_APPLESS_MAIN(LoadTrialTest)
#include "load_trial_test.moc"
