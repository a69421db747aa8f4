// SPDX-License-Identifier: GPL-3.0-or-later
// What a person did to a case, its image or its labels is not done to what has taken their place since.
#include <QTest>

#include "complaint.h"
#include "gate.h"
#include "glisson/core/files.h"
#include "glisson/editing/tools/threshold.h"
#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/check_model.h"
#include "glisson/engine/commands/choose_rival.h"
#include "glisson/engine/commands/decide_segmentation.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/edit_trees.h"
#include "glisson/engine/commands/export_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/preview_edit.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/take_registration.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/review.h"
#include "glisson/registration/refusal.h"
#include "labelled_ct.h"
#include "runners.h"
#include "seeded_case.h"

using namespace glisson;
using namespace glisson::engine;
using editing::Edit;
using test::Gate;
using test::write_ct;
namespace fs = std::filesystem;

namespace {

Edit ball(double radius_mm) { return test::ball({40, 36, 42}, radius_mm); }

/// All voxels between two values.
Edit threshold(double low, double high) {
  editing::Threshold tool;
  tool.label = structure::kParenchyma;
  tool.low = low;
  tool.high = high;
  return {tool, {}};
}

/// Threaded; a command T waits at the gate before it does anything.
template <class T>
std::unique_ptr<Engine> held(Gate& gate) {
  Engine::Options options;
  options.apply = [&gate](const CaseState& state, const Command& command, const RunContext& context,
                          const Services&) {
    if (command.as<T>() != nullptr) gate.pass();
    return apply(state, command, context);
  };
  return std::make_unique<Engine>(std::move(options));
}

Status done(Engine& engine, Command command) { return test::done(engine, std::move(command)).status; }

}  // namespace

class LateActsTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { folder_ = std::make_unique<TemporaryFolder>(); }
  void cleanup() { folder_.reset(); }
  void WhatIsDoneWhileAnotherCaseOpensIsNotDoneToIt();
  void ACaseThatIsChosenWhileAnotherOpensIsOpened();
  void LabelsThatNobodyHasSeenAreNotApproved();
  void WhatNobodyHasSeenIsNotAccepted();
  void AModelThatComesWhileAPersonClicksIsNotChecked();
  void APreviewOfAFormerImageIsNotApplied();
  void ThereIsNoWayBackToLabelsOfAFormerImage();

 private:
  fs::path at(const char* name) const { return folder_->path() / name; }
  std::unique_ptr<TemporaryFolder> folder_;
};

void LateActsTest::WhatIsDoneWhileAnotherCaseOpensIsNotDoneToIt() {
  {
    Engine maker(test::options_of(Runner::inline_));
    QCOMPARE(done(maker, test::seeds(0.2)), Status::done);
    QCOMPARE(done(maker, SaveCase{at("b.glisson")}), Status::done);
  }
  Gate gate;
  const auto engine = held<OpenCase>(gate);
  QCOMPARE(done(*engine, test::seeds(0.1)), Status::done);
  const std::uint64_t shown = engine->snapshot()->case_number;
  const CommandId open = engine->post(OpenCase{at("b.glisson")}, shown);
  const CommandId act = engine->post(test::seeds(0.3), shown);
  const CommandId of_a_script = engine->post(SetReview{1, ReviewState::approved});
  gate.open();
  QCOMPARE(engine->wait(open).status, Status::done);
  QCOMPARE(engine->wait(act).status, Status::cancelled);
  QCOMPARE(engine->wait(of_a_script).status, Status::done);  // meant for whatever case there is
  QCOMPARE(test::seed_of(engine->snapshot()->state), 0.2);
  QVERIFY(engine->snapshot()->case_number != shown);
  QCOMPARE(engine->wait(engine->post(test::seeds(0.4), engine->snapshot()->case_number)).status,
           Status::done);
}

void LateActsTest::ACaseThatIsChosenWhileAnotherOpensIsOpened() {
  for (const double seed : {0.1, 0.2}) {
    Engine maker(test::options_of(Runner::inline_));
    done(maker, test::seeds(seed));
    QCOMPARE(done(maker, SaveCase{at(seed < 0.15 ? "a.glisson" : "b.glisson")}), Status::done);
  }
  Gate gate;
  const auto engine = held<OpenCase>(gate);
  const std::uint64_t shown = engine->snapshot()->case_number;
  engine->post(OpenCase{at("a.glisson")}, shown);
  const CommandId second = engine->post(OpenCase{at("b.glisson")}, shown);
  gate.open();
  QCOMPARE(engine->wait(second).status, Status::done);
  QCOMPARE(test::seed_of(engine->snapshot()->state), 0.2);
}

void LateActsTest::LabelsThatNobodyHasSeenAreNotApproved() {
  write_ct(at("ct.nrrd"), 60);
  Engine engine(test::options_of(Runner::inline_));
  QCOMPARE(done(engine, ImportImage{at("ct.nrrd")}), Status::done);
  QCOMPARE(done(engine, EditLabels{ball(8.0)}), Status::done);
  const auto seen = engine.snapshot()->state[part::labels];
  QCOMPARE(done(engine, EditLabels{ball(12.0)}), Status::done);
  const Outcome refused =
      engine.wait(engine.post(SetReview{structure::kParenchyma, ReviewState::approved, seen}));
  QCOMPARE(refused.status, Status::failed);
  QVERIFY2(refused.error.find("has changed since it was looked at") != std::string::npos,
           refused.error.c_str());
  const auto& review = engine.snapshot()->state[part::review];
  QVERIFY(review->at(structure::kParenchyma) != ReviewState::approved);
  const auto now = engine.snapshot()->state[part::labels];
  QCOMPARE(done(engine, SetReview{structure::kParenchyma, ReviewState::approved, now}), Status::done);
}

