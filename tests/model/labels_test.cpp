// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <map>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"
#include "shapes.h"

using namespace glisson;

namespace {

const Eigen::Vector3d kCentre(70, 60, 60);  // mm, in the voxels' own axes

/// Distance from a segment, millimetres.
double from_segment(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

/// An ellipsoid of a liver (half axes 60, 45, 40 mm) with a Y of a portal vein, two lesions, a vena cava that
/// touches it from behind, and a speck of wrong label far away.
Label label_at(const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = (p - kCentre).cwiseQuotient(Eigen::Vector3d(60, 45, 40));
  if ((p - Eigen::Vector3d(90, 60, 60)).norm() < 11) return structure::kFirstLesion;
  if ((p - Eigen::Vector3d(40, 50, 65)).norm() < 7) return structure::kFirstLesion + 1;
  const Eigen::Vector3d in(70, 60, 22), fork(70, 60, 55), left(40, 62, 75), right(98, 62, 82);
  if (from_segment(p, in, fork) < 5 || from_segment(p, fork, left) < 3.5 ||
      from_segment(p, fork, right) < 3.5)
    return structure::kPortalVein;
  if (std::hypot(p.x() - 70, p.y() - 112) < 9) return structure::kVenaCava;
  if (q.norm() < 1.0) return structure::kParenchyma;
  if ((p - Eigen::Vector3d(134, 8, 8)).norm() < 4) return structure::kParenchyma;
  return structure::kBackground;
}

/// The phantom on a grid, however its axes lie in the patient.
LabelMap phantom(const Eigen::Matrix3d& direction, const Eigen::Vector3d& spacing) {
  VolumeGrid grid;
  grid.spacing_mm = spacing;
  grid.size = (Eigen::Vector3d(140, 128, 120).cwiseQuotient(spacing)).array().ceil().cast<int>();
  grid.direction = direction;
  grid.origin_mm << -30, 45, 1000;
  std::vector<Label> dense;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        dense.push_back(label_at(Eigen::Vector3d(i, j, k).cwiseProduct(spacing)));
  LabelMap map;
  map.voxels = LabelVolume(grid, dense);
  return map;
}

const Eigen::Vector3d kSpacing(1.5, 1.5, 2.0);

Eigen::Vector3d in_ct(const LabelMap& map, const Eigen::Vector3d& p_mm) {
  return 1e-3 * (map.voxels.grid().origin_mm + map.voxels.grid().direction * p_mm);
}

model::ModelOptions quick() {
  model::ModelOptions options;
  options.mesh.target_vertices = 450;
  options.target_beams = 25;
  return options;
}

bool says(const model::ModelReport& report, const std::string& code) {
  for (const std::string& note : report.notes)
    if (note.rfind(code, 0) == 0) return true;
  return false;
}

}  // namespace

class LabelsTest : public QObject {
  Q_OBJECT
 private slots:
  void AVesselOutsideTheLiverIsLeftOut();
  void initTestCase();
  void MeshIsGood();
  void MeshFillsTheLabels();
  void LesionsAreSubdomains();
  void ElementsAreFinerAtLesionsAndVesselsOnRequest();
  void PortalTreeStartsAtItsEntrance();
  void FineSurfacesFaceOutwards();
  void SpecksAreReported();
  void VenaCavaTouchesWhereItTouches();
  void EveryOrientationGivesTheSameModel();
  void SameInputGivesTheSameBits();
  void GivenRootIsTaken();
  void ARootThatIsGivenTwiceMakesOneTree();
  void GivenRootFarAwayIsRefused();
  void NoLiverIsRefused();
  void TwoLargePiecesAreRefused();
  void CancelGivesNothing();
  void OptionsOutOfRangeAreRefused();

