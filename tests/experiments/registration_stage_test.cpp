// SPDX-License-Identifier: GPL-3.0-or-later
// What the proof of the registration shows to it, and the trials on one patient that is handled in one way.
#include "registration_stage.h"

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <numbers>
#include <set>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "phantom.h"
#include "registration_looks.h"
#include "registration_trials.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::experiments;
namespace fs = std::filesystem;

namespace {

constexpr double kShare = 0.3;

/// One of whom the proof has a surface alone: here a small liver's, which is a formula.
const ProofPatient& patient() {
  return *std::ranges::find(proof_patients(), "liver_ply",
                            [](const ProofPatient& one) { return std::string_view(one.name); });
}

/// A stage whose organ has few nodes, so that it is registered in a second: the phantom, handled in one way.
RegistrationStage small_stage() {
  RegistrationStage stage;
  stage.patient = patient();
  stage.model = phantom::model(6, 5, 3);
  stage.model.surfaces.push_back({structure::kParenchyma, "liver", stage.model.surface.mesh});
  stage.found = stage.model.landmarks;
  insilico::HandlingOptions options;
  options.truth_vertices = 400;
  stage.handled.push_back(insilico::HandledLiver::build(stage.model, options, RunContext()).value());
  stage.lesions.resize(3, 3);
  for (int k = 0; k < 3; ++k) stage.lesions.row(k) = phantom::shape(0.4 * (k - 1), 0.1, 0.0).transpose();
  return stage;
}

}  // namespace

class RegistrationStageTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    const fs::path surface = data_.path() / patient().path;
    fs::create_directories(surface.parent_path());
    write_triangle_mesh(surface, insilico::test::liver_surface(36), LengthUnit::millimetre);
    auto built = build_stage(patient(), data_.path(), 1, 1, RunContext());
    QVERIFY(built && built->handled.size() == 1);
    stage_ = std::make_unique<RegistrationStage>(std::move(*built));
  }

  void LesionsLieDeepAndFarFromEachOther();
  void EachFaultIsInItsCloud();
  void ALookFromElsewhereShowsTheSameOrgan();
  void MoreThanOneLookShowsIsSeenInSeveral();
  void AMistakenPlaceIsThatFarOff();
  void TrialsAreKeptAndTakenUpAgain();
  void AFileThatHoldsNoTrialsIsRefused();
  void WhatOneMoreLookBringsIsSummedUp();
  void TrialsThatAreThereAreSummedUpWithoutTheirPatient();
  void NothingIsLeftOfACancelledProof();

 private:
  /// Distances of a cloud's points to where the surface truly is, metres.
  std::vector<double> off(const LabelledCloud& cloud) const {
    TriangleMesh surface = stage_->model.surface.mesh;
    surface.vertices = stage_->by(0).carry(surface.vertices);
    return distances_to_surface(cloud.points, surface);
  }
  double median_off(const LabelledCloud& cloud) const {
    std::vector<double> all = off(cloud);
    for (double& one : all) one = std::abs(one);
    return upper_median(std::move(all));
  }
  LabelledCloud cloud(RegistrationFault fault) const {
    return faulty_cloud(*stage_, *stage_, 0, kShare, fault, 9);
  }
  /// A registration that nobody has made.
  RegistrationTrial made_up(RegistrationFault fault, double share) const {
    RegistrationTrial trial;
    trial.patient = patient().name;
    trial.set = patient().set;
    trial.handling = insilico::handling_code(insilico::kHandlings[0]);
    trial.share = share;
    trial.fault = fault;
    trial.mean = 2e-3;
    trial.lesions = {3e-3, 3e-3, 3e-3};
    trial.rigid_mean = 5e-3;
    trial.refused = fault != RegistrationFault::none;
    return trial;
  }

  const TemporaryFolder data_;
  std::unique_ptr<RegistrationStage> stage_;
};

void RegistrationStageTest::LesionsLieDeepAndFarFromEachOther() {
  QCOMPARE(stage_->lesions.rows(), 3);
  for (const double depth : distances_to_surface(stage_->lesions, stage_->model.surface.mesh))
    QVERIFY2(depth > 9e-3, qPrintable(QString::number(1e3 * depth)));
  for (Eigen::Index i = 0; i < 3; ++i) {
    QVERIFY((stage_->lesions.row(i) - stage_->lesions.row((i + 1) % 3)).norm() > 30e-3);
    const Label label = RegistrationStage::lesion_label(i);
    QCOMPARE(std::count_if(stage_->model.surfaces.begin(), stage_->model.surfaces.end(),
                           [&](const NamedSurface& one) { return one.structure == label; }),
             1);
  }
}

