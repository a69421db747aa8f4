// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "glisson/engine/parts/cloud.h"

/// @file
/// The points of the whole stereo pair that a cloud was made of, as files.

namespace glisson::engine {

/// points/whole.ply: the points, left camera's frame, mm, with normals and standard deviation;
/// points/points.json: of which pair they are, how they were made, their covariance (mm2), figures and
/// density.
/// @pre `points` has a cloud.
void write_points(const std::filesystem::path& folder, const CaseState& state, const PairPoints& points);
/// @param state with the frame and the rig that were saved beside the points: they belong to these again.
/// @throws InputError, FileError naming the file and the field: missing, malformed, of other pictures.
std::shared_ptr<const PairPoints> read_points(const std::filesystem::path& folder, const CaseState& state);

/// Whether two sets of points are the same but for what files round (1e-6 of a value).
bool same_pair_points(const PairPoints& a, const PairPoints& b);

}  // namespace glisson::engine
