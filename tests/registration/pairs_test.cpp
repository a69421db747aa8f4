// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "glisson/core/error.h"
#include "glisson/registration/pairs.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

class PairsTest : public QObject {
  Q_OBJECT
 private slots:
  void LabelledPointsGoToTheirPartOnly();
  void NotchPointsGoTogetherToTheCarriedLandmark();
  void WithoutALandmarkTheWholeSurfaceServes();
  void RefittedTreesFindWhatBruteForceFinds();
  void FormerPairsHastenAndChangeNothing();
  void NormalsFollowTheSurface();
  void PairsAgainstTheNormalAreRefused();
  void LonelyOutliersAreRefusedAndALobeFarAwayIsNot();
  void DenserCloudDoesNotWeighMore();
  void NotchWeighsByCount();
  void LargeCloudIsThinnedAndKeepsItsWeight();
  void ThinningKeepsRareLandmarks();
  void EstimatedNormalsFaceTheCamera();
  void UnusableCloudsAreRefused();
  void UnusableOptionsAreRefused();
  void WhatIsSeenIsWhatBruteForceFinds();
};

namespace {

LabelledCloud seen(const PatientModel& model, double share = 0.3, double density = 3.9) {
  phantom::PatchOptions options;
  options.share = share;
  options.density_per_cm2 = density;
  return phantom::patch(model, phantom::view().apply(model.mesh.vertices), options);
}

double total_weight(const PreparedCloud& cloud, Feature feature) {
  double sum = 0.0;
  for (int i = 0; i < cloud.cloud.size(); ++i)
    if (cloud.cloud.feature(i) == feature) sum += cloud.weight[static_cast<std::size_t>(i)];
  return sum;
}

}  // namespace

void PairsTest::LabelledPointsGoToTheirPartOnly() {
  const PatientModel model = phantom::model(10, 8, 4);
  MovingSurface surface(model);
  surface.move(phantom::view().apply(model.mesh.vertices));
  const PreparedCloud cloud = prepare_cloud(seen(model), {});
  std::set<int> part[3];
  for (const Feature feature : {Feature::surface, Feature::anterior_margin, Feature::umbilical_notch}) {
    const auto& triangles = surface.triangles(feature);
    part[static_cast<int>(feature) - 1].insert(triangles.begin(), triangles.end());
  }
  QVERIFY(part[1].size() > 10 && part[1].size() < part[0].size() / 3);
  QVERIFY(!part[2].empty() && part[2].size() < part[1].size());
  int labelled = 0;
  for (const Pair& pair : find_pairs(cloud, surface, {})) {
    QVERIFY(part[static_cast<int>(pair.feature) - 1].contains(pair.on_model.triangle));
    labelled += pair.feature != Feature::surface;
  }
  QVERIFY(labelled > 10);
}

void PairsTest::NotchPointsGoTogetherToTheCarriedLandmark() {
  const PatientModel model = phantom::model(10, 8, 4);
  const CameraFromCt pose = phantom::view();
  MovingSurface surface(model);
  surface.move(pose.apply(model.mesh.vertices));
  const LabelledCloud cloud = seen(model);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  int count = 0;
  for (int i = 0; i < cloud.size(); ++i)
    if (cloud.feature(i) == Feature::umbilical_notch) middle += cloud.points.row(i).transpose(), ++count;
  middle /= count;
  const Eigen::Vector3d landmark =
      (pose * Point<CtFrame>(model.landmarks.umbilical_notch.row(0).transpose())).xyz;
  int tested = 0;
  for (const Pair& pair : find_pairs(prepare_cloud(cloud, {}), surface, {})) {
    if (pair.feature != Feature::umbilical_notch) continue;
    QVERIFY((pair.on_model.point - landmark).norm() < 3e-3);  // the mesh cuts the notch's corner
    QVERIFY((pair.on_model.point + pair.gap - middle).norm() < 1e-12);
    ++tested;
  }
  QVERIFY(tested > 0 && tested == count);
}

void PairsTest::WithoutALandmarkTheWholeSurfaceServes() {
  PatientModel model = phantom::model(6, 5, 3);
  model.landmarks = {};
  const MovingSurface surface(model);
  QVERIFY(!surface.has(Feature::anterior_margin) && surface.has(Feature::surface));
  const Eigen::Vector3d p(0.03, 0.01, 0.2);
  QCOMPARE(surface.closest(Feature::anterior_margin, p).triangle,
           surface.closest(Feature::surface, p).triangle);
}

