// SPDX-License-Identifier: GPL-3.0-or-later
// An atlas of one's own cases: what goes into it, where it is kept, and what is refused.
#include <QTest>

#include <algorithm>
#include <fstream>

#include "atlas_cases.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/build_atlas.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

namespace {

/// With labels, of which the liver is approved or not.
void give_labels(const fs::path& path, bool approved) {
  CaseState state = *open_case(path, RunContext());
  VolumeGrid grid;
  grid.size = {4, 4, 4};
  auto labels = std::make_shared<LabelMap>();
  labels->voxels = LabelVolume(
      grid, std::vector<Label>(static_cast<std::size_t>(grid.voxel_count()), structure::kParenchyma));
  labels->infos.push_back(
      {structure::kParenchyma, "parenchyma", "", structure_colour(structure::kParenchyma)});
  state[part::labels] = labels;
  if (approved)
    state[part::review] =
        std::make_shared<const Review>(Review{{structure::kParenchyma, ReviewState::approved}});
  QVERIFY(save_case(path, state, RunContext()));
}

std::string complaint_of(const BuildAtlas& build) {
  try {
    (void)build.apply(CaseState(), RunContext());
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

/// Whether the livers are enough; the build is cancelled then.
bool is_begun(const BuildAtlas& build) {
  auto flag = std::make_shared<CancelFlag>();
  bool begun = false;
  const RunContext context(
      [&](double, std::string_view stage) {
        if (stage == "atlas.livers") return;
        begun = true;
        flag->request();
      },
      flag, 1);
  return !build.apply(CaseState(), context) && begun;
}

}  // namespace

class BuildAtlasTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    base_ = test::built_in_atlas();
    fs::create_directory(folder_.path() / "cases");
    paths_ = test::write_atlas_cases(folder_.path() / "cases", 5);
  }

  /// What a person has placed is the new atlas' own; the rest is taken over from the base, and said.
  void aFolderOfCasesBecomesAnAtlas() {
    BuildAtlas build{.cases = {folder_.path() / "cases"}, .base = base_, .out = folder_.path() / "made/own"};
    build.options.name = "own";
    double last = 0.0;
    const auto applied = build.apply(
        CaseState(), RunContext([&](double fraction, std::string_view) { last = fraction; }, nullptr, 1));
    QVERIFY(applied && last > 0.9);
    const auto result = applied->result.as<atlas::BuildResult>();
    QVERIFY(result && result->left_out.size() == 5);
    const atlas::Atlas read = atlas::read_atlas(folder_.path() / "made/own");
    QCOMPARE(read.name, std::string("own"));
    QCOMPARE(read.members.size(), std::size_t{5});
    QCOMPARE(read.members.front().name, std::string("liver_0"));
    QCOMPARE(read.find(atlas::Structure::umbilical_notch)->origin, std::string("own"));
    QCOMPARE(read.find(atlas::Structure::falciform_line)->origin,
             base_->find(atlas::Structure::falciform_line)->origin);
    QVERIFY(std::any_of(applied->notes.begin(), applied->notes.end(), [](const std::string& note) {
      return note.starts_with("atlas.taken_over falciform_line");
    }));
    QVERIFY(applied->figures.at("atlas_members") == 5.0);
  }

