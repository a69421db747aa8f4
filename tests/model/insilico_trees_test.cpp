// SPDX-License-Identifier: GPL-3.0-or-later
// The trees of the synthetic patient, found again from its labels.
#include <QTest>

#include "anatomy.h"
#include "evaluate_trees.h"
#include "glisson/insilico/patient.h"
#include "vessels.h"

using namespace glisson;

class InsilicoTreesTest : public QObject {
  Q_OBJECT
 private slots:
  void TreesAreFoundAgain_data();
  void TreesAreFoundAgain();
};

void InsilicoTreesTest::TreesAreFoundAgain_data() {
  QTest::addColumn<int>("shape");
  for (const int shape : {1, 2}) QTest::newRow(qPrintable(QStringLiteral("shape %1").arg(shape))) << shape;
}

void InsilicoTreesTest::TreesAreFoundAgain() {
  QFETCH(int, shape);
  insilico::PatientOptions options;
  options.shape_seed = static_cast<std::uint64_t>(shape);
  const auto patient = insilico::make_patient(options, RunContext());
  model::ModelOptions wanted;
  wanted.target_beams = 4000;  // as fine as they get: nothing is pruned
  auto anatomy = model::anatomy_of(patient->truth, wanted, RunContext());
  std::vector<std::string> notes;
  const auto trees = model::vessel_trees(*anatomy, wanted, notes, RunContext());
  const double voxel = 1e-3 * std::cbrt(options.spacing_mm.prod());
  QCOMPARE(patient->trees.size(), std::size_t{2});
  for (const VesselTree& truth : patient->trees) {
    const auto mask =
        std::find_if(anatomy->vessels.begin(), anatomy->vessels.end(),
                     [&](const model::VesselMask& it) { return it.structure == truth.structure; });
    QVERIFY(mask != anatomy->vessels.end());
    const auto in_labels = [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3i at = (mask->grid.index_of(Point<CtFrame>(p))).array().round().cast<int>();
      return mask->grid.contains(at) && mask->voxels[static_cast<std::size_t>(mask->grid.offset(at))] != 0;
    };
    const experiments::TreeScore score = experiments::score_tree(truth, *trees, voxel, in_labels);
    qInfo("%s: mean %.2f mm, worst %.2f mm, %d of %d branches over 2 mm, %d bridges, %d doubled",
          structure_name(truth.structure).c_str(), 1e3 * score.mean, 1e3 * score.worst, score.thick_found,
          score.thick, score.bridges, score.doubled);
    QVERIFY(score.mean < voxel);
    QVERIFY(score.thick_found >= 0.95 * score.thick);
    QCOMPARE(score.bridges, 0);
    QCOMPARE(score.doubled, 0);
  }
}

QTEST_APPLESS_MAIN(InsilicoTreesTest)
#include "insilico_trees_test.moc"
