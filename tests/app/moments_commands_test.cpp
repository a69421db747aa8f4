// SPDX-License-Identifier: GPL-3.0-or-later
// 'glisson moments': what a case keeps of the live view is listed and written as it was kept.
#include <QJsonArray>
#include <QTest>

#include <algorithm>

#include "ball_surfaces.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/keep_moment.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/script.h"
#include "glisson/patient/label_map.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/png.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "program.h"

using namespace glisson;
using test::Ran;
namespace fs = std::filesystem;

class MomentsCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanupTestCase() { remove_folder(); }

  void MomentsAreListed();
  void EachIsWrittenAsItWas();
  void OverACalibrationThatIsNewNothingIsDrawn();
  void ADamagedMomentIsNamed();
  void WhatCannotBeIsRefused();

 private:
  engine::KeptMoment moment(int frame, Validity validity) const;
  static Picture view(int first) {
    const StereoRig rig = test::rig();
    auto bytes = std::make_shared<std::vector<std::uint8_t>>();
    for (int i = 0; i < 3 * rig.left.width * rig.left.height; ++i)
      bytes->push_back(static_cast<std::uint8_t>(60 + (first + i / 7) % 90));
    return {rig.left.width, rig.left.height, 3, bytes};
  }

  std::unique_ptr<engine::Script> script_;
};

engine::KeptMoment MomentsCommandsTest::moment(int frame, Validity validity) const {
  const engine::CaseState& state = script_->state();
  engine::KeptMoment made;
  made.kept_at = "2026-01-31T10:20:30Z";
  made.title = frame == 10 ? "Über dem Tumor" : "";
  made.left_png = std::make_shared<const std::string>(stereo::png_of(view(frame)));
  made.right_png = std::make_shared<const std::string>(stereo::png_of(view(frame + 40)));
  made.overlay.index = frame;
  made.overlay.seconds = frame / 20.0;
  made.overlay.validity = validity;
  made.overlay.nodes_in_camera =
      state[part::model]->model.mesh.vertices.rowwise() + Eigen::RowVector3d(0.002, 0.0, 0.22);
  made.camera_from_model = Eigen::Matrix4d::Identity();
  LesionVerdict lesion;
  lesion.lesion = structure::kFirstLesion;
  lesion.level = Level::valid;
  lesion.reason = LesionReason::known;
  lesion.centre = {0.032, 0.0, 0.21};
  lesion.radius = 8e-3;
  lesion.covariance = Eigen::Vector3d(9e-6, 16e-6, 25e-6).asDiagonal();
  lesion.expected = 6.1e-3;
  lesion.reach = 9e-3;
  made.overlay.lesions = {lesion};
  made.chosen = lesion.lesion;
  made.measures = guidance::LesionMeasures{};
  made.measures->lesion = lesion.lesion;
  made.measures->shortest = 0.0125;
  made.model_unchecked = true;
  made.model_revision = state.stamp(part::model).revision;
  made.rig_revision = state.stamp(part::rig).revision;
  return made;
}

void MomentsCommandsTest::initTestCase() {
  make_folder();
  test::write_ball_surfaces(at("surfaces"));
  stereo::write_calibration(at("c.yaml"), test::rig());
  script_ = std::make_unique<engine::Script>(RunContext());
  model::ModelOptions options;
  options.mesh.target_vertices = 150;
  QVERIFY(script_->run(engine::ImportSurfaces{at("surfaces"), LengthUnit::millimetre, options}));
  QVERIFY(script_->run(engine::SetCalibration{at("c.yaml")}));
  QVERIFY(script_->run(engine::SaveCase{at("empty.glisson")}));
  for (const auto& [frame, validity] :
       {std::pair{10, Validity::valid}, {20, Validity::partly_covered}, {30, Validity::surface_apart}})
    QVERIFY(script_->run(
        engine::KeepMoment{std::make_shared<const engine::KeptMoment>(moment(frame, validity))}));
  QVERIFY(script_->run(engine::SaveCase{at("a.glisson")}));
}