  /// And an atlas that is there gives way to the new one.
  void whatNobodyHasApprovedStaysOut() {
    const fs::path out = folder_.path() / "again";
    atlas::write_atlas(out, *base_);
    fs::create_directory(folder_.path() / "mixed");
    const auto paths = test::write_atlas_cases(folder_.path() / "mixed", 6);
    give_labels(paths[1], true);
    give_labels(paths[2], false);
    BuildAtlas build{.cases = paths, .base = base_, .out = out};
    build.options.name = "newer";
    build.cases[2] /= "";  // as a folder is completed on a command line
    const auto applied = build.apply(CaseState(), RunContext());
    QVERIFY(applied);
    QVERIFY(std::count(applied->notes.begin(), applied->notes.end(), "atlas.not_approved liver_2") == 1);
    const auto& members = applied->result.as<atlas::BuildResult>()->atlas.members;
    QCOMPARE(members.size(), std::size_t{5});
    QVERIFY(std::none_of(members.begin(), members.end(),
                         [](const atlas::AtlasMember& one) { return one.name == "liver_2"; }));
    build.cases.erase(build.cases.begin());  // four are too few, five with that one are not
    QVERIFY(complaint_of(build).find("5 livers") != std::string::npos);
    build.unapproved = true;
    QVERIFY(is_begun(build));
    QCOMPARE(atlas::read_atlas(out).name, std::string("newer"));
    QCOMPARE(std::distance(fs::directory_iterator(out), fs::directory_iterator()), std::ptrdiff_t{2});
  }

  /// An atlas is made of none of it.
  void aCaseWithoutItsCloudGoesIn() {
    fs::create_directory(folder_.path() / "lossy");
    const auto paths = test::write_atlas_cases(folder_.path() / "lossy", 5);
    CaseState state = *open_case(paths[0], RunContext());
    auto cloud = std::make_shared<LabelledCloud>();
    cloud->points = cloud->normals = Points::Constant(40, 3, 0.1);
    cloud->normals.rowwise().normalize();
    cloud->sigma.assign(40, 1e-3);
    state[part::cloud] = cloud;
    QVERIFY(save_case(paths[0], state, RunContext()));
    QVERIFY(fs::remove(paths[0] / "cloud.ply"));
    QVERIFY(is_begun({.cases = paths, .base = base_}));
  }

  /// It could propose nothing, and no case could keep that.
  void anAtlasOfNoStructureIsNotWritten() {
    BuildAtlas build{.base = std::make_shared<const atlas::Atlas>(atlas::bare_atlas(base_->mean())),
                     .out = folder_.path() / "of_nothing"};
    for (int i = 0; i < 5; ++i)
      build.members.push_back({"liver_" + std::to_string(i),
                               test::atlas_case(*base_, i)[part::model]->model.surfaces.front().mesh,
                               {}});
    QVERIFY(complaint_of(build).find("structures") != std::string::npos);
    QVERIFY(!fs::exists(build.out));
  }

  void cancelLeavesNothing() {
    auto flag = std::make_shared<CancelFlag>();
    flag->request();
    const BuildAtlas build{.cases = paths_, .base = base_, .out = folder_.path() / "cancelled"};
    QVERIFY(!build.apply(CaseState(), RunContext({}, flag, 1)));
    QVERIFY(!fs::exists(folder_.path() / "cancelled"));
  }

  void whatCannotBeIsRefused() {
    const fs::path other = folder_.path() / "letters";
    fs::create_directory(other);
    QVERIFY(complaint_of({.cases = {other}, .base = base_}).find("letters") != std::string::npos);
    QVERIFY(complaint_of({.cases = {other / "none"}, .base = base_}).find("none") != std::string::npos);
    std::ofstream(other / "letter.txt") << "x";
    QVERIFY(complaint_of({.cases = paths_, .base = base_, .out = other}).find("letters") !=
            std::string::npos);
    QVERIFY(complaint_of({.cases = {paths_[0], paths_[1]}, .base = base_}).find("5 livers") !=
            std::string::npos);
    // Said before the livers are looked at.
    QVERIFY(complaint_of({.cases = {paths_[0]}, .base = base_, .out = other / "letter.txt/own"})
                .find("cannot be written to") != std::string::npos);
    QVERIFY_THROWS_EXCEPTION(PreconditionError,
                             (BuildAtlas{.cases = paths_}.apply(CaseState(), RunContext())));
  }

 private:
  TemporaryFolder folder_;
  std::shared_ptr<const atlas::Atlas> base_;
  std::vector<fs::path> paths_;
};

QTEST_APPLESS_MAIN(BuildAtlasTest)
#include "build_atlas_test.moc"
