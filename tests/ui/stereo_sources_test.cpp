// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogs that describe a stereo source and calibrate a laparoscope.
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>

#include "glisson/core/files.h"
#include "glisson/engine/commands/calibrate_rig.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/stereo/calibration_dialog.h"
#include "glisson/ui/stereo/source_dialog.h"
#include "rendered_board.h"
#include "rendered_pair.h"

namespace glisson {

class StereoSourcesTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

  template <class Widget>
  static Widget& child(QDialog& dialog, const char* name) {
    return *dialog.findChild<Widget*>(QString::fromLatin1(name));
  }

  /// Nine pairs. @param moved the board of this pair was moved between its two pictures; negative: none.
  void write_boards(const std::filesystem::path& pictures, int moved) const {
    std::filesystem::create_directories(pictures);
    const auto poses = rendered::board_poses(board_, 0.13);
    for (int i = 0; i < 9; ++i)
      for (const bool left : {true, false}) {
        const std::string name = (left ? "left-" : "right-") + std::to_string(i) + ".png";
        const bool is_moved = !left && i == moved;
        if (moved >= 0 && !is_moved) {
          std::filesystem::copy_file(folder_.path() / "boards" / name, pictures / name);
          continue;
        }
        auto pose = poses[static_cast<std::size_t>(i + i / 3)];
        if (is_moved) pose.translation += Eigen::Vector3d(0.0, 0.6e-3, 0.0);
        stereo::write_picture(pictures / name, rendered::board_picture(rendered::rig(), left, pose,
                                                                       rendered::chessboard_ink(board_)));
      }
  }
  void ask_for(QDialog& dialog, const std::filesystem::path& pictures) const {
    child<QLineEdit>(dialog, "board_folder").setText(QString::fromStdString(pictures.string()));
    child<QSpinBox>(dialog, "board_columns").setValue(board_.columns);
    child<QSpinBox>(dialog, "board_rows").setValue(board_.rows);
    child<QDoubleSpinBox>(dialog, "board_square").setValue(1e3 * board_.square);
  }

  const stereo::Board board_{9, 6, 6e-3, {}, 0.0};

