// SPDX-License-Identifier: GPL-3.0-or-later
// A calibration whose rows are off: points within reach of it, a refusal that names it beyond.
#include <QTest>
#include <cmath>

#include "complaint.h"
#include "glisson/stereo/evaluate.h"
#include "glisson/stereo/reconstruct_pair.h"
#include "rendered_pair.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

/// A plane before the scope, with a calibration whose right rows are off.
PairInput with_rows_off(const rendered::Pair& pair, double rows) {
  PairInput input{{pair.left, pair.right}, pair.rig, {}, {}};
  input.rig.right.matrix(1, 2) -= rows;
  return input;
}

}  // namespace

class RowOffsetTest : public QObject {
  Q_OBJECT

  const rendered::Pair pair_ =
      rendered::pair(rendered::plane({0.0, 0.0, 0.1}, Eigen::Vector3d(0.35, -0.2, -1.0).normalized()));

 private slots:
  void PointsComeAndLieInTheMiddleOfTheirRows_data() {
    QTest::addColumn<double>("rows");
    QTest::newRow("as it was calibrated") << 0.0;
    QTest::newRow("right rows below") << 2.5;
    QTest::newRow("right rows above") << -2.5;
    QTest::newRow("as far as matches are looked for") << 3.3;
  }
  void PointsComeAndLieInTheMiddleOfTheirRows() {
    QFETCH(double, rows);
    const auto made = reconstruct_pair(with_rows_off(pair_, rows), {}, RunContext());
    const Reconstructed& whole = *made->whole;
    qInfo("%d points, rows off by %.2f px", whole.cloud.size(), whole.report.row_offset_px);
    QVERIFY(whole.cloud.size() > 150);
    QVERIFY(std::abs(whole.report.row_offset_px - rows) < 0.3);
    // A row is 0.14 mm there, and the plane's depth changes by a fifth of it.
    const CloudErrors errors = cloud_errors(whole.cloud, pair_.rig.left, pair_.depth);
    QVERIFY2(errors.distance.median < 0.15e-3, qPrintable(QString::number(1e3 * errors.distance.median)));
  }

  void RefusalNamesTheRows() {
    ReconstructOptions options;
    options.epipolar_px = 0.2;
    options.features = 300;
    const std::string said =
        test::complaint([&] { (void)reconstruct_pair(with_rows_off(pair_, 3.6), options, RunContext()); });
    QVERIFY2(said.find("pixels from its epipolar lines, and is looked for within 0.4") != std::string::npos,
             said.c_str());
    QVERIFY2(said.find("calibrate it again") != std::string::npos, said.c_str());
  }
};

QTEST_APPLESS_MAIN(RowOffsetTest)
#include "row_offset_test.moc"
