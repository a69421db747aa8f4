// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of labels stays with them: in the case, under a hand's edits, and back and forth in the steps.
#include <QTest>
#include <algorithm>

#include "ball_ct.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/correct_around.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/export_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/redo_labels.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/volume/io.h"
#include "labelled_ct.h"

using namespace glisson;
using namespace glisson::engine;
using namespace glisson::test;
using Notes = std::vector<std::string>;

namespace {

/// Of the ball that is the liver; metres.
const Eigen::Vector3d kMiddle(-0.08, 0.0, 0.0);
constexpr double kRadius = 36.0;  // mm

PointsIn<CtFrame> at_middle() { return kMiddle.transpose(); }

Segment coarse() {
  Segment segment;
  segment.options.working_spacing_mm = 4.0;
  segment.over_hand_work = OverHandWork::replace;
  return segment;
}

bool tells(const Notes& notes, const char* note) {
  return std::find(notes.begin(), notes.end(), note) != notes.end();
}

}  // namespace

class LabelNotesTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void TheyComeBackWithTheCase();
  void TheyFollowTheirClicks();
  void AClickThatCorrectsTakesNoneAway();
  void WhatTheLabelsAnswerGoesWithACorrection();
  void TheyGoBackAndForthWithTheSteps();
  void WhatIsToldOfAKeptLiverOutlastsANewSearchInIt();
  void WhatLiesOutsideOfARegionOrIsLockedIsToldStill();

 private:
  Outcome run(Command command) { return done(*engine_, std::move(command)); }
  Notes told() { return told_of_labels(engine_->snapshot()->state); }
  std::filesystem::path path(const char* name) const { return folder_->path() / name; }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<Engine> engine_;
};

void LabelNotesTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  write_image(path("ct.nrrd"), ball_ct(kRadius));
  Engine::Options options;
  options.runner = Runner::inline_;
  engine_ = std::make_unique<Engine>(std::move(options));
  QCOMPARE(run(ImportImage{path("ct.nrrd")}).status, Status::done);
  segmentation::Seeds seeds;
  seeds.liver = kMiddle.transpose().replicate(2, 1);
  seeds.liver(1, 1) = 0.05;  // in the fat
  QCOMPARE(run(SetSeeds{seeds}).status, Status::done);
  const Outcome segmented = run(coarse());
  QVERIFY2(segmented.status == Status::done, segmented.error.c_str());
  QCOMPARE(told(), segmented.notes);
  QVERIFY(tells(told(), "seed.liver_apart 2") && tells(told(), "liver.small"));
}

void LabelNotesTest::TheyComeBackWithTheCase() {
  const Notes before = told();
  QCOMPARE(run(EditLabels{ball({-80, 0, 39}, 9)}).status, Status::done);
  QCOMPARE(told(), before);
  QCOMPARE(run(SaveCase{path("a.glisson")}).status, Status::done);
  QCOMPARE(run(ImportImage{path("ct.nrrd")}).status, Status::done);
  QCOMPARE(run(OpenCase{path("a.glisson")}).status, Status::done);
  QCOMPARE(told(), before);
}

void LabelNotesTest::TheyFollowTheirClicks() {
  const Notes before = told();
  const auto of_seeds = [&] {
    Notes now = told();
    std::erase_if(now, [](const std::string& note) { return !note.starts_with("seed."); });
    return now;
  };
  const segmentation::Seeds both = *engine_->snapshot()->state[part::seeds];
  segmentation::Seeds second = both, first = both;
  second.liver = both.liver.bottomRows(1);
  first.liver = both.liver.topRows(1);
  QCOMPARE(run(SetSeeds{second}).status, Status::done);
  QCOMPARE(of_seeds(), Notes{"seed.liver_apart 1"});
  QCOMPARE(run(SaveCase{path("a.glisson")}).status, Status::done);
  QCOMPARE(run(OpenCase{path("a.glisson")}).status, Status::done);
  QCOMPARE(of_seeds(), Notes{"seed.liver_apart 1"});
  QCOMPARE(run(SetSeeds{first}).status, Status::done);
  QCOMPARE(of_seeds(), Notes{});
  // An edit in between does not lose it.
  QCOMPARE(run(EditLabels{ball({-80, 0, 39}, 9)}).status, Status::done);
  QCOMPARE(run(SetSeeds{both}).status, Status::done);
  QCOMPARE(told(), before);
}

void LabelNotesTest::WhatTheLabelsAnswerGoesWithACorrection() {
  // A hand joins what lies around the seed to the liver; then another click is followed.
  QCOMPARE(run(EditLabels{ball({-80, 46, 0}, 9)}).status, Status::done);
  QVERIFY(tells(told(), "seed.liver_apart 2"));
  const CorrectAround click{{{Point<CtFrame>(kMiddle + Eigen::Vector3d(0.0, 0.0, 0.03)), false}},
                            *engine_->snapshot()->state[part::seeds],
                            {}};
  const Outcome corrected = run(click);
  QVERIFY2(corrected.status == Status::done, corrected.error.c_str());
  QVERIFY(!tells(told(), "seed.liver_apart 2") && tells(told(), "liver.small"));
  QCOMPARE(run(UndoLabels{}).status, Status::done);
  QVERIFY(tells(told(), "seed.liver_apart 2"));
}

