// SPDX-License-Identifier: GPL-3.0-or-later
// What one structure tells of another, on draws whose joint distribution is known.
#include <Eigen/LU>
#include <QTest>
#include <algorithm>
#include <functional>

#include "glisson/core/random.h"
#include "glisson/core/run_context.h"
#include "statistics.h"

using namespace glisson;
using namespace glisson::atlas;

namespace {

constexpr double kDeviation = 0.02;  // metres, of the structure that tells

/// A point's residual, metres.
using Draw = std::function<Eigen::RowVector3d()>;

Draw draws(std::mt19937_64& random, double deviation) {
  return [&random, deviation]() -> Eigen::RowVector3d {
    return deviation * standard_normal3(random).transpose();
  };
}

StructureStatistics structure(Structure which, Eigen::Index points) {
  StructureStatistics one;
  one.structure = which;
  one.mean = Points::Zero(points, 3);
  return one;
}

void add(StructureStatistics& statistics, const std::string& member, const Points& residual) {
  statistics.members.push_back(member);
  statistics.residuals.push_back(residual);
}

/// Two structures of one point each, the second of which is `gain` times the first, and noise.
struct Pair {
  Pair(int members, const Eigen::Matrix3d& gain, const Draw& first, const Draw& noise) {
    for (int i = 0; i < members; ++i) {
      const Eigen::RowVector3d r = first();
      add(on, "liver " + std::to_string(i), r);
      add(of, "liver " + std::to_string(i), Eigen::RowVector3d(r * gain.transpose() + noise()));
    }
  }
  StructureStatistics on = structure(Structure::umbilical_notch, 1),
                      of = structure(Structure::portal_entrance, 1);
};

}  // namespace

class DependenceTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { random_ = RunContext().random("test.dependence"); }

  void ofManyLiversItIsTheJointDistributions() {
    Eigen::Matrix3d gain;
    gain << 0.9, 0.2, 0.0, 0.0, 0.4, -0.3, 0.1, 0.0, 0.7;
    const Pair pair(3000, gain, draws(random_, kDeviation), draws(random_, 0.004));
    const auto told = dependence(pair.of, pair.on, 0);
    QVERIFY(told && told->livers == 3000);
    QVERIFY((told->gains[0] - gain).norm() < 0.02);
    QVERIFY((told->left[0] - 0.004 * 0.004 * Eigen::Matrix3d::Identity()).norm() < 0.1 * 0.004 * 0.004);
  }

  void whatIsTheSamePlaceFollowsWholly() {
    const Pair pair(6, Eigen::Matrix3d::Identity(), draws(random_, kDeviation), draws(random_, 0.0));
    const auto told = dependence(pair.of, pair.on, 0);
    QVERIFY((told->gains[0] - Eigen::Matrix3d::Identity()).norm() < 1e-6);
    QVERIFY(told->left[0].norm() < 1e-12);
    // Nothing is known better than marks are.
    QVERIFY(covariance(pair.of, *told, 0).trace() >= 3e-6);
  }

  void ellipsoidsHold95PercentHoweverFewTheMembers_data() {
    QTest::addColumn<int>("members");
    QTest::addColumn<double>("gain");
    for (const int members : {6, 10, 20})
      for (const double gain : {0.0, 0.5, 1.0})
        QTest::addRow("%d livers, gain %.1f", members, gain) << members << gain;
  }
  /// 3000 draws each: of a liver that had no part in it, whose other structure is known. Where there is
  /// nothing to follow little is lost by it.
  void ellipsoidsHold95PercentHoweverFewTheMembers() {
    QFETCH(int, members);
    QFETCH(double, gain);
    const Draw first = draws(random_, kDeviation), noise = draws(random_, 0.01);
    int inside = 0;
    double alone = 0.0, following = 0.0;
    constexpr int kDraws = 3000;
    for (int trial = 0; trial < kDraws; ++trial) {
      const Pair pair(members, gain * Eigen::Matrix3d::Identity(), first, noise);
      const Eigen::Vector3d on = first().transpose(), of = gain * on + noise().transpose();
      const auto told = dependence(pair.of, pair.on, 0);
      const Eigen::Vector3d rest = told ? Eigen::Vector3d(of - told->gains[0] * on) : of;
      const Eigen::Matrix3d spread = told ? covariance(pair.of, *told, 0) : covariance(pair.of, 0);
      if (rest.dot(spread.inverse() * rest) <= kEllipsoid95) ++inside;
      alone += of.squaredNorm();
      following += rest.squaredNorm();
    }
    const double share = static_cast<double>(inside) / kDraws, size = std::sqrt(following / alone);
    qInfo("within the ellipsoids %.3f, error over that alone %.3f", share, size);
    QVERIFY2(share > 0.92 && share < 0.99, qPrintable(QString::number(share)));
    QVERIFY2(size < (gain == 0.0 ? 1.1 : gain == 0.5 ? 0.85 : 0.55), qPrintable(QString::number(size)));
  }

  void thePointThatTellsMostIsTaken() {
    StructureStatistics on = structure(Structure::vena_cava, 5), of = structure(Structure::falciform_line, 2);
    const Draw draw = draws(random_, kDeviation), noise = draws(random_, 0.002);
    for (int i = 0; i < 12; ++i) {
      Points five(5, 3), two(2, 3);
      for (Eigen::Index k = 0; k < 5; ++k) five.row(k) = draw();
      for (Eigen::Index k = 0; k < 2; ++k) two.row(k) = five.row(3) + noise();
      add(on, "liver " + std::to_string(i), five);
      add(of, "liver " + std::to_string(i), two);
    }
    learn_dependences({&on, &of});
    QCOMPARE(of.depends.size(), std::size_t{1});
    QCOMPARE(of.depends.front().on, Structure::vena_cava);
    QCOMPARE(of.depends.front().point, 3);
    // The synthetic population's members do not show how patients differ.
    of.added_deviation = 0.01;
    learn_dependences({&on, &of});
    QVERIFY(of.depends.empty() && on.depends.empty());
  }

  void membersBelongTogetherByName() {
    Pair pair(8, Eigen::Matrix3d::Identity(), draws(random_, kDeviation), draws(random_, 0.002));
    const auto before = dependence(pair.of, pair.on, 0);
    std::ranges::reverse(pair.on.members);
    std::ranges::reverse(pair.on.residuals);
    add(pair.on, "another", Eigen::RowVector3d(1.0, 1.0, 1.0));
    const auto after = dependence(pair.of, pair.on, 0);
    QCOMPARE(after->livers, 8);
    QVERIFY((after->gains[0] - before->gains[0]).norm() < 1e-12);
    for (int i = 0; i < 4; ++i) pair.of.members[static_cast<std::size_t>(i)] = "x" + std::to_string(i);
    QVERIFY(!dependence(pair.of, pair.on, 0));  // four are left
  }

  void aMemberLeftOutHasNoPartInIt() {
    const Draw first = draws(random_, kDeviation), noise = draws(random_, 0.005);
    Pair pair(9, 0.7 * Eigen::Matrix3d::Identity(), first, noise);
    const auto before = dependence(pair.of, pair.on, 0, "liver 4");
    pair.of.residuals[4] *= 7.0;
    pair.on.residuals[4] *= -3.0;
    const auto after = dependence(pair.of, pair.on, 0, "liver 4");
    QCOMPARE(after->livers, 8);
    QVERIFY((after->gains[0] - before->gains[0]).norm() < 1e-12);
    QVERIFY((after->left[0] - before->left[0]).norm() < 1e-15);
  }

 private:
  std::mt19937_64 random_;
};

QTEST_APPLESS_MAIN(DependenceTest)
#include "dependence_test.moc"
