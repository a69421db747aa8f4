// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/history.h"

#include <QTest>

#include <fstream>
#include <functional>
#include <random>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;
using namespace glisson::editing;

namespace {

LabelMap blank(const Eigen::Vector3i& size) {
  VolumeGrid grid;
  grid.size = size;
  grid.spacing_mm = {0.7, 0.7, 1.5};
  LabelMap labels;
  labels.voxels = LabelVolume(grid);
  return labels;
}

/// A random box of a random label.
LabelMap scribbled(LabelMap labels, std::mt19937_64& random) {
  const Eigen::Vector3i size = labels.voxels.grid().size;
  Eigen::Vector3i low, high;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = static_cast<int>(random() % static_cast<unsigned>(size[axis]));
    high[axis] = std::min(size[axis], low[axis] + 1 + static_cast<int>(random() % 12));
  }
  const auto label = static_cast<Label>(random() % 6);
  for (int k = low.z(); k < high.z(); ++k)
    for (int j = low.y(); j < high.y(); ++j)
      for (int i = low.x(); i < high.x(); ++i) labels.voxels.set({i, j, k}, label);
  const bool known = std::any_of(labels.infos.begin(), labels.infos.end(),
                                 [&](const LabelInfo& info) { return info.code == label; });
  if (!known && label != 0) labels.infos.push_back(structure_info(label));
  return labels;
}

const StepName kPaint{"paint", structure::kPortalVein, 0.01};

/// A plain copy of everything, to compare with.
struct Plain {
  std::vector<std::vector<Label>> states;  ///< of all steps; states[0] before the first
  std::size_t now = 0;
};

}  // namespace

class HistoryTest : public QObject {
  Q_OBJECT
 private slots:
  void TenThousandRandomOperationsAgreeWithPlainCopies();
  void AGestureIsOneStep();
  void AStepThatChangesNothingIsNone();
  void AStepMayChangeWhatIsSaidOfALabelAlone();
  void MemoryStaysWithinTheBudgetAndTheNewestStepIsKept();
  void StepsHoldOnlyWhatTheyChanged();
  void ComesBackFromDisk();
  void RefusesWhatDoesNotBelongToTheLabels();
  void RefusesStepsFartherBackAndUndoneOnesOfOtherLabels();
  void UndoAndRedoNeedAStep();
};

void HistoryTest::TenThousandRandomOperationsAgreeWithPlainCopies() {
  std::mt19937_64 random(4);
  LabelMap labels = blank({45, 40, 37});
  History history(std::size_t{1} << 40U);  // nothing is forgotten
  Plain plain{{labels.voxels.dense()}, 0};
  const TemporaryFolder folder;
  for (int n = 0; n < 10000; ++n) {
    const auto what = random() % 100;
    if (what < 40) {
      const LabelMap before = labels;
      labels = scribbled(labels, random);
      const auto dense = labels.voxels.dense();
      if (dense != plain.states[plain.now] || labels.infos.size() != before.infos.size()) {
        plain.states.resize(plain.now + 1);
        plain.states.push_back(dense);
        ++plain.now;
      }
      history = history.with(kPaint, before, labels);
      if (plain.states.size() > 60) {  // the plain copies must not fill the memory: start anew
        plain = {{dense}, 0};
        history = History(std::size_t{1} << 40U);
      }
    } else if (what < 70) {
      QCOMPARE(history.can_undo(), plain.now > 0);
      if (history.can_undo()) {
        std::tie(labels, history) = history.undo(labels);
        --plain.now;
      }
    } else if (what < 99 || n % 7 != 0) {
      QCOMPARE(history.can_redo(), plain.now + 1 < plain.states.size());
      if (history.can_redo()) {
        std::tie(labels, history) = history.redo(labels);
        ++plain.now;
      }
    } else {
      write_history(folder.path(), history);
      history = read_history(folder.path(), labels.voxels);
    }
    QVERIFY2(labels.voxels.dense() == plain.states[plain.now], qPrintable(QString::number(n)));
  }
}

