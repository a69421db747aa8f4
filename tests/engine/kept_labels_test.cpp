// SPDX-License-Identifier: GPL-3.0-or-later
// What of labels edited by hand comes with a case or a label map, and what stays behind.
#include <QTest>

#include "gate.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/export_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/redo_labels.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_locks.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/locks.h"
#include "glisson/engine/parts/review.h"
#include "labelled_ct.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;
using namespace glisson::test;

class KeptLabelsTest : public QObject {
  Q_OBJECT
 private slots:
  void StepsReviewAndFiguresComeBackWithTheCase();
  void SlicersStatusIsKnownAndKept();
  void LocksComeBackWithTheCaseAndHoldAgainstAnImport();
  void ReviewComesWithTheLabelsThatItIsOf();
  void ANewCaseKeepsNothingOfTheFormerOne_data() { both_runners(); }
  void ANewCaseKeepsNothingOfTheFormerOne();
  void WhatIsSavedIsTheCaseAsItWasWhenTheSaveBegan();
};

void KeptLabelsTest::StepsReviewAndFiguresComeBackWithTheCase() {
  const CtFolder files;
  const auto engine = engine_of(Runner::inline_, files);
  done(*engine, EditLabels{ball({40, 36, 42}, 10)});
  done(*engine, EditLabels{ball({40, 36, 42}, 5, structure::kPortalVein)});
  done(*engine, UndoLabels{});
  done(*engine, SetReview{structure::kParenchyma, ReviewState::approved});
  const Outcome saved = done(*engine, SaveCase{files.path() / "a.glisson"});
  QVERIFY2(saved.status == Status::done, saved.error.c_str());
  const long painted = voxels(*engine, structure::kParenchyma);

  const auto other = engine_of(Runner::inline_, files);
  const Outcome opened = done(*other, OpenCase{files.path() / "a.glisson"});
  QVERIFY2(opened.status == Status::done, opened.error.c_str());
  const auto snapshot = other->snapshot();
  QVERIFY(snapshot->state[part::labels]->voxels == engine->snapshot()->state[part::labels]->voxels);
  QCOMPARE(snapshot->state[part::review]->at(structure::kParenchyma), ReviewState::approved);
  QCOMPARE(voxels(*other, structure::kParenchyma), painted);
  QVERIFY(snapshot->state[part::history]->can_undo() && snapshot->state[part::history]->can_redo());
  done(*other, RedoLabels{});
  QVERIFY(voxels(*other, structure::kPortalVein) > 0);
  done(*other, UndoLabels{});
  done(*other, UndoLabels{});
  QCOMPARE(voxels(*other, structure::kParenchyma), 0L);
}

void KeptLabelsTest::SlicersStatusIsKnownAndKept() {
  const CtFolder files;
  LabelMap labels;
  labels.voxels = LabelVolume(small_grid());
  labels.voxels.set({10, 10, 10}, structure::kParenchyma);
  labels.voxels.set({12, 10, 10}, structure::kFirstLesion);
  LabelInfo liver = structure_info(structure::kParenchyma), lesion = structure_info(structure::kFirstLesion);
  liver.status = "completed";
  lesion.status = "flagged";
  write_labels(files.path() / "labels.seg.nrrd", labels.voxels, {liver, lesion});
  const auto engine = engine_of(Runner::inline_, files);
  done(*engine, ImportLabels{files.path() / "labels.seg.nrrd", {}});
  QCOMPARE(engine->snapshot()->state[part::review]->at(structure::kParenchyma), ReviewState::approved);
  QCOMPARE(engine->snapshot()->state[part::review]->at(structure::kFirstLesion), ReviewState::to_review);
  done(*engine, SaveCase{files.path() / "a.glisson"});
  const LabelFile written = read_labels(files.path() / "a.glisson" / "labels.seg.nrrd");
  QCOMPARE(written.infos.size(), std::size_t{2});
  QCOMPARE(written.infos[0].status, std::string("completed"));
  QCOMPARE(written.infos[1].status, std::string("flagged"));
  // The same in a file of its own.
  QCOMPARE(done(*engine, ExportLabels{files.path() / "out.seg.nrrd"}).status, Status::done);
  const LabelFile exported = read_labels(files.path() / "out.seg.nrrd");
  QVERIFY(exported.voxels == labels.voxels);
  QCOMPARE(exported.infos[0].status, std::string("completed"));
}

