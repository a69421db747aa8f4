// SPDX-License-Identifier: GPL-3.0-or-later
// What a track wrote is drawn again: the program's pictures against the painter's own, from what the track
// knew.
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <cstdlib>

#include "ball_surfaces.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/script.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "program.h"

using namespace glisson;
using test::Ran;
namespace fs = std::filesystem;

namespace {

constexpr int kFrames = 4;

double mean_difference(const Picture& a, const Picture& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.bytes->size(); ++i) sum += std::abs((*a.bytes)[i] - (*b.bytes)[i]);
  return sum / static_cast<double>(a.bytes->size());
}

}  // namespace

class TrackReplayTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanupTestCase() { remove_folder(); }

  void AVideoThatNobodyHasChosenIsGivenByThePerson();
  void ARightViewThatIsGivenIsTaken();
  void RenderDrawsWhatTheTrackKnew_data();
  void RenderDrawsWhatTheTrackKnew();
  void OverlayDrawsTheWholeFilmAgain();
  void ALesionThatTheModelLacksIsRefused();
  void ATrackOfAnotherModelIsRefused();
  void ATrackOfAnotherVideoIsRefused();
  void WhatIsNoTrackIsRefused();

 private:
  /// The frame's overlay as the track knew it.
  OverlayFrame known(int frame) const;
  Picture expected(int frame) const;

  std::unique_ptr<engine::Script> script_;
  std::vector<StereoFrame> film_;
};

OverlayFrame TrackReplayTest::known(int frame) const {
  OverlayFrame overlay;
  overlay.index = frame;
  overlay.seconds = frame / 30.0;
  overlay.validity = frame == 2   ? Validity::partly_covered
                     : frame == 3 ? Validity::surface_apart
                                  : Validity::valid;
  overlay.residual = 1.25e-3;
  if (overlay.level() == Level::withdrawn) return overlay;
  const PatientModel& model = script_->state()[part::model]->model;
  overlay.nodes_in_camera = model.mesh.vertices.rowwise() + Eigen::RowVector3d(0.002 * frame, 0.0, 0.22);
  LesionVerdict lesion;
  lesion.lesion = structure::kFirstLesion;
  lesion.level = frame == 0 ? Level::valid : Level::degraded;
  lesion.reason = frame == 0   ? LesionReason::known
                  : frame == 1 ? LesionReason::far_from_points
                               : LesionReason::with_the_whole;
  lesion.centre = Eigen::Vector3d(0.03 + 0.002 * frame, 0.0, 0.20);
  lesion.radius = 8e-3;
  lesion.covariance = Eigen::Vector3d(9e-6, 16e-6, 25e-6).asDiagonal();
  lesion.expected = 6.1e-3;
  lesion.reach = 14e-3;
  lesion.support = 21e-3;
  overlay.lesions = {lesion};
  return overlay;
}

Picture TrackReplayTest::expected(int frame) const {
  const engine::CaseState& state = script_->state();
  scene::OverlayPainter painter(engine::effective_model(state), state[part::rig]->left);
  scene::OverlayStatus status;
  status.model_unchecked = !engine::is_model_checked(state);
  status.landmarks_open = engine::landmark_review(state).is_open;
  status.landmarks_from_statistics = engine::landmark_review(state).from_statistics;
  return painter.paint(film_[static_cast<std::size_t>(frame)].left, known(frame), status);
}

