// SPDX-License-Identifier: GPL-3.0-or-later
// The segmentation panel by mouse and keyboard: the list of labels, seeds and growth, the history.
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QTranslator>

#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/review.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/segmentation/notes_box.h"
#include "segmentation_window.h"

namespace glisson {

using scene::Plane;
using ui::EditTool;

class SegmentationPanelTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void WithoutACtAToolSaysWhatToDoFirst();
  void LockedLabelIsNotTouched();
  void ALiverThatIsLockedNeedsNoSeed();
  void HiddenLabelLeavesTheViews();
  void LabelThatToolsWorkOnHasItsRow();
  void KeysChooseToolsAndEscLetsGo();
  void UndoWorksWhileANumberHasTheKeyboard();
  void ApprovalIsTakenBackByAnEdit();
  void ApprovingGoesOnToTheNextLabelUntilTheStepIsDone();
  void TheKeyboardStaysAtApproveFromLabelToLabel();
  void AToolInHandKeepsItsLabelThroughAnApproval();
  void ToolsKeepTheirPlaceWhateverTheFiguresSay();
  void EditPanelFitsItsColumnInEveryLanguage_data();
  void EditPanelFitsItsColumnInEveryLanguage();
  void WholePathByHandIsSavedWithItsHistory();
  void ANoteThatTellsAPlaceShowsIt();
};

void SegmentationPanelTest::ANoteThatTellsAPlaceShowsIt() {
  open_labels();
  auto* box = window_->findChild<ui::NotesBox*>();
  QVERIFY(box != nullptr);
  box->show_proposal({"liver.small", "liver.dark_body 12 @30.0000,-4.0000,8.0000"});
  QCOMPARE(box->count(), std::size_t{2});
  auto* words = find<QLabel>("label_notes");
  QVERIFY2(words->text().count(QLatin1String("<a ")) == 1 && words->text().contains(QLatin1String("12 ml")),
           qPrintable(words->text()));
  emit words->linkActivated(QStringLiteral("0"));  // tells no place
  const auto crosshair = [&] { return window_->views().state().crosshair().xyz; };
  QVERIFY((crosshair() - Eigen::Vector3d(0.03, -0.004, 0.008)).norm() > 5e-3);
  emit words->linkActivated(QStringLiteral("1"));
  QVERIFY((crosshair() - Eigen::Vector3d(0.03, -0.004, 0.008)).norm() < 2e-3);
}

void SegmentationPanelTest::WithoutACtAToolSaysWhatToDoFirst() {
  session().set_tool(ui::edit_tool("paint"));
  QCOMPARE(session().obstacle(), ui::EditObstacle::case_first);
  QCOMPARE(session().why_not(), QStringLiteral("Open a CT first."));
  QCOMPARE(find<QLabel>("edit_outcome")->text(), QStringLiteral("Open a CT first."));
  open_labels();
  session().set_tool(ui::edit_tool("paint"));
  QCOMPARE(session().obstacle(), ui::EditObstacle::none);
  QCOMPARE(find<QLabel>("edit_outcome")->text(), QString());
}

void SegmentationPanelTest::LockedLabelIsNotTouched() {
  open_labels();
  click_mark(structure::kFirstLesion, ui::LabelTable::locked);
  const long lesion = count(structure::kFirstLesion);
  choose(structure::kPortalVein);
  press("tool_paint");
  drag(slice(Plane::axial), {{0.01, 0, 0}, {0.05, 0, 0}});
  QVERIFY(settle());
  QCOMPARE(count(structure::kFirstLesion), lesion);
  QCOMPARE(at({0.012, 0, 0}), structure::kPortalVein);
  const LabelVolume before = labels();
  choose(structure::kFirstLesion);
  drag(slice(Plane::axial), {{0.0, 0.02, 0}, {0.01, 0.02, 0}});
  QVERIFY(settle());
  QVERIFY(labels() == before);
  QVERIFY(find<QLabel>("edit_outcome")->text().contains(QStringLiteral("locked")));
}

