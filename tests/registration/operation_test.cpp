// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <QTest>
#include <numbers>
#include <random>

#include "elastic.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/pairs.h"
#include "lying_phantom.h"
#include "shape_fits.h"

using namespace glisson;
using namespace glisson::registration;
using phantom::lying;
using phantom::simulated;

class OperationTest : public QObject {
  Q_OBJECT
 private slots:
  void ModesHoldNoRigidMotion();
  void SameSeedGivesTheSameBits();
  void OtherOperationsLieInTheModes();
  void AmplitudesAreStandardDeviations();
  void UnforeseenForcesMoveByWhatIsAsked();
  void ShapeAndPoseAreFoundTogether();
  void AFitThatIsFarBehindEndsEarlyAndTheBestIsTheSame();
  void AFaceSeenFromBehindSpeaksAgainstAShape();
  void RegistrationWithThePriorIsTheBetterOne();
  void FineSurfaceIsCarriedByItsTetrahedra();
  void UnfitFineSurfaceIsNotUsed();
  void CancelIsObeyed();
  void UnusableInputIsRefused();

 private:
  PatientModel model_ = lying(7, 6, 3);
};

void OperationTest::ModesHoldNoRigidMotion() {
  const OperationPrior prior = simulated(model_, 60, 1);
  const Points& rest = model_.mesh.vertices;
  for (Eigen::Index k = 0; k < 5; ++k) {
    // Small, so that what the alignment of a large deformation leaves in second order does not show.
    const Points moved = prior.shape(rest, 0.01 * Eigen::VectorXd::Unit(prior.modes.cols(), k));
    const double motion = (moved - rest).rowwise().norm().mean();
    const Points rigid = fit_rigid<CtFrame, CtFrame>(rest, moved).apply(rest);
    QVERIFY((rigid - rest).rowwise().norm().mean() < 0.1 * motion);
  }
}

void OperationTest::SameSeedGivesTheSameBits() {
  const OperationPrior one = simulated(model_, 50, 7), again = simulated(model_, 50, 7);
  QVERIFY(one.modes == again.modes);
  QVERIFY(one.modes != simulated(model_, 50, 8).modes);
}

void OperationTest::OtherOperationsLieInTheModes() {
  const OperationPrior known = simulated(model_, 100, 1), others = simulated(model_, 60, 2);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(known.modes.leftCols(40));
  const Eigen::MatrixXd span = qr.householderQ() * Eigen::MatrixXd::Identity(known.modes.rows(), 40);
  for (Eigen::Index k = 0; k < 8; ++k) {
    const Eigen::VectorXd mode = others.modes.col(k);
    // Another draw's components are the same physics: what is left is sampling.
    QVERIFY((mode - span * (span.transpose() * mode)).norm() < 0.15 * mode.norm());
  }
}

void OperationTest::AmplitudesAreStandardDeviations() {
  // The mean square motion of the operations is the sum of the modes' squares, whatever they are turned to.
  OperationOptions options;
  options.operations = 120;
  options.modes = 120;
  options.unforeseen_m = 0.0;
  const OperationPrior prior = simulate_operations(model_, options, RunContext()).value();
  const double root_mean_square =
      std::sqrt(prior.modes.squaredNorm() / static_cast<double>(model_.mesh.vertex_count()));
  // Between the mean and twice the mean: lengths of a few normal components.
  QVERIFY(root_mean_square > prior.mean_motion && root_mean_square < 2.0 * prior.mean_motion);
}

