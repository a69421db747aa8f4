// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <QtTest>
#include <limits>
#include <memory>
#include <numeric>

#include "block_mesh.h"
#include "ellipsoid_mesh.h"
#include "glisson/core/error.h"
#include "glisson/fem/beam.h"
#include "glisson/fem/integrator.h"
#include "glisson/fem/stiffness.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

CompositeOptions homogeneous() {
  CompositeOptions options;
  options.with_capsule = options.with_vessels = false;
  return options;
}

std::vector<int> boundary_nodes(const CompositeModel& model) { return model.surface().node_of_vertex; }

/// Minus the force's derivative along `direction`, by central differences.
Eigen::VectorXd numeric_product(const std::function<Points(const Points&)>& force, const Points& x,
                                const Points& direction) {
  const double h = 1e-6;
  const Points difference = (force(x - h * direction) - force(x + h * direction)) / (2.0 * h);
  return Eigen::Map<const Eigen::VectorXd>(difference.data(), difference.size());
}

Eigen::VectorXd flat(const Points& p) { return Eigen::Map<const Eigen::VectorXd>(p.data(), p.size()); }

/// Sum of the internal forces on the nodes at x = value, along x.
double pull_at(const CompositeModel& model, const Points& x, double value) {
  const Points force = model.internal_force(x);
  double sum = 0.0;
  for (const int node : nodes_at(model.mesh(), 0, value)) sum -= force(node, 0);
  return sum;
}

Points stretched(const Points& rest, double strain, double poisson) {
  Points x = rest;
  x.col(0) *= 1.0 + strain;
  x.rightCols<2>() *= 1.0 - poisson * strain;
  return x;
}

}  // namespace

class ModelTest : public QObject {
  Q_OBJECT
 private slots:
  void PatchTestHoldsForLargeStrains_data() {
    QTest::addColumn<bool>("neo_hookean");
    QTest::newRow("corotational") << false;
    QTest::newRow("neo-Hookean") << true;
  }
  void PatchTestHoldsForLargeStrains() {
    QFETCH(bool, neo_hookean);
    TetMesh mesh = block_mesh({4, 3, 3}, {0.04, 0.03, 0.03});
    shake(mesh, 0.002, 1);
    CompositeOptions options = homogeneous();
    options.law = neo_hookean ? TetrahedronLaw::neo_hookean : TetrahedronLaw::corotational;
    const CompositeModel model(mesh, {}, options);
    Eigen::Matrix3d f;
    f << 1.1, 0.2, 0.05, -0.1, 0.9, 0.1, 0.0, 0.15, 1.05;
    const Points expected = mesh.vertices * (random_rotation(2) * f).transpose();
    // The boundary is where the affine map puts it, the inside starts elsewhere.
    StaticOptions held;
    held.fixed_nodes = boundary_nodes(model);
    held.tolerance = 1e-13;
    Points start = expected;
    const Points off = noise(start.rows(), 0.001, 4);
    std::vector<bool> inside(static_cast<std::size_t>(start.rows()), true);
    for (const int node : held.fixed_nodes) inside[static_cast<std::size_t>(node)] = false;
    Loads loads;
    for (int i = 0; i < start.rows(); ++i)
      if (inside[static_cast<std::size_t>(i)]) start.row(i) += off.row(i);
    loads.gravity_change = {0.0, 0.0, 1e-9};  // gives the residual a scale
    const auto solution = solve_static(
        model, start, [&](const Points&) { return loads; }, held, RunContext());
    QVERIFY(solution);
    QVERIFY((solution->positions - expected).cwiseAbs().maxCoeff() < 1e-9);
  }