void SegmentationPanelTest::ALiverThatIsLockedNeedsNoSeed() {
  open_labels();
  press("mode_seeds");
  press("seed_portal_vein");
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(-0.02, -0.015, 0)).toPoint());
  QVERIFY(settle());
  auto* segment = window_->findChild<ui::TaskButton*>(QStringLiteral("segment"));
  QVERIFY(!segment->button()->isEnabled());
  click_mark(structure::kParenchyma, ui::LabelTable::locked);
  QVERIFY(segment->button()->isEnabled());
  click_mark(structure::kParenchyma, ui::LabelTable::locked);
  QVERIFY(!segment->button()->isEnabled());
}

void SegmentationPanelTest::HiddenLabelLeavesTheViews() {
  open_labels();
  const Picture before = slice(Plane::axial).slice();
  click_mark(structure::kParenchyma, ui::LabelTable::shown);
  QVERIFY(*slice(Plane::axial).slice().bytes != *before.bytes);
  click_mark(structure::kParenchyma, ui::LabelTable::shown);
  QVERIFY(*slice(Plane::axial).slice().bytes == *before.bytes);
}

void SegmentationPanelTest::LabelThatToolsWorkOnHasItsRow() {
  open_labels();
  constexpr Label second = structure::kFirstLesion + 1, third = structure::kFirstLesion + 2;
  const auto is_chosen = [&](Label label) {
    return session().settings().label == label && table().currentItem() != nullptr &&
           table().currentItem() == table().row_of(label);
  };
  choose(second);
  press("tool_paint");
  drag(slice(Plane::axial), {{-0.03, 0.01, 0}, {-0.02, 0.01, 0}});
  QVERIFY(settle());
  QVERIFY(count(second) > 0);
  table().scrollToItem(table().row_of(third));
  choose(third);
  // The second lesion is the free one again, the third is still what the brush paints.
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QCOMPARE(count(second), 0L);
  QVERIFY(is_chosen(third));
  table().scrollToItem(table().row_of(structure::kParenchyma));
  choose(structure::kParenchyma);  // a click on any other row is heard
  QVERIFY(is_chosen(structure::kParenchyma));
  ui::EditSettings next = session().settings();
  next.label = structure::kFirstOther;
  session().set_settings(next);
  QVERIFY(is_chosen(structure::kFirstOther));
}

void SegmentationPanelTest::KeysChooseToolsAndEscLetsGo() {
  open_labels();
  press("mode_seeds");
  QVERIFY(!find<QToolButton>("tool_paint")->isVisible());
  for (const EditTool tool : ui::edit_tools()) {
    QTest::keyClick(window_.get(), static_cast<Qt::Key>(tool->key));
    QCOMPARE(session().tool(), tool);
    QVERIFY(find<QToolButton>(("tool_" + tool->code).c_str())->isChecked());
  }
  QVERIFY(find<QToolButton>("tool_paint")->isVisible());  // the tools came into sight
  for (int i = 0; i < 3 && session().tool() != nullptr; ++i) QTest::keyClick(window_.get(), Qt::Key_Escape);
  QCOMPARE(session().tool(), nullptr);
  QVERIFY(settle());
  // Seeds and tools share the mouse: one lets go when the other is taken.
  QTest::keyClick(window_.get(), Qt::Key_P);
  press("mode_seeds");
  press("seed_portal_vein");
  QCOMPARE(session().tool(), nullptr);
  const LabelVolume before = labels();
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {}, slice(Plane::axial).rect().center());
  QVERIFY(settle());
  QVERIFY(labels() == before);
  QCOMPARE(window_->engine().state()[part::seeds]->portal_vein.rows(), 1);
}

