// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/ui/common/measure_book.h"

namespace glisson {

using scene::Plane;
using ui::MeasureTool;

class MeasureBookTest : public QObject {
  Q_OBJECT
 private slots:
  void ADragIsADistanceWithOneDecimal();
  void AClickMeasuresNothing();
  void ASecondDiameterCrossesTheFirst();
  void WhatDoesNotCrossIsAnotherLesion();
  void DiametersOfAnotherSliceAreAnotherLesions();
  void AMeasureStaysInItsSlice();
  void UndoTakesTheLastLineBackAndWipeAll();
  void AnotherToolDropsWhatIsDrawn();
  void MeasuringWithoutAToolIsRefused();

 private:
  void drag(ui::MeasureBook& book, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
            Plane plane = Plane::axial) {
    book.begin(plane, Point<CtFrame>(from));
    book.move(Point<CtFrame>(to));
    book.end(1e-3);
  }
};

void MeasureBookTest::ADragIsADistanceWithOneDecimal() {
  ui::MeasureBook book;
  book.set_tool(MeasureTool::distance);
  book.begin(Plane::axial, Point<CtFrame>(0.0, 0.0, 0.01));
  book.move(Point<CtFrame>(3e-3, 4e-3, 0.01));
  QCOMPARE(ui::MeasureBook::text(*book.drawn()), QStringLiteral("5.0 mm"));  // while it is drawn, too
  book.move(Point<CtFrame>(0.01, 0.01234, 0.01));
  book.end(1e-3);
  QVERIFY(!book.drawn());
  QCOMPARE(book.measures().size(), std::size_t{1});
  QCOMPARE(ui::MeasureBook::text(book.measures()[0]), QStringLiteral("15.9 mm"));
}

void MeasureBookTest::AClickMeasuresNothing() {
  ui::MeasureBook book;
  book.set_tool(MeasureTool::diameters);
  drag(book, {0, 0, 0}, {0.9e-3, 0, 0});
  QVERIFY(book.measures().empty() && !book.is_drawing());
}

void MeasureBookTest::ASecondDiameterCrossesTheFirst() {
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    const auto in_plane = [plane](double x, double y) {
      const int normal = scene::normal_axis(plane), first = normal == 0 ? 1 : 0;
      Eigen::Vector3d p = Eigen::Vector3d::Constant(0.05);
      p[first] = x;
      p[3 - normal - first] = y;
      return p;
    };
    ui::MeasureBook book;
    book.set_tool(MeasureTool::diameters);
    drag(book, in_plane(0, 0), in_plane(0.01, 0.01), plane);
    drag(book, in_plane(0.012, 0), in_plane(-0.004, 0.016), plane);
    QCOMPARE(book.measures().size(), std::size_t{1});
    QVERIFY(book.measures()[0].across.has_value());
    QCOMPARE(ui::MeasureBook::text(book.measures()[0]), QStringLiteral("22.6 × 14.1 mm"));  // longer first
  }
}

void MeasureBookTest::WhatDoesNotCrossIsAnotherLesion() {
  ui::MeasureBook book;
  book.set_tool(MeasureTool::diameters);
  drag(book, {0, 0, 0}, {0.01, 0, 0});
  drag(book, {0.02, -0.01, 0}, {0.02, 0.01, 0});  // beyond its end
  QCOMPARE(book.measures().size(), std::size_t{2});
  drag(book, {0.01, 0.005, 0}, {0.03, 0.005, 0});
  QCOMPARE(book.measures().size(), std::size_t{2});  // crosses the second
  drag(book, {0.015, -0.008, 0}, {0.025, 0.008, 0});
  QCOMPARE(book.measures().size(), std::size_t{3});  // that has both already
  book.set_tool(MeasureTool::distance);
  drag(book, {0.02, -0.02, 0}, {0.02, 0.02, 0});
  QCOMPARE(book.measures().size(), std::size_t{4});  // a distance is none
}

void MeasureBookTest::DiametersOfAnotherSliceAreAnotherLesions() {
  ui::MeasureBook book;
  book.set_tool(MeasureTool::diameters);
  drag(book, {0, 0, 0}, {0.01, 0, 0});
  drag(book, {0.005, -0.01, 2e-3}, {0.005, 0.01, 2e-3});
  QCOMPARE(book.measures().size(), std::size_t{2});
}

void MeasureBookTest::AMeasureStaysInItsSlice() {
  ui::MeasureBook book;
  book.set_tool(MeasureTool::distance);
  drag(book, {0, 0, 0}, {0.01, 0, 0.03});  // the wheel turned meanwhile
  QCOMPARE(book.measures()[0].line.to.z(), 0.0);
  QCOMPARE(ui::MeasureBook::text(book.measures()[0]), QStringLiteral("10.0 mm"));
}

void MeasureBookTest::UndoTakesTheLastLineBackAndWipeAll() {
  ui::MeasureBook book;
  book.set_tool(MeasureTool::diameters);
  drag(book, {0, 0, 0}, {0.01, 0, 0});
  drag(book, {0.005, -0.01, 0}, {0.005, 0.01, 0});
  QSignalSpy told(&book, &ui::MeasureBook::changed);
  book.undo();
  QVERIFY(book.measures().size() == 1 && !book.measures()[0].across);
  book.undo();
  QVERIFY(book.measures().empty());
  QCOMPARE(told.size(), 2);
  book.undo();
  QCOMPARE(told.size(), 2);
  drag(book, {0, 0, 0}, {0.01, 0, 0});
  drag(book, {0, 0.1, 0}, {0.01, 0.1, 0});
  book.wipe();
  QVERIFY(book.measures().empty());
}

void MeasureBookTest::AnotherToolDropsWhatIsDrawn() {
  ui::MeasureBook book;
  book.set_tool(MeasureTool::distance);
  book.begin(Plane::axial, Point<CtFrame>(0, 0, 0));
  book.set_tool(MeasureTool::none);
  QVERIFY(!book.is_drawing());
  book.move(Point<CtFrame>(0.01, 0, 0));
  book.end(1e-3);
  QVERIFY(book.measures().empty());
}

void MeasureBookTest::MeasuringWithoutAToolIsRefused() {
  ui::MeasureBook book;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, book.begin(Plane::axial, Point<CtFrame>()));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::MeasureBookTest)
#include "measure_book_test.moc"
