// SPDX-License-Identifier: GPL-3.0-or-later
// The linear posterior against conditioning of the joint normal law, written out.
#include "linear_posterior.h"

#include <Eigen/Dense>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "glisson/core/random.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

constexpr Eigen::Index kRows = 40, kUnknowns = 7;

Eigen::MatrixXd drawn(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& random) {
  Eigen::MatrixXd values(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j)
    for (Eigen::Index i = 0; i < rows; ++i) values(i, j) = standard_normal(random);
  return values;
}

LinearPosterior some() {
  std::mt19937_64 random(5);
  LinearPosterior posterior;
  posterior.answers = drawn(kRows, kUnknowns, random);
  posterior.variance = 0.5 + drawn(kRows, 1, random).array().square();
  posterior.y = drawn(kRows, 1, random);
  for (Eigen::Index first = 0; first < kRows; first += 8) {
    posterior.places.emplace_back();
    for (Eigen::Index i = first; i < first + 8; ++i) posterior.places.back().push_back(i);
  }
  return posterior;
}

/// Covariance of y before anything is known.
Eigen::MatrixXd before(const LinearPosterior& p, const Eigen::VectorXd& prior) {
  Eigen::MatrixXd s = p.answers * prior.asDiagonal() * p.answers.transpose();
  s.diagonal() += p.variance;
  return s;
}

}  // namespace

class LinearPosteriorTest : public QObject {
  Q_OBJECT
 private slots:
  void ItIsTheJointLawConditioned();
  void WhatIsDecidedIsTheVarianceThatWent();
  void APlaceLeftOutIsPredictedFromTheOthers();
};

void LinearPosteriorTest::ItIsTheJointLawConditioned() {
  LinearPosterior p = some();
  Eigen::VectorXd prior = Eigen::VectorXd::LinSpaced(kUnknowns, 0.5, 3.0);
  p.solve(prior);
  const Eigen::MatrixXd s = before(p, prior), across = prior.asDiagonal() * p.answers.transpose();
  const Eigen::MatrixXd inverse = s.inverse();
  const Eigen::MatrixXd covariance =
      Eigen::MatrixXd(prior.asDiagonal()) - across * inverse * across.transpose();
  QVERIFY((p.root * p.root.transpose() - covariance).norm() < 1e-10);
  QVERIFY((p.mean - across * inverse * p.y).norm() < 1e-10);
  QVERIFY((p.apart(p.y) - inverse * p.y).norm() < 1e-10);
  QVERIFY((p.left - (p.y - p.answers * p.mean)).norm() < 1e-12);
}

void LinearPosteriorTest::WhatIsDecidedIsTheVarianceThatWent() {
  LinearPosterior p = some();
  p.solve(Eigen::VectorXd::Ones(kUnknowns));
  const Eigen::MatrixXd covariance = p.root * p.root.transpose();
  QVERIFY(std::abs(p.decided(4) - (4.0 - covariance.topLeftCorner(4, 4).trace())) < 1e-12);
  // Rows that say nothing decide nothing.
  p.answers.setZero();
  p.solve(Eigen::VectorXd::Ones(kUnknowns));
  QVERIFY(std::abs(p.decided(kUnknowns)) < 1e-12);
}

void LinearPosteriorTest::APlaceLeftOutIsPredictedFromTheOthers() {
  LinearPosterior p = some();
  const Eigen::VectorXd prior = Eigen::VectorXd::Ones(kUnknowns);
  p.solve(prior);
  const Eigen::MatrixXd s = before(p, prior);
  double squares = 0.0, variances = 0.0;
  for (const auto& place : p.places) {
    std::vector<Eigen::Index> others;
    for (Eigen::Index i = 0; i < kRows; ++i)
      if (std::find(place.begin(), place.end(), i) == place.end()) others.push_back(i);
    const Eigen::MatrixXd gain = s(place, others) * s(others, others).inverse();
    const Eigen::VectorXd off = p.y(place) - gain * p.y(others);
    const Eigen::MatrixXd law = s(place, place) - gain * s(others, place);
    const double mean = off.mean();
    squares += mean * mean;
    variances += mean * mean / (law.sum() / 64.0);
  }
  const auto [square, variance] = p.held_out(RunContext());
  QVERIFY(std::abs(square - squares / 5.0) < 1e-10);
  QVERIFY(std::abs(variance - variances / 5.0) < 1e-10);
}

QTEST_APPLESS_MAIN(LinearPosteriorTest)
#include "linear_posterior_test.moc"
