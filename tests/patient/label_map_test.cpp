// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/label_map.h"

#include <QTest>

#include <set>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/patient/label_summary.h"
#include "glisson/patient/segment_meaning.h"

using namespace glisson;

namespace {

VolumeGrid cube(int side, double spacing_mm) {
  VolumeGrid grid;
  grid.size = Eigen::Vector3i::Constant(side);
  grid.spacing_mm = Eigen::Vector3d::Constant(spacing_mm);
  return grid;
}

/// A ball of parenchyma (radius 20 mm in 50 voxels of 1 mm) with vessels running in along i from the left
/// edge of the volume to its middle: portal of radius 2 mm, hepatic of radius 6 mm, each half outside.
LabelMap liver_with_vessels() {
  const VolumeGrid grid = cube(50, 1.0);
  LabelMap map;
  map.voxels = LabelVolume(grid);
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 50; ++i) {
        const Eigen::Vector3d p(i - 25.0, j - 25.0, k - 25.0);
        if (p.norm() <= 20.0) map.voxels.set({i, j, k}, structure::kParenchyma);
        if (i <= 25 && std::hypot(p.y() - 10.0, p.z()) <= 2.0)
          map.voxels.set({i, j, k}, structure::kPortalVein);
        if (i <= 25 && std::hypot(p.y() + 6.0, p.z()) <= 6.0)
          map.voxels.set({i, j, k}, structure::kHepaticVeins);
        if (std::hypot(p.x() - 8.0, p.y(), p.z()) <= 4.0) map.voxels.set({i, j, k}, structure::kFirstLesion);
      }
  return map;
}

bool is_in(const LabelMap& map, const std::vector<std::uint8_t>& mask, int i, int j, int k) {
  return mask[static_cast<std::size_t>(map.voxels.grid().offset({i, j, k}))] != 0;
}

LabelFile file_of(const LabelVolume& voxels) { return {voxels, {}}; }

}  // namespace

class LabelMapTest : public QObject {
  Q_OBJECT
 private slots:
  void LiverHoldsItsLesionsAndTheVesselsWithinIt();
  void VesselsOutsideTheLiverStayOutside();
  void EmptyLabelsHaveNoInside();
  void RecodeFollowsTheTable();
  void RecodeRefusesAFileWithoutLiver();
  void RecodeRefusesAMirroredPatient();
  void SidesAreToldForAnyMeaningOfTheCodes();
  void APartThatIsSplitOffBecomesWhatIsFree();
  void CodesAreReadByName();
  void LesionsOfOtherOrgansAreNoneOfTheLiver();
  void BadCodesAreRefused_data();
  void BadCodesAreRefused();
};

void LabelMapTest::LiverHoldsItsLesionsAndTheVesselsWithinIt() {
  const LabelMap map = liver_with_vessels();
  const auto inside = inside_liver(map);
  QVERIFY(is_in(map, inside, 33, 25, 25));  // lesion
  QVERIFY(is_in(map, inside, 20, 35, 25));  // thin vessel
  QVERIFY(is_in(map, inside, 20, 19, 25));  // middle of the thick one
  // The volume is that of the ball: nothing is lost where the vessels run.
  const long count = std::count(inside.begin(), inside.end(), std::uint8_t(1));
  QVERIFY2(std::abs(count - 33510) < 500, qPrintable(QString::number(count)));
}

void LabelMapTest::VesselsOutsideTheLiverStayOutside() {
  const LabelMap map = liver_with_vessels();
  const auto inside = inside_liver(map);
  QVERIFY(!is_in(map, inside, 2, 35, 25));
  QVERIFY(!is_in(map, inside, 1, 19, 25));
  QVERIFY(!is_in(map, inside, 48, 25, 25));
}

void LabelMapTest::EmptyLabelsHaveNoInside() {
  LabelMap map;
  map.voxels = LabelVolume(cube(5, 1.0));
  const auto inside = inside_liver(map);
  QCOMPARE(inside.size(), std::size_t(125));
  QCOMPARE(std::count(inside.begin(), inside.end(), std::uint8_t(0)), std::ptrdiff_t(125));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, inside_liver(map, -1.0));
}

