// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"

namespace glisson::experiments {

/// What is done to an organ, and what is known of it.
struct PulledKind {
  const char* code;
  double smallest_patch_cm2, largest_patch_cm2;
  double held_radius_mm;
  bool other_mesh;  ///< the truth is no mesh that is registered
  bool hidden;      ///< one patch lies outside of what is seen
  bool loose;       ///< nobody says what is held, nor where the organ is before the camera
};
inline constexpr PulledKind kPulledKinds[] = {
    {"patches", 2.0, 6.0, 24.0, false, false, false}, {"few nodes", 0.3, 1.0, 24.0, false, false, false},
    {"local", 0.3, 1.0, 70.0, false, false, false},   {"other mesh", 2.0, 6.0, 24.0, true, false, false},
    {"hidden", 2.0, 6.0, 24.0, false, true, false},   {"loose", 2.0, 6.0, 24.0, true, false, true}};

/// A rest shape.
struct BareOrgan {
  std::string name;
  TetMesh mesh;
};

/// One organ, registered in its first frame and followed over the others. Metres; errors are means over
/// nodes.
struct PulledTrial {
  std::string organ;
  const PulledKind* kind = nullptr;  ///< of kPulledKinds
  std::uint64_t seed = 0;
  double noise = 0.0;
  double moved = 0.0, moved_most = 0.0;  ///< of the first frame's nodes; what doing nothing leaves
  double error = 0.0, worst = 0.0;       ///< of the first frame, and of its worst node
  double residual = 0.0;
  double followed = 0.0, followed_worst = 0.0;  ///< over the frames after it, and of the worst of them
  double frozen = 0.0;                          ///< of a registration that stays where it is, there
  int valid = 0, frames = 0;                    ///< of the frames after it
  bool refused = false;
  std::vector<std::string> doubts;
};

/// @param seed of the organ; one that cannot be pulled is drawn with another (PulledTrial::seed). @param
/// noise of the clouds, metres a coordinate. Empty: cancelled. @throws Error.
Cancellable<PulledTrial> try_pulled(const BareOrgan& organ, const PulledKind& kind, std::uint64_t seed,
                                    double noise, int frames, const RunContext& context);

/// What elastic_sequence's own truth gives.
struct SequenceTrial {
  double moved = 0.0, error = 0.0;              ///< metres, rest to its first frame
  double followed = 0.0, followed_worst = 0.0;  ///< of the frames with a truth
  int frames = 0, valid = 0;
};
/// @param folder of the sequence. Empty: cancelled. @throws Error.
Cancellable<SequenceTrial> try_sequence(const std::filesystem::path& folder, const RunContext& context);

}  // namespace glisson::experiments
