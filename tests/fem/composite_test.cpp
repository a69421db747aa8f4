// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <memory>

#include "block_mesh.h"
#include "glisson/core/error.h"
#include "glisson/fem/composite_model.h"
#include "glisson/fem/integrator.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

/// 60 x 40 x 30 mm of liver with a forked vessel whose nodes lie in different tetrahedra.
std::unique_ptr<CompositeModel> liver_block(CompositeOptions options = {}) {
  TetMesh mesh = block_mesh({6, 4, 3}, {0.06, 0.04, 0.03});
  shake(mesh, 0.0015, 3);
  for (int t = 0; t < mesh.tetrahedron_count(); ++t)
    mesh.labels.push_back(t % 5 == 0 ? structure::kFirstLesion : structure::kParenchyma);
  options.by_label[structure::kFirstLesion] = {20e3, 0.4};
  std::vector<VesselTree> vessels{straight_vessel({0.004, 0.02, 0.015}, {0.055, 0.022, 0.017}, 9, 0.004),
                                  straight_vessel({0.02, 0.02, 0.015}, {0.041, 0.036, 0.025}, 5, 0.002)};
  return std::make_unique<CompositeModel>(mesh, vessels, options);
}

/// Largest difference between the force and minus the energy's central difference, relative to the largest
/// force.
double derivative_error(const CompositeModel& model, const Points& x) {
  const Points force = model.internal_force(x);
  const double h = 1e-7;
  double worst = 0.0;
  for (Eigen::Index i = 0; i < x.rows(); i += 3)
    for (int k = 0; k < 3; ++k) {
      Points high = x, low = x;
      high(i, k) += h;
      low(i, k) -= h;
      const double numeric = -(model.energy(high) - model.energy(low)) / (2.0 * h);
      worst = std::max(worst, std::abs(numeric - force(i, k)));
    }
  return worst / force.cwiseAbs().maxCoeff();
}

}  // namespace

class CompositeTest : public QObject {
  Q_OBJECT
 private slots:
  void ForceIsDerivativeOfEnergy_data() {
    QTest::addColumn<bool>("neo_hookean");
    QTest::addColumn<bool>("capsule");
    QTest::addColumn<bool>("vessels");
    QTest::newRow("corotational") << false << false << false;
    QTest::newRow("neo-Hookean") << true << false << false;
    QTest::newRow("capsule") << false << true << false;
    QTest::newRow("vessels") << false << false << true;
    QTest::newRow("all") << false << true << true;
    QTest::newRow("all, neo-Hookean") << true << true << true;
  }
  void ForceIsDerivativeOfEnergy() {
    QFETCH(bool, neo_hookean);
    QFETCH(bool, capsule);
    QFETCH(bool, vessels);
    CompositeOptions options;
    options.law = neo_hookean ? TetrahedronLaw::neo_hookean : TetrahedronLaw::corotational;
    options.with_capsule = capsule;
    options.with_vessels = vessels;
    const auto model = liver_block(options);
    QCOMPARE(model->beam_count(), vessels ? 14 : 0);
    const Points& rest = model->mesh().vertices;
    // Bent, and so far that elements are turned by 40 degrees; then with noise on top. Central differences
    // of 1e-7 m carry about 1e-8 of truncation and 1e-7 of round-off: the force is exact, beams included.
    const Points x = bent(rest);
    QVERIFY2(derivative_error(*model, x) < 2e-6, qPrintable(QString::number(derivative_error(*model, x))));
    const Points y = x + noise(x.rows(), 0.001, 5);
    QVERIFY2(derivative_error(*model, y) < 2e-6, qPrintable(QString::number(derivative_error(*model, y))));
  }

  /// 65552 is a lesion's 16 in sixteen bits, and so is -65520.
  void NumbersThatAreNoLabelsAreParenchyma() {
    const TetMesh plain = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    CompositeOptions options;
    options.with_capsule = false;
    options.by_label[structure::kFirstLesion] = {20e3, 0.4};
    const auto energy = [&](int label) {
      TetMesh mesh = plain;
      if (label != 0) mesh.labels.assign(static_cast<std::size_t>(mesh.tetrahedron_count()), label);
      return CompositeModel(mesh, {}, options).energy(bent(mesh.vertices));
    };
    QVERIFY(energy(structure::kFirstLesion) > 2.0 * energy(0));
    for (const int label : {1, 65535, 65552, -65520}) QCOMPARE(energy(label), energy(0));
  }

