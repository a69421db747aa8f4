// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "anatomy.h"
#include "cut_faces.h"
#include "glisson/core/error.h"
#include "glisson/model/label_surfaces.h"
#include "glisson/patient/cut_organ.h"
#include "glisson/patient/lesion_pieces.h"
#include "glisson/volume/brick_voxels.h"
#include "surface_field.h"

namespace glisson::model {
namespace {

constexpr double kSpeck = 0.01;           // of the largest piece's voxels
constexpr double kFineSpacingMm = 1.5;    // of the liver's fine surface
constexpr double kOtherSpacingMm = 1.0;   // of vessels and lesions
constexpr double kLeastLesionMm3 = 15.0;  // below, a lesion is a few voxels of noise

double smoothing_of(const VolumeGrid& grid) { return std::clamp(0.8 * grid.spacing_mm.maxCoeff(), 0.6, 2.0); }

long count(const std::vector<std::uint8_t>& mask) { return std::count(mask.begin(), mask.end(), 1); }

/// Keeps the one large piece of the liver.
void keep_largest(const VolumeGrid& grid, std::vector<std::uint8_t>& mask, std::vector<std::string>& notes) {
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, mask, 0.0);
  if (box.empty())
    throw InputError("labels", "liver", "there is no liver in them", "Segment the liver first");
  Mask part = crop(grid.size, grid.spacing_mm, mask, box);
  std::vector<long> sizes;
  const std::vector<int> pieces = connected_components(part, sizes);
  double dropped_ml = 0.0;
  for (std::size_t n = 1; n < sizes.size(); ++n) {
    if (static_cast<double>(sizes[n]) > kSpeck * static_cast<double>(sizes[0]))
      throw InputError("labels", "liver",
                       "is in several large pieces (" + shown(sizes[0] * grid.voxel_volume_mm3() * 1e-3) +
                           " ml and " + shown(sizes[n] * grid.voxel_volume_mm3() * 1e-3) + " ml)",
                       "Join them or erase those that are not liver");
    dropped_ml += static_cast<double>(sizes[n]) * grid.voxel_volume_mm3() * 1e-3;
  }
  if (sizes.size() > 1)
    notes.push_back("liver.pieces_dropped " + std::to_string(sizes.size() - 1) + " ml " + shown(dropped_ml));
  for (std::size_t i = 0; i < pieces.size(); ++i) part.voxels[i] = pieces[i] == 1;
  paste(part, box, grid.size, mask);
}

/// Not finer than a person can see: a CT's in-plane voxels would give millions of triangles.
NamedSurface surface_of(Label label, const ScalarField& field) {
  return {label, structure_name(label),
          zero_level(resampled(field, std::max(kOtherSpacingMm, 0.6 * field.grid().spacing_mm.minCoeff())))};
}

/// Whether a lesion is too small; notes it then.
bool is_dropped(Label lesion, double mm3, std::vector<std::string>& notes) {
  if (mm3 >= kLeastLesionMm3) return false;
  notes.push_back("lesion.dropped " + structure_name(lesion) + " mm3 " + shown(mm3));
  return true;
}

/// A lesion in pieces is one for all that is said of it.
void note_pieces(const LabelVolume& labels, Label lesion, std::vector<std::string>& notes) {
  const std::size_t pieces = lesion_pieces(labels, lesion).size();
  if (pieces > 1)
    notes.push_back("lesion.in_pieces " + structure_name(lesion) + ' ' + std::to_string(pieces));
}

/// The voxels of a label, in the box around them: lesions are small, and may be many.
struct Part {
  Mask mask;
  Eigen::Vector3i low;  ///< the box's first voxel
};

/// @pre some voxel has the label
Part part_of(const LabelVolume& labels, Label label) {
  Eigen::Vector3i low = labels.grid().size, high = Eigen::Vector3i::Zero();
  each_voxel(labels, label, [&](const Eigen::Vector3i& v) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  });
  Part part{Mask(high - low + Eigen::Vector3i::Ones(), labels.grid().spacing_mm), low};
  each_voxel(labels, label, [&](const Eigen::Vector3i& v) {
    const Eigen::Vector3i at = v - low;
    part.mask.voxels[part.mask.offset(at.x(), at.y(), at.z())] = 1;
  });
  return part;
}

/// Leaves what lies in the liver.
void clip(Part& part, const VolumeGrid& grid, const std::vector<std::uint8_t>& liver) {
  for (int k = 0; k < part.mask.size.z(); ++k)
    for (int j = 0; j < part.mask.size.y(); ++j)
      for (int i = 0; i < part.mask.size.x(); ++i)
        part.mask.voxels[part.mask.offset(i, j, k)] &=
            liver[static_cast<std::size_t>(grid.offset(part.low + Eigen::Vector3i(i, j, k)))];
}

ScalarField field_of_part(const VolumeGrid& grid, const Part& part) {
  return field_of_mask(grid, part.mask, part.low, 0.5 * smoothing_of(grid));
}

/// Vessel voxels in the liver or at its entrances.
VesselMask vessel_in_liver(Label structure, const LabelVolume& labels,
                           const std::vector<std::uint8_t>& near_liver) {
  VesselMask vessel{structure, labels.grid(), labels.mask([&](Label label) { return label == structure; })};
  for (std::size_t i = 0; i < vessel.voxels.size(); ++i) vessel.voxels[i] &= near_liver[i];
  return vessel;
}