void PairsTest::RefittedTreesFindWhatBruteForceFinds() {
  const PatientModel model = phantom::model(6, 5, 3);
  MovingSurface surface(model);
  Points nodes = phantom::view(0.7).apply(model.mesh.vertices);
  for (Eigen::Index i = 0; i < nodes.rows(); ++i) nodes(i, 2) += 0.02 * std::sin(40.0 * nodes(i, 0));
  surface.move(nodes);
  const TriangleMesh& mesh = surface.mesh();
  for (int q = 0; q < 50; ++q) {
    const Eigen::Vector3d p(0.1 * std::sin(q), 0.1 * std::cos(1.7 * q), 0.1 + 0.05 * std::sin(0.3 * q));
    double best = std::numeric_limits<double>::infinity();
    for (const int t : surface.triangles(Feature::anterior_margin)) {
      const Eigen::Vector3d a = mesh.vertex(mesh.triangles(t, 0)), b = mesh.vertex(mesh.triangles(t, 1)),
                            c = mesh.vertex(mesh.triangles(t, 2)), w = closest_on_triangle(p, a, b, c);
      best = std::min(best, (w[0] * a + w[1] * b + w[2] * c - p).norm());
    }
    QVERIFY(std::abs(surface.closest(Feature::anterior_margin, p).distance - best) < 1e-12);
  }
}

void PairsTest::FormerPairsHastenAndChangeNothing() {
  const PatientModel model = phantom::model(10, 8, 4);
  MovingSurface surface(model);
  const PreparedCloud cloud = prepare_cloud(seen(model), {});
  surface.move(phantom::view(0.7).apply(model.mesh.vertices));
  const std::vector<Pair> before = find_pairs(cloud, surface, {});
  surface.move(phantom::view().apply(model.mesh.vertices));
  const std::vector<Pair> fresh = find_pairs(cloud, surface, {}),
                          again = find_pairs(cloud, surface, {}, before);
  int moved = 0;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    QCOMPARE(again[i].on_model.triangle, fresh[i].on_model.triangle);
    QVERIFY(again[i].gap == fresh[i].gap && again[i].normal == fresh[i].normal);
    QCOMPARE(again[i].kept, fresh[i].kept);
    moved += before[i].on_model.triangle != fresh[i].on_model.triangle;
  }
  QVERIFY(moved > 100);
  const std::vector<Pair> too_few(before.begin(), before.end() - 1);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, find_pairs(cloud, surface, {}, too_few));
}

void PairsTest::NormalsFollowTheSurface() {
  // The organ is turned as a whole: its normals turn with it, whether they are asked for before or after.
  const PatientModel model = phantom::model(6, 5, 3);
  const CameraFromCt pose = phantom::view();
  MovingSurface still(model), moved(model);
  NormalMemo memo;
  for (int t = 0; t < moved.mesh().triangle_count(); ++t) {
    const ClosestPoint corner{t, Eigen::Vector3d::UnitX(), moved.mesh().vertex(moved.mesh().triangles(t, 0)),
                              0.0};
    QVERIFY(moved.normal(corner, memo) == moved.normal(corner));
  }
  moved.move(pose.apply(model.mesh.vertices));
  for (int q = 0; q < 50; ++q) {
    const Eigen::Vector3d p(0.1 * std::sin(q), 0.1 * std::cos(1.7 * q), 0.05 * std::sin(0.3 * q));
    const ClosestPoint at = still.closest(Feature::surface, p);
    const Eigen::Vector3d expected = pose.rotation * still.normal(at);
    QVERIFY((moved.normal(at) - expected).norm() < 1e-12);
    // Remembered from query to query, and not beyond the next move.
    QVERIFY(moved.normal(at, memo) == moved.normal(at));
    QVERIFY(moved.normal(at, memo) == moved.normal(at));
    QVERIFY(std::abs(expected.norm() - 1.0) < 1e-12);
  }
}

void PairsTest::PairsAgainstTheNormalAreRefused() {
  const PatientModel model = phantom::model(10, 8, 4);
  MovingSurface surface(model);
  surface.move(phantom::view().apply(model.mesh.vertices));
  LabelledCloud cloud = seen(model);
  cloud.features.clear();
  for (int i = 0; i < 40; ++i) cloud.normals.row(i) *= -1.0;
  const std::vector<Pair> pairs = find_pairs(prepare_cloud(cloud, {}), surface, {});
  int kept = 0;
  for (int i = 0; i < 40; ++i) QVERIFY(!pairs[static_cast<std::size_t>(i)].kept);
  for (std::size_t i = 40; i < pairs.size(); ++i) kept += pairs[i].kept;
  QVERIFY(kept > 0.9 * static_cast<double>(pairs.size() - 40));
}

