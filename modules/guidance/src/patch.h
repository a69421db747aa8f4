// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

namespace cv {
class Mat;
}

namespace glisson::guidance {

/// How a point of the tissue looks in one view: a small grey picture around it.
struct Patch {
  static constexpr int kReach = 13;  ///< pixels to each side of the point
  static constexpr int kSide = 2 * kReach + 1;
  std::array<std::uint8_t, static_cast<std::size_t>(kSide* kSide)> grey{};
};

/// @param grey one channel, 8 bits. @param at pixels, between them too. @return empty: too near the border.
std::optional<Patch> patch_at(const cv::Mat& grey, const Eigen::Vector2d& at);

struct PatchFound {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< pixels
  double likeness = 0.0;                         ///< normalised correlation there, -1 to 1
};

/// Looks for a patch near a guess: Gauss-Newton on the place, inverse compositional (Baker and Matthews,
/// Lucas- Kanade 20 years on, 2004), brightness and contrast free.
/// @param picture_from_patch how the patch is turned, stretched and sheared in this picture, pixels to
/// pixels.
/// @param most pixels that the place may be off the guess.
/// @return empty: not there, no texture, or stretched so that the patch does not say how it looks.
std::optional<PatchFound> find_patch(const cv::Mat& grey, const Patch& patch,
                                     const Eigen::Matrix2d& picture_from_patch, const Eigen::Vector2d& guess,
                                     double most);

}  // namespace glisson::guidance
