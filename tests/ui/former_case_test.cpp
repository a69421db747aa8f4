// SPDX-License-Identifier: GPL-3.0-or-later
// What was said of one case, hidden or asked in it, does not stand in the next one.
#include <QAction>
#include <QKeySequence>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QStatusBar>

#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_seeds.h"
#include "segmentation_window.h"

namespace glisson {

class FormerCaseTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void HiddenAndLockedLabelsAreOfTheirCase();
  void LocksComeBackWithTheirCase();
  void HowWorkEndedIsSaidOfItsCase();
  void AnErrorsTipGoesWithTheError();
  void WhatAnImageIsIsAskedOfThatImageAlone();
  void WhoseAnImageIsIsAskedOfTheCaseThatIsOpen();
  void ABrushElsewhereIsNotTheEditors();
  void TheEditorsPlaceToWorkIsOfItsCase();
  void LabelsAloneAreKeptToo();
  void AStrokeEndsWithItsCase();
  void ASeedIsNotPlacedWhileAnotherPatientIsOpened();

 private:
  /// Of the CT with labels and seeds.
  std::filesystem::path saved_case() {
    open_labels();
    segmentation::Seeds seeds;
    seeds.liver = Points::Zero(1, 3);
    window_->engine().post(engine::SetSeeds{seeds});
    const auto path = folder_->path() / "other.glisson";
    window_->engine().post(engine::SaveCase{path, true});
    return settle() ? path : std::filesystem::path();
  }
  void open_case(const std::filesystem::path& path) {
    window_->engine().post(engine::OpenCase{path});
    QVERIFY(settle());
  }
  /// Null: nobody is asked whose an image is.
  QMessageBox* whose() const {
    for (auto* box : window_->findChildren<QMessageBox*>(QStringLiteral("whose_image")))
      if (box->isVisible()) return box;
    return nullptr;
  }
  /// All that a button says below itself.
  static QString told_by(const ui::TaskButton& button) {
    QString told;
    for (const QLabel* text : button.findChildren<QLabel*>())
      if (text->isVisibleTo(&button)) told += text->text();
    return told;
  }
};

void FormerCaseTest::HiddenAndLockedLabelsAreOfTheirCase() {
  const auto other = saved_case();
  click_mark(structure::kFirstLesion, ui::LabelTable::shown);
  click_mark(structure::kPortalVein, ui::LabelTable::locked);
  QCOMPARE(window_->views().state().style().hidden.size(), std::size_t{1});
  QCOMPARE(session().settings().region.locked.size(), std::size_t{1});
  open_case(other);
  QVERIFY(window_->views().state().style().hidden.empty());
  QVERIFY(session().settings().region.locked.empty());
}

void FormerCaseTest::LocksComeBackWithTheirCase() {
  const auto without = saved_case();
  click_mark(structure::kPortalVein, ui::LabelTable::locked);
  click_mark(structure::kFirstLesion, ui::LabelTable::locked);
  click_mark(structure::kPortalVein, ui::LabelTable::locked);
  const auto with = folder_->path() / "locked.glisson";
  window_->engine().post(engine::SaveCase{with, true});
  open_case(without);
  QVERIFY(session().settings().region.locked.empty());
  open_case(with);
  QCOMPARE(session().settings().region.locked, std::vector<Label>{structure::kFirstLesion});
  click_mark(structure::kFirstLesion, ui::LabelTable::locked);
  QVERIFY(settle());
  QVERIFY(session().settings().region.locked.empty());
}

void FormerCaseTest::HowWorkEndedIsSaidOfItsCase() {
  const auto other = saved_case();
  press("mode_seeds");
  auto* segment = find<ui::TaskButton>("segment");
  QTest::mouseClick(segment->button(), Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY2(!told_by(*segment).isEmpty(), "how it ended");
  open_case(other);
  QCOMPARE(told_by(*segment), QString());
}

void FormerCaseTest::AnErrorsTipGoesWithTheError() {
  window_->engine().post(engine::ImportImage{folder_->path() / "none.nrrd"});
  QVERIFY(settle());
  const QLabel* line = nullptr;
  for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>())
    if (!label->text().isEmpty() && label->text() == window_->status_text()) line = label;
  QVERIFY(line != nullptr && line->toolTip().contains("none.nrrd"));
  window_->engine().post(engine::ImportImage{folder_->path() / "ct.nrrd"});
  QVERIFY(settle());
  QCOMPARE(line->toolTip(), QString());
}

void FormerCaseTest::WhatAnImageIsIsAskedOfThatImageAlone() {
  const auto other = saved_case();
  window_.reset();
  show_window();
  Image unsaid = ct_;
  unsaid.modality = Modality::other;
  auto greys = std::make_shared<std::vector<std::int16_t>>(*ct_.voxels);
  for (std::int16_t& grey : *greys) grey = static_cast<std::int16_t>(grey + 1100);  // no Hounsfield units
  unsaid.voxels = greys;
  write_image(folder_->path() / "unsaid.nii", unsaid);
  window_->open(folder_->path() / "unsaid.nii");
  QVERIFY(settle());
  QPointer<QMessageBox> question = window_->findChild<QMessageBox*>("modality_question");
  QVERIFY(question);
  open_case(other);
  QTRY_VERIFY(!question || !question->isVisible());
  QVERIFY(window_->engine().state()[part::image]->modality == Modality::ct);
}

