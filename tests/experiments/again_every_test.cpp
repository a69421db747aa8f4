// SPDX-License-Identifier: GPL-3.0-or-later
// Who registers again without a person: when, what is taken, and what becomes of failures.
#include "glisson/experiments/again_every.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/engine/commands/take_registration.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/other_registration.h"

using namespace glisson;
using namespace glisson::experiments;

class AgainEveryTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void ItComesEverySoManySeconds();
  void WhatIsNotFollowedIsPutOffToTheNextFrame();
  void OnlyTheBetterOneIsTaken();
  void AFailureLeavesTheTrackGoing();
  void ACancelEndsIt();

 private:
  void put_live(Validity validity, bool has_tissue) {
    engine::LiveState live;
    live.overlay.validity = validity;
    LabelledCloud tissue;
    tissue.points = Points::Zero(40, 3);
    if (has_tissue) live.tissue_at_start = std::make_shared<const LabelledCloud>(std::move(tissue));
    state_[part::live] = std::make_shared<const engine::LiveState>(live);
  }
  AgainEvery every(double seconds) {
    return AgainEvery(
        seconds, {},
        [this](engine::Command command) {
          posted_.emplace_back(command.code());
          if (fails_) throw Error("registration: cannot be made. Show more.");
          if (command.as<engine::RegisterAgain>() == nullptr) return;
          engine::OtherRegistration other;
          other.is_better = is_better_;
          other.former_gap = 1.5e-3;
          other.gap = 0.4e-3;
          state_[part::other_registration] = std::make_shared<const engine::OtherRegistration>(other);
        },
        [this]() -> const engine::CaseState& { return state_; });
  }

  engine::CaseState state_;
  std::vector<std::string> posted_;
  bool fails_ = false, is_better_ = true;
};

void AgainEveryTest::init() {
  state_ = {};
  posted_.clear();
  fails_ = false;
  is_better_ = true;
  put_live(Validity::valid, true);
}

void AgainEveryTest::ItComesEverySoManySeconds() {
  AgainEvery again = every(2.0);
  std::vector<int> frames;
  for (int k = 0; k < 200; ++k)
    if (again.after(k, k / 30.0, RunContext())) frames.push_back(k);
  QCOMPARE(frames, (std::vector<int>{60, 120, 180}));
  AgainEvery never = every(0.0);
  QVERIFY(!never.after(1000, 1000.0, RunContext()));
}

void AgainEveryTest::WhatIsNotFollowedIsPutOffToTheNextFrame() {
  AgainEvery again = every(2.0);
  put_live(Validity::too_few_points, true);
  QVERIFY(!again.after(60, 2.0, RunContext()));
  put_live(Validity::valid, false);
  QVERIFY(!again.after(61, 2.03, RunContext()));
  QVERIFY(posted_.empty());
  put_live(Validity::surface_apart, true);  // followed, though refuted: the one that needs it
  QVERIFY(again.after(62, 2.07, RunContext()));
  QVERIFY(!again.after(63, 2.1, RunContext()));
}

void AgainEveryTest::OnlyTheBetterOneIsTaken() {
  AgainEvery again = every(1.0);
  const auto taken = again.after(30, 1.0, RunContext());
  QVERIFY(taken->line.is_taken && taken->problem.empty());
  QCOMPARE(taken->line.frame, 30);
  QCOMPARE(taken->line.gap, 0.4e-3);
  QCOMPARE(posted_, (std::vector<std::string>{"register_again", "take_registration"}));
  is_better_ = false;
  const auto left = again.after(60, 2.0, RunContext());
  QVERIFY(!left->line.is_taken && left->problem.empty());
  QCOMPARE(posted_.size(), std::size_t{3});
}

void AgainEveryTest::AFailureLeavesTheTrackGoing() {
  AgainEvery again = every(1.0);
  fails_ = true;
  const auto tried = again.after(30, 1.0, RunContext());
  QVERIFY(!tried->line.is_taken);
  QCOMPARE(tried->problem, std::string("registration: cannot be made. Show more."));
  fails_ = false;
  QVERIFY(again.after(60, 2.0, RunContext())->problem.empty());
}

void AgainEveryTest::ACancelEndsIt() {
  AgainEvery again = every(1.0);
  fails_ = true;
  auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  QVERIFY_THROWS_EXCEPTION(Error, again.after(30, 1.0, RunContext({}, cancel, 1)));
}

QTEST_APPLESS_MAIN(AgainEveryTest)
#include "again_every_test.moc"
