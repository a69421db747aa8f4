// SPDX-License-Identifier: GPL-3.0-or-later
// Ways along the edges of a box: round the corner where the edge goes, not straight over the faces.
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/ridge_way.h"
#include "glisson/geometry/sharpness.h"

namespace glisson {

class RidgeWayTest : public QObject {
  Q_OBJECT
 private slots:
  void AnEdgeIsSharpAndAFaceIsNot();
  void AHollowIsNoRidge();
  void AWayKeepsToTheEdge();
  void WithoutARidgeThePointStays();
  void NoSurfaceIsRefused();

 private:
  static TriangleMesh box() {
    TriangleMesh mesh;
    mesh.vertices.resize(8, 3);
    for (int v = 0; v < 8; ++v) mesh.vertices.row(v) << 0.1 * (v & 1), 0.05 * (v >> 1 & 1), 0.1 * (v >> 2);
    mesh.triangles.resize(12, 3);
    mesh.triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6,
        2, 1, 3, 7, 1, 7, 5;
    return mesh;
  }
};

void RidgeWayTest::AnEdgeIsSharpAndAFaceIsNot() {
  const TriangleMesh fine = refined(box(), 0.004);
  const std::vector<double> sharp = Sharpness(fine).value();
  for (int v = 0; v < fine.vertex_count(); ++v) {
    const Eigen::Vector3d p = fine.vertex(v);
    const bool inside_face = p.x() > 0.02 && p.x() < 0.08 && p.z() > 0.02 && p.z() < 0.08;
    if (inside_face) QVERIFY(std::abs(sharp[static_cast<std::size_t>(v)]) < 1e-9);
    const bool on_edge = p.y() < 1e-9 && p.z() < 1e-9 && p.x() > 0.02 && p.x() < 0.08;
    // Two planes at right angles: 1 - cos 45 degrees, where both halves of the patch are as large.
    if (on_edge) QVERIFY(std::abs(sharp[static_cast<std::size_t>(v)] - (1.0 - std::sqrt(0.5))) < 0.05);
  }
}

void RidgeWayTest::AHollowIsNoRidge() {
  TriangleMesh inside_out = box();
  inside_out.triangles.col(1).swap(inside_out.triangles.col(2));
  const Sharpness sharpness(refined(inside_out, 0.004));
  for (const double sharp : sharpness.value()) QVERIFY(sharp < 1e-9);
}

void RidgeWayTest::AWayKeepsToTheEdge() {
  const RidgeWays ways(box());
  // Diagonally over the lower face it would be 28 mm shorter.
  const Eigen::Vector3d from(0.01, 0.0, 0.0), to(0.1, 0.0, 0.09);
  const Points way = ways.between(from, to);
  QVERIFY((way.row(0).transpose() - from).norm() < 1e-12);
  QVERIFY((way.row(way.rows() - 1).transpose() - to).norm() < 1e-12);
  for (Eigen::Index k = 0; k < way.rows(); ++k) {
    const double from_first = std::hypot(way(k, 1), way(k, 2)),
                 from_second = std::hypot(way(k, 0) - 0.1, way(k, 1));
    QVERIFY(std::min(from_first, from_second) < 0.006);
  }
  for (const double distance : distances_to_surface(way, box())) QVERIFY(distance < 1e-9);
  // Beside the edge a hand takes the edge.
  const Eigen::Vector3d taken = ways.onto_ridge({0.05, 0.0, 0.005}, 0.008);
  QVERIFY(taken.tail(2).norm() < 1e-9 && std::abs(taken.x() - 0.05) < 0.006);
}

void RidgeWayTest::WithoutARidgeThePointStays() {
  const RidgeWays ways(box());
  const Eigen::Vector3d middle(0.05, -0.001, 0.05);
  QVERIFY((ways.onto_ridge(middle, 0.008) - Eigen::Vector3d(0.05, 0.0, 0.05)).norm() < 1e-9);
}

void RidgeWayTest::NoSurfaceIsRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, RidgeWays{TriangleMesh{}});
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::RidgeWayTest)
#include "ridge_way_test.moc"
