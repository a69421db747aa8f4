// SPDX-License-Identifier: GPL-3.0-or-later
#include "skeleton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>
#include <tuple>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"

namespace glisson::model {

Eigen::Vector3d VesselVoxels::position_mm(int voxel) const {
  const int row = mask.size.x(), slice = row * mask.size.y();
  const Eigen::Vector3i at(voxel % row, voxel % slice / row, voxel / slice);
  return at.cast<double>().cwiseProduct(mask.spacing_mm);
}

std::vector<VesselVoxels::Step> VesselVoxels::steps() const {
  std::vector<Step> all;
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        all.push_back({i + mask.size.x() * (j + mask.size.y() * k),
                       static_cast<float>(Eigen::Vector3d(i, j, k).cwiseProduct(mask.spacing_mm).norm())});
      }
  return all;
}

VesselVoxels measure_vessel(Mask mask) {
  VesselVoxels vessel;
  Mask outside(mask.size, mask.spacing_mm);
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) outside.voxels[i] = mask.voxels[i] == 0;
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i)
        if (i == 0 || j == 0 || k == 0 || i + 1 == mask.size.x() || j + 1 == mask.size.y() ||
            k + 1 == mask.size.z())
          require(mask.voxels[mask.offset(i, j, k)] == 0, "a vessel's mask needs an empty margin");
  vessel.radius_mm = squared_distance_mm2(outside);
  for (std::size_t i = 0; i < vessel.radius_mm.size(); ++i)
    vessel.radius_mm[i] = mask.voxels[i] != 0 ? std::sqrt(vessel.radius_mm[i]) : 0.0F;
  vessel.mask = std::move(mask);
  return vessel;
}

