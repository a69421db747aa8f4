// SPDX-License-Identifier: GPL-3.0-or-later
// Saving a case destroys nothing that is not the case's.
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"
#include "seeded_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::seed_on_disk;
namespace fs = std::filesystem;

namespace {

CaseState state_with(double seed, bool has_labels = true) {
  CaseState state;
  auto clicked = std::make_shared<segmentation::Seeds>();
  clicked->liver = Eigen::RowVector3d(seed, 0.0, 0.0);
  state[part::seeds] = clicked;
  state.stamp(part::seeds).revision = 1;
  if (!has_labels) return state;
  VolumeGrid grid;
  grid.size = {8, 8, 8};
  grid.spacing_mm = {1.0, 1.0, 1.0};
  auto labels = std::make_shared<LabelMap>();
  labels->voxels = LabelVolume(grid);
  labels->voxels.set({2, 3, 4}, structure::kParenchyma);
  state[part::labels] = labels;
  state.stamp(part::labels).revision = 2;
  return state;
}

std::set<std::string> names(const fs::path& folder) {
  std::set<std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    all.insert(entry.path().lexically_relative(folder).string());
  return all;
}

}  // namespace

class CaseForeignTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup() { folder_.reset(); }
  void ForeignFilesStay();
  void ForeignFilesOfAnOlderEditionStay();
  void WhatOthersChangedIsKeptBeside();
  void WhatOthersChangedIsToldAtOpening();
  void WhatOthersChangedInAFolderIsToldAtOpening_data();
  void WhatOthersChangedInAFolderIsToldAtOpening();
  void NumbersOfACaseStayInTheirRange();
  void WhatTheCaseNoLongerHasGoes();
  void AForeignFileOfOneOfItsNamesIsNotReadAsItsOwn();
  void ALinkToACaseStaysOne();
  void PermissionsOfTheCaseStay();
  void ForeignFoldersStayAsTheyAre();
  void AFolderThatCannotBeReadIsNamed();
  void SameContentIsSameBytes();
  void KilledSavesLeaveNothingAfterTheNextOpening();
  void CasesInALoopOfLinksAreNamed();

 private:
  fs::path path() const { return folder_->path() / "a.glisson"; }
  std::vector<std::string> save(const CaseState& state) const {
    std::vector<std::string> notes;
    save_case(path(), state, RunContext(), &notes);
    return notes;
  }
  std::unique_ptr<TemporaryFolder> folder_;
};

void CaseForeignTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  save(state_with(0.1));
}

void CaseForeignTest::ForeignFilesStay() {
  write_file_atomically(path() / "letter.txt", "Dear colleague");
  fs::create_directories(path() / "photos/empty");
  write_file_atomically(path() / "photos/1.png", "a photo");
  fs::create_symlink("/somewhere/else", path() / "photos/link");
  QCOMPARE(::mkfifo((path() / "pipe").c_str(), 0600), 0);
  for (const double seed : {0.2, 0.3}) {
    QVERIFY(save(state_with(seed)).empty());
    QCOMPARE(seed_on_disk(path()), seed);
    QCOMPARE(read_file(path() / "letter.txt"), std::string("Dear colleague"));
    QCOMPARE(read_file(path() / "photos/1.png"), std::string("a photo"));
    QVERIFY(fs::is_directory(path() / "photos/empty"));
    QCOMPARE(fs::read_symlink(path() / "photos/link"), fs::path("/somewhere/else"));
    QVERIFY(fs::is_fifo(path() / "pipe"));
  }
}

void CaseForeignTest::ForeignFilesOfAnOlderEditionStay() {
  // Earlier editions did not list their files.
  nlohmann::json document = read_json(path() / "case.json");
  document.erase("files");
  write_json(path() / "case.json", document);
  write_file_atomically(path() / "letter.txt", "Dear colleague");
  write_file_atomically(path() / "model.stl", "a model");
  save(state_with(0.2, false));
  QVERIFY(names(path()) == (std::set<std::string>{"case.json", "letter.txt", "model.stl", "seeds.json"}));
}

void CaseForeignTest::WhatOthersChangedIsKeptBeside() {
  const std::string edited = read_file(path() / "seeds.json") + "\n";  // by another program
  write_file_atomically(path() / "seeds.json", edited);
  QCOMPARE(save(state_with(0.2)),
           std::vector<std::string>{"case.kept_changed " + (path() / "seeds.json.kept-1").string()});
  QCOMPARE(read_file(path() / "seeds.json.kept-1"), edited);
  QCOMPARE(seed_on_disk(path()), 0.2);
  QVERIFY(save(state_with(0.3)).empty());
  QCOMPARE(read_file(path() / "seeds.json.kept-1"), edited);
}

