// SPDX-License-Identifier: GPL-3.0-or-later
#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numeric>
#include <set>
#include <utility>

#include "claim.h"
#include "dicom_objects.h"
#include "dicom_pixels.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "most_values.h"
#include "segment_codes.h"
#include "slice_gaps.h"

namespace glisson::reader {
namespace {

using gdcm::DataSet;
using gdcm::Tag;

constexpr const char* kExport = "Export the segmentation again";

/// "PixelSpacing (0028|0030)", as errors call it.
struct Field {
  Tag tag;
  const char* name;
  std::string words() const {
    char text[16] = {};
    std::snprintf(text, sizeof(text), "%04x|%04x", tag.GetGroup(), tag.GetElement());
    return std::string(name) + " (" + text + ")";
  }
};
constexpr std::uint16_t kSegments = 0x0062;

/// The items of a sequence; the smart pointer keeps them alive. Null: there is none.
gdcm::SmartPointer<gdcm::SequenceOfItems> items_of(const DataSet& data, const Tag& tag) {
  if (!data.FindDataElement(tag)) return nullptr;
  return data.GetDataElement(tag).GetValueAsSQ();
}

/// The first item of a sequence in the frame's groups, else in those that all frames share.
const DataSet* group_of(const DataSet* frame, const DataSet* shared, const Tag& tag,
                        std::vector<gdcm::SmartPointer<gdcm::SequenceOfItems>>& alive) {
  for (const DataSet* groups : {frame, shared}) {
    if (groups == nullptr) continue;
    auto items = items_of(*groups, tag);
    if (items == nullptr || items->GetNumberOfItems() < 1) continue;
    alive.push_back(items);
    return &items->GetItem(1).GetNestedDataSet();
  }
  return nullptr;
}

struct Place {
  Eigen::Vector3d origin_mm, row, column;
  Eigen::Vector2d spacing_mm;
  double gap_mm = 0.0;  ///< from slice to slice; 0: unsaid
  int segment = 0;
};

struct Segment {
  int number = 0;
  Label label = 0;
  bool own = false;
  std::string name, status;
  SegmentCodes codes;
  std::array<double, 3> colour = {0.5, 0.5, 0.5};
  std::size_t voxels = 0;
};

class Object {
 public:
  explicit Object(const Request& request) : request_(request) {
    reader_.SetFileName(request.path.c_str());
    if (!is_dicom(request.path))
      refuse(request, "", "is named as DICOM, but is none", "Name a DICOM segmentation");
    if (!reader_.Read()) refuse(request, "", "is a DICOM file that cannot be read", kExport);
    check_kind();
    read_sizes();
    read_segments();
    read_places();
  }

  RawVolume volume() {
    RawVolume raw;
    std::vector<int> slice(places_.size());
    raw.grid = grid_of(slice);
    const auto voxels = static_cast<double>(raw.grid.voxel_count());
    raise_limits(static_cast<double>(pixels().GetLength()), voxels);
    raw.voxels.assign(static_cast<std::size_t>(raw.grid.voxel_count()), 0.0F);
    paint(slice, raw.voxels);
    tell(raw.texts);
    raw.source.frame_of_reference_uid = words_of(data(), {0x0020, 0x0052});
    return raw;
  }

 private:
  const DataSet& data() const { return reader_.GetFile().GetDataSet(); }

  [[noreturn]] void refuse_field(const Field& field, const std::string& problem,
                                 const std::string& remedy = kExport) const {
    refuse(request_, field.words(), problem, remedy);
  }

  int number_in(const DataSet& data, const Field& field, int low, int high) const {
    int value = -1;
    const gdcm::ByteValue* bytes =
        data.FindDataElement(field.tag) ? data.GetDataElement(field.tag).GetByteValue() : nullptr;
    if (bytes != nullptr && bytes->GetPointer() != nullptr && bytes->GetLength() == 2) {
      std::uint16_t number = 0;
      std::memcpy(&number, bytes->GetPointer(), sizeof(number));
      value = number;
    }
    if (value < low || value > high)
      refuse_field(field, value < 0 ? std::string("is missing or no number")
                                    : "is " + std::to_string(value) + ", which no segmentation of bits has");
    return value;
  }

