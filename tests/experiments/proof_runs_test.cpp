// SPDX-License-Identifier: GPL-3.0-or-later
// The proofs run, each on as little as it can: all that they are measured against in silico is measured, and
// a cancel ends them.
#include <QTest>
#include <cmath>

#include "atlas_proof.h"
#include "following_proof.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "landmark_effect.h"
#include "live_proof.h"
#include "patient_proof.h"
#include "pulled_proof.h"
#include "registration_joined.h"
#include "registration_looks.h"
#include "registration_trials.h"
#include "stereo_proof.h"

using namespace glisson;
using namespace glisson::experiments;
namespace fs = std::filesystem;

namespace {

std::shared_ptr<const atlas::Atlas> built_in() {
  const fs::path source = qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString();
  return std::make_shared<const atlas::Atlas>(atlas::read_atlas(source / "resources/atlas"));
}

/// Aims in silico that have no figure. @param besides those whose key begins so.
QStringList not_measured(const std::vector<Aim>& aims, const Figures& figures,
                         const std::string& besides = {}) {
  QStringList names;
  for (const Aim& aim : aims)
    if (aim.evidence == experiments::Evidence::in_silico &&
        (besides.empty() || !aim.key.starts_with(besides)) && verdict(aim, figures) == Verdict::not_measured)
      names << QString::fromStdString(aim.key);
  return names;
}

RunContext cancelled() {
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  return {{}, flag, 1};
}

}  // namespace

class ProofRunsTest : public QObject {
  Q_OBJECT
 private slots:
  void OrgansArePulled();
  void AnAtlasForetellsLivers();
  void LandmarksOfEachSourceAreRegistered();
  void TheOverlayStaysWithoutAFault();
  void AFastScopeIsFollowed();
  void APatientGoesFromTheCtToTheModel();
  void LooksAreHeldAgainstTheTruth();
  void ARegistrationsTrialsThatAreThereAreNotMadeAgain();
  void CancelGivesNothing();
  void WrongOptionsAreRefused();
};

void ProofRunsTest::OrgansArePulled() {
  const TemporaryFolder folder;
  PulledProofOptions options;
  options.organs = 1;
  options.frames = 2;
  options.nodes = 400;
  const auto proof = prove_pulled(options, folder.path(), RunContext());
  QVERIFY(proof);
  QCOMPARE(not_measured(pulled_aims(), proof->figures, "sequence_"), QStringList());
  QVERIFY(std::ranges::count(proof->absent, "elastic_sequence") == 1);
  // A kind a line, with noise and without, below the heads.
  QCOMPARE(proof->table.size(), std::size_t{1 + 2 * 6});
  QCOMPARE(std::ranges::count(read_file(folder.path() / "pulled_1.csv"), '\n'), 1 + 2 * 6);
  QVERIFY(proof->figures.at("pulled_held_worst_mm") < 2.0);
  QVERIFY(proof->figures.at("pulled_held_worst_mm") <= proof->figures.at("pulled_held_noise_worst_mm"));
}

void ProofRunsTest::AnAtlasForetellsLivers() {
  AtlasProofOptions options;
  options.built_in = built_in();
  options.livers = 5;
  options.effect_patients = 0;
  const auto proof = prove_atlas(options, RunContext());
  QVERIFY(proof);
  QCOMPARE(not_measured(atlas_aims(), proof->figures, "effect_"), QStringList());
  QCOMPARE(proof->absent, std::vector<std::string>{"liver_labelmaps"});
  QCOMPARE(proof->figures.at("synthetic_vena_cava_livers"), 5.0);
  QVERIFY(proof->figures.at("synthetic_surface_mean_mm") < 1.5);
  QVERIFY(proof->figures.at("synthetic_surface_worst_mm") >= proof->figures.at("synthetic_surface_mean_mm"));
}