void KeptLabelsTest::LocksComeBackWithTheCaseAndHoldAgainstAnImport() {
  const CtFolder files;
  const auto engine = engine_of(Runner::inline_, files);
  const auto export_to = [&](const char* file) {
    QCOMPARE(done(*engine, ExportLabels{files.path() / file}).status, Status::done);
  };
  done(*engine, EditLabels{ball({40, 36, 42}, 12)});
  done(*engine, EditLabels{ball({40, 36, 42}, 6, structure::kFirstLesion)});
  const long lesion = voxels(*engine, structure::kFirstLesion),
             liver = voxels(*engine, structure::kParenchyma);
  done(*engine, EditLabels{ball({22, 36, 42}, 9)});
  export_to("larger_liver.seg.nrrd");
  done(*engine, UndoLabels{});
  done(*engine, EditLabels{ball({40, 36, 42}, 8, structure::kFirstLesion)});
  export_to("larger_lesion.seg.nrrd");
  done(*engine, UndoLabels{});
  QCOMPARE(done(*engine, SetLocks{{structure::kFirstLesion}}).status, Status::done);
  QCOMPARE(done(*engine, SaveCase{files.path() / "a.glisson"}).status, Status::done);
  QCOMPARE(done(*engine, SetLocks{}).status, Status::done);
  QCOMPARE(done(*engine, OpenCase{files.path() / "a.glisson"}).status, Status::done);
  QCOMPARE(locked_in(engine->snapshot()->state), std::set<Label>{structure::kFirstLesion});
  const Outcome refused = done(*engine, ImportLabels{files.path() / "larger_lesion.seg.nrrd", {}});
  QVERIFY2(refused.error.find("lesion_1: is locked") != std::string::npos, refused.error.c_str());
  QCOMPARE(voxels(*engine, structure::kFirstLesion), lesion);
  const Outcome imported = done(*engine, ImportLabels{files.path() / "larger_liver.seg.nrrd", {}});
  QVERIFY2(imported.status == Status::done, imported.error.c_str());
  QVERIFY(voxels(*engine, structure::kParenchyma) > liver);
  // An edit that says nothing of locks leaves it as it is.
  done(*engine, EditLabels{ball({40, 36, 42}, 12)});
  QCOMPARE(voxels(*engine, structure::kFirstLesion), lesion);
}

void KeptLabelsTest::ReviewComesWithTheLabelsThatItIsOf() {
  const CtFolder files;
  LabelFile file;
  file.voxels = LabelVolume(small_grid());
  for (int i = 5; i < 20; ++i) {
    file.voxels.set({i, 9, 9}, 1);
    file.voxels.set({i, 12, 9}, 6);
    file.voxels.set({i, 15, 9}, 7);
  }
  const auto info = [](Label code, const char* name, const char* status) {
    LabelInfo made;
    made.code = code;
    made.name = name;
    made.status = status;
    return made;
  };
  file.infos = {info(1, "spleen", "completed"), info(6, "left", "completed"), info(7, "right", "inprogress")};
  write_labels(files.path() / "other.seg.nrrd", file.voxels, file.infos);
  const auto engine = engine_of(Runner::inline_, files);
  // Code 1 is Glisson's parenchyma, but here it is a spleen, which is dropped.
  const ImportLabels import{files.path() / "other.seg.nrrd",
                            {{6, structure::kParenchyma}, {7, structure::kParenchyma}}};
  const Outcome outcome = done(*engine, import);
  QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
  QCOMPARE(voxels(*engine, structure::kParenchyma), 30L);
  QVERIFY(*engine->snapshot()->state[part::review] ==
          (Review{{structure::kParenchyma, ReviewState::in_progress}}));
}

void KeptLabelsTest::ANewCaseKeepsNothingOfTheFormerOne() {
  QFETCH(Runner, runner);
  const CtFolder files;
  const auto engine = engine_of(runner, files);
  QCOMPARE(done(*engine, EditLabels{ball({40, 36, 42}, 10)}).status, Status::done);
  QCOMPARE(done(*engine, SaveCase{files.path() / "former.glisson"}).status, Status::done);
  QCOMPARE(done(*engine, ImportImage{files.path() / "ct.nrrd"}).status, Status::done);
  QVERIFY(engine->snapshot()->state[part::labels] && !engine->snapshot()->state.path.empty());
  QCOMPARE(engine->snapshot()->stage(part::labels), StageState::stale);
  QCOMPARE(done(*engine, ImportImage{files.path() / "none.nrrd", {}, true}).status, Status::failed);
  QVERIFY(engine->snapshot()->state[part::labels] != nullptr);
  QCOMPARE(done(*engine, ImportImage{files.path() / "ct.nrrd", {}, true}).status, Status::done);
  const CaseState& now = engine->snapshot()->state;
  QVERIFY(now.path.empty() && now[part::image] && !now[part::labels] && !now[part::history] &&
          !now[part::review]);
  QCOMPARE(done(*engine, SaveCase{}).status, Status::failed);  // not over the former patient
}

void KeptLabelsTest::WhatIsSavedIsTheCaseAsItWasWhenTheSaveBegan() {
  const CtFolder files;
  Gate gate;
  const auto engine = engine_of(
      Runner::threaded, files,
      [&gate](const CaseState& state, const Command& command, const RunContext& context, const Services&) {
        if ((command.as<SaveCase>() != nullptr)) gate.pass();
        return apply(state, command, context);
      });
  const Editions begun = editions(engine->snapshot()->state);
  const CommandId save = engine->post(SaveCase{files.path() / "case.glisson"});
  gate.wait_for_arrival();
  QCOMPARE(done(*engine, EditLabels{ball({40, 36, 42}, 10)}).status, Status::done);
  gate.open();
  const Outcome outcome = engine->wait(save);
  QCOMPARE(outcome.status, Status::done);
  QVERIFY(outcome.result.as<CaseOnDisk>()->editions == begun);
  QVERIFY(outcome.result.as<CaseOnDisk>()->editions != editions(engine->snapshot()->state));
  const Outcome opened = done(*engine, OpenCase{files.path() / "case.glisson"});
  QVERIFY(opened.result.as<CaseOnDisk>()->editions == editions(engine->snapshot()->state));
}

QTEST_APPLESS_MAIN(KeptLabelsTest)
#include "kept_labels_test.moc"
