// SPDX-License-Identifier: GPL-3.0-or-later
// What others have put where a file is read, and what they have written into it.
#include <sys/stat.h>

#include <QTest>
#include <fstream>
#include <thread>

#include "glisson/core/files.h"
#include "glisson/core/printable.h"

namespace glisson {

class ForeignInputTest : public QObject {
  Q_OBJECT
 private slots:
  void APipeThatNobodyWritesToIsEmpty();
  void APipeIsReadToItsEnd();
  void TextCommandsNoTerminal_data();
  void TextCommandsNoTerminal();
  void NoCharacterIsCutInTwo();
};

void ForeignInputTest::APipeThatNobodyWritesToIsEmpty() {
  const TemporaryFolder folder;
  QCOMPARE(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  QCOMPARE(read_file(folder.path() / "pipe"), std::string());
}

void ForeignInputTest::APipeIsReadToItsEnd() {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "pipe").string(), text(300000, 'x');
  QCOMPARE(::mkfifo(path.c_str(), 0600), 0);
  // Open for both, so that whoever reads finds a writer, as behind a shell's "<(...)".
  std::fstream both(path, std::ios::in | std::ios::out | std::ios::binary);
  std::thread writer([&both, &text] {
    both << text.substr(0, 100000) << std::flush;
    QTest::qSleep(100);
    both << text.substr(100000) << std::flush;
    both.close();
  });
  const std::string got = read_file(path);
  writer.join();
  QVERIFY(got == text);
}

void ForeignInputTest::TextCommandsNoTerminal_data() {
  QTest::addColumn<std::string>("text");
  QTest::addColumn<std::string>("shown");
  QTest::newRow("plain") << std::string("a liver") << std::string("a liver");
  QTest::newRow("umlauts") << std::string("Leberübersicht – ß") << std::string("Leberübersicht – ß");
  QTest::newRow("escape") << std::string("a\x1b[2Jb") << std::string("a?[2Jb");
  QTest::newRow("lines") << std::string("a\nb\rc\x7f") << std::string("a?b?c?");
  QTest::newRow("second set") << std::string(
                                     "a\xc2\x9b"
                                     "2J")
                              << std::string("a?2J");
}

void ForeignInputTest::TextCommandsNoTerminal() {
  QFETCH(std::string, text);
  QFETCH(std::string, shown);
  QCOMPARE(printable(text), shown);
}

void ForeignInputTest::NoCharacterIsCutInTwo() {
  QCOMPARE(printable("abc", 3), std::string("abc"));
  QCOMPARE(printable("abcd", 3), std::string("abc..."));
  QCOMPARE(printable("aübc", 2), std::string("a..."));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::ForeignInputTest)
#include "foreign_input_test.moc"
