// SPDX-License-Identifier: GPL-3.0-or-later
// Labels leave a case as a DICOM segmentation and come in again unchanged.
#include <QTest>

#include "../volume/dicom_bytes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/export_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/set_review.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/parts/source.h"
#include "glisson/engine/script.h"
#include "glisson/patient/segment_meaning.h"
#include "glisson/volume/dicom_segmentation.h"
#include "glisson/volume/io.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

constexpr Label kThird = structure::kFirstLesion + 2;  // lesions one and two are gone
constexpr const char* kFrame = "1.2.3.6";              // of reference, the CT's

class DicomLabelsTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void LabelsComeInAgainUnchanged();
  void NamedSegmentsOfOthersAreTakenByTheirMeaning();
  void AnotherGridIsRefused();
  void AnotherFrameOfReferenceIsTold();

 private:
  fs::path at(const char* name) const { return folder_->path() / name; }
  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<Script> script_;
  LabelVolume labels_;
};

void DicomLabelsTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  fs::create_directory(at("ct"));
  test::HandSlice slice;
  slice.other["0020|0052"] = kFrame;
  for (int k = 0; k < 4; ++k) write_file_atomically(at("ct") / std::to_string(k), test::dicom_of(k, slice));
  script_ = std::make_unique<Script>(RunContext());
  script_->run(ImportImage{at("ct")});
  // The first and the last slice are empty, so that the file has another grid than the CT.
  labels_ = LabelVolume(script_->state()[part::image]->grid);
  for (int i = 0; i < 6; ++i) labels_.set({i, 2, 1}, structure::kParenchyma);
  labels_.set({1, 1, 1}, structure::kPortalVein);
  labels_.set({2, 1, 2}, kThird);
}

void DicomLabelsTest::LabelsComeInAgainUnchanged() {
  write_labels(at("a.seg.nrrd"), labels_,
               {structure_info(structure::kParenchyma), structure_info(structure::kPortalVein),
                structure_info(kThird)});
  script_->run(ImportLabels{at("a.seg.nrrd"), {}});
  script_->run(SetReview{structure::kPortalVein, ReviewState::approved});
  const std::vector<LabelInfo> before = script_->state()[part::labels]->infos;
  script_->run(ExportLabels{at("a.dcm")});

  script_->run(ImportLabels{at("a.dcm"), {}});
  const LabelMap& after = *script_->state()[part::labels];
  QVERIFY(after.voxels == labels_);
  QCOMPARE(after.infos.size(), before.size());
  for (std::size_t n = 0; n < before.size(); ++n) {
    QCOMPARE(after.infos[n].code, before[n].code);
    QCOMPARE(after.infos[n].name, before[n].name);
    QCOMPARE(after.infos[n].terminology, structure_terminology(before[n].code));
    for (std::size_t c = 0; c < 3; ++c)
      QVERIFY(std::abs(after.infos[n].colour[c] - before[n].colour[c]) < 2e-3);
  }
  QCOMPARE(script_->state()[part::review]->at(structure::kPortalVein), ReviewState::approved);
  // It names the CT's slices, which the case knows.
  const std::string bytes = read_file(at("a.dcm"));
  for (const std::string& uid : script_->state()[part::source]->slice_uids)
    QVERIFY(bytes.find(uid) != std::string::npos);
}

/// As 3D Slicer numbers them: in the order in which they were drawn. By number the tumour would be the portal
/// vein.
void DicomLabelsTest::NamedSegmentsOfOthersAreTakenByTheirMeaning() {
  LabelVolume theirs(labels_.grid());
  theirs.set({1, 1, 1}, 1);
  theirs.set({2, 2, 2}, 2);
  theirs.set({3, 3, 2}, 3);
  theirs.set({4, 3, 2}, 4);
  LabelInfo portal{3, "Pfortader", structure_terminology(structure::kPortalVein)};
  portal.status = "completed";
  write_labels(at("theirs.seg.nrrd"), theirs,
               {{1, "Leber", structure_terminology(structure::kParenchyma)},
                {2, "Tumor", structure_terminology(structure::kFirstLesion)},
                portal,
                {4, "Milz links", "c~SCT^123037004^Anatomical Structure~SCT^78961009^Spleen~^^~c~^^~^^"}});
  const auto outcome = script_->run(ImportLabels{at("theirs.seg.nrrd"), {}});
  const LabelVolume& taken = script_->state()[part::labels]->voxels;
  QCOMPARE(taken.at({1, 1, 1}), structure::kParenchyma);
  QCOMPARE(taken.at({2, 2, 2}), structure::kFirstLesion);
  QCOMPARE(taken.at({3, 3, 2}), structure::kPortalVein);
  QCOMPARE(taken.at({4, 3, 2}), structure::kBackground);
  QCOMPARE(outcome->notes, (std::vector<std::string>{"labels.segments_left_out Milz links"}));
  QCOMPARE(script_->state()[part::review]->at(structure::kPortalVein), ReviewState::approved);
  // Numbers that a person gives come first; what they leave out is told.
  const auto given = script_->run(ImportLabels{at("theirs.seg.nrrd"), {{2, structure::kParenchyma}}});
  QCOMPARE(given->notes.size(), std::size_t{1});
  const std::string& left_out = given->notes.front();
  QVERIFY2(left_out.starts_with("labels.codes_left_out 1 Leber ("), left_out.c_str());
  QVERIFY2(left_out.find("4 Milz links (") != std::string::npos, left_out.c_str());
  QVERIFY2(left_out.find("Tumor") == std::string::npos, left_out.c_str());
  QCOMPARE(script_->state()[part::labels]->voxels.at({2, 2, 2}), structure::kParenchyma);
  QCOMPARE(script_->state()[part::labels]->voxels.at({1, 1, 1}), structure::kBackground);
}

void DicomLabelsTest::AnotherGridIsRefused() {
  VolumeGrid elsewhere = labels_.grid();
  elsewhere.origin_mm.x() += 0.4;
  LabelVolume shifted(elsewhere, labels_.dense());
  write_dicom_labels(at("a.dcm"), shifted, {}, {});
  try {
    script_->run(ImportLabels{at("a.dcm"), {}});
    QFAIL("is taken");
  } catch (const Error& error) {
    QVERIFY2(std::string(error.what()).find("a.dcm: ") != std::string::npos, error.what());
    QVERIFY2(std::string(error.what()).find("Resample") != std::string::npos, error.what());
  }
  QVERIFY(!script_->state()[part::labels]);
}

void DicomLabelsTest::AnotherFrameOfReferenceIsTold() {
  const auto notes = [&](const std::string& frame) {
    DicomSource source = *script_->state()[part::source];
    source.frame_of_reference_uid = frame;
    write_dicom_labels(at("a.dcm"), labels_, {}, source);
    return script_->run(ImportLabels{at("a.dcm"), {}})->notes;
  };
  QCOMPARE(notes("1.2.3.7"), (std::vector<std::string>{"labels.other_frame"}));
  QVERIFY(script_->state()[part::labels]->voxels == labels_);  // they are taken all the same
  QVERIFY(notes(kFrame).empty());
  // Where the CT does not say its frame there is nothing to compare.
  Image image = *script_->state()[part::image];
  write_image(at("ct.nrrd"), image);
  script_->run(ImportImage{at("ct.nrrd")});
  write_dicom_labels(at("a.dcm"), labels_, {}, {});
  QVERIFY(script_->run(ImportLabels{at("a.dcm"), {}})->notes.empty());
}

QTEST_APPLESS_MAIN(DicomLabelsTest)
#include "dicom_labels_test.moc"
