// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QTest>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/model/build.h"
#include "glisson/model/quality.h"
#include "shapes.h"

using namespace glisson;

class LiverModelsTest : public QObject {
  Q_OBJECT
 private slots:
  void RealPatientBecomesAModel();
  void FineMeshKeepsTheVolume();
};

void LiverModelsTest::RealPatientBecomesAModel() {
  const std::filesystem::path folder = test::data_folder() / "liver_models";
  if (!std::filesystem::exists(folder)) QSKIP("liver_models is not here (set GLISSON_DATA)");
  const model::SurfaceSet surfaces = model::read_surfaces(folder, LengthUnit::millimetre);
  QElapsedTimer timer;
  timer.start();
  const auto built = model::build_from_surfaces(surfaces, {}, RunContext());
  QVERIFY(built.has_value());
  const model::MeshQuality& quality = built->report.quality;
  QVERIFY(quality.organ_fit);
  const model::OrganFit& fit = *quality.organ_fit;
  qInfo(
      "%d nodes, %d tetrahedra, dihedral %.1f to %.1f deg, volume %.1f %%, nodes to fine %.3f mm, mesh to "
      "fine %.2f mm, "
      "fine to mesh %.2f mm (max %.1f), %.1f s",
      quality.vertices, quality.tetrahedra, quality.min_dihedral_deg, quality.max_dihedral_deg,
      100 * fit.volume_error, fit.vertices_to_fine_mean_mm, fit.mesh_to_fine_mean_mm,
      fit.fine_to_mesh_mean_mm, fit.fine_to_mesh_max_mm, 1e-3 * static_cast<double>(timer.elapsed()));
  for (const std::string& note : built->report.notes) qInfo("%s", note.c_str());
  for (const VesselTree& tree : built->model.vessels)
    qInfo("%s: %zu beams, root (%.0f %.0f %.0f) r %.1f", structure_name(tree.structure).c_str(),
          tree.beams.size(), 1e3 * tree.nodes(0, 0), 1e3 * tree.nodes(0, 1), 1e3 * tree.nodes(0, 2),
          1e3 * tree.radii[0]);
  QVERIFY(std::abs(quality.vertices - 550) <= 55);
  QVERIFY(quality.min_dihedral_deg >= 10.0);
  QVERIFY(std::abs(fit.volume_error) < 0.04);
  QVERIFY(fit.vertices_to_fine_mean_mm <= 0.25);
  QVERIFY(fit.fine_to_mesh_mean_mm < 2.0);
  for (const model::LesionVolume& lesion : model::lesion_volumes(built->model))
    if (lesion.volume > 1e-6) QVERIFY(std::abs(lesion.mesh_volume / lesion.volume - 1.0) < 0.05);
  std::size_t beams = 0;
  for (const VesselTree& tree : built->model.vessels) beams += tree.beams.size();
  QVERIFY(beams >= 100 && beams <= 160);
  QVERIFY(built->model.landmarks.anterior_margin.rows() > 50);
  QVERIFY(lesion_centres(built->model).size() >= 20);
}

void LiverModelsTest::FineMeshKeepsTheVolume() {
  const std::filesystem::path folder = test::data_folder() / "liver_models";
  if (!std::filesystem::exists(folder)) QSKIP("liver_models is not here (set GLISSON_DATA)");
  model::ModelOptions options;
  options.mesh.target_vertices = 2300;
  options.vessels = false;
  const auto built =
      model::build_from_surfaces(model::read_surfaces(folder, LengthUnit::millimetre), options, RunContext());
  const model::MeshQuality& quality = built->report.quality;
  QVERIFY(quality.organ_fit);
  const model::OrganFit& fit = *quality.organ_fit;
  qInfo("%d tetrahedra, volume %.2f %%, dihedral %.1f deg", quality.tetrahedra, 100.0 * fit.volume_error,
        quality.min_dihedral_deg);
  QVERIFY(quality.tetrahedra > 9000 && quality.tetrahedra < 11500);
  QVERIFY(std::abs(fit.volume_error) < 0.01);
  QVERIFY(quality.min_dihedral_deg >= 10.0);
}

QTEST_APPLESS_MAIN(LiverModelsTest)
#include "liver_models_test.moc"