void PairsTest::LonelyOutliersAreRefusedAndALobeFarAwayIsNot() {
  const PatientModel model = phantom::model(10, 8, 4);
  MovingSurface surface(model);
  surface.move(phantom::view().apply(model.mesh.vertices));
  LabelledCloud cloud = seen(model);
  cloud.features.clear();
  cloud.normals.resize(0, 3);
  // One side lifted by up to 30 mm towards the camera, smoothly; every fiftieth point is noise.
  for (int i = 0; i < cloud.size(); ++i) cloud.points(i, 2) -= std::max(0.0, 0.5 * cloud.points(i, 0));
  for (int i = 0; i < cloud.size(); i += 50) cloud.points(i, 2) -= 0.03;
  const std::vector<Pair> pairs = find_pairs(prepare_cloud(cloud, {}), surface, {});
  int kept_lobe = 0, lobe = 0;
  for (int i = 0; i < cloud.size(); ++i) {
    const Pair& pair = pairs[static_cast<std::size_t>(i)];
    if (i % 50 == 0) {
      QVERIFY(!pair.kept);
    } else if (cloud.points(i, 0) > 0.03) {
      ++lobe;
      kept_lobe += pair.kept;
    }
  }
  QVERIFY(lobe > 50);
  QVERIFY(kept_lobe > 0.9 * lobe);
}

void PairsTest::DenserCloudDoesNotWeighMore() {
  const PatientModel model = phantom::model(10, 8, 4);
  const PreparedCloud thin = prepare_cloud(seen(model, 0.3, 2.0), {});
  const PreparedCloud dense = prepare_cloud(seen(model, 0.3, 6.0), {});
  QVERIFY(dense.cloud.size() > 2.5 * thin.cloud.size());
  const double surface = total_weight(dense, Feature::surface) / total_weight(thin, Feature::surface);
  const double margin =
      total_weight(dense, Feature::anterior_margin) / total_weight(thin, Feature::anterior_margin);
  QVERIFY2(surface > 0.8 && surface < 1.25, qPrintable(QString::number(surface)));
  QVERIFY2(margin > 0.6 && margin < 2.1, qPrintable(QString::number(margin)));
  // What the points of the reference density would weigh: one each.
  const double area = 1e4 * phantom::PatchOptions{}.share * glisson::area(model.surface.mesh);
  QVERIFY(std::abs(total_weight(dense, Feature::surface) / (3.9 * area) - 1.0) < 0.35);
}

void PairsTest::NotchWeighsByCount() {
  const PatientModel model = phantom::model(10, 8, 4);
  LabelledCloud cloud = seen(model);
  for (int i = 0; i < cloud.size(); ++i)
    cloud.features[static_cast<std::size_t>(i)] = i < 2 ? Feature::umbilical_notch : Feature::surface;
  QCOMPARE(total_weight(prepare_cloud(cloud, {}), Feature::umbilical_notch), 2.0);
  for (int i = 0; i < 40; ++i) cloud.features[static_cast<std::size_t>(i)] = Feature::umbilical_notch;
  QVERIFY(std::abs(total_weight(prepare_cloud(cloud, {}), Feature::umbilical_notch) - 3.9) < 1e-9);
}

void PairsTest::LargeCloudIsThinnedAndKeepsItsWeight() {
  const PatientModel model = phantom::model(10, 8, 4);
  const LabelledCloud cloud = seen(model, 0.3, 6.0);
  CloudOptions few;
  few.maximum_points = 300;
  const PreparedCloud thinned = prepare_cloud(cloud, few), whole = prepare_cloud(cloud, {});
  QVERIFY(thinned.cloud.size() >= 300 && thinned.cloud.size() <= 310);  // and a few points of landmarks
  const double ratio = total_weight(thinned, Feature::surface) / total_weight(whole, Feature::surface);
  QVERIFY2(ratio > 0.8 && ratio < 1.3, qPrintable(QString::number(ratio)));
}

void PairsTest::ThinningKeepsRareLandmarks() {
  // Thousands of points of the surface, one after the other, and few of the landmarks at one place of the
  // list.
  LabelledCloud cloud;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.1, 0.1);
  for (int i = 0; i < 9000; ++i) {
    cloud.features.push_back(i >= 4003 && i < 4011   ? Feature::umbilical_notch
                             : i >= 6002 && i < 6005 ? Feature::anterior_margin
                                                     : Feature::surface);
    cloud.looks.push_back(i < 4007 ? 0 : 1);
  }
  cloud.points.resize(9000, 3);
  for (double& coordinate : cloud.points.reshaped()) coordinate = place(random);
  cloud.eyes = Points::Zero(2, 3);
  CloudOptions few;
  few.maximum_points = 500;
  const PreparedCloud thinned = prepare_cloud(cloud, few);
  const auto count = [&](Feature feature, int look) {
    int found = 0;
    for (int i = 0; i < thinned.cloud.size(); ++i)
      found += thinned.cloud.feature(i) == feature && thinned.cloud.look(i) == look;
    return found;
  };
  QCOMPARE(count(Feature::umbilical_notch, 0), 4);
  QCOMPARE(count(Feature::umbilical_notch, 1), 4);
  QCOMPARE(count(Feature::anterior_margin, 1), 3);
  QVERIFY(thinned.cloud.size() <= 515);
}

