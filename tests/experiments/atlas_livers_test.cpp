// SPDX-License-Identifier: GPL-3.0-or-later
// Livers for atlases: label maps as others wrote them, and what an atlas foretells of a liver it never saw.
#include "glisson/experiments/atlas_livers.h"

#include <QTest>
#include <cmath>

#include "foretold.h"
#include "glisson/core/files.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/io.h"

using namespace glisson;
using namespace glisson::experiments;
using atlas::Structure;
namespace fs = std::filesystem;

namespace {

/// An ellipsoid of a liver with the cava at its back, to the left of its middle. The codes are those of the
/// real maps, and so is the header: it claims that left is right.
LabelVolume label_map() {
  VolumeGrid grid;
  grid.size = {72, 60, 48};
  grid.spacing_mm = {3.0, 3.0, 3.0};
  grid.direction = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  LabelVolume labels(grid);
  for (int k = 0; k < 48; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 72; ++i) {
        const Eigen::Vector3d p = 3.0 * Eigen::Vector3d(i - 36.0, j - 30.0, k - 24.0);
        if (p.cwiseQuotient(Eigen::Vector3d(95.0, 70.0, 60.0)).norm() <= 1.0) labels.set({i, j, k}, 6);
        if (std::hypot(p.x() - 25.0, p.y() + 58.0) <= 12.0)
          labels.set({i, j, k}, 9);  // +y leads to the front
      }
  return labels;
}

}  // namespace

class AtlasLiversTest : public QObject {
  Q_OBJECT
 private slots:
  void LabelMapsAreListedInOrder();
  void ALabelMapsSidesAreMended();
  void WhatAnAtlasForetellsIsHeldAgainstTheLiver();
  void ACancelGivesNothing();
};

void AtlasLiversTest::LabelMapsAreListedInOrder() {
  const TemporaryFolder folder;
  QVERIFY(label_map_names(folder.path()).empty());
  fs::create_directory(folder.path() / "liver_labelmaps");
  for (const char* name : {"0010.nii.gz", "0003.nii.gz", "README.txt", "0002.nii.gz"})
    write_file_atomically(folder.path() / "liver_labelmaps" / name, "x");
  QCOMPARE(label_map_names(folder.path()), (std::vector<std::string>{"0002", "0003", "0010"}));
  QVERIFY(is_for_development("0002") && is_for_development("0010") && !is_for_development("0003"));
}

void AtlasLiversTest::ALabelMapsSidesAreMended() {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "liver_labelmaps");
  write_labels(folder.path() / "liver_labelmaps/0002.nii.gz", label_map(), {});
  const auto member = label_map_member(folder.path(), "0002", RunContext());
  QVERIFY(member);
  QCOMPARE(member->name, std::string("0002"));
  const Points& liver = member->liver.vertices;
  const Eigen::RowVector3d size = liver.colwise().maxCoeff() - liver.colwise().minCoeff();
  QVERIFY2((size - Eigen::RowVector3d(0.19, 0.14, 0.12)).cwiseAbs().maxCoeff() < 5e-3,
           qPrintable(QString("%1 %2 %3").arg(size.x()).arg(size.y()).arg(size.z())));
  // The cava lies to the patient's left of the liver's middle (+x) and behind it (+y).
  const auto cava = member->structures.find(Structure::vena_cava);
  QVERIFY(cava != member->structures.end() && cava->second.rows() > 10);
  const Eigen::RowVector3d off = cava->second.colwise().mean() - liver.colwise().mean();
  QVERIFY2(off.x() > 10e-3 && off.y() > 30e-3, qPrintable(QString("%1 %2").arg(off.x()).arg(off.y())));
  QVERIFY(!member->structures.contains(Structure::gallbladder_bed));
}

/// Of the population whose shapes, vena cava and portal entrance the built-in atlas has, but none of its
/// livers.
void AtlasLiversTest::WhatAnAtlasForetellsIsHeldAgainstTheLiver() {
  const fs::path source = qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString();
  const atlas::Atlas built_in = atlas::read_atlas(source / "resources/atlas");
  atlas::Member member = synthetic_member(9001);
  QCOMPARE(member.name, std::string("synthetic_9001"));
  member.structures.erase(Structure::gallbladder_bed);
  const auto found = foretold(built_in, member, RunContext());
  QVERIFY(found);
  QCOMPARE(found->name, member.name);
  QVERIFY(found->mean_distance > 0.0 && found->mean_distance < 3e-3 &&
          found->max_distance > found->mean_distance);
  QVERIFY(!found->structures.contains(Structure::gallbladder_bed));  // nothing to be held against
  for (const Structure structure : {Structure::portal_entrance, Structure::vena_cava}) {
    const atlas::LeftOutStructure& one = found->structures.at(structure);
    QVERIFY2(one.mean_error > 0.0 && one.mean_error < 30e-3, atlas::structure_code(structure));
    QVERIFY(one.points > 0 && one.inside >= 0 && one.inside <= one.points);
  }
  QVERIFY(found->structures.at(Structure::vena_cava).area_distance > 0.0);
  // Moved aside, its portal entrance is as much farther off.
  for (auto& [structure, points] : member.structures)
    if (structure == Structure::portal_entrance) points.col(0).array() += 0.2;
  const double far =
      foretold(built_in, member, RunContext())->structures.at(Structure::portal_entrance).mean_error;
  QVERIFY(std::abs(far - 0.2) < 30e-3);
}

void AtlasLiversTest::ACancelGivesNothing() {
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  const fs::path source = qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString();
  const atlas::Atlas built_in = atlas::read_atlas(source / "resources/atlas");
  QVERIFY(!foretold(built_in, synthetic_member(9001), RunContext({}, flag, 1)));
}

QTEST_GUILESS_MAIN(AtlasLiversTest)
#include "atlas_livers_test.moc"
