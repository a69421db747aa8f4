// SPDX-License-Identifier: GPL-3.0-or-later
// A liver that nobody has clicked: proposed seeds lie in the truth's liver, however the CT is stored.
#include "glisson/segmentation/propose_seeds.h"

#include <QTest>
#include <cmath>

#include "ball_ct.h"
#include "glisson/core/error.h"
#include "glisson/insilico/pathology.h"

using namespace glisson;
using namespace glisson::segmentation;
using test::ball_ct;

namespace {

insilico::PathologyCt coarse_ct(const std::string& name) {
  for (insilico::Pathology pathology : insilico::pathologies(2)) {
    if (pathology.name != name) continue;
    pathology.spacing_mm = {3.0, 3.0, 4.0};
    return std::move(*insilico::make_pathology_ct(pathology, RunContext()));
  }
  throw PreconditionError("there is no such pathology");
}

/// The same picture in the patient, its first axis stored the other way round.
Image stored_backwards(const Image& image) {
  Image result = image;
  const Eigen::Vector3i& size = image.grid.size;
  result.grid.origin_mm = 1e3 * image.grid.p_in_ct(Eigen::Vector3d(size.x() - 1, 0, 0)).xyz;
  result.grid.direction.col(0) *= -1.0;
  std::vector<std::int16_t> voxels(image.voxels->size());
  for (std::size_t at = 0; at < voxels.size(); ++at) {
    const auto row = static_cast<std::size_t>(size.x());
    voxels[at / row * row + (row - 1 - at % row)] = (*image.voxels)[at];
  }
  result.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  return result;
}

}  // namespace

class ProposeSeedsTest : public QObject {
  Q_OBJECT
 private slots:
  void SeedsLieInTheLiver_data();
  void SeedsLieInTheLiver();
  void HowTheCtIsStoredPlaysNoPart();
  void WhatIsNoLiverIsRefused();
  void CancelLeavesNothing();
};

void ProposeSeedsTest::SeedsLieInTheLiver_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"hypodense, cava and rim", "cysts", "unenhanced"}) QTest::newRow(name) << name;
}

void ProposeSeedsTest::SeedsLieInTheLiver() {
  QFETCH(QString, name);
  const insilico::PathologyCt patient = coarse_ct(name.toStdString());
  const auto seeds = propose_liver_seeds(patient.ct, RunContext());
  QCOMPARE(seeds->rows(), Eigen::Index(5));
  const VolumeGrid& grid = patient.ct.grid;
  const std::vector<std::uint8_t> liver = inside_liver(patient.truth);
  for (Eigen::Index n = 0; n < seeds->rows(); ++n) {
    const Eigen::Vector3d p = seeds->row(n).transpose();
    const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(p));
    QVERIFY2(liver[static_cast<std::size_t>(grid.offset(index.array().round().matrix().cast<int>()))] != 0,
             qPrintable(QString::number(n)));
    for (Eigen::Index m = 0; m < n; ++m) QVERIFY((seeds->row(m) - seeds->row(n)).norm() > 0.02);
  }
}

void ProposeSeedsTest::HowTheCtIsStoredPlaysNoPart() {
  const Image ct = coarse_ct("hypodense, rim").ct;
  const Image backwards = stored_backwards(ct);
  const auto one = propose_liver_seeds(ct, RunContext()),
             other = propose_liver_seeds(backwards, RunContext());
  QCOMPARE(one->rows(), other->rows());
  // Voxels of equal worth may be taken in another order: the first seed, which is the deepest place, counts.
  QVERIFY((one->row(0) - other->row(0)).norm() < 0.007);
}

void ProposeSeedsTest::WhatIsNoLiverIsRefused() {
  QCOMPARE(propose_liver_seeds(ball_ct(60.0), RunContext())->rows(), Eigen::Index(5));
  QVERIFY_THROWS_EXCEPTION(InputError, propose_liver_seeds(ball_ct(30.0), RunContext()));
  QVERIFY_THROWS_EXCEPTION(InputError, propose_liver_seeds(ball_ct(0.0), RunContext()));
  QVERIFY_THROWS_EXCEPTION(InputError, propose_liver_seeds(Image(), RunContext()));
  Image mri = ball_ct(60.0);
  mri.modality = Modality::mr;
  QVERIFY_THROWS_EXCEPTION(InputError, propose_liver_seeds(mri, RunContext()));
}

void ProposeSeedsTest::CancelLeavesNothing() {
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  QVERIFY(!propose_liver_seeds(ball_ct(60.0), RunContext({}, cancel, 1)));
}

QTEST_APPLESS_MAIN(ProposeSeedsTest)
#include "propose_seeds_test.moc"
