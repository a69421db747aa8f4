// SPDX-License-Identifier: GPL-3.0-or-later
// A folder takes another one's place whole, and what a killed exchange has left is known.
#include "glisson/core/folder_exchange.h"

#include <sys/stat.h>

#include <QTest>

#include <iterator>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;
namespace fs = std::filesystem;

namespace {

constexpr const char* kMark = "whole.txt";

/// A folder with its mark and what it says.
void put(const fs::path& folder, const std::string& says) {
  fs::create_directories(folder);
  write_file_atomically(folder / kMark, says);
}

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

}  // namespace

class FolderExchangeTest : public QObject {
  Q_OBJECT
 private slots:
  void AFolderComesWhereNoneIs() {
    const TemporaryFolder around;
    put(around.path() / "beside/own", "new");
    exchange_folders(around.path() / "beside/own", around.path() / "own", kMark);
    QCOMPARE(read_file(around.path() / "own" / kMark), std::string("new"));
    QCOMPARE(entries(around.path() / "beside"), std::ptrdiff_t{0});
  }

  /// The folder that stands there afterwards is the new one itself: no file in the former one was touched.
  void TheFormerFolderGivesWayWhole() {
    const TemporaryFolder around;
    put(around.path() / "own", "former");
    put(around.path() / "beside/own", "new");
    struct stat fresh = {}, standing = {};
    QCOMPARE(::stat((around.path() / "beside/own").c_str(), &fresh), 0);
    exchange_folders(around.path() / "beside/own", around.path() / "own", kMark);
    QCOMPARE(::stat((around.path() / "own").c_str(), &standing), 0);
    QVERIFY(standing.st_ino == fresh.st_ino);
    QCOMPARE(read_file(around.path() / "own" / kMark), std::string("new"));
    QCOMPARE(entries(around.path() / "beside"), std::ptrdiff_t{0});
    QCOMPARE(entries(around.path()), std::ptrdiff_t{2});
  }

  void WhatCannotBeReplacedIsSaid() {
    const TemporaryFolder around;
    QVERIFY_THROWS_EXCEPTION(FileError,
                             exchange_folders(around.path() / "none", around.path() / "own", kMark));
    put(around.path() / "own", "former");
    QVERIFY_THROWS_EXCEPTION(FileError,
                             exchange_folders(around.path() / "none", around.path() / "own", kMark));
    QCOMPARE(read_file(around.path() / "own" / kMark), std::string("former"));
    QVERIFY(!fs::exists(former_name(around.path() / "own")));
  }

  void TheFormerOneIsDroppedBesideAWholeOneOnly() {
    const TemporaryFolder around;
    const fs::path own = around.path() / "own";
    put(former_name(own), "former");
    QCOMPARE(former_name(own).filename().string(), std::string(".own.former"));
    drop_former(own, kMark);
    QVERIFY(fs::exists(former_name(own)));
    fs::create_directory(own);
    drop_former(own, kMark);
    QVERIFY(fs::exists(former_name(own)));
    put(own, "new");
    drop_former(own, kMark);
    QVERIFY(!fs::exists(former_name(own)));
    // What is none of this kind is nobody's to remove.
    fs::create_directory(former_name(own));
    drop_former(own, kMark);
    QVERIFY(fs::exists(former_name(own)));
  }

  void AFolderHasOnePlaceWhateverItIsCalled() {
    const TemporaryFolder around;
    const fs::path own = fs::canonical(around.path()) / "own";
    fs::create_directory_symlink("own", around.path() / "link");
    for (const char* name : {"own", "own/", "./own", "link", "link/", "none/../own"})
      QCOMPARE(place_for_folder(around.path() / name).string(), own.string());
    fs::create_directory(own);
    QCOMPARE(place_for_folder(around.path() / "link/").string(), own.string());
  }
};

QTEST_APPLESS_MAIN(FolderExchangeTest)
#include "folder_exchange_test.moc"
