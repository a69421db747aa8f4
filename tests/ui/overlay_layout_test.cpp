// SPDX-License-Identifier: GPL-3.0-or-later
// Words on the live picture do not cover each other.
#include "overlay_layout.h"

#include <QTest>
#include <random>

using namespace glisson;
using scene::Layout;
using scene::Taken;

class OverlayLayoutTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatComesLaterMovesAway();
  void ALabelStandsBesideItsRegionWhereItIsFree();
  void ManyLabelsStandApartAndInThePicture();
  void InAFullPictureAWordStaysWhereItBelongs();
};

namespace {
const Layout kLayout(QSize(960, 540));
const QRectF kPicture(0, 0, 960, 540);
}  // namespace

void OverlayLayoutTest::WhatComesLaterMovesAway() {
  Taken taken(kLayout);
  const QRectF first(10, 10, 500, 20), second(400, 10, 550, 20), third(300, 15, 100, 20),
      low(0, 500, 900, 20);
  QCOMPARE(taken.below(first), first);
  const QRectF then = taken.below(second);
  QVERIFY(!then.intersects(first) && then.top() > first.bottom());
  QCOMPARE(then.left(), second.left());
  const QRectF last = taken.below(third);
  QVERIFY(!last.intersects(first) && !last.intersects(then));
  QCOMPARE(taken.above(low), low);
  QVERIFY(taken.above(low).bottom() < low.top());
}

void OverlayLayoutTest::ALabelStandsBesideItsRegionWhereItIsFree() {
  const QRectF region(400, 40, 80, 60);
  const QSizeF size(90, 14);
  Taken free(kLayout);
  QVERIFY(free.beside(region, size).bottom() <= region.top());
  Taken banner(kLayout);
  banner.add({200, 5, 600, 30});  // over it
  const QRectF under = banner.beside(region, size);
  QVERIFY(under.top() >= region.bottom());
  QVERIFY(!under.intersects(region));
  banner.add({200, 101, 600, 30});  // and under it
  QVERIFY(banner.beside(region, size).left() >= region.right());
  QVERIFY(banner.beside(region, size).right() <= region.left());
}

void OverlayLayoutTest::ManyLabelsStandApartAndInThePicture() {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-30.0, 930.0), y(-30.0, 510.0), extent(10.0, 120.0);
  for (int trial = 0; trial < 200; ++trial) {
    Taken taken(kLayout);
    std::vector<QRectF> placed;
    for (int label = 0; label < 6; ++label) {
      const QRectF box = taken.beside({x(random), y(random), extent(random), extent(random)}, {95, 14});
      QVERIFY(kPicture.contains(box));
      for (const QRectF& other : placed) QVERIFY(!box.intersects(other));
      placed.push_back(box);
    }
  }
}

void OverlayLayoutTest::InAFullPictureAWordStaysWhereItBelongs() {
  Taken taken(kLayout);
  taken.add(kPicture);
  const QRectF wanted(10, 10, 100, 20);
  QCOMPARE(taken.below(wanted), wanted);
  QCOMPARE(taken.above(wanted), wanted);
}

QTEST_APPLESS_MAIN(OverlayLayoutTest)
#include "overlay_layout_test.moc"