void SegmentationPanelTest::UndoWorksWhileANumberHasTheKeyboard() {
  open_labels();
  const LabelVolume before = labels();
  choose(structure::kHepaticVeins);
  press("tool_paint");
  drag(slice(Plane::axial), {{-0.03, 0.01, 0}, {0.01, 0.01, 0}});
  QVERIFY(settle());
  auto* number = find<QDoubleSpinBox>("brush_diameter");
  number->setFocus();
  QTest::keyClicks(number, QStringLiteral("7"));
  QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(labels() == before);
}

void SegmentationPanelTest::ApprovingGoesOnToTheNextLabelUntilTheStepIsDone() {
  open_labels();
  auto* approve = find<QPushButton>("approve_label");
  std::set<Label> open;
  for (const auto& [review, labels] : engine::unapproved_labels(window_->engine().state()))
    open.insert(labels.begin(), labels.end());
  QVERIFY(open.size() > 2);
  choose(*std::next(open.begin()));
  while (!open.empty()) {
    QCOMPARE(panel().step_state(), ui::StepState::to_review);
    const Label now = session().settings().label;
    QCOMPARE(open.erase(now), 1UL);
    QTRY_VERIFY(approve->isEnabled());
    press("approve_label");
    // Not by the same hand at once, and shown.
    if (!open.empty()) QVERIFY(!approve->isEnabled() && session().settings().label != now);
    if (!open.empty()) QCOMPARE(at(window_->views().state().crosshair().xyz), session().settings().label);
    QVERIFY(settle());
    QCOMPARE(window_->engine().state()[part::review]->at(now), ReviewState::approved);
  }
  QCOMPARE(panel().step_state(), ui::StepState::done);
}

void SegmentationPanelTest::TheKeyboardStaysAtApproveFromLabelToLabel() {
  open_labels();
  auto* approve = find<QPushButton>("approve_label");
  approve->setFocus();
  const Label first = session().settings().label;
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  const Label second = session().settings().label;
  QVERIFY(second != first);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);  // the same hand at once: nothing
  QCOMPARE(session().settings().label, second);
  QTRY_VERIFY(approve->hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::review]->at(second), ReviewState::approved);
}

void SegmentationPanelTest::AToolInHandKeepsItsLabelThroughAnApproval() {
  open_labels();
  choose(structure::kPortalVein);
  press("tool_paint");
  press("approve_label");
  QVERIFY(settle());
  QCOMPARE(session().settings().label, structure::kPortalVein);
}

void SegmentationPanelTest::ApprovalIsTakenBackByAnEdit() {
  open_labels();
  choose(structure::kPortalVein);
  press("tool_paint");
  press("approve_label");
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::review]->at(structure::kPortalVein), ReviewState::approved);
  QVERIFY(!find<QPushButton>("approve_label")->isEnabled());
  drag(slice(Plane::axial), {{-0.02, 0.02, 0}, {0.0, 0.02, 0}});
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::review]->at(structure::kPortalVein), ReviewState::to_review);
  QVERIFY(find<QPushButton>("approve_label")->isEnabled());
}

void SegmentationPanelTest::ToolsKeepTheirPlaceWhateverTheFiguresSay() {
  open_labels();
  const auto place = [&] {
    QCoreApplication::processEvents();
    return find<QToolButton>("tool_paint")->mapTo(&panel(), QPoint());
  };
  choose(structure::kVenaCava);  // "nothing yet"
  const QPoint before = place();
  for (const Label label : {structure::kParenchyma, structure::kPortalVein, structure::kFirstLesion}) {
    choose(label);
    QCOMPARE(place(), before);
    const auto* figures = find<QLabel>("label_figures");
    QVERIFY2(figures->heightForWidth(figures->width()) <= figures->height(), qPrintable(figures->text()));
  }
}

void SegmentationPanelTest::EditPanelFitsItsColumnInEveryLanguage_data() {
  QTest::addColumn<QString>("language");
  for (const char* language : {"en", "de", "fr"}) QTest::newRow(language) << QString::fromLatin1(language);
}

