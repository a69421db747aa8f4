// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/evaluate.h"

#include <QTest>

#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

/// A square at z = 0.1 m, two triangles.
TriangleMesh square() {
  TriangleMesh mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << -0.05, -0.05, 0.1, 0.05, -0.05, 0.1, 0.05, 0.05, 0.1, -0.05, 0.05, 0.1;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3;
  return mesh;
}

Camera camera() {
  Camera result;
  result.width = 64;
  result.height = 48;
  result.matrix << 60, 0, 32, 0, 60, 24, 0, 0, 1;
  return result;
}

/// Points off z = 0.1 by the offsets.
LabelledCloud cloud_at(const std::vector<double>& offsets) {
  LabelledCloud cloud;
  cloud.points.resize(static_cast<Eigen::Index>(offsets.size()), 3);
  for (std::size_t i = 0; i < offsets.size(); ++i)
    cloud.points.row(static_cast<Eigen::Index>(i)) << 0.0, 0.0, 0.1 + offsets[i];
  return cloud;
}

}  // namespace

class EvaluateTest : public QObject {
  Q_OBJECT

 private slots:
  void DistancesToASurfaceAreTheOffsets() {
    const CloudErrors errors = cloud_errors(cloud_at({0.001, -0.002, 0.003}), square());
    QCOMPARE(errors.distance.count, 3);
    QVERIFY(std::abs(errors.distance.mean - 0.002) < 1e-12);
    QVERIFY(std::abs(errors.distance.maximum - 0.003) < 1e-12);
  }

  void BiasIsPositiveBeyondTheSurface() {
    QVERIFY(std::abs(cloud_errors(cloud_at({0.001, 0.001, -0.002}), square()).bias - 0.001) < 1e-12);
    QVERIFY(std::abs(cloud_errors(cloud_at({-0.001, -0.001, 0.002}), square()).bias + 0.001) < 1e-12);
    const std::vector<float> depth(64 * 48, 0.1F);
    QVERIFY(std::abs(cloud_errors(cloud_at({0.001, 0.001, -0.002}), camera(), depth).bias - 0.001) < 1e-7);
  }

  void DepthMapIsReadAtThePointsPixelAlongItsRay() {
    // A slanted plane: inverse depth is linear in the picture, so interpolation is exact.
    const Camera view = camera();
    const Eigen::Vector3d normal = Eigen::Vector3d(0.3, 0.2, -1.0).normalized(), at(0, 0, 0.1);
    std::vector<float> depth;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        depth.push_back(static_cast<float>(
            at.dot(normal) / view.ray({static_cast<double>(x), static_cast<double>(y)}).dot(normal)));
    LabelledCloud cloud;
    cloud.points.resize(1, 3);
    const Eigen::Vector3d ray = view.ray({20.3, 30.7});
    const Eigen::Vector3d true_point = ray * (at.dot(normal) / ray.dot(normal));
    cloud.points.row(0) = (true_point + 0.002 * ray.normalized()).transpose();
    const CloudErrors errors = cloud_errors(cloud, view, depth);
    QVERIFY(std::abs(errors.bias - 0.002) < 1e-6);
    QVERIFY(std::abs(errors.distance.maximum - 0.002) < 1e-6);
  }

  void PointsWithoutTruthAreCountedNotMeasured() {
    std::vector<float> depth(64 * 48, 0.0F);
    LabelledCloud cloud = cloud_at({0.001, 0.001});
    cloud.points.row(1) << 10.0, 0.0, 0.1;  // outside the picture
    QCOMPARE(cloud_errors(cloud, camera(), depth).without_truth, 2);
    depth.assign(depth.size(), 0.1F);
    const CloudErrors errors = cloud_errors(cloud, camera(), depth);
    QCOMPARE(errors.without_truth, 1);
    QCOMPARE(errors.distance.count, 1);
  }

  void NormalisedErrorIsOneForGaussianErrorsOfThatSigma() {
    std::mt19937 random(5);  // NOLINT: the same numbers on every run
    std::normal_distribution<double> gauss(0.0, 0.0007);
    std::vector<double> offsets(20000);
    for (double& offset : offsets) offset = gauss(random);
    LabelledCloud cloud = cloud_at(offsets);
    cloud.sigma.assign(offsets.size(), 0.0007);
    QVERIFY(std::abs(cloud_errors(cloud, square()).normalised - 1.0) < 0.05);
    cloud.sigma.assign(offsets.size(), 0.0014);
    QVERIFY(std::abs(cloud_errors(cloud, square()).normalised - 0.25) < 0.02);
  }

  void TruthOfAnotherShapeIsRefused() {
    QVERIFY_THROWS_EXCEPTION(PreconditionError, cloud_errors(cloud_at({0.0}), TriangleMesh{}));
    QVERIFY_THROWS_EXCEPTION(PreconditionError,
                             cloud_errors(cloud_at({0.0}), camera(), std::vector<float>(10, 0.1F)));
  }
};

QTEST_APPLESS_MAIN(EvaluateTest)
#include "evaluate_test.moc"
