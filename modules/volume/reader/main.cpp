// SPDX-License-Identifier: GPL-3.0-or-later
//
// glisson-read-volume MODE INPUT FOLDER NAME [SERIES]
//
// Reads INPUT (MODE: image or labels) and leaves FOLDER/header.json and FOLDER/voxels.raw, or only lists the
// series of a DICOM folder (MODE: series) in FOLDER/series.json, or unpacks an archive into FOLDER/archive
// (MODE: unpack), or tells in FOLDER/files.json which files a DICOMDIR names (MODE: dicomdir), or makes a
// small picture of one DICOM file in FOLDER/picture.json (MODE: picture); with exit code 3 it leaves
// FOLDER/refusal.json. MODE escapes leaves in FOLDER/escapes.json what it could do that it must not. NAME is
// what messages call the input, SERIES chooses one of several. Progress goes to standard output, one fraction
// a line. A program of its own because the parsers abort on some malformed files; it gives up all but reading
// INPUT and writing FOLDER before it parses.

#include <sys/statvfs.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "archive.h"
#include "dicomdir.h"
#include "glisson/core/confinement.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/volume/dicom_segmentation.h"
#include "raw_volume.h"

namespace {

using namespace glisson;
using reader::RawVolume;
using reader::Request;
namespace fs = std::filesystem;

constexpr int kRefused = 3;

bool is_file(const fs::path& path) {
  std::error_code failure;
  return fs::is_regular_file(path, failure);
}

double bytes_of(const fs::path& path) {
  std::error_code failure;
  const std::uintmax_t bytes = is_file(path) ? fs::file_size(path, failure) : 0;
  return failure ? 0.0 : static_cast<double>(bytes);
}

/// A damaged header may ask for all memory or loop for ever: then this process dies, and only it. Raised when
/// the size of the volume is known, see raise_limits().
void limit_resources(const Request& request) {
  die_with_parent();
  reader::raise_limits(bytes_of(request.path), 0.0);
  limit_written_file(5e9);
}

/// A folder's own links may lead to where its slices are kept.
void confine_to(const Request& request, const fs::path& folder) {
  std::vector<fs::path> readable = {request.path};
  std::error_code failure;
  const std::string extension = lower_extension(request.path);
  if (extension == ".nhdr" || extension == ".mhd")  // their voxels lie beside them
    readable.push_back(fs::absolute(request.path, failure).parent_path());
  fs::recursive_directory_iterator entry(request.path, fs::directory_options::skip_permission_denied,
                                         failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    std::error_code broken;
    if (!entry->is_symlink(broken)) continue;
    const fs::path target = fs::canonical(entry->path(), broken);
    if (!broken && is_file(target)) readable.push_back(target);
  }
  confine(readable, {folder});
}

RawVolume read_any(const Request& request) {
  if (fs::is_directory(request.path)) return reader::read_dicom_folder(request);
  if (!is_file(request.path))
    throw InputError(request.name, "", "is neither a file nor a folder", "Name a volume");
  if (!request.series.empty())
    throw InputError(request.name, "series", "cannot be chosen in a file that holds one volume",
                     "Leave the series out, or name the folder that holds the DICOM slices");
  const std::string extension = lower_extension(request.path);
  if (request.labels && (has_dicom_mark(request.path) || extension == ".dcm"))
    return reader::read_dicom_segmentation(request);
  if (extension == ".vti") return reader::read_vti_file(request);
  if (extension == ".dcm" || extension == ".ima") {
    if (!reader::is_dicom(request.path))
      throw InputError(request.name, "", "is named as DICOM, but is none",
                       "Name the folder that holds the series");
    throw InputError(request.name, "", "is a single DICOM slice", "Name the folder that holds the series");
  }
  return reader::read_itk_file(request);
}

/// Rounds to whole numbers in [low, high]. @throws InputError outside, or not a number.
template <class Integer>
std::vector<Integer> whole_numbers(const Request& request, const std::vector<float>& voxels, float low,
                                   float high, const char* meaning, bool clamp) {
  std::vector<Integer> values(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const float value = std::round(voxels[i]);
    if (!std::isfinite(value))
      throw InputError(request.name, "voxels", "hold a value that is not a number",
                       "Export the volume again");
    if (!clamp && (value < low || value > high || value != voxels[i]))
      throw InputError(request.name, "voxels",
                       "hold " + std::to_string(voxels[i]) + ", which is no " + meaning,
                       "Check that this is the right file");
    values[i] = static_cast<Integer>(std::clamp(value, low, high));
  }
  return values;
}

std::vector<std::int16_t> image_values(const Request& request, const RawVolume& raw) {
  const auto [low, high] = std::minmax_element(raw.voxels.begin(), raw.voxels.end());
  const bool fractions =
      std::any_of(raw.voxels.begin(), raw.voxels.end(), [](float v) { return v != std::round(v); });
  if (fractions && *high - *low < 64.0F)
    throw InputError(request.name, "voxels",
                     "run from " + std::to_string(*low) + " to " + std::to_string(*high) +
                         " only: too few grey levels when rounded",
                     "Scale the intensities so that they span several hundred (a CT's unit is HU)");
  // Metal and padding lie beyond what 16 bits hold; a whole image there is another matter.
  const auto beyond = std::count_if(raw.voxels.begin(), raw.voxels.end(),
                                    [](float v) { return v > 32767.0F || v < -32768.0F; });
  if (static_cast<double>(beyond) > 0.01 * static_cast<double>(raw.voxels.size()))
    throw InputError(
        request.name, "voxels",
        "run from " + std::to_string(*low) + " to " + std::to_string(*high) + ", beyond 16-bit integers",
        "Scale the intensities to -32768 ... 32767");
  return whole_numbers<std::int16_t>(request, raw.voxels, -32768.0F, 32767.0F, "intensity", true);
}

template <class T>
void write_raw(const fs::path& path, const std::vector<T>& values) {
  struct statvfs disk {};
  const double needed = static_cast<double>(values.size() * sizeof(T));
  if (::statvfs(path.parent_path().c_str(), &disk) == 0 &&
      static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize) < needed + 1e7)
    throw FileError(path.parent_path().parent_path().string() + ": has no room for a volume of " +
                    std::to_string(static_cast<long>(1e-6 * needed)) +
                    " MB. Free space for temporary files, or set TMPDIR to a larger disk.");
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(T)));
  stream.close();
  if (!stream) throw FileError(path.string() + ": could not be written. Free space for temporary files.");
}

