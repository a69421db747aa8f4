// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_smoothing.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

#include "thin_parts.h"

namespace glisson::editing {
namespace {

constexpr int kRounds = 40;             ///< of finding the weights
constexpr double kVolumeMissed = 1e-3;  ///< of what is contested of a label: near enough
constexpr float kStays = 0.25F;         ///< of a vote, for the label that a voxel has: it breaks ties

/// A label that a voxel may have, and its share of the ball there.
struct Bid {
  std::uint32_t owner;  ///< number of the label
  float share;
};

/// Shares out the voxels that are near to more than one label. Each goes to the label with the largest share
/// plus weight; weights are sought under which every label keeps as many of these voxels as it has now.
class Contest {
 public:
  void add(std::size_t at, Label here, const std::vector<std::pair<Label, float>>& bids) {
    places_.push_back(at);
    ++wanted_[owner_of(here)];
    for (const auto& [label, share] : bids) bids_.push_back({owner_of(label), share});
    starts_.push_back(bids_.size());
  }
  /// @return false when cancelled.
  bool settle(const RunContext& context) {
    by_owner_.resize(labels_.size());
    for (std::size_t n = 0; n < places_.size(); ++n)
      for (std::size_t b = starts_[n]; b < starts_[n + 1]; ++b)
        by_owner_[bids_[b].owner].push_back(static_cast<std::uint32_t>(n));
    weights_.assign(labels_.size(), 0.0F);
    // Only differences of weights count, so the label that is to have most keeps 0 and gets what the others
    // leave.
    const auto rest = std::max_element(wanted_.begin(), wanted_.end()) - wanted_.begin();
    for (int round = 0; round < kRounds && !is_settled(); ++round) {
      if (context.cancelled()) return false;
      context.progress(static_cast<double>(round) / kRounds, "segmentation.edit");
      for (std::size_t owner = 0; owner < labels_.size(); ++owner)
        if (static_cast<std::ptrdiff_t>(owner) != rest) weigh(owner);
    }
    return true;
  }
  /// Calls take(place, label) for each of the voxels.
  template <class Take>
  void each_winner(const Take& take) const {
    for (std::size_t n = 0; n < places_.size(); ++n) take(places_[n], labels_[winner(n)]);
  }

 private:
  std::uint32_t owner_of(Label label) {
    const auto [found, is_new] = owners_.emplace(label, static_cast<std::uint32_t>(labels_.size()));
    if (is_new) {
      labels_.push_back(label);
      wanted_.push_back(0);
    }
    return found->second;
  }
  std::size_t winner(std::size_t n) const {
    std::size_t best = bids_[starts_[n]].owner;
    float most = -std::numeric_limits<float>::infinity();
    for (std::size_t b = starts_[n]; b < starts_[n + 1]; ++b) {
      const float offer = bids_[b].share + weights_[bids_[b].owner];
      if (offer <= most) continue;
      most = offer;
      best = bids_[b].owner;
    }
    return best;
  }
  /// Sets an owner's weight so that it wins as many voxels as it had before, while the others keep theirs.
  void weigh(std::size_t owner) {
    if (by_owner_[owner].empty()) return;
    std::vector<float> missing;
    missing.reserve(by_owner_[owner].size());
    for (const std::uint32_t n : by_owner_[owner]) missing.push_back(missing_of(owner, n));
    weights_[owner] = threshold(missing, wanted_[owner]);
  }
  /// The weight above which an owner wins a voxel that it bids for.
  float missing_of(std::size_t owner, std::size_t n) const {
    float others = -std::numeric_limits<float>::infinity(), own = 0.0F;
    for (std::size_t b = starts_[n]; b < starts_[n + 1]; ++b)
      if (bids_[b].owner == owner)
        own = bids_[b].share;
      else
        others = std::max(others, bids_[b].share + weights_[bids_[b].owner]);
    return others - own;
  }
  /// A number below which `wanted` of the values lie. Equal values fall on one side together, so it may be a
  /// few more or fewer: whichever is closer.
  static float threshold(std::vector<float>& values, long wanted) {
    const long size = static_cast<long>(values.size());
    const auto middle = values.begin() + std::min(wanted, size - 1);
    std::nth_element(values.begin(), middle, values.end());
    const float value = *middle;
    float below = value - 1.0F, above = value + 1.0F;  // next to it
    long low = 0, high = 0;
    for (const float other : values) {
      low += other < value ? 1 : 0;
      high += other <= value ? 1 : 0;
      if (other < value) below = std::max(below, other);
      if (other > value) above = std::min(above, other);
    }
    return 0.5F * (value + (wanted - low < high - wanted ? below : above));
  }
  bool is_settled() const {
    std::vector<long> won(labels_.size(), 0);
    for (std::size_t n = 0; n < places_.size(); ++n) ++won[winner(n)];
    for (std::size_t owner = 0; owner < labels_.size(); ++owner)
      if (static_cast<double>(std::abs(won[owner] - wanted_[owner])) >
          kVolumeMissed * static_cast<double>(wanted_[owner]))
        return false;
    return true;
  }

