// SPDX-License-Identifier: GPL-3.0-or-later
// What hospitals hand out: zip archives, and media with a DICOMDIR.
#include <QTest>

#include "complaint.h"
#include "dicom_bytes.h"
#include "dicomdir_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/dicom_source.h"
#include "glisson/volume/io.h"
#include "glisson/volume/series.h"
#include "phantom.h"
#include "zip_bytes.h"

using namespace glisson;
using test::ZipFile;
namespace fs = std::filesystem;

namespace {

std::string complaint_of(const fs::path& path) {
  return test::complaint<Error>([&] { (void)read_image(path, RunContext()); });
}

bool says(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

std::string name_of(int k) { return "DICOM/ST0/IM" + std::to_string(k); }

/// A hospital's disc: a series deep in folders, a viewer, its help and a DICOMDIR beside it.
std::vector<ZipFile> disc(bool deflated = true) {
  std::vector<ZipFile> files = {{"VIEWER/", ""},
                                {"VIEWER/view.exe", std::string(5000, 'M'), deflated},
                                {"autorun.inf", "[autorun]", deflated},
                                {"DICOMDIR", test::dicomdir_of({"", "DICOM\\ST0\\IM0"}), deflated}};
  for (int k = 0; k < 4; ++k) files.push_back({name_of(k), test::dicom_of(k, test::HandSlice()), deflated});
  return files;
}

}  // namespace

class MediumTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { folder_ = std::make_unique<TemporaryFolder>(); }
  void AZippedDiscIsReadAsItsFolder();
  void ArchivesOfUsualProgramsAreRead();
  void SeriesInAZipAreListed();
  void WhatIsEncryptedOrPackedOtherwiseIsRefusedWithARemedy();
  void FilesStayInTheirFolder();
  void DamageIsRefused();
  void BombsAreToldByWhatTheyClaimAndByWhatTheyHold();
  void TooManyAndTooDeepAreTold();
  void ADicomdirOpensItsFolder();
  void FilesThatADicomdirNamesAndAreMissingAreNamed();
  void ReferencesNeverLeaveTheFolder();
  void WhatIsNoDicomdirIsRefused();

 private:
  fs::path zip(const std::vector<ZipFile>& files) {
    write_file_atomically(folder_->path() / "a.zip", test::zip_of(files));
    return folder_->path() / "a.zip";
  }
  bool is_world(const fs::path& path) { return test::shows_world(read_image(path, RunContext()).value()); }
  /// Four slices on a disc, and the DICOMDIR that names these files.
  fs::path medium(const std::vector<std::string>& files);

  std::unique_ptr<TemporaryFolder> folder_;
};

void MediumTest::AZippedDiscIsReadAsItsFolder() {
  QVERIFY(is_world(zip(disc(true))));
  QVERIFY(is_world(zip(disc(false))));
  auto wide = disc();
  for (ZipFile& file : wide) file.zip64 = true;
  QVERIFY(is_world(zip(wide)));
  auto windows = disc();
  for (ZipFile& file : windows) std::replace(file.name.begin(), file.name.end(), '/', '\\');
  QVERIFY(is_world(zip(windows)));
  fs::rename(folder_->path() / "a.zip", folder_->path() / "B.ZIP");
  QVERIFY(is_world(folder_->path() / "B.ZIP"));
}

void MediumTest::ArchivesOfUsualProgramsAreRead() {
  fs::create_directories(folder_->path() / "disc/DICOM/ST0");
  for (int k = 0; k < 4; ++k)
    write_file_atomically(folder_->path() / "disc" / name_of(k), test::dicom_of(k, test::HandSlice()));
  const std::string command =
      "cd " + folder_->path().string() + " && cmake -E tar cf b.zip --format=zip disc > /dev/null 2>&1";
  if (std::system(command.c_str()) != 0) QSKIP("CMake packs no archives here");
  QVERIFY(is_world(folder_->path() / "b.zip"));
}

void MediumTest::SeriesInAZipAreListed() {
  auto files = disc();
  test::HandSlice other;
  other.series += ".8";
  other.description = "arterial";
  for (int k = 0; k < 3; ++k)
    files.push_back({"DICOM/ST1/IM" + std::to_string(k), test::dicom_of(k, other), true});
  const auto series = list_series(zip(files), RunContext()).value();
  QCOMPARE(series.size(), std::size_t{2});
  QVERIFY(series[0].picture.width > 0 && series[1].picture.width > 0);
  QVERIFY(says(complaint_of(folder_->path() / "a.zip"), "holds 2 series"));
  QVERIFY(test::shows_world(
      read_image(folder_->path() / "a.zip", RunContext(), test::HandSlice().series).value()));
}

void MediumTest::WhatIsEncryptedOrPackedOtherwiseIsRefusedWithARemedy() {
  auto files = disc();
  files[5].encrypted = true;
  QVERIFY2(says(complaint_of(zip(files)), "encrypted. Unpack it with its password and name the folder"),
           complaint_of(zip(files)).c_str());
  files = disc();
  files[5].other_method = 9;
  QVERIFY2(says(complaint_of(zip(files)), "Unpack it yourself"), complaint_of(zip(files)).c_str());
}

