// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/calibrate.h"

#include <QTest>
#include <opencv2/aruco/charuco.hpp>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "picture_pairs.h"
#include "real_data.h"
#include "rendered_board.h"
#include "rendered_pair.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

namespace {

constexpr double kNoise = 0.2;

Board small_board() {
  Board board;
  board.columns = 9;
  board.rows = 6;
  board.square = 6e-3;
  return board;
}

BoardViews views_of(const StereoRig& rig, const Board& board, const std::vector<rendered::BoardPose>& poses) {
  BoardViews views(board);
  std::mt19937 random(5);  // NOLINT: the same noise on every run
  for (const rendered::BoardPose& pose : poses)
    views.add_corners(rendered::board_view(rig, board, pose, kNoise, random), rig.left.width,
                      rig.left.height);
  return views;
}

Calibration calibrated(const BoardViews& views, const CalibrateOptions& options = {}) {
  return *calibrate(views, options, RunContext());
}

std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

StereoRig swapped(const StereoRig& rig) {
  StereoRig result;
  result.left = rig.right;
  result.right = rig.left;
  result.right_from_left.rotation = rig.right_from_left.rotation.transpose();
  result.right_from_left.translation =
      -(rig.right_from_left.rotation.transpose() * rig.right_from_left.translation);
  return result;
}

}  // namespace

class CalibrateTest : public QObject {
  Q_OBJECT

 private slots:
  void KnownRigIsFoundAgain() {
    const StereoRig rig = rendered::rig();
    const Board board = small_board();
    const Calibration found = calibrated(views_of(rig, board, rendered::board_poses(board, 0.12)));
    QVERIFY(std::abs(found.rig.left.matrix(0, 0) / rig.left.matrix(0, 0) - 1.0) < 5e-3);
    QVERIFY(std::abs(found.rig.right.matrix(1, 1) / rig.right.matrix(1, 1) - 1.0) < 5e-3);
    QVERIFY(std::abs(found.rig.baseline() / rig.baseline() - 1.0) < 0.02);
    QVERIFY((found.rig.right_from_left.rotation - rig.right_from_left.rotation).norm() < 5e-3);
    // The distance of a corner from where it should be: noise in both directions.
    QVERIFY(std::abs(found.rms / (std::sqrt(2.0) * kNoise) - 1.0) < 0.1);
    // Rows differ by the noise of two corners, whoever judges them.
    QVERIFY(std::abs(found.epipolar_left_out / (std::sqrt(2.0) * kNoise) - 1.0) < 0.25);
    QVERIFY(found.epipolar_rms <= found.epipolar_left_out);
    QVERIFY(found.focal_sigma > 0.0 &&
            std::abs(found.rig.left.matrix(0, 0) - rig.left.matrix(0, 0)) < 4.0 * found.focal_sigma);
    for (const ViewReport& view : found.views) {
      QVERIFY(view.used && !view.outlier);
      QVERIFY(view.distance > 0.09 && view.distance < 0.15);
      QVERIFY(view.tilt > 0.2 && view.tilt < 0.9);
    }
    QVERIFY(found.left_coverage > 0.3 && found.left_coverage < 1.0);
  }

  void ReferenceThatIsOffHasTheLargerEpipolarError() {
    const StereoRig rig = rendered::rig();
    const Board board = small_board();
    CalibrateOptions options;
    options.reference = rig;
    options.reference->right.matrix(1, 2) += 3.0;  // rows off by three pixels
    const Calibration found = calibrated(views_of(rig, board, rendered::board_poses(board, 0.12)), options);
    QVERIFY(std::abs(found.epipolar_reference - 3.0) < 0.2);
    for (const ViewReport& view : found.views) QVERIFY(view.epipolar_left_out < view.epipolar_reference);
  }

  /// What is written must be read again.
  void CamerasThatNoFileMayHoldAreRefused() {
    StereoRig rig = rendered::rig();
    rig.right.distortion << 0.0, 0.0, 0.02, 0.02, 0.0;
    const Board board = small_board();
    const BoardViews views = views_of(rig, board, rendered::board_poses(board, 0.12));
    const std::string said = complaint([&] { (void)calibrate(views, {}, RunContext()); });
    QVERIFY2(said.find("right camera") != std::string::npos &&
                 said.find("tangential terms") != std::string::npos &&
                 said.find("Take more views") != std::string::npos,
             said.c_str());
  }