 private:
  LabelMap map_;
  model::BuiltModel built_;
};

void LabelsTest::initTestCase() {
  map_ = phantom(Eigen::Matrix3d::Identity(), kSpacing);
  built_ = *model::build_from_labels(map_, quick(), RunContext());
  for (const std::string& note : built_.report.notes) qInfo("%s", note.c_str());
}

void LabelsTest::MeshIsGood() {
  check_tetrahedra(built_.model.mesh, "mesh");
  QVERIFY(std::abs(built_.report.quality.vertices - 450) <= 45);
  QCOMPARE(built_.report.quality.vertices, built_.model.mesh.vertex_count());
  QVERIFY2(built_.report.quality.min_dihedral_deg >= 10.0,
           qPrintable(QString::number(built_.report.quality.min_dihedral_deg)));
  QVERIFY(is_closed(built_.model.surface.mesh));
}

void LabelsTest::MeshFillsTheLabels() {
  const double ellipsoid = 4.0 / 3.0 * std::numbers::pi * 0.06 * 0.045 * 0.04;
  QVERIFY2(std::abs(volume(built_.model.mesh) / ellipsoid - 1.0) < 0.06,
           qPrintable(QString::number(volume(built_.model.mesh) / ellipsoid)));
  QVERIFY(built_.report.quality.organ_fit);
  QVERIFY(std::abs(built_.report.quality.organ_fit->volume_error) < 0.06);
  QVERIFY(built_.report.quality.organ_fit->fine_to_mesh_mean_mm < 1.5);
  QVERIFY(built_.report.quality.organ_fit->vertices_to_fine_mean_mm <= 0.25);
  const Eigen::Vector3d middle = built_.model.mesh.vertices.colwise().mean().transpose();
  QVERIFY((middle - in_ct(map_, kCentre)).norm() < 6e-3);
}

void LabelsTest::LesionsAreSubdomains() {
  const auto centres = lesion_centres(built_.model);
  QCOMPARE(centres.size(), std::size_t{2});
  QVERIFY((centres[0].second - in_ct(map_, {90, 60, 60})).norm() < 2e-3);
  QVERIFY((centres[1].second - in_ct(map_, {40, 50, 65})).norm() < 2e-3);
  double inside[2] = {0.0, 0.0};
  const Eigen::VectorXd volumes = tetrahedron_volumes(built_.model.mesh);
  for (int t = 0; t < built_.model.mesh.tetrahedron_count(); ++t)
    for (int lesion = 0; lesion < 2; ++lesion)
      if (built_.model.mesh.labels[t] == structure::kFirstLesion + lesion) inside[lesion] += volumes[t];
  const double radii[2] = {0.011, 0.007};  // 5.6 and 1.4 ml
  for (int lesion = 0; lesion < 2; ++lesion) {
    const auto label = static_cast<std::size_t>(structure::kFirstLesion + lesion);
    const double labelled =
        1e-9 * static_cast<double>(map_.voxels.histogram()[label]) * map_.voxels.grid().voxel_volume_mm3();
    QVERIFY2(std::abs(inside[lesion] / labelled - 1.0) < 0.02,
             qPrintable(QString::number(inside[lesion] / labelled)));
    // The closed form, of which the voxels lose some.
    const double truth = 4.0 / 3.0 * std::numbers::pi * std::pow(radii[lesion], 3);
    QVERIFY2(std::abs(inside[lesion] / truth - 1.0) < 0.06,
             qPrintable(QString::number(inside[lesion] / truth)));
  }
}

void LabelsTest::ElementsAreFinerAtLesionsAndVesselsOnRequest() {
  // Mean edge of the elements that lie there over that of the others.
  const auto ratio = [&](const TetMesh& mesh, const auto& near) {
    double sum[2] = {0.0, 0.0};
    int count[2] = {0, 0};
    for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (int k = 0; k < 4; ++k) middle += 0.25 * mesh.vertex(mesh.tetrahedra(t, k));
      const bool is_near = near(1e3 * middle - map_.voxels.grid().origin_mm);
      for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b, ++count[is_near])
          sum[is_near] += (mesh.vertex(mesh.tetrahedra(t, a)) - mesh.vertex(mesh.tetrahedra(t, b))).norm();
    }
    return sum[1] / count[1] / (sum[0] / count[0]);
  };
  const auto in_lesion = [](const Eigen::Vector3d& p) {
    return (p - Eigen::Vector3d(90, 60, 60)).norm() < 9;
  };
  const auto at_vessel = [](const Eigen::Vector3d& p) {
    return from_segment(p, {70, 60, 30}, {70, 60, 52}) < 6;
  };
  const auto refined = [&](double lesions, double vessels) {
    model::ModelOptions finer = quick();
    finer.mesh.target_vertices = 900;
    finer.mesh.lesion_refinement = lesions;
    finer.mesh.vessel_refinement = vessels;
    auto built = model::build_from_labels(map_, finer, RunContext());
    check_tetrahedra(built->model.mesh, "mesh");
    return built->model.mesh;
  };
  const TetMesh plain = refined(1.0, 1.0), lesions = refined(0.4, 1.0), vessels = refined(1.0, 0.4);
  for (const TetMesh* mesh : {&plain, &lesions, &vessels}) {
    QVERIFY(std::abs(mesh->vertex_count() - 900) <= 90);
    QVERIFY(dihedral_angles(*mesh).col(0).minCoeff() >= 10.0);
  }
  qInfo("edges over those elsewhere: lesion %.2f, refined %.2f; vessel %.2f, refined %.2f",
        ratio(plain, in_lesion), ratio(lesions, in_lesion), ratio(plain, at_vessel),
        ratio(vessels, at_vessel));
  QVERIFY(ratio(lesions, in_lesion) < 0.7 * ratio(plain, in_lesion));
  QVERIFY(ratio(vessels, at_vessel) < 0.7 * ratio(plain, at_vessel));
}

