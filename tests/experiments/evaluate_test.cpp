// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/evaluate.h"

#include <QtTest>

#include <cmath>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"

using namespace glisson;

namespace {

/// Five tetrahedra in a unit decimetre: the inner one is a lesion.
PatientModel small_model() {
  PatientModel model;
  model.mesh.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i)
    model.mesh.vertices.row(i) = 0.1 * Eigen::RowVector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  model.mesh.tetrahedra.resize(5, 4);
  model.mesh.tetrahedra << 0, 1, 2, 4, 3, 2, 1, 7, 5, 1, 4, 7, 6, 4, 2, 7, 1, 2, 4, 7;
  orient_tetrahedra(model.mesh);
  model.mesh.labels = {structure::kParenchyma, structure::kParenchyma, structure::kParenchyma,
                       structure::kParenchyma, structure::kFirstLesion};
  model.surface = boundary_surface(model.mesh);
  return model;
}

}  // namespace

class EvaluateTest : public QObject {
  Q_OBJECT
 private slots:
  void AShiftIsTheErrorEverywhere();
  void WithoutLesionsTheTargetErrorIsUnknown();
  void ARigidMotionLeavesNothingAfterTheBestRigidAlignment();
  void TheTruthOfAnotherMeshIsRefused();
};

void EvaluateTest::AShiftIsTheErrorEverywhere() {
  const PatientModel model = small_model();
  const Points moved = model.mesh.vertices.rowwise() + Eigen::RowVector3d(0.003, 0.0, -0.004);
  const Figures figures = experiments::target_errors(model, moved, model.mesh.vertices, "truth");
  for (const char* key : {"tre_volume_mean_mm", "tre_volume_max_mm", "tre_surface_mean_mm",
                          "tre_target_mean_mm", "tre_target_max_mm"})
    QVERIFY2(std::abs(figures.at(key) - 5.0) < 1e-9, key);
}

void EvaluateTest::WithoutLesionsTheTargetErrorIsUnknown() {
  PatientModel model = small_model();
  model.mesh.labels.clear();
  QVERIFY(std::isnan(experiments::target_errors(model, model.mesh.vertices, model.mesh.vertices, "truth")
                         .at("tre_target_mean_mm")));
}

void EvaluateTest::ARigidMotionLeavesNothingAfterTheBestRigidAlignment() {
  const PatientModel model = small_model();
  const CameraFromCt motion{Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
                            {0.1, 0.2, 0.3}};
  const Figures figures =
      experiments::motion_figures(model, model.mesh.vertices, motion.apply(model.mesh.vertices));
  QVERIFY(figures.at("rigid_best_mean_mm") < 1e-9);
  QVERIFY(figures.at("motion_mean_mm") > 100.0);
}

void EvaluateTest::TheTruthOfAnotherMeshIsRefused() {
  const PatientModel model = small_model();
  QVERIFY_EXCEPTION_THROWN(
      experiments::target_errors(model, model.mesh.vertices, Points::Zero(3, 3), "truth.xyz"), InputError);
}

QTEST_APPLESS_MAIN(EvaluateTest)
#include "evaluate_test.moc"
