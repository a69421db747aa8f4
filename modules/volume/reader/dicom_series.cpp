// SPDX-License-Identifier: GPL-3.0-or-later
#include <gdcmByteValue.h>
#include <gdcmImageReader.h>
#include <gdcmMediaStorage.h>
#include <gdcmReader.h>
#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "claim.h"
#include "dicom_pixels.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/statistics.h"

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

constexpr int kMostPixels = 8192;  // a side: of no scanner

struct Slice {
  fs::path path;
  std::string modality, description;
  Eigen::Vector2i size;
  Eigen::Vector2d spacing_mm;
  Eigen::Vector3d origin_mm, row, column;
  double along_mm = 0.0;  ///< position on the slices' normal
  PixelRule rule;
};

[[noreturn]] void refuse(const Request& request, const std::string& field, const std::string& problem,
                         const std::string& remedy) {
  throw InputError(request.name, field, problem, remedy);
}

std::string text_of(const itk::MetaDataDictionary& tags, const char* tag) {
  std::string value;
  itk::ExposeMetaData<std::string>(tags, tag, value);
  while (!value.empty() && (value.back() == ' ' || value.back() == '\0')) value.pop_back();
  return value;
}

bool has_dicom_mark(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  char mark[4] = {};
  stream.seekg(128);
  stream.read(mark, 4);
  return stream.gcount() == 4 && std::string(mark, 4) == "DICM";
}

/// A DICOM file and the series that it says it belongs to.
struct Found {
  fs::path path;
  DicomSeries series;
  std::optional<Eigen::Vector3d> origin_mm = {};
};

std::string text_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return "";
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetPointer() == nullptr) return "";
  std::string text(bytes->GetPointer(), bytes->GetLength());
  const auto blank = [](char letter) { return letter == ' ' || letter == '\0'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  while (!text.empty() && blank(text.front())) text.erase(text.begin());
  return text;
}

/// A text for people, in UTF-8: what is none is taken for Latin-1, the standard's commonest other one. Names
/// have carets between their parts.
std::string words_of(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  constexpr std::size_t kLongest = 200;
  const std::string text = text_of(data, tag).substr(0, kLongest);
  std::string utf8;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto byte = static_cast<unsigned char>(text[at]);
    const int follow = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : byte >= 0xC2 ? 1 : 0;
    bool whole = byte < 0xF5 && follow > 0 && at + static_cast<std::size_t>(follow) < text.size();
    for (int n = 1; whole && n <= follow; ++n)
      whole = (static_cast<unsigned char>(text[at + static_cast<std::size_t>(n)]) & 0xC0U) == 0x80U;
    if (byte < 0x20) {
      utf8.push_back(' ');
    } else if (byte < 0x80) {
      utf8.push_back(byte == '^' ? ' ' : text[at]);
    } else if (whole) {
      utf8 += text.substr(at, static_cast<std::size_t>(follow) + 1);
      at += static_cast<std::size_t>(follow);
    } else {
      utf8.push_back(static_cast<char>(0xC0U | byte >> 6U));
      utf8.push_back(static_cast<char>(0x80U | (byte & 0x3FU)));
    }
  }
  while (!utf8.empty() && utf8.back() == ' ') utf8.pop_back();
  return utf8;
}

/// Numbers parted by backslashes; empty where they are not so many finite ones. Only for people to read and
/// to sort by: what is measured with is read strictly, see read_place().
std::vector<double> loose_numbers(const gdcm::DataSet& data, const gdcm::Tag& tag, std::size_t count) {
  std::istringstream text(text_of(data, tag));
  std::vector<double> numbers;
  for (std::string part; std::getline(text, part, '\\');) {
    char* end = nullptr;
    const double number = std::strtod(part.c_str(), &end);
    if (end == part.c_str() || !std::isfinite(number) || std::abs(number) > 1e6) return {};
    numbers.push_back(number);
  }
  return numbers.size() == count ? numbers : std::vector<double>();
}