  void UnusableOptionsAreNamed() {
    const auto refused = [](const std::function<void(CalibrateOptions&)>& change) {
      CalibrateOptions options;
      options.reference = rendered::rig();
      change(options);
      return QString::fromStdString(test::refused_field([&] { options.validate(); }));
    };
    QCOMPARE(refused([](CalibrateOptions&) {}), QString("none"));
    QCOMPARE(refused([](CalibrateOptions& o) { o.without = {"frame 3", ""}; }), QString("without"));
    QCOMPARE(refused([](CalibrateOptions& o) { o.reference->left.matrix(0, 0) = 0.0; }),
             QString("reference"));
    QCOMPARE(refused([](CalibrateOptions& o) { o.reference->right.matrix(0, 2) = -1.0; }),
             QString("reference"));
    QCOMPARE(refused([](CalibrateOptions& o) { o.reference->right_from_left.rotation *= 2.0; }),
             QString("reference"));
    QCOMPARE(refused([](CalibrateOptions& o) { o.reference->right_from_left.translation *= 100.0; }),
             QString("reference"));
    QCOMPARE(refused([](CalibrateOptions& o) { o.reference = swapped(*o.reference); }), QString("reference"));
    // Calibrating looks at them, too.
    CalibrateOptions unnamed;
    unnamed.without = {""};
    const Board board = small_board();
    const BoardViews views = views_of(rendered::rig(), board, rendered::board_poses(board, 0.12));
    QVERIFY_THROWS_EXCEPTION(InputError, (void)calibrate(views, unnamed, RunContext()));
  }

  void ViewThatDoesNotFitIsProposedAndDropped() {
    const StereoRig rig = rendered::rig();
    const Board board = small_board();
    BoardViews views = views_of(rig, board, rendered::board_poses(board, 0.12));
    std::mt19937 random(9);  // NOLINT: the same noise on every run
    BoardView moved = rendered::board_view(rig, board, rendered::board_at(board, {0.0, 0.0, 0.12}, 0.3, -0.2),
                                           kNoise, random);
    for (Eigen::Vector2d& p : moved.right.pixels) p.y() += 4.0;  // the board moved between the two pictures
    views.add_corners(moved, rig.left.width, rig.left.height);
    const Calibration kept = calibrated(views);
    QVERIFY(kept.views.back().outlier && kept.views.back().used);
    QCOMPARE(std::count_if(kept.views.begin(), kept.views.end(), [](const auto& v) { return v.outlier; }),
             1L);
    CalibrateOptions options;
    options.drop_outliers = true;
    const Calibration dropped = calibrated(views, options);
    QVERIFY(!dropped.views.back().used);
    QVERIFY(dropped.rms < 0.6 * kept.rms);
    QVERIFY(dropped.views.back().epipolar_left_out > 3.0);
  }