void write_json_file(const fs::path& path, const nlohmann::json& document) {
  std::ofstream stream(path);
  // Texts of foreign files need not be UTF-8.
  stream << document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  stream.close();
  if (!stream) throw FileError(path.string() + ": could not be written. Free space for temporary files.");
}

void deliver(const Request& request, const fs::path& folder, const RawVolume& raw) {
  if (raw.components != 1 && !(request.labels && raw.layers))
    throw InputError(request.name, "voxels",
                     "hold " + std::to_string(raw.components) + " values each (a colour or vector image)",
                     "Export a volume with one value a voxel");
  std::string modality = raw.modality;
  if (request.labels) {
    write_raw(folder / "voxels.raw",
              whole_numbers<std::uint16_t>(request, raw.voxels, 0.0F, 65535.0F, "label (0 to 65535)", false));
  } else {
    const std::vector<std::int16_t> values = image_values(request, raw);
    write_raw(folder / "voxels.raw", values);
    // Where the file does not say: only Hounsfield units go below zero.
    if (modality.empty()) modality = *std::min_element(values.begin(), values.end()) < -50 ? "ct" : "other";
  }
  const VolumeGrid& grid = raw.grid;
  nlohmann::json direction = nlohmann::json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) direction.push_back(grid.direction(row, column));
  write_json_file(folder / "header.json",
                  {{"size", {grid.size.x(), grid.size.y(), grid.size.z()}},
                   {"spacing", {grid.spacing_mm.x(), grid.spacing_mm.y(), grid.spacing_mm.z()}},
                   {"origin", {grid.origin_mm.x(), grid.origin_mm.y(), grid.origin_mm.z()}},
                   {"direction", direction},
                   {"components", raw.components},
                   {"modality", modality},
                   {"description", raw.description},
                   {"texts", raw.texts},
                   {"source",
                    {{"patient", raw.source.patient},
                     {"patient_id", raw.source.patient_id},
                     {"birth_date", raw.source.birth_date},
                     {"study_uid", raw.source.study_uid},
                     {"series_uid", raw.source.series_uid},
                     {"frame_of_reference_uid", raw.source.frame_of_reference_uid},
                     {"slice_class_uid", raw.source.slice_class_uid},
                     {"slice_uids", raw.source.slice_uids}}}});
}