/// A whole number in two bytes; 0: there is none.
int short_in(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return 0;
  const gdcm::ByteValue* bytes = data.GetDataElement(tag).GetByteValue();
  if (bytes == nullptr || bytes->GetPointer() == nullptr || bytes->GetLength() < 2) return 0;
  std::uint16_t value = 0;
  std::memcpy(&value, bytes->GetPointer(), sizeof(value));
  return value;
}

/// "20260131" -> "2026-01-31"; others as they are.
std::string date_of(const std::string& text) {
  const bool digits = text.size() == 8 && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? text.substr(0, 4) + '-' + text.substr(4, 2) + '-' + text.substr(6) : text;
}

/// What one file says of its series.
Found described(const fs::path& path, const gdcm::DataSet& data) {
  Found found;
  found.path = path;
  DicomSeries& series = found.series;
  series.uid = text_of(data, {0x0020, 0x000e});
  series.number = text_of(data, {0x0020, 0x0011});
  series.description = words_of(data, {0x0008, 0x103e});
  series.modality = text_of(data, {0x0008, 0x0060});
  series.slices = 1;
  series.patient = words_of(data, {0x0010, 0x0010});
  series.patient_id = words_of(data, {0x0010, 0x0020});
  series.date = date_of(words_of(data, {0x0008, 0x0021}));
  if (series.date.empty()) series.date = date_of(words_of(data, {0x0008, 0x0020}));
  series.study = words_of(data, {0x0008, 0x1030});
  series.protocol = words_of(data, {0x0018, 0x1030});
  series.kind = words_of(data, {0x0008, 0x0008});
  series.contrast_agent = !text_of(data, {0x0018, 0x0010}).empty();
  series.pixels = {short_in(data, {0x0028, 0x0011}), short_in(data, {0x0028, 0x0010})};
  if (const auto mm = loose_numbers(data, {0x0028, 0x0030}, 2); !mm.empty()) series.pixel_mm = {mm[1], mm[0]};
  if (const auto mm = loose_numbers(data, {0x0018, 0x0050}, 1); !mm.empty()) series.thickness_mm = mm[0];
  if (const auto count = loose_numbers(data, {0x0028, 0x0008}, 1); !count.empty())
    series.frames = static_cast<int>(std::clamp(count[0], 1.0, 1e6));
  if (const auto axes = loose_numbers(data, {0x0020, 0x0037}, 6); !axes.empty())
    series.normal = Eigen::Vector3d(axes[0], axes[1], axes[2])
                        .cross(Eigen::Vector3d(axes[3], axes[4], axes[5]))
                        .normalized();
  if (const auto p = loose_numbers(data, {0x0020, 0x0032}, 3); !p.empty())
    found.origin_mm = Eigen::Vector3d(p[0], p[1], p[2]);
  return found;
}

/// Empty: the file is foreign, or a DICOM object of no series (a directory). Other objects than images
/// (reports, contours) say so.
std::optional<Found> find_object(const Request& request, const fs::path& path) {
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  if (!reader.CanRead() || !reader.ReadUpToTag(gdcm::Tag(0x0028, 0x0100))) {
    if (has_dicom_mark(path))
      refuse(request, path.filename().string(), "is a DICOM file that cannot be read",
             "Export the series again");
    return std::nullopt;
  }
  gdcm::MediaStorage storage;
  storage.SetFromFile(reader.GetFile());
  Found found = described(path, reader.GetFile().GetDataSet());
  const std::string& modality = found.series.modality;
  // A segmentation object's pixels are bits, all its structures in one file.
  found.series.images = gdcm::MediaStorage::IsImage(storage) && modality != "SEG";
  if (!found.series.images && (found.series.uid.empty() || modality.empty())) return std::nullopt;
  return found;
}

