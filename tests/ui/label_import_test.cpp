// SPDX-License-Identifier: GPL-3.0-or-later
// Labels of other programs: what each one is, is asked where the file does not say.
#include <QComboBox>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>

#include "glisson/patient/segment_meaning.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/segmentation/label_meanings.h"
#include "segmentation_window.h"

namespace glisson {
namespace {

/// A block of 8 x 6 x 4 voxels of 10 mm in which each code has so many voxels, one after the other.
LabelFile counted(const std::vector<std::pair<Label, int>>& codes, const std::vector<LabelInfo>& infos) {
  VolumeGrid grid;
  grid.size = {8, 6, 4};
  grid.spacing_mm = {10.0, 10.0, 10.0};
  std::vector<Label> dense(static_cast<std::size_t>(grid.voxel_count()), 0);
  std::size_t next = 0;
  for (const auto& [code, count] : codes)
    for (int n = 0; n < count; ++n) dense[next++] = code;
  return {LabelVolume(grid, dense), infos};
}

}  // namespace

class LabelImportTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void WhatSaysItselfIsNotAsked();
  void NumbersAreAskedAbout();
  void PlainTissueIsAskedAbout();
  void LesionsAreNumberedInTheirOrder();
  void AFileWithoutMeaningsIsImportedAsThePersonSays();
  void WhoCancelsImportsNothing();
  void GlissonsOwnPlainFileTakesItsNumbers();
  void WhatAHandHasCorrectedIsNotReplacedUnasked();
  void WhatCannotBeReadSaysWhy();
  void ALiverOnTheLeftIsNotImportedUnlessAPersonSaysSo_data();
  void ALiverOnTheLeftIsNotImportedUnlessAPersonSaysSo();
  void ALiverOnTheLeftThatWasOperatedOnIsImported_data();
  void ALiverOnTheLeftThatWasOperatedOnIsImported();

 private:
  static LabelInfo segment(Label code, const std::string& name, Label terminology) {
    LabelInfo info;
    info.code = code;
    info.name = name;
    info.terminology = structure_terminology(terminology);
    return info;
  }
  /// The window's labels as another program writes them: plain tissue, by numbers of its own.
  std::filesystem::path foreign_file() const {
    const LabelFile own = read_labels(folder_->path() / "labels.seg.nrrd");
    std::vector<Label> dense = own.voxels.dense();
    for (Label& label : dense)
      label = label == structure::kParenchyma    ? Label{2}
              : label == structure::kPortalVein  ? Label{3}
              : label == structure::kFirstLesion ? Label{1}
                                                 : Label{0};
    const auto path = folder_->path() / "foreign.seg.nrrd";
    write_labels(
        path, LabelVolume(own.voxels.grid(), dense),
        {segment(1, "Segment_1", structure::kFirstOther), segment(2, "Leber", structure::kFirstOther),
         segment(3, "Segment_3", structure::kFirstOther)});
    return path;
  }
  /// The window's labels with a vena cava on the right of all of them, as a right hepatectomy leaves it.
  LabelVolume liver_on_the_left() const {
    LabelVolume voxels = read_labels(folder_->path() / "labels.seg.nrrd").voxels;
    for (int k = 0; k < voxels.grid().size.z(); ++k) voxels.set({4, 30, k}, structure::kVenaCava);
    return voxels;
  }
  /// Of all labels in it, as Glisson names them.
  static std::vector<LabelInfo> known_infos() {
    std::vector<LabelInfo> infos;
    for (const Label label :
         {structure::kParenchyma, structure::kPortalVein, structure::kVenaCava, structure::kFirstLesion})
      infos.push_back(structure_info(label));
    return infos;
  }
  QMessageBox* left_liver_question() {
    return window_->findChild<QMessageBox*>(QStringLiteral("left_liver_question"));
  }
  ui::LabelMeanings* question() { return window_->findChild<ui::LabelMeanings*>(); }
  bool is_asked() {
    return QTest::qWaitFor([this] { return question() != nullptr && question()->isVisible(); }, 20000);
  }
  static QPushButton* button(const ui::LabelMeanings& asked, const char* name) {
    return asked.findChild<QPushButton*>(QLatin1String(name));
  }
  static void say(const ui::LabelMeanings& asked, int code, Label meaning) {
    auto* choice = asked.findChild<QComboBox*>(QStringLiteral("meaning_%1").arg(code));
    QVERIFY(choice != nullptr);
    choice->setCurrentIndex(choice->findData(meaning));
  }
};