 private slots:
  void initTestCase() { write_boards(folder_.path() / "boards", -1); }

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
    const std::filesystem::path pictures = folder_.path() / "boards";
    const StereoRig rig = rendered::rig();
    ui::EngineBridge engine;
    ui::CalibrationDialog dialog(engine);
    dialog.open();
    QVERIFY(!dialog.task().button()->isEnabled());  // and says that the folder is missing
    ask_for(dialog, pictures);
    QVERIFY(dialog.task().button()->isEnabled());
    QVERIFY(!dialog.again().isVisible());
    const QRect screen = dialog.screen()->availableGeometry();
    dialog.move(screen.right() - dialog.width() - 10, screen.top() + 10);
    QSignalSpy done(&dialog.task(), &ui::TaskButton::done), ended(&dialog, &QDialog::finished);
    QTest::mouseClick(dialog.task().button(), Qt::LeftButton);
    auto& columns = child<QSpinBox>(dialog, "board_columns");
    QTRY_VERIFY(!columns.isEnabled() || done.count() == 1);  // what comes out belongs to what was asked for
    QCOMPARE(done.count(), 0);
    dialog.reject();  // it works: it only steps back
    QVERIFY(!dialog.isVisible() && ended.isEmpty());
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 120000);
    QVERIFY(dialog.isVisible());
    QVERIFY(columns.isEnabled());
    const auto outcome = done[0][0].value<engine::Outcome>();
    QVERIFY2(outcome.status == engine::Status::done, outcome.error.c_str());
    QVERIFY(engine.state()[part::rig] != nullptr);
    const double focal = engine.state()[part::rig]->left.matrix(0, 0);
    QVERIFY(std::abs(focal / rig.left.matrix(0, 0) - 1.0) < 0.02);
    QVERIFY(std::abs(engine.state()[part::rig]->baseline() / rig.baseline() - 1.0) < 0.02);
    QString shown;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) shown += label->text() + QLatin1Char('\n');
    QVERIFY(shown.contains(QStringLiteral("9 of 9 pairs")));
    QTRY_VERIFY(screen.contains(dialog.frameGeometry()));                          // it has grown
    QVERIFY(dialog.again().isVisible() && !dialog.again().button()->isEnabled());  // all views are ticked
    QVERIFY(!child<ui::CoverageView>(dialog, "calibration_coverage").picture().empty());
    QCOMPARE(child<QTreeWidget>(dialog, "calibration_views").topLevelItemCount(), 9);
    columns.setValue(board_.columns + 1);
    QVERIFY(!dialog.again().isVisible());  // what was found is of another board
    dialog.reject();
    QCOMPARE(ended.count(), 1);
  }

  void AViewThatFitsFarWorseIsProposedAndLeftOut() {
    constexpr int kMoved = 4;
    const std::filesystem::path pictures = folder_.path() / "moved";
    write_boards(pictures, kMoved);
    ui::EngineBridge engine;
    ui::CalibrationDialog dialog(engine);
    ask_for(dialog, pictures);
    dialog.open();
    QSignalSpy done(&dialog.task(), &ui::TaskButton::done);
    dialog.task().trigger();
    QTRY_COMPARE_WITH_TIMEOUT(done.count(), 1, 120000);
    const auto first = done[0][0].value<engine::Outcome>();
    QVERIFY2(first.status == engine::Status::done, first.error.c_str());
    const auto first_sheet = first.result.as<engine::CalibrationSheet>();
    auto& table = child<QTreeWidget>(dialog, "calibration_views");
    auto& results = *dialog.findChild<ui::CalibrationResults*>();
    QVERIFY(table.topLevelItem(kMoved)->checkState(0) == Qt::Unchecked);
    QCOMPARE(results.unticked().size(), std::size_t{1});
    QVERIFY(results.differs());
    QVERIFY(first_sheet->calibration.views[kMoved].used);  // proposed, not dropped
    QVERIFY(table.topLevelItem(kMoved)->text(ui::CalibrationResults::left).toDouble() > 0.7);
    // A row brings its board out in the picture.
    auto& coverage = child<ui::CoverageView>(dialog, "calibration_coverage");
    const QImage before = coverage.grab().toImage();
    table.setCurrentItem(table.topLevelItem(kMoved));
    QCOMPARE(coverage.brought_out(), kMoved);
    QVERIFY(coverage.grab().toImage() != before);

    QSignalSpy again(&dialog.again(), &ui::TaskButton::done);
    QTest::mouseClick(dialog.again().button(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(again.count(), 1, 120000);
    const auto second = again[0][0].value<engine::Outcome>();
    QVERIFY2(second.status == engine::Status::done, second.error.c_str());
    const auto second_sheet = second.result.as<engine::CalibrationSheet>();
    QVERIFY(second_sheet->views == first_sheet->views);  // not looked for again
    QVERIFY(!second_sheet->calibration.views[kMoved].used);
    QVERIFY(second_sheet->calibration.rms < 0.5 * first_sheet->calibration.rms);
    const double wrong = engine.state()[part::rig]->baseline() / rendered::rig().baseline() - 1.0;
    QVERIFY2(std::abs(wrong) < 0.02, qPrintable(QString::number(wrong)));
    QVERIFY(!dialog.again().button()->isEnabled() && !results.differs());
    QCOMPARE(table.topLevelItem(kMoved)->text(ui::CalibrationResults::left), QStringLiteral("–"));
    QVERIFY(table.topLevelItem(kMoved)->text(ui::CalibrationResults::rows).toDouble() > 0.7);

    // Too few views are refused, and the calibration stays.
    const auto rig = engine.state()[part::rig];
    for (int i = 2; i < table.topLevelItemCount(); ++i)
      table.topLevelItem(i)->setCheckState(0, Qt::Unchecked);
    QTest::mouseClick(dialog.again().button(), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(again.count(), 2, 120000);
    const auto third = again[1][0].value<engine::Outcome>();
    QVERIFY(third.status == engine::Status::failed);
    QVERIFY2(third.error.find("Keep 3") != std::string::npos, third.error.c_str());
    QVERIFY(engine.state()[part::rig] == rig);
    QVERIFY(dialog.again().button()->isEnabled());  // with other ticks

    // Figures of another request than the present one would pass for its own.
    const auto says_baseline = [&] {
      const auto labels = dialog.findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
        return label->isVisibleTo(label->window()) && label->text() == QStringLiteral("Baseline");
      });
    };
    QVERIFY(says_baseline());
    child<QDoubleSpinBox>(dialog, "board_square").setValue(12.5);
    QVERIFY(!says_baseline());
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
    QVERIFY(engine.state()[part::rig] == nullptr);
  }
};

}  // namespace glisson

QTEST_MAIN(glisson::StereoSourcesTest)
#include "stereo_sources_test.moc"
