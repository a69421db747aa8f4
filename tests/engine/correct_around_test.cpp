// SPDX-License-Identifier: GPL-3.0-or-later
// A click that corrects the liver, as a step of the case.
#include "glisson/engine/commands/correct_around.h"

#include <QTest>
#include <algorithm>

#include "ball_ct.h"
#include "glisson/core/files.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/engine/commands/decide_segmentation.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/set_locks.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/review.h"
#include "glisson/volume/io.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;
using test::both_runners;

namespace {

constexpr double kRadius = 40.0;  // mm
const Eigen::Vector3d kMiddle(-0.08, 0.0, 0.0);

Outcome done(Engine& engine, Command command) { return engine.wait(engine.post(std::move(command))); }

/// A case with a ball of liver, of which labels hold the middle only, if any.
std::unique_ptr<Engine> engine_of(Runner runner, bool with_labels) {
  TemporaryFolder folder;
  write_image(folder.path() / "ct.nrrd", test::ball_ct(kRadius));
  Engine::Options options;
  options.runner = runner;
  auto engine = std::make_unique<Engine>(std::move(options));
  if (done(*engine, ImportImage{folder.path() / "ct.nrrd"}).status != Status::done) return nullptr;
  editing::Paint paint;
  paint.label = structure::kParenchyma;
  paint.brush = editing::Paint::Brush::ball;
  paint.radius = 0.5e-3 * kRadius;
  paint.path = kMiddle.transpose();
  if (with_labels && done(*engine, EditLabels{{paint, {}}}).status != Status::done) return nullptr;
  return engine;
}

double ml_of(const Engine& engine) {
  return engine.snapshot()->state[part::statistics]->figures().at(structure::kParenchyma).ml;
}

CorrectAround click_at(const Eigen::Vector3d& p, bool is_liver) {
  return {{{Point<CtFrame>(p), is_liver}}, {}, {}};
}

/// A lesion that a hand has drawn, and a click beside its middle that finds another.
CorrectAround click_over_drawn_lesion(Engine& engine) {
  editing::Paint paint;
  paint.label = structure::kFirstLesion;
  paint.brush = editing::Paint::Brush::ball;
  paint.radius = 6e-3;
  paint.path = kMiddle.transpose();
  done(engine, EditLabels{{paint, {}}});
  CorrectAround command;
  command.seeds.lesions = {kMiddle.transpose()};
  command.seeds.lesions[0](0, 1) += 0.004;
  command.seeds.lesion_diameters_mm = {12.0};
  command.grown = {{structure::kFirstLesion,
                    Point<CtFrame>(Eigen::Vector3d(command.seeds.lesions[0].row(0).transpose()))}};
  return command;
}

}  // namespace

class CorrectAroundTest : public QObject {
  Q_OBJECT
 private slots:
  void AClickIsAStepThatCanBeUndone_data() { both_runners(); }
  void AClickIsAStepThatCanBeUndone();
  void SeveralClicksAreOneStepAndCountTogether();
  void AClickOnAVesselIsAStepOfIts();
  void ALesionsNotesComeWithItsClickAndGoWithIt();
  void AllThatClicksHaveWorkedOnIsWorkByHand();
  void ADrawnLesionIsNotReplacedUnasked();
  void AClickDoesNotLetAnOfferGo();
  void WhatWasApprovedIsToBeLookedAtAgain();
  void AClickThatSaysNothingNewOutdatesNothing();
  void WithoutLabelsThereIsNothingToCorrect();
  void ALockedLiverIsSaid();
  void WhatIsLockedInTheCaseIsSoWithoutAWord();
};

void CorrectAroundTest::AClickIsAStepThatCanBeUndone() {
  QFETCH(Runner, runner);
  const auto engine = engine_of(runner, true);
  const double before = ml_of(*engine);
  const Outcome outcome = done(*engine, click_at(kMiddle + Eigen::Vector3d(0.0, 0.032, 0.0), true));
  QCOMPARE(outcome.status, Status::done);
  QVERIFY(ml_of(*engine) > before + 20.0);
  QVERIFY(std::abs(outcome.figures.at("changed_ml") - (ml_of(*engine) - before)) < 1e-6);
  QVERIFY(edited_by_hand(engine->snapshot()->state).contains(structure::kParenchyma));
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  QCOMPARE(ml_of(*engine), before);
}

