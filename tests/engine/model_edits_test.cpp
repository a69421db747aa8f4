// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does to a model: edits its trees, and says that it is right.
#include "glisson/engine/review.h"
#include "runners.h"
#include "trial_patient.h"

#include <algorithm>

#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/check_model.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/edit_trees.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/commands/load_stereo_pair.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/review.h"

using namespace glisson;
using namespace glisson::engine;

namespace {

/// The real commands of this test, on a patient that all others give.
Engine::Options real_options(Runner runner) {
  Engine::Options options;
  options.runner = runner;
  options.apply = [](const CaseState& state, const Command& command, const RunContext& context,
                     const Services& services) {
    return (command.as<EditTrees>() != nullptr) || (command.as<CheckModel>() != nullptr)
               ? apply(state, command, context, services)
               : give_patient(state, command, context, services);
  };
  return options;
}

model::TreeEdit root_at(const Eigen::Vector3d& p) { return {model::TreeEdit::Kind::set_root, p}; }

}  // namespace

class ModelEditsTest : public QObject {
  Q_OBJECT
 private slots:
  void EntrancesFollowTheEditsAndComeBack_data() { test::both_runners(); }
  void EntrancesFollowTheEditsAndComeBack();
  void WhatAModelWasMadeOfOutlivesAnEdit_data() { test::both_runners(); }
  void WhatAModelWasMadeOfOutlivesAnEdit();
  void SeedsDoNotOutdateLabelsThatAHandHasChanged();
  void WhatIsKeptOfLabelsStaysAsOldAsItWas();
  void ACloudIsOfTheFrameAndTheScopeThatSawIt();
  void AnImpossibleEditLeavesTheModel_data() { test::both_runners(); }
  void AnImpossibleEditLeavesTheModel();
  void AnotherModelIsNotChecked_data() { test::both_runners(); }
  void AnotherModelIsNotChecked();
  void VesselsOutsideOfTheMeshAreTold();
  void LabelsThatNobodyApprovedAreNamed();
  void WithoutAModelThereIsNothingToEditOrCheck();
};

void ModelEditsTest::EntrancesFollowTheEditsAndComeBack() {
  QFETCH(Runner, runner);
  Engine engine(real_options(runner));
  engine.wait(engine.post(ImportMesh{}));
  const VesselTree built = engine.snapshot()->state[part::model]->model.vessels.at(0);
  const auto entrance = [&] {
    const VesselTree& tree = engine.snapshot()->state[part::model]->model.vessels.at(0);
    return Eigen::Vector3d(tree.nodes.row(tree.root).transpose());
  };
  const Eigen::Vector3d far_end = built.nodes.bottomRows(1).transpose();
  QVERIFY((entrance() - far_end).norm() > 0.05);
  const Outcome outcome = engine.wait(engine.post(EditTrees{{root_at(far_end)}}));
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(outcome.figures.at("model_beams"), static_cast<double>(built.beams.size()));
  QVERIFY((entrance() - far_end).norm() < 1e-12);
  QCOMPARE(engine.snapshot()->state[part::model]->tree_edits.size(), std::size_t{1});
  QCOMPARE(engine.snapshot()->stage(part::model), StageState::current);
  engine.wait(engine.post(EditTrees{}));
  QVERIFY(engine.snapshot()->state[part::model]->model.vessels.at(0).nodes == built.nodes);
  QVERIFY(engine.snapshot()->state[part::model]->tree_edits.empty());
}

void ModelEditsTest::WhatAModelWasMadeOfOutlivesAnEdit() {
  QFETCH(Runner, runner);
  Engine engine(real_options(runner));
  engine.wait(engine.post(Segment{}));
  engine.wait(engine.post(BuildModel{}));
  const Points& nodes = engine.snapshot()->state[part::model]->model.vessels.at(0).nodes;
  const Outcome outcome = engine.wait(engine.post(EditTrees{{root_at(nodes.bottomRows(1).transpose())}}));
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(engine.snapshot()->stage(part::model), StageState::current);
  QVERIFY(engine.snapshot()->state.stamp(part::model).made_from.contains(part::labels));
  engine.wait(engine.post(EditLabels{}));
  QCOMPARE(engine.snapshot()->stage(part::model), StageState::stale);
  // Nor does an edit make a model current whose labels have gone on.
  engine.wait(engine.post(EditTrees{}));
  QCOMPARE(engine.snapshot()->stage(part::model), StageState::stale);
}

void ModelEditsTest::SeedsDoNotOutdateLabelsThatAHandHasChanged() {
  Engine engine(real_options(Runner::inline_));
  engine.wait(engine.post(Segment{}));
  engine.wait(engine.post(SetSeeds{}));
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::stale);
  engine.wait(engine.post(EditLabels{}));
  engine.wait(engine.post(SetSeeds{}));
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::current);
}

void ModelEditsTest::WhatIsKeptOfLabelsStaysAsOldAsItWas() {
  Engine engine(real_options(Runner::inline_));
  engine.wait(engine.post(ImportImage{}));
  engine.wait(engine.post(Segment{}));
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::current);
  engine.wait(engine.post(ImportImage{}));
  Segment gallbladder;
  gallbladder.options.structures = {false, false, false, false, true, false};
  QVERIFY(gallbladder.keeps_labels());
  engine.wait(engine.post(gallbladder));
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::stale);  // the liver is the former CT's
  Segment around_a_lock;
  around_a_lock.options.locked = {structure::kGallbladder};
  QVERIFY(around_a_lock.keeps_labels());
  engine.wait(engine.post(around_a_lock));
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::stale);
  engine.wait(engine.post(Segment{}));
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::current);
}