  /// Among few views a wrong one bends the cameras: its own error is hardly larger than that of the others.
  void OneWrongViewAmongSixIsNamed_data() {
    QTest::addColumn<int>("bad");
    QTest::addColumn<double>("down");
    QTest::addColumn<double>("across");
    QTest::addColumn<double>("blur");
    QTest::newRow("none") << -1 << 0.0 << 0.0 << 0.0;
    QTest::newRow("moved down between its pictures") << 0 << 4.0 << 0.0 << 0.0;
    QTest::newRow("the same, another view") << 3 << 4.0 << 0.0 << 0.0;
    QTest::newRow("moved across") << 2 << 0.0 << 4.0 << 0.0;
    QTest::newRow("moved a little") << 5 << 2.0 << 0.0 << 0.0;
    QTest::newRow("blurred") << 1 << 0.0 << 0.0 << 2.0;
  }
  void OneWrongViewAmongSixIsNamed() {
    QFETCH(int, bad);
    QFETCH(double, down);
    QFETCH(double, across);
    QFETCH(double, blur);
    const StereoRig rig = rendered::rig();
    const Board board = small_board();
    const auto poses = rendered::board_poses(board, 0.12);
    std::mt19937 random(7);  // NOLINT: the same noise on every run
    std::normal_distribution<double> noise(0.0, blur);
    BoardViews views(board);
    for (int i = 0; i < 6; ++i) {
      BoardView view =
          rendered::board_view(rig, board, poses[static_cast<std::size_t>(2 * i)], kNoise, random);
      if (i == bad) {
        for (Eigen::Vector2d& p : view.right.pixels)
          p += Eigen::Vector2d{across + noise(random), down + noise(random)};
      }
      view.name = std::to_string(i);
      views.add_corners(view, rig.left.width, rig.left.height);
    }
    const Calibration kept = calibrated(views);
    for (int i = 0; i < 6; ++i) QCOMPARE(kept.views[static_cast<std::size_t>(i)].outlier, i == bad);
    if (bad < 0) return;
    CalibrateOptions options;
    options.drop_outliers = true;
    const Calibration dropped = calibrated(views, options);
    for (int i = 0; i < 6; ++i) QCOMPARE(dropped.views[static_cast<std::size_t>(i)].used, i != bad);
    QVERIFY(std::abs(dropped.rms / (std::sqrt(2.0) * kNoise) - 1.0) < 0.15);
    QVERIFY(std::abs(dropped.rig.baseline() / rig.baseline() - 1.0) < 0.02);
  }

  void ViewWhoseCornersAreMixedUpIsNamed() {
    const StereoRig rig = rendered::rig();
    const Board board = small_board();
    const auto poses = rendered::board_poses(board, 0.12);
    std::mt19937 random(7);  // NOLINT: the same noise on every run
    BoardViews views(board);
    for (int i = 0; i < 6; ++i) {
      BoardView view =
          rendered::board_view(rig, board, poses[static_cast<std::size_t>(2 * i)], kNoise, random);
      view.name = "shot " + std::to_string(i);
      if (i == 4) std::rotate(view.left.pixels.begin(), view.left.pixels.begin() + 1, view.left.pixels.end());
      views.add_corners(view, rig.left.width, rig.left.height);
    }
    const std::string said = complaint([&] { calibrated(views); });
    QVERIFY2(said.find("shot 4") != std::string::npos, said.c_str());
    CalibrateOptions options;
    options.drop_outliers = true;
    const Calibration dropped = calibrated(views, options);
    for (int i = 0; i < 6; ++i) QCOMPARE(dropped.views[static_cast<std::size_t>(i)].used, i != 4);
    QVERIFY(std::abs(dropped.rms / (std::sqrt(2.0) * kNoise) - 1.0) < 0.15);
  }

  void SwappedCamerasAreRecognised() {
    const Board board = small_board();
    const BoardViews views = views_of(swapped(rendered::rig()), board, rendered::board_poses(board, 0.12));
    QVERIFY(complaint([&] { calibrated(views); }).find("swapped") != std::string::npos);
  }

  void WrongSquareIsRecognised() {
    Board board = small_board();
    const BoardViews views = views_of(rendered::rig(), board, rendered::board_poses(board, 0.12));
    board.square = 60e-3;  // centimetres taken for millimetres
    BoardViews wrong(board);
    for (const BoardView& view : views.views()) wrong.add_corners(view, views.width(), views.height());
    QVERIFY(complaint([&] { calibrated(wrong); }).find("Measure the side of a square") != std::string::npos);
  }

  void ParallelViewsAreRefused() {
    const Board board = small_board();
    std::vector<rendered::BoardPose> poses;
    for (int i = 0; i < 8; ++i)
      poses.push_back(
          rendered::board_at(board, {0.004 * (i % 3), 0.003 * (i / 3), 0.12 + 1e-3 * i}, 0.0, 0.0));
    QVERIFY(complaint([&] { calibrated(views_of(rendered::rig(), board, poses)); }).find("Tilt the board") !=
            std::string::npos);
  }

  void TooFewViewsAreRefused() {
    const Board board = small_board();
    auto poses = rendered::board_poses(board, 0.12);
    poses.resize(2);
    QVERIFY_THROWS_EXCEPTION(InputError, calibrated(views_of(rendered::rig(), board, poses)));
  }

