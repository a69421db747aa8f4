// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "glisson/core/units.h"
#include "glisson/engine/case_state.h"
#include "glisson/engine/load_trial.h"
#include "glisson/fem/loads_io.h"
#include "glisson/fem/simulate.h"
#include "glisson/guidance/tracker.h"
#include "glisson/registration/register_model.h"
#include "glisson/stereo/calibrate.h"

/// @file
/// Everything that can be asked of the engine, as values. The window, the command line and the tests post the
/// same.

namespace glisson::engine {

/// Reads a CT or MR (see read_image).
struct ImportImage {
  std::filesystem::path path;
  std::string series = {};  ///< UID or number, where there are several
  bool new_case = false;    ///< of another patient: nothing of the case stays, nor where it lay
};
/// Says in its outcome which DICOM series a folder or an archive holds. Changes no part.
struct ListSeries {
  std::filesystem::path path;
};
/// Reads labels, recoded by `codes` (empty: Glisson's own codes).
struct ImportLabels {
  std::filesystem::path path;
  LabelCodes codes;
};
/// Writes the labels with their names, terminology and review to a file (.seg.nrrd, .nii.gz, ...). Changes no
/// part.
struct ExportLabels {
  std::filesystem::path path;
};
/// One edit of the labels. Done at once where its tool is local (see editing::is_local); with the result
/// of the preview where that is of the same edit.
struct EditLabels {
  editing::Edit edit;
  /// Edits of one gesture (not 0), as the pieces of a stroke, are one step of the history.
  std::uint64_t gesture = 0;
};
/// What an edit would do, as the part `preview`; empty: it goes.
struct PreviewEdit {
  std::optional<editing::Edit> edit;
};
/// One step back or forth. @throws InputError when there is none.
struct UndoLabels {};
struct RedoLabels {};
struct SetReview {
  Label label = 0;
  ReviewState state = ReviewState::not_started;
};
struct SetSeeds {
  segmentation::Seeds seeds;
};
/// Where only some structures or a region are found anew, the rest of the case's labels is kept.
struct Segment {
  segmentation::SegmentationOptions options;
  /// Sees the liver's contour on its way; the engine puts its own in place (see Snapshot::evolving).
  segmentation::ShowLiver show = {};

  bool keeps_labels() const { return options.region || !(options.structures == segmentation::Structures{}); }
};
struct BuildModel {
  model::ModelOptions options;
};
/// A model from closed surfaces: a folder by structure, or one file.
struct ImportSurfaces {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;
  model::ModelOptions options;
};
/// A tetrahedral mesh as it is: node order and all.
struct ImportMesh {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;
};
/// Replays edits on the trees as they were built; undo is the list without its last.
struct EditTrees {
  std::vector<model::TreeEdit> edits;
};
/// A person has looked at the model.
struct CheckModel {
  ModelCheck check;
};
struct SetLandmarks {
  Landmarks landmarks;
};
/// OpenCV YAML; or a folder of plain text (stereo::read_text_calibration, mm), for pictures of the size of
/// the case's frame.
struct SetCalibration {
  std::filesystem::path path;
};
/// Calibrates the laparoscope from pairs of pictures of a board (stereo::picture_pairs: a folder; or with
/// `right` two folders or patterns). Outliers are notes: "calibration.outlier NAME" was dropped,
/// "calibration.proposed NAME" was not. The outcome has the whole report.
struct CalibrateRig {
  std::filesystem::path left, right;
  stereo::Board board;
  stereo::CalibrateOptions options;
  /// The boards, where an earlier outcome or the caller (from a video) has them: they are not looked for.
  std::shared_ptr<const stereo::BoardViews> found = {};
};
/// How a calibration was made and how far to trust it.
struct CalibrationSheet {
  std::shared_ptr<const stereo::BoardViews> views;
  stereo::Calibration calibration;
  Picture coverage;  ///< stereo::coverage_picture
};
/// A stereo pair of picture files; `mask` may be empty.
struct LoadStereoPair {
  std::filesystem::path left, right, mask;
};
/// From now on the case's video is this one (`right` empty: `left` holds both views side by side).
struct SetVideo {
  std::filesystem::path left, right;
};
/// The frame `index` of the case's video, to be labelled and registered.
struct LoadVideoFrame {
  int index = 0;
  std::filesystem::path mask = {};  ///< may be empty
};
struct SetRegions {
  stereo::Regions regions;
};
/// The points of the whole pair, then those in regions with their labels. Where only the regions have changed
/// since the last time, the points are those of that time; with Method::automatic they become dense once the
/// regions leave fewer of them than wanted (if dense ones are more), and stay so until another pair comes.
struct Reconstruct {
  stereo::ReconstructOptions options;
};
struct ImportCloud {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;
};
/// registration::register_model.
struct Register : registration::RegisterOptions {};
/// A registration that was made before (registered.vtu), as the start of tracking.
struct ImportRegistration {
  std::filesystem::path path;
  LengthUnit unit = LengthUnit::millimetre;
};
/// From now on frames, or clouds, are followed (see Engine::submit_frame). For frames, the frame part is the
/// one that was registered.
struct StartTracking {
  enum class Source { frames, clouds };
  Source source = Source::frames;
  guidance::TrackerOptions options;
  int steps_per_cloud = 50;  ///< implicit Euler steps towards each cloud
};
struct StopTracking {};
/// From now on a load can be tried on the model (see Engine::submit_pull). Changes no part; another model or
/// other landmarks end it.
struct StartTrial {
  TrialOptions options;
};
struct StopTrial {};
/// Plain mechanics on the model, from its rest shape. Changes no part: writes step_00001.vtu ...
/// (displacement_mm, von_mises_pa) and steps.csv into `folder`, which exists.
struct Simulate {
  fem::LoadCase load;
  fem::SimulationOptions options;
  fem::CompositeOptions materials;
  std::filesystem::path folder;
  LengthUnit unit = LengthUnit::millimetre;  ///< of the meshes
  int every = 1;                             ///< write every so many steps, and the last
};
struct OpenCase {
  std::filesystem::path path;
};
/// `path` empty: where the case was opened from or last saved.
struct SaveCase {
  std::filesystem::path path;
};

using Command =
    std::variant<ImportImage, ListSeries, ImportLabels, ExportLabels, EditLabels, PreviewEdit, UndoLabels,
                 RedoLabels, SetReview, SetSeeds, Segment, BuildModel, ImportSurfaces, ImportMesh, EditTrees,
                 CheckModel, SetLandmarks, SetCalibration, CalibrateRig, LoadStereoPair, SetVideo,
                 LoadVideoFrame, SetRegions, Reconstruct, ImportCloud, Register, ImportRegistration,
                 StartTracking, StopTracking, StartTrial, StopTrial, Simulate, OpenCase, SaveCase>;

/// Code of a command for progress, figures and logs: "segment", "build_model", ...
std::string_view command_code(const Command& command);
/// What a command reads and writes. Two commands may overlap or overtake each other only where neither writes
/// what the other touches; so the outcome is always that of the order in which they were posted.
Parts reads(const Command& command);
Parts writes(const Command& command);
/// Whether it is done at once (an edit) rather than on the worker.
bool is_edit(const Command& command);

}  // namespace glisson::engine
