// SPDX-License-Identifier: GPL-3.0-or-later
// Where the portal vein shows its umbilical part, notch and falciform line are drawn to it; where it does
// not, or shows it where it cannot be, they stay what statistics say, and that is said.
#include <QTest>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "../support/portal_trees.h"
#include "glisson/atlas/transfer.h"
#include "glisson/insilico/patient.h"
#include "known_livers.h"

using namespace glisson;
using namespace glisson::atlas;
using test::LeftBranch;

namespace {

/// From the end of the umbilical part to the notch, as on real livers: 28 mm forwards, 22 mm down, 7 mm to
/// the right.
const Eigen::RowVector3d kToNotch(-0.007, -0.028, -0.022);

VesselTree moved(VesselTree tree, const Eigen::RowVector3d& by) {
  tree.nodes.rowwise() += by;
  return tree;
}

const Proposal& of(const Transfer& made, Structure structure) {
  return *std::ranges::find(made.proposals, structure, &Proposal::structure);
}

bool is_from(const Proposal& proposal, Source source) {
  return std::ranges::all_of(proposal.sources, [&](Source one) { return one == source; });
}

bool says(const Transfer& made, const char* doubt) {
  return std::ranges::any_of(made.doubts, [&](const std::string& one) { return one.starts_with(doubt); });
}

/// Squared Mahalanobis distance of a point from a proposal's k-th.
double off(const Proposal& proposal, Eigen::Index k, const Eigen::RowVector3d& point) {
  const Eigen::Vector3d d = (point - proposal.points.row(k)).transpose();
  return d.dot(proposal.covariances[static_cast<std::size_t>(k)].inverse() * d);
}

}  // namespace

class FissureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    member_ = test::synthetic_member(911);
    notch_ = member_.structures.at(Structure::umbilical_notch).row(0);
    atlas_ = test::population_atlas();
    plain_ = *transfer(atlas_, member_.liver, {}, RunContext());
    with_ = made_with(moved(test::portal_vein(LeftBranch::whole), notch_ - kToNotch));
  }

  void withoutAPortalVeinNothingChanges() {
    QVERIFY(!says(plain_, "atlas.no_umbilical_part") && !says(plain_, "atlas.umbilical_part_elsewhere"));
    QVERIFY(is_from(of(plain_, Structure::umbilical_notch), Source::statistics));
    QVERIFY(is_from(of(plain_, Structure::falciform_line), Source::statistics));
  }

  void notchAndLineAreDrawnToIt() {
    const Proposal &before = of(plain_, Structure::umbilical_notch), &notch = of(with_, before.structure);
    QVERIFY(is_from(notch, Source::both));
    QVERIFY2(notch.deviation() < 0.7 * before.deviation(),
             qPrintable(QStringLiteral("%1 %2").arg(notch.deviation()).arg(before.deviation())));
    QVERIFY((notch.points.row(0) - notch_).norm() < (before.points.row(0) - notch_).norm() + 0.001);
    QVERIFY(off(notch, 0, notch_) < kEllipsoid95);
    // Across the fissure it is known best, up and down least.
    const Eigen::Matrix3d& spread = notch.covariances[0];
    QVERIFY(spread(0, 0) < spread(2, 2) && spread(1, 1) < spread(2, 2));
    const Proposal &was = of(plain_, Structure::falciform_line), &line = of(with_, was.structure);
    QVERIFY(line.sources.front() == Source::both);
    for (std::size_t k = 0; k < line.sources.size(); ++k) {
      QVERIFY(line.covariances[k](0, 0) <= was.covariances[k](0, 0) * (1.0 + 1e-9));
      // Along the fissure's plane the vein says nothing.
      QVERIFY(line.covariances[k](2, 2) > 0.8 * was.covariances[k](2, 2));
    }
  }

  void nothingElseChanges() {
    for (const Proposal& one : with_.proposals) {
      if (one.structure == Structure::umbilical_notch || one.structure == Structure::falciform_line) continue;
      QVERIFY((one.points - of(plain_, one.structure).points).norm() < 1e-12);
    }
    QCOMPARE(with_.doubts, plain_.doubts);
  }

  void itMovesWithThePatient() {
    const Eigen::Matrix3d turn(
        Eigen::AngleAxisd(0.15, Eigen::Vector3d(0.2, 0.3, 0.9).normalized()).toRotationMatrix());
    const Eigen::RowVector3d shift(0.05, -0.1, 0.3);
    Member other = member_;
    other.liver.vertices = (other.liver.vertices * turn.transpose()).rowwise() + shift;
    VesselTree tree = moved(test::portal_vein(LeftBranch::whole), notch_ - kToNotch);
    tree.nodes = (tree.nodes * turn.transpose()).rowwise() + shift;
    Evidence evidence;
    evidence.portal_vein = {tree};
    const auto made = transfer(atlas_, other.liver, evidence, RunContext());
    const Proposal& notch = of(*made, Structure::umbilical_notch);
    QVERIFY(is_from(notch, Source::both));
    const Eigen::RowVector3d back = (notch.points.row(0) - shift) * turn;
    QVERIFY2((back - of(with_, notch.structure).points.row(0)).norm() < 0.002,
             qPrintable(QString::number((back - of(with_, notch.structure).points.row(0)).norm())));
  }

  void aPersonsMarkStays() {
    Evidence evidence;
    evidence.portal_vein = {moved(test::portal_vein(LeftBranch::whole), notch_ - kToNotch)};
    evidence.placed[Structure::umbilical_notch] = notch_ + Eigen::RowVector3d(0.0, 0.0, 0.01);
    const auto made = transfer(atlas_, member_.liver, evidence, RunContext());
    QVERIFY(is_from(of(*made, Structure::umbilical_notch), Source::person));
    QVERIFY(of(*made, Structure::falciform_line).sources.front() == Source::both);
    QVERIFY(!says(*made, "atlas.mark_contradicted"));
    // One that the vein contradicts stays too; then the vein says nothing of the line.
    evidence.portal_vein = {
        moved(test::portal_vein(LeftBranch::whole), notch_ - kToNotch - Eigen::RowVector3d(0.0, 0.04, 0.0))};
    const auto other = transfer(atlas_, member_.liver, evidence, RunContext());
    QVERIFY(is_from(of(*other, Structure::umbilical_notch), Source::person));
    QVERIFY(is_from(of(*other, Structure::falciform_line), Source::statistics));
    QVERIFY(says(*other, "atlas.mark_contradicted"));
  }

  void wrongTreesSayNothing_data() {
    QTest::addColumn<VesselTree>("tree");
    QTest::addColumn<QByteArray>("doubt");
    const Eigen::RowVector3d end = notch_ - kToNotch;
    QTest::newRow("left branch missing")
        << moved(test::portal_vein(LeftBranch::none), end) << QByteArray("atlas.no_umbilical_part");
    QTest::newRow("ends in the transverse part")
        << moved(test::portal_vein(LeftBranch::transverse), end) << QByteArray("atlas.no_umbilical_part");
    QTest::newRow("hepatic veins") << moved(test::hepatic_veins(), end) << QByteArray("atlas.");
    const double bed = member_.structures.at(Structure::gallbladder_bed).col(0).mean();
    QTest::newRow("round ligament on the right")
        << moved(test::portal_vein(LeftBranch::whole), {bed - 0.02, end.y(), end.z()})
        << QByteArray("atlas.umbilical_part_elsewhere");
    // As high as where hepatic veins enter the vena cava.
    QTest::newRow("swapped") << moved(test::portal_vein(LeftBranch::whole),
                                      end + Eigen::RowVector3d(0, 0, 0.07))
                             << QByteArray("atlas.umbilical_part_elsewhere");
    QTest::newRow("far to the left") << moved(test::portal_vein(LeftBranch::whole),
                                              end + Eigen::RowVector3d(0.12, 0, 0))
                                     << QByteArray("atlas.");
  }

  void wrongTreesSayNothing() {
    QFETCH(VesselTree, tree);
    QFETCH(QByteArray, doubt);
    const Transfer made = made_with(tree);
    for (const Structure one : {Structure::umbilical_notch, Structure::falciform_line}) {
      QVERIFY(is_from(of(made, one), Source::statistics));
      QVERIFY((of(made, one).points - of(plain_, one).points).norm() < 1e-12);
    }
    QCOMPARE(made.doubts.size(), plain_.doubts.size() + 1);
    QVERIFY2(QByteArray::fromStdString(made.doubts.back()).startsWith(doubt), made.doubts.back().c_str());
  }

  /// Synthetic patients grow their own portal vein, whose umbilical part runs in the fissure.
  void syntheticPatients() {
    double before = 0.0, after = 0.0;
    for (const std::uint64_t seed : {911, 912, 913}) {
      insilico::PatientOptions options;
      options.shape_seed = seed;
      options.spacing_mm = {8.0, 8.0, 8.0};
      options.surface_spacing_mm = 3.0;
      const auto patient = insilico::make_patient(options, RunContext());
      Evidence evidence;
      std::ranges::copy_if(patient->trees, std::back_inserter(evidence.portal_vein),
                           [](const VesselTree& tree) { return tree.structure == structure::kPortalVein; });
      const TriangleMesh& liver = patient->surfaces.front().mesh;
      const auto plain = transfer(atlas_, liver, {}, RunContext()),
                 made = transfer(atlas_, liver, evidence, RunContext());
      const Eigen::RowVector3d truth = patient->landmarks.umbilical_notch.row(0);
      const Proposal& notch = of(*made, Structure::umbilical_notch);
      const double was = (of(*plain, notch.structure).points.row(0) - truth).norm(),
                   is = (notch.points.row(0) - truth).norm();
      qInfo("seed %d: %s, %.1f mm, deviation %.1f; from statistics %.1f", static_cast<int>(seed),
            source_code(notch.sources[0]), 1e3 * is, 1e3 * notch.deviation(), 1e3 * was);
      for (const std::string& doubt : made->doubts) qInfo("  %s", doubt.c_str());
      QVERIFY(off(notch, 0, truth) < kEllipsoid95);
      before += was;
      after += is;
    }
    qInfo("mean %.1f mm, from statistics %.1f", 1e3 * after / 3.0, 1e3 * before / 3.0);
  }

 private:
  Transfer made_with(const VesselTree& tree) const {
    Evidence evidence;
    evidence.portal_vein = {tree};
    return *transfer(atlas_, member_.liver, evidence, RunContext());
  }

  Member member_;
  Eigen::RowVector3d notch_;
  Atlas atlas_;
  Transfer plain_, with_;
};

QTEST_APPLESS_MAIN(FissureTest)
#include "fissure_test.moc"
