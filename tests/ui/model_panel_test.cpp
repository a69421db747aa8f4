// SPDX-License-Identifier: GPL-3.0-or-later
// The model panel by mouse: what it says of a model, the check, and the editing of vessel trees in 3D.
#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include <vtkActorCollection.h>
#include <vtkRenderer.h>
#include <atomic>

#include "fake_operation.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/check_model.h"
#include "glisson/engine/commands/edit_trees.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_tissue.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/engine/review.h"
#include "glisson/ui/common/texts.h"
#include "glisson/ui/model/quality_sheet.h"
#include "glisson/ui/model/tree_editor.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

using Kind = model::TreeEdit::Kind;
using ui::MainWindow;

class ModelPanelTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void TheSheetSaysWhatStandsOut();
  void ALiverThatEndsWithTheImageStandsOut();
  void WhatCannotBeComparedIsNotShownAsPerfect();
  void TheCheckIsKeptUntilAnotherModel();
  void AModelThatIsBeingMadeIsNotChecked();
  void LabelsThatNobodyApprovedAreNamedOnceWhereTheModelIsApproved();
  void FlattestElementsAreShownAndPutAway();
  void SizeIsGivenByVerticesOrEdges();
  void StiffnessGoesToTheCaseAndComesBack();
  void ByValueTheParenchymaMayBeAsAHealthyOne();
  void AGivenStiffnessIsNotRoundedByAnotherOnesChange();
  void AnEntranceIsMovedByAClickAndUndone();
  void APrunedTreeComesBackAndGoesAgain();
  void AnUndoThatFailsLeavesNothingToRedo();
  void WhatAClickWouldCutIsToldBefore();
  void WhatAClickWouldJoinIsShownBefore();
  void AnImpossibleJoinSaysWhy();
  void EscapeAndAnotherPanelPutTheToolAway();
  void AClickBesideTheVesselsTurnsTheCamera();

 private:
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 20000);
  }
  const engine::CaseState& state() { return window_->engine().state(); }
  const std::vector<VesselTree>& trees() { return state()[part::model]->model.vessels; }
  ui::RenderView& view() { return window_->views().volume(); }
  ui::TreeEditor& editor() { return *window_->findChild<ui::TreeEditor*>(); }
  ui::QualitySheet& sheet() { return *window_->findChild<ui::QualitySheet*>(); }
  QString text(const char* label) { return window_->findChild<QLabel*>(QString::fromLatin1(label))->text(); }
  int actors() { return view().patient().renderer().GetActors()->GetNumberOfItems(); }
  void press(QAbstractButton* button) {
    QVERIFY(button->isEnabled());
    button->click();
    QVERIFY(settle());
  }
  void choose(const char* name, int index) {
    auto* combo = window_->findChild<QComboBox*>(QString::fromLatin1(name));
    QVERIFY(combo != nullptr && combo->isVisible());
    combo->setCurrentIndex(index);
    emit combo->activated(index);
    QVERIFY(settle());
  }
  int chosen(const char* name) {
    return window_->findChild<QComboBox*>(QString::fromLatin1(name))->currentIndex();
  }
  QDoubleSpinBox* kilopascals(const char* name) {
    return window_->findChild<QDoubleSpinBox*>(QString::fromLatin1(name));
  }
  bool is_tissue(const char* list) {
    return state()[part::tissue] && *state()[part::tissue] == fem::tissue_from(list);
  }
  void click_on(const Eigen::Vector3d& p) {
    const auto at = view().patient().view_point(p, view().aspect());
    QVERIFY(at.has_value());
    const QPoint place(static_cast<int>(at->x() * view().width()),
                       static_cast<int>(at->y() * view().height()));
    QTest::mouseClick(&view(), Qt::LeftButton, {}, place);
    QVERIFY(settle());
  }
  void point_at(const QPointF& place) {
    QMouseEvent move(QEvent::MouseMove, place, view().mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&view(), &move);
  }
  void point_at(const Eigen::Vector3d& p) {
    const auto at = view().patient().view_point(p, view().aspect());
    QVERIFY(at.has_value());
    point_at(QPointF(at->x() * view().width(), at->y() * view().height()));
  }
  Eigen::Vector3d entrance(std::size_t tree) {
    return trees().at(tree).nodes.row(trees().at(tree).root).transpose();
  }
  Eigen::Vector3d last_node(std::size_t tree) {
    return operation_->model.vessels[tree].nodes.bottomRows(1).transpose();
  }

  std::atomic<bool> edits_fail_ = false;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<MainWindow> window_;
};

