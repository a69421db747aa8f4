// SPDX-License-Identifier: GPL-3.0-or-later
// Labels edited by hand through the engine: steps, previews, review, and edits beside long work. What of them
// comes with files and cases is in kept_labels_test.cpp.
#include <QTest>

#include "gate.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/export_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/preview_edit.h"
#include "glisson/engine/commands/redo_labels.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/engine/parts/review.h"
#include "labelled_ct.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;
using namespace glisson::test;
using editing::Edit;

class LabelsTest : public QObject {
  Q_OBJECT
 private slots:
  void AnEditIsAStepThatCanBeUndoneAndRedone_data() { both_runners(); }
  void AnEditIsAStepThatCanBeUndoneAndRedone();
  void ThePiecesOfAStrokeAreOneStep_data() { both_runners(); }
  void ThePiecesOfAStrokeAreOneStep();
  void APreviewChangesNothingAndConfirmingItGivesThatResult_data() { both_runners(); }
  void APreviewChangesNothingAndConfirmingItGivesThatResult();
  void AnEditMakesThePreviewGo_data() { both_runners(); }
  void AnEditMakesThePreviewGo();
  void WhatWasApprovedAndIsTouchedMustBeLookedAtAgain_data() { both_runners(); }
  void WhatWasApprovedAndIsTouchedMustBeLookedAtAgain();
  void AFailedEditLeavesEverythingAsItWas_data() { both_runners(); }
  void AFailedEditLeavesEverythingAsItWas();
  void ReviewMakesNothingStaleAndEditsDo();
  void EditsGoOnWhileAModelIsBuiltWhichIsStaleThen();
  void AnEditThatChangesNothingOutdatesNothing_data() { both_runners(); }
  void AnEditThatChangesNothingOutdatesNothing();
  void NothingToUndoOrToDrawOnIsSaid();
  void WhatAHandCorrectedIsReplacedOnlyWhenThatIsSaid();
  void TheContourIsSeenWhileItEvolvesAndIsGoneThen_data() { both_runners(); }
  void TheContourIsSeenWhileItEvolvesAndIsGoneThen();
  void NoContourIsDrawnWhereNobodyLooks();
};

void LabelsTest::AnEditIsAStepThatCanBeUndoneAndRedone() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  QCOMPARE(done(*engine, EditLabels{ball({40, 36, 42}, 10)}).status, Status::done);
  const long painted = voxels(*engine, structure::kParenchyma);
  QVERIFY(painted > 200);
  QCOMPARE(done(*engine, EditLabels{ball({40, 36, 42}, 5, structure::kPortalVein)}).status, Status::done);
  QVERIFY(voxels(*engine, structure::kParenchyma) < painted);
  QCOMPARE(engine->snapshot()->state[part::history]->undo_name().label, structure::kPortalVein);
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  QCOMPARE(voxels(*engine, structure::kParenchyma), painted);
  QCOMPARE(voxels(*engine, structure::kPortalVein), 0L);
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  QCOMPARE(voxels(*engine, structure::kParenchyma), 0L);
  QVERIFY(engine->snapshot()->state[part::labels]->infos.empty());
  QCOMPARE(done(*engine, RedoLabels{}).status, Status::done);
  QCOMPARE(voxels(*engine, structure::kParenchyma), painted);
}

void LabelsTest::ThePiecesOfAStrokeAreOneStep() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  for (int n = 0; n < 10; ++n) done(*engine, EditLabels{ball({20.0 + 4.0 * n, 36, 42}, 6), 3});
  QCOMPARE(engine->snapshot()->state[part::history]->steps().size(), std::size_t{1});
  done(*engine, UndoLabels{});
  QCOMPARE(voxels(*engine, structure::kParenchyma), 0L);
}

