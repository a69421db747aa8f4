// SPDX-License-Identifier: GPL-3.0-or-later
// Ellipsoids hold what they promise on draws whose distribution is known.
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <QTest>

#include "glisson/atlas/atlas.h"
#include "glisson/core/random.h"
#include "glisson/core/run_context.h"
#include "statistics.h"

using namespace glisson;
using namespace glisson::atlas;

class StatisticsTest : public QObject {
  Q_OBJECT
 private slots:
  void ellipsoidsHold95PercentHoweverFewTheMembers_data() {
    QTest::addColumn<int>("members");
    QTest::newRow("6") << 6;
    QTest::newRow("10") << 10;
    QTest::newRow("20") << 20;
    QTest::newRow("60") << 60;
  }
  /// Residuals of a flat distribution, as surfaces have them; 4000 draws each.
  void ellipsoidsHold95PercentHoweverFewTheMembers() {
    QFETCH(int, members);
    auto random = RunContext().random("test.ellipsoids");
    const auto draw = [&] {
      return Eigen::RowVector3d{0.009 * standard_normal(random), 0.006 * standard_normal(random),
                                0.003 * standard_normal(random)};
    };
    int inside = 0;
    constexpr int kDraws = 4000;
    for (int trial = 0; trial < kDraws; ++trial) {
      StructureStatistics statistics;
      for (int i = 0; i < members; ++i) statistics.residuals.emplace_back(draw());
      const Eigen::Vector3d other = draw();
      if (other.dot(covariance(statistics, 0).inverse() * other) <= kEllipsoid95) ++inside;
    }
    const double share = static_cast<double>(inside) / kDraws;
    QVERIFY2(share > 0.92 && share < 0.99, qPrintable(QString::number(share)));
  }
  void aMemberLeftOutDoesNotCount() {
    StructureStatistics statistics;
    for (int i = 0; i < 8; ++i) statistics.residuals.emplace_back(Points::Constant(1, 3, 0.001 * i));
    StructureStatistics without = statistics;
    without.residuals.erase(without.residuals.begin() + 5);
    QVERIFY((covariance(statistics, 0, 5) - covariance(without, 0)).norm() < 1e-15);
  }
  void addedDeviationIsAddedInEveryDirection() {
    StructureStatistics statistics;
    for (int i = 0; i < 8; ++i) statistics.residuals.emplace_back(Points::Constant(1, 3, 0.001 * i));
    const Eigen::Matrix3d before = covariance(statistics, 0);
    statistics.added_deviation = 0.01;
    QVERIFY((covariance(statistics, 0) - before - 1e-4 * Eigen::Matrix3d::Identity()).norm() < 1e-15);
  }
  void whatIsUnusualWidensTheMembersPartAndTheAddedOneOnlyBeyondWhereItWasSet() {
    StructureStatistics statistics;
    for (int i = 0; i < 8; ++i) statistics.residuals.emplace_back(Points::Constant(1, 3, 0.001 * i));
    const Eigen::Matrix3d members = covariance(statistics, 0);
    statistics.added_deviation = 0.01;
    statistics.added_unusual = 2.5;
    const auto added = [&](double growth) -> Eigen::Matrix3d {
      return covariance(statistics, 0, -1, growth) - growth * growth * members;
    };
    QVERIFY((added(2.0) - 1e-4 * Eigen::Matrix3d::Identity()).norm() < 1e-15);
    QVERIFY((added(5.0) - 4e-4 * Eigen::Matrix3d::Identity()).norm() < 1e-15);
    // Where nothing is added the members are those livers.
    statistics.added_deviation = 0.0;
    QVERIFY((covariance(statistics, 0, -1, 2.4) - members).norm() < 1e-15);
    QVERIFY((covariance(statistics, 0, -1, 5.0) - 4.0 * members).norm() < 1e-15);
  }
  void whatIsSummedUpHoldsAsMuchAndNamesNobody() {
    auto random = RunContext().random("test.summed");
    StructureStatistics statistics;
    statistics.mean = Points::Zero(2, 3);
    for (int i = 0; i < 7; ++i) {
      Points residual(2, 3);
      for (Eigen::Index k = 0; k < residual.size(); ++k) residual.data()[k] = 0.01 * standard_normal(random);
      statistics.residuals.push_back(residual);
      statistics.members.push_back("liver " + std::to_string(i));
    }
    const Eigen::Matrix3d first = covariance(statistics, 0), second = covariance(statistics, 1);
    sum_up(statistics);
    QVERIFY(statistics.members.empty() && statistics.residuals.empty());
    QCOMPARE(statistics.livers(), 7);
    QVERIFY((covariance(statistics, 0) - first).norm() < 1e-15);
    QVERIFY((covariance(statistics, 1) - second).norm() < 1e-15);
  }

  void whatMeetsGoesAlongWithTheSameModes() {
    std::vector<Observation> follows, stays;
    for (int i = 0; i < 12; ++i) {
      const auto sign = [](int bit) { return bit % 2 == 0 ? 1.0 : -1.0; };
      Observation one;
      one.modes = Eigen::Vector2d{sign(i), sign(i / 2)};
      one.points = Points::Zero(1, 3);
      one.points(0, 0) = 1e-3 * sign(i + i / 2);  // whatever the modes are
      stays.push_back(one);
      one.points(0, 1) = 0.02 * one.modes[0];
      follows.push_back(one);
    }
    QCOMPARE(modes_for({stays}), 0);
    QCOMPARE(modes_for({follows}), 1);
    QCOMPARE(modes_for({stays, follows}), 1);
    StructureStatistics statistics;
    observe(statistics, stays, modes_for({stays, follows}));
    QCOMPARE(statistics.slopes.cols(), Eigen::Index(1));
    observe(statistics, follows, 1);
    QVERIFY(slope_size(statistics) > 0.8 * 0.02 / std::sqrt(3.0));
  }
};

QTEST_APPLESS_MAIN(StatisticsTest)
#include "statistics_test.moc"