void CorrectAroundTest::SeveralClicksAreOneStepAndCountTogether() {
  const auto engine = engine_of(Runner::inline_, true);
  const double before = ml_of(*engine);
  CorrectAround command = click_at(kMiddle + Eigen::Vector3d(0.0, 0.032, 0.0), true);
  command.clicks.push_back(click_at(kMiddle + Eigen::Vector3d(0.0, -0.1, 0.07), true).clicks.front());
  command.clicks.push_back(click_at(kMiddle + Eigen::Vector3d(0.0, -0.032, 0.0), true).clicks.front());
  command.seeds.liver.resize(3, 3);
  for (Eigen::Index n = 0; n < 3; ++n)
    command.seeds.liver.row(n) = command.clicks[static_cast<std::size_t>(n)].p_in_ct.xyz.transpose();
  const Outcome outcome = done(*engine, command);
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(outcome.notes, std::vector<std::string>{"seed.liver_apart 2"});
  QVERIFY(std::abs(outcome.figures.at("changed_ml") - (ml_of(*engine) - before)) < 1e-6);
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  QCOMPARE(ml_of(*engine), before);
}

void CorrectAroundTest::AClickOnAVesselIsAStepOfIts() {
  const auto engine = engine_of(Runner::inline_, true);
  const auto before = engine->snapshot()->state[part::labels];
  // In a ball of one tissue there is no vessel: said, and nothing else.
  CorrectAround command;
  command.grown = {{structure::kPortalVein, Point<CtFrame>(kMiddle)}};
  const Outcome outcome = done(*engine, command);
  QCOMPARE(outcome.status, Status::done);
  QVERIFY(std::count(outcome.notes.begin(), outcome.notes.end(), "portal_vein.not_found") == 1);
  QCOMPARE(engine->snapshot()->state[part::labels], before);
}

void CorrectAroundTest::ALesionsNotesComeWithItsClickAndGoWithIt() {
  const auto engine = engine_of(Runner::inline_, true);
  const auto told = [&] { return told_of_labels(engine->snapshot()->state); };
  QVERIFY(told().empty());
  CorrectAround command;
  command.seeds.lesions = {kMiddle.transpose()};
  command.seeds.lesion_diameters_mm = {12.0};
  command.grown = {{structure::kFirstLesion, Point<CtFrame>(kMiddle)}};
  const Outcome outcome = done(*engine, command);
  QVERIFY2(outcome.status == Status::done && !outcome.notes.empty(), outcome.error.c_str());
  QVERIFY(outcome.figures.at("voxels_changed") > 0.0);
  QCOMPARE(told(), outcome.notes);
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  QVERIFY(told().empty());
}

void CorrectAroundTest::AllThatClicksHaveWorkedOnIsWorkByHand() {
  const auto engine = engine_of(Runner::inline_, true);
  CorrectAround command;
  command.seeds.lesions = {kMiddle.transpose(), kMiddle.transpose()};
  command.seeds.lesions[1](0, 1) += 0.012;
  command.seeds.lesion_diameters_mm = {9.0, 9.0};
  for (int n = 0; n < 2; ++n)
    command.grown.push_back({static_cast<Label>(structure::kFirstLesion + n),
                             Point<CtFrame>(Eigen::Vector3d(command.seeds.lesions[n].row(0).transpose()))});
  QCOMPARE(done(*engine, command).status, Status::done);
  const std::set<Label> by_hand = edited_by_hand(engine->snapshot()->state);
  for (const auto& click : command.grown) QVERIFY(by_hand.contains(click.structure));
}

