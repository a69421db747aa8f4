// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "box_patient.h"
#include "glisson/engine/engine.h"
#include "glisson/registration/register_model.h"

namespace glisson::engine {
struct BuildModel;
struct ImportImage;
struct ImportLabels;
struct ListSeries;
struct LoadVideoFrame;
struct ReadImage;
struct Reconstruct;
struct Register;
struct RegisterAgain;
struct SaveCase;
struct Segment;
struct SetCalibration;
struct SetLandmarks;
struct SetRegions;
struct SetSeeds;
struct SetVideo;
}  // namespace glisson::engine

namespace glisson {

/// An engine whose stages are quick and known, so that tests of the window test the window: the scheduling,
/// the staleness and the cancelling are the real ones, only what each command computes is made here.
class FakeOperation {
 public:
  Image ct;
  LabelMap labels;
  PatientModel model;
  std::vector<std::string> model_notes;  ///< what building it tells
  bool knows_organ = true;               ///< false: the mesh is as one that was imported
  double volume_error = -0.011;          ///< of the mesh, as a share of the organ
  StereoRig rig;
  CameraFromCt camera_from_ct;
  std::filesystem::path video;  ///< side by side
  /// While set, long commands go on until they are cancelled.
  std::atomic<bool> hold{false};
  /// Of every live frame.
  std::atomic<Validity> live_validity{Validity::valid};
  std::atomic<bool> next_frame_fails{false};             ///< the next live frame cannot be followed
  std::vector<std::string> doubts{"few_margin_points"};  ///< of the registration
  std::vector<std::string> more_notes;                   ///< that registering tells besides
  std::atomic<bool> again_is_better{true};               ///< a registration that is made while one follows
  std::vector<std::string> again_doubts;                 ///< of that one
  std::optional<engine::MaskStatus> mask;                ///< of every live frame; before tracking begins
  std::atomic<bool> mask_is_removed{false};              ///< from the next live frame on there is none
  double rival_away = 0.0;                               ///< metres; 0: the registration has no rival
  std::optional<CameraFromCt> start;                     ///< that the last registration was to begin near
  registration::Method method{};                         ///< that the last registration was to take

  engine::Engine::Options options();

  /// From nothing to a cloud, with a film of so many frames at the scope.
  std::vector<engine::Command> steps_to_cloud(const std::filesystem::path& scope, int frames);

  /// Writes a video of `frames` frames in which everything is grey-red with a moving bar.
  void film(const std::filesystem::path& path, int frames);

  static Picture picture(int width, int height, int index);

 private:
  /// @return false when cancelled.
  bool work(const RunContext& context, const char* stage) const;

  Cancellable<engine::Applied> apply(const engine::CaseState& state, const engine::Command& command,
                                     const RunContext& context);

  /// Empty: it is none of these. False: cancelled.
  template <class... C>
  std::optional<bool> try_change(engine::Applied& applied, const engine::Command& command,
                                 const RunContext& context) const;

  static void require_readable(const std::filesystem::path& path);
  bool change(engine::Applied& applied, const engine::ReadImage& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::ImportImage& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::ImportLabels& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::ListSeries& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::SetSeeds& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::Segment&, const RunContext& context) const;
  bool change(engine::Applied& applied, const engine::BuildModel&, const RunContext& context) const;
  bool change(engine::Applied& applied, const engine::SetLandmarks& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::SetCalibration&, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::SetVideo&, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::LoadVideoFrame& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::SetRegions& command, const RunContext&) const;
  bool change(engine::Applied& applied, const engine::Reconstruct&, const RunContext& context) const;
  bool change(engine::Applied& applied, const engine::Register&, const RunContext& context) const;
  /// 3 mm to the right of the former one.
  bool change(engine::Applied& applied, const engine::RegisterAgain&, const RunContext& context) const;
  bool change(engine::Applied& applied, const engine::SaveCase& command, const RunContext&) const;
};

/// The block patient in a small CT, seen by a small laparoscope.
void make_box_operation(FakeOperation& operation);

}  // namespace glisson
