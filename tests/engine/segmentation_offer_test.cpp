// SPDX-License-Identifier: GPL-3.0-or-later
// A new segmentation over labels that a hand has corrected: what it would change is told, and a person
// decides.
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/engine/commands/decide_segmentation.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_locks.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/volume/io.h"

using namespace glisson;
using namespace glisson::engine;
using Choice = DecideSegmentation::Choice;

namespace {

// A liver of 36 mm about the origin: a hand adds a ball at its top, and takes a bite out of its front.
const Eigen::Vector3d kAdded(0.0, 0.0, 39.0), kBite(0.0, -30.0, 0.0);

Image small_ct() {
  Image image;
  image.grid.size = {40, 40, 36};
  image.grid.spacing_mm = {3.0, 3.0, 3.0};
  image.grid.origin_mm = {-58.5, -58.5, -52.5};
  std::vector<std::int16_t> voxels;
  for (int k = 0; k < 36; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        voxels.push_back(image.grid.p_in_ct(Eigen::Vector3d(i, j, k)).xyz.norm() < 36e-3 ? 110 : -100);
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return image;
}

/// Coarse: what is grown is soon there, and how well is not what these tests ask.
Segment growing(OverHandWork over_hand_work) {
  Segment segment;
  segment.options.working_spacing_mm = 4.0;
  segment.over_hand_work = over_hand_work;
  return segment;
}

/// Background: it is taken out of the liver.
editing::Edit ball(const Eigen::Vector3d& centre_mm, Label label) {
  editing::Paint paint;
  paint.label = label == structure::kBackground ? structure::kParenchyma : label;
  paint.erase = label == structure::kBackground;
  paint.brush = editing::Paint::Brush::ball;
  paint.radius = 9e-3;
  paint.path = 1e-3 * centre_mm.transpose();
  return {paint, {}};
}

}  // namespace

class SegmentationOfferTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void WhatIsOfferedIsToldAndChangesNothing();
  void TakenItReplacesAndUndoBringsTheCorrectionsBack();
  void CorrectionsAreKeptVoxelByVoxelAndAreAHandsStill();
  void AllIsKeptAndNothingIsAStep();
  void CorrectionsAreKeptAtOnceWhereThatWasSaid();
  void WithoutCorrectionsNothingIsOffered();
  void WhatDiffersNowhereIsNotAskedAbout();
  void ASavedCaseKeepsTheCorrectionsWhileAnOfferWaits();
  void AnEditLetsTheOfferGoAndOtherSeedsMakeItUnfit();
  void ADecisionNeedsAnOffer();
  void WhatIsLockedMeanwhileIsNotReplaced();

 private:
  Outcome done(Command command) { return engine_->wait(engine_->post(std::move(command))); }
  const CaseState& state() { return engine_->snapshot()->state; }
  const LabelVolume& labels() { return state()[part::labels]->voxels; }
  Label at(const Eigen::Vector3d& mm) {
    const Eigen::Vector3d index = labels().grid().index_of(Point<CtFrame>(1e-3 * mm));
    return labels().at(index.array().round().cast<int>().matrix());
  }
  void correct_and_offer();

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<Engine> engine_;
};

void SegmentationOfferTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  write_image(folder_->path() / "ct.nrrd", small_ct());
  Engine::Options options;
  options.runner = Runner::inline_;
  engine_ = std::make_unique<Engine>(std::move(options));
  QCOMPARE(done(ImportImage{folder_->path() / "ct.nrrd"}).status, Status::done);
  segmentation::Seeds seeds;
  seeds.liver = PointsIn<CtFrame>::Zero(1, 3);
  QCOMPARE(done(SetSeeds{seeds}).status, Status::done);
  QCOMPARE(done(growing(OverHandWork::refuse)).status, Status::done);
}

void SegmentationOfferTest::correct_and_offer() {
  QCOMPARE(done(EditLabels{ball(kAdded, structure::kParenchyma)}).status, Status::done);
  QCOMPARE(done(EditLabels{ball(kBite, structure::kBackground)}).status, Status::done);
  QCOMPARE(at(kAdded), structure::kParenchyma);
  QCOMPARE(at(kBite), structure::kBackground);
  const Outcome outcome = done(growing(OverHandWork::offer));
  QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
  QVERIFY(state()[part::offer] != nullptr);
}