/// The numbers of a tag, by ourselves: ITK takes 1 mm where it can make nothing of them.
std::vector<double> numbers_of(const Request& request, const std::string& file,
                               const itk::MetaDataDictionary& tags, const char* tag, const char* name,
                               std::size_t count) {
  std::string text = text_of(tags, tag);
  const std::string field = std::string(name) + " (" + tag + ")";
  if (text.empty())
    refuse(request, file,
           std::string("has no tag (") + tag + "), so that its place in the patient is unknown",
           "Export the series from the scanner again, not from a viewer");
  std::replace(text.begin(), text.end(), '\\', ' ');
  try {
    return numbers_in(request, field, text, count);
  } catch (const InputError& error) {
    refuse(request, file + ", " + field, error.problem(), "Export the series again");
  }
}

void read_place(const Request& request, const std::string& file, const itk::MetaDataDictionary& tags,
                Slice& slice) {
  const auto origin = numbers_of(request, file, tags, "0020|0032", "ImagePositionPatient", 3),
             axes = numbers_of(request, file, tags, "0020|0037", "ImageOrientationPatient", 6),
             spacing = numbers_of(request, file, tags, "0028|0030", "PixelSpacing", 2);
  slice.origin_mm = {origin[0], origin[1], origin[2]};
  slice.row = {axes[0], axes[1], axes[2]};
  slice.column = {axes[3], axes[4], axes[5]};
  slice.spacing_mm = {spacing[1], spacing[0]};  // the first is from row to row
  for (const Eigen::Vector3d* axis : {&slice.row, &slice.column})
    if (!(std::abs(axis->stableNorm() - 1.0) < 1e-2))
      refuse(request, file + ", ImageOrientationPatient (0020|0037)",
             "holds a direction whose length is not 1", "Export the series again");
  slice.row.normalize();
  slice.column.normalize();
  if (!(slice.spacing_mm.array() > 0.0).all())
    refuse(request, file + ", PixelSpacing (0028|0030)",
           "is " + text_of(tags, "0028|0030") + " mm, which is no pixel's", "Export the series again");
}

/// What pixels are multiplied with and what is added must be numbers that keep them apart.
PixelRule rule_of(const Request& request, const std::string& file, const itk::MetaDataDictionary& tags) {
  // Below it all of 16 bits fall on one whole number.
  constexpr double kLeastSlope = 1.0 / 65536.0;
  PixelRule rule;
  for (const char* tag : {"0028|1052", "0028|1053"}) {
    const bool slope = tag[8] == '3';
    const char* name = slope ? "RescaleSlope" : "RescaleIntercept";
    if (text_of(tags, tag).empty()) continue;
    const double value = numbers_of(request, file, tags, tag, name, 1).front();
    if (std::abs(value) > 1e6 || (slope && !(value > kLeastSlope)))
      refuse(request, file + ", " + name + " (" + tag + ")",
             "is " + text_of(tags, tag) + ", which makes no intensities of the pixels",
             "Export the series again");
    (slope ? rule.slope : rule.intercept) = value;
  }
  rule.bits = {text_of(tags, "0028|0100"), text_of(tags, "0028|0101"), text_of(tags, "0028|0102"),
               text_of(tags, "0028|0103")};
  return rule;
}

Slice slice_of(const Request& request, const fs::path& path) {
  const auto io = itk::GDCMImageIO::New();
  const std::string file = path.filename().string();
  io->SetFileName(path.string());
  try {
    io->ReadImageInformation();
  } catch (const itk::ExceptionObject&) {
    refuse(request, file, "is a DICOM image that cannot be read", "Export the series again");
  }
  const itk::MetaDataDictionary& tags = io->GetMetaDataDictionary();
  const std::string samples = text_of(tags, "0028|0002"), meaning = text_of(tags, "0028|0004");
  if (io->GetNumberOfComponents() != 1 || (!samples.empty() && samples != "1") ||
      (!meaning.empty() && !meaning.starts_with("MONOCHROME")))
    refuse(request, file, "is a colour picture, not a slice of a volume", "Remove it from the folder");
  if (io->GetNumberOfDimensions() > 2 && io->GetDimensions(2) > 1)
    refuse(request, file, "holds several frames in one file", "Convert it to NIfTI or to single slices");
  Slice slice;
  slice.path = path;
  slice.modality = text_of(tags, "0008|0060");
  slice.description = text_of(tags, "0008|103e");
  if (io->GetDimensions(0) > kMostPixels || io->GetDimensions(1) > kMostPixels)
    refuse(request, file, "claims more than 8192 pixels a side, which no scanner's slices have",
           "Export the series again");
  slice.size = {static_cast<int>(io->GetDimensions(0)), static_cast<int>(io->GetDimensions(1))};
  read_place(request, file, tags, slice);
  slice.rule = rule_of(request, file, tags);
  return slice;
}

