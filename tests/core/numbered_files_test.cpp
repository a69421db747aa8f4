// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/numbered_files.h"

#include <QFile>
#include <QTest>

#include "glisson/core/error.h"

using namespace glisson;

class NumberedFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void NamesAreAsPrintfMakesThem() {
    for (const char* pattern : {"a/cloud_%02d.ply", "%d", "frame%5d.vtu", "x%03d"})
      for (const int number : {0, 7, 42, 12345})
        QCOMPARE(NumberedFiles::of(pattern)->at(number).string(),
                 QString::asprintf(pattern, number).toStdString());
    // The first number alone counts.
    QCOMPARE(NumberedFiles::of("%04d_%d")->at(7).string(), std::string("0007_%d"));
    QCOMPARE(NumberedFiles::of("cloud_%02d.ply")->digits(), 2);
    QVERIFY(!NumberedFiles::of("cloud.ply") && !NumberedFiles::of("%s") && !NumberedFiles::of(""));
  }

  void LostOnesDoNotHideThoseAfterThem() {
    QTemporaryDir folder;
    const auto files = NumberedFiles::of((folder.path() + "/c%02d.ply").toStdString());
    QVERIFY_THROWS_EXCEPTION(FileError, files->existing());
    for (const int number : {3, 4, 5, 7, 1007, 2009}) {
      QFile file(QString::fromStdString(files->at(number).string()));
      QVERIFY(file.open(QIODevice::WriteOnly));
    }
    const auto there = files->existing();
    std::vector<int> numbers;
    for (const auto& [number, file] : there) {
      numbers.push_back(number);
      QCOMPARE(file, files->at(number));
    }
    QCOMPARE(numbers, (std::vector<int>{3, 4, 5, 7, 1007}));  // from there to 2009 it is too far
  }
};

QTEST_APPLESS_MAIN(NumberedFilesTest)
#include "numbered_files_test.moc"