void TrackReplayTest::initTestCase() {
  make_folder();
  test::write_ball_surfaces(at("surfaces"));
  const StereoRig rig = test::rig();
  stereo::write_calibration(at("c.yaml"), rig);
  {
    stereo::VideoWriter writer(at("film.mkv"), 2 * rig.left.width, rig.left.height, 30.0);
    for (int k = 0; k < kFrames; ++k) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>();
      for (int v = 0; v < rig.left.height; ++v)
        for (int u = 0; u < 2 * rig.left.width; ++u)
          for (int c = 0; c < 3; ++c)
            bytes->push_back(static_cast<std::uint8_t>(60 + (u + 2 * v + 9 * k) % 90));
      writer.write({2 * rig.left.width, rig.left.height, 3, bytes});
    }
    writer.close();
  }
  script_ = std::make_unique<engine::Script>(RunContext());
  model::ModelOptions options;
  options.mesh.target_vertices = 150;
  QVERIFY(script_->run(engine::ImportSurfaces{at("surfaces"), LengthUnit::millimetre, options}));
  QVERIFY(script_->run(engine::SetVideo{at("film.mkv"), {}}));
  QVERIFY(script_->run(engine::SetCalibration{at("c.yaml")}));
  QVERIFY(script_->run(engine::SaveCase{at("a.glisson")}));
  fs::create_directories(state());  // the program has a list of its own
  test::write_text(state() / "known_sources", fs::canonical(at("film.mkv")).string() + "\n");
  stereo::StereoVideo video(at("film.mkv"));
  for (StereoFrame frame; video.read(frame);) film_.push_back(frame);
  QCOMPARE(film_.size(), static_cast<std::size_t>(kFrames));

  const PatientModel& model = script_->state()[part::model]->model;
  fs::create_directory(at("tracked"));
  std::string lines;
  for (int k = 0; k < kFrames; ++k) {
    OverlayLine line;
    line.number = k;
    line.overlay = known(k);
    if (line.overlay.nodes_in_camera.rows() > 0) {
      line.mesh = "registered_0000" + std::to_string(k) + ".vtu";
      line.camera_from_model = Eigen::Matrix4d::Identity();
      TetFile mesh;
      mesh.mesh = model.mesh;
      mesh.mesh.vertices = line.overlay.nodes_in_camera;
      write_tet_mesh(at("tracked") / line.mesh, mesh, LengthUnit::millimetre);
    }
    lines += overlay_line(line) + "\n";
  }
  test::write_text(at("tracked/frames.jsonl"), lines + overlay_record_end(true, kFrames) + "\n");
  script_->run(engine::OpenCase{at("a.glisson"), engine::OpenCase::Access::read});
}

void TrackReplayTest::AVideoThatNobodyHasChosenIsGivenByThePerson() {
  const QStringList render = {"render", "--case", "a.glisson", "--track", "tracked", "--frame", "0", "--out"};
  const QString refusal = QStringLiteral("film.mkv). Give them by --video");
  fs::remove(state() / "known_sources");
  refused(render + QStringList{"first.png"}, refusal);
  refused({"overlay", "--case", "a.glisson", "--track", "tracked", "--out", "first.mkv"}, refusal);
  refused(render + QStringList{"first.png", "--video-right", "film.mkv"}, "--video", 2);
  const Ran given = run(render + QStringList{"first.png", "--video", "film.mkv"});
  QVERIFY2(given.code == 0, qPrintable(given.error));
  QVERIFY2(!(given.error + given.out).contains("without its video"), qPrintable(given.error + given.out));
  const Ran known = run(render + QStringList{"second.png"});
  QVERIFY2(known.code == 0, qPrintable(known.error));
  QCOMPARE(read_file(at("second.png")), read_file(at("first.png")));
}

/// The case's film has both views side by side; a right view of its own makes it another video.
void TrackReplayTest::ARightViewThatIsGivenIsTaken() {
  for (const auto& [name, view] :
       {std::pair{"left.mkv", &StereoFrame::left}, {"right.mkv", &StereoFrame::right}}) {
    stereo::VideoWriter writer(at(name), film_.front().left.width, film_.front().left.height, 30.0);
    for (const StereoFrame& frame : film_) writer.write(frame.*view);
    writer.close();
  }
  const QStringList render = {"render", "--case", "a.glisson", "--track", "tracked", "--frame", "0", "--out"};
  const Ran apart =
      run(render + QStringList{"apart.png", "--video", "left.mkv", "--video-right", "right.mkv"});
  QVERIFY2(apart.code == 0, qPrintable(apart.error));
  // It was compressed twice.
  const double off = mean_difference(stereo::read_picture(at("apart.png")), expected(0));
  QVERIFY2(off < 5.0, qPrintable(QString::number(off)));
  refused(render + QStringList{"mixed.png", "--video", "film.mkv", "--video-right", "right.mkv"},
          "right.mkv: is 320x240");
  QVERIFY(!fs::exists(at("mixed.png")));
}

void TrackReplayTest::RenderDrawsWhatTheTrackKnew_data() {
  QTest::addColumn<int>("frame");
  QTest::newRow("lesion as itself") << 0;
  QTest::newRow("lesion as its region") << 1;
  QTest::newRow("outline only") << 2;
  QTest::newRow("nothing") << 3;
}