void ProofRunsTest::LandmarksOfEachSourceAreRegistered() {
  LandmarkEffectOptions options;
  options.atlas = built_in();
  options.patients = options.handlings = 1;
  const auto effect = measure_landmark_effect(options, RunContext());
  QVERIFY(effect);
  QCOMPARE(effect->figures.at("effect_trials"), 1.0);
  QVERIFY(effect->figures.at("effect_compared") <= 1.0);
  QVERIFY(effect->figures.at("effect_atlas_notch_mm") < 30.0);
  // Heads and a line each source, heads and a line the cloud.
  QCOMPARE(effect->table.size(), std::size(kLandmarkSources) + 3);
  for (const LandmarkSource source : kLandmarkSources)
    QVERIFY(effect->figures.at(std::string("effect_") + landmark_source_code(source) + "_told") <= 1.0);
}

void ProofRunsTest::TheOverlayStaysWithoutAFault() {
  const TemporaryFolder folder;
  LiveProofOptions options;
  options.seeds = {101};
  options.frames = 60;
  options.only = "none";
  const auto proof = prove_live(options, folder.path(), RunContext());
  QVERIFY(proof);
  QCOMPARE(proof->figures.at("live_near_sound_valid_share"), 1.0);
  QCOMPARE(proof->figures.at("live_far_frames"), 0.0);
  QVERIFY(proof->figures.at("live_of_frozen_share") < 0.5);
  QVERIFY(!proof->figures.contains("live_tissue_far_frames"));
  QVERIFY(std::ranges::count(proof->absent, "stereo_opencas") == 1 &&
          std::ranges::count(proof->absent, "stereo_heart") == 1);
  const std::string frames = read_file(folder.path() / "live.csv");
  QCOMPARE(std::ranges::count(frames, '\n'), 1 + 59);
  QVERIFY(read_file(folder.path() / "live.txt").find("none") != std::string::npos);
  QVERIFY(read_file(folder.path() / "lesions.csv").find(",none,") != std::string::npos);
}

/// A film for each thing that hands do is filmed and followed; one is looked at here.
void ProofRunsTest::AFastScopeIsFollowed() {
  const TemporaryFolder folder;
  FollowingProofOptions options;
  options.frames = options.long_frames = 60;
  options.only = "fast";
  const auto proof = prove_following(options, folder.path(), RunContext());
  QVERIFY(proof);
  QCOMPARE(proof->table.size(), std::size_t{2});
  QCOMPARE(proof->figures.at("following_fast_shown_share"), 1.0);
  QVERIFY(proof->figures.at("following_fast_tre_mm") < 1.0);
  QVERIFY(proof->figures.at("following_fast_of_motion_share") < 0.5);
  QCOMPARE(proof->figures.at("following_far_shown_frames"), 0.0);
  const std::string frames = read_file(folder.path() / "following.csv");
  QCOMPARE(std::ranges::count(frames, '\n'), 1 + 59);
  options.frames = 10;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
}

void ProofRunsTest::APatientGoesFromTheCtToTheModel() {
  const TemporaryFolder folder;
  PatientProofOptions options;
  options.strokes = 4;
  options.patient.spacing_mm = {2.5, 2.5, 3.0};
  options.only = "slices of 5 mm";
  const auto proof = prove_patient(options, folder.path(), RunContext());
  QVERIFY(proof);
  QCOMPARE(not_measured(patient_aims(), proof->figures), QStringList());
  QVERIFY(std::ranges::count(proof->absent, "ct_ircad1") == 1 &&
          std::ranges::count(proof->absent, "ct_chaos3") == 1);
  QVERIFY(proof->figures.at("synthetic_dice_liver") > 0.9);
  QCOMPARE(proof->figures.at("synthetic_strokes"), 4.0);
  QVERIFY(proof->figures.at("trial_synthetic_dice_liver_worst") > 0.85);
  QCOMPARE(proof->table.size(), std::size_t{2});
  QVERIFY(fs::exists(folder.path() / "synthetic/patient.glisson/case.json"));
}

