// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas' proposals reviewed by mouse and keyboard, on the atlas' own mean as the patient's liver.
#include <QApplication>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <algorithm>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/ridge_way.h"
#include "glisson/ui/atlas/move_proposal.h"
#include "glisson/ui/atlas/proposal_review.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/volume/io.h"
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
  void AKeyThatIsHeldAcceptsOne();
  void APointByHandTakesThePlaceOfAnUncertainOne();
  void UndoLeavesWhatAHandHasPlacedSince();
  void AClickMovesIt();
  void AfterTheModesTheArrowsChooseAgain();
  void AnotherPanelPutsItAway();
  void ADragMovesItAndTheViewStays();
  void TheMarginIsTakenFromBesideTheLiver();
  void AClickInASliceMovesItAndEnterDoesAtTheCrosshair();
  void FacesArePaintedAndWiped();
  void FacesArePaintedInSlicesWithTheBrushShown();
  void OfALineTheNeighboursFollow();
  void TheMarginFollowsTheRidge();
  void TheMarginsEndIsDragged();

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
  bool says(const char* words) {
    const auto has = [&](const QLabel* label) { return label->text().contains(QLatin1String(words)); };
    return std::ranges::any_of(review().findChildren<QLabel*>(), has);
  }
  /// As the list has them.
  void choose(Structure structure) {
    const auto& all = state()[part::proposals]->proposals;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].structure == structure) list().setCurrentRow(static_cast<int>(i));
  }
  void press(Qt::Key key) {
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(window_->focusWidget() != nullptr ? window_->focusWidget() : window_.get(), key);
    QVERIFY(settle());
  }

  /// Accepts the notch that is proposed from other livers. @return it
  Points accept_notch() {
    choose(Structure::umbilical_notch);
    press(Qt::Key_A);
    return engine::effective_landmarks(state()).umbilical_notch;
  }
  /// Clicks the notch in the middle of the 3D view. @return the place
  Eigen::Vector3d place_notch() {
    ui::RenderView& view = window_->views().volume();
    const Eigen::Vector3d there = *window_->views().surface_point(0.5, 0.5);
    find<QPushButton>("place_notch")->click();
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(view.width() / 2, view.height() / 2));
    settle();
    press(Qt::Key_Escape);
    return there;
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
  Image ct;  // so that there are slices to click in
  ct.grid.size = {70, 60, 60};
  ct.grid.spacing_mm = {5.0, 5.0, 5.0};
  ct.grid.origin_mm = {-175.0, -150.0, -150.0};
  auto voxels = std::make_shared<std::vector<std::int16_t>>();
  for (long i = 0; i < ct.grid.voxel_count(); ++i)  // tissue among air
    voxels->push_back(i % ct.grid.size.x() < 10 ? std::int16_t{-1000}
                                                : static_cast<std::int16_t>(10 + i * 7919 % 61));
  ct.voxels = std::move(voxels);
  write_image(folder_.path() / "ct.nrrd", ct);
  window_->engine().post(engine::ImportImage{folder_.path() / "ct.nrrd", {}, false, Modality::ct});
  model::ModelOptions options;
  options.mesh.target_vertices = 300;
  window_->engine().post(engine::ImportSurfaces{file, LengthUnit::millimetre, options});
  QVERIFY(settle());
  QVERIFY(state()[part::model]);
  if (QWidget* doubts = QApplication::activeModalWidget()) doubts->close();  // about this CT
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
  QVERIFY((marks[0].p - proposal(Structure::umbilical_notch).points.row(0).transpose()).norm() < 1e-12);
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

/// What comes next was not looked at.
void ProposalReviewTest::AKeyThatIsHeldAcceptsOne() {
  choose(Structure::umbilical_notch);
  QApplication::setActiveWindow(window_.get());
  for (const bool repeats : {false, true, true}) {
    QTest::simulateEvent(window_->focusWidget(), true, Qt::Key_A, {}, QStringLiteral("a"), repeats);
    QVERIFY(settle());
  }
  QTest::keyRelease(window_->focusWidget(), Qt::Key_A);
  const auto& all = state()[part::proposals]->proposals;
  QCOMPARE(std::ranges::count(all, Decision::accepted, &atlas::Proposal::decision), std::ptrdiff_t{1});
  press(Qt::Key_U);
  QVERIFY(!state()[part::landmarks] && !find<QPushButton>("undo_review")->isEnabled());
}

