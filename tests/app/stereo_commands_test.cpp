// SPDX-License-Identifier: GPL-3.0-or-later
// The stereo laparoscope on the command line: calibrate, check, reconstruct, and the proofs.
#include <QImage>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "program.h"
#include "rendered_board.h"
#include "rendered_pair.h"

using namespace glisson;
using test::Ran;
using test::rig;
using test::write_text;
namespace fs = std::filesystem;

namespace {

/// As rendered::rig(), with half the pixels.
StereoRig half_rig() {
  StereoRig rig = rendered::rig();
  for (Camera* camera : {&rig.left, &rig.right}) {
    camera->matrix.topRows<2>() *= 0.5;
    camera->width /= 2;
    camera->height /= 2;
  }
  return rig;
}

}  // namespace

class StereoCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void initTestCase();
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void WrongUsageIsRefusedWithCodeTwo();
  void CalibrateNamesWhatIsMissing();
  void CalibrateNamesABoardThatWasMoved();
  void CalibrateLeavesItOutAndFindsTheTrueCameras();
  void CalibrateSaysWhichBoardItSees();
  void CalibrateKeepsTheViewsThatDifferMost();
  void CalibrateConvertsPlainText();
  void ACancelledCalibrationWritesNothing();
  void GoodPicturesAreNotCalledDamagedWhereATerminalInterrupts();
  void CheckFindsNothingInASoundSequence();
  void CheckNamesTheFramesWithFaults();
  void CheckHoldsPairsAgainstTheCalibration();
  void CheckTakesTheCalibrationOfWholeViewsForPicturesThatAreCut();
  void CheckNamesWhatIsMissing();
  void ProofsRefuseWrongUsage();
  void AProofWithoutItsDataIsNoSuccess();
  void ACancelledProofLeavesNothing();
  void ACalibrationOfAnotherSizeIsRefused();
  void SwappedCamerasAreRecognised();
  void ReconstructRefusesBadInput_data();
  void ReconstructRefusesBadInput();
  void ReconstructNamesTheFaultOfAPair();

 private:
  /// Two plain pictures of that size with the calibration c.yaml.
  void refuse_reconstruction(const QSize& size, const QString& mentions) const;
  /// Copies rendered boards into boards/, `times` over.
  void put_boards(int times = 1, int pairs = kPairs) const;
  /// The same, one of them moved between its pictures.
  void put_moved_board() const;
  /// Texture that moves and sparkles, as frames/left-00.png and so on; what `edit` makes of it.
  void put_frames(int count, const std::function<void(int, Picture&, Picture&)>& edit) const;
  QStringList calibrate(const QStringList& more) const {
    return QStringList{"calibrate",   "--pairs", "boards", "--board", "9x6",
                       "--square-mm", "6",       "--out",  "c.yaml"} +
           more;
  }

  static constexpr int kPairs = 6;
  static constexpr int kMoved = 2;  ///< the board of this pair was moved between its pictures, in moved_
  const stereo::Board board_{9, 6, 6e-3, {}, 0.0};
  /// A rendered pair of 320x240 with what else a reconstruction reads: l.png, r.png, c.yaml, m.png, g.json.
  void put_pair() const;
  QStringList reconstruct(const QString& left = "l.png", const QString& right = "r.png",
                          const QString& calibration = "c.yaml") const {
    return {"reconstruct", "--left", left, "--right", right, "--calibration", calibration, "--out", "o.ply"};
  }

  TemporaryFolder rendered_;
};

void StereoCommandsTest::initTestCase() {
  const auto poses = rendered::board_poses(board_, 0.13);
  for (std::size_t i = 0; i < kPairs; ++i)
    for (const bool left : {true, false}) {
      const std::string name = (left ? "left-" : "right-") + std::to_string(i) + ".png";
      const auto ink = rendered::chessboard_ink(board_);
      stereo::write_picture(rendered_.path() / name,
                            rendered::board_picture(rendered::rig(), left, poses[2 * i], ink));
      if (left || i != kMoved) continue;
      auto moved = poses[2 * i];
      moved.translation.y() += 0.6e-3;
      stereo::write_picture(rendered_.path() / "moved.png",
                            rendered::board_picture(rendered::rig(), false, moved, ink));
    }
}

