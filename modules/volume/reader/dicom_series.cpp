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

/// A DICOM image file and the series that it says it belongs to.
struct Found {
  fs::path path;
  DicomSeries series;
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

/// Empty: the file is no DICOM image; other DICOM objects (directories, reports) and foreign files are not.
std::optional<Found> find_image(const Request& request, const fs::path& path) {
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  if (!reader.CanRead() || !reader.ReadUpToTag(gdcm::Tag(0x0020, 0x0037))) {
    if (has_dicom_mark(path))
      refuse(request, path.filename().string(), "is a DICOM file that cannot be read",
             "Export the series again");
    return std::nullopt;
  }
  gdcm::MediaStorage storage;
  storage.SetFromFile(reader.GetFile());
  if (!gdcm::MediaStorage::IsImage(storage)) return std::nullopt;
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  return Found{path,
               {text_of(data, {0x0020, 0x000e}), text_of(data, {0x0020, 0x0011}),
                text_of(data, {0x0008, 0x103e}), text_of(data, {0x0008, 0x0060}), 1}};
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
void check_rescale(const Request& request, const std::string& file, const itk::MetaDataDictionary& tags) {
  for (const char* tag : {"0028|1052", "0028|1053"}) {
    const bool slope = tag[8] == '3';
    const char* name = slope ? "RescaleSlope" : "RescaleIntercept";
    if (text_of(tags, tag).empty()) continue;
    const double value = numbers_of(request, file, tags, tag, name, 1).front();
    if (std::abs(value) > 1e6 || (slope && !(value > 0.0)))
      refuse(request, file + ", " + name + " (" + tag + ")",
             "is " + text_of(tags, tag) + ", which makes no intensities of the pixels",
             "Export the series again");
  }
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
  check_rescale(request, file, tags);
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

std::vector<Found> images_below(const Request& request) {
  std::vector<Found> images;
  const std::vector<fs::path> files = files_below(request);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (auto image = find_image(request, files[i])) images.push_back(std::move(*image));
    request.progress(0.2 * static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  if (images.empty())
    refuse(request, "", "holds no DICOM image", "Name the folder that holds the DICOM slices");
  return images;
}

/// By UID, each once.
std::vector<DicomSeries> series_of(const std::vector<Found>& images) {
  std::map<std::string, DicomSeries> all;
  for (const Found& image : images) {
    const auto [place, fresh] = all.try_emplace(image.series.uid, image.series);
    if (!fresh) ++place->second.slices;
  }
  std::vector<DicomSeries> list;
  for (const auto& [uid, series] : all) list.push_back(series);
  return list;
}

std::string list_of(const std::vector<DicomSeries>& all) {
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
  const std::vector<DicomSeries> all = series_of(images);
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

/// Whether a file with compressed pixels ends as it should: GDCM takes what there is of one that was cut.
/// Such pixels are a list of fragments in explicit little endian, closed by a mark of its own.
bool fragments_are_closed(const fs::path& path) {
  static const std::string kStart("\xE0\x7F\x10\x00OB\x00\x00\xFF\xFF\xFF\xFF", 12);
  static const std::string kEnd("\xFE\xFF\xDD\xE0\x00\x00\x00\x00", 8);
  const std::string bytes = read_file(path);
  const std::size_t start = bytes.rfind(kStart);
  return start != std::string::npos && bytes.find(kEnd, start) != std::string::npos;
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
  // GDCM fills up what an uncompressed slice lacks.
  const gdcm::ByteValue* plain = image.GetDataElement().GetByteValue();
  if (plain != nullptr ? plain->GetLength() < bytes.size() : !fragments_are_closed(slice.path))
    refuse_pixels();
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

}  // namespace

bool is_dicom(const fs::path& path) {
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  return has_dicom_mark(path) || (reader.CanRead() && reader.ReadUpToTag(gdcm::Tag(0x0008, 0x0018)) &&
                                  !reader.GetFile().GetDataSet().IsEmpty());
}

std::vector<DicomSeries> list_dicom_folder(const Request& request) {
  return series_of(images_below(request));
}

RawVolume read_dicom_folder(const Request& request) {
  const std::vector<Found> images = chosen_series(request, images_below(request));
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
