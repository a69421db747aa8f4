// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/core/units.h"
#include "glisson/engine/case_state.h"
#include "glisson/engine/saved_image.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/registration.h"

namespace glisson::engine {

/// The edition of the folder's layout that this program writes; older ones are read, newer ones refused.
inline constexpr int kCaseFormatVersion = 1;

/// Whether a case stands in a folder, whole or not.
bool holds_case(const std::filesystem::path& folder);
/// Whether a path is to be opened as a case: a folder that holds one, or is named as one (open_case() says
/// then what it lacks).
bool is_case(const std::filesystem::path& path);

/// Writes a case as a folder NAME.glisson of standard files (see the module's README). Written beside,
/// flushed, read back and compared, then exchanged in one step: killed at any moment it leaves the old case
/// or the new one. Files in its folder that are not the case's stay, and what others have changed is kept
/// under another name; a link to the case stays a link. Does not ask who else has it: see SaveCase.
/// @param notes takes "case.kept_changed FILE" for each file of the case that others have changed; null:
/// nobody is told.
/// @return false when cancelled; the old case stands then.
/// @throws FileError, InputError (the path does not end in .glisson, or is something else than a case).
bool save_case(const std::filesystem::path& path, const CaseState& state, const RunContext& context,
               std::vector<std::string>* notes = nullptr);

/// As above, taking over the image's file where `saved` knows one; afterwards it knows this case's.
/// @param last_look called when all is written, before it takes the old case's place; the old case stands
/// when it throws. Empty: nobody looks.
bool save_case(const std::filesystem::path& path, const CaseState& state, const RunContext& context,
               SavedImage& saved, std::vector<std::string>* notes = nullptr,
               const std::function<void()>& last_look = {});

/// Puts a case that was written whole in place of another one, in one step; what is not the case's stays.
/// @param fresh on the same file system. @return notes, as save_case gives them. @throws FileError.
std::vector<std::string> put_case(const std::filesystem::path& fresh, const std::filesystem::path& path);

/// Which edition of a case stands in its folder: another one after each save that changes anything. Empty:
/// there is no case. @throws FileError it cannot be read.
std::string edition_on_disk(const std::filesystem::path& folder);

/// Reads a case, stamps included.
/// @param lost receives what could not be read but can be spared: the case is opened without it. One note
///   each: "case.cloud_lost SENTENCE", likewise calibration_lost, points_lost (of the stereo pair),
///   former_registration_lost and operations_lost. Null: these are thrown, too.
/// @throws FileError missing; InputError not a case, newer format, a part that is malformed (named).
Cancellable<CaseState> open_case(const std::filesystem::path& path, const RunContext& context,
                                 std::vector<std::string>* lost = nullptr);

/// Landmarks as JSON: {"frame": "LPS", "unit": "mm", "anterior_margin": [[x, y, z], ...], "umbilical_notch":
/// ..., "vena_cava": ...}; absent ones may be left out. @throws InputError naming the field.
Landmarks read_landmarks(const std::filesystem::path& path);
/// The same file; absent landmarks are left out (a file without any is refused by read_landmarks()). Atomic.
/// @throws FileError.
void write_landmarks(const std::filesystem::path& path, const Landmarks& landmarks);

/// What a registration says of itself, so that it is not lost on the way: `residual_mm`, `seen_share`,
/// `converged`, `doubts` (how many), `doubt_CODE` for each of them (its values; -1: it has none),
/// `note_TEXT`, and `lesion_N_covariance_mm2` (3 x 3) for each lesion.
/// @param said more of it; comes before what has the same name.
NamedArrays registration_fields(const Registration& registration, const NamedArrays& said = {});

/// The registered mesh: node order and units of the model, camera frame, field data `cloud_from_model` (4 x
/// 4, the rigid part, translation in `unit`), and registration_fields(). At the nodes `expected_error_mm`,
/// `force_n_per_kpa` (where forces act; several at one node as their sum), and for each rival
/// `rival_K_displacement_mm` (from here to there; the field `rival_K_probability` beside it).
/// @param said more field data.
void write_registration(const std::filesystem::path& path, const PatientModel& model,
                        const Registration& registration, LengthUnit unit, const NamedArrays& said = {});
/// @throws InputError when the mesh is not the model's (another number of nodes or other tetrahedra), or a
/// covariance, an expected error or a probability is none.
Registration read_registration(const std::filesystem::path& path, const PatientModel& model, LengthUnit unit);

}  // namespace glisson::engine
