// SPDX-License-Identifier: GPL-3.0-or-later
// Several looks at one organ: joined, and where each was seen from is found together with the shape.
#include "looks.h"

#include <QTest>
#include <random>

#include "fit_contact_forces.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/moving_surface.h"
#include "glisson/registration/pairs.h"
#include "lying_phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

using Scope = Rigid<CameraFrame, CameraFrame>;

Scope moved_scope(double turn, double shift) {
  Scope scope;
  scope.rotation = Eigen::AngleAxisd(turn, Eigen::Vector3d(0.3, 1.0, 0.2).normalized()).toRotationMatrix();
  const Eigen::Vector3d middle(0.0, 0.0, 0.15);
  scope.translation = middle - scope.rotation * middle + shift * Eigen::Vector3d(0.6, -0.5, 0.62);
  return scope;
}

LabelledCloud seen_by(const Scope& scope, LabelledCloud cloud) {
  cloud.points = scope.apply(cloud.points);
  return cloud;
}

/// The organ bent as no operation of the prior was, seen all around; its points by turns in one of two looks.
struct Bent {
  PatientModel model = phantom::lying(7, 6, 3);
  OperationPrior prior = phantom::simulated(model, 80, 1);
  Points truth, otherwise;  ///< bent, and bent the other way
  LabelledCloud all, first, second;

  Bent() {
    const OperationPrior other = phantom::simulated(model, 50, 5);
    Eigen::VectorXd amplitudes = Eigen::VectorXd::Zero(other.modes.cols());
    amplitudes.head<4>() << 1.2, -0.9, 0.8, 0.7;
    truth = phantom::lying_view().apply(other.shape(model.mesh.vertices, amplitudes));
    otherwise = phantom::lying_view().apply(other.shape(model.mesh.vertices, -1.5 * amplitudes));
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.5e-3);
    all.points = truth(model.surface.node_of_vertex, Eigen::all);
    for (double& coordinate : all.points.reshaped()) coordinate += noise(random);
    std::vector<Eigen::Index> left, right;  // overlapping halves
    const double middle = all.points.col(0).mean();
    for (Eigen::Index i = 0; i < all.points.rows(); ++i) {
      if (all.points(i, 0) < middle + 0.02) left.push_back(i);
      if (all.points(i, 0) > middle - 0.02) right.push_back(i);
    }
    first.points = all.points(left, Eigen::all);
    second.points = all.points(right, Eigen::all);
  }
};

double farthest(const Points& a, const Points& b) { return (a - b).rowwise().norm().maxCoeff(); }

}  // namespace

class LooksTest : public QObject {
  Q_OBJECT
 private slots:
  void LooksAreJoinedInTheFirstOnesFrame();
  void NeighboursAreOfOneLookAndAnAreaSeenTwiceCountsOnce();
  void EachLookHasANotchOfItsOwn();
  void WhereALookWasSeenFromIsFoundWithTheShape();
  void ForcesFindItToo();
  void WhatIsKnownOfTheCameraMakesTheErrorSmaller();
  void ALookFromElsewhereIsJoinedWithoutAStart();
  void AnOrganThatWasBentInBetweenIsRecognised();
  void HowFarALookLiesIsMeasured();
  void ALookOfFewPointsIsRefused();
};

void LooksTest::LooksAreJoinedInTheFirstOnesFrame() {
  const PatientModel model = phantom::model(6, 5, 3);
  const LabelledCloud cloud = phantom::patch(model, phantom::view().apply(model.mesh.vertices), {});
  const Scope scope = moved_scope(0.6, 0.03);
  LabelledCloud other = seen_by(scope, cloud);
  other.features.clear();
  const LabelledCloud both = joined({cloud, other}, {Scope(), scope.inverse()});
  QCOMPARE(both.size(), 2 * cloud.size());
  QVERIFY(farthest(both.points.topRows(cloud.size()), cloud.points) == 0.0);
  QVERIFY(farthest(both.points.bottomRows(cloud.size()), cloud.points) < 1e-12);
  QCOMPARE(both.look(0), 0);
  QCOMPARE(both.look(both.size() - 1), 1);
  QCOMPARE(both.look_count(), 2);
  QVERIFY((both.eye(both.size() - 1) - scope.inverse().translation).norm() < 1e-12);
  QCOMPARE(both.eye(0), Eigen::Vector3d(Eigen::Vector3d::Zero()));
  // A cloud without labels is all surface, and normals are there when all looks have them.
  QCOMPARE(both.feature(both.size() - 1), Feature::surface);
  QCOMPARE(both.feature(0), cloud.feature(0));
  QCOMPARE(both.normals.rows() > 0, cloud.normals.rows() > 0);
}

