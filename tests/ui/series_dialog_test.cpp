// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogue that asks which series of a folder is meant.
#include "glisson/ui/shell/series_dialog.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "glisson/ui/common/series_texts.h"
#include "run_in_window.h"

namespace glisson {
namespace {

DicomSeries series_called(const char* description, const char* uid) {
  DicomSeries series;
  series.uid = uid;
  series.number = "4";
  series.description = description;
  series.modality = "CT";
  series.slices = 129;
  series.patient = "Doe Jane";
  series.patient_id = "4711";
  series.date = "2026-01-31";
  series.pixels = {512, 512};
  series.pixel_mm = {0.57, 0.57};
  series.gap_mm = 1.6;
  series.thickness_mm = 2.0;
  series.normal = {0, 0, 1};
  return series;
}

std::vector<DicomSeries> a_folder() {
  std::vector<DicomSeries> all = {series_called("contours", "1.1"), series_called("portal venous", "1.2"),
                                  series_called("vein mask", "1.3"), series_called("", "1.4")};
  all[0].images = false;
  all[1].contrast_agent = true;
  all[1].picture = {2, 1, 2.0, {0, 255}, 200};
  all[2].picture = {1, 1, 1.0, {255}, 2};
  return all;
}

}  // namespace

class SeriesDialogTest : public QObject {
  Q_OBJECT
 private slots:
  void RowsSayWhatASeriesIs();
  void WhereNoSeriesSaysItsPhaseThereIsNoColumnForIt();
  void TheFirstThatCanBeReadIsChosen();
  void APatientIsSaidOnceOrInEachRow();
  void PicturesHaveThePatientsProportions();
  void NothingToReadIsNotOpened();
};

void SeriesDialogTest::RowsSayWhatASeriesIs() {
  std::vector<DicomSeries> all = a_folder();
  sort_by_likelihood(all);
  const ui::SeriesDialog dialog(all);
  const auto* list = dialog.findChild<QTreeWidget*>();
  QCOMPARE(list->topLevelItemCount(), 4);
  const QTreeWidgetItem* first = list->topLevelItem(0);
  QCOMPARE(first->text(0), QString("portal venous\nCT, series 4"));
  QCOMPARE(first->text(1), QString("portal venous\ncontrast agent"));
  QCOMPARE(first->text(2), QString("129"));
  QCOMPARE(first->text(3), QString("512 × 512\n0.57 × 0.57 × 1.60 mm, slices 2.00 mm thick"));
  QCOMPARE(first->text(4), QString("2026-01-31"));
  QCOMPARE(first->text(5), QString("likeliest"));
  QVERIFY(list->topLevelItem(1)->text(0).startsWith("no description"));
  QVERIFY(list->topLevelItem(1)->text(5).isEmpty());
  QCOMPARE(list->topLevelItem(2)->text(5), ui::doubt_text(SeriesDoubt::mask));
  QCOMPARE(list->topLevelItem(3)->text(5), ui::doubt_text(SeriesDoubt::no_image));
  for (int doubt = 0; doubt <= static_cast<int>(SeriesDoubt::no_image); ++doubt)
    QVERIFY(!ui::doubt_text(static_cast<SeriesDoubt>(doubt)).isEmpty());
}

void SeriesDialogTest::WhereNoSeriesSaysItsPhaseThereIsNoColumnForIt() {
  const ui::SeriesDialog unsaid({series_called("abdomen 2 mm", "1.1"), series_called("", "1.2")});
  QVERIFY(unsaid.findChild<QTreeWidget*>()->isColumnHidden(1));
  // In the description alone is enough.
  const ui::SeriesDialog said({series_called("abdomen portal venous", "1.1"), series_called("", "1.2")});
  QVERIFY(!said.findChild<QTreeWidget*>()->isColumnHidden(1));
}

void SeriesDialogTest::TheFirstThatCanBeReadIsChosen() {
  ui::SeriesDialog dialog(a_folder());  // contours come first
  QCOMPARE(dialog.chosen_uid(), std::string("1.2"));
  auto* list = dialog.findChild<QTreeWidget*>();
  QVERIFY(!list->topLevelItem(0)->flags().testFlag(Qt::ItemIsEnabled));
  dialog.show();
  QVERIFY(QTest::qWaitForWindowExposed(&dialog));
  const auto click = [&](int row) {
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->topLevelItem(row)).center());
  };
  click(2);
  QCOMPARE(dialog.chosen_uid(), std::string("1.3"));
  click(0);
  QCOMPARE(dialog.chosen_uid(), std::string("1.3"));
  QTest::keyClick(list, Qt::Key_Down);
  QCOMPARE(dialog.chosen_uid(), std::string("1.4"));
  QTest::keyClick(&dialog, Qt::Key_Return);
  QTRY_VERIFY(!dialog.isVisible());
  QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
}

void SeriesDialogTest::APatientIsSaidOnceOrInEachRow() {
  std::vector<DicomSeries> all = a_folder();
  const ui::SeriesDialog one(all);
  QVERIFY(one.findChild<QLabel*>("series_patient")->text().contains("Doe Jane (4711)"));
  all[2].patient = "Roe <b>John";
  const ui::SeriesDialog two(all);
  QVERIFY(two.findChild<QLabel*>("series_patient") == nullptr);
  const auto* list = two.findChild<QTreeWidget*>();
  QVERIFY(list->topLevelItem(1)->text(0).endsWith("Doe Jane (4711)"));
  QVERIFY(list->topLevelItem(2)->text(0).endsWith("Roe <b>John (4711)"));
}

void SeriesDialogTest::PicturesHaveThePatientsProportions() {
  const ui::SeriesDialog dialog(a_folder());
  const auto* list = dialog.findChild<QTreeWidget*>();
  // Two pixels beside each other, each twice as high as wide: a square, its left half black.
  const QImage square = list->topLevelItem(1)->icon(0).pixmap(list->iconSize()).toImage();
  const int w = square.width(), h = square.height();
  QVERIFY(w >= 64 && w == h);
  for (const int y : {2, h / 2, h - 3}) {
    QVERIFY(qGray(square.pixel(w / 8, y)) < 30);
    QVERIFY(qGray(square.pixel(w - w / 8, y)) > 225);
  }
}

void SeriesDialogTest::NothingToReadIsNotOpened() {
  std::vector<DicomSeries> all = a_folder();
  for (DicomSeries& series : all) series.images = false;
  ui::SeriesDialog dialog(all);
  QVERIFY(dialog.chosen_uid().empty());
  QVERIFY(!dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->isEnabled());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::SeriesDialogTest>(argc, argv); }
#include "series_dialog_test.moc"