void SegmentationOfferTest::WhatIsOfferedIsToldAndChangesNothing() {
  const LabelVolume grown = labels();
  correct_and_offer();
  const auto& offer = *state()[part::offer];
  QVERIFY(offer.labels.voxels == grown);  // the same seeds
  QCOMPARE(at(kAdded), structure::kParenchyma);
  QCOMPARE(offer.edited, std::set<Label>{structure::kParenchyma});
  // Exactly the hand's voxels differ from what growth finds.
  long added = 0, bitten = 0;
  const auto mine = labels().dense(), other = grown.dense();
  for (std::size_t n = 0; n < mine.size(); ++n) {
    added += mine[n] != 0 && other[n] == 0;
    bitten += mine[n] == 0 && other[n] != 0;
  }
  QVERIFY(added > 20 && bitten > 20);
  const LabelShift shift = offer.difference.labels.at(structure::kParenchyma);
  QCOMPARE(shift.lost, added);
  QCOMPARE(shift.gained, bitten);
  QCOMPARE(offer.difference.hand_voxels, added + bitten);
  QCOMPARE(offer.difference.hand_changed, added + bitten);
  const auto figures = done(growing(OverHandWork::offer)).figures;
  QCOMPARE(figures.at("gained_parenchyma_ml"), 0.027 * static_cast<double>(bitten));
  QCOMPARE(figures.at("lost_parenchyma_ml"), 0.027 * static_cast<double>(added));
  QCOMPARE(figures.at("hand_corrected_voxels_changed"), static_cast<double>(added + bitten));
}

void SegmentationOfferTest::TakenItReplacesAndUndoBringsTheCorrectionsBack() {
  const LabelVolume grown = labels();
  correct_and_offer();
  const LabelVolume mine = labels();
  QCOMPARE(done(DecideSegmentation{Choice::take}).status, Status::done);
  QVERIFY(labels() == grown && !state()[part::offer]);
  QVERIFY(edited_by_hand(state()).empty());
  QCOMPARE(engine_->snapshot()->stage(part::labels), StageState::current);
  QCOMPARE(done(UndoLabels{}).status, Status::done);
  QVERIFY(labels() == mine);
  QCOMPARE(edited_by_hand(state()), std::set<Label>{structure::kParenchyma});
}

void SegmentationOfferTest::CorrectionsAreKeptVoxelByVoxelAndAreAHandsStill() {
  correct_and_offer();
  const LabelVolume mine = labels(), hand = hand_corrected(state());
  QCOMPARE(done(DecideSegmentation{Choice::keep_all}).status, Status::done);
  // Other seeds let growth find something else beside the corrections.
  segmentation::Seeds seeds = *state()[part::seeds];
  seeds.background = PointsIn<CtFrame>::Zero(1, 3);
  seeds.background.row(0) = Eigen::RowVector3d(0.0, 0.0, -0.033);
  QCOMPARE(done(SetSeeds{seeds}).status, Status::done);
  QCOMPARE(done(growing(OverHandWork::offer)).status, Status::done);
  const LabelVolume offered = state()[part::offer]->labels.voxels;
  QCOMPARE(done(DecideSegmentation{Choice::keep_hand}).status, Status::done);
  QVERIFY(labels() == keeping_hand(mine, offered, hand));
  QVERIFY(!(labels() == mine) && !(labels() == offered));
  QCOMPARE(engine_->snapshot()->stage(part::labels), StageState::current);
  QVERIFY(hand_corrected(state()) == hand);
  QCOMPARE(Segment{}.would_replace(state()), std::set<Label>{structure::kParenchyma});
  QCOMPARE(done(UndoLabels{}).status, Status::done);
  QVERIFY(labels() == mine);
}