void LooksTest::NeighboursAreOfOneLookAndAnAreaSeenTwiceCountsOnce() {
  const PatientModel model = phantom::model(6, 5, 3);
  LabelledCloud cloud = phantom::patch(model, phantom::view().apply(model.mesh.vertices), {});
  cloud.features.clear();
  LabelledCloud other = cloud;
  other.points.rowwise() += Eigen::RowVector3d(0.0, 0.0, 0.4e-3);
  const PreparedCloud both = prepare_cloud(joined({cloud, other}, LookMotions(2)), {});
  const PreparedCloud one = prepare_cloud(cloud, {});
  double weight = 0.0, alone = 0.0;
  for (int i = 0; i < both.cloud.size(); ++i) {
    weight += both.weight[static_cast<std::size_t>(i)];
    for (const int j : both.neighbours[static_cast<std::size_t>(i)])
      QCOMPARE(both.cloud.look(j), both.cloud.look(i));
  }
  for (const double w : one.weight) alone += w;
  QVERIFY2(std::abs(weight / alone - 1.0) < 0.1, qPrintable(QString::number(weight / alone)));
}

/// Averaged over both, the marks would pull either look towards the other one's error.
void LooksTest::EachLookHasANotchOfItsOwn() {
  const PatientModel model = phantom::model(8, 7, 4);
  const Points nodes = phantom::view().apply(model.mesh.vertices);
  const LabelledCloud cloud = phantom::patch(model, nodes, {.noise = 0.0});
  Scope off;
  off.translation.x() = 0.02;
  const PreparedCloud both = prepare_cloud(joined({cloud, cloud}, {Scope(), off}), {});
  MovingSurface surface(model, SurfaceDetail::fine);
  surface.move(nodes);
  Eigen::Vector3d gaps[2];
  int marks = 0;
  for (const Pair& pair : find_pairs(both, surface, {})) {
    if (pair.feature != Feature::umbilical_notch) continue;
    gaps[both.cloud.look(pair.point)] = pair.gap;
    ++marks;
  }
  QVERIFY(marks > 2);
  QVERIFY((gaps[1] - gaps[0] - off.translation).norm() < 1e-9);
  QCOMPARE(both.notch_points.size(), std::size_t{2});
  QCOMPARE(both.notch_points[0] + both.notch_points[1], marks);
}

void LooksTest::WhereALookWasSeenFromIsFoundWithTheShape() {
  const Bent bent;
  const auto best = fit_rigid<CameraFrame, CtFrame>(bent.model.mesh.vertices, bent.truth);
  const auto whole = fit_shape(bent.model, bent.prior, bent.all, {best, {}}, {}, RunContext());
  // The second look is 8 mm and 5 degrees away from where it belongs.
  const Scope off = moved_scope(0.09, 0.008);
  const LabelledCloud cloud = joined({bent.first, bent.second}, {Scope(), off});
  const double before = farthest(off.apply(bent.second.points), bent.second.points);
  const auto found = fit_shape(bent.model, bent.prior, cloud, {best, {}}, {}, RunContext());
  QCOMPARE(found->looks.size(), std::size_t{2});
  const Points back = found->looks[1].apply(off.apply(bent.second.points));
  QVERIFY(before > 10e-3);
  QVERIFY2(farthest(back, bent.second.points) < 0.25 * before,
           qPrintable(QString::number(1e3 * farthest(back, bent.second.points))));
  // The shape is nearly as good as that of one cloud of all points; stuck where they are put it would not be.
  const double at_once = point_errors(whole->nodes_in_camera, bent.truth).mean;
  const double of_looks = point_errors(found->nodes_in_camera, bent.truth).mean;
  QVERIFY2(of_looks < at_once + 0.7e-3, qPrintable(QString("%1, %2").arg(1e3 * of_looks).arg(1e3 * at_once)));
  LabelledCloud stuck = cloud;
  stuck.looks.clear();
  stuck.eyes.resize(0, 3);
  const auto wrong = fit_shape(bent.model, bent.prior, stuck, {best, {}}, {}, RunContext());
  QVERIFY(point_errors(wrong->nodes_in_camera, bent.truth).mean > of_looks + 1e-3);
}

void LooksTest::ForcesFindItToo() {
  const Bent bent;
  const auto best = fit_rigid<CameraFrame, CtFrame>(bent.model.mesh.vertices, bent.truth);
  const Scope off = moved_scope(0.05, 0.004);
  const LabelledCloud cloud = joined({bent.first, bent.second}, {Scope(), off});
  ContactForceOptions options;
  options.prior = std::make_shared<const OperationPrior>(bent.prior);
  options.information = 0.2;
  options.sigmas.assign(3, 3e-3);
  options.patch_price = 1.0;
  options.patch_spacing = 20e-3;
  options.patch_radius = 30e-3;
  const auto fit = fit_contact_forces(bent.model, cloud, best, options, RunContext());
  QCOMPARE(fit->looks.size(), std::size_t{2});
  const Points back = fit->looks[1].apply(off.apply(bent.second.points));
  const double before = farthest(off.apply(bent.second.points), bent.second.points);
  QVERIFY2(farthest(back, bent.second.points) < 0.5 * before,
           qPrintable(QString("%1 of %2").arg(1e3 * farthest(back, bent.second.points)).arg(1e3 * before)));
}

