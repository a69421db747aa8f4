// SPDX-License-Identifier: GPL-3.0-or-later
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/dicom_segmentation.h"
#include "segment_codes.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

class Writer {
 public:
  Writer(const fs::path& path, const LabelVolume& labels, const DicomSource& source)
      : path_(path), grid_(labels.grid()), dense_(labels.dense()), source_(source) {}

  void write(const std::vector<LabelInfo>& infos) {
    create();
    place();
    for (const LabelInfo& info : infos) add(info);
    write_file_atomically(path_, bytes());
  }

 private:
  void hold(const OFCondition& condition) const {
    if (condition.bad())
      throw InputError(path_.string(), "labels",
                       std::string("cannot be written as a DICOM segmentation (") + condition.text() + ")",
                       "Export the labels as .seg.nrrd instead");
  }

  /// A decimal of the at most 16 letters that DICOM allows.
  static std::string decimal(double value) {
    char text[32] = {};
    for (int digits = 15; digits > 0; --digits)
      if (std::snprintf(text, sizeof(text), "%.*g", digits, value) <= 16) break;
    return text;
  }

  /// At most the 64 letters that DICOM allows, none of them cut.
  static std::string shortened(const std::string& utf8) {
    std::size_t letters = 0, end = 0;
    for (; end < utf8.size(); ++end)
      if ((static_cast<unsigned char>(utf8[end]) & 0xC0U) != 0x80U && ++letters > 64) break;
    std::string text = utf8.substr(0, end);
    std::ranges::replace(text, '\\', '/');  // it parts values
    return text;
  }

  static std::string known_or_new(const std::string& uid) {
    if (!uid.empty()) return uid;
    char made[100] = {};
    return dcmGenerateUniqueIdentifier(made, SITE_INSTANCE_UID_ROOT);
  }