  void BarInTensionFollowsYoungAndPoisson() {
    TetMesh mesh = block_mesh({6, 3, 3}, {0.06, 0.02, 0.02});
    shake(mesh, 0.001, 1);
    const CompositeModel model(mesh, {}, homogeneous());
    const double strain = 0.05;
    const Points x = stretched(mesh.vertices, strain, 0.45);
    const double expected = 3500.0 * 4e-4 * strain;
    QVERIFY(std::abs(pull_at(model, x, 0.06) - expected) < 1e-10);
    // The lateral faces are free of force.
    const Points force = model.internal_force(x);
    for (int i = 0; i < model.node_count(); ++i)
      if (mesh.vertices(i, 0) > 1e-9 && mesh.vertices(i, 0) < 0.06 - 1e-9)
        QVERIFY(force.row(i).norm() < 1e-10);
  }

  void CapsuleAddsEhTimesThePerimeter() {
    const TetMesh mesh = block_mesh({6, 2, 2}, {0.06, 0.02, 0.02});
    CompositeOptions options = homogeneous();
    options.with_capsule = true;
    const CompositeModel model(mesh, {}, options);
    const double strain = 0.05;
    const Points x = stretched(mesh.vertices, strain, 0.45);
    // In the middle of the bar, between the end faces with capsules of their own: work of the stretch.
    const double middle = 0.5 * (3500.0 * 4e-4 + 8e6 * 20e-6 * 0.08) * strain * strain * 0.06;
    // Equal Poisson ratios: the sides are in uniaxial tension. The end faces only narrow: plane strain energy
    // h A E / (1 - nu) e^2 with e = nu strain.
    const double ends = 2.0 * 20e-6 * 4e-4 * 8e6 / 0.55 * (0.45 * strain) * (0.45 * strain);
    QVERIFY(std::abs(model.energy(x) / (middle + ends) - 1.0) < 1e-10);
  }

  void EmbeddedVesselFollowsTheRuleOfMixtures() {
    TetMesh mesh = block_mesh({8, 4, 4}, {0.08, 0.02, 0.02});
    shake(mesh, 0.0015, 2);
    CompositeOptions options = homogeneous();
    options.with_vessels = true;
    const VesselTree vessel = straight_vessel({0.0, 0.011, 0.009}, {0.08, 0.011, 0.009}, 13, 0.003);
    const CompositeModel model(mesh, {vessel}, options);
    QCOMPARE(model.vessel_nodes_outside(), 0);
    QCOMPARE(model.beam_count(), 13);
    const double axial = BeamSection::hollow(0.003, 0.0003, options.vessel_wall).axial;
    const double mixture = 3500.0 * 4e-4 + axial;
    QVERIFY(axial > 2.0 * 3500.0 * 4e-4);  // the vessel counts
    const double strain = 0.02;
    const Points x = stretched(mesh.vertices, strain, 0.45);
    QVERIFY(std::abs(2.0 * model.energy(x) / (strain * strain * 0.08) / mixture - 1.0) < 1e-9);
    QVERIFY(std::abs(pull_at(model, x, 0.08) / (mixture * strain) - 1.0) < 1e-9);
    // And solved for, between grips that cannot narrow: stiffer than the mixture by a little.
    StaticOptions held;
    held.fixed_nodes = nodes_at(mesh, 0, 0.0);
    const std::vector<int> end = nodes_at(mesh, 0, 0.08);
    held.fixed_nodes.insert(held.fixed_nodes.end(), end.begin(), end.end());
    Points start = mesh.vertices;
    start.col(0) *= 1.0 + strain;
    Loads loads;
    loads.gravity_change = {0.0, 0.0, 1e-6};
    held.tolerance = 1e-4;
    const auto solution = solve_static(
        model, start, [&](const Points&) { return loads; }, held, RunContext());
    QVERIFY(solution && solution->converged);
    const double ratio = pull_at(model, solution->positions, 0.08) / (mixture * strain);
    QVERIFY2(ratio > 1.0 && ratio < 1.08, qPrintable(QString::number(ratio)));
  }

