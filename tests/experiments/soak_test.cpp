// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/soak.h"

#include <QCoreApplication>
#include <QFile>
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/script.h"
#include "glisson/volume/io.h"
#include "kill_trial.h"
#include "small_case.h"
#include "soak_film.h"
#include "soak_run.h"

using namespace glisson;
using namespace glisson::experiments;

class SoakTest : public QObject {
  Q_OBJECT
 private slots:
  void ALeakIsSeen();
  void WhatStaysIsFlat();
  void OneMoreDescriptorIsALeak();
  void TooFewTimesSayNothing();
  void ACancelEndsTheWork();
  void WhatWasDoneBeforeACancelIsKept();
  void TheProcessIsMeasured();
  void TheFilmTurnsRoundWithoutAJump();
  void LossesAreCountedInSpells();
  void NothingDoneProvesNothing();
  void EditsAreMadeAndUndone();
  void FramesNeedAVideo();
  void WrongOptionsAreRefused();
  void AProgramThatFailsInPeaceIsNoTrial();

 private:
  /// A case whose labels lie around its model.
  static std::filesystem::path labelled_case(const std::filesystem::path& folder) {
    engine::CaseState state = test::small_case();
    VolumeGrid grid;
    grid.size = {20, 20, 20};
    grid.spacing_mm = {10.0, 10.0, 10.0};
    auto image = std::make_shared<Image>();
    image->grid = grid;
    image->voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(grid.voxel_count()));
    state[engine::part::image] = image;
    auto labels = std::make_shared<LabelMap>(*state[engine::part::labels]);
    labels->voxels = LabelVolume(grid);
    labels->voxels.set({8, 8, 8}, structure::kParenchyma);
    state[engine::part::labels] = labels;
    const std::filesystem::path path = folder / "a.glisson";
    if (!engine::save_case(path, state, RunContext())) throw PreconditionError("the case is not saved");
    return path;
  }
  /// After `times` of work, each of which leaves so much behind. Once a second for a day.
  static SoakRun after(int times, double megabytes_each, double descriptors_each = 0.0) {
    const auto n = std::make_shared<int>(0);
    SoakRun run("work", times, 86400.0, [=] {
      return Usage{500.0 + megabytes_each * *n, 10.0 + descriptors_each * *n, 4.0};
    });
    run.work([=](int) { return ++*n > 0; });
    return run;
  }
};

void SoakTest::ALeakIsSeen() {
  // Of 10,000 times half lie between the second quarter's middle and the last's: 50 MB, more than 24.
  const SoakRun run = after(10000, 0.01);
  QVERIFY(run.is_long_enough() && !run.is_flat());
  const Figures figures = run.figures();
  QVERIFY(std::abs(figures.at("soak_work_growth_mb") - 50.0) < 0.5);
  QCOMPARE(figures.at("soak_work_flat"), 0.0);
  QVERIFY(run.row().find("**no**") != std::string::npos);
}

void SoakTest::WhatStaysIsFlat() {
  // 5 MB between the quarters: the allocator's.
  const SoakRun run = after(10000, 0.001);
  QVERIFY(run.is_flat());
  QCOMPARE(run.figures().at("soak_work_flat"), 1.0);
  QVERIFY(run.row().find("| yes |") != std::string::npos);
}

void SoakTest::OneMoreDescriptorIsALeak() {
  QVERIFY(!after(10000, 0.0, 1.0 / 4000.0).is_flat());
  QVERIFY(after(10000, 0.0, 1.0 / 40000.0).is_flat());
}

void SoakTest::TooFewTimesSayNothing() {
  // What 24 MB over half of 60 times hides would fill 2 GB long before the day is over.
  const SoakRun run = after(60, 0.0);
  QVERIFY(!run.is_long_enough() && !run.is_flat());
  QVERIFY(run.row().find("too short to say") != std::string::npos);
}

void SoakTest::ACancelEndsTheWork() {
  SoakRun run("work", 100, 1.0, [] { return Usage{}; });
  int done = 0;
  QVERIFY(!run.work([&](int n) { return ++done, n < 3; }));
  QCOMPARE(done, 4);
}

void SoakTest::WhatWasDoneBeforeACancelIsKept() {
  SoakRun run("work", 60, 1.0, [] { return Usage{100.0, 4.0, 1.0}; });
  QVERIFY(!run.work([](int n) { return n < 20; }));
  QCOMPARE(run.figures().at("soak_work"), 20.0);
  QVERIFY(run.row().find("| 20 of 60 |") != std::string::npos);
  // The same of a whole soak: it is no page of a run that went to its end, and passes nothing.
  const TemporaryFolder folder;
  SoakOptions options;
  options.patient = labelled_case(folder.path());
  options.frames = options.opens = 0;
  options.edits = 60;
  const auto flag = std::make_shared<CancelFlag>();
  int told = 0;
  const RunContext context([&](double, std::string_view) { told == 100 ? flag->request() : void(++told); },
                           flag, 1);
  const auto result = soak(options, folder.path(), {}, context);
  QVERIFY(result && !result->complete && !result->passed);
  const double done = result->figures.at("soak_edits");
  QVERIFY(done > 0.0 && done < 60.0);
  QVERIFY(result->page.find("Interrupted") != std::string::npos);
  QVERIFY(result->page.find(" of 60 |") != std::string::npos);
}

