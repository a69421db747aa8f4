// SPDX-License-Identifier: GPL-3.0-or-later
// The model against answers that were found without it.
#include <QTest>
#include <cmath>
#include <memory>
#include <numbers>

#include "beam.h"
#include "block_mesh.h"
#include "ellipsoid_mesh.h"
#include "glisson/fem/integrator.h"
#include "membrane.h"
#include "stiffness.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

CompositeOptions homogeneous(const Material& material) {
  CompositeOptions options;
  options.with_capsule = options.with_vessels = false;
  options.parenchyma = material;
  return options;
}

/// A thin tube of membranes along z: radius 10 mm, length 100 mm, wall 0.1 mm.
struct Tube {
  static constexpr double kRadius = 0.01, kLength = 0.1, kWall = 1e-4;
  Points rest;
  std::vector<Membrane> membranes;

  Tube(int around, const Material& material) {
    const int along = 2 * around;
    rest.resize(around * (along + 1), 3);
    for (int z = 0; z <= along; ++z)
      for (int a = 0; a < around; ++a) {
        const double angle = 2.0 * std::numbers::pi * a / around;
        rest.row(z * around + a) << kRadius * std::cos(angle), kRadius * std::sin(angle), kLength * z / along;
      }
    for (int z = 0; z < along; ++z)
      for (int a = 0; a < around; ++a) {
        const int p = z * around + a, q = z * around + (a + 1) % around;
        add({p, q, q + around}, material);
        add({p, q + around, p + around}, material);
      }
  }
  void add(const std::array<int, 3>& nodes, const Material& material) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = rest.row(nodes[static_cast<std::size_t>(k)]).transpose();
    membranes.emplace_back(nodes, corners, material, kWall);
  }
  double energy(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& displacement) const {
    Points x = rest;
    for (Eigen::Index i = 0; i < x.rows(); ++i) x.row(i) += displacement(rest.row(i)).transpose();
    double sum = 0.0;
    for (const Membrane& e : membranes) sum += e.volume * energy_density(e, e.deformation_gradient(x));
    return sum;
  }
};

/// Longitudinal vibration of a bar that is held at x = 0: u = sin(k x), k = pi / (2 L).
struct Vibration {
  double rayleigh, exact, kh;

  explicit Vibration(MassMatrix mass) {
    constexpr double kLength = 0.1;
    const TetMesh mesh = block_mesh({8, 2, 2}, {kLength, 0.02, 0.02});
    CompositeOptions options = homogeneous({3500.0, 0.0});
    options.mass = mass;
    const CompositeModel model(mesh, {}, options);
    const double k = std::numbers::pi / (2.0 * kLength);
    Points u = Points::Zero(model.node_count(), 3);
    for (int i = 0; i < model.node_count(); ++i) u(i, 0) = std::sin(k * mesh.vertices(i, 0));
    const Eigen::Map<const Eigen::VectorXd> flat(u.data(), u.size());
    const double stiff = flat.dot(stiffness_matrix(model, mesh.vertices, Tangent::rotated) * flat);
    rayleigh = stiff / model.mass_times(u).cwiseProduct(u).sum();
    exact = k * k * 3500.0 / options.density;
    kh = k * kLength / 8;
  }
};

}  // namespace