void LabelNotesTest::AClickThatCorrectsTakesNoneAway() {
  const Notes before = told();
  CorrectAround click{{{Point<CtFrame>(kMiddle + Eigen::Vector3d(0.0, 0.0, 0.03)), false}}, {}, {}};
  const Outcome corrected = run(click);
  QVERIFY2(corrected.status == Status::done, corrected.error.c_str());
  QVERIFY(corrected.figures.at("voxels_changed") > 0.0);
  for (const std::string& note : before) QVERIFY2(tells(told(), note.c_str()), note.c_str());
}

void LabelNotesTest::TheyGoBackAndForthWithTheSteps() {
  const Notes before = told();
  QCOMPARE(run(ExportLabels{path("l.seg.nrrd")}).status, Status::done);
  QCOMPARE(run(EditLabels{ball({-80, 0, 39}, 9)}).status, Status::done);
  const Outcome imported = run(ImportLabels{path("l.seg.nrrd"), {}});
  QVERIFY2(imported.status == Status::done, imported.error.c_str());
  QCOMPARE(told(), imported.notes);
  QVERIFY(told() != before);
  QCOMPARE(run(UndoLabels{}).status, Status::done);
  QCOMPARE(told(), before);
  // The case keeps both.
  QCOMPARE(run(SaveCase{path("a.glisson")}).status, Status::done);
  QCOMPARE(run(OpenCase{path("a.glisson")}).status, Status::done);
  QCOMPARE(run(RedoLabels{}).status, Status::done);
  QCOMPARE(told(), imported.notes);
  QCOMPARE(run(UndoLabels{}).status, Status::done);
  QCOMPARE(told(), before);
}

void LabelNotesTest::WhatIsToldOfAKeptLiverOutlastsANewSearchInIt() {
  segmentation::Seeds seeds = *engine_->snapshot()->state[part::seeds];
  seeds.lesions = {at_middle()};
  QCOMPARE(run(SetSeeds{seeds}).status, Status::done);
  Segment lesions = coarse();
  lesions.options.structures = segmentation::kNoStructures;
  lesions.options.structures.lesions = true;
  const Outcome outcome = run(lesions);
  QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
  QVERIFY(tells(told(), "seed.liver_apart 2"));
  const Notes now = told();
  QCOMPARE(std::count(now.begin(), now.end(), "liver.small"), 1);
  QCOMPARE(now, outcome.notes);
  // Found anew, it is told of anew.
  seeds.liver = at_middle();
  QCOMPARE(run(SetSeeds{seeds}).status, Status::done);
  QCOMPARE(run(coarse()).status, Status::done);
  QVERIFY(!tells(told(), "seed.liver_apart 2") && tells(told(), "liver.small"));
}

void LabelNotesTest::WhatLiesOutsideOfARegionOrIsLockedIsToldStill() {
  segmentation::Seeds seeds;
  seeds.liver = at_middle();
  seeds.lesions = {at_middle(), at_middle()};
  seeds.lesions[1](0, 0) += 0.03;
  QCOMPARE(run(SetSeeds{seeds}).status, Status::done);
  QCOMPARE(run(coarse()).status, Status::done);
  const auto of_lesion = [&](const char* lesion) {
    const Notes now = told();
    return std::count_if(now.begin(), now.end(),
                         [&](const std::string& note) { return note.starts_with(lesion); });
  };
  // In one tissue neither has a border.
  QVERIFY(of_lesion("lesion_1.") > 0 && of_lesion("lesion_2.") > 0);
  const auto first = of_lesion("lesion_1.");
  Segment second = coarse();
  second.options.structures = segmentation::kNoStructures;
  second.options.structures.lesions = true;
  second.options.region = Eigen::AlignedBox3d(kMiddle + Eigen::Vector3d(0.015, -0.03, -0.03),
                                              kMiddle + Eigen::Vector3d(0.05, 0.03, 0.03));
  const Outcome in_box = run(second);
  QVERIFY2(in_box.status == Status::done, in_box.error.c_str());
  QCOMPARE(of_lesion("lesion_1."), first);
  Segment locked = coarse();
  locked.options.structures = segmentation::kNoStructures;
  locked.options.structures.lesions = true;
  locked.options.locked = {structure::kFirstLesion};
  QCOMPARE(run(locked).status, Status::done);
  QCOMPARE(of_lesion("lesion_1."), first);
  // All of it locked: there is nothing to be done, which is said.
  locked.options.locked = {structure::kParenchyma};
  const Notes before = told();
  const Outcome refused = run(locked);
  QVERIFY2(refused.error.find("liver: is locked") != std::string::npos, refused.error.c_str());
  // So it is where nothing was clicked.
  Segment cava = coarse();
  cava.options.structures = segmentation::kNoStructures;
  cava.options.structures.vena_cava = true;
  const Outcome unclicked = run(cava);
  QVERIFY2(unclicked.error.find("vena_cava: has no point") != std::string::npos, unclicked.error.c_str());
  QCOMPARE(told(), before);
}

QTEST_APPLESS_MAIN(LabelNotesTest)
#include "label_notes_test.moc"
