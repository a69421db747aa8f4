// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <QTest>
#include <cmath>
#include <numbers>
#include <random>

#include "evidence.h"
#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

constexpr int kGroups = 5, kSize = 3, kFixed = 2, kRows = 40;

Eigen::MatrixXd normal_matrix(int rows, int columns, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd m(rows, columns);
  for (double& value : m.reshaped()) value = normal(random);
  return m;
}

struct Example {
  Eigen::MatrixXd a = normal_matrix(kRows, kGroups* kSize + kFixed, 1);
  Eigen::VectorXd truth = normal_matrix(static_cast<int>(a.cols()), 1, 2);
  Eigen::VectorXd sigma = normal_matrix(kRows, 1, 3).cwiseAbs().array() * 0.2 + 0.1;
  Eigen::VectorXd fixed = Eigen::Vector2d(0.5, 2.0);
  Eigen::VectorXd y;
  Example() {
    for (int group = 0; group < kGroups; ++group)
      truth.segment<kSize>(group * kSize) =
          (group == 1 || group == 4 ? 1.0 : 0.0) * Eigen::Vector3d(1.0, -0.8, 1.5);
    y = a * truth + sigma.cwiseProduct(normal_matrix(kRows, 1, 4));
  }
  EvidenceProblem problem() const { return {a, y, sigma, kGroups, kSize, fixed}; }
  Eigen::MatrixXd marginal(const Eigen::VectorXd& gamma) const {
    Eigen::MatrixXd m = a * problem().column_variances(gamma).asDiagonal() * a.transpose();
    m.diagonal() += sigma.cwiseAbs2();
    return m;
  }
};

}  // namespace

class EvidenceTest : public QObject {
  Q_OBJECT
 private slots:
  void EvidenceIsTheDensityOfTheObservations() {
    const Example e;
    Eigen::VectorXd gamma(kGroups);
    gamma << 0.3, 1.0, 0.0, 2.5, 1e-4;
    const Eigen::MatrixXd m = e.marginal(gamma);
    const Eigen::LLT<Eigen::MatrixXd> llt(m);
    const double brute = -0.5 * e.y.dot(llt.solve(e.y)) - llt.matrixLLT().diagonal().array().log().sum() -
                         0.5 * kRows * std::log(2.0 * std::numbers::pi);
    QVERIFY(std::abs(posterior(e.problem(), gamma).log_evidence - brute) < 1e-9 * std::abs(brute));
  }

  void WithoutTheFixedColumnsEvidenceAndForcesAreTheSame() {
    const Example e;
    const EvidenceProblem whole = e.problem(), alone = whole.of_groups();
    QCOMPARE(alone.columns(), kGroups * kSize);
    Eigen::VectorXd gamma(kGroups);
    gamma << 0.3, 1.0, 0.0, 2.5, 1e-4;
    const EvidencePosterior all = posterior(whole, gamma), some = posterior(alone, gamma);
    QVERIFY(std::abs(some.log_evidence - all.log_evidence) < 1e-9 * std::abs(all.log_evidence));
    QVERIFY((some.mean - all.mean.head(kGroups * kSize)).norm() < 1e-9 * all.mean.norm());
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(kGroups);
    const Eigen::VectorXd raised = maximise_evidence(whole, ones, 10);
    QVERIFY((maximise_evidence(alone, ones, 10) - raised).norm() < 1e-9 * raised.norm());
    QVERIFY((evidence_of_groups(alone, gamma) - evidence_of_groups(whole, gamma)).norm() < 1e-8);
  }

  void PosteriorIsThatOfADenseComputation() {
    const Example e;
    Eigen::VectorXd gamma(kGroups);
    gamma << 0.3, 1.0, 0.0, 2.5, 1e-4;
    const Eigen::VectorXd variances = e.problem().column_variances(gamma);
    const Eigen::MatrixXd gain = variances.asDiagonal() * e.a.transpose() * e.marginal(gamma).inverse();
    const EvidencePosterior found = posterior(e.problem(), gamma);
    QVERIFY((found.mean - gain * e.y).norm() < 1e-10);
    const Eigen::MatrixXd covariance =
        Eigen::MatrixXd(variances.asDiagonal()) - gain * e.a * variances.asDiagonal();
    QVERIFY((found.root * found.root.transpose() - covariance).norm() < 1e-10);
  }

  void PosteriorIsThatOfSamples() {
    // Draws from the prior, weighed by how probable they make the observations.
    const Eigen::MatrixXd a = normal_matrix(4, 3, 8);
    const Eigen::VectorXd y = normal_matrix(4, 1, 9), sigma = Eigen::VectorXd::Constant(4, 0.8);
    const EvidenceProblem problem(a, y, sigma, 1, 3, {});
    const Eigen::VectorXd gamma = Eigen::VectorXd::Constant(1, 0.6);
    const EvidencePosterior found = posterior(problem, gamma);
    constexpr int kDraws = 400000;
    const Eigen::MatrixXd draws = std::sqrt(0.6) * normal_matrix(3, kDraws, 10);
    Eigen::VectorXd weight(kDraws);
    for (int k = 0; k < kDraws; ++k)
      weight[k] = std::exp(-0.5 * ((y - a * draws.col(k)).array() / sigma.array()).square().sum());
    const double total = weight.sum();
    const Eigen::VectorXd mean = draws * weight / total;
    const Eigen::MatrixXd centred = draws.colwise() - mean;
    const Eigen::MatrixXd covariance = centred * weight.asDiagonal() * centred.transpose() / total;
    QVERIFY((mean - found.mean).norm() < 0.01);
    QVERIFY((covariance - found.root * found.root.transpose()).norm() < 0.01);
    const double evidence =
        std::log(total / kDraws) - sigma.array().log().sum() - 2.0 * std::log(2.0 * std::numbers::pi);
    QVERIFY(std::abs(evidence - found.log_evidence) < 0.02);
  }

