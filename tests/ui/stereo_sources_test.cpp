// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogs that describe a stereo source and calibrate a laparoscope.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QtTest>

#include "../stereo/rendered_board.h"
#include "../stereo/rendered_pair.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/stereo/calibration_dialog.h"
#include "glisson/ui/stereo/source_dialog.h"

namespace glisson {

class StereoSourcesTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

  template <class Widget>
  static Widget& child(QDialog& dialog, const char* name) {
    return *dialog.findChild<Widget*>(QString::fromLatin1(name));
  }

 private slots:
  void DescribedArrangementIsReadBackAsItWasSaid() {
    ui::SourceDialog dialog;
    QSignalSpy described(&dialog, &ui::SourceDialog::described);
    child<QLineEdit>(dialog, "source_left").setText(QStringLiteral("scope.mkv"));
    child<QComboBox>(dialog, "source_layout").setCurrentIndex(1);
    child<QCheckBox>(dialog, "source_right_first").setChecked(true);
    child<QCheckBox>(dialog, "source_interlaced").setChecked(true);
    const std::filesystem::path file = folder_.path() / "scope.json";
    QVERIFY(dialog.save_as(QString::fromStdString(file.string())));
    QCOMPARE(described.count(), 1);
    const stereo::SourceOptions back = stereo::read_source(file);
    QVERIFY(back.layout == stereo::Layout::top_bottom && back.right_first && back.deinterlace);
    QCOMPARE(std::filesystem::path(back.left).filename().string(), std::string("scope.mkv"));
    QVERIFY(back.right.empty() && !back.crop.any());
  }

  void WhatCannotBeWrittenIsSaidAndTheDialogStays() {
    ui::SourceDialog dialog;
    dialog.open();
    child<QLineEdit>(dialog, "source_left").setText(QStringLiteral("scope.mkv"));
    QVERIFY(!dialog.save_as(QString::fromStdString((folder_.path() / "none" / "x.json").string())));
    QVERIFY(dialog.isVisible());
  }

  void BoardsInAFolderCalibrateTheRig() {
    stereo::Board board;
    board.columns = 9;
    board.rows = 6;
    board.square = 6e-3;
    const StereoRig rig = rendered::rig();
    const std::filesystem::path pictures = folder_.path() / "boards";
    std::filesystem::create_directories(pictures);
    const auto poses = rendered::board_poses(board, 0.13);
    for (std::size_t i = 0; i < poses.size(); i += 2)
      for (const bool left : {true, false})
        stereo::write_picture(pictures / ((left ? "left-" : "right-") + std::to_string(i) + ".png"),
                              rendered::board_picture(rig, left, poses[i], rendered::chessboard_ink(board)));
    ui::EngineBridge engine;
    ui::CalibrationDialog dialog(engine);
    dialog.open();
    QVERIFY(!dialog.task().button()->isEnabled());  // and says that the folder is missing
    child<QLineEdit>(dialog, "board_folder").setText(QString::fromStdString(pictures.string()));
    child<QSpinBox>(dialog, "board_columns").setValue(board.columns);
    child<QSpinBox>(dialog, "board_rows").setValue(board.rows);
    child<QDoubleSpinBox>(dialog, "board_square").setValue(1e3 * board.square);
    QVERIFY(dialog.task().button()->isEnabled());
    QSignalSpy done(&dialog.task(), &ui::TaskButton::done);
    QTest::mouseClick(dialog.task().button(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 120000);
    const auto outcome = done[0][0].value<engine::Outcome>();
    QVERIFY2(outcome.status == engine::Status::done, outcome.error.c_str());
    QVERIFY(engine.state().rig != nullptr);
    const double focal = engine.state().rig->left.matrix(0, 0);
    QVERIFY(std::abs(focal / rig.left.matrix(0, 0) - 1.0) < 0.02);
    QVERIFY(std::abs(engine.state().rig->baseline() / rig.baseline() - 1.0) < 0.02);
    QString shown;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) shown += label->text() + QLatin1Char('\n');
    QVERIFY(shown.contains(QStringLiteral("of 6 pairs")));
  }

  void WrongBoardSizeIsSaid() {
    ui::EngineBridge engine;
    ui::CalibrationDialog dialog(engine);
    child<QLineEdit>(dialog, "board_folder")
        .setText(QString::fromStdString((folder_.path() / "boards").string()));
    child<QSpinBox>(dialog, "board_columns").setValue(11);
    child<QSpinBox>(dialog, "board_rows").setValue(8);
    QSignalSpy done(&dialog.task(), &ui::TaskButton::done);
    dialog.task().trigger();
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 120000);
    const auto outcome = done[0][0].value<engine::Outcome>();
    QVERIFY(outcome.status == engine::Status::failed);
    QVERIFY2(outcome.error.find("is seen") != std::string::npos, outcome.error.c_str());
    QVERIFY2(outcome.error.find("9x6") != std::string::npos, outcome.error.c_str());
    QVERIFY(engine.state().rig == nullptr);
  }
};

}  // namespace glisson

QTEST_MAIN(glisson::StereoSourcesTest)
#include "stereo_sources_test.moc"
