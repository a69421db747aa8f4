// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "glisson/ui/stereo/region_drawing.h"

using namespace glisson;
using ui::RegionDrawing;
using Click = ui::RegionDrawing::Click;

namespace {

RegionDrawing::Place at(double x, double y, stereo::Side side = stereo::Side::left) {
  return {side, {x, y}, 5.0};
}
constexpr RegionDrawing::Tool kMargin{Feature::anterior_margin, true, 6.0};
constexpr RegionDrawing::Tool kCurve{Feature::anterior_margin, false, 6.0};

}  // namespace

class StereoDrawingTest : public QObject {
  Q_OBJECT

  static RegionDrawing with_triangle() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    drawing.press(at(10, 10));
    drawing.press(at(100, 10));
    drawing.press(at(100, 90));
    drawing.finish();
    drawing.set_tool(std::nullopt);
    return drawing;
  }

 private slots:
  void ClickNearTheFirstCornerClosesExactlyThere() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    QVERIFY(drawing.click_at(at(10, 10)) == Click::begin);
    QVERIFY(!drawing.press(at(10, 10)));
    QVERIFY(!drawing.press(at(100, 10)));
    QVERIFY(drawing.click_at(at(12, 12)) == Click::add);  // two corners enclose nothing
    QVERIFY(!drawing.press(at(100, 90)));
    QVERIFY(drawing.click_at(at(16, 10)) == Click::add);  // beyond reach
    QVERIFY(drawing.click_at(at(13, 13)) == Click::close);
    QVERIFY(drawing.press(at(13, 13)));
    QCOMPARE(drawing.regions().size(), std::size_t{1});
    QCOMPARE(drawing.regions()[0].polygon.size(), std::size_t{3});
    QVERIFY(drawing.regions()[0].polygon[0] == Eigen::Vector2d(10, 10));
    QVERIFY(drawing.unfinished() == nullptr);
    QVERIFY(drawing.tool() == std::optional(kMargin));  // the next one may begin at once
  }

  void ADoubleClickThatClosesBeginsNothing() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    for (const auto& p : {at(10, 10), at(100, 10), at(100, 90)}) drawing.press(p);
    QVERIFY(drawing.press(at(11, 11)));  // its first press, on the first corner
    QVERIFY(!drawing.double_click(at(11, 11)));
    QCOMPARE(drawing.regions().size(), std::size_t{1});
    QVERIFY(drawing.unfinished() == nullptr);
    QVERIFY(!drawing.press(at(200, 50)));  // the next one begins where it is pressed
    QVERIFY(drawing.unfinished() != nullptr);
  }

  void DoubleClickClosesWithoutASecondCorner() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    drawing.press(at(10, 10));
    drawing.press(at(100, 10));
    drawing.press(at(100, 90));
    QVERIFY(drawing.double_click(at(101, 90)));
    QCOMPARE(drawing.regions()[0].polygon.size(), std::size_t{3});
  }

  void QuickClicksFarApartAreTwoCorners() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    drawing.press(at(10, 10));
    drawing.press(at(100, 10));
    drawing.press(at(100, 90));
    QVERIFY(!drawing.double_click(at(40, 90)));
    QCOMPARE(drawing.unfinished()->polygon.size(), std::size_t{4});
  }

  void TooFewCornersDoNotClose() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    drawing.press(at(10, 10));
    drawing.press(at(100, 10));
    QVERIFY(!drawing.finish());
    QVERIFY(drawing.unfinished() != nullptr && drawing.regions().empty());
  }

  void CurveNeedsTwoCornersAndEndsAtItsLast() {
    RegionDrawing drawing;
    drawing.set_tool(kCurve);
    drawing.press(at(10, 50));
    QVERIFY(!drawing.finish());
    drawing.press(at(60, 55));
    drawing.set_tool(RegionDrawing::Tool{Feature::anterior_margin, false, 9.0});  // wider on the way
    QVERIFY(drawing.click_at(at(10, 50)) == Click::add);                          // a curve is not closed
    QVERIFY(drawing.click_at(at(61, 55)) == Click::end_curve);
    QVERIFY(drawing.press(at(61, 55)));
    QVERIFY(!drawing.regions()[0].closed);
    QCOMPARE(drawing.regions()[0].polygon.size(), std::size_t{2});
    QCOMPARE(drawing.regions()[0].half_width_px, 9.0);
  }

  void LineStaysOnThePictureWhereItBegan() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    drawing.press(at(10, 10, stereo::Side::right));
    QVERIFY(drawing.click_at(at(50, 50)) == Click::wrong_picture);
    QVERIFY(!drawing.press(at(50, 50)));
    drawing.press(at(50, 10, stereo::Side::right));
    drawing.press(at(50, 50, stereo::Side::right));
    QVERIFY(drawing.finish());
    QVERIFY(drawing.regions()[0].side == stereo::Side::right);
    drawing.set_tool(std::nullopt);
    QVERIFY(drawing.click_at(at(10, 10)) == Click::nothing);  // the same pixel of the other picture
  }

  void BackspaceTakesCornersBackOneByOne() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    drawing.press(at(10, 10));
    drawing.press(at(100, 10));
    QVERIFY(drawing.take_back());
    QCOMPARE(drawing.unfinished()->polygon.size(), std::size_t{1});
    QVERIFY(drawing.take_back());
    QVERIFY(drawing.unfinished() == nullptr);
    QVERIFY(!drawing.take_back());
    QVERIFY(drawing.tool().has_value());
  }

  void EscDropsTheLineThenTheTool() {
    RegionDrawing drawing;
    drawing.set_tool(kMargin);
    drawing.press(at(10, 10));
    QVERIFY(drawing.drop());
    QVERIFY(drawing.unfinished() == nullptr && drawing.tool());
    QVERIFY(drawing.drop());
    QVERIFY(!drawing.tool());
    QVERIFY(!drawing.drop());
  }

  void CornerIsDraggedAndTheDragIsOneStep() {
    RegionDrawing drawing = with_triangle();
    QVERIFY(drawing.click_at(at(102, 12)) == Click::drag);
    QVERIFY(!drawing.press(at(102, 12)));
    for (int x = 103; x <= 130; ++x) drawing.move(at(x, 20));
    QVERIFY(drawing.release());
    QVERIFY(drawing.regions()[0].polygon[1] == Eigen::Vector2d(130, 20));
    QVERIFY(drawing.undo());
    QVERIFY(drawing.regions()[0].polygon[1] == Eigen::Vector2d(100, 10));
    QVERIFY(drawing.redo());
    QVERIFY(drawing.regions()[0].polygon[1] == Eigen::Vector2d(130, 20));
  }

  void ClickOnACornerWithoutADragChangesNothing() {
    RegionDrawing drawing = with_triangle();
    drawing.press(at(101, 11));
    QVERIFY(!drawing.release());
    QVERIFY(drawing.selected() == std::optional<std::size_t>(0));
  }

  void EscPutsADraggedCornerBack() {
    RegionDrawing drawing = with_triangle();
    drawing.press(at(100, 10));
    drawing.move(at(150, 50));
    QVERIFY(drawing.drop());
    QVERIFY(drawing.regions()[0].polygon[1] == Eigen::Vector2d(100, 10));
    QVERIFY(!drawing.release());
  }

  void ClickOnTheSelectedOutlinePutsACorner() {
    RegionDrawing drawing = with_triangle();
    QVERIFY(drawing.click_at(at(55, 11)) == Click::select);
    drawing.press(at(55, 11));
    QVERIFY(drawing.click_at(at(55, 11)) == Click::insert);
    drawing.press(at(55, 11));
    drawing.move(at(55, 2));
    QVERIFY(drawing.release());
    QCOMPARE(drawing.regions()[0].polygon.size(), std::size_t{4});
    QVERIFY(drawing.regions()[0].polygon[1] == Eigen::Vector2d(55, 2));
    // Also on the edge from the last corner to the first.
    drawing.press(at(56, 51));
    drawing.move(at(50, 60));
    QVERIFY(drawing.release());
    QVERIFY(drawing.regions()[0].polygon.back() == Eigen::Vector2d(50, 60));
  }

  void DeleteRemovesTheSelectedAndUndoBringsItBack() {
    RegionDrawing drawing = with_triangle();
    QVERIFY(!drawing.remove_selected());
    drawing.press(at(80, 30));  // inside
    QVERIFY(drawing.remove_selected());
    QVERIFY(drawing.regions().empty());
    QVERIFY(drawing.undo());
    QCOMPARE(drawing.regions().size(), std::size_t{1});
    QVERIFY(drawing.remove_at(at(80, 30)));
    QVERIFY(!drawing.remove_at(at(80, 30)));
  }

  void UndoOfAnUnfinishedLineTakesOneCorner() {
    RegionDrawing drawing = with_triangle();
    drawing.set_tool(kMargin);
    drawing.press(at(200, 10));
    drawing.press(at(220, 10));
    QVERIFY(!drawing.undo());
    QCOMPARE(drawing.unfinished()->polygon.size(), std::size_t{1});
    QVERIFY(!drawing.undo());
    QCOMPARE(drawing.regions().size(), std::size_t{1});
    QVERIFY(drawing.undo());
    QVERIFY(drawing.regions().empty());
  }

  void NewChangeEndsWhatCouldBeRedone() {
    RegionDrawing drawing = with_triangle();
    drawing.undo();
    QVERIFY(drawing.can_redo());
    drawing.set_tool(kCurve);
    drawing.press(at(1, 1));
    drawing.press(at(50, 1));
    drawing.finish();
    QVERIFY(!drawing.can_redo() && !drawing.redo());
  }

  void OtherRegionsBeginANewHistoryTheSameDoNot() {
    RegionDrawing drawing = with_triangle();
    drawing.set_regions(RegionDrawing::Regions(drawing.regions()));
    QVERIFY(drawing.can_undo());
    drawing.set_regions({});
    QVERIFY(!drawing.can_undo() && drawing.regions().empty());
  }

  /// What was drawn for one patient is not brought back into another one's case.
  void AnotherCaseBeginsANewHistoryWhateverItHolds() {
    RegionDrawing drawing = with_triangle();
    drawing.undo();
    QVERIFY(drawing.regions().empty() && drawing.can_redo());
    drawing.begin_anew({});
    QVERIFY(!drawing.can_undo() && !drawing.can_redo());
    QVERIFY(!drawing.redo() && drawing.regions().empty());
  }

  void ClearIsOneStep() {
    RegionDrawing drawing = with_triangle();
    QVERIFY(drawing.clear());
    QVERIFY(!drawing.clear());
    QVERIFY(drawing.undo());
    QCOMPARE(drawing.regions().size(), std::size_t{1});
  }
};

QTEST_APPLESS_MAIN(StereoDrawingTest)
#include "stereo_drawing_test.moc"