void StereoCommandsTest::put_boards(int times, int pairs) const {
  fs::create_directory(at("boards"));
  for (int n = 0; n < times; ++n)
    for (int i = 0; i < pairs; ++i)
      for (const char* side : {"left-", "right-"})
        fs::copy_file(rendered_.path() / (side + std::to_string(i) + ".png"),
                      at("boards") / (side + std::to_string(kPairs * n + i) + ".png"));
}

void StereoCommandsTest::put_frames(int count,
                                    const std::function<void(int, Picture&, Picture&)>& edit) const {
  constexpr int kWidth = 320, kHeight = 240;
  fs::create_directory(at("frames"));
  std::mt19937 random(5);  // NOLINT: the same frames on every run
  std::normal_distribution<double> sensor(0.0, 2.0);
  for (int frame = 0; frame < count; ++frame) {
    const auto picture = [&](double shift) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>();
      for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
          const double grey =
              120.0 + 60.0 * rendered::noise({(x + shift) / 14.0, y / 14.0, 0.3}) + sensor(random);
          for (int channel = 0; channel < 3; ++channel)
            bytes->push_back(static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0)));
        }
      return Picture{kWidth, kHeight, 3, std::move(bytes)};
    };
    Picture left = picture(3.0 * frame), right = picture(3.0 * frame + 20.0);
    if (edit) edit(frame, left, right);
    const std::string number = (frame < 10 ? "0" : "") + std::to_string(frame) + ".png";
    stereo::write_picture(at("frames") / ("left-" + number), left);
    stereo::write_picture(at("frames") / ("right-" + number), right);
  }
}

void StereoCommandsTest::WrongUsageIsRefusedWithCodeTwo() {
  put_boards();
  refused({"calibrate", "--pairs", "boards"}, "--out", 2);
  refused({"calibrate", "--out", "c.yaml"}, "--pairs", 2);
  refused({"calibrate", "--pairs", "boards", "--video", "v.mkv", "--out", "c.yaml"}, "one of", 2);
  refused({"calibrate", "--left", "boards", "--out", "c.yaml"}, "--right", 2);
  refused({"calibrate", "--pairs", "boards", "--out", "c.txt"}, ".yaml", 2);
  refused(calibrate({"--coverage", "c.txt"}), ".png", 2);
  refused({"calibrate", "--pairs", "boards", "--board", "14", "--out", "c.yaml"}, "14x10", 2);
  refused(calibrate({"--most-views", "2"}), "--most-views", 2);
  refused({"calibrate", "--pairs", "boards", "--square-mm", "0", "--out", "c.yaml"}, "--square-mm", 2);
  refused({"calibrate", "--text", "boards", "--out", "c.yaml"}, "--size", 2);
  refused({"check"}, "--video", 2);
  refused({"check", "--video", "boards", "--every", "0"}, "--every", 2);
}

void StereoCommandsTest::CalibrateNamesWhatIsMissing() {
  refused({"calibrate", "--pairs", "nothing", "--out", "c.yaml"}, "nothing");
  refused({"calibrate", "--left", "a*.png", "--right", "b*.png", "--out", "c.yaml"}, "a*.png");
  fs::create_directory(at("empty"));
  refused({"calibrate", "--pairs", "empty", "--out", "c.yaml"}, "empty");
  put_boards();
  refused(calibrate({"--reference", "none.yaml"}), "none.yaml");
  refused({"calibrate", "--pairs", "boards", "--out", "nowhere/c.yaml"}, "nowhere");
  refused({"calibrate", "--pairs", "boards", "--charuco", "DICT_NONE", "--marker-mm", "2", "--out", "c.yaml"},
          "DICT_NONE");
}

void StereoCommandsTest::CalibrateNamesABoardThatWasMoved() {
  put_moved_board();
  const Ran ran = run(calibrate({"--json", "c.json"}));
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY2(ran.out.contains(QRegularExpression(QString("(^|\n)%1 .*--drop-outliers").arg(kMoved))),
           qPrintable(ran.out));
  const QJsonObject json = figures("c.json");
  QCOMPARE(json["calibration_outliers"].toInt(), 1);
  QVERIFY(json["calibration_rms_px"].toDouble() > 0.4);
}

