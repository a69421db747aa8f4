// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/model/tree_edits.h"

#include <QTest>
#include <fstream>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/patient/label_map.h"

using namespace glisson;
using model::TreeEdit;

namespace {

using Kind = TreeEdit::Kind;

/// A trunk of 40 mm along z with a fork at its end into two branches of 30 mm, nodes every 10 mm:
///   root (0,0,0) ... fork (0,0,40), left to (-30,0,40), right to (30,0,40).
VesselTree fork(const Eigen::Vector3d& at_mm, Label structure = structure::kPortalVein) {
  VesselTree tree;
  tree.structure = structure;
  tree.root = 0;
  std::vector<Eigen::Vector3d> nodes;
  for (int i = 0; i <= 4; ++i) nodes.emplace_back(0, 0, 10 * i);
  for (int i = 1; i <= 3; ++i) nodes.emplace_back(-10 * i, 0, 40);
  for (int i = 1; i <= 3; ++i) nodes.emplace_back(10 * i, 0, 40);
  tree.nodes.resize(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    tree.nodes.row(static_cast<Eigen::Index>(i)) = 1e-3 * (nodes[i] + at_mm).transpose();
  tree.radii = {5e-3, 5e-3, 5e-3, 5e-3, 5e-3, 3e-3, 3e-3, 3e-3, 2e-3, 2e-3, 2e-3};
  tree.beams = {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {4, 8}, {8, 9}, {9, 10}};
  return tree;
}

Eigen::Vector3d mm(double x, double y, double z) { return 1e-3 * Eigen::Vector3d(x, y, z); }

/// Every node is reached from node 0, the root, by beams that lead outwards, each but the root by one.
void require_tree(const VesselTree& tree) {
  QCOMPARE(tree.root, 0);
  QCOMPARE(tree.radii.size(), static_cast<std::size_t>(tree.nodes.rows()));
  QCOMPARE(tree.beams.size() + 1, tree.radii.size());
  std::vector<char> reached(tree.radii.size(), 0);
  reached[0] = 1;
  for (const auto& [from, to] : tree.beams) {
    QVERIFY(reached[static_cast<std::size_t>(from)] && !reached[static_cast<std::size_t>(to)]);
    reached[static_cast<std::size_t>(to)] = 1;
  }
}

double length_mm(const VesselTree& tree) {
  double sum = 0.0;
  for (const auto& [a, b] : tree.beams) sum += 1e3 * (tree.nodes.row(a) - tree.nodes.row(b)).norm();
  return sum;
}

model::BuiltModel built_with(const std::vector<VesselTree>& trees) {
  model::BuiltModel built;
  built.model.vessels = trees;
  built.model.mesh.vertices.resize(4, 3);  // around everything
  built.model.mesh.vertices << -1, -1, -1, 4, -1, -1, -1, 4, -1, -1, -1, 4;
  built.model.mesh.tetrahedra.resize(1, 4);
  built.model.mesh.tetrahedra << 0, 1, 2, 3;
  return built;
}

std::vector<VesselTree> edited_trees(const std::vector<VesselTree>& trees,
                                     const std::vector<TreeEdit>& edits) {
  return model::with_tree_edits(built_with(trees), edits).model.vessels;
}

std::string complaint(const std::vector<VesselTree>& trees, const TreeEdit& edit) {
  return test::complaint([&] { edited_trees(trees, {edit}); });
}

}  // namespace

class TreeEditsTest : public QObject {
  Q_OBJECT
 private slots:
  void RootMovesAndBeamsLeadAwayFromIt();
  void PruningTakesTheBranchWithAllThatHangsOnIt();
  void PruningTheTrunkTakesTheTree();
  void AClickAtAForkTakesTheChildMeant_data();
  void AClickAtAForkTakesTheChildMeant();
  void ACutIsToldBeforeItIsMade();
  void JoinHangsOneTreeOnTheOther();
  void JoiningAtTellsWhatAJoinHangsAndWhatForbidsIt();
  void JoinIsUndoneByReplayingWithoutIt();
  void EditsFollowOneAnother();
  void FarFromEveryVesselIsRefused();
  void LoopIsRefused();
  void VesselsOfTwoKindsAreNotJoined();
  void FarJoinIsRefused();
  void FileKeepsTheEdits();
  void BadFilesAreRefused_data();
  void BadFilesAreRefused();
};

void TreeEditsTest::RootMovesAndBeamsLeadAwayFromIt() {
  const auto trees = edited_trees({fork({0, 0, 0})}, {{Kind::set_root, mm(-29, 1, 40)}});
  QCOMPARE(trees.size(), std::size_t{1});
  require_tree(trees[0]);
  QVERIFY((trees[0].nodes.row(0).transpose() - mm(-30, 0, 40)).norm() < 1e-12);
  QCOMPARE(trees[0].radii[0], 3e-3);
  QVERIFY(std::abs(length_mm(trees[0]) - 100) < 1e-9);
}

void TreeEditsTest::PruningTakesTheBranchWithAllThatHangsOnIt() {
  for (const double x : {10.0, 20.0, 30.0}) {  // wherever the branch is picked
    const auto trees = edited_trees({fork({0, 0, 0})}, {{Kind::prune, mm(x, 0, 40)}});
    require_tree(trees.at(0));
    QVERIFY(std::abs(length_mm(trees[0]) - 70) < 1e-9);
    QVERIFY(trees[0].nodes.col(0).maxCoeff() < 1e-9);
  }
  // From a root on the left, the branch to the right is what hangs on the fork there.
  const auto trees =
      edited_trees({fork({0, 0, 0})}, {{Kind::set_root, mm(-30, 0, 40)}, {Kind::prune, mm(0, 0, 20)}});
  require_tree(trees.at(0));
  QVERIFY(std::abs(length_mm(trees[0]) - 60) < 1e-9);
}

void TreeEditsTest::PruningTheTrunkTakesTheTree() {
  for (const double z : {0.0, 20.0, 30.0}) {  // clearly before the fork
    const auto trees = edited_trees({fork({0, 0, 0}), fork({100, 0, 0})}, {{Kind::prune, mm(0, 0, z)}});
    QCOMPARE(trees.size(), std::size_t{1});
    QVERIFY(trees[0].nodes.col(0).minCoeff() > 0.05);
  }
}

void TreeEditsTest::AClickAtAForkTakesTheChildMeant_data() {
  QTest::addColumn<double>("x");
  QTest::addColumn<double>("z");
  QTest::addColumn<double>("goes");  // mm
  QTest::addColumn<double>("left");  // mm, least x of what goes
  const auto row = [](const char* name, double x, double z, double goes, double least_x) {
    QTest::newRow(name) << x << z << goes << least_x;
  };
  // The left branch (30 mm) bears a twig of 8 mm, the right one (30 mm) none: less hangs on it.
  row("the fork itself: the least", 0, 40, 30, 0);
  row("the fork's left side", -1, 41, 38, -30);
  row("the fork's right side", 1, 41, 30, 0);
  row("just before the fork", 0, 36, 30, 0);
  row("just before the fork, to the left", -1.5, 38, 38, -30);
  row("in the fork's tube, to the left", -3, 39, 38, -30);
  row("the twig's fork, from the trunk's side", -18, 40, 8, -20);
  row("the trunk, clearly", 0, 33, 108, -30);
}

void TreeEditsTest::AClickAtAForkTakesTheChildMeant() {
  QFETCH(double, x);
  QFETCH(double, z);
  QFETCH(double, goes);
  QFETCH(double, left);
  VesselTree tree = fork({0, 0, 0});
  tree.nodes.conservativeResize(12, 3);
  tree.nodes.row(11) = mm(-20, 0, 48).transpose();
  tree.radii.push_back(1e-3);
  tree.beams.push_back({6, 11});
  const model::Pruning cut = model::pruning_at({tree}, mm(x, 0, z));
  QVERIFY(std::abs(length_mm(cut.part) - goes) < 1e-9);
  require_tree(cut.part);
  QVERIFY(std::abs(1e3 * cut.part.nodes.col(0).minCoeff() - left) < 1e-9);
  const auto rest = edited_trees({tree}, {{Kind::prune, mm(x, 0, z)}});
  QCOMPARE(rest.empty(), cut.whole_tree);
  if (!rest.empty()) {
    require_tree(rest[0]);
    QVERIFY(std::abs(length_mm(rest[0]) + goes - 108) < 1e-9);
    QVERIFY((rest[0].nodes.row(0) - tree.nodes.row(0)).norm() < 1e-12);  // the trunk stays
  }
}

void TreeEditsTest::ACutIsToldBeforeItIsMade() {
  // Of the second tree; between two nodes, beside the line.
  const auto trees = {fork({0, 0, 0}), fork({100, 0, 0}, structure::kHepaticVeins)};
  const model::Pruning cut = model::pruning_at(trees, mm(85, 2, 40));
  QCOMPARE(cut.tree, std::size_t{1});
  QCOMPARE(cut.part.structure, structure::kHepaticVeins);
  QVERIFY(!cut.whole_tree);
  QVERIFY((cut.part.nodes.row(0).transpose() - mm(100, 0, 40)).norm() < 1e-12);
  QVERIFY(model::pruning_at(trees, mm(0, 0, 5)).whole_tree);
  QVERIFY_THROWS_EXCEPTION(InputError, model::pruning_at(trees, mm(0, 50, 0)));
  QVERIFY_THROWS_EXCEPTION(InputError, model::pruning_at({}, mm(0, 0, 0)));
}

void TreeEditsTest::JoinHangsOneTreeOnTheOther() {
  // From the first tree's right tip (30, 0, 40) to the second one's left tip (60, 0, 40).
  const auto trees =
      edited_trees({fork({0, 0, 0}), fork({90, 0, 0})}, {{Kind::join, mm(30, 0, 40), mm(60, 0, 40)}});
  QCOMPARE(trees.size(), std::size_t{1});
  require_tree(trees[0]);
  QVERIFY(std::abs(length_mm(trees[0]) - 230) < 1e-9);
  QVERIFY((trees[0].nodes.row(0).transpose() - mm(0, 0, 0)).norm() < 1e-12);
  for (const auto& [a, b] : trees[0].beams)
    QVERIFY((trees[0].nodes.row(a) - trees[0].nodes.row(b)).norm() < 10.5e-3);
}

void TreeEditsTest::JoiningAtTellsWhatAJoinHangsAndWhatForbidsIt() {
  using Obstacle = model::Joining::Obstacle;
  std::vector<VesselTree> trees{fork({0, 0, 0}), fork({90, 0, 0})};
  const Eigen::Vector3d at = mm(30, 0, 40), to = mm(60, 0, 40);
  const model::Joining told = model::joining_at(trees, at, to);
  QVERIFY(told.obstacle == Obstacle::none);
  QCOMPARE(told.stays, std::size_t{0});
  QCOMPARE(told.hangs, std::size_t{1});
  QVERIFY(std::abs(told.link - 0.030) < 1e-12);
  // What was told is what is new in the joined tree, and no more.
  const auto joined = edited_trees(trees, {{Kind::join, at, to}});
  QCOMPARE(joined[0].nodes.rows(), trees[0].nodes.rows() + told.part.nodes.rows() - 1);
  QCOMPARE(joined[0].beams.size(), trees[0].beams.size() + told.part.beams.size());
  for (Eigen::Index i = 0; i < told.part.nodes.rows(); ++i)
    QVERIFY((joined[0].nodes.rowwise() - told.part.nodes.row(i)).rowwise().norm().minCoeff() < 1e-15);
  QVERIFY((told.part.nodes.row(0).transpose() - at).norm() < 1e-12);

  QVERIFY(model::joining_at(trees, at, mm(-30, 0, 40)).obstacle == Obstacle::one_tree);
  QVERIFY(model::joining_at(trees, mm(0, 0, 0), mm(90, 0, 0)).obstacle == Obstacle::too_far);
  trees[1].structure = structure::kHepaticVeins;
  const model::Joining other = model::joining_at(trees, at, to);
  QVERIFY(other.obstacle == Obstacle::two_kinds && other.part.beams.empty());
  QVERIFY_THROWS_EXCEPTION(InputError, model::joining_at(trees, at, mm(0, 200, 0)));
}

void TreeEditsTest::JoinIsUndoneByReplayingWithoutIt() {
  model::BuiltModel built = built_with({fork({0, 0, 0}), fork({90, 0, 0})});
  built.report.notes = {"vessels.beams 20", "liver.pieces_dropped 1 ml 0.2"};
  const TreeEdit join{Kind::join, mm(30, 0, 40), mm(60, 0, 40)}, prune{Kind::prune, mm(-20, 0, 40)};
  const model::BuiltModel both = model::with_tree_edits(built, {prune, join});
  QCOMPARE(both.model.vessels.size(), std::size_t{1});
  QCOMPARE(both.report.notes,
           (std::vector<std::string>{"liver.pieces_dropped 1 ml 0.2",
                                     "vessels.pruned_by_hand portal_vein mm 30 tips 1", "vessels.beams 20"}));
  const model::BuiltModel one = model::with_tree_edits(both, {prune});
  QCOMPARE(one.model.vessels.size(), std::size_t{2});
  QVERIFY(std::abs(length_mm(one.model.vessels[0]) - 70) < 1e-9);
  const model::BuiltModel none = model::with_tree_edits(one, {});
  QVERIFY(none.tree_edits.empty() && none.trees_as_built.empty());
  QCOMPARE(none.report.notes.size(), std::size_t{2});
  QVERIFY(none.model.vessels[0].nodes == built.model.vessels[0].nodes);
  QVERIFY(none.model.vessels[0].beams == built.model.vessels[0].beams);
}

void TreeEditsTest::EditsFollowOneAnother() {
  // The second edit finds what the first has left.
  const auto trees =
      edited_trees({fork({0, 0, 0})}, {{Kind::prune, mm(20, 0, 40)}, {Kind::prune, mm(18, 0, 40)}});
  QVERIFY(trees.empty());  // nearest to (18, 0, 40) is now where the fork was: one line from root to tip
}

void TreeEditsTest::FarFromEveryVesselIsRefused() {
  const std::string text = complaint({fork({0, 0, 0})}, {Kind::prune, mm(0, 50, 0)});
  QVERIFY(text.find("edit 1 (prune)") != std::string::npos && text.find("50 mm") != std::string::npos);
  QVERIFY_THROWS_EXCEPTION(InputError, edited_trees({}, {{Kind::set_root, mm(0, 0, 0)}}));
}

void TreeEditsTest::LoopIsRefused() {
  QVERIFY(complaint({fork({0, 0, 0})}, {Kind::join, mm(30, 0, 40), mm(-30, 0, 40)}).find("loop") !=
          std::string::npos);
}

void TreeEditsTest::VesselsOfTwoKindsAreNotJoined() {
  const std::string text = complaint({fork({0, 0, 0}), fork({90, 0, 0}, structure::kHepaticVeins)},
                                     {Kind::join, mm(30, 0, 40), mm(60, 0, 40)});
  QVERIFY(text.find("portal_vein") != std::string::npos && text.find("hepatic_veins") != std::string::npos);
}

void TreeEditsTest::FarJoinIsRefused() {
  QVERIFY(complaint({fork({0, 0, 0}), fork({200, 0, 0})}, {Kind::join, mm(30, 0, 40), mm(170, 0, 40)})
              .find("140 mm") != std::string::npos);
}

void TreeEditsTest::FileKeepsTheEdits() {
  TemporaryFolder folder;
  const std::vector<TreeEdit> edits = {
      {Kind::set_root, mm(1, 2, 3)}, {Kind::prune, mm(-4, 5, 6)}, {Kind::join, mm(7, 8, 9), mm(10, 11, 12)}};
  model::write_tree_edits(folder.path() / "edits.json", edits);
  const auto read = model::read_tree_edits(folder.path() / "edits.json");
  QCOMPARE(read.size(), edits.size());
  for (std::size_t i = 0; i < edits.size(); ++i) {
    QVERIFY(read[i].kind == edits[i].kind);
    QVERIFY((read[i].at - edits[i].at).norm() < 1e-12 && (read[i].to - edits[i].to).norm() < 1e-12);
  }
}

void TreeEditsTest::BadFilesAreRefused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QByteArray>("names");
  QTest::newRow("no list") << QByteArray("{}") << QByteArray("edits");
  QTest::newRow("metres") << QByteArray(R"({"unit": "m", "edits": []})") << QByteArray("unit");
  QTest::newRow("unknown edit") << QByteArray(R"({"edits": [{"edit": "cut", "at": [0, 0, 0]}]})")
                                << QByteArray("edits[0]");
  QTest::newRow("no place") << QByteArray(R"({"edits": [{"edit": "prune"}]})") << QByteArray("at");
  QTest::newRow("two numbers") << QByteArray(R"({"edits": [{"edit": "prune", "at": [0, 0]}]})")
                               << QByteArray("three numbers");
  QTest::newRow("join to nowhere") << QByteArray(R"({"edits": [{"edit": "join", "at": [0, 0, 0]}]})")
                                   << QByteArray("to");
}

void TreeEditsTest::BadFilesAreRefused() {
  QFETCH(QByteArray, text);
  QFETCH(QByteArray, names);
  TemporaryFolder folder;
  const auto path = folder.path() / "edits.json";
  std::ofstream(path) << text.toStdString();
  const std::string said = test::complaint([&] { model::read_tree_edits(path); });
  QVERIFY2(said.find(names.toStdString()) != std::string::npos, said.c_str());
  QVERIFY(said.find("edits.json") != std::string::npos);
}

QTEST_APPLESS_MAIN(TreeEditsTest)
#include "tree_edits_test.moc"