void list_series(const Request& request, const fs::path& folder) {
  if (!fs::is_directory(request.path))
    throw InputError(request.name, "", "is no folder of DICOM slices",
                     "Name the folder that holds the series");
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [series, middle] : reader::list_dicom_folder(request))
    list.push_back({{"uid", series.uid},
                    {"number", series.number},
                    {"description", series.description},
                    {"modality", series.modality},
                    {"slices", series.slices},
                    {"images", series.images},
                    {"patient", series.patient},
                    {"patient_id", series.patient_id},
                    {"date", series.date},
                    {"study", series.study},
                    {"protocol", series.protocol},
                    {"kind", series.kind},
                    {"contrast_agent", series.contrast_agent},
                    {"pixels", {series.pixels.x(), series.pixels.y()}},
                    {"pixel_mm", {series.pixel_mm.x(), series.pixel_mm.y()}},
                    {"thickness_mm", series.thickness_mm},
                    {"gap_mm", series.gap_mm},
                    {"normal", {series.normal.x(), series.normal.y(), series.normal.z()}},
                    {"frames", series.frames},
                    {"middle", middle.string()}});
  write_json_file(folder / "series.json", list);
}

void make_picture(const Request& request, const fs::path& folder) {
  const SeriesPicture picture = reader::dicom_picture(request);
  write_json_file(folder / "picture.json", {{"width", picture.width},
                                            {"height", picture.height},
                                            {"pixel_aspect", picture.pixel_aspect},
                                            {"values", picture.values},
                                            {"grey", picture.grey}});
}

int refuse(const fs::path& folder, const InputError& error) {
  write_json_file(folder / "refusal.json", {{"file", error.file()},
                                            {"field", error.field()},
                                            {"problem", error.problem()},
                                            {"remedy", error.remedy()}});
  return kRefused;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5 && count != 6) {
    std::fprintf(
        stderr,
        "glisson-read-volume MODE INPUT FOLDER NAME [SERIES]: a helper of Glisson, not run by hand\n");
    return 2;
  }
  const std::string mode = words[1];
  const fs::path folder = words[3];
  const auto tell = [](double fraction) {
    std::printf("%.3f\n", fraction);
    std::fflush(stdout);
  };
  const Request request{words[2], words[4], folder, tell, count == 6 ? words[5] : "", mode == "labels"};
  limit_resources(request);
  confine_to(request, folder);
  try {
    if (mode == "escapes")
      write_json_file(folder / "escapes.json", escapes());
    else if (mode == "unpack")
      reader::unpack_archive(request, folder / "archive");
    else if (mode == "dicomdir")
      write_json_file(folder / "files.json", reader::files_of_dicomdir(request));
    else if (mode == "series")
      list_series(request, folder);
    else if (mode == "picture")
      make_picture(request, folder);
    else
      deliver(request, folder, read_any(request));
    return 0;
  } catch (const InputError& error) {
    return refuse(folder, error);
  } catch (const FileError& error) {
    return refuse(folder, InputError("", "", error.what(), ""));
  } catch (const std::bad_alloc&) {
    return refuse(folder, InputError(request.name, "size", "needs more memory than there is",
                                     "The header is damaged, or crop the volume"));
  } catch (const fs::filesystem_error& error) {
    return refuse(folder, InputError(request.name, "", "cannot be read (" + error.code().message() + ")",
                                     "Check its permissions"));
  } catch (const std::exception&) {
    return refuse(folder, InputError(request.name, "", "is damaged or not of the format that its name claims",
                                     "Export it again"));
  }
}