void CaseForeignTest::WhatOthersChangedIsToldAtOpening() {
  const auto told = [this] {
    std::vector<std::string> notes;
    (void)open_case(path(), RunContext(), &notes);
    return notes;
  };
  QVERIFY(told().empty());
  write_file_atomically(path() / "letter.txt", "Dear colleague");  // no file of the case
  QVERIFY(told().empty());
  write_file_atomically(path() / "seeds.json", read_file(path() / "seeds.json") + "\n");
  QCOMPARE(told(), std::vector<std::string>{"case.changed_outside seeds.json"});
}

void CaseForeignTest::WhatOthersChangedInAFolderIsToldAtOpening_data() {
  QTest::addColumn<bool>("told");
  for (const char* name : {"model/mesh.vtu", "model/vessels.vtp", "model/landmarks.json", "frame/left.png",
                           "points/whole.ply", "points/whole.json", "looks/look_1.ply", "history/steps.json",
                           "history/bricks.nrrd", "./model/mesh.vtu"})
    QTest::newRow(name) << true;
  for (const char* name : {"model/letter.txt", "model/deeper/mesh.vtu", "photos/left.png", "../mesh.vtu",
                           "model/../../mesh.vtu", "../model/mesh.vtu", "/model/mesh.vtu", ""})
    QTest::newRow(*name == '\0' ? "no name" : name) << false;
}

void CaseForeignTest::WhatOthersChangedInAFolderIsToldAtOpening() {
  QFETCH(bool, told);
  const std::string row = QTest::currentDataTag(), name = row == "no name" ? "" : row;
  // Listed with another sum than that of what lies there: changed since, in a part that is not read.
  nlohmann::json document = read_json(path() / "case.json");
  document["files"][name] = "0123456789abcdef";
  write_json(path() / "case.json", document);
  std::vector<std::string> notes;
  (void)open_case(path(), RunContext(), &notes);
  QCOMPARE(notes,
           told ? std::vector<std::string>{"case.changed_outside " + name} : std::vector<std::string>{});
  // The history is read wherever it lies: what it cannot be is an error of its own.
  if (!told || name.starts_with(".") || name.starts_with("history/")) return;
  fs::create_directories((path() / name).parent_path());
  write_file_atomically(path() / name, "by another program");
  notes.clear();
  (void)open_case(path(), RunContext(), &notes);
  QCOMPARE(notes, std::vector<std::string>{"case.changed_outside " + name});
}

void CaseForeignTest::NumbersOfACaseStayInTheirRange() {
  const std::string good = read_file(path() / "case.json");
  for (const char* value : {"-5", "1e300", "0.5", "99999999999999999999", "\"1\""}) {
    nlohmann::json document = nlohmann::json::parse(good);
    document["parts"]["seeds"]["revision"] = nlohmann::json::parse(value);
    write_json(path() / "case.json", document);
    QCOMPARE(test::refused_field([&] { (void)open_case(path(), RunContext()); }), std::string("revision"));
  }
}

void CaseForeignTest::WhatTheCaseNoLongerHasGoes() {
  save(state_with(0.2, false));
  QVERIFY(names(path()) == (std::set<std::string>{"case.json", "seeds.json"}));
}

void CaseForeignTest::AForeignFileOfOneOfItsNamesIsNotReadAsItsOwn() {
  fs::create_directory(path() / "history");
  write_file_atomically(path() / "history/steps.json", "nonsense");
  QCOMPARE(save(state_with(0.2)).size(), std::size_t{1});
  QCOMPARE(read_file(path() / "history/steps.json.kept-1"), std::string("nonsense"));
  QCOMPARE(seed_on_disk(path()), 0.2);
}

void CaseForeignTest::ALinkToACaseStaysOne() {
  const TemporaryFolder elsewhere;
  fs::rename(path(), elsewhere.path() / "real.glisson");
  fs::create_directory_symlink(elsewhere.path() / "real.glisson", path());
  save(state_with(0.2));
  QVERIFY(fs::is_symlink(path()));
  QCOMPARE(seed_on_disk(elsewhere.path() / "real.glisson"), 0.2);
  QVERIFY(names(elsewhere.path()).contains("real.glisson"));
  QCOMPARE(std::distance(fs::directory_iterator(elsewhere.path()), fs::directory_iterator()), 1L);
}

void CaseForeignTest::PermissionsOfTheCaseStay() {
  fs::permissions(path(), fs::perms::owner_all);
  save(state_with(0.2));
  QCOMPARE(static_cast<int>(fs::status(path()).permissions()), 0700);
}