  void CancelLeavesNothing() {
    const auto flag = std::make_shared<CancelFlag>();
    flag->request();
    const Board board = small_board();
    const BoardViews views = views_of(rendered::rig(), board, rendered::board_poses(board, 0.12));
    QVERIFY(!calibrate(views, {}, RunContext({}, flag, 1)));
  }

  void MostDifferentViewsAreKept() {
    const Board board = small_board();
    const auto poses = rendered::board_poses(board, 0.12);
    std::vector<rendered::BoardPose> many(30, poses[0]);  // a video that rests, and moves at its end
    many.insert(many.end(), poses.begin(), poses.begin() + 6);
    BoardViews views = views_of(rendered::rig(), board, many);
    views.keep_most_different(6);
    QCOMPARE(views.views().size(), std::size_t{6});
    const Calibration found = calibrated(views);
    QVERIFY(std::abs(found.rig.left.matrix(0, 0) / rendered::rig().left.matrix(0, 0) - 1.0) < 0.02);
  }

  void BoardsAreChecked() {
    const auto refused = [](auto change) {
      Board board = small_board();
      change(board);
      return !complaint([&] { board.validate(); }).empty();
    };
    QVERIFY(!refused([](Board&) {}));
    QVERIFY(refused([](Board& b) { b.columns = 2; }));
    QVERIFY(refused([](Board& b) { b.square = 0.0; }));
    QVERIFY(refused([](Board& b) { b.square = std::nan(""); }));
    QVERIFY(refused([](Board& b) { b.dictionary = "DICT_9X9_1"; }));
    QVERIFY(refused([](Board& b) { b.dictionary = "DICT_4X4_50"; }));  // markers of no size
    QVERIFY(refused([](Board& b) {
      b.dictionary = "DICT_4X4_50";
      b.marker = 4e-3;
      b.columns = b.rows = 20;
    }));
  }

  void CornersOfAPictureAreFoundAndTurnedAlike() {
    const StereoRig rig = rendered::rig();
    const Board board = small_board();
    const auto pose = rendered::board_at(board, {0.002, -0.001, 0.115}, 0.3, -0.25, 0.1);
    const Picture left = rendered::board_picture(rig, true, pose, rendered::chessboard_ink(board));
    const Picture right = rendered::board_picture(rig, false, pose, rendered::chessboard_ink(board));
    BoardViews views(board);
    QVERIFY(views.add("pair", left, right) == BoardViews::Found::both);
    std::mt19937 random(1);  // NOLINT: no noise is drawn
    const BoardView truth = rendered::board_view(rig, board, pose, 0.0, random);
    BoardView found = views.views()[0];
    if ((found.left.pixels[0] - truth.left.pixels[0]).norm() > 10.0) {  // counted from the other end
      std::reverse(found.left.pixels.begin(), found.left.pixels.end());
      std::reverse(found.right.pixels.begin(), found.right.pixels.end());
    }
    for (std::size_t i = 0; i < truth.left.pixels.size(); ++i) {
      QVERIFY((found.left.pixels[i] - truth.left.pixels[i]).norm() < 0.15);
      QVERIFY((found.right.pixels[i] - truth.right.pixels[i]).norm() < 0.15);
    }
    QVERIFY_THROWS_EXCEPTION(InputError, views.add("twice", left, left));
    const Picture half{left.width / 2, left.height, 1,
                       std::make_shared<std::vector<std::uint8_t>>(left.bytes->size() / 2)};
    QVERIFY_THROWS_EXCEPTION(InputError, views.add("other size", half, half));
  }

  void WrongBoardSizeIsRecognised() {
    const StereoRig rig = rendered::rig();
    const Board board = small_board();
    const auto pose = rendered::board_at(board, {0.0, 0.0, 0.115}, 0.3, -0.25);
    const Picture left = rendered::board_picture(rig, true, pose, rendered::chessboard_ink(board));
    const Picture right = rendered::board_picture(rig, false, pose, rendered::chessboard_ink(board));
    Board wrong = board;
    wrong.columns = 10;  // squares counted instead of corners
    wrong.rows = 7;
    BoardViews views(wrong);
    QVERIFY(views.add("pair", left, right) == BoardViews::Found::neither);
    const std::string said = complaint([&] { calibrated(views); });
    QVERIFY2(said.find("9x6") != std::string::npos, said.c_str());
  }

