// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "anatomy.h"
#include "close_holes.h"
#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"
#include "surface_field.h"

namespace glisson::model {
namespace {

constexpr double kVesselSpacingMm = 1.0;
constexpr double kLesionSamples = 16.0;  // across a lesion

/// Each piece by itself, so that a piece turned inside out still counts as full.
/// @param open receives whether a piece had holes; they are closed.
std::vector<std::uint8_t> voxels_of(const TriangleMesh& surface, const VolumeGrid& grid, bool& open) {
  std::vector<std::uint8_t> all(static_cast<std::size_t>(grid.voxel_count()), 0);
  for (TriangleMesh& piece : split_components(surface)) {
    open |= close_holes(piece);
    const std::vector<std::uint8_t> inside = voxelise(piece, grid);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] |= inside[i];
  }
  return all;
}

/// Vessel voxels in the liver or at its entrances.
/// @param open receives whether the surface had holes.
VesselMask vessel_in_liver(const NamedSurface& vessel, const ScalarField& liver, bool& open) {
  VesselMask mask;
  mask.structure = vessel.structure;
  Points corners(2, 3);  // of what the vessel and the liver share
  corners.row(0) = vessel.mesh.vertices.colwise().minCoeff().cwiseMax(liver.low().transpose());
  corners.row(1) = vessel.mesh.vertices.colwise().maxCoeff().cwiseMin(liver.high().transpose());
  if ((corners.row(0).array() >= corners.row(1).array()).any()) return mask;
  mask.grid = grid_around(corners, kVesselSpacingMm, kEntranceMm + kVesselSpacingMm);
  mask.voxels = voxels_of(vessel.mesh, mask.grid, open);
  for (int k = 0; k < mask.grid.size.z(); ++k)
    for (int j = 0; j < mask.grid.size.y(); ++j)
      for (int i = 0; i < mask.grid.size.x(); ++i) {
        auto& voxel = mask.voxels[static_cast<std::size_t>(mask.grid.offset({i, j, k}))];
        if (voxel != 0 && liver.at(mask.grid.p_in_ct({double(i), double(j), double(k)}).xyz) < -kEntranceMm)
          voxel = 0;
      }
  return mask;
}

/// What of a lesion lies where a depth (mm, of a point in the CT frame, metres) is positive. The same bits
/// where all of it does.
ScalarField clipped(const ScalarField& lesion,
                    const std::function<double(const Eigen::Vector3d&)>& depth_at) {
  const VolumeGrid& grid = lesion.grid();
  std::vector<float> values = lesion.values();
  bool reaches_out = false;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        float& value = values[static_cast<std::size_t>(grid.offset({i, j, k}))];
        const auto depth = static_cast<float>(depth_at(grid.p_in_ct({double(i), double(j), double(k)}).xyz));
        reaches_out |= value > 0.0F && depth <= 0.0F;
        value = std::min(value, depth);
      }
  return reaches_out ? ScalarField(grid, std::move(values)) : lesion;
}

/// As labels would show it: inside the liver, and no place of two lesions. The mesher gives such a place to
/// the first that is large enough for elements of its own.
void add_lesion(const NamedSurface& surface, const ModelOptions& options, Anatomy& anatomy) {
  const TriangleMesh lesion = largest_closed_piece(surface.mesh, surface.name);
  const double diameter_mm = 1e3 * std::cbrt(6.0 / std::numbers::pi * volume(lesion));
  const ScalarField whole = field_of_surface(lesion, std::clamp(diameter_mm / kLesionSamples, 0.25, 2.0));
  ScalarField field = clipped(whole, [&](const Eigen::Vector3d& p) { return anatomy.liver.at(p); });
  if (anatomy.liver.at(centroid(lesion)) <= 0.0 || field.volume() == 0.0) {
    anatomy.notes.push_back("lesion.outside_liver " + surface.name);
    return;
  }
  anatomy.surfaces.push_back({surface.structure, surface.name, lesion});
  for (const auto& other : anatomy.lesions)
    if (is_for_the_mesh(other.second, anatomy.liver_volume, options.mesh))
      field = clipped(field, [&](const Eigen::Vector3d& p) { return -other.second.at(p); });
  if (field.volume() == 0.0) {
    anatomy.notes.push_back("lesion.without_tetrahedra " + structure_name(surface.structure));
    return;
  }
  const long percent = std::lround(100.0 * (1.0 - field.volume() / whole.volume()));
  if (percent > 0) anatomy.notes.push_back("lesion.clipped " + surface.name + " " + std::to_string(percent));
  anatomy.lesions.emplace_back(surface.structure, std::move(field));
}

}  // namespace

Cancellable<Anatomy> anatomy_of(const SurfaceSet& surfaces, const ModelOptions& options,
                                const RunContext& context) {
  Anatomy anatomy;
  anatomy.notes = surfaces.notes;
  context.progress(0.0, "model.surfaces");
  std::vector<double> dropped;
  anatomy.fine_liver = largest_closed_piece(surfaces.liver, "liver", &dropped);
  for (const double ml : dropped) anatomy.notes.push_back("liver.piece_dropped ml " + shown(ml));
  anatomy.liver_volume = volume(anatomy.fine_liver);
  anatomy.liver = field_of_surface(anatomy.fine_liver, body_spacing_mm(anatomy.fine_liver, options.mesh));
  anatomy.surfaces.push_back({structure::kParenchyma, "liver", anatomy.fine_liver});
  for (const NamedSurface& other : surfaces.others) {
    if (context.cancelled()) return {};
    context.progress(0.5, "model.surfaces");
    if (is_lesion(other.structure)) {
      add_lesion(other, options, anatomy);
      continue;
    }
    anatomy.surfaces.push_back(other);
    if (!is_wanted_vessel(other.structure, options)) continue;
    bool open = false;
    VesselMask mask = vessel_in_liver(other, anatomy.liver, open);
    // Boxes that overlap do not say that the vessel and the liver do.
    if (std::ranges::count(mask.voxels, 1) == 0) {
      anatomy.notes.push_back("vessels.outside_liver " + other.name);
      continue;
    }
    if (open) anatomy.notes.push_back("vessels.open_surface " + other.name);
    anatomy.vessels.push_back(std::move(mask));
  }
  context.progress(1.0, "model.surfaces");
  return anatomy;
}

}  // namespace glisson::model