void MediumTest::FilesStayInTheirFolder() {
  const fs::path target = folder_->path() / "target";
  for (const std::string& name :
       {std::string("../target"), std::string("x/../../../../target"), target.string(),
        std::string("..\\target"), std::string("x\\..\\..\\..\\target")}) {
    auto files = disc();
    files.insert(files.begin(), ZipFile{name, "written"});
    QVERIFY(is_world(zip(files)));
    QVERIFY2(!fs::exists(target), name.c_str());
  }
  // Through a link that the archive brings itself.
  auto files = disc();
  files.insert(files.begin(), {ZipFile{"out", folder_->path().string(), false, false, false, 0, 0, 0120777},
                               ZipFile{"out/target", "written"}});
  QVERIFY(is_world(zip(files)));
  QVERIFY(!fs::exists(target));
}

void MediumTest::DamageIsRefused() {
  const std::string good = test::zip_of(disc(false));
  std::string flipped = good;
  flipped[good.find("autorun.inf") + 15] ^= 1;  // in its content: the sum tells
  for (const std::string& bad : {flipped, good.substr(0, good.size() / 2), good.substr(0, good.size() - 30),
                                 std::string("no archive"), std::string()}) {
    write_file_atomically(folder_->path() / "a.zip", bad);
    const std::string told = complaint_of(folder_->path() / "a.zip");
    QVERIFY2(says(told, "cannot be unpacked"), told.c_str());
  }
  // Less is claimed than is held: what was unpacked does not have the sum.
  auto files = disc();
  files[1].claimed_size = 100;
  QVERIFY2(says(complaint_of(zip(files)), "cannot be unpacked"), complaint_of(zip(files)).c_str());
}

void MediumTest::BombsAreToldByWhatTheyClaimAndByWhatTheyHold() {
  auto files = disc();
  files[1].claimed_size = 20000000000ULL;
  QVERIFY2(says(complaint_of(zip(files)), "a hundred times its size"), complaint_of(zip(files)).c_str());
  files = disc();
  files[1].content = std::string(400000000, '\0');
  QVERIFY2(says(complaint_of(zip(files)), "a hundred times its size"), complaint_of(zip(files)).c_str());
  QVERIFY(fs::file_size(folder_->path() / "a.zip") < 1000000);
}

void MediumTest::TooManyAndTooDeepAreTold() {
  std::string deep;
  for (int n = 0; n < 40; ++n) deep += "a/";
  QVERIFY(says(complaint_of(zip({{deep + "b", ""}})), "more than 32 deep"));
  std::vector<ZipFile> many;
  std::string above;
  for (int n = 0; n < 30; ++n) above += "/a";
  for (int n = 0; n < 170; ++n) many.push_back({std::to_string(n) + above + "/b", ""});
  QVERIFY(says(complaint_of(zip(many)), "more than 5000 folders"));
}

fs::path MediumTest::medium(const std::vector<std::string>& files) {
  const fs::path disc = folder_->path() / "disc";
  fs::create_directories(disc / "DICOM/ST0");
  for (int k = 0; k < 4; ++k) write_file_atomically(disc / name_of(k), test::dicom_of(k, test::HandSlice()));
  write_file_atomically(disc / "DICOMDIR", test::dicomdir_of(files));
  return disc / "DICOMDIR";
}

void MediumTest::ADicomdirOpensItsFolder() {
  // Discs are copied in small letters, too.
  const fs::path path =
      medium({"", "DICOM\\ST0\\IM0", "DICOM\\ST0\\IM1", "dicom\\st0\\im2", "DICOM\\ST0\\IM3"});
  const Scan scan = read_scan(path, RunContext()).value();
  QVERIFY(test::shows_world(scan.image));
  QVERIFY(scan.missing.empty());
  QCOMPARE(list_series(path, RunContext()).value().size(), std::size_t{1});
  fs::rename(path, path.parent_path() / "dicomdir");
  QVERIFY(is_world(path.parent_path() / "dicomdir"));
}

void MediumTest::FilesThatADicomdirNamesAndAreMissingAreNamed() {
  const Scan scan = read_scan(medium({"DICOM\\ST0\\IM0", "DICOM\\ST0\\IM9", "X"}), RunContext()).value();
  QCOMPARE(scan.missing, (std::vector<std::string>{"DICOM/ST0/IM9", "X"}));
  const std::string told = complaint_of(medium({"DICOM\\ST0\\IM8", "DICOM\\ST0\\IM9"}));
  QVERIFY2(says(told, "DICOM/ST0/IM8") && says(told, "Copy the whole medium"), told.c_str());
}

void MediumTest::ReferencesNeverLeaveTheFolder() {
  write_file_atomically(folder_->path() / "secret", "secret");
  const Scan scan =
      read_scan(medium({"..\\secret", "/etc/passwd", "DICOM\\..\\..\\secret", "DICOM\\ST0\\IM1"}),
                RunContext())
          .value();
  QVERIFY(scan.missing.empty());  // neither looked for nor named
  QVERIFY(test::shows_world(scan.image));
}

void MediumTest::WhatIsNoDicomdirIsRefused() {
  const fs::path path = medium({});
  for (const std::string& bad : {std::string("text"), test::dicom_of(0, test::HandSlice())}) {
    write_file_atomically(path, bad);
    QVERIFY2(says(complaint_of(path), "is none or is damaged. Name the folder"), complaint_of(path).c_str());
  }
  for (const std::size_t length : {std::size_t{200}, std::size_t{400}}) {  // GDCM breaks down at some
    write_file_atomically(path, test::dicomdir_of({"DICOM\\ST0\\IM0"}).substr(0, length));
    const std::string told = complaint_of(path);
    QVERIFY2(says(told, "Name the folder that holds") || read_image(path, RunContext()).has_value(),
             told.c_str());
  }
}

QTEST_APPLESS_MAIN(MediumTest)
#include "medium_test.moc"
