// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkRenderer.h>

#include <QTest>

#include "box_patient.h"
#include "glisson/core/error.h"
#include "glisson/ui/scene/offscreen_renderer.h"
#include "glisson/ui/scene/patient_scene.h"
#include "glisson/ui/scene/picture_image.h"
#include "glisson/ui/scene/seen_point.h"
#include "glisson/ui/scene/surface_shapes.h"

namespace glisson {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

Picture draw(const scene::PatientScene& patient) {
  scene::OffscreenRenderer offscreen(kWidth, kHeight);
  return offscreen.render(patient.renderer());
}

int pixels_that_differ(const Picture& a, const Picture& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.bytes->size(); i += 3)
    count += std::equal(a.bytes->begin() + static_cast<long>(i), a.bytes->begin() + static_cast<long>(i) + 3,
                        b.bytes->begin() + static_cast<long>(i))
                 ? 0
                 : 1;
  return count;
}

/// At the lesion: in the middle of the box, 6 mm in radius.
std::optional<Eigen::Vector3d> seen_at_lesion(const scene::PatientScene& patient,
                                              const Eigen::Vector3d& off) {
  const auto place = patient.view_point(Eigen::Vector3d(0.03, 0.0, 0.0) + off, kAspect);
  return scene::seen_point(patient.renderer(), patient.surface_actors(), place->x(), place->y(), kAspect);
}

}  // namespace

class PatientSceneTest : public QObject {
  Q_OBJECT
 private slots:
  void AnteriorViewHasThePatientsRightOnTheLeft();
  void PickedPointProjectsBackToWhereItWasPicked();
  void AClickSeesThroughTheLiverToWhatIsSolid();
  void AHiddenStructureIsNotSeen();
  void ASliceHidesWhatLiesBehindIt();
  void DeformedNodesMoveSurfacesAndPicks();
  void HiddenStructureIsNotDrawn();
  void SliceIsDrawnUnmirrored();
  void CloudAndMarkersAppearAndGo();
  void TheLiverFillsTheViewWhateverHangsOnIt();
  void TubesFollowTheirRadii();
  void SimplifiedKeepsShape();
  void WrongNodesAreRefused();
  void WrongSlicePictureIsRefused();
};

void PatientSceneTest::AnteriorViewHasThePatientsRightOnTheLeft() {
  scene::PatientScene patient;
  patient.set_model(box_patient());
  patient.look_from(scene::ViewFrom::anterior);
  const auto right = patient.view_point({-0.06, 0, 0}, kAspect),
             left = patient.view_point({0.06, 0, 0}, kAspect);
  const auto head = patient.view_point({0, 0, 0.025}, kAspect),
             feet = patient.view_point({0, 0, -0.025}, kAspect);
  QVERIFY(right && left && head && feet);
  QVERIFY(right->x() < left->x());
  QVERIFY(head->y() < feet->y());
}

void PatientSceneTest::PickedPointProjectsBackToWhereItWasPicked() {
  scene::PatientScene patient;
  patient.set_model(box_patient());
  for (const auto from : {scene::ViewFrom::anterior, scene::ViewFrom::right, scene::ViewFrom::inferior}) {
    patient.look_from(from);
    const auto p = patient.surface_point(0.52, 0.47, kAspect);
    QVERIFY(p.has_value());
    const auto back = patient.view_point(*p, kAspect);
    QVERIFY(back && (*back - Eigen::Vector2d(0.52, 0.47)).norm() < 1e-6);
  }
  patient.look_from(scene::ViewFrom::anterior);
  QVERIFY(std::abs(patient.surface_point(0.5, 0.5, kAspect)->y() + 0.04) <
          1e-9);  // the anterior face, not the back
  QVERIFY(!patient.surface_point(0.01, 0.01, kAspect).has_value());
}

void PatientSceneTest::AClickSeesThroughTheLiverToWhatIsSolid() {
  scene::PatientScene patient;
  patient.set_model(box_patient());
  patient.look_from(scene::ViewFrom::superior);  // no vessel in the way
  const auto lesion = seen_at_lesion(patient, {0, 0, 0});
  QVERIFY(lesion && (*lesion - Eigen::Vector3d(0.03, 0.0, 0.006)).norm() < 1.5e-3);
  const auto beside = seen_at_lesion(patient, {0.0, 0.012, 0.025});
  QVERIFY(beside && (*beside - Eigen::Vector3d(0.03, 0.012, 0.025)).norm() < 1e-6);  // the liver's top
  QVERIFY(!scene::seen_point(patient.renderer(), patient.surface_actors(), 0.01, 0.01, kAspect));
  patient.set_opacity(structure::kParenchyma, 1.0);
  const auto skin = seen_at_lesion(patient, {0, 0, 0});
  QVERIFY(skin && std::abs(skin->z() - 0.025) < 1e-6);
}

