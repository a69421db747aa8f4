// SPDX-License-Identifier: GPL-3.0-or-later
// Where a vein enters the liver: neither what lies along the liver outside nor how far it is drawn within
// moves it.
#include <QtTest>

#include <cmath>
#include <numbers>

#include "glisson/atlas/member.h"
#include "glisson/patient/label_map.h"
#include "shapes.h"

using namespace glisson;
using namespace glisson::atlas;

namespace {

constexpr double kLiver = 0.07, kVein = 0.006;  // metres, radii
constexpr int kAround = 16;

/// An open tube about a line in the plane z = 0.
TriangleMesh tube(const std::vector<Eigen::Vector3d>& line) {
  TriangleMesh mesh;
  const auto count = static_cast<int>(line.size());
  mesh.vertices.resize(count * kAround, 3);
  mesh.triangles.resize(2 * (count - 1) * kAround, 3);
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d along = (line[std::min(i + 1, count - 1)] - line[std::max(i - 1, 0)]).normalized();
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ(), side = up.cross(along);
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kAround;
      mesh.vertices.row(i * kAround + k) =
          (line[static_cast<std::size_t>(i)] + kVein * (std::cos(angle) * side + std::sin(angle) * up))
              .transpose();
    }
  }
  int t = 0;
  for (int i = 0; i + 1 < count; ++i)
    for (int k = 0; k < kAround; ++k) {
      const int a = i * kAround + k, b = i * kAround + (k + 1) % kAround;
      mesh.triangles.row(t++) << a, b, a + kAround;
      mesh.triangles.row(t++) << b, b + kAround, a + kAround;
    }
  return mesh;
}

/// From within the liver straight out at its front (0, kLiver, 0), and then along its surface.
TriangleMesh vein(double within, double along) {
  constexpr double kStep = 0.002, kOff = kLiver + kVein + 0.002;
  std::vector<Eigen::Vector3d> line;
  for (double y = kLiver - within; y < kOff; y += kStep) line.emplace_back(0.0, y, 0.0);
  for (double way = kStep; way <= along; way += kStep)
    line.emplace_back(kOff * std::sin(way / kOff), kOff * std::cos(way / kOff), 0.0);
  return tube(line);
}

Eigen::Vector3d entrance(const TriangleMesh& portal) {
  PatientModel model;
  model.surfaces.push_back({structure::kParenchyma, "liver", test::sphere(kLiver, 5)});
  model.surfaces.push_back({structure::kPortalVein, "portal vein", portal});
  return member_of("liver", model, {}).structures.at(Structure::portal_entrance).row(0).transpose();
}

}  // namespace

class EntranceTest : public QObject {
  Q_OBJECT
 private slots:
  void ItIsWhereTheVeinCrossesTheHull_data() {
    QTest::addColumn<double>("within");
    QTest::addColumn<double>("along");
    QTest::newRow("short") << 0.02 << 0.0;
    QTest::newRow("drawn far within") << 0.06 << 0.0;
    QTest::newRow("lies along the liver") << 0.02 << 0.06;
    QTest::newRow("both") << 0.06 << 0.06;
  }
  void ItIsWhereTheVeinCrossesTheHull() {
    QFETCH(double, within);
    QFETCH(double, along);
    const double off = (entrance(vein(within, along)) - Eigen::Vector3d(0.0, kLiver, 0.0)).norm();
    QVERIFY2(off < 0.004, qPrintable(QString::number(off)));
  }

  /// A vein that only touches comes in nowhere: then where it touches is all there is.
  void AVeinThatOnlyTouchesHasItsContact() {
    std::vector<Eigen::Vector3d> line;
    for (double x = -0.02; x <= 0.02; x += 0.002) line.emplace_back(x, kLiver + kVein + 0.001, 0.0);
    QVERIFY((entrance(tube(line)) - Eigen::Vector3d(0.0, kLiver, 0.0)).norm() < 0.004);
  }
};

QTEST_APPLESS_MAIN(EntranceTest)
#include "entrance_test.moc"
