// SPDX-License-Identifier: GPL-3.0-or-later
// Two writers of one case: the second is told who the first is, and nothing of either is lost.
#include "glisson/engine/case_lock.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/keeping.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/script.h"
#include "runners.h"
#include "seeded_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::seed_of;
using test::seed_on_disk;
using test::seeds;
namespace fs = std::filesystem;

namespace {

using Access = OpenCase::Access;

/// A program of its own that has the case open, until it is killed.
class OtherProgram {
 public:
  explicit OtherProgram(const fs::path& path) {
    int told[2];
    if (::pipe(told) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
      Script script{RunContext()};
      char success = 'y';
      try {
        script.run(OpenCase{path, Access::write});
      } catch (const Error&) {
        success = 'n';
      }
      (void)!::write(told[1], &success, 1);
      for (;;) ::pause();
    }
    (void)!::read(told[0], &answer_, 1);
    ::close(told[0]);
    ::close(told[1]);
  }
  ~OtherProgram() { kill(); }
  void kill() {
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
    process_ = 0;
  }
  bool has_it() const { return answer_ == 'y'; }
  pid_t process() const { return process_; }

 private:
  pid_t process_ = 0;
  char answer_ = '?';
};

std::string refusal(Script& script, const Command& command) {
  try {
    script.run(command);
    return {};
  } catch (const Error& failure) {
    return failure.what();
  }
}

bool says(const std::string& sentence, const std::string& word) {
  return sentence.find(word) != std::string::npos;
}

}  // namespace

class CaseLockTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup() { folder_.reset(); }
  void ASecondWriterIsToldWho();
  void ASecondWriterMayRead();
  void WhatIsOpenForReadingIsSavedOnceTheWriterHasGone();
  void OfTwoThatReadNoneLosesItsWork();
  void AWriterThatWasKilledHoldsNothing();
  void ALockOfAnotherMachineIsBelieved();
  void ALockFromBeforeTheLastStartIsStale();
  void TheOpenCaseMayBeOpenedAgain();
  void ClosingLetsGo();
  void TheSameCaseThroughALinkIsTheSame();
  void ALockIsNoWayToAnotherFile();
  void APipeInTheLocksPlaceIsNotWaitedFor();
  void WhatIsNoLockIsNotWrittenOver_data();
  void WhatIsNoLockIsNotWrittenOver();
  void ALockThatIsHeldWithoutANameIsHeld();
  void WhoIsOvertakenWhileSavingGoesBeside_data();
  void WhoIsOvertakenWhileSavingGoesBeside();
  void WhatALockSaysCommandsNoTerminal();
  void ALockThatCannotBeWrittenNamesItsOwner();
  void AnotherCaseIsReplacedOnlyWhenSaid();
  void ASaveThatIsCancelledTooLateIsDone();

 private:
  fs::path path() const { return folder_->path() / "a.glisson"; }
  std::unique_ptr<TemporaryFolder> folder_;
};

void CaseLockTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  Script script{RunContext()};
  script.run(seeds(0.1));
  script.run(SaveCase{path()});
}

void CaseLockTest::ASecondWriterIsToldWho() {
  const OtherProgram other(path());
  QVERIFY(other.has_it());
  Script script{RunContext()};
  const std::string told = refusal(script, OpenCase{path(), Access::write});
  QVERIFY2(says(told, "is open for writing by"), told.c_str());
  QVERIFY2(says(told, "process " + std::to_string(other.process())), told.c_str());
  // Without having opened it, a save over it is refused as well.
  script.run(seeds(0.2));
  QVERIFY(says(refusal(script, SaveCase{path()}), "is open for writing by"));
  QCOMPARE(seed_on_disk(path()), 0.1);
}

void CaseLockTest::ASecondWriterMayRead() {
  const OtherProgram other(path());
  Script script{RunContext()};
  QVERIFY(script.run(OpenCase{path(), Access::read})->notes.empty());
  const auto opened = script.run(OpenCase{path()});
  QCOMPARE(opened->notes.size(), std::size_t{1});
  QVERIFY(opened->notes[0].starts_with("case.open_for_reading "));
  QVERIFY(says(opened->notes[0], "process " + std::to_string(other.process())));
  QVERIFY(!script.state()[part::keeping]->lock);
  script.run(seeds(0.2));
  QVERIFY(says(refusal(script, SaveCase{}), "is open for writing by"));
  script.run(SaveCase{folder_->path() / "b.glisson"});
  QCOMPARE(seed_on_disk(path()), 0.1);
  QCOMPARE(seed_on_disk(folder_->path() / "b.glisson"), 0.2);
}

