// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/late_library.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;

class LateLibraryTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatItOffersIsThere();
  void WhatIsNotThereIsNamed();
};

void LateLibraryTest::WhatItOffersIsThere() {
  const void* found = late_symbol("glisson-nowhere.so", GLISSON_TEST_LIBRARY, "glisson_answer");
  QCOMPARE(*static_cast<const int*>(found), 42);
  QCOMPARE(late_symbol("glisson-nowhere.so", GLISSON_TEST_LIBRARY, "glisson_answer"), found);
}

void LateLibraryTest::WhatIsNotThereIsNamed() {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "text.so", "no library");
  const auto told = [](const std::filesystem::path& built, const char* symbol) -> std::string {
    try {
      (void)late_symbol("glisson-nowhere.so", built, symbol);
    } catch (const FileError& failure) {
      return failure.what();
    }
    return {};
  };
  for (const auto& [built, symbol] : {std::pair(folder.path() / "text.so", "glisson_answer"),
                                      std::pair(std::filesystem::path(GLISSON_TEST_LIBRARY), "another")}) {
    const std::string sentence = told(built, symbol);
    QVERIFY2(sentence.starts_with(built.string() + ": a library of Glisson"), sentence.c_str());
  }
  // Where an installed one should be is told, not where somebody once built it.
  const std::string sentence = told(folder.path() / "none.so", "glisson_answer");
  QVERIFY2(sentence.find("lib/glisson/glisson-nowhere.so: a library of Glisson") != std::string::npos,
           sentence.c_str());
}

QTEST_APPLESS_MAIN(LateLibraryTest)
#include "late_library_test.moc"
