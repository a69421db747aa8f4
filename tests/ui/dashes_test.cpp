// SPDX-License-Identifier: GPL-3.0-or-later
// Dashes against a line whose length and curvature are known.
#include "dashes.h"

#include <QTest>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"

namespace glisson {

class DashesTest : public QObject {
  Q_OBJECT
 private slots:
  void AStraightLineIsCutInTime();
  void DashesGoRoundCornersAndStayOnACircle();
  void NothingIsDrawnOfNothing();
};

void DashesTest::AStraightLineIsCutInTime() {
  // Whether the line has one corner or many makes no difference.
  QPolygonF many;
  for (int i = 0; i <= 40; ++i) many << QPointF(i, 0.0);
  for (const QPolygonF& line : {QPolygonF({QPointF(0, 0), QPointF(40, 0)}), many}) {
    const QList<QLineF> dashes = scene::dashes_of(line, false, 6.0, 4.0);
    QCOMPARE(dashes.size(), 4);
    for (qsizetype k = 0; k < dashes.size(); ++k) {
      QVERIFY(std::abs(dashes[k].x1() - 10.0 * static_cast<double>(k)) < 1e-9);
      QVERIFY(std::abs(dashes[k].length() - 6.0) < 1e-9);
    }
  }
  // The last one ends where the line ends.
  const QList<QLineF> cut = scene::dashes_of({QPointF(0, 0), QPointF(13, 0)}, false, 6.0, 4.0);
  QCOMPARE(cut.size(), 2);
  QCOMPARE(cut.back().p2(), QPointF(13, 0));
}

void DashesTest::DashesGoRoundCornersAndStayOnACircle() {
  constexpr double kRadius = 50.0;
  QPolygonF circle;
  for (int i = 0; i < 360; ++i)
    circle << kRadius * QPointF(std::cos(i * std::numbers::pi / 180), std::sin(i * std::numbers::pi / 180));
  const QList<QLineF> dashes = scene::dashes_of(circle, true, 8.0, 8.0);
  const double round = 2.0 * std::numbers::pi * kRadius;
  QCOMPARE(dashes.size(), static_cast<qsizetype>(std::ceil(round / 16.0)));
  for (const QLineF& dash : dashes) {
    const QPointF middle = dash.center();
    QVERIFY(kRadius - std::hypot(middle.x(), middle.y()) < 0.5);
  }
  // Without the way back to its begin a quarter of a square's border is missing.
  const QPolygonF square{QPointF(0, 0), QPointF(40, 0), QPointF(40, 40), QPointF(0, 40)};
  QVERIFY(scene::dashes_of(square, true, 6.0, 4.0).size() > scene::dashes_of(square, false, 6.0, 4.0).size());
  // A dash round a corner has two pieces.
  const QList<QLineF> bent = scene::dashes_of({QPointF(0, 0), QPointF(3, 0), QPointF(3, 3)}, false, 6.0, 4.0);
  QCOMPARE(bent, (QList<QLineF>{{QPointF(0, 0), QPointF(3, 0)}, {QPointF(3, 0), QPointF(3, 3)}}));
}

void DashesTest::NothingIsDrawnOfNothing() {
  QVERIFY(scene::dashes_of({}, true, 6.0, 4.0).isEmpty());
  QVERIFY(scene::dashes_of({QPointF(1, 1)}, false, 6.0, 4.0).isEmpty());
  QVERIFY(scene::dashes_of({QPointF(1, 1), QPointF(1, 1)}, true, 6.0, 4.0).size() < 3);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::dashes_of({}, true, 0.0, 4.0));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::DashesTest)
#include "dashes_test.moc"