void ModelPanelTest::init() {
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  operation_->model.vessels[1].nodes.col(2).array() += 0.018;  // not behind the other, seen from the front
  engine::Engine::Options options = operation_->options();
  edits_fail_ = false;
  options.apply = [this, fake = options.apply](const engine::CaseState& now, const engine::Command& command,
                                               const RunContext& context, const engine::Services& services) {
    if (edits_fail_ && command.as<engine::EditTrees>() != nullptr) throw NumericalError("no memory");
    const bool real =
        command.as<engine::EditTrees>() != nullptr || command.as<engine::CheckModel>() != nullptr ||
        command.as<engine::SetReview>() != nullptr || command.as<engine::SetTissue>() != nullptr;
    return real ? engine::apply(now, command, context, services) : fake(now, command, context, services);
  };
  window_ = std::make_unique<MainWindow>(std::move(options));
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  window_->engine().post(engine::ImportImage{"ct.nii"});
  window_->engine().post(engine::SetSeeds{});
  window_->engine().post(engine::Segment{});
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  window_->show_step(MainWindow::model);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
}

void ModelPanelTest::cleanup() {
  window_.reset();
  operation_.reset();
}

void ModelPanelTest::TheSheetSaysWhatStandsOut() {
  // The block's lesion has no elements of its own; everything else is as it should be.
  QVERIFY(text("model_summary").contains(QStringLiteral("Lesions without elements of their own: 1")));
  QVERIFY(!text("model_summary").contains(QStringLiteral("Flat elements")));
  QVERIFY(!text("model_summary").contains(QStringLiteral("The image ends inside the liver")));
  QStringList shown;
  for (const QLabel* label : sheet().findChildren<QLabel*>()) shown << label->text();
  QVERIFY(shown.contains(QStringLiteral("14.2° to 151.0°")));
  QVERIFY(shown.contains(QStringLiteral("-1.1 %")));
  QVERIFY(shown.contains(QStringLiteral("480 ml")));  // 12 x 8 x 5 cm
  QCOMPARE(shown.filter(QStringLiteral("tips: 1, beams: 4")).size(), 2);
}

void ModelPanelTest::ALiverThatEndsWithTheImageStandsOut() {
  operation_->model_notes = {"liver.cut_off 166"};
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  QTRY_VERIFY(text("model_summary").contains(QStringLiteral("The image ends inside the liver: 166 cm²")));
}

void ModelPanelTest::WhatCannotBeComparedIsNotShownAsPerfect() {
  const auto shown = [&] {
    QStringList texts;
    for (const QLabel* label : sheet().findChildren<QLabel*>()) texts << label->text();
    return texts;
  };
  QVERIFY(shown().contains(QStringLiteral("Volume error")));
  QVERIFY(!text("model_summary").contains(QStringLiteral("not known")));
  operation_->knows_organ = false;
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  QTRY_VERIFY(text("model_summary").contains(QStringLiteral("not known")));
  for (const char* row : {"Volume error", "Mesh to fine surface, mean", "Fine surface to mesh, largest"})
    QVERIFY2(!shown().contains(QString::fromLatin1(row)), row);
  operation_->knows_organ = true;
  for (const auto& [error, words] :
       {std::pair{0.08, "8.0 % more volume than the organ"}, {-0.08, "8.0 % less volume than the organ"}}) {
    operation_->volume_error = error;
    window_->engine().post(engine::BuildModel{});
    QVERIFY(settle());
    QTRY_VERIFY2(text("model_summary").contains(QString::fromLatin1(words)), words);
  }
  QVERIFY(shown().contains(QStringLiteral("Tetrahedra")));
}

void ModelPanelTest::TheCheckIsKeptUntilAnotherModel() {
  QVERIFY(!sheet().checked_box()->isChecked());
  // The operation's panel warns as long as nobody has checked it.
  const auto* warning = window_->findChild<QLabel*>(QStringLiteral("model_unchecked"));
  QVERIFY(warning != nullptr && !warning->isHidden());
  press(sheet().checked_box());
  QVERIFY(engine::is_model_checked(state()));
  QTRY_VERIFY(warning->isHidden());
  QVERIFY(sheet().checked_box()->isChecked());
  press(sheet().checked_box());
  QVERIFY(!engine::is_model_checked(state()));
  press(sheet().checked_box());
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  QTRY_VERIFY(!sheet().checked_box()->isChecked());
  QVERIFY(!engine::is_model_checked(state()));
}

