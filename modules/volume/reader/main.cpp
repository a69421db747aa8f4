// SPDX-License-Identifier: GPL-3.0-or-later
//
// glisson-read-volume MODE INPUT FOLDER NAME [SERIES]
//
// Reads INPUT (MODE: image or labels) and leaves FOLDER/header.json and FOLDER/voxels.raw, or only lists the
// series of a DICOM folder (MODE: series) in FOLDER/series.json; with exit code 3 it leaves
// FOLDER/refusal.json. NAME is what messages call the input, SERIES chooses one of several. Progress goes to
// standard output, one fraction a line. A program of its own because the parsers abort on some malformed
// files.

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "raw_volume.h"

namespace {

using namespace glisson;
using reader::RawVolume;
using reader::Request;

constexpr int kRefused = 3;

/// A damaged header may ask for all memory or loop for ever: then this process dies, and only it.
void limit_resources() {
  const rlimit seconds{600, 600};
  setrlimit(RLIMIT_CPU, &seconds);
  const rlimit core{0, 0};
  setrlimit(RLIMIT_CORE, &core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const auto memory =
      static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGE_SIZE));
  const rlimit bytes{memory, memory};
  setrlimit(RLIMIT_AS, &bytes);
#endif
}

RawVolume read_any(const Request& request) {
  if (std::filesystem::is_directory(request.path)) return reader::read_dicom_folder(request);
  if (!request.series.empty())
    throw InputError(request.name, "series", "cannot be chosen in a file that holds one volume",
                     "Leave the series out, or name the folder that holds the DICOM slices");
  const std::string extension = lower_extension(request.path);
  if (extension == ".vti") return reader::read_vti_file(request);
  if (extension == ".dcm" || extension == ".ima")
    throw InputError(request.name, "", "is a single DICOM slice", "Name the folder that holds the series");
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
void write_raw(const std::filesystem::path& path, const std::vector<T>& values) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(T)));
  stream.close();
  if (!stream) throw FileError(path.string() + ": could not be written. Free space for temporary files.");
}

void write_json_file(const std::filesystem::path& path, const nlohmann::json& document) {
  std::ofstream stream(path);
  // Texts of foreign files need not be UTF-8.
  stream << document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  stream.close();
  if (!stream) throw FileError(path.string() + ": could not be written. Free space for temporary files.");
}

void deliver(const Request& request, bool labels, const std::filesystem::path& folder, const RawVolume& raw) {
  if (raw.components != 1 && !(labels && raw.layers))
    throw InputError(request.name, "voxels",
                     "hold " + std::to_string(raw.components) + " values each (a colour or vector image)",
                     "Export a volume with one value a voxel");
  std::string modality = raw.modality;
  if (labels) {
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
                   {"texts", raw.texts}});
}

void list_series(const Request& request, const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(request.path))
    throw InputError(request.name, "", "is no folder of DICOM slices",
                     "Name the folder that holds the series");
  nlohmann::json list = nlohmann::json::array();
  for (const DicomSeries& series : reader::list_dicom_folder(request))
    list.push_back({{"uid", series.uid},
                    {"number", series.number},
                    {"description", series.description},
                    {"modality", series.modality},
                    {"slices", series.slices}});
  write_json_file(folder / "series.json", list);
}

int refuse(const std::filesystem::path& folder, const InputError& error) {
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
  limit_resources();
  const std::string mode = words[1];
  const std::filesystem::path folder = words[3];
  const auto tell = [](double fraction) {
    std::printf("%.3f\n", fraction);
    std::fflush(stdout);
  };
  const Request request{words[2], words[4], folder, tell, count == 6 ? words[5] : ""};
  try {
    if (mode == "series")
      list_series(request, folder);
    else
      deliver(request, mode == "labels", folder, read_any(request));
    return 0;
  } catch (const InputError& error) {
    return refuse(folder, error);
  } catch (const FileError& error) {
    return refuse(folder, InputError("", "", error.what(), ""));
  } catch (const std::bad_alloc&) {
    return refuse(folder, InputError(request.name, "size", "needs more memory than there is",
                                     "The header is damaged, or crop the volume"));
  } catch (const std::exception&) {
    return refuse(folder, InputError(request.name, "", "is damaged or not of the format that its name claims",
                                     "Export it again"));
  }
}
