// SPDX-License-Identifier: GPL-3.0-or-later
// A load tried by mouse in the model panel: the real mechanics of the block patient behind the real window.
#include <QApplication>
#include <QCoreApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <Eigen/Geometry>

#include "fake_operation.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/geometry/rigid.h"
#include "glisson/ui/model/load_trial_box.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

using ui::MainWindow;

class ModelTrialTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void DraggedLiverFollowsAndReturns();
  void PressBesideTheLiverTurnsTheCamera();
  void EscapeEndsIt();
  void LeavingThePanelEndsIt();
  void AnotherModelEndsIt();
  void AnImpossiblePullIsStoppedAndSaysSo_data();
  void AnImpossiblePullIsStoppedAndSaysSo();
  void WhatNothingHoldsIsRefusedWithTheRemedy();
  void OutsideStaysWhereItIsNotAttached();

 private:
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 20000);
  }
  void open_window(engine::Engine::Options options) {
    window_ = std::make_unique<MainWindow>(std::move(options));
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    build_model();
    rest_height_ = drawn_height();
    QVERIFY(std::abs(rest_height_ - 0.025) < 2e-3);
  }
  void build_model() {
    window_->engine().post(engine::ImportImage{"ct.nii"});
    window_->engine().post(engine::SetSeeds{});
    window_->engine().post(engine::Segment{});
    window_->engine().post(engine::BuildModel{});
    QVERIFY(settle());
    window_->show_step(MainWindow::model);
    QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  }
  ui::LoadTrialBox& box() { return *window_->findChild<ui::LoadTrialBox*>(); }
  QLabel* label(const char* name) { return window_->findChild<QLabel*>(QString::fromLatin1(name)); }
  ui::RenderView& view() { return window_->views().volume(); }
  std::shared_ptr<const engine::TrialState> trial() { return window_->engine().snapshot()->trial; }
  void begin() {
    QTest::mouseClick(box().button(), Qt::LeftButton);
    QVERIFY(settle());
    QTRY_VERIFY(box().is_on() && trial() != nullptr);
  }
  QPoint place_of(const Eigen::Vector3d& p) {
    const auto at = view().patient().view_point(p, view().aspect());
    return at ? QPoint(static_cast<int>(at->x() * view().width()),
                       static_cast<int>(at->y() * view().height()))
              : QPoint();
  }
  void move_to(const QPoint& to) {
    QMouseEvent move(QEvent::MouseMove, QPointF(to), view().mapToGlobal(QPointF(to)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view(), &move);
  }
  /// Presses on the front's right upper part and drags it 15 mm to the head.
  void drag() {
    QTest::mousePress(&view(), Qt::LeftButton, {}, place_of(kGrabbed));
    move_to(place_of(kGrabbed + Eigen::Vector3d(0, 0, 0.005)));
    move_to(place_of(kGrabbed + Eigen::Vector3d(0, 0, 0.015)));
    QTRY_VERIFY(trial() && trial()->displacement_max > 5e-3);
  }
  /// What is drawn, under the place of the grabbed point at rest.
  double drawn_height() {
    double highest = -1.0;
    for (double z = -0.04; z < 0.06; z += 5e-4) {
      const QPoint at = place_of({kGrabbed.x(), -0.04, z});
      if (window_->views().surface_point(double(at.x()) / view().width(), double(at.y()) / view().height()))
        highest = z;
    }
    return highest;
  }
  bool shows_rest() {
    return !box().is_on() && !box().button()->isChecked() && std::abs(drawn_height() - rest_height_) < 1e-9 &&
           !label("trial_force")->isVisible() && !label("trial_rate")->isVisible();
  }

  const Eigen::Vector3d kGrabbed{-0.03, -0.04, 0.015};
  double rest_height_ = 0.0;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<MainWindow> window_;
};

void ModelTrialTest::init() {
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  // The vena cava behind, so that the organ is held off the line through its vessels' entrances.
  Points& cava = operation_->model.landmarks.vena_cava;
  cava.resize(3, 3);
  cava << 0.0, 0.04, -0.02, 0.012, 0.04, 0.0, 0.0, 0.04, 0.02;
  open_window(operation_->options());
}