double total_bytes(const std::vector<fs::path>& files) {
  double bytes = 0.0;
  std::error_code failure;
  for (const fs::path& file : files) {
    const std::uintmax_t size = fs::file_size(file, failure);
    if (!failure) bytes += static_cast<double>(size);
  }
  return bytes;
}

std::vector<fs::path> files_below(const Request& request) {
  std::vector<fs::path> files;
  std::error_code failure;
  fs::recursive_directory_iterator entry(request.path, fs::directory_options::skip_permission_denied,
                                         failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    std::error_code broken;  // a link to nowhere, or round in a circle
    if (entry->is_regular_file(broken)) files.push_back(entry->path());
  }
  if (failure)
    throw FileError(request.name + ": cannot be searched (" + failure.message() +
                    "). Check its permissions, or copy it to a disk of this computer.");
  std::sort(files.begin(), files.end());
  if (files.empty()) refuse(request, "", "is an empty folder", "Name the folder that holds the DICOM slices");
  raise_limits(total_bytes(files), 0.0);
  return files;
}

/// @param all other objects than images, too.
std::vector<Found> objects_below(const Request& request, bool all) {
  std::vector<Found> images;
  bool any = false;
  const std::vector<fs::path> files = files_below(request);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (auto object = find_object(request, files[i]); object && (all || object->series.images)) {
      any = any || object->series.images;
      images.push_back(std::move(*object));
    }
    request.progress(0.2 * static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  if (!any) refuse(request, "", "holds no DICOM image", "Name the folder that holds the DICOM slices");
  return images;
}

/// One series of its files: the first one's texts, and how far its slices lie apart.
ListedSeries listed(const Request& request, const std::vector<const Found*>& files) {
  ListedSeries result{files.front()->series, {}};
  DicomSeries& series = result.series;
  series.slices = static_cast<int>(files.size());
  const Eigen::Vector3d normal = series.normal;
  std::vector<std::pair<double, const Found*>> places;
  for (const Found* file : files) {
    series.frames = std::max(series.frames, file->series.frames);
    series.images = series.images && file->series.images;
    if ((file->series.normal - normal).norm() > 1e-2) series.normal.setZero();
    places.emplace_back(file->origin_mm ? file->origin_mm->dot(normal) : 0.0, file);
  }
  std::ranges::stable_sort(places, {}, [](const auto& place) { return place.first; });
  std::vector<double> gaps;
  for (std::size_t n = 1; n < places.size(); ++n) gaps.push_back(places[n].first - places[n - 1].first);
  if (!gaps.empty() && series.normal.norm() > 0.5) series.gap_mm = upper_median(gaps);
  if (series.images) result.middle = places[places.size() / 2].second->path.lexically_relative(request.path);
  return result;
}

/// By UID, each once.
std::vector<ListedSeries> series_of(const Request& request, const std::vector<Found>& objects) {
  std::map<std::string, std::vector<const Found*>> all;
  for (const Found& object : objects) all[object.series.uid].push_back(&object);
  std::vector<ListedSeries> list;
  for (const auto& [uid, files] : all) list.push_back(listed(request, files));
  return list;
}

std::string list_of(std::vector<DicomSeries> all) {
  sort_by_likelihood(all);
  std::ostringstream list;
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (n == 4) return list.str() + ", ...";
    list << (n > 0 ? ", " : "") << '"' << all[n].description << "\" with " << all[n].slices
         << " slices (number " << (all[n].number.empty() ? "unknown" : all[n].number) << ", UID "
         << all[n].uid << ')';
  }
  return list.str();
}

