// SPDX-License-Identifier: GPL-3.0-or-later
// A save takes over the image's file where it is the same image, to the byte, and writes it anew otherwise.
#include "glisson/engine/saved_image.h"

#include <sys/stat.h>

#include <QTest>

#include <fstream>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/keep_copy.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/recovery.h"
#include "glisson/engine/script.h"
#include "glisson/volume/io.h"
#include "killed_child.h"
#include "plain_ct.h"
#include "seeded_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::seed_on_disk;
using test::seeds;
namespace fs = std::filesystem;

namespace {

/// What is the same for two names of one file.
std::pair<dev_t, ino_t> file_at(const fs::path& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) throw FileError(path.string() + ": is missing.");
  return {found.st_dev, found.st_ino};
}

/// Somebody touches a file, without a trace in its time or its size.
void touch(const fs::path& path) {
  const auto time = fs::last_write_time(path);
  std::string bytes = read_file(path);
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  fs::last_write_time(path, time);
}

/// Another patient's.
Image changed(Image image) {
  auto voxels = std::make_shared<std::vector<std::int16_t>>(*image.voxels);
  voxels->front() = 7;
  image.voxels = voxels;
  return image;
}

/// Whether the case in a folder holds the image of a state, read by itself.
bool holds_image(const fs::path& folder, const CaseState& state) {
  const auto opened = open_case(folder, RunContext());
  const auto &there = (*opened)[part::image], &here = state[part::image];
  return *there->voxels == *here->voxels && there->grid.same_as(here->grid) &&
         there->modality == here->modality;
}

}  // namespace

class SavedImageTest : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    test::write_plain_ct(folder_->path() / "ct.nrrd");
    script_ = std::make_unique<Script>(RunContext());
    script_->run(ImportImage{folder_->path() / "ct.nrrd"});
  }
  void cleanup() {
    script_.reset();
    folder_.reset();
  }
  void TheNextSaveTakesTheFileOver();
  void WhatWasOpenedIsTakenOver();
  void AnotherPlaceGetsACopy();
  void ATouchedFileIsWrittenAnewAndKept();
  void AFileTouchedBeforeItWasOpenedIsWrittenAnew();
  void AnotherImageIsWrittenAnew();
  void WhereNothingIsListedItIsWrittenAnew();
  void RecoveryCopiesTakeItOver();
  void ATouchedRecoveryCopyIsWrittenAnew();
  void KilledAtAnyMomentTheCaseHasItsImage();

 private:
  fs::path place(const char* name = "a.glisson") const { return folder_->path() / name; }
  static fs::path image_of(const fs::path& folder) { return folder / "image.nrrd"; }
  const CaseState& state() const { return script_->state(); }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<Script> script_;
};

void SavedImageTest::TheNextSaveTakesTheFileOver() {
  script_->run(SaveCase{place()});
  const auto first = file_at(image_of(place()));
  script_->run(seeds(0.2));
  QVERIFY(script_->run(SaveCase{})->notes.empty());
  QVERIFY(file_at(image_of(place())) == first);
  QCOMPARE(fs::hard_link_count(image_of(place())), std::uintmax_t{1});  // the former case is gone
  QVERIFY(holds_image(place(), state()));
  QCOMPARE(seed_on_disk(place()), 0.2);
  QCOMPARE(open_case(place(), RunContext())->stamp(part::image).revision,
           state().stamp(part::image).revision);
}

void SavedImageTest::WhatWasOpenedIsTakenOver() {
  script_->run(SaveCase{place()});
  const auto first = file_at(image_of(place()));
  script_.reset();  // lets go of the case
  Script again{RunContext()};
  again.run(OpenCase{place()});
  again.run(seeds(0.3));
  again.run(SaveCase{});
  QVERIFY(file_at(image_of(place())) == first);
  QVERIFY(holds_image(place(), again.state()));
  QCOMPARE(seed_on_disk(place()), 0.3);
}

void SavedImageTest::AnotherPlaceGetsACopy() {
  script_->run(SaveCase{place()});
  const auto first = file_at(image_of(place()));
  script_->run(SaveCase{place("b.glisson")});
  QVERIFY(file_at(image_of(place("b.glisson"))) != first);
  QVERIFY(read_file(image_of(place("b.glisson"))) == read_file(image_of(place())));
  QVERIFY(file_at(image_of(place())) == first);
  touch(image_of(place()));  // is not seen there
  QVERIFY(holds_image(place("b.glisson"), state()));
}

void SavedImageTest::ATouchedFileIsWrittenAnewAndKept() {
  script_->run(SaveCase{place()});
  touch(image_of(place()));
  const auto touched = file_at(image_of(place()));
  const auto outcome = script_->run(SaveCase{});
  QCOMPARE(outcome->notes.size(), std::size_t{1});
  QVERIFY(file_at(image_of(place())) != touched);
  QVERIFY(file_at(place() / "image.nrrd.kept-1") == touched);
  QVERIFY(holds_image(place(), state()));
  // Nor does it go to another place.
  touch(image_of(place()));
  script_->run(SaveCase{place("b.glisson")});
  QVERIFY(holds_image(place("b.glisson"), state()));
}