void CaseLockTest::WhatIsOpenForReadingIsSavedOnceTheWriterHasGone() {
  OtherProgram other(path());
  Script script{RunContext()};
  script.run(OpenCase{path()});
  script.run(seeds(0.2));
  other.kill();
  QVERIFY(script.run(SaveCase{})->notes.empty());
  QVERIFY(script.state()[part::keeping]->lock);
  QCOMPARE(seed_on_disk(path()), 0.2);
}

void CaseLockTest::OfTwoThatReadNoneLosesItsWork() {
  // As two 'edit' runs did that began at the same time: each had read the same case.
  Script one{RunContext()}, two{RunContext()};
  one.run(OpenCase{path(), Access::read});
  two.run(OpenCase{path(), Access::read});
  one.run(seeds(0.2));
  two.run(seeds(0.3));
  one.run(SaveCase{});
  QVERIFY(says(refusal(two, SaveCase{}), "is open for writing by"));
  one.run(OpenCase{path(), Access::read});  // lets go
  const auto saved = two.run(SaveCase{});
  QCOMPARE(saved->notes,
           std::vector<std::string>{"case.saved_beside " + (folder_->path() / "a (2).glisson").string()});
  QCOMPARE(seed_on_disk(path()), 0.2);
  QCOMPARE(seed_on_disk(folder_->path() / "a (2).glisson"), 0.3);
  QCOMPARE(two.state().path, folder_->path() / "a (2).glisson");
  two.run(seeds(0.4));
  QVERIFY(two.run(SaveCase{})->notes.empty());  // goes on there
  QCOMPARE(seed_on_disk(folder_->path() / "a (2).glisson"), 0.4);
}

void CaseLockTest::AWriterThatWasKilledHoldsNothing() {
  OtherProgram other(path());
  other.kill();
  QVERIFY(fs::exists(lock_file_of(path())));
  Script script{RunContext()};
  QVERIFY(script.run(OpenCase{path(), Access::write})->notes.empty());
}

void CaseLockTest::ALockOfAnotherMachineIsBelieved() {
  write_file_atomically(lock_file_of(path()),
                        R"({"user":"anna","host":"another.example","process":1,"boot":"x","since":"then"})");
  Script script{RunContext()};
  const std::string told = refusal(script, OpenCase{path(), Access::write});
  QVERIFY2(says(told, "anna on another.example (process 1, since then)"), told.c_str());
  QVERIFY2(says(told, "remove " + lock_file_of(path()).string()), told.c_str());
  fs::remove(lock_file_of(path()));
  QCOMPARE(refusal(script, OpenCase{path(), Access::write}), std::string());
}

void CaseLockTest::ALockFromBeforeTheLastStartIsStale() {
  char host[256] = {};
  QCOMPARE(::gethostname(host, sizeof host - 1), 0);
  // Process 1 is always there.
  write_file_atomically(lock_file_of(path()),
                        std::string(R"({"user":"anna","host":")") + host +
                            R"(","process":1,"boot":"of another start","since":"then"})");
  Script script{RunContext()};
  QCOMPARE(refusal(script, OpenCase{path(), Access::write}), std::string());
}

void CaseLockTest::TheOpenCaseMayBeOpenedAgain() {
  Script script{RunContext()};
  script.run(OpenCase{path(), Access::write});
  script.run(seeds(0.2));
  script.run(OpenCase{path(), Access::write});
  QCOMPARE(seed_of(script.state()), 0.1);
  QVERIFY(!OtherProgram(path()).has_it());
}

void CaseLockTest::ClosingLetsGo() {
  {
    Script script{RunContext()};
    script.run(OpenCase{path(), Access::write});
    QVERIFY(!OtherProgram(path()).has_it());
    script.run(SaveCase{folder_->path() / "b.glisson"});
    QVERIFY(OtherProgram(path()).has_it());
    QVERIFY(!OtherProgram(folder_->path() / "b.glisson").has_it());
  }
  QVERIFY(OtherProgram(folder_->path() / "b.glisson").has_it());
  Script script{RunContext()};
  script.run(OpenCase{path(), Access::write});
  script.run(OpenCase{path(), Access::read});
  QVERIFY(!fs::exists(lock_file_of(path())));
}

