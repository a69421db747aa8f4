// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/calibration_io.h"

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <fstream>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "mutant.h"
#include "text_calibration.h"

using namespace glisson;
using namespace glisson::stereo;
using test::write_text_calibration;

namespace {

StereoRig example() {
  StereoRig rig;
  rig.left.width = rig.right.width = 960;
  rig.left.height = rig.right.height = 540;
  rig.left.matrix << 900.5, 0, 470.25, 0, 901.5, 268.75, 0, 0, 1;
  rig.right.matrix << 905.5, 0, 490.25, 0, 904.5, 271.75, 0, 0, 1;
  rig.left.distortion << -0.2, 0.1, 0.001, -0.002, 0.03;
  rig.right.distortion << -0.21, 0.12, -0.001, 0.002, 0.0;
  rig.right_from_left.rotation =
      Eigen::AngleAxisd(0.03, Eigen::Vector3d(0.1, 1.0, 0.2).normalized()).toRotationMatrix();
  rig.right_from_left.translation << -0.0045, 0.0001, 0.0002;
  return rig;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the test's text does not hold " + from);
  return text.replace(at, from.size(), to);
}

/// What calibration programs write by hand, in the unit given.
std::string yaml(const std::string& unit, const std::string& t) {
  return "%YAML:1.0\n---\nimage_width: 960\nimage_height: 540\nunit: " + unit +
         "\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
         "   data: [ 900., 0., 470., 0., 900., 268., 0., 0., 1. ]\n"
         "D1: !!opencv-matrix\n   rows: 4\n   cols: 1\n   dt: f\n   data: [ -0.1, 0.01, 0., 0. ]\n"
         "M2: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
         "   data: [ 900., 0., 490., 0., 900., 268., 0., 0., 1. ]\n"
         "D2: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [ -0.1, 0.01, 0., 0., 0. ]\n"
         "R: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
         "   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]\n"
         "T: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ " +
         t + " ]\n";
}

}  // namespace

class CalibrationIoTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

  std::filesystem::path file(const std::string& content) {
    std::ofstream(folder_.path() / "rig.yml", std::ios::binary) << content;
    return folder_.path() / "rig.yml";
  }

  std::string refusal(const std::string& content) {
    return test::refused_field([&] { read_calibration(file(content)); });
  }

 private slots:
  void WhatIsWrittenIsRead() {
    const StereoRig rig = example();
    const auto path = folder_.path() / "round.yml";
    write_calibration(path, rig);
    const StereoRig back = read_calibration(path);
    QCOMPARE(back.left.width, 960);
    QCOMPARE(back.right.height, 540);
    QVERIFY((back.left.matrix - rig.left.matrix).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY((back.right.matrix - rig.right.matrix).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY((back.left.distortion - rig.left.distortion).cwiseAbs().maxCoeff() < 1e-15);
    QVERIFY((back.right.distortion - rig.right.distortion).cwiseAbs().maxCoeff() < 1e-15);
    QVERIFY((back.right_from_left.rotation - rig.right_from_left.rotation).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY((back.right_from_left.translation - rig.right_from_left.translation).norm() < 1e-15);
  }

  void UnitsScaleTheBaseline() {
    QVERIFY(std::abs(read_calibration(file(yaml("mm", "-4.5, 0., 0."))).baseline() - 0.0045) < 1e-15);
    QVERIFY(std::abs(read_calibration(file(yaml("cm", "-0.45, 0., 0."))).baseline() - 0.0045) < 1e-15);
    QVERIFY(std::abs(read_calibration(file(yaml("m", "-0.0045, 0., 0."))).baseline() - 0.0045) < 1e-15);
  }

  void RoundedRotationBecomesExact() {
    const std::string text = replaced(yaml("mm", "-4.5, 0., 0."), "[ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]",
                                      "[ 0.9995, 0., -0.0302, 0., 1., 0., 0.0302, 0., 0.9995 ]");
    const Eigen::Matrix3d r = read_calibration(file(text)).right_from_left.rotation;
    QVERIFY((r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-14);
  }

  void BadInputIsRefusedAndNamed_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QByteArray>("field");
    const auto row = [](const char* name, const std::string& content, const char* field) {
      QTest::newRow(name) << QByteArray::fromStdString(content) << QByteArray(field);
    };
    const std::string good = yaml("mm", "-4.5, 0., 0.");
    row("empty", "", "");
    row("not YAML", "M1 = [1 2 3]", "");
    row("cut off", good.substr(0, good.find("M2")), "M2");
    row("cut off in a matrix", good.substr(0, good.find("490")), "");
    row("metres written as mm", yaml("mm", "-0.0045, 0., 0."), "T");
    row("mm written as metres", yaml("m", "-4.5, 0., 0."), "T");
    row("no baseline", yaml("mm", "0., 0., 0."), "T");
    row("swapped", yaml("mm", "4.5, 0., 0."), "T");
    row("inches", yaml("inch", "-4.5, 0., 0."), "unit");
    row("unit of a number", yaml("7", "-4.5, 0., 0."), "unit");
    row("no unit", replaced(good, "unit: mm\n", ""), "unit");
    row("no width", replaced(good, "image_width: 960\n", ""), "image_width");
    row("width of zero", replaced(good, "image_width: 960", "image_width: 0"), "image_width");
    row("width in words", replaced(good, "image_width: 960", "image_width: wide"), "image_width");
    row("half the image", replaced(good, "image_width: 960", "image_width: 480"), "M2");
    row("not a rotation", replaced(good, "[ 1., 0., 0., 0., 1., 0.,", "[ 1.1, 0., 0., 0., 1., 0.,"), "R");
    row("mirrored", replaced(good, "[ 1., 0., 0., 0., 1., 0.,", "[ -1., 0., 0., 0., 1., 0.,"), "R");
    row("R a vector",
        replaced(good, "R: !!opencv-matrix\n   rows: 3\n   cols: 3",
                 "R: !!opencv-matrix\n   rows: 9\n   cols: 1"),
        "R");
    row("D too short",
        replaced(good, "rows: 4\n   cols: 1\n   dt: f\n   data: [ -0.1, 0.01, 0., 0. ]",
                 "rows: 2\n   cols: 1\n   dt: f\n   data: [ -0.1, 0.01 ]"),
        "D1");
    row("D of the rational model",
        replaced(good, "rows: 1\n   cols: 5\n   dt: d\n   data: [ -0.1, 0.01, 0., 0., 0. ]",
                 "rows: 1\n   cols: 8\n   dt: d\n   data: [ -0.1, 0.01, 0., 0., 0., 0.1, 0., 0. ]"),
        "D2");
    row("M not a camera", replaced(good, "[ 900., 0., 470.", "[ -900., 0., 470."), "M1");
    // As MATLAB and others write them.
    row("skew", replaced(good, "[ 900., 0., 490.", "[ 900., 2.5, 490."), "M2");
    row("negative skew", replaced(good, "[ 900., 0., 470.", "[ 900., -2.5, 470."), "M1");
    row("transposed",
        replaced(good, "[ 900., 0., 470., 0., 900., 268., 0., 0., 1. ]",
                 "[ 900., 0., 0., 0., 900., 0., 470., 268., 1. ]"),
        "M1");
    row("k1 k2 k3 p1 p2",
        replaced(good, "[ -0.1, 0.01, 0., 0., 0. ]", "[ -0.27, 0.31, -0.19, 0.0012, -0.0008 ]"), "D2");
    row("M of text", replaced(good, "M1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n", "M1:\n"),
        "M1");
    row("a matrix of terabytes", replaced(good, "rows: 4\n   cols: 1", "rows: 400000000\n   cols: 1000"),
        "D1");
    row("NaN", replaced(good, "[ -4.5,", "[ .Nan,"), "T");
  }
  void BadInputIsRefusedAndNamed() {
    QFETCH(QByteArray, content);
    QFETCH(QByteArray, field);
    QCOMPARE(QByteArray::fromStdString(refusal(content.toStdString())), field);
  }

  /// One that moves no pixel is nobody's: followed points would have none and drawn ones would.
  void ASkewThatMovesNothingIsLeftOut() {
    const std::string good = yaml("mm", "-4.5, 0., 0.");
    const StereoRig rig = read_calibration(file(replaced(good, "[ 900., 0., 470.", "[ 900., 0.2, 470.")));
    QCOMPARE(rig.left.matrix(0, 1), 0.0);
    QCOMPARE(rig.left.matrix(0, 2), 470.0);
    const TemporaryFolder folder;
    StereoRig askew = example();
    askew.right.matrix(0, 1) = 0.2;
    write_text_calibration(folder.path(), askew);
    QCOMPARE(read_text_calibration(folder.path(), 960, 540).right.matrix(0, 1), 0.0);
    askew.right.matrix(0, 1) = 2.0;
    write_text_calibration(folder.path(), askew);
    QVERIFY_THROWS_EXCEPTION(InputError, read_text_calibration(folder.path(), 960, 540));
  }

  /// What real lenses have beside their radial terms is no mistake: two of a stereo laparoscope of 1920 x
  /// 1080.
  void TangentialTermsOfRealLensesAreRead() {
    StereoRig rig = example();
    rig.left.distortion << -0.269, 0.156, 0.0032, -0.0016, 0.0;
    rig.right.distortion << -0.253, 0.126, -0.0061, 0.0003, 0.0;
    const TemporaryFolder folder;
    write_text_calibration(folder.path(), rig);
    QVERIFY((read_text_calibration(folder.path(), 960, 540).right.distortion - rig.right.distortion).norm() <
            1e-12);
    // The same terms and a k3, in MATLAB's order.
    rig.right.distortion << -0.253, 0.126, -0.11, -0.0061, 0.0003;
    write_text_calibration(folder.path(), rig);
    QVERIFY_THROWS_EXCEPTION(InputError, read_text_calibration(folder.path(), 960, 540));
  }

  /// x (1 + k1 x^2) is nowhere larger than 2 / (3 sqrt(3 |k1|)): with k1 = -2.4 pixels more than 0.2485 focal
  /// lengths from the axis have no ray, and with k1 = -0.1 all of this picture have one.
  void WhereTheLensTurnsBackWithinThePictureIsTold() {
    StereoRig rig = example();
    QVERIFY(calibration_doubts(rig).empty());
    rig.left.distortion << -0.1, 0.0, 0.0, 0.0, 0.0;
    rig.right.distortion << -2.4, 0.0, 0.0, 0.0, 0.0;
    const std::vector<std::string> doubts = calibration_doubts(rig);
    QCOMPARE(doubts.size(), std::size_t{1});
    QVERIFY2(doubts[0].starts_with("calibration.right_lens_turns_back "), doubts[0].c_str());
    const double without = 0.01 * std::stod(doubts[0].substr(doubts[0].find(' ')));
    const double least = 1.0 - M_PI * std::pow(0.2485 * 905.0, 2) / (960.0 * 540.0);
    QVERIFY2(without > least - 0.01 && without < least + 0.03, doubts[0].c_str());
  }

  void OpenCvsJsonIsReadAndItsXmlIsNot() {
    // As cv::FileStorage writes it.
    const auto matrix = [](int rows, int columns, const std::string& data) {
      return "{ \"type_id\": \"opencv-matrix\", \"rows\": " + std::to_string(rows) +
             ", \"cols\": " + std::to_string(columns) + ", \"dt\": \"d\", \"data\": [ " + data + " ] }";
    };
    const std::string camera = matrix(3, 3, "900.0, 0.0, 470.0, 0.0, 900.0, 260.0, 0.0, 0.0, 1.0"),
                      bend = matrix(1, 5, "-1.0e-01, 0.01, 0.0, 0.0, 0.0");
    const std::string json =
        "{ \"image_width\": 960, \"image_height\": 540, \"unit\": \"mm\", \"M1\": " + camera +
        ", \"D1\": " + bend + ", \"M2\": " + camera + ", \"D2\": " + bend +
        ", \"R\": " + matrix(3, 3, "1, 0, 0, 0, 1, 0, 0, 0, 1") +
        ", \"T\": " + matrix(3, 1, "-4.5, 0.0, 0.0") + " }";
    const StereoRig rig = read_calibration(file(json));
    QCOMPARE(rig.left.matrix(0, 2), 470.0);
    QCOMPARE(rig.left.distortion[0], -0.1);
    QVERIFY(std::abs(rig.baseline() - 0.0045) < 1e-15);
    // As in YAML: which of two is meant is not known.
    std::string twice = json;
    twice.insert(twice.rfind(" }"), ", \"M1\": " + camera);
    QCOMPARE(refusal(twice), std::string("\"M1\""));
    std::string deep = json;
    deep.insert(deep.rfind(" }"), ", \"note\": " + std::string(70, '[') + std::string(70, ']'));
    QVERIFY_THROWS_EXCEPTION(InputError, read_calibration(file(deep)));
    QCOMPARE(refusal("<?xml version=\"1.0\"?>\n<opencv_storage></opencv_storage>\n"), std::string(""));
  }

  void WhatOthersWriteBesideItIsPassedOver() {
    std::string text = yaml("mm", "-4.5, 0., 0.");
    text +=
        "calibration_time: \"Tue 3 Mar 2026 10:00:00\"\nflags: 0x10\nviews:\n   - a.png\n   - b.png\n# the "
        "end\n"
        "errors: !!opencv-matrix\n   rows: 1\n   cols: 3\n   dt: \"2d\"\n   data: [ 1., 2., 3.,\n       4., "
        "5., 6. ]\n"
        "nested: { a: 1, b: [ 1, 2,\n   3 ] }\n";
    QCOMPARE(refusal(text), std::string("none"));
  }

  void MissingFileIsAFileError() {
    QVERIFY_THROWS_EXCEPTION(FileError, read_calibration(folder_.path() / "absent.yml"));
  }

  void MutantsNeverCrash() {
    const std::string good = yaml("mm", "-4.5, 0., 0.");
    std::mt19937 random(11);  // NOLINT: the same mutants on every run
    int refused = 0;
    for (int mutant = 0; mutant < 1500; ++mutant) {
      const std::string text = test::mutant_of(good, random, 12);
      const std::string result = refusal(text);
      QVERIFY2(!result.starts_with("other") && result != "no remedy", result.c_str());
      refused += result != "none";
    }
    QVERIFY(refused > 500);
  }

  void PlainTextIsReadAsItIsWritten() {
    const StereoRig rig = example();
    const TemporaryFolder folder;
    write_text_calibration(folder.path(), rig);
    const StereoRig back = read_text_calibration(folder.path(), 960, 540);
    QVERIFY((back.left.matrix - rig.left.matrix).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY((back.right.distortion - rig.right.distortion).cwiseAbs().maxCoeff() < 1e-15);
    QVERIFY((back.right_from_left.rotation - rig.right_from_left.rotation).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY((back.right_from_left.translation - rig.right_from_left.translation).norm() < 1e-15);
  }

  void PlainTextMapsTheWayThatItsNameSays() {
    const StereoRig rig = example();
    const auto with = [&](const char* name, const Eigen::Matrix4d& transform) {
      const TemporaryFolder folder;
      write_text_calibration(folder.path(), rig);
      std::filesystem::remove(folder.path() / "calib.l2r.txt");
      std::ofstream file(folder.path() / name);
      file.precision(17);
      file << transform << "\n";
      file.close();
      return read_text_calibration(folder.path(), 960, 540);
    };
    Eigen::Matrix4d right_from_left = Eigen::Matrix4d::Identity();
    right_from_left.topLeftCorner<3, 3>() = rig.right_from_left.rotation;
    right_from_left.topRightCorner<3, 1>() = 1e3 * rig.right_from_left.translation;
    const Eigen::Matrix4d left_from_right = right_from_left.inverse();
    for (const StereoRig& back :
         {with("l2r.txt", right_from_left), with("calib.R2L.txt", left_from_right),
          with("extrinsics.4x4", right_from_left), with("extrinsics.4x4", left_from_right)})
      QVERIFY((back.right_from_left.translation - rig.right_from_left.translation).norm() < 1e-12);
    QVERIFY_THROWS_EXCEPTION(InputError, with("l2r.txt", left_from_right));  // swapped
    QVERIFY_THROWS_EXCEPTION(InputError, with("r2l.txt", right_from_left));
  }

  void BadPlainTextIsRefused_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("words") << QByteArray("calib.left.intrinsics.txt")
                           << QByteArray("900 0 a 0 900 200 0 0 1");
    QTest::newRow("too few") << QByteArray("calib.left.intrinsics.txt") << QByteArray("900 0 400 0 900 200");
    QTest::newRow("NaN") << QByteArray("calib.right.distortion.txt") << QByteArray("0 0 nan 0");
    QTest::newRow("three terms") << QByteArray("calib.right.distortion.txt") << QByteArray("0 0 0");
    QTest::newRow("of a larger picture")
        << QByteArray("calib.right.intrinsics.txt") << QByteArray("2000 0 1900 0 2000 1000 0 0 1");
    QTest::newRow("not a rotation") << QByteArray("calib.l2r.txt")
                                    << QByteArray("2 0 0 -5 0 1 0 0 0 0 1 0 0 0 0 1");
    QTest::newRow("metres") << QByteArray("calib.l2r.txt")
                            << QByteArray("1 0 0 -.005 0 1 0 0 0 0 1 0 0 0 0 1");
    QTest::newRow("odd last row") << QByteArray("calib.l2r.txt")
                                  << QByteArray("1 0 0 -5 0 1 0 0 0 0 1 0 0 0 1 1");
    QTest::newRow("two of a kind") << QByteArray("old.left.intrinsic.txt") << QByteArray("1");
  }
  void BadPlainTextIsRefused() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, content);
    const TemporaryFolder folder;
    write_text_calibration(folder.path(), example());
    std::ofstream(folder.path() / name.toStdString()) << content.constData();
    QVERIFY_THROWS_EXCEPTION(InputError, read_text_calibration(folder.path(), 960, 540));
  }

  void IncompletePlainTextIsRefused() {
    const TemporaryFolder folder;
    write_text_calibration(folder.path(), example());
    std::filesystem::remove(folder.path() / "calib.right.distortion.txt");
    QVERIFY_THROWS_EXCEPTION(InputError, read_text_calibration(folder.path(), 960, 540));
    QVERIFY_THROWS_EXCEPTION(FileError, read_text_calibration(folder.path() / "absent", 960, 540));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, read_text_calibration(folder.path(), 0, 540));
  }

  void CalibrationsOfWholeViewsAreCutAsThePicturesAre() {
    const TemporaryFolder folder;
    write_calibration(folder.path() / "c.yaml", example());
    const Cut cut{960, 540, {40, 20, 800, 500}};
    const StereoRig part = read_calibration_for(folder.path() / "c.yaml", 800, 500, cut);
    QCOMPARE(part.left.width, 800);
    QCOMPARE(part.left.height, 500);
    QVERIFY(std::abs(part.left.matrix(0, 2) - (example().left.matrix(0, 2) - 40.0)) < 1e-6);
    // One that is of the cut pictures already stays, and so does any where nothing is cut.
    write_calibration(folder.path() / "part.yaml", part);
    QCOMPARE(read_calibration_for(folder.path() / "part.yaml", 800, 500, cut).left.matrix(0, 2),
             part.left.matrix(0, 2));
    QCOMPARE(read_calibration_for(folder.path() / "c.yaml", 960, 540, {}).left.width, 960);
    // Plain text does not tell its size: it is that of the whole views.
    write_text_calibration(folder.path(), example());
    QVERIFY(is_text_calibration(folder.path()) && !is_text_calibration(folder.path() / "c.yaml"));
    QCOMPARE(read_calibration_for(folder.path(), 800, 500, cut).left.width, 800);
    QCOMPARE(read_calibration_for(folder.path(), 960, 540, {}).left.width, 960);
  }

  void TwoImageSizesAreNotWritten() {
    StereoRig rig = example();
    rig.right.width = 640;
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_calibration(folder_.path() / "never.yml", rig));
  }
};

QTEST_APPLESS_MAIN(CalibrationIoTest)
#include "calibration_io_test.moc"
