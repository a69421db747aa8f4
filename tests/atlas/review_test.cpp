// SPDX-License-Identifier: GPL-3.0-or-later
// What a person's word makes of a proposal, and which landmark is left by it.
#include "glisson/atlas/review.h"

#include <QTest>

#include <cmath>

#include "glisson/core/error.h"

using namespace glisson;
using atlas::Decision;
using atlas::Proposal;
using atlas::Source;
using atlas::Structure;

namespace {

constexpr double kSpread = 0.02;  // metres, of what statistics alone say: too much for a landmark

/// Points 5 mm apart along x, of statistics alone.
Proposal proposed(Structure structure, Eigen::Index count) {
  Proposal made;
  made.structure = structure;
  made.points = Points::Zero(count, 3);
  for (Eigen::Index k = 0; k < count; ++k) made.points(k, 0) = 0.005 * static_cast<double>(k);
  made.sources.assign(static_cast<std::size_t>(count), Source::statistics);
  made.covariances.assign(static_cast<std::size_t>(count), kSpread * kSpread * Eigen::Matrix3d::Identity());
  return made;
}

/// A contact of two rows, 2 mm apart, beside its course.
Proposal proposed_cava() {
  Proposal made = proposed(Structure::vena_cava, 5);
  made.area = made.points.replicate(2, 1);
  made.area.bottomRows(5).col(1).array() += 0.002;
  return made;
}

double nearest(const Points& points, const Eigen::RowVector3d& place) {
  return (points.rowwise() - place).rowwise().norm().minCoeff();
}

}  // namespace

class ReviewTest : public QObject {
  Q_OBJECT
 private slots:
  void ADecisionAloneMovesNothing();
  void WhatMerelyFollowsADragKeepsItsSource();
  void TheCourseOfAMovedContactLiesOnIt();
  void OtherNumbersOfPointsAreRefused();
  void OnlyWhatIsAcceptedBecomesALandmark();
  void PointsOfAContactAreNoDenserThanTheModels();
  void OfAMarginOnlyWhatIsShownIsUsed();
  void OnlyStatisticsDeviate();
};

void ReviewTest::ADecisionAloneMovesNothing() {
  const Proposal before = proposed(Structure::anterior_margin, 50);
  const Proposal after = atlas::reviewed(before, Decision::accepted, Points(0, 3));
  QVERIFY(after.decision == Decision::accepted && after.points == before.points);
  QVERIFY(after.sources == before.sources && after.covariances[7] == before.covariances[7]);
}

/// A margin that goes along with the dragged place is not all the person's word.
void ReviewTest::WhatMerelyFollowsADragKeepsItsSource() {
  const Proposal before = proposed(Structure::anterior_margin, 50);
  Points to = before.points;
  for (Eigen::Index k = 0; k < to.rows(); ++k)
    to(k, 2) += 0.01 * std::exp(-0.5 * std::pow(static_cast<double>(k - 20) / 5.0, 2));
  const Proposal after = atlas::reviewed(before, Decision::moved, to);
  QVERIFY(after.points == to && after.decision == Decision::moved);
  QVERIFY(after.sources[20] == Source::person && after.sources[24] == Source::person);
  QVERIFY(after.sources[28] == Source::statistics && after.sources[12] == Source::statistics);
  QVERIFY(after.covariances[20].trace() < after.covariances[28].trace());
}

void ReviewTest::TheCourseOfAMovedContactLiesOnIt() {
  const Proposal before = proposed_cava();
  Points to = before.area.bottomRows(5);
  to.col(2).array() += 0.01;
  const Proposal after = atlas::reviewed(before, Decision::moved, to);
  QVERIFY(after.area == to);
  QCOMPARE(after.points.rows(), before.points.rows());
  for (Eigen::Index k = 0; k < after.points.rows(); ++k) QVERIFY(nearest(to, after.points.row(k)) < 1e-12);
  QVERIFY(after.source() == Source::person && after.deviation() < before.deviation());
}

void ReviewTest::OtherNumbersOfPointsAreRefused() {
  const Points two = Points::Zero(2, 3);
  QVERIFY_THROWS_EXCEPTION(InputError,
                           atlas::reviewed(proposed(Structure::umbilical_notch, 1), Decision::moved, two));
  QVERIFY_THROWS_EXCEPTION(InputError, atlas::reviewed(proposed_cava(), Decision::moved, two));
  // What was not moved is not looked at.
  QVERIFY(atlas::reviewed(proposed_cava(), Decision::not_visible, two).decision == Decision::not_visible);
}

void ReviewTest::OnlyWhatIsAcceptedBecomesALandmark() {
  Proposal notch = proposed(Structure::umbilical_notch, 1);
  for (const Decision decision : {Decision::proposed, Decision::not_visible}) {
    notch.decision = decision;
    QCOMPARE(atlas::landmark_left_by(notch).rows(), 0);
  }
  for (const Decision decision : {Decision::accepted, Decision::moved}) {
    notch.decision = decision;
    QVERIFY(atlas::landmark_left_by(notch) == notch.points);
  }
}

void ReviewTest::PointsOfAContactAreNoDenserThanTheModels() {
  Proposal cava = proposed_cava();
  cava.decision = Decision::accepted;
  QVERIFY(atlas::landmark_left_by(cava) == Points(cava.area.topRows(5)));  // the others are 2 mm beside
}

void ReviewTest::OfAMarginOnlyWhatIsShownIsUsed() {
  Proposal margin = proposed(Structure::anterior_margin, 50);
  margin.decision = Decision::accepted;
  QCOMPARE(atlas::landmark_left_by(margin).rows(), 0);
  for (std::size_t k = 0; k < 24; ++k) margin.sources[k] = Source::both;
  QVERIFY(atlas::landmark_left_by(margin) == Points(margin.points.topRows(24)));
  // A short piece of statistics is bridged: 25 mm here.
  for (std::size_t k = 10; k < 14; ++k) margin.sources[k] = Source::statistics;
  QVERIFY(atlas::landmark_left_by(margin) == Points(margin.points.topRows(24)));
  // A long one of which the atlas is sure parts nothing.
  for (std::size_t k = 24; k < 50; ++k) margin.covariances[k] = 25e-6 * Eigen::Matrix3d::Identity();
  QVERIFY(atlas::landmark_left_by(margin) == margin.points);
}

void ReviewTest::OnlyStatisticsDeviate() {
  Proposal margin = proposed(Structure::anterior_margin, 3);
  margin.sources[1] = Source::person;
  margin.covariances[2] = Eigen::Vector3d(9e-6, 16e-6, 16e-6).asDiagonal();
  Points landmark(4, 3);
  landmark << margin.points, Eigen::RowVector3d(0.0, 0.0, 1.0);
  const Eigen::VectorXd found = atlas::landmark_deviations(margin, landmark);
  QVERIFY(std::abs(found[0] - kSpread) < 1e-12);
  QCOMPARE(found[1], 0.0);
  QVERIFY(std::abs(found[2] - 0.004) < 1e-12);  // its spread along the margin does not count
  QCOMPARE(found[3], 0.0);
}

QTEST_APPLESS_MAIN(ReviewTest)
#include "review_test.moc"