void LabelsTest::PortalTreeStartsAtItsEntrance() {
  QCOMPARE(built_.model.vessels.size(), std::size_t{1});
  const VesselTree& tree = built_.model.vessels[0];
  QCOMPARE(tree.structure, structure::kPortalVein);
  QVERIFY((tree.nodes.row(tree.root).transpose() - in_ct(map_, {70, 60, 20})).norm() < 6e-3);
  QVERIFY(tree.beams.size() >= 15 && tree.beams.size() <= 30);
  std::vector<int> degree(tree.radii.size(), 0);
  for (const auto& beam : tree.beams)
    for (const int node : beam) ++degree[node];
  QCOMPARE(std::count(degree.begin(), degree.end(), 3), 1L);
  const int fork = static_cast<int>(std::find(degree.begin(), degree.end(), 3) - degree.begin());
  QVERIFY((tree.nodes.row(fork).transpose() - in_ct(map_, {70, 60, 55})).norm() < 5e-3);
}

void LabelsTest::FineSurfacesFaceOutwards() {
  std::map<Label, double> volumes;
  for (const NamedSurface& surface : built_.model.surfaces) {
    QVERIFY(surface.mesh.triangle_count() > 0);
    volumes[surface.structure] = volume(surface.mesh);
  }
  QVERIFY(std::abs(volumes.at(structure::kParenchyma) / (4.0 / 3.0 * std::numbers::pi * 0.06 * 0.045 * 0.04) -
                   1.0) < 0.03);
  QVERIFY(std::abs(volumes.at(structure::kFirstLesion) / (4.0 / 3.0 * std::numbers::pi * std::pow(0.011, 3)) -
                   1.0) < 0.08);
  QVERIFY(volumes.at(structure::kPortalVein) > 0.0 && volumes.at(structure::kVenaCava) > 0.0);
}

void LabelsTest::SpecksAreReported() { QVERIFY(says(built_.report, "liver.pieces_dropped 1")); }

void LabelsTest::VenaCavaTouchesWhereItTouches() {
  const Points& contact = built_.model.landmarks.vena_cava;
  QVERIFY(contact.rows() >= 5);
  for (Eigen::Index i = 0; i < contact.rows(); ++i) {
    const Eigen::Vector3d p = 1e3 * contact.row(i).transpose() - map_.voxels.grid().origin_mm;
    QVERIFY(std::abs(std::hypot(p.x() - 70, p.y() - 112) - 9) < 7.5);
  }
}

void LabelsTest::EveryOrientationGivesTheSameModel() {
  Eigen::Matrix3d mirrored = Eigen::Matrix3d::Zero();  // axes permuted and one of them flipped: det -1
  mirrored.col(0) << 0, 1, 0;
  mirrored.col(1) << 1, 0, 0;
  mirrored.col(2) << 0, 0, 1;
  const LabelMap turned = phantom(mirrored, kSpacing);
  const auto built = model::build_from_labels(turned, quick(), RunContext());
  check_tetrahedra(built->model.mesh, "mesh");
  QVERIFY(std::abs(volume(built->model.mesh) / volume(built_.model.mesh) - 1.0) < 0.03);
  const auto centres = lesion_centres(built->model);
  QVERIFY((centres[0].second - in_ct(turned, {90, 60, 60})).norm() < 2e-3);
  for (const NamedSurface& surface : built->model.surfaces) QVERIFY(volume(surface.mesh) > 0.0);
}

