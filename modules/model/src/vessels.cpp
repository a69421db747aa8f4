// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessels.h"

#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "vessel_tree.h"

namespace glisson::model {
namespace {

constexpr double kLeastPieceMm3 = 150.0;   // smaller pieces carry nothing
constexpr double kLeastPieceShare = 0.02;  // of the largest piece
constexpr double kFarthestRootMm = 20.0;   // a root point farther from its vessel is a mistake
constexpr double kNearSurfaceMm = 8.0, kNearCavaMm = 15.0;
constexpr float kFavour = 1.4F;  // how much thicker an unfavoured end must be
constexpr double kShortestSpacingMm = 4.0, kLongestSpacingMm = 20.0;
constexpr double kMostTurn = 1.2;      // radians that a beam may span where beams are short
constexpr double kMostBeams = 1.15;    // of the target, before branches are pruned
constexpr double kKeptRadiusMm = 2.0;  // what is as thick stays, however many beams it takes

/// One piece of a vessel on a grid of its own, with a margin.
struct Piece {
  VolumeGrid grid;
  VesselVoxels vessel;
};

Piece piece_of(const VesselMask& mask, const Mask& whole, const std::vector<int>& voxels) {
  const int row = whole.size.x(), slice = row * whole.size.y();
  const auto index = [&](int v) { return Eigen::Vector3i(v % row, v % slice / row, v / slice); };
  Eigen::Vector3i low = index(voxels.front()), high = low;
  for (const int v : voxels) {
    low = low.cwiseMin(index(v));
    high = high.cwiseMax(index(v));
  }
  const Eigen::Vector3i margin = Eigen::Vector3i::Ones();
  Piece piece;
  piece.grid = mask.grid;
  piece.grid.size = high - low + 3 * margin;
  piece.grid.origin_mm = 1e3 * mask.grid.p_in_ct((low - margin).cast<double>()).xyz;
  Mask own(piece.grid.size, piece.grid.spacing_mm);
  for (const int v : voxels)
    own.voxels[static_cast<std::size_t>(piece.grid.offset(index(v) - low + margin))] = 1;
  piece.vessel = measure_vessel(std::move(own));
  return piece;
}

Eigen::Vector3d in_ct(const Piece& piece, int voxel) {
  return piece.grid.p_in_ct(piece.vessel.position_mm(voxel).cwiseQuotient(piece.grid.spacing_mm)).xyz;
}

std::vector<int> voxels_of(const Piece& piece) {
  std::vector<int> voxels;
  for (std::size_t i = 0; i < piece.vessel.mask.voxels.size(); ++i)
    if (piece.vessel.mask.voxels[i] != 0) voxels.push_back(static_cast<int>(i));
  return voxels;
}

/// Where a vessel may enter: a portal vein or an artery at the liver's surface, a hepatic vein at the cava.
std::vector<float> favoured_ends(const Piece& piece, Label structure, const ClosestPointTree& liver,
                                 const ClosestPointTree& cava) {
  const bool at_cava = structure == structure::kHepaticVeins && !cava.empty();
  const ClosestPointTree& tree = at_cava ? cava : liver;
  const double near = 1e-3 * (at_cava ? kNearCavaMm : kNearSurfaceMm);
  std::vector<float> favour(piece.vessel.mask.voxels.size(), 1.0F);
  for (const int voxel : voxels_of(piece))
    if (tree.closest(in_ct(piece, voxel), near).triangle >= 0) favour[voxel] = kFavour;
  return favour;
}

/// Root points of the operator, each given to the piece that it is nearest to.
std::vector<std::vector<int>> roots_by_piece(const std::vector<Piece>& pieces, const Points& points,
                                             Label structure) {
  std::vector<std::vector<int>> roots(pieces.size());
  for (Eigen::Index r = 0; r < points.rows(); ++r) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t piece = 0;
    int voxel = -1;
    for (std::size_t n = 0; n < pieces.size(); ++n)
      for (const int v : voxels_of(pieces[n])) {
        const double far = (in_ct(pieces[n], v) - points.row(r).transpose()).norm();
        if (far >= nearest) continue;
        nearest = far;
        piece = n;
        voxel = v;
      }
    if (voxel < 0 || nearest > 1e-3 * kFarthestRootMm)
      throw InputError("roots", structure_name(structure) + " root " + std::to_string(r + 1),
                       "lies " + shown(1e3 * nearest) + " mm from the vessel",
                       "Place it on the vessel's entrance");
    std::vector<int>& own = roots[piece];
    if (std::find(own.begin(), own.end(), voxel) == own.end()) own.push_back(voxel);  // one tree a voxel
  }
  return roots;
}

std::vector<Piece> pieces_of(const VesselMask& mask, std::vector<std::string>& notes) {
  VesselVoxels whole;
  // A margin all around: neighbours are looked at without asking.
  VesselMask padded = mask;
  padded.grid.size.array() += 2;
  padded.grid.origin_mm = 1e3 * mask.grid.p_in_ct(Eigen::Vector3d::Constant(-1.0)).xyz;
  whole.mask = Mask(padded.grid.size, padded.grid.spacing_mm);
  for (int k = 0; k < mask.grid.size.z(); ++k)
    for (int j = 0; j < mask.grid.size.y(); ++j)
      for (int i = 0; i < mask.grid.size.x(); ++i)
        whole.mask.voxels[whole.mask.offset(i + 1, j + 1, k + 1)] =
            mask.voxels[static_cast<std::size_t>(mask.grid.offset({i, j, k}))];
  std::vector<Piece> pieces;
  int dropped = 0;
  double dropped_mm3 = 0.0, largest = 0.0;
  for (const std::vector<int>& voxels : vessel_pieces(whole)) {
    const double volume = static_cast<double>(voxels.size()) * mask.grid.voxel_volume_mm3();
    largest = std::max(largest, volume);
    if (volume < std::max(kLeastPieceMm3, kLeastPieceShare * largest)) {
      ++dropped;
      dropped_mm3 += volume;
      continue;
    }
    pieces.push_back(piece_of(padded, whole.mask, voxels));
  }
  if (dropped > 0)
    notes.push_back("vessels.pieces_dropped " + structure_name(mask.structure) + " " +
                    std::to_string(dropped) + " ml " + shown(1e-3 * dropped_mm3));
  return pieces;
}

std::size_t beam_count(const std::vector<FittedTree>& trees, const FittedTree::Sampling& sampling) {
  std::size_t count = 0;
  for (const FittedTree& tree : trees) count += tree.sample(sampling).beams.size();
  return count;
}

/// The beam length that gives about the wanted number; branches go, thinnest and of those shortest first,
/// where even long beams are too many.
std::vector<VesselTree> sampled(std::vector<FittedTree> trees, int target, std::vector<std::string>& notes) {
  FittedTree::Sampling sampling;
  sampling.longest_mm = kLongestSpacingMm;
  const auto most = static_cast<std::size_t>(kMostBeams * target);
  // Better a coarser bend than a branch less.
  while (sampling.turn < kMostTurn && beam_count(trees, sampling) > most) sampling.turn *= 1.25;
  int pruned = 0;
  double pruned_mm = 0.0, thickest_mm = 0.0;
  while (beam_count(trees, sampling) > most) {
    const auto next = std::min_element(
        trees.begin(), trees.end(),
        [](const FittedTree& a, const FittedTree& b) { return a.next_to_prune().before(b.next_to_prune()); });
    const FittedTree::Leaf leaf = next == trees.end() ? FittedTree::Leaf() : next->next_to_prune();
    if (leaf.branch < 0 || leaf.radius_mm >= kKeptRadiusMm) break;
    next->prune(leaf);
    pruned_mm += leaf.length_mm;
    thickest_mm = std::max(thickest_mm, leaf.radius_mm);
    ++pruned;
  }
  if (pruned > 0)
    notes.push_back("vessels.branches_pruned " + std::to_string(pruned) + " mm " + shown(pruned_mm));
  if (pruned > 0) notes.push_back("vessels.pruned_radius_mm " + shown(thickest_mm));
  double shortest = kShortestSpacingMm, longest = kLongestSpacingMm;
  for (int pass = 0; pass < 12; ++pass) {
    sampling.longest_mm = 0.5 * (shortest + longest);
    (beam_count(trees, sampling) > static_cast<std::size_t>(target) ? shortest : longest) =
        sampling.longest_mm;
  }
  sampling.longest_mm = longest;
  std::vector<VesselTree> result;
  result.reserve(trees.size());
  for (const FittedTree& tree : trees) result.push_back(tree.sample(sampling));
  return result;
}

}  // namespace

