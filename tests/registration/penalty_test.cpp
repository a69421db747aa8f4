// SPDX-License-Identifier: GPL-3.0-or-later
#include "penalty.h"

#include <Eigen/Eigenvalues>
#include <QTest>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/registration/pairs.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

class PenaltyTest : public QObject {
  Q_OBJECT
 private slots:
  void CorrectedIsASpringAtContact();
  void CorrectedSaturatesFarAway();
  void CorrectedNeverDecreases();
  void ClampedPullsAtContactAndVanishesBeyondTangentOne();
  void PrintedPushesAtContactAndPullsBeyondTangentOne();
  void LoadPointsFromModelToCloud();
  void LoadOfPrintedFormPointsAway();
  void TangentIsPositiveSemiDefinite();
  void SlidingResistanceIsTheGivenShare();
  void StiffnessStartsAtMinimumAndEndsAtMaximum();
  void StiffnessFollowsTheEquation();
  void StiffnessGrowsFromPlateauToPlateau();
  void BadArgumentsAreRefused();

 private:
  static Pair pair_at(const MovingSurface& surface, double distance) {
    Pair pair;
    pair.point = 0;
    pair.on_model = surface.closest(Feature::surface, {0.0, 0.0, 1.0});
    pair.normal = surface.normal(pair.on_model);
    pair.gap = distance * Eigen::Vector3d(0.6, 0.0, 0.8);
    pair.on_model.distance = distance;
    return pair;
  }
};

void PenaltyTest::CorrectedIsASpringAtContact() {
  QCOMPARE(penalty_force(PenaltyForm::corrected, 50.0, 0.0), 0.0);
  const double d = 1e-7;
  QVERIFY(std::abs(penalty_force(PenaltyForm::corrected, 50.0, d) / d - 1.0) < 1e-5);
}

void PenaltyTest::CorrectedSaturatesFarAway() {
  // d (1 - (2/pi) atan(s d)) -> 2 / (pi s).
  for (const double s : {10.0, 50.0, 200.0})
    QVERIFY(std::abs(penalty_force(PenaltyForm::corrected, s, 1e4) * s * std::numbers::pi / 2.0 - 1.0) <
            1e-4);
}

void PenaltyTest::CorrectedNeverDecreases() {
  double before = 0.0;
  for (int i = 1; i < 1000; ++i) {
    const double force = penalty_force(PenaltyForm::corrected, 50.0, 1e-4 * i);
    QVERIFY(force > before);
    before = force;
  }
}

void PenaltyTest::ClampedPullsAtContactAndVanishesBeyondTangentOne() {
  const double s = 50.0, zero = std::tan(1.0) / s;
  QCOMPARE(penalty_force(PenaltyForm::clamped, s, 0.0), 1.0 / s);
  QVERIFY(penalty_force(PenaltyForm::clamped, s, 0.99 * zero) > 0.0);
  QCOMPARE(penalty_force(PenaltyForm::clamped, s, 1.01 * zero), 0.0);
  QCOMPARE(penalty_force(PenaltyForm::clamped, s, 1.0), 0.0);
}

void PenaltyTest::PrintedPushesAtContactAndPullsBeyondTangentOne() {
  const double s = 50.0, zero = std::tan(1.0) / s;
  QCOMPARE(penalty_force(PenaltyForm::printed, s, 0.0), -1.0 / s);
  QVERIFY(penalty_force(PenaltyForm::printed, s, 0.99 * zero) < 0.0);
  QVERIFY(penalty_force(PenaltyForm::printed, s, 1.01 * zero) > 0.0);
  QVERIFY(std::abs(penalty_force(PenaltyForm::printed, s, 1e6) * s - (std::numbers::pi / 2.0 - 1.0)) < 1e-6);
}

