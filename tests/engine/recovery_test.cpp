// SPDX-License-Identifier: GPL-3.0-or-later
// Copies of what is not saved: found after a kill, gone after a good end, never over what others saved.
#include "glisson/engine/recovery.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/keep_copy.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/recover_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/keeping.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/script.h"
#include "seeded_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::seed_of;
using test::seed_on_disk;
using test::seeds;
namespace fs = std::filesystem;

class RecoveryTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { folder_ = std::make_unique<TemporaryFolder>(); }
  void cleanup() { folder_.reset(); }
  void WhatAKilledProgramHadIsFound();
  void WhatARunningProgramHasIsNotOffered();
  void AGoodEndLeavesNothing();
  void ACopyThatWasCutShortIsNone();
  void ACopyThatCannotBeReadNowStays();
  void KeepingACopyLeavesTheCaseAlone();
  void ACaseThatWasNeverSavedComesBackWithoutAPlace();
  void WhatOthersSavedMeanwhileStays();
  void RecoveredACaseIsHeldAgain();
  void WhatIsOpenHereIsRecoveredForWriting();
  void ACopyNeverStandsUnderAnotherCasesName();

 private:
  fs::path root() const { return folder_->path() / "recovery"; }
  fs::path path() const { return folder_->path() / "a.glisson"; }
  /// A program that works on a case, keeps copies and is killed. @param saved whether the case has a place.
  void killed_at_work(bool saved) const {
    int told[2];
    QCOMPARE(::pipe(told), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      Script script{RunContext()};
      script.run(seeds(0.1));
      if (saved) script.run(SaveCase{path()});
      const RecoveryFolder folder(root());
      for (const double x : {0.2, 0.3}) {
        script.run(seeds(x));
        script.run(KeepCopy{folder.path()});
      }
      (void)!::write(told[1], "x", 1);
      for (;;) ::pause();
    }
    char byte = 0;
    QCOMPARE(::read(told[0], &byte, 1), ssize_t{1});
    QVERIFY(find_recoverable(root()).empty());  // it still runs
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    ::close(told[0]);
    ::close(told[1]);
  }
  std::unique_ptr<TemporaryFolder> folder_;
};

void RecoveryTest::WhatAKilledProgramHadIsFound() {
  killed_at_work(true);
  const auto found = find_recoverable(root());
  QCOMPARE(found.size(), std::size_t{1});
  QCOMPARE(found[0].of, path());
  QVERIFY(!found[0].saved.empty());
  QCOMPARE(seed_on_disk(found[0].copy), 0.3);
  QCOMPARE(seed_on_disk(path()), 0.1);
  QCOMPARE(static_cast<int>(fs::status(root()).permissions()), 0700);
  Script script{RunContext()};
  script.run(RecoverCase{found[0]});
  QCOMPARE(seed_of(script.state()), 0.3);
  QCOMPARE(script.state().path, path());
  QCOMPARE(seed_on_disk(path()), 0.1);  // until somebody saves
  QVERIFY(script.run(SaveCase{})->notes.empty());
  QCOMPARE(seed_on_disk(path()), 0.3);
  discard(found[0]);
  QVERIFY(find_recoverable(root()).empty() && fs::is_empty(root()));
}

void RecoveryTest::WhatARunningProgramHasIsNotOffered() {
  const RecoveryFolder own(root());
  Script script{RunContext()};
  script.run(seeds(0.1));
  script.run(KeepCopy{own.path()});
  QVERIFY(find_recoverable(root()).empty());
  QVERIFY(fs::exists(own.path()));
}

void RecoveryTest::AGoodEndLeavesNothing() {
  {
    const RecoveryFolder own(root());
    Script script{RunContext()};
    script.run(seeds(0.1));
    script.run(KeepCopy{own.path()});
    own.clear();
    QVERIFY(fs::is_empty(own.path()));
    script.run(KeepCopy{own.path()});
  }
  QVERIFY(fs::is_empty(root()));
}

void RecoveryTest::ACopyThatWasCutShortIsNone() {
  killed_at_work(true);
  const auto found = find_recoverable(root());
  fs::remove(found.at(0).copy / "case.json");
  QVERIFY(find_recoverable(root()).empty());
  QVERIFY(fs::is_empty(root()));  // and is removed
}

