// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/ray_caster.h"

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

StereoRig distorted_rig() {
  StereoRig rig;
  rig.left.width = rig.right.width = 160;
  rig.left.height = rig.right.height = 120;
  rig.left.matrix << 120.0, 0.0, 81.0, 0.0, 121.0, 58.0, 0.0, 0.0, 1.0;
  rig.right.matrix << 118.0, 0.0, 78.0, 0.0, 119.0, 61.0, 0.0, 0.0, 1.0;
  rig.left.distortion << -0.25, 0.08, 0.002, -0.003, 0.0;
  rig.right.distortion << -0.22, 0.06, -0.002, 0.001, 0.0;
  rig.right_from_left.rotation = Eigen::AngleAxisd(0.03, Eigen::Vector3d::UnitY()).toRotationMatrix();
  rig.right_from_left.translation = Eigen::Vector3d(-0.005, 0.0002, 0.0001);
  return rig;
}

TriangleMesh plate(double z, double tilt) {
  TriangleMesh mesh;
  mesh.vertices.resize(4, 3);
  mesh.vertices << -1, -1, z - tilt, 1, -1, z + tilt, 1, 1, z + tilt, -1, 1, z - tilt;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 2, 1, 0, 3, 2;
  return mesh;
}

}  // namespace

class RayCasterTest : public QObject {
  Q_OBJECT
 private slots:
  void PlaneDepthIsAnalyticThroughADistortingLens() {
    const StereoRig rig = distorted_rig();
    const double z = 0.1, tilt = 0.3;  // depth = z + tilt x: a plane that leans
    const RayCaster caster(plate(z, tilt));
    const std::vector<float> depth = caster.organ_depth(left_rays(rig));
    double largest = 0.0;
    for (int v = 0; v < rig.left.height; ++v)
      for (int u = 0; u < rig.left.width; ++u) {
        const double ray_x = rig.left.ray({u, v}).x();
        const double expected = z / (1.0 - tilt * ray_x);
        largest = std::max(largest, std::abs(depth[static_cast<std::size_t>(v * 160 + u)] - expected));
      }
    QVERIFY2(largest < 1e-6, qPrintable(QString::number(largest)));
  }

  void TheHitProjectsBackOntoItsPixelInBothCameras() {
    const StereoRig rig = distorted_rig();
    const RayCaster caster(plate(0.09, 0.2));
    for (const bool left : {true, false}) {
      const RayTable rays = left ? left_rays(rig) : right_rays(rig);
      const Camera& camera = left ? rig.left : rig.right;
      double largest = 0.0;
      for (int v = 0; v < 120; v += 7)
        for (int u = 0; u < 160; u += 7) {
          const Eigen::Vector3f& ray = rays.directions[static_cast<std::size_t>(v * 160 + u)];
          const RayHit hit = caster.cast(rays.origin, ray);
          QVERIFY(hit.thing == RayHit::Thing::organ);
          Eigen::Vector3d p = (rays.origin + hit.parameter * ray).cast<double>();
          if (!left) p = rig.right_from_left.rotation * p + rig.right_from_left.translation;
          largest = std::max(largest, (camera.project(p) - Eigen::Vector2d(u, v)).norm());
        }
      QVERIFY2(largest < 2e-3, qPrintable(QString::number(largest)));
    }
  }

  void SphereDepthIsAnalytic() {
    const StereoRig rig = distorted_rig();
    const Eigen::Vector3d centre(0.005, -0.003, 0.1);
    const double radius = 0.03;
    TriangleMesh sphere = test::liver_surface(200);
    for (int v = 0; v < sphere.vertex_count(); ++v) {
      // the same net, put on a sphere
      const int around = 400, last = sphere.vertex_count() - 1;
      const double theta = v == 0 ? 0.0 : v == last ? M_PI : M_PI * ((v - 1) / around + 1) / 200;
      const double phi = 2.0 * M_PI * ((v - 1) % around) / around;
      sphere.vertices.row(v) =
          (centre + radius * Eigen::Vector3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                             std::cos(theta)))
              .transpose();
    }
    const RayCaster caster(sphere);
    const std::vector<float> depth = caster.organ_depth(left_rays(rig));
    int hits = 0;
    for (int v = 0; v < 120; ++v)
      for (int u = 0; u < 160; ++u) {
        const Eigen::Vector3d ray = rig.left.ray({u, v});
        const double b = ray.dot(centre), a = ray.squaredNorm();
        const double root = b * b - a * (centre.squaredNorm() - radius * radius);
        const float got = depth[static_cast<std::size_t>(v * 160 + u)];
        if (root < -1e-6) QCOMPARE(got, 0.0F);
        if (root < 1e-5) continue;  // grazing: the polygon lies inside the sphere
        ++hits;
        QVERIFY(std::abs(got - (b - std::sqrt(root)) / a) < 2e-5);
      }
    QVERIFY(hits > 1000);
  }

  void AMovedOrganIsHitWhereItIsNow() {
    const StereoRig rig = distorted_rig();
    TriangleMesh mesh = plate(0.1, 0.0);
    RayCaster caster(mesh);
    mesh.vertices.col(2).array() += 0.02;
    caster.move_organ(mesh.vertices);
    const std::vector<float> depth = caster.organ_depth(left_rays(rig));
    QVERIFY(std::abs(depth[60 * 160 + 80] - 0.12F) < 1e-6F);
  }

  void TheNearerOfOrganAndWallIsMet() {
    RayCaster caster(plate(0.1, 0.0));
    caster.set_wall(plate(0.2, 0.0));
    QVERIFY(caster.cast(Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ()).thing == RayHit::Thing::organ);
    caster.set_wall(plate(0.05, 0.0));  // replaces the first
    QVERIFY(caster.cast(Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ()).thing == RayHit::Thing::wall);
    QVERIFY(caster.cast(Eigen::Vector3f::Zero(), -Eigen::Vector3f::UnitZ()).thing == RayHit::Thing::nothing);
    QVERIFY(!caster.sees(Eigen::Vector3d::Zero(), {0.0, 0.0, 0.1}));
    QVERIFY(caster.sees(Eigen::Vector3d::Zero(), {0.0, 0.0, 0.05}));
  }

  void BarycentricWeightsGiveThePointMet() {
    const TriangleMesh mesh = plate(0.1, 0.3);
    const RayCaster caster(mesh);
    const Eigen::Vector3f ray(0.2F, -0.3F, 1.0F);
    const RayHit hit = caster.cast(Eigen::Vector3f::Zero(), ray);
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      p += static_cast<double>(hit.barycentric[k]) * mesh.vertex(mesh.triangles(hit.triangle, k));
    QVERIFY((p - (hit.parameter * ray).cast<double>()).norm() < 1e-6);
  }

  void AnEmptyOrganThrows() { QVERIFY_THROWS_EXCEPTION(PreconditionError, RayCaster(TriangleMesh{})); }
  void AnIndexBeyondTheVerticesThrows() {
    TriangleMesh mesh = plate(0.1, 0.0);
    mesh.triangles(0, 0) = 4;
    QVERIFY_THROWS_EXCEPTION(PreconditionError, RayCaster{mesh});
  }
  void AMoveWithOtherVerticesThrows() {
    RayCaster caster(plate(0.1, 0.0));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, caster.move_organ(Points::Zero(3, 3)));
  }
};

QTEST_APPLESS_MAIN(RayCasterTest)
#include "ray_caster_test.moc"