void SoakTest::TheProcessIsMeasured() {
  const Usage before = usage_now();
  QVERIFY(before.memory_mb > 1.0 && before.descriptors >= 3.0 && before.threads >= 1.0);
  std::vector<char> held(std::size_t{64} << 20, 'x');
  QFile opened(QCoreApplication::applicationFilePath());
  QVERIFY(opened.open(QIODevice::ReadOnly));
  const Usage now = usage_now();
  QVERIFY(now.memory_mb - before.memory_mb > 50.0);
  QCOMPARE(now.descriptors, before.descriptors + 1.0);
  QCOMPARE(held.back(), 'x');
}

void SoakTest::TheFilmTurnsRoundWithoutAJump() {
  const SoakFilm film(std::vector<StereoFrame>(4));
  std::vector<int> shown;
  for (int n = 0; n < 8; ++n) shown.push_back(film.picture(n));
  QVERIFY((shown == std::vector<int>{0, 1, 2, 3, 2, 1, 0, 1}));
  QCOMPARE(film.at(7).index, 7);
  QVERIFY(std::abs(film.at(7).seconds - 7.0 / 30.0) < 1e-12);
}

void SoakTest::LossesAreCountedInSpells() {
  const SoakFilm film(std::vector<StereoFrame>(40));
  SoakLosses losses(film);
  const auto add = [&](int from, int to, Validity validity) {
    OverlayFrame overlay;
    overlay.validity = validity;
    for (int n = from; n < to; ++n) losses.add(n, overlay);
  };
  add(0, 10, Validity::valid);
  QVERIFY(losses.table().empty());
  add(10, 15, Validity::surface_apart);
  add(15, 37, Validity::valid);
  add(37, 39, Validity::surface_apart);  // where the film turns round
  add(39, 42, Validity::partly_covered);
  const Figures figures = losses.figures();
  QCOMPARE(figures.at("soak_frames_withdrawn"), 7.0);
  QCOMPARE(figures.at("soak_frames_degraded"), 3.0);
  QCOMPARE(figures.at("soak_frames_surface_apart"), 7.0);
  QCOMPARE(figures.at("soak_frames_surface_apart_spells"), 2.0);
  QCOMPARE(figures.at("soak_frames_surface_apart_spells_at_turns"), 1.0);
  QVERIFY(losses.table().find("of 42.") != std::string::npos);
}

void SoakTest::NothingDoneProvesNothing() {
  const TemporaryFolder folder;
  Image image;
  image.grid.size = {8, 8, 8};
  image.voxels = std::make_shared<std::vector<std::int16_t>>(8 * 8 * 8);
  write_image(folder.path() / "ct.nrrd", image);
  engine::Script script{RunContext()};
  QVERIFY(script.run(engine::ImportImage{folder.path() / "ct.nrrd"}));
  QVERIFY(script.run(engine::SaveCase{folder.path() / "a.glisson"}));
  SoakOptions options;
  options.patient = folder.path() / "a.glisson";
  options.frames = options.opens = options.edits = 0;
  const auto result = soak(options, folder.path(), {}, RunContext());
  QVERIFY(result && !result->passed);
}

void SoakTest::EditsAreMadeAndUndone() {
  const TemporaryFolder folder;
  SoakOptions options;
  options.patient = labelled_case(folder.path());
  options.frames = options.opens = 0;
  options.edits = 3;
  const auto result = soak(options, folder.path(), {}, RunContext());
  QVERIFY(result && result->complete && !result->passed);  // three say nothing
  QCOMPARE(result->figures.at("soak_edits"), 3.0);
  QVERIFY(result->figures.at("voxels_changed") > 0.0);  // of the last stroke: it painted
  QVERIFY(result->figures.contains("seconds_edit_labels") && result->figures.contains("seconds_undo_labels"));
  QVERIFY(result->page.find("| edits | 3 |") != std::string::npos);
  QVERIFY(result->page.find("opens_and_saves |") == std::string::npos);
  // A cancel before the first sample ends it without a page.
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  QVERIFY(!soak(options, folder.path(), {}, RunContext({}, flag, 1)));
}

void SoakTest::FramesNeedAVideo() {
  const TemporaryFolder folder;
  SoakOptions options;
  options.patient = labelled_case(folder.path());
  options.frames = 2;
  options.opens = options.edits = 0;
  QVERIFY_THROWS_EXCEPTION(Error, soak(options, folder.path(), {}, RunContext()));
}

void SoakTest::WrongOptionsAreRefused() {
  const TemporaryFolder folder;
  SoakOptions options;
  options.opens = -1;
  QVERIFY_THROWS_EXCEPTION(InputError, soak(options, folder.path(), {}, RunContext()));
  options = {};
  options.kills = 1;
  options.program = folder.path() / "none";
  QVERIFY_THROWS_EXCEPTION(InputError, soak(options, folder.path(), {}, RunContext()));
}

void SoakTest::AProgramThatFailsInPeaceIsNoTrial() {
  const TemporaryFolder folder;
  QVERIFY_THROWS_EXCEPTION(Error, kill_at_work("/bin/false", folder.path(), {}, 1, RunContext()));
}

QTEST_GUILESS_MAIN(SoakTest)
#include "soak_test.moc"