class ClosedFormsTest : public QObject {
  Q_OBJECT
 private slots:
  void MembraneTubeFollowsBredtAndTheBendingOfBeams_data() {
    QTest::addColumn<bool>("torsion");
    QTest::newRow("torsion") << true;
    QTest::newRow("bending") << false;
  }
  void MembraneTubeFollowsBredtAndTheBendingOfBeams() {
    QFETCH(bool, torsion);
    const Material wall{620e3, 0.4};
    const double r = Tube::kRadius, l = Tube::kLength, small = 1e-4;
    // Bredt: J = 2 pi r^3 h. Bending: I = pi r^3 h; the cross-section narrows by Poisson's ratio.
    const double expected =
        torsion ? 0.5 * 620e3 / 2.8 * 2.0 * std::numbers::pi * r * r * r * Tube::kWall * small * small / l
                : 0.5 * 620e3 * std::numbers::pi * r * r * r * Tube::kWall * small * small / l;
    const auto twist = [&](const Eigen::Vector3d& p) {
      const double angle = small * p.z() / l;
      return Eigen::Vector3d(-angle * p.y(), angle * p.x(), 0.0);
    };
    const auto bend = [&](const Eigen::Vector3d& p) {
      const double c = small / l;
      return Eigen::Vector3d(-0.4 * c * p.x() * p.y(),
                             -0.5 * c * (p.z() * p.z() + 0.4 * (p.y() * p.y() - p.x() * p.x())),
                             c * p.y() * p.z());
    };
    std::vector<double> errors;
    for (const int around : {12, 24, 48}) {
      const Tube tube(around, wall);
      errors.push_back(std::abs((torsion ? tube.energy(twist) : tube.energy(bend)) / expected - 1.0));
    }
    QVERIFY2(errors[2] < 0.015, qPrintable(QString::number(errors[2])));
    QVERIFY(errors[0] / errors[1] > 3.5 && errors[1] / errors[2] > 3.5);  // second order
    // And the beam of that section agrees with the tube: a wall of a hundredth of the radius.
    const BeamSection section = BeamSection::hollow(r + 0.5 * Tube::kWall, Tube::kWall, wall);
    const double stiffness = torsion ? section.torsion : section.bending;
    QVERIFY(std::abs(0.5 * stiffness * small * small / l / expected - 1.0) < 1e-4);
  }