/// Both together would be registered to the place half-way between a guess and a mark, as an exact one.
void ProposalReviewTest::APointByHandTakesThePlaceOfAnUncertainOne() {
  const Points guess = accept_notch();
  QCOMPARE(guess.rows(), 1);
  QVERIFY(engine::effective_landmarks(state()).notch_deviation > 0.0);
  const Eigen::Vector3d there = place_notch();
  const Landmarks placed = engine::effective_landmarks(state());
  QCOMPARE(placed.umbilical_notch.rows(), 1);
  QVERIFY((placed.umbilical_notch.row(0).transpose() - there).norm() < 0.003);
  QVERIFY((placed.umbilical_notch - guess).norm() > 0.005);
  QCOMPARE(placed.notch_deviation, 0.0);
  find<QPushButton>("undo_landmark")->click();
  QVERIFY(settle());
  QCOMPARE(engine::effective_landmarks(state()).umbilical_notch.rows(), 0);
  // A guess that is taken back leaves no doubt behind either.
  accept_notch();
  find<QPushButton>("undo_landmark")->click();
  QVERIFY(settle());
  QCOMPARE(engine::effective_landmarks(state()).umbilical_notch.rows(), 0);
  QVERIFY(!state()[part::landmarks]);
  press(Qt::Key_U);
  press(Qt::Key_U);
}

void ProposalReviewTest::UndoLeavesWhatAHandHasPlacedSince() {
  accept_notch();
  const Eigen::Vector3d there = place_notch();
  // What the model has found of the margin is neither placed nor accepted by it.
  QVERIFY(engine::effective_landmarks(state()).anterior_margin.rows() > 0);
  QCOMPARE(state()[part::landmarks]->anterior_margin.rows(), 0);
  choose(Structure::umbilical_notch);
  QVERIFY(says("placed by hand is used"));
  press(Qt::Key_U);
  QVERIFY(proposal(Structure::umbilical_notch).decision == Decision::proposed);
  const Points kept = engine::effective_landmarks(state()).umbilical_notch;
  QVERIFY(kept.rows() > 0);
  QVERIFY((kept.bottomRows(1).transpose() - there).norm() < 0.003);
  find<QPushButton>("clear_landmarks")->click();
  QVERIFY(settle());
  QCOMPARE(engine::effective_landmarks(state()).umbilical_notch.rows(), 0);
}

void ProposalReviewTest::AClickMovesIt() {
  choose(Structure::umbilical_notch);
  press(Qt::Key_M);
  QVERIFY(review().tool() == ui::ProposalReview::Tool::move);
  ui::RenderView& view = window_->views().volume();
  const auto there = window_->views().surface_point(0.5, 0.5);
  QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(view.width() / 2, view.height() / 2));
  QVERIFY(settle());
  const atlas::Proposal& moved = proposal(Structure::umbilical_notch);
  QVERIFY(moved.decision == Decision::moved && moved.source() == atlas::Source::person);
  QVERIFY((moved.points.row(0).transpose() - *there).norm() < 0.003);
  QVERIFY((engine::effective_landmarks(state()).umbilical_notch - moved.points).norm() < 1e-12);
  press(Qt::Key_Escape);
  QVERIFY(!(review().tool() == ui::ProposalReview::Tool::move));
  QVERIFY((proposal(Structure::falciform_line).points.row(0) - moved.points.row(0)).norm() < 0.015);
  choose(Structure::falciform_line);
  QVERIFY(says("follows the notch that you placed"));
  press(Qt::Key_U);
}

void ProposalReviewTest::AfterTheModesTheArrowsChooseAgain() {
  choose(Structure::falciform_line);
  const int row = list().currentRow();
  press(Qt::Key_D);
  press(Qt::Key_Escape);
  press(Qt::Key_Down);
  QCOMPARE(list().currentRow(), row + 1);
}

void ProposalReviewTest::AnotherPanelPutsItAway() {
  window_->show_step(MainWindow::model);
  QCOMPARE(review().actor_count(), 0);
  QVERIFY(window_->views().state().ellipsoids().empty());
  window_->show_step(MainWindow::atlas);
  QVERIFY(review().actor_count() > 0);
}

