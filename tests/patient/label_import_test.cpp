// SPDX-License-Identifier: GPL-3.0-or-later
// What the numbers of a file of labels mean, by whom it was written, and what is told of it.
#include "glisson/patient/label_import.h"

#include <QTest>

#include <memory>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/patient/segment_meaning.h"
#include "glisson/volume/dicom_segmentation.h"
#include "glisson/volume/io.h"

using namespace glisson;
using test::complaint;
namespace fs = std::filesystem;
using Notes = std::vector<std::string>;

constexpr Label kThird = structure::kFirstLesion + 2;  // lesions one and two are gone

class LabelImportTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void SegmentsOfOthersAreTakenByTheirMeaning();
  void LesionsOfOtherOrgansAreLeftOut();
  void VoxelsThatNoSegmentNamesAreTold();
  void NamedSegmentsThatMeanNothingAreRefused();
  void NumbersWithoutForeignNamesAreTaken();
  void AllTumoursUnderOneNumberAreOneLesionEach();
  void APieceTakesOverHowFarAPersonHadCome();
  void ALiverThatLooksMirroredIsRefusedOrTold();
  void AnotherGridIsRefused();
  void LabelsWithoutParenchymaAreRefused();
  void SegmentsThatMeanNothingOfTheLiverAreRefused();
  void CancelledItGivesNothing();
  void EveryStructureHasAMeaning();
  void ANumberIsNoName();

 private:
  fs::path at(const char* name) const { return folder_->path() / name; }
  ImportedLabels imported(const char* name, const LabelCodes& codes = {},
                          LeftLiver left_liver = LeftLiver::refused) const {
    return import_labels(at(name), codes, left_liver, {&labels_.grid(), {}}, RunContext()).value();
  }
  /// A DICOM segmentation that does not say that it is of Glisson.
  void write_foreign(const LabelVolume& labels, const std::vector<LabelInfo>& infos) const {
    write_dicom_labels(at("own.dcm"), labels, infos, {});
    std::string bytes = read_file(at("own.dcm"));
    for (std::size_t found = 0; (found = bytes.find("Glisson label ", found)) != std::string::npos;)
      bytes.replace(found, 14, "Another label ");
    write_file_atomically(at("foreign.dcm"), bytes);
  }
  std::unique_ptr<TemporaryFolder> folder_;
  LabelVolume labels_;
};

void LabelImportTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  VolumeGrid grid;
  grid.size = {6, 4, 4};
  // The first and the last slice are empty, so that a DICOM file has another grid than the CT.
  labels_ = LabelVolume(grid);
  for (int i = 0; i < 6; ++i) labels_.set({i, 2, 1}, structure::kParenchyma);
  labels_.set({1, 1, 1}, structure::kPortalVein);
  labels_.set({2, 1, 2}, kThird);
}

void LabelImportTest::SegmentsOfOthersAreTakenByTheirMeaning() {
  // Numbered otherwise: 1 is a lesion, 2 the spleen, 3 the liver.
  LabelVolume theirs(labels_.grid());
  theirs.set({1, 1, 1}, 1);
  theirs.set({2, 2, 2}, 2);
  theirs.set({3, 3, 2}, 3);
  write_foreign(theirs, {{1, "Tumor", structure_terminology(structure::kFirstLesion)},
                         {2, "Spleen", "c~SCT^123037004^Anatomical Structure~SCT^78961009^Spleen~^^~c~^^~^^"},
                         {3, "Leber", structure_terminology(structure::kParenchyma)}});
  const ImportedLabels made = imported("foreign.dcm");
  QCOMPARE(made.notes, Notes{"labels.segments_left_out Spleen"});
  QCOMPARE(made.labels.voxels.at({1, 1, 1}), structure::kFirstLesion);
  QCOMPARE(made.labels.voxels.at({2, 2, 2}), structure::kBackground);
  QCOMPARE(made.labels.voxels.at({3, 3, 2}), structure::kParenchyma);
}