void LabelsTest::APreviewChangesNothingAndConfirmingItGivesThatResult() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  done(*engine, EditLabels{ball({40, 36, 42}, 10)});
  const auto before = engine->snapshot()->state[part::labels];
  QCOMPARE(done(*engine, PreviewEdit{grown(4.0)}).status, Status::done);
  auto snapshot = engine->snapshot();
  QCOMPARE(snapshot->state[part::labels], before);
  QVERIFY(snapshot->state[part::preview]->result.voxels_changed > 100);
  QCOMPARE(snapshot->stage(part::preview), StageState::current);
  const LabelVolume promised = snapshot->state[part::preview]->result.labels.voxels;
  done(*engine, EditLabels{grown(4.0)});
  snapshot = engine->snapshot();
  QVERIFY(snapshot->state[part::labels]->voxels == promised);
  // It is that very result, not another computation of it.
  QCOMPARE(snapshot->state[part::labels]->voxels.bricks_differing_from(promised), 0);
  QVERIFY(!snapshot->state[part::preview]);
  // A preview that nobody wants goes and leaves nothing.
  done(*engine, PreviewEdit{grown(4.0)});
  done(*engine, PreviewEdit{});
  QVERIFY(!engine->snapshot()->state[part::preview]);
  QCOMPARE(engine->snapshot()->state[part::labels], snapshot->state[part::labels]);
}

void LabelsTest::AnEditMakesThePreviewGo() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  done(*engine, EditLabels{ball({40, 36, 42}, 10)});
  done(*engine, PreviewEdit{grown(4.0)});
  done(*engine, EditLabels{ball({20, 20, 42}, 4)});
  QVERIFY(!engine->snapshot()->state[part::preview]);
}

void LabelsTest::WhatWasApprovedAndIsTouchedMustBeLookedAtAgain() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  const auto review = [&](Label label) { return engine->snapshot()->state[part::review]->at(label); };
  done(*engine, EditLabels{ball({40, 36, 42}, 10)});
  QCOMPARE(review(structure::kParenchyma), ReviewState::in_progress);
  done(*engine, SetReview{structure::kParenchyma, ReviewState::approved});
  QCOMPARE(review(structure::kParenchyma), ReviewState::approved);
  done(*engine, EditLabels{ball({10, 10, 10}, 3, structure::kArtery)});  // touches background only
  QCOMPARE(review(structure::kParenchyma), ReviewState::approved);
  done(*engine, EditLabels{ball({40, 36, 42}, 3, structure::kPortalVein)});
  QCOMPARE(review(structure::kParenchyma), ReviewState::to_review);
  QCOMPARE(review(structure::kPortalVein), ReviewState::in_progress);
}

void LabelsTest::AFailedEditLeavesEverythingAsItWas() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  done(*engine, EditLabels{ball({40, 36, 42}, 10)});
  const auto before = engine->snapshot();
  const Outcome outcome = done(*engine, EditLabels{ball({40, 36, 42}, -1)});
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY(outcome.error.find("radius") != std::string::npos);
  QCOMPARE(engine->snapshot()->revision, before->revision);
}

void LabelsTest::ReviewMakesNothingStaleAndEditsDo() {
  const CtFolder files;
  const auto engine = engine_of(
      Runner::inline_, files,
      [](const CaseState& state, const Command& command, const RunContext& context, const Services&) {
        if (!(command.as<BuildModel>() != nullptr)) return engine::apply(state, command, context);
        Applied applied{state, {}, {}};
        applied.state[part::model] = std::make_shared<model::BuiltModel>();
        return Cancellable<Applied>(std::move(applied));
      });
  done(*engine, EditLabels{ball({40, 36, 42}, 10)});
  done(*engine, BuildModel{});
  done(*engine, SetReview{structure::kParenchyma, ReviewState::approved});
  done(*engine, PreviewEdit{grown(2.0)});
  QCOMPARE(engine->snapshot()->stage(part::model), StageState::current);
  QCOMPARE(engine->snapshot()->stage(part::labels), StageState::current);
  done(*engine, EditLabels{ball({20, 20, 42}, 4)});
  QCOMPARE(engine->snapshot()->stage(part::model), StageState::stale);
  QCOMPARE(engine->snapshot()->stage(part::review), StageState::current);
  // Labels that were drawn on a CT which is no longer there are old, however much one draws on them.
  done(*engine, ImportImage{files.path() / "ct.nrrd"});
  QCOMPARE(engine->snapshot()->stage(part::labels), StageState::stale);
  done(*engine, EditLabels{ball({20, 20, 42}, 5)});
  QCOMPARE(engine->snapshot()->stage(part::labels), StageState::stale);
}