  void WhatAGroupAddsIsTheEvidenceLostWithoutIt() {
    const Example e;
    Eigen::VectorXd gamma(kGroups);
    gamma << 0.3, 1.0, 0.0, 2.5, 1e-4;
    const Eigen::VectorXd added = evidence_of_groups(e.problem(), gamma);
    const double all = posterior(e.problem(), gamma).log_evidence;
    for (int j = 0; j < kGroups; ++j) {
      Eigen::VectorXd without = gamma;
      without[j] = 0.0;
      const double lost = all - posterior(e.problem(), without).log_evidence;
      QVERIFY(std::abs(added[j] - lost) < 1e-7 * std::max(1.0, std::abs(lost)));
    }
  }

  void OnlyGroupsThatActAreWorthTheirPrice() {
    const Example e;
    const Eigen::VectorXd kept = keep_worth(
        e.problem(), maximise_evidence(e.problem(), Eigen::VectorXd::Constant(kGroups, 1.0), 30), 3.0);
    for (int j = 0; j < kGroups; ++j) QCOMPARE(kept[j] > 0.0, j == 1 || j == 4);
    const Eigen::VectorXd none = keep_worth(e.problem(), kept, 1e9);
    QVERIFY((none.array() == 0.0).all());
  }

  void UpdatesNeverLowerTheEvidence() {
    const Example e;
    Eigen::VectorXd gamma = Eigen::VectorXd::Constant(kGroups, 1.0);
    double last = posterior(e.problem(), gamma).log_evidence;
    for (int k = 0; k < 60; ++k) {
      gamma = maximise_evidence(e.problem(), gamma, 1);
      const double now = posterior(e.problem(), gamma).log_evidence;
      QVERIFY(now >= last - 1e-9 * std::abs(last));
      last = now;
    }
  }

  void GroupsThatDoNothingVanish() {
    const Example e;
    const Eigen::VectorXd gamma = maximise_evidence(e.problem(), Eigen::VectorXd::Ones(kGroups), 300);
    QVERIFY(gamma[1] > 0.05 && gamma[4] > 0.05);
    for (const int group : {0, 2, 3}) QVERIFY(gamma[group] < 1e-2 * gamma[1]);
    const EvidencePosterior found = posterior(e.problem(), gamma);
    QVERIFY((found.mean - e.truth).norm() < 0.3);
  }

  void UnitsAreNoMatter() {
    // Columns in another unit: amplitudes and variances follow, the evidence stays. Observations likewise.
    const Example e;
    const EvidenceProblem other(1e3 * e.a, e.y, e.sigma, kGroups, kSize, 1e-6 * e.fixed);
    const Eigen::VectorXd gamma = maximise_evidence(e.problem(), Eigen::VectorXd::Ones(kGroups), 10);
    const Eigen::VectorXd small = maximise_evidence(other, Eigen::VectorXd::Constant(kGroups, 1e-6), 10);
    QVERIFY((1e6 * small - gamma).norm() < 1e-9 * gamma.norm());
    const EvidencePosterior a = posterior(e.problem(), gamma), b = posterior(other, small);
    QVERIFY((a.mean - 1e3 * b.mean).norm() < 1e-9 * a.mean.norm());
    QVERIFY(std::abs(a.log_evidence - b.log_evidence) < 1e-9 * std::abs(a.log_evidence));
  }

  void OrderOfGroupsIsNoMatter() {
    const Example e;
    Eigen::MatrixXd a = e.a;
    a.leftCols<kSize>() = e.a.middleCols<kSize>(kSize);
    a.middleCols<kSize>(kSize) = e.a.leftCols<kSize>();
    const EvidenceProblem other(a, e.y, e.sigma, kGroups, kSize, e.fixed);
    const Eigen::VectorXd one = maximise_evidence(e.problem(), Eigen::VectorXd::Ones(kGroups), 10);
    const Eigen::VectorXd two = maximise_evidence(other, Eigen::VectorXd::Ones(kGroups), 10);
    QVERIFY(std::abs(one[0] - two[1]) + std::abs(one[1] - two[0]) < 1e-9 * one.norm());
  }

  void RefusesWhatDoesNotFit() {
    const Example e;
    QVERIFY_THROWS_EXCEPTION(PreconditionError, EvidenceProblem(e.a, e.y, e.sigma, kGroups, 2, e.fixed));
    QVERIFY_THROWS_EXCEPTION(PreconditionError,
                             EvidenceProblem(e.a, e.y.head(3), e.sigma, kGroups, kSize, e.fixed));
  }
};

QTEST_APPLESS_MAIN(EvidenceTest)
#include "evidence_test.moc"
