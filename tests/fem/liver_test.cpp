// SPDX-License-Identifier: GPL-3.0-or-later
// The same properties on a liver that we did not make: 3046 nodes, 10703 tetrahedra (elastic_sequence), with
// capsule and vessels of our own through it.
#include <QTest>
#include <filesystem>
#include <memory>

#include "block_mesh.h"
#include "data_folder.h"
#include "glisson/fem/integrator.h"
#include "glisson/geometry/mesh_io.h"
#include "stiffness.h"

using namespace glisson;
using namespace glisson::fem;
using namespace glisson::fem_test;

namespace {

std::filesystem::path mesh_path() { return test::data_folder() / "elastic_sequence" / "rest.vtk"; }

double volume_of(const TetMesh& mesh) { return tetrahedron_volumes(mesh).sum(); }

/// Vessels from the organ's middle towards nodes deep inside it.
std::vector<VesselTree> vessels_in(const TetMesh& mesh) {
  const Eigen::Vector3d middle = mesh.vertices.colwise().mean().transpose();
  std::vector<VesselTree> trees;
  for (int k = 0; k < 6; ++k) {
    const Eigen::Vector3d to = mesh.vertex(k * mesh.vertex_count() / 6);
    trees.push_back(straight_vessel(middle, middle + 0.6 * (to - middle), 8, 0.003));
  }
  return trees;
}

std::vector<int> held_nodes(const TetMesh& mesh) {
  const Eigen::Vector3d low = mesh.vertices.colwise().minCoeff().transpose();
  std::vector<int> nodes;
  for (int i = 0; i < mesh.vertex_count(); ++i)
    if (mesh.vertex(i).x() < low.x() + 0.02) nodes.push_back(i);
  return nodes;
}

/// Bent by 40 degrees from end to end, stretched, and shaken; no element turns inside out.
Points moved_smoothly(const Points& rest) {
  const Eigen::RowVector3d middle = rest.colwise().mean();
  Points x = rest.rowwise() - middle;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const Eigen::RowVector3d p = x.row(i);
    const double angle = 3.0 * p.x();
    x.row(i) << 1.1 * p.x() - p.y() * std::sin(angle), p.y() * std::cos(angle), 0.95 * p.z() + 0.2 * p.x();
  }
  return x + noise(rest.rows(), 0.0001, 2);
}

}  // namespace

class LiverTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    if (!std::filesystem::exists(mesh_path())) QSKIP("elastic_sequence is not here (set GLISSON_DATA)");
    mesh_ = read_tet_mesh(mesh_path(), LengthUnit::millimetre);
    model_ = std::make_shared<CompositeModel>(mesh_, vessels_in(mesh_), CompositeOptions{});
    QVERIFY(model_->beam_count() > 30);
  }

  void ForceIsDerivativeOfEnergyAndTangentOfForce() {
    for (const TetrahedronLaw law : {TetrahedronLaw::corotational, TetrahedronLaw::neo_hookean}) {
      CompositeOptions options;
      options.law = law;
      const CompositeModel model(mesh_, vessels_in(mesh_), options);
      const Points x = moved_smoothly(mesh_.vertices), force = model.internal_force(x);
      for (unsigned seed = 0; seed < 3; ++seed) {
        const Points d = noise(x.rows(), 1.0, seed);
        // Along a direction: central differences of 1e-6 m carry 1e-7 of truncation and round-off.
        const double h = 1e-6;
        const double slope = (model.energy(x + h * d) - model.energy(x - h * d)) / (2.0 * h);
        const double work = -force.cwiseProduct(d).sum();
        QVERIFY2(std::abs(slope - work) < 1e-5 * force.norm() * d.norm(),
                 qPrintable(QString("%1 against %2").arg(slope).arg(work)));
        const Points numeric =
            (model.internal_force(x - h * d) - model.internal_force(x + h * d)) / (2.0 * h);
        const Eigen::VectorXd product = stiffness_matrix(model, x, Tangent::exact) *
                                        Eigen::Map<const Eigen::VectorXd>(d.data(), d.size());
        const double wrong =
            (product - Eigen::Map<const Eigen::VectorXd>(numeric.data(), numeric.size())).norm();
        QVERIFY2(wrong < 1e-5 * product.norm(), qPrintable(QString::number(wrong / product.norm())));
      }
    }
  }

  void RigidMotionLeavesNoForce() {
    const double scale = model_->internal_force(moved_smoothly(mesh_.vertices)).cwiseAbs().maxCoeff();
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Points x =
          (mesh_.vertices * random_rotation(seed).transpose()).rowwise() + Eigen::RowVector3d(0.3, -0.2, 0.1);
      QVERIFY(model_->internal_force(x).cwiseAbs().maxCoeff() < 1e-10 * scale);
    }
  }

  void SolversAgreeAndRepeat() {
    Loads loads;
    loads.gravity_change = {9.81, -9.81, 0.0};  // supine to the left flank
    Points ends[4];
    const LinearSolver solvers[4] = {LinearSolver::direct, LinearSolver::direct, LinearSolver::fast,
                                     LinearSolver::reference};
    for (int run = 0; run < 4; ++run) {
      IntegratorOptions options;
      options.solver = solvers[run];
      options.tolerance = 1e-8;
      options.fixed_nodes = held_nodes(mesh_);
      Integrator integrator(model_, options);
      for (int n = 0; n < 10; ++n) {
        const StepSummary step = integrator.step(loads);
        QVERIFY(step.ok);
        QVERIFY(step.residual < 1.1e-8);
      }
      ends[run] = integrator.positions();
    }
    QVERIFY((ends[0].array() == ends[1].array()).all());
    const double moved = (ends[0] - mesh_.vertices).rowwise().norm().maxCoeff();
    QVERIFY(moved > 0.005);
    QVERIFY((ends[2] - ends[0]).rowwise().norm().maxCoeff() < 1e-5 * moved);
    QVERIFY((ends[3] - ends[0]).rowwise().norm().maxCoeff() < 1e-9 * moved);
  }

  void TurningToTheFlankReachesEquilibrium() {
    Loads loads;
    loads.gravity_change = {9.81, -9.81, 0.0};
    StaticOptions held;
    held.fixed_nodes = held_nodes(mesh_);
    const auto solution = solve_static(
        *model_, mesh_.vertices, [&](const Points&) { return loads; }, held, RunContext());
    QVERIFY(solution && solution->converged());
    const Eigen::VectorXd moved = (solution->positions - mesh_.vertices).rowwise().norm();
    TetMesh there = mesh_;
    there.vertices = solution->positions;
    qInfo("real liver, in-silico load: %d iterations, residual %.1e, mean %.1f mm, largest %.1f mm",
          solution->iterations, solution->residual, 1e3 * moved.mean(), 1e3 * moved.maxCoeff());
    // Nearly incompressible, and what moves is the far end.
    QVERIFY(std::abs(volume_of(there) / volume_of(mesh_) - 1.0) < 0.1);
    QVERIFY(moved.maxCoeff() > 2.0 * moved.mean());
  }

 private:
  TetMesh mesh_;
  std::shared_ptr<const CompositeModel> model_;
};

QTEST_APPLESS_MAIN(LiverTest)
#include "liver_test.moc"