void ModelPanelTest::AModelThatIsBeingMadeIsNotChecked() {
  QVERIFY(sheet().checked_box()->isEnabled());
  operation_->hold = true;
  window_->engine().post(engine::BuildModel{});
  QVERIFY(!sheet().checked_box()->isEnabled());
  QVERIFY(sheet().checked_box()->toolTip().contains(QStringLiteral("look at it first")));
  sheet().checked_box()->click();
  operation_->hold = false;
  QVERIFY(settle());
  // Nobody has seen the new one.
  QVERIFY(!engine::is_model_checked(state()));
  QVERIFY(!sheet().checked_box()->isChecked());
  QVERIFY(sheet().checked_box()->isEnabled());
}

void ModelPanelTest::LabelsThatNobodyApprovedAreNamedOnceWhereTheModelIsApproved() {
  const auto* line = window_->findChild<QLabel*>(QStringLiteral("model_review"));
  const auto* before_building = window_->findChild<QLabel*>(QStringLiteral("build_review"));
  const auto unapproved = engine::unapproved_labels(state());
  const std::vector<Label> labels = unapproved.at(ReviewState::not_started);
  QVERIFY(!labels.empty());
  const QString name = ui::structure_text(labels.front());
  const QString sentence = QStringLiteral("nobody has reviewed: ") + name;
  QVERIFY(line->isVisible() && line->text().contains(sentence));
  const auto said = [&] {
    int times = 0;
    for (const QLabel* label : window_->findChildren<QLabel*>())
      times += label->isVisible() && label->text().contains(sentence);
    return times;
  };
  QCOMPARE(said(), 1);
  // Between what is read and the box that approves.
  QCOMPARE(line->parentWidget(), sheet().checked_box()->parentWidget());
  const int gap = sheet().checked_box()->geometry().top() - line->geometry().bottom();
  QVERIFY2(gap > 0 && gap < 20, qPrintable(QString::number(gap)));
  window_->engine().post(engine::SetReview{labels.front(), ReviewState::to_review});
  QVERIFY(settle());
  QTRY_VERIFY(line->text().contains(QStringLiteral("still to be reviewed: ") + name));
  for (const Label label : labels) window_->engine().post(engine::SetReview{label, ReviewState::approved});
  QVERIFY(settle());
  QTRY_VERIFY(!line->isVisible());
  QVERIFY(!before_building->isVisible());
}

void ModelPanelTest::FlattestElementsAreShownAndPutAway() {
  const int before = actors();
  sheet().worst_box()->click();
  QCOMPARE(actors(), before + 1);
  sheet().worst_box()->click();
  QCOMPARE(actors(), before);
  sheet().worst_box()->click();
  window_->show_step(MainWindow::atlas);
  QVERIFY(!sheet().worst_box()->isChecked());
}

void ModelPanelTest::SizeIsGivenByVerticesOrEdges() {
  auto* by = window_->findChild<QComboBox*>(QStringLiteral("mesh_size_by"));
  QVERIFY(by != nullptr);
  auto* edge = by->parentWidget()->findChild<QDoubleSpinBox*>();
  QVERIFY(!edge->isVisible());
  by->setCurrentIndex(1);
  QVERIFY(edge->isVisible());
  // Beams are asked for where vessels are wanted.
  auto* beams = window_->findChild<QSpinBox*>(QStringLiteral("model_beams"));
  QCOMPARE(beams->value(), model::ModelOptions{}.target_beams);
  QVERIFY(beams->isEnabled());
}

void ModelPanelTest::StiffnessGoesToTheCaseAndComesBack() {
  choose("stiffness_parenchyma", 1);  // cirrhotic
  choose("stiffness_lesion_1", 2);    // stiff
  QTRY_VERIFY(is_tissue("parenchyma=cirrhotic,lesion_1=stiff"));
  QCOMPARE(kilopascals("stiffness_lesion_1_kpa")->value(), 150.0);
  // The block's lesion has no elements of its own.
  QTRY_VERIFY2(text("stiffness_notes").contains("its stiffness changes nothing"),
               qPrintable(text("stiffness_notes")));
  QVERIFY(!kilopascals("stiffness_lesion_1_kpa")->isEnabled());
  choose("stiffness_lesion_1", 3);  // by value
  QVERIFY(kilopascals("stiffness_lesion_1_kpa")->isEnabled());
  kilopascals("stiffness_lesion_1_kpa")->setValue(20.0);
  QVERIFY(settle());
  QTRY_VERIFY(is_tissue("parenchyma=cirrhotic,lesion_1=20"));
  // What comes from elsewhere is shown.
  window_->engine().post(engine::SetTissue{fem::tissue_from("lesion_1=soft")});
  QVERIFY(settle());
  QTRY_COMPARE(chosen("stiffness_lesion_1"), 1);
  QCOMPARE(chosen("stiffness_parenchyma"), 0);
  choose("stiffness_lesion_1", 0);
  QTRY_VERIFY(!state()[part::tissue]);
  QTRY_VERIFY(!window_->findChild<QLabel*>(QStringLiteral("stiffness_notes"))->isVisible());
}

