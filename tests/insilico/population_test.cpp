// SPDX-License-Identifier: GPL-3.0-or-later
// Many synthetic patients, on coarse grids.
#include <QTest>
#include <map>
#include <numeric>

#include "glisson/geometry/distance.h"
#include "glisson/geometry/topology.h"
#include "patient_checks.h"

using namespace glisson;
using namespace glisson::test;
using insilico::make_patient;
using insilico::PatientOptions;

namespace {

PatientOptions coarse(std::uint64_t seed) {
  PatientOptions options;
  options.shape_seed = seed;
  options.spacing_mm = {5.0, 5.0, 5.0};
  options.surface_spacing_mm = 3.0;
  return options;
}

}  // namespace

class PopulationTest : public QObject {
  Q_OBJECT
 private slots:
  void SameSeedGivesTheSameBits();
  void OtherSeedGivesAnotherPatient();
  void CancelAtAnyMomentReturnsNothing();
  void ProgressRisesToOne();
  void PopulationIsValid_data();
  void PopulationIsValid();

 private:
  /// One member of the population, on a coarse grid; made when it is first asked for.
  const SyntheticPatient& member(int seed) {
    auto& made = population_[seed];
    if (!made) made = make_patient(coarse(static_cast<std::uint64_t>(seed)), RunContext());
    return *made;
  }

  std::map<int, Cancellable<SyntheticPatient>> population_;
};

void PopulationTest::SameSeedGivesTheSameBits() {
  const SyntheticPatient* a = &member(3);
  const auto b = make_patient(coarse(3), RunContext());
  QVERIFY(*a->ct.voxels == *b->ct.voxels);
  QVERIFY(a->truth.voxels == b->truth.voxels);
  QVERIFY(a->surfaces.front().mesh.vertices == b->surfaces.front().mesh.vertices);
  QVERIFY(a->trees[0].nodes == b->trees[0].nodes && a->trees[1].radii == b->trees[1].radii);
  QVERIFY(a->landmarks.anterior_margin == b->landmarks.anterior_margin);
}

void PopulationTest::OtherSeedGivesAnotherPatient() {
  const SyntheticPatient *a = &member(3), *b = &member(6);
  const auto distance = surface_distance(a->surfaces.front().mesh, b->surfaces.front().mesh, 2000);
  QVERIFY2(distance.forward.mean > 1e-3, qPrintable(QString::number(distance.forward.mean)));
  QVERIFY(a->trees[0].nodes.rows() != b->trees[0].nodes.rows() || a->trees[0].nodes != b->trees[0].nodes);
}

void PopulationTest::CancelAtAnyMomentReturnsNothing() {
  for (const double when : {0.0, 0.1, 0.4, 0.7, 0.8}) {
    const auto flag = std::make_shared<CancelFlag>();
    const RunContext context(
        [&](double fraction, std::string_view) {
          if (fraction >= when) flag->request();
        },
        flag, 1);
    QVERIFY(!make_patient(coarse(1), context).has_value());
  }
}

void PopulationTest::ProgressRisesToOne() {
  double last = 0.0;
  bool rising = true;
  const RunContext context(
      [&](double fraction, std::string_view stage) {
        rising = rising && fraction >= last && stage.starts_with("patient.");
        last = fraction;
      },
      nullptr, 1);
  QVERIFY(make_patient(coarse(1), context).has_value());
  QVERIFY(rising);
  QCOMPARE(last, 1.0);
}

void PopulationTest::PopulationIsValid_data() {
  QTest::addColumn<int>("seed");
  for (int seed = 1; seed <= 20; ++seed) QTest::addRow("seed %d", seed) << seed;
}

void PopulationTest::PopulationIsValid() {
  QFETCH(int, seed);
  const SyntheticPatient* patient = &member(seed);
  const TriangleMesh& liver = surface(*patient, structure::kParenchyma);
  QVERIFY(is_closed(liver));
  const double litres = 1e3 * volume(liver);
  const double clearance_mm =
      1e3 * wall_distance(tree(*patient, structure::kPortalVein), tree(*patient, structure::kHepaticVeins));
  qInfo("%.2f l, clearance %.2f mm, %d and %d vessel nodes", litres, clearance_mm,
        static_cast<int>(patient->trees[0].nodes.rows()), static_cast<int>(patient->trees[1].nodes.rows()));
  QVERIFY(litres > 1.38 && litres < 1.82);
  QVERIFY(clearance_mm > 2.0);
  std::vector<int> of;
  const std::vector<long> sizes = components(patient->ct.grid, patient->truth.voxels.mask(of_liver), of);
  const long all = std::accumulate(sizes.begin(), sizes.end(), 0L);
  QVERIFY(static_cast<double>(*std::max_element(sizes.begin(), sizes.end())) >
          0.995 * static_cast<double>(all));

  for (const Label label : {structure::kFirstLesion, static_cast<Label>(structure::kFirstLesion + 1)}) {
    const TriangleMesh& lesion = surface(*patient, label);
    QVERIFY(inside_mesh(liver, centroid(lesion)));
    for (const double d : distances_to_surface(lesion.vertices, liver)) QVERIFY(d > 3e-3);
    for (const VesselTree& vessels : patient->trees) {
      const std::vector<double> distances = distances_to_surface(vessels.nodes, lesion);
      for (std::size_t i = 0; i < distances.size(); ++i) QVERIFY(distances[i] > vessels.radii[i]);
    }
  }
  for (const VesselTree& vessels : patient->trees) QVERIFY(vessels.nodes.rows() > 500);
  const Points& margin = patient->landmarks.anterior_margin;
  for (const double d : distances_to_surface(margin, liver)) QVERIFY(d < 1.5e-3);
  for (Eigen::Index i = 1; i < margin.rows(); ++i) QVERIFY((margin.row(i) - margin.row(i - 1)).norm() < 8e-3);
  QVERIFY(patient->landmarks.vena_cava.rows() >= 8);
}

QTEST_APPLESS_MAIN(PopulationTest)
#include "population_test.moc"
