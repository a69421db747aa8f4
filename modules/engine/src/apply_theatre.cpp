// SPDX-License-Identifier: GPL-3.0-or-later
// From the pictures to the registration: calibration, frames, cloud, initial registration, and the follower.
#include "apply_parts.h"
#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"
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

/// Operations that an earlier registration has simulated on the same model.
registration::KnownOperations known_operations(const CaseState& state) {
  const auto& known = state.operations;
  if (!known || known->model != state.model || known->landmarks != state.landmarks) return {};
  return {known->options, known->prior};
}

void add_figures(Figures& figures, const registration::Registered& made) {
  const Registration& registration = made.registration;
  if (made.rigid_residual) figures["rigid_residual_mm"] = 1e3 * *made.rigid_residual;
  if (made.operations) {
    figures["operations_simulated"] = made.operations->operations;
    figures["operations_motion_mean_mm"] = 1e3 * made.operations->mean_motion;
  }
  figures["displacement_mean_mm"] = 1e3 * made.displacement.mean;
  figures["displacement_max_mm"] = 1e3 * made.displacement.maximum;
  figures["registration_residual_mm"] = 1e3 * registration.residual;
  figures["registration_seen_share"] = registration.seen_share;
  figures["registration_steps"] = registration.steps;
  figures["registration_plateaus"] = registration.plateaus;
  figures["registration_converged"] = registration.termination == Termination::converged ? 1.0 : 0.0;
}

}  // namespace

Cancellable<Applied> apply_one(const CaseState& state, const Register& command, const RunContext& context) {
  require_part(state, Part::model, "Build or import a model first");
  require_part(state, Part::cloud, "Reconstruct or import a cloud first");
  const registration::KnownOperations known = known_operations(state);
  auto made = registration::register_model(effective_model(state), *state.cloud, command, context, known);
  if (!made) return {};
  Applied applied;
  applied.state = state;
  add_figures(applied.figures, *made);
  applied.notes = made->registration.doubts;
  if (made->operations && made->operations != known.prior)
    applied.state.operations = std::make_shared<const SimulatedOperations>(
        SimulatedOperations{state.model, state.landmarks, command.operation, std::move(made->operations)});
  applied.state.registration = std::make_shared<const Registration>(std::move(made->registration));
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