void CaseLockTest::TheSameCaseThroughALinkIsTheSame() {
  fs::create_directory(folder_->path() / "desk");
  fs::create_directory_symlink(path(), folder_->path() / "desk/link.glisson");
  Script script{RunContext()};
  script.run(OpenCase{folder_->path() / "desk/link.glisson", Access::write});
  QVERIFY(!OtherProgram(path()).has_it());
  script.run(seeds(0.2));
  script.run(SaveCase{});
  QVERIFY(fs::is_symlink(folder_->path() / "desk/link.glisson"));
  QCOMPARE(seed_on_disk(path()), 0.2);
}

void CaseLockTest::ALockIsNoWayToAnotherFile() {
  write_file_atomically(folder_->path() / "precious.txt", "precious");
  fs::create_symlink("precious.txt", lock_file_of(path()));
  Script script{RunContext()};
  QVERIFY(!refusal(script, OpenCase{path(), Access::write}).empty());
  QCOMPARE(read_file(folder_->path() / "precious.txt"), std::string("precious"));
}

/// As a person who may write the folder, but not the lock of another one.
class AsAnother {
 public:
  explicit AsAnother(const fs::path& lock) : is_root_(::geteuid() == 0) {
    constexpr uid_t kNobody = 65534;
    if (is_root_)
      (void)!::seteuid(kNobody);
    else
      fs::permissions(lock, fs::perms::owner_read | fs::perms::group_read);
  }
  ~AsAnother() {
    if (is_root_) (void)!::seteuid(0);
  }

 private:
  bool is_root_;
};

void CaseLockTest::APipeInTheLocksPlaceIsNotWaitedFor() {
  fs::remove(lock_file_of(path()));
  QCOMPARE(::mkfifo(lock_file_of(path()).c_str(), 0444), 0);
  std::optional<CaseOwner> owner;
  QVERIFY(CaseLock::take(path(), owner) == nullptr && owner.has_value());
  QVERIFY(fs::is_fifo(lock_file_of(path())));
}

void CaseLockTest::WhatIsNoLockIsNotWrittenOver_data() {
  QTest::addColumn<bool>("is_linked");
  QTest::newRow("another name of another file") << true;
  QTest::newRow("another file") << false;
}

void CaseLockTest::WhatIsNoLockIsNotWrittenOver() {
  QFETCH(bool, is_linked);
  const fs::path precious = folder_->path() / "precious.txt", lock = lock_file_of(path());
  // Empty, a file cannot be told from a lock whose writer has just made it; by its names it can.
  write_file_atomically(precious, is_linked ? "" : "precious");
  if (is_linked)
    fs::create_hard_link(precious, lock);
  else
    fs::rename(precious, lock);
  const std::string before = read_file(lock);
  Script script{RunContext()};
  const std::string told = refusal(script, OpenCase{path(), Access::write});
  QVERIFY2(says(told, "remove " + lock.string()), told.c_str());
  script.run(seeds(0.2));
  QVERIFY(!refusal(script, SaveCase{path(), true}).empty());
  QCOMPARE(read_file(lock), before);
  QCOMPARE(seed_on_disk(path()), 0.1);
}