void LabelsTest::SameInputGivesTheSameBits() {
  const auto again = model::build_from_labels(map_, quick(), RunContext());
  QVERIFY(again->model.mesh.vertices == built_.model.mesh.vertices);
  QVERIFY(again->model.mesh.tetrahedra == built_.model.mesh.tetrahedra);
  QVERIFY(again->model.vessels[0].nodes == built_.model.vessels[0].nodes);
  QVERIFY(again->model.landmarks.anterior_margin == built_.model.landmarks.anterior_margin);
}

void LabelsTest::GivenRootIsTaken() {
  model::ModelOptions options = quick();
  options.portal_root = in_ct(map_, {40, 62, 75}).transpose();  // the left branch's tip
  const auto built = model::build_from_labels(map_, options, RunContext());
  QVERIFY((built->model.vessels[0].nodes.row(0) - options.portal_root).norm() < 4e-3);
}

void LabelsTest::ARootThatIsGivenTwiceMakesOneTree() {
  model::ModelOptions options = quick();
  options.portal_root = in_ct(map_, {40, 62, 75}).transpose();
  const auto once = model::build_from_labels(map_, options, RunContext());
  options.portal_root.conservativeResize(2, 3);
  options.portal_root.row(1) = options.portal_root.row(0);
  const auto twice = model::build_from_labels(map_, options, RunContext());
  QCOMPARE(twice->model.vessels.size(), once->model.vessels.size());
}

void LabelsTest::GivenRootFarAwayIsRefused() {
  model::ModelOptions options = quick();
  options.portal_root = in_ct(map_, {5, 5, 5}).transpose();
  QVERIFY_THROWS_EXCEPTION(InputError, model::build_from_labels(map_, options, RunContext()));
}

void LabelsTest::NoLiverIsRefused() {
  QVERIFY_THROWS_EXCEPTION(InputError, model::build_from_labels({}, quick(), RunContext()));
  LabelMap none;
  none.voxels = LabelVolume(map_.voxels.grid());
  QVERIFY_THROWS_EXCEPTION(InputError, model::build_from_labels(none, quick(), RunContext()));
}

void LabelsTest::TwoLargePiecesAreRefused() {
  LabelMap two = map_;
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 15; ++i) two.voxels.set({i, j, k}, structure::kParenchyma);
  QVERIFY_THROWS_EXCEPTION(InputError, model::build_from_labels(two, quick(), RunContext()));
}

void LabelsTest::CancelGivesNothing() {
  auto flag = std::make_shared<CancelFlag>();
  const RunContext context(
      [&](double, std::string_view stage) {
        if (stage == "model.mesh.refine") flag->request();
      },
      flag, 1);
  QVERIFY(!model::build_from_labels(map_, quick(), context).has_value());
}

void LabelsTest::OptionsOutOfRangeAreRefused() {
  model::ModelOptions options;
  options.target_beams = 0;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options = {};
  options.mesh.vessel_refinement = 1.5;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options = {};
  options.hepatic_root = Points::Constant(1, 3, std::numeric_limits<double>::quiet_NaN());
  QVERIFY_THROWS_EXCEPTION(InputError, model::build_from_labels(map_, options, RunContext()));
}

void LabelsTest::AVesselOutsideTheLiverIsLeftOut() {
  LabelMap map = phantom(Eigen::Matrix3d::Identity(), kSpacing);
  const VolumeGrid& grid = map.voxels.grid();
  for (int i = 1; i < 5; ++i)  // in the corner that is farthest from the liver
    map.voxels.set({i, grid.size.y() - 2, 1}, structure::kHepaticVeins);
  model::ModelOptions options = quick();
  options.mesh.vessel_refinement = 0.5;
  const auto built = model::build_from_labels(map, options, RunContext());
  QVERIFY(built.has_value());
  QVERIFY(says(built->report, "vessels.outside_liver hepatic_veins"));
  QCOMPARE(built->model.vessels.size(), std::size_t{1});
}

QTEST_APPLESS_MAIN(LabelsTest)
#include "labels_test.moc"
