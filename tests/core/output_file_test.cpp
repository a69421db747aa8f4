// SPDX-License-Identifier: GPL-3.0-or-later
// Writing harms nothing but what it is to replace, and what was killed on its way is known and removed.
#include "glisson/core/output_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include <fstream>
#include <set>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "remove_tree.h"
#include "take_soon.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

std::string refusal(const fs::path& path) {
  return test::complaint<FileError>([&] { write_file_atomically(path, "new"); });
}

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> all;
  for (const auto& entry : fs::directory_iterator(folder)) all.insert(entry.path().filename().string());
  return all;
}

/// A child that does `work` and is killed in the middle of it, as soon as it says so.
template <class Work>
void killed(const Work& work) {
  int told[2];
  QCOMPARE(::pipe(told), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    work([&] {
      (void)!::write(told[1], "x", 1);
      for (;;) ::pause();
    });
    ::_exit(0);
  }
  char byte = 0;
  QCOMPARE(::read(told[0], &byte, 1), ssize_t{1});
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(told[0]);
  ::close(told[1]);
}

}  // namespace

class OutputFileTest : public QObject {
  Q_OBJECT
 private slots:
  void ALinkIsWrittenThrough();
  void ALinkToNothingMakesItsTarget();
  void ALinkThatLeadsBackToItselfIsRefused();
  void DevicesPipesAndFoldersAreRefused();
  void APlantedTemporaryNameIsNotFollowed();
  void PermissionsOfWhatWasThereStay();
  void TheNameOnTheWayIsNewEachTimeAndKeepsTheEnding();
  void WhatTookItsPlaceIsNotCommitted();
  void WhatIsBeingWrittenIsNotSwept();
  void WhatWasKilledIsSweptAndNothingElse();
  void TreesAreRemovedInParts();
  void WhatAChildOfTheKilledHoldsForAMomentIsSwept();
  void WhatIsHeldLongerIsAtWork();
  void ARecordingThatWasKilledIsKept();
  void TemporaryFoldersAreForOneUserAlone();
  void WorkIsNotDoneInTheSharedFolder();
};

void OutputFileTest::ALinkIsWrittenThrough() {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "elsewhere");
  write_file_atomically(folder.path() / "elsewhere/target.txt", "old");
  fs::create_symlink("elsewhere/target.txt", folder.path() / "link.txt");
  fs::create_symlink("link.txt", folder.path() / "link of link.txt");
  write_file_atomically(folder.path() / "link of link.txt", "new");
  QVERIFY(fs::is_symlink(folder.path() / "link.txt") && fs::is_symlink(folder.path() / "link of link.txt"));
  QCOMPARE(read_file(folder.path() / "elsewhere/target.txt"), std::string("new"));
  QVERIFY(names(folder.path() / "elsewhere") == std::set<std::string>{"target.txt"});
}

void OutputFileTest::ALinkToNothingMakesItsTarget() {
  const TemporaryFolder folder;
  fs::create_symlink("later.txt", folder.path() / "link.txt");
  write_file_atomically(folder.path() / "link.txt", "new");
  QVERIFY(fs::is_symlink(folder.path() / "link.txt"));
  QCOMPARE(read_file(folder.path() / "later.txt"), std::string("new"));
}

void OutputFileTest::ALinkThatLeadsBackToItselfIsRefused() {
  const TemporaryFolder folder;
  fs::create_symlink("b", folder.path() / "a");
  fs::create_symlink("a", folder.path() / "b");
  QVERIFY(refusal(folder.path() / "a").find("leads back to itself") != std::string::npos);
  QVERIFY(refusal(folder.path() / "a/x.txt").find("leads back to itself") != std::string::npos);
}

