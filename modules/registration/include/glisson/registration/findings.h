// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

/// @file
/// What speaks for and against a registration. The points agree with the model because they moved it; so each
/// of these asks something that a wrong registration is likely to answer otherwise than a right one.

namespace glisson::registration {

/// Lengths in metres. Infinite or not a number: could not be asked.
struct Findings {
  /// Deviation of the cloud's points from a smooth surface through their neighbours: its own noise, whatever
  /// the model.
  double roughness = 0.0;
  /// Distance of the cloud from the most probable shape: rms over places of 25 mm of the mean distance along
  /// the normals.
  double misfit = 0.0;
  /// The same for places left out one at a time, each predicted from the others; and in the standard
  /// deviations that the error model expects.
  double held_out = 0.0, held_out_z = 0.0;
  /// Squared amplitudes of the deformation over what is expected of them: about 1 for an operation like those
  /// simulated.
  double strangeness = 0.0;
  double decided = 0.0;  ///< modes of the prior that the cloud decides, as a number
  double forced = 0.0;   ///< mean motion by which forces or springs still changed the most probable shape
  /// How far marked margin (rms) and notch lie from the model's.
  double margin_off = std::numeric_limits<double>::quiet_NaN();
  double notch_off = std::numeric_limits<double>::quiet_NaN();
  /// Share of the points that lie 10 mm and more behind the model, and of those whose own normal is against
  /// the model's (over 70 degrees). Not a number: where the camera stood is not known.
  double hidden = std::numeric_limits<double>::quiet_NaN();
  double turned = std::numeric_limits<double>::quiet_NaN();
  /// Logarithm of the odds of the most probable shape against that of the cloud's mirror image: a liver is
  /// not symmetric, so what fits no better than its mirror image has not been recognised.
  double mirror_odds = std::numeric_limits<double>::infinity();
  /// Logarithm of the odds against the most probable other shape 10 mm away.
  double rival_odds = std::numeric_limits<double>::infinity();
  /// Probability that the organ has changed between several looks.
  double looks_differ = std::numeric_limits<double>::quiet_NaN();
  double elsewhere = 0.0;  ///< probability that the organ is more than 20 mm away from where it was put
  /// How much larger than the model the organ would have to be, a share, and its standard deviation.
  double size = 0.0, size_sigma = std::numeric_limits<double>::infinity();
  double volume_change = 0.0;  ///< of the organ as it was put since the CT, a share of its volume there
  double expected = 0.0;       ///< mean expected error of the nodes
  struct Lesion {
    std::string name;  ///< structure_name()
    double expected = 0.0;
  };
  std::vector<Lesion> lesions;  ///< mean expected error of each
};

}  // namespace glisson::registration