  void HangingBlockConvergesWithSecondOrder() {
    // A bar that hangs under its own weight (Timoshenko and Goodier, par. 86), z from its top down, nu = 0.3:
    // w = rho g / E (z L - z^2/2 - nu (x^2 + y^2) / 2), u = -nu rho g / E (L - z) x, likewise v; the whole
    // surface of the top and the free one are as in the exact solution, nothing else is prescribed.
    constexpr double kE = 3500.0, kNu = 0.3, kLength = 0.04, kWidth = 0.02, kG = 1e-3;
    const double c = 1060.0 * kG / kE;
    const auto exact = [&](const Eigen::Vector3d& p) {
      const double x = p.x() - 0.5 * kWidth, y = p.y() - 0.5 * kWidth, z = p.z();
      return Eigen::Vector3d(-kNu * c * (kLength - z) * x, -kNu * c * (kLength - z) * y,
                             c * (z * kLength - 0.5 * z * z - 0.5 * kNu * (x * x + y * y)));
    };
    std::vector<double> displacement, stress;
    for (const int across : {2, 4, 8, 12}) {
      const TetMesh mesh = block_mesh({across, across, 2 * across}, {kWidth, kWidth, kLength});
      const CompositeModel model(mesh, {}, homogeneous({kE, kNu}));
      StaticOptions held;
      held.fixed_nodes = nodes_at(mesh, 2, 0.0);
      held.tolerance = 1e-7;
      Points start = mesh.vertices;
      for (const int node : held.fixed_nodes) start.row(node) += exact(mesh.vertex(node)).transpose();
      Loads loads;
      loads.gravity_change = {0.0, 0.0, kG};
      const auto solution = solve_static(
          model, start, [&](const Points&) { return loads; }, held, RunContext());
      QVERIFY(solution && solution->converged());
      double wrong = 0.0, size = 0.0;
      for (int i = 0; i < mesh.vertex_count(); ++i) {
        const Eigen::Vector3d u = exact(mesh.vertex(i));
        const Eigen::Vector3d found = (solution->positions.row(i) - mesh.vertices.row(i)).transpose();
        wrong += model.lumped_mass()[i] * (found - u).squaredNorm();
        size += model.lumped_mass()[i] * u.squaredNorm();
      }
      displacement.push_back(std::sqrt(wrong / size));
      // Uniaxial: von Mises is rho g (L - z), taken in the elements' middles.
      const Eigen::VectorXd mises = model.von_mises(solution->positions);
      const Eigen::VectorXd volumes = tetrahedron_volumes(mesh);
      double wrong_stress = 0.0, stress_size = 0.0;
      for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
        double z = 0.0;
        for (int k = 0; k < 4; ++k) z += 0.25 * mesh.vertex(mesh.tetrahedra(t, k)).z();
        const double expected = 1060.0 * kG * (kLength - z);
        wrong_stress += volumes[t] * (mises[t] - expected) * (mises[t] - expected);
        stress_size += volumes[t] * expected * expected;
      }
      stress.push_back(std::sqrt(wrong_stress / stress_size));
    }
    const auto order = [](const std::vector<double>& e) { return std::log(e[2] / e[3]) / std::log(1.5); };
    qInfo(
        "hanging block, 2 4 8 12 cells across: displacement wrong by %.3f %.3f %.3f %.3f %% (order %.2f), "
        "stress by %.1f %.1f %.1f %.1f %% (order %.2f)",
        100 * displacement[0], 100 * displacement[1], 100 * displacement[2], 100 * displacement[3],
        order(displacement), 100 * stress[0], 100 * stress[1], 100 * stress[2], 100 * stress[3],
        order(stress));
    // Linear elements: second order in displacements, first in stresses. Strains of 1e-5 keep the turn's
    // non-linearity far below.
    QVERIFY(order(displacement) > 1.8);
    QVERIFY(order(stress) > 0.9);
    QVERIFY(displacement[3] < 0.02);
  }

  void MassMatricesVibrateAsTheBooksSay() {
    // Linear elements of length h: (w_h / w)^2 = 6 (1 - cos kh) / ((kh)^2 (2 + cos kh)) with the consistent
    // mass, above the exact frequency, and 2 (1 - cos kh) / (kh)^2 with the lumped one, below.
    const Vibration consistent(MassMatrix::consistent), lumped(MassMatrix::lumped);
    const double kh = consistent.kh, c = std::cos(kh);
    QVERIFY(std::abs(consistent.rayleigh / consistent.exact / (6.0 * (1.0 - c) / (kh * kh * (2.0 + c))) -
                     1.0) < 1e-10);
    QVERIFY(consistent.rayleigh > consistent.exact);
    QVERIFY(std::abs(lumped.rayleigh / lumped.exact / (2.0 * (1.0 - c) / (kh * kh)) - 1.0) < 1e-10);
    QVERIFY(lumped.rayleigh < lumped.exact);
  }

  void ConsistentMassCarriesMomentumAndEnergy() {
    CompositeOptions options;
    options.mass = MassMatrix::consistent;
    options.rayleigh_mass = 0.0;
    const auto model = std::make_shared<CompositeModel>(ellipsoid_mesh(6), ellipsoid_vessels(20), options);
    const Points& rest = model->mesh().vertices;
    // All move alike: the momentum is the mass's.
    const Points ones = Points::Ones(model->node_count(), 3);
    QVERIFY((model->mass_times(ones).col(1) - model->lumped_mass()).norm() < 1e-14);
    for (const LinearSolver solver : {LinearSolver::direct, LinearSolver::fast}) {
      IntegratorOptions integration;
      integration.solver = solver;
      integration.tolerance = 1e-11;
      Integrator integrator(model, integration);
      const Points velocities = noise(model->node_count(), 0.5, 3);
      integrator.set_state(rest, velocities);
      const Eigen::RowVector3d before = model->mass_times(velocities).colwise().sum();
      StepSummary step;
      for (int n = 0; n < 20; ++n) {
        step = integrator.step({});
        QVERIFY(step.ok);
      }
      const Eigen::RowVector3d after = model->mass_times(integrator.velocities()).colwise().sum();
      QVERIFY((after - before).norm() < 1e-9 * (model->lumped_mass().sum() * 0.5));
      const double kinetic =
          0.5 * model->mass_times(integrator.velocities()).cwiseProduct(integrator.velocities()).sum();
      QVERIFY(std::abs(kinetic - step.kinetic_energy) < 1e-12 * kinetic);
    }
    // Free fall of all nodes alike, whatever the mass matrix.
    Integrator integrator(model, {});
    Loads loads;
    loads.gravity_change = {0.0, 0.0, -9.81};
    QVERIFY(integrator.step(loads).ok);
    QVERIFY((integrator.velocities().rowwise() - Eigen::RowVector3d(0.0, 0.0, -9.81 * 0.02))
                .cwiseAbs()
                .maxCoeff() < 1e-9);
  }

  void CantileverOfTetrahedraConvergesToTimoshenko_data() {
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("allowed");
    // The limit of refinement, by Richardson's extrapolation. Thick: what the clamp's warping adds to the
    // closed form counts; thin: what is left of the coarse meshes' locking.
    QTest::newRow("thick, 2.5 : 1") << 0.05 << 0.03;
    QTest::newRow("thin, 8 : 1") << 0.16 << 0.03;
  }
  void CantileverOfTetrahedraConvergesToTimoshenko() {
    QFETCH(double, length);
    QFETCH(double, allowed);
    // 20 x 20 mm, nu = 0.3, clamped at one end, a small pull down on the other: tip deflection
    // F L^3 / (3 E I) + F L / (kappa G A), kappa = 10 (1 + nu) / (12 + 11 nu). Linear tetrahedra are too
    // stiff and get better as they get smaller.
    const double e = 3500.0, nu = 0.3, l = length, a = 0.02, pull = 1e-5;
    const double inertia = std::pow(a, 4) / 12.0, kappa = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    const double beam =
        pull * l * l * l / (3.0 * e * inertia) + pull * l / (kappa * e / (2.0 * (1.0 + nu)) * a * a);
    std::vector<double> tips;
    for (const int across : {3, 6, 12}) {
      const TetMesh mesh =
          block_mesh({static_cast<int>(std::lround(across * l / a)), across, across}, {l, a, a});
      const CompositeModel model(mesh, {}, homogeneous({e, nu}));
      StaticOptions held;
      held.fixed_nodes = nodes_at(mesh, 0, 0.0);
      held.tolerance = 1e-6;
      const std::vector<int> end = nodes_at(mesh, 0, l);
      Loads loads;
      for (const int node : end) {
        AttachedLoad load;
        load.nodes[0] = node;
        load.weights[0] = 1.0;
        load.force = {0.0, 0.0, -pull / static_cast<double>(end.size())};
        loads.attached.push_back(load);
      }
      const auto solution = solve_static(
          model, mesh.vertices, [&](const Points&) { return loads; }, held, RunContext());
      QVERIFY(solution && solution->converged());
      double tip = 0.0;
      for (const int node : end)
        tip += (mesh.vertices(node, 2) - solution->positions(node, 2)) / static_cast<double>(end.size());
      tips.push_back(tip / beam);
    }
    QVERIFY(tips[0] < tips[1] && tips[1] < tips[2] && tips[2] < 1.0 + allowed);
    // The refinement's own order, and its limit.
    const double ratio = (tips[1] - tips[0]) / (tips[2] - tips[1]);
    const double limit = tips[2] + (tips[2] - tips[1]) / 3.0;
    qInfo("cantilever: %.1f, %.1f, %.1f %% of Timoshenko's deflection, order %.2f, limit %.1f %%",
          100 * tips[0], 100 * tips[1], 100 * tips[2], std::log2(ratio), 100 * limit);
    QVERIFY(std::log2(ratio) > 0.7);
    QVERIFY(std::abs(limit - 1.0) < allowed);
  }
};

QTEST_APPLESS_MAIN(ClosedFormsTest)
#include "closed_forms_test.moc"
