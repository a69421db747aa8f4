// SPDX-License-Identifier: GPL-3.0-or-later
// The mechanics of a load that is tried live, through the engine: the static solution under a held pull, the
// way back to rest, the case as it was.
#include "glisson/engine/load_trial.h"

#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/start_trial.h"
#include "glisson/engine/commands/stop_trial.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/fem/integrator.h"
#include "glisson/guidance/boundary_springs.h"
#include "runners.h"
#include "trial_patient.h"

using namespace glisson;
using namespace glisson::engine;
using test::both_runners;

namespace {

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
  return solved && solved->converged() ? solved->positions : Points();
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
 private slots:
  void AHeldPullEndsInTheStaticSolution_data();
  void AHeldPullEndsInTheStaticSolution();
  void ThePullIsNoStrongerThanItsLimit();
  void AReleasedOrganReturnsToRest_data() { both_runners(); }
  void AReleasedOrganReturnsToRest();
  void ATrialChangesNothingOfTheCase_data() { both_runners(); }
  void ATrialChangesNothingOfTheCase();
  void ElementsInsideOutEndIt();
  void AnOrganThatNothingHoldsIsRefused();
  void OptionsOutOfRangeAreRefusedBeforeAnythingElse();
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
  const PatientModel& model = engine.snapshot()->state[part::model]->model;
  const TrialPull pull = corner_pull(model);
  const auto held = settle(engine, pull);
  QVERIFY(held != nullptr);
  QVERIFY(!held->termination);
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
  const PatientModel& model = engine.snapshot()->state[part::model]->model;
  TrialPull pull = corner_pull(model);
  pull.target += Eigen::Vector3d(0.05, -0.2, 0.1);
  const auto held = settle(engine, pull);
  QVERIFY(held != nullptr);
  QVERIFY(!held->termination);
  QVERIFY(std::abs(held->force.norm() - 2.0) < 1e-9);
  const Points expected = equilibrium(model, pull, command.options);
  const double error = (held->nodes - expected).rowwise().norm().maxCoeff();
  QVERIFY2(error < 1e-6, qPrintable(QString::number(error)));
}

void LoadTrialTest::AReleasedOrganReturnsToRest() {
  QFETCH(Runner, runner);
  Engine engine(options(runner));
  start(engine);
  const auto held = settle(engine, corner_pull(engine.snapshot()->state[part::model]->model));
  QVERIFY(held && held->nodes.rows() > 0);
  const auto released = settle(engine, std::nullopt);
  QVERIFY(released != nullptr);
  QVERIFY(!released->termination);
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
  engine.submit_pull(corner_pull(before->state[part::model]->model));
  engine.wait_for_trial();
  QVERIFY(engine.snapshot()->trial->nodes.rows() > 0);
  engine.wait(engine.post(StopTrial{}));
  const auto after = engine.snapshot();
  QCOMPARE(after->revision, before->revision);  // no reason to save
  for (const Part part : all_parts()) {
    QVERIFY(after->state.shares(part, before->state));
    QCOMPARE(after->stage(part), before->stage(part));
  }
}

void LoadTrialTest::ElementsInsideOutEndIt() {
  Engine engine(options(Runner::inline_));
  engine.wait(engine.post(ImportMesh{}));
  StartTrial command;
  command.options.pull_stiffness = 1e4;
  command.options.pull_limit = 100.0;
  engine.wait(engine.post(command));
  TrialPull pull = corner_pull(engine.snapshot()->state[part::model]->model);
  pull.target = {0.0, 0.1, 0.0};  // through the organ
  const auto trial = settle(engine, pull);
  QVERIFY(trial != nullptr);
  QVERIFY(trial->termination == Termination::diverged);
  QVERIFY(trial->inverted_tetrahedra > 0);
  QCOMPARE(trial->nodes.rows(), Eigen::Index{0});
}

void LoadTrialTest::AnOrganThatNothingHoldsIsRefused() {
  CaseState state;
  const auto complaint_of = [&] {
    return test::complaint([&] { make_load_trial(state, TrialOptions{}, RunContext()); });
  };
  // Without a model the engine refuses.
  QVERIFY(obstacle(state, StartTrial{}) == (Obstacle{Obstacle::Kind::missing, part::model, part::labels}));
  auto built = std::make_shared<model::BuiltModel>(*patient());
  built->model.landmarks = {};
  built->model.vessels.clear();
  state[part::model] = built;
  QVERIFY(complaint_of().find("Place the vena cava") != std::string::npos);
  // Two places do not keep it from turning, nor do three in a row.
  built->model.vessels = patient()->model.vessels;
  auto cava = std::make_shared<Landmarks>();
  cava->vena_cava = patient()->model.vessels[0].nodes.middleRows(2, 2);
  state[part::landmarks] = cava;
  QVERIFY(complaint_of().find("one line") != std::string::npos);
  built->model.vessels.clear();
  // Placing the vena cava where it is remedies both.
  state[part::landmarks] = std::make_shared<Landmarks>(patient()->model.landmarks);
  QVERIFY(make_load_trial(state, TrialOptions{}, RunContext()).has_value());
  built->model.mesh = {};
  QVERIFY(complaint_of().find("tetrahedra") != std::string::npos);
}

void LoadTrialTest::OptionsOutOfRangeAreRefusedBeforeAnythingElse() {
  auto built = std::make_shared<model::BuiltModel>(*patient());
  built->model.landmarks = {};
  built->model.vessels.clear();
  CaseState state;
  state[part::model] = built;
  TrialOptions options;
  options.boundary_young_modulus = 0.0;  // no spring could be made of it
  const std::string said = test::complaint([&] { options.validate(); });
  QVERIFY2(said.find("boundary_young_modulus") != std::string::npos, said.c_str());
  QCOMPARE(test::complaint([&] { make_load_trial(state, options, RunContext()); }), said);
}

QTEST_APPLESS_MAIN(LoadTrialTest)
#include "load_trial_test.moc"
