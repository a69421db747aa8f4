// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/late_library.h"

#include <QTest>
#include <string>
#include <utility>

using namespace glisson;

class LateLibraryTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatItOffersIsThere();
  void WhatIsNotThereIsNamed();
};

void LateLibraryTest::WhatItOffersIsThere() {
  const void* found = late_symbol("glisson-test.so", "glisson_answer");
  QCOMPARE(*static_cast<const int*>(found), 42);
  QCOMPARE(late_symbol("glisson-test.so", "glisson_answer"), found);
}

void LateLibraryTest::WhatIsNotThereIsNamed() {
  // The test's own program lies beside it and is no library.
  for (const auto& [library, symbol] :
       {std::pair("glisson-nowhere.so", "glisson_answer"), std::pair("glisson-test.so", "another"),
        std::pair("../../tests/core_late_library_test", "glisson_answer")}) {
    std::string sentence;
    try {
      (void)late_symbol(library, symbol);
    } catch (const MissingLibrary& failure) {
      sentence = failure.what();
    }
    const std::string there = std::string("lib/glisson/") + library + ": a library of Glisson is missing";
    QVERIFY2(sentence.find(there) != std::string::npos, sentence.c_str());
  }
}

QTEST_APPLESS_MAIN(LateLibraryTest)
#include "late_library_test.moc"
