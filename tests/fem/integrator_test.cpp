// SPDX-License-Identifier: GPL-3.0-or-later
// Steps in time: what they keep, what they must not depend on, what they do when they cannot.
#include <QTest>
#include <limits>
#include <memory>
#include <numeric>

#include "block_mesh.h"
#include "ellipsoid_mesh.h"
#include "glisson/fem/integrator.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

class IntegratorTest : public QObject {
  Q_OBJECT
 private slots:
  void LinearMomentumIsKeptInFreeFlight() {
    CompositeOptions options;
    options.rayleigh_mass = 0.0;
    const auto model = std::make_shared<CompositeModel>(ellipsoid_mesh(6), ellipsoid_vessels(20), options);
    Integrator integrator(model, {});
    const Points velocities = noise(model->node_count(), 0.5, 3);
    integrator.set_state(model->mesh().vertices, velocities);
    const Eigen::RowVector3d before = model->lumped_mass().transpose() * velocities;
    double energy = std::numeric_limits<double>::infinity();
    for (int n = 0; n < 30; ++n) {
      const StepSummary step = integrator.step({});
      QVERIFY(step.ok);
      const double now = step.kinetic_energy + model->energy(integrator.positions());
      QVERIFY(now <= energy * (1.0 + 1e-12));  // backward Euler only loses
      energy = now;
    }
    const Eigen::RowVector3d after = model->lumped_mass().transpose() * integrator.velocities();
    QVERIFY((after - before).norm() < 1e-9 * (model->lumped_mass().sum() * 0.5));
  }

  void AnswersDoNotDependOnTheNumbering() {
    TetMesh mesh = ellipsoid_mesh(8);
    shake(mesh, 0.001, 5);  // no vessel node on a face, where two tetrahedra may claim it
    std::vector<int> order(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(order.begin(), order.end(), 0);
    std::mt19937_64 random(11);
    std::shuffle(order.begin(), order.end(), random);
    TetMesh other = mesh;
    for (int i = 0; i < mesh.vertex_count(); ++i)
      other.vertices.row(order[static_cast<std::size_t>(i)]) = mesh.vertices.row(i);
    for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
      // Another order of elements, and an even permutation of their nodes.
      const int from = mesh.tetrahedron_count() - 1 - t;
      const int turn[4] = {2, 0, 1, 3};
      for (int k = 0; k < 4; ++k)
        other.tetrahedra(t, k) = order[static_cast<std::size_t>(mesh.tetrahedra(from, turn[k]))];
    }
    Points results[2];
    for (int run = 0; run < 2; ++run) {
      const auto model = std::make_shared<CompositeModel>(run == 0 ? mesh : other, ellipsoid_vessels(40),
                                                          CompositeOptions{});
      Integrator integrator(model, {});
      Loads loads;
      loads.gravity_change = {3.0, 9.81, 0.0};
      loads.pressure = 500.0;
      for (int n = 0; n < 10; ++n) QVERIFY(integrator.step(loads).ok);
      results[run] = integrator.positions();
    }
    double worst = 0.0;
    for (int i = 0; i < mesh.vertex_count(); ++i)
      worst =
          std::max(worst, (results[0].row(i) - results[1].row(order[static_cast<std::size_t>(i)])).norm());
    QVERIFY2(worst < 1e-9, qPrintable(QString::number(worst)));
  }

  void AnswersDoNotDependOnTheUnitOfLength() {
    // The same organ ten times as long, of ten times Young's modulus and a tenth of the density: time stays,
    // so every displacement is ten times as long. What remains is round-off.
    TetMesh mesh = ellipsoid_mesh(8);
    shake(mesh, 0.001, 5);
    std::vector<VesselTree> vessels = ellipsoid_vessels(40);
    CompositeOptions options;
    Points results[2];
    for (int run = 0; run < 2; ++run) {
      const double scale = run == 0 ? 1.0 : 10.0;
      TetMesh scaled = mesh;
      scaled.vertices *= scale;
      std::vector<VesselTree> trees = vessels;
      for (VesselTree& tree : trees) {
        tree.nodes *= scale;
        for (double& radius : tree.radii) radius *= scale;
      }
      CompositeOptions o = options;
      for (Material* m : {&o.parenchyma, &o.vessel_wall, &o.capsule}) m->young_modulus *= scale;
      o.capsule_thickness *= scale;
      o.density /= scale;
      const auto model = std::make_shared<CompositeModel>(scaled, trees, o);
      Integrator integrator(model, {});
      Loads loads;
      loads.gravity_change = scale * Eigen::Vector3d(3.0, 9.81, 0.0);
      loads.pressure = scale * 500.0;
      for (int n = 0; n < 10; ++n) QVERIFY(integrator.step(loads).ok);
      results[run] = integrator.positions() / scale;
    }
    const double moved = (results[0] - mesh.vertices).rowwise().norm().maxCoeff();
    QVERIFY(moved > 0.01);
    QVERIFY((results[1] - results[0]).rowwise().norm().maxCoeff() < 1e-9 * moved);
  }

