// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_to_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/quality.h"

namespace glisson::model {
namespace {

constexpr double kTolerance = 0.10;  // of the number of nodes
constexpr double kSearchTolerance = 0.04;
constexpr int kSearchPasses = 10;
// Perturbation gives up at the first sliver that it cannot better, which happens in about half of all meshes
// with lesions. Then the next pair of edge length and number of smoothing passes is tried.
constexpr std::array<int, 4> kPasses = {20, 5, 10, 2};
constexpr std::array<double, 3> kSizes = {1.0, 1.015, 0.985};
constexpr double kMostVertices = 200000;
constexpr std::size_t kAttempts = kPasses.size() * kSizes.size();
/// Mean edge of a finished mesh over the cube root of its volume a node; measured on livers.
constexpr double kMeanEdgeOverRoot = 1.32;
constexpr double kEdgesAcrossLesion = 0.7;  // edge length over a lesion's diameter, at most

/// A lesion gets elements that can show it, however small it is against the others.
MesherSizes sizes_of(double edge, const MesherInput& input, const MeshOptions& options) {
  MesherSizes sizes{edge, {}, edge * options.vessel_refinement};
  for (const auto& [label, field] : input.inclusions) {
    const double diameter = std::cbrt(6.0 / std::numbers::pi * field.volume());
    sizes.inclusion_edges.push_back(
        std::min(edge * options.lesion_refinement, kEdgesAcrossLesion * diameter));
  }
  return sizes;
}

/// The mesher's edge length at which bare refinement gives the wanted number of nodes, or mean edge. Nodes go
/// with a power of the edge between -2 (a thin body, all surface) and -3: a secant on logarithms.
std::optional<double> find_edge(const MesherInput& input, const MeshOptions& options,
                                const RunContext& context) {
  const bool by_edge = options.edge_mm > 0.0;
  const double wanted = std::log(by_edge ? 1e-3 * options.edge_mm : options.target_vertices);
  double edge = 1.25 * typical_edge(input.body.volume(), options);
  double best_edge = edge, best_miss = std::numeric_limits<double>::infinity();
  double last_log_edge = 0.0, last_log_met = 0.0, slope = by_edge ? 1.0 : -2.6;
  for (int pass = 0; pass < kSearchPasses; ++pass) {
    const double done = static_cast<double>(pass) / kSearchPasses;
    const auto mesh =
        fill_with_tetrahedra(input, sizes_of(edge, input, options), 0, context.part(done, done));
    if (!mesh) return {};
    const double log_edge = std::log(edge);
    const double log_met = std::log(by_edge ? std::max(1e-3, mean_edge_length(*mesh))
                                            : std::max(4.0, double(mesh->vertex_count())));
    const double miss = std::abs(log_met - wanted);
    if (miss < best_miss) {
      best_miss = miss;
      best_edge = edge;
    }
    if (miss < std::log1p(kSearchTolerance)) break;
    if (pass > 0 && std::abs(log_edge - last_log_edge) > 1e-3)
      slope = std::clamp((log_met - last_log_met) / (log_edge - last_log_edge), by_edge ? 0.5 : -3.2,
                         by_edge ? 1.5 : -1.4);
    last_log_edge = log_edge;
    last_log_met = log_met;
    edge = std::exp(log_edge + std::clamp((wanted - log_met) / slope, -0.7, 0.7));
  }
  return best_edge;
}

double vertices_expected(double volume, const MeshOptions& options) {
  const double edge = typical_edge(volume, options);
  return volume / (edge * edge * edge);
}

struct Flaws {
  double dihedral = 0.0;  ///< smallest, degrees
  bool whole = false;     ///< boundary closed, manifold, one piece
  double off_target = 0.0;
  bool acceptable() const { return whole && dihedral >= kLeastDihedral && off_target <= kTolerance; }
  bool better_than(const Flaws& other) const {
    if (whole != other.whole) return whole;
    if ((off_target <= kTolerance) != (other.off_target <= kTolerance)) return off_target <= kTolerance;
    return dihedral > other.dihedral;
  }
};

Flaws flaws_of(const TetMesh& mesh, const MeshOptions& options) {
  Flaws flaws;
  flaws.dihedral = mesh.tetrahedron_count() > 0 ? dihedral_angles(mesh).col(0).minCoeff() : 0.0;
  const BoundarySurface surface = boundary_surface(mesh);
  int pieces = 0;
  connected_components(surface.mesh, &pieces);
  flaws.whole = is_closed(surface.mesh) && pieces == 1;
  if (options.edge_mm == 0.0)
    flaws.off_target = std::abs(static_cast<double>(mesh.vertex_count()) / options.target_vertices - 1.0);
  return flaws;
}

}  // namespace

double typical_edge(double volume, const MeshOptions& options) {
  return options.edge_mm > 0.0 ? 1e-3 * options.edge_mm / kMeanEdgeOverRoot
                               : std::cbrt(volume / options.target_vertices);
}

Cancellable<TetMesh> mesh_to_size(const MesherInput& input, const MeshOptions& options,
                                  std::vector<std::string>& notes, const RunContext& context) {
  options.validate();
  if (options.edge_mm > 0.0 && vertices_expected(input.body.volume(), options) > kMostVertices)
    throw InputError("mesh options", "edge_mm",
                     std::to_string(options.edge_mm) + " would give more than 200000 vertices",
                     "Ask for longer edges");
  const std::optional<double> found = find_edge(input, options, context.part(0.0, 0.3));
  if (!found) return {};
  TetMesh best;
  Flaws best_flaws;
  double done = 0.3;
  for (std::size_t attempt = 0; attempt < kAttempts; ++attempt) {
    const double from = done;
    done = 0.5 * (1.0 + done);  // more attempts may follow: each takes half of what is left
    const double edge = *found * kSizes[attempt / kPasses.size()];
    auto mesh = fill_with_tetrahedra(input, sizes_of(edge, input, options), kPasses[attempt % kPasses.size()],
                                     context.part(from, done));
    if (!mesh) return {};
    const Flaws flaws = flaws_of(*mesh, options);
    if (attempt == 0 || flaws.better_than(best_flaws)) {
      best = std::move(*mesh);
      best_flaws = flaws;
    }
    if (best_flaws.acceptable()) break;
  }
  if (best.tetrahedron_count() == 0)
    throw NumericalError("The mesher filled nothing. Check that the surface encloses a volume.");
  if (!best_flaws.whole) notes.push_back("mesh.boundary_not_manifold");
  if (best_flaws.dihedral < kLeastDihedral)
    notes.push_back("mesh.sliver_deg " + std::to_string(best_flaws.dihedral));
  if (best_flaws.off_target > kTolerance)
    notes.push_back("mesh.vertices_off_target " + std::to_string(best.vertex_count()));
  check_tetrahedra(best, "mesh");
  context.progress(1.0, "model.mesh.size");
  return best;
}

}  // namespace glisson::model