void LabelMapTest::RecodeFollowsTheTable() {
  LabelVolume foreign(cube(4, 1.0));
  foreign.set({0, 0, 0}, 449);
  foreign.set({1, 0, 0}, 451);
  foreign.set({2, 0, 0}, 65);  // not in the table
  LabelFile file = file_of(foreign);
  file.infos.push_back({451, "tumour", "a~terminology", {1, 0, 0}});
  const LabelMap map =
      recode(file, {{449, structure::kParenchyma}, {451, structure::kFirstLesion}}, "labels.nrrd");
  QCOMPARE(map.voxels.at({0, 0, 0}), structure::kParenchyma);
  QCOMPARE(map.voxels.at({1, 0, 0}), structure::kFirstLesion);
  QCOMPARE(map.voxels.at({2, 0, 0}), structure::kBackground);
  QCOMPARE(map.infos.size(), std::size_t(2));
  QCOMPARE(map.infos[1].name, std::string("lesion_1"));
  QCOMPARE(map.infos[1].terminology, std::string("a~terminology"));
}

void LabelMapTest::RecodeRefusesAFileWithoutLiver() {
  LabelVolume foreign(cube(4, 1.0));
  foreign.set({0, 0, 0}, 10);
  QVERIFY_THROWS_EXCEPTION(InputError, recode(file_of(foreign), {{10, structure::kPortalVein}}, "x"));
  QVERIFY_THROWS_EXCEPTION(InputError, recode(file_of(foreign), {{6, structure::kParenchyma}}, "x"));
  foreign.set({1, 0, 0}, structure::kParenchyma);  // its number alone says nothing
  QVERIFY_THROWS_EXCEPTION(InputError, recode(file_of(foreign), {}, "x"));
}

void LabelMapTest::RecodeRefusesAMirroredPatient() {
  LabelVolume foreign(cube(40, 2.0));
  foreign.set({5, 5, 5}, structure::kParenchyma);  // x grows to the patient's left
  foreign.set({30, 5, 5}, structure::kVenaCava);
  const LabelCodes as_they_are = {{1, structure::kParenchyma}, {4, structure::kVenaCava}};
  QCOMPARE(recode(file_of(foreign), as_they_are, "x").voxels.at({5, 5, 5}), structure::kParenchyma);
  VolumeGrid mirrored = foreign.grid();
  mirrored.direction(0, 0) = -1.0;
  const LabelVolume turned(mirrored, foreign.dense());
  QVERIFY(looks_mirrored(turned));
  QVERIFY_THROWS_EXCEPTION(InputError, require_not_mirrored(LabelSummary(turned), {}, "turned.nii"));
  QVERIFY_THROWS_EXCEPTION(InputError, recode(file_of(turned), as_they_are, "x"));
  QVERIFY(recode(file_of(turned), as_they_are, "x", LeftLiver::taken).voxels == turned);
}

void LabelMapTest::SidesAreToldForAnyMeaningOfTheCodes() {
  LabelVolume voxels(cube(40, 2.0));
  voxels.set({5, 5, 5}, 70);  // x grows to the patient's left
  voxels.set({20, 5, 5}, 71);
  voxels.set({38, 5, 5}, 72);
  const LabelSummary summary(voxels);
  QVERIFY(!summary.look_mirrored());  // no code of Glisson's is in it
  QCOMPARE(summary.labels(), (std::set<Label>{70, 71, 72}));
  QCOMPARE(summary.ml(71), 8e-3);
  QCOMPARE(summary.ml(7), 0.0);
  using structure::kParenchyma, structure::kVenaCava;
  for (const auto& [codes, wanted] : std::vector<std::pair<LabelCodes, bool>>{
           {{{70, kParenchyma}, {71, kVenaCava}}, false},
           {{{71, kParenchyma}, {70, kVenaCava}}, true},
           {{{70, kParenchyma}}, false},
           // Its lesions are the liver's: what lies farther left than both outweighs the other.
           {{{70, kParenchyma}, {71, kVenaCava}, {72, structure::kFirstLesion}}, true}}) {
    QCOMPARE(summary.look_mirrored(codes), wanted);
    const LabelMap recoded = recode(file_of(voxels), codes, "x", LeftLiver::taken);
    QCOMPARE(LabelSummary(recoded.voxels).look_mirrored(), wanted);
    QCOMPARE(summary.labels(codes), LabelSummary(recoded.voxels).labels());
  }
  QVERIFY(!LabelSummary().look_mirrored());
}