void RegistrationStageTest::EachFaultIsInItsCloud() {
  const LabelledCloud sound = cloud(RegistrationFault::none);
  QVERIFY(sound.size() > 100);
  QVERIFY2(median_off(sound) < 2e-3, qPrintable(QString::number(1e3 * median_off(sound))));
  QVERIFY(median_off(cloud(RegistrationFault::noise)) > 4e-3);
  const LabelledCloud mirrored = cloud(RegistrationFault::mirrored);
  QVERIFY((mirrored.points.col(0) + sound.points.col(0)).cwiseAbs().maxCoeff() < 1e-12);
  QVERIFY(mirrored.points.rightCols(2) == sound.points.rightCols(2));
  QVERIFY((cloud(RegistrationFault::larger).points - 1.2 * sound.points).cwiseAbs().maxCoeff() < 1e-12);
  QVERIFY((1.2 * cloud(RegistrationFault::smaller).points - sound.points).cwiseAbs().maxCoeff() < 1e-12);
  const LabelledCloud mislabelled = cloud(RegistrationFault::wrong_labels);
  QVERIFY(mislabelled.points == sound.points && mislabelled.features != sound.features);
  QVERIFY(std::ranges::count(mislabelled.features, Feature::umbilical_notch) > 0);
  const LabelledCloud stomach = cloud(RegistrationFault::foreign_organ);
  QCOMPARE(stomach.size(), sound.size());
  QVERIFY(median_off(stomach) > 5e-3);
  QVERIFY(!shows_the_organ(RegistrationFault::foreign_organ) && shows_the_organ(RegistrationFault::noise));
  std::set<std::string> codes;
  for (const RegistrationFault fault : kRegistrationFaults)
    QVERIFY(codes.insert(registration_fault_code(fault)).second);
}

void RegistrationStageTest::ALookFromElsewhereShowsTheSameOrgan() {
  const LabelledCloud look = look_from_elsewhere(*stage_, 0, kShare, 9);
  QVERIFY(look.size() > 100);
  // It is told in a frame in which the organ lies otherwise.
  QVERIFY(median_off(look) > 2.0 * median_off(cloud(RegistrationFault::none)));
  // The laparoscope has gone round the organ, which stays about where it was before it.
  const Eigen::RowVector3d middle = stage_->by(0).carry(stage_->model.mesh.vertices).colwise().mean();
  QVERIFY(std::abs(look.points.col(2).mean() - middle.z()) < 80e-3);
}

void RegistrationStageTest::MoreThanOneLookShowsIsSeenInSeveral() {
  const ShownLiver one = shown_liver(*stage_, 0, kShare, 9), several = shown_liver(*stage_, 0, 0.5, 9);
  QVERIFY(one.others.empty() && one.cloud.points == cloud(RegistrationFault::none).points);
  QVERIFY(!several.others.empty() && several.cloud.size() > 100);
  QVERIFY(median_off(several.cloud) < 2e-3);
  for (const LabelledCloud& other : several.others) QVERIFY(other.size() >= 10 && median_off(other) > 2e-3);
}

void RegistrationStageTest::AMistakenPlaceIsThatFarOff() {
  const CameraFromCt truth = stage_->by(0).camera_from_ct(), wrong = mistaken(*stage_, 0);
  const Points& nodes = stage_->model.mesh.vertices;
  const Eigen::RowVector3d shift = wrong.apply(nodes).colwise().mean() - truth.apply(nodes).colwise().mean();
  QVERIFY(std::abs(shift.norm() - 35e-3) < 1e-3);
  const double turn = Eigen::AngleAxisd(Eigen::Matrix3d(wrong.rotation * truth.rotation.transpose())).angle();
  QVERIFY(std::abs(turn * 180.0 / std::numbers::pi - 40.0) < 0.1);
}

