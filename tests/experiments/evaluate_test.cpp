// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/evaluate.h"

#include <QTest>

#include <cmath>

#include "evaluate_trees.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/rigid.h"
#include "glisson/insilico/film.h"
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
  void ACloudIsComparedWithASurfaceOrADepthMap();
  void NothingThatIsFoundHasNoError();
  void NodesAreReadFromAListOrAMesh();
  void ASurfaceIsComparedInBothDirections();
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
  QVERIFY_THROWS_EXCEPTION(
      InputError, experiments::target_errors(model, model.mesh.vertices, Points::Zero(3, 3), "truth.xyz"));
}

void EvaluateTest::ACloudIsComparedWithASurfaceOrADepthMap() {
  const TemporaryFolder folder;
  Camera left;
  left.width = 32, left.height = 24;
  left.matrix << 40.0, 0, 16.0, 0, 40.0, 12.0, 0, 0, 1;
  LabelledCloud cloud;  // 2 mm before a plane at 100 mm
  cloud.points.resize(5, 3);
  for (int i = 0; i < 5; ++i) cloud.points.row(i) << 0.003 * i - 0.006, 0.002 * i - 0.004, 0.098;
  insilico::write_depth(folder.path() / "d.pfm", std::vector<float>(32 * 24, 0.1F), 32, 24);
  TriangleMesh plane;
  plane.vertices.resize(4, 3);
  plane.vertices << -1, -1, 0.1, 1, -1, 0.1, 1, 1, 0.1, -1, 1, 0.1;
  plane.triangles.resize(2, 3);
  plane.triangles << 0, 1, 2, 0, 2, 3;
  write_triangle_mesh(folder.path() / "p.ply", plane, LengthUnit::millimetre);
  for (const char* truth : {"d.pfm", "p.ply"}) {
    const Figures figures =
        experiments::cloud_figures(cloud, left, folder.path() / truth, LengthUnit::millimetre);
    QVERIFY(std::abs(figures.at("cloud_error_median_mm") - 2.0) < 0.1);
    QVERIFY(std::abs(figures.at("cloud_bias_mm") + 2.0) < 0.1);
    QCOMPARE(figures.at("cloud_points_without_truth"), 0.0);
  }
  left.width = 64;
  QVERIFY_THROWS_EXCEPTION(
      InputError, experiments::cloud_figures(cloud, left, folder.path() / "d.pfm", LengthUnit::millimetre));
}

void EvaluateTest::NothingThatIsFoundHasNoError() {
  VesselTree truth;
  truth.structure = structure::kPortalVein;
  truth.root = 0;
  truth.nodes.resize(3, 3);
  truth.nodes << 0, 0, 0, 0, 0, 0.01, 0, 0, 0.02;
  truth.radii = {3e-3, 3e-3, 3e-3};
  truth.beams = {{0, 1}, {1, 2}};
  const auto everywhere = [](const Eigen::Vector3d&) { return true; };
  const experiments::TreeScore none = experiments::score_tree(truth, {}, 1e-3, everywhere);
  QVERIFY(std::isnan(none.mean) && std::isnan(none.worst));
  QVERIFY(none.thick == 1 && none.thick_found == 0);
  QVERIFY(experiments::score_tree(truth, {truth}, 1e-3, everywhere).mean < 1e-9);

  const TemporaryFolder folder;
  Camera left;
  left.width = 32, left.height = 24;
  left.matrix << 40.0, 0, 16.0, 0, 40.0, 12.0, 0, 0, 1;
  LabelledCloud cloud;
  cloud.points.resize(2, 3);
  cloud.points << 0, 0, 0.1, 0.001, 0, 0.1;
  insilico::write_depth(folder.path() / "d.pfm", std::vector<float>(32 * 24, 0.0F), 32, 24);
  const Figures figures =
      experiments::cloud_figures(cloud, left, folder.path() / "d.pfm", LengthUnit::millimetre);
  QCOMPARE(figures.at("cloud_points_without_truth"), 2.0);
  for (const char* key :
       {"cloud_error_median_mm", "cloud_error_mean_mm", "cloud_error_p95_mm", "cloud_bias_mm"})
    QVERIFY2(std::isnan(figures.at(key)), key);
}

void EvaluateTest::NodesAreReadFromAListOrAMesh() {
  const TemporaryFolder folder;
  const PatientModel model = small_model();
  write_tet_mesh(folder.path() / "m.vtu", model.mesh, LengthUnit::millimetre);
  write_triangle_mesh(folder.path() / "s.ply", model.surface.mesh, LengthUnit::millimetre);
  write_file_atomically(folder.path() / "n.xyz", "1 2 3\n4 5 6\n");
  const auto read = [&](const char* name) {
    return experiments::read_true_nodes(folder.path() / name, LengthUnit::millimetre);
  };
  QVERIFY((read("m.vtu") - model.mesh.vertices).cwiseAbs().maxCoeff() < 1e-6);
  QCOMPARE(read("s.ply").rows(), model.surface.mesh.vertices.rows());
  QVERIFY((read("n.xyz").row(1) - Eigen::RowVector3d(0.004, 0.005, 0.006)).norm() < 1e-12);
}

void EvaluateTest::ASurfaceIsComparedInBothDirections() {
  const TriangleMesh surface = small_model().surface.mesh;
  TriangleMesh shifted = surface;
  for (const auto& [key, value] : experiments::surface_figures(surface, surface))
    QVERIFY2(value < 1e-6, key.c_str());
  shifted.vertices.col(0).array() += 0.002;
  const Figures figures = experiments::surface_figures(surface, shifted);
  QVERIFY(figures.at("surface_to_truth_mean_mm") > 0.1 && figures.at("truth_to_surface_mean_mm") > 0.1);
  QVERIFY(std::abs(figures.at("truth_to_surface_max_mm") - 2.0) < 0.01);
}

QTEST_APPLESS_MAIN(EvaluateTest)
#include "evaluate_test.moc"