  void RigidMotionLeavesNoForce() {
    for (const TetrahedronLaw law : {TetrahedronLaw::corotational, TetrahedronLaw::neo_hookean}) {
      CompositeOptions options;
      options.law = law;
      const auto model = liver_block(options);
      const Points& rest = model->mesh().vertices;
      const double scale = model->internal_force(bent(rest)).cwiseAbs().maxCoeff();
      for (unsigned seed = 0; seed < 20; ++seed) {
        const Points x =
            (rest * random_rotation(seed).transpose()).rowwise() + Eigen::RowVector3d(0.3, -0.2, 0.1);
        QVERIFY(model->internal_force(x).cwiseAbs().maxCoeff() < 1e-11 * scale);
        QVERIFY(std::abs(model->energy(x)) < 1e-13);
      }
    }
  }

  void ForcesBalanceInAnyState() {
    const auto model = liver_block();
    const Points x = bent(model->mesh().vertices) + noise(model->node_count(), 0.002, 9);
    const Points force = model->internal_force(x);
    const double scale = force.cwiseAbs().sum();
    QVERIFY(force.colwise().sum().norm() < 1e-12 * scale);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      moment += x.row(i).transpose().cross(force.row(i).transpose());
    QVERIFY(moment.norm() < 1e-12 * scale);
  }

  void StepFallsFreelyUnderGravityChange() {
    CompositeOptions options;
    options.rayleigh_mass = 0.0;
    const std::shared_ptr<const CompositeModel> model = liver_block(options);
    Integrator integrator(model, {});
    Loads loads;
    loads.gravity_change = {0.0, 0.0, -9.81};
    for (int n = 0; n < 10; ++n) QVERIFY(integrator.step(loads).ok);
    // Backward Euler: v = g t exactly, and no strain.
    const Points expected = Eigen::RowVector3d(0.0, 0.0, -9.81 * 0.2).replicate(model->node_count(), 1);
    QVERIFY((integrator.velocities() - expected).cwiseAbs().maxCoeff() < 1e-10);
  }

  void StepsRepeatToTheBit() {
    const std::shared_ptr<const CompositeModel> model = liver_block();
    for (const LinearSolver solver : {LinearSolver::reference, LinearSolver::direct}) {
      Points previous;
      for (int run = 0; run < 2; ++run) {
        IntegratorOptions options;
        options.solver = solver;
        options.fixed_nodes = nodes_at(model->mesh(), 0, 0.0);
        Integrator integrator(model, options);
        Loads loads;
        loads.gravity_change = {0.0, 9.81, 0.0};
        loads.pressure = 200.0;
        for (int n = 0; n < 20; ++n) {
          const StepSummary summary = integrator.step(loads);
          QVERIFY(summary.ok);
          QVERIFY(summary.residual < 1e-10);
        }
        if (run == 0)
          previous = integrator.positions();
        else
          QVERIFY((previous.array() == integrator.positions().array()).all());
      }
    }
  }

  void DynamicsSettleAtTheStaticSolution() {
    CompositeOptions options;
    options.rayleigh_mass = 30.0;
    const std::shared_ptr<const CompositeModel> model = liver_block(options);
    IntegratorOptions dynamic;
    dynamic.fixed_nodes = nodes_at(model->mesh(), 0, 0.0);
    Integrator integrator(model, dynamic);
    Loads loads;
    loads.gravity_change = {0.0, 9.81, 9.81};
    loads.pressure = 300.0;
    for (int n = 0; n < 800; ++n) QVERIFY(integrator.step(loads).ok);
    StaticOptions held;
    held.fixed_nodes = dynamic.fixed_nodes;
    const auto solution = solve_static(
        *model, model->mesh().vertices, [&](const Points&) { return loads; }, held, RunContext());
    QVERIFY(solution.has_value());
    QVERIFY2(solution->converged(), qPrintable(QString::number(solution->residual)));
    qInfo("static: %d iterations, residual %.1e", solution->iterations, solution->residual);
    const Points& rest = model->mesh().vertices;
    const double moved = (solution->positions - rest).rowwise().norm().maxCoeff();
    QVERIFY(moved > 1e-4);
    QVERIFY((integrator.positions() - solution->positions).rowwise().norm().maxCoeff() < 1e-3 * moved);
  }

  void NothingHoldsTheModelIsRefused() {
    const auto model = liver_block();
    Loads loads;
    loads.gravity_change = {0.0, 0.0, 1.0};
    QVERIFY_THROWS_EXCEPTION(NumericalError, solve_static(
                                                 *model, model->mesh().vertices,
                                                 [&](const Points&) { return loads; }, {}, RunContext()));
  }
};

QTEST_APPLESS_MAIN(CompositeTest)
#include "composite_test.moc"