void ModelTrialTest::cleanup() {
  window_.reset();
  operation_.reset();
}

void ModelTrialTest::DraggedLiverFollowsAndReturns() {
  const auto before = window_->engine().snapshot();
  begin();
  QVERIFY(label("trial_message")->text().contains(QStringLiteral("drag")));
  drag();
  // The drawing has moved with the organ, and the figures say how it goes.
  QTRY_VERIFY(drawn_height() > rest_height_ + 4e-3);
  QTRY_VERIFY(label("trial_rate")->isVisible() && label("trial_rate")->text().contains(QStringLiteral("Hz")));
  QVERIFY(label("trial_rate")->text().contains(QStringLiteral("750")));  // elements
  QVERIFY(label("trial_rate")->text().contains(QStringLiteral("ms")));
  QVERIFY(label("trial_load")->text().contains(QStringLiteral("mm")));
  QVERIFY(label("trial_force")->isVisible());
  QVERIFY(label("trial_force")->text().endsWith(QStringLiteral(" N")));
  // In the plane that faces the viewer: the front looks along y.
  QVERIFY(std::abs(trial()->pull->target.y() + 0.04) < 1e-6);
  QVERIFY(std::abs(trial()->pull->target.z() - 0.030) < 1e-3);  // a pixel or so
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, place_of(kGrabbed));
  QTRY_VERIFY_WITH_TIMEOUT(trial() && trial()->nodes.rows() == 0, 20000);
  QTRY_VERIFY(std::abs(drawn_height() - rest_height_) < 1e-9);
  QVERIFY(!label("trial_force")->isVisible());
  QVERIFY(box().is_on());
  QTest::mouseClick(box().button(), Qt::LeftButton);
  QVERIFY(shows_rest());
  QVERIFY(settle());
  QVERIFY(trial() == nullptr);
  // It was a trial.
  const auto after = window_->engine().snapshot();
  QCOMPARE(after->revision, before->revision);
  for (const engine::Part part : engine::all_parts()) QVERIFY(after->state.shares(part, before->state));
}

void ModelTrialTest::PressBesideTheLiverTurnsTheCamera() {
  begin();
  const QPoint before = place_of({0.06, 0.0, 0.0});
  const QPoint beside(view().width() / 2, 12);
  QVERIFY(!window_->views().surface_point(0.5, 12.0 / view().height()));
  QTest::mousePress(&view(), Qt::LeftButton, {}, beside);
  move_to(beside + QPoint(60, 10));
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, beside + QPoint(60, 10));
  QVERIFY((place_of({0.06, 0.0, 0.0}) - before).manhattanLength() > 5);
  QCOMPARE(trial()->steps, 0);  // nobody pulled
}

void ModelTrialTest::EscapeEndsIt() {
  begin();
  drag();
  QApplication::setActiveWindow(window_.get());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QVERIFY(shows_rest());
  // What is still in the hand pulls no more.
  move_to(place_of(kGrabbed));
  QVERIFY(settle());
  QVERIFY(trial() == nullptr);
  QVERIFY(shows_rest());
}

void ModelTrialTest::LeavingThePanelEndsIt() {
  begin();
  drag();
  window_->show_step(MainWindow::atlas);
  QVERIFY(shows_rest());
  QVERIFY(settle());
  QVERIFY(trial() == nullptr);
}

void ModelTrialTest::AnotherModelEndsIt() {
  begin();
  drag();
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  QTRY_VERIFY(!box().is_on());
  QVERIFY(label("trial_message")->text().contains(QStringLiteral("changed")));
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  QVERIFY(shows_rest());
}

void ModelTrialTest::AnImpossiblePullIsStoppedAndSaysSo_data() {
  QTest::addColumn<int>("inverted");
  QTest::newRow("inverted") << 2;
  QTest::newRow("diverged") << 0;
}