  void PrescribedNodesPullLikeVeryStiffSprings() {
    // One end of a bar of liver held, the other led 5 mm away within 10 steps: by prescription, and by
    // springs that are ten million times stiffer than the bar.
    const TetMesh mesh = block_mesh({6, 2, 2}, {0.06, 0.02, 0.02});
    CompositeOptions composite;
    composite.mass = MassMatrix::consistent;  // its couplings count, too
    const auto model = std::make_shared<CompositeModel>(mesh, std::vector<VesselTree>{}, composite);
    const std::vector<int> held = nodes_at(mesh, 0, 0.0), led = nodes_at(mesh, 0, 0.06);
    IntegratorOptions by_prescription, by_springs;
    by_springs.fixed_nodes = by_prescription.fixed_nodes = held;
    by_prescription.fixed_nodes.insert(by_prescription.fixed_nodes.end(), led.begin(), led.end());
    Integrator first(model, by_prescription), second(model, by_springs);
    for (int n = 1; n <= 20; ++n) {
      const Eigen::Vector3d by = std::min(1.0, n / 10.0) * Eigen::Vector3d(0.004, 0.0, 0.003);
      Loads prescribed, springs;
      for (const int node : led) {
        prescribed.prescribed.push_back({node, mesh.vertex(node) + by});
        AttachedLoad spring;
        spring.nodes[0] = node;
        spring.weights[0] = 1.0;
        spring.tangent = 1e9 * Eigen::Matrix3d::Identity();
        spring.force = spring.tangent * (mesh.vertex(node) + by - second.positions().row(node).transpose());
        springs.attached.push_back(spring);
      }
      QVERIFY(first.step(prescribed).ok);
      QVERIFY(second.step(springs).ok);
      for (const int node : led)
        QVERIFY((first.positions().row(node) - mesh.vertices.row(node) - by.transpose()).norm() < 1e-15);
      // The springs give by a ten millionth; a factor of 1e9 N/m against 100 costs digits, too.
      const double apart = (first.positions() - second.positions()).rowwise().norm().maxCoeff();
      QVERIFY2(apart < 1e-7, qPrintable(QString("step %1: %2").arg(n).arg(apart)));
    }
  }

  void FixedNodesStay() {
    const auto model =
        std::make_shared<CompositeModel>(ellipsoid_mesh(6), ellipsoid_vessels(20), CompositeOptions{});
    IntegratorOptions options;
    options.fixed_nodes = {0, 5, 17, 5};
    Integrator integrator(model, options);
    Loads loads;
    loads.gravity_change = {0.0, 0.0, -9.81};
    for (int n = 0; n < 5; ++n) QVERIFY(integrator.step(loads).ok);
    for (const int node : options.fixed_nodes)
      QVERIFY((integrator.positions().row(node).array() == model->mesh().vertices.row(node).array()).all());
    QVERIFY((integrator.positions() - model->mesh().vertices).norm() > 1e-3);
  }

  void FailedStepLeavesTheState() {
    const auto model =
        std::make_shared<CompositeModel>(ellipsoid_mesh(6), std::vector<VesselTree>{}, CompositeOptions{});
    Integrator integrator(model, {});
    Points far = model->mesh().vertices;
    far.row(7).setConstant(1e200);  // its energy is not a number
    integrator.set_state(far);
    const StepSummary step = integrator.step({});
    QVERIFY(!step.ok);
    QVERIFY((integrator.positions().array() == far.array()).all());
  }

  void InvertedTetrahedraAreCountedAndRecover() {
    const TetMesh mesh = block_mesh({3, 3, 3}, {0.03, 0.03, 0.03});
    const auto model = std::make_shared<CompositeModel>(mesh, std::vector<VesselTree>{}, CompositeOptions{});
    Integrator integrator(model, {});
    Points turned = mesh.vertices;
    for (int i = 0; i < mesh.vertex_count(); ++i)
      if ((mesh.vertex(i) - Eigen::Vector3d(0.01, 0.01, 0.01)).norm() < 1e-6)
        turned.row(i).setConstant(0.025);
    integrator.set_state(turned);
    StepSummary step = integrator.step({});
    QVERIFY(step.ok);
    QVERIFY(step.inverted_tetrahedra > 0);
    for (int n = 0; n < 200 && step.inverted_tetrahedra > 0; ++n) step = integrator.step({});
    QCOMPARE(step.inverted_tetrahedra, 0);
  }
};

QTEST_APPLESS_MAIN(IntegratorTest)
#include "integrator_test.moc"
