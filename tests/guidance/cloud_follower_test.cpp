// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <random>

#include "filmed_phantom.h"
#include "glisson/guidance/tracker.h"

using namespace glisson;
using namespace glisson::guidance;

/// Clouds that are not of the followed organ, or not of where it is.
class CloudFollowerTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void WhatIsElsewhereIsToldAndForgotten_data();
  void WhatIsElsewhereIsToldAndForgotten();
  void TheFirstCloudElsewhereIsToldAndForgotten_data() { methods(); }
  void TheFirstCloudElsewhereIsToldAndForgotten();
  void WhatNoTissueExplainsIsNoFailureOfTheMechanics_data();
  void WhatNoTissueExplainsIsNoFailureOfTheMechanics();
  void WhatIsNotValidMovesNothing_data();
  void WhatIsNotValidMovesNothing();
  void PointsWithoutDepthAreLeftOut_data() { methods(); }
  void PointsWithoutDepthAreLeftOut();

 private:
  static void methods();
  Tracker tracker(int method) const {
    TrackerOptions by = phantom::free_body();
    by.cloud_method = static_cast<registration::Method>(method);
    return {model_, start_, by};
  }
  /// Of the organ, breathed in by this share.
  LabelledCloud cloud(double share, unsigned seed) const {
    phantom::PatchOptions patch;
    patch.seed = seed;
    patch.share = 0.4;
    LabelledCloud cloud = phantom::patch(model_, phantom::breathed(model_, nodes_, share), patch);
    cloud.normals.resize(0, 3);
    return cloud;
  }

  PatientModel model_ = phantom::model(8, 6, 3);
  Points nodes_;
  Registration start_;
};

namespace {

constexpr int kSteps = 10;

LabelledCloud moved(LabelledCloud cloud, const Eigen::RowVector3d& way) {
  cloud.points.rowwise() += way;
  return cloud;
}

/// A ball's near side behind the organ, as of a stomach.
LabelledCloud ball_at(const Eigen::RowVector3d& centre, int points) {
  constexpr double kRadius = 35e-3, kGolden = 2.399963;
  LabelledCloud cloud;
  cloud.points.resize(points, 3);
  for (int i = 0; i < points; ++i) {
    const double z = -1.0 + 0.8 * i / points, r = std::sqrt(1.0 - z * z);
    cloud.points.row(i) =
        centre + kRadius * Eigen::RowVector3d(r * std::cos(kGolden * i), r * std::sin(kGolden * i), z);
  }
  return cloud;
}

}  // namespace

void CloudFollowerTest::methods() {
  QTest::addColumn<int>("method");
  QTest::newRow("springs") << static_cast<int>(registration::Method::springs);
  QTest::newRow("forces") << static_cast<int>(registration::Method::forces);
}

void CloudFollowerTest::initTestCase() {
  nodes_ = phantom::view().apply(model_.mesh.vertices);
  start_.nodes_in_camera = nodes_;
  start_.camera_from_ct = phantom::view();
}

void CloudFollowerTest::WhatIsElsewhereIsToldAndForgotten_data() {
  QTest::addColumn<int>("method");
  QTest::addColumn<QString>("what");
  const auto row = [](const char* name, registration::Method method, const char* what) {
    QTest::addRow("%s %s", name, what) << static_cast<int>(method) << QString(what);
  };
  for (const char* what : {"aside", "deeper", "ball"}) row("springs", registration::Method::springs, what);
  row("forces", registration::Method::forces, "aside");
}

void CloudFollowerTest::WhatIsElsewhereIsToldAndForgotten() {
  QFETCH(int, method);
  QFETCH(QString, what);
  LabelledCloud other = cloud(0.5, 5);
  if (what == "aside") other = moved(other, {60e-3, 0.0, 0.0});
  if (what == "deeper") other = moved(other, {0.0, 0.0, 60e-3});
  if (what == "ball") other = ball_at(nodes_.colwise().mean() + Eigen::RowVector3d(0.0, 0.0, 0.1), 300);
  Tracker one = tracker(method), another = tracker(method);
  const OverlayFrame before = one.follow(cloud(0.5, 1), 0, 0.0, kSteps);
  QVERIFY(before.validity == Validity::valid);
  another.follow(cloud(0.5, 1), 0, 0.0, kSteps);
  const OverlayFrame told = one.follow(other, 1, 1.0 / 30.0, kSteps);
  QVERIFY2(told.validity == Validity::surface_apart, validity_code(told.validity));
  QVERIFY(told.nodes_in_camera == before.nodes_in_camera);
  // As if it had never been.
  const OverlayFrame after = one.follow(cloud(0.6, 2), 2, 2.0 / 30.0, kSteps);
  QVERIFY2(after.validity == Validity::valid, validity_code(after.validity));
  QVERIFY(after.nodes_in_camera == another.follow(cloud(0.6, 2), 2, 2.0 / 30.0, kSteps).nodes_in_camera);
}

void CloudFollowerTest::TheFirstCloudElsewhereIsToldAndForgotten() {
  QFETCH(int, method);
  Tracker one = tracker(method), another = tracker(method);
  const OverlayFrame told = one.follow(moved(cloud(0.0, 1), {0.0, 60e-3, 0.0}), 0, 0.0, kSteps);
  QVERIFY2(told.validity == Validity::surface_apart, validity_code(told.validity));
  QVERIFY(told.nodes_in_camera == nodes_);
  const LabelledCloud right = cloud(0.5, 2);
  QVERIFY(one.follow(right, 1, 1.0 / 30.0, kSteps).nodes_in_camera ==
          another.follow(right, 1, 1.0 / 30.0, kSteps).nodes_in_camera);
}

