// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas' proposals reviewed by mouse and keyboard, on the atlas' own mean as the patient's liver.
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QtTest>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/ui/atlas/move_proposal.h"
#include "glisson/ui/atlas/proposal_review.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

using atlas::Decision;
using atlas::Structure;
using ui::MainWindow;

class ProposalReviewTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanupTestCase() { window_.reset(); }
  void NothingIsProposedUnasked();
  void OneButtonProposesAll();
  void TheKeyboardReviewsThem();
  void UndoTakesStepsBackInTurn();
  void AClickMovesIt();
  void AnotherPanelPutsItAway();
  void OfALineTheNeighboursFollow();

 private:
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 60000);
  }
  const engine::CaseState& state() { return window_->engine().state(); }
  const atlas::Proposal& proposal(Structure structure) { return *engine::proposal_of(state(), structure); }
  template <class Widget>
  Widget* find(const char* name) {
    return window_->findChild<Widget*>(QString::fromLatin1(name));
  }
  QListWidget& list() { return *find<QListWidget>("proposals"); }
  ui::ProposalReview& review() { return *find<ui::ProposalReview>("proposal_review"); }
  /// As the list has them.
  void choose(Structure structure) {
    const auto& all = state()[part::proposals]->proposals;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].structure == structure) list().setCurrentRow(static_cast<int>(i));
  }
  void press(Qt::Key key) {
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(window_.get(), key);
    QVERIFY(settle());
  }

  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

void ProposalReviewTest::initTestCase() {
  const std::string source = qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString();
  const auto file = folder_.path() / "liver.ply";
  write_triangle_mesh(file, read_triangle_mesh(source + "/resources/atlas/mean.vtp", LengthUnit::millimetre),
                      LengthUnit::millimetre);
  window_ = std::make_unique<MainWindow>();
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  model::ModelOptions options;
  options.mesh.target_vertices = 300;
  window_->engine().post(engine::ImportSurfaces{file, LengthUnit::millimetre, options});
  QVERIFY(settle());
  QVERIFY(state()[part::model]);
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
}

void ProposalReviewTest::NothingIsProposedUnasked() {
  QVERIFY(!state()[part::proposals]);
  QVERIFY(!list().isVisible());
  QCOMPARE(review().actor_count(), 0);
}

void ProposalReviewTest::OneButtonProposesAll() {
  find<QWidget>("propose_landmarks")->findChild<QPushButton*>()->click();
  QVERIFY(settle());
  QVERIFY(state()[part::proposals]);
  QCOMPARE(list().count(), static_cast<int>(atlas::kStructures.size()));
  QVERIFY(list().isVisible());
  for (int i = 0; i < list().count(); ++i)
    QVERIFY(list().item(i)->text().endsWith(QStringLiteral("proposed")));
  QVERIFY(!state()[part::landmarks]);  // nothing is used unasked
  // Every structure, and the ellipsoids of the chosen one.
  QVERIFY(review().actor_count() > list().count());
  choose(Structure::umbilical_notch);
  const auto& marks = window_->views().state().ellipsoids();
  QCOMPARE(marks.size(), std::size_t{1});
  const Eigen::Vector3d notch = proposal(Structure::umbilical_notch).points.row(0).transpose();
  QVERIFY((marks[0].p - notch).norm() < 1e-12);
  QVERIFY(marks[0].distance2 == kEllipsoid95 && marks[0].colour != QColor(Qt::black));
}

void ProposalReviewTest::TheKeyboardReviewsThem() {
  choose(Structure::umbilical_notch);
  press(Qt::Key_A);
  QVERIFY(proposal(Structure::umbilical_notch).decision == Decision::accepted);
  QCOMPARE(engine::effective_landmarks(state()).umbilical_notch.rows(), 1);
  QVERIFY(list().currentRow() != 0);  // on to what is not reviewed yet
  choose(Structure::vena_cava);
  press(Qt::Key_N);
  QVERIFY(proposal(Structure::vena_cava).decision == Decision::not_visible);
  QCOMPARE(engine::effective_landmarks(state()).vena_cava.rows(), 0);
}

void ProposalReviewTest::UndoTakesStepsBackInTurn() {
  press(Qt::Key_U);
  QVERIFY(proposal(Structure::vena_cava).decision == Decision::proposed);
  QVERIFY(proposal(Structure::umbilical_notch).decision == Decision::accepted);
  press(Qt::Key_U);
  QVERIFY(proposal(Structure::umbilical_notch).decision == Decision::proposed);
  QVERIFY(!state()[part::landmarks]);
  QVERIFY(!find<QPushButton>("undo_review")->isEnabled());
}

void ProposalReviewTest::AClickMovesIt() {
  choose(Structure::umbilical_notch);
  press(Qt::Key_M);
  QVERIFY(review().is_moving());
  ui::RenderView& view = window_->views().volume();
  const auto there = window_->views().surface_point(0.5, 0.5);
  QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(view.width() / 2, view.height() / 2));
  QVERIFY(settle());
  const atlas::Proposal& moved = proposal(Structure::umbilical_notch);
  QVERIFY(moved.decision == Decision::moved && moved.source() == atlas::Source::person);
  QVERIFY((moved.points.row(0).transpose() - *there).norm() < 0.003);
  QVERIFY((engine::effective_landmarks(state()).umbilical_notch - moved.points).norm() < 1e-12);
  press(Qt::Key_Escape);
  QVERIFY(!review().is_moving());
}

void ProposalReviewTest::AnotherPanelPutsItAway() {
  window_->show_step(MainWindow::model);
  QCOMPARE(review().actor_count(), 0);
  QVERIFY(window_->views().state().ellipsoids().empty());
  window_->show_step(MainWindow::atlas);
  QVERIFY(review().actor_count() > 0);
}

void ProposalReviewTest::OfALineTheNeighboursFollow() {
  const atlas::Proposal& margin = proposal(Structure::anterior_margin);
  const TriangleMesh& liver = state()[part::model]->model.surface.mesh;
  const Eigen::Vector3d to = margin.points.row(20).transpose() + Eigen::Vector3d(0.0, 0.0, 0.008);
  const Points moved = ui::moved_points(margin, to, liver);
  QCOMPARE(moved.rows(), margin.points.rows());
  const Eigen::VectorXd way = (moved - margin.points).rowwise().norm();
  Eigen::Index most = 0;
  QVERIFY(way.maxCoeff(&most) < 0.012);
  QVERIFY(std::abs(most - 20) <= 2);
  QCOMPARE(way[0], 0.0);
  QCOMPARE(way[40], 0.0);
  for (const double distance : distances_to_surface(moved.middleRows(18, 5), liver)) QVERIFY(distance < 1e-9);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::ProposalReviewTest>(argc, argv); }
#include "proposal_review_test.moc"
