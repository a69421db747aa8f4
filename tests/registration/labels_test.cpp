// SPDX-License-Identifier: GPL-3.0-or-later
// What a label says of where the organ is, beside what its point says as one of the surface.
#include <QTest>
#include <algorithm>

#include "force_rows.h"
#include "glisson/registration/error_model.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

class LabelsTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatLiesOnALandmarkLiesOnTheSurfaceToo();
  void LabelsMakeNothingLessSure();
  void ALandmarkThatTheModelLacksTellsNothing();

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

QTEST_APPLESS_MAIN(LabelsTest)
#include "labels_test.moc"
