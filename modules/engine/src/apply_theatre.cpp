// SPDX-License-Identifier: GPL-3.0-or-later
// From the pictures to the registration: calibration, frames, cloud, initial registration, and the follower.
#include "apply_parts.h"
#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"
#include "glisson/geometry/distance.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reconstruct_pair.h"
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

/// @param mask the file that the mask was read from, where there is one.
Cancellable<Applied> with_frame(const CaseState& state, StereoInput input,
                                const std::filesystem::path& mask) {
  stereo::require_one_size(input.frame, input.mask, mask.string());
  Applied applied;
  applied.state = state;
  // A calibration of another size is told where the two are used: either may be the one that comes next.
  applied.state.frame = std::make_shared<const StereoInput>(std::move(input));
  return applied;
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const SetCalibration& command, const RunContext&) {
  if (stereo::is_text_calibration(command.path))
    require_part(state, Part::frame, "Load a stereo pair first: its size is needed");
  const int width = state.frame ? state.frame->frame.left.width : 0;
  const int height = state.frame ? state.frame->frame.left.height : 0;
  std::optional<stereo::Cut> cut;
  if (state.video && state.video->right.empty()) cut = stereo::cut_of(state.video->left, width, height);
  StereoRig rig = stereo::read_calibration_for(command.path, width, height, cut);
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

/// Points that an earlier command has made of the same pair.
stereo::KnownPoints known_points(const CaseState& state) {
  const auto& known = state.points;
  if (!known || known->frame != state.frame || known->rig != state.rig) return {};
  return {known->options, known->whole};
}

void add_figures(Figures& figures, const stereo::PairCloud& made) {
  const stereo::ReconstructReport& report = made.whole->report;
  figures["cloud_features_left"] = report.features_left;
  figures["cloud_features_right"] = report.features_right;
  figures["cloud_matches"] = report.matches;
  figures["cloud_points"] = made.part.cloud.size();
  figures["cloud_area_cm2"] = made.part.area_cm2;
  figures["cloud_density_per_cm2"] = made.part.density_per_cm2;
  figures["cloud_covered_share"] = made.density.covered;
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
  const stereo::PairInput input{state.frame->frame, *state.rig, state.frame->mask,
                                state.regions ? *state.regions : stereo::Regions{}};
  auto made = stereo::reconstruct_pair(input, command.options, context, known_points(state));
  if (!made) return {};
  Applied applied;
  applied.state = state;
  add_figures(applied.figures, *made);
  for (const stereo::Fault fault : made->faults)
    applied.notes.push_back("stereo." + std::string(stereo::fault_code(fault)));
  applied.state.points = std::make_shared<const PairPoints>(
      PairPoints{state.frame, state.rig, command.options, std::move(made->whole), made->part.area_cm2,
                 made->part.density_per_cm2, std::move(made->density), std::move(made->frame_identity)});
  applied.state.cloud = std::make_shared<const LabelledCloud>(std::move(made->part.cloud));
  return applied;
}

Cancellable<Applied> apply_one(const CaseState& state, const ImportCloud& command, const RunContext&) {
  Applied applied;
  applied.state = state;
  auto cloud = std::make_shared<const LabelledCloud>(read_cloud(command.path, command.unit));
  require_liver_sized(*cloud, command.unit, command.path.string());
  applied.state.cloud = std::move(cloud);
  applied.state.points = nullptr;
  applied.figures["cloud_points"] = applied.state.cloud->size();
  return applied;
}

namespace {

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
    stereo::require_rig_of(*state.rig, state.frame->frame.left);
  }
  return std::make_unique<TrackerFollower>(state, command);
}

}  // namespace glisson::engine