void LabelImportTest::LesionsOfOtherOrgansAreLeftOut() {
  // Mass in the kidney, metastasis in a segment of the liver, cyst of no region (SNOMED CT).
  const std::string begin = "c~SCT^49755003^Morphologically Altered Structure~SCT^";
  LabelVolume theirs(labels_.grid());
  for (int n = 0; n < 4; ++n) theirs.set({n, 1, 1}, static_cast<Label>(n + 1));
  write_foreign(theirs, {{1, "Leber", structure_terminology(structure::kParenchyma)},
                         {2, "Niere", begin + "4147007^Mass~^^~c~SCT^64033007^Kidney~^^"},
                         {3, "M1", begin + "14799000^Metastasis~^^~c~SCT^1^Segment 4 of Liver~^^"},
                         {4, "Zyste", begin + "441457006^Cyst~^^~c~^^~^^"}});
  const ImportedLabels made = imported("foreign.dcm");
  QCOMPARE(made.labels.voxels.at({0, 1, 1}), structure::kParenchyma);
  QCOMPARE(made.labels.voxels.at({1, 1, 1}), structure::kBackground);
  QCOMPARE(made.labels.voxels.at({2, 1, 1}), structure::kFirstLesion);
  QCOMPARE(made.labels.voxels.at({3, 1, 1}), static_cast<Label>(structure::kFirstLesion + 1));
  QCOMPARE(made.notes, Notes{"labels.segments_left_out Niere"});
}

void LabelImportTest::VoxelsThatNoSegmentNamesAreTold() {
  // The key of the number of segment 1 is called otherwise: what it was is not known.
  LabelVolume theirs(labels_.grid());
  theirs.set({1, 1, 1}, 1);
  theirs.set({2, 1, 1}, 2);
  const auto made_of = [&](const std::string& liver) {
    write_labels(at("theirs.seg.nrrd"), theirs,
                 {{1, liver, structure_terminology(structure::kParenchyma)}, {2, "Tumor", "", {}}});
    std::string text = read_file(at("theirs.seg.nrrd"));
    const std::string key = "Segment1_ID:=";
    text.replace(text.find(key), key.size(), "Segment1_Id:=");
    write_file_atomically(at("theirs.seg.nrrd"), text);
    return imported("theirs.seg.nrrd");
  };
  const ImportedLabels named = made_of("Leber");
  QCOMPARE(named.notes, Notes{"labels.segments_left_out 2"});
  QCOMPARE(named.labels.voxels.at({2, 1, 1}), structure::kBackground);
  // Among Glisson's own names a number is taken for Glisson's, and that is told.
  const ImportedLabels own = made_of("parenchyma");
  QCOMPARE(own.notes, Notes{"labels.by_number 2 portal_vein"});
  QCOMPARE(own.labels.voxels.at({2, 1, 1}), structure::kPortalVein);
}

void LabelImportTest::NamedSegmentsThatMeanNothingAreRefused() {
  write_labels(at("theirs.seg.nrrd"), labels_, {{1, "Segment_1", structure_terminology(7)}});
  const std::string said = complaint([this] { imported("theirs.seg.nrrd"); });
  QVERIFY2(said.find("--codes") != std::string::npos, said.c_str());
  const ImportedLabels made = imported("theirs.seg.nrrd", {{1, structure::kParenchyma}});
  QCOMPARE(made.labels.voxels.at({0, 2, 1}), structure::kParenchyma);
}

void LabelImportTest::NumbersWithoutForeignNamesAreTaken() {
  const std::vector<LabelInfo> own = {structure_info(structure::kParenchyma),
                                      structure_info(structure::kPortalVein), structure_info(kThird)};
  write_labels(at("a.seg.nrrd"), labels_, own);
  QVERIFY(imported("a.seg.nrrd").notes.empty());
  QVERIFY(imported("a.seg.nrrd").labels.voxels == labels_);
  // In others' files 2 is the tumour, as often as not: what the numbers were taken for is told.
  for (const char* name : {"nameless.seg.nrrd", "a.nii"}) {
    write_labels(at(name), labels_, {});
    const ImportedLabels made = imported(name);
    QCOMPARE(made.notes, Notes{"labels.by_number 1 parenchyma, 2 portal_vein, " + std::to_string(kThird) +
                               ' ' + structure_name(kThird)});
    QVERIFY(made.labels.voxels == labels_);
  }
}