  void CharucoIsFoundWhereTheBoardIsCutOff() {
    const StereoRig rig = rendered::rig();
    Board board = small_board();
    board.dictionary = "DICT_4X4_50";
    board.marker = 4.2e-3;
    cv::Mat print;
    constexpr int kPerSquare = 60;
    cv::aruco::CharucoBoard::create(10, 7, static_cast<float>(board.square), static_cast<float>(board.marker),
                                    cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50))
        ->draw(cv::Size(10 * kPerSquare, 7 * kPerSquare), print);
    const auto ink = [&](double x, double y) {
      const double u = (x / board.square + 1.0) * kPerSquare, v = (y / board.square + 1.0) * kPerSquare;
      if (u < 0.0 || v < 0.0 || u >= print.cols || v >= print.rows) return 1.0;
      return print.at<std::uint8_t>(static_cast<int>(v), static_cast<int>(u)) / 255.0;
    };
    const auto pose = rendered::board_at(board, {0.03, 0.0, 0.1}, 0.2, -0.25);  // its right side lies outside
    BoardViews views(board);
    QVERIFY(views.add("pair", rendered::board_picture(rig, true, pose, ink),
                      rendered::board_picture(rig, false, pose, ink)) == BoardViews::Found::both);
    const BoardView& found = views.views()[0];
    QVERIFY(found.left.size() >= 12 && found.left.size() < board.corners());
    QVERIFY(found.left.ids == found.right.ids);
    std::vector<double> errors;
    for (std::size_t i = 0; i < found.left.ids.size(); ++i) {
      const Eigen::Vector3d p = pose.rotation * board.corner(found.left.ids[i]) + pose.translation;
      errors.push_back((rig.left.project(p) - found.left.pixels[i]).norm());
    }
    std::sort(errors.begin(), errors.end());
    QVERIFY2(errors[errors.size() / 2] < 0.15, QByteArray::number(errors[errors.size() / 2]).constData());
    QVERIFY2(errors.back() < 0.6, QByteArray::number(errors.back()).constData());
  }

  void RealPairsCalibrateBetterThanTheirReference() {
    const fs::path folder = glisson::test::data_folder() / "stereo_chessboard";
    if (!fs::exists(folder)) QSKIP("the real chessboards are not here (see GLISSON_DATA)");
    BoardViews views{Board()};
    std::vector<PicturePair> pairs = picture_pairs(folder).pairs;
    QCOMPARE(pairs.size(), std::size_t{9});
    pairs.resize(6);  // the command `prove stereo` takes all: a second a picture
    for (const PicturePair& pair : pairs)
      QVERIFY(views.add(pair.name, read_picture(pair.left), read_picture(pair.right)) ==
              BoardViews::Found::both);
    CalibrateOptions options;
    options.reference = read_text_calibration(folder, 1920, 1080);
    const Calibration found = calibrated(views, options);
    for (const ViewReport& view : found.views)
      qInfo("%s: %.2f and %.2f px, %.0f mm, %.0f degrees, rows %.2f px left out, %.2f px by the reference%s",
            view.name.c_str(), view.left_rms, view.right_rms, 1e3 * view.distance, 57.3 * view.tilt,
            view.epipolar_left_out, view.epipolar_reference, view.outlier ? ", outlier" : "");
    qInfo("rms %.3f px (alone %.3f and %.3f), rows %.3f left out, %.3f by the reference, baseline %.2f mm",
          found.rms, found.left_alone, found.right_alone, found.epipolar_left_out, found.epipolar_reference,
          1e3 * found.rig.baseline());
    QVERIFY(found.rms <= 0.65);
    QVERIFY(found.epipolar_left_out < 0.5 * found.epipolar_reference);
    QVERIFY(std::abs(1e3 * found.rig.baseline() - 4.7) < 0.3);
    const Picture picture = coverage_picture(views, found);
    QVERIFY(picture.width > 1000 && picture.channels == 3);
  }
};

QTEST_APPLESS_MAIN(CalibrateTest)
#include "calibrate_test.moc"