  std::vector<double> numbers(const DataSet* data, const Field& field, std::size_t count) const {
    std::string text = data == nullptr ? std::string() : text_of(*data, field.tag);
    if (text.empty())
      refuse_field(field, "is missing in a frame, so that its place in the patient is unknown");
    std::replace(text.begin(), text.end(), '\\', ' ');
    return numbers_in(request_, field.words(), text, count);
  }

  void check_kind() const {
    const std::string kind = text_of(data(), {0x0008, 0x0016});
    const Field field{{0x0008, 0x0016}, "SOPClassUID"};
    if (kind == "1.2.840.10008.5.1.4.1.1.66.7")
      refuse_field(field, "says that it is a label map segmentation, which is not read",
                   "Export it as a binary DICOM segmentation");
    if (kind != "1.2.840.10008.5.1.4.1.1.66.4")
      refuse_field(field, "says that it is no segmentation but another DICOM object",
                   "Name a DICOM segmentation (modality SEG); of a CT open the folder of its slices");
    if (const std::string type = text_of(data(), {kSegments, 0x0001}); type != "BINARY")
      refuse_field({{kSegments, 0x0001}, "SegmentationType"},
                   "is \"" + type.substr(0, 40) + "\", of which the border is not known",
                   "Export it as a binary DICOM segmentation");
    const gdcm::TransferSyntax& syntax = reader_.GetFile().GetHeader().GetDataSetTransferSyntax();
    if (syntax.IsEncapsulated() || syntax.GetSwapCode() == gdcm::SwapCode::BigEndian)
      refuse_field({{0x0002, 0x0010}, "TransferSyntaxUID"}, "says that the bits are compressed or swapped",
                   "Export it without compression (Explicit VR Little Endian)");
  }

  void read_sizes() {
    rows_ = number_in(data(), {{0x0028, 0x0010}, "Rows"}, 1, 65535);
    columns_ = number_in(data(), {{0x0028, 0x0011}, "Columns"}, 1, 65535);
    (void)number_in(data(), {{0x0028, 0x0002}, "SamplesPerPixel"}, 1, 1);
    (void)number_in(data(), {{0x0028, 0x0100}, "BitsAllocated"}, 1, 1);
    const Field field{{0x0028, 0x0008}, "NumberOfFrames"};
    const std::vector<int> frames = sizes_in(request_, field.words(), text_of(data(), field.tag), 1);
    frames_ = static_cast<std::size_t>(frames.front());
    const double bits = static_cast<double>(rows_) * columns_ * static_cast<double>(frames_);
    if (bits > 8.0 * kMostVolumeValues)
      refuse_field(field, "claims more pixels than a segmentation can mean");
    const double needed = std::ceil(bits / 8.0), there = pixels().GetLength();
    const StoredValue value = value_in(read_file(request_.path), static_cast<std::uint32_t>(there));
    if (there < needed || there > needed + 1.0 || value != StoredValue::whole)
      refuse_field({{0x7fe0, 0x0010}, "PixelData"},
                   value == StoredValue::cut ? std::string("ends early: the file was cut")
                   : value == StoredValue::shifted
                       ? std::string("is followed by no element: bytes were put in among them")
                       : "holds " + std::to_string(static_cast<long>(there)) + " bytes where " +
                             std::to_string(static_cast<long>(needed)) +
                             " are expected: the file is damaged");
  }

  const gdcm::ByteValue& pixels() const {
    const Tag tag(0x7fe0, 0x0010);
    const gdcm::ByteValue* bytes =
        data().FindDataElement(tag) ? data().GetDataElement(tag).GetByteValue() : nullptr;
    if (bytes == nullptr || bytes->GetPointer() == nullptr) refuse_field({tag, "PixelData"}, "is missing");
    return *bytes;
  }