void ProofRunsTest::LooksAreHeldAgainstTheTruth() {
  auto stage = build_stage(proof_patients().front(), {}, 1, 1, RunContext());
  QVERIFY(stage);
  for (const LookTrial& trial : try_looks(*stage, 0, {}, RunContext())) {
    QVERIFY(trial.promised < trial.expected && trial.promised > 0.0);
    QVERIFY(trial.error > 0.0 && trial.after > 0.0 && trial.after_other > 0.0);
    QVERIFY(trial.error < 0.1 && trial.after < 0.1);
  }
  const std::vector<JoinedTrial> trials = try_joined(*stage, 0, {}, RunContext());
  QCOMPARE(trials.size(), std::size_t{1});
  const JoinedTrial& trial = trials.front();
  QVERIFY(trial.alone.seen > 0.1 && trial.alone.seen < 0.35);
  QVERIFY2(trial.joined.seen > trial.alone.seen,
           qPrintable(QString("%1, %2").arg(trial.alone.seen).arg(trial.joined.seen)));
  QVERIFY(!trial.joined.told && trial.joined.error < 30e-3);
}

void ProofRunsTest::ARegistrationsTrialsThatAreThereAreNotMadeAgain() {
  const TemporaryFolder folder, before;
  const ProofPatient& patient = proof_patients().front();
  RegistrationProofOptions options;
  options.only = patient.name;
  options.shares = {0.3};
  options.former = before.path();
  TrialLog log(before.path() / "registration_1.csv");
  for (const insilico::Handling handling : insilico::kHandlings)
    for (const RegistrationFault fault : kRegistrationFaults) {
      RegistrationTrial trial;
      trial.patient = patient.name;
      trial.set = patient.set;
      trial.handling = insilico::handling_code(handling);
      trial.share = 0.3;
      trial.fault = fault;
      trial.mean = 2e-3;
      trial.lesions = {3e-3, 3e-3, 3e-3};
      trial.rigid_mean = 5e-3;
      trial.refused = fault != RegistrationFault::none;
      log.add(trial);
    }
  const auto proof = prove_registration(options, folder.path(), RunContext());
  QVERIFY(proof && proof->absent.empty());
  QVERIFY(std::abs(proof->figures.at("registration_development_30_mean_mm") - 2.0) < 1e-3);
  QVERIFY(fs::is_empty(folder.path()));  // nothing was added
}

void ProofRunsTest::CancelGivesNothing() {
  const TemporaryFolder folder;
  QVERIFY(!prove_pulled({}, folder.path(), cancelled()));
  AtlasProofOptions options;
  options.built_in = built_in();
  QVERIFY(!prove_atlas(options, cancelled()));
  QVERIFY(!prove_stereo({}, folder.path(), cancelled()));
  LandmarkEffectOptions effect;
  effect.atlas = options.built_in;
  QVERIFY(!measure_landmark_effect(effect, cancelled()));
  QVERIFY(fs::is_empty(folder.path()));
  QVERIFY(!prove_patient({}, folder.path(), cancelled()));
}

void ProofRunsTest::WrongOptionsAreRefused() {
  AtlasProofOptions atlas;
  QVERIFY_THROWS_EXCEPTION(InputError, atlas.validate());
  atlas.built_in = built_in();
  atlas.livers = 4;
  QVERIFY_THROWS_EXCEPTION(InputError, prove_atlas(atlas, RunContext()));
  PulledProofOptions pulled;
  pulled.nodes = 10;
  QVERIFY_THROWS_EXCEPTION(InputError, pulled.validate());
  PatientProofOptions patient;
  patient.strokes = -1;
  QVERIFY_THROWS_EXCEPTION(InputError, patient.validate());
}

QTEST_GUILESS_MAIN(ProofRunsTest)
#include "proof_runs_test.moc"