void TrackReplayTest::RenderDrawsWhatTheTrackKnew() {
  QFETCH(int, frame);
  const Ran ran = run({"render", "--case", "a.glisson", "--track", "tracked", "--frame",
                       QString::number(frame), "--out", "p.png", "--json", "r.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const OverlayFrame overlay = known(frame);
  const QJsonObject json = figures("r.json");
  QCOMPARE(json["validity"].toString(), QString(validity_code(overlay.validity)));
  QCOMPARE(json["level"].toString(), QString(level_code(overlay.level())));
  if (!overlay.lesions.empty()) {
    const LesionVerdict& lesion = overlay.lesions.front();
    QCOMPARE(json["lesion_1_level"].toString(), QString(level_code(lesion.level)));
    QCOMPARE(json["lesion_1_reason"].toString(), QString(lesion_reason_code(lesion.reason)));
    QVERIFY(std::abs(json["lesion_1_reach_95_mm"].toDouble() - 14.0) < 1e-9);
    QVERIFY(std::abs(json["lesion_1_expected_error_mm"].toDouble() - 6.1) < 1e-9);
  }
  const Picture drawn = stereo::read_picture(at("p.png")), wanted = expected(frame);
  QVERIFY(drawn.width == wanted.width && drawn.height == wanted.height);
  QVERIFY(mean_difference(wanted, film_[static_cast<std::size_t>(frame)].left) > 0.5);
  QVERIFY2(*drawn.bytes == *wanted.bytes, qPrintable(QString::number(mean_difference(drawn, wanted))));
}

void TrackReplayTest::OverlayDrawsTheWholeFilmAgain() {
  const Ran ran =
      run({"overlay", "--case", "a.glisson", "--track", "tracked", "--out", "again.mkv", "--json", "o.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(figures("o.json")["frames"].toInt(), kFrames);
  QCOMPARE(figures("o.json")["frames_valid"].toInt(), 2);
  // The same pictures through the same codec give the same film. (Both are read as if they held two views.)
  const StereoRig rig = test::rig();
  stereo::VideoWriter writer(at("own.mkv"), rig.left.width, rig.left.height, 30.0);
  for (int k = 0; k < kFrames; ++k) writer.write(expected(k));
  writer.close();
  stereo::StereoVideo again(at("again.mkv")), own(at("own.mkv"));
  int count = 0;
  for (StereoFrame a, b; again.read(a) && own.read(b); ++count)
    QVERIFY2(*a.left.bytes == *b.left.bytes && *a.right.bytes == *b.right.bytes,
             qPrintable(QString("frame %1").arg(count)));
  QCOMPARE(count, kFrames);
}

void TrackReplayTest::ALesionThatTheModelLacksIsRefused() {
  const QStringList told{"--case", "a.glisson", "--track", "tracked", "--lesion"};
  refused(QStringList{"render"} + told + QStringList{"lesion_7", "--frame", "0", "--out", "q.png"},
          "Its lesions: lesion_1", 2);
  refused(QStringList{"overlay"} + told + QStringList{"lesion_7", "--out", "q.mkv"}, "Its lesions: lesion_1",
          2);
  const Ran ran =
      run(QStringList{"render"} + told + QStringList{"lesion_1", "--frame", "0", "--out", "l.png"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
}

void TrackReplayTest::ATrackOfAnotherModelIsRefused() {
  fs::create_directory(at("other"));
  fs::copy_file(at("tracked/frames.jsonl"), at("other/frames.jsonl"));
  write_tet_mesh(at("other/registered_00000.vtu"), test::ball(3), LengthUnit::millimetre);
  refused({"render", "--case", "a.glisson", "--track", "other", "--frame", "0", "--out", "q.png"},
          "registered_00000.vtu");
  QVERIFY(!fs::exists(at("q.png")));
}

void TrackReplayTest::ATrackOfAnotherVideoIsRefused() {
  fs::create_directory(at("later"));
  OverlayLine line;
  line.overlay = known(3);
  line.overlay.seconds = 7.0;
  test::write_text(at("later/frames.jsonl"), overlay_line(line) + "\n");
  refused({"overlay", "--case", "a.glisson", "--track", "later", "--out", "q.mkv"}, "another moment");
}

void TrackReplayTest::WhatIsNoTrackIsRefused() {
  refused({"overlay", "--case", "a.glisson", "--track", "surfaces", "--out", "q.mkv"}, "frames.jsonl");
  refused({"render", "--case", "a.glisson", "--track", "tracked", "--frame", "9", "--out", "q.png"},
          "frame 9");
}

int main(int argc, char** argv) {
  const scene::HeadlessGui gui;
  TrackReplayTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "track_replay_test.moc"
