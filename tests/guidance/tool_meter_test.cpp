// SPDX-License-Identifier: GPL-3.0-or-later
// Distances from a tip to a block with a ball in it, whose truth is a line of arithmetic.
#include "glisson/guidance/tool_meter.h"

#include <QTest>
#include <cmath>

#include "box_patient.h"
#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::guidance;

namespace {

constexpr double kHalfZ = 0.025, kRadius = 0.006, kBefore = 0.13;  // metres
constexpr Label kLesion = structure::kFirstLesion;

CarriedSurface carried(const PatientModel& model, Label structure, const TriangleMesh& mesh) {
  return {structure, mesh, bind_points(model.mesh, mesh.vertices, false)};
}

}  // namespace

class ToolMeterTest : public QObject {
  Q_OBJECT
 private slots:
  void DistancesAreTheShortest();
  void TheOrganGoesAndTheTipStays();
  void InsideIsToldFromOutside();
  void OnlyNearTheSurfaceItTouches();
  void WhatIsNotThereCannotBeSaid();
  void NodesOfAnotherModelAreRefused();

 private:
  Points nodes(double before = kBefore) const {
    return model_.mesh.vertices.rowwise() + Eigen::RowVector3d(0.0, 0.0, before);
  }

  PatientModel model_ = box_patient();
  ToolMeter meter_{model_,
                   carried(model_, structure::kParenchyma, model_.surface.mesh),
                   {carried(model_, kLesion, ball_mesh(Eigen::Vector3d::Zero(), kRadius, 40))}};
};

void ToolMeterTest::DistancesAreTheShortest() {
  meter_.move(nodes());
  const ToolMeasures measures = meter_.measure({0.0, 0.0, kBefore - kHalfZ - 0.02}, kLesion);
  QVERIFY(std::abs(measures.to_surface - 0.02) < 1e-9);
  QVERIFY2(std::abs(measures.to_lesion - (0.02 + kHalfZ - kRadius)) < 5e-5,
           qPrintable(QString::number(measures.to_lesion)));
}

void ToolMeterTest::TheOrganGoesAndTheTipStays() {
  const Eigen::Vector3d tip(0.0, 0.0, kBefore - kHalfZ - 0.02);
  meter_.move(nodes(kBefore + 0.01));
  const ToolMeasures measures = meter_.measure(tip, kLesion);
  QVERIFY(std::abs(measures.to_surface - 0.03) < 1e-9);
  QVERIFY(std::abs(measures.to_lesion - (0.03 + kHalfZ - kRadius)) < 5e-5);
}

void ToolMeterTest::InsideIsToldFromOutside() {
  for (const double before : {kBefore, kBefore + 0.03}) {  // where the organ is now
    meter_.move(nodes(before));
    for (const double depth : {-0.02, -0.008, -1e-4, 1e-4, 0.008, 0.02}) {
      const double near = before - kHalfZ + depth, far = before + kHalfZ - depth;
      for (const Eigen::Vector3d& tip : {Eigen::Vector3d(0.0, 0.0, near), Eigen::Vector3d(0.01, 0.005, near),
                                         Eigen::Vector3d(-0.02, 0.0, near), Eigen::Vector3d(0.0, 0.0, far)}) {
        const ToolMeasures measures = meter_.measure(tip, 0);
        QCOMPARE(measures.is_inside, depth > 0.0);
        QVERIFY(std::abs(measures.to_surface - std::abs(depth)) < 1e-9);
      }
    }
  }
}

void ToolMeterTest::OnlyNearTheSurfaceItTouches() {
  meter_.move(nodes());
  const double surface = kBefore - kHalfZ;
  QVERIFY(!meter_.measure({0.01, 0.005, surface - 1.01 * kTouching}, 0).touched);
  for (const double beside : {-0.99 * kTouching, 0.0, 0.99 * kTouching}) {
    const auto touched = meter_.measure({0.01, 0.005, surface + beside}, 0).touched;
    QVERIFY(touched);
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      place += touched->weights[k] *
               model_.surface.mesh.vertex(model_.surface.mesh.triangles(touched->triangle, k));
    QVERIFY((place + Eigen::Vector3d(0.0, 0.0, kBefore) - Eigen::Vector3d(0.01, 0.005, surface)).norm() <
            1e-9);
  }
}

void ToolMeterTest::WhatIsNotThereCannotBeSaid() {
  meter_.move(nodes());
  QVERIFY(std::isnan(meter_.measure({0.0, 0.0, 0.1}, 0).to_lesion));
  QVERIFY(std::isnan(meter_.measure({0.0, 0.0, 0.1}, kLesion + 1).to_lesion));
  const ToolMeasures nowhere = meter_.measure({0.0, 0.0, std::nan("")}, kLesion);
  QVERIFY(std::isnan(nowhere.to_surface) && std::isnan(nowhere.to_lesion) && !nowhere.touched);
  QVERIFY(!nowhere.is_inside);
}

void ToolMeterTest::NodesOfAnotherModelAreRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, meter_.move(Points::Zero(3, 3)));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, ToolMeter(model_, CarriedSurface(), {}));
}

QTEST_APPLESS_MAIN(ToolMeterTest)
#include "tool_meter_test.moc"
