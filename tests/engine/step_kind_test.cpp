// SPDX-License-Identifier: GPL-3.0-or-later
// What a hand has corrected, by the kinds of the history's steps: two that only this file knows count like
// the built-in ones.
#include "glisson/engine/step_kind.h"

#include <QTest>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "glisson/editing/history.h"
#include "glisson/editing/tool.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/labels.h"

using namespace glisson;
using namespace glisson::engine;
using structure::kArtery, structure::kPortalVein;

namespace {

constexpr StepKind kSprout{"sprout", StepKind::Work::grown, "Sprout"};
constexpr StepKind kTransplant{"transplant", StepKind::Work::imported, "Transplant"};
const RegisteredStepKind registered_sprout(kSprout), registered_transplant(kTransplant);

const editing::StepName kBrush{"paint", kPortalVein, 5e-3};

}  // namespace

class StepKindTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void EveryKindHasACodeOfItsOwn();
  void WhatNoKindIsKnownOfIsAHands();
  void GrowthTakesTheLabelFromTheHand();
  void GrowthAroundTheHandLeavesItWhatItKept();
  void NothingBeforeAnImportCounts();

 private:
  /// One voxel becomes a label, by a step of this name.
  void step(const editing::StepName& name, const Eigen::Vector3i& voxel, Label label) {
    LabelMap labels = *state_[part::labels];
    labels.voxels.set(voxel, label);
    state_[part::history] = std::make_shared<const editing::History>(
        state_[part::history]->with(name, *state_[part::labels], labels));
    state_[part::labels] = std::make_shared<const LabelMap>(std::move(labels));
  }
  bool is_by_hand(const Eigen::Vector3i& voxel) const { return hand_corrected(state_).at(voxel) == 1; }

  CaseState state_;
};

void StepKindTest::init() {
  VolumeGrid grid;
  grid.size = {8, 8, 8};
  LabelMap labels;
  labels.voxels = LabelVolume(grid);
  state_ = {};
  state_[part::labels] = std::make_shared<const LabelMap>(std::move(labels));
  state_[part::history] = std::make_shared<const editing::History>();
}

void StepKindTest::EveryKindHasACodeOfItsOwn() {
  std::set<std::string> codes;
  for (const editing::ToolKind* tool : editing::tools())
    for (const std::string& code : tool->steps()) codes.insert(code);
  for (const StepKind* kind : step_kinds())
    QVERIFY2(codes.insert(std::string(kind->code)).second, kind->code.data());
  for (const char* code : {"segment", "segment_around_hand", "correct_around", "import_labels", "sprout"})
    QVERIFY2(std::ranges::count(step_kinds(), code, [](const StepKind* kind) { return kind->code; }) == 1,
             code);
}

void StepKindTest::WhatNoKindIsKnownOfIsAHands() {
  QCOMPARE(work_of(kBrush), StepKind::Work::by_hand);
  QCOMPARE(work_of({"of_another_program", kArtery, 0.0}), StepKind::Work::by_hand);
  QCOMPARE(work_of(kSprout.name()), StepKind::Work::grown);
  step({"of_another_program", kArtery, 0.0}, {1, 1, 1}, kArtery);
  QCOMPARE(edited_by_hand(state_), std::set<Label>{kArtery});
  QVERIFY(is_by_hand({1, 1, 1}) && !is_by_hand({2, 2, 2}));
}

void StepKindTest::GrowthTakesTheLabelFromTheHand() {
  step(kBrush, {1, 1, 1}, kPortalVein);
  step({"paint", kArtery, 5e-3}, {3, 3, 3}, kArtery);
  QCOMPARE(edited_by_hand(state_), (std::set<Label>{kPortalVein, kArtery}));
  step(kSprout.name(), {2, 2, 2}, kPortalVein);
  QCOMPARE(edited_by_hand(state_), std::set<Label>{kArtery});
  QVERIFY(is_by_hand({3, 3, 3}) && !is_by_hand({2, 2, 2}));
  step(kBrush, {4, 4, 4}, kPortalVein);
  QVERIFY(is_by_hand({4, 4, 4}) && !is_by_hand({1, 1, 1}));
}

void StepKindTest::GrowthAroundTheHandLeavesItWhatItKept() {
  step(kBrush, {1, 1, 1}, kPortalVein);
  step(kBrush, {2, 2, 2}, kPortalVein);
  step({"segment_around_hand", structure::kBackground, 0.0}, {2, 2, 2}, kArtery);
  QCOMPARE(edited_by_hand(state_), std::set<Label>{kPortalVein});
  QVERIFY(is_by_hand({1, 1, 1}) && !is_by_hand({2, 2, 2}));
}

void StepKindTest::NothingBeforeAnImportCounts() {
  const std::vector<editing::StepName> imports = {kTransplant.name(),
                                                  {"import_labels", structure::kBackground, 0.0}};
  for (const editing::StepName& name : imports) {
    init();
    step(kBrush, {1, 1, 1}, kPortalVein);
    step(name, {2, 2, 2}, kArtery);
    QVERIFY(edited_by_hand(state_).empty());
    QVERIFY(!is_by_hand({1, 1, 1}) && !is_by_hand({2, 2, 2}));
  }
}

QTEST_APPLESS_MAIN(StepKindTest)
#include "step_kind_test.moc"
