// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/codes.h"
#include "glisson/volume/io.h"
#include "glisson/volume/label_volume.h"

namespace glisson {

/// What a voxel can be. The codes are those of the files that Glisson writes; other files are mapped to them
/// on the way in (see LabelCodes).
namespace structure {
inline constexpr Label kBackground = 0;
inline constexpr Label kParenchyma = 1;
inline constexpr Label kPortalVein = 2;
inline constexpr Label kHepaticVeins = 3;
inline constexpr Label kVenaCava = 4;
inline constexpr Label kArtery = 5;
inline constexpr Label kGallbladder = 6;
/// Whatever else is marked on the way: rivals of the liver while it grows, parts that were split off. Models
/// do not contain it.
inline constexpr Label kFirstOther = 7;
inline constexpr Label kLastOther = 15;
/// Lesions are 16, 17, ...: each its own label.
inline constexpr Label kFirstLesion = 16;
inline constexpr Label kLastLesion = 255;
}  // namespace structure

/// kFirstLesion to kLastLesion. @param label also a number of a mesh, which need not be one of 16 bits.
bool is_lesion(int label);
/// kFirstOther to kLastOther.
bool is_other(Label label);
/// Parenchyma, or a lesion.
bool is_liver_tissue(Label label);
/// What a part that is split off may become, ascending: the lesions that are not taken where it comes from a
/// lesion, else the others.
std::vector<Label> free_labels(Label like, const std::function<bool(Label)>& is_taken);
/// Code for people and files: "parenchyma", "portal_vein", ..., "lesion_1". Not translated.
std::string structure_name(Label label);
/// The label whose structure_name() is `name`; "label_12345" has none.
std::optional<Label> structure_named(const std::string& name);
/// Colour-blind-safe (Okabe and Ito 2008), sRGB in [0, 1].
std::array<double, 3> structure_colour(Label label);

/// Code, name and colour of a label as Glisson has them.
LabelInfo structure_info(Label label);

/// Which structure each code of a foreign label file means.
using LabelCodes = std::map<Label, Label>;
/// Reads a JSON object {"6": "parenchyma", "10": "portal_vein", "451": "lesion_1"}. @throws InputError.
LabelCodes read_label_codes(const std::filesystem::path& path);

/// The segmented patient. Value type; copies share bricks. A vessel keeps its label outside the liver, too:
/// which of its voxels lie inside is told by inside_liver().
struct LabelMap {
  LabelVolume voxels;
  std::vector<LabelInfo> infos;  ///< names, colours, terminology of the labels present
};

/// How far a person has come with a label.
enum class ReviewState { not_started, in_progress, to_review, approved };
/// For the command line, and in the codes of notes.
inline constexpr Codes<ReviewState, 4> kReviewCodes = {{{"not_started", ReviewState::not_started},
                                                        {"in_progress", ReviewState::in_progress},
                                                        {"to_review", ReviewState::to_review},
                                                        {"approved", ReviewState::approved}}};
/// Labels that are not in it are not_started.
using Review = std::map<Label, ReviewState>;
/// As Slicer's tag Segmentation.Status: "notstarted", "inprogress", "flagged", "completed".
std::string slicer_status(ReviewState state);
/// Unknown texts: not_started.
ReviewState review_state(const std::string& slicer_status);

/// Dense 0/1 mask of the liver with everything in it: parenchyma, lesions, and the vessel voxels enclosed by
/// them (in the closing by `closing_mm`, or a hole of it in one slice of the three axes), then hole filling.
/// @pre closing_mm >= 0
std::vector<std::uint8_t> inside_liver(const LabelMap& labels, double closing_mm = 3.0);

/// Whether the liver lies to the patient's left of the vena cava, as in a volume whose header swaps left and
/// right. False when either is missing. Takes structure labels.
bool looks_mirrored(const LabelVolume& labels);

/// What becomes of a liver that looks mirrored. What a right hepatectomy leaves does lie so, and half a liver
/// looks like the mirror image of another half: no shape tells the two apart, only a person does.
enum class LeftLiver {
  refused,
  taken,  ///< a person says that it does lie there; it is noted
  asked   ///< a person has said so when asked about this very file, and is not told again
};

/// A foreign label volume, recoded. Codes that the table does not name become background.
/// @param name of the file, for messages.
/// @throws InputError when nothing of the liver remains, or it looks mirrored and is not to be taken so.
LabelMap recode(const LabelFile& file, const LabelCodes& codes, const std::string& name,
                LeftLiver left_liver = LeftLiver::refused);

}  // namespace glisson