  static void read_code(const DataSet& segment, const Tag& tag, Code& code) {
    const auto items = items_of(segment, tag);
    if (items == nullptr || items->GetNumberOfItems() < 1) return;
    const DataSet& item = items->GetItem(1).GetNestedDataSet();
    Code found{words_of(item, {0x0008, 0x0102}), words_of(item, {0x0008, 0x0100}),
               words_of(item, {0x0008, 0x0104})};
    for (std::string* text : {&found.scheme, &found.value, &found.meaning})
      std::ranges::replace_if(
          *text, [](char c) { return c == '~' || c == '^' || c == '|'; }, ' ');
    if (!found.value.empty() && !found.scheme.empty()) code = found;
  }

  void read_segments() {
    const Field field{{kSegments, 0x0002}, "SegmentSequence"};
    const auto items = items_of(data(), field.tag);
    if (items == nullptr || items->GetNumberOfItems() < 1) refuse_field(field, "is missing");
    if (items->GetNumberOfItems() > 65535) refuse_field(field, "holds more segments than it can");
    for (std::size_t n = 1; n <= items->GetNumberOfItems(); ++n) {
      const DataSet& item = items->GetItem(n).GetNestedDataSet();
      Segment segment;
      segment.number = number_in(item, {{kSegments, 0x0004}, "SegmentNumber"}, 1, 65535);
      segment.label = static_cast<Label>(segment.number);
      segment.name = words_of(item, {kSegments, 0x0005});
      read_code(item, {kSegments, 0x0003}, segment.codes.category);
      read_code(item, {kSegments, 0x000f}, segment.codes.type);
      read_code(item, {0x0008, 0x2218}, segment.codes.region);
      read_colour(item, segment);
      read_own(words_of(item, {kSegments, 0x0006}), segment);
      for (const Segment& other : segments_)
        if (other.number == segment.number)
          refuse_field({{kSegments, 0x0004}, "SegmentNumber"},
                       "is " + std::to_string(segment.number) + " twice");
      segments_.push_back(segment);
    }
    own_ = std::ranges::all_of(segments_, &Segment::own);
    std::vector<Label> labels;
    for (const Segment& segment : segments_) labels.push_back(segment.label);
    std::ranges::sort(labels);
    own_ = own_ && std::ranges::adjacent_find(labels) == labels.end();
    if (own_) return;
    for (Segment& segment : segments_) segment.label = static_cast<Label>(segment.number);
  }

  static void read_colour(const DataSet& item, Segment& segment) {
    const Tag tag(kSegments, 0x000d);
    const gdcm::ByteValue* bytes =
        item.FindDataElement(tag) ? item.GetDataElement(tag).GetByteValue() : nullptr;
    std::array<unsigned short, 3> lab = {};
    if (bytes == nullptr || bytes->GetPointer() == nullptr || bytes->GetLength() != sizeof(lab)) return;
    std::memcpy(lab.data(), bytes->GetPointer(), sizeof(lab));
    segment.colour = rgb_of_dicom_lab(lab);
  }

  /// "Glisson label 16, completed".
  static void read_own(const std::string& description, Segment& segment) {
    if (!description.starts_with(kOwnSegment)) return;
    const std::string rest = description.substr(std::string(kOwnSegment).size());
    unsigned label = 0;
    const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), label);
    if (failure != std::errc() || label < 1 || label > 65535) return;
    segment.own = true;
    segment.label = static_cast<Label>(label);
    const std::string after(end, rest.data() + rest.size());
    if (after.starts_with(", ")) segment.status = after.substr(2, 20);
  }

  void read_places() {
    const Field field{{0x5200, 0x9230}, "PerFrameFunctionalGroupsSequence"};
    const auto frames = items_of(data(), field.tag);
    if (frames == nullptr || frames->GetNumberOfItems() != frames_)
      refuse_field(field, "does not hold one item a frame");
    const auto shared_items = items_of(data(), {0x5200, 0x9229});
    const DataSet* shared = shared_items != nullptr && shared_items->GetNumberOfItems() > 0
                                ? &shared_items->GetItem(1).GetNestedDataSet()
                                : nullptr;
    for (std::size_t n = 1; n <= frames_; ++n)
      places_.push_back(place_of(&frames->GetItem(n).GetNestedDataSet(), shared));
  }