void OperationTest::UnforeseenForcesMoveByWhatIsAsked() {
  OperationOptions options;
  options.operations = 40;
  options.unforeseen_m = 0.0;
  const Eigen::MatrixXd foreseen = simulate_operations(model_, options, RunContext()).value().modes;
  options.unforeseen_m = 5e-3;
  const Eigen::MatrixXd all = simulate_operations(model_, options, RunContext()).value().modes;
  QVERIFY(all.leftCols(foreseen.cols()) == foreseen);
  const Eigen::MatrixXd others = all.rightCols(all.cols() - foreseen.cols());
  const double motion = std::sqrt(others.squaredNorm() / static_cast<double>(model_.mesh.vertex_count()));
  QVERIFY(motion > 0.97 * 5e-3 && motion < 1.001 * 5e-3);  // the smallest components are left out
  // Components: orthogonal, the larger first, and nothing rigid in them.
  for (Eigen::Index k = 1; k < others.cols(); ++k) {
    QVERIFY(others.col(k).norm() <= others.col(k - 1).norm() * (1.0 + 1e-9));
    QVERIFY(std::abs(others.col(k).dot(others.col(0))) < 1e-9 * others.col(0).squaredNorm());
  }
  for (int c = 0; c < 3; ++c) {
    double mean = 0.0;
    for (Eigen::Index i = c; i < others.rows(); i += 3) mean += others(i, 0);
    QVERIFY(std::abs(mean) < 1e-9 * others.col(0).norm());
  }
}

void OperationTest::ShapeAndPoseAreFoundTogether() {
  const OperationPrior prior = simulated(model_, 80, 1);
  // The truth is of another draw, on the same mesh: what is tested is the estimate, not the mesh.
  const OperationPrior other = simulated(model_, 50, 5);
  Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero(other.modes.cols());
  amplitudes.head<4>() << 1.2, -0.9, 0.8, 0.7;
  const Points there = phantom::lying_view().apply(other.shape(model_.mesh.vertices, amplitudes));
  // From all sides: on its dome alone the phantom is so round that shapes and poses stand in for each other.
  // What a partial view allows is measured on patients (see the README).
  LabelledCloud cloud;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.5e-3);
  cloud.points = there(model_.surface.node_of_vertex, Eigen::all);
  for (double& coordinate : cloud.points.reshaped()) coordinate += noise(random);
  TriangleMesh now = model_.surface.mesh;
  now.vertices = there(model_.surface.node_of_vertex, Eigen::all);
  cloud.normals = vertex_normals(now);
  const Points& truth = there;
  const auto best = fit_rigid<CameraFrame, CtFrame>(model_.mesh.vertices, truth);
  CameraFromCt start = best;
  start.rotation = Eigen::AngleAxisd(0.06, Eigen::Vector3d(1, 1, 0).normalized()) * best.rotation;
  start.translation = best.translation + Eigen::Vector3d(0.004, -0.004, 0.003);

  const auto fit = fit_shape(model_, prior, cloud, {start, {}}, {}, RunContext());
  const double rigid = point_errors(best.apply(model_.mesh.vertices), truth).mean;
  const double fitted = point_errors(fit->nodes_in_camera, truth).mean;
  qInfo("operations move %.1f mm; best rigid %.2f mm, fitted %.2f mm (in-silico, %d iterations)",
        1e3 * prior.mean_motion, 1e3 * rigid, 1e3 * fitted, fit->iterations);
  QVERIFY(rigid > 4e-3);
  // A fit that forgets the prior, or leaves the pose where it started, leaves more than a third of what the
  // best rigid pose does.
  QVERIFY(fitted < 0.3 * rigid);
  QVERIFY(fit->residual < 1.5e-3);
}

