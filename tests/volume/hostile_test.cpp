// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <QTest>

#include "complaint.h"
#include "dicom_bytes.h"
#include "escapes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/io.h"
#include "glisson/volume/reader_program.h"
#include "phantom.h"
#include "tar_bytes.h"

using namespace glisson;
namespace fs = std::filesystem;

/// Files and folders that are meant to do harm.
class HostileTest : public QObject {
  Q_OBJECT
 private slots:
  void TheReaderIsConfined();
  void WhatATakenReaderLeavesIsNotTrusted();
  void ArchivesAreUnpackedAsTarDoes();
  void OldArchivesTellAFolderByItsSlash();
  void ArchivesStayInTheirFolder();
  void DamagedArchivesAreRefused();
  void BombsAreToldEarly();
  void TooManyFilesAreTold();
  void FoldersCountAsFilesDo();
  void PackedVolumesAreMeasured();
  void LinksRoundInACircleAreTold();
  void PipesAndDevicesAreNotRead();
  void LinkedSlicesAreRead();
};

namespace {

std::string complaint_of(const fs::path& path) {
  return test::complaint<Error>([&] { (void)read_image(path, RunContext()); });
}

bool says(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

std::string series_as_tar() {
  std::string bytes;
  for (int k = 0; k < 4; ++k)
    bytes += test::tar_entry("series/" + std::to_string(k) + ".dcm", test::dicom_of(k, test::HandSlice()));
  return bytes;
}

/// Bytes of the temporary folder that are ours, while they are there.
long files_below(const fs::path& folder) {
  long count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file();
  return count;
}

}  // namespace

void HostileTest::TheReaderIsConfined() {
  if (!test::can_confine()) QSKIP("this kernel confines nothing, or this is a build with sanitizers");
  QCOMPARE(test::broken_out(reader_escapes()), std::vector<std::string>());
}

void HostileTest::WhatATakenReaderLeavesIsNotTrusted() {
  const TemporaryFolder folder;
  const fs::path program = folder.path() / "reader", volume = folder.path() / "a.nrrd";
  write_file_atomically(volume, "x");
  const std::string header =
      R"({"size":[SIZE],"spacing":[1,1,1],"origin":[0,0,0],"direction":[1,0,0,0,1,0,0,0,1],)"
      R"("components":1,"modality":"ct","description":"","texts":{}})";
  write_file_atomically(folder.path() / "header.json", std::string(header).replace(9, 4, "2,2,2"));
  write_file_atomically(folder.path() / "huge.json", std::string(header).replace(9, 4, "90000,90000,90000"));
  const std::string from = "cp " + folder.path().string();
  const std::string good = from + "/header.json $3/header.json\n",
                    voxels = "head -c 16 /dev/zero > $3/voxels.raw\n";
  const auto told = [&](const std::string& lines) {
    write_file_atomically(program, "#!/bin/sh\n" + lines);
    fs::permissions(program, fs::perms::owner_all);
    qputenv("GLISSON_READ_VOLUME", program.c_str());
    const std::string complaint = complaint_of(volume);
    qunsetenv("GLISSON_READ_VOLUME");
    return complaint;
  };
  QCOMPARE(told(good + voxels), std::string());
  for (const std::string& bad :
       {"ln -s " + folder.path().string() + "/header.json $3/header.json\n" + voxels,
        "mkfifo $3/header.json\n" + voxels, good + "ln -s /dev/zero $3/voxels.raw\n",
        good + "mkfifo $3/voxels.raw\n", good + "head -c 18 /dev/zero > $3/voxels.raw\n",
        from + "/huge.json $3/header.json\n" + voxels})
    QVERIFY2(says(told(bad), "left what is no result of it"), bad.c_str());
}

void HostileTest::ArchivesAreUnpackedAsTarDoes() {
  const TemporaryFolder folder;
  const fs::path plain = folder.path() / "plain";
  // A name of more than 100 letters takes an entry of its own, in GNU's way or in that of pax.
  const fs::path deep = plain / std::string(90, 'a') / std::string(90, 'b');
  fs::create_directories(deep);
  for (int k = 0; k < 4; ++k)
    write_file_atomically(deep / (std::to_string(k) + ".dcm"), test::dicom_of(k, test::HandSlice()));
  for (const char* format : {"ustar", "gnu", "pax"})
    for (const char* packing : {"", "z"}) {
      const fs::path archive = folder.path() / (std::string("a.tar") + (*packing == 'z' ? ".gz" : ""));
      const std::string command = "tar --format=" + std::string(format) + " -c" + packing + "f " +
                                  archive.string() + " -C " + folder.path().string() + " plain";
      QCOMPARE(std::system(command.c_str()), 0);
      QVERIFY2(test::shows_world(read_image(archive, RunContext()).value()), command.c_str());
    }
}

void HostileTest::OldArchivesTellAFolderByItsSlash() {
  const TemporaryFolder folder;
  const fs::path archive = folder.path() / "a.tar";
  write_file_atomically(archive, test::tar_entry("series/", "", '\0') + series_as_tar() + test::tar_end());
  QVERIFY(test::shows_world(read_image(archive, RunContext()).value()));
}

void HostileTest::ArchivesStayInTheirFolder() {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "target", archive = folder.path() / "a.tar";
  for (const std::string& name :
       {"../" + target.filename().string(), std::string("x/../../../../target"), target.string()}) {
    const std::string bytes = test::tar_entry(name, "written") + series_as_tar();
    write_file_atomically(archive, bytes + test::tar_end());
    QVERIFY(test::shows_world(read_image(archive, RunContext()).value()));
    QVERIFY(!fs::exists(target));
  }
  // Through a link that the archive brings itself.
  const std::string link = test::tar_entry("out", "", '2', folder.path().string());
  write_file_atomically(archive,
                        link + test::tar_entry("out/target", "written") + series_as_tar() + test::tar_end());
  QVERIFY(test::shows_world(read_image(archive, RunContext()).value()));
  QVERIFY(!fs::exists(target));
}

void HostileTest::DamagedArchivesAreRefused() {
  const TemporaryFolder folder;
  const fs::path archive = folder.path() / "a.tar";
  const std::string good = series_as_tar() + test::tar_end();
  write_file_atomically(archive, good);
  QVERIFY(test::shows_world(read_image(archive, RunContext()).value()));
  std::string sum = good;
  sum[0] ^= 1;
  std::string size = good;
  size.replace(124, 12, std::string("77777777777\0", 12));
  for (const std::string& bad :
       {sum, size, good.substr(0, 700), good.substr(0, 1024 + 100), std::string("no archive")}) {
    write_file_atomically(archive, bad);
    QVERIFY2(says(complaint_of(archive), "cannot be unpacked"), complaint_of(archive).c_str());
  }
}

void HostileTest::BombsAreToldEarly() {
  const TemporaryFolder folder;
  const fs::path archive = folder.path() / "a.tar.gz";
  // 20 GB of zeros in 20 MB.
  const std::string command = "(printf ''; cat " + (folder.path() / "head").string() +
                              "; head -c 600000000 /dev/zero) | gzip -1 > " + archive.string();
  write_file_atomically(folder.path() / "head", test::tar_entry("big", "", '0', "", 20000000000ULL));
  QCOMPARE(std::system(command.c_str()), 0);
  QVERIFY(fs::file_size(archive) < 20000000);
  const std::string told = complaint_of(archive);
  QVERIFY2(says(told, "a hundred times its size"), told.c_str());
}

void HostileTest::TooManyFilesAreTold() {
  const TemporaryFolder folder;
  std::string bytes;
  for (int n = 0; n < 100002; ++n) bytes += test::tar_entry("a", "");
  write_file_atomically(folder.path() / "a.tar", bytes + test::tar_end());
  QVERIFY(says(complaint_of(folder.path() / "a.tar"), "more than 100000 files"));
}

void HostileTest::FoldersCountAsFilesDo() {
  const TemporaryFolder folder;
  const fs::path archive = folder.path() / "a.tar";
  std::string deep;
  for (int n = 0; n < 40; ++n) deep += "a/";
  write_file_atomically(archive, test::tar_entry(deep + "b", "") + test::tar_end());
  QVERIFY2(says(complaint_of(archive), "more than 32 deep"), complaint_of(archive).c_str());
  // Few files, each below thirty folders of its own.
  std::string bytes, above;
  for (int n = 0; n < 30; ++n) above += "/a";
  for (int n = 0; n < 170; ++n) bytes += test::tar_entry(std::to_string(n) + above + "/b", "");
  write_file_atomically(archive, bytes + test::tar_end());
  QVERIFY2(says(complaint_of(archive), "more than 5000 folders"), complaint_of(archive).c_str());
}

void HostileTest::PackedVolumesAreMeasured() {
  // 300 MB of zeros in 300 kB, told by the header alone.
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.nrrd", zeros = folder.path() / "zeros.gz";
  QCOMPARE(std::system(("head -c 300000000 /dev/zero | gzip -9 > " + zeros.string()).c_str()), 0);
  write_file_atomically(
      path,
      "NRRD0004\ntype: short\nendian: little\nencoding: gzip\ndimension: 3\nsizes: 500 500 600\n"
      "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: "
      "(0,0,0)\n\n" +
          read_file(zeros));
  QVERIFY2(says(complaint_of(path), "a hundred times its size"), complaint_of(path).c_str());
}

void HostileTest::LinksRoundInACircleAreTold() {
  const TemporaryFolder folder;
  fs::create_symlink("b.nrrd", folder.path() / "a.nrrd");
  fs::create_symlink("a.nrrd", folder.path() / "b.nrrd");
  QVERIFY2(says(complaint_of(folder.path() / "a.nrrd"), "leads back to itself"),
           complaint_of(folder.path() / "a.nrrd").c_str());
  QVERIFY(says(test::complaint<Error>([&] { (void)read_labels(folder.path() / "a.nrrd"); }),
               "leads back to itself"));
  // Within a series they are passed over.
  const fs::path series = folder.path() / "series";
  fs::create_directory(series);
  for (int k = 0; k < 4; ++k)
    write_file_atomically(series / std::to_string(k), test::dicom_of(k, test::HandSlice()));
  fs::create_directory_symlink(series, series / "again");
  fs::create_symlink("round", series / "round");
  QVERIFY(test::shows_world(read_image(series, RunContext()).value()));
}

void HostileTest::PipesAndDevicesAreNotRead() {
  const TemporaryFolder folder;
  const fs::path pipe = folder.path() / "a.nrrd";
  QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
  QVERIFY(says(complaint_of(pipe), "neither a file nor a folder"));
  QVERIFY(says(complaint_of("/dev/zero"), "neither a file nor a folder"));
}

void HostileTest::LinkedSlicesAreRead() {
  // Stores of data keep files elsewhere and link to them.
  const TemporaryFolder store, folder;
  for (int k = 0; k < 4; ++k) {
    const fs::path file = store.path() / std::to_string(k);
    write_file_atomically(file, test::dicom_of(k, test::HandSlice()));
    fs::create_symlink(file, folder.path() / file.filename());
  }
  QVERIFY(test::shows_world(read_image(folder.path(), RunContext()).value()));
  QCOMPARE(files_below(folder.path()), 4L);
}

QTEST_APPLESS_MAIN(HostileTest)
#include "hostile_test.moc"
