// SPDX-License-Identifier: GPL-3.0-or-later
// From the pictures to the registration: calibration, frames, cloud, initial registration, and the follower.
#include <algorithm>
#include <cstdio>

#include "apply_parts.h"
#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/labelling.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/source.h"

namespace glisson::engine {
namespace {

class TrackerFollower : public Follower {
 public:
  TrackerFollower(const CaseState& state, const StartTracking& command)
      : tracker_(effective_model(state), *state.registration, command.options),
        steps_per_cloud_(command.steps_per_cloud) {
    if (command.source == StartTracking::Source::frames)
      tracker_.begin(*state.rig, state.frame->frame, state.frame->mask);
  }
  OverlayFrame follow(const LiveInput& input) override {
    if (const auto* cloud = std::get_if<IndexedCloud>(&input))
      return tracker_.follow(cloud->cloud, cloud->index, cloud->seconds, steps_per_cloud_);
    return tracker_.follow(std::get<StereoFrame>(input));
  }

 private:
  guidance::Tracker tracker_;
  int steps_per_cloud_;
};

void require_rig_fits(const CaseState& state) {
  if (!state.rig || !state.frame) return;
  const Picture& left = state.frame->frame.left;
  if (left.width == state.rig->left.width && left.height == state.rig->left.height) return;
  throw InputError("calibration", "image_width, image_height",
                   "is for pictures of " + std::to_string(state.rig->left.width) + "x" +
                       std::to_string(state.rig->left.height) + ", the pictures are " +
                       std::to_string(left.width) + "x" + std::to_string(left.height),
                   "Use the calibration of this scope at this resolution");
}

/// @param mask the file that the mask was read from, where there is one.
Cancellable<Applied> with_frame(const CaseState& state, StereoInput input,
                                const std::filesystem::path& mask) {
  if (input.frame.left.width != input.frame.right.width ||
      input.frame.left.height != input.frame.right.height)
    throw InputError("stereo pair", "size", "left and right pictures differ in size",
                     "Give two pictures of one moment of one scope");
  if (!input.mask.empty() &&
      (input.mask.width != input.frame.left.width || input.mask.height != input.frame.left.height))
    throw InputError(mask.string(), "size",
                     "is " + std::to_string(input.mask.width) + "x" + std::to_string(input.mask.height) +
                         ", the left picture " + std::to_string(input.frame.left.width) + "x" +
                         std::to_string(input.frame.left.height),
                     "Give the mask of this left picture");
  Applied applied;
  applied.state = state;
  // A calibration of another size is told where the two are used: either may be the one that comes next.
  applied.state.frame = std::make_shared<const StereoInput>(std::move(input));
  return applied;
}

/// Simulated now, or for an earlier registration of the same model.
Cancellable<std::shared_ptr<const SimulatedOperations>> operations_of(
    const CaseState& state, const PatientModel& model, const registration::OperationOptions& options,
    const RunContext& context) {
  const auto& known = state.operations;
  if (known && known->model == state.model && known->landmarks == state.landmarks &&
      known->options == options)
    return known;
  auto prior = registration::simulate_operations(model, options, context);
  if (!prior) return {};
  return std::make_shared<const SimulatedOperations>(
      SimulatedOperations{state.model, state.landmarks, options,
                          std::make_shared<const registration::OperationPrior>(std::move(*prior))});
}

}  // namespace

namespace {

/// How the case's pictures were cut out of a video's views; empty: they were not.
struct Cut {
  int whole_width = 0, whole_height = 0;  ///< of a view
  stereo::Crop crop;
};
std::optional<Cut> cut_of(const CaseState& state) {
  if (!state.video || !state.video->right.empty() || state.video->left.extension() != ".json") return {};
  const stereo::SourceOptions source = stereo::read_source(state.video->left);
  if (!source.crop.any()) return {};
  const stereo::StereoVideo video(source);
  if (state.frame &&
      (state.frame->frame.left.width != video.width() || state.frame->frame.left.height != video.height()))
    return {};  // the pair is another one
  return Cut{video.whole_width(), video.whole_height(), source.crop};
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const SetCalibration& command, const RunContext&) {
  const bool plain_text = std::filesystem::is_directory(command.path);
  // Plain text files do not tell the pictures' size.
  if (plain_text) require_part(state, Part::frame, "Load a stereo pair first: its size is needed");
  const auto cut = cut_of(state);
  StereoRig rig;
  if (plain_text)
    rig = stereo::read_text_calibration(command.path, cut ? cut->whole_width : state.frame->frame.left.width,
                                        cut ? cut->whole_height : state.frame->frame.left.height);
  else
    rig = stereo::read_calibration(command.path);
  // Scopes are calibrated on whole views.
  if (cut && rig.left.width == cut->whole_width && rig.left.height == cut->whole_height)
    rig = stereo::cropped(rig, cut->crop);
  Applied applied;
  applied.state = state;
  applied.state.rig = std::make_shared<const StereoRig>(std::move(rig));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const LoadStereoPair& command, const RunContext&) {
  StereoInput input;
  input.frame.left = stereo::read_picture(command.left);
  input.frame.right = stereo::read_picture(command.right);
  if (!command.mask.empty()) input.mask = stereo::read_picture(command.mask);
  return with_frame(state, std::move(input), command.mask);
}

Cancellable<Applied> apply_one(const CaseState& state, const SetVideo& command, const RunContext&) {
  const stereo::StereoVideo video(command.left, command.right);  // refused here, not at the first frame
  Applied applied;
  applied.state = state;
  applied.state.video = std::make_shared<const VideoSource>(VideoSource{command.left, command.right});
  applied.figures["video_frames"] = video.frame_count();
  applied.figures["video_frames_per_second"] = video.frames_per_second();
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const LoadVideoFrame& command,
                               const RunContext& context) {
  require_part(state, Part::video, "Open a stereo video first");
  stereo::StereoVideo video(state.video->left, state.video->right);
  StereoInput input;
  if (!command.mask.empty()) input.mask = stereo::read_picture(command.mask);
  for (int i = 0; i <= command.index; ++i) {
    if (context.cancelled()) return {};
    if (!video.read(input.frame))
      throw InputError(state.video->left.string(), "frame " + std::to_string(command.index),
                       "the video has only " + std::to_string(i) + " frames", "Choose an earlier frame");
    context.progress(static_cast<double>(i + 1) / (command.index + 1), "video.seek");
  }
  return with_frame(state, std::move(input), command.mask);
}

Cancellable<Applied> apply_one(const CaseState& state, const SetRegions& command, const RunContext&) {
  require_part(state, Part::frame, "Load a stereo pair first: regions are clicked on it");
  Applied applied;
  applied.state = state;
  const StereoFrame& frame = state.frame->frame;
  stereo::require_regions_of(command.regions, frame.left, frame.right);
  stereo::Regions regions = command.regions;
  if (regions.identity.empty()) regions.identity = stereo::frame_identity(frame.left, frame.right);
  applied.state.regions = std::make_shared<const stereo::Regions>(std::move(regions));
  return applied;
}

namespace {

/// Reconstructed now, or for an earlier command on the same pair.
Cancellable<std::shared_ptr<const stereo::Reconstructed>> points_of(const CaseState& state,
                                                                    const stereo::ReconstructOptions& options,
                                                                    const RunContext& context) {
  const auto& known = state.points;
  if (known && known->frame == state.frame && known->rig == state.rig && known->options == options)
    return known->whole;
  const StereoInput& input = *state.frame;
  try {
    auto made = stereo::reconstruct(input.frame.left, input.frame.right, *state.rig, input.mask, {}, options,
                                    context);
    if (!made) return {};
    return std::make_shared<const stereo::Reconstructed>(std::move(*made));
  } catch (const InputError&) {
    // Where the pair itself is at fault, that is the better answer.
    stereo::require_sound(stereo::check_pair(input.frame.left, input.frame.right, *state.rig));
    throw;
  }
}

/// Dense ones, where the sparse ones are too few; null: the pair has too few of those, too.
Cancellable<std::shared_ptr<const stereo::Reconstructed>> dense_points_of(const CaseState& state,
                                                                          stereo::ReconstructOptions options,
                                                                          const RunContext& context) {
  options.method = stereo::Method::dense;
  try {
    return points_of(state, options, context);
  } catch (const InputError&) {
    return std::shared_ptr<const stereo::Reconstructed>();
  }
}

/// What is wrong with the pair, as notes. Looked for where the points give cause to: it takes a second.
std::vector<std::string> fault_notes(const CaseState& state, const PairPoints& points) {
  constexpr double kRowsOff = 3.0;  // pixels
  const bool suspicious = std::abs(points.whole->report.row_offset_px) > kRowsOff ||
                          points.density_per_cm2 < points.options.least_density_per_cm2;
  std::vector<std::string> notes;
  if (!suspicious) return notes;
  const StereoFrame& frame = state.frame->frame;
  for (const stereo::Fault fault : stereo::check_pair(frame.left, frame.right, *state.rig).faults)
    notes.push_back("stereo." + std::string(stereo::fault_code(fault)));
  return notes;
}

void add_figures(Figures& figures, const PairPoints& points, const LabelledCloud& cloud) {
  const stereo::ReconstructReport& report = points.whole->report;
  figures["cloud_features_left"] = report.features_left;
  figures["cloud_features_right"] = report.features_right;
  figures["cloud_matches"] = report.matches;
  figures["cloud_points"] = cloud.size();
  figures["cloud_area_cm2"] = points.area_cm2;
  figures["cloud_density_per_cm2"] = points.density_per_cm2;
  figures["cloud_covered_share"] = points.density.covered;
  figures["cloud_row_offset_px"] = report.row_offset_px;
  figures["cloud_epipolar_rms_px"] = report.epipolar_rms_px;
  figures["cloud_sigma_median_mm"] = 1e3 * report.sigma_median;
  figures["cloud_dense"] = report.method == stereo::Method::dense ? 1.0 : 0.0;
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const Reconstruct& command,
                               const RunContext& context) {
  require_part(state, Part::rig, "Load the laparoscope's calibration first");
  require_part(state, Part::frame, "Load a stereo pair first");
  require_rig_fits(state);
  const stereo::Regions regions = state.regions ? *state.regions : stereo::Regions{};
  stereo::require_regions_of(regions, state.frame->frame.left, state.frame->frame.right);
  const bool labels = !regions.regions.empty();
  const bool may_be_dense = labels && command.options.method == stereo::Method::automatic;
  auto whole = points_of(state, command.options, context.part(0.0, may_be_dense ? 0.6 : 1.0));
  if (!whole) return {};
  stereo::LabelledPart part = stereo::labelled_part((*whole)->cloud, *state.rig, state.frame->mask, regions);
  if (may_be_dense && (*whole)->report.method == stereo::Method::sparse &&
      part.density_per_cm2 < command.options.least_density_per_cm2) {
    // From here on this pair's points stay dense whatever its regions become: a switch there and back would
    // exchange points under the operator's hand. The next pair is judged anew.
    const auto dense = dense_points_of(state, command.options, context.part(0.6, 1.0));
    if (!dense) return {};
    if (*dense) {
      stereo::LabelledPart denser =
          stereo::labelled_part((*dense)->cloud, *state.rig, state.frame->mask, regions);
      if (denser.density_per_cm2 > part.density_per_cm2) whole = dense, part = std::move(denser);
    }
  }
  if (part.cloud.size() == 0)
    throw InputError("regions", "",
                     "hold none of the pair's " + std::to_string((*whole)->cloud.size()) + " points",
                     "Draw them where the liver is reconstructed, or reconstruct densely");
  PairPoints points{state.frame,
                    state.rig,
                    command.options,
                    *whole,
                    part.area_cm2,
                    part.density_per_cm2,
                    stereo::density_map(part.cloud, state.rig->left, state.frame->mask, regions),
                    stereo::frame_identity(state.frame->frame.left, state.frame->frame.right)};
  if (!labels) {
    points.area_cm2 = (*whole)->report.area_cm2;
    points.density_per_cm2 = (*whole)->report.density_per_cm2;
  }
  Applied applied;
  applied.state = state;
  add_figures(applied.figures, points, part.cloud);
  applied.notes = fault_notes(state, points);
  applied.state.cloud = std::make_shared<const LabelledCloud>(std::move(part.cloud));
  applied.state.points = std::make_shared<const PairPoints>(std::move(points));
  return applied;
}

namespace {

/// Half of a cloud's points lie within this of its middle, metres. Outliers do not count.
double spread(const Points& points) {
  const auto median = [](std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  Eigen::RowVector3d centre;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::VectorXd column = points.col(axis);
    centre[axis] = median({column.begin(), column.end()});
  }
  const Eigen::VectorXd distances = (points.rowwise() - centre).rowwise().norm();
  return median({distances.begin(), distances.end()});
}

/// A cloud shows some of a liver: from a few millimetres of it to all.
void require_cloud_of_a_liver(const LabelledCloud& cloud, LengthUnit unit, const std::string& name) {
  constexpr double kSmallest = 1e-3, kLargest = 0.3;
  if (cloud.size() == 0) return;
  const double found = spread(cloud.points);
  if (found <= kLargest && (found >= kSmallest || cloud.size() < 10)) return;
  std::string remedy = "Check what the file holds";
  for (const LengthUnit other : {LengthUnit::metre, LengthUnit::centimetre, LengthUnit::millimetre}) {
    const double read_so = found / metres_per(unit) * metres_per(other);
    if (read_so <= kLargest && read_so >= kSmallest) remedy = std::string("Read it in ") + unit_code(other);
  }
  char problem[160];
  std::snprintf(problem, sizeof problem,
                "half of its points lie within %.3g m of its middle when read in %s, which is no liver",
                found, unit_code(unit));
  throw InputError(name, "size", problem, remedy);
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const ImportCloud& command, const RunContext&) {
  Applied applied;
  applied.state = state;
  auto cloud = std::make_shared<const LabelledCloud>(read_cloud(command.path, command.unit));
  require_cloud_of_a_liver(*cloud, command.unit, command.path.string());
  applied.state.cloud = std::move(cloud);
  applied.state.points = nullptr;
  applied.figures["cloud_points"] = applied.state.cloud->size();
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const Register& command, const RunContext& context) {
  require_part(state, Part::model, "Build or import a model first");
  require_part(state, Part::cloud, "Reconstruct or import a cloud first");
  const PatientModel model = effective_model(state);
  Applied applied;
  applied.state = state;
  CameraFromCt start = command.start == Register::Start::given ? command.given : CameraFromCt{};
  std::vector<std::string> doubts;
  std::vector<CameraFromCt> other_starts;
  double begun = 0.0;  ///< share of the work that is done
  if (command.start == Register::Start::automatic) {
    auto rigid = registration::align_rigid(model, *state.cloud, command.rigid, context.part(0.0, 0.2));
    if (!rigid) return {};
    start = rigid->camera_from_ct;
    doubts = rigid->doubts;
    other_starts = rigid->alternatives;
    begun = 0.2;
    applied.figures["rigid_residual_mm"] = 1e3 * rigid->residual;
  }
  registration::ElasticOptions elastic = command.elastic;
  if (command.operations && !elastic.prior && elastic.fixed_nodes.empty() &&
      registration::can_simulate_operations(model)) {
    auto operations = operations_of(state, model, command.operation, context.part(begun, 0.7));
    if (!operations) return {};
    begun = 0.7;
    applied.state.operations = *operations;
    elastic.prior = (*operations)->prior;
    applied.figures["operations_simulated"] = elastic.prior->operations;
    applied.figures["operations_motion_mean_mm"] = 1e3 * elastic.prior->mean_motion;
    elastic.other_starts = other_starts;
  }
  auto registered =
      registration::register_elastic(model, *state.cloud, start, elastic, context.part(begun, 1.0));
  if (!registered) return {};
  registered->doubts.insert(registered->doubts.begin(), doubts.begin(), doubts.end());
  const Points rigid_nodes = registered->camera_from_ct.apply(model.mesh.vertices);
  const DistanceSummary moved = point_errors(registered->nodes_in_camera, rigid_nodes);
  applied.figures["displacement_mean_mm"] = 1e3 * moved.mean;
  applied.figures["displacement_max_mm"] = 1e3 * moved.maximum;
  applied.figures["registration_residual_mm"] = 1e3 * registered->residual;
  applied.figures["registration_seen_share"] = registered->seen_share;
  applied.figures["registration_steps"] = registered->steps;
  applied.figures["registration_plateaus"] = registered->plateaus;
  applied.figures["registration_converged"] = registered->termination == Termination::converged ? 1.0 : 0.0;
  applied.notes = registered->doubts;
  applied.state.registration = std::make_shared<const Registration>(std::move(*registered));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const ImportRegistration& command, const RunContext&) {
  require_part(state, Part::model, "Build or import a model first");
  Applied applied;
  applied.state = state;
  applied.state.registration =
      std::make_shared<const Registration>(read_registration(command.path, state.model->model, command.unit));
  return applied;
}

std::unique_ptr<Follower> make_follower(const CaseState& state, const StartTracking& command) {
  require_part(state, Part::model, "Build or import a model first");
  require_part(state, Part::registration, "Register the model first");
  if (stage_state(state, Part::registration) == StageState::stale) {
    // Registered again on what is out of date itself, it would stay so.
    for (const Part input : {Part::model, Part::landmarks, Part::cloud})
      if (stage_state(state, input) == StageState::stale)
        throw InputError("case", std::string(part_code(input)),
                         "is stale: something that it was made from has changed",
                         "Make it anew, then register again");
    throw InputError("case", "registration", "is stale: something that it was made from has changed",
                     "Register again");
  }
  if (command.source == StartTracking::Source::frames) {
    require_part(state, Part::rig, "Load the laparoscope's calibration first");
    require_part(state, Part::frame, "Load the stereo pair that was registered first");
    require_rig_fits(state);
  }
  return std::make_unique<TrackerFollower>(state, command);
}

}  // namespace glisson::engine
