// SPDX-License-Identifier: GPL-3.0-or-later
#include "connections.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "glisson/core/error.h"
#include "glisson/volume/shells.h"

namespace glisson::segmentation {
namespace {

using Voxels = std::vector<std::uint8_t>;

/// Cross-sections' middles from the root to a tip, indices of the volume.
using Way = std::vector<Eigen::Vector3d>;

bool is_set(const VolumeGrid& grid, const Voxels& mask, const Eigen::Vector3d& index) {
  const Eigen::Vector3i v = index.array().round().matrix().cast<int>();
  return grid.contains(v) && mask[static_cast<std::size_t>(grid.offset(v))] != 0;
}

/// Whether a branch ends at `tip`: the way back is long enough before another branch joins it, and nothing
/// that starts beside it runs on farther (the wall's bumps end in pieces, too).
bool ends_a_branch(const Shells& shells, int tip, double least_mm) {
  const double end = shells.pieces[static_cast<std::size_t>(tip)].distance_mm;
  for (int n = tip; n >= 0;) {
    const Shells::Piece& piece = shells.pieces[static_cast<std::size_t>(n)];
    if (end - piece.distance_mm >= least_mm) return true;
    if (piece.parent < 0) return false;
    for (const int other : shells.pieces[static_cast<std::size_t>(piece.parent)].children) {
      const int height = shells.pieces[static_cast<std::size_t>(other)].height;
      if (other != n && (height >= 2 || height > piece.height || (height == piece.height && other < n)))
        return false;
    }
    n = piece.parent;
  }
  return false;
}

/// Ways to the tips in the part of a tree that is joined to its root.
void add_ways(const VolumeGrid& grid, const Shells& shells, const Voxels& counted, double least_mm,
              std::vector<Way>& ways) {
  for (std::size_t n = 0; n < shells.pieces.size(); ++n) {
    const Shells::Piece& tip = shells.pieces[n];
    if (!tip.children.empty() || !is_set(grid, counted, tip.centre) ||
        !ends_a_branch(shells, static_cast<int>(n), least_mm))
      continue;
    Way way;
    for (int at = static_cast<int>(n); at >= 0; at = shells.pieces[static_cast<std::size_t>(at)].parent) {
      const Eigen::Vector3d& centre = shells.pieces[static_cast<std::size_t>(at)].centre;
      if (is_set(grid, counted, centre)) way.push_back(centre);
    }
    std::reverse(way.begin(), way.end());
    ways.push_back(std::move(way));
  }
}

std::vector<Way> ways_of(const LabelMap& labels, Label tree, const Voxels& liver, double least_mm) {
  const VolumeGrid& grid = labels.voxels.grid();
  const bool hepatic = tree == structure::kHepaticVeins;
  const Voxels all = labels.voxels.mask(
      [=](Label label) { return label == tree || (hepatic && label == structure::kVenaCava); });
  Voxels counted = labels.voxels.mask([=](Label label) { return label == tree; });
  for (std::size_t i = 0; i < counted.size(); ++i) counted[i] = counted[i] != 0 && liver[i] != 0;
  std::vector<Way> ways;
  // Parts that are not joined have roots of their own; specks have no ways.
  constexpr double kSpeck = 50.0;  // mm3
  for (const Shells& shells : shells_of_each(grid, all, kSpeck))
    add_ways(grid, shells, counted, least_mm, ways);
  return ways;
}

/// Connected pieces (26 neighbours) of a label, numbered from 1 in a box.
struct Pieces {
  VoxelBox box;
  Eigen::Vector3i size;
  std::vector<int> number;
};

Pieces pieces_of(const LabelMap& labels, Label tree) {
  const VolumeGrid& grid = labels.voxels.grid();
  const Voxels mask = labels.voxels.mask([=](Label label) { return label == tree; });
  Pieces pieces{bounding_box(grid.size, grid.spacing_mm, mask, 0.0), {0, 0, 0}, {}};
  if (pieces.box.empty()) return pieces;
  const Mask part = crop(grid.size, grid.spacing_mm, mask, pieces.box);
  pieces.size = part.size;
  pieces.number.assign(part.voxels.size(), 0);
  int count = 0;
  for (const auto& patch : patches_of(part)) {
    ++count;
    for (const std::size_t at : patch) pieces.number[at] = count;
  }
  return pieces;
}

/// Numbers of the pieces within reach of a place.
std::vector<int> near(const Pieces& pieces, const VolumeGrid& grid, const Eigen::Vector3d& index,
                      double reach_mm) {
  std::vector<int> numbers;
  const Eigen::Vector3d place = index - pieces.box.low.cast<double>();
  Eigen::Vector3i low, high;
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = reach_mm / grid.spacing_mm[axis];
    low[axis] = std::max(0, static_cast<int>(std::ceil(place[axis] - reach)));
    high[axis] = std::min(pieces.size[axis] - 1, static_cast<int>(std::floor(place[axis] + reach)));
  }
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i) {
        const int number = pieces.number[static_cast<std::size_t>(
            i + pieces.size.x() * (j + static_cast<long>(pieces.size.y()) * k))];
        if (number == 0 || std::find(numbers.begin(), numbers.end(), number) != numbers.end()) continue;
        if ((Eigen::Vector3d(i, j, k) - place).cwiseProduct(grid.spacing_mm).norm() <= reach_mm)
          numbers.push_back(number);
      }
  return numbers;
}

bool lies_along(const Pieces& pieces, const VolumeGrid& grid, const Way& way,
                const ConnectionOptions& options) {
  if (pieces.number.empty() || way.empty()) return false;
  std::map<int, std::size_t> hits;
  for (const Eigen::Vector3d& place : way)
    for (const int number : near(pieces, grid, place, options.reach_mm)) ++hits[number];
  const std::vector<int> at_tip = near(pieces, grid, way.back(), options.reach_mm);
  const double wanted = options.least_share * static_cast<double>(way.size());
  return std::any_of(at_tip.begin(), at_tip.end(),
                     [&](int number) { return static_cast<double>(hits[number]) >= wanted; });
}

}  // namespace

void ConnectionOptions::validate() const {
  if (!(least_branch_mm > 0.0 && least_branch_mm <= 100.0))
    throw InputError("connections", "least_branch_mm", "is " + std::to_string(least_branch_mm),
                     "Choose up to 100 mm");
  if (!(reach_mm > 0.0 && reach_mm <= 20.0))
    throw InputError("connections", "reach_mm", "is " + std::to_string(reach_mm), "Choose up to 20 mm");
  if (!(least_share > 0.0 && least_share <= 1.0))
    throw InputError("connections", "least_share", "is " + std::to_string(least_share), "Choose up to 1");
}

Connections count_connections(const LabelMap& of, const LabelMap& in, Label tree, const Voxels& liver,
                              const ConnectionOptions& options) {
  options.validate();
  const VolumeGrid& grid = of.voxels.grid();
  require(grid.same_as(in.voxels.grid()) && static_cast<long>(liver.size()) == grid.voxel_count(),
          "segmentations whose trees are compared have one grid");
  Connections connections;
  const Pieces pieces = pieces_of(in, tree);
  for (const Way& way : ways_of(of, tree, liver, options.least_branch_mm)) {
    ++connections.ways;
    connections.found += lies_along(pieces, grid, way, options) ? 1 : 0;
  }
  return connections;
}

}  // namespace glisson::segmentation