void ProposalReviewTest::ADragMovesItAndTheViewStays() {
  choose(Structure::umbilical_notch);
  press(Qt::Key_M);
  ui::RenderView& view = window_->views().volume();
  const QPoint from(view.width() / 2, view.height() / 2), to = from + QPoint(25, -15);
  const auto camera = view.view_from_scene();
  const auto there = window_->views().surface_point(static_cast<double>(to.x()) / view.width(),
                                                    static_cast<double>(to.y()) / view.height());
  QVERIFY(there);
  const Points before = proposal(Structure::umbilical_notch).points;
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, to);
  QCOMPARE(proposal(Structure::umbilical_notch).points, before);  // a drag asks, its end decides
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  QVERIFY(settle());
  QVERIFY((proposal(Structure::umbilical_notch).points.row(0).transpose() - *there).norm() < 0.003);
  QVERIFY(view.view_from_scene().isApprox(camera, 1e-9));
  press(Qt::Key_U);
  QCOMPARE(proposal(Structure::umbilical_notch).points, before);
  // Beside the liver the mouse turns the view.
  QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(8, view.height() - 12));
  QTest::mouseMove(&view, QPoint(60, view.height() - 60));
  QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(60, view.height() - 60));
  QVERIFY(!view.view_from_scene().isApprox(camera, 1e-6));
  QCOMPARE(proposal(Structure::umbilical_notch).points, before);
  press(Qt::Key_Escape);
  window_->views().volume().patient().look_from(scene::ViewFrom::anterior);
}

/// The margin is the liver's outline in most views: a hand that presses a few pixels off has it all the same.
void ProposalReviewTest::TheMarginIsTakenFromBesideTheLiver() {
  choose(Structure::anterior_margin);
  press(Qt::Key_M);
  ui::RenderView& view = window_->views().volume();
  const Points before = proposal(Structure::anterior_margin).points;
  const auto camera = view.view_from_scene();
  const auto pixel = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2d seen = *view.patient().view_point(p, view.aspect());
    return Eigen::Vector2d(seen.x() * view.width(), seen.y() * view.height());
  };
  const Eigen::Vector2d middle(0.5 * view.width(), 0.5 * view.height());
  std::optional<QPoint> beside;
  QPoint to;
  for (Eigen::Index k = 0; k < before.rows() && !beside; ++k) {
    const Eigen::Vector2d at = pixel(before.row(k).transpose()), outwards = (at - middle).normalized();
    const Eigen::Vector2d off = at + 8.0 * outwards, in = at - 30.0 * outwards;
    if (window_->views().surface_point(off.x() / view.width(), off.y() / view.height())) continue;
    beside = QPoint(qRound(off.x()), qRound(off.y()));
    to = QPoint(qRound(in.x()), qRound(in.y()));
  }
  QVERIFY(beside);
  QTest::mousePress(&view, Qt::LeftButton, {}, *beside);
  QTest::mouseMove(&view, to);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  QVERIFY(settle());
  QVERIFY(view.view_from_scene().isApprox(camera, 1e-9));
  const atlas::Proposal& margin = proposal(Structure::anterior_margin);
  QVERIFY(margin.decision == Decision::moved);
  QVERIFY((margin.points - before).rowwise().norm().maxCoeff() > 0.003);
  press(Qt::Key_U);
  press(Qt::Key_Escape);
}

void ProposalReviewTest::AClickInASliceMovesItAndEnterDoesAtTheCrosshair() {
  choose(Structure::umbilical_notch);
  const Points before = proposal(Structure::umbilical_notch).points;
  press(Qt::Key_M);
  ui::SliceView& axial = window_->views().slice(scene::Plane::axial);
  const Eigen::Vector3d wanted = before.row(0).transpose() + Eigen::Vector3d(0.004, 0.0, 0.0);
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.widget_point(Point<CtFrame>(wanted)).toPoint());
  QVERIFY(settle());
  const ClosestPointTree liver(state()[part::model]->model.surface.mesh);
  const auto is_at_the_crosshair = [&] {
    const Eigen::Vector3d there = liver.closest(window_->views().state().crosshair().xyz).point;
    return (proposal(Structure::umbilical_notch).points.row(0).transpose() - there).norm() < 1e-9;
  };
  QVERIFY(proposal(Structure::umbilical_notch).points != before);
  QVERIFY(is_at_the_crosshair());
  axial.setFocus();
  press(Qt::Key_Up);  // the next slice
  QVERIFY(!is_at_the_crosshair());
  press(Qt::Key_Return);
  QVERIFY(is_at_the_crosshair());
  press(Qt::Key_U);
  press(Qt::Key_U);
  QCOMPARE(proposal(Structure::umbilical_notch).points, before);
  press(Qt::Key_Escape);
}

