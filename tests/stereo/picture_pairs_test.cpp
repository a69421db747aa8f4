// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_pairs.h"

#include <QTest>
#include <fstream>

#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

class PicturePairsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<TemporaryFolder> folder_;

  void make(const std::vector<std::string>& names) {
    folder_ = std::make_unique<TemporaryFolder>();
    for (const std::string& name : names) {
      fs::create_directories((folder_->path() / name).parent_path());
      std::ofstream(folder_->path() / name) << "x";
    }
  }
  static std::string text(const PicturePairs& found) {
    std::string result;
    for (const PicturePair& pair : found.pairs)
      result += pair.name + ":" + pair.left.filename().string() + "+" + pair.right.filename().string() + " ";
    return result;
  }

 private slots:
  void NumbersAreOrderedByValue() {
    make({"left-1095.png", "left-798.png", "right-798.png", "right-1095.png", "notes.txt",
          "left-798.png.points.txt"});
    const PicturePairs found = picture_pairs(folder_->path());
    QCOMPARE(text(found), std::string("798:left-798.png+right-798.png 1095:left-1095.png+right-1095.png "));
    QVERIFY(found.alone.empty());
  }

  void SingleLettersTellTheSide() {
    make({"f7_dynamic_L_0100.png", "f7_dynamic_R_0100.png", "f7_mask_0100.png"});
    QCOMPARE(text(picture_pairs(folder_->path())),
             std::string("f7_dynamic__0100:f7_dynamic_L_0100.png+f7_dynamic_R_0100.png "));
  }

  void SubfoldersTellTheSide() {
    make({"left/a2.bmp", "left/a10.bmp", "right/a2.bmp", "right/a10.bmp"});
    QCOMPARE(text(picture_pairs(folder_->path())), std::string("a2:a2.bmp+a2.bmp a10:a10.bmp+a10.bmp "));
  }

  void FilesOfOneNameArePairedByTheirFormat() {
    make({"left/1.jpg", "left/1.png", "right/1.jpg", "right/1.png", "right/1.bmp"});
    const PicturePairs found = picture_pairs(folder_->path());
    QCOMPARE(text(found), std::string("1:1.jpg+1.jpg 1:1.png+1.png "));
    QCOMPARE(found.alone.size(), std::size_t{1});
    QCOMPARE(found.alone.front().filename(), fs::path("1.bmp"));
    make({"left/1.bmp", "left/1.jpg", "right/1.jpg", "right/1.png"});
    QCOMPARE(text(picture_pairs(folder_->path())), std::string("1:1.bmp+1.png 1:1.jpg+1.jpg "));
  }

  void PatternsAreMatchedByNameAndElseInOrder() {
    make({"l/cam1_7.png", "l/cam1_12.png", "r/x3.png", "r/x1.png", "both/leftA.png", "both/rightA.png"});
    QCOMPARE(text(picture_pairs(folder_->path() / "l" / "cam*.png", folder_->path() / "r")),
             std::string("cam1_7:cam1_7.png+x1.png cam1_12:cam1_12.png+x3.png "));
    QCOMPARE(text(picture_pairs(folder_->path() / "both/left?.png", folder_->path() / "both/right?.png")),
             std::string("a:leftA.png+rightA.png "));
  }

  void PicturesWithoutPartnerAreTold() {
    make({"left1.png", "right1.png", "left2.png", "right3.png"});
    const PicturePairs found = picture_pairs(folder_->path());
    QCOMPARE(found.pairs.size(), std::size_t{1});
    QCOMPARE(found.alone.size(), std::size_t{2});
  }

  void WhatHoldsNoPairIsRefused() {
    make({"left1.png", "right2.png", "l/a.png", "r/b.png", "r/c.png", "empty/notes.txt"});
    QVERIFY_THROWS_EXCEPTION(InputError, picture_pairs(folder_->path()));
    QVERIFY_THROWS_EXCEPTION(InputError, picture_pairs(folder_->path() / "l", folder_->path() / "r"));
    QVERIFY_THROWS_EXCEPTION(FileError, picture_pairs(folder_->path() / "absent"));
    QVERIFY_THROWS_EXCEPTION(FileError, picture_pairs(folder_->path() / "l/z*.png", folder_->path() / "r"));
    QVERIFY_THROWS_EXCEPTION(FileError, picture_pairs(folder_->path() / "empty", folder_->path() / "r"));
  }
};

QTEST_APPLESS_MAIN(PicturePairsTest)
#include "picture_pairs_test.moc"
