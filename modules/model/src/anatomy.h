// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glisson/model/build.h"
#include "scalar_field.h"

namespace glisson::model {

/// Voxels of one kind of vessel, as far as it lies in the liver or at its entrance.
struct VesselMask {
  Label structure = 0;
  VolumeGrid grid;
  std::vector<std::uint8_t> voxels;
};

/// What a model is built from, whether it came as labels or as surfaces.
struct Anatomy {
  ScalarField liver;
  double liver_volume = 0.0;  ///< m3, of the labels or the surface
  TriangleMesh fine_liver;
  TriangleMesh cut;  ///< where the image ends inside the liver (cut_faces.h); empty: nowhere
  std::vector<std::pair<Label, ScalarField>> lesions;
  std::vector<VesselMask> vessels;
  std::vector<NamedSurface> surfaces;  ///< fine, the liver first
  std::vector<std::string> notes;

  /// The vena cava's surface; null when it is not known.
  const TriangleMesh* vena_cava() const;
};

/// @param image as build_from_labels() has it. @throws InputError no liver, several large pieces.
Cancellable<Anatomy> anatomy_of(const LabelMap& labels, const ModelOptions& options,
                                const RunContext& context, const Image* image = nullptr);
Cancellable<Anatomy> anatomy_of(const SurfaceSet& surfaces, const ModelOptions& options,
                                const RunContext& context);

/// Vessels may enter the liver through a groove: what lies within this of it counts as in it.
inline constexpr double kEntranceMm = 3.0;

/// Whether trees are wanted of a structure.
bool is_wanted_vessel(Label structure, const ModelOptions& options);

/// Whether elements of the wanted size can show a lesion.
bool is_for_the_mesh(const ScalarField& lesion, double liver_volume, const MeshOptions& options);

/// Adds how many beams the trees have, and how many of their nodes lie outside the mesh.
void count_vessel_nodes(const PatientModel& model, std::vector<std::string>& notes);

/// A number for a note: three significant digits.
std::string shown(double value);

}  // namespace glisson::model
