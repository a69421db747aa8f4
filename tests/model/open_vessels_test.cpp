// SPDX-License-Identifier: GPL-3.0-or-later
// Vessel surfaces with holes: what the voxels of their trees are.
#include <QTest>
#include <algorithm>
#include <numbers>

#include "anatomy.h"
#include "close_holes.h"
#include "shapes.h"

using namespace glisson;

namespace {

const Eigen::Vector3d kFrom(-0.035, -0.02, -0.03), kTo(0.03, 0.025, 0.035);
const Eigen::Vector3d kFork = 0.4 * kFrom + 0.6 * kTo, kTip(0.005, 0.04, -0.02);  // of a branch
constexpr double kRadius = 0.006, kThin = 0.003;

/// A tube along a line, `around` corners, flat ends that are there or not.
TriangleMesh tube(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, int along,
                  bool open_begin, bool open_end) {
  const int around = 24;
  const Eigen::Vector3d axis = (to - from).normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
  TriangleMesh mesh;
  mesh.vertices.resize((along + 1) * around + 2, 3);
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j < around; ++j) {
      const double angle = 2.0 * std::numbers::pi * j / around;
      mesh.vertices.row(i * around + j) =
          (from + (to - from) * i / along + radius * (std::cos(angle) * u + std::sin(angle) * v)).transpose();
      const int next = (j + 1) % around, a = i * around + j, b = i * around + next;
      if (i < along) {
        triangles.emplace_back(a, b, b + around);
        triangles.emplace_back(a, b + around, a + around);
      }
      const int middle = (along + 1) * around;
      if (i == 0 && !open_begin) triangles.emplace_back(b, a, middle);
      if (i == along && !open_end) triangles.emplace_back(a, b, middle + 1);
    }
  mesh.vertices.row((along + 1) * around) = from.transpose();
  mesh.vertices.row((along + 1) * around + 1) = to.transpose();
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
  return mesh;
}

bool is_in_tube(const Eigen::Vector3d& p, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                double radius) {
  const Eigen::Vector3d axis = (to - from).normalized();
  const double at = (p - from).dot(axis);
  return at > 0.0 && at < (to - from).norm() && (p - from - at * axis).norm() < radius;
}

model::Anatomy anatomy_with(const TriangleMesh& vessel) {
  model::SurfaceSet set;
  set.liver = test::sphere(0.07, 4);
  set.others.push_back({structure::kPortalVein, "portal_vein", vessel});
  return *model::anatomy_of(set, {}, RunContext());
}

bool says_open(const model::Anatomy& anatomy) {
  return std::ranges::count(anatomy.notes, "vessels.open_surface portal_vein") == 1;
}

/// Voxels of the vessel that are not as they should be, over those that should be set.
template <class Truth>
double share_wrong(const model::Anatomy& anatomy, const Truth& truth) {
  if (anatomy.vessels.size() != 1) return 1.0;
  const model::VesselMask& mask = anatomy.vessels.front();
  double wrong = 0.0, set = 0.0;
  for (int k = 0; k < mask.grid.size.z(); ++k)
    for (int j = 0; j < mask.grid.size.y(); ++j)
      for (int i = 0; i < mask.grid.size.x(); ++i) {
        const bool inside = truth(mask.grid.p_in_ct({double(i), double(j), double(k)}).xyz);
        set += inside;
        wrong += inside != (mask.voxels[static_cast<std::size_t>(mask.grid.offset({i, j, k}))] != 0);
      }
  return wrong / set;
}

}  // namespace

class OpenVesselsTest : public QObject {
  Q_OBJECT
 private slots:
  void AnObliqueTubeThatIsCutOpenIsFilledToItsEnds_data();
  void AnObliqueTubeThatIsCutOpenIsFilledToItsEnds();
  void NothingIsFilledBesideAnOpenTrunk();
  void AHoleInTheWallIsClosed();
  void APatchTurnedRoundLeavesTheTubeFull();
  void AClosedSurfaceKeepsItsBits();
  void CapsMakeASurfaceClosed();
};

void OpenVesselsTest::AnObliqueTubeThatIsCutOpenIsFilledToItsEnds_data() {
  QTest::addColumn<bool>("begin");
  QTest::addColumn<bool>("end");
  QTest::newRow("closed") << false << false;
  QTest::newRow("one end") << true << false;
  QTest::newRow("both ends") << true << true;
}

