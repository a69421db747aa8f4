// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <Eigen/LU>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "glisson/atlas/transfer.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/folder_exchange.h"
#include "known_livers.h"

using namespace glisson;
using namespace glisson::atlas;
namespace fs = std::filesystem;

namespace {

constexpr int kMembers = 5;

BuildResult built(std::vector<Member> members) {
  return *build(std::move(members), test::built_in(), BuildOptions(), RunContext());
}

double mean_apart(const Points& a, const Points& b) { return (a - b).rowwise().norm().mean(); }

std::string complaint_of(const fs::path& folder) {
  try {
    read_atlas(folder);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

void replace(const fs::path& file, const std::string& what, const std::string& by) {
  std::string text = read_file(file);
  const auto at = text.find(what);
  QVERIFY(at != std::string::npos);
  text.replace(at, what.size(), by);
  std::ofstream(file) << text;
}

}  // namespace

class BuildTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    for (int i = 0; i < kMembers; ++i)
      members_.push_back(test::synthetic_member(700 + static_cast<std::uint64_t>(i)));
    result_ = built(members_);
  }

  void everyLiverIsForetoldByTheOthers() {
    QCOMPARE(static_cast<int>(result_.left_out.size()), kMembers);
    for (const LeftOut& left : result_.left_out) {
      QVERIFY2(left.mean_distance < 1.5e-3, left.name.c_str());
      QCOMPARE(left.structures.size(), kStructures.size());
      // Synthetic livers differ less than patients: 25 mm would be another place.
      for (const auto& [structure, found] : left.structures)
        QVERIFY2(found.mean_error < 0.025, structure_code(structure));
    }
    QVERIFY(result_.quality.generality > 0.0 && result_.quality.specificity > 0.0);
  }

  /// Order, names' order and place of the livers are nothing that the atlas could know.
  void orderAndPlaceOfMembersDoNotMatter() {
    std::vector<Member> others = members_;
    std::reverse(others.begin(), others.end());
    const Eigen::RowVector3d by(0.4, -0.7, 0.9);
    others[1].liver.vertices.rowwise() += by;
    for (auto& [structure, points] : others[1].structures) points.rowwise() += by;
    const BuildResult again = built(others);
    QVERIFY(mean_apart(again.atlas.shape.mean, result_.atlas.shape.mean) < 1e-5);
    QCOMPARE(again.atlas.shape.mode_count(), result_.atlas.shape.mode_count());
    for (const Structure structure : kStructures)
      QVERIFY(mean_apart(again.atlas.find(structure)->mean, result_.atlas.find(structure)->mean) < 1e-3);
  }