void CorrectAroundTest::ADrawnLesionIsNotReplacedUnasked() {
  const auto engine = engine_of(Runner::inline_, true);
  const auto state = [&]() -> const CaseState& { return engine->snapshot()->state; };
  CorrectAround command = click_over_drawn_lesion(*engine);
  const LabelVolume drawn = state()[part::labels]->voxels;
  const Outcome refused = done(*engine, command);
  QVERIFY2(refused.error.find("lesion_1: was corrected by hand") != std::string::npos, refused.error.c_str());
  command.over_hand_work = OverHandWork::offer;
  const Outcome offered = done(*engine, command);
  QVERIFY2(offered.status == Status::done, offered.error.c_str());
  QVERIFY(state()[part::offer] && state()[part::labels]->voxels == drawn);
  QCOMPARE(state()[part::offer]->edited, std::set<Label>{structure::kFirstLesion});
  QCOMPARE(offered.figures.at("voxels_changed"), 0.0);
  QVERIFY(offered.figures.at("hand_corrected_voxels_changed") > 0.0);
  const LabelVolume found = state()[part::offer]->labels.voxels;
  using Choice = DecideSegmentation::Choice;
  QCOMPARE(done(*engine, DecideSegmentation{Choice::take, true, state()[part::offer]}).status, Status::done);
  QVERIFY(state()[part::labels]->voxels == found);
  // It is a click's now, and work by hand still, as the liver's is.
  QVERIFY(command.would_replace(state()).empty());
  QVERIFY(edited_by_hand(state()).contains(structure::kFirstLesion) &&
          edited_by_hand(state()).contains(structure::kParenchyma));
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  QVERIFY(state()[part::labels]->voxels == drawn);
  command.over_hand_work = OverHandWork::replace;
  QCOMPARE(done(*engine, command).status, Status::done);
  QVERIFY(state()[part::labels]->voxels == found && !state()[part::offer]);
}

void CorrectAroundTest::AClickDoesNotLetAnOfferGo() {
  const auto engine = engine_of(Runner::inline_, true);
  CorrectAround command = click_over_drawn_lesion(*engine);
  command.over_hand_work = OverHandWork::offer;
  QCOMPARE(done(*engine, command).status, Status::done);
  const auto offer = engine->snapshot()->state[part::offer];
  QVERIFY(offer != nullptr);
  CorrectAround next = click_at(kMiddle + Eigen::Vector3d(0.0, 0.032, 0.0), true);
  next.over_hand_work = OverHandWork::offer;
  const Outcome refused = done(*engine, next);
  QVERIFY2(refused.error.find("waits for a decision") != std::string::npos, refused.error.c_str());
  QCOMPARE(engine->snapshot()->state[part::offer], offer);
}

void CorrectAroundTest::WhatWasApprovedIsToBeLookedAtAgain() {
  const auto engine = engine_of(Runner::inline_, true);
  QCOMPARE(done(*engine, SetReview{structure::kParenchyma, ReviewState::approved}).status, Status::done);
  QCOMPARE(done(*engine, click_at(kMiddle, false)).status, Status::done);
  QCOMPARE(engine->snapshot()->state[part::review]->at(structure::kParenchyma), ReviewState::to_review);
}

void CorrectAroundTest::AClickThatSaysNothingNewOutdatesNothing() {
  const auto engine = engine_of(Runner::inline_, true);
  const auto before = engine->snapshot()->state[part::labels];
  const Outcome outcome = done(*engine, click_at(kMiddle, true));
  QCOMPARE(outcome.figures.at("voxels_changed"), 0.0);
  QCOMPARE(engine->snapshot()->state[part::labels], before);
}

void CorrectAroundTest::WithoutLabelsThereIsNothingToCorrect() {
  const auto engine = engine_of(Runner::inline_, false);
  const Outcome outcome = done(*engine, click_at(kMiddle, true));
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY(QString::fromStdString(outcome.error).contains(QLatin1String("labels")));
}

void CorrectAroundTest::ALockedLiverIsSaid() {
  const auto engine = engine_of(Runner::inline_, true);
  CorrectAround command = click_at(kMiddle, false);
  command.locked = {structure::kParenchyma};
  const Outcome outcome = done(*engine, command);
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY(QString::fromStdString(outcome.error).contains(QLatin1String("is locked")));
}

void CorrectAroundTest::WhatIsLockedInTheCaseIsSoWithoutAWord() {
  const auto engine = engine_of(Runner::inline_, true);
  const double before = ml_of(*engine);
  QCOMPARE(done(*engine, SetLocks{{structure::kParenchyma}}).status, Status::done);
  const Outcome outcome = done(*engine, click_at(kMiddle + Eigen::Vector3d(0.0, 0.032, 0.0), true));
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY(QString::fromStdString(outcome.error).contains(QLatin1String("is locked")));
  QCOMPARE(ml_of(*engine), before);
}

QTEST_APPLESS_MAIN(CorrectAroundTest)
#include "correct_around_test.moc"