void HistoryTest::AGestureIsOneStep() {
  std::mt19937_64 random(5);
  const LabelMap first = blank({70, 40, 40});
  LabelMap labels = first;
  History history;
  for (int n = 0; n < 20; ++n) {
    const LabelMap before = labels;
    labels = scribbled(labels, random);
    history = history.with(kPaint, before, labels, 7);
  }
  const LabelMap last = labels;
  QCOMPARE(history.steps().size(), std::size_t{1});
  std::tie(labels, history) = history.undo(labels);
  QVERIFY(labels.voxels == first.voxels);
  QVERIFY(labels.infos.empty());
  std::tie(labels, history) = history.redo(labels);
  QVERIFY(labels.voxels == last.voxels);
  QCOMPARE(labels.infos.size(), last.infos.size());
  // Another gesture, or none, is another step.
  const LabelMap before = labels;
  labels = scribbled(labels, random);
  QCOMPARE(history.with(kPaint, before, labels, 8).steps().size(), std::size_t{2});
  QCOMPARE(history.with(kPaint, before, labels, 0).steps().size(), std::size_t{2});
}

void HistoryTest::AStepThatChangesNothingIsNone() {
  const LabelMap labels = blank({40, 40, 40});
  LabelMap same = labels;
  same.voxels.set({1, 1, 1}, 3);
  same.voxels.set({1, 1, 1}, 0);
  QVERIFY(!History().with(kPaint, labels, same).can_undo());
}

/// As a file of labels that is imported again, in which another program has marked one as completed.
void HistoryTest::AStepMayChangeWhatIsSaidOfALabelAlone() {
  LabelMap before = blank({40, 40, 40});
  before.infos = {structure_info(structure::kParenchyma)};
  const std::vector<std::function<void(LabelInfo&)>> changes = {
      [](LabelInfo& info) { info.name = "liver"; }, [](LabelInfo& info) { info.terminology = "SCT~liver"; },
      [](LabelInfo& info) { info.colour[1] = 0.25; }, [](LabelInfo& info) { info.status = "completed"; }};
  for (const auto& change : changes) {
    LabelMap after = before;
    change(after.infos.front());
    const History history = History().with(kPaint, before, after);
    QVERIFY(history.can_undo());
    const LabelInfo back = history.undo(after).first.infos.front();
    QVERIFY(back.name == before.infos.front().name && back.terminology.empty() && back.status.empty());
    QVERIFY(back.colour == before.infos.front().colour);
  }
}

void HistoryTest::MemoryStaysWithinTheBudgetAndTheNewestStepIsKept() {
  constexpr std::size_t kBrick = sizeof(LabelVolume::Brick);
  LabelMap labels = blank({64, 64, 64});  // 8 bricks
  History history(6 * kBrick);
  for (int n = 0; n < 30; ++n) {
    const LabelMap before = labels;
    labels.voxels.set({32 * (n % 2), 0, 0}, static_cast<Label>(1 + n));
    history = history.with({"paint", static_cast<Label>(1 + n), 0.0}, before, labels);
    QVERIFY(history.bytes() <= 6 * kBrick);
    QCOMPARE(history.undo_name().label, static_cast<Label>(1 + n));
  }
  QVERIFY(history.steps().size() >= 3);
  // A single step beyond the budget is kept all the same.
  LabelMap all = labels;
  for (int n = 0; n < 8; ++n) all.voxels.set(32 * all.voxels.brick_place(static_cast<std::size_t>(n)), 99);
  history = history.with({"fill", 99, 0.0}, labels, all);
  QCOMPARE(history.steps().size(), std::size_t{1});
  QVERIFY(history.undo(all).first.voxels == labels.voxels);
}

void HistoryTest::StepsHoldOnlyWhatTheyChanged() {
  LabelMap labels = blank({320, 320, 320});  // 1000 bricks
  const LabelMap before = labels;
  labels.voxels.set({100, 100, 100}, 2);
  const History history = History().with(kPaint, before, labels);
  QCOMPARE(history.steps()[0]->changes.size(), std::size_t{1});
  QCOMPARE(history.bytes(), sizeof(LabelVolume::Brick));  // there was no brick before
}

