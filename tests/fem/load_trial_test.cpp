// SPDX-License-Identifier: GPL-3.0-or-later
// The mechanics of a load that is tried: a block whose left face hangs on springs, pulled at its right one.
#include "glisson/fem/load_trial.h"

#include <QTest>

#include <limits>

#include "block_mesh.h"
#include "complaint.h"
#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::fem;

namespace {

constexpr double kSpring = 2e4;  ///< N/m a node

std::shared_ptr<const CompositeModel> block() {
  TetMesh mesh = fem_test::block_mesh({4, 2, 2}, {0.08, 0.04, 0.04});
  mesh.labels.assign(static_cast<std::size_t>(mesh.tetrahedron_count()), structure::kParenchyma);
  return std::make_shared<const CompositeModel>(mesh, std::vector<VesselTree>{}, CompositeOptions{});
}

/// Springs from the nodes at x = 0 to where they are at rest.
Holding left_face_of(const Points& rest) {
  return [rest](const Points& nodes, std::vector<AttachedLoad>& loads) {
    for (int i = 0; i < static_cast<int>(rest.rows()); ++i) {
      if (rest(i, 0) > 1e-9) continue;
      AttachedLoad spring;
      spring.nodes[0] = i;
      spring.weights[0] = 1.0;
      spring.force = kSpring * (rest.row(i) - nodes.row(i)).transpose();
      spring.tangent = kSpring * Eigen::Matrix3d::Identity();
      loads.push_back(spring);
    }
  };
}

std::unique_ptr<LoadTrial> trial_of(const std::shared_ptr<const CompositeModel>& model,
                                    const TrialOptions& options = {}) {
  return make_load_trial(model, left_face_of(model->mesh().vertices), options);
}

/// At a corner of the face on the right, wanted that far above it.
TrialPull lift(const CompositeModel& model, double height) {
  const TriangleMesh& skin = model.surface().mesh;
  TrialPull pull;
  for (int t = 0; t < skin.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector3d p = skin.vertices.row(skin.triangles(t, k));
      if (p.x() < 0.08 - 1e-9 || p.y() > 1e-9 || p.z() > 1e-9) continue;
      pull.triangle = t;
      pull.weights = Eigen::Vector3d::Unit(k);
      pull.target = p.transpose() + Eigen::Vector3d(0.0, 0.0, height);
    }
  return pull;
}

}  // namespace

class LoadTrialTest : public QObject {
  Q_OBJECT
 private slots:
  void TheGrabbedPointFollowsThePull();
  void AJumpOfThePointerIsNoBlow();
  void ThePullIsNoStrongerThanItsLimit();
  void AReleasedOrganReturnsToRest();
  void PlacesOnOneLineHoldNothing();
  void PullsBesideTheSurfaceAreRefused();
  void OptionsOutOfRangeAreRefused_data();
  void OptionsOutOfRangeAreRefused();
};

void LoadTrialTest::TheGrabbedPointFollowsThePull() {
  const auto model = block();
  const auto trial = trial_of(model);
  const TrialPull pull = lift(*model, 0.005);
  TrialState state;
  for (int i = 0; i < 200; ++i) state = trial->step(pull);
  QVERIFY(!state.termination && state.pull == pull);
  QCOMPARE(state.nodes.rows(), model->mesh().vertices.rows());
  QVERIFY(state.displacement_max > 0.001 && state.displacement_max < 0.006);
  QVERIFY(state.force.z() > 0.0);
  const Eigen::Vector3d spring = TrialOptions{}.pull_stiffness * (pull.target - state.grabbed);
  QVERIFY((state.force - spring).norm() < 1e-9);
  QCOMPARE(state.tetrahedra, model->mesh().tetrahedron_count());
}

/// What pulls starts at the grabbed point: after one step it is no further on than its speed allows.
void LoadTrialTest::AJumpOfThePointerIsNoBlow() {
  const auto model = block();
  const TrialOptions options;
  const TrialState state = trial_of(model, options)->step(lift(*model, 0.3));
  const double most = options.pull_stiffness * options.target_speed * options.time_step;
  QVERIFY(most < options.pull_limit);
  QVERIFY(state.force.norm() > 0.0 && state.force.norm() <= most);
}

void LoadTrialTest::ThePullIsNoStrongerThanItsLimit() {
  const auto model = block();
  TrialOptions options;
  options.pull_limit = 0.05;
  const auto trial = trial_of(model, options);
  TrialState state;
  const TrialPull pull = lift(*model, 0.1);
  for (int i = 0; i < 100; ++i) state = trial->step(pull);
  QVERIFY(!state.termination);
  QVERIFY(std::abs(state.force.norm() - 0.05) < 1e-9);
}

void LoadTrialTest::AReleasedOrganReturnsToRest() {
  const auto model = block();
  const auto trial = trial_of(model);
  const TrialPull pull = lift(*model, 0.005);
  for (int i = 0; i < 60; ++i) trial->step(pull);
  TrialState state = trial->step({});
  QVERIFY(state.nodes.rows() > 0);
  for (int i = 0; i < 1500 && state.nodes.rows() > 0; ++i) state = trial->step({});
  QCOMPARE(state.nodes.rows(), Eigen::Index{0});  // at rest, exactly
  QCOMPARE(state.displacement_max, 0.0);
  QVERIFY(!state.pull && !state.termination);
}

void LoadTrialTest::PlacesOnOneLineHoldNothing() {
  PatientModel model;
  QVERIFY(!is_held(model));
  model.vessels = {fem_test::straight_vessel({0.01, 0.041, 0.026}, {0.11, 0.039, 0.024}, 5, 4e-3)};
  model.landmarks.vena_cava = model.vessels[0].nodes.middleRows(2, 2);
  QVERIFY(!is_held(model));
  model.landmarks.vena_cava.row(0) += Eigen::RowVector3d(0.0, 0.03, 0.0);
  QVERIFY(is_held(model));
}

void LoadTrialTest::PullsBesideTheSurfaceAreRefused() {
  TrialPull pull{3, {0.5, 0.25, 0.25}, Eigen::Vector3d::Zero()};
  pull.require_on_surface(4);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, pull.require_on_surface(3));
  TrialPull heavy = pull;
  heavy.weights[0] = 0.6;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, heavy.require_on_surface(4));
  TrialPull nowhere = pull;
  nowhere.target[1] = std::numeric_limits<double>::infinity();
  QVERIFY_THROWS_EXCEPTION(PreconditionError, nowhere.require_on_surface(4));
  pull.triangle = -1;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, pull.require_on_surface(4));
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
  QCOMPARE(test::complaint([&] { trial_of(block(), options); }), said);
  // Before anything is asked of the model: what holds it is made with them.
  const auto hold = []() -> Holding { throw PreconditionError("nothing is made with such options"); };
  QCOMPARE(test::complaint([&] { make_load_trial(PatientModel(), {}, hold, options, RunContext()); }), said);
}

QTEST_APPLESS_MAIN(LoadTrialTest)
#include "load_trial_test.moc"
