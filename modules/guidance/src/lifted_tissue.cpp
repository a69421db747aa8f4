// SPDX-License-Identifier: GPL-3.0-or-later
#include "lifted_tissue.h"

#include <algorithm>
#include <cmath>

namespace glisson::guidance {
namespace {

constexpr std::size_t kLeast = 8;  ///< places of a patch; less may be wrong matches
/// Metres, and standard deviations besides: a larger change of depth from one place to the next is a step.
constexpr double kStep = 3e-3, kStepSigmas = 2.0;
/// Of the patch's border on the organ, the share without a step from which it is one surface with it.
constexpr double kJoined = 0.25;
constexpr int kFewFollowed = 5;  ///< fewer points say nothing
constexpr double kDense = 0.5;   ///< of the points a place on the rest of the organ

class Patches {
 public:
  explicit Patches(const SeenGrid& grid) : grid_(grid), taken_(grid.nearer.size(), 0) {
    int points = 0, places = 0;
    for (std::size_t i = 0; i < grid.nearer.size(); ++i) {
      if (grid.predicted[i] == 0 || grid.nearer[i] != 0 || grid.range[i] <= 0.0) continue;
      points += grid.followed[i];
      ++places;
    }
    density_ = places > 0 ? points / static_cast<double>(places) : 0.0;
  }

  /// The patch of this place. @pre it is nearer and not taken yet.
  std::vector<std::size_t> grow(std::size_t from) {
    std::vector<std::size_t> patch{from};
    taken_[from] = 1;
    for (std::size_t next = 0; next < patch.size(); ++next)
      beside(patch[next], [&](std::size_t at) {
        if (grid_.nearer[at] == 0 || taken_[at] != 0) return;
        taken_[at] = 1;
        patch.push_back(at);
      });
    return patch;
  }
  bool is_taken(std::size_t at) const { return taken_[at] != 0; }
  bool is_tissue(const std::vector<std::size_t>& patch) const {
    return patch.size() >= kLeast && (is_joined(patch) || is_followed(patch));
  }

 private:
  template <class Visit>
  void beside(std::size_t at, const Visit& visit) const {
    const int row = static_cast<int>(at) / grid_.columns, column = static_cast<int>(at) % grid_.columns;
    for (int r = std::max(0, row - 1); r <= std::min(grid_.rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(grid_.columns - 1, column + 1); ++c)
        visit(static_cast<std::size_t>(r * grid_.columns + c));
  }
  bool is_joined(const std::vector<std::size_t>& patch) const {
    int border = 0, joined = 0;
    for (const std::size_t at : patch) {
      bool is_border = false, goes_over = false;
      beside(at, [&](std::size_t other) {
        if (grid_.nearer[other] != 0 || grid_.predicted[other] == 0) return;
        is_border = true;
        goes_over = goes_over || (grid_.range[other] > 0.0 &&
                                  std::abs(grid_.range[other] - grid_.range[at]) <
                                      kStep + kStepSigmas * std::hypot(grid_.sigma[other], grid_.sigma[at]));
      });
      border += is_border;
      joined += goes_over;
    }
    return joined > 0 && joined >= kJoined * border;
  }
  bool is_followed(const std::vector<std::size_t>& patch) const {
    int points = 0;
    for (const std::size_t at : patch) points += grid_.followed[at];
    return points >= kFewFollowed && points >= kDense * density_ * static_cast<double>(patch.size());
  }

  const SeenGrid& grid_;
  std::vector<char> taken_;
  double density_ = 0.0;  ///< followed points a place
};

}  // namespace

std::vector<char> lifted_places(const SeenGrid& grid) {
  std::vector<char> lifted(grid.nearer.size(), 0);
  Patches patches(grid);
  for (std::size_t i = 0; i < grid.nearer.size(); ++i) {
    if (grid.nearer[i] == 0 || patches.is_taken(i)) continue;
    const std::vector<std::size_t> patch = patches.grow(i);
    if (!patches.is_tissue(patch)) continue;
    for (const std::size_t at : patch) lifted[at] = 1;
  }
  return lifted;
}

}  // namespace glisson::guidance