void StereoCommandsTest::CalibrateLeavesItOutAndFindsTheTrueCameras() {
  put_moved_board();
  const Ran ran = run(calibrate({"--drop-outliers", "--coverage", "coverage.png", "--json", "c.json"}));
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(ran.error, QString());
  const StereoRig truth = rendered::rig(), found = stereo::read_calibration(at("c.yaml"));
  QVERIFY(std::abs(found.left.matrix(0, 0) / truth.left.matrix(0, 0) - 1.0) < 0.02);
  QVERIFY(std::abs(found.baseline() / truth.baseline() - 1.0) < 0.02);
  const QJsonObject json = figures("c.json");
  QCOMPARE(json["calibration_views"].toInt(), kPairs);
  QCOMPARE(json["calibration_outliers"].toInt(), 1);
  QVERIFY(json["calibration_rms_px"].toDouble() > 0.0 && json["calibration_rms_px"].toDouble() < 0.3);
  QVERIFY(std::abs(json["calibration_baseline_mm"].toDouble() - 1e3 * found.baseline()) < 1e-3);
  QVERIFY(json["calibration_epipolar_reference_px"].isNull());  // none was given: unknown, not zero
  const QImage coverage(text_of("coverage.png"));
  QVERIFY(coverage.width() > 1000 && coverage.height() == 480);
  int views = 0;
  for (const QString& line : ran.out.split('\n')) {
    const bool is_view = line.contains(QRegularExpression("^[0-5] .*\\d\\.\\d\\d"));
    views += is_view;
    if (is_view) QCOMPARE(line.contains("left out"), line.startsWith(QString::number(kMoved)));
  }
  QCOMPARE(views, kPairs);
}

void StereoCommandsTest::put_moved_board() const {
  put_boards();
  fs::copy_file(rendered_.path() / "moved.png", at("boards") / ("right-" + std::to_string(kMoved) + ".png"),
                fs::copy_options::overwrite_existing);
}

void StereoCommandsTest::CalibrateSaysWhichBoardItSees() {
  put_boards(1, 1);
  // Where each pair failed is told on the way; the error is one sentence, and nothing is written.
  const Ran ran = run({"calibrate", "--pairs", "boards", "--board", "11x8", "--out", "c.yaml"});
  QCOMPARE(ran.code, 1);
  QVERIFY2(ran.error.contains("9x6") && ran.error.trimmed().count('\n') == 0, qPrintable(ran.error));
  QVERIFY(ran.out.contains("no board is found"));
  QVERIFY(!fs::exists(at("c.yaml")));
}

void StereoCommandsTest::CalibrateKeepsTheViewsThatDifferMost() {
  put_boards();
  fs::copy_file(at("boards/left-0.png"), at("boards/left-77.png"));
  const Ran ran = run(calibrate({"--most-views", "4", "--json", "c.json"}));
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY2(ran.out.contains("left-77.png: has no partner"), qPrintable(ran.out));
  const QJsonObject json = figures("c.json");
  QCOMPARE(json["calibration_pairs"].toInt(), kPairs);
  QCOMPARE(json["calibration_views"].toInt(), 4);
}

