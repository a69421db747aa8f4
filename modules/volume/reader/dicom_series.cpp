// SPDX-License-Identifier: GPL-3.0-or-later
#include <itkGDCMImageIO.h>
#include <itkMetaDataObject.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "claim.h"
#include "dicom_objects.h"
#include "dicom_pixels.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "slice_gaps.h"

namespace glisson::reader {
namespace {

namespace fs = std::filesystem;

struct Slice {
  fs::path path;
  std::string modality, description;
  std::string study_uid, series_uid, frame_of_reference_uid, class_uid, uid;
  Eigen::Vector2i size;
  Eigen::Vector2d spacing_mm;
  Eigen::Vector3d origin_mm, row, column;
  double along_mm = 0.0;  ///< position on the slices' normal
  PixelRule rule;
};

std::string text_of(const itk::MetaDataDictionary& tags, const char* tag) {
  std::string value;
  itk::ExposeMetaData<std::string>(tags, tag, value);
  while (!value.empty() && (value.back() == ' ' || value.back() == '\0')) value.pop_back();
  return value;
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
  slice.study_uid = text_of(tags, "0020|000d");
  slice.series_uid = text_of(tags, "0020|000e");
  slice.frame_of_reference_uid = text_of(tags, "0020|0052");
  slice.class_uid = text_of(tags, "0008|0016");
  slice.uid = text_of(tags, "0008|0018");
  if (io->GetDimensions(0) > kMostPixels || io->GetDimensions(1) > kMostPixels)
    refuse(request, file, "claims more than 8192 pixels a side, which no scanner's slices have",
           "Export the series again");
  slice.size = {static_cast<int>(io->GetDimensions(0)), static_cast<int>(io->GetDimensions(1))};
  read_place(request, file, tags, slice);
  slice.rule = rule_of(request, file, tags);
  return slice;
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
std::vector<DicomObject> chosen_series(const Request& request, const std::vector<DicomObject>& images) {
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
  std::vector<DicomObject> chosen;
  for (const DicomObject& image : images)
    if (image.series.uid == matching.front()) chosen.push_back(image);
  return chosen;
}

/// @param step from slice to slice. @throws InputError a slice lies half a voxel from its place in the grid:
/// gaps that each are nearly right add up.
void check_places(const Request& request, const std::vector<Slice>& slices, const Eigen::Vector3d& step) {
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const Eigen::Vector3d off =
        slices[i].origin_mm - slices.front().origin_mm - static_cast<double>(i) * step;
    const double along = std::abs(off.dot(step.normalized()));
    const double aside = (off - off.dot(step.normalized()) * step.normalized()).norm();
    if (along <= 0.5 * step.norm() && aside <= 0.5 * slices.front().spacing_mm.minCoeff()) continue;
    std::ostringstream problem;
    problem << "are no regular stack: " << slices[i].path.filename().string() << " lies " << off.norm()
            << " mm from its place";
    refuse(request, "slices", problem.str(), "Export the whole series again, or resample it");
  }
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
    const std::string before = slices[i].path.filename().string();
    const std::string behind = slices[i + 1].path.filename().string();
    if (gaps[i] < 1e-2)
      refuse(request, "slices", "lie at the same place: " + before + ", " + behind,
             "Keep one phase or one copy only");
    if (std::abs(gaps[i] - usual) > gap_tolerance_mm(usual)) {
      std::ostringstream problem;
      problem << "are " << gaps[i] << " mm apart between " << before << " and " << behind << " and " << usual
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
  check_places(request, slices, gap_mm * normal);
}

void check_one_patient(const Request& request, const std::vector<DicomObject>& images) {
  const DicomObject& first = images.front();
  for (const DicomObject& image : images)
    if (image.series.patient != first.series.patient || image.series.patient_id != first.series.patient_id ||
        image.birth_date != first.birth_date)
      refuse(request, image.path.filename().string(),
             "names another patient (0010|0010, 0010|0020, 0010|0030) than " + first.path.filename().string(),
             "Export the series again, of one patient");
}

DicomSource source_of(const DicomObject& of, const std::vector<Slice>& slices) {
  const Slice& first = slices.front();
  DicomSource source{of.series.patient, of.series.patient_id,         of.birth_date,   first.study_uid,
                     first.series_uid,  first.frame_of_reference_uid, first.class_uid, {}};
  for (const Slice& slice : slices) source.slice_uids.push_back(slice.uid);
  return source;
}

}  // namespace

RawVolume read_dicom_folder(const Request& request) {
  const std::vector<DicomObject> images = chosen_series(request, objects_below(request, false));
  check_one_patient(request, images);
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
  raw.source = source_of(images.front(), slices);
  std::vector<fs::path> paths;
  for (const Slice& slice : slices) paths.push_back(slice.path);
  raise_limits(total_bytes(paths), static_cast<double>(raw.grid.voxel_count()));
  raw.voxels.reserve(static_cast<std::size_t>(raw.grid.voxel_count()));
  for (std::size_t i = 0; i < slices.size(); ++i) {
    append_slice(request, slices[i].path, slices[i].size, raw.voxels);
    request.progress(0.4 + 0.6 * static_cast<double>(i + 1) / static_cast<double>(slices.size()));
  }
  if (static_cast<long>(raw.voxels.size()) != raw.grid.voxel_count())
    refuse(request, "slices", "hold fewer pixels than they claim", "Export the series again");
  return raw;
}

}  // namespace glisson::reader
