// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of a ball in a block, whose truth is a line of arithmetic.
#include <Eigen/Geometry>
#include <QTest>
#include <cmath>

#include "box_patient.h"
#include "glisson/core/error.h"
#include "glisson/guidance/lesion_meter.h"

using namespace glisson;
using namespace glisson::guidance;

namespace {

// Half sides of the block, and the ball in it, metres; the camera stands kBefore before the block's middle.
constexpr double kHalfZ = 0.025, kRadius = 0.006, kBefore = 0.13;
const Eigen::Vector3d kCentre(0.03, 0.0, 0.0);

CarriedSurface carried(const PatientModel& model, Label structure, const TriangleMesh& mesh) {
  return {structure, mesh, bind_points(model.mesh, mesh.vertices, false)};
}

}  // namespace

class LesionMeterTest : public QObject {
  Q_OBJECT
 private slots:
  void DepthsAreThoseOfABallInABlock();
  void TheShortestWayEndsOnBoth();
  void DepthGoesWithTheDeformation();
  void MotionOfTheWholeChangesNoShortestWay();
  void AMarkedPlaceGoesWithItsTissue();
  void ALesionThatComesFirstHasNoDepth();
  void WhatIsNotThereCannotBeMeasured();
  void NodesOfAnotherModelAreRefused();
  void OnlyWhatCanBeSaidIsAFigure();

 private:
  LesionMeter meter() const {
    return {model_,
            carried(model_, structure::kParenchyma, model_.surface.mesh),
            {carried(model_, structure::kFirstLesion, ball_mesh(kCentre, kRadius, 40))}};
  }
  Points nodes() const { return model_.mesh.vertices.rowwise() + Eigen::RowVector3d(0.0, 0.0, kBefore); }

  PatientModel model_ = box_patient();
};

void LesionMeterTest::DepthsAreThoseOfABallInABlock() {
  LesionMeter measured = meter();
  measured.move(nodes());
  const LesionMeasures measures = measured.measure(structure::kFirstLesion);
  QVERIFY(std::abs(measures.shortest - (kHalfZ - kRadius)) < 1e-6);
  const Eigen::Vector3d centre = kCentre + Eigen::Vector3d(0.0, 0.0, kBefore);
  const double entry = centre.norm() * (kBefore - kHalfZ) / kBefore;
  const double along = centre.norm() - kRadius - entry;
  QVERIFY2(std::abs(measures.along_sight - along) < 5e-5, qPrintable(QString::number(measures.along_sight)));
  QVERIFY(std::isnan(measures.from_place));
}

void LesionMeterTest::TheShortestWayEndsOnBoth() {
  LesionMeter measured = meter();
  measured.move(nodes());
  const LesionMeasures measures = measured.measure(structure::kFirstLesion);
  const Eigen::Vector3d centre = kCentre + Eigen::Vector3d(0.0, 0.0, kBefore);
  QVERIFY(std::abs((measures.lesion_end - centre).norm() - kRadius) < 1e-6);
  QVERIFY(std::abs(std::abs(measures.surface_end.z() - kBefore) - kHalfZ) < 1e-6);
  QVERIFY(std::abs((measures.lesion_end - measures.surface_end).norm() - measures.shortest) < 1e-9);
}

void LesionMeterTest::DepthGoesWithTheDeformation() {
  LesionMeter measured = meter();
  Points squeezed = model_.mesh.vertices;
  squeezed.col(2) *= 0.8;  // along z the ball, too, is a fifth thinner
  squeezed.col(2).array() += kBefore;
  measured.move(squeezed);
  QVERIFY(std::abs(measured.measure(structure::kFirstLesion).shortest - 0.8 * (kHalfZ - kRadius)) < 1e-6);
}

void LesionMeterTest::MotionOfTheWholeChangesNoShortestWay() {
  LesionMeter measured = meter();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  measured.move((model_.mesh.vertices * turn.transpose()).rowwise() + Eigen::RowVector3d(0.01, -0.02, 0.2));
  QVERIFY(std::abs(measured.measure(structure::kFirstLesion).shortest - (kHalfZ - kRadius)) < 1e-6);
}

void LesionMeterTest::AMarkedPlaceGoesWithItsTissue() {
  LesionMeter measured = meter();
  measured.move(nodes());
  const double z = kBefore - kHalfZ;
  const Eigen::Vector3d place(-0.02, 0.01, z);
  const auto marked = measured.place_on(place / z);
  QVERIFY(marked.has_value());
  QVERIFY((measured.position(*marked) - place).norm() < 1e-9);
  const double distance = (place - kCentre - Eigen::Vector3d(0.0, 0.0, kBefore)).norm() - kRadius;
  QVERIFY(std::abs(measured.measure(structure::kFirstLesion, marked).from_place - distance) < 5e-5);
  const Eigen::RowVector3d shift(0.004, -0.003, 0.01);
  measured.move(nodes().rowwise() + shift);
  QVERIFY((measured.position(*marked) - place - shift.transpose()).norm() < 1e-9);
  QVERIFY(std::abs(measured.measure(structure::kFirstLesion, marked).from_place - distance) < 5e-5);
  QVERIFY(!measured.place_on({5.0, 0.0, 1.0}));
}

void LesionMeterTest::ALesionThatComesFirstHasNoDepth() {
  LesionMeter measured(
      model_, carried(model_, structure::kParenchyma, model_.surface.mesh),
      {carried(model_, structure::kFirstLesion, ball_mesh({0.0, 0.0, -kHalfZ}, kRadius, 40))});
  measured.move(nodes());
  QCOMPARE(measured.measure(structure::kFirstLesion).along_sight, 0.0);
}

void LesionMeterTest::WhatIsNotThereCannotBeMeasured() {
  LesionMeter measured = meter();
  measured.move(nodes());
  const LesionMeasures measures = measured.measure(structure::kFirstLesion + 3);
  QVERIFY(std::isnan(measures.shortest) && std::isnan(measures.along_sight));
  const SurfacePlace elsewhere{1 << 20, Eigen::Vector3d::Constant(1.0 / 3.0)};
  QVERIFY(!measured.has(SurfacePlace()) && !measured.has(elsewhere));
  QVERIFY(std::isnan(measured.measure(structure::kFirstLesion, elsewhere).from_place));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, measured.position(elsewhere));
}

void LesionMeterTest::NodesOfAnotherModelAreRefused() {
  LesionMeter measured = meter();
  QVERIFY_THROWS_EXCEPTION(PreconditionError, measured.move(Points::Ones(3, 3)));
}

void LesionMeterTest::OnlyWhatCanBeSaidIsAFigure() {
  LesionMeasures measures;
  measures.lesion = structure::kFirstLesion;
  QVERIFY(measure_figures(measures).empty());
  measures.along_sight = 0.015625;
  measures.from_place = 0.5;
  QCOMPARE(measure_figures(measures),
           (Figures{{"lesion_1_depth_along_sight_mm", 15.625}, {"lesion_1_from_mark_mm", 500.0}}));
  measures.shortest = 0.25;
  QCOMPARE(measure_figures(measures).at("lesion_1_depth_shortest_mm"), 250.0);
}

QTEST_APPLESS_MAIN(LesionMeterTest)
#include "lesion_meter_test.moc"
