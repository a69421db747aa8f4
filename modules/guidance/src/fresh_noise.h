// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "frame_clock.h"
#include "glisson/patient/picture.h"

namespace glisson::guidance {

/// Whether a picture that does not move is alive. A sensor's noise is another in every picture. In a picture
/// that is shown again it is the same, and in copies to which something adds noise of its own, what is fresh
/// is only that. Immerkaer's mask m, blind to slopes, leaves noise of a picture and of the difference of two:
///     fresh = (spread of m(I_k - I_(k-1)))^2 / 2 / (spread of m(I_k))^2,
/// 1 where nothing but live noise differs, 0 for a repeated picture, s^2 / (live noise^2 + s^2) for copies
/// with noise s; above 1 where the scene moves. Spreads are lower quartiles: texture and highlights weigh
/// little. About a millisecond a frame at 960 x 540.
class FreshNoise {
 public:
  /// The next frame.
  void push(const StereoFrame& frame, const FrameClock& clock);
  /// Call it while the scene moves, and surely is live: what noise is usual.
  void learn();

  /// The largest over 0.3 s of the lesser of both views: a source that repeats some frames only is alive.
  /// Negative: not known yet.
  double fresh() const;
  /// Deviation of the noise over what was usual while the scene moved; noise that something adds shows. 0:
  /// not known.
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
