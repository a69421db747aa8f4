// SPDX-License-Identifier: GPL-3.0-or-later
#include "fake_operation.h"

#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/choose_rival.h"
#include "glisson/engine/commands/correct_tracking.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/keep_copy.h"
#include "glisson/engine/commands/list_series.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/read_image.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/register_again.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_mask_network.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/take_registration.h"
#include "glisson/engine/commands/undo_correction.h"
#include "glisson/engine/commands/undo_registration.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/engine/parts/named_video.h"
#include "glisson/engine/parts/other_registration.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"

namespace glisson {

namespace {
class Breathing : public engine::Follower {
 public:
  Breathing(Points nodes, const std::atomic<Validity>& validity, std::atomic<bool>& fails,
            std::optional<engine::MaskStatus> mask, const std::atomic<bool>& mask_is_removed)
      : nodes_(std::move(nodes)),
        mask_(std::move(mask)),
        validity_(validity),
        fails_(fails),
        mask_is_removed_(mask_is_removed) {}
  std::optional<engine::MaskStatus> mask_status() const override {
    return mask_is_removed_ ? std::nullopt : mask_;
  }
  OverlayFrame follow(const engine::LiveInput& input) override {
    const auto& frame = std::get<StereoFrame>(input);
    if (fails_.exchange(false)) throw NumericalError("the mechanics: no solution. Start tracking again.");
    OverlayFrame overlay;
    overlay.index = frame.index;
    overlay.seconds = frame.seconds;
    overlay.validity = validity_;
    overlay.nodes_in_camera = nodes_.rowwise() + Eigen::RowVector3d(0, 3e-3 * std::sin(0.2 * frame.index), 0);
    overlay.tracked_left = 200;
    overlay.tracked_right = 196;
    overlay.pairs = 181;
    LesionVerdict lesion;
    lesion.lesion = structure::kFirstLesion;
    lesion.level = overlay.level();
    lesion.reason = lesion.level == Level::valid ? LesionReason::known : LesionReason::with_the_whole;
    lesion.centre = overlay.nodes_in_camera.colwise().mean().transpose();
    lesion.radius = 6e-3;
    lesion.covariance = 4e-6 * Eigen::Matrix3d::Identity();
    lesion.expected = 3.2e-3;
    lesion.reach = 5.6e-3;
    lesion.support = 24e-3;
    overlay.lesions = {lesion};
    if (mask_ && mask_->is_used) overlay.mask = MaskUse{0.25, *mask_->age, 12};
    overlay.residual = 0.8e-3;
    overlay.milliseconds = 12.0;
    last_ = overlay;
    return handled();
  }
  /// It goes as a whole, to the right only, as far as a pixel is at 120 mm.
  OverlayFrame correct(const Correction& correction) override {
    const double right = 0.12 / 260.0 * (correction.to - correction.from).x();
    if (std::abs(right) > 0.05)
      throw InputError("correction", "the place", "would be outside of the picture",
                       "Drag to where the picture shows it");
    const bool goes_on = !made_.empty() && made_.back().correction.gesture == correction.gesture;
    if (!goes_on) made_.emplace_back();
    made_.back().correction = correction;
    made_.back().frame = last_.index;
    made_.back().moved += right;
    return handled();
  }
  OverlayFrame undo_correction() override {
    if (made_.empty()) return Follower::undo_correction();
    made_.pop_back();
    return handled();
  }
  std::vector<CorrectionMade> corrections() const override { return made_; }
  OverlayFrame take(const Registration& registration) override {
    const Points change = registration.nodes_in_camera - nodes_;
    nodes_ = registration.nodes_in_camera;
    last_.nodes_in_camera += change;
    made_.clear();
    return handled();
  }

 private:
  OverlayFrame handled() const {
    OverlayFrame overlay = last_;
    for (const CorrectionMade& made : made_) overlay.nodes_in_camera.col(0).array() += made.moved;
    return overlay;
  }

