// SPDX-License-Identifier: GPL-3.0-or-later
// Livers that disease or a surgeon has changed: what the atlas doubts of them is said, its ellipsoids grow,
// and nothing is asserted.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "glisson/atlas/transfer.h"
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

 private:
  Member member_;
  Atlas atlas_;
  Transfer whole_;
};

QTEST_APPLESS_MAIN(ChangedLiversTest)
#include "changed_livers_test.moc"
