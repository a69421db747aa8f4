// SPDX-License-Identifier: GPL-3.0-or-later
// What follows the operation: the tracker on the case's parts.
#include "glisson/core/error.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/tissue.h"
#include "glisson/network/live_mask.h"
#include "glisson/stereo/faults.h"

namespace glisson::engine {
namespace {

/// The mechanics by which this model is registered, too.
guidance::TrackerOptions tracker_options(const CaseState& state, const PatientModel& model,
                                         const StartTracking& command) {
  guidance::TrackerOptions options = command.options;
  const registration::ElasticOptions own =
      registration::options_for(model, state[part::landmarks] != nullptr);
  options.cloud.final_stiffening = own.final_stiffening;
  options.cloud.tangential = own.tangential;
  options.materials = options.cloud.materials = fem::with_tissue(
      command.materials.value_or(own.materials), tissue_of(state, !command.materials), model.mesh);
  return options;
}

class TrackerFollower : public Follower {
 public:
  TrackerFollower(const CaseState& state, const PatientModel& model, const StartTracking& command)
      : tracker_(model, *state[part::registration], tracker_options(state, model, command)),
        steps_per_cloud_(command.steps_per_cloud),
        mask_every_(command.mask.every) {
    if (command.source == StartTracking::Source::clouds) return;
    const StereoFrame& first = state[part::frame]->frame;
    if (!command.mask.network.empty()) mask_by(command.mask.network);
    look_at_mask(first);
    if (mask_every_ > 0 && mask_) mask_->require_well();
    tracker_.begin(*state[part::rig], first, state[part::frame]->mask);
  }
  OverlayFrame follow(const LiveInput& input) override {
    if (const auto* cloud = std::get_if<IndexedCloud>(&input))
      return tracker_.follow(cloud->cloud, cloud->index, cloud->seconds, steps_per_cloud_);
    const StereoFrame& frame = std::get<StereoFrame>(input);
    look_at_mask(frame);
    return tracker_.follow(frame);
  }
  void set_mask_network(const std::filesystem::path& network) override {
    mask_every_ = 0;
    mask_by(network);
  }
  std::optional<MaskStatus> mask_status() const override {
    if (!mask_) return {};
    return MaskStatus{mask_->network(), mask_->age(now_), mask_used_, mask_->problem()};
  }
  OverlayFrame correct(const Correction& correction) override { return tracker_.correct(correction); }
  OverlayFrame undo_correction() override { return tracker_.undo_correction(); }
  std::vector<CorrectionMade> corrections() const override { return tracker_.corrections(); }
  OverlayFrame take(const Registration& registration) override { return tracker_.take(registration); }
  std::shared_ptr<const LabelledCloud> tissue_at_start() override { return tracker_.tissue_at_start(); }

 private:
  void mask_by(const std::filesystem::path& network) {
    mask_.reset();
    if (!network.empty()) mask_ = std::make_unique<network::LiveMask>(network);
  }
  void look_at_mask(const StereoFrame& frame) {
    now_ = frame.seconds;
    if (mask_ && (mask_every_ == 0 || frames_++ % mask_every_ == 0)) {
      mask_->offer(frame);
      if (mask_every_ > 0) mask_->wait();
    }
    auto mask = mask_ ? mask_->usable(frame.seconds) : nullptr;
    mask_used_ = mask != nullptr;
    tracker_.see(std::move(mask));
  }

  guidance::Tracker tracker_;
  int steps_per_cloud_;
  std::unique_ptr<network::LiveMask> mask_;
  int mask_every_ = 0, frames_ = 0;
  bool mask_used_ = false;
  double now_ = 0.0;
};

}  // namespace

OverlayFrame Follower::correct(const Correction&) {
  throw InputError("correction", "the organ", "is not followed in pictures", "Track a stereo video");
}

OverlayFrame Follower::undo_correction() {
  throw InputError("correction", "the last one", "is none", "Correct first");
}

OverlayFrame Follower::take(const Registration&) {
  throw InputError("registration", "the organ", "is not followed in pictures", "Track a stereo video");
}

void Follower::set_mask_network(const std::filesystem::path&) {
  throw InputError("mask network", "the organ", "is not followed in pictures", "Track a stereo video");
}

std::unique_ptr<Follower> make_follower(const CaseState& state, const StartTracking& command) {
  require(state.has(part::model) && state.has(part::registration), "a registered model is followed");
  if (command.source != StartTracking::Source::clouds)
    stereo::require_rig_of(*state[part::rig], state[part::frame]->frame.left);
  return std::make_unique<TrackerFollower>(state, effective_model(state), command);
}

}  // namespace glisson::engine
