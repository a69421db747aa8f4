// SPDX-License-Identifier: GPL-3.0-or-later
// What a label says of where the organ is, beside what its point says as one of the surface.
#include <QTest>
#include <algorithm>

#include "force_rows.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/rivals.h"
#include "phantom.h"
#include "unmarked.h"

using namespace glisson;
using namespace glisson::registration;

class LabelsTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatLiesOnALandmarkLiesOnTheSurfaceToo();
  void LabelsMakeNothingLessSure();
  void ALandmarkThatTheModelLacksTellsNothing();
  void AMarginThatIsSeenIsMarked();
  void WhoMarksNothingLeavesOnePlaceOut();
  void WhatIsLeftOutDoesNotDependOnTheFrame();

 private:
  LabelledCloud labelled() const {
    phantom::PatchOptions options;
    options.noise = 1e-3;
    return phantom::patch(model_, nodes_, options);
  }
  LabelledCloud unlabelled() const {
    LabelledCloud cloud = labelled();
    cloud.features.clear();
    return cloud;
  }
  static int count(const LabelledCloud& cloud, Feature feature) {
    return static_cast<int>(std::count(cloud.features.begin(), cloud.features.end(), feature));
  }
  static ForceRows rows_of(const PatientModel& model, const Points& nodes, const LabelledCloud& cloud) {
    MovingSurface surface(model, SurfaceDetail::fine);
    surface.move(nodes);
    return find_rows(prepare_cloud(cloud, {}), surface, {3e-3, 6e-3, 0.2});
  }

  /// What a place of the margin that is left out costs, with a fifth of the points independent.
  const double kPlace = 2.0 * votes_of_a_place(0.2) * std::log(5.0);
  static double unmarked(const PatientModel& model, const Points& nodes, const LabelledCloud& cloud) {
    MovingSurface surface(model, SurfaceDetail::fine);
    surface.move(nodes);
    return unmarked_cost(model, prepare_cloud(cloud, {}), surface, 0.2);
  }

  PatientModel model_ = phantom::model(9, 8, 4);
  Points nodes_ = phantom::view().apply(model_.mesh.vertices);
};

void LabelsTest::WhatLiesOnALandmarkLiesOnTheSurfaceToo() {
  const ForceRows with = rows_of(model_, nodes_, labelled()), without = rows_of(model_, nodes_, unlabelled());
  QVERIFY(count(labelled(), Feature::anterior_margin) >= 10);
  QVERIFY(count(labelled(), Feature::umbilical_notch) > 5);
  QCOMPARE(with.surface_count, without.surface_count);
  QVERIFY(with.gap.head(with.surface_count) == without.gap);
  // The median that no point outweighs three times is of the surface's own points: hardly another one.
  const Eigen::VectorXd ratio = with.sigma.head(with.surface_count).cwiseQuotient(without.sigma);
  QVERIFY2(ratio.minCoeff() > 0.9 && ratio.maxCoeff() < 1.1,
           qPrintable(QStringLiteral("%1 %2").arg(ratio.minCoeff()).arg(ratio.maxCoeff())));
}

void LabelsTest::LabelsMakeNothingLessSure() {
  const auto expected = [&](const LabelledCloud& cloud) {
    return ErrorModel(model_, nullptr, {}, phantom::view(), nodes_, prepare_cloud(cloud, {}), 1e-3)
        .expected();
  };
  const Eigen::VectorXd with = expected(labelled()), without = expected(unlabelled());
  const double worst = with.cwiseQuotient(without).maxCoeff();
  QVERIFY2(worst < 1.01, qPrintable(QString::number(worst)));
  QVERIFY(with.mean() < 0.99 * without.mean());
}

void LabelsTest::ALandmarkThatTheModelLacksTellsNothing() {
  PatientModel bare = model_;
  bare.landmarks = {};
  const ForceRows with = rows_of(bare, nodes_, labelled()), without = rows_of(bare, nodes_, unlabelled());
  QCOMPARE(with.size(), without.size());
  QVERIFY(with.gap == without.gap);
}

void LabelsTest::AMarginThatIsSeenIsMarked() {
  QCOMPARE(unmarked(model_, nodes_, unlabelled()), 0.0);
  const double all = unmarked(model_, nodes_, labelled());
  // Half of the marks are taken for surface.
  LabelledCloud half = labelled();
  const double middle = half.points.col(0).mean();
  for (int i = 0; i < half.size(); ++i)
    if (half.feature(i) == Feature::anterior_margin && half.points(i, 0) > middle)
      half.features[static_cast<std::size_t>(i)] = Feature::surface;
  QVERIFY(count(half, Feature::anterior_margin) > 5);
  const double some = unmarked(model_, nodes_, half);
  QVERIFY2(all < 0.2 * kPlace && some > kPlace, qPrintable(QString("%1 %2").arg(all).arg(some)));
  PatientModel unsure = model_;
  unsure.landmarks.margin_deviation =
      Eigen::VectorXd::Constant(model_.landmarks.anterior_margin.rows(), 2.0 * kMarginSigma);
  QVERIFY(std::abs(unmarked(unsure, nodes_, half) / some - 0.25) < 0.01);
  PatientModel without = model_;
  without.landmarks.anterior_margin.resize(0, 3);
  QCOMPARE(unmarked(without, nodes_, half), 0.0);
}

void LabelsTest::WhoMarksNothingLeavesOnePlaceOut() {
  LabelledCloud none = labelled();
  none.features.assign(none.features.size(), Feature::surface);
  QVERIFY(std::abs(unmarked(model_, nodes_, none) - kPlace) < 1e-9);
  // Where the cloud shows no margin there is none to be marked.
  std::vector<int> away;
  for (int i = 0; i < none.size(); ++i)
    if (labelled().feature(i) == Feature::surface) away.push_back(i);
  // Nor is anybody asked of tissue that was followed.
  LabelledCloud followed = none;
  followed.seen_from = Points::Zero(none.size(), 3);
  QCOMPARE(unmarked(model_, nodes_, followed), 0.0);
  const LabelledCloud inside = glisson::rows_of(none, away);
  QVERIFY(unmarked(model_, nodes_, inside) < 0.5 * kPlace);
}

void LabelsTest::WhatIsLeftOutDoesNotDependOnTheFrame() {
  LabelledCloud none = labelled();
  for (int i = 0; i < none.size(); ++i)
    if (none.points(i, 0) > none.points.col(0).mean())
      none.features[static_cast<std::size_t>(i)] = Feature::surface;
  const double here = unmarked(model_, nodes_, none);
  Rigid<CameraFrame, CameraFrame> moved;
  moved.rotation = rotation_by(Eigen::Vector3d(0.4, -1.0, 2.0));
  moved.translation = Eigen::Vector3d(0.1, 0.2, -0.3);
  LabelledCloud there = none;
  there.points = moved.apply(none.points);
  there.normals = none.normals * moved.rotation.transpose();
  QVERIFY(here > 0.0);
  QVERIFY(std::abs(unmarked(model_, moved.apply(nodes_), there) / here - 1.0) < 0.02);
}

QTEST_APPLESS_MAIN(LabelsTest)
#include "labels_test.moc"