void ModelTrialTest::AnImpossiblePullIsStoppedAndSaysSo() {
  QFETCH(int, inverted);
  // Follows for three steps, then fails.
  struct Failing : engine::LoadTrial {
    Points rest;
    int inverted = 0;
    int steps = 0;
    engine::TrialState step(const std::optional<engine::TrialPull>& pull) override {
      engine::TrialState state;
      state.pull = pull;
      state.displacement_max = 0.01;
      if (++steps > 3) {
        state.termination = Termination::diverged;
        state.inverted_tetrahedra = inverted;
      } else {
        state.nodes = rest.rowwise() + Eigen::RowVector3d(0.0, 0.0, 0.01);
      }
      return state;
    }
  };
  engine::Engine::Options options = operation_->options();
  options.make_trial = [&](const engine::CaseState&, const engine::TrialOptions&, const RunContext&) {
    auto failing = std::make_unique<Failing>();
    failing->rest = operation_->model.mesh.vertices;
    failing->inverted = inverted;
    return failing;
  };
  open_window(std::move(options));
  begin();
  QTest::mousePress(&view(), Qt::LeftButton, {}, place_of(kGrabbed));
  QTRY_VERIFY(!box().is_on());
  QVERIFY(label("trial_message")->isVisible());
  QVERIFY(label("trial_message")->text().contains(QStringLiteral("Stopped")));
  QCOMPARE(label("trial_message")->text().contains(QStringLiteral("inside out")), inverted > 0);
  QVERIFY(shows_rest());
}

void ModelTrialTest::WhatNothingHoldsIsRefusedWithTheRemedy() {
  operation_->model.landmarks.vena_cava.resize(0, 3);
  for (VesselTree& tree : operation_->model.vessels) tree.root = -1;
  window_->engine().post(engine::BuildModel{});
  QVERIFY(settle());
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  QTest::mouseClick(box().button(), Qt::LeftButton);
  QTRY_VERIFY(!box().is_on());
  QVERIFY(label("trial_message")->text().contains(QStringLiteral("Place the vena cava")));
  QVERIFY(label("trial_message")->isVisible());
  QVERIFY(shows_rest());
}

void ModelTrialTest::OutsideStaysWhereItIsNotAttached() {
  // A vena cava that runs from the block 75 mm up, and a gallbladder that hangs from its underside.
  auto model = std::make_shared<PatientModel>(operation_->model);
  model->surfaces.push_back({structure::kVenaCava, "vena_cava", ball_mesh({0.0, 0.0, 0.055}, 0.04, 16)});
  model->surfaces.push_back({structure::kGallbladder, "gallbladder", ball_mesh({0.0, 0.0, -0.04}, 0.02, 16)});
  const auto drawable = scene::make_drawable(model);
  // The whole organ turns about z and goes 20 mm to the left.
  const Rigid<CtFrame, CtFrame> turn{Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
                                     {0.02, 0.0, 0.0}};
  int seen = 0;
  for (const scene::DrawableSurface& surface : drawable->surfaces) {
    const Points& rest = surface.mesh.vertices;
    const Points moved = scene::loaded_vertices(*model, surface, turn.apply(model->mesh.vertices));
    const Points carried = turn.apply(rest);
    for (int i = 0; i < surface.mesh.vertex_count(); ++i) {
      const double off = (moved.row(i) - carried.row(i)).norm(), way = (moved.row(i) - rest.row(i)).norm();
      if (surface.structure == structure::kVenaCava) {
        const double above = rest(i, 2) - 0.025;
        if (above < 0.0) QVERIFY2(off < 1e-9, "what lies in the organ goes along");
        if (above > 0.05) QVERIFY2(way < 1e-4, "far from the organ it stays");
      } else if (surface.structure == structure::kGallbladder) {
        QVERIFY2(off < 2e-3, "the gallbladder goes along as a body");
      } else if (surface.structure == structure::kParenchyma) {
        QVERIFY(off < 1e-9);
      }
    }
    ++seen;
  }
  QVERIFY(seen >= 5);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::ModelTrialTest>(argc, argv); }
#include "model_trial_test.moc"