std::vector<std::vector<int>> vessel_pieces(const VesselVoxels& vessel) {
  std::vector<char> seen(vessel.mask.voxels.size(), 0);
  const auto steps = vessel.steps();
  std::vector<std::vector<int>> pieces;
  for (std::size_t seed = 0; seed < seen.size(); ++seed) {
    if (vessel.mask.voxels[seed] == 0 || seen[seed]) continue;
    std::vector<int> piece{static_cast<int>(seed)};
    seen[seed] = 1;
    for (std::size_t next = 0; next < piece.size(); ++next)
      for (const auto& step : steps) {
        const int neighbour = piece[next] + step.offset;
        if (vessel.mask.voxels[neighbour] == 0 || seen[neighbour]) continue;
        seen[neighbour] = 1;
        piece.push_back(neighbour);
      }
    pieces.push_back(std::move(piece));
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return pieces;
}

SpanningTree span(const VesselVoxels& vessel, const std::vector<int>& roots, const SkeletonOptions& options) {
  const std::size_t count = vessel.mask.voxels.size();
  SpanningTree tree;
  tree.parent.assign(count, -1);
  tree.root_number.assign(count, -1);
  tree.from_root_mm.assign(count, 0.0F);
  std::vector<double> cost(count, std::numeric_limits<double>::infinity());
  std::vector<char> done(count, 0);
  const auto steps = vessel.steps();
  // Ties are settled by the voxel's number, so that the tree does not depend on the heap's making.
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  for (std::size_t r = 0; r < roots.size(); ++r) {
    require(vessel.mask.voxels.at(static_cast<std::size_t>(roots[r])) != 0, "a root must lie in its vessel");
    tree.root_number[roots[r]] = static_cast<int>(r);
    cost[roots[r]] = 0.0;
    heap.emplace(0.0, roots[r]);
  }
  while (!heap.empty()) {
    const auto [key, voxel] = heap.top();
    heap.pop();
    if (done[voxel]) continue;
    done[voxel] = 1;
    tree.order.push_back(voxel);
    for (const auto& step : steps) {
      const int neighbour = voxel + step.offset;
      if (vessel.mask.voxels[neighbour] == 0 || done[neighbour]) continue;
      const double weight = std::pow(static_cast<double>(vessel.radius_mm[neighbour]), -options.exponent);
      const double reached = options.accumulated_cost ? key + weight * step.length_mm : weight;
      if (!(reached < cost[neighbour])) continue;
      cost[neighbour] = reached;
      tree.parent[neighbour] = voxel;
      tree.root_number[neighbour] = tree.root_number[voxel];
      tree.from_root_mm[neighbour] = tree.from_root_mm[voxel] + step.length_mm;
      heap.emplace(reached, neighbour);
    }
  }
  return tree;
}

namespace {

/// A path's farthest voxel lies somewhere on the rim of the vessel's end, where the last steps hook off the
/// middle. From where the end is as near as the wall, the path goes straight on instead.
std::vector<int> with_straight_tip(const VesselVoxels& vessel, std::vector<int> path) {
  const auto p = [&](std::size_t i) { return vessel.position_mm(path[i]); };
  double to_tip = 0.0;
  std::size_t turn = path.size() - 1;
  while (turn > 0 && to_tip < vessel.radius_mm[path[turn]]) {
    to_tip += (p(turn) - p(turn - 1)).norm();
    --turn;
  }
  std::size_t back = turn;
  double stretch = 0.0;
  const double radius = vessel.radius_mm[path[turn]];
  for (; back > 0 && stretch < 2.0 * radius; --back) stretch += (p(back) - p(back - 1)).norm();
  if (stretch < radius) return path;  // too short to have a direction
  const Eigen::Vector3d from = p(turn), along = (from - p(back)).normalized();
  path.resize(turn + 1);
  const double step = 0.5 * vessel.mask.spacing_mm.minCoeff();
  for (double far = step; far <= to_tip; far += step) {
    const Eigen::Vector3i at =
        (from + far * along).cwiseQuotient(vessel.mask.spacing_mm).array().round().cast<int>();
    if ((at.array() < 0).any() || (at.array() >= vessel.mask.size.array()).any()) break;
    const auto voxel = static_cast<int>(vessel.mask.offset(at.x(), at.y(), at.z()));
    if (vessel.mask.voxels[voxel] == 0) break;
    if (voxel != path.back()) path.push_back(voxel);
  }
  return path;
}

/// Extracts the paths of all roots from a spanning tree.
class Extraction {
 public:
  Extraction(const VesselVoxels& vessel, const SpanningTree& tree, const SkeletonOptions& options)
      : vessel_(vessel), tree_(tree), options_(options), steps_(vessel.steps()) {
    const std::size_t count = tree.parent.size();
    farthest_.resize(count);
    owner_.assign(count, -1);
    position_.assign(count, -1);
    covered_.assign(count, 0);
    taken_.assign(count, 0);
    first_child_.assign(count, -1);
    next_sibling_.assign(count, -1);
    for (std::size_t i = 0; i < count; ++i) farthest_[i] = static_cast<int>(i);
    for (auto at = tree.order.rbegin(); at != tree.order.rend(); ++at) {
      const int parent = tree.parent[*at];
      if (parent < 0) continue;
      next_sibling_[*at] = first_child_[parent];
      first_child_[parent] = *at;
      if (tree.from_root_mm[farthest_[*at]] > tree.from_root_mm[farthest_[parent]])
        farthest_[parent] = farthest_[*at];
    }
  }

  std::vector<SkeletonPath> paths_from(int root) {
    paths_.clear();
    accept({tree_path(root, farthest_[root]), -1, -1, 0});
    while (!candidates_.empty()) {
      const Candidate longest = candidates_.top();
      candidates_.pop();
      if (!taken_[longest.child]) try_branch(longest);
    }
    return std::move(paths_);
  }

 private:
  static constexpr double kMiddle = 0.5;  // of the radius

  /// A subtree that may hold a branch. The longest is looked at first: what creeps along a tube's wall is
  /// then met when the tube has its path, and is known for what it is.
  struct Candidate {
    float length_mm;   ///< from the fork to the subtree's farthest tip
    int child;         ///< the subtree's first voxel
    int fork, parent;  ///< voxel of a path, and the path
    bool operator<(const Candidate& other) const {
      return std::tie(length_mm, other.child) < std::tie(other.length_mm, child);
    }
  };

  /// Voxels from `from` (an ancestor) to `to`.
  std::vector<int> tree_path(int from, int to) const {
    std::vector<int> path{to};
    while (path.back() != from) path.push_back(tree_.parent[path.back()]);
    std::reverse(path.begin(), path.end());
    return path;
  }

  double distance(int a, int b) const { return (vessel_.position_mm(a) - vessel_.position_mm(b)).norm(); }

  /// The middle of a tube belongs to the path that runs there; the whole of the tube is covered by it.
  void accept(SkeletonPath path) {
    const int number = static_cast<int>(paths_.size());
    path.voxels = with_straight_tip(vessel_, std::move(path.voxels));
    const double voxel = vessel_.mask.spacing_mm.maxCoeff();
    for (std::size_t i = path.parent < 0 ? 0 : 1; i < path.voxels.size(); ++i) {
      taken_[path.voxels[i]] = 1;
      owner_[path.voxels[i]] = number;
      position_[path.voxels[i]] = static_cast<int>(i);
    }
    for (std::size_t i = 0; i < path.voxels.size(); ++i) {
      const double radius = vessel_.radius_mm[path.voxels[i]];
      for_ball(path.voxels[i], radius + voxel, [&](int at, double far) {
        covered_[at] = 1;
        if (far > kMiddle * radius || owner_[at] >= 0) return;
        owner_[at] = number;
        position_[at] = static_cast<int>(i);
      });
    }
    paths_.push_back(std::move(path));
    const SkeletonPath& kept = paths_.back();
    if (kept.order >= options_.most_orders) return;
    for (std::size_t i = kept.parent < 0 ? 0 : 1; i < kept.voxels.size(); ++i)
      look_beside(kept.voxels[i], kept.voxels[i], number);
  }

  template <class Visit>
  void for_ball(int centre, double radius, Visit visit) const {
    const Eigen::Vector3i size = vessel_.mask.size;
    const Eigen::Vector3i at(centre % size.x(), centre / size.x() % size.y(), centre / (size.x() * size.y()));
    const Eigen::Vector3i reach = (radius * vessel_.mask.spacing_mm.cwiseInverse()).cast<int>();
    const Eigen::Vector3i low = (at - reach).cwiseMax(0),
                          high = (at + reach).cwiseMin(size - Eigen::Vector3i::Ones());
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) {
          const double far =
              (Eigen::Vector3i(i, j, k) - at).cast<double>().cwiseProduct(vessel_.mask.spacing_mm).norm();
          const auto voxel = static_cast<int>(vessel_.mask.offset(i, j, k));
          if (far <= radius && vessel_.mask.voxels[voxel] != 0) visit(voxel, far);
        }
  }

  /// The subtrees beside `voxel`, seen from a fork of a path.
  void look_beside(int voxel, int fork, int parent) {
    for (int child = first_child_[voxel]; child >= 0; child = next_sibling_[child]) {
      const float length = tree_.from_root_mm[farthest_[child]] - tree_.from_root_mm[fork];
      // Nothing in a short subtree can stand out of the tube.
      if (!taken_[child] && length >= static_cast<float>(options_.least_protrusion_mm))
        candidates_.push({length, child, fork, parent});
    }
  }

  void try_branch(const Candidate& candidate) {
    const int tip = farthest_[candidate.child];
    const std::vector<int> whole = tree_path(candidate.child, tip), path = tree_path(candidate.fork, tip);
    for (const int voxel : whole) taken_[voxel] = 1;
    SkeletonPath branch = shortened(candidate.parent, path, path.size());
    if (!stands_out(branch) || is_false(branch)) {
      // Its tip lies in a tube that has a path. What comes before may be the other way around a loop.
      branch = shortened(candidate.parent, path, first_uncovered_stretch(path));
      if (branch.voxels.size() < 2 || !stands_out(branch)) branch.voxels.clear();
    }
    // What a rejected branch passes through, and what the shortening left behind, may still lead to a true
    // one.
    const std::size_t kept = branch.voxels.empty() ? 0 : std::min(whole.size(), branch.voxels.size() - 1);
    for (std::size_t i = 0; i + kept < whole.size(); ++i)
      look_beside(whole[i], candidate.fork, candidate.parent);
    if (branch.voxels.empty()) return;
    branch.order = paths_[branch.parent].order + 1;
    accept(std::move(branch));
  }

  /// Where the first long stretch outside all tubes begins on a path; 0 when there is none.
  std::size_t first_uncovered_stretch(const std::vector<int>& path) const {
    double stretch = 0.0;
    std::size_t begin = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (covered_[path[i]]) {
        stretch = 0.0;
        continue;
      }
      if (stretch == 0.0) begin = i;
      stretch += distance(path[i - 1], path[i]);
      if (stretch >= std::max(options_.least_protrusion_mm,
                              options_.least_protrusion_over_radius * vessel_.radius_mm[path[i]]))
        return begin;
    }
    return 0;
  }

  /// First heuristic: start from where the tip is nearest along the path. The paper looks along the parent;
  /// siblings that run side by side in one tube for a while ask for a look at every path that is there.
  /// @param end only the voxels before it may touch the other path.
  SkeletonPath shortened(int parent, const std::vector<int>& path, std::size_t end) const {
    SkeletonPath result;
    if (end == 0) return result;
    const int fork = path.front();
    double best = tree_.from_root_mm[path.back()] - tree_.from_root_mm[fork];
    result.parent = parent;
    result.parent_position = paths_[parent].voxels[0] == fork ? 0 : position_[fork];
    std::size_t best_rest = 1;
    const auto consider = [&](int at, std::size_t i) {
      if (owner_[at] < 0) return;
      const int start = paths_[owner_[at]].voxels[position_[at]];
      const double length =
          tree_.from_root_mm[path.back()] - tree_.from_root_mm[path[i]] + distance(start, path[i]);
      if (length >= best) return;
      best = length;
      best_rest = i;
      result.parent = owner_[at];
      result.parent_position = position_[at];
    };
    for (std::size_t i = 1; i < end; ++i) {
      consider(path[i], i);
      for (const auto& step : steps_) consider(path[i] + step.offset, i);
    }
    result.voxels.push_back(paths_[result.parent].voxels[result.parent_position]);
    result.voxels.insert(result.voxels.end(), path.begin() + static_cast<std::ptrdiff_t>(best_rest),
                         path.end());
    return result;
  }

  bool stands_out(const SkeletonPath& path) const {
    double length = 0.0;
    std::vector<float> radii;
    const double parent_radius = vessel_.radius_mm[path.voxels.front()];
    for (std::size_t i = 1; i < path.voxels.size(); ++i) {
      length += distance(path.voxels[i - 1], path.voxels[i]);
      if (length > parent_radius) radii.push_back(vessel_.radius_mm[path.voxels[i]]);
    }
    if (radii.empty()) return false;
    const double own_radius = upper_median(std::move(radii));
    return length - parent_radius >=
           std::max(options_.least_protrusion_mm, options_.least_protrusion_over_radius * own_radius);
  }

  bool segment_inside(int from, int to) const {
    const Eigen::Vector3d a = vessel_.position_mm(from), b = vessel_.position_mm(to);
    const int samples =
        1 + static_cast<int>(std::ceil((b - a).norm() / (0.5 * vessel_.mask.spacing_mm.minCoeff())));
    for (int s = 0; s <= samples; ++s) {
      const Eigen::Vector3d index =
          (a + (b - a) * s / samples).cwiseQuotient(vessel_.mask.spacing_mm).array().round();
      if (vessel_.mask.voxels[vessel_.mask.offset(static_cast<int>(index.x()), static_cast<int>(index.y()),
                                                  static_cast<int>(index.z()))] == 0)
        return false;
    }
    return true;
  }

  int nearest_on(const SkeletonPath& line, int voxel) const {
    return *std::min_element(line.voxels.begin(), line.voxels.end(),
                             [&](int a, int b) { return distance(a, voxel) < distance(b, voxel); });
  }

  /// Second heuristic: a path inside a tube that has one already. The paper asks whether the tip sees the
  /// parent; a second way around a loop ends beside its parent too, so here the whole path must see it.
  bool is_false(const SkeletonPath& path) const {
    const SkeletonPath& parent = paths_[path.parent];
    const int fork = path.voxels.front(), tip = path.voxels.back();
    const int nearest = nearest_on(parent, tip);
    if (nearest == fork) return false;  // no angle to speak of
    const Eigen::Vector3d along = vessel_.position_mm(nearest) - vessel_.position_mm(fork),
                          out = vessel_.position_mm(tip) - vessel_.position_mm(fork);
    const double angle = std::acos(std::clamp(along.dot(out) / (along.norm() * out.norm()), -1.0, 1.0));
    if (std::abs(angle - 0.5 * std::numbers::pi) <= options_.right_angle_tolerance) return false;
    for (auto voxel = path.voxels.rbegin(); voxel != path.voxels.rend(); ++voxel)
      if (!segment_inside(nearest_on(parent, *voxel), *voxel)) return false;
    return true;
  }

  const VesselVoxels& vessel_;
  const SpanningTree& tree_;
  const SkeletonOptions& options_;
  std::vector<VesselVoxels::Step> steps_;
  std::vector<int> farthest_;  ///< of each voxel's subtree, from the root
  std::vector<int> first_child_, next_sibling_;
  std::vector<int> owner_, position_;  ///< path in the middle of whose tube a voxel lies, and the place in it
  std::vector<char> taken_, covered_;
  std::vector<SkeletonPath> paths_;
  std::priority_queue<Candidate> candidates_;
};

}  // namespace