void SavedImageTest::AFileTouchedBeforeItWasOpenedIsWrittenAnew() {
  script_->run(SaveCase{place()});
  const Image other = changed(*state()[part::image]);
  script_.reset();
  write_image(image_of(place()), other);
  Script again{RunContext()};
  again.run(OpenCase{place()});
  QCOMPARE(int{again.state()[part::image]->voxels->front()}, 7);
  const auto touched = file_at(image_of(place()));
  QCOMPARE(again.run(SaveCase{})->notes.size(), std::size_t{1});
  QVERIFY(file_at(image_of(place())) != touched);
  QVERIFY(holds_image(place(), again.state()));
}

void SavedImageTest::AnotherImageIsWrittenAnew() {
  script_->run(SaveCase{place()});
  const auto first = file_at(image_of(place()));
  const Image other = changed(*state()[part::image]);
  write_image(folder_->path() / "other.nrrd", other);
  script_->run(ImportImage{folder_->path() / "other.nrrd"});
  script_->run(SaveCase{});
  QVERIFY(file_at(image_of(place())) != first);
  QVERIFY(holds_image(place(), state()));
}

void SavedImageTest::WhereNothingIsListedItIsWrittenAnew() {
  script_->run(SaveCase{place()});
  script_.reset();
  nlohmann::json document = read_json(place() / "case.json");
  document.erase("files");  // as an earlier edition wrote it
  write_json(place() / "case.json", document);
  const auto first = file_at(image_of(place()));
  Script again{RunContext()};
  again.run(OpenCase{place()});
  again.run(SaveCase{});
  QVERIFY(file_at(image_of(place())) != first);
  QVERIFY(holds_image(place(), again.state()));
}

void SavedImageTest::RecoveryCopiesTakeItOver() {
  script_->run(SaveCase{place()});
  const RecoveryFolder own(folder_->path() / "recovery");
  const fs::path copy = own.path() / "copy.glisson";
  const auto saved = std::make_shared<SavedImage>();
  script_->run(KeepCopy{own.path(), saved});
  const auto first = file_at(image_of(copy));
  QVERIFY(first != file_at(image_of(place())));  // a copy of it
  QVERIFY(read_file(image_of(copy)) == read_file(image_of(place())));
  script_->run(seeds(0.2));
  script_->run(KeepCopy{own.path(), saved});
  QVERIFY(file_at(image_of(copy)) == first);
  QCOMPARE(fs::hard_link_count(image_of(copy)), std::uintmax_t{1});
  QVERIFY(holds_image(copy, state()));
  QCOMPARE(seed_on_disk(copy), 0.2);
  // The case's own place is not mixed up with the copy's.
  const auto own_file = file_at(image_of(place()));
  script_->run(SaveCase{});
  QVERIFY(file_at(image_of(place())) == own_file);
}

void SavedImageTest::ATouchedRecoveryCopyIsWrittenAnew() {
  const RecoveryFolder own(folder_->path() / "recovery");
  const fs::path copy = own.path() / "copy.glisson";
  const auto saved = std::make_shared<SavedImage>();
  // Another patient's case whose image has the same revision.
  const Image other = changed(*state()[part::image]);
  write_image(folder_->path() / "other.nrrd", other);
  std::uint64_t revision = 0;
  for (const char* name : {"ct.nrrd", "other.nrrd"}) {
    Script script{RunContext()};
    script.run(ImportImage{folder_->path() / name});
    QVERIFY(revision == 0 || revision == script.state().stamp(part::image).revision);
    revision = script.state().stamp(part::image).revision;
    script.run(KeepCopy{own.path(), saved});
    QVERIFY(holds_image(copy, script.state()));
    touch(image_of(copy));
    script.run(KeepCopy{own.path(), saved});
    QVERIFY(holds_image(copy, script.state()));
  }
}

void SavedImageTest::KilledAtAnyMomentTheCaseHasItsImage() {
  script_->run(seeds(0.1));
  script_->run(SaveCase{place()});
  SavedImage saved;
  saved.remember(state(), place(), place());
  script_->run(seeds(0.2));
  const auto first = file_at(image_of(place()));
  int killed = 0;
  for (bool completed = false; !completed && killed < 100;) {
    completed = test::comes_through(
        killed + 1, [&](const RunContext& context) { save_case(place(), state(), context, saved); });
    killed += completed ? 0 : 1;
    QVERIFY(holds_image(place(), state()));  // opening it sweeps what the killed one left
    QVERIFY(file_at(image_of(place())) == first);
    QCOMPARE(fs::hard_link_count(image_of(place())), std::uintmax_t{1});
    const double seed = seed_on_disk(place());
    QVERIFY(seed == 0.2 || (seed == 0.1 && !completed));
  }
  QVERIFY2(killed >= 3 && killed < 100, qPrintable(QString::number(killed)));  // it was killed on the way
}

QTEST_APPLESS_MAIN(SavedImageTest)
#include "saved_image_test.moc"