void LabelsTest::EditsGoOnWhileAModelIsBuiltWhichIsStaleThen() {
  const CtFolder files;
  auto gate = std::make_shared<Gate>();
  const auto engine = engine_of(
      Runner::threaded, files,
      [gate](const CaseState& state, const Command& command, const RunContext& context, const Services&) {
        if (!(command.as<BuildModel>() != nullptr)) return engine::apply(state, command, context);
        gate->pass();
        Applied applied{state, {}, {}};
        applied.state[part::model] = std::make_shared<model::BuiltModel>();
        return Cancellable<Applied>(std::move(applied));
      });
  done(*engine, EditLabels{ball({40, 36, 42}, 10)});
  const CommandId build = engine->post(BuildModel{});
  gate->wait_for_arrival();
  const long before = voxels(*engine, structure::kParenchyma);
  QCOMPARE(done(*engine, EditLabels{ball({20, 20, 42}, 6)}).status, Status::done);  // would hang if it waited
  QVERIFY(voxels(*engine, structure::kParenchyma) > before);
  const long after = voxels(*engine, structure::kParenchyma);
  gate->open();
  QCOMPARE(engine->wait(build).status, Status::done);
  QCOMPARE(engine->snapshot()->stage(part::model), StageState::stale);
  QCOMPARE(voxels(*engine, structure::kParenchyma), after);  // the model's commit did not undo the edit
}

void LabelsTest::AnEditThatChangesNothingOutdatesNothing() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  const Edit liver = ball({40, 36, 42}, 10);
  QCOMPARE(done(*engine, EditLabels{liver}).status, Status::done);
  const auto before = engine->snapshot()->state;
  const Outcome outcome = done(*engine, EditLabels{liver});
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(outcome.figures.at("voxels_changed"), 0.0);
  const auto& after = engine->snapshot()->state;
  QVERIFY(after[part::labels] == before[part::labels] && after[part::history] == before[part::history]);
  QCOMPARE(after.stamp(part::labels).revision, before.stamp(part::labels).revision);
}

void LabelsTest::NothingToUndoOrToDrawOnIsSaid() {
  Engine::Options options;
  options.runner = Runner::inline_;
  Engine engine(std::move(options));
  QVERIFY(done(engine, EditLabels{ball({0, 0, 0}, 5)}).error.find("Import a CT first") != std::string::npos);
  QVERIFY(done(engine, ExportLabels{"x.seg.nrrd"}).error.find("Segment the CT") != std::string::npos);
  QVERIFY(done(engine, UndoLabels{}).error.find("no step to undo") != std::string::npos);
  QVERIFY(done(engine, RedoLabels{}).error.find("no step to redo") != std::string::npos);
}

