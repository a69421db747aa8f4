// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/sound_cloud.h"

#include <QTest>
#include <limits>

using namespace glisson;

namespace {

/// A plate of 6 x 6 points, 100 mm before the lens; each with all that a point may have.
LabelledCloud plate() {
  LabelledCloud cloud;
  cloud.points.resize(36, 3);
  cloud.normals.resize(36, 3);
  for (int i = 0; i < 36; ++i) {
    cloud.points.row(i) << 0.01 * (i % 6), 0.01 * (i / 6), 0.1;
    cloud.normals.row(i) << 0.0, 0.001 * i, -1.0;
    cloud.features.push_back(i % 6 == 0 ? Feature::anterior_margin : Feature::surface);
    cloud.sigma.push_back(1e-4 * i);
  }
  return cloud;
}

LabelledCloud with(LabelledCloud cloud, const std::vector<Eigen::RowVector3d>& points, Feature feature) {
  const Eigen::Index n = cloud.points.rows(), more = static_cast<Eigen::Index>(points.size());
  cloud.points.conservativeResize(n + more, Eigen::NoChange);
  cloud.normals.conservativeResize(n + more, Eigen::NoChange);
  for (Eigen::Index i = 0; i < more; ++i) {
    cloud.points.row(n + i) = points[static_cast<std::size_t>(i)];
    cloud.normals.row(n + i) << 0.0, 0.0, -1.0;
    cloud.features.push_back(feature);
    cloud.sigma.push_back(1e-3);
  }
  return cloud;
}

bool is_plate(const LabelledCloud& cloud) {
  const LabelledCloud good = plate();
  return cloud.points == good.points && cloud.normals == good.normals && cloud.features == good.features &&
         cloud.sigma == good.sigma;
}

}  // namespace

class SoundCloudTest : public QObject {
  Q_OBJECT
 private slots:
  void AGoodCloudStaysAsItIs() {
    CloudFaults faults;
    QVERIFY(is_plate(sound_cloud(plate(), true, faults)));
    QVERIFY(faults.notes().empty());
  }
  void PointsWithoutDepthGo() {
    const LabelledCloud cloud = with(plate(), {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, Feature::surface);
    CloudFaults faults;
    QVERIFY(is_plate(sound_cloud(cloud, true, faults)));
    QCOMPARE(faults.notes(), (std::vector<std::string>{"cloud.without_depth 4"}));
  }
  void NormalsFaceTheCamera() {
    LabelledCloud cloud = plate();
    for (const int i : {3, 20, 21, 35}) cloud.normals.row(i) *= -1.0;
    CloudFaults faults;
    QVERIFY(is_plate(sound_cloud(cloud, true, faults)));
    QCOMPARE(faults.notes(), (std::vector<std::string>{"cloud.normals_turned 4"}));
    // Noise turns a few of those that are seen edge on: nothing to tell.
    cloud = plate();
    for (const int i : {3, 20, 21}) cloud.normals.row(i) *= -1.0;
    CloudFaults few;
    QVERIFY(is_plate(sound_cloud(cloud, true, few)));
    QVERIFY(few.notes().empty());
    // Where no camera is known there is no side to face.
    CloudFaults unknown;
    QVERIFY(sound_cloud(cloud, false, unknown).normals == cloud.normals);
    // Another look's camera stands behind the plate.
    cloud.eyes.resize(2, 3);
    cloud.eyes << 0.0, 0.0, 0.0, 0.0, 0.0, 0.3;
    cloud.looks.assign(36, 0);
    cloud.looks[3] = cloud.looks[20] = cloud.looks[21] = 1;
    CloudFaults two;
    QVERIFY(sound_cloud(cloud, true, two).normals == cloud.normals);
  }
  void InTheModelsFrameDepthIsNotKnown() {
    const LabelledCloud cloud = with(plate(), {{0, 0, 0}}, Feature::surface);
    CloudFaults faults;
    QCOMPARE(sound_cloud(cloud, false, faults).size(), 37);
    QVERIFY(faults.notes().empty());
  }
  void WhatIsThereTwiceCountsOnce() {
    LabelledCloud cloud = plate();
    for (int times = 0; times < 3; ++times)
      for (int i = 0; i < 36; ++i)
        cloud =
            with(cloud, {plate().points.row(i)}, i % 6 == 0 ? Feature::anterior_margin : Feature::surface);
    CloudFaults faults;
    QVERIFY(is_plate(sound_cloud(cloud, true, faults)));
    QCOMPARE(faults.repeated, 3 * 36);
  }
  void APlaceOfTwoFeaturesOrLooksIsNoRepetition() {
    LabelledCloud cloud = with(plate(), {plate().points.row(7)}, Feature::umbilical_notch);
    CloudFaults faults;
    QCOMPARE(sound_cloud(cloud, true, faults).size(), 37);
    cloud = with(plate(), {plate().points.row(7)}, Feature::surface);
    cloud.looks.assign(37, 0);
    cloud.looks.back() = 1;
    cloud.eyes.setZero(2, 3);
    const LabelledCloud kept = sound_cloud(cloud, true, faults);
    QCOMPARE(kept.size(), 37);
    QCOMPARE(kept.looks.back(), 1);
    QCOMPARE(faults.repeated, 0);
  }
  void AnotherConventionIsToldAndStays() {
    LabelledCloud cloud = plate();
    cloud.points.rightCols<2>() *= -1.0;  // as OpenGL's and VTK's cameras see it
    cloud.normals.rightCols<2>() *= -1.0;
    CloudFaults faults;
    QVERIFY(sound_cloud(cloud, true, faults).points == cloud.points);
    QCOMPARE(faults.notes(), (std::vector<std::string>{"cloud.behind 36"}));
    CloudFaults of_model;
    QVERIFY(sound_cloud(cloud, false, of_model).points == cloud.points);
    QVERIFY(of_model.notes().empty());
  }
  void WhatIsNotANumberIsLeftToThoseWhoRefuseIt() {
    LabelledCloud cloud = plate();
    cloud.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
    CloudFaults faults;
    QCOMPARE(sound_cloud(cloud, true, faults).size(), 36);
  }
};

QTEST_GUILESS_MAIN(SoundCloudTest)
#include "sound_cloud_test.moc"