  void create() {
    static const IODGeneralEquipmentModule::EquipmentInfo kEquipment("Glisson", "Glisson", "0",
                                                                     GLISSON_VERSION);
    const ContentIdentificationMacro content("1", "LIVER", "Segmentation for the planning of liver surgery",
                                             "Glisson");
    DcmSegmentation* made = nullptr;
    hold(DcmSegmentation::createBinarySegmentation(made, static_cast<Uint16>(grid_.size.y()),
                                                   static_cast<Uint16>(grid_.size.x()), kEquipment, content));
    document_.reset(made);
    hold(document_->getSOPCommon().setSpecificCharacterSet("ISO_IR 192"));
    hold(document_->getSeries().setSeriesDescription("Glisson segmentation"));
    hold(document_->getSeries().setSeriesNumber("1"));
    hold(document_->getStudy().setStudyInstanceUID(known_or_new(source_.study_uid).c_str()));
    hold(document_->getFrameOfReference().setFrameOfReferenceUID(
        known_or_new(source_.frame_of_reference_uid).c_str()));
    IODMultiframeDimensionModule& dimensions = document_->getDimensions();
    const std::string uid = known_or_new("");
    hold(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, uid.c_str(),
                                      DCM_SegmentIdentificationSequence, "Segment"));
    hold(dimensions.addDimensionIndex(DCM_ImagePositionPatient, uid.c_str(), DCM_PlanePositionSequence,
                                      "Slice"));
  }

  /// What all frames share.
  void place() {
    FGPixelMeasures measures;
    hold(measures.setPixelSpacing(
        (decimal(grid_.spacing_mm.y()) + "\\" + decimal(grid_.spacing_mm.x())).c_str()));
    hold(measures.setSliceThickness(decimal(grid_.spacing_mm.z()).c_str()));
    hold(measures.setSpacingBetweenSlices(decimal(grid_.spacing_mm.z()).c_str()));
    hold(document_->addForAllFrames(measures));
    const Eigen::Vector3d row = grid_.direction.col(0), column = grid_.direction.col(1);
    FGPlaneOrientationPatient plane;
    hold(plane.setImageOrientationPatient(decimal(row.x()).c_str(), decimal(row.y()).c_str(),
                                          decimal(row.z()).c_str(), decimal(column.x()).c_str(),
                                          decimal(column.y()).c_str(), decimal(column.z()).c_str()));
    hold(document_->addForAllFrames(plane));
  }

  static CodeSequenceMacro code_of(const Code& code) {
    return {code.value.c_str(), code.scheme.c_str(), code.meaning.c_str()};
  }

  void add(const LabelInfo& info) {
    const SegmentCodes codes = codes_of_terminology(info.terminology);
    const std::string name = info.name.empty() ? "label_" + std::to_string(info.code) : info.name;
    DcmSegment* segment = nullptr;
    hold(DcmSegment::create(segment, "segment", code_of(codes.category), code_of(codes.type),
                            DcmSegTypes::SAT_SEMIAUTOMATIC, "Glisson"));
    std::unique_ptr<DcmSegment> owned(segment);
    const std::string description =
        kOwnSegment + std::to_string(info.code) + (info.status.empty() ? "" : ", " + info.status);
    names_.push_back(shortened(name));
    hold(segment->setSegmentDescription(description.c_str()));
    const auto lab = dicom_lab(info.colour);
    hold(segment->setRecommendedDisplayCIELabValue(lab[0], lab[1], lab[2]));
    if (!codes.region.value.empty())
      hold(segment->getGeneralAnatomyCode().getAnatomicRegion().set(
          codes.region.value.c_str(), codes.region.scheme.c_str(), codes.region.meaning.c_str()));
    Uint16 number = 0;
    hold(document_->addSegment(segment, number));
    (void)owned.release();  // the document's own now
    add_frames(info.code, number);
  }

  void add_frames(Label label, Uint16 segment) {
    const auto pixels = static_cast<std::size_t>(grid_.size.x()) * static_cast<std::size_t>(grid_.size.y());
    std::vector<Uint8> mask(pixels);
    for (int k = 0; k < grid_.size.z(); ++k) {
      const auto slice = dense_.begin() + static_cast<std::ptrdiff_t>(pixels) * k;
      std::transform(slice, slice + static_cast<std::ptrdiff_t>(pixels), mask.begin(),
                     [&](Label value) { return static_cast<Uint8>(value == label ? 1 : 0); });
      if (std::ranges::find(mask, Uint8{1}) == mask.end()) continue;
      FGFrameContent content;
      hold(content.setFrameAcquisitionNumber(1));
      hold(content.setDimensionIndexValues(segment, 0));
      hold(content.setDimensionIndexValues(static_cast<Uint32>(k + 1), 1));
      const Eigen::Vector3d p = 1e3 * grid_.p_in_ct(Eigen::Vector3d(0, 0, k)).xyz;
      FGPlanePosPatient position;
      hold(position.setImagePositionPatient(decimal(p.x()).c_str(), decimal(p.y()).c_str(),
                                            decimal(p.z()).c_str()));
      const std::unique_ptr<FGDerivationImage> derivation = reference_to(k);
      OFVector<FGBase*> groups;
      groups.push_back(&content);
      groups.push_back(&position);
      if (derivation) groups.push_back(derivation.get());
      hold(document_->addFrame(mask.data(), segment, groups));
      pack(mask);
    }
  }

  /// Frames follow each other without a gap, whether or not they end with a byte. By ourselves: the library
  /// (3.6.7) loses bits where they do not, which two other readers found.
  void pack(const std::vector<Uint8>& mask) {
    for (const Uint8 bit : mask) {
      if (bit_count_ % 8 == 0) bits_.push_back(0);
      bits_.back() = static_cast<Uint8>(bits_.back() | (bit << (bit_count_ % 8)));
      ++bit_count_;
    }
  }

  void put_bits(DcmDataset& data) {
    if (bits_.size() % 2 != 0) bits_.push_back(0);
    hold(data.putAndInsertUint8Array(DCM_PixelData, bits_.data(), bits_.size()));
  }

  bool names_slices() const {
    return !source_.slice_class_uid.empty() &&
           source_.slice_uids.size() == static_cast<std::size_t>(grid_.size.z());
  }

  /// The slice that frames at k were drawn on; null where it has no name.
  std::unique_ptr<FGDerivationImage> reference_to(int k) const {
    if (!names_slices()) return nullptr;
    OFVector<ImageSOPInstanceReferenceMacro> images;
    ImageSOPInstanceReferenceMacro image;
    hold(image.setReferencedSOPClassUID(source_.slice_class_uid.c_str()));
    hold(image.setReferencedSOPInstanceUID(source_.slice_uids[static_cast<std::size_t>(k)].c_str()));
    images.push_back(image);
    return std::unique_ptr<FGDerivationImage>(
        DcmSegmentation::createDerivationImageFG(images, "Segmentation"));
  }

  /// Study, series and slices once more, where archives look for them.
  void refer_to_series(DcmDataset& data) const {
    if (!names_slices() || source_.series_uid.empty()) return;
    DcmItem* series = nullptr;
    hold(data.findOrCreateSequenceItem(DCM_ReferencedSeriesSequence, series, 0));
    hold(series->putAndInsertString(DCM_SeriesInstanceUID, source_.series_uid.c_str()));
    for (std::size_t k = 0; k < source_.slice_uids.size(); ++k) {
      DcmItem* slice = nullptr;
      hold(series->findOrCreateSequenceItem(DCM_ReferencedInstanceSequence, slice, static_cast<long>(k)));
      hold(slice->putAndInsertString(DCM_ReferencedSOPClassUID, source_.slice_class_uid.c_str()));
      hold(slice->putAndInsertString(DCM_ReferencedSOPInstanceUID, source_.slice_uids[k].c_str()));
    }
  }

  /// Names come last: the library takes letters beyond ASCII for errors, whatever the character set.
  void name_segments(DcmDataset& data) const {
    for (std::size_t n = 0; n < names_.size(); ++n) {
      DcmItem* segment = nullptr;
      hold(data.findAndGetSequenceItem(DCM_SegmentSequence, segment, static_cast<long>(n)));
      hold(segment->putAndInsertString(DCM_SegmentLabel, names_[n].c_str()));
    }
  }

  std::string bytes() {
    DcmFileFormat file;
    hold(document_->writeDataset(*file.getDataset()));
    put_bits(*file.getDataset());
    name_segments(*file.getDataset());
    refer_to_series(*file.getDataset());
    const TemporaryFolder folder;
    const fs::path scratch = folder.path() / "labels.dcm";
    hold(file.saveFile(scratch.c_str(), EXS_LittleEndianExplicit));
    return read_file(scratch);
  }

  const fs::path& path_;
  const VolumeGrid& grid_;
  const std::vector<Label> dense_;
  const DicomSource& source_;
  std::unique_ptr<DcmSegmentation> document_;
  std::vector<std::string> names_;  ///< of the segments, UTF-8
  std::vector<Uint8> bits_;         ///< of all frames
  std::size_t bit_count_ = 0;
};

}  // namespace

void write_dicom_labels(const fs::path& path, const LabelVolume& labels, const std::vector<LabelInfo>& infos,
                        const DicomSource& source) {
  const VolumeGrid& grid = labels.grid();
  if (grid.size.x() > 65535 || grid.size.y() > 65535)
    throw InputError(path.string(), "size", "is more than the 65535 pixels a side that DICOM counts",
                     "Export the labels as .seg.nrrd instead");
  std::vector<LabelInfo> present;
  const std::vector<long> counts = labels.histogram();
  for (std::size_t code = 1; code < counts.size(); ++code) {
    if (counts[code] == 0) continue;
    const auto known = std::ranges::find_if(infos, [&](const LabelInfo& info) { return info.code == code; });
    present.push_back(known != infos.end() ? *known : LabelInfo{static_cast<Label>(code), "", ""});
  }
  if (present.empty())
    throw InputError(path.string(), "labels", "are empty, and a DICOM segmentation holds at least one",
                     "Segment the CT first");
  static std::once_flag quiet;  // the library tells its errors on the terminal, too
  std::call_once(quiet, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
  Writer(path, labels, source).write(present);
}

}  // namespace glisson