  std::map<Label, std::uint32_t> owners_;
  std::vector<Label> labels_;
  std::vector<long> wanted_;
  std::vector<std::size_t> places_, starts_{0};
  std::vector<Bid> bids_;
  std::vector<std::vector<std::uint32_t>> by_owner_;
  std::vector<float> weights_;
};

/// Enters what one ball decides: the voxels that it fits. @return false when cancelled.
bool collect(const Block& block, const Eigen::Vector3d& spacing_mm, const FittingBalls& fitting,
             std::size_t which, const MayChange& may_change, const RunContext& context, Contest& contest) {
  const double radius_mm = fitting.radii_mm[which];
  const std::vector<BallRow> ball = ball_rows(spacing_mm, radius_mm);
  const Quiet quiet(block, spacing_mm, radius_mm);
  Votes votes(block, ball);
  const Eigen::Vector3i size = block.box.size();
  std::vector<std::pair<Label, float>> bids;
  for (int k = 0; k < size.z(); ++k) {
    if (context.cancelled()) return false;
    context.progress(static_cast<double>(k) / size.z(), "segmentation.edit");
    for (int j = 0; j < size.y(); ++j) {
      votes.start_row(j, k);
      for (int i = 0; i < size.x(); ++i) {
        const std::size_t at = block.offset(i, j, k);
        if (fitting.ball[at] != which || quiet.at(i, j, k)) continue;
        votes.move_to(i);
        const Label here = block.labels[at];
        bids.clear();
        int all = 0;
        for (const Label label : votes.labels()) {
          const int count = votes.count(label);
          all += count;
          if (count > 0 && (label == here || may_change(i, j, k, here, label)))
            bids.emplace_back(label, static_cast<float>(count) + (label == here ? kStays : 0.0F));
        }
        if (bids.size() < 2) continue;
        for (auto& bid : bids) bid.second /= static_cast<float>(all);
        contest.add(at, here, bids);
      }
    }
  }
  return true;
}

}  // namespace

Cancellable<std::vector<Label>> smoothed_jointly(const Block& block, const Eigen::Vector3d& spacing_mm,
                                                 double radius_mm, const MayChange& may_change,
                                                 const RunContext& context) {
  const auto fitting = fitting_balls(block, spacing_mm, radius_mm, context.part(0.0, 0.2));
  if (!fitting) return std::nullopt;
  Contest contest;
  const double balls = static_cast<double>(fitting->radii_mm.size());
  for (std::size_t which = 0; which < fitting->radii_mm.size(); ++which) {
    const double from = 0.2 + 0.6 * static_cast<double>(which) / balls;
    if (!collect(block, spacing_mm, *fitting, which, may_change, context.part(from, from + 0.6 / balls),
                 contest))
      return std::nullopt;
  }
  if (!contest.settle(context.part(0.8, 1.0))) return std::nullopt;
  std::vector<Label> result = block.labels;
  contest.each_winner([&](std::size_t at, Label label) { result[at] = label; });
  return result;
}

}  // namespace glisson::editing
