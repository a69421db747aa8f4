// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/statistics.h"

#include <QTest>

using namespace glisson;

class StatisticsTest : public QObject {
  Q_OBJECT
 private slots:
  void MedianIsAValueOfTheList();
  void ConventionsDifferOnlyBetweenTwoValues();
  void OrderDoesNotMatter();
  void DeviationIgnoresOutliers();
  void ASpreadIsMedianAndScaledDeviation();
  void EmptyListsAreRefused();
  void SharesOutsideZeroToOneAreRefused();
  void RanksOutsideTheListAreRefused();
};

void StatisticsTest::MedianIsAValueOfTheList() {
  QCOMPARE(upper_median(std::vector{3.0, 1.0, 2.0}), 2.0);
  QCOMPARE(upper_median(std::vector{4.0, 1.0, 3.0, 2.0}), 3.0);
  QCOMPARE(upper_median(std::vector{7.0F}), 7.0F);
}

void StatisticsTest::ConventionsDifferOnlyBetweenTwoValues() {
  const std::vector<double> even = {1.0, 2.0, 4.0, 8.0}, odd = {1.0, 2.0, 4.0};
  QCOMPARE(lower_percentile(even, 0.5), 2.0);
  QCOMPARE(interpolated_percentile(even, 0.5), 3.0);
  QCOMPARE(upper_percentile(even, 0.5), 4.0);
  QCOMPARE(lower_percentile(odd, 0.5), 2.0);
  QCOMPARE(interpolated_percentile(odd, 0.5), 2.0);
  QCOMPARE(upper_percentile(odd, 0.5), 2.0);
  for (const double share : {0.0, 1.0}) {
    QCOMPARE(lower_percentile(even, share), interpolated_percentile(even, share));
    QCOMPARE(upper_percentile(even, share), interpolated_percentile(even, share));
  }
}

void StatisticsTest::OrderDoesNotMatter() {
  std::vector<double> values = {1.0, 2.0, 3.0, 4.0, 5.0};
  do {
    QCOMPARE(upper_median(values), 3.0);
    QCOMPARE(at_rank(values, 1), 2.0);
    QCOMPARE(upper_percentile(values, 0.6), 4.0);
    QCOMPARE(lower_percentile(values, 0.6), 3.0);
  } while (std::next_permutation(values.begin(), values.end()));
}

void StatisticsTest::DeviationIgnoresOutliers() {
  QCOMPARE(median_absolute_deviation(std::vector{-1.0, 0.0, 1.0, 2.0, 1e9}, 1.0), 1.0);
  QCOMPARE(median_absolute_deviation(std::vector{-3.0F, 3.0F, 3.0F}, 0.0F), 3.0F);
}

void StatisticsTest::ASpreadIsMedianAndScaledDeviation() {
  const Spread<float> spread = robust_spread(std::vector{-1.0F, 0.0F, 1.0F, 2.0F, 1e9F});
  QCOMPARE(spread.middle, 1.0F);
  QCOMPARE(spread.deviation, kDeviationPerMad);
}

void StatisticsTest::EmptyListsAreRefused() {
  const std::vector<double> none;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, upper_median(none));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, robust_spread(none));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, median_absolute_deviation(none, 0.0));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, lower_percentile(none, 0.5));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, upper_percentile(none, 0.5));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, interpolated_percentile(none, 0.5));
}

void StatisticsTest::SharesOutsideZeroToOneAreRefused() {
  const std::vector<double> values = {1.0, 2.0};
  for (const double share : {-0.1, 1.1, std::nan("")}) {
    QVERIFY_THROWS_EXCEPTION(PreconditionError, lower_percentile(values, share));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, upper_percentile(values, share));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, interpolated_percentile(values, share));
  }
}

void StatisticsTest::RanksOutsideTheListAreRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, at_rank(std::vector{1.0, 2.0}, 2));
}

QTEST_APPLESS_MAIN(StatisticsTest)
#include "statistics_test.moc"
