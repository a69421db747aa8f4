// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "glisson/core/codes.h"
#include "glisson/core/run_context.h"
#include "glisson/geometry/mesh.h"
#include "glisson/patient/label_map.h"
#include "glisson/volume/image.h"

namespace glisson::segmentation {

/// What a person clicks. CT frame, metres. File: JSON {"liver": [[x, y, z] mm LPS, ...], "portal_vein": ...,
/// ...}.
struct Seeds {
  PointsIn<CtFrame> liver;
  PointsIn<CtFrame> portal_vein, hepatic_veins, vena_cava, gallbladder;
  std::vector<PointsIn<CtFrame>> lesions;  ///< a list for each, in the order of their labels; it may be empty
  PointsIn<CtFrame> background;            ///< "not liver": optional
  /// About how wide each lesion is, as drawn by hand around its click; 0 or missing: not drawn. File:
  /// "lesion_diameters_mm": [0, 24, ...]. @throws InputError in segment() outside kLeast- to kMostDiameter.
  std::vector<double> lesion_diameters_mm;

  static constexpr double kLeastDiameter = 3.0, kMostDiameter = 250.0;  ///< mm
  double lesion_diameter_mm(std::size_t lesion) const {
    return lesion < lesion_diameters_mm.size() ? lesion_diameters_mm[lesion] : 0.0;
  }
};
/// @throws InputError naming `file`, the field and the remedy when a diameter is out of range, or of no
/// lesion.
void check_diameters(const std::string& file, const Seeds& seeds);
/// The file as Seeds shows it; structures that it leaves out have no seeds. Points come back in metres.
/// @throws FileError missing; InputError naming file and field: malformed, an unknown key, a diameter.
Seeds read_seeds(const std::filesystem::path& path);
/// Millimetres, LPS; structures without seeds as empty lists. Atomic. @throws FileError.
void write_seeds(const std::filesystem::path& path, const Seeds& seeds);

/// What is found anew. A structure that is not, or that has no seeds, stays as the labels given to segment()
/// have it; so does a single lesion without seeds, and what nothing was found of ("portal_vein.not_found").
struct Structures {
  bool liver = true, portal_vein = true, hepatic_veins = true, vena_cava = true, gallbladder = true,
       lesions = true;  ///< liver: its parenchyma
  bool operator==(const Structures&) const = default;
};
/// For the command line.
inline constexpr Codes<bool Structures::*, 6> kStructureCodes = {
    {{"liver", &Structures::liver},
     {"portal_vein", &Structures::portal_vein},
     {"hepatic_veins", &Structures::hepatic_veins},
     {"vena_cava", &Structures::vena_cava},
     {"gallbladder", &Structures::gallbladder},
     {"lesions", &Structures::lesions}}};
/// None of them.
inline constexpr Structures kNoStructures = {false, false, false, false, false, false};

/// What is found anew, where, and how finely.
struct SegmentationOptions {
  /// Resolution of the liver's contour, 0.3 to 5 mm. Below 2 mm the level set runs at 2 mm first, and its
  /// last rounds once more at this spacing, from where it came to rest. Memory then is an estimated 60 bytes
  /// for each working voxel of the region: 0.4 GB for (100 mm)^3 at 0.57 mm. @throws InputError in segment()
  /// for a region of more than 50 million working voxels.
  double working_spacing_mm = 2.0;
  /// CT frame, metres, along LPS; the whole image when not set. Only what lies in it is read and labelled;
  /// outside it the labels given to segment() stay. Seeds outside are left aside.
  std::optional<Eigen::AlignedBox3d> region;
  Structures structures;
  /// Labels that neither lose nor gain a voxel; what is locked of the labels given to segment() counts as
  /// known. With the parenchyma locked, the vessels and lesions in it stay, too. Without such labels they
  /// stay empty.
  std::vector<Label> locked;
  /// Whether hepatic veins grow from the wall of the vena cava, too, besides their clicks.
  bool veins_from_cava = true;
  /// @throws InputError naming the option.
  void validate() const;
};

/// Whether a label is found anew in an image of this grid, at least in the region.
bool is_found_anew(Label label, const SegmentationOptions& options, const VolumeGrid& grid,
                   const Seeds& seeds);

/// Told before a person waits for nothing. @throws InputError naming a structure that was asked for, where
/// none of them has a seed in the region, or all are locked.
void require_something_to_find(const SegmentationOptions& options, const VolumeGrid& grid,
                               const Seeds& seeds);

/// Why segment() cannot begin.
enum class Hindrance {
  small_region,             ///< the region holds less of the image than eight voxels a side
  no_liver_seed,            ///< the liver is to be found, and nobody has clicked it
  no_liver_seed_in_region,  ///< nobody has in the region
  no_kept_liver             ///< the liver is neither to be found nor kept
};
/// Asked without doing anything; segment() throws it. Empty: nothing hinders.
/// @param grid of the image. @param keeps_labels whether segment() is given labels to keep.
std::optional<Hindrance> hindrance(const SegmentationOptions& options, const VolumeGrid& grid,
                                   const Seeds& seeds, bool keeps_labels);

/// Volumes, and what a person should look at. The liver's is with vessels and lesions in it.
struct SegmentationReport {
  double liver_ml = 0.0, portal_ml = 0.0, hepatic_ml = 0.0;
  std::vector<double> lesion_ml;   ///< one for each list of Seeds::lesions
  std::vector<std::string> notes;  ///< codes with values: "liver.small", "lesion_2.not_found", ...
};
/// The labels of the whole image, and their report.
struct Segmented {
  LabelMap labels;
  SegmentationReport report;
};

/// Receives the liver as the contour stands, 0 or 1 on the image's whole grid: in the thread of segment(), a
/// few times a second at most, and once at the contour's end. Keep a copy (it shares bricks) and look at
/// LabelVolume::bricks_differing_from: a brick is written only where the contour moved.
using ShowLiver = std::function<void(const LabelVolume& liver)>;

/// Liver by a geodesic active contour from seeds (speed from intensity statistics and gradient), smoothing,
/// hole filling, largest component; vessels by vesselness and growth from their seeds, portal and hepatic
/// kept apart; lesions each its own label.
/// @param kept labels on the image's grid of which the structures that are not found anew are kept, voxel by
///   voxel; none: everything starts empty. Its untouched bricks are shared by the result. Vessels found anew
///   inside a kept liver take the place of its parenchyma, and leave parenchyma where they are no more.
/// @param show may be empty.
/// @throws InputError seeds outside the image, a hindrance(), no liver in `kept` where it is kept, another
///   grid, neither CT nor MRI.
Cancellable<Segmented> segment(const Image& image, const Seeds& seeds, const SegmentationOptions& options,
                               const RunContext& context, const LabelMap* kept = nullptr,
                               const ShowLiver& show = {});

/// Dice coefficient of two masks of one grid.
double dice(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b);

}  // namespace glisson::segmentation