  Place place_of(const DataSet* frame, const DataSet* shared) {
    std::vector<gdcm::SmartPointer<gdcm::SequenceOfItems>> alive;
    const DataSet* measures = group_of(frame, shared, {0x0028, 0x9110}, alive);
    const DataSet* plane = group_of(frame, shared, {0x0020, 0x9116}, alive);
    const DataSet* position = group_of(frame, shared, {0x0020, 0x9113}, alive);
    const DataSet* identity = group_of(frame, shared, {kSegments, 0x000a}, alive);
    const auto spacing = numbers(measures, {{0x0028, 0x0030}, "PixelSpacing"}, 2);
    const Field orientation{{0x0020, 0x0037}, "ImageOrientationPatient"};
    const auto axes = numbers(plane, orientation, 6);
    const auto p = numbers(position, {{0x0020, 0x0032}, "ImagePositionPatient"}, 3);
    Place place{{p[0], p[1], p[2]},
                {axes[0], axes[1], axes[2]},
                {axes[3], axes[4], axes[5]},
                {spacing[1], spacing[0]}};
    for (Eigen::Vector3d* axis : {&place.row, &place.column}) {
      if (!(std::abs(axis->stableNorm() - 1.0) < 1e-2))
        refuse_field(orientation, "holds a direction whose length is not 1");
      axis->normalize();
    }
    for (const Field& gap :
         {Field{{0x0018, 0x0088}, "SpacingBetweenSlices"}, Field{{0x0018, 0x0050}, "SliceThickness"}})
      if (place.gap_mm <= 0.0 && !text_of(*measures, gap.tag).empty())
        place.gap_mm = std::abs(numbers(measures, gap, 1).front());
    const Field segment{{kSegments, 0x000b}, "ReferencedSegmentNumber"};
    if (identity == nullptr) refuse_field(segment, "is missing in a frame");
    place.segment = number_in(*identity, segment, 1, 65535);
    if (std::ranges::find(segments_, place.segment, &Segment::number) == segments_.end())
      refuse_field(segment, "is " + std::to_string(place.segment) + ", which is no segment of the file");
    return place;
  }

  /// From the first slice that has a frame to the last. @param[out] slice of each frame.
  VolumeGrid grid_of(std::vector<int>& slice) const {
    const Place& first = places_.front();
    const Eigen::Vector3d normal = first.row.cross(first.column).normalized();
    std::vector<double> along;
    for (const Place& place : places_) {
      if ((place.row - first.row).norm() > 1e-3 || (place.column - first.column).norm() > 1e-3 ||
          (place.spacing_mm - first.spacing_mm).norm() > 1e-4)
        refuse(request_, "frames", "differ in orientation or pixel spacing", kExport);
      along.push_back(place.origin_mm.dot(normal));
    }
    const std::size_t lowest = static_cast<std::size_t>(std::ranges::min_element(along) - along.begin());
    std::vector<double> steps = along;
    std::ranges::sort(steps);
    double gap = 0.0;  // the least between two slices, where no number is said
    for (std::size_t n = 1; n < steps.size(); ++n)
      if (const double step = steps[n] - steps[n - 1]; step > 1e-2 && (gap <= 0.0 || step < gap)) gap = step;
    if (first.gap_mm > 0.0 && (gap <= 0.0 || fits(along, along[lowest], first.gap_mm))) gap = first.gap_mm;
    if (!(gap > 0.0))
      refuse_field({{0x0018, 0x0088}, "SpacingBetweenSlices"}, "is missing in a file of one slice");
    if (!fits(along, along[lowest], gap))
      refuse(request_, "frames", "do not lie at equal steps along their normal",
             "Resample the segmentation to the CT's grid");
    int last = 0;
    double far = 0.0;
    std::set<std::pair<int, int>> taken;  // segments and slices
    for (std::size_t n = 0; n < places_.size(); ++n) {
      const double at = along[n] - along[lowest];
      slice[n] = static_cast<int>(std::lround(at / gap));
      if (slice[n] > last) far = at;
      last = std::max(last, slice[n]);
      const Eigen::Vector3d run = places_[n].origin_mm - places_[lowest].origin_mm;
      if ((run - normal * run.dot(normal)).norm() > 0.5 * first.spacing_mm.minCoeff())
        refuse(request_, "frames", "are shifted against each other across their normal",
               "Resample the segmentation to the CT's grid");
      if (!taken.emplace(places_[n].segment, slice[n]).second)
        refuse(request_, "frames", "of one segment lie twice in one slice", kExport);
    }
    Eigen::Matrix3d direction;
    direction << first.row, first.column, normal;
    return checked_grid(request_, {columns_, rows_, last + 1},
                        {first.spacing_mm.x(), first.spacing_mm.y(), last > 0 ? far / last : gap},
                        places_[lowest].origin_mm, direction);
  }

