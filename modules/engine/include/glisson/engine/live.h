// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "glisson/engine/case_state.h"
#include "glisson/engine/load_trial.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"

/// @file
/// What lives beside the case: the follower of frames, the load trial, and what long work shows on its way.

namespace glisson::engine {

struct StartTracking;

/// How a mask network does beside the live loop.
struct MaskStatus {
  std::filesystem::path network;
  std::optional<double> age;  ///< seconds since the picture of its newest mask; empty: it has made none
  bool is_used = false;       ///< that mask holds points out; false: there is none, or it is too old
  std::string problem;        ///< why no masks come any more; empty: nothing went wrong
};

/// A cloud with its place in time.
struct IndexedCloud {
  LabelledCloud cloud;
  int index = 0;
  double seconds = 0.0;
};

/// One moment of the operation for the live lane: pictures, or a cloud that somebody else made of them.
using LiveInput = std::variant<StereoFrame, IndexedCloud>;

/// Follows frames. Used by the live lane only.
class Follower {
 public:
  virtual ~Follower() = default;
  /// The next moment. What cannot be followed is told by the overlay's validity; should this throw, the
  /// engine shows no overlay for the moment (mechanics_failed).
  virtual OverlayFrame follow(const LiveInput& input) = 0;
  /// Somebody has seen a place of the organ elsewhere than in the last frame's overlay.
  /// @return that overlay as it is now. @throws InputError why it cannot be done; nothing has changed.
  virtual OverlayFrame correct(const Correction& correction);
  /// Takes the last correction back. @throws InputError there is none.
  virtual OverlayFrame undo_correction();
  /// Those that stand, the oldest first.
  virtual std::vector<CorrectionMade> corrections() const { return {}; }
  /// Goes over to another registration of the moment in which this began.
  /// @return the last frame's overlay as it is now. @throws InputError why it cannot; nothing has changed.
  virtual OverlayFrame take(const Registration& registration);
  /// From now on this network says what is not liver, beside the live loop; empty: none does.
  /// @throws InputError why it cannot; nothing has changed.
  virtual void set_mask_network(const std::filesystem::path& network);
  /// How the mask network does; empty: there is none.
  virtual std::optional<MaskStatus> mask_status() const { return {}; }
  /// Where the tissue has been seen since, and from where, all looks joined in that moment: left camera's
  /// frame, metres. Null: not known yet.
  virtual std::shared_ptr<const LabelledCloud> tissue_at_start() { return nullptr; }
};
/// Makes a follower from the state. @pre nothing is in the command's way (obstacle.h). @throws Error the
/// mechanics cannot be made, a calibration of other pictures.
using MakeFollower = std::function<std::unique_ptr<Follower>(const CaseState&, const StartTracking&)>;
std::unique_ptr<Follower> make_follower(const CaseState& state, const StartTracking& command);

/// Makes the mechanics of a load trial. @throws Error when a part is missing. Empty: cancelled.
using MakeTrial = std::function<Cancellable<std::unique_ptr<LoadTrial>>(const CaseState&, const TrialOptions&,
                                                                        const RunContext&)>;

/// What a command may use of the engine besides the state and its context.
struct Services {
  MakeFollower make_follower;
  MakeTrial make_trial;
  /// Shows the liver's contour on its way (see Snapshot::evolving), until the command ends. Empty: nobody
  /// looks.
  std::function<void(const LabelVolume&)> show_evolving;
  /// What follows frames just now; null: nothing. For commands of the edits' lane, which is its own.
  std::shared_ptr<Follower> follower = {};
};
/// Those of a command that is done outside of an engine: the real makers, and nobody looks.
Services plain_services();

/// What goes on live, as a command may change it. Called when the command is committed, never before.
class LiveLanes {
 public:
  virtual ~LiveLanes() = default;
  virtual void begin_tracking(std::shared_ptr<Follower> follower) = 0;
  virtual void end_tracking() = 0;
  /// @param made_from the state whose model is tried.
  virtual void begin_trial(std::shared_ptr<LoadTrial> mechanics, const CaseState& made_from) = 0;
  virtual void end_trial() = 0;
};

}  // namespace glisson::engine