void SegmentationPanelTest::EditPanelFitsItsColumnInEveryLanguage() {
  QFETCH(QString, language);
  QTranslator translator;
  if (language != QStringLiteral("en")) {
    QVERIFY(translator.load(QStringLiteral(":/glisson/translations/glisson_") + language));
    QCoreApplication::installTranslator(&translator);
  }
  show_window();
  open_labels();
  auto* column = qobject_cast<QScrollArea*>(panel().parentWidget()->parentWidget());
  QVERIFY(column != nullptr);
  const int room = column->width() - column->verticalScrollBar()->sizeHint().width();
  for (const EditTool tool : ui::edit_tools()) {
    session().set_tool(tool);
    QCoreApplication::processEvents();
    const QByteArray what = QStringLiteral("%1 needs %2 of %3 pixels")
                                .arg(QString::fromStdString(tool->code))
                                .arg(panel().minimumSizeHint().width())
                                .arg(room)
                                .toUtf8();
    QVERIFY2(panel().minimumSizeHint().width() <= room, what.constData());
    // Its key can be read without pointing at it.
    const auto* button = find<QToolButton>(("tool_" + tool->code).c_str());
    QVERIFY(!button->text().isEmpty() && button->toolButtonStyle() != Qt::ToolButtonIconOnly);
    QVERIFY2(button->sizeHint().width() <= button->width(), qPrintable(button->text()));
  }
  for (const Label label : {structure::kParenchyma, structure::kHepaticVeins, structure::kFirstLesion}) {
    choose(label);
    const auto* figures = find<QLabel>("label_figures");
    QVERIFY2(figures->heightForWidth(figures->width()) <= figures->height(), qPrintable(figures->text()));
  }
  session().cancel();
  QVERIFY(settle());
  QCOMPARE(window_->size(), QSize(1280, 800));
  QCoreApplication::removeTranslator(&translator);
}

void SegmentationPanelTest::WholePathByHandIsSavedWithItsHistory() {
  open_ct();
  seed_liver();
  press("seed_portal_vein");
  for (const double x : {-0.03, 0.02})
    QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                      slice(Plane::axial).widget_point(Point<CtFrame>(x, -0.015, 0)).toPoint());
  QVERIFY(settle());
  grow();
  QVERIFY2(window_->engine().state()[part::labels] != nullptr, qPrintable(window_->status_text()));
  QCOMPARE(at({0.0, 0.02, 0}), structure::kParenchyma);
  const LabelVolume grown = labels();

  press("mode_edit");
  choose(structure::kFirstLesion);
  QTest::keyClick(window_.get(), Qt::Key_P);
  drag(slice(Plane::axial), {{0.026, 0, 0}, {0.034, 0, 0}});
  QVERIFY(settle());
  QCOMPARE(at({0.03, 0, 0}), structure::kFirstLesion);
  choose(structure::kParenchyma);
  QTest::keyClick(window_.get(), Qt::Key_X);
  drag(slice(Plane::axial), {{-0.07, -0.02, 0}, {-0.05, -0.02, 0}, {-0.05, 0.02, 0}, {-0.07, 0.02, 0}});
  QVERIFY(settle());
  QVERIFY(at({-0.055, 0, 0}) != structure::kParenchyma);
  press("approve_label");
  QVERIFY(settle());
  const LabelVolume edited = labels();
  QVERIFY(!(edited == grown));

  const std::filesystem::path path = folder_->path() / "edited.glisson";
  window_->engine().post(engine::SaveCase{path});
  QVERIFY(settle());
  show_window();
  window_->open(path);
  QVERIFY(settle());
  QVERIFY(labels() == edited);
  QCOMPARE(window_->engine().state()[part::review]->at(structure::kParenchyma), ReviewState::approved);
  press("mode_edit");
  QVERIFY(find<QToolButton>("undo")->text().contains(QStringLiteral("Scissors: erase inside, Liver")));
  for (int step = 0; step < 2; ++step) QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(labels() == grown);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::SegmentationPanelTest>(argc, argv); }
#include "segmentation_panel_test.moc"