void add_vessel(VesselMask vessel, Anatomy& anatomy) {
  if (count(vessel.voxels) > 0)
    anatomy.vessels.push_back(std::move(vessel));
  else
    anatomy.notes.push_back("vessels.outside_liver " + structure_name(vessel.structure));
}

std::vector<std::uint8_t> grown(const VolumeGrid& grid, const std::vector<std::uint8_t>& mask, double by_mm) {
  const VoxelBox box = bounding_box(grid.size, grid.spacing_mm, mask, by_mm + grid.spacing_mm.maxCoeff());
  std::vector<std::uint8_t> all = mask;
  paste(dilated(crop(grid.size, grid.spacing_mm, mask, box), by_mm), box, grid.size, all);
  return all;
}

}  // namespace

const TriangleMesh* Anatomy::vena_cava() const {
  for (const NamedSurface& surface : surfaces)
    if (surface.structure == structure::kVenaCava) return &surface.mesh;
  return nullptr;
}

bool is_wanted_vessel(Label structure, const ModelOptions& options) {
  return options.vessels && (structure == structure::kPortalVein || structure == structure::kHepaticVeins ||
                             (structure == structure::kArtery && options.arteries));
}

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

Cancellable<Anatomy> anatomy_of(const LabelMap& labels, const ModelOptions& options,
                                const RunContext& context, const Image* image) {
  const LabelVolume& voxels = labels.voxels;
  const VolumeGrid& grid = voxels.grid();
  context.progress(0.0, "model.labels");
  if (voxels.empty()) throw InputError("labels", "", "are empty", "Segment the liver first");
  Anatomy anatomy;
  std::vector<std::uint8_t> liver = inside_liver(labels);
  keep_largest(grid, liver, anatomy.notes);
  if (looks_mirrored(voxels)) anatomy.notes.emplace_back("liver.perhaps_mirrored");
  const std::vector<CutRow> cut = image_cut(grid, liver, image);
  if (auto note = cut_note(grid, cut)) {
    anatomy.notes.push_back(std::move(*note));
    anatomy.cut = cut_faces(grid, cut);
  }
  anatomy.liver_volume = static_cast<double>(count(liver)) * grid.voxel_volume_mm3() * 1e-9;
  anatomy.liver = field_of_mask(grid, liver, smoothing_of(grid));
  anatomy.fine_liver = largest_closed_piece(
      zero_level(resampled(anatomy.liver, std::max(kFineSpacingMm, grid.spacing_mm.minCoeff()))), "labels");
  anatomy.surfaces.push_back({structure::kParenchyma, "liver", anatomy.fine_liver});
  if (context.cancelled()) return {};
  context.progress(0.4, "model.labels");

  const std::vector<std::uint8_t> near_liver = grown(grid, liver, kEntranceMm);
  const std::vector<long> histogram = voxels.histogram();
  for (std::size_t code = 2; code < histogram.size(); ++code) {
    if (histogram[code] == 0) continue;
    const auto label = static_cast<Label>(code);
    if (is_lesion(label)) {
      Part lesion = part_of(voxels, label);
      clip(lesion, grid, liver);
      const double mm3 = static_cast<double>(lesion.mask.count()) * grid.voxel_volume_mm3();
      if (is_dropped(label, mm3, anatomy.notes)) continue;
      note_pieces(voxels, label, anatomy.notes);
      anatomy.lesions.emplace_back(label, field_of_part(grid, lesion));
      anatomy.surfaces.push_back(surface_of(label, anatomy.lesions.back().second));
    } else if (label <= structure::kGallbladder) {
      anatomy.surfaces.push_back(surface_of(label, field_of_part(grid, part_of(voxels, label))));
      if (is_wanted_vessel(label, options)) add_vessel(vessel_in_liver(label, voxels, near_liver), anatomy);
    }
    if (context.cancelled()) return {};
  }
  context.progress(1.0, "model.labels");
  return anatomy;
}

Cancellable<std::vector<NamedSurface>> surfaces_of_labels(const LabelMap& labels, const RunContext& context,
                                                          std::vector<std::string>& notes) {
  const LabelVolume& voxels = labels.voxels;
  const VolumeGrid& grid = voxels.grid();
  const std::vector<long> histogram = voxels.histogram();
  if (voxels.empty() || std::all_of(histogram.begin() + 1, histogram.end(), [](long n) { return n == 0; }))
    throw InputError("labels", "", "are empty", "Segment the liver first");
  std::vector<NamedSurface> surfaces;
  const std::vector<std::uint8_t> liver = inside_liver(labels);
  if (count(liver) > 0)
    surfaces.push_back({structure::kParenchyma, "liver",
                        zero_level(resampled(field_of_mask(grid, liver, smoothing_of(grid)),
                                             std::max(kFineSpacingMm, grid.spacing_mm.minCoeff())))});
  for (std::size_t code = 2; code < histogram.size(); ++code) {
    if (context.cancelled()) return {};
    context.progress(static_cast<double>(code) / static_cast<double>(histogram.size()), "model.labels");
    const auto label = static_cast<Label>(code);
    if (histogram[code] == 0 || (!is_lesion(label) && label > structure::kGallbladder)) continue;
    const double mm3 = static_cast<double>(histogram[code]) * grid.voxel_volume_mm3();
    if (is_lesion(label) && is_dropped(label, mm3, notes)) continue;
    surfaces.push_back(surface_of(label, field_of_part(grid, part_of(voxels, label))));
  }
  std::erase_if(surfaces, [](const NamedSurface& surface) { return surface.mesh.triangle_count() == 0; });
  return surfaces;
}

}  // namespace glisson::model