void CaseForeignTest::ForeignFoldersStayAsTheyAre() {
  fs::create_directories(path() / "private/empty");
  write_file_atomically(path() / "private/letter.txt", "Dear colleague");
  const fs::perms own = fs::perms::owner_all, read_only = fs::perms::owner_read | fs::perms::owner_exec;
  fs::permissions(path() / "private/empty", read_only);
  fs::permissions(path() / "private", own);
  const fs::file_time_type long_ago = fs::file_time_type::clock::now() - std::chrono::hours(24 * 365);
  for (const char* name : {"private/empty", "private"}) fs::last_write_time(path() / name, long_ago);
  for (const double seed : {0.2, 0.3}) {
    save(state_with(seed));
    QVERIFY(fs::status(path() / "private").permissions() == own);
    QVERIFY(fs::status(path() / "private/empty").permissions() == read_only);
    QCOMPARE(read_file(path() / "private/letter.txt"), std::string("Dear colleague"));
    for (const char* name : {"private/empty", "private"})
      QVERIFY(std::chrono::abs(fs::last_write_time(path() / name) - long_ago) < std::chrono::seconds(2));
  }
}

void CaseForeignTest::AFolderThatCannotBeReadIsNamed() {
#if defined(GLISSON_INSTRUMENTED)
  if (::geteuid() == 0) QSKIP("leaks cannot be counted in a program that is run as somebody else");
#endif
  const QTemporaryDir folder;  // below which others may come
  const fs::path shared = folder.path().toStdString(), place = shared / "a.glisson";
  save_case(place, state_with(0.1), RunContext());
  fs::permissions(shared, fs::perms::all);
  fs::create_directory(place / "locked");
  fs::permissions(place / "locked", fs::perms::none);
  constexpr uid_t kNobody = 65534;
  const bool is_root = ::geteuid() == 0;  // who can read any folder
  if (is_root) QCOMPARE(::seteuid(kNobody), 0);
  const std::string told =
      test::complaint<FileError>([&] { save_case(place, state_with(0.2), RunContext()); });
  if (is_root) QCOMPARE(::seteuid(0), 0);
  fs::permissions(place / "locked", fs::perms::owner_all);
  QVERIFY2(told.find((place / "locked").string()) != std::string::npos, told.c_str());
  QCOMPARE(seed_on_disk(place), 0.1);
}

void CaseForeignTest::SameContentIsSameBytes() {
  const std::string before = read_file(path() / "case.json"), edition = edition_on_disk(path());
  save(state_with(0.1));
  QCOMPARE(read_file(path() / "case.json"), before);
  QCOMPARE(edition_on_disk(path()), edition);
  save(state_with(0.2));
  QVERIFY(edition_on_disk(path()) != edition);
}

void CaseForeignTest::KilledSavesLeaveNothingAfterTheNextOpening() {
  write_file_atomically(path() / "letter.txt", "Dear colleague");
  int killed = 0, littered = 0;
  for (int moment = 0; moment < 25; ++moment) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (int n = 0;; ++n) save(state_with(n % 2 == 0 ? 0.2 : 0.1));
    }
    ::usleep(static_cast<useconds_t>(1500 + 1700 * moment));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    killed += WIFSIGNALED(status);
    const auto entries = [&] {
      return std::distance(fs::directory_iterator(folder_->path()), fs::directory_iterator());
    };
    littered += entries() > 1;
    const double seed = seed_on_disk(path());
    QVERIFY(seed == 0.1 || seed == 0.2);
    QCOMPARE(entries(), 1L);
    QCOMPARE(read_file(path() / "letter.txt"), std::string("Dear colleague"));
  }
  QCOMPARE(killed, 25);
  QVERIFY(littered > 5);  // it was really killed on the way
}

void CaseForeignTest::CasesInALoopOfLinksAreNamed() {
  fs::create_symlink("y.glisson", folder_->path() / "x.glisson");
  fs::create_symlink("x.glisson", folder_->path() / "y.glisson");
  const auto told = [&](const auto& action) { return test::complaint<Error>(action); };
  const fs::path loop = folder_->path() / "x.glisson";
  QVERIFY(told([&] { open_case(loop, RunContext()); }).find("leads back to itself") != std::string::npos);
  QVERIFY(told([&] { save_case(loop, state_with(0.1), RunContext()); }).find("leads back to itself") !=
          std::string::npos);
}

QTEST_APPLESS_MAIN(CaseForeignTest)
#include "case_foreign_test.moc"
