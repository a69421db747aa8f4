// SPDX-License-Identifier: GPL-3.0-or-later
#include "thin_parts.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "glisson/patient/label_map.h"

namespace glisson::editing {
namespace {

using Places = std::vector<std::size_t>;
using Marks = std::vector<std::uint8_t>;

constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// Asks for a cancel now and then: a place costs less than the question.
class Poll {
 public:
  explicit Poll(const RunContext& context) : context_(context) {}
  /// Of one more place.
  bool cancelled() { return ++places_ % kEvery == 0 && context_.cancelled(); }

 private:
  static constexpr std::size_t kEvery = 4096;

  const RunContext& context_;
  std::size_t places_ = 0;
};

bool is_structure(Label label) { return label != structure::kBackground && label != structure::kParenchyma; }

/// Balls and ways in a block. Beyond it nothing is known, and nothing is otherwise. Once cancelled it is of
/// no use any more.
class Lattice {
 public:
  Lattice(const Block& block, const Eigen::Vector3d& spacing_mm, const RunContext& context)
      : block_(block),
        size_(block.box.size()),
        spacing_mm_(spacing_mm),
        context_(context),
        way_(block.labels.size(), kNowhere) {}

  /// The places about which the ball lies within their label.
  Cancellable<Places> cores(const Places& places, const std::vector<BallRow>& ball) const {
    Places cores;
    Poll poll(context_);
    for (const std::size_t at : places) {
      if (poll.cancelled()) return std::nullopt;
      if (holds(at, ball)) cores.push_back(at);
    }
    return cores;
  }
  /// Marks the balls about places. @return false when cancelled.
  bool mark(const Places& places, const std::vector<BallRow>& ball, std::uint8_t value, Marks& marks) const {
    Poll poll(context_);
    for (const std::size_t at : places) {
      if (poll.cancelled()) return false;
      each_run(at, ball, [&](std::size_t first, std::size_t count) {
        std::fill_n(marks.begin() + static_cast<std::ptrdiff_t>(first), count, value);
        return true;
      });
    }
    return true;
  }
  /// The places with a neighbour in `through`, of their label: ways into it begin at no others.
  Cancellable<Places> beside(const Places& places, const Marks& through) const {
    Places found;
    Poll poll(context_);
    for (const std::size_t at : places) {
      if (poll.cancelled()) return std::nullopt;
      bool is_beside = false;
      each_neighbour(at, [&](std::size_t to, float) { is_beside |= leads(at, to, through); });
      if (is_beside) found.push_back(at);
    }
    return found;
  }
  /// The places in `through` that a way of at most `mm` leads to from sources, from neighbour to neighbour
  /// (26 of them) of one label.
  Cancellable<Places> within(const Places& sources, const Marks& through, double mm) {
    Places found;
    Poll poll(context_);
    for (const std::size_t at : sources) put(at, 0.0F);
    while (!fronts_.empty()) {
      if (poll.cancelled()) return std::nullopt;
      const float length = fronts_.top().first;
      const std::size_t at = fronts_.top().second;
      fronts_.pop();
      if (length > way_[at]) continue;
      if (through[at] != 0) found.push_back(at);
      each_neighbour(at, [&](std::size_t beside, float step) {
        if (leads(at, beside, through) && length + step <= static_cast<float>(mm)) put(beside, length + step);
      });
    }
    for (const std::size_t at : reached_) way_[at] = kNowhere;
    reached_.clear();
    return found;
  }

 private:
  using Front = std::pair<float, std::size_t>;