void LabelImportTest::WhatSaysItselfIsNotAsked() {
  using structure::kParenchyma, structure::kPortalVein;
  const auto own = counted({{kParenchyma, 9}, {kPortalVein, 2}},
                           {structure_info(kParenchyma), structure_info(kPortalVein)});
  QVERIFY(!ui::found_labels(own, false).must_be_asked());
  // By its terminology, whatever its number and name are; what is left out is told by the import.
  const auto by_meaning = counted(
      {{5, 9}, {7, 2}}, {segment(5, "Leber", kParenchyma), segment(7, "Milz", structure::kFirstOther)});
  const ui::FoundLabels found = ui::found_labels(by_meaning, false);
  QVERIFY(!found.must_be_asked());
  QVERIFY(found.labels[0].meaning == kParenchyma && !found.labels[1].meaning);
  // A DICOM segmentation that Glisson has written.
  QVERIFY(!ui::found_labels(counted({{kParenchyma, 9}}, {}), true).must_be_asked());
  // Nothing to be asked about: the import says what is wrong.
  QVERIFY(!ui::found_labels(counted({}, {}), false).must_be_asked());
}

void LabelImportTest::NumbersAreAskedAbout() {
  const ui::FoundLabels found = ui::found_labels(counted({{1, 9}, {2, 4}}, {}), false);
  QVERIFY(found.must_be_asked() && found.are_numbers);
  QCOMPARE(found.labels.size(), std::size_t{2});
  QCOMPARE(found.labels[0].ml, 9.0);
  QVERIFY(!found.labels[0].meaning && !found.labels[1].meaning);  // 2 may be a tumour
}

void LabelImportTest::PlainTissueIsAskedAbout() {
  const auto file = counted({{1, 9}, {2, 4}}, {segment(1, "Segment_1", structure::kFirstOther),
                                               segment(2, "tumour", structure::kFirstLesion)});
  const ui::FoundLabels found = ui::found_labels(file, false);
  QVERIFY(found.must_be_asked() && !found.are_numbers);
  QVERIFY(!found.labels[0].meaning);
  const ui::LabelMeanings asked(found, QStringLiteral("a.seg.nrrd"));
  QCOMPARE(asked.codes(),
           (LabelCodes{{2, structure::kFirstLesion}}));  // what the file says is chosen already
  QVERIFY(!button(asked, "import_meanings")->isEnabled());
  say(asked, 1, structure::kParenchyma);
  QVERIFY(button(asked, "import_meanings")->isEnabled());
}

void LabelImportTest::LesionsAreNumberedInTheirOrder() {
  const ui::FoundLabels found = ui::found_labels(counted({{1, 9}, {4, 2}, {18, 2}, {20, 2}}, {}), false);
  const ui::LabelMeanings asked(found, QStringLiteral("a.nii.gz"));
  say(asked, 1, structure::kParenchyma);
  say(asked, 18, structure::kFirstLesion);
  say(asked, 20, structure::kFirstLesion);
  QCOMPARE(asked.codes(), (LabelCodes{{1, structure::kParenchyma}, {18, 16}, {20, 17}}));
  // In Glisson's own files they have their numbers.
  button(asked, "take_numbers")->click();
  QCOMPARE(asked.codes(),
           (LabelCodes{{1, structure::kParenchyma}, {4, structure::kVenaCava}, {18, 18}, {20, 20}}));
  say(asked, 4, structure::kFirstLesion);
  QCOMPARE(asked.codes(), (LabelCodes{{1, structure::kParenchyma}, {4, 16}, {18, 18}, {20, 20}}));
}

void LabelImportTest::AFileWithoutMeaningsIsImportedAsThePersonSays() {
  open_labels();
  const long liver = count(structure::kParenchyma), vein = count(structure::kPortalVein);
  window_->open(foreign_file());
  QVERIFY(is_asked());
  QVERIFY(window_->findChild<QMessageBox*>() == nullptr);  // no error on the way
  const QPointer<ui::LabelMeanings> asked = question();
  say(*asked, 1, structure::kFirstLesion);
  say(*asked, 2, structure::kParenchyma);
  QTest::mouseClick(button(*asked, "import_meanings"), Qt::LeftButton);
  QVERIFY(settle());
  QCOMPARE(count(structure::kParenchyma), liver);
  QVERIFY(count(structure::kFirstLesion) > 0);
  QCOMPARE(count(structure::kPortalVein), 0L);
  QVERIFY(vein > 0);
  QTRY_VERIFY(asked.isNull());
  QVERIFY(find<QPushButton>("import_labels")->isEnabled());
}

void LabelImportTest::WhoCancelsImportsNothing() {
  open_labels();
  const LabelVolume before = labels();
  panel().import_labels(foreign_file());
  QVERIFY(!find<QPushButton>("import_labels")->isEnabled());  // while it is read
  QVERIFY(is_asked());
  QTest::keyClick(question(), Qt::Key_Escape);
  QTRY_VERIFY(question() == nullptr);
  QVERIFY(settle());
  QVERIFY(labels() == before);
}