void CaseLockTest::ALockThatIsHeldWithoutANameIsHeld() {
  const fs::path place = folder_->path() / "new.glisson";
  const Claim other(::open(lock_file_of(place).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  QVERIFY(other.take());
  for (const char* text : {"", "x"}) {
    QVERIFY(::pwrite(other.descriptor(), text, std::strlen(text), 0) >= 0);
    Script script{RunContext()};
    script.run(seeds(0.2));
    const std::string told = refusal(script, SaveCase{place});
    QVERIFY2(says(told, "is open for writing by somebody"), told.c_str());
    QVERIFY(!fs::exists(place));
  }
}

void CaseLockTest::WhoIsOvertakenWhileSavingGoesBeside_data() {
  QTest::addColumn<bool>("is_new");
  QTest::newRow("its own case") << false;
  QTest::newRow("a new one") << true;
}

void CaseLockTest::WhoIsOvertakenWhileSavingGoesBeside() {
  QFETCH(bool, is_new);
  const fs::path place = is_new ? folder_->path() / "new.glisson" : path();
  const fs::path beside = folder_->path() / (is_new ? "new (2).glisson" : "a (2).glisson");
  Engine::Options options = test::options_of(Runner::inline_);
  bool is_over = false;
  options.progress = [&](const Progress& progress) {
    if (progress.stage != "case.verify" || is_over) return;
    is_over = true;
    fs::remove(lock_file_of(place));  // somebody took it for a stale one
    Script other{RunContext()};
    other.run(seeds(0.9));
    other.run(SaveCase{place, true});
  };
  Engine engine(std::move(options));
  if (!is_new) engine.wait(engine.post(OpenCase{place, Access::write}));
  engine.wait(engine.post(seeds(0.2)));
  const Outcome saved = engine.wait(engine.post(SaveCase{place}));
  QVERIFY(is_over);
  QVERIFY2(saved.status == Status::done, saved.error.c_str());
  QCOMPARE(saved.notes, std::vector<std::string>{"case.saved_beside " + beside.string()});
  QCOMPARE(seed_on_disk(place), 0.9);
  QCOMPARE(seed_on_disk(beside), 0.2);
  QCOMPARE(engine.snapshot()->state.path, beside);
}

void CaseLockTest::WhatALockSaysCommandsNoTerminal() {
  CaseOwner owner;
  owner.user = "anna\x1b[2J\nglisson: all is well";
  owner.host = "another.example";
  owner.since = std::string(3000, 'x');
  const std::string told = owner.told();
  QVERIFY(told.size() < 300);
  QVERIFY(std::ranges::all_of(told, [](char c) { return static_cast<unsigned char>(c) >= 0x20; }));
}

void CaseLockTest::ALockThatCannotBeWrittenNamesItsOwner() {
  const QTemporaryDir folder;  // below which others may come
  const fs::path shared = folder.path().toStdString();
  fs::permissions(shared, fs::perms::all);
  std::optional<CaseOwner> owner;
  auto held = CaseLock::take(shared / "a.glisson", owner);
  QVERIFY(held && !owner);
  {
    const AsAnother person(lock_file_of(shared / "a.glisson"));
    QVERIFY(!CaseLock::take(shared / "a.glisson", owner));
    QVERIFY(owner);
    QCOMPARE(owner->process, static_cast<long>(::getpid()));
    QVERIFY(!owner->host.empty());
  }
  // One that was left behind is made anew.
  const std::string written = read_file(lock_file_of(shared / "a.glisson"));
  held.reset();
  write_file_atomically(lock_file_of(shared / "a.glisson"), written);
  const AsAnother person(lock_file_of(shared / "a.glisson"));
  QVERIFY(CaseLock::take(shared / "a.glisson", owner) && !owner);
}

void CaseLockTest::AnotherCaseIsReplacedOnlyWhenSaid() {
  Script script{RunContext()};
  script.run(seeds(0.2));
  QVERIFY(says(refusal(script, SaveCase{path()}), "is another case"));
  QCOMPARE(seed_on_disk(path()), 0.1);
  QVERIFY(script.run(SaveCase{path(), true})->notes.empty());
  QCOMPARE(seed_on_disk(path()), 0.2);
  script.run(seeds(0.3));
  script.run(SaveCase{path()});  // its own by now
  QCOMPARE(seed_on_disk(path()), 0.3);
}

void CaseLockTest::ASaveThatIsCancelledTooLateIsDone() {
  Engine::Options options = test::options_of(Runner::inline_);
  Engine* made = nullptr;
  options.progress = [&](const Progress& progress) {
    if (progress.stage == "case.saved") made->cancel(progress.id);
  };
  Engine engine(std::move(options));
  made = &engine;
  const fs::path place = folder_->path() / "late.glisson";
  engine.wait(engine.post(seeds(0.2)));
  QCOMPARE(engine.wait(engine.post(SaveCase{place})).status, Status::done);
  engine.wait(engine.post(seeds(0.3)));
  const Outcome again = engine.wait(engine.post(SaveCase{}));
  QCOMPARE(again.status, Status::done);
  QVERIFY(again.notes.empty());  // nobody else has saved there
  QCOMPARE(seed_on_disk(place), 0.3);
}

QTEST_APPLESS_MAIN(CaseLockTest)
#include "case_lock_test.moc"
