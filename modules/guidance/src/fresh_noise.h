// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "frame_clock.h"
#include "glisson/patient/picture.h"

namespace glisson::guidance {

/// Tells a live picture from a copy where nothing moves. A camera makes new noise in every picture; a picture
/// that is shown again has the old noise; if something adds noise to copies, only that part is new. The share
/// of new noise is measured with Immerkaer's mask m (Fast noise variance estimation, 1996), which cancels
/// constant and sloping brightness:
///     fresh = (spread of m(I_k - I_(k-1)))^2 / 2 / (spread of m(I_k))^2.
/// It is 1 for a live still scene, 0 for a repeated picture, s^2 / (live noise^2 + s^2) for copies with added
/// noise s, and above 1 where the scene moves. Spreads are lower quartiles, in which texture and highlights
/// weigh little. Pixels near black and white are left out: noise is cut off there.
class FreshNoise {
 public:
  /// The next frame.
  void push(const StereoFrame& frame, const FrameClock& clock);
  /// Learns what noise is usual. To be called while the scene moves: then it is surely live.
  void learn();

  /// The smaller of the two views' shares, and of these the largest in the last 0.3 s: a source that repeats
  /// only some frames is live. Negative: not known yet.
  double fresh() const;
  /// The noise's standard deviation over what was usual while the scene moved: above 1 where something adds
  /// noise. 0: not known.
  double louder() const { return usual_ > 0.0 ? noise_ / usual_ : 0.0; }

 private:
  struct View {
    std::vector<int> masked;  ///< at the places of a grid; kSkipped: too dark or too bright there
    double noise = 0.0;       ///< grey levels
    double fresh = -1.0;
  };
  static void look(const Picture& picture, View& view);

  View left_, right_;
  double noise_ = 0.0, usual_ = 0.0;
  double passed_ = 0.0;                             ///< seconds since the frame before
  std::deque<std::pair<double, double>> freshest_;  ///< seconds, fresh
};

}  // namespace glisson::guidance
