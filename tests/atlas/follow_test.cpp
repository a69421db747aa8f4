// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of one structure moves those that depend on it, and nothing that somebody has placed.
#include <Eigen/LU>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "../support/portal_trees.h"
#include "glisson/atlas/review.h"
#include "glisson/atlas/transfer.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "known_livers.h"

using namespace glisson;
using namespace glisson::atlas;

namespace {

template <class Made>
auto& of(Made& made, Structure structure) {
  return *std::ranges::find(made.proposals, structure, &Proposal::structure);
}

bool says(const Transfer& made, const char* doubt) {
  return std::ranges::any_of(made.doubts, [&](const std::string& one) { return one.starts_with(doubt); });
}

bool same(const Proposal& a, const Proposal& b) {
  return a.points == b.points && a.area == b.area && a.covariances == b.covariances &&
         a.sources == b.sources && a.decision == b.decision && a.follows == b.follows;
}

double error(const Proposal& proposal, const Points& truth) {
  return (proposal.points - truth).rowwise().norm().mean();
}

}  // namespace

class FollowTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    atlas_ = test::dependent_atlas();
    member_ = test::synthetic_member(911);
    notch_ = member_.structures.at(Structure::umbilical_notch).row(0);
    for (const Structure one : {Structure::falciform_line, Structure::anterior_margin})
      truth_[one] = ordered_points(one, member_.structures.at(one), Eigen::Matrix3d::Identity(), notch_);
    bare_ = *transfer(atlas_, member_.liver, {}, RunContext());
    // As far off as the portal vein leaves the notch of real livers.
    elsewhere_ = notch_ + Eigen::RowVector3d(0.0, 0.004, 0.02);
  }

  void byItselfNothingFollows() {
    for (const Proposal& one : bare_.proposals) QVERIFY(one.follows.empty());
    QVERIFY(!says(bare_, "atlas.nothing_follows"));
  }

  void aPlacedNotchDrawsLineAndMarginAlong() {
    const Transfer made = moved(bare_, Structure::umbilical_notch, notch_);
    for (const Structure one : {Structure::falciform_line, Structure::anterior_margin}) {
      const Proposal &before = of(bare_, one), &after = of(made, one);
      qInfo("%s: %.1f mm, %.1f before; deviation %.1f, %.1f", structure_code(one),
            1e3 * error(after, truth_[one]), 1e3 * error(before, truth_[one]), 1e3 * after.deviation(),
            1e3 * before.deviation());
      QVERIFY(error(after, truth_[one]) < error(before, truth_[one]) + 0.0005);
      QVERIFY(after.deviation() < before.deviation());
      QCOMPARE(after.follows.size(), std::size_t{1});
      QCOMPARE(after.follows.front().on, Structure::umbilical_notch);
      QCOMPARE(after.follows.front().source, Source::person);
      QVERIFY(after.follows.front().points > 0 && after.decision == Decision::proposed);
      for (std::size_t k = 0; k < after.covariances.size(); ++k) {
        QVERIFY(after.covariances[k].trace() <= before.covariances[k].trace() * (1.0 + 1e-12));
        QVERIFY(after.sources[k] == Source::statistics);  // it is no evidence of its own
      }
    }
    QVERIFY((of(made, Structure::falciform_line).points.row(0) - notch_).norm() < 0.006);
    QVERIFY((of(made, Structure::anterior_margin).points.row(26) - notch_).norm() < 0.006);
  }

  /// Where the notch goes its neighbours go, the far ends hardly.
  void itFollowsAsFarAsTheNotchTells() {
    const Transfer there = moved(bare_, Structure::umbilical_notch, notch_),
                   elsewhere = moved(bare_, Structure::umbilical_notch, elsewhere_);
    const Eigen::VectorXd way =
        (of(elsewhere, Structure::anterior_margin).points - of(there, Structure::anterior_margin).points)
            .rowwise()
            .norm();
    const double by = (elsewhere_ - notch_).norm();
    QVERIFY2(way[26] > 0.5 * by, qPrintable(QString::number(way[26])));
    QVERIFY2(way[0] < 0.5 * way[26], qPrintable(QString::number(way[0])));
  }

  /// The same words in any order leave the same proposals. (Of a line that is dragged the points that count
  /// as a person's depend on where it was shown.)
  void theOrderOfReviewDoesNotMatter() {
    const Points entrance = of(bare_, Structure::portal_entrance).points.rowwise() + (elsewhere_ - notch_);
    const Transfer one = moved(moved(bare_, Structure::umbilical_notch, elsewhere_),
                               Structure::portal_entrance, entrance),
                   other = moved(moved(bare_, Structure::portal_entrance, entrance),
                                 Structure::umbilical_notch, elsewhere_);
    QVERIFY(!same(of(one, Structure::anterior_margin), of(bare_, Structure::anterior_margin)));
    for (const Structure structure : kStructures) QVERIFY(same(of(one, structure), of(other, structure)));
  }

  void whatIsTakenBackIsAsItWas() {
    Transfer made = moved(bare_, Structure::umbilical_notch, elsewhere_);
    of(made, Structure::umbilical_notch) = of(bare_, Structure::umbilical_notch);
    propose_again(made, member_.liver, {});
    for (const Structure structure : kStructures) QVERIFY(same(of(made, structure), of(bare_, structure)));
    QCOMPARE(made.doubts, bare_.doubts);
  }

  void whatIsDecidedStays() {
    const Points line = truth_[Structure::falciform_line];
    Transfer made = moved(bare_, Structure::falciform_line, line);
    of(made, Structure::anterior_margin) =
        reviewed(of(made, Structure::anterior_margin), Decision::accepted, {});
    const Transfer before = made;
    made = moved(made, Structure::umbilical_notch, elsewhere_);
    for (const Structure structure : {Structure::falciform_line, Structure::anterior_margin})
      QVERIFY(same(of(made, structure), of(before, structure)));
    QVERIFY((of(made, Structure::falciform_line).points - line).norm() < 1e-12);
  }

  void whatIsNotVisibleTellsNothingAndAnAcceptedGuessNeither() {
    Transfer made = moved(bare_, Structure::umbilical_notch, elsewhere_);
    of(made, Structure::umbilical_notch) =
        reviewed(of(made, Structure::umbilical_notch), Decision::not_visible, {});
    propose_again(made, member_.liver, {});
    QVERIFY(same(of(made, Structure::anterior_margin), of(bare_, Structure::anterior_margin)));
    QVERIFY((of(made, Structure::umbilical_notch).points.row(0) - elsewhere_).norm() < 1e-12);
    made = bare_;
    of(made, Structure::umbilical_notch) =
        reviewed(of(made, Structure::umbilical_notch), Decision::accepted, {});
    propose_again(made, member_.liver, {});
    QVERIFY(same(of(made, Structure::anterior_margin), of(bare_, Structure::anterior_margin)));
  }

  /// A mark that was there before the atlas, and the same place in the review.
  void aMarkDoesAsTheReviewDoes() {
    Evidence evidence;
    evidence.placed[Structure::umbilical_notch] = notch_;
    const Transfer marked = told(bare_, member_.liver, evidence),
                   whole = *transfer(atlas_, member_.liver, evidence, RunContext()),
                   made = moved(bare_, Structure::umbilical_notch,
                                of(marked, Structure::umbilical_notch).points);
    for (const Structure structure : kStructures) {
      QVERIFY(same(of(whole, structure), of(marked, structure)));
      if (structure == Structure::umbilical_notch) continue;
      QVERIFY(same(of(made, structure), of(marked, structure)));
    }
  }

  void aLineThatIsPlacedDrawsTheNotch() {
    const Eigen::RowVector3d by = elsewhere_ - notch_;
    const Transfer made =
        moved(bare_, Structure::falciform_line, of(bare_, Structure::falciform_line).points.rowwise() + by);
    const Proposal &before = of(bare_, Structure::umbilical_notch), &notch = of(made, before.structure);
    QVERIFY(notch.follows.size() == 1 && notch.follows.front().on == Structure::falciform_line);
    QVERIFY(notch.deviation() < before.deviation());
    QVERIFY((notch.points - before.points).row(0).dot(by) > 0.3 * by.squaredNorm());
  }

  /// The notch as the portal vein shows it takes the others along, less surely than a person's.
  void whatTheVeinShowsIsFollowed() {
    Evidence evidence;
    evidence.portal_vein = {vein_to(elsewhere_)};
    const Transfer made = told(bare_, member_.liver, evidence),
                   placed = moved(bare_, Structure::umbilical_notch, elsewhere_);
    QVERIFY(of(made, Structure::umbilical_notch).sources[0] == Source::both);
    const Proposal &margin = of(made, Structure::anterior_margin), &surely = of(placed, margin.structure);
    QCOMPARE(margin.follows.size(), std::size_t{1});
    QCOMPARE(margin.follows.front().source, Source::both);
    QVERIFY(margin.deviation() < of(bare_, margin.structure).deviation());
    QVERIFY(margin.deviation() > surely.deviation());
  }

  void aVeinThatContradictsAMarkIsSaidAndNotUsed() {
    Evidence evidence;
    evidence.portal_vein = {vein_to(notch_ - Eigen::RowVector3d(0.0, 0.04, 0.0))};
    const Transfer alone = told(bare_, member_.liver, evidence);
    QVERIFY(says(alone, "atlas.contradiction umbilical_notch"));
    Transfer made = alone;
    of(made, Structure::umbilical_notch) =
        reviewed(of(made, Structure::umbilical_notch), Decision::moved, notch_);
    propose_again(made, member_.liver, evidence);
    QVERIFY(says(made, "atlas.mark_contradicted umbilical_notch"));
    const Transfer without = moved(bare_, Structure::umbilical_notch, notch_);
    QVERIFY(same(of(made, Structure::falciform_line), of(without, Structure::falciform_line)));
  }

  void anAtlasThatDoesNotKnowSaysSo() {
    Atlas old = atlas_;
    for (StructureStatistics& one : old.structures) one.depends.clear();
    const TemporaryFolder folder;
    write_atlas(folder.path(), old);
    QVERIFY(read_file(folder.path() / "atlas.json").find("depends") == std::string::npos);
    const Transfer before = *transfer(read_atlas(folder.path()), member_.liver, {}, RunContext()),
                   made = moved(before, Structure::umbilical_notch, elsewhere_);
    QVERIFY(!says(before, "atlas.nothing_follows") && says(made, "atlas.nothing_follows"));
    for (const Structure structure : {Structure::falciform_line, Structure::anterior_margin})
      QVERIFY(same(of(made, structure), of(before, structure)));
  }

  void theFolderHoldsWhatDependsOnWhat() {
    const TemporaryFolder folder;
    write_atlas(folder.path(), atlas_);
    const Atlas read = read_atlas(folder.path());
    for (const StructureStatistics& one : atlas_.structures) {
      const auto& found = read.find(one.structure)->depends;
      QVERIFY(!one.depends.empty());
      QCOMPARE(found.size(), one.depends.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        const Dependence &a = one.depends[i], &b = found[i];
        QVERIFY(a.on == b.on && a.point == b.point && a.livers == b.livers);
        for (std::size_t k = 0; k < a.gains.size(); ++k) {
          QVERIFY((a.gains[k] - b.gains[k]).cwiseAbs().maxCoeff() < 0.00051);
          QVERIFY((a.left[k] - b.left[k]).cwiseAbs().maxCoeff() < 1e-9);
        }
      }
    }
  }

  void aDamagedDependenceIsRefusedByName_data() {
    QTest::addColumn<int>("what");
    QTest::addColumn<QByteArray>("complaint");
    QTest::newRow("a matrix too few") << 0 << QByteArray("gains: needs 1 rows");
    QTest::newRow("on itself") << 1 << QByteArray("on: is the structure itself");
    QTest::newRow("a point that is not there") << 2 << QByteArray("point: is no point of that structure");
    QTest::newRow("one liver") << 3 << QByteArray("livers: are fewer than 3");
    QTest::newRow("no covariance") << 4 << QByteArray("left_mm2: holds a matrix that is no covariance");
    QTest::newRow("twice") << 5 << QByteArray("depends: name a structure twice");
  }
  void aDamagedDependenceIsRefusedByName() {
    QFETCH(int, what);
    QFETCH(QByteArray, complaint);
    Atlas damaged = atlas_;
    StructureStatistics& notch =
        *std::ranges::find(damaged.structures, Structure::umbilical_notch, &StructureStatistics::structure);
    Dependence& one = notch.depends.front();
    if (what == 0) one.gains.clear();
    if (what == 1) one.on = Structure::umbilical_notch;
    if (what == 2) one.point = point_count(one.on);
    if (what == 3) one.livers = 1;
    if (what == 4) one.left[0](1, 1) = -1e-4;
    if (what == 5) notch.depends.push_back(one);
    const TemporaryFolder folder;
    write_atlas(folder.path(), damaged);
    std::string said;
    try {
      read_atlas(folder.path());
    } catch (const InputError& error) {
      said = error.what();
    }
    QVERIFY2(said.find(complaint.toStdString()) != std::string::npos, said.c_str());
  }

  void whatIsNotThereIsRefused() {
    Atlas damaged = atlas_;
    std::erase_if(damaged.structures,
                  [](const StructureStatistics& one) { return one.structure == Structure::vena_cava; });
    const TemporaryFolder folder;
    write_atlas(folder.path(), damaged);
    QVERIFY_THROWS_EXCEPTION(InputError, read_atlas(folder.path()));
  }

 private:
  Transfer moved(Transfer made, Structure structure, const Points& to) const {
    of(made, structure) = reviewed(of(made, structure), Decision::moved, to);
    propose_again(made, member_.liver, {});
    return made;
  }

  /// A portal vein whose umbilical part ends where on real livers it does, from that notch.
  static VesselTree vein_to(const Eigen::RowVector3d& notch) {
    VesselTree tree = test::portal_vein(test::LeftBranch::whole);
    tree.nodes.rowwise() += notch + Eigen::RowVector3d(0.007, 0.028, 0.022);
    return tree;
  }

  Atlas atlas_;
  Member member_;
  Transfer bare_;
  Eigen::RowVector3d notch_, elsewhere_;
  std::map<Structure, Points> truth_;
};

QTEST_APPLESS_MAIN(FollowTest)
#include "follow_test.moc"
