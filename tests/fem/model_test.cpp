// SPDX-License-Identifier: GPL-3.0-or-later
// The composite at rest and in equilibrium: forces, energies and tangents.
#include <Eigen/Eigenvalues>
#include <QTest>

#include "beam.h"
#include "block_mesh.h"
#include "ellipsoid_mesh.h"
#include "glisson/fem/integrator.h"
#include "stiffness.h"

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
    QCOMPARE(bound_vessels(mesh, {vessel}).nodes_outside, 0);
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
    QVERIFY(solution && solution->converged());
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

  void VesselsOutsideAreCountedAndFarPiecesDropped() {
    const TetMesh mesh = block_mesh({2, 2, 2}, {0.02, 0.02, 0.02});
    // Nodes at -10, -5, 0, 5, 10, 15, 20, 25 mm; outside by 10, 5 and 5.
    const VesselTree vessel = straight_vessel({-0.01, 0.0101, 0.0103}, {0.025, 0.0101, 0.0103}, 7, 0.001);
    const CompositeModel model(mesh, {vessel}, {});
    const BoundVessels bound = bound_vessels(mesh, {vessel});
    QCOMPARE(bound.nodes_outside, 3);
    // -10 to -5 lies outside; -5 to 0 and 20 to 25 shrink to a point on the surface once clamped.
    QCOMPARE(bound.beams_dropped, 3);
    QCOMPARE(bound.beams, 4);
    QCOMPARE(model.beam_count(), 4);
    QVERIFY(model.internal_force(mesh.vertices).cwiseAbs().maxCoeff() < 1e-12);
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
    QVERIFY(solution && solution->converged());
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
