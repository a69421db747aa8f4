// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/bridges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/volume/shells.h"

namespace glisson::editing {
namespace {

constexpr double kClickReach = 5.0;  // mm
constexpr double kCutReach = 6.0;    // mm of way on either side of the click
constexpr double kSmoothing = 5.0;   // mm of way over which a cross-section is averaged
constexpr double kWideAgain = 2.0;   // times a neck's cross-section
constexpr double kForkReach = 3.0;   // mm before two branches part, at least, that mean one of them
constexpr double kForkRadii = 1.5;   // or so many radii: they part about one behind where their axes meet
constexpr int kBeginning = 4;        // pieces of a branch by which it is known

std::vector<std::uint8_t> mask_of(const LabelVolume& labels, Label label) {
  return labels.mask([=](Label l) { return l == label; });
}

/// Faces of each contact voxel with the other tree, mm2; only voxels that have any.
struct Contact {
  Mask touching;
  std::vector<double> area;  ///< of the box's voxels
};

Contact contact_of(const VolumeGrid& grid, const VoxelBox& box, const Mask& portal, const Mask& hepatic) {
  Contact contact{Mask(box.size(), grid.spacing_mm), std::vector<double>(portal.voxels.size(), 0.0)};
  const std::array<Eigen::Vector3i, 3> axes = {Eigen::Vector3i::UnitX(), Eigen::Vector3i::UnitY(),
                                               Eigen::Vector3i::UnitZ()};
  std::size_t at = 0;
  for (int k = 0; k < portal.size.z(); ++k)
    for (int j = 0; j < portal.size.y(); ++j)
      for (int i = 0; i < portal.size.x(); ++i, ++at)
        for (int axis = 0; axis < 3; ++axis) {
          const Eigen::Vector3i w = Eigen::Vector3i(i, j, k) + axes[static_cast<std::size_t>(axis)];
          if (w[axis] >= portal.size[axis]) continue;
          const std::size_t other = portal.offset(w.x(), w.y(), w.z());
          const bool meet = (portal.voxels[at] != 0 && hepatic.voxels[other] != 0) ||
                            (hepatic.voxels[at] != 0 && portal.voxels[other] != 0);
          if (!meet) continue;
          contact.touching.voxels[at] = contact.touching.voxels[other] = 1;
          contact.area[at] += grid.voxel_volume_mm3() / grid.spacing_mm[axis];
        }
  return contact;
}

Bridge bridge_of(const VolumeGrid& grid, const VoxelBox& box, const Contact& contact,
                 const std::vector<std::size_t>& patch) {
  const auto place = [&](std::size_t at) {
    const int n = static_cast<int>(at), nx = contact.touching.size.x(), ny = contact.touching.size.y();
    return Eigen::Vector3i(n % nx, n / nx % ny, n / (nx * ny)).cast<double>().eval();
  };
  Bridge bridge;
  Eigen::Vector3d middle(0, 0, 0);
  for (const std::size_t at : patch) {
    middle += place(at) / static_cast<double>(patch.size());
    bridge.contact_mm2 += contact.area[at];
  }
  bridge.voxels = static_cast<long>(patch.size());
  double best = 1e30;
  for (const std::size_t at : patch) {
    const double d2 = (place(at) - middle).cwiseProduct(grid.spacing_mm).squaredNorm();
    if (d2 >= best) continue;
    best = d2;
    bridge.p_in_ct = grid.p_in_ct(box.low.cast<double>() + place(at));
  }
  return bridge;
}

/// The mean cross-section over the pieces from `n` outwards and inwards, as far as the way allows.
std::vector<double> smoothed_areas(const Shells& shells) {
  const int steps = std::max(1, static_cast<int>(std::lround(0.5 * kSmoothing / shells.thickness_mm)));
  std::vector<double> result(shells.pieces.size());
  for (std::size_t n = 0; n < result.size(); ++n) {
    double sum = shells.pieces[n].area_mm2, count = 1.0;
    int up = static_cast<int>(n), down = up;
    for (int step = 0; step < steps; ++step) {
      up = up >= 0 ? shells.pieces[static_cast<std::size_t>(up)].parent : -1;
      if (up >= 0) sum += shells.pieces[static_cast<std::size_t>(up)].area_mm2, count += 1.0;
      const std::vector<int> next = shells.branches_of(down);
      if (next.size() != 1) continue;
      down = next.front();
      sum += shells.pieces[static_cast<std::size_t>(down)].area_mm2, count += 1.0;
    }
    result[n] = sum / count;
  }
  return result;
}

/// Necks of one tree piece: places that are no wider than their neighbours, and narrow against what follows.
void add_joints(const VolumeGrid& grid, const Shells& shells, Label tree, double least_ml,
                std::vector<Joint>& joints) {
  const std::vector<double> wide = smoothed_areas(shells);
  std::vector<double> widest = wide, volume(wide.size());
  for (std::size_t n = wide.size(); n-- > 0;) {  // children before parents
    volume[n] += shells.pieces[n].volume_mm3;
    const int parent = shells.pieces[n].parent;
    if (parent < 0) continue;
    const auto p = static_cast<std::size_t>(parent);
    widest[p] = std::max(widest[p], widest[n]);
    volume[p] += volume[n];
  }
  for (std::size_t n = 1; n < wide.size(); ++n) {
    const Shells::Piece& piece = shells.pieces[n];
    if (piece.parent <= 0 || widest[n] < kWideAgain * piece.area_mm2 || 1e-3 * volume[n] < least_ml) continue;
    const double before = shells.pieces[static_cast<std::size_t>(piece.parent)].area_mm2;
    const std::vector<int> next = shells.branches_of(static_cast<int>(n));
    const bool narrowest = piece.area_mm2 < before && std::all_of(next.begin(), next.end(), [&](int child) {
                             return piece.area_mm2 <= shells.pieces[static_cast<std::size_t>(child)].area_mm2;
                           });
    if (!narrowest) continue;
    joints.push_back({tree, grid.p_in_ct(piece.centre), piece.area_mm2, widest[n], 1e-3 * volume[n]});
  }
}

/// The piece with the thinnest cross-section near that of the click, without passing a fork.
int thinnest_near(const Shells& shells, int clicked) {
  const auto& pieces = shells.pieces;
  int best = clicked;
  const auto consider = [&](int n) {
    if (pieces[static_cast<std::size_t>(n)].parent >= 0 &&
        pieces[static_cast<std::size_t>(n)].area_mm2 < pieces[static_cast<std::size_t>(best)].area_mm2)
      best = n;
  };
  const double way = pieces[static_cast<std::size_t>(clicked)].distance_mm;
  for (int n = clicked; n > 0 && way - pieces[static_cast<std::size_t>(n)].distance_mm <= kCutReach;
       n = pieces[static_cast<std::size_t>(n)].parent) {
    consider(n);
    const int parent = pieces[static_cast<std::size_t>(n)].parent;
    if (parent < 0 || shells.branches_of(parent).size() > 1) break;
  }
  for (int n = clicked; pieces[static_cast<std::size_t>(n)].distance_mm - way <= kCutReach;) {
    consider(n);
    const std::vector<int> children = shells.branches_of(n);
    if (children.size() != 1) break;
    n = children.front();
  }
  return best;
}

/// The beginning of a branch, up to the next fork.
std::vector<int> beginning(const Shells& shells, int child) {
  std::vector<int> pieces{child};
  while (static_cast<int>(pieces.size()) < kBeginning && shells.branches_of(pieces.back()).size() == 1)
    pieces.push_back(shells.branches_of(pieces.back()).front());
  return pieces;
}

/// The first fork within reach of a click, as a hand means it; -1: none.
int fork_near(const Shells& shells, int clicked) {
  const Shells::Piece& piece = shells.pieces[static_cast<std::size_t>(clicked)];
  // The root's piece is a ball: its volume says nothing of a cross-section.
  const double reach = piece.parent < 0
                           ? kForkReach
                           : std::max(kForkReach, kForkRadii * std::sqrt(piece.area_mm2 / std::numbers::pi));
  for (int n = clicked;;) {
    const std::vector<int> next = shells.branches_of(n);
    if (next.size() != 1) return next.empty() ? -1 : n;
    n = next.front();
    if (shells.pieces[static_cast<std::size_t>(n)].distance_mm - piece.distance_mm > reach) return -1;
  }
}

/// Where to cut for a click. At a fork a branch behind it is meant, the one nearest to the click, and never
/// the trunk before it; but a neck before it is one: there a part of another tree hangs by its side.
/// @param p_mm the click, an index of the volume times its spacing.
int cut_for(const Shells& shells, int clicked, const Eigen::Vector3d& p_mm,
            const Eigen::Vector3d& spacing_mm) {
  const auto& pieces = shells.pieces;
  const int cut = thinnest_near(shells, clicked), fork = fork_near(shells, clicked);
  if (fork < 0) return cut;
  int best = -1;
  double least = std::numeric_limits<double>::infinity(), widest = 0.0;
  for (const int child : shells.branches_of(fork))
    for (const int n : beginning(shells, child)) {
      const Shells::Piece& piece = pieces[static_cast<std::size_t>(n)];
      const double far = (piece.centre.cwiseProduct(spacing_mm) - p_mm).norm();
      widest = std::max(widest, piece.area_mm2);
      if (far >= least) continue;
      least = far;
      best = child;
    }
  const bool neck = pieces[static_cast<std::size_t>(cut)].parent >= 0 &&
                    widest >= kWideAgain * pieces[static_cast<std::size_t>(cut)].area_mm2;
  return neck ? cut : thinnest_near(shells, best);
}

}  // namespace

std::vector<Bridge> find_bridges(const LabelMap& labels) {
  const VolumeGrid& grid = labels.voxels.grid();
  const std::vector<std::uint8_t> portal = mask_of(labels.voxels, structure::kPortalVein),
                                  hepatic = mask_of(labels.voxels, structure::kHepaticVeins);
  // Contacts lie where both boxes overlap, a voxel more.
  const VoxelBox a = bounding_box(grid.size, grid.spacing_mm, portal, grid.spacing_mm.maxCoeff()),
                 b = bounding_box(grid.size, grid.spacing_mm, hepatic, grid.spacing_mm.maxCoeff());
  const VoxelBox box{a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)};
  if (a.empty() || b.empty() || box.empty()) return {};
  const Contact contact = contact_of(grid, box, crop(grid.size, grid.spacing_mm, portal, box),
                                     crop(grid.size, grid.spacing_mm, hepatic, box));
  std::vector<Bridge> bridges;
  for (const auto& patch : patches_of(contact.touching))
    bridges.push_back(bridge_of(grid, box, contact, patch));
  std::stable_sort(bridges.begin(), bridges.end(),
                   [](const Bridge& x, const Bridge& y) { return x.contact_mm2 > y.contact_mm2; });
  return bridges;
}

