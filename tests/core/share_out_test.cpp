// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/share_out.h"

#include <QTest>
#include <array>
#include <atomic>
#include <latch>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace glisson;

class ShareOutTest : public QObject {
  Q_OBJECT
 private slots:
  void EachPieceIsDoneOnce();
  void TwoThreadsWorkAtATime();
  void OneThreadIsTheCallers();
  void TheFailureOfTheLowestPieceIsThrown();
  void NoPieceIsBegunAfterAFailure();
  void RunsCoverEachPlaceOnce();
  void AShortRunBeginsNoThread();
};

void ShareOutTest::EachPieceIsDoneOnce() {
  for (const std::size_t pieces : {0, 1, 2, 1001})
    for (const int threads : {1, 2}) {
      std::vector<int> done(pieces, 0);
      share_out(pieces, threads, [&](std::size_t piece, bool) { ++done[piece]; });
      QCOMPARE(done, std::vector<int>(pieces, 1));
    }
}

void ShareOutTest::TwoThreadsWorkAtATime() {
  // Each waits for the other: one thread would wait for ever.
  std::latch both(2);
  std::array<std::thread::id, 2> who;
  std::array<bool, 2> is_here{};
  share_out(2, 2, [&](std::size_t piece, bool here) {
    both.arrive_and_wait();
    who.at(piece) = std::this_thread::get_id();
    is_here.at(piece) = here;
  });
  QVERIFY(who[0] != who[1] && is_here[0] != is_here[1]);
  QVERIFY(who.at(is_here[0] ? 0 : 1) == std::this_thread::get_id());
}

void ShareOutTest::OneThreadIsTheCallers() {
  std::vector<std::size_t> order;
  share_out(5, 1, [&](std::size_t piece, bool here) {
    QVERIFY(here);
    order.push_back(piece);
  });
  QCOMPARE(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

void ShareOutTest::TheFailureOfTheLowestPieceIsThrown() {
  std::latch both(2);
  std::string told;
  try {
    share_out(2, 2, [&](std::size_t piece, bool) {
      both.arrive_and_wait();
      throw std::runtime_error(std::to_string(piece));
    });
  } catch (const std::runtime_error& error) {
    told = error.what();
  }
  QCOMPARE(told, std::string("0"));
}

void ShareOutTest::NoPieceIsBegunAfterAFailure() {
  std::atomic<int> begun{0};
  QVERIFY_THROWS_EXCEPTION(std::runtime_error, share_out(1000, 1, [&](std::size_t piece, bool) {
                             ++begun;
                             if (piece == 3) throw std::runtime_error("at the fourth");
                           }));
  QCOMPARE(begun.load(), 4);
}

void ShareOutTest::RunsCoverEachPlaceOnce() {
  for (const std::size_t count : {0, 1, 15, 16, 17, 1000})
    for (const std::size_t least : {0, 1, 7, 5000}) {
      std::vector<int> done(count, 0);
      std::atomic<bool> is_long_enough{true};
      share_out_runs(count, least, [&](std::size_t first, std::size_t end) {
        if (end - first < least && end != count) is_long_enough = false;
        for (std::size_t at = first; at < end; ++at) ++done[at];
      });
      QCOMPARE(done, std::vector<int>(count, 1));
      QVERIFY(is_long_enough);
    }
}

void ShareOutTest::AShortRunBeginsNoThread() {
  bool is_callers = false;
  std::atomic<int> runs{0};
  share_out_runs(100, 100, [&, caller = std::this_thread::get_id()](std::size_t, std::size_t) {
    is_callers = std::this_thread::get_id() == caller;
    ++runs;
  });
  QVERIFY(is_callers && runs == 1);
}

QTEST_APPLESS_MAIN(ShareOutTest)
#include "share_out_test.moc"