void StereoCommandsTest::CalibrateConvertsPlainText() {
  fs::create_directory(at("text"));
  for (const char* side : {"left", "right"}) {
    write_text(at("text") / (std::string("calib.") + side + ".intrinsics.txt"),
               "700 0 320\n0 700 240\n0 0 1\n");
    write_text(at("text") / (std::string("calib.") + side + ".distortion.txt"), "0 0 0 0 0\n");
  }
  write_text(at("text") / "calib.l2r.txt", "1 0 0 -5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  refused({"calibrate", "--text", "text", "--size", "640", "--out", "c.yaml"}, "--size", 2);
  const Ran ran = run({"calibrate", "--text", "text", "--size", "640x480", "--out", "c.yaml"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const StereoRig found = stereo::read_calibration(at("c.yaml"));
  QCOMPARE(found.left.width, 640);
  QVERIFY(std::abs(found.baseline() - 5e-3) < 1e-9);
  refused({"calibrate", "--text", "nothing", "--size", "640x480", "--out", "d.yaml"}, "nothing");
}

void StereoCommandsTest::ACancelledCalibrationWritesNothing() {
  put_boards(10);  // half a minute, were it not cancelled
  const int before = files();
  const Ran ran = interrupted(calibrate({"--json", "c.json"}));
  QVERIFY2(ran.code == 130, qPrintable(QString::number(ran.code) + ran.error + ran.out));
  QVERIFY(ran.error.contains("cancelled"));
  QCOMPARE(files(), before);
}

/// The program that reads the pictures gets the signal, too.
void StereoCommandsTest::GoodPicturesAreNotCalledDamagedWhereATerminalInterrupts() {
  put_boards(10);
  for (const int signal : {SIGINT, SIGTERM}) {
    const Ran ran = interrupted_as_a_group(calibrate({}), signal);
    QVERIFY2(ran.code == 130, qPrintable(QString::number(ran.code) + ran.error + ran.out));
    QVERIFY2(ran.error.contains("cancelled"), qPrintable(ran.error));
  }
}

void StereoCommandsTest::CheckFindsNothingInASoundSequence() {
  put_frames(12, {});
  const Ran ran = run({"check", "--video", "frames", "--json", "f.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error + ran.out));
  const QJsonObject json = figures("f.json");
  QCOMPARE(json["frames"].toInt(), 12);
  QCOMPARE(json["faults"].toInt(), 0);
  QCOMPARE(json["frames_skipped"].toInt(), 0);
}

void StereoCommandsTest::CheckNamesTheFramesWithFaults() {
  Picture left_before, right_before;
  put_frames(12, [&](int frame, Picture& left, Picture& right) {
    if (frame == 4)
      for (Picture* picture : {&left, &right})
        picture->bytes =
            std::make_shared<const std::vector<std::uint8_t>>(picture->bytes->size(), std::uint8_t{2});
    if (frame == 9) left = left_before, right = right_before;
    left_before = left, right_before = right;
  });
  const Ran ran = run({"check", "--video", "frames", "--json", "f.json"});
  QVERIFY2(ran.code == 1, qPrintable(ran.error + ran.out));  // a fault was found
  QCOMPARE(ran.error, QString());                            // and that is no error
  QVERIFY2(ran.out.contains("frame 4: Both pictures are dark."), qPrintable(ran.out));
  QVERIFY2(ran.out.contains("frame 9: The frame before comes once more."), qPrintable(ran.out));
  const QJsonObject json = figures("f.json");
  QCOMPARE(json["faults"].toInt(), 2);
  QCOMPARE(json["fault_black"].toInt(), 1);
  QCOMPARE(json["fault_duplicated"].toInt(), 1);
}

void StereoCommandsTest::CheckHoldsPairsAgainstTheCalibration() {
  put_pair();
  fs::create_directory(at("frames"));
  fs::rename(at("l.png"), at("frames/left-0.png"));
  fs::rename(at("r.png"), at("frames/right-0.png"));
  Ran ran = run({"check", "--video", "frames", "--calibration", "c.yaml"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error + ran.out));
  fs::rename(at("frames/left-0.png"), at("kept.png"));
  fs::rename(at("frames/right-0.png"), at("frames/left-0.png"));
  fs::rename(at("kept.png"), at("frames/right-0.png"));
  ran = run({"check", "--video", "frames", "--calibration", "c.yaml"});
  QCOMPARE(ran.code, 1);
  QVERIFY2(ran.out.contains("frame 0: Left and right are swapped."), qPrintable(ran.out + ran.error));
}

/// As every other command does.
void StereoCommandsTest::CheckTakesTheCalibrationOfWholeViewsForPicturesThatAreCut() {
  put_pair();
  fs::create_directory(at("frames"));
  fs::rename(at("l.png"), at("frames/left-0.png"));
  fs::rename(at("r.png"), at("frames/right-0.png"));
  write_text(at("cut.json"), R"({"left": "frames", "crop": [10, 6, 300, 220]})");
  const Ran ran = run({"check", "--video", "cut.json", "--calibration", "c.yaml"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error + ran.out));
}

void StereoCommandsTest::CheckNamesWhatIsMissing() {
  refused({"check", "--video", "nothing.mkv"}, "nothing.mkv");
  write_text(at("v.mkv"), "no video");
  refused({"check", "--video", "v.mkv"}, "v.mkv");
  put_frames(2, {});
  refused({"check", "--video", "frames", "--calibration", "none.yaml"}, "none.yaml");
  refused({"check", "--video", "frames", "--json", "nowhere/f.json"}, "nowhere");
}

void StereoCommandsTest::ProofsRefuseWrongUsage() {
  refused({"prove"}, "arguments", 2);
  refused({"prove", "stereo", "patient", "--out", "p"}, "arguments", 2);
  refused({"prove", "everything", "--out", "p"}, "everything: is no proof", 2);
  refused({"prove", "stereo"}, "--out", 2);
  refused({"prove", "stereo", "--out", "nowhere/p"}, "nowhere/p");
  write_text(at("p"), "a file");
  refused({"prove", "stereo", "--out", "p"}, "is a file");
  refused({"prove", "stereo", "--out", "q", "--seed", "one"}, "--seed", 2);
  // What a run that was cut short has left is read from the folder itself, before anything is computed.
  fs::create_directory(at("cut_short"));
  write_text(at("cut_short/registration_1.csv"), "set,patient\nnobody,nothing\n");
  refused({"prove", "registration", "--out", "cut_short", "--resume"},
          "cut_short/registration_1.csv: line 2");
}

void StereoCommandsTest::AProofWithoutItsDataIsNoSuccess() {
  for (const char* proof : {"stereo", "patient"}) {
    const Ran ran = run({"prove", proof, "--real-only", "--data", "none", "--out", "p", "--figures", "f"});
    QVERIFY2(ran.code == 3, qPrintable(QString::number(ran.code) + ran.error + ran.out));
    QVERIFY(ran.out.contains("not measured"));
    const std::string page = read_file(at("f") / (std::string(proof) + ".md"));
    QVERIFY(page.find("0 not met") != std::string::npos && page.find(" aims met, ") != std::string::npos);
  }
}

void StereoCommandsTest::ACancelledProofLeavesNothing() {
  for (const char* proof : {"stereo", "patient"}) {
    const Ran ran = interrupted({"prove", proof, "--data", "none", "--out", "p"});
    QVERIFY2(ran.code == 130, qPrintable(QString::number(ran.code) + ran.error + ran.out));
    QVERIFY(ran.error.contains("nothing was written"));
    QCOMPARE(files(), 0);
  }
}

void StereoCommandsTest::put_pair() const {
  if (!fs::exists(rendered_.path() / "l.png")) {
    const auto surface =
        rendered::plane(Eigen::Vector3d(0, 0, 0.08), Eigen::Vector3d(0.1, 0.2, -1.0).normalized());
    rendered::Look look;
    look.grain = 0.0025;
    for (const bool left : {true, false})
      stereo::write_picture(rendered_.path() / (left ? "l.png" : "r.png"),
                            rendered::render(half_rig(), left, surface, look, nullptr));
  }
  for (const char* name : {"l.png", "r.png"}) fs::copy_file(rendered_.path() / name, at(name));
  stereo::write_calibration(at("c.yaml"), half_rig());
  const Picture left = stereo::read_picture(at("l.png"));
  stereo::write_picture(
      at("m.png"), {left.width, left.height, 1,
                    std::make_shared<std::vector<std::uint8_t>>(left.bytes->size() / 3, std::uint8_t{255})});
  write_text(at("g.json"),
             R"({"regions": [{"label": "surface", "polygon": [[60,60],[260,60],[260,180],[60,180]]}]})");
}

void StereoCommandsTest::ReconstructRefusesBadInput_data() {
  QTest::addColumn<QString>("file");  // that is damaged, and named
  QTest::addColumn<int>("kept");      // so many hundredths of it
  QTest::newRow("left picture cut off") << "l.png" << 50;
  QTest::newRow("mask cut off") << "m.png" << 40;
  QTest::newRow("calibration cut off") << "c.yaml" << 60;
  QTest::newRow("regions cut off") << "g.json" << 70;
  QTest::newRow("no left picture") << "l.png" << -1;
  QTest::newRow("a folder as a picture") << "r.png" << -2;
}

void StereoCommandsTest::ReconstructRefusesBadInput() {
  QFETCH(QString, file);
  QFETCH(int, kept);
  put_pair();
  const fs::path path = at(qPrintable(file));
  const std::string whole = read_file(path);
  fs::remove(path);
  if (kept >= 0) write_text(path, whole.substr(0, whole.size() * static_cast<std::size_t>(kept) / 100));
  if (kept == -2) fs::create_directory(path);
  refused(reconstruct() + QStringList{"--mask", "m.png", "--regions", "g.json"}, file);
}

void StereoCommandsTest::ReconstructNamesTheFaultOfAPair() {
  put_pair();
  refused(reconstruct("l.png", "l.png"), "the same picture in both views");
  refused(reconstruct("r.png", "l.png"), "swapped");
  const Picture left = stereo::read_picture(at("l.png"));
  stereo::write_picture(at("black.png"),
                        {left.width, left.height, 3,
                         std::make_shared<std::vector<std::uint8_t>>(left.bytes->size(), std::uint8_t{2})});
  refused(reconstruct("l.png", "black.png"), "nothing in the right view");
  stereo::write_picture(at("small.png"), {2, 1, 3, std::make_shared<std::vector<std::uint8_t>>(6)});
  refused(reconstruct("l.png", "small.png"), "differ in size");
  refused(reconstruct() + QStringList{"--mask", "small.png"}, "2x1");
  StereoRig other = half_rig();  // its cameras point 1.7 degrees apart in height
  other.right_from_left.rotation =
      Eigen::AngleAxisd(0.03, Eigen::Vector3d::UnitX()).toRotationMatrix() * other.right_from_left.rotation;
  stereo::write_calibration(at("other.yaml"), other);
  refused(reconstruct("l.png", "r.png", "other.yaml"), "another laparoscope");
  // Clicked on another pair.
  write_text(at("g.json"), R"({"identity": "0123456789abcdef", "regions": [{"label": "surface",
    "polygon": [[60,60],[260,60],[260,180],[60,180]]}]})");
  refused(reconstruct() + QStringList{"--regions", "g.json"}, "not to this pair");
  // What all these refuse is reconstructed otherwise.
  const Ran ran = run(reconstruct());
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(fs::exists(at("o.ply")));
}

void StereoCommandsTest::refuse_reconstruction(const QSize& size, const QString& mentions) const {
  QImage picture(size, QImage::Format_RGB888);
  picture.fill(Qt::darkRed);
  QVERIFY(picture.save(text_of("l.png")) && picture.save(text_of("r.png")));
  refused(
      {"reconstruct", "--left", "l.png", "--right", "r.png", "--calibration", "c.yaml", "--out", "cloud.ply"},
      mentions);
}

void StereoCommandsTest::ACalibrationOfAnotherSizeIsRefused() {
  stereo::write_calibration(at("c.yaml"), rig());
  refuse_reconstruction({640, 480}, "320x240");
}

void StereoCommandsTest::SwappedCamerasAreRecognised() {
  // Written by hand: the writer of a calibration would not write one that its reader refuses.
  stereo::write_calibration(at("good.yaml"), rig());
  std::string yaml = read_file(at("good.yaml"));
  const auto place = yaml.find("-5.");
  QVERIFY2(place != std::string::npos, yaml.c_str());
  yaml.erase(place, 1);
  write_text(at("c.yaml"), yaml);
  refuse_reconstruction({320, 240}, "swap");
}

QTEST_GUILESS_MAIN(StereoCommandsTest)
#include "stereo_commands_test.moc"
