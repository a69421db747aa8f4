// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QtTest>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/model/build.h"
#include "shapes.h"

using namespace glisson;

class LiverModelsTest : public QObject {
  Q_OBJECT
 private slots:
  void RealPatientBecomesAModel();
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
  qInfo(
      "%d nodes, %d tetrahedra, dihedral %.1f to %.1f deg, volume %.1f %%, nodes to fine %.3f mm, mesh to "
      "fine %.2f mm, "
      "fine to mesh %.2f mm (max %.1f), %.1f s",
      quality.vertices, quality.tetrahedra, quality.min_dihedral_deg, quality.max_dihedral_deg,
      100 * quality.volume_error, quality.vertices_to_fine_mean_mm, quality.mesh_to_fine_mean_mm,
      quality.fine_to_mesh_mean_mm, quality.fine_to_mesh_max_mm, 1e-3 * static_cast<double>(timer.elapsed()));
  for (const std::string& note : built->report.notes) qInfo("%s", note.c_str());
  for (const VesselTree& tree : built->model.vessels)
    qInfo("%s: %zu beams, root (%.0f %.0f %.0f) r %.1f", structure_name(tree.structure).c_str(),
          tree.beams.size(), 1e3 * tree.nodes(0, 0), 1e3 * tree.nodes(0, 1), 1e3 * tree.nodes(0, 2),
          1e3 * tree.radii[0]);
  QVERIFY(std::abs(quality.vertices - 550) <= 55);
  QVERIFY(quality.min_dihedral_deg >= 10.0);
  QVERIFY(std::abs(quality.volume_error) < 0.06);
  QVERIFY(quality.fine_to_mesh_mean_mm < 2.0);
  std::size_t beams = 0;
  for (const VesselTree& tree : built->model.vessels) beams += tree.beams.size();
  QVERIFY(beams >= 100 && beams <= 160);
  QVERIFY(built->model.landmarks.anterior_margin.rows() > 50);
  QVERIFY(lesion_centres(built->model).size() >= 20);
}

QTEST_APPLESS_MAIN(LiverModelsTest)
#include "liver_models_test.moc"
