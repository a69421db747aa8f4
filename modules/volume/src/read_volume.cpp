// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "glisson/core/child_process.h"
#include "glisson/core/error.h"
#include "glisson/core/failure_sentence.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/volume/dicom_segmentation.h"
#include "glisson/volume/io.h"
#include "glisson/volume/reader_program.h"
#include "glisson/volume/series.h"
#include "most_values.h"
#include "slicer_segments.h"

namespace glisson {
namespace fs = std::filesystem;
namespace {

constexpr int kRefused = 3;  // reader/main.cpp

fs::path reader_program() { return helper_program("glisson-read-volume", "GLISSON_READ_VOLUME"); }

/// What the reading program has left.
struct Delivered {
  VolumeGrid grid;
  int components = 1;
  std::string modality, description;
  Texts texts;
  DicomSource source;
  fs::path voxels;
};

template <class Vector>
void fill(const nlohmann::json& from, Vector& to) {
  for (Eigen::Index i = 0; i < to.size(); ++i) to[i] = from.at(static_cast<std::size_t>(i));
}

[[noreturn]] void throw_fault() {
  throw FileError(
      "glisson-read-volume: left what is no result of it. Do not trust the file; export it again.");
}

/// A program that a file has taken over may leave links and pipes: only a file of its own is a result.
fs::path result_in(const fs::path& folder, const char* name, double most_bytes) {
  const fs::path path = folder / name;
  std::error_code failure;
  const bool is_file = fs::is_regular_file(fs::symlink_status(path, failure));
  if (!is_file || !(static_cast<double>(fs::file_size(path, failure)) <= most_bytes) || failure)
    throw_fault();
  return path;
}

nlohmann::json told_in(const fs::path& folder, const char* name) {
  constexpr double kLongest = 1e8;  // segmentations carry long texts
  return read_json(result_in(folder, name, kLongest));
}

/// What the reader itself refuses, see reader/checks.cpp: nothing is allocated for it here, either.
void check(const VolumeGrid& grid, int components) {
  const double values = grid.size.cast<double>().prod() * components;
  const bool is_one = (grid.size.array() >= 1).all() && components >= 1 && values <= kMostVolumeValues &&
                      grid.spacing_mm.allFinite() && (grid.spacing_mm.array() > 0.0).all() &&
                      grid.origin_mm.allFinite() && grid.direction.allFinite();
  if (!is_one) throw_fault();
}

/// Of a DICOM UID's form, else empty: what is written again must be one.
std::string uid_in(const nlohmann::json& json) {
  const std::string uid = json;
  const bool is_one =
      !uid.empty() && uid.size() <= 64 && uid.find_first_not_of("0123456789.") == std::string::npos;
  return is_one ? uid : std::string();
}

DicomSource source_in(const nlohmann::json& json) {
  DicomSource source{json.at("patient"),
                     json.at("patient_id"),
                     json.at("birth_date"),
                     uid_in(json.at("study_uid")),
                     uid_in(json.at("series_uid")),
                     uid_in(json.at("frame_of_reference_uid")),
                     uid_in(json.at("slice_class_uid")),
                     {}};
  for (const nlohmann::json& uid : json.at("slice_uids")) source.slice_uids.push_back(uid_in(uid));
  if (std::ranges::find(source.slice_uids, std::string()) != source.slice_uids.end())
    source.slice_uids.clear();
  return source;
}

Delivered delivered_in(const fs::path& folder) {
  const nlohmann::json header = told_in(folder, "header.json");
  Delivered result;
  fill(header.at("size"), result.grid.size);
  fill(header.at("spacing"), result.grid.spacing_mm);
  fill(header.at("origin"), result.grid.origin_mm);
  for (std::size_t i = 0; i < 9; ++i)
    result.grid.direction(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
        header.at("direction").at(i);
  result.components = header.at("components");
  result.modality = header.at("modality");
  result.description = header.at("description");
  result.texts = header.at("texts").get<Texts>();
  if (header.contains("source")) result.source = source_in(header.at("source"));
  check(result.grid, result.components);
  result.voxels = result_in(folder, "voxels.raw", 5e9);
  return result;
}

[[noreturn]] void throw_refusal(const fs::path& folder) {
  const nlohmann::json refusal = told_in(folder, "refusal.json");
  throw InputError(refusal.at("file"), refusal.at("field"), refusal.at("problem"), refusal.at("remedy"));
}

/// Runs the reading program on `input`. False when cancelled.
bool run_reader(const char* mode, const fs::path& input, const std::string& name, const fs::path& folder,
                const std::string& series, const RunContext& context, const char* stage = "volume.read") {
  std::vector<std::string> words = {mode, input.string(), folder.string(), name};
  if (!series.empty()) words.push_back(series);
  const auto end = run_child(reader_program().string(), words, context, [&](const std::string& line) {
    context.progress(std::strtod(line.c_str(), nullptr), stage);
  });
  if (!end) return false;
  if (end->code == kRefused) throw_refusal(folder);
  if (end->code == 127) throw FileError(reader_program().string() + ": cannot run. Install Glisson again.");
  // GDCM breaks down at some directories that were cut.
  if (end->code != 0 && mode == std::string_view("dicomdir"))
    throw InputError(name, "", "is a DICOM directory that was cut or is damaged",
                     "Name the folder that holds the series");
  if (end->code != 0)
    throw InputError(name, "", "is damaged: the program that reads it broke down", "Export it again");
  return true;
}

template <class T>
std::vector<T> read_raw(const fs::path& path, std::size_t count) {
  std::error_code failure;
  const std::uintmax_t bytes = fs::file_size(path, failure);
  if (!failure && bytes > count * sizeof(T)) throw_fault();
  if (failure || bytes < count * sizeof(T))
    throw FileError(path.string() + ": is shorter than expected. Free space for temporary files.");
  std::vector<T> values(count);
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
  if (static_cast<std::size_t>(stream.gcount()) != count * sizeof(T))
    throw FileError(path.string() + ": is shorter than expected. Free space for temporary files.");
  return values;
}

void require_exists(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (failure && failure != std::errc::no_such_file_or_directory)
    throw FileError(sentence_of(fs::filesystem_error("", path, failure)));
  if (!fs::exists(status)) throw FileError(path.string() + ": does not exist. Check the path.");
  if (fs::is_directory(status)) return;
  if (!fs::is_regular_file(status))
    throw FileError(path.string() + ": is neither a file nor a folder. Name a volume.");
  if (!std::ifstream(path, std::ios::binary))
    throw FileError(path.string() + ": cannot be opened (" + std::strerror(errno) +
                    "). Check its permissions.");
}

bool is_archive(const fs::path& path) {
  const std::string name = lower_name(path);
  return name.ends_with(".tar.gz") || name.ends_with(".tgz") || name.ends_with(".tar") ||
         name.ends_with(".zip");
}

/// The folder of an archive's content below `work`, else the path itself. `reading` becomes what is left of
/// the progress. Empty when cancelled.
std::optional<fs::path> unpacked(const fs::path& path, const fs::path& work, const RunContext& context,
                                 RunContext& reading) {
  if (!is_archive(path)) return path;
  const fs::path input = work / "archive";
  fs::create_directory(input);
  if (!run_reader("unpack", fs::absolute(path), path.string(), work, "", context.part(0.0, 0.2),
                  "volume.unpack"))
    return std::nullopt;
  reading = context.part(0.2, 0.95);
  return input;
}

bool is_dicomdir(const fs::path& path) {
  std::error_code failure;
  return lower_name(path) == "dicomdir" && fs::is_regular_file(path, failure);
}

std::string lowered(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

/// Names without case, for what a disc's file system and its copy write differently.
std::set<std::string> names_below(const fs::path& folder) {
  constexpr std::size_t kMostFiles = 300000;
  std::set<std::string> names;
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, failure);
  for (; !failure && entry != fs::recursive_directory_iterator() && names.size() < kMostFiles;
       entry.increment(failure))
    names.insert(lowered(entry->path().lexically_relative(folder).generic_string()));
  return names;
}

/// Of the files that a DICOMDIR names those that are not there. Empty when cancelled.
/// @throws InputError none of them is there.
std::optional<std::vector<std::string>> missing_of(const fs::path& dicomdir, const fs::path& work,
                                                   const RunContext& context) {
  if (!run_reader("dicomdir", dicomdir, dicomdir.string(), work, "", context.quiet())) return std::nullopt;
  const auto named = told_in(work, "files.json").get<std::vector<std::string>>();
  const std::set<std::string> there = names_below(fs::absolute(dicomdir).parent_path());
  std::vector<std::string> missing;
  for (const std::string& file : named)
    if (!there.contains(lowered(file))) missing.push_back(file);
  if (!named.empty() && missing.size() == named.size())
    throw InputError(dicomdir.string(), "", "names files that are all missing, " + named.front() + " first",
                     "Copy the whole medium, not its DICOMDIR alone");
  return missing;
}

/// What the reading program is given: the folder of an archive's content below `work` or of a DICOMDIR, else
/// the path itself. `missing`: see missing_of(). Empty when cancelled.
std::optional<fs::path> input_of(const fs::path& path, const fs::path& work, const RunContext& context,
                                 RunContext& reading, std::vector<std::string>& missing) {
  if (!is_dicomdir(path)) return unpacked(path, work, context, reading);
  auto found = missing_of(path, work, context);
  if (!found) return std::nullopt;
  missing = std::move(*found);
  return fs::absolute(path).parent_path();
}

DicomSeries series_from(const nlohmann::json& json) {
  DicomSeries series;
  series.uid = json.at("uid");
  series.number = json.at("number");
  series.description = json.at("description");
  series.modality = json.at("modality");
  series.slices = json.at("slices");
  series.images = json.at("images");
  series.patient = json.at("patient");
  series.patient_id = json.at("patient_id");
  series.date = json.at("date");
  series.study = json.at("study");
  series.protocol = json.at("protocol");
  series.kind = json.at("kind");
  series.contrast_agent = json.at("contrast_agent");
  fill(json.at("pixels"), series.pixels);
  fill(json.at("pixel_mm"), series.pixel_mm);
  series.thickness_mm = json.at("thickness_mm");
  series.gap_mm = json.at("gap_mm");
  fill(json.at("normal"), series.normal);
  series.frames = json.at("frames");
  return series;
}

/// A picture of one file; none where the reading program cannot make one. No value: cancelled.
Cancellable<SeriesPicture> picture_of(const fs::path& file, const RunContext& context) {
  const TemporaryFolder work;
  SeriesPicture picture;
  try {
    if (!run_reader("picture", file, file.string(), work.path(), "", context.quiet())) return std::nullopt;
    const nlohmann::json json = told_in(work.path(), "picture.json");
    picture.width = json.at("width");
    picture.height = json.at("height");
    picture.pixel_aspect = json.at("pixel_aspect");
    picture.values = json.at("values");
    picture.grey = json.at("grey").get<std::vector<std::uint8_t>>();
    const bool fits = picture.width > 0 && picture.height > 0 && picture.width <= 1024 &&
                      picture.height <= 1024 &&
                      picture.grey.size() ==
                          static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    if (!fits) picture = {};
  } catch (const Error&) {
    picture = {};  // the series is listed without one; whether it can be read says its reading
  }
  return picture;
}

std::vector<LabelInfo> infos_of(const LabelVolume& voxels) {
  std::vector<LabelInfo> infos;
  const std::vector<long> counts = voxels.histogram();
  for (std::size_t label = 1; label < counts.size(); ++label)
    if (counts[label] > 0) infos.push_back({static_cast<Label>(label), "", "", {0.5, 0.5, 0.5}});
  return infos;
}

Cancellable<DicomLabels> read_labels_of(const fs::path& path, const RunContext& context) {
  require_exists(path);
  if (is_archive(path))
    throw InputError(path.string(), "", "is an archive, not a file of labels",
                     "Unpack it yourself and name the file of labels in it");
  const TemporaryFolder work;
  if (!run_reader("labels", path, path.string(), work.path(), "", context, "labels.read"))
    return std::nullopt;
  const Delivered delivered = delivered_in(work.path());
  DicomLabels labels{{}, delivered.texts.contains("glisson_own"), delivered.source.frame_of_reference_uid};
  const auto values =
      read_raw<Label>(delivered.voxels, static_cast<std::size_t>(delivered.grid.voxel_count()) *
                                            static_cast<std::size_t>(delivered.components));
  std::vector<SlicerSegment> segments = slicer_segments(path.string(), delivered.texts, delivered.components);
  if (!segments.empty()) segments = with_unnamed(std::move(segments), delivered.components, values);
  LabelFile& file = labels.file;
  if (delivered.components > 1) {
    file = flattened(delivered.grid, delivered.components, values, segments);
    return labels;
  }
  file.voxels = LabelVolume(delivered.grid, values);
  for (const SlicerSegment& segment : segments)
    file.infos.push_back({segment.value, segment.name, segment.terminology, segment.colour, segment.status});
  if (segments.empty()) file.infos = infos_of(file.voxels);
  return labels;
}

}  // namespace

std::vector<std::string> reader_escapes() {
  const TemporaryFolder work;
  run_reader("escapes", work.path(), "", work.path(), "", RunContext());
  return told_in(work.path(), "escapes.json").get<std::vector<std::string>>();
}

Cancellable<std::vector<DicomSeries>> list_series(const fs::path& path, const RunContext& context) {
  require_exists(path);
  const TemporaryFolder work;
  RunContext reading = context;
  std::vector<std::string> missing;
  const auto input = input_of(path, work.path(), context, reading, missing);
  if (!input || !run_reader("series", *input, path.string(), work.path(), "",
                            is_archive(path) ? reading : context.part(0.0, 0.7)))
    return std::nullopt;
  std::vector<DicomSeries> all;
  std::map<std::string, fs::path> middles;  // by UID
  for (const nlohmann::json& json : told_in(work.path(), "series.json")) {
    all.push_back(series_from(json));
    middles[all.back().uid] = json.at("middle").get<std::string>();
  }
  sort_by_likelihood(all);
  constexpr std::size_t kPictures = 60;
  for (std::size_t n = 0; n < std::min(all.size(), kPictures); ++n) {
    const fs::path& middle = middles[all[n].uid];
    // Named by a program that has read foreign files: nowhere but below the folder.
    if (middle.empty() || middle.is_absolute() || std::ranges::find(middle, fs::path("..")) != middle.end())
      continue;
    auto picture = picture_of(*input / middle, context);
    if (!picture) return std::nullopt;
    all[n].picture = std::move(*picture);
    context.progress(0.7 + 0.3 * static_cast<double>(n + 1) / static_cast<double>(all.size()), "volume.read");
  }
  sort_by_likelihood(all);  // by now masks are known
  return all;
}

Cancellable<Image> read_image(const fs::path& path, const RunContext& context, const std::string& series) {
  auto scan = read_scan(path, context, series);
  if (!scan) return std::nullopt;
  return std::move(scan->image);
}

Cancellable<Scan> read_scan(const fs::path& path, const RunContext& context, const std::string& series) {
  require_exists(path);
  const TemporaryFolder work;
  RunContext reading = context.part(0.0, 0.95);
  std::vector<std::string> missing;
  const auto input = input_of(path, work.path(), context, reading, missing);
  if (!input || !run_reader("image", *input, path.string(), work.path(), series, reading))
    return std::nullopt;
  const Delivered delivered = delivered_in(work.path());
  Image image;
  image.grid = delivered.grid;
  image.modality = modality_named(delivered.modality).value_or(Modality::other);
  image.description = delivered.description;
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(
      read_raw<std::int16_t>(delivered.voxels, static_cast<std::size_t>(image.grid.voxel_count())));
  context.progress(1.0, "volume.read");
  return Scan{std::move(image), delivered.source, std::move(missing)};
}

Cancellable<DicomLabels> read_dicom_labels(const fs::path& path, const RunContext& context) {
  return read_labels_of(path, context);
}

Cancellable<LabelFile> read_labels(const fs::path& path, const RunContext& context) {
  auto labels = read_labels_of(path, context);
  if (!labels) return std::nullopt;
  return std::move(labels->file);
}

LabelFile read_labels(const fs::path& path) { return *read_labels(path, RunContext()); }

void require_same_grid(const VolumeGrid& a, const VolumeGrid& b, const std::string& name) {
  if (a.same_as(b)) return;
  const auto text = [](const Eigen::Vector3i& size) {
    return std::to_string(size.x()) + " x " + std::to_string(size.y()) + " x " + std::to_string(size.z());
  };
  if (a.size != b.size)
    throw InputError(name, "size", "is " + text(b.size) + " voxels where " + text(a.size) + " are expected",
                     "Resample one of the two volumes to the other's grid");
  throw InputError(name, "position", "has the right size but lies elsewhere in the patient",
                   "Check origin, spacing and direction of the two volumes");
}

}  // namespace glisson
