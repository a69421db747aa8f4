// SPDX-License-Identifier: GPL-3.0-or-later
// How livers differ: the atlas' mean bent by its first modes over the patient's liver, by mouse and keyboard.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/parts/model.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/ui/atlas/bent_liver.h"
#include "glisson/ui/atlas/shape_modes.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

using ui::MainWindow;

class ShapeModesTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanupTestCase() { window_.reset(); }
  void NoDeviationIsTheMeanOnThePatient();
  void ThreeDeviationsAreAsFarAsTheVarianceSays();
  void TheStructuresGoAlongOnTheSurface();
  void TheKeyboardBendsIt();
  void LeavingItGivesThePatientsViewBack();
  void AnotherPanelPutsItAway();

 private:
  template <class Widget>
  Widget* find(const char* name) {
    return window_->findChild<Widget*>(QString::fromLatin1(name));
  }
  ui::ShapeModes& modes() { return *find<ui::ShapeModes>("shape_modes"); }
  void press(Qt::Key key) {
    QApplication::setActiveWindow(window_.get());
    QTest::keyClick(window_->focusWidget() != nullptr ? window_->focusWidget() : window_.get(), key);
  }
  QImage volume() { return window_->views().volume().grab().toImage(); }

  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
  const atlas::Atlas& atlas_ = *ui::built_in_atlas();
};

void ShapeModesTest::initTestCase() {
  const auto file = folder_.path() / "liver.ply";
  TriangleMesh liver = atlas_.mean();
  liver.vertices = (1.1 * liver.vertices).rowwise() + Eigen::RowVector3d(0.02, -0.05, 0.1);
  write_triangle_mesh(file, liver, LengthUnit::millimetre);
  window_ = std::make_unique<MainWindow>();
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  model::ModelOptions options;
  options.mesh.target_vertices = 300;
  window_->engine().post(engine::ImportSurfaces{file, LengthUnit::millimetre, options});
  QVERIFY(QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 60000));
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
}

void ShapeModesTest::NoDeviationIsTheMeanOnThePatient() {
  const TriangleMesh& liver = window_->engine().state()[part::model]->model.surface.mesh;
  const atlas::Similarity onto = ui::patient_from_mean(atlas_, nullptr, liver);
  QVERIFY(std::abs(onto.scale - 1.1) < 0.05);
  const ui::BentLiver mean = ui::bent_liver(atlas_, 0, 0.0, onto);
  QVERIFY(distances_to_surface(mean.surface.vertices, liver).size() ==
          static_cast<std::size_t>(mean.surface.vertices.rows()));
  double sum = 0.0;
  for (const double distance : distances_to_surface(mean.surface.vertices, liver)) sum += distance;
  QVERIFY(sum / static_cast<double>(mean.surface.vertices.rows()) < 0.006);
  // A transfer of the atlas says it exactly.
  atlas::Transfer transfer;
  transfer.atlas = atlas_.name;
  transfer.surface = onto.apply(atlas_.shape.mean);
  transfer.surface.col(0).array() += 0.01;
  const atlas::Similarity by_transfer = ui::patient_from_mean(atlas_, &transfer, liver);
  QVERIFY((by_transfer.apply(atlas_.shape.mean) - transfer.surface).cwiseAbs().maxCoeff() < 1e-9);
}

void ShapeModesTest::ThreeDeviationsAreAsFarAsTheVarianceSays() {
  for (int mode = 0; mode < 3; ++mode) {
    const Points bent = ui::bent_liver(atlas_, mode, 3.0, {}).surface.vertices;
    const Eigen::VectorXd b = atlas_.shape.coefficients(bent);
    QVERIFY(std::abs(b[mode] / std::sqrt(atlas_.shape.variances[mode]) - 3.0) < 1e-6);
    const Points other = ui::bent_liver(atlas_, mode, -3.0, {}).surface.vertices;
    QVERIFY((0.5 * (bent + other) - atlas_.shape.mean).cwiseAbs().maxCoeff() < 1e-9);
    if (mode > 0) QVERIFY(ui::share_of_variance(atlas_, mode) <= ui::share_of_variance(atlas_, mode - 1));
  }
  QVERIFY(ui::share_of_variance(atlas_, 0) > 0.05 && ui::share_of_variance(atlas_, 0) < 1.0);
}

void ShapeModesTest::TheStructuresGoAlongOnTheSurface() {
  const ui::BentLiver mean = ui::bent_liver(atlas_, 0, 0.0, {}), bent = ui::bent_liver(atlas_, 0, 3.0, {});
  QCOMPARE(bent.structures.size(), atlas_.structures.size());
  for (std::size_t i = 0; i < bent.structures.size(); ++i)
    for (const double distance : distances_to_surface(bent.structures[i].second, bent.surface))
      QVERIFY(distance < 1e-9);
  double moved = 0.0;
  for (std::size_t i = 0; i < bent.structures.size(); ++i)
    moved =
        std::max(moved, (bent.structures[i].second - mean.structures[i].second).rowwise().norm().maxCoeff());
  QVERIFY(moved > 0.002);
}

void ShapeModesTest::TheKeyboardBendsIt() {
  QVERIFY(!modes().is_shown());
  press(Qt::Key_D);
  QVERIFY(modes().is_shown());
  QCOMPARE(modes().actor_count(), 1 + static_cast<int>(atlas_.structures.size()));
  const auto* caption = find<QLabel>("mode_caption");
  QVERIFY(caption->isVisible() && caption->text().contains(QStringLiteral("0.0 deviations")));
  const QImage at_mean = volume();
  press(Qt::Key_End);
  QCOMPARE(find<QSlider>("deviations")->value(), 30);
  QVERIFY(caption->text().contains(QStringLiteral("Mode 1 at +3.0 deviations")));
  QTRY_VERIFY(volume() != at_mean);
  press(Qt::Key_Left);
  QCOMPARE(find<QSlider>("deviations")->value(), 25);
  press(Qt::Key_2);
  QCOMPARE(find<QComboBox>("mode")->currentIndex(), 1);
  QVERIFY(caption->text().contains(
      QStringLiteral("%1 % of the variance").arg(100.0 * ui::share_of_variance(atlas_, 1), 0, 'f', 0)));
  press(Qt::Key_0);
  QCOMPARE(find<QSlider>("deviations")->value(), 0);
}

void ShapeModesTest::LeavingItGivesThePatientsViewBack() {
  press(Qt::Key_Escape);
  QVERIFY(!modes().is_shown());
  QCOMPARE(modes().actor_count(), 0);
  QVERIFY(!find<QLabel>("mode_caption")->isVisible());
  const QImage patient = volume();
  press(Qt::Key_D);
  QTRY_VERIFY(volume() != patient);
  find<QPushButton>("show_modes")->click();
  QTRY_COMPARE(volume(), patient);
}

void ShapeModesTest::AnotherPanelPutsItAway() {
  press(Qt::Key_D);
  QVERIFY(modes().is_shown());
  window_->show_step(MainWindow::model);
  QVERIFY(!modes().is_shown());
  QCOMPARE(modes().actor_count(), 0);
  window_->show_step(MainWindow::atlas);
  QVERIFY(!modes().is_shown());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::ShapeModesTest>(argc, argv); }
#include "shape_modes_test.moc"