void ModelPanelTest::ByValueTheParenchymaMayBeAsAHealthyOne() {
  QDoubleSpinBox* value = kilopascals("stiffness_parenchyma_kpa");
  for (const int kind : {0, 1}) {
    const double shown = kind == 0 ? 3.5 : 30.0;  // healthy, cirrhotic
    choose("stiffness_parenchyma", kind);
    choose("stiffness_parenchyma", 2);  // by value
    QTRY_VERIFY(state()[part::tissue] && state()[part::tissue]->parenchyma == 1e3 * shown);
    QCOMPARE(chosen("stiffness_parenchyma"), 2);
    QVERIFY(value->isEnabled());
    QCOMPARE(value->value(), shown);
  }
  value->setValue(5.0);
  QVERIFY(settle());
  QTRY_VERIFY(is_tissue("parenchyma=5"));
  window_->engine().post(engine::SetTissue{});
  QVERIFY(settle());
  QTRY_COMPARE(chosen("stiffness_parenchyma"), 0);
}

void ModelPanelTest::AGivenStiffnessIsNotRoundedByAnotherOnesChange() {
  const auto give = [this] {
    window_->engine().post(engine::SetTissue{fem::tissue_from("parenchyma=12.34,lesion_1=45.67")});
    QVERIFY(settle());
    QTRY_COMPARE(kilopascals("stiffness_lesion_1_kpa")->value(), 45.7);
  };
  give();
  QCOMPARE(kilopascals("stiffness_parenchyma_kpa")->value(), 12.3);
  choose("stiffness_lesion_1", 2);  // stiff
  QTRY_VERIFY(is_tissue("parenchyma=12.34,lesion_1=stiff"));
  give();
  kilopascals("stiffness_parenchyma_kpa")->setValue(20.0);
  QVERIFY(settle());
  QTRY_VERIFY(is_tissue("parenchyma=20,lesion_1=45.67"));
}

void ModelPanelTest::AnEntranceIsMovedByAClickAndUndone() {
  const Eigen::Vector3d before = entrance(0), wanted = last_node(0);
  const int drawn = actors();
  press(editor().tool_button(Kind::set_root));
  QVERIFY(actors() > drawn);  // centrelines and entrances
  QVERIFY(text("tree_message").contains(QStringLiteral("Click the place")));
  click_on(wanted);
  QVERIFY((entrance(0) - wanted).norm() < 1e-9);
  QTRY_VERIFY(editor().undo_button()->isEnabled());
  press(editor().undo_button());
  QVERIFY((entrance(0) - before).norm() < 1e-9);
  QVERIFY(!editor().undo_button()->isEnabled());
}

void ModelPanelTest::APrunedTreeComesBackAndGoesAgain() {
  press(editor().tool_button(Kind::prune));
  click_on(operation_->model.vessels[0].nodes.row(2).transpose());
  QCOMPARE(trees().size(), std::size_t{1});  // its trunk was all that it had
  QTRY_VERIFY(editor().undo_button()->isEnabled());
  press(editor().undo_button());
  QCOMPARE(trees().size(), std::size_t{2});
  QTRY_VERIFY(editor().redo_button()->isEnabled());
  press(editor().redo_button());
  QCOMPARE(trees().size(), std::size_t{1});
  // A new model has nothing to undo or redo.
  press(editor().undo_button());
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  QTRY_VERIFY(!editor().undo_button()->isEnabled() && !editor().redo_button()->isEnabled());
}

void ModelPanelTest::AnUndoThatFailsLeavesNothingToRedo() {
  press(editor().tool_button(Kind::prune));
  click_on(operation_->model.vessels[0].nodes.row(2).transpose());
  QTRY_VERIFY(editor().undo_button()->isEnabled());
  edits_fail_ = true;
  press(editor().undo_button());
  QCOMPARE(trees().size(), std::size_t{1});
  QTRY_VERIFY(editor().undo_button()->isEnabled());
  QVERIFY(!editor().redo_button()->isEnabled());
  edits_fail_ = false;
  press(editor().undo_button());
  QTRY_VERIFY(editor().redo_button()->isEnabled());
  // A redo that fails can be tried again.
  edits_fail_ = true;
  press(editor().redo_button());
  QTRY_VERIFY(editor().redo_button()->isEnabled());
}