void FormerCaseTest::WhoseAnImageIsIsAskedOfTheCaseThatIsOpen() {
  const auto other = saved_case(), third = folder_->path() / "third.glisson";
  std::filesystem::copy(other, third, std::filesystem::copy_options::recursive);
  window_->open(folder_->path() / "ct.nrrd");
  QTRY_VERIFY_WITH_TIMEOUT(whose() != nullptr, 20000);
  QPointer<QMessageBox> asked = whose();
  open_case(third);
  QTRY_VERIFY_WITH_TIMEOUT(whose() != nullptr && whose() != asked, 20000);
  QVERIFY(!asked || !asked->isVisible());
  // Who is open is about to change: the answer is not for the one who comes.
  asked = whose();
  auto* same = asked->findChild<QPushButton*>(QStringLiteral("same_patient"));
  window_->engine().post(engine::OpenCase{other});
  QTest::mouseClick(same, Qt::LeftButton);
  QVERIFY(settle());
  QCOMPARE(window_->engine().state().path, other);
  QVERIFY(!window_->isWindowModified());
  QTRY_VERIFY_WITH_TIMEOUT(whose() != nullptr && whose() != asked, 20000);
  whose()->reject();
}

void FormerCaseTest::ABrushElsewhereIsNotTheEditors() {
  open_labels();
  const double radius = session().settings().brush_radius;
  window_->show_step(ui::MainWindow::atlas);
  const_cast<ui::ViewState&>(window_->views().state()).turn_brush(3.0);  // as the wheel over a slice
  QCOMPARE(session().settings().brush_radius, radius);
}

void FormerCaseTest::TheEditorsPlaceToWorkIsOfItsCase() {
  const auto other = saved_case();
  ui::EditSettings settings = session().settings();
  settings.label = structure::kFirstLesion;
  settings.region.area = editing::EditableRegion::Area::inside_label;
  settings.region.label = structure::kFirstLesion;
  settings.region.intensity = {40.0, 80.0};
  settings.brush_radius = 3e-3;
  session().set_settings(settings);
  press("mode_seeds");
  press("seed_lesion_1");
  open_case(other);
  const ui::EditSettings& now = session().settings();
  QVERIFY(now.region.area == editing::EditableRegion::Area::everywhere && !now.region.intensity);
  QCOMPARE(now.label, structure::kParenchyma);
  QCOMPARE(now.brush_radius, 3e-3);  // a hand's, not a patient's
  QVERIFY(window_->views().state().hand() == ui::Hand::crosshair);
  QVERIFY(!find<QPushButton>("seed_lesion_1")->isChecked());
}

void FormerCaseTest::LabelsAloneAreKeptToo() {
  window_->engine().post(engine::ImportLabels{folder_->path() / "labels.seg.nrrd", {}});
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::labels] && !window_->engine().state()[part::image]);
  QVERIFY(window_->isWindowModified());
  const auto* who = window_->findChild<QLabel*>("patient_identity");
  QCOMPARE(who->text(), QString("Anonymous"));
  for (const QAction* action : window_->findChildren<QAction*>())
    if (action->shortcut() == QKeySequence(QKeySequence::Save)) QVERIFY(action->isEnabled());
}

void FormerCaseTest::AStrokeEndsWithItsCase() {
  const auto other = saved_case();
  choose(structure::kPortalVein);
  press("tool_paint");
  const long before = count(structure::kPortalVein);
  // Opening takes a while, and the hand goes on drawing: the first piece of the stroke comes too late, and
  // what is left of it with the piece.
  window_->engine().post(engine::OpenCase{other});
  drag(slice(scene::Plane::axial), {{-0.03, 0.02, 0.0}, {0.0, 0.02, 0.0}, {0.02, 0.02, 0.0}});
  QVERIFY(settle());
  QCOMPARE(count(structure::kPortalVein), before);
  QVERIFY(!window_->isWindowModified());
  // The tool is at hand in the next case.
  drag(slice(scene::Plane::axial), {{-0.03, 0.02, 0.0}, {0.0, 0.02, 0.0}});
  QVERIFY(settle());
  QVERIFY(count(structure::kPortalVein) > before);
}

void FormerCaseTest::ASeedIsNotPlacedWhileAnotherPatientIsOpened() {
  open_ct();
  const auto other = folder_->path() / "without_seeds.glisson";
  window_->engine().post(engine::SaveCase{other, true});
  QVERIFY(settle());
  press("seed_parenchyma");
  window_->engine().post(engine::OpenCase{other});
  QTest::mouseClick(&slice(scene::Plane::axial), Qt::LeftButton, {},
                    slice(scene::Plane::axial).widget_point(Point<CtFrame>(0.0, 0.02, 0.0)).toPoint());
  QCOMPARE(find<QListWidget>("seed_list")->count(), 0);
  QVERIFY(settle());
  QVERIFY(!window_->engine().state()[part::seeds]);
  QCOMPARE(find<QListWidget>("seed_list")->count(), 0);
  QVERIFY(window_->views().state().markers().empty());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::FormerCaseTest>(argc, argv); }
#include "former_case_test.moc"