void LooksTest::WhatIsKnownOfTheCameraMakesTheErrorSmaller() {
  const Bent bent;
  const auto best = fit_rigid<CameraFrame, CtFrame>(bent.model.mesh.vertices, bent.truth);
  const auto expected = [&](const LabelledCloud& cloud) {
    return ErrorModel(bent.model, &bent.prior, {}, best, bent.truth, prepare_cloud(cloud, {}), 0.5e-3)
        .expected()
        .mean();
  };
  LabelledCloud known = joined({bent.first, bent.second}, LookMotions(2));
  const double unknown = expected(known), alone = expected(bent.first);
  known.looks.clear();
  known.eyes.resize(0, 3);
  const double fixed = expected(known);
  QVERIFY2(fixed < 0.98 * unknown && unknown < 0.98 * alone,
           qPrintable(QString("%1 %2 %3").arg(1e3 * fixed).arg(1e3 * unknown).arg(1e3 * alone)));
}

void LooksTest::ALookFromElsewhereIsJoinedWithoutAStart() {
  const PatientModel model = phantom::lying(7, 6, 3);
  const Points nodes = phantom::lying_view().apply(model.mesh.vertices);
  const LabelledCloud cloud = phantom::patch(model, nodes, {.share = 0.25});
  const Scope scope = moved_scope(0.5, 0.02);
  RegisterOptions options;
  options.operation.operations = 40;
  options.rigid.starts = 60;
  options.looks = {seen_by(scope, phantom::patch(model, nodes, {.share = 0.3, .seed = 2}))};
  options.looks[0].normals.resize(0, 3);
  const auto made = register_model(model, cloud, options, RunContext());
  QVERIFY(made.has_value());
  QCOMPARE(made->registered.look_distances.size(), std::size_t{2});
  for (const double distance : made->registered.look_distances) QVERIFY(distance < 1.5e-3);
  const double error = point_errors(made->registered.registration.nodes_in_camera, nodes).mean;
  QVERIFY2(error < 4e-3, qPrintable(QString::number(1e3 * error)));
}

void LooksTest::AnOrganThatWasBentInBetweenIsRecognised() {
  const Bent bent;
  const CameraFromCt pose = phantom::lying_view();
  const LabelledCloud first = phantom::patch(bent.model, bent.truth, {.share = 0.4});
  const auto odds = [&](const Points& nodes) {
    const std::vector<LabelledCloud> looks = {first,
                                              phantom::patch(bent.model, nodes, {.share = 0.4, .seed = 2})};
    const auto joint =
        fit_shape(bent.model, bent.prior, joined(looks, LookMotions(2)), {pose, {}}, {}, RunContext());
    return one_shape_odds(bent.model, bent.prior, looks, LookMotions(2), *joint, {}, RunContext()).value();
  };
  const double same = odds(bent.truth), moved = odds(bent.otherwise);
  QVERIFY2(same > 10.0, qPrintable(QString::number(same)));
  QVERIFY2(moved < 5.0, qPrintable(QString::number(moved)));
}

void LooksTest::HowFarALookLiesIsMeasured() {
  const PatientModel model = phantom::model(8, 7, 4);
  const Points nodes = phantom::view().apply(model.mesh.vertices);
  const LabelledCloud cloud = phantom::patch(model, nodes, {.noise = 0.0});
  Scope away;  // along the view, which the dome faces
  away.translation.z() = -6e-3;
  const auto distances = distances_of_looks(model, nodes, joined({cloud, cloud}, {Scope(), away}));
  QCOMPARE(distances.size(), std::size_t{2});
  QVERIFY(distances[0] < 0.2e-3);
  QVERIFY2(distances[1] > 3.5e-3 && distances[1] < 6e-3, qPrintable(QString::number(1e3 * distances[1])));
}

void LooksTest::ALookOfFewPointsIsRefused() {
  const PatientModel model = phantom::model(6, 5, 3);
  const LabelledCloud cloud = phantom::patch(model, phantom::view().apply(model.mesh.vertices), {});
  LabelledCloud few;
  few.points = cloud.points.topRows(5);
  QVERIFY_THROWS_EXCEPTION(InputError, joined({cloud, few}, LookMotions(2)));
}

QTEST_APPLESS_MAIN(LooksTest)
#include "looks_test.moc"