void OperationTest::AFitThatIsFarBehindEndsEarlyAndTheBestIsTheSame() {
  const OperationPrior prior = simulated(model_, 50, 1);
  const CameraFromCt right = phantom::lying_view();
  const LabelledCloud cloud = phantom::patch(model_, right.apply(model_.mesh.vertices), {.share = 0.4});
  CameraFromCt near = right, far = right;
  near.translation += Eigen::Vector3d(0.003, 0.0, 0.002);
  far.rotation = Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitY()) * right.rotation;
  ShapeFitOptions sure;
  sure.information = 0.5;  // so that the places differ by far
  const auto alone = fit_shape(model_, prior, cloud, {near, {}}, sure, RunContext());
  const auto lost = fit_shape(model_, prior, cloud, {far, {}}, sure, RunContext());
  const auto both = fit_shapes(model_, prior, cloud, starts_of(near, {far}), sure, RunContext());
  QVERIFY(lost->iterations > 20);  // by itself it goes on
  QCOMPARE(both->fits.size(), std::size_t{2});
  QVERIFY(both->best().nodes_in_camera == alone->nodes_in_camera);
  QCOMPARE(both->fits.back().iterations, 20);
  QCOMPARE(both->places().size(), std::size_t{1});  // so far behind that it is no other place
}

void OperationTest::AFaceSeenFromBehindSpeaksAgainstAShape() {
  const OperationPrior prior = simulated(model_, 40, 1);
  LabelledCloud cloud =
      phantom::patch(model_, phantom::lying_view().apply(model_.mesh.vertices), {.share = 0.2});
  // Half a turn about the patch lays its back on the cloud.
  const Eigen::Vector3d middle = cloud.points.colwise().mean().transpose();
  Rigid<CameraFrame, CameraFrame> turn;
  turn.rotation = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
  turn.translation = middle - turn.rotation * middle;
  const CameraFromCt behind = turn * phantom::lying_view();
  ShapeFitOptions once;
  once.max_iterations = 1;
  LabelledCloud bare = cloud, from_behind = cloud;
  bare.normals.resize(0, 3);
  from_behind.normals = -cloud.normals;
  const auto told = fit_shape(model_, prior, bare, {behind, {}}, once, RunContext());
  const auto agreed = fit_shape(model_, prior, from_behind, {behind, {}}, once, RunContext());
  QVERIFY2(told->cost > 1.2 * agreed->cost, qPrintable(QString("%1, %2").arg(told->cost).arg(agreed->cost)));
}

void OperationTest::RegistrationWithThePriorIsTheBetterOne() {
  const PatientModel finer = lying(11, 9, 5);
  const OperationPrior other = simulated(finer, 50, 6);
  Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero(other.modes.cols());
  amplitudes.head<3>() << -1.3, 1.0, 0.8;
  const Points there = phantom::lying_view().apply(other.shape(finer.mesh.vertices, amplitudes));
  const LabelledCloud cloud = phantom::patch(finer, there, {});
  const Points truth = bind_points(finer.mesh, model_.mesh.vertices, false).apply(finer.mesh, there);
  const auto best = fit_rigid<CameraFrame, CtFrame>(model_.mesh.vertices, truth);
  ElasticOptions options;
  options.r_surface = 3;
  const auto alone = register_elastic(model_, cloud, best, options, RunContext());
  const auto prior = std::make_shared<const OperationPrior>(simulated(model_, 80, 1));
  options.prior = prior;
  const auto shapes = fit_shapes(model_, *prior, cloud, starts_of(best, {}), options.shape, RunContext());
  const auto with = register_elastic(model_, cloud, *shapes, options, RunContext());
  const double error_alone = point_errors(alone->nodes_in_camera, truth).mean,
               error_with = point_errors(with->nodes_in_camera, truth).mean;
  qInfo("elasticity alone %.2f mm, with the prior %.2f mm (in-silico)", 1e3 * error_alone, 1e3 * error_with);
  QVERIFY(error_with < 0.9 * error_alone);
}

