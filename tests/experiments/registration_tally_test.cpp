// SPDX-License-Identifier: GPL-3.0-or-later
// What the proof of the registration says of its trials.
#include <Eigen/Core>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "glisson/core/random.h"
#include "glisson/experiments/aims.h"
#include "registration_joined.h"
#include "registration_trials.h"

using namespace glisson;
using namespace glisson::experiments;

namespace {

RegistrationTrial trial(double metres, double rigid) {
  RegistrationTrial one;
  one.patient = "somebody";
  one.set = ProofSet::validation;
  one.handling = "lifted";
  one.share = 0.2;
  one.mean = metres;
  one.lesions = {metres};
  one.rigid_mean = rigid;
  return one;
}

RegistrationProof proof_of(const std::vector<RegistrationTrial>& trials) {
  RegistrationProof proof;
  sum_up(trials, ProofSet::validation, proof);
  return proof;
}

Verdict verdict_of(const char* key, const RegistrationProof& proof) {
  const auto aim = std::find_if(registration_aims().begin(), registration_aims().end(),
                                [key](const Aim& one) { return one.key == key; });
  return aim == registration_aims().end() ? Verdict::missed : verdict(*aim, proof.figures);
}

}  // namespace

class RegistrationTallyTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatDidNotHappenMeetsNoAim();
  void AMethodThatWasNotTriedHasNoError();
  void WaysTriedWithOneShareStandApart();
  void MethodsAreComparedOnTheSameRegistrations();
  void WhoeverFailsOnHardCloudsMissesTheAim();
  void JoinedLooksAreComparedWhereNeitherWasRefused();
  void WhatIsWrittenIsReadAgain();
  void EvenRightExpectationsCorrelateOnlySoFar();
  void WhatIsOverItsLimitIsDoubtedOrCounted();
};

void RegistrationTallyTest::WhatIsOverItsLimitIsDoubtedOrCounted() {
  RegistrationTrial near = trial(3.9e-3, 8e-3), told = trial(9e-3, 8e-3), untold = trial(4.1e-3, 8e-3);
  told.doubts = {"residual_large"};
  const RegistrationProof sound = proof_of({near, told});
  QCOMPARE(sound.figures.at("registration_validation_20_untold_share"), 0.0);
  QCOMPARE(verdict_of("registration_validation_20_untold_share", sound), Verdict::met);
  const RegistrationProof proof = proof_of({near, told, untold, near});
  QCOMPARE(proof.figures.at("registration_validation_20_untold_share"), 0.25);
  QCOMPARE(verdict_of("registration_validation_20_untold_share", proof), Verdict::missed);
  QCOMPARE(verdict_of("registration_validation_10_untold_share", proof), Verdict::not_measured);
}

/// Errors drawn from just the distributions that are expected.
void RegistrationTallyTest::EvenRightExpectationsCorrelateOnlySoFar() {
  constexpr double kMeanOfThree = 1.5957691216;  // of the length of three standard normal numbers
  std::mt19937_64 random(5);
  RegistrationTrial one = trial(5e-3, 8e-3);
  one.lesions.clear();
  for (int i = 0; i < 20000; ++i) {
    const double sigma = 1e-3 * (1.0 + 4.0 * uniform01(random));
    const Eigen::Vector3d off{standard_normal(random), standard_normal(random), standard_normal(random)};
    one.expected.push_back(kMeanOfThree * sigma);
    one.lesions.push_back(sigma * off.norm());
  }
  one.covered.assign(one.expected.size(), 1);
  RegistrationProof proof = proof_of({one});
  const double found = proof.figures["registration_validation_expected_correlation"],
               best = proof.figures["registration_validation_expected_correlation_at_best"];
  QVERIFY2(std::abs(found - best) < 0.02 && best < 0.8, qPrintable(QString("%1, %2").arg(found).arg(best)));
  // All are expected alike: nothing can be told apart.
  std::fill(one.expected.begin(), one.expected.end(), 3e-3);
  QVERIFY(std::isnan(proof_of({one}).figures["registration_validation_expected_correlation_at_best"]));
}

void RegistrationTallyTest::WhatDidNotHappenMeetsNoAim() {
  const RegistrationProof between = proof_of({trial(5e-3, 8e-3)});  // neither far nor near
  for (const char* key :
       {"registration_validation_far_told_share", "registration_validation_near_doubted_share"})
    QVERIFY2(verdict_of(key, between) == Verdict::not_measured, key);
  QVERIFY(verdict_of("registration_validation_rigid_beaten_share", between) == Verdict::met);
  const RegistrationProof far = proof_of({trial(20e-3, 8e-3)});
  QVERIFY(verdict_of("registration_validation_far_told_share", far) == Verdict::missed);
}

void RegistrationTallyTest::AMethodThatWasNotTriedHasNoError() {
  const RegistrationProof proof = proof_of({trial(5e-3, 8e-3)});
  QVERIFY(std::isnan(proof.figures.at("registration_validation_20_paper_mean_mm")));
  QCOMPARE(proof.figures.at("registration_validation_20_rigid_mean_mm"), 8.0);
  QCOMPARE(proof.table[2],
           std::string("lifted         20       1     5.00         -      8.00       5.00        0"));
}