void OutputFileTest::DevicesPipesAndFoldersAreRefused() {
  const TemporaryFolder folder;
  QCOMPARE(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  fs::create_directory(folder.path() / "folder");
  fs::create_symlink("/dev/null", folder.path() / "link");
  for (const fs::path& path : {fs::path("/dev/full"), folder.path() / "pipe", folder.path() / "link"})
    QVERIFY2(refusal(path).find("is a device or a pipe") != std::string::npos, path.c_str());
  QVERIFY(refusal(folder.path() / "folder").find("is a folder") != std::string::npos);
  QVERIFY(fs::is_character_file("/dev/full") && fs::is_fifo(folder.path() / "pipe"));
  QVERIFY(fs::is_symlink(folder.path() / "link"));
}

void OutputFileTest::APlantedTemporaryNameIsNotFollowed() {
  // What was written beside was once called .NAME.writingPID.
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "precious.txt", "precious");
  for (const char* ending : {"", ".txt"})
    fs::create_symlink("precious.txt", folder.path() / (".x.writing" + std::to_string(::getpid()) + ending));
  write_file_atomically(folder.path() / "x.txt", "new");
  QCOMPARE(read_file(folder.path() / "precious.txt"), std::string("precious"));
  QVERIFY(!fs::is_symlink(folder.path() / "x.txt"));
}

void OutputFileTest::PermissionsOfWhatWasThereStay() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "x.txt";
  write_file_atomically(path, "old");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  write_file_atomically(path, "new");
  QCOMPARE(static_cast<int>(fs::status(path).permissions()), 0640);
}

void OutputFileTest::TheNameOnTheWayIsNewEachTimeAndKeepsTheEnding() {
  const TemporaryFolder folder;
  std::set<fs::path> seen;
  for (int i = 0; i < 50; ++i) {
    const OutputFile file(folder.path() / "patient Smith.nii.gz");
    QCOMPARE(file.path().extension(), fs::path(".gz"));
    QVERIFY(file.path().string().find("Smith") == std::string::npos);  // litter names nobody
    QVERIFY(seen.insert(file.path()).second);
  }
  QVERIFY(names(folder.path()).empty());
}

void OutputFileTest::WhatTookItsPlaceIsNotCommitted() {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "x.txt", "old");
  OutputFile file(folder.path() / "x.txt");
  file.write("new");
  fs::remove(file.path());
  fs::create_symlink("/dev/null", file.path());
  QVERIFY(!test::complaint<FileError>([&] { file.commit(); }).empty());
  QCOMPARE(read_file(folder.path() / "x.txt"), std::string("old"));
}

void OutputFileTest::WhatIsBeingWrittenIsNotSwept() {
  const TemporaryFolder folder;
  OutputFile file(folder.path() / "x.txt");
  const TemporaryFolder inner(folder.path());
  file.write("new");
  QCOMPARE(sweep_leftovers(folder.path()), 0);
  QVERIFY(fs::exists(inner.path()));
  file.commit();
  QCOMPARE(read_file(folder.path() / "x.txt"), std::string("new"));
}

void OutputFileTest::WhatWasKilledIsSweptAndNothingElse() {
  const TemporaryFolder folder;
  const std::set<std::string> foreign = {"x.txt", ".glisson-notes", ".glisson-0123456789abcdeX", "link"};
  for (const std::string& name : foreign)
    if (name != "link") std::ofstream(folder.path() / name) << "foreign";
  fs::create_directory(folder.path() / "outside");
  std::ofstream(folder.path() / "outside/kept") << "kept";
  fs::create_symlink("outside", folder.path() / "link");
  killed([&](const auto& now) {
    const OutputFile file(folder.path() / "x.txt");
    file.write("half");
    const TemporaryFolder inner(folder.path());
    fs::create_directories(inner.path() / "a/b");
    fs::create_directory_symlink(folder.path() / "outside", inner.path() / "a/way out");
    now();
  });
  QCOMPARE(names(folder.path()).size(), foreign.size() + 3);  // the two, and "outside"
  QCOMPARE(sweep_leftovers(folder.path()), 2);
  QCOMPARE(names(folder.path()).size(), foreign.size() + 1);
  QCOMPARE(read_file(folder.path() / "x.txt"), std::string("foreign"));
  QCOMPARE(read_file(folder.path() / "outside/kept"), std::string("kept"));
  QCOMPARE(sweep_leftovers(folder.path() / "absent"), 0);
}

