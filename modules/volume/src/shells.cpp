// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <set>

namespace glisson {
namespace {

constexpr double kThickness = 1.5;  // of a shell, in units of the longest side of a voxel
constexpr float kFar = 1e30F;

struct Entry {
  float distance;
  std::size_t at;
  bool operator>(const Entry& other) const {
    return distance != other.distance ? distance > other.distance : at > other.at;
  }
};

template <class Visit>
void each_neighbour(const Mask& grid, std::size_t at, Visit&& visit) {
  const auto nx = static_cast<std::size_t>(grid.size.x()),
             slice = nx * static_cast<std::size_t>(grid.size.y());
  const int i = static_cast<int>(at % nx), j = static_cast<int>((at % slice) / nx),
            k = static_cast<int>(at / slice);
  for (int c = std::max(0, k - 1); c <= std::min(grid.size.z() - 1, k + 1); ++c)
    for (int b = std::max(0, j - 1); b <= std::min(grid.size.y() - 1, j + 1); ++b)
      for (int a = std::max(0, i - 1); a <= std::min(grid.size.x() - 1, i + 1); ++a) {
        const std::size_t other = grid.offset(a, b, c);
        if (other == at || grid.voxels[other] == 0) continue;
        visit(other,
              static_cast<float>(Eigen::Vector3d(a - i, b - j, c - k).cwiseProduct(grid.spacing_mm).norm()));
      }
}

/// Distance in the tree from the ball that fills it at the root.
std::vector<float> distance_from(const Mask& grid, std::size_t root, double radius_mm) {
  std::vector<float> distance(grid.voxels.size(), kFar);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[root] = -static_cast<float>(radius_mm);
  queue.push({distance[root], root});
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.distance > distance[entry.at]) continue;
    each_neighbour(grid, entry.at, [&](std::size_t other, float length) {
      const float next = entry.distance + length;
      if (next >= distance[other]) return;
      distance[other] = next;
      queue.push({next, other});
    });
  }
  return distance;
}

/// The pieces of one shell, found from its voxels in memory order.
class Pieces {
 public:
  Pieces(Shells& shells, const std::vector<float>& distance) : shells_(shells), distance_(distance) {}

  int shell_of(std::size_t at) const {
    return std::max(0, static_cast<int>(std::floor(distance_[at] / shells_.thickness_mm)));
  }
  void add_from(std::size_t seed) {
    const int number = static_cast<int>(shells_.pieces.size()), shell = shell_of(seed);
    Shells::Piece piece;
    std::vector<std::size_t> stack{seed};
    // A step across a voxel's corner is longer than a shell is thick: where only such steps lead on, the
    // piece hangs on the shell before the last one.
    std::array<Below, 2> below;
    double count = 0.0, nearest = kFar;
    shells_.piece[seed] = number;
    while (!stack.empty()) {
      const std::size_t at = stack.back();
      stack.pop_back();
      piece.centre += place_of(at);
      nearest = std::min(nearest, static_cast<double>(distance_[at]));
      count += 1.0;
      each_neighbour(shells_.grid, at, [&](std::size_t other, float) {
        const int there = shell_of(other);
        if (there == shell && shells_.piece[other] < 0) {
          shells_.piece[other] = number;
          stack.push_back(other);
        } else if (there == shell - 1 || there == shell - 2) {
          below[static_cast<std::size_t>(shell - 1 - there)].add(shells_.piece[other], distance_[other]);
        }
      });
    }
    const Below& before = below[below[0].nearest < 0 ? 1 : 0];
    piece.parent = before.nearest;
    piece.centre /= count;
    piece.distance_mm = std::max(0.0, nearest);
    piece.volume_mm3 = count * shells_.grid.spacing_mm.prod();
    piece.area_mm2 = piece.volume_mm3 / shells_.thickness_mm;
    if (before.pieces.size() > 1) shells_.loops += static_cast<int>(before.pieces.size()) - 1;
    shells_.pieces.push_back(piece);
    if (piece.parent >= 0) shells_.pieces[static_cast<std::size_t>(piece.parent)].children.push_back(number);
  }

 private:
  /// Pieces of a shell nearer to the root that a piece touches, and the one with the nearest voxel.
  struct Below {
    std::set<int> pieces;
    int nearest = -1;
    float distance = kFar;
    void add(int piece, float far) {
      pieces.insert(piece);
      if (far < distance) distance = far, nearest = piece;
    }
  };

  Eigen::Vector3d place_of(std::size_t at) const {
    const auto nx = static_cast<std::size_t>(shells_.grid.size.x()),
               slice = nx * static_cast<std::size_t>(shells_.grid.size.y());
    const Eigen::Matrix<std::size_t, 3, 1> v(at % nx, at % slice / nx, at / slice);
    return shells_.box.low.cast<double>() + v.cast<double>();
  }
  Shells& shells_;
  const std::vector<float>& distance_;
};

}  // namespace

std::vector<int> Shells::beyond(int from) const {
  std::vector<int> all{from};
  for (std::size_t n = 0; n < all.size(); ++n) {
    const auto& children = pieces[static_cast<std::size_t>(all[n])].children;
    all.insert(all.end(), children.begin(), children.end());
  }
  return all;
}

std::vector<int> Shells::branches_of(int from) const {
  std::vector<int> branches;
  for (const int child : pieces[static_cast<std::size_t>(from)].children)
    if (pieces[static_cast<std::size_t>(child)].height >= 2) branches.push_back(child);
  return branches;
}