void LabelImportTest::GlissonsOwnPlainFileTakesItsNumbers() {
  open_labels();
  const LabelVolume before = labels();
  const auto path = folder_->path() / "plain.nii.gz";
  write_labels(path, before, {});
  panel().import_labels(path);
  QVERIFY(is_asked());
  QTest::mouseClick(button(*question(), "take_numbers"), Qt::LeftButton);
  QTest::mouseClick(button(*question(), "import_meanings"), Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(labels() == before);
}

void LabelImportTest::WhatAHandHasCorrectedIsNotReplacedUnasked() {
  correct_by_hand();
  const LabelVolume mine = labels();
  const auto import = [&](const char* answer) {
    panel().import_labels(folder_->path() / "labels.seg.nrrd");
    const auto asked = [&] { return window_->findChild<QMessageBox*>(QStringLiteral("hand_work_question")); };
    QTRY_VERIFY_WITH_TIMEOUT(asked() != nullptr && asked()->isVisible(), 20000);
    QVERIFY2(asked()->text().contains(QLatin1String("Liver")), qPrintable(asked()->text()));
    if (answer != nullptr)
      QTest::mouseClick(asked()->findChild<QPushButton*>(QLatin1String(answer)), Qt::LeftButton);
    else
      QTest::keyClick(asked(), Qt::Key_Return);
    QTRY_VERIFY(asked() == nullptr);
    QVERIFY(settle());
  };
  for (const char* no : {"keep_hand_work", static_cast<const char*>(nullptr)}) {
    import(no);
    QVERIFY(labels() == mine);
  }
  import("replace_hand_work");
  QVERIFY(labels() != mine);
}

void LabelImportTest::WhatCannotBeReadSaysWhy() {
  window_->open(folder_->path() / "gone.seg.nrrd");
  QTRY_VERIFY(window_->findChild<QMessageBox*>() != nullptr);
  QVERIFY2(window_->findChild<QMessageBox*>()->text().contains(QStringLiteral("gone.seg.nrrd")),
           qPrintable(window_->findChild<QMessageBox*>()->text()));
  QVERIFY(question() == nullptr);
}

void LabelImportTest::ALiverOnTheLeftIsNotImportedUnlessAPersonSaysSo_data() {
  QTest::addColumn<Qt::Key>("key");
  QTest::newRow("Enter") << Qt::Key_Return;
  QTest::newRow("Escape") << Qt::Key_Escape;
}

void LabelImportTest::ALiverOnTheLeftIsNotImportedUnlessAPersonSaysSo() {
  QFETCH(const Qt::Key, key);
  open_labels();
  const LabelVolume before = labels();
  const auto path = folder_->path() / "left.seg.nrrd";
  write_labels(path, liver_on_the_left(), known_infos());
  window_->open(path);
  QTRY_VERIFY(left_liver_question() != nullptr && left_liver_question()->isVisible());
  QVERIFY2(left_liver_question()->text().contains(QStringLiteral("left.seg.nrrd")),
           qPrintable(left_liver_question()->text()));
  QTest::keyClick(left_liver_question(), key);
  QTRY_VERIFY(left_liver_question() == nullptr);
  QVERIFY(settle());
  QVERIFY(labels() == before);
  QVERIFY(window_->findChild<QMessageBox*>() == nullptr);  // it is no error
}

void LabelImportTest::ALiverOnTheLeftThatWasOperatedOnIsImported_data() {
  QTest::addColumn<QString>("file");
  QTest::newRow("the file says what each label is") << "left.seg.nrrd";
  QTest::newRow("the person says it") << "left.nii.gz";
}

void LabelImportTest::ALiverOnTheLeftThatWasOperatedOnIsImported() {
  QFETCH(const QString, file);
  open_labels();
  const LabelVolume left = liver_on_the_left();
  const auto path = folder_->path() / file.toStdString();
  const bool is_asked_first = file.endsWith(QLatin1String(".nii.gz"));
  write_labels(path, left, is_asked_first ? std::vector<LabelInfo>() : known_infos());
  panel().import_labels(path);
  if (is_asked_first) {
    QVERIFY(is_asked());
    QVERIFY(left_liver_question() == nullptr);
    QTest::mouseClick(button(*question(), "take_numbers"), Qt::LeftButton);
    QTest::mouseClick(button(*question(), "import_meanings"), Qt::LeftButton);
  }
  QTRY_VERIFY(left_liver_question() != nullptr && left_liver_question()->isVisible());
  QTest::mouseClick(left_liver_question()->findChild<QPushButton*>(QStringLiteral("left_liver_operated")),
                    Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(labels() == left);
  // It was told by the question, and is not told again.
  for (const QMessageBox* box : window_->findChildren<QMessageBox*>())
    QVERIFY2(box->objectName() == QLatin1String("left_liver_question") ||
                 !box->text().contains(ui::note_text("liver.perhaps_mirrored")),
             qPrintable(box->text()));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::LabelImportTest>(argc, argv); }
#include "label_import_test.moc"
