// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glisson/segmentation/segment.h"
#include "lesions.h"
#include "liver.h"

namespace glisson::segmentation {

/// mm around a click that are its side's whatever the CT shows; of two clicks the nearer's.
inline constexpr double kHeld = 4.0;

/// The nearest voxel of the field to each point; kept inside.
std::vector<Eigen::Vector3i> voxels_of(const VolumeGrid& image, const Field& field, const Points& points);

/// Whether a label is found anew: its structure is, and a lesion has a point of its own.
bool is_anew(const Structures& anew, const Seeds& seeds, Label label);

/// Adds the voxels of `more`. @pre one grid.
void unite(Mask& mask, const Mask& more);

/// Labels that are kept, and their liver as inside_liver() has it; no voxels: it is found anew.
struct Kept {
  LabelMap labels;
  std::vector<std::uint8_t> liver;
};

/// Tissue in the liver that is darker than it: a tumour or cyst that nobody clicked, or a gallbladder or
/// stomach that was taken for one.
struct DarkBody {
  double ml = 0.0;
  Eigen::Vector3d at_index = Eigen::Vector3d::Zero();  ///< a voxel of the image well inside of it
};

/// Liver and compact bodies, found or kept.
struct Bodies {
  Field liver_phi;  ///< mm, negative inside; lesions united, holes filled, one piece
  Tissue parenchyma;
  Field grid;  ///< of the masks, without values
  Mask liver, cava, gallbladder;
  Doubtful doubtful;
  std::vector<DarkBody> dark;        ///< in a liver that was found anew
  std::vector<GrownLesion> lesions;  ///< found anew, one for each list of seeds; without values where the
                                     ///< list is empty or nothing was found
};

/// Whether anything was found of a lesion.
bool is_found(const GrownLesion& lesion);

/// @param anew what is found; the rest is taken from `kept`, which may be null when all is found.
/// @throws InputError clicks that lie in no liver tissue; a kept liver that is not there; a contour too fine
///   for its size.
Cancellable<Bodies> find_bodies(const Image& image, const Seeds& seeds, double spacing_mm,
                                const Structures& anew, const Kept* kept, const RunContext& context,
                                const ShowContour& show);

}  // namespace glisson::segmentation