/// The slices of the series that is wanted, or of the only one.
std::vector<Found> chosen_series(const Request& request, const std::vector<Found>& images) {
  std::vector<DicomSeries> all;
  for (ListedSeries& each : series_of(request, images)) all.push_back(std::move(each.series));
  if (request.series.empty()) {
    if (all.size() > 1)
      refuse(request, "", "holds " + std::to_string(all.size()) + " series: " + list_of(all),
             "Choose one by its number or UID, or put each into a folder of its own");
    return images;
  }
  std::vector<std::string> matching;
  for (const DicomSeries& series : all) {
    if (series.uid == request.series) matching.assign(1, series.uid);
    if (series.uid == request.series) break;
    if (series.number == request.series) matching.push_back(series.uid);
  }
  if (matching.size() != 1)
    refuse(request, "series",
           (matching.empty() ? "holds no series " : "holds several series ") + request.series + ", but " +
               list_of(all),
           "Choose one of these by its UID");
  std::vector<Found> chosen;
  for (const Found& image : images)
    if (image.series.uid == matching.front()) chosen.push_back(image);
  return chosen;
}

/// Sorts along the normal; refuses slices that do not form one regular stack.
void order_and_check(const Request& request, std::vector<Slice>& slices, double& gap_mm) {
  const Slice& first = slices.front();
  for (const Slice& slice : slices) {
    if (slice.size != first.size)
      refuse(request, slice.path.filename().string(), "has another size than the other slices",
             "Remove it from the folder");
    if ((slice.row - first.row).norm() > 1e-3 || (slice.column - first.column).norm() > 1e-3 ||
        (slice.spacing_mm - first.spacing_mm).norm() > 1e-4)
      refuse(request, slice.path.filename().string(),
             "has another orientation or pixel spacing than the other slices",
             "Remove it from the folder (is it a scout view?)");
    check_same_rule(request, first.modality, first.path.filename().string(), first.rule,
                    slice.path.filename().string(), slice.rule);
  }
  const Eigen::Vector3d normal = first.row.cross(first.column).normalized();
  for (Slice& slice : slices) slice.along_mm = slice.origin_mm.dot(normal);
  std::stable_sort(slices.begin(), slices.end(),
                   [](const Slice& a, const Slice& b) { return a.along_mm < b.along_mm; });
  std::vector<double> gaps;
  for (std::size_t i = 1; i < slices.size(); ++i) gaps.push_back(slices[i].along_mm - slices[i - 1].along_mm);
  const double usual = upper_median(gaps);
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    std::ostringstream where;
    where << "between " << slices[i].path.filename().string() << " and "
          << slices[i + 1].path.filename().string();
    if (gaps[i] < 1e-2)
      refuse(request, "slices", "lie at the same place: " + where.str(), "Keep one phase or one copy only");
    // Positions are often rounded to a tenth of a millimetre.
    if (std::abs(gaps[i] - usual) > std::max(0.05 * usual, 0.06)) {
      std::ostringstream problem;
      problem << "are " << gaps[i] << " mm apart " << where.str() << " and " << usual
              << " mm elsewhere: a slice is missing or the spacing changes";
      refuse(request, "slices", problem.str(), "Export the whole series again, or resample it");
    }
  }
  const Eigen::Vector3d run = slices.back().origin_mm - slices.front().origin_mm;
  const double drift = (run - normal * run.dot(normal)).norm();
  if (drift > 0.5 * first.spacing_mm.minCoeff()) {
    std::ostringstream problem;
    problem << "are shifted against each other by " << drift
            << " mm from the first to the last (gantry tilt of "
            << std::atan2(drift, run.dot(normal)) * 180.0 / M_PI << " degrees)";
    refuse(request, "slices", problem.str(), "Resample the series to a rectangular grid");
  }
  gap_mm = run.dot(normal) / static_cast<double>(gaps.size());
}

