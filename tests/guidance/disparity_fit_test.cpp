// SPDX-License-Identifier: GPL-3.0-or-later
// A disparity of two pictures that are made by a formula, so that the true one is known.
#include "disparity_fit.h"

#include <QTest>
#include <cmath>
#include <opencv2/core.hpp>
#include <random>

using namespace glisson;
using guidance::fit_disparity;

namespace {

constexpr int kWidth = 120, kHeight = 60, kX = 60, kY = 30;

/// Waves of several lengths, in grey levels about 100.
double texture(double x, double y) {
  return std::sin(0.55 * x + 0.3 * y) + std::sin(0.31 * x - 0.47 * y + 1.0) +
         std::sin(0.83 * x + 0.11 * y + 2.0);
}

/// The right picture shows at x what the left one shows at x + disparity(x_left, y).
struct Pair {
  cv::Mat left = cv::Mat(kHeight, kWidth, CV_8U), right = cv::Mat(kHeight, kWidth, CV_8U);
};
Pair pair_of(double disparity, double slope, double levels, double noise, unsigned seed, double gain = 1.0,
             double offset = 0.0) {
  Pair pair;
  std::mt19937 random(seed);
  std::normal_distribution<double> grain(0.0, std::max(noise, 1e-9));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      // x = left - (disparity + slope (left - kX))
      const double left = (x + disparity - slope * kX) / (1.0 - slope);
      pair.left.at<std::uint8_t>(y, x) =
          cv::saturate_cast<std::uint8_t>(100.0 + levels * texture(x, y) + grain(random));
      pair.right.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(
          (100.0 + levels * texture(left, y) - offset) / gain + grain(random));
    }
  return pair;
}

}  // namespace

class DisparityFitTest : public QObject {
  Q_OBJECT
 private slots:
  void TheDisparityIsFoundFromNearby_data();
  void TheDisparityIsFoundFromNearby();
  void SigmaIsTheScatterOverNoise();
  void WhatThePicturesDoNotShowIsNotConfirmed();
  void WhatIsFarFromWhereItIsLookedForIsAnothers();
  void ThePatchStaysInThePicture();
};

void DisparityFitTest::TheDisparityIsFoundFromNearby_data() {
  QTest::addColumn<double>("slope");
  QTest::addColumn<double>("gain");
  QTest::addColumn<double>("offset");
  QTest::newRow("facing, the same light") << 0.0 << 1.0 << 0.0;
  QTest::newRow("slanted") << 0.08 << 1.0 << 0.0;
  QTest::newRow("other light") << 0.0 << 1.3 << -20.0;
  QTest::newRow("slanted, other light") << -0.06 << 0.8 << 15.0;
}

void DisparityFitTest::TheDisparityIsFoundFromNearby() {
  QFETCH(double, slope);
  QFETCH(double, gain);
  QFETCH(double, offset);
  const double truth = 11.37;
  const Pair pair = pair_of(truth, slope, 20.0, 0.0, 1, gain, offset);
  for (const double start : {truth - 0.7, truth, truth + 0.7}) {
    const auto fit = fit_disparity(pair.left, pair.right, kX, kY, start);
    QVERIFY(fit);
    QVERIFY2(std::abs(fit->disparity - truth) < 0.05, qPrintable(QString::number(fit->disparity)));
  }
}

void DisparityFitTest::SigmaIsTheScatterOverNoise() {
  const double truth = 8.6;
  double squares = 0.0, told = 0.0;
  int n = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const Pair pair = pair_of(truth, 0.0, 6.0, 3.0, seed);
    const auto fit = fit_disparity(pair.left, pair.right, kX, kY, 8.5);
    if (!fit) continue;
    squares += std::pow(fit->disparity - truth, 2);
    told += fit->sigma;
    ++n;
  }
  QVERIFY2(n > 180, qPrintable(QString::number(n)));
  const double scatter = std::sqrt(squares / n), mean = told / n;
  const QString said = QString("%1 told, %2 true").arg(mean).arg(scatter);
  QVERIFY2(scatter > 0.02, qPrintable(said));  // else the noise is not what is measured
  QVERIFY2(mean > 0.7 * scatter && mean < 1.5 * scatter, qPrintable(said));
}

void DisparityFitTest::WhatThePicturesDoNotShowIsNotConfirmed() {
  int confirmed = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const Pair plain = pair_of(9.0, 0.0, 0.0, 3.0, seed);  // noise alone
    confirmed += fit_disparity(plain.left, plain.right, kX, kY, 9.0).has_value();
  }
  QCOMPARE(confirmed, 0);
}

void DisparityFitTest::WhatIsFarFromWhereItIsLookedForIsAnothers() {
  const Pair pair = pair_of(9.0, 0.0, 20.0, 0.5, 1);
  QVERIFY(fit_disparity(pair.left, pair.right, kX, kY, 9.0));
  QVERIFY(!fit_disparity(pair.left, pair.right, kX, kY, 12.0));
}

void DisparityFitTest::ThePatchStaysInThePicture() {
  const Pair pair = pair_of(9.0, 0.0, 20.0, 0.5, 1);
  QVERIFY(!fit_disparity(pair.left, pair.right, 3, kY, 9.0));
  QVERIFY(!fit_disparity(pair.left, pair.right, kX, kHeight - 3, 9.0));
  QVERIFY(!fit_disparity(pair.left, pair.right, 14, kY, 9.0));  // its left half has no partner
  QVERIFY(fit_disparity(pair.left, pair.right, 20, kY, 9.0));
}

QTEST_APPLESS_MAIN(DisparityFitTest)
#include "disparity_fit_test.moc"
