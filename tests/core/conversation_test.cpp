// SPDX-License-Identifier: GPL-3.0-or-later
// A child that is asked things: what it answers, that it may be silent for ever, and what an end is.
#include <QTest>

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <stdexcept>
#include <string>

#include "glisson/core/child_process.h"
#include "glisson/core/files.h"

using namespace glisson;

namespace {

constexpr double kPatient = 60.0, kShort = 0.05;  // seconds

Conversation shell(const char* script) { return {"/bin/sh", {"-c", script}}; }

/// The whole group of processes that this one is in is asked to stop, as by Ctrl-C and by `timeout`. It is a
/// group of this test alone.
class AskedToStop {
 public:
  AskedToStop() {
    ::setpgid(0, 0);
    for (const int request : {SIGINT, SIGTERM}) std::signal(request, [](int) {});
  }
  AskedToStop(const AskedToStop&) = delete;
  AskedToStop& operator=(const AskedToStop&) = delete;
  ~AskedToStop() {
    for (const int request : {SIGINT, SIGTERM}) std::signal(request, SIG_DFL);
  }
  void all() const {
    for (const int request : {SIGINT, SIGTERM}) ::kill(0, request);
  }
};

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
  /// It is this process that decides what becomes of it: it would be taken for one that a file has broken.
  void AChildOutlivesWhatAsksTheWholeGroupToStop() {
    const AskedToStop asked;
    Conversation echo = shell("exec cat");
    for (const int number : {5, 6}) {
      int answer = 0;
      QVERIFY(echo.send(number, kPatient) && echo.receive(answer, kPatient));
      QCOMPARE(answer, number);
      asked.all();
    }
  }
  void AChildThatIsWaitedForOutlivesItToo() {
    const AskedToStop asked;
    const TemporaryFolder folder;
    const std::string told = (folder.path() / "told").string();
    const auto end = run_child("/bin/sh", {"-c", "echo; while [ ! -e " + told + " ]; do sleep 0.01; done"},
                               RunContext(), [&](const std::string&) {
                                 asked.all();
                                 std::ofstream{told};
                               });
    QVERIFY(end.has_value());
    QCOMPARE(end->signal, 0);
    QCOMPARE(end->code, 0);
  }
  void WhoHearsAChildMayThrow() {
    pid_t child = 0;
    const auto hear = [&](const std::string& line) {
      child = std::stoi(line);
      throw std::runtime_error("is not understood");
    };
    QVERIFY_THROWS_EXCEPTION(std::runtime_error,
                             run_child("/bin/sh", {"-c", "echo $$; exec sleep 600"}, RunContext(), hear));
    QVERIFY(child > 0);
    QVERIFY(::kill(child, 0) != 0 && errno == ESRCH);  // it has been ended, and nothing is left of it
  }

  void AChildThatTalksForEverIsEnded() {
    const auto end = run_child("/bin/sh", {"-c", "while echo; do sleep 0.01; done"}, RunContext(), {}, 0.3);
    QVERIFY(end.has_value());
    QCOMPARE(end->signal, SIGKILL);
  }

  /// And a cancel ends it all the same.
  void ACancelEndsAChild() {
    const auto cancel = std::make_shared<CancelFlag>();
    QVERIFY(!run_child("/bin/sh", {"-c", "echo; exec sleep 600"}, RunContext({}, cancel, 1),
                       [&](const std::string&) { cancel->request(); }));
  }
};

QTEST_APPLESS_MAIN(ConversationTest)
#include "conversation_test.moc"