void PatientSceneTest::AHiddenStructureIsNotSeen() {
  scene::PatientScene patient;
  patient.set_model(box_patient());
  patient.look_from(scene::ViewFrom::superior);
  patient.set_visible(structure::kFirstLesion, false);
  const auto seen = seen_at_lesion(patient, {0, 0, 0});
  QVERIFY(seen && std::abs(seen->z() - 0.025) < 1e-6);
  patient.set_visible(structure::kParenchyma, false);
  QVERIFY(!seen_at_lesion(patient, {0, 0, 0}));
}

void PatientSceneTest::ASliceHidesWhatLiesBehindIt() {
  scene::PatientScene patient;
  patient.set_model(box_patient());
  patient.look_from(scene::ViewFrom::superior);
  VolumeGrid grid;
  grid.size = {120, 80, 50};
  grid.origin_mm = {-59.5, -39.5, -24.5};
  Image image{grid, Modality::ct, nullptr, {}};
  image.voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(grid.voxel_count()));
  const auto show = [&](double z) {
    const auto slice = scene::slice_geometry(grid, scene::Plane::axial, Point<CtFrame>(0.0, 0.0, z));
    patient.set_slice(slice, scene::slice_picture(image, nullptr, slice, {}));
  };
  show(0.015);
  const auto skin = seen_at_lesion(patient, {0, 0, 0});
  QVERIFY(skin && std::abs(skin->z() - 0.025) < 1e-6);  // the skin lies before the slice
  patient.set_visible(structure::kParenchyma, false);
  const auto slice = seen_at_lesion(patient, {0, 0, 0});
  QVERIFY(slice && std::abs(slice->z() - 0.015) < 1e-6);
  show(-0.015);
  const auto lesion = seen_at_lesion(patient, {0, 0, 0});
  QVERIFY(lesion && std::abs(lesion->z() - 0.006) < 5e-4);
}

void PatientSceneTest::DeformedNodesMoveSurfacesAndPicks() {
  const auto model = std::make_shared<PatientModel>(box_patient());
  scene::PatientScene patient;
  patient.set_model(*model);
  patient.look_from(scene::ViewFrom::anterior);
  const Picture rest = draw(patient);
  Points nodes = model->mesh.vertices;
  nodes.col(1).array() += 0.02;
  patient.set_nodes(nodes);
  QVERIFY(std::abs(patient.surface_point(0.5, 0.5, kAspect)->y() + 0.02) < 1e-9);
  QVERIFY(pixels_that_differ(rest, draw(patient)) > 200);
  patient.set_nodes(Points());
  QCOMPARE(pixels_that_differ(rest, draw(patient)), 0);
}

void PatientSceneTest::HiddenStructureIsNotDrawn() {
  scene::PatientScene patient;
  const Picture empty = draw(patient);
  patient.set_model(box_patient());
  patient.set_landmarks({});
  patient.look_from(scene::ViewFrom::anterior);
  const Picture all = draw(patient);
  QVERIFY(pixels_that_differ(empty, all) > 5000);
  patient.set_visible(structure::kPortalVein, false);
  QVERIFY(pixels_that_differ(all, draw(patient)) > 100);
  for (const Label label : {structure::kParenchyma, structure::kHepaticVeins, structure::kFirstLesion})
    patient.set_visible(label, false);
  QCOMPARE(pixels_that_differ(empty, draw(patient)), 0);
  if (qEnvironmentVariableIsSet("GLISSON_SAVE_PICTURES"))
    scene::view_as_image(all).save(qEnvironmentVariable("GLISSON_SAVE_PICTURES") + "/patient.png");
}

void PatientSceneTest::SliceIsDrawnUnmirrored() {
  scene::PatientScene patient;
  scene::SliceGeometry slice;
  slice.plane = scene::Plane::coronal;
  slice.width = 40;
  slice.height = 30;
  slice.right = {1e-3, 0, 0};
  slice.down = {0, 0, -1e-3};
  slice.origin = {-0.02, 0, 0.015};
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(3 * 40 * 30, std::uint8_t{40});
  for (int v = 0; v < 8; ++v)  // a red mark in the upper left: the patient's right, superior
    for (int u = 0; u < 8; ++u) (*bytes)[static_cast<std::size_t>(3 * (v * 40 + u) + 2)] = 255;
  patient.set_slice(slice, {40, 30, 3, bytes});
  patient.look_from(scene::ViewFrom::anterior);
  const Picture picture = draw(patient);
  const auto red_at = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2d view = *patient.view_point(p, kAspect);
    const auto u = static_cast<int>(view.x() * kWidth), v = static_cast<int>(view.y() * kHeight);
    return int((*picture.bytes)[static_cast<std::size_t>(3 * (v * kWidth + u) + 2)]);
  };
  QVERIFY(red_at({-0.017, 0, 0.012}) > 200);
  QVERIFY(red_at({0.016, 0, 0.012}) < 100);
  QVERIFY(red_at({-0.017, 0, -0.011}) < 100);
  patient.set_slice(slice, {});
  scene::PatientScene empty;
  empty.look_from(scene::ViewFrom::anterior);
  QCOMPARE(pixels_that_differ(draw(empty), draw(patient)), 0);
}