void RegistrationTallyTest::WaysTriedWithOneShareStandApart() {
  RegistrationTrial known = trial(3e-3, 8e-3), other = trial(7e-3, 6e-3), failed = other;
  known.share = other.share = failed.share = 0.3;
  other.handling = "resected";
  failed.handling = "swollen";
  failed.mean = std::numeric_limits<double>::infinity();
  failed.refused = true;
  const RegistrationProof proof = proof_of({known, other, failed});
  QCOMPARE(proof.figures.at("registration_validation_30_mean_mm"), 3.0);
  QCOMPARE(proof.figures.at("registration_validation_others_mean_mm"), 7.0);
  QCOMPARE(proof.figures.at("registration_validation_others_rigid_mean_mm"), 6.0);
  QCOMPARE(proof.figures.at("registration_validation_others_failed"), 1.0);
  QCOMPARE(proof.figures.at("registration_validation_others_untold_share"), 0.5);
  QVERIFY(!proof_of({known}).figures.contains("registration_validation_others_mean_mm"));
}

void RegistrationTallyTest::MethodsAreComparedOnTheSameRegistrations() {
  RegistrationTrial failed = trial(std::numeric_limits<double>::infinity(), 20e-3);
  failed.refused = true;
  const RegistrationProof proof = proof_of({trial(5e-3, 4e-3), failed});
  QCOMPARE(proof.figures.at("registration_validation_20_mean_mm"), 5.0);
  QCOMPARE(proof.figures.at("registration_validation_20_rigid_mean_mm"), 4.0);
  QVERIFY(verdict_of("registration_validation_rigid_beaten_share", proof) == Verdict::missed);
  const RegistrationProof none = proof_of({failed});
  QVERIFY(std::isnan(none.figures.at("registration_validation_20_mean_mm")));
  QVERIFY(verdict_of("registration_validation_rigid_beaten_share", none) == Verdict::missed);
}

void RegistrationTallyTest::WhoeverFailsOnHardCloudsMissesTheAim() {
  RegistrationTrial failed = trial(std::numeric_limits<double>::infinity(), 20e-3);
  failed.refused = true;
  const char* aim = "registration_validation_20_all_mean_mm";
  const RegistrationProof all = proof_of({trial(2e-3, 4e-3)});
  QCOMPARE(all.figures.at("registration_validation_20_failed"), 0.0);
  QVERIFY(verdict_of(aim, all) == Verdict::met);
  const RegistrationProof some = proof_of({trial(2e-3, 4e-3), failed});
  QCOMPARE(some.figures.at("registration_validation_20_failed"), 1.0);
  QVERIFY(verdict_of(aim, some) == Verdict::missed);
  QVERIFY(verdict_of(aim, proof_of({failed})) == Verdict::missed);
}

void RegistrationTallyTest::JoinedLooksAreComparedWhereNeitherWasRefused() {
  const auto found = [](double error, bool refused) {
    JoinedTrial::Found one;
    one.error = error;
    one.refused = refused;
    return one;
  };
  const double never = std::numeric_limits<double>::infinity();
  const std::vector<JoinedTrial> trials = {
      {"somebody", "lifted", found(4e-3, false), found(2e-3, false), found(9e-3, true)},
      {"somebody", "pressed", found(6e-3, false), found(5e-3, false), found(8e-3, false)},
      {"somebody", "turned", found(30e-3, false), found(40e-3, true), found(7e-3, true)},
      {"somebody", "pulled", found(never, true), found(20e-3, false), found(6e-3, false)}};
  RegistrationProof proof;
  sum_up(trials, "validation", proof);
  const auto figure = [&](const std::string& key) {
    return proof.figures.at("registration_validation_" + key);
  };
  QCOMPARE(figure("joined_trials"), 4.0);
  QCOMPARE(figure("joined_compared"), 2.0);
  QCOMPARE(figure("joined_alone_mean_mm"), 5.0);
  QCOMPARE(figure("joined_mean_mm"), 3.5);
  QCOMPARE(figure("joined_median_mm"), 5.0);
  QCOMPARE(figure("joined_alone_refused"), 1.0);
  QCOMPARE(figure("joined_refused"), 1.0);
  QCOMPARE(figure("moved_refused"), 2.0);
  QCOMPARE(figure("moved_mean_mm"), 7.0);
}

void RegistrationTallyTest::WhatIsWrittenIsReadAgain() {
  RegistrationTrial failed = trial(std::numeric_limits<double>::infinity(), 8e-3);
  failed.refused = true;
  failed.doubts = {"one 1", "two"};
  const auto read = trials_of(csv_of({failed}), "trials.csv");
  QCOMPARE(read.size(), std::size_t{1});
  QVERIFY(std::isinf(read[0].mean) && read[0].refused && read[0].doubts == failed.doubts);
  QVERIFY(std::isnan(read[0].paper_mean));
  QCOMPARE(read[0].rigid_mean, 8e-3);
}

QTEST_APPLESS_MAIN(RegistrationTallyTest)
#include "registration_tally_test.moc"