  Points nodes_;
  OverlayFrame last_;
  std::vector<CorrectionMade> made_;
  std::optional<engine::MaskStatus> mask_;
  const std::atomic<Validity>& validity_;
  std::atomic<bool>& fails_;
  const std::atomic<bool>& mask_is_removed_;
};
}  // namespace

std::vector<engine::Command> FakeOperation::steps_to_cloud(const std::filesystem::path& scope, int frames) {
  film(scope, frames);
  return {engine::ImportImage{"ct.nii"},
          engine::SetSeeds{},
          engine::Segment{},
          engine::BuildModel{},
          engine::SetCalibration{"scope.yml"},
          engine::SetVideo{video, {}},
          engine::LoadVideoFrame{2},
          engine::Reconstruct{}};
}

engine::Engine::Options FakeOperation::options() {
  engine::Engine::Options options;
  options.apply = [this](const engine::CaseState& state, const engine::Command& command,
                         const RunContext& context, const engine::Services& services) {
    const bool is_of_follower =
        command.as<engine::CorrectTracking>() || command.as<engine::UndoCorrection>() ||
        command.as<engine::SetMaskNetwork>() || command.as<engine::TakeRegistration>();
    if (command.traits().live != engine::LiveLane::none || is_of_follower)
      return engine::apply(state, command, context, services);
    return apply(state, command, context);
  };
  options.make_follower = [this](const engine::CaseState& state, const engine::StartTracking&) {
    return std::make_unique<Breathing>(state[part::registration]->nodes_in_camera, live_validity,
                                       next_frame_fails, mask, mask_is_removed);
  };
  return options;
}

namespace {

/// What every frame of a size shows: tissue in the light of a lamp, blue, green, red.
const std::vector<std::uint8_t>& still(int width, int height) {
  static std::map<std::pair<int, int>, std::vector<std::uint8_t>> known;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::vector<std::uint8_t>& bytes = known[{width, height}];
  if (!bytes.empty()) return bytes;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const double r =
          std::hypot((u % (width / 2)) / (0.5 * width) - 0.5, static_cast<double>(v) / height - 0.5);
      const double tissue = 15.0 * std::sin(0.13 * u + 0.3 * std::sin(0.05 * v)) * std::sin(0.11 * v);
      const double light = std::max(0.1, 1.0 - 1.4 * r * r);
      for (const double grey : {55 + 0.5 * tissue, 60 + 0.6 * tissue, 150 + 2.0 * tissue})
        bytes.push_back(static_cast<std::uint8_t>(light * grey));
    }
  return bytes;
}

}  // namespace

void FakeOperation::film(const std::filesystem::path& path, int frames) {
  video = path;
  stereo::VideoWriter writer(path, 2 * rig.left.width, rig.left.height, 30.0);
  for (int i = 0; i < frames; ++i) writer.write(picture(2 * rig.left.width, rig.left.height, i));
  writer.close();
}

Picture FakeOperation::picture(int width, int height, int index) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(still(width, height));
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      if ((u + 3 * index) % 200 >= 2) continue;
      const auto i = static_cast<std::size_t>(3 * (v * width + u));
      for (const std::size_t channel : {i, i + 1})
        (*bytes)[channel] = static_cast<std::uint8_t>((*bytes)[channel] + 20);
    }
  return {width, height, 3, bytes};
}

bool FakeOperation::work(const RunContext& context, const char* stage) const {
  int turn = 0;
  do {
    if (context.cancelled()) return false;
    context.progress(std::min(0.4, 0.01 * ++turn), stage);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  } while (hold.load());
  context.progress(1.0, stage);
  return true;
}

Cancellable<engine::Applied> FakeOperation::apply(const engine::CaseState& state,
                                                  const engine::Command& command, const RunContext& context) {
  if (const auto* accept = command.as<engine::AcceptRegistration>()) return accept->apply(state, context);
  if (const auto* choose = command.as<engine::ChooseRival>()) return choose->apply(state, context);
  if (const auto* undo = command.as<engine::UndoRegistration>()) return undo->apply(state, context);
  if (const auto* open = command.as<engine::OpenCase>()) return open->apply(state, context);
  if (command.traits().writes == engine::Parts{part::moments})
    return engine::apply(state, command, context, engine::plain_services());
  if (const auto* keep = command.as<engine::KeepCopy>()) {
    if (!work(context, "case.write")) return {};
    return keep->apply(state, context);
  }
  if (const auto* given = command.as<engine::Register>()) {
    start.reset();
    method = given->method;
    if (given->start == engine::Register::Start::near) start = given->given;
  }
  engine::Applied applied{state};
  const auto done =
      try_change<engine::ImportImage, engine::ImportLabels, engine::ListSeries, engine::ReadImage,
                 engine::SetSeeds, engine::Segment, engine::BuildModel, engine::SetLandmarks,
                 engine::SetCalibration, engine::SetVideo, engine::LoadVideoFrame, engine::SetRegions,
                 engine::Reconstruct, engine::Register, engine::RegisterAgain, engine::SaveCase>(
          applied, command, context);
  if (!done) throw InputError("test", "", "this command is not part of the fake operation", "Use another");
  if (!*done) return {};
  return applied;
}

