// SPDX-License-Identifier: GPL-3.0-or-later
// The registered organ in 3D, drawn without a display and looked at pixel by pixel.
#include <vtkActorCollection.h>
#include <vtkRenderer.h>

#include <QTest>

#include "box_patient.h"
#include "glisson/core/error.h"
#include "glisson/ui/scene/offscreen_renderer.h"
#include "glisson/ui/scene/patient_scene.h"
#include "glisson/ui/scene/registration_actors.h"

namespace glisson {
namespace {

constexpr int kWidth = 200, kHeight = 150;

/// One patient, registered, and what is drawn of that.
struct Stage {
  std::shared_ptr<const scene::DrawableModel> drawable =
      scene::make_drawable(std::make_shared<const PatientModel>(box_patient()));
  Registration registration;
  scene::PatientScene scene;
  scene::RegistrationActors actors{scene.renderer()};

  Stage() { registration.nodes_in_camera = drawable->model->mesh.vertices; }
  void expect(double error) {
    registration.expected = Eigen::VectorXd::Constant(registration.nodes_in_camera.rows(), error);
  }
  int actor_count() const { return scene.renderer().GetActors()->GetNumberOfItems(); }
  /// Mean colour in the picture's middle: blue, green, red.
  std::array<double, 3> middle(int look = -1, bool holds = true) {
    actors.show(*drawable, registration, {}, {-1, look, holds});
    scene.look_from(scene::ViewFrom::camera);
    scene::OffscreenRenderer offscreen(kWidth, kHeight);
    const Picture picture = offscreen.render(scene.renderer());
    std::array<double, 3> sum{};
    for (int v = kHeight / 2 - 5; v < kHeight / 2 + 5; ++v)
      for (int u = kWidth / 2 - 5; u < kWidth / 2 + 5; ++u)
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += (*picture.bytes)[static_cast<std::size_t>(3 * (v * kWidth + u)) + c] / 100.0;
    return sum;
  }
};

double brightness(const QColor& colour) {
  return 0.2126 * colour.redF() + 0.7152 * colour.greenF() + 0.0722 * colour.blueF();
}

}  // namespace

class RegistrationActorsTest : public QObject {
  Q_OBJECT
 private slots:
  void TheScaleGrowsBrighterAllTheWay();
  void TheOrganHasTheColourOfItsError();
  void ALookIsShownInTheColoursOfWhatItLeaves();
  void WithoutAnErrorItIsGrey();
  void LesionsForcesAndTheOtherPlaceAppearAndGo();
  void WhatDoesNotHoldIsAGreyShapeAlone();
  void NodesOfAnotherModelAreRefused();
};

void RegistrationActorsTest::TheScaleGrowsBrighterAllTheWay() {
  double last = -1.0;
  for (double mm = 0.0; mm <= 15.0; mm += 0.5) {
    const double now = brightness(scene::error_colour(1e-3 * mm));
    QVERIFY(now > last);
    last = now;
  }
  QCOMPARE(scene::error_colour(0.04), scene::error_colour(scene::kMostErrorShown));
  QCOMPARE(scene::error_colour(-1.0), scene::error_colour(0.0));
}

void RegistrationActorsTest::TheOrganHasTheColourOfItsError() {
  Stage stage;
  stage.expect(0.5e-3);
  const auto small = stage.middle();
  stage.expect(14e-3);
  const auto large = stage.middle();
  QVERIFY2(small[0] > small[2] + 20.0, "a small error is blue");
  QVERIFY2(large[2] > large[0] + 60.0 && large[1] > large[0] + 40.0, "a large one is yellow");
}

void RegistrationActorsTest::ALookIsShownInTheColoursOfWhatItLeaves() {
  Stage stage;
  stage.expect(0.5e-3);
  const Eigen::Index count = stage.registration.expected.size();
  // All but one place leave all of it: the last colour, whatever its size.
  for (const double now : {14e-3, 3e-3}) {
    stage.registration.looks = {
        {structure::kFirstLesion, now, Eigen::VectorXd::Constant(count, now), now, now}};
    stage.registration.looks[0].seen[0] = 0.5 * now;
    const auto error = stage.middle(), left = stage.middle(0);
    QVERIFY(error[0] > error[2] + 20.0 && left[2] > left[0] + 20.0);
    QVERIFY(scene::look_range(stage.registration.looks[0]) == (scene::ErrorRange{0.5 * now, now}));
  }
  stage.actors.show(*stage.drawable, stage.registration, {}, {});
  const int plain = stage.actor_count();
  stage.actors.show(*stage.drawable, stage.registration, {}, {-1, 0});
  QCOMPARE(stage.actor_count(), plain + 1);  // the ball at the best place
}

void RegistrationActorsTest::WithoutAnErrorItIsGrey() {
  Stage stage;
  const auto [blue, green, red] = stage.middle();
  QVERIFY(std::abs(blue - green) < 12.0 && std::abs(green - red) < 12.0);
  QVERIFY(red > 40.0);  // it is there
}

void RegistrationActorsTest::LesionsForcesAndTheOtherPlaceAppearAndGo() {
  Stage stage;
  stage.actors.show(*stage.drawable, stage.registration, {}, {});
  const int alone = stage.actor_count();
  LesionVerdict lesion;
  lesion.lesion = structure::kFirstLesion;
  lesion.covariance = 9e-6 * Eigen::Matrix3d::Identity();
  stage.registration.forces = {{0, Eigen::Vector3d(0, 0, 0.3)}, {1, Eigen::Vector3d(0.001, 0, 0)}};
  stage.registration.rivals = {
      {stage.registration.nodes_in_camera.rowwise() + Eigen::RowVector3d(0.01, 0, 0), 0.3}};
  stage.actors.show(*stage.drawable, stage.registration, {lesion}, {0, -1});
  // An ellipsoid, shaft and head of the strong force, the other place; the weak force is too short to be
  // seen.
  QCOMPARE(stage.actor_count(), alone + 4);
  lesion.covariance.setZero();  // not known
  stage.actors.show(*stage.drawable, stage.registration, {lesion}, {7, 7});
  QCOMPARE(stage.actor_count(), alone + 2);
  stage.actors.clear();
  QCOMPARE(stage.actor_count(), alone - 1);
}

void RegistrationActorsTest::WhatDoesNotHoldIsAGreyShapeAlone() {
  Stage stage;
  stage.expect(14e-3);
  const Eigen::Index count = stage.registration.expected.size();
  stage.registration.looks = {
      {structure::kFirstLesion, 6e-3, Eigen::VectorXd::LinSpaced(count, 3e-3, 6e-3), 6e-3, 6e-3}};
  LesionVerdict lesion;
  lesion.lesion = structure::kFirstLesion;
  lesion.covariance = 9e-6 * Eigen::Matrix3d::Identity();
  stage.actors.show(*stage.drawable, stage.registration, {}, {});
  const int alone = stage.actor_count();
  stage.actors.show(*stage.drawable, stage.registration, {lesion}, {-1, 0, false});
  QCOMPARE(stage.actor_count(), alone);
  const auto [blue, green, red] = stage.middle(0, false);
  QVERIFY(std::abs(blue - green) < 12.0 && std::abs(green - red) < 12.0);
}

void RegistrationActorsTest::NodesOfAnotherModelAreRefused() {
  Stage stage;
  stage.registration.nodes_in_camera.conservativeResize(3, 3);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, stage.actors.show(*stage.drawable, stage.registration, {}, {}));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::RegistrationActorsTest)
#include "registration_actors_test.moc"