void CloudFollowerTest::WhatNoTissueExplainsIsNoFailureOfTheMechanics_data() {
  QTest::addColumn<QString>("what");
  for (const char* what : {"mirrored", "slid", "turned"}) QTest::newRow(what) << QString(what);
}

void CloudFollowerTest::WhatNoTissueExplainsIsNoFailureOfTheMechanics() {
  QFETCH(QString, what);
  TrackerOptions held = phantom::free_body();
  held.cloud_method = registration::Method::forces;
  const double end = model_.mesh.vertices.col(0).minCoeff() + 5e-3;
  for (int node = 0; node < model_.mesh.vertex_count(); ++node)
    if (model_.mesh.vertices(node, 0) < end) held.fixed_nodes.push_back(node);
  Tracker one(model_, start_, held), another(model_, start_, held);
  const LabelledCloud right = cloud(0.3, 1);
  const OverlayFrame before = one.follow(right, 0, 0.0, kSteps);
  another.follow(right, 0, 0.0, kSteps);
  QVERIFY2(before.validity == Validity::valid, validity_code(before.validity));
  const Eigen::RowVector3d middle = right.points.colwise().mean();
  LabelledCloud other = right;
  if (what == "mirrored") other.points.col(0) = 2.0 * middle.x() - right.points.col(0).array();
  if (what == "slid") other = moved(right, {25e-3, 0.0, 0.0});
  if (what == "turned") {
    other.points.col(0) = middle.x() - (right.points.col(1).array() - middle.y());
    other.points.col(1) = middle.y() + (right.points.col(0).array() - middle.x());
  }
  const OverlayFrame told = one.follow(other, 1, 1.0 / 30.0, kSteps);
  QVERIFY2(told.validity == Validity::surface_apart, validity_code(told.validity));
  QVERIFY(told.nodes_in_camera == before.nodes_in_camera);
  const LabelledCloud next = cloud(0.4, 2);
  QVERIFY(one.follow(next, 2, 2.0 / 30.0, kSteps).nodes_in_camera ==
          another.follow(next, 2, 2.0 / 30.0, kSteps).nodes_in_camera);
}

void CloudFollowerTest::WhatIsNotValidMovesNothing_data() {
  QTest::addColumn<bool>("scattered");
  QTest::newRow("too few pairs") << false;
  QTest::newRow("too large a residual") << true;
}

void CloudFollowerTest::WhatIsNotValidMovesNothing() {
  QFETCH(bool, scattered);
  const int springs = static_cast<int>(registration::Method::springs);
  Tracker one = tracker(springs), another = tracker(springs);
  const OverlayFrame before = one.follow(cloud(0.5, 1), 0, 0.0, kSteps);
  another.follow(cloud(0.5, 1), 0, 0.0, kSteps);
  LabelledCloud poor = moved(cloud(0.5, 3), {0.0, 0.0, -6e-3});
  if (scattered) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 12e-3);
    for (int i = 0; i < poor.size(); ++i) poor.points(i, 2) += noise(random);
  } else {  // enough points, of which a few lie each somewhere else
    const int every = poor.size() / 36;
    for (int i = 0; i < 36; ++i) poor.points.row(i) = poor.points.row(i * every).eval();
    for (int k = 0; k < 8; ++k) poor.points.row(4 * k) *= 0.5 + 0.05 * k;
    poor.points.conservativeResize(36, 3);
    poor.features.assign(36, Feature::surface);
  }
  const OverlayFrame told = one.follow(poor, 1, 1.0 / 30.0, kSteps);
  QVERIFY2(told.validity == (scattered ? Validity::residual_too_large : Validity::too_few_points),
           qPrintable(QString("%1, %2 pairs, %3 mm")
                          .arg(validity_code(told.validity))
                          .arg(told.pairs)
                          .arg(1e3 * told.residual)));
  QVERIFY(told.nodes_in_camera == before.nodes_in_camera);
  QVERIFY(one.follow(cloud(0.6, 2), 2, 2.0 / 30.0, kSteps).nodes_in_camera ==
          another.follow(cloud(0.6, 2), 2, 2.0 / 30.0, kSteps).nodes_in_camera);
}

void CloudFollowerTest::PointsWithoutDepthAreLeftOut() {
  QFETCH(int, method);
  const LabelledCloud right = cloud(0.5, 1);
  LabelledCloud with_zeros = right;
  with_zeros.points.conservativeResize(right.size() + 100, 3);
  with_zeros.points.bottomRows(100).setZero();
  with_zeros.features.resize(static_cast<std::size_t>(with_zeros.size()), Feature::surface);
  Tracker one = tracker(method), another = tracker(method);
  const OverlayFrame overlay = one.follow(with_zeros, 0, 0.0, kSteps);
  QVERIFY2(overlay.validity == Validity::valid, validity_code(overlay.validity));
  QVERIFY(overlay.nodes_in_camera == another.follow(right, 0, 0.0, kSteps).nodes_in_camera);
}

QTEST_GUILESS_MAIN(CloudFollowerTest)
#include "cloud_follower_test.moc"