std::optional<Eigen::Vector3i> nearest_set(const VolumeGrid& grid, const std::vector<std::uint8_t>& mask,
                                           const Eigen::Vector3d& index, double reach_mm) {
  std::optional<Eigen::Vector3i> nearest;
  double best = reach_mm * reach_mm;
  Eigen::Vector3i low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = reach_mm / grid.spacing_mm[axis], last = grid.size[axis] - 1.0;
    low[axis] = static_cast<int>(std::clamp(std::floor(index[axis] - reach), 0.0, last));
    high[axis] = static_cast<int>(std::clamp(std::ceil(index[axis] + reach), 0.0, last));
  }
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i) {
        if (mask[static_cast<std::size_t>(grid.offset({i, j, k}))] == 0) continue;
        const double d2 = (Eigen::Vector3d(i, j, k) - index).cwiseProduct(grid.spacing_mm).squaredNorm();
        if (d2 <= best) {
          if (d2 == best && nearest) continue;
          best = d2;
          nearest = Eigen::Vector3i(i, j, k);
        }
      }
  return nearest;
}

std::vector<std::vector<std::size_t>> patches_of(const Mask& mask) {
  std::vector<std::vector<std::size_t>> patches;
  Mask left = mask;
  const int nx = mask.size.x(), ny = mask.size.y();
  for (std::size_t seed = 0; seed < left.voxels.size(); ++seed) {
    if (left.voxels[seed] == 0) continue;
    std::vector<std::size_t> patch{seed};
    left.voxels[seed] = 0;
    for (std::size_t n = 0; n < patch.size(); ++n) {
      const int at = static_cast<int>(patch[n]);
      const int i = at % nx, j = at / nx % ny, k = at / (nx * ny);
      for (int c = std::max(0, k - 1); c <= std::min(mask.size.z() - 1, k + 1); ++c)
        for (int b = std::max(0, j - 1); b <= std::min(ny - 1, j + 1); ++b)
          for (int a = std::max(0, i - 1); a <= std::min(nx - 1, i + 1); ++a) {
            const std::size_t other = mask.offset(a, b, c);
            if (left.voxels[other] == 0) continue;
            left.voxels[other] = 0;
            patch.push_back(other);
          }
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

Shells shells_of(const VolumeGrid& grid, const std::vector<std::uint8_t>& tree,
                 const std::optional<Eigen::Vector3d>& root) {
  Shells shells;
  shells.thickness_mm = kThickness * grid.spacing_mm.maxCoeff();
  // A voxel of nothing around: the depth is measured to it.
  shells.box = bounding_box(grid.size, grid.spacing_mm, tree, grid.spacing_mm.maxCoeff());
  if (shells.box.empty()) return shells;
  shells.grid = crop(grid.size, grid.spacing_mm, tree, shells.box);
  const std::vector<float> depth2 = squared_depth_mm2(shells.grid);
  std::size_t start = 0;
  if (root) {
    const auto place = nearest_set(grid, tree, *root, 1e4);
    const Eigen::Vector3i v = *place - shells.box.low;
    start = shells.grid.offset(v.x(), v.y(), v.z());
  } else {
    const auto finite = [](float d2) { return std::isfinite(d2) ? d2 : 0.0F; };
    for (std::size_t at = 0; at < depth2.size(); ++at)
      if (finite(depth2[at]) > finite(depth2[start])) start = at;
    if (shells.grid.voxels[start] == 0)  // the whole box is tree: it has no thickest place
      start = static_cast<std::size_t>(std::find(shells.grid.voxels.begin(), shells.grid.voxels.end(), 1) -
                                       shells.grid.voxels.begin());
  }
  const double radius = std::isfinite(depth2[start]) ? std::sqrt(depth2[start]) : 0.0;
  const std::vector<float> distance = distance_from(shells.grid, start, radius);
  shells.piece.assign(distance.size(), -1);
  std::vector<std::size_t> order;
  for (std::size_t at = 0; at < distance.size(); ++at)
    if (distance[at] < kFar) order.push_back(at);
  for (std::size_t at = 0; at < distance.size(); ++at)
    if (distance[at] >= kFar) shells.grid.voxels[at] = 0;
  Pieces pieces(shells, distance);
  // Shell after shell: a piece's parent is numbered before it.
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return pieces.shell_of(a) < pieces.shell_of(b); });
  for (const std::size_t at : order)
    if (shells.piece[at] < 0) pieces.add_from(at);
  for (std::size_t n = shells.pieces.size(); n-- > 1;) {
    const Shells::Piece& piece = shells.pieces[n];
    if (piece.parent < 0) continue;
    int& height = shells.pieces[static_cast<std::size_t>(piece.parent)].height;
    height = std::max(height, piece.height + 1);
  }
  return shells;
}

std::vector<Shells> shells_of_each(const VolumeGrid& grid, const std::vector<std::uint8_t>& tree,
                                   double least_mm3) {
  std::vector<Shells> all;
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, tree, 0.0);
  if (box.empty()) return all;
  const Mask part = crop(grid.size, grid.spacing_mm, tree, box);
  auto patches = patches_of(part);
  std::stable_sort(patches.begin(), patches.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  Mask one(part.size, part.spacing_mm);
  std::vector<std::uint8_t> whole(tree.size(), 0);
  for (const auto& patch : patches) {
    if (static_cast<double>(patch.size()) * grid.voxel_volume_mm3() < least_mm3) break;
    for (const std::size_t at : patch) one.voxels[at] = 1;
    paste(one, box, grid.size, whole);
    all.push_back(shells_of(grid, whole, std::nullopt));
    for (const std::size_t at : patch) one.voxels[at] = 0;
  }
  return all;
}

}  // namespace glisson