void LabelsTest::WhatAHandCorrectedIsReplacedOnlyWhenThatIsSaid() {
  const CtFolder files;
  const auto engine = engine_of(Runner::inline_, files);
  segmentation::Seeds seeds;
  seeds.liver = PointsIn<CtFrame>::Constant(1, 3, 0.03);
  seeds.lesions = {PointsIn<CtFrame>::Constant(1, 3, 0.03)};
  QCOMPARE(done(*engine, SetSeeds{seeds}).status, Status::done);
  const auto state = [&]() -> const CaseState& { return engine->snapshot()->state; };
  QVERIFY(Segment{}.would_replace(state()).empty());
  QCOMPARE(done(*engine, EditLabels{ball({40, 36, 42}, 10, structure::kPortalVein)}).status, Status::done);
  QCOMPARE(done(*engine, EditLabels{ball({20, 20, 22}, 6, structure::kFirstLesion)}).status, Status::done);
  const std::set<Label> both{structure::kPortalVein, structure::kFirstLesion};
  QCOMPARE(Segment{}.would_replace(state()), both);
  const LabelVolume before = state()[part::labels]->voxels;
  const Outcome refused = done(*engine, Segment{});
  QCOMPARE(refused.status, Status::failed);
  QVERIFY2(refused.error.find("portal_vein, lesion_1") != std::string::npos, refused.error.c_str());
  QVERIFY(refused.error.find("--replace-edited") != std::string::npos);
  QVERIFY(state()[part::labels]->voxels == before);
  // Only what is found anew: the portal vein has no seed, the lesion has one.
  Segment some;
  some.options.structures = {false, true, false, false, false, true};
  QCOMPARE(some.would_replace(state()), std::set<Label>{structure::kFirstLesion});
  some.options.structures.lesions = false;
  QVERIFY(some.would_replace(state()).empty());
  Segment locked;
  locked.options.locked = {structure::kPortalVein, structure::kFirstLesion};
  QVERIFY(locked.would_replace(state()).empty());
  // What was undone is no correction, nor is what came with a file.
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  QCOMPARE(Segment{}.would_replace(state()), std::set<Label>{structure::kPortalVein});
  QCOMPARE(done(*engine, EditLabels{ball({60, 36, 42}, 9)}).status, Status::done);
  QCOMPARE(done(*engine, ExportLabels{files.path() / "l.seg.nrrd"}).status, Status::done);
  QCOMPARE(done(*engine, UndoLabels{}).status, Status::done);
  const Outcome imported = done(*engine, ImportLabels{files.path() / "l.seg.nrrd", {}});
  QVERIFY2(imported.status == Status::done, imported.error.c_str());
  QVERIFY(Segment{}.would_replace(state()).empty());
  // A case that is opened again still knows.
  QCOMPARE(done(*engine, EditLabels{ball({40, 36, 42}, 14, structure::kPortalVein)}).status, Status::done);
  QCOMPARE(done(*engine, SaveCase{files.path() / "c.glisson"}).status, Status::done);
  QCOMPARE(done(*engine, OpenCase{files.path() / "c.glisson"}).status, Status::done);
  QCOMPARE(Segment{}.would_replace(state()), std::set<Label>{structure::kPortalVein});
  Segment allowed;
  allowed.over_hand_work = OverHandWork::replace;
  QVERIFY(done(*engine, allowed).error.find("corrected by hand") == std::string::npos);
}

void LabelsTest::TheContourIsSeenWhileItEvolvesAndIsGoneThen() {
  QFETCH(Runner, runner);
  const CtFolder files;
  Engine* running = nullptr;
  std::vector<long> seen;
  const auto engine = engine_of(runner, files,
                                [&](const CaseState& state, const Command& command, const RunContext& context,
                                    const Services& services) {
                                  if (command.as<Segment>() == nullptr)
                                    return engine::apply(state, command, context);
                                  LabelVolume liver(state[part::image]->grid);
                                  for (int n = 0; n < 3; ++n) {
                                    liver.set({n, 0, 0}, 1);
                                    services.show_evolving(liver);
                                    seen.push_back(running->snapshot()->evolving->histogram()[1]);
                                  }
                                  return Cancellable<Applied>();  // cancelled
                                });
  running = engine.get();
  QCOMPARE(done(*engine, Segment{}).status, Status::cancelled);
  QCOMPARE(seen, (std::vector<long>{1, 2, 3}));
  QVERIFY(!engine->snapshot()->evolving);
}

void LabelsTest::NoContourIsDrawnWhereNobodyLooks() {
  std::vector<bool> is_asked_for;
  for (const bool somebody_looks : {false, true}) {
    Engine::Options options;
    options.runner = Runner::inline_;
    if (somebody_looks) options.wake = [] {};
    options.apply = [&](const CaseState&, const Command&, const RunContext&, const Services& services) {
      is_asked_for.push_back(services.show_evolving != nullptr);
      return Cancellable<Applied>();
    };
    Engine engine(std::move(options));
    engine.wait(engine.post(UndoLabels{}));
  }
  QCOMPARE(is_asked_for, (std::vector<bool>{false, true}));
}

QTEST_APPLESS_MAIN(LabelsTest)
#include "labels_test.moc"
