// SPDX-License-Identifier: GPL-3.0-or-later
// A child that is asked things: what it answers, that it may be silent for ever, and what an end is.
#include <QTest>

#include "glisson/core/child_process.h"

using namespace glisson;

namespace {

constexpr double kPatient = 60.0, kShort = 0.05;  // seconds

Conversation shell(const char* script) { return {"/bin/sh", {"-c", script}}; }

}  // namespace

class ConversationTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsAskedIsAnswered() {
    Conversation echo = shell("exec cat");
    for (const int number : {7, -3}) {
      int answer = 0;
      QVERIFY(echo.send(number, kPatient) && echo.receive(answer, kPatient));
      QCOMPARE(answer, number);
    }
  }
  /// And it is killed: nothing is believed of it any more.
  void ASilentChildIsGivenUp() {
    Conversation silent = shell("exec sleep 600");
    char byte = 0;
    QVERIFY(!silent.waits_for(kShort));
    QVERIFY(!silent.receive(byte, kShort));
    QVERIFY(!silent.send(byte, kPatient) && !silent.receive(byte, kPatient));
  }
  void AChildThatReadsNothingIsGivenUp() {
    Conversation deaf = shell("exec sleep 600 <&-");
    const std::vector<char> much(std::size_t{1} << 24U);
    QVERIFY(!deaf.send(much.data(), much.size(), kShort));
  }
  void AnEndIsNoAnswer() {
    Conversation brief = shell("printf ab");
    char bytes[3] = {};
    QVERIFY(!brief.receive(bytes, 3, kPatient));
  }
};

QTEST_APPLESS_MAIN(ConversationTest)
#include "conversation_test.moc"