  static bool fits(const std::vector<double>& along, double from, double gap) {
    const double allowed = gap_tolerance_mm(gap);  // as slices of a CT
    return std::ranges::all_of(along, [&](double at) {
      const double steps = (at - from) / gap;
      return steps < 1e5 && std::abs(steps - std::round(steps)) * gap <= allowed;
    });
  }

  template <class Function>
  void for_bits(std::size_t frame, const Function& function) const {
    const auto* bytes = reinterpret_cast<const unsigned char*>(pixels().GetPointer());
    const std::size_t count = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_);
    for (std::size_t n = 0, bit = frame * count; n < count; ++n, ++bit)
      if (((bytes[bit >> 3U] >> (bit & 7U)) & 1U) != 0) function(n);
  }

  /// The larger segments first, so that of those that overlap the smallest stays.
  void paint(const std::vector<int>& slice, std::vector<float>& voxels) {
    std::map<int, Segment*> by_number;
    for (Segment& segment : segments_) by_number[segment.number] = &segment;
    for (std::size_t frame = 0; frame < frames_; ++frame)
      for_bits(frame, [&, segment = by_number[places_[frame].segment]](std::size_t) { ++segment->voxels; });
    std::vector<std::size_t> order(frames_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater(),
                             [&](std::size_t f) { return by_number[places_[f].segment]->voxels; });
    const std::size_t count = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_);
    for (const std::size_t frame : order) {
      const auto label = static_cast<float>(by_number[places_[frame].segment]->label);
      const std::size_t start = count * static_cast<std::size_t>(slice[frame]);
      for_bits(frame, [&](std::size_t n) { voxels[start + n] = label; });
    }
  }

  void tell(std::map<std::string, std::string>& texts) const {
    if (own_) texts["glisson_own"] = "1";
    for (std::size_t n = 0; n < segments_.size(); ++n) {
      const Segment& segment = segments_[n];
      const std::string key = "Segment" + std::to_string(n) + "_";
      texts[key + "ID"] = "Segment_" + std::to_string(segment.number);
      texts[key + "Name"] = segment.name;
      texts[key + "LabelValue"] = std::to_string(segment.label);
      texts[key + "Color"] = std::to_string(segment.colour[0]) + ' ' + std::to_string(segment.colour[1]) +
                             ' ' + std::to_string(segment.colour[2]);
      texts[key + "Tags"] = "Segmentation.Status:" + segment.status +
                            "|TerminologyEntry:" + terminology_of(segment.codes) + "|";
    }
  }

  const Request& request_;
  gdcm::Reader reader_;
  int rows_ = 0, columns_ = 0;
  std::size_t frames_ = 0;
  std::vector<Segment> segments_;
  std::vector<Place> places_;
  bool own_ = false;
};

}  // namespace

RawVolume read_dicom_segmentation(const Request& request) { return Object(request).volume(); }

}  // namespace glisson::reader