void HistoryTest::ComesBackFromDisk() {
  std::mt19937_64 random(6);
  LabelMap labels = blank({50, 40, 40});
  History history;
  for (int n = 0; n < 12; ++n) {
    const LabelMap before = labels;
    labels = scribbled(labels, random);
    history = history.with({"paint", static_cast<Label>(n), 1e-3 * n}, before, labels);
  }
  for (int n = 0; n < 4; ++n) std::tie(labels, history) = history.undo(labels);
  const TemporaryFolder folder;
  write_history(folder.path(), history);
  History read = read_history(folder.path(), labels.voxels);
  QCOMPARE(read.steps().size(), history.steps().size());
  QCOMPARE(read.done(), history.done());
  QVERIFY(read.undo_name() == history.undo_name());
  LabelMap other = labels;
  while (history.can_redo()) {
    std::tie(labels, history) = history.redo(labels);
    std::tie(other, read) = read.redo(other);
    QVERIFY(other.voxels == labels.voxels);
  }
  while (history.can_undo()) {
    std::tie(labels, history) = history.undo(labels);
    std::tie(other, read) = read.undo(other);
    QVERIFY(other.voxels == labels.voxels);
    QCOMPARE(other.infos.size(), labels.infos.size());
  }
}

void HistoryTest::RefusesWhatDoesNotBelongToTheLabels() {
  LabelMap labels = blank({50, 40, 40});
  const LabelMap before = labels;
  labels.voxels.set({1, 2, 3}, 1);
  const TemporaryFolder folder;
  write_history(folder.path(), History().with(kPaint, before, labels));
  const auto complaint = [&](const LabelVolume& volume) {
    return test::complaint<InputError>([&] { read_history(folder.path(), volume); });
  };
  QVERIFY(complaint(before.voxels).find("do not lead to") != std::string::npos);
  QVERIFY(complaint(labels.voxels).empty());
  std::ofstream(folder.path() / "steps.json") << R"({"done": 3, "steps": []})";
  QVERIFY(complaint(labels.voxels).find("done") != std::string::npos);
  std::ofstream(folder.path() / "steps.json")
      << R"({"done": 1, "steps": [{"tool": "paint", "label": 1, "size_mm": 1, "bricks": [[0, -1, 9999999]],
             "infos_before": [], "infos_after": []}]})";
  QVERIFY(complaint(labels.voxels).find("9999999") != std::string::npos);
  std::ofstream(folder.path() / "steps.json") << R"({"done": 1, "steps": [{"tool": 4}]})";
  QVERIFY(complaint(labels.voxels).find("malformed") != std::string::npos);
}

void HistoryTest::RefusesStepsFartherBackAndUndoneOnesOfOtherLabels() {
  // Two steps in two bricks; then somebody else changes the first one's brick, which the second does not
  // touch.
  const LabelMap start = blank({50, 40, 40});
  LabelMap first = start;
  first.voxels.set({1, 2, 3}, 1);
  LabelMap second = first;
  second.voxels.set({40, 2, 3}, 2);
  const History both = History().with(kPaint, start, first).with(kPaint, first, second);
  const TemporaryFolder folder;
  const auto complaint = [&](const LabelVolume& volume) {
    return test::complaint<InputError>([&] { read_history(folder.path(), volume); });
  };
  write_history(folder.path(), both);
  QVERIFY(complaint(second.voxels).empty());
  LabelMap foreign = second;
  foreign.voxels.set({5, 5, 5}, 3);
  QVERIFY(complaint(foreign.voxels).find("do not lead to") != std::string::npos);
  // All undone: redoing would put the step's brick over what is there.
  const History undone = both.undo(second).second.undo(first).second;
  write_history(folder.path(), undone);
  QVERIFY(complaint(start.voxels).empty());
  foreign = start;
  foreign.voxels.set({5, 5, 5}, 3);
  QVERIFY(complaint(foreign.voxels).find("do not lead to") != std::string::npos);
}

void HistoryTest::UndoAndRedoNeedAStep() {
  const LabelMap labels = blank({4, 4, 4});
  QVERIFY_THROWS_EXCEPTION(PreconditionError, History().undo(labels));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, History().redo(labels));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, History().undo_step());
  QVERIFY_THROWS_EXCEPTION(PreconditionError, History().redo_step());
  QVERIFY_THROWS_EXCEPTION(PreconditionError, History().undo_name());
  QVERIFY_THROWS_EXCEPTION(PreconditionError, History().redo_name());
}

QTEST_APPLESS_MAIN(HistoryTest)
#include "history_test.moc"
