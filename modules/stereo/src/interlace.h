// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opencv2/core.hpp>

namespace glisson::stereo {

/// Tells whether the pictures of one view are interlaced: their even and their odd rows show two moments,
/// half of a frame's time apart.
///
/// The rows between two rows of the other parity look like those, the less, the more has moved meanwhile:
/// that is how much two fields are apart. Of a picture and the one before there are three such pairs: its own
/// two fields, and each of them with the other one's field of the other parity. In a progressive film these
/// are 0, 1 and 1 frames apart; in an interlaced one 1/2, 1/2 and 3/2. So the latter two differ, always the
/// same way round, and the nearer one is as far apart as the picture's own fields. What stands, fine texture,
/// noise and a change of brightness are the same in both.
class Interlace {
 public:
  /// @param grey 8 bit, all pixels of the next picture; it is kept, not copied.
  /// @return whether that is known by now.
  bool push(const cv::Mat& grey);

 private:
  cv::Mat before_;
  int parity_ = 0;    ///< which field seems to come first: 1 even rows, -1 odd rows
  int evidence_ = 0;  ///< pictures that say so, less those that move and say that it is progressive
};

}  // namespace glisson::stereo