void OutputFileTest::TreesAreRemovedInParts() {
  const TemporaryFolder folder;
  const fs::path tree = folder.path() / "tree";
  fs::path deep = tree;
  for (int n = 0; n < 40; ++n) deep /= "a";
  fs::create_directories(deep);
  for (int n = 0; n < 20; ++n) std::ofstream(tree / std::to_string(n)) << "x";
  std::ofstream(folder.path() / "kept") << "kept";
  fs::create_symlink(folder.path() / "kept", tree / "link");
  int steps = 10, starts = 1;
  const auto may_go_on = [&steps] { return steps-- > 0; };
  for (; !remove_tree(AT_FDCWD, tree.c_str(), may_go_on); ++starts) {
    QVERIFY(starts < 100);
    steps = 100;
  }
  QVERIFY(starts > 1);
  QVERIFY(!fs::exists(tree));
  QCOMPARE(read_file(folder.path() / "kept"), std::string("kept"));
}

void OutputFileTest::WhatAChildOfTheKilledHoldsForAMomentIsSwept() {
  // Killed while it starts another program: until that is there, a child shares what was held.
  const TemporaryFolder folder;
  fs::path left;
  int gate[2] = {-1, -1};
  QCOMPARE(::pipe(gate), 0);
  pid_t child = 0;
  {
    Claim claim;
    left = Claim::make_folder(folder.path(), claim);
    QVERIFY(!left.empty());
    child = ::fork();
    if (child == 0) {
      char byte = 0;
      ::close(gate[1]);
      (void)!::read(gate[0], &byte, 1);  // until the gate is shut
      ::_exit(0);
    }
  }
  const Claim claim(::open(left.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  int waits = 5, pauses = 0;
  QVERIFY(take_soon(claim, waits, [&] {
    if (++pauses < 3) return;
    ::close(gate[1]);
    ::waitpid(child, nullptr, 0);
  }));
  QCOMPARE(pauses, 3);
  QCOMPARE(waits, 2);
  ::close(gate[0]);
}

void OutputFileTest::WhatIsHeldLongerIsAtWork() {
  const TemporaryFolder folder;
  Claim claim;
  const fs::path path = Claim::make_folder(folder.path(), claim);
  const Claim other(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  int waits = 3, pauses = 0;
  const auto pause = [&pauses] { ++pauses; };
  QVERIFY(!take_soon(other, waits, pause));
  QCOMPARE(pauses, 3);
  claim.release();
  QVERIFY(take_soon(other, waits, pause));  // what nobody holds needs no wait
  QCOMPARE(pauses, 3);
}

void OutputFileTest::ARecordingThatWasKilledIsKept() {
  const TemporaryFolder folder;
  killed([&](const auto& now) {
    const OutputFile film(folder.path() / "film.mkv"), empty(folder.path() / "empty.mkv");
    film.write("half a film");
    now();
  });
  QCOMPARE(sweep_leftovers(folder.path()), 2);
  const std::set<std::string> left = names(folder.path());
  QCOMPARE(left.size(), std::size_t{1});
  QVERIFY(left.begin()->starts_with("recovered-") && left.begin()->ends_with(".mkv"));
  QCOMPARE(read_file(folder.path() / *left.begin()), std::string("half a film"));
  QCOMPARE(sweep_leftovers(folder.path()), 0);
}

void OutputFileTest::TemporaryFoldersAreForOneUserAlone() {
  const mode_t before = ::umask(0);
  const TemporaryFolder folder;
  ::umask(before);
  QCOMPARE(static_cast<int>(fs::status(folder.path()).permissions()), 0700);
}

void OutputFileTest::WorkIsNotDoneInTheSharedFolder() {
  const TemporaryFolder home;
  const QByteArray before = qgetenv("TMPDIR"), cache = qgetenv("XDG_CACHE_HOME");
  qunsetenv("TMPDIR");
  qputenv("XDG_CACHE_HOME", QByteArray::fromStdString(home.path().string()));
  {
    const TemporaryFolder folder;
    QCOMPARE(folder.path().parent_path(), home.path() / "glisson/work");
    QCOMPARE(static_cast<int>(fs::status(home.path() / "glisson/work").permissions()), 0700);
  }
  if (!before.isNull()) qputenv("TMPDIR", before);
  cache.isNull() ? qunsetenv("XDG_CACHE_HOME") : qputenv("XDG_CACHE_HOME", cache);
}

QTEST_APPLESS_MAIN(OutputFileTest)
#include "output_file_test.moc"
