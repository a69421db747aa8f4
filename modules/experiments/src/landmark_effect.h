// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/core/json_file.h"
#include "glisson/core/run_context.h"
#include "glisson/patient/patient_model.h"

/// @file
/// What landmarks are worth to a registration: the same clouds with those of an atlas, of a person, and none.

namespace glisson::experiments {

/// Where a model's landmarks come from.
enum class LandmarkSource {
  none,          ///< nobody marked margin and notch, neither on the model nor in the picture
  person,        ///< clicked in the CT, with a person's error
  person_wrong,  ///< the same with the notch 17.5 mm along the surface (the largest in the paper's 3.3)
  atlas          ///< as an atlas proposes them, all accepted as they are
};
inline constexpr LandmarkSource kLandmarkSources[] = {LandmarkSource::none, LandmarkSource::person,
                                                      LandmarkSource::person_wrong, LandmarkSource::atlas};
/// "none", "person", "person_wrong", "atlas".
const char* landmark_source_code(LandmarkSource source);

/// A node of the surface about 17.5 mm from the model's notch, on a random side. 1 x 3, CT frame, metres.
/// @pre the model has a notch.
Points mistaken_notch(const PatientModel& model, std::mt19937_64 random);

/// What is tried.
struct LandmarkEffectOptions {
  std::shared_ptr<const atlas::Atlas> atlas;  ///< required
  std::uint64_t seed = 1;
  int patients = 2;    ///< livers of the synthetic population that the built-in atlas has not
  int handlings = 4;   ///< of each, the first ones of insilico::kHandlings
  double share = 0.3;  ///< of the surface that is seen

  /// @throws InputError naming the option.
  void validate() const;
};

/// Errors of registrations by where the landmarks came from.
struct LandmarkEffect {
  /// "effect_SOURCE_mean_mm" (over all nodes) and "effect_SOURCE_lesion_mm" (the largest of three deep
  /// places), both over the "effect_compared" of "effect_trials" clouds that were refused with no source;
  /// "effect_SOURCE_told" (of all, refused or doubted), "effect_atlas_over_none" (a ratio of means),
  /// "effect_atlas_notch_mm" (from the atlas' notch to the true one).
  Figures figures;
  std::vector<std::string> table;  ///< a row a source, then a row a cloud, each with heads
};
/// In silico: each patient handled in so many ways of `insilico`, one cloud each, registered with each
/// source. Empty: cancelled. @throws InputError options; Error.
Cancellable<LandmarkEffect> measure_landmark_effect(const LandmarkEffectOptions& options,
                                                    const RunContext& context);

}  // namespace glisson::experiments