/// It may be the only copy of somebody's work: a disk that fails for a moment is no reason to remove it.
void RecoveryTest::ACopyThatCannotBeReadNowStays() {
  killed_at_work(true);
  const fs::path said = find_recoverable(root()).at(0).folder / "copy.json";
  fs::rename(said, folder_->path() / "aside.json");
  fs::create_directory(said);  // to open it fails, whoever asks
  QVERIFY(find_recoverable(root()).empty());
  fs::remove(said);
  fs::rename(folder_->path() / "aside.json", said);
  QCOMPARE(find_recoverable(root()).size(), std::size_t{1});
}

void RecoveryTest::KeepingACopyLeavesTheCaseAlone() {
  const RecoveryFolder own(root());
  Script script{RunContext()};
  script.run(seeds(0.1));
  script.run(SaveCase{path()});
  script.run(seeds(0.2));
  const auto before = script.state()[part::keeping];
  script.run(KeepCopy{own.path()});
  QCOMPARE(script.state().path, path());
  QVERIFY(script.state()[part::keeping] == before);
  QCOMPARE(seed_on_disk(path()), 0.1);
}

void RecoveryTest::ACaseThatWasNeverSavedComesBackWithoutAPlace() {
  killed_at_work(false);
  const auto found = find_recoverable(root());
  QCOMPARE(found.size(), std::size_t{1});
  QVERIFY(found[0].of.empty());
  Script script{RunContext()};
  script.run(RecoverCase{found[0]});
  QCOMPARE(seed_of(script.state()), 0.3);
  QVERIFY(script.state().path.empty() && !script.state()[part::keeping]);
}

void RecoveryTest::WhatOthersSavedMeanwhileStays() {
  killed_at_work(true);
  {
    Script other{RunContext()};
    other.run(OpenCase{path(), OpenCase::Access::write});
    other.run(seeds(0.9));
    other.run(SaveCase{});
  }
  Script script{RunContext()};
  script.run(RecoverCase{find_recoverable(root()).at(0)});
  const auto saved = script.run(SaveCase{});
  QCOMPARE(saved->notes.size(), std::size_t{1});
  QVERIFY(saved->notes[0].starts_with("case.saved_beside "));
  QCOMPARE(seed_on_disk(path()), 0.9);
  QCOMPARE(seed_on_disk(folder_->path() / "a (2).glisson"), 0.3);
}

void RecoveryTest::RecoveredACaseIsHeldAgain() {
  killed_at_work(true);
  Script script{RunContext()};
  script.run(RecoverCase{find_recoverable(root()).at(0)});
  Script other{RunContext()};
  QVERIFY_THROWS_EXCEPTION(Error, other.run(OpenCase{path(), OpenCase::Access::write}));
}

/// As after a crash the window is begun with the case, and offers the copy.
void RecoveryTest::WhatIsOpenHereIsRecoveredForWriting() {
  killed_at_work(true);
  Script script{RunContext()};
  script.run(OpenCase{path()});
  QVERIFY(script.state()[part::keeping]->lock);
  const auto recovered = script.run(RecoverCase{find_recoverable(root()).at(0)});
  QVERIFY(recovered->notes.empty());
  QVERIFY(script.state()[part::keeping]->lock && !script.state()[part::keeping]->writer);
  script.run(SaveCase{});
  QCOMPARE(seed_on_disk(path()), 0.3);
  Script other{RunContext()};
  QVERIFY_THROWS_EXCEPTION(Error, other.run(OpenCase{path(), OpenCase::Access::write}));
}

void RecoveryTest::ACopyNeverStandsUnderAnotherCasesName() {
  const RecoveryFolder own(root());
  Script one{RunContext()};
  one.run(seeds(0.1));
  one.run(SaveCase{path()});
  one.run(KeepCopy{own.path()});
  QVERIFY(fs::exists(own.path() / "copy.json"));
  // The next patient's copy is written, and the program ends before it has said whose it is.
  const auto end = [](double, std::string_view stage) {
    if (stage == "case.saved") throw FileError("the end");
  };
  Script other{RunContext(end, nullptr, 1)};
  other.run(seeds(0.9));
  QVERIFY_THROWS_EXCEPTION(Error, other.run(KeepCopy{own.path()}));
  QCOMPARE(seed_on_disk(own.path() / "copy.glisson"), 0.9);
  QVERIFY(!fs::exists(own.path() / "copy.json"));
}

QTEST_APPLESS_MAIN(RecoveryTest)
#include "recovery_test.moc"
