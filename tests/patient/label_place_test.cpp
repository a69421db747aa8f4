// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_place.h"

#include <QTest>

using namespace glisson;

class LabelPlaceTest : public QObject {
  Q_OBJECT
 private slots:
  void ItIsTheLabelsAndNearItsMiddle() {
    VolumeGrid grid;
    grid.size = {70, 50, 40};  // more than one brick along each axis
    grid.spacing_mm = {1.0, 2.0, 3.0};
    grid.origin_mm = {-10.0, 5.0, 7.0};
    LabelVolume labels(grid);
    for (int k = 30; k < 37; ++k)
      for (int j = 28; j < 37; ++j)
        for (int i = 25; i < 66; ++i) labels.set({i, j, k}, 3);
    // A ring around a middle that it does not hold: one of the two places nearest to it is the answer.
    for (int i = 5; i <= 15; ++i)
      for (int j = 5; j <= 15; ++j)
        if (std::abs(i - 10) == 5 || std::abs(j - 10) == 5) labels.set({i, j, 2}, 4);
    QCOMPARE(place_of(labels, 3)->xyz, Eigen::Vector3d(0.035, 0.069, 0.106));
    const Eigen::Vector3d ring = 1e3 * place_of(labels, 4)->xyz - grid.origin_mm;
    QVERIFY((ring - Eigen::Vector3d(5, 20, 6)).norm() < 1e-9 ||
            (ring - Eigen::Vector3d(15, 20, 6)).norm() < 1e-9);
    QVERIFY(!place_of(labels, 5) && !place_of(labels, 0));
  }
};

QTEST_APPLESS_MAIN(LabelPlaceTest)
#include "label_place_test.moc"