template <class T>
void append_rescaled(const std::vector<char>& bytes, const gdcm::Image& image, std::vector<float>& voxels) {
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(T)) {
    T stored{};
    std::memcpy(&stored, bytes.data() + at, sizeof(T));
    voxels.push_back(
        static_cast<float>(image.GetSlope() * static_cast<double>(stored) + image.GetIntercept()));
  }
}

/// By GDCM and not by ITK, which turns the numbers of MONOCHROME1 round: that says how to draw them only.
void append_slice(const Request& request, const Slice& slice, std::vector<float>& voxels) {
  const auto refuse_pixels = [&] {
    refuse(request, slice.path.filename().string(), "has pixels that cannot be decoded",
           "Export the series again, uncompressed");
  };
  gdcm::ImageReader reader;
  reader.SetFileName(slice.path.c_str());
  if (!reader.Read()) refuse_pixels();
  if (reader.GetFile().GetDataSet().FindDataElement(gdcm::Tag(0x0028, 0x3000)))
    refuse(request, slice.path.filename().string(),
           "gives its intensities by a table (Modality LUT), which is not read",
           "Export the series with RescaleSlope and RescaleIntercept");
  const gdcm::Image& image = reader.GetImage();
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  const auto pixels = static_cast<std::size_t>(slice.size.x()) * static_cast<std::size_t>(slice.size.y());
  std::vector<char> bytes(image.GetBufferLength());
  check_pixel_bytes(request, slice.path, image, bytes.size());
  if (format.GetSamplesPerPixel() != 1 || bytes.size() != pixels * format.GetPixelSize() ||
      !image.GetBuffer(bytes.data()))
    refuse_pixels();
  switch (format.GetScalarType()) {
    case gdcm::PixelFormat::UINT8:
      return append_rescaled<std::uint8_t>(bytes, image, voxels);
    case gdcm::PixelFormat::INT8:
      return append_rescaled<std::int8_t>(bytes, image, voxels);
    case gdcm::PixelFormat::UINT16:
      return append_rescaled<std::uint16_t>(bytes, image, voxels);
    case gdcm::PixelFormat::INT16:
      return append_rescaled<std::int16_t>(bytes, image, voxels);
    case gdcm::PixelFormat::UINT32:
      return append_rescaled<std::uint32_t>(bytes, image, voxels);
    case gdcm::PixelFormat::INT32:
      return append_rescaled<std::int32_t>(bytes, image, voxels);
    default:
      refuse(request, slice.path.filename().string(), "has pixels in a number format that is not known",
             "Export the series again as 16-bit integers");
  }
}

/// At most 128 pixels a side, each the mean of those that it stands for. A CT in a window for soft tissue,
/// others from their second to their last but second percent.
SeriesPicture reduced(const std::vector<float>& values, const DicomSeries& series) {
  constexpr int kSide = 128;
  constexpr std::size_t kMostValues = 256;
  constexpr float kLow = -160.0F, kHigh = 240.0F;  // HU
  const int width = series.pixels.x(), height = series.pixels.y();
  SeriesPicture picture;
  std::vector<float> sorted = values;
  std::ranges::sort(sorted);
  for (std::size_t n = 0; n < sorted.size() && picture.values < static_cast<int>(kMostValues); ++n)
    if (n == 0 || sorted[n] != sorted[n - 1]) ++picture.values;
  const bool hounsfield = series.modality == "CT" && picture.values > 2;
  const std::size_t rim = sorted.size() / 50;
  const float low = hounsfield ? kLow : sorted[picture.values > 2 ? rim : 0];
  const float high = hounsfield ? kHigh : sorted[sorted.size() - 1 - (picture.values > 2 ? rim : 0)];
  const int step = (std::max(width, height) + kSide - 1) / kSide;
  picture.width = (width + step - 1) / step;
  picture.height = (height + step - 1) / step;
  if (series.pixel_mm.minCoeff() > 0.0)
    picture.pixel_aspect = std::clamp(series.pixel_mm.y() / series.pixel_mm.x(), 0.1, 10.0);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      double sum = 0.0;
      int count = 0;
      for (int j = y * step; j < std::min(height, (y + 1) * step); ++j)
        for (int i = x * step; i < std::min(width, (x + 1) * step); ++i, ++count)
          sum += static_cast<double>(values[static_cast<std::size_t>(i) +
                                            static_cast<std::size_t>(width) * static_cast<std::size_t>(j)]);
      const double share =
          high > low ? (sum / count - static_cast<double>(low)) / static_cast<double>(high - low) : 0.0;
      picture.grey.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0))));
    }
  return picture;
}

}  // namespace