  Eigen::Vector3i index(std::size_t at) const {
    const auto nx = static_cast<std::size_t>(size_.x()), ny = static_cast<std::size_t>(size_.y());
    return {static_cast<int>(at % nx), static_cast<int>(at / nx % ny), static_cast<int>(at / (nx * ny))};
  }
  bool leads(std::size_t from, std::size_t to, const Marks& through) const {
    return through[to] != 0 && block_.labels[to] == block_.labels[from];
  }
  void put(std::size_t at, float length) {
    if (length >= way_[at]) return;
    if (way_[at] == kNowhere) reached_.push_back(at);
    way_[at] = length;
    fronts_.emplace(length, at);
  }
  /// Calls visit(place of its first voxel, count) for each row of a ball, until it returns false.
  template <class Visit>
  bool each_run(std::size_t at, const std::vector<BallRow>& ball, const Visit& visit) const {
    const Eigen::Vector3i v = index(at);
    for (const BallRow& row : ball) {
      const int j = v.y() + row.j, k = v.z() + row.k;
      if (j < 0 || k < 0 || j >= size_.y() || k >= size_.z()) continue;
      const int first = std::max(0, v.x() - row.half), last = std::min(size_.x() - 1, v.x() + row.half);
      if (!visit(block_.offset(first, j, k), static_cast<std::size_t>(last - first + 1))) return false;
    }
    return true;
  }
  bool holds(std::size_t at, const std::vector<BallRow>& ball) const {
    return each_run(at, ball, [&](std::size_t first, std::size_t count) {
      const Label* voxel = block_.labels.data() + first;
      return std::all_of(voxel, voxel + count, [&](Label other) { return other == block_.labels[at]; });
    });
  }
  template <class Visit>
  void each_neighbour(std::size_t at, const Visit& visit) const {
    const Eigen::Vector3i v = index(at);
    for (int k = std::max(0, v.z() - 1); k <= std::min(size_.z() - 1, v.z() + 1); ++k)
      for (int j = std::max(0, v.y() - 1); j <= std::min(size_.y() - 1, v.y() + 1); ++j)
        for (int i = std::max(0, v.x() - 1); i <= std::min(size_.x() - 1, v.x() + 1); ++i) {
          const Eigen::Vector3d step =
              (Eigen::Vector3i(i, j, k) - v).cast<double>().cwiseProduct(spacing_mm_);
          if (!step.isZero()) visit(block_.offset(i, j, k), static_cast<float>(step.norm()));
        }
  }

  const Block& block_;
  Eigen::Vector3i size_;
  Eigen::Vector3d spacing_mm_;
  const RunContext& context_;
  std::vector<float> way_;
  Places reached_;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> fronts_;
};

/// Those of `places`, in parts of structures, that a ball does not fit into.
Cancellable<Places> thin_among(const Places& places, const std::vector<BallRow>& ball, double radius_mm,
                               double step_mm, std::size_t voxels, Lattice& lattice) {
  Marks left(voxels, 0);
  Places thick, rest;
  {
    Marks covered(voxels, 0);
    const auto cores = lattice.cores(places, ball);
    if (!cores || !lattice.mark(*cores, ball, 1, covered)) return std::nullopt;
    for (const std::size_t at : places) {
      (covered[at] != 0 ? thick : rest).push_back(at);
      left[at] = covered[at] == 0 ? 1 : 0;
    }
  }
  const auto joints = lattice.beside(thick, left);
  if (!joints) return std::nullopt;
  const auto near = lattice.within(*joints, left, radius_mm);
  if (!near) return std::nullopt;
  Marks far = left;
  for (const std::size_t at : *near) far[at] = 0;
  Places ends;
  for (const std::size_t at : rest)
    if (far[at] != 0) ends.push_back(at);
  // And back to where it joins what is thick.
  return lattice.within(ends, left, radius_mm + step_mm);
}

}  // namespace

Cancellable<FittingBalls> fitting_balls(const Block& block, const Eigen::Vector3d& spacing_mm,
                                        double radius_mm, const RunContext& context) {
  FittingBalls fitting;
  fitting.ball.assign(block.labels.size(), 0);
  Places structures;
  for (std::size_t at = 0; at < block.labels.size(); ++at)
    if (is_structure(block.labels[at])) structures.push_back(at);
  Lattice lattice(block, spacing_mm, context);
  Marks is_thin(block.labels.size(), 1);  // for the ball before
  for (Places thin = structures; !thin.empty() || fitting.radii_mm.empty();) {
    const double r = fitting.radii_mm.empty() ? radius_mm : 0.5 * fitting.radii_mm.back();
    if (r < spacing_mm.minCoeff() && !fitting.radii_mm.empty()) break;
    if (context.cancelled()) return std::nullopt;
    fitting.radii_mm.push_back(r);
    const std::vector<BallRow> ball = ball_rows(spacing_mm, r);
    auto found = thin_among(structures, ball, r, spacing_mm.maxCoeff(), block.labels.size(), lattice);
    if (!found) return std::nullopt;
    thin = std::move(*found);
    std::erase_if(thin, [&](std::size_t at) { return is_thin[at] == 0; });
    is_thin.assign(is_thin.size(), 0);
    for (const std::size_t at : thin) is_thin[at] = 1;
    if (!lattice.mark(thin, ball, static_cast<std::uint8_t>(fitting.radii_mm.size()), fitting.ball))
      return std::nullopt;
  }
  return fitting;
}

}  // namespace glisson::editing