  void TangentIsTheForcesDerivative() {
    TetMesh mesh = block_mesh({4, 3, 3}, {0.04, 0.03, 0.03});
    shake(mesh, 0.0015, 3);
    const VesselTree vessel = straight_vessel({0.003, 0.014, 0.015}, {0.037, 0.017, 0.013}, 6, 0.003);
    const Points direction = noise(mesh.vertex_count(), 1.0, 8);
    for (const bool vessels : {false, true}) {
      CompositeOptions options;
      options.with_vessels = vessels;
      const CompositeModel model(mesh, {vessel}, options);
      const auto force = [&](const Points& y) { return model.internal_force(y); };
      const Points rest = mesh.vertices;
      const Points x = bent(rest) + noise(rest.rows(), 0.0005, 2);
      // At rest all kinds are the derivative; the differences are the finite step's.
      const Eigen::VectorXd at_rest = numeric_product(force, rest, direction);
      for (const Tangent kind : {Tangent::rotated, Tangent::projected, Tangent::exact})
        QVERIFY((stiffness_matrix(model, rest, kind) * flat(direction) - at_rest).norm() <
                1e-4 * at_rest.norm());
      const Eigen::VectorXd there = numeric_product(force, x, direction);
      const double exact = (stiffness_matrix(model, x, Tangent::exact) * flat(direction) - there).norm();
      const double rotated = (stiffness_matrix(model, x, Tangent::rotated) * flat(direction) - there).norm();
      // Differences of 1e-6 m carry about 1e-8 of truncation and of round-off.
      QVERIFY2(exact < 1e-6 * there.norm(), qPrintable(QString::number(exact / there.norm())));
      QVERIFY(rotated > exact);
    }
  }