bool is_dicom(const fs::path& path) {
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  return has_dicom_mark(path) || (reader.CanRead() && reader.ReadUpToTag(gdcm::Tag(0x0008, 0x0018)) &&
                                  !reader.GetFile().GetDataSet().IsEmpty());
}

std::vector<ListedSeries> list_dicom_folder(const Request& request) {
  return series_of(request, objects_below(request, true));
}

SeriesPicture dicom_picture(const Request& request) {
  gdcm::Reader header;
  header.SetFileName(request.path.c_str());
  if (!header.CanRead() || !header.ReadUpToTag(gdcm::Tag(0x0028, 0x0100)))
    refuse(request, request.path.filename().string(), "is a DICOM file that cannot be read",
           "Export the series again");
  const gdcm::DataSet& data = header.GetFile().GetDataSet();
  const DicomSeries series = described(request.path, data).series;
  if (series.pixels.minCoeff() < 1 || series.pixels.maxCoeff() > kMostPixels || series.frames > 1)
    refuse(request, request.path.filename().string(), "holds no slice", "Choose another series");
  Slice slice;
  slice.path = request.path;
  slice.size = series.pixels;
  raise_limits(total_bytes({request.path}), static_cast<double>(slice.size.x()) * slice.size.y());
  std::vector<float> values;
  append_slice(request, slice, values);
  SeriesPicture picture = reduced(values, series);
  if (text_of(data, {0x0028, 0x0004}) == "MONOCHROME1" && series.modality != "CT")
    for (std::uint8_t& grey : picture.grey) grey = static_cast<std::uint8_t>(255 - grey);
  return picture;
}

RawVolume read_dicom_folder(const Request& request) {
  const std::vector<Found> images = chosen_series(request, objects_below(request, false));
  std::vector<Slice> slices;
  for (std::size_t i = 0; i < images.size(); ++i) {
    slices.push_back(slice_of(request, images[i].path));
    request.progress(0.2 + 0.2 * static_cast<double>(i + 1) / static_cast<double>(images.size()));
  }
  if (slices.size() < 2)
    refuse(request, "", "holds a single slice, not a volume", "Name a folder with the whole series");
  double gap_mm = 0.0;
  order_and_check(request, slices, gap_mm);

  const Slice& first = slices.front();
  RawVolume raw;
  Eigen::Matrix3d direction;
  direction << first.row, first.column, first.row.cross(first.column).normalized();
  const Eigen::Vector3i size(first.size.x(), first.size.y(), static_cast<int>(slices.size()));
  raw.grid = checked_grid(request, size, {first.spacing_mm.x(), first.spacing_mm.y(), gap_mm},
                          first.origin_mm, direction);
  raw.modality = first.modality == "CT" ? "ct" : first.modality == "MR" ? "mr" : "other";
  raw.description = first.description;
  std::vector<fs::path> paths;
  for (const Slice& slice : slices) paths.push_back(slice.path);
  raise_limits(total_bytes(paths), static_cast<double>(raw.grid.voxel_count()));
  raw.voxels.reserve(static_cast<std::size_t>(raw.grid.voxel_count()));
  for (std::size_t i = 0; i < slices.size(); ++i) {
    append_slice(request, slices[i], raw.voxels);
    request.progress(0.4 + 0.6 * static_cast<double>(i + 1) / static_cast<double>(slices.size()));
  }
  if (static_cast<long>(raw.voxels.size()) != raw.grid.voxel_count())
    refuse(request, "slices", "hold fewer pixels than they claim", "Export the series again");
  return raw;
}

}  // namespace glisson::reader
