// SPDX-License-Identifier: GPL-3.0-or-later
// Livers that disease or a surgeon has changed: what the atlas doubts of them is said, its ellipsoids grow,
// and nothing is asserted.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "glisson/atlas/transfer.h"
#include "glisson/geometry/topology.h"
#include "known_livers.h"

using namespace glisson;
using namespace glisson::atlas;

namespace {

/// From 0 to the right of the notch to 1 well to its left.
double left_share(double x, double notch_x) {
  const double t = std::clamp((x - notch_x + 0.01) / 0.03, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Larger or smaller on either side of the notch. In the CT x points to the patient's left.
void scale_lobes(TriangleMesh& liver, const Eigen::RowVector3d& notch, double right, double left) {
  for (Eigen::Index v = 0; v < liver.vertices.rows(); ++v) {
    const double share = left_share(liver.vertices(v, 0), notch.x());
    const double scale = right + share * (left - right);
    liver.vertices.row(v) = notch + scale * (liver.vertices.row(v) - notch);
  }
}

/// Nodules of about a centimetre, 4 mm high; the right lobe shrunken, the left one grown.
TriangleMesh cirrhotic(const Member& whole) {
  TriangleMesh liver = whole.liver;
  const Points normals = vertex_normals(liver);
  for (Eigen::Index v = 0; v < liver.vertices.rows(); ++v) {
    const Eigen::RowVector3d p = 500.0 * liver.vertices.row(v);
    const double bump = std::sin(p.x()) * std::sin(p.y() + 1.0) * std::sin(p.z() + 2.0);
    liver.vertices.row(v) += 0.004 * bump * normals.row(v);
  }
  scale_lobes(liver, whole.structures.at(Structure::umbilical_notch).row(0), 0.7, 1.5);
  return liver;
}

/// The left lobe after the right portal vein was closed.
TriangleMesh hypertrophied(const Member& whole) {
  TriangleMesh liver = whole.liver;
  scale_lobes(liver, whole.structures.at(Structure::umbilical_notch).row(0), 0.8, 1.9);
  return liver;
}

/// What lies to the left of the notch is gone: pressed onto the cut, closed and flat there.
TriangleMesh without_left_lobe(const Member& whole) {
  TriangleMesh liver = whole.liver;
  const double cut = whole.structures.at(Structure::umbilical_notch)(0, 0);
  for (Eigen::Index v = 0; v < liver.vertices.rows(); ++v)
    liver.vertices(v, 0) = std::min(liver.vertices(v, 0), cut + 0.02 * (liver.vertices(v, 0) - cut));
  return liver;
}

using Change = TriangleMesh (*)(const Member&);

}  // namespace

class ChangedLiversTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    member_ = test::synthetic_member(911);
    atlas_ = test::built_in();
    whole_ = *transfer(atlas_, member_.liver, {}, RunContext());
  }

  void doubtIsSaidAndEllipsoidsGrow_data() {
    QTest::addColumn<Change>("change");
    QTest::newRow("cirrhotic") << Change(cirrhotic);
    QTest::newRow("hypertrophied") << Change(hypertrophied);
    QTest::newRow("after left hepatectomy") << Change(without_left_lobe);
  }

  void doubtIsSaidAndEllipsoidsGrow() {
    QFETCH(Change, change);
    const auto made = transfer(atlas_, change(member_), {}, RunContext());
    QVERIFY(!made->doubts.empty());
    QVERIFY2(made->unusual > 1.0 && made->unusual > whole_.unusual,
             qPrintable(QStringLiteral("%1 %2").arg(made->unusual).arg(whole_.unusual)));
    QCOMPARE(made->proposals.size(), whole_.proposals.size());
    for (std::size_t i = 0; i < made->proposals.size(); ++i) {
      const Proposal& one = made->proposals[i];
      // Wider than of a usual liver as large as the mean, whatever was squeezed or is gone.
      QVERIFY2(one.deviation() > deviation(*atlas_.find(one.structure)), structure_code(one.structure));
      // It is a proposal from statistics, as before: nothing of it was seen, nothing is decided.
      QVERIFY(one.decision == Decision::proposed);
      QVERIFY(std::all_of(one.sources.begin(), one.sources.end(),
                          [](Source source) { return source == Source::statistics; }));
    }
  }

  /// Where a part of the surface is not there nothing draws the atlas to it.
  void whatLacksSurfaceIsDoubted() {
    TriangleMesh open = member_.liver;
    std::vector<int> kept;
    const double low = open.vertices.col(2).minCoeff() + 0.03;
    for (int t = 0; t < open.triangle_count(); ++t)
      if (open.vertex(open.triangles(t, 0)).z() > low) kept.push_back(t);
    open = select_triangles(open, kept);
    TriangleMesh pieces = member_.liver;
    const Eigen::Index vertices = pieces.vertices.rows(), triangles = pieces.triangles.rows();
    pieces.vertices.conservativeResize(2 * vertices, 3);
    pieces.vertices.bottomRows(vertices) =
        (0.5 * member_.liver.vertices).rowwise() + Eigen::RowVector3d(0.25, 0.0, 0.0);
    pieces.triangles.conservativeResize(2 * triangles, 3);
    pieces.triangles.bottomRows(triangles) = member_.liver.triangles.array() + static_cast<int>(vertices);
    const std::vector<std::pair<TriangleMesh, std::string>> livers = {{open, "atlas.open_surface"},
                                                                      {pieces, "atlas.several_pieces 2"}};
    for (const auto& [liver, doubt] : livers) {
      const auto made = transfer(atlas_, liver, {}, RunContext());
      QVERIFY(std::find(made->doubts.begin(), made->doubts.end(), doubt) != made->doubts.end());
      for (std::size_t i = 0; i < made->proposals.size(); ++i)
        QVERIFY2(made->proposals[i].deviation() > 1.02 * whole_.proposals[i].deviation(),
                 structure_code(made->proposals[i].structure));
    }
  }

  void whatLiesOtherwiseIsDoubted() {
    TriangleMesh turned = member_.liver;
    for (Eigen::Index v = 0; v < turned.vertices.rows(); ++v)  // a quarter round the body's long axis
      turned.vertices.row(v) =
          Eigen::RowVector3d(-turned.vertices(v, 1), turned.vertices(v, 0), turned.vertices(v, 2));
    const auto made = transfer(atlas_, turned, {}, RunContext());
    QVERIFY(std::any_of(made->doubts.begin(), made->doubts.end(),
                        [](const std::string& doubt) { return doubt.starts_with("atlas.turned "); }));
    for (std::size_t i = 0; i < made->proposals.size(); ++i)
      QVERIFY(made->proposals[i].deviation() > 1.5 * whole_.proposals[i].deviation());
  }

 private:
  Member member_;
  Atlas atlas_;
  Transfer whole_;
};

QTEST_APPLESS_MAIN(ChangedLiversTest)
#include "changed_livers_test.moc"