  void WhatIsFactorisedIsPositive() {
    TetMesh mesh = block_mesh({3, 3, 2}, {0.03, 0.03, 0.02});
    shake(mesh, 0.0015, 3);
    const CompositeModel model(mesh, {straight_vessel({0.003, 0.014, 0.01}, {0.027, 0.017, 0.01}, 4, 0.003)},
                               {});
    Loads loads;
    loads.pressure = 2000.0;
    const Points x = bent(mesh.vertices) + noise(model.node_count(), 0.003, 6);
    for (const Tangent kind : {Tangent::rotated, Tangent::projected}) {
      const Eigen::MatrixXd k = Eigen::MatrixXd(stiffness_matrix(model, x, kind)) +
                                Eigen::MatrixXd(load_stiffness_matrix(model, loads, x, kind));
      QVERIFY((k - k.transpose()).norm() < 1e-14 * k.norm());
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k);
      QVERIFY(eigen.eigenvalues()[0] > -1e-12 * eigen.eigenvalues().tail<1>()[0]);
    }
  }

  void PressureFollowsTheSurface() {
    const TetMesh mesh = ellipsoid_mesh(6);
    const CompositeModel model(mesh, {}, homogeneous());
    Loads loads;
    loads.pressure = 1000.0;
    // On a closed surface the force is minus the derivative of p V, and sums to nothing.
    const Points x = bent(mesh.vertices);
    const Points force = external_force(model, loads, x);
    QVERIFY(force.colwise().sum().norm() < 1e-12);
    const Points direction = noise(x.rows(), 1.0, 3);
    const auto volume_at = [&](double h) {
      TetMesh moved = mesh;
      moved.vertices = x + h * direction;
      return volume(moved);
    };
    const double h = 1e-6;
    const double work = 1000.0 * (volume_at(h) - volume_at(-h)) / (2.0 * h);
    QVERIFY(std::abs(-(force.array() * direction.array()).sum() / work - 1.0) < 1e-6);
    // There the derivative is symmetric, and the exact tangent is all of it.
    const Eigen::VectorXd numeric =
        numeric_product([&](const Points& y) { return external_force(model, loads, y); }, x, direction);
    const Eigen::VectorXd product = load_stiffness_matrix(model, loads, x, Tangent::exact) * flat(direction);
    QVERIFY((product - numeric).norm() < 1e-7 * numeric.norm());
  }

  void SpringPullsBackByItsStiffness() {
    const TetMesh mesh = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    const CompositeModel model(mesh, {}, homogeneous());
    Loads loads;
    AttachedLoad spring;
    spring.nodes = {mesh.tetrahedra(0, 0), mesh.tetrahedra(0, 1), mesh.tetrahedra(0, 2), -1};
    spring.weights = {0.2, 0.3, 0.5, 0.0};
    spring.force = {1.0, 2.0, 3.0};
    spring.tangent = 40.0 * Eigen::Matrix3d::Identity();
    loads.attached.push_back(spring);
    const Points force = external_force(model, loads, mesh.vertices);
    QVERIFY((force.colwise().sum() - Eigen::RowVector3d(1, 2, 3)).norm() < 1e-12);
    const Points shift = Eigen::RowVector3d(0.0, 0.0, 1.0).replicate(mesh.vertex_count(), 1);
    const Eigen::VectorXd product =
        load_stiffness_matrix(model, loads, mesh.vertices, Tangent::rotated) * flat(shift);
    QVERIFY(std::abs(product.sum() - 40.0) < 1e-12);
  }

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

  void PrescribedNodesThatAreFreeAreRefused() {
    const TetMesh mesh = block_mesh({6, 2, 2}, {0.06, 0.02, 0.02});
    const auto model = std::make_shared<CompositeModel>(mesh, std::vector<VesselTree>{}, CompositeOptions{});
    IntegratorOptions options;
    options.fixed_nodes = nodes_at(mesh, 0, 0.0);
    Integrator first(model, options);
    const std::vector<int>& led = options.fixed_nodes;
    // A free node cannot be prescribed, and what is refused changes nothing.
    Loads wrong;
    wrong.prescribed.push_back({led[0], mesh.vertex(led[0]) + Eigen::Vector3d(0.001, 0.0, 0.0)});
    wrong.prescribed.push_back({20, mesh.vertex(20)});
    const Points before = first.positions();
    QVERIFY_EXCEPTION_THROWN(first.step(wrong), InputError);
    QVERIFY((first.positions().array() == before.array()).all());
    wrong.prescribed = {{-1, Eigen::Vector3d::Zero()}};
    QVERIFY_EXCEPTION_THROWN(first.step(wrong), InputError);
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

  void UnusableMeshesAreNamed() {
    const TetMesh good = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    const auto refused = [&](const TetMesh& mesh) {
      try {
        CompositeModel(mesh, {}, {});
      } catch (const InputError& error) {
        return QString::fromStdString(error.field());
      }
      return QString();
    };
    QCOMPARE(refused(good), QString());
    TetMesh mesh = good;
    std::swap(mesh.tetrahedra(7, 0), mesh.tetrahedra(7, 1));
    QVERIFY(refused(mesh).contains("7"));
    mesh = good;
    mesh.tetrahedra.row(9) = mesh.tetrahedra.row(4);
    QVERIFY(refused(mesh).contains("9"));
    mesh = good;
    mesh.tetrahedra.conservativeResize(mesh.tetrahedron_count() + 1, 4);
    mesh.vertices.conservativeResize(mesh.vertex_count() + 1, 3);
    // A sliver: its fourth node in the plane of the others.
    const int last = mesh.vertex_count() - 1;
    mesh.vertices.row(last) = (mesh.vertices.row(0) + mesh.vertices.row(1) + mesh.vertices.row(3)) / 3.0;
    mesh.tetrahedra.bottomRows<1>() << 0, 1, 3, last;
    QVERIFY(refused(mesh).contains(QString::number(mesh.tetrahedron_count() - 1)));
    mesh = good;
    mesh.vertices.conservativeResize(mesh.vertex_count() + 1, 3);
    mesh.vertices.bottomRows<1>().setConstant(0.5);
    QVERIFY(refused(mesh).contains(QString::number(good.vertex_count())));
    mesh = good;
    mesh.labels = {1, 2};
    QCOMPARE(refused(mesh), QString("labels"));
    QCOMPARE(refused(TetMesh{}), QString("tetrahedra"));
  }

  void UnusableOptionsAreNamed() {
    const auto refused = [](const std::function<void(CompositeOptions&)>& change) {
      CompositeOptions options;
      change(options);
      try {
        options.validate();
      } catch (const InputError& error) {
        return QString::fromStdString(error.field());
      }
      return QString();
    };
    QCOMPARE(refused([](CompositeOptions&) {}), QString());
    QCOMPARE(refused([](CompositeOptions& o) { o.parenchyma.young_modulus = 0.0; }),
             QString("young_modulus"));
    QCOMPARE(refused([](CompositeOptions& o) { o.capsule.poisson_ratio = 0.5; }), QString("poisson_ratio"));
    QCOMPARE(refused([](CompositeOptions& o) { o.by_label[16] = {-1.0, 0.3}; }), QString("young_modulus"));
    QCOMPARE(refused([](CompositeOptions& o) { o.capsule_thickness = 0.0; }), QString("capsule_thickness"));
    QCOMPARE(refused([](CompositeOptions& o) { o.wall_fraction = 1.5; }), QString("wall_fraction"));
    QCOMPARE(refused([](CompositeOptions& o) { o.density = std::nan(""); }), QString("density"));
    QCOMPARE(refused([](CompositeOptions& o) { o.rayleigh_mass = -1.0; }), QString("rayleigh_mass"));
    QCOMPARE(refused([](CompositeOptions& o) { o.rayleigh_stiffness = -1.0; }),
             QString("rayleigh_stiffness"));
    IntegratorOptions step;
    step.time_step = 0.0;
    QVERIFY_EXCEPTION_THROWN(step.validate(), InputError);
  }

  void UnusableVesselsAreNamed() {
    const TetMesh mesh = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    const VesselTree good = straight_vessel({0.001, 0.01, 0.01}, {0.019, 0.01, 0.01}, 3, 0.001);
    const auto refused = [&](const std::function<void(VesselTree&)>& change) {
      VesselTree tree = good;
      change(tree);
      try {
        CompositeModel(mesh, {tree}, {});
      } catch (const InputError& error) {
        return QString::fromStdString(error.field());
      }
      return QString();
    };
    QCOMPARE(refused([](VesselTree&) {}), QString());
    QCOMPARE(refused([](VesselTree& t) { t.radii[1] = 0.0; }), QString("radius 1"));
    QCOMPARE(refused([](VesselTree& t) { t.radii.pop_back(); }), QString("radii"));
    QCOMPARE(refused([](VesselTree& t) { t.beams[2] = {0, 99}; }), QString("beam 2"));
    QCOMPARE(refused([](VesselTree& t) { t.nodes(0, 0) = std::nan(""); }), QString("nodes"));
  }

  void VesselsOutsideAreCountedAndFarPiecesDropped() {
    const TetMesh mesh = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    // Nodes at -10, -5, 0, 5, 10, 15, 20, 25 mm; outside by 10, 5 and 5.
    const VesselTree vessel = straight_vessel({-0.01, 0.0101, 0.0103}, {0.025, 0.0101, 0.0103}, 7, 0.001);
    const CompositeModel model(mesh, {vessel}, {});
    QCOMPARE(model.vessel_nodes_outside(), 3);
    // -10 to -5 lies outside; -5 to 0 and 20 to 25 shrink to a point on the surface once clamped.
    QCOMPARE(model.vessel_beams_dropped(), 3);
    QCOMPARE(model.beam_count(), 4);
    QVERIFY(model.internal_force(mesh.vertices).cwiseAbs().maxCoeff() < 1e-12);
  }

  void LoadsThatDoNotFitAreRefused() {
    const TetMesh mesh = block_mesh({3, 3, 3}, {0.03, 0.03, 0.03});
    const auto model = std::make_shared<CompositeModel>(mesh, std::vector<VesselTree>{}, CompositeOptions{});
    Integrator integrator(model, {});
    Loads loads;
    AttachedLoad far;  // opposite corners share no element
    far.nodes = {0, mesh.vertex_count() - 1, -1, -1};
    far.weights = {0.5, 0.5, 0.0, 0.0};
    far.tangent = Eigen::Matrix3d::Identity();
    loads.attached = {far};
    QVERIFY_EXCEPTION_THROWN(integrator.step(loads), PreconditionError);
    loads.attached[0].nodes = {0, 1000, -1, -1};
    QVERIFY_EXCEPTION_THROWN(integrator.step(loads), InputError);
    loads.attached.clear();
    loads.pressure = std::nan("");
    QVERIFY_EXCEPTION_THROWN(integrator.step(loads), InputError);
    loads.pressure = 1.0;
    loads.pressure_triangles = {100000};
    QVERIFY_EXCEPTION_THROWN(integrator.step(loads), InputError);
    IntegratorOptions options;
    options.fixed_nodes = {1000};
    QVERIFY_EXCEPTION_THROWN(Integrator(model, options), InputError);
    options.fixed_nodes.resize(static_cast<std::size_t>(mesh.vertex_count()));
    std::iota(options.fixed_nodes.begin(), options.fixed_nodes.end(), 0);
    QVERIFY_EXCEPTION_THROWN(Integrator(model, options), InputError);
    QVERIFY_EXCEPTION_THROWN(integrator.set_state(Points::Zero(3, 3)), PreconditionError);
  }

  void LiverUnderPressureAndGravityReachesEquilibrium() {
    // What the theatre asks: the neo-Hookean law, 20 mm and more, at about 2,000 tetrahedra here.
    CompositeOptions options = homogeneous();
    options.law = TetrahedronLaw::neo_hookean;
    const TetMesh mesh = ellipsoid_mesh(12);
    const CompositeModel model(mesh, {}, options);
    Loads loads;
    loads.gravity_change = {2.0, -3.0, 0.0};
    loads.pressure = 300.0;
    const Points normals = triangle_normals(model.surface().mesh);
    for (int t = 0; t < normals.rows(); ++t)
      if (normals(t, 2) > 0.5) loads.pressure_triangles.push_back(t);
    StaticOptions held;
    for (int i = 0; i < mesh.vertex_count(); ++i)
      if ((mesh.vertex(i) - Eigen::Vector3d(0.03, 0.075, 0.05)).norm() < 0.03) held.fixed_nodes.push_back(i);
    const auto solution = solve_static(
        model, mesh.vertices, [&](const Points&) { return loads; }, held, RunContext());
    QVERIFY(solution && solution->converged);
    Points left =
        model.internal_force(solution->positions) + external_force(model, loads, solution->positions);
    for (const int node : held.fixed_nodes) left.row(node).setZero();
    QVERIFY(left.norm() < 1e-6 * external_force(model, loads, solution->positions).norm());
    const Eigen::VectorXd moved = (solution->positions - mesh.vertices).rowwise().norm();
    qInfo("%d iterations, mean %.1f mm, largest %.1f mm", solution->iterations, 1e3 * moved.mean(),
          1e3 * moved.maxCoeff());
    QVERIFY(moved.mean() > 0.02);
    // Pressure on a part has no potential: with the symmetric part of its tangent alone this took 141
    // iterations, with all of it Newton converges quadratically at the end.
    QVERIFY(solution->iterations <= 30);
  }
};

QTEST_APPLESS_MAIN(ModelTest)
#include "model_test.moc"