/// As in the files of most data sets: 1 is the liver, 2 all its tumours.
void LabelImportTest::AllTumoursUnderOneNumberAreOneLesionEach() {
  VolumeGrid grid;
  grid.size = {20, 6, 6};
  grid.spacing_mm.setConstant(2.0);
  const auto import_alone = [this](const char* name, const LabelCodes& codes) {
    return import_labels(at(name), codes, LeftLiver::refused, {}, RunContext()).value();
  };
  LabelVolume theirs(grid);
  for (int i = 0; i < 20; ++i) theirs.set({i, 3, 3}, 1);
  for (const int i : {2, 10, 11, 18}) theirs.set({i, 3, 3}, 2);
  write_labels(at("theirs.nii.gz"), theirs, {});
  const ImportedLabels made =
      import_alone("theirs.nii.gz", {{1, structure::kParenchyma}, {2, structure::kFirstLesion}});
  QCOMPARE(made.notes, Notes{"labels.lesion_split lesion_1 3"});
  const LabelVolume& taken = made.labels.voxels;
  QCOMPARE(taken.at({11, 3, 3}), structure::kFirstLesion);
  QCOMPARE(taken.at({2, 3, 3}) + taken.at({18, 3, 3}), 2 * structure::kFirstLesion + 3);
  QCOMPARE(taken.at({5, 3, 3}), structure::kParenchyma);
  // Glisson's own say which is which: places that a person made one lesion stay one.
  LabelVolume own(grid);
  for (int i = 0; i < 20; ++i) own.set({i, 3, 3}, structure::kParenchyma);
  for (const int i : {2, 18}) own.set({i, 3, 3}, structure::kFirstLesion);
  write_labels(at("own.seg.nrrd"), own,
               {structure_info(structure::kParenchyma), structure_info(structure::kFirstLesion)});
  QVERIFY(import_alone("own.seg.nrrd", {}).notes.empty());
  QVERIFY(import_alone("own.seg.nrrd", {}).labels.voxels == own);
}

void LabelImportTest::APieceTakesOverHowFarAPersonHadCome() {
  VolumeGrid grid;
  grid.size = {20, 6, 6};
  grid.spacing_mm.setConstant(2.0);
  LabelVolume theirs(grid);
  for (int i = 0; i < 20; ++i) theirs.set({i, 3, 3}, 1);
  for (const int i : {2, 18}) theirs.set({i, 3, 3}, 2);
  LabelInfo tumours{2, "Tumor", structure_terminology(structure::kFirstLesion)};
  LabelInfo liver{1, "Leber", structure_terminology(structure::kParenchyma)};
  liver.status = "flagged";
  tumours.status = "completed";
  write_labels(at("theirs.seg.nrrd"), theirs, {liver, tumours});
  const auto made = import_labels(at("theirs.seg.nrrd"), {}, LeftLiver::refused, {}, RunContext());
  QVERIFY((made->review == Review{{structure::kParenchyma, ReviewState::to_review},
                                  {structure::kFirstLesion, ReviewState::approved},
                                  {structure::kFirstLesion + 1, ReviewState::approved}}));
}