void ModelPanelTest::WhatAClickWouldCutIsToldBefore() {
  press(editor().tool_button(Kind::prune));
  const int drawn = actors();
  point_at(Eigen::Vector3d(operation_->model.vessels[0].nodes.row(2).transpose()));
  QVERIFY(text("tree_message").contains(QStringLiteral("takes the whole tree: Portal vein")));
  QVERIFY(text("tree_message").contains(QStringLiteral("tips: 1")));
  QCOMPARE(actors(), drawn + 1);  // and marked
  QCOMPARE(trees().size(), std::size_t{2});
  point_at(QPointF(view().width() / 2.0, 12.0));
  QVERIFY(!text("tree_message").contains(QStringLiteral("Portal vein")));
  QCOMPARE(actors(), drawn);
}

void ModelPanelTest::WhatAClickWouldJoinIsShownBefore() {
  // A second tree of the portal vein, which begins 15 mm below the end of the first.
  VesselTree other = operation_->model.vessels[0];
  for (int i = 0; i < other.nodes.rows(); ++i)
    other.nodes.row(i) = last_node(0).transpose() + Eigen::RowVector3d(-0.01 * i, 0.0, -0.015);
  operation_->model.vessels.push_back(other);
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  QTRY_COMPARE(trees().size(), std::size_t{3});
  press(editor().tool_button(Kind::join));
  const int drawn = actors();
  const auto end_of = [](const VesselTree& tree) {
    return Eigen::Vector3d(tree.nodes.bottomRows(1).transpose());
  };
  const Eigen::Vector3d near_end = other.nodes.row(0).transpose();
  point_at(end_of(trees()[0]));
  QVERIFY(text("tree_message").contains(QStringLiteral("lets this tree stay: Portal vein")));
  QCOMPARE(actors(), drawn + 1);  // marked
  click_on(end_of(trees()[0]));
  QCOMPARE(actors(), drawn + 2);  // the tree, and the place that was clicked
  point_at(end_of(trees()[1]));
  QVERIFY(text("tree_message").contains(QStringLiteral("this is Hepatic veins")));
  QCOMPARE(actors(), drawn + 1);  // nothing would move
  point_at(trees()[0].nodes.row(1).transpose());
  QVERIFY(text("tree_message").contains(QStringLiteral("the tree that stays. Point at another")));
  point_at(near_end);
  QVERIFY2(text("tree_message")
               .contains(QStringLiteral("hangs this on the tree that stays, 15 mm away: Portal vein")),
           qPrintable(text("tree_message")));
  QCOMPARE(actors(), drawn + 2);
  QCOMPARE(trees().size(), std::size_t{3});  // still shown only
  click_on(near_end);
  QTRY_COMPARE(trees().size(), std::size_t{2});
  QCOMPARE(actors(), drawn);
}

void ModelPanelTest::AnImpossibleJoinSaysWhy() {
  press(editor().tool_button(Kind::join));
  click_on(last_node(0));
  QVERIFY(text("tree_message").contains(QStringLiteral("other tree")));
  click_on(last_node(1));
  QTRY_VERIFY(text("tree_message").contains(QStringLiteral("hepatic_veins")));
  QCOMPARE(trees().size(), std::size_t{2});
  QVERIFY(!editor().undo_button()->isEnabled());
}

void ModelPanelTest::EscapeAndAnotherPanelPutTheToolAway() {
  const int drawn = actors();
  press(editor().tool_button(Kind::prune));
  QVERIFY(editor().is_on());
  QApplication::setActiveWindow(window_.get());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QVERIFY(!editor().is_on() && !editor().tool_button(Kind::prune)->isChecked());
  QCOMPARE(actors(), drawn);
  press(editor().tool_button(Kind::join));
  window_->show_step(MainWindow::atlas);
  QVERIFY(!editor().is_on());
}

void ModelPanelTest::AClickBesideTheVesselsTurnsTheCamera() {
  press(editor().tool_button(Kind::prune));
  QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(view().width() / 2, 12));
  QVERIFY(settle());
  QCOMPARE(trees().size(), std::size_t{2});
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::ModelPanelTest>(argc, argv); }
#include "model_panel_test.moc"