void ModelEditsTest::ACloudIsOfTheFrameAndTheScopeThatSawIt() {
  for (const Command& next : {Command(LoadVideoFrame{}), Command(SetCalibration{})}) {
    Engine engine(real_options(Runner::inline_));
    for (const Command& command : {Command(ImportMesh{}), Command(SetCalibration{}),
                                   Command(LoadStereoPair{}), Command(ImportCloud{}), Command(Register{})})
      QCOMPARE(engine.wait(engine.post(command)).status, Status::done);
    QCOMPARE(engine.snapshot()->stage(part::registration), StageState::current);
    engine.wait(engine.post(next));
    QCOMPARE(engine.snapshot()->stage(part::registration), StageState::stale);
  }
}

void ModelEditsTest::AnImpossibleEditLeavesTheModel() {
  QFETCH(Runner, runner);
  Engine engine(real_options(runner));
  engine.wait(engine.post(ImportMesh{}));
  const auto before = engine.snapshot()->state[part::model];
  const Outcome outcome = engine.wait(engine.post(EditTrees{{root_at({1.0, 1.0, 1.0})}}));
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY(outcome.error.find("edit 1 (set_root)") != std::string::npos);
  QVERIFY(engine.snapshot()->state[part::model] == before);
}

void ModelEditsTest::AnotherModelIsNotChecked() {
  QFETCH(Runner, runner);
  Engine engine(real_options(runner));
  engine.wait(engine.post(ImportMesh{}));
  QVERIFY(!is_model_checked(engine.snapshot()->state));
  engine.wait(engine.post(CheckModel{{true}}));
  QVERIFY(is_model_checked(engine.snapshot()->state));
  engine.wait(engine.post(CheckModel{{false}}));
  QVERIFY(!is_model_checked(engine.snapshot()->state));
  engine.wait(engine.post(CheckModel{{true}}));
  const Points& nodes = engine.snapshot()->state[part::model]->model.vessels.at(0).nodes;
  engine.wait(engine.post(EditTrees{{root_at(nodes.bottomRows(1).transpose())}}));
  QVERIFY(!is_model_checked(engine.snapshot()->state));
  engine.wait(engine.post(CheckModel{{true}}));
  engine.wait(engine.post(ImportMesh{}));
  QVERIFY(!is_model_checked(engine.snapshot()->state));
}

/// The root's setting goes through the same door as a model that was built.
void ModelEditsTest::VesselsOutsideOfTheMeshAreTold() {
  for (const double off : {0.0, 0.07}) {  // metres, along a vessel of 100 mm
    auto moved = std::make_shared<model::BuiltModel>(*patient());
    moved->model.vessels.at(0).nodes.col(0).array() += off;
    CaseState state;
    state[part::model] = moved;
    const Eigen::Vector3d end = moved->model.vessels.at(0).nodes.bottomRows(1).transpose();
    const auto told = apply(state, Command(EditTrees{{root_at(end)}}), RunContext());
    const bool is_off = off > 0.0;
    QCOMPARE(told->figures.at("model_beams_outside") > 0.0, is_off);
    QCOMPARE(told->figures.at("model_vessel_nodes_outside") > 0.0, is_off);
    const auto is_note = [](const std::string& note) { return note.starts_with("vessels.beams_outside "); };
    QCOMPARE(std::ranges::count_if(told->notes, is_note), is_off ? 1 : 0);
    // It is said of the trees as they are.
    const auto again = apply(told->state, Command(EditTrees{}), RunContext());
    QCOMPARE(std::ranges::count_if(again->notes, is_note), is_off ? 1 : 0);
    const auto& kept = again->state[part::model]->report.notes;
    QCOMPARE(std::ranges::count_if(kept, is_note), is_off ? 1 : 0);
  }
}

void ModelEditsTest::LabelsThatNobodyApprovedAreNamed() {
  CaseState state;
  QVERIFY(unapproved_labels(state).empty());
  VolumeGrid grid;
  grid.size = {8, 8, 8};
  LabelMap labels{LabelVolume(grid), {}};
  const std::vector<Label> present = {structure::kParenchyma, structure::kPortalVein,
                                      structure::kHepaticVeins, structure::kFirstOther,
                                      structure::kFirstLesion};
  for (std::size_t i = 0; i < present.size(); ++i) labels.voxels.set({static_cast<int>(i), 1, 1}, present[i]);
  state[part::labels] = std::make_shared<const LabelMap>(labels);
  state[part::review] =
      std::make_shared<const Review>(Review{{structure::kParenchyma, ReviewState::approved},
                                            {structure::kPortalVein, ReviewState::to_review},
                                            {structure::kVenaCava, ReviewState::in_progress}});
  const std::map<ReviewState, std::vector<Label>> wanted = {
      {ReviewState::not_started, {structure::kHepaticVeins, structure::kFirstLesion}},
      {ReviewState::to_review, {structure::kPortalVein}}};
  QVERIFY(unapproved_labels(state) == wanted);  // models hold nothing of the other
  state[part::statistics] = std::make_shared<const segmentation::LabelStatistics>(labels, nullptr);
  QVERIFY(unapproved_labels(state) == wanted);
  QCOMPARE(unapproved_notes(state),
           (std::vector<std::string>{"label.not_started hepatic_veins", "label.not_started lesion_1",
                                     "label.to_review portal_vein"}));
}

void ModelEditsTest::WithoutAModelThereIsNothingToEditOrCheck() {
  Engine engine(real_options(Runner::inline_));
  QCOMPARE(engine.wait(engine.post(EditTrees{})).status, Status::failed);
  QCOMPARE(engine.wait(engine.post(CheckModel{{true}})).status, Status::failed);
}

QTEST_APPLESS_MAIN(ModelEditsTest)
#include "model_edits_test.moc"
