// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom_objects.h"

#include <gdcmByteValue.h>
#include <gdcmMediaStorage.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/volume/dicom_segmentation.h"

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

/// Numbers parted by backslashes; empty where they are not so many finite ones. Only for people to read and
/// to sort by: what is measured with is read strictly, see dicom_series.cpp.
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

/// Empty: the file is foreign, or a DICOM object of no series (a directory). Other objects than images
/// (reports, contours) say so.
std::optional<DicomObject> find_object(const Request& request, const fs::path& path) {
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
  DicomObject found = described(path, reader.GetFile().GetDataSet());
  const std::string& modality = found.series.modality;
  // A segmentation object's pixels are bits, all its structures in one file.
  found.series.images = gdcm::MediaStorage::IsImage(storage) && modality != "SEG";
  if (!found.series.images && (found.series.uid.empty() || modality.empty())) return std::nullopt;
  return found;
}

/// Neither a file nor a folder: nothing that is read.
bool is_neither(const fs::directory_entry& entry) {
  std::error_code broken;
  return entry.is_symlink(broken) || !entry.is_directory(broken);
}

std::vector<fs::path> files_below(const Request& request) {
  std::vector<fs::path> files, others;
  std::error_code failure;
  fs::recursive_directory_iterator entry(request.path, fs::directory_options::skip_permission_denied,
                                         failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    std::error_code broken;  // a link to nowhere, or round in a circle
    if (entry->is_regular_file(broken))
      files.push_back(entry->path());
    else if (is_neither(*entry))
      others.push_back(entry->path().lexically_relative(request.path));
  }
  if (failure)
    throw FileError(request.name + ": cannot be searched (" + failure.message() +
                    "). Check its permissions, or copy it to a disk of this computer.");
  std::sort(files.begin(), files.end());
  if (files.empty() && !others.empty()) {
    const std::string first = std::min_element(others.begin(), others.end())->string();
    refuse(request, "", "holds no file: " + first + " is a pipe, a socket, a device or a link to no file",
           "Name the folder that holds the DICOM slices");
  }
  if (files.empty()) refuse(request, "", "is an empty folder", "Name the folder that holds the DICOM slices");
  raise_limits(total_bytes(files), 0.0);
  return files;
}

/// One series of its files: the first one's texts, and how far its slices lie apart.
ListedSeries listed(const Request& request, const std::vector<const DicomObject*>& files) {
  ListedSeries result{files.front()->series, {}};
  DicomSeries& series = result.series;
  series.slices = static_cast<int>(files.size());
  const Eigen::Vector3d normal = series.normal;
  std::vector<std::pair<double, const DicomObject*>> places;
  for (const DicomObject* file : files) {
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

}  // namespace

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

// What is no UTF-8 is taken for Latin-1, the standard's commonest other one.
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

DicomObject described(const fs::path& path, const gdcm::DataSet& data) {
  DicomObject found;
  found.path = path;
  DicomSeries& series = found.series;
  series.uid = text_of(data, {0x0020, 0x000e});
  series.number = text_of(data, {0x0020, 0x0011});
  series.description = words_of(data, {0x0008, 0x103e});
  series.modality = text_of(data, {0x0008, 0x0060});
  series.slices = 1;
  series.patient = words_of(data, {0x0010, 0x0010});
  series.patient_id = words_of(data, {0x0010, 0x0020});
  found.birth_date = date_of(words_of(data, {0x0010, 0x0030}));
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

double total_bytes(const std::vector<fs::path>& files) {
  double bytes = 0.0;
  std::error_code failure;
  for (const fs::path& file : files) {
    const std::uintmax_t size = fs::file_size(file, failure);
    if (!failure) bytes += static_cast<double>(size);
  }
  return bytes;
}

std::vector<DicomObject> objects_below(const Request& request, bool all) {
  std::vector<DicomObject> images;
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

std::vector<ListedSeries> series_of(const Request& request, const std::vector<DicomObject>& objects) {
  std::map<std::string, std::vector<const DicomObject*>> all;
  for (const DicomObject& object : objects) all[object.series.uid].push_back(&object);
  std::vector<ListedSeries> list;
  list.reserve(all.size());
  for (const auto& [uid, files] : all) list.push_back(listed(request, files));
  return list;
}

bool is_dicom(const fs::path& path) {
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  return has_dicom_mark(path) || (reader.CanRead() && reader.ReadUpToTag(gdcm::Tag(0x0008, 0x0018)) &&
                                  !reader.GetFile().GetDataSet().IsEmpty());
}

std::vector<ListedSeries> list_dicom_folder(const Request& request) {
  return series_of(request, objects_below(request, true));
}

}  // namespace glisson::reader
