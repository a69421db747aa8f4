// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"
#include "glisson/patient/picture.h"

/// @file
/// Whether the outline that is drawn lies on the organ's edge: the drawn pixels themselves against the mask
/// that the theatre's ray caster says. Nothing of the overlay's drawing is used. And whether the margin lies
/// on the true one.

namespace glisson::experiments {

/// Between two lines of a picture, either way: from each pixel of the one to the nearest of the other.
struct OutlineDistance {
  double mean = 0.0, percentile_95 = 0.0;  ///< pixels
};

/// @param drawn the outline alone on black ground; what has half of the brightest pixel's light is the line.
/// @param true_depth row-major, of the same size; 0 where the organ is not seen (insilico::Theatre::depth()).
/// The picture's border, where the organ is cut off, is no edge. Empty: one of both has no line inside.
/// @throws InputError another size.
std::optional<OutlineDistance> outline_distance(const Picture& drawn, const std::vector<float>& true_depth);

/// The same of a line of the organ, as its anterior margin, whose true place on the picture is known.
/// @param drawn, truth corners in order, pixels; what lies outside of the picture does not count, but where
///   nothing drawn lies inside and the truth does, the distance is the picture's diagonal. Empty: the truth
///   is not in the picture.
std::optional<OutlineDistance> line_distance(const std::vector<Eigen::Vector2d>& drawn,
                                             const std::vector<Eigen::Vector2d>& truth, int width,
                                             int height);

/// Of a film's frames.
class OutlineTally {
 public:
  void add(const OutlineDistance& distance) { distances_.push_back(distance); }
  /// For the line `outline`: outline_frames; outline_mean_px and outline_p95_px, each frame's, the mean over
  /// frames; outline_worst_mean_px, the frame's that is worst. Empty without frames.
  Figures figures(const std::string& line = "outline") const;

 private:
  std::vector<OutlineDistance> distances_;
};

}  // namespace glisson::experiments