/// The registration holds on to them, so that a hand says which faces the vena cava touches.
void ProposalReviewTest::FacesArePaintedAndWiped() {
  choose(Structure::anterior_margin);
  press(Qt::Key_P);
  QVERIFY(review().tool() == ui::ProposalReview::Tool::none);  // a line has no faces
  choose(Structure::vena_cava);
  press(Qt::Key_P);
  QVERIFY(review().tool() == ui::ProposalReview::Tool::paint);
  QVERIFY(!window_->views().volume().patient().is_visible(structure::kVenaCava));  // it would hide them
  ui::RenderView& view = window_->views().volume();
  const QPoint at(view.width() / 2, view.height() / 2);
  const auto there = window_->views().surface_point(0.5, 0.5);
  const auto close = [&](const Points& area) {
    return ((area.rowwise() - there->transpose()).rowwise().norm().array() < 0.0075).count();
  };
  const Points before = proposal(Structure::vena_cava).area;
  QCOMPARE(close(before), 0);
  QTest::mouseClick(&view, Qt::LeftButton, {}, at);
  QVERIFY(settle());
  const atlas::Proposal& painted = proposal(Structure::vena_cava);
  QVERIFY(painted.decision == Decision::moved && painted.source() == atlas::Source::person);
  QVERIFY(close(painted.area) > 0);
  QVERIFY(close(engine::effective_landmarks(state()).vena_cava) > 0);
  QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, at);
  QVERIFY(settle());
  QCOMPARE(close(proposal(Structure::vena_cava).area), 0);
  press(Qt::Key_U);
  QVERIFY(close(proposal(Structure::vena_cava).area) > 0);
  press(Qt::Key_U);
  QVERIFY((proposal(Structure::vena_cava).area - before).cwiseAbs().maxCoeff() < 1e-12);
  press(Qt::Key_Escape);
  QVERIFY(window_->views().volume().patient().is_visible(structure::kVenaCava));
  QVERIFY(review().tool() == ui::ProposalReview::Tool::none);
}

/// The slices show the brush as a ball and what is painted; in 3D its border lies on the liver.
void ProposalReviewTest::FacesArePaintedInSlicesWithTheBrushShown() {
  choose(Structure::gallbladder_bed);
  press(Qt::Key_P);
  ui::ViewState& shared = const_cast<ui::ViewState&>(window_->views().state());
  QVERIFY(shared.hand() == ui::Hand::brush && shared.brush().ball);
  QCOMPARE(shared.brush().label, structure::kGallbladder);
  const double radius = shared.brush().radius;
  const Points before = proposal(Structure::gallbladder_bed).area;
  // A place of the liver far from the bed.
  const TriangleMesh& liver = state()[part::model]->model.surface.mesh;
  Eigen::Index far = 0;
  double most = 0.0;
  for (int v = 0; v < liver.vertex_count(); ++v) {
    const double away = (before.rowwise() - liver.vertex(v).transpose()).rowwise().norm().minCoeff();
    if (away > most) most = away, far = v;
  }
  const Eigen::Vector3d there = liver.vertices.row(far).transpose();
  const auto close = [&](const Points& area) {
    return ((area.rowwise() - there.transpose()).rowwise().norm().array() < 0.9 * radius).count();
  };
  QCOMPARE(close(before), 0);
  shared.set_crosshair(Point<CtFrame>(there));
  ui::SliceView& axial = window_->views().slice(scene::Plane::axial);
  const QPoint at = axial.widget_point(Point<CtFrame>(there)).toPoint();
  QTest::mouseClick(&axial, Qt::LeftButton, {}, at);
  QVERIFY(settle());
  QVERIFY(close(proposal(Structure::gallbladder_bed).area) > 0);
  QVERIFY(shared.ellipsoids().size() >=
          static_cast<std::size_t>(before.rows()));  // what is painted is marked
  QTest::mouseClick(&axial, Qt::LeftButton, Qt::ControlModifier, at);
  QVERIFY(settle());
  QCOMPARE(close(proposal(Structure::gallbladder_bed).area), 0);
  shared.turn_brush(2.0);
  QVERIFY(shared.brush().radius > radius);
  ui::RenderView& view = window_->views().volume();
  QVERIFY(!review().shows_ring());
  QTest::mouseMove(&view, QPoint(view.width() / 2, view.height() / 2));
  QTRY_VERIFY(review().shows_ring());
  press(Qt::Key_Escape);
  QVERIFY(!review().shows_ring());
  QVERIFY(shared.hand() == ui::Hand::crosshair);
  press(Qt::Key_U);
  press(Qt::Key_U);
  QVERIFY((proposal(Structure::gallbladder_bed).area - before).cwiseAbs().maxCoeff() < 1e-12);
}