void LateActsTest::WhatNobodyHasSeenIsNotAccepted() {
  Registration refused;
  refused.doubts = {registration::kRefused};
  const auto seen = std::make_shared<const Registration>(refused);
  CaseState state;
  state[part::registration] = std::make_shared<const Registration>(refused);
  state[part::model] = std::make_shared<const model::BuiltModel>();
  state[part::offer] = std::make_shared<const SegmentationOffer>();
  state[part::proposals] = std::make_shared<const atlas::Transfer>();
  state[part::other_registration] = std::make_shared<const OtherRegistration>();
  const auto told = [&state](const Command& command) {
    return test::complaint([&] { command.apply(state, RunContext(), plain_services()); });
  };
  const auto is_unseen = [&](const Command& command, const char* what) {
    return told(command).starts_with(std::string("case: ") + what + ": has changed since it was looked at");
  };
  QVERIFY(is_unseen(AcceptRegistration{seen}, "registration"));
  QVERIFY(is_unseen(ChooseRival{0, seen}, "registration"));
  QVERIFY(is_unseen(CheckModel{{true}, std::make_shared<const model::BuiltModel>()}, "model"));
  QVERIFY(is_unseen(SetLandmarks{{}, std::make_shared<const model::BuiltModel>()}, "model"));
  QVERIFY(is_unseen(EditTrees{{}, std::make_shared<const model::BuiltModel>()}, "model"));
  ReviewProposal review;
  review.seen = std::make_shared<const atlas::Transfer>();
  QVERIFY(is_unseen(review, "proposals"));
  QVERIFY(is_unseen(TakeRegistration{std::make_shared<const OtherRegistration>()}, "other_registration"));
  for (const auto choice : {DecideSegmentation::Choice::take, DecideSegmentation::Choice::keep_all})
    QVERIFY(
        is_unseen(DecideSegmentation{choice, true, std::make_shared<const SegmentationOffer>()}, "offer"));
  // What was seen, and what a script says of whatever there is.
  QVERIFY(told(AcceptRegistration{state[part::registration]}).empty());
  QVERIFY(told(AcceptRegistration{}).empty());
  QVERIFY(told(CheckModel{{true}, state[part::model]}).empty());
  QVERIFY(told(SetLandmarks{{}, state[part::model]}).empty());
  QVERIFY(told(DecideSegmentation{DecideSegmentation::Choice::keep_all, true, state[part::offer]}).empty());
}

void LateActsTest::AModelThatComesWhileAPersonClicksIsNotChecked() {
  Gate gate;
  Engine::Options options;
  options.apply = [&gate, built = 0](const CaseState& state, const Command& command,
                                     const RunContext& context,
                                     const Services& services) mutable -> Cancellable<Applied> {
    if (command.as<BuildModel>() == nullptr) return apply(state, command, context, services);
    if (built++ > 0) gate.pass();
    Applied applied{state};
    applied.state[part::model] = std::make_shared<const model::BuiltModel>();
    return applied;
  };
  Engine engine(std::move(options));
  QCOMPARE(done(engine, BuildModel{}), Status::done);
  const auto seen = engine.snapshot()->state[part::model];
  engine.post(BuildModel{});
  gate.wait_for_arrival();
  const CommandId click = engine.post(CheckModel{{true}, seen});
  gate.open();
  QCOMPARE(engine.wait(click).status, Status::failed);
  QVERIFY(!is_model_checked(engine.snapshot()->state));
  QCOMPARE(done(engine, CheckModel{{true}, engine.snapshot()->state[part::model]}), Status::done);
  QVERIFY(is_model_checked(engine.snapshot()->state));
}

void LateActsTest::APreviewOfAFormerImageIsNotApplied() {
  write_ct(at("arterial.nrrd"), 60);
  write_ct(at("portal.nrrd"), 120);
  Engine engine(test::options_of(Runner::inline_));
  QCOMPARE(done(engine, ImportImage{at("arterial.nrrd")}), Status::done);
  QCOMPARE(done(engine, PreviewEdit{threshold(50.0, 70.0)}), Status::done);
  QCOMPARE(engine.snapshot()->stage(part::preview), StageState::current);
  QCOMPARE(done(engine, ImportImage{at("portal.nrrd")}), Status::done);
  const Outcome outcome = engine.wait(engine.post(EditLabels{threshold(50.0, 70.0)}));
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(outcome.figures.at("voxels_changed"), 0.0);  // nothing of the portal phase is so dark
}

void LateActsTest::ThereIsNoWayBackToLabelsOfAFormerImage() {
  write_ct(at("arterial.nrrd"), 60);
  write_ct(at("portal.nrrd"), 120);
  Engine engine(test::options_of(Runner::inline_));
  QCOMPARE(done(engine, ImportImage{at("arterial.nrrd")}), Status::done);
  QCOMPARE(done(engine, EditLabels{ball(8.0)}), Status::done);
  QCOMPARE(done(engine, ExportLabels{at("labels.seg.nrrd")}), Status::done);
  QCOMPARE(done(engine, EditLabels{ball(12.0)}), Status::done);
  QCOMPARE(done(engine, ImportImage{at("portal.nrrd")}), Status::done);
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::stale);
  QCOMPARE(done(engine, ImportLabels{at("labels.seg.nrrd"), {}}), Status::done);
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::current);
  QCOMPARE(done(engine, UndoLabels{}), Status::failed);
  QCOMPARE(engine.snapshot()->stage(part::labels), StageState::current);
  // Of this image there is.
  QCOMPARE(done(engine, EditLabels{ball(12.0)}), Status::done);
  QCOMPARE(done(engine, UndoLabels{}), Status::done);
}

QTEST_GUILESS_MAIN(LateActsTest)
#include "late_acts_test.moc"
