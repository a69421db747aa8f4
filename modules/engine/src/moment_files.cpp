// SPDX-License-Identifier: GPL-3.0-or-later
#include "moment_files.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "case_files.h"
#include "case_manifest.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/core/word_sum.h"
#include "glisson/engine/moment_export.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/overlay_record.h"

namespace glisson::engine {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

constexpr double kMillimetre = 1e-3;
constexpr const char* kAgain = "Restore the case from a copy";
constexpr std::size_t kMostTitle = 1000;  ///< bytes
/// Bytes: of 64 million pixels, more than which no picture is read.
constexpr std::size_t kMostPicture = 200'000'000;

fs::path file_of(const fs::path& folder, int number, const char* ending) {
  char name[32];
  (void)std::snprintf(name, sizeof name, "%04d", number);
  return folder / "moments" / (std::string(name) + ending);
}

/// Pictures never change: the same bytes need no second place on the disk.
void write_or_link(const fs::path& path, const fs::path& former, const std::string& content) {
  std::error_code failure;
  const bool is_there = former != path && fs::is_regular_file(fs::symlink_status(former, failure)) &&
                        fs::file_size(former, failure) == content.size() && read_file(former) == content;
  if (is_there) {
    fs::create_hard_link(former, path, failure);
    if (!failure) return;
  }
  write_file_atomically(path, content);
}

json written(double metres) { return std::isfinite(metres) ? json(metres / kMillimetre) : json(); }

json written(const guidance::LesionMeasures& measures) {
  return {{"along_sight_mm", written(measures.along_sight)},
          {"shortest_mm", written(measures.shortest)},
          {"from_mark_mm", written(measures.from_place)}};
}

json written(const KeptMoment& moment) {
  json document = {{"number", moment.number},
                   {"title", moment.title},
                   {"kept_at", moment.kept_at},
                   {"model_revision", moment.model_revision},
                   {"calibration_revision", moment.rig_revision},
                   {"model_unchecked", moment.model_unchecked},
                   {"landmarks_open", moment.landmarks_open},
                   {"landmarks_from_statistics", moment.landmarks_from_statistics},
                   {"anterior_margin_mm", points_to_json(moment.margin)}};
  if (moment.chosen != 0) document["chosen_lesion"] = structure_name(moment.chosen);
  if (moment.measures) document["measures"] = written(*moment.measures);
  if (moment.place) {
    const Eigen::Vector3d& w = moment.place->weights;
    document["mark"] = {{"triangle", moment.place->triangle}, {"weights", {w.x(), w.y(), w.z()}}};
  }
  return document;
}

/// Its overlay, as a track's frames.jsonl has it.
std::string overlay_of(const KeptMoment& moment) {
  OverlayLine line;
  line.number = moment.overlay.index;
  line.overlay = moment.overlay;
  line.nodes_here = moment.camera_from_model.has_value();
  line.camera_from_model = moment.camera_from_model;
  return overlay_line(line);
}

/// Entries of a moment's file, refused by name.
class MomentFile {
 public:
  explicit MomentFile(const fs::path& path) : file_(path.string()), document_(read_json(path)) {
    if (!document_.is_object()) refuse("", "is not a JSON object");
  }
  [[noreturn]] void refuse(const std::string& field, const std::string& problem) const {
    throw InputError(file_, field, problem, kAgain);
  }
  bool has(const char* field) const { return document_.contains(field); }
  const json& entry(const char* field) const {
    const auto found = document_.find(field);
    if (found == document_.end()) refuse(field, "is missing");
    return *found;
  }
  template <class T>
  T get(const char* field) const {
    return as<T>(entry(field), field);
  }
  std::uint64_t count(const char* field) const {
    const json& value = entry(field);
    if (!value.is_number_unsigned()) refuse(field, "is not of the right kind");
    return value.get<std::uint64_t>();
  }
  /// Metres of a field of `group` in millimetres; null: not a number.
  double length(const char* group, const char* field) const {
    const json& within = entry(group);
    const auto found = within.is_object() ? within.find(field) : within.end();
    if (!within.is_object() || found == within.end()) refuse(group, "is not of the right kind");
    if (found->is_null()) return std::numeric_limits<double>::quiet_NaN();
    const double value = as<double>(*found, group);
    if (!std::isfinite(value) || value < 0.0) refuse(group, "is not of the right kind");
    return kMillimetre * value;
  }
  template <class T>
  T as(const json& value, const char* field) const {
    try {
      return value.get<T>();
    } catch (const json::exception&) {
      refuse(field, "is not of the right kind");
    }
  }
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  json document_;
};

Label read_lesion(const MomentFile& file) {
  const auto name = file.get<std::string>("chosen_lesion");
  const std::optional<Label> lesion = structure_named(name);
  if (!lesion || !is_lesion(*lesion)) file.refuse("chosen_lesion", "is no lesion");
  return *lesion;
}

guidance::SurfacePlace read_mark(const MomentFile& file) {
  const json& mark = file.entry("mark");
  if (!mark.is_object() || !mark.contains("triangle") || !mark.contains("weights"))
    file.refuse("mark", "is not of the right kind");
  guidance::SurfacePlace place;
  const auto weights = file.as<std::vector<double>>(mark["weights"], "mark");
  const json& triangle = mark["triangle"];
  const bool is_sound = triangle.is_number_integer() && triangle >= 0 &&
                        triangle <= std::numeric_limits<int>::max() && weights.size() == 3;
  if (!is_sound) file.refuse("mark", "is not of the right kind");
  place.triangle = triangle.get<int>();
  place.weights = {weights[0], weights[1], weights[2]};
  // A place within its triangle.
  const bool is_within = place.weights.allFinite() && place.weights.minCoeff() >= -1e-6 &&
                         std::abs(place.weights.sum() - 1.0) < 1e-6;
  if (!is_within) file.refuse("mark", "is not of the right kind");
  return place;
}

KeptMoment read_description(const MomentFile& file) {
  KeptMoment moment;
  const std::uint64_t number = file.count("number");
  moment.number = number <= 1000000 ? static_cast<int>(number) : -1;
  moment.title = file.get<std::string>("title");
  if (moment.title.size() > kMostTitle) file.refuse("title", "is longer than a title can be");
  moment.kept_at = file.get<std::string>("kept_at");
  if (moment.kept_at.size() > 40) file.refuse("kept_at", "is no time");
  moment.model_revision = file.count("model_revision");
  moment.rig_revision = file.count("calibration_revision");
  moment.model_unchecked = file.get<bool>("model_unchecked");
  moment.landmarks_open = file.get<bool>("landmarks_open");
  moment.landmarks_from_statistics = file.get<bool>("landmarks_from_statistics");
  moment.margin = points_from_json(file.entry("anterior_margin_mm"), file.file(), "anterior_margin_mm");
  if (file.has("chosen_lesion")) moment.chosen = read_lesion(file);
  if (file.has("measures") && moment.chosen != 0) {
    guidance::LesionMeasures measures;
    measures.lesion = moment.chosen;
    measures.along_sight = file.length("measures", "along_sight_mm");
    measures.shortest = file.length("measures", "shortest_mm");
    measures.from_place = file.length("measures", "from_mark_mm");
    moment.measures = measures;
  }
  if (file.has("mark")) moment.place = read_mark(file);
  return moment;
}

bool is_near(double a, double b) { return std::isfinite(a) == std::isfinite(b) && !(std::abs(a - b) > 1e-6); }

bool same_measures(const KeptMoment& a, const KeptMoment& b) {
  if (!a.measures || !b.measures) return !a.measures && !b.measures;
  return is_near(a.measures->along_sight, b.measures->along_sight) &&
         is_near(a.measures->shortest, b.measures->shortest) &&
         is_near(a.measures->from_place, b.measures->from_place);
}

}  // namespace