void PatientSceneTest::CloudAndMarkersAppearAndGo() {
  scene::PatientScene patient;
  patient.set_model(box_patient());
  patient.look_from(scene::ViewFrom::anterior);
  const Picture before = draw(patient);
  LabelledCloud cloud;
  cloud.points = Points::Random(50, 3) * 0.02;
  cloud.points.col(1).setConstant(-0.06);
  patient.set_cloud(cloud);
  const Picture with_cloud = draw(patient);
  QVERIFY(pixels_that_differ(before, with_cloud) > 100);
  patient.set_markers({{Eigen::Vector3d(0.0, -0.05, 0.0), structure::kArtery, 4e-3}});
  QVERIFY(pixels_that_differ(with_cloud, draw(patient)) > 20);
  patient.set_cloud({});
  patient.set_markers({});
  QCOMPARE(pixels_that_differ(before, draw(patient)), 0);
}

void PatientSceneTest::TheLiverFillsTheViewWhateverHangsOnIt() {
  PatientModel model = box_patient();
  model.surfaces.push_back(model.surfaces.back());
  model.surfaces.back().structure = structure::kVenaCava;
  model.surfaces.back().mesh.vertices.col(2).array() += 0.3;
  scene::PatientScene patient;
  patient.set_model(model);
  const auto width = [&] {
    const auto right = patient.view_point({-0.06, 0, 0}, kAspect),
               left = patient.view_point({0.06, 0, 0}, kAspect);
    return right && left ? std::abs(left->x() - right->x()) : 0.0;
  };
  patient.look_from(scene::ViewFrom::anterior);
  const double beside_all = width();
  patient.look_from(scene::ViewFrom::anterior, scene::InView::liver);
  const double alone = width();
  QVERIFY2(alone > 2.0 * beside_all && alone < 1.0, qPrintable(QString::number(alone)));
  patient.keep_in_view();
  QCOMPARE(width(), alone);
}

void PatientSceneTest::TubesFollowTheirRadii() {
  VesselTree tree;
  tree.nodes.resize(4, 3);
  tree.nodes << 0, 0, 0, 0.02, 0, 0, 0.04, 0, 0, 0.06, 0, 0;
  tree.radii.assign(4, 3e-3);
  tree.beams = {{0, 1}, {1, 2}, {2, 3}};
  const TriangleMesh tube = scene::tube_mesh(tree, 32);
  QVERIFY(std::abs(volume(tube) / (M_PI * 9e-6 * 0.06) - 1.0) < 0.02);  // a cylinder, closed by its caps
  QVERIFY(std::abs(tube.vertices.col(1).maxCoeff() - 3e-3) < 1e-5);
  QCOMPARE(scene::tube_mesh({}).triangle_count(), 0);
}

void PatientSceneTest::SimplifiedKeepsShape() {
  const TriangleMesh fine = ball_mesh({0, 0, 0}, 0.05, 60);
  const TriangleMesh coarse = scene::simplified(fine, 2000);
  QVERIFY(coarse.triangle_count() <= 2100 && coarse.triangle_count() > 1000);
  QVERIFY(std::abs(volume(coarse) / volume(fine) - 1.0) < 0.01);
  QCOMPARE(scene::simplified(fine, 1000000).triangle_count(), fine.triangle_count());
}

void PatientSceneTest::WrongNodesAreRefused() {
  scene::PatientScene patient;
  patient.set_model(box_patient());
  QVERIFY_THROWS_EXCEPTION(PreconditionError, patient.set_nodes(Points::Zero(2, 3)));
}

void PatientSceneTest::WrongSlicePictureIsRefused() {
  scene::PatientScene patient;
  scene::SliceGeometry slice;
  slice.width = slice.height = 4;
  const auto bytes = std::make_shared<std::vector<std::uint8_t>>(27);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, patient.set_slice(slice, {3, 3, 3, bytes}));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::PatientSceneTest)
#include "patient_scene_test.moc"