template <class... C>
std::optional<bool> FakeOperation::try_change(engine::Applied& applied, const engine::Command& command,
                                              const RunContext& context) const {
  std::optional<bool> done;
  const auto attempt = [&](const auto* one) {
    if (one != nullptr) done = change(applied, *one, context);
  };
  (attempt(command.as<C>()), ...);
  return done;
}

void FakeOperation::require_readable(const std::filesystem::path& path) {
  if (path.filename() == "broken.nii" || path.filename() == "broken")
    throw InputError(path.string(), "header", "is cut off after 12 bytes", "Copy the file again");
}

bool FakeOperation::change(engine::Applied& applied, const engine::ReadImage& command,
                           const RunContext&) const {
  require_readable(command.path);
  applied.result = std::make_shared<const Scan>(Scan{ct, {}});
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::ImportImage& command,
                           const RunContext&) const {
  require_readable(command.path);
  if (command.new_case) applied.state = {};
  Image image = ct;
  image.description = command.series;
  if (command.path.filename() == "unknown.nii") image.modality = command.modality.value_or(Modality::other);
  applied.state[part::image] = std::make_shared<const Image>(std::move(image));
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::ImportLabels&, const RunContext&) const {
  applied.notes = {"labels.other_frame"};
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::ListSeries& command,
                           const RunContext&) const {
  std::vector<DicomSeries> series = {{"1.2.3", "2", "portal venous", "CT", 129}};
  if (command.path.filename() == "no_series")
    throw InputError(command.path.string(), "", "holds no DICOM image", "Choose another folder");
  if (command.path.filename() == "two_series") series.push_back({"1.2.4", "3", "arterial", "CT", 90});
  applied.result = std::make_shared<const engine::ListSeries::Result>(std::move(series));
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::SetSeeds& command,
                           const RunContext&) const {
  applied.state[part::seeds] = std::make_shared<const segmentation::Seeds>(command.seeds);
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::Segment&,
                           const RunContext& context) const {
  if (!work(context, "segment.liver")) return false;
  applied.state[part::labels] = std::make_shared<const LabelMap>(labels);
  applied.figures = {{"liver_ml", 1523.4}, {"portal_ml", 24.2}, {"hepatic_ml", 31.9}};
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::BuildModel&,
                           const RunContext& context) const {
  if (!work(context, "mesh.refine")) return false;
  model::BuiltModel built;
  built.model = model;
  built.report.notes = model_notes;
  built.report.quality.vertices = model.mesh.vertex_count();
  built.report.quality.tetrahedra = model.mesh.tetrahedron_count();
  built.report.quality.min_dihedral_deg = 14.2;
  built.report.quality.max_dihedral_deg = 151.0;
  if (knows_organ) built.report.quality.organ_fit = model::OrganFit{volume_error, 0.21, 0.0, 0.0, 4.4};
  applied.state[part::model] = std::make_shared<const model::BuiltModel>(std::move(built));
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::SetLandmarks& command,
                           const RunContext&) const {
  applied.state[part::landmarks] = std::make_shared<const Landmarks>(command.landmarks);
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::SetCalibration&, const RunContext&) const {
  applied.state[part::rig] = std::make_shared<const StereoRig>(rig);
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::SetVideo&, const RunContext&) const {
  applied.state[part::video] = std::make_shared<const engine::VideoSource>(engine::VideoSource{video, {}});
  applied.state[part::named_video] = nullptr;
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::LoadVideoFrame& command,
                           const RunContext&) const {
  engine::StereoInput input;
  input.frame.left = picture(rig.left.width, rig.left.height, command.index);
  input.frame.right = input.frame.left;
  input.frame.index = command.index;
  applied.state[part::frame] = std::make_shared<const engine::StereoInput>(std::move(input));
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::SetRegions& command,
                           const RunContext&) const {
  applied.state[part::regions] = std::make_shared<const stereo::Regions>(command.regions);
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::Reconstruct&,
                           const RunContext& context) const {
  if (!work(context, "stereo.match")) return false;
  LabelledCloud cloud;
  const Points skin = camera_from_ct.apply(model.surface.mesh.vertices);
  cloud.points.resize(skin.rows(), 3);
  Eigen::Index kept = 0;
  const double middle = skin.col(2).mean();
  for (Eigen::Index i = 0; i < skin.rows(); ++i)
    if (skin(i, 2) < middle) cloud.points.row(kept++) = skin.row(i);
  cloud.points.conservativeResize(kept, 3);
  applied.figures = {{"cloud_points", static_cast<double>(kept)}, {"cloud_density_per_cm2", 2.4}};
  applied.state[part::cloud] = std::make_shared<const LabelledCloud>(std::move(cloud));
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::Register&,
                           const RunContext& context) const {
  if (!work(context, "register.elastic")) return false;
  Registration registration;
  registration.camera_from_ct = camera_from_ct;
  registration.nodes_in_camera = camera_from_ct.apply(model.mesh.vertices);
  registration.termination = Termination::converged;
  registration.plateaus = 11;
  registration.residual = 1.1e-3;
  registration.doubts = doubts;
  registration.lesions = {{structure::kFirstLesion, 4e-6 * Eigen::Matrix3d::Identity()}};
  registration.forks = {
      {structure::kPortalVein, 1, 4e-3, {0.0, 0.0, 0.1}, 9e-6 * Eigen::Matrix3d::Identity()}};
  registration.expected = Eigen::VectorXd::LinSpaced(model.mesh.vertex_count(), 1e-3, 13e-3);
  registration.looks = {{structure::kFirstLesion, 6e-3,
                         Eigen::VectorXd::LinSpaced(model.mesh.vertex_count(), 3e-3, 6e-3), 6e-3, 6e-3}};
  if (rival_away > 0.0)
    registration.rivals = {
        {registration.nodes_in_camera.rowwise() + Eigen::RowVector3d(rival_away, 0, 0), 0.12}};
  registration.notes = more_notes;
  applied.notes = doubts;
  applied.notes.insert(applied.notes.end(), more_notes.begin(), more_notes.end());
  engine::keep_former_registration(applied.state, engine::CaseState(applied.state));
  applied.state[part::registration] = std::make_shared<const Registration>(std::move(registration));
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::RegisterAgain&,
                           const RunContext& context) const {
  if (!work(context, "register.elastic")) return false;
  engine::OtherRegistration offered;
  offered.registration = *applied.state[part::registration];
  offered.registration.nodes_in_camera.col(0).array() += 3e-3;
  if (!again_doubts.empty()) offered.registration.doubts = again_doubts;
  offered.is_better = again_is_better;
  offered.former_gap = 1.6e-3;
  offered.gap = again_is_better ? 0.4e-3 : 1.5e-3;
  offered.moved = 3e-3;
  applied.state[part::other_registration] =
      std::make_shared<const engine::OtherRegistration>(std::move(offered));
  return true;
}