void LabelMapTest::CodesAreReadByName() {
  const TemporaryFolder folder;
  const auto path = folder.path() / "codes.json";
  write_file_atomically(path, R"({"449": "parenchyma", "465": "portal_vein", "451": "lesion_1"})");
  const LabelCodes codes = read_label_codes(path);
  QCOMPARE(codes, (LabelCodes{{449, 1}, {465, 2}, {451, 16}}));
}

void LabelMapTest::LesionsOfOtherOrgansAreNoneOfTheLiver() {
  // Mass in the kidney, metastasis in a segment of the liver, cysts of the liver and of no region (SNOMED
  // CT).
  const std::string begin = "c~SCT^49755003^Morphologically Altered Structure~SCT^";
  const LabelCodes codes =
      codes_meant({{5, "Niere", begin + "4147007^Mass~^^~c~SCT^64033007^Kidney~^^"},
                   {6, "M1", begin + "14799000^Metastasis~^^~c~SCT^1^Segment 4 of Liver~^^"},
                   {7, "Z1", begin + "441457006^Cyst~^^~c~SCT^10200004^~^^"},
                   {8, "Z2", begin + "441457006^Cyst~^^~c~^^~^^"}});
  QCOMPARE(codes, (LabelCodes{{6, 16}, {7, 17}, {8, 18}}));
}

void LabelMapTest::BadCodesAreRefused_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("empty") << QByteArray("{}");
  QTest::newRow("a list") << QByteArray("[1, 2]");
  QTest::newRow("no number") << QByteArray(R"({"liver": "parenchyma"})");
  QTest::newRow("too large") << QByteArray(R"({"65536": "parenchyma"})");
  QTest::newRow("unknown structure") << QByteArray(R"({"1": "spleen"})");
  QTest::newRow("no text") << QByteArray(R"({"1": 2})");
  QTest::newRow("a code twice") << QByteArray(R"({"6": "parenchyma", "6": "lesion_1"})");
  QTest::newRow("a code in two spellings") << QByteArray(R"({"6": "parenchyma", "06": "lesion_1"})");
  QTest::newRow("not JSON") << QByteArray(R"({"1": )");
}

void LabelMapTest::BadCodesAreRefused() {
  QFETCH(QByteArray, text);
  const TemporaryFolder folder;
  const auto path = folder.path() / "codes.json";
  write_file_atomically(path, text.toStdString());
  QVERIFY_THROWS_EXCEPTION(InputError, read_label_codes(path));
  QVERIFY_THROWS_EXCEPTION(FileError, read_label_codes(folder.path() / "absent.json"));
}

void LabelMapTest::APartThatIsSplitOffBecomesWhatIsFree() {
  const auto taken = [](Label label) { return label == 7 || label == 17; };
  const std::vector<Label> lesions = free_labels(structure::kFirstLesion, taken);
  QCOMPARE(lesions.size(), std::size_t{239});
  QCOMPARE(lesions[0], Label{16});
  QCOMPARE(lesions[1], Label{18});
  QCOMPARE(lesions.back(), structure::kLastLesion);
  QCOMPARE(free_labels(structure::kPortalVein, taken), (std::vector<Label>{8, 9, 10, 11, 12, 13, 14, 15}));
  QVERIFY(free_labels(structure::kFirstLesion, [](Label) { return true; }).empty());
}

QTEST_APPLESS_MAIN(LabelMapTest)
#include "label_map_test.moc"
