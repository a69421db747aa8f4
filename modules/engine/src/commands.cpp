// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/commands.h"

#include <array>

namespace glisson::engine {
namespace {

struct Traits {
  std::string_view code;
  Parts reads, writes;
  bool is_edit = false;
};

// One overload a command: a new command does not compile until it says what it touches.
Traits traits(const ImportImage& command) {
  return {"import_image", {}, command.new_case ? Parts::all() : Parts{Part::image}};
}
Traits traits(const ListSeries&) { return {"list_series", {}, {}}; }
constexpr Parts kEdited = {Part::labels, Part::review, Part::preview};
constexpr Parts kEditReads = {Part::image, Part::labels, Part::review, Part::preview};
Traits traits(const ImportLabels&) { return {"import_labels", {Part::image}, kEdited}; }
Traits traits(const ExportLabels&) { return {"export_labels", {Part::labels, Part::review}, {}}; }
Traits traits(const EditLabels& command) {
  return {"edit_labels", kEditReads, kEdited, editing::is_local(command.edit.tool)};
}
Traits traits(const PreviewEdit& command) {
  return {"preview_edit", {Part::image, Part::labels}, {Part::preview}, !command.edit};
}
Traits traits(const UndoLabels&) { return {"undo_labels", kEditReads, kEdited, true}; }
Traits traits(const RedoLabels&) { return {"redo_labels", kEditReads, kEdited, true}; }
Traits traits(const SetReview&) { return {"set_review", {}, {Part::review}, true}; }
Traits traits(const SetSeeds&) { return {"set_seeds", {}, {Part::seeds}, true}; }
Traits traits(const Segment& command) {
  // What is kept of the labels stays as old as it was.
  if (command.keeps_labels()) return {"segment", {Part::image, Part::seeds, Part::labels}, kEdited};
  return {"segment", {Part::image, Part::seeds}, kEdited};
}
Traits traits(const BuildModel&) { return {"build_model", {Part::labels}, {Part::model}}; }
Traits traits(const ImportSurfaces&) { return {"import_surfaces", {}, {Part::model}}; }
Traits traits(const ImportMesh&) { return {"import_mesh", {}, {Part::model}}; }
Traits traits(const EditTrees&) { return {"edit_trees", {Part::model}, {Part::model}, true}; }
Traits traits(const CheckModel&) { return {"check_model", {Part::model}, {Part::check}, true}; }
Traits traits(const SetLandmarks&) { return {"set_landmarks", {Part::model}, {Part::landmarks}, true}; }
Traits traits(const SetCalibration&) { return {"set_calibration", {}, {Part::rig}, true}; }
Traits traits(const CalibrateRig&) { return {"calibrate", {}, {Part::rig}}; }
Traits traits(const LoadStereoPair&) { return {"load_stereo_pair", {}, {Part::frame}}; }
Traits traits(const SetVideo&) { return {"set_video", {}, {Part::video}, true}; }
Traits traits(const LoadVideoFrame&) { return {"load_video_frame", {Part::video}, {Part::frame}}; }
Traits traits(const SetRegions&) { return {"set_regions", {Part::frame}, {Part::regions}, true}; }
Traits traits(const Reconstruct&) {
  return {"reconstruct", {Part::rig, Part::frame, Part::regions}, {Part::cloud}};
}
// It was seen by the camera, and in the frame, of the case: with others it is not to be drawn.
Traits traits(const ImportCloud&) { return {"import_cloud", {Part::rig, Part::frame}, {Part::cloud}}; }
Traits traits(const Register&) {
  return {"register", {Part::model, Part::landmarks, Part::cloud}, {Part::registration}};
}
Traits traits(const ImportRegistration&) {
  return {"import_registration", {Part::model}, {Part::registration}};
}
Traits traits(const StartTracking&) {
  return {"start_tracking",
          {Part::model, Part::landmarks, Part::rig, Part::frame, Part::registration},
          {Part::live},
          true};
}
Traits traits(const StopTracking&) { return {"stop_tracking", {}, {Part::live}, true}; }
Traits traits(const StartTrial&) { return {"start_trial", {Part::model, Part::landmarks}, {}, true}; }
Traits traits(const StopTrial&) { return {"stop_trial", {}, {}, true}; }
Traits traits(const Simulate&) { return {"simulate", {Part::model}, {}}; }
Traits traits(const OpenCase&) { return {"open_case", {}, Parts::all()}; }
// A save reads the whole case; the live view goes on beside it and is not saved.
Traits traits(const SaveCase&) {
  return {"save_case",
          {Part::image, Part::seeds, Part::labels, Part::review, Part::model, Part::check, Part::landmarks,
           Part::rig, Part::video, Part::frame, Part::regions, Part::cloud, Part::registration},
          {}};
}

Traits traits_of(const Command& command) {
  return std::visit([](const auto& one) { return traits(one); }, command);
}

}  // namespace

std::string_view command_code(const Command& command) { return traits_of(command).code; }
Parts reads(const Command& command) { return traits_of(command).reads; }
Parts writes(const Command& command) { return traits_of(command).writes; }
bool is_edit(const Command& command) { return traits_of(command).is_edit; }

}  // namespace glisson::engine