void OpenVesselsTest::AnObliqueTubeThatIsCutOpenIsFilledToItsEnds() {
  QFETCH(bool, begin);
  QFETCH(bool, end);
  const model::Anatomy anatomy = anatomy_with(tube(kFrom, kTo, kRadius, 40, begin, end));
  const double wrong =
      share_wrong(anatomy, [](const Eigen::Vector3d& p) { return is_in_tube(p, kFrom, kTo, kRadius); });
  QVERIFY2(wrong < 0.03, qPrintable(QString::number(wrong)));
  QCOMPARE(says_open(anatomy), begin || end);
}

/// As a portal vein whose trunk is cut off: rows that came in through the trunk's end ran on to the branch.
void OpenVesselsTest::NothingIsFilledBesideAnOpenTrunk() {
  const TriangleMesh vessel =
      test::joined(tube(kFrom, kTo, kRadius, 40, true, true), tube(kFork, kTip, kThin, 30, true, true));
  const model::Anatomy anatomy = anatomy_with(vessel);
  const double wrong = share_wrong(anatomy, [](const Eigen::Vector3d& p) {
    return is_in_tube(p, kFrom, kTo, kRadius) || is_in_tube(p, kFork, kTip, kThin);
  });
  QVERIFY2(wrong < 0.04, qPrintable(QString::number(wrong)));
  QVERIFY(says_open(anatomy));
}

void OpenVesselsTest::AHoleInTheWallIsClosed() {
  TriangleMesh vessel = tube(kFrom, kTo, kRadius, 40, false, false);
  std::vector<int> kept;
  for (int t = 0; t < vessel.triangle_count(); ++t) {
    const Eigen::Vector3d middle =
        (vessel.vertex(vessel.triangles(t, 0)) + vessel.vertex(vessel.triangles(t, 1)) +
         vessel.vertex(vessel.triangles(t, 2))) /
        3.0;
    const Eigen::Vector3d place = vessel.vertex(20 * 24 + 5);
    if ((middle - place).norm() > 0.003) kept.push_back(t);
  }
  QVERIFY(static_cast<int>(kept.size()) < vessel.triangle_count());
  const model::Anatomy anatomy = anatomy_with(select_triangles(vessel, kept));
  const double wrong =
      share_wrong(anatomy, [](const Eigen::Vector3d& p) { return is_in_tube(p, kFrom, kTo, kRadius); });
  QVERIFY2(wrong < 0.04, qPrintable(QString::number(wrong)));
  QVERIFY(says_open(anatomy));
}

void OpenVesselsTest::APatchTurnedRoundLeavesTheTubeFull() {
  TriangleMesh vessel = tube(kFrom, kTo, kRadius, 40, false, false);
  for (int t = vessel.triangle_count() / 2; t < vessel.triangle_count() / 2 + 60; ++t)
    std::swap(vessel.triangles(t, 1), vessel.triangles(t, 2));
  QVERIFY(is_closed(vessel));
  const model::Anatomy anatomy = anatomy_with(vessel);
  const double wrong =
      share_wrong(anatomy, [](const Eigen::Vector3d& p) { return is_in_tube(p, kFrom, kTo, kRadius); });
  QVERIFY2(wrong < 0.04, qPrintable(QString::number(wrong)));
  QVERIFY(says_open(anatomy));
}

void OpenVesselsTest::AClosedSurfaceKeepsItsBits() {
  TriangleMesh vessel = test::torus(0.02, 0.005, 40, 20);
  const TriangleMesh before = vessel;
  QVERIFY(!model::close_holes(vessel));
  QVERIFY(vessel.vertices == before.vertices);
  QVERIFY(vessel.triangles == before.triangles);
}

void OpenVesselsTest::CapsMakeASurfaceClosed() {
  const TriangleMesh whole = tube(kFrom, kTo, kRadius, 10, false, false);
  TriangleMesh open = tube(kFrom, kTo, kRadius, 10, true, true);
  QVERIFY(!is_closed(open));
  QVERIFY(model::close_holes(open));
  QVERIFY(is_closed(open));
  QVERIFY(std::abs(volume(open) / volume(whole) - 1.0) < 1e-9);
  QVERIFY(!model::close_holes(open));
}

QTEST_APPLESS_MAIN(OpenVesselsTest)
#include "open_vessels_test.moc"
