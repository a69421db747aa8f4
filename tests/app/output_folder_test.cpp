// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_folder.h"

#include <QCoreApplication>
#include <QTest>
#include <nlohmann/json.hpp>
#include <optional>

#include "complaint.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_lock.h"

using namespace glisson;
namespace fs = std::filesystem;

/// A case among what a command leaves is replaced as saving replaces it.
class OutputFolderTest : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    fs::create_directory(wanted());
  }
  void cleanup() { folder_.reset(); }
  void ACaseBehindALinkIsReplacedThere();
  void ACaseThatSomebodyHasOpenStays();

 private:
  fs::path wanted() const { return folder_->path() / "out"; }
  static void write_case(const fs::path& path, int revision) {
    fs::create_directories(path);
    write_json(path / "case.json", {{"format", "glisson-case"},
                                    {"version", 1},
                                    {"parts", {{"seeds", {{"revision", revision}}}}},
                                    {"files", nlohmann::json::object()}});
  }
  static int revision(const fs::path& path) {
    return read_json(path / "case.json")["parts"]["seeds"]["revision"];
  }

  std::unique_ptr<TemporaryFolder> folder_;
};

void OutputFolderTest::ACaseBehindALinkIsReplacedThere() {
  const fs::path there = folder_->path() / "there.glisson", link = wanted() / "patient.glisson";
  write_case(there, 1);
  fs::create_directory_symlink("../there.glisson", link);
  app::OutputFolder out(wanted());
  write_case(out.path() / "patient.glisson", 2);
  out.commit();
  QVERIFY(fs::is_symlink(link));
  QCOMPARE(revision(there), 2);
}

void OutputFolderTest::ACaseThatSomebodyHasOpenStays() {
  const fs::path taken = wanted() / "patient.glisson";
  write_case(taken, 1);
  app::OutputFolder out(wanted());
  write_case(out.path() / "patient.glisson", 2);
  write_file_atomically(out.path() / "report.txt", "new");
  std::optional<engine::CaseOwner> owner;
  auto window = engine::CaseLock::take(engine::case_place(taken), owner);
  QVERIFY(window != nullptr);
  const std::string told = test::complaint([&] { out.commit(); });
  QVERIFY2(told.find("is open for writing by") != std::string::npos, told.c_str());
  QCOMPARE(revision(taken), 1);
  QVERIFY(!fs::exists(wanted() / "report.txt"));  // all of it or nothing
  window.reset();
  out.commit();
  QCOMPARE(revision(taken), 2);
}

QTEST_GUILESS_MAIN(OutputFolderTest)
#include "output_folder_test.moc"
