// SPDX-License-Identifier: GPL-3.0-or-later
// What the meshes of a track tell.
#include "glisson/experiments/track_record.h"

#include <QTest>

#include "glisson/core/files.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/overlay_record.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::experiments;

class TrackRecordTest : public QObject {
  Q_OBJECT
 private slots:
  void MeshesTellOfTheRegistrationThatIsFollowed();
  void AFrameIsLateByTheSourcesOwnRate();
  void WhatAPersonAndTheProgramDidIsCountedAndWritten();
};

void TrackRecordTest::MeshesTellOfTheRegistrationThatIsFollowed() {
  const PatientModel model = phantom::model(6, 5, 3);
  Registration first;
  first.camera_from_ct = phantom::view();
  first.nodes_in_camera = phantom::view().apply(model.mesh.vertices);
  first.doubts = {"little_surface_seen"};
  Registration second = first;
  second.doubts = {"many_outliers"};

  const TemporaryFolder folder;
  std::vector<Registration> written;
  TrackOutput output;
  output.folder = folder.path();
  output.write_mesh = [&](const std::filesystem::path&, const Registration& carried, const NamedArrays&) {
    written.push_back(carried);
  };
  TrackRecord record(model, first, output);
  OverlayFrame overlay;
  overlay.nodes_in_camera = first.nodes_in_camera;
  record.add(0, overlay);
  record.go_on_from(second);
  record.add(1, overlay);
  QCOMPARE(written.size(), std::size_t{2});
  QCOMPARE(written[0].doubts, first.doubts);
  QCOMPARE(written[1].doubts, second.doubts);
}

/// 25 ms: in time for 30 frames a second, too late for 60.
void TrackRecordTest::AFrameIsLateByTheSourcesOwnRate() {
  const PatientModel model = phantom::model(6, 5, 3);
  Registration start;
  start.camera_from_ct = phantom::view();
  start.nodes_in_camera = phantom::view().apply(model.mesh.vertices);
  OverlayFrame overlay;
  overlay.milliseconds = 25.0;
  for (const auto& [rate, late] : {std::pair(30.0, 0.0), std::pair(60.0, 1.0)}) {
    const TemporaryFolder folder;
    TrackOutput output;
    output.folder = folder.path();
    output.frames_per_second = rate;
    TrackRecord record(model, start, output);
    record.add(0, overlay);
    record.finish(true);
    QCOMPARE(record.figures().at("frames_late"), late);
  }
}

void TrackRecordTest::WhatAPersonAndTheProgramDidIsCountedAndWritten() {
  const PatientModel model = phantom::model(6, 5, 3);
  Registration start;
  start.camera_from_ct = phantom::view();
  start.nodes_in_camera = phantom::view().apply(model.mesh.vertices);
  const TemporaryFolder folder;
  TrackOutput output;
  output.folder = folder.path();
  TrackRecord record(model, start, output);
  OverlayFrame overlay;
  overlay.validity = Validity::partly_covered;
  overlay.mask.emplace();
  overlay.mask->held_out = 7;
  LesionVerdict lesion;
  lesion.lesion = structure::kFirstLesion;
  lesion.level = Level::degraded;
  overlay.lesions = {lesion};
  record.add(0, overlay);
  record.add(1, overlay);
  record.add(CorrectionMade{{}, 1, 0.033, 2e-3});
  overlay.index = 1;
  record.add_undone(overlay);
  record.add(AgainLine{1, 0.033, true, 5e-3, 2e-3, 3e-3});
  record.add(AgainLine{1, 0.066, false, 2e-3, 4e-3, 3e-3});
  record.finish(false);
  const Figures figures = record.figures();
  for (const auto& [key, value] : {std::pair{"frames_partly_covered", 2.0},
                                   {"frames_with_mask", 2.0},
                                   {"points_held_out", 14.0},
                                   {"lesion_1_frames_degraded", 2.0},
                                   {"corrections", 1.0},
                                   {"corrections_undone", 1.0},
                                   {"registered_again", 2.0},
                                   {"registered_again_taken", 1.0},
                                   {"complete", 0.0}})
    QVERIFY2(figures.contains(key) && figures.at(key) == value, key);
  const OverlayRecord written = read_overlay_record(folder.path() / "frames.jsonl");
  QCOMPARE(written.frames.size(), std::size_t{2});
  QVERIFY(!written.complete);
}

QTEST_GUILESS_MAIN(TrackRecordTest)
#include "track_record_test.moc"
