// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/aside.h"

#include <QTest>
#include <latch>
#include <memory>
#include <stdexcept>
#include <thread>

using namespace glisson;

namespace {

/// Waits as a driver does, until the test lets it go on.
struct Driver {
  std::latch begun{1}, goes_on{1}, ended{1};
  void call() {
    begun.count_down();
    goes_on.wait();
    ended.count_down();
  }
};

}  // namespace

class AsideTest : public QObject {
  Q_OBJECT
 private slots:
  void CallsAreDoneElsewhereOneAfterTheOther();
  void WhatACallThrowsIsThrown();
  void CancelLetsGoOfACallThatDoesNotEnd();
};

void AsideTest::CallsAreDoneElsewhereOneAfterTheOther() {
  Aside aside;
  int done = 0;
  std::thread::id there;
  for (int i = 1; i <= 100; ++i) {
    QVERIFY(aside.run([&] { ++done, there = std::this_thread::get_id(); }, RunContext()));
    QCOMPARE(done, i);
  }
  QVERIFY(there != std::this_thread::get_id());
}

void AsideTest::WhatACallThrowsIsThrown() {
  Aside aside;
  QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                           aside.run([] { throw std::runtime_error("unplugged"); }, RunContext()));
  int done = 0;
  QVERIFY(aside.run([&] { ++done; }, RunContext()));  // it goes on
  QCOMPARE(done, 1);
}

void AsideTest::CancelLetsGoOfACallThatDoesNotEnd() {
  const auto driver = std::make_shared<Driver>();
  const auto cancel = std::make_shared<CancelFlag>();
  const RunContext context({}, cancel, 1);
  std::jthread hand([&] {
    driver->begun.wait();
    cancel->request();
  });
  auto aside = std::make_unique<Aside>();
  QVERIFY(!aside->run([driver] { driver->call(); }, context));
  bool is_done = false;
  QVERIFY(!aside->run([&] { is_done = true; }, RunContext()));
  aside.reset();  // does not wait
  QVERIFY(!driver->ended.try_wait());
  driver->goes_on.count_down();
  driver->ended.wait();  // it has gone on alone
  QVERIFY(!is_done);
}

QTEST_APPLESS_MAIN(AsideTest)
#include "aside_test.moc"