Cancellable<std::vector<VesselTree>> vessel_trees(const Anatomy& anatomy, const ModelOptions& options,
                                                  std::vector<std::string>& notes,
                                                  const RunContext& context) {
  const ClosestPointTree liver(anatomy.fine_liver);
  const ClosestPointTree cava =
      anatomy.vena_cava() != nullptr ? ClosestPointTree(*anatomy.vena_cava()) : ClosestPointTree();
  const SkeletonOptions skeleton_options;
  std::vector<FittedTree> trees;
  for (std::size_t n = 0; n < anatomy.vessels.size(); ++n) {
    const VesselMask& mask = anatomy.vessels[n];
    context.progress(static_cast<double>(n) / static_cast<double>(anatomy.vessels.size()), "model.skeleton");
    const std::vector<Piece> pieces = pieces_of(mask, notes);
    const Points& given = mask.structure == structure::kPortalVein     ? options.portal_root
                          : mask.structure == structure::kHepaticVeins ? options.hepatic_root
                                                                       : Points();
    std::vector<std::vector<int>> roots = roots_by_piece(pieces, given, mask.structure);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      if (context.cancelled()) return {};
      if (roots[p].empty()) {
        const std::vector<float> favour = favoured_ends(pieces[p], mask.structure, liver, cava);
        roots[p] = {thickest_end(pieces[p].vessel, voxels_of(pieces[p]), skeleton_options, &favour)};
      }
      for (const auto& paths : skeleton(pieces[p].vessel, roots[p], skeleton_options))
        trees.emplace_back(pieces[p].vessel, pieces[p].grid, paths, mask.structure);
    }
    notes.push_back("vessels.pieces " + structure_name(mask.structure) + " " + std::to_string(pieces.size()));
  }
  context.progress(1.0, "model.skeleton");
  return sampled(std::move(trees), options.target_beams, notes);
}

}  // namespace glisson::model