std::vector<Joint> find_joined(const LabelMap& labels, double least_ml) {
  const VolumeGrid& grid = labels.voxels.grid();
  std::vector<Joint> joints;
  for (const Label tree : {structure::kPortalVein, structure::kHepaticVeins}) {
    // A part cannot hang on what is smaller than itself.
    for (const Shells& shells : shells_of_each(grid, mask_of(labels.voxels, tree), 1e3 * least_ml))
      add_joints(grid, shells, tree, least_ml, joints);
  }
  std::stable_sort(joints.begin(), joints.end(),
                   [](const Joint& x, const Joint& y) { return x.beyond_ml > y.beyond_ml; });
  return joints;
}

LabelVolume reassign_branch(const LabelVolume& labels, Label from, Label to, const Point<CtFrame>& p,
                            const std::optional<Point<CtFrame>>& root) {
  const VolumeGrid& grid = labels.grid();
  std::vector<std::uint8_t> tree = mask_of(labels, from);
  const auto click = nearest_set(grid, tree, grid.index_of(p), kClickReach);
  if (!click)
    throw InputError("click", "", "has no voxel of " + structure_name(from) + " within 5 mm",
                     "Click on the branch that is to change");
  // The thickest place of the piece that was clicked, not of another one.
  const Shells own = shells_of(grid, tree, click->cast<double>());
  std::fill(tree.begin(), tree.end(), std::uint8_t{0});
  paste(own.grid, own.box, grid.size, tree);
  const Shells shells =
      shells_of(grid, tree, root ? std::optional<Eigen::Vector3d>(grid.index_of(*root)) : std::nullopt);
  const Eigen::Vector3i v = *click - shells.box.low;
  const int clicked = shells.piece[shells.grid.offset(v.x(), v.y(), v.z())];
  const int cut = cut_for(shells, clicked, grid.index_of(p).cwiseProduct(grid.spacing_mm), grid.spacing_mm);
  if (shells.pieces[static_cast<std::size_t>(cut)].parent < 0)
    throw InputError("click", "", "lies at the tree's root", "Click farther out on the branch");
  std::vector<std::uint8_t> moves(shells.pieces.size(), 0);
  for (const int n : shells.beyond(cut)) moves[static_cast<std::size_t>(n)] = 1;
  LabelVolume result = labels;
  std::size_t at = 0;
  for (int k = shells.box.low.z(); k < shells.box.high.z(); ++k)
    for (int j = shells.box.low.y(); j < shells.box.high.y(); ++j)
      for (int i = shells.box.low.x(); i < shells.box.high.x(); ++i, ++at)
        if (shells.piece[at] >= 0 && moves[static_cast<std::size_t>(shells.piece[at])] != 0)
          result.set({i, j, k}, to);
  return result;
}

}  // namespace glisson::editing