void MomentsCommandsTest::MomentsAreListed() {
  const Ran ran = run({"moments", "--case", "a.glisson", "--json", "m.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  for (const char* words : {"Über dem Tumor", "2026-01-31T10:20:30Z", "part of the organ is covered"})
    QVERIFY2((ran.out + ran.error).contains(QString::fromUtf8(words)), qPrintable(ran.out + ran.error));
  const QJsonObject json = figures("m.json");
  QCOMPARE(json["moments"].toInt(), 3);
  QCOMPARE(json["moment_1_frame"].toInt(), 10);
  QCOMPARE(json["moment_1_time_s"].toDouble(), 0.5);
  QCOMPARE(json["moment_1_title"].toString(), QStringLiteral("Über dem Tumor"));
  QCOMPARE(json["moment_1_level"].toString(), QStringLiteral("valid"));
  QCOMPARE(json["moment_3_level"].toString(), QStringLiteral("withdrawn"));
  QCOMPARE(json["moment_3_validity"].toString(), QString(validity_code(Validity::surface_apart)));
  QVERIFY(std::abs(json["moment_1_lesion_1_depth_shortest_mm"].toDouble() - 12.5) < 1e-6);
  QVERIFY(std::abs(json["moment_2_lesion_1_expected_error_mm"].toDouble() - 6.1) < 1e-6);
  const Ran none = run({"moments", "--case", "empty.glisson", "--json", "n.json"});
  QVERIFY2(none.code == 0, qPrintable(none.error));
  QCOMPARE(figures("n.json")["moments"].toInt(), 0);
}

void MomentsCommandsTest::EachIsWrittenAsItWas() {
  const Ran ran = run({"moments", "--case", "a.glisson", "--out", "out", "--json", "o.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(figures("o.json")["without_overlay"].toInt(), 0);
  const engine::CaseState& state = script_->state();
  for (const auto& [number, frame] : {std::pair{1, 10}, {2, 20}, {3, 30}}) {
    const std::string stem = "out/moment_000" + std::to_string(number);
    const Picture left = stereo::read_picture(at((stem + "_left.png").c_str()));
    QVERIFY(*left.bytes == *view(frame).bytes);
    QVERIFY(*stereo::read_picture(at((stem + "_right.png").c_str())).bytes == *view(frame + 40).bytes);
    const engine::KeptMoment& kept = *engine::moment_of(state, number);
    scene::OverlayPainter painter(engine::effective_model(state), state[part::rig]->left);
    scene::OverlayStatus status;
    status.stands = status.model_unchecked = true;
    const Picture wanted = painter.paint(left, kept.overlay, status, {kept.chosen, {}, {}});
    const Picture drawn = stereo::read_picture(at((stem + "_overlay.png").c_str()));
    QVERIFY2(*drawn.bytes == *wanted.bytes, stem.c_str());
    const QJsonObject json = figures((stem + ".json").c_str());
    QCOMPARE(json["overlay"].toObject()["frame"].toInt(), frame);
    QCOMPARE(json["overlay"].toObject()["nodes"].toArray().size(), kept.overlay.nodes_in_camera.rows());
    QVERIFY(json["overlay_is_drawn"].toBool());
  }
  // What is somebody else's in the folder stays.
  test::write_text(at("out/notes.txt"), "mine");
  QCOMPARE(run({"moments", "--case", "a.glisson", "--out", "out"}).code, 0);
  QCOMPARE(read_file(at("out/notes.txt")), std::string("mine"));
}

void MomentsCommandsTest::OverACalibrationThatIsNewNothingIsDrawn() {
  engine::Script other{RunContext()};
  fs::copy(at("a.glisson"), at("b.glisson"), fs::copy_options::recursive);
  QVERIFY(other.run(engine::OpenCase{at("b.glisson"), engine::OpenCase::Access::write}));
  QVERIFY(other.run(engine::SetCalibration{at("c.yaml")}));
  QVERIFY(other.run(engine::SaveCase{at("b.glisson")}));
  const Ran ran = run({"moments", "--case", "b.glisson", "--out", "without", "--json", "w.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(figures("w.json")["without_overlay"].toInt(), 3);
  QVERIFY((ran.out + ran.error).contains("Without an overlay"));
  QVERIFY(!fs::exists(at("without/moment_0001_overlay.png")) &&
          fs::exists(at("without/moment_0001_left.png")));
  QVERIFY(!figures("without/moment_0001.json")["overlay_is_drawn"].toBool());
}

void MomentsCommandsTest::ADamagedMomentIsNamed() {
  fs::copy(at("a.glisson"), at("d.glisson"), fs::copy_options::recursive);
  test::write_text(at("d.glisson/moments/0002_left.png"), "damaged");
  const Ran ran = run({"moments", "--case", "d.glisson", "--json", "d.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(figures("d.json")["moments"].toInt(), 2);
  QVERIFY2((ran.out + ran.error).contains("0002_left.png: is not the picture that was kept"),
           qPrintable(ran.out + ran.error));
}

void MomentsCommandsTest::WhatCannotBeIsRefused() {
  refused({"moments"}, "--case", 2);
  refused({"moments", "--case", "nowhere.glisson"}, "does not exist");
  refused({"moments", "--case", "empty.glisson", "--out", "o"}, "Keep a moment of the live view first");
  refused({"moments", "--case", "a.glisson", "--out", "c.yaml"}, "is a file, a folder is needed here");
}

int main(int argc, char** argv) {
  const scene::HeadlessGui gui;
  MomentsCommandsTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "moments_commands_test.moc"