void ProposalReviewTest::OfALineTheNeighboursFollow() {
  const atlas::Proposal& line = proposal(Structure::falciform_line);
  const TriangleMesh& liver = state()[part::model]->model.surface.mesh;
  const Eigen::Index middle = line.points.rows() / 2, last = line.points.rows() - 1;
  const Eigen::Vector3d to = line.points.row(middle).transpose() + Eigen::Vector3d(0.008, 0.0, 0.0);
  const Points moved = ui::ProposalMover(liver).moved(line, middle, to);
  QCOMPARE(moved.rows(), line.points.rows());
  const Eigen::VectorXd way = (moved - line.points).rowwise().norm();
  Eigen::Index most = 0;
  QVERIFY(way.maxCoeff(&most) < 0.012);
  QVERIFY(std::abs(most - middle) <= 2);
  QCOMPARE(way[0], 0.0);
  QCOMPARE(way[last], 0.0);
  for (const double distance : distances_to_surface(moved.middleRows(middle - 1, 3), liver))
    QVERIFY(distance < 1e-9);
}

/// The hand is 6 mm off the edge; what comes of it is not, nor is the course between there and what stays.
void ProposalReviewTest::TheMarginFollowsTheRidge() {
  const atlas::Proposal& margin = proposal(Structure::anterior_margin);
  const TriangleMesh& liver = state()[part::model]->model.surface.mesh;
  const ui::ProposalMover mover(liver);
  const Eigen::Vector3d beside = margin.points.row(20).transpose() + Eigen::Vector3d(0.0, 0.0, 0.006);
  const Points moved = mover.moved(margin, 20, beside);
  const RidgeWays ridges(liver);
  QVERIFY((ridges.onto_ridge(beside, 0.008) - moved.row(20).transpose()).norm() < 1e-9);
  for (const double distance : distances_to_surface(moved.middleRows(19, 3), liver)) QVERIFY(distance < 1e-3);
  for (Eigen::Index k = 1; k < moved.rows(); ++k)  // no jump
    QVERIFY((moved.row(k) - moved.row(k - 1)).norm() < 0.03);
  QCOMPARE((moved.row(0) - margin.points.row(0)).norm(), 0.0);
  QCOMPARE((moved.row(40) - margin.points.row(40)).norm(), 0.0);
}

void ProposalReviewTest::TheMarginsEndIsDragged() {
  const atlas::Proposal& margin = proposal(Structure::anterior_margin);
  const ui::ProposalMover mover(state()[part::model]->model.surface.mesh);
  const auto length = [](const Points& line) {
    return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1)).rowwise().norm().sum();
  };
  // Back to where the fifth point is: so much shorter.
  const Points shorter = mover.moved(margin, 0, margin.points.row(4).transpose());
  QCOMPARE(shorter.rows(), margin.points.rows());
  // The mover's surface is coarser than the one on which the proposal lies.
  const double off =
      distances_to_surface(margin.points.middleRows(4, 1), state()[part::model]->model.surface.mesh).front();
  QVERIFY((shorter.row(0) - margin.points.row(4)).norm() < 0.008 + off + 1e-9);
  const double gone = length(margin.points.topRows(5));
  QVERIFY2(length(shorter) < length(margin.points) - 0.5 * gone,
           qPrintable(QStringLiteral("%1 %2 %3").arg(length(shorter)).arg(length(margin.points)).arg(gone)));
  QCOMPARE((shorter.row(40) - margin.points.row(40)).norm(), 0.0);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::ProposalReviewTest>(argc, argv); }
#include "proposal_review_test.moc"