std::vector<std::vector<SkeletonPath>> skeleton(const VesselVoxels& vessel, const std::vector<int>& roots,
                                                const SkeletonOptions& options) {
  const SpanningTree tree = span(vessel, roots, options);
  std::vector<std::vector<SkeletonPath>> all;
  all.reserve(roots.size());
  for (const int root : roots) all.push_back(Extraction(vessel, tree, options).paths_from(root));
  return all;
}

int thickest_end(const VesselVoxels& vessel, const std::vector<int>& piece, const SkeletonOptions& options,
                 const std::vector<float>* favoured) {
  require(!piece.empty(), "thickest_end needs voxels");
  const int middle = *std::max_element(piece.begin(), piece.end(), [&](int a, int b) {
    return std::tie(vessel.radius_mm[a], b) < std::tie(vessel.radius_mm[b], a);
  });
  // From one end all others are tips of paths.
  const SpanningTree tree = span(vessel, {middle}, options);
  const int start = *std::max_element(piece.begin(), piece.end(), [&](int a, int b) {
    return std::tie(tree.from_root_mm[a], b) < std::tie(tree.from_root_mm[b], a);
  });
  const double stretch = 3.0 * vessel.radius_mm[middle];
  const auto thickness_at = [&](auto voxel, auto end) {
    const int tip = *voxel;
    double length = 0.0, sum = 0.0;
    int count = 0;
    for (int last = tip; voxel != end && length <= stretch; last = *voxel, ++voxel, ++count) {
      length += (vessel.position_mm(*voxel) - vessel.position_mm(last)).norm();
      sum += vessel.radius_mm[*voxel];
    }
    return sum / count * (favoured != nullptr ? (*favoured)[tip] : 1.0F);
  };
  const std::vector<SkeletonPath> paths = skeleton(vessel, {start}, options).front();
  std::vector<int> from_start(paths.front().voxels.rbegin(), paths.front().voxels.rend());
  int best = with_straight_tip(vessel, std::move(from_start)).back();
  double best_thickness = thickness_at(paths.front().voxels.begin(), paths.front().voxels.end());
  for (const SkeletonPath& path : paths) {
    const double thickness = thickness_at(path.voxels.rbegin(), path.voxels.rend());
    if (thickness <= best_thickness) continue;
    best_thickness = thickness;
    best = path.voxels.back();
  }
  return best;
}

}  // namespace glisson::model
