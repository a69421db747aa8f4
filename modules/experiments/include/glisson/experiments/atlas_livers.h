// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "glisson/atlas/atlas.h"
#include "glisson/atlas/member.h"

/// @file
/// Livers for atlases: the synthetic population, whose structures are known by formula, and the real label
/// maps of the shared data.

namespace glisson::experiments {

/// A liver of the synthetic population as an atlas' member, "synthetic_SEED"; every structure is known.
atlas::Member synthetic_member(std::uint64_t seed);
/// A template of about 2000 even vertices: a liver of the population that is no atlas' member.
TriangleMesh synthetic_template();

/// The numbers of the label maps in `data`/liver_labelmaps that are there, ascending: "0001", ...
std::vector<std::string> label_map_names(const std::filesystem::path& data);
/// Those of even numbers served development; the others are for validation.
bool is_for_development(const std::string& label_map);
/// What a label map shows.
struct LabelMapLiver {
  atlas::Member member;  ///< with vena cava's and gallbladder's contact and the portal vein's entrance
  std::vector<VesselTree> portal_vein;  ///< CT frame, metres
};
/// One of them with its header's orientation mended (their README). Empty: cancelled. @throws FileError,
/// InputError.
Cancellable<LabelMapLiver> label_map_liver(const std::filesystem::path& data, const std::string& name,
                                           const RunContext& context);
/// The label maps that served development, with what was read on them and nothing else: notch, falciform line
/// and margin. Empty: cancelled. @param readings file of readings.h. @throws FileError, InputError.
Cancellable<std::vector<atlas::Member>> read_livers(const std::filesystem::path& data,
                                                    const std::filesystem::path& readings,
                                                    const RunContext& context);
/// The member alone.
Cancellable<atlas::Member> label_map_member(const std::filesystem::path& data, const std::string& name,
                                            const RunContext& context);

}  // namespace glisson::experiments
