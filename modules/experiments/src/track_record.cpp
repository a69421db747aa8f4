// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/track_record.h"

#include <string_view>
#include <utility>

#include "glisson/core/files.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/forks.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

/// Those that are there already are replaced.
void append(Figures& figures, const Figures& more) {
  for (const auto& [key, value] : more) figures[key] = value;
}

/// With zeros in front.
std::string padded(int number, int digits) {
  std::string text = std::to_string(number);
  const auto wanted = static_cast<std::size_t>(digits);
  return text.size() < wanted ? std::string(wanted - text.size(), '0') + text : text;
}

}  // namespace

TrackRecord::TrackRecord(const PatientModel& model, Registration start, TrackOutput output)
    : model_(model),
      start_(std::move(start)),
      carried_(start_),
      output_(std::move(output)),
      evaluation_(model_, start_, output_.frames_per_second) {}

void TrackRecord::add(int number, const OverlayFrame& overlay) {
  evaluation_.add(overlay);
  const std::string level = level_code(overlay.level()), reason = validity_code(overlay.validity);
  OverlayLine line;
  line.number = number;
  line.unit = output_.unit;
  line.overlay = overlay;
  if (output_.remedy) line.remedy = output_.remedy(overlay.validity);
  if (overlay.level() != Level::valid) figures_["frames_" + reason] += 1.0;
  if (overlay.mask) {
    figures_["frames_with_mask"] += 1.0;
    figures_["points_held_out"] += overlay.mask->held_out;
  }
  for (const LesionVerdict& verdict : overlay.lesions) {
    const std::string lesion = structure_name(verdict.lesion);
    figures_[lesion + "_frames_" + level_code(verdict.level)] += 1.0;
  }
  if (overlay.nodes_in_camera.rows() > 0) {
    Registration carried = registration::carried_to(model_, carried_, overlay.nodes_in_camera);
    carried.residual = overlay.residual;
    line.camera_from_model = carried.camera_from_ct.matrix();
    Eigen::Matrix4d pose = *line.camera_from_model;
    pose.topRightCorner<3, 1>() /= metres_per(output_.unit);
    const auto mark = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
    // As the registration's doubts: what is said is a field's name.
    NamedArrays marks = {{"camera_from_model", pose},
                         {"frame", mark(number)},
                         {"level_" + level, mark(1.0)},
                         {"reason_" + reason, mark(1.0)}};
    if (overlay.doubtful) marks["doubtful"] = mark(1.0);
    line.mesh = "registered_" + padded(number, output_.digits) + "." + output_.ending;
    output_.write_mesh(output_.folder / line.mesh, carried, marks);
    if (output_.truth) compare(number, overlay);
  }
  lines_ += overlay_line(line) + "\n";
}

void TrackRecord::add(const CorrectionMade& made) {
  lines_ += correction_line(made) + "\n";
  figures_["corrections"] += 1.0;
}

void TrackRecord::add_undone(const OverlayFrame& overlay) {
  lines_ += undone_line(overlay.index, overlay.seconds) + "\n";
  figures_["corrections_undone"] += 1.0;
}

void TrackRecord::add(const AgainLine& again) {
  lines_ += again_line(again) + "\n";
  figures_["registered_again"] += 1.0;
  figures_["registered_again_taken"] += again.is_taken ? 1.0 : 0.0;
}

void TrackRecord::finish(bool whole) {
  lines_ += overlay_record_end(whole, frames()) + "\n";
  write_file_atomically(output_.folder / "frames.jsonl", lines_);
  figures_["complete"] = whole ? 1.0 : 0.0;
  append(figures_, evaluation_.times().counts());
  append(figures_, evaluation_.times().percentiles());
  append(figures_, evaluation_.displacement());
  if (!output_.truth) return;
  append(figures_, evaluation_.errors());
  figures_["frames_compared"] = evaluation_.compared();
}

void TrackRecord::compare(int number, const OverlayFrame& overlay) {
  const fs::path path = output_.truth(number);
  if (!fs::exists(path)) return;  // truth may be given for some frames only
  const Points truth = read_true_nodes(path, output_.unit);
  const Figures errors = evaluation_.compare(overlay, truth, path.string());
  figures_["frame_" + padded(number, output_.digits) + "_tre_volume_mean_mm"] =
      errors.at("tre_volume_mean_mm");
}

namespace {

/// Whether a file has the name of a frame's mesh, as TrackRecord gives it: registered_NUMBER.vtu or .vtp.
bool is_mesh_of_frame(std::string_view name) {
  constexpr std::string_view kBegin = "registered_";
  if (!name.starts_with(kBegin) || !(name.ends_with(".vtu") || name.ends_with(".vtp"))) return false;
  const std::string_view number = name.substr(kBegin.size(), name.size() - kBegin.size() - 4);
  return !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

void remove_former_meshes(const std::filesystem::path& folder, const std::filesystem::path& fresh) {
  namespace fs = std::filesystem;
  const fs::path list = folder / "frames.jsonl";
  std::error_code failure;
  if (!fs::is_regular_file(list, failure)) return;
  OverlayRecord former;
  try {
    former = read_overlay_record(list);
  } catch (const Error&) {
    return;  // no list of ours
  }
  for (const OverlayLine& line : former.frames) {
    const fs::path mesh = folder / line.mesh;
    // Only what has a name that is given here: anybody may have written the list.
    if (!is_mesh_of_frame(line.mesh)) continue;
    const bool is_file = fs::is_regular_file(fs::symlink_status(mesh, failure));
    if (is_file && !fs::exists(fresh / line.mesh, failure)) fs::remove(mesh, failure);
  }
}

}  // namespace glisson::experiments