void OperationTest::FineSurfaceIsCarriedByItsTetrahedra() {
  PatientModel model = lying(8, 6, 4);
  model.surfaces.push_back({structure::kParenchyma, "liver", lying(20, 16, 8).surface.mesh});
  MovingSurface surface(model, SurfaceDetail::fine);
  QVERIFY(surface.mesh().vertex_count() > 2 * model.surface.mesh.vertex_count());
  // An affine motion is carried exactly, inside the mesh and outside.
  Eigen::Matrix3d stretch;
  stretch << 1.1, 0.2, 0.0, -0.1, 0.9, 0.05, 0.0, 0.1, 1.05;
  const Points nodes = model.mesh.vertices * stretch.transpose();
  surface.move(nodes);
  const Points expected = model.surfaces.back().mesh.vertices * stretch.transpose();
  QVERIFY((surface.mesh().vertices - expected).rowwise().norm().maxCoeff() < 1e-9);
  for (int t = 0; t < surface.mesh().triangle_count(); t += 37) {
    ClosestPoint at;
    at.triangle = t;
    at.barycentric = Eigen::Vector3d(0.2, 0.3, 0.5);
    Eigen::Vector3d on_surface = Eigen::Vector3d::Zero(), carried = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      on_surface += at.barycentric[k] * surface.mesh().vertex(surface.mesh().triangles(t, k));
    const Carrier carrier = surface.carrier(at);
    for (std::size_t k = 0; k < 4; ++k)
      carried += carrier.weights[k] * nodes.row(carrier.nodes[k]).transpose();
    QVERIFY((carried - on_surface).norm() < 1e-9);
  }
}

void OperationTest::UnfitFineSurfaceIsNotUsed() {
  PatientModel model = lying(8, 6, 4);
  TriangleMesh half = model.surface.mesh;
  half.vertices *= 0.5;  // an eighth of the volume: the outline of something else
  model.surfaces.push_back({structure::kParenchyma, "liver", half});
  QCOMPARE(MovingSurface(model, SurfaceDetail::fine).mesh().vertex_count(),
           model.surface.mesh.vertex_count());
  QVERIFY(MovingSurface(model, SurfaceDetail::fine).mesh().vertices == model.surface.mesh.vertices);
}

void OperationTest::CancelIsObeyed() {
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  const RunContext context({}, flag, 1);
  QVERIFY(!simulate_operations(model_, {}, context).has_value());
  const LabelledCloud cloud = phantom::patch(model_, phantom::lying_view().apply(model_.mesh.vertices), {});
  QVERIFY(!fit_shape(model_, simulated(model_, 50, 1), cloud, {phantom::lying_view(), {}}, {}, context)
               .has_value());
}

void OperationTest::UnusableInputIsRefused() {
  PatientModel unknown = model_;
  unknown.landmarks.vena_cava.resize(0, 3);
  QVERIFY(!can_simulate_operations(unknown));
  QVERIFY_THROWS_EXCEPTION(InputError, simulate_operations(unknown, {}, RunContext()));
  const auto refused = [&](auto change) {
    OperationOptions options;
    change(options);
    try {
      simulate_operations(model_, options, RunContext());
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  QVERIFY(refused([](OperationOptions& o) { o.operations = 39; }));
  QVERIFY(refused([](OperationOptions& o) { o.modes = 0; }));
  QVERIFY(refused([](OperationOptions& o) { o.gravity = -1.0; }));
  QVERIFY(refused([](OperationOptions& o) { o.gas_pa = 5000.0; }));
  QVERIFY(refused([](OperationOptions& o) { o.bed_m = 0.2; }));
  QVERIFY(refused([](OperationOptions& o) { o.ligament_m = -0.1; }));
  QVERIFY(refused([](OperationOptions& o) { o.contact_spread = 3.0; }));
  QVERIFY(refused([](OperationOptions& o) { o.unforeseen_m = 0.1; }));
  ShapeFitOptions flat;
  flat.sigma_surface = 0.0;
  const LabelledCloud cloud = phantom::patch(model_, phantom::lying_view().apply(model_.mesh.vertices), {});
  QVERIFY_THROWS_EXCEPTION(InputError, fit_shape(model_, simulated(model_, 50, 1), cloud,
                                                 {phantom::lying_view(), {}}, flat, RunContext()));
}

QTEST_APPLESS_MAIN(OperationTest)
#include "operation_test.moc"