void PenaltyTest::LoadPointsFromModelToCloud() {
  const MovingSurface surface(phantom::model(4, 4, 3));
  for (const PenaltyForm form : {PenaltyForm::corrected, PenaltyForm::clamped}) {
    const Pair pair = pair_at(surface, 0.01);
    const auto load = pair_load(pair, surface, form, 50.0, 3.5, 1.0);
    QVERIFY(load.force.dot(pair.gap) > 0.0);
    QVERIFY(std::abs(load.force.norm() - 3.5 * penalty_force(form, 50.0, 0.01)) < 1e-12);
    QVERIFY(std::abs(load.weights[0] + load.weights[1] + load.weights[2] - 1.0) < 1e-12);
  }
}

void PenaltyTest::LoadOfPrintedFormPointsAway() {
  const MovingSurface surface(phantom::model(4, 4, 3));
  const Pair pair = pair_at(surface, 0.01);
  QVERIFY(pair_load(pair, surface, PenaltyForm::printed, 50.0, 3.5, 1.0).force.dot(pair.gap) < 0.0);
}

void PenaltyTest::TangentIsPositiveSemiDefinite() {
  const MovingSurface surface(phantom::model(4, 4, 3));
  for (const PenaltyForm form : {PenaltyForm::corrected, PenaltyForm::clamped, PenaltyForm::printed})
    for (const double d : {0.0, 1e-6, 1e-3, 1e-2, 0.1, 1.0}) {
      const auto load = pair_load(pair_at(surface, d), surface, form, 50.0, 3.5, 0.1);
      QVERIFY(load.force.allFinite());
      QVERIFY((load.tangent - load.tangent.transpose()).norm() < 1e-12 * (1.0 + load.tangent.norm()));
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(load.tangent);
      QVERIFY(eigen.eigenvalues().minCoeff() >= -1e-12);
    }
}

void PenaltyTest::SlidingResistanceIsTheGivenShare() {
  const MovingSurface surface(phantom::model(4, 4, 3));
  Pair pair = pair_at(surface, 0.01);
  const Eigen::Vector3d along = pair.normal.unitOrthogonal();
  pair.gap = 0.01 * pair.normal;
  const Eigen::Vector3d normal = pair_load(pair, surface, PenaltyForm::corrected, 50.0, 1.0, 0.25).force;
  pair.gap = 0.01 * along;
  const Eigen::Vector3d sliding = pair_load(pair, surface, PenaltyForm::corrected, 50.0, 1.0, 0.25).force;
  QVERIFY(std::abs(sliding.norm() / normal.norm() - 0.25) < 1e-9);
}

void PenaltyTest::StiffnessStartsAtMinimumAndEndsAtMaximum() {
  QCOMPARE(stiffness_at_plateau(1e-4, 1e-3, 2, 0), 1e-4);
  for (const int n : {2, 3, 100}) QCOMPARE(stiffness_at_plateau(1e-4, 1e-3, 2, n), 1e-3);
  QCOMPARE(stiffness_at_plateau(0.0, 1e-3, 10, 0), 0.0);
  QCOMPARE(stiffness_at_plateau(0.0, 1e-3, 10, 10), 1e-3);
}

void PenaltyTest::StiffnessFollowsTheEquation() {
  // n/r = 1/2: 2 (1/4) / (5/4) = 2/5 of the way.
  QVERIFY(std::abs(stiffness_at_plateau(1e-4, 1e-3, 2, 1) - (1e-4 + 0.4 * 9e-4)) < 1e-15);
}

void PenaltyTest::StiffnessGrowsFromPlateauToPlateau() {
  for (int n = 0; n < 10; ++n)
    QVERIFY(stiffness_at_plateau(0.0, 1.0, 10, n + 1) > stiffness_at_plateau(0.0, 1.0, 10, n));
}

void PenaltyTest::BadArgumentsAreRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, stiffness_at_plateau(0.0, 1.0, 0, 1));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, stiffness_at_plateau(0.0, 1.0, 2, -1));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, penalty_force(PenaltyForm::corrected, 0.0, 1.0));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, penalty_force(PenaltyForm::corrected, 50.0, -1.0));
}

QTEST_APPLESS_MAIN(PenaltyTest)
#include "penalty_test.moc"