bool FakeOperation::change(engine::Applied& applied, const engine::SaveCase& command,
                           const RunContext&) const {
  if (!command.path.empty()) applied.state.path = command.path;
  applied.result =
      std::make_shared<const engine::CaseOnDisk>(engine::CaseOnDisk{engine::editions(applied.state)});
  return true;
}

void make_box_operation(FakeOperation& operation) {
  operation.model = box_patient();
  Image& ct = operation.ct;
  ct.grid.size = {80, 60, 40};
  ct.grid.spacing_mm = {2.0, 2.0, 2.0};
  ct.grid.origin_mm = {-79.0, -59.0, -39.0};
  auto voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(ct.grid.voxel_count()));
  LabelVolume labels(ct.grid);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 80; ++i) {
        const Eigen::Vector3d p = ct.grid.p_in_ct({double(i), double(j), double(k)}).xyz;
        const bool liver = std::abs(p.x()) < 0.06 && std::abs(p.y()) < 0.04 && std::abs(p.z()) < 0.025;
        const bool lesion = (p - Eigen::Vector3d(0.03, 0, 0)).norm() < 0.006;
        (*voxels)[static_cast<std::size_t>(ct.grid.offset({i, j, k}))] =
            static_cast<std::int16_t>(lesion  ? 60
                                      : liver ? 110
                                              : -80 + (i + j + k) % 7);
        if (liver) labels.set({i, j, k}, lesion ? structure::kFirstLesion : structure::kParenchyma);
      }
  ct.voxels = voxels;
  operation.labels.voxels = labels;
  Camera& left = operation.rig.left;
  left.width = 320;
  left.height = 180;
  left.matrix << 260.0, 0.0, 162.0, 0.0, 260.0, 88.0, 0.0, 0.0, 1.0;
  left.distortion << -0.1, 0.02, 0.0, 0.0, 0.0;
  operation.rig.right = left;
  operation.rig.right_from_left.translation = {-0.0045, 0.0, 0.0};
  operation.camera_from_ct.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  operation.camera_from_ct.translation = {0.0, 0.0, 0.15};
}

}  // namespace glisson
