// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

/// @file
/// Synthetic CTs of ill livers, of other phases and of poor pictures, each with its truth: what a
/// segmentation must carry over to. Their bodies, grey values and places are drawn by seed.

namespace glisson::insilico {

/// A lesion: what it looks like and where it lies. Radii in mm.
struct LesionKind {
  enum class Look { hypodense, necrotic, calcified, rim_enhancing, cyst, hyperdense };
  enum class Place { deep, rim, beside_cava };
  Look look = Look::hypodense;
  Place place = Place::deep;
  double radius_mm = 15.0;
};

/// How one patient and one scan differ from the standard synthetic patient.
struct Pathology {
  enum class Phase { portal_venous, late_arterial, unenhanced };
  std::string name;
  std::uint64_t shape_seed = 1;
  std::vector<LesionKind> lesions;
  Phase phase = Phase::portal_venous;
  bool fatty = false;      ///< parenchyma darker than vessels and spleen
  bool cirrhotic = false;  ///< nodular surface and texture
  bool metal = false;      ///< streaks in some slices
  double body_scale = 1.0;
  double noise_hu = 12.0;
  Eigen::Vector3d spacing_mm{1.5, 1.5, 2.0};  ///< each slice is the mean over its thickness
};

/// A CT of a patient with a pathology, and its true labels. Several million voxels, some seconds.
struct PathologyCt {
  Image ct;
  LabelMap truth;
};

/// Fifteen patients. Another seed gives other bodies, places and grey values of the same kinds.
std::vector<Pathology> pathologies(std::uint64_t seed);

/// The same pathology gives the same bits. Empty: cancelled.
Cancellable<PathologyCt> make_pathology_ct(const Pathology& pathology, const RunContext& context);

}  // namespace glisson::insilico