void LabelImportTest::ALiverThatLooksMirroredIsRefusedOrTold() {
  LabelVolume theirs(labels_.grid());
  theirs.set({1, 1, 1}, 1);
  theirs.set({5, 1, 1}, 2);
  const bool cava_is_left =
      theirs.grid().p_in_ct({5.0, 1.0, 1.0}).xyz.x() > theirs.grid().p_in_ct({1.0, 1.0, 1.0}).xyz.x();
  const Label liver = cava_is_left ? 2 : 1;
  write_labels(at("theirs.seg.nrrd"), theirs,
               {{liver, "Leber", structure_terminology(structure::kParenchyma)},
                {static_cast<Label>(3 - liver), "Hohlvene", structure_terminology(structure::kVenaCava)}});
  const std::string said = complaint([this] { imported("theirs.seg.nrrd"); });
  QVERIFY2(said.find("mirrored") != std::string::npos, said.c_str());
  QCOMPARE(imported("theirs.seg.nrrd", {}, LeftLiver::taken).notes, Notes{"liver.perhaps_mirrored"});
  QVERIFY(imported("theirs.seg.nrrd", {}, LeftLiver::asked).notes.empty());
}

void LabelImportTest::AnotherGridIsRefused() {
  VolumeGrid elsewhere = labels_.grid();
  elsewhere.origin_mm.x() += 0.4;
  const LabelVolume shifted(elsewhere, labels_.dense());
  write_dicom_labels(at("a.dcm"), shifted, {}, {});
  write_labels(at("a.seg.nrrd"), shifted, {});
  for (const char* name : {"a.dcm", "a.seg.nrrd"}) {
    const std::string said = complaint([&] { imported(name); });
    QVERIFY2(said.find(name) != std::string::npos, said.c_str());
  }
}

void LabelImportTest::LabelsWithoutParenchymaAreRefused() {
  LabelVolume vein(labels_.grid());
  vein.set({1, 1, 1}, structure::kPortalVein);
  write_labels(at("a.seg.nrrd"), vein, {structure_info(structure::kPortalVein)});
  const std::string said = complaint([this] { imported("a.seg.nrrd"); });
  QVERIFY2(said.find("parenchyma") != std::string::npos, said.c_str());
}

void LabelImportTest::SegmentsThatMeanNothingOfTheLiverAreRefused() {
  write_foreign(labels_, {});
  const std::string said = complaint([this] { imported("foreign.dcm"); });
  QVERIFY2(said.find("--codes") != std::string::npos, said.c_str());
  const ImportedLabels made = imported("foreign.dcm", {{1, structure::kParenchyma}});
  QCOMPARE(made.labels.voxels.at({0, 2, 1}), structure::kParenchyma);
}

void LabelImportTest::CancelledItGivesNothing() {
  write_labels(at("a.seg.nrrd"), labels_, {});
  auto flag = std::make_shared<CancelFlag>();
  flag->request();
  QVERIFY(!import_labels(at("a.seg.nrrd"), {}, LeftLiver::refused, {}, RunContext({}, flag, 1)));
}

void LabelImportTest::EveryStructureHasAMeaning() {
  for (const Label label :
       {structure::kParenchyma, structure::kPortalVein, structure::kHepaticVeins, structure::kVenaCava,
        structure::kArtery, structure::kGallbladder, structure::kFirstLesion})
    QCOMPARE(codes_meant({{9, "", structure_terminology(label)}}).at(9), label);
  QVERIFY(codes_meant({{9, "", structure_terminology(structure::kFirstOther)}}).empty());
}

void LabelImportTest::ANumberIsNoName() {
  QVERIFY(is_nameless({7, "", ""}) && is_nameless({7, "label_7", ""}));
  QVERIFY(!is_nameless({7, "label_8", ""}));
  QVERIFY(is_named_otherwise({structure::kParenchyma, "Leber", ""}));
  QVERIFY(is_named_otherwise({structure::kPortalVein, structure_name(structure::kParenchyma), ""}));
  QVERIFY(!is_named_otherwise(structure_info(structure::kParenchyma)));
  QVERIFY(!is_named_otherwise({structure::kParenchyma, "label_1", ""}));
}

QTEST_APPLESS_MAIN(LabelImportTest)
#include "label_import_test.moc"