void RegistrationStageTest::TrialsAreKeptAndTakenUpAgain() {
  const RegistrationStage stage = small_stage();
  const TemporaryFolder folder;
  const fs::path csv = folder.path() / "trials.csv";
  TrialLog log(csv);
  for (const RegistrationFault fault : kRegistrationFaults)
    if (fault != RegistrationFault::none && fault != RegistrationFault::wrong_start)
      log.add(made_up(fault, kShare));
  const std::size_t before = log.trials().size();
  RegistrationProofOptions options;
  options.shares = {kShare};
  run_trials(stage, stage, options, 0, log, RunContext());
  const std::vector<RegistrationTrial> all = log.trials();
  QCOMPARE(all.size(), before + 2);
  const RegistrationTrial &sound = all[before], &wrong = all[before + 1];
  QVERIFY(sound.fault == RegistrationFault::none && !sound.refused);
  QVERIFY(sound.rigid_mean > 2e-3 && sound.rigid_mean < 15e-3);
  QVERIFY2(sound.mean > 0.0 && sound.mean < 12e-3, qPrintable(QString::number(1e3 * sound.mean)));
  QVERIFY(sound.paper_mean > 0.0);  // at this share the paper's method is tried, too
  QVERIFY(sound.lesions.size() == 3 && sound.expected.size() == 3 && sound.covered.size() == 3);
  QVERIFY(sound.worst_lesion() >= sound.lesions[0] && sound.seconds > 0.0);
  QVERIFY(wrong.fault == RegistrationFault::wrong_start && std::isnan(wrong.paper_mean));

  TrialLog again(csv, csv);  // in its own place
  QVERIFY(again.has(sound) && again.has(wrong));
  run_trials(stage, stage, options, 0, again, RunContext());
  QCOMPARE(again.trials().size(), all.size());
  QCOMPARE(csv_of(again.trials()), csv_of(all));
}

void RegistrationStageTest::AFileThatHoldsNoTrialsIsRefused() {
  const TemporaryFolder folder;
  const fs::path csv = folder.path() / "trials.csv";
  write_file_atomically(csv, "a,b\n1,2\n");
  QVERIFY_THROWS_EXCEPTION(InputError, TrialLog(csv, csv));
  QVERIFY(TrialLog(csv).trials().empty());
  QVERIFY(TrialLog(csv, folder.path() / "none.csv").trials().empty());
}

void RegistrationStageTest::WhatOneMoreLookBringsIsSummedUp() {
  RegistrationProof proof;
  sum_up(std::vector<LookTrial>{}, "development", proof);
  QVERIFY(proof.figures.empty() && proof.table.empty());
  const LookTrial one{"lifted", 8e-3, 4e-3, 6e-3, 3e-3, 5e-3, {"hidden 0.4"}},
      two{"pressed", 9e-3, 5e-3, 7e-3, 2e-3, 6e-3, {}}, lost{"turned", 7e-3, 6e-3, 90e-3, 95e-3, 80e-3, {}};
  sum_up({one, two, lost}, "development", proof);
  const std::string prefix = "registration_development_looks_";
  QCOMPARE(proof.figures.at(prefix + "trials"), 3.0);
  QCOMPARE(proof.figures.at(prefix + "expected_mm"), 8.0);
  QCOMPARE(proof.figures.at(prefix + "promised_mm"), 5.0);
  QCOMPARE(proof.figures.at(prefix + "error_mm"), 7.0);  // the lost one does not drown the others
  QCOMPARE(proof.figures.at(prefix + "after_mm"), 3.0);
  QCOMPARE(proof.figures.at(prefix + "after_other_mm"), 6.0);
  QCOMPARE(proof.table.size(), std::size_t{2 + 3 + 1});
  QVERIFY(proof.table[2].starts_with("lifted") && proof.table[2].ends_with("  hidden"));
}

void RegistrationStageTest::TrialsThatAreThereAreSummedUpWithoutTheirPatient() {
  const TemporaryFolder folder;
  RegistrationProofOptions options;
  options.only = patient().name;
  options.shares = {kShare};
  const TemporaryFolder before;
  options.former = before.path();
  TrialLog log(before.path() / "registration_1.csv");
  for (const insilico::Handling handling : insilico::kHandlings)
    for (const RegistrationFault fault : kRegistrationFaults) {
      RegistrationTrial trial = made_up(fault, kShare);
      trial.handling = insilico::handling_code(handling);
      log.add(trial);
    }
  const auto proof = prove_registration(options, folder.path(), RunContext());
  QVERIFY(proof && !proof->table.empty());
  QVERIFY(std::abs(proof->figures.at("registration_validation_30_mean_mm") - 2.0) < 1e-3);
  QVERIFY(std::abs(proof->figures.at("registration_validation_30_rigid_mean_mm") - 5.0) < 1e-3);
  QVERIFY(!proof->figures.contains("registration_development_30_mean_mm"));
  QCOMPARE(proof->absent, std::vector<std::string>{patient().path});
}

void RegistrationStageTest::NothingIsLeftOfACancelledProof() {
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  const RunContext context({}, flag, 1);
  const TemporaryFolder folder;
  QVERIFY(!prove_registration(RegistrationProofOptions::quick(), folder.path(), context));
  QVERIFY(fs::is_empty(folder.path()));
  RegistrationProofOptions options;
  options.shares = {};
  QVERIFY_THROWS_EXCEPTION(InputError, prove_registration(options, folder.path(), RunContext()));
  options.shares = {1.5};
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
}

QTEST_GUILESS_MAIN(RegistrationStageTest)
#include "registration_stage_test.moc"
