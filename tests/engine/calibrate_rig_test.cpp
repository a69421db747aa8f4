// SPDX-License-Identifier: GPL-3.0-or-later
// From pictures of boards to cameras: the window and the command line post the same command.
#include <QTest>

#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/calibrate_rig.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/script.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "rendered_board.h"
#include "rendered_pair.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

class CalibrateRigTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void TheViewsThatDifferMostAreKept();
  void WhatWasFoundIsTakenAsItIs();
  void WhatBecomesOfEachPictureIsTold();
  void AReferenceIsReadForThePicturesSize();
  void ANumberOfViewsOutOfRangeIsRefusedBeforeAnyPictureIsRead();

 private:
  CalibrateRig command(int most_views) const {
    CalibrateRig command;
    command.search.left = folder_.path() / "boards";
    command.search.board = board_;
    command.search.most_views = most_views;
    command.options.leave_one_out = false;
    return command;
  }
  static std::shared_ptr<const CalibrationSheet> sheet_of(const CalibrateRig& command) {
    Script script{RunContext()};
    return script.run(command)->result.as<CalibrationSheet>();
  }

  static constexpr int kPairs = 6;
  const stereo::Board board_{9, 6, 6e-3, {}, 0.0};
  TemporaryFolder folder_;
};

void CalibrateRigTest::initTestCase() {
  const fs::path boards = folder_.path() / "boards";
  fs::create_directory(boards);
  const auto poses = rendered::board_poses(board_, 0.13);
  const auto ink = rendered::chessboard_ink(board_);
  for (int i = 0; i < kPairs; ++i)
    for (const bool left : {true, false})
      stereo::write_picture(
          boards / ((left ? "left-" : "right-") + std::to_string(i) + ".png"),
          rendered::board_picture(rendered::rig(), left, poses[2 * static_cast<std::size_t>(i)], ink));
  fs::copy_file(boards / "left-0.png", boards / "left-77.png");
  stereo::write_calibration(folder_.path() / "reference.yaml", rendered::rig());
}

void CalibrateRigTest::TheViewsThatDifferMostAreKept() {
  Script script{RunContext()};
  const auto outcome = script.run(command(4));
  const auto sheet = outcome->result.as<CalibrationSheet>();
  QCOMPARE(sheet->views->views().size(), std::size_t{4});
  QCOMPARE(sheet->views->too_alike(), kPairs - 4);
  QCOMPARE(sheet->calibration.views.size(), std::size_t{4});
  QCOMPARE(outcome->figures.at("calibration_pairs"), double{kPairs});
  QCOMPARE(outcome->figures.at("calibration_views"), 4.0);
  QVERIFY(script.state()[part::rig] != nullptr);
  QCOMPARE(sheet_of(command(40))->views->views().size(), std::size_t{kPairs});
}

void CalibrateRigTest::WhatWasFoundIsTakenAsItIs() {
  const auto first = sheet_of(command(5));
  CalibrateRig again = command(3);
  again.found = first->views;
  QVERIFY(sheet_of(again)->views == first->views);
}

void CalibrateRigTest::WhatBecomesOfEachPictureIsTold() {
  CalibrateRig told = command(40);
  std::vector<std::string> alone, looked;
  told.told.alone = [&](const fs::path& picture) { alone.push_back(picture.filename().string()); };
  told.told.looked = [&](const std::string& name, stereo::BoardViews::Found found) {
    if (found == stereo::BoardViews::Found::both) looked.push_back(name);
  };
  sheet_of(told);
  QCOMPARE(alone, std::vector<std::string>{"left-77.png"});
  QCOMPARE(looked, (std::vector<std::string>{"0", "1", "2", "3", "4", "5"}));
}

void CalibrateRigTest::AReferenceIsReadForThePicturesSize() {
  CalibrateRig compared = command(40);
  compared.reference = folder_.path() / "reference.yaml";
  const auto sheet = sheet_of(compared);
  QVERIFY(sheet->calibration.epipolar_reference < 0.3);
  QVERIFY(std::isnan(sheet_of(command(40))->calibration.epipolar_reference));
}

void CalibrateRigTest::ANumberOfViewsOutOfRangeIsRefusedBeforeAnyPictureIsRead() {
  for (const int most : {2, 201}) {
    CalibrateRig refused = command(most);
    refused.search.left = "nowhere";
    QVERIFY_THROWS_EXCEPTION(Error, sheet_of(refused));
    try {
      sheet_of(refused);
    } catch (const Error& error) {
      QVERIFY2(std::string(error.what()).find("most_views") != std::string::npos, error.what());
    }
  }
}

QTEST_APPLESS_MAIN(CalibrateRigTest)
#include "calibrate_rig_test.moc"