void SegmentationOfferTest::AllIsKeptAndNothingIsAStep() {
  correct_and_offer();
  const auto mine = state()[part::labels];
  const std::size_t steps = state()[part::history]->done();
  QCOMPARE(done(DecideSegmentation{Choice::keep_all}).status, Status::done);
  QVERIFY(state()[part::labels] == mine && !state()[part::offer]);
  QCOMPARE(state()[part::history]->done(), steps);
}

void SegmentationOfferTest::CorrectionsAreKeptAtOnceWhereThatWasSaid() {
  const LabelVolume grown = labels();
  correct_and_offer();
  const LabelVolume mine = labels();
  const Outcome kept = done(growing(OverHandWork::keep_hand));
  QCOMPARE(kept.status, Status::done);
  QVERIFY(labels() == mine && !state()[part::offer]);
  QVERIFY(kept.figures.at("hand_corrected_voxels_changed") > 40.0);
  const Outcome replaced = done(growing(OverHandWork::replace));
  QVERIFY(labels() == grown);
  QCOMPARE(replaced.figures.at("lost_parenchyma_ml"), kept.figures.at("lost_parenchyma_ml"));
}

void SegmentationOfferTest::WithoutCorrectionsNothingIsOffered() {
  QCOMPARE(done(growing(OverHandWork::offer)).status, Status::done);
  QVERIFY(!state()[part::offer]);
}

void SegmentationOfferTest::WhatDiffersNowhereIsNotAskedAbout() {
  // A hand that did what growth finds.
  QCOMPARE(done(EditLabels{ball({0, 0, 0}, structure::kBackground)}).status, Status::done);
  QCOMPARE(done(EditLabels{ball({0, 0, 0}, structure::kParenchyma)}).status, Status::done);
  QVERIFY(!Segment{}.would_replace(state()).empty());
  QCOMPARE(done(growing(OverHandWork::offer)).status, Status::done);
  QVERIFY(!state()[part::offer]);
}

void SegmentationOfferTest::ASavedCaseKeepsTheCorrectionsWhileAnOfferWaits() {
  correct_and_offer();
  const LabelVolume mine = labels();
  QCOMPARE(done(SaveCase{folder_->path() / "c.glisson"}).status, Status::done);
  QVERIFY(state()[part::offer] != nullptr);  // it waits on
  QCOMPARE(done(OpenCase{folder_->path() / "c.glisson"}).status, Status::done);
  QVERIFY(labels() == mine && !state()[part::offer]);
  QCOMPARE(edited_by_hand(state()), std::set<Label>{structure::kParenchyma});
}

void SegmentationOfferTest::AnEditLetsTheOfferGoAndOtherSeedsMakeItUnfit() {
  correct_and_offer();
  const LabelVolume mine = labels();
  segmentation::Seeds seeds = *state()[part::seeds];
  seeds.liver(0, 1) = 0.01;
  QCOMPARE(done(SetSeeds{seeds}).status, Status::done);
  const Outcome unfit = done(DecideSegmentation{Choice::take});
  QVERIFY2(unfit.error.find("other seeds") != std::string::npos, unfit.error.c_str());
  QVERIFY(labels() == mine);
  QCOMPARE(done(EditLabels{ball({0, 25, 0}, structure::kBackground)}).status, Status::done);
  QVERIFY(!state()[part::offer]);
}

void SegmentationOfferTest::ADecisionNeedsAnOffer() {
  QVERIFY(done(DecideSegmentation{Choice::take}).error.find("Segment first") != std::string::npos);
}

void SegmentationOfferTest::WhatIsLockedMeanwhileIsNotReplaced() {
  correct_and_offer();
  const LabelVolume mine = labels();
  QCOMPARE(done(SetLocks{{structure::kParenchyma}}).status, Status::done);
  const Outcome refused = done(DecideSegmentation{Choice::take});
  QVERIFY2(refused.error.find("parenchyma: is locked") != std::string::npos, refused.error.c_str());
  QVERIFY(labels() == mine && state()[part::offer]);
  QCOMPARE(done(SetLocks{}).status, Status::done);
  QCOMPARE(done(DecideSegmentation{Choice::take}).status, Status::done);
  QVERIFY(labels() != mine);
}

QTEST_APPLESS_MAIN(SegmentationOfferTest)
#include "segmentation_offer_test.moc"