void PairsTest::EstimatedNormalsFaceTheCamera() {
  const PatientModel model = phantom::model(14, 12, 5);
  const LabelledCloud cloud = seen(model);
  const Points normals = estimate_normals(prepare_cloud(cloud, {}));
  int like_the_truth = 0;
  for (int i = 0; i < cloud.size(); ++i) {
    QVERIFY(normals.row(i).dot(cloud.points.row(i)) <= 0.0);
    like_the_truth += normals.row(i).dot(cloud.normals.row(i)) > 0.8;
  }
  QVERIFY(like_the_truth > 0.85 * cloud.size());
}

void PairsTest::UnusableCloudsAreRefused() {
  const PatientModel model = phantom::model(6, 5, 3);
  LabelledCloud cloud = seen(model);
  LabelledCloud few = cloud;
  few.points.conservativeResize(9, 3);
  few.normals.resize(0, 3);
  few.features.clear();
  QVERIFY_THROWS_EXCEPTION(InputError, prepare_cloud(few, {}));
  LabelledCloud broken = cloud;
  broken.points(5, 1) = std::numeric_limits<double>::quiet_NaN();
  QVERIFY_THROWS_EXCEPTION(InputError, prepare_cloud(broken, {}));
  LabelledCloud short_labels = cloud;
  short_labels.features.pop_back();
  QVERIFY_THROWS_EXCEPTION(InputError, prepare_cloud(short_labels, {}));
  LabelledCloud short_normals = cloud;
  short_normals.normals.conservativeResize(3, 3);
  QVERIFY_THROWS_EXCEPTION(InputError, prepare_cloud(short_normals, {}));
}

void PairsTest::UnusableOptionsAreRefused() {
  CloudOptions().validate();
  PairOptions().validate();
  const auto cloud_refuses = [](const std::function<void(CloudOptions&)>& change) {
    CloudOptions options;
    change(options);
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  };
  cloud_refuses([](CloudOptions& o) { o.reference_density_per_cm2 = 0.0; });
  cloud_refuses([](CloudOptions& o) { o.maximum_points = 9; });
  cloud_refuses([](CloudOptions& o) { o.neighbours = 0; });
  const auto pairs_refuse = [](const std::function<void(PairOptions&)>& change) {
    PairOptions options;
    change(options);
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  };
  pairs_refuse([](PairOptions& o) { o.minimum_normal_cosine = 1.5; });
  pairs_refuse([](PairOptions& o) { o.outlier_deviations = 0.0; });
  pairs_refuse([](PairOptions& o) { o.outlier_floor = -1.0; });
}

/// To the bit, on both sides of zero and a little within and beyond the limit.
void PairsTest::WhatIsSeenIsWhatBruteForceFinds() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-0.05, 0.05);
  Points cloud(300, 3);
  for (Eigen::Index i = 0; i < cloud.rows(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      cloud(i, axis) =
          i % 2 == 0 ? anywhere(random) : kSeenWithin * std::round(anywhere(random) / kSeenWithin);
  const auto is_near = [&](const Eigen::RowVector3d& at) {
    return (cloud.rowwise() - at).rowwise().squaredNorm().minCoeff() < kSeenWithin * kSeenWithin;
  };
  const SeenPlaces places(cloud);
  int seen_count = 0;
  for (int n = 0; n < 3000; ++n) {
    Eigen::RowVector3d at;
    for (int axis = 0; axis < 3; ++axis) at[axis] = anywhere(random);
    if (n % 3 == 0)  // away from one point by about the limit
      at = cloud.row(n % cloud.rows()) +
           (n % 2 == 0 ? 1.0 - 1e-9 : 1.0 + 1e-9) * kSeenWithin * Eigen::RowVector3d::Unit(n / 3 % 3);
    QCOMPARE(places.is_seen(at), is_near(at));
    seen_count += is_near(at) ? 1 : 0;
  }
  QVERIFY(seen_count > 300 && seen_count < 2700);
  TriangleMesh surface = phantom::model(10, 8, 4).surface.mesh;
  surface.vertices.rowwise() -= surface.vertices.colwise().mean().eval();
  const Eigen::VectorXd areas = vertex_areas(surface);
  double seen_area = 0.0;
  for (int v = 0; v < surface.vertex_count(); ++v)
    if (is_near(surface.vertices.row(v))) seen_area += areas[v];
  QVERIFY(seen_area > 0.0 && seen_area < areas.sum());
  QVERIFY(seen_share(surface, cloud) == seen_area / areas.sum());
  QVERIFY(!SeenPlaces(Points(0, 3)).is_seen(Eigen::RowVector3d::Zero()));
}

QTEST_APPLESS_MAIN(PairsTest)
#include "pairs_test.moc"
