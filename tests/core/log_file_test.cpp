// SPDX-License-Identifier: GPL-3.0-or-later
// A log that goes round and names nobody.
#include "glisson/core/log_file.h"

#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include <set>

#include "glisson/core/files.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> all;
  for (const auto& entry : fs::directory_iterator(folder)) all.insert(entry.path().filename().string());
  return all;
}

long lines_in(const fs::path& folder) {
  long lines = 0;
  for (const std::string& name : names(folder))
    for (const char letter : read_file(folder / name)) lines += letter == '\n';
  return lines;
}

}  // namespace

class LogFileTest : public QObject {
  Q_OBJECT
 private slots:
  void LinesGoToTheFile();
  void FullFilesGoRound();
  void TwoProgramsLoseNoLine();
  void WhereNothingCanBeWrittenNothingFails();
};

void LogFileTest::LinesGoToTheFile() {
  const TemporaryFolder folder;
  const Log log = log_to_file(folder.path() / "log");
  log.write(LogLevel::warning, "first\nsecond");
  const std::string text = read_file(folder.path() / "log/glisson.log");
  QVERIFY(text.ends_with(" warning first second\n"));  // a line is a line
  QVERIFY(text.find(" " + std::to_string(::getpid()) + " ") != std::string::npos);
  QCOMPARE(static_cast<int>(fs::status(folder.path() / "log").permissions()), 0700);
  QCOMPARE(static_cast<int>(fs::status(folder.path() / "log/glisson.log").permissions()), 0600);
}

void LogFileTest::FullFilesGoRound() {
  const TemporaryFolder folder;
  const Log log = log_to_file(folder.path(), 1000, 2);
  for (int n = 0; n < 200; ++n) log.write(LogLevel::info, "line number " + std::to_string(n));
  QVERIFY(names(folder.path()) == (std::set<std::string>{"glisson.log", "glisson.log.1", "glisson.log.2"}));
  for (const std::string& name : names(folder.path())) QVERIFY(fs::file_size(folder.path() / name) < 1100);
  QVERIFY(read_file(folder.path() / "glisson.log").find("line number 199\n") != std::string::npos);
}

void LogFileTest::TwoProgramsLoseNoLine() {
  const TemporaryFolder folder;
  constexpr int kLines = 400;
  const auto write_all = [&] {
    const Log log = log_to_file(folder.path(), 3000, 50);
    for (int n = 0; n < kLines; ++n) log.write(LogLevel::info, "0123456789");
  };
  const pid_t child = ::fork();
  if (child == 0) {
    write_all();
    ::_exit(0);
  }
  write_all();
  ::waitpid(child, nullptr, 0);
  QCOMPARE(lines_in(folder.path()), 2L * kLines);
  QVERIFY(names(folder.path()).size() > 5);  // it really went round
}

void LogFileTest::WhereNothingCanBeWrittenNothingFails() {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "file", "");
  log_to_file(folder.path() / "file/log").write(LogLevel::error, "x");
  log_to_file({}).write(LogLevel::error, "x");
}

QTEST_APPLESS_MAIN(LogFileTest)
#include "log_file_test.moc"