void write_moment(const fs::path& folder, const fs::path& former, const KeptMoment& moment) {
  fs::create_directories(folder / "moments");
  json document = written(moment);
  for (const auto& [side, png] : {std::pair{"left", moment.left_png}, {"right", moment.right_png}}) {
    const std::string ending = std::string("_") + side + ".png";
    const fs::path path = file_of(folder, moment.number, ending.c_str());
    write_or_link(path, file_of(former, moment.number, ending.c_str()), *png);
    document["sums"][side] = sum_of_content(*png);
  }
  write_file_atomically(file_of(folder, moment.number, ".jsonl"), overlay_of(moment) + "\n");
  write_json(file_of(folder, moment.number, ".json"), document);
}

KeptMoment read_moment(const fs::path& folder, int number) {
  const MomentFile file(file_of(folder, number, ".json"));
  KeptMoment moment = read_description(file);
  if (moment.number != number) file.refuse("number", "is that of another moment");
  const fs::path lines = file_of(folder, number, ".jsonl");
  const OverlayRecord record = read_overlay_record(lines);
  if (record.frames.size() != 1 || !record.frames.front().mesh.empty())
    throw InputError(lines.string(), "", "does not hold one frame", kAgain);
  moment.overlay = record.frames.front().overlay;
  moment.camera_from_model = record.frames.front().camera_from_model;
  const json& sums = file.entry("sums");
  for (const char* side : {"left", "right"}) {
    const fs::path path = file_of(folder, number, side == std::string("left") ? "_left.png" : "_right.png");
    auto content = std::make_shared<const std::string>(read_file(path, kMostPicture));
    if (!sums.is_object() || !sums.contains(side) || sums[side] != sum_of_content(*content))
      throw InputError(path.string(), "", "is not the picture that was kept", kAgain);
    (side == std::string("left") ? moment.left_png : moment.right_png) = std::move(content);
  }
  return moment;
}

void export_moment(const fs::path& folder, const std::string& name, const KeptMoment& moment, bool is_drawn) {
  json document = written(moment);
  document["overlay"] = json::parse(overlay_of(moment));
  document["overlay_is_drawn"] = is_drawn;
  write_file_atomically(folder / (name + "_left.png"), *moment.left_png);
  write_file_atomically(folder / (name + "_right.png"), *moment.right_png);
  write_json(folder / (name + ".json"), document);
}

bool same_moment(const KeptMoment& a, const KeptMoment& b) {
  return a.number == b.number && a.title == b.title && a.kept_at == b.kept_at && *a.left_png == *b.left_png &&
         *a.right_png == *b.right_png && a.overlay.index == b.overlay.index &&
         is_near(a.overlay.seconds, b.overlay.seconds) && a.overlay.validity == b.overlay.validity &&
         a.overlay.doubtful == b.overlay.doubtful &&
         same_points(a.overlay.nodes_in_camera, b.overlay.nodes_in_camera) &&
         // Without nodes nothing is told of lesions.
         (!a.camera_from_model || a.overlay.lesions.size() == b.overlay.lesions.size()) &&
         a.camera_from_model.has_value() == b.camera_from_model.has_value() && a.chosen == b.chosen &&
         same_measures(a, b) && a.place.has_value() == b.place.has_value() &&
         same_points(a.margin, b.margin) && a.model_unchecked == b.model_unchecked &&
         a.landmarks_open == b.landmarks_open && a.landmarks_from_statistics == b.landmarks_from_statistics &&
         a.model_revision == b.model_revision && a.rig_revision == b.rig_revision;
}

}  // namespace glisson::engine
