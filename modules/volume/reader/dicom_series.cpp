// SPDX-License-Identifier: GPL-3.0-or-later
#include <gdcmMediaStorage.h>
#include <gdcmReader.h>
#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "glisson/core/error.h"
#include "itk_buffer.h"
#include "raw_volume.h"

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

struct Slice {
  fs::path path;
  std::string series, modality, description;
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

/// Whether the file is a DICOM image; other DICOM objects (directories, reports) and foreign files are not.
bool is_dicom_image(const Request& request, const fs::path& path) {
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  if (!reader.CanRead() || !reader.ReadUpToTag(gdcm::Tag(0x0020, 0x0037))) {
    if (has_dicom_mark(path))
      refuse(request, path.filename().string(), "is a DICOM file that cannot be read",
             "Export the series again");
    return false;
  }
  gdcm::MediaStorage storage;
  storage.SetFromFile(reader.GetFile());
  return gdcm::MediaStorage::IsImage(storage);
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
  if (io->GetNumberOfComponents() != 1)
    refuse(request, file, "is a colour picture, not a slice of a volume", "Remove it from the folder");
  if (io->GetNumberOfDimensions() > 2 && io->GetDimensions(2) > 1)
    refuse(request, file, "holds several frames in one file", "Convert it to NIfTI or to single slices");
  for (const char* tag : {"0020|0032", "0020|0037", "0028|0030"})
    if (text_of(tags, tag).empty())
      refuse(request, file,
             std::string("has no tag (") + tag + "), so that its place in the patient is unknown",
             "Export the series from the scanner again, not from a viewer");
  Slice slice;
  slice.path = path;
  slice.series = text_of(tags, "0020|000e");
  slice.modality = text_of(tags, "0008|0060");
  slice.description = text_of(tags, "0008|103e");
  slice.size = {static_cast<int>(io->GetDimensions(0)), static_cast<int>(io->GetDimensions(1))};
  slice.spacing_mm = {io->GetSpacing(0), io->GetSpacing(1)};
  for (unsigned i = 0; i < 3; ++i) {
    slice.origin_mm[i] = io->GetOrigin(i);
    slice.row[i] = io->GetDirection(0)[i];
    slice.column[i] = io->GetDirection(1)[i];
  }
  return slice;
}

std::vector<fs::path> files_below(const Request& request) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(request.path))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) refuse(request, "", "is an empty folder", "Name the folder that holds the DICOM slices");
  return files;
}

void check_one_series(const Request& request, const std::vector<Slice>& slices) {
  std::map<std::string, int> count;
  std::map<std::string, std::string> description;
  for (const Slice& slice : slices) {
    ++count[slice.series];
    description[slice.series] = slice.description;
  }
  if (count.size() < 2) return;
  std::ostringstream list;
  int shown = 0;
  for (const auto& [series, n] : count) {
    if (shown == 3) {
      list << ", ...";
      break;
    }
    list << (shown++ > 0 ? ", " : "") << '"' << description[series] << "\" with " << n << " slices";
  }
  refuse(request, "", "holds " + std::to_string(count.size()) + " series: " + list.str(),
         "Put each series into a folder of its own");
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
  std::vector<double> sorted = gaps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double usual = sorted[sorted.size() / 2];
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

void append_slice(const Request& request, const Slice& slice, std::vector<float>& voxels) {
  const auto io = itk::GDCMImageIO::New();
  io->SetFileName(slice.path.string());
  try {
    io->ReadImageInformation();
    const std::vector<float> values = read_buffer(request, *io);
    voxels.insert(voxels.end(), values.begin(), values.end());
  } catch (const itk::ExceptionObject&) {
    refuse(request, slice.path.filename().string(), "has pixels that cannot be decoded",
           "Export the series again, uncompressed");
  }
}

}  // namespace

RawVolume read_dicom_folder(const Request& request) {
  std::vector<Slice> slices;
  const std::vector<fs::path> files = files_below(request);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (is_dicom_image(request, files[i])) slices.push_back(slice_of(request, files[i]));
    request.progress(0.4 * static_cast<double>(i + 1) / static_cast<double>(files.size()));
  }
  if (slices.empty())
    refuse(request, "", "holds no DICOM image", "Name the folder that holds the DICOM slices");
  check_one_series(request, slices);
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