  void theFolderHoldsTheAtlas() {
    const TemporaryFolder folder;
    write_atlas(folder.path(), result_.atlas);
    const Atlas read = read_atlas(folder.path());
    QVERIFY((read.shape.mean - result_.atlas.shape.mean).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY((read.shape.modes - result_.atlas.shape.modes).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY((read.shape.variances - result_.atlas.shape.variances).cwiseAbs().maxCoeff() < 1e-12);
    for (const Structure structure : kStructures) {
      const StructureStatistics &a = *result_.atlas.find(structure), &b = *read.find(structure);
      QVERIFY((a.mean - b.mean).cwiseAbs().maxCoeff() < 1e-6);
      QVERIFY((covariance(a, 0) - covariance(b, 0)).norm() < 1e-3 * covariance(a, 0).norm());
      QCOMPARE(a.members, b.members);
      QCOMPARE(a.share.size(), b.share.size());
    }
  }

  /// Another folder stands there afterwards, whole: no file of the former atlas was touched before.
  void anAtlasGivesWayInOneStep() {
    const TemporaryFolder folder;
    const fs::path own = folder.path() / "own", link = folder.path() / "link";
    replace_atlas(own, test::built_in());
    write_file_atomically(own / "notes.txt", "a person's");
    fs::create_directories(own / "figures/empty");
    fs::create_symlink("notes.txt", own / "figures/link");
    fs::permissions(own, fs::perms::owner_all);
    fs::create_directory_symlink("own", link);
    struct stat former = {}, standing = {};
    QCOMPARE(::stat(own.c_str(), &former), 0);
    replace_atlas(link / "", result_.atlas);
    QCOMPARE(::stat(own.c_str(), &standing), 0);
    QVERIFY(standing.st_ino != former.st_ino && standing.st_mode == former.st_mode);
    QCOMPARE(read_atlas(own).members.size(), result_.atlas.members.size());
    QCOMPARE(read_file(own / "notes.txt"), std::string("a person's"));
    QVERIFY(fs::is_directory(own / "figures/empty") && fs::is_symlink(own / "figures/link"));
    QVERIFY(fs::is_symlink(link));
    // And nothing is left beside it.
    QCOMPARE(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()),
             std::ptrdiff_t{2});
  }

  /// As a kill leaves it where the file system cannot exchange.
  void anAtlasUnderItsFormerNameIsFound() {
    const TemporaryFolder folder;
    const fs::path own = folder.path() / "own";
    replace_atlas(own, test::built_in());
    write_file_atomically(own / "notes.txt", "a person's");
    fs::rename(own, former_name(own));
    QCOMPARE(read_atlas(own).members.size(), test::built_in().members.size());
    replace_atlas(own, result_.atlas);
    QCOMPARE(read_atlas(own).members.size(), result_.atlas.members.size());
    QCOMPARE(read_file(own / "notes.txt"), std::string("a person's"));
    QVERIFY(!fs::exists(former_name(own)));
  }

  void aDamagedFolderIsRefusedByName() {
    const auto damaged = [&](const char* file, const std::string& what, const std::string& by) {
      const TemporaryFolder folder;
      write_atlas(folder.path(), result_.atlas);
      replace(folder.path() / file, what, by);
      return complaint_of(folder.path());
    };
    QVERIFY(damaged("atlas.json", "\"version\": 1", "\"version\": 2").find("version") != std::string::npos);
    QVERIFY(damaged("atlas.json", "glisson-atlas", "something").find("format") != std::string::npos);
    QVERIFY(damaged("atlas.json", "\"usual\"", "\"unusual\"").find("usual") != std::string::npos);
    QVERIFY(damaged("atlas.json", "umbilical_notch", "navel").find("navel") != std::string::npos);
    QVERIFY(damaged("atlas.json", "\"vertices\": ", "\"vertices\": 1").find("mean.vtp") != std::string::npos);
    QVERIFY(damaged("mean.vtp", "mode_1", "mode_x").find("mode_1") != std::string::npos);
    QVERIFY(!complaint_of("/nowhere/at/all").empty());
  }

  void whatNoCaseCouldKeepIsRefused() {
    const auto complaint = [](const Atlas& atlas) {
      const TemporaryFolder folder;
      write_atlas(folder.path(), atlas);
      return complaint_of(folder.path());
    };
    Atlas changed = result_.atlas;
    changed.structures.push_back(changed.structures.front());
    QVERIFY(complaint(changed).find("twice") != std::string::npos);
    changed.structures.clear();
    QVERIFY(complaint(changed).find("structures") != std::string::npos);
    changed = result_.atlas;
    for (StructureStatistics& one : changed.structures) one.share.resize(0);
    QVERIFY(complaint(changed).find("share_vena_cava") != std::string::npos);
    changed = result_.atlas;
    for (StructureStatistics& one : changed.structures) one.share.setZero();
    QVERIFY(complaint(changed).find("share_vena_cava") != std::string::npos);
  }

  /// All atlases on one base have as many vertices and triangles.
  void filesOfTwoAtlasesAreTold() {
    const TemporaryFolder one, other;
    Atlas larger = result_.atlas;
    larger.shape.mean *= 1.01;
    write_atlas(one.path(), result_.atlas);
    write_atlas(other.path(), larger);
    fs::copy_file(other.path() / "mean.vtp", one.path() / "mean.vtp", fs::copy_options::overwrite_existing);
    QVERIFY(complaint_of(one.path()).find("mean.vtp") != std::string::npos);
    // One of a former edition has no sum.
    replace(one.path() / "atlas.json", "\"surface_sum\"", "\"something\"");
    QVERIFY(complaint_of(one.path()).empty());
  }

  /// A base that was built of the same cases, under the same names, has other residuals of them.
  void whatIsTakenOverIsNotJudgedAndAnOutlierIsTold() {
    std::vector<Member> members = members_;
    members.push_back(test::synthetic_member(710));
    members.back().name = "odd one";
    for (const int axis : {0, 2}) members.back().liver.vertices.col(axis) *= axis == 0 ? 1.6 : 0.8;
    members.back().structures.clear();
    for (std::size_t i = 0; i < 3; ++i) {
      members[i].structures.erase(Structure::gallbladder_bed);
      members[i].structures.erase(Structure::portal_entrance);
    }
    const auto again = build(members, result_.atlas, BuildOptions(), RunContext());
    QVERIFY(again);
    for (const LeftOut& left : again->left_out)
      for (const Structure structure : {Structure::gallbladder_bed, Structure::portal_entrance})
        QVERIFY(!left.structures.contains(structure));
    QVERIFY(again->left_out.front().structures.contains(Structure::vena_cava));
    const auto told = [&](const std::string& note) {
      return std::any_of(again->notes.begin(), again->notes.end(),
                         [&](const std::string& one) { return one.starts_with(note); });
    };
    QVERIFY(told("atlas.taken_over gallbladder_bed"));
    QVERIFY(told("atlas.outlier odd"));
    QVERIFY(!told("atlas.outlier liver_"));
    for (const AtlasMember& member : again->atlas.members)
      QVERIFY((member.weight < 1.0) == (member.name == "odd one"));
  }

  /// The livers' marks lie elsewhere on them than the base's own members' did.
  void aKeptShapeStaysAndItsPlacesAreLearnt() {
    std::vector<Member> members = members_;
    for (Member& member : members) {
      const Points line = member.structures.at(Structure::anterior_margin);
      member.structures = {{Structure::umbilical_notch, line.row(line.rows() / 5)}};
    }
    BuildOptions options;
    options.name = "read";
    options.keep_shape = options.summed = true;
    const Atlas base = test::built_in();
    const auto made = build(members, base, options, RunContext());
    QVERIFY(made);
    const Atlas& atlas = made->atlas;
    QVERIFY(atlas.shape.mean == base.shape.mean && atlas.shape.modes == base.shape.modes);
    QCOMPARE(atlas.name, base.name + ", read");
    QCOMPARE(atlas.members.size(), base.members.size());
    QCOMPARE(atlas.structures.size(), base.structures.size());
    const StructureStatistics& notch = *atlas.find(Structure::umbilical_notch);
    QVERIFY(notch.origin == "read" && notch.members.empty() && notch.livers() == kMembers);
    QVERIFY(mean_apart(notch.mean, base.find(Structure::umbilical_notch)->mean) > 0.03);
    QCOMPARE(atlas.find(Structure::vena_cava)->mean, base.find(Structure::vena_cava)->mean);
    for (const LeftOut& left : made->left_out) {
      QCOMPARE(left.structures.size(), std::size_t{1});
      QVERIFY(left.structures.at(Structure::umbilical_notch).mean_error < 0.02);
    }
    // A liver that was not there, and the atlas read again.
    const TemporaryFolder folder;
    write_atlas(folder.path(), atlas);
    const Member other = test::synthetic_member(720);
    const Points line = other.structures.at(Structure::anterior_margin);
    const auto met = transfer(read_atlas(folder.path()), other.liver, {}, RunContext());
    for (const Proposal& one : met->proposals)
      if (one.structure == Structure::umbilical_notch) {
        QVERIFY(mean_apart(one.points, line.row(line.rows() / 5)) < 0.025);
        QCOMPARE(one.members, kMembers);
      }
    replace(folder.path() / "atlas.json", "\"summed_livers\": 5", "\"summed_livers\": 2");
    QVERIFY(complaint_of(folder.path()).find("summed_livers") != std::string::npos);
    QVERIFY_THROWS_EXCEPTION(InputError, build(members, bare_atlas(base.mean()), options, RunContext()));
  }

  void whatIsSummedUpNamesNoLiver() {
    BuildOptions options;
    options.summed = true;
    const auto made = build(members_, test::built_in(), options, RunContext());
    QVERIFY(made);
    for (const AtlasMember& member : made->atlas.members)
      QVERIFY2(!member.name.starts_with("liver_"), member.name.c_str());
    for (const Structure structure : kStructures) {
      const StructureStatistics &plain = *result_.atlas.find(structure),
                                &summed = *made->atlas.find(structure);
      QVERIFY(summed.members.empty() && summed.livers() == kMembers);
      QVERIFY((covariance(summed, 0) - covariance(plain, 0)).norm() < 1e-9 * covariance(plain, 0).norm());
    }
    QCOMPARE(made->left_out.front().name, result_.left_out.front().name);  // told, not kept
  }

  void whatTheImageShowsWins() {
    const Member other = test::synthetic_member(911);
    Evidence evidence;
    evidence.found[Structure::vena_cava] = other.structures.at(Structure::vena_cava);
    evidence.ridge = other.structures.at(Structure::anterior_margin).middleRows(20, 40);
    const Transfer made = *transfer(result_.atlas, other.liver, evidence, RunContext());
    for (const Proposal& one : made.proposals) {
      if (one.structure == Structure::vena_cava) {
        QVERIFY(one.source() == Source::image);
        QVERIFY(one.deviation() < 0.005);
        QCOMPARE(one.area.rows(), other.structures.at(Structure::vena_cava).rows());
      } else if (one.structure == Structure::anterior_margin) {
        // Where the ridge is known the margin is drawn to it, elsewhere it is statistics.
        const auto drawn = std::count(one.sources.begin(), one.sources.end(), Source::both);
        QVERIFY(drawn > 5 && drawn < point_count(one.structure));
        for (std::size_t k = 0; k < one.sources.size(); ++k)
          if (one.sources[k] == Source::both) {
            const auto row = one.points.row(static_cast<Eigen::Index>(k));
            QVERIFY((evidence.ridge.rowwise() - row).rowwise().norm().minCoeff() < 0.006);
          }
      } else {
        QVERIFY(one.source() == Source::statistics);
      }
    }
  }

  /// Half a liver is no liver: it is doubted, and its ellipsoids are larger than those of the whole one.
  void halfALiverIsDoubted() {
    const Member other = test::synthetic_member(911);
    TriangleMesh half = other.liver;
    const double cut = half.vertices.col(0).mean();
    // What lies to the left of the middle is pressed onto the cut: closed, and flat there.
    for (Eigen::Index v = 0; v < half.vertices.rows(); ++v)
      half.vertices(v, 0) = std::min(half.vertices(v, 0), cut + 0.02 * (half.vertices(v, 0) - cut));
    const Transfer whole = *transfer(test::built_in(), other.liver, {}, RunContext());
    const auto doubted = transfer(test::built_in(), half, {}, RunContext());
    QVERIFY(!doubted->doubts.empty());
    QVERIFY(doubted->unusual > 1.0 && doubted->unusual > whole.unusual);
    for (std::size_t i = 0; i < whole.proposals.size(); ++i)
      QVERIFY(doubted->proposals[i].deviation() > whole.proposals[i].deviation());
  }

  void piecesAndHolesAreSaid() {
    TriangleMesh open = members_[0].liver;
    open.triangles.conservativeResize(open.triangles.rows() - 30, 3);
    const PreparedLiver prepared = prepare(open, "liver");
    QVERIFY(std::find(prepared.doubts.begin(), prepared.doubts.end(), "atlas.open_surface") !=
            prepared.doubts.end());
  }

  void badMembersAreRefused() {
    const auto refused = [](std::vector<Member> members) {
      try {
        built(std::move(members));
      } catch (const InputError& error) {
        return std::string(error.what());
      }
      return std::string();
    };
    QVERIFY(refused({members_[0], members_[1]}).find("5 livers") != std::string::npos);
    std::vector<Member> twice = members_;
    twice[1].name = twice[0].name;
    QVERIFY(refused(twice).find(twice[0].name) != std::string::npos);
    std::vector<Member> tiny = members_;
    tiny[2].liver.vertices *= 1e-3;
    QVERIFY(!refused(tiny).empty());
    BuildOptions options;
    options.share = 0.0;
    QVERIFY_THROWS_EXCEPTION(InputError, build(members_, test::built_in(), options, RunContext()));
    options = {};
    options.threads = 3;
    QVERIFY_THROWS_EXCEPTION(InputError, build(members_, test::built_in(), options, RunContext()));
  }

 private:
  std::vector<Member> members_;
  BuildResult result_;
};

QTEST_APPLESS_MAIN(BuildTest)
#include "build_test.moc"
