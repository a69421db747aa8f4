// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "glisson/core/json_file.h"
#include "glisson/core/units.h"
#include "glisson/experiments/track_evaluation.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"

namespace glisson::experiments {

/// Where a track is written, and how.
struct TrackOutput {
  std::filesystem::path folder;
  int digits = 5;                            ///< of the numbers in the meshes' names
  std::string ending = "vtu";                ///< of the meshes
  LengthUnit unit = LengthUnit::millimetre;  ///< of the meshes, the record and the truth
  double frames_per_second = 30.0;           ///< of the source: a frame that takes longer is late
  /// Writes the organ where the registration puts it, with more field data.
  std::function<void(const std::filesystem::path&, const Registration&, const NamedArrays&)> write_mesh;
  /// What a person is to do about a reason, in words; empty: nothing. May be absent.
  std::function<std::string(Validity)> remedy;
  /// File of a frame's true nodes, which need not exist; empty: nothing is compared.
  std::function<std::filesystem::path(int frame)> truth;
};

/// What 'glisson track' writes: one mesh a frame, with what is known of it; frames.jsonl, a line a frame; and
/// what the track comes to.
class TrackRecord {
 public:
  /// @param model that is tracked; outlives this. @param start where tracking began.
  TrackRecord(const PatientModel& model, Registration start, TrackOutput output);

  /// @throws FileError; InputError the truth is not of this model.
  void add(int number, const OverlayFrame& overlay);
  /// A correction by hand that was made after the last frame that was added; and one that was taken back.
  void add(const CorrectionMade& made);
  void add_undone(const OverlayFrame& overlay);
  /// The organ was registered again after that frame.
  void add(const AgainLine& again);
  /// What the meshes from now on tell of errors and doubts: the registration that tracking goes on from.
  void go_on_from(Registration registration) { carried_ = std::move(registration); }
  /// Writes frames.jsonl. @param whole false: it was cut short. @throws FileError.
  void finish(bool whole);
  int frames() const { return evaluation_.times().frames(); }
  /// Of what was added; after finish() of the whole track.
  const Figures& figures() const { return figures_; }

 private:
  void compare(int number, const OverlayFrame& overlay);

  const PatientModel& model_;
  Registration start_, carried_;  ///< where tracking began; whose errors and doubts the meshes tell
  TrackOutput output_;
  TrackEvaluation evaluation_;
  Figures figures_;
  std::string lines_;  ///< of frames.jsonl
};

/// Removes the meshes of a former run, as its own list names them: beside the new ones they would pass for
/// theirs. @param folder of the former run. @param fresh of the new one: what it holds too stays.
void remove_former_meshes(const std::filesystem::path& folder, const std::filesystem::path& fresh);

}  // namespace glisson::experiments
