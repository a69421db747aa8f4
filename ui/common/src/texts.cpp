// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/texts.h"

#include <QCoreApplication>
#include <QHash>

#include "glisson/patient/label_map.h"

namespace glisson::ui {
namespace {

/// Context of these words for translators.
class Texts {
  Q_DECLARE_TR_FUNCTIONS(Texts)
 public:
  static QHash<QString, QString> commands() {
    return {{"read_image", tr("Reading the volume")},
            {"import_image", tr("Reading the volume")},
            {"import_labels", tr("Reading the labels")},
            {"export_labels", tr("Writing the labels")},
            {"export_surfaces", tr("Writing the surfaces")},
            {"edit_labels", tr("Editing the labels")},
            {"preview_edit", tr("Preparing a preview")},
            {"undo_labels", tr("Undoing")},
            {"redo_labels", tr("Redoing")},
            {"set_review", tr("Storing the review")},
            {"set_locks", tr("Storing what is locked")},
            {"list_series", tr("Looking for series")},
            {"set_modality", tr("Storing what the volume is")},
            {"set_seeds", tr("Storing the seeds")},
            {"segment", tr("Segmenting")},
            {"segment_by_network", tr("Segmenting by your network")},
            {"correct_around", tr("Correcting around a click")},
            {"decide_segmentation", tr("Storing the decision about the new segmentation")},
            {"build_model", tr("Building the model")},
            {"import_surfaces", tr("Building the model from surfaces")},
            {"import_mesh", tr("Reading the mesh")},
            {"edit_trees", tr("Editing the vessel trees")},
            {"check_model", tr("Noting the check of the model")},
            {"set_landmarks", tr("Storing the landmarks")},
            {"build_atlas", tr("Building an atlas")},
            {"set_tissue", tr("Storing the stiffness")},
            {"undo_registration", tr("Going back to the former registration")},
            {"propose_landmarks", tr("Proposing the landmarks")},
            {"propose_seeds", tr("Looking for the liver")},
            {"review_proposal", tr("Storing the review of a landmark")},
            {"restore_review", tr("Taking a step of the review back")},
            {"set_calibration", tr("Reading the calibration")},
            {"calibrate", tr("Calibrating the laparoscope")},
            {"load_stereo_pair", tr("Reading the stereo pair")},
            {"set_video", tr("Opening the video")},
            {"load_video_frame", tr("Reading the video's frame")},
            {"set_regions", tr("Storing the regions")},
            {"reconstruct", tr("Reconstructing the surface")},
            {"import_cloud", tr("Reading the cloud")},
            {"keep_look", tr("Keeping the look")},
            {"forget_looks", tr("Forgetting the looks")},
            {"keep_moment", tr("Keeping the moment")},
            {"rename_moment", tr("Storing a moment's title")},
            {"remove_moment", tr("Deleting a moment")},
            {"register", tr("Registering")},
            {"import_registration", tr("Reading the registration")},
            {"accept_registration", tr("Accepting the registration")},
            {"choose_rival", tr("Taking the other place")},
            {"simulate", tr("Simulating")},
            {"simulate_operations", tr("Simulating operations")},
            {"start_tracking", tr("Starting the tracking")},
            {"correct_tracking", tr("Correcting by hand")},
            {"register_again", tr("Registering again")},
            {"take_registration", tr("Taking the other registration")},
            {"undo_correction", tr("Taking a correction back")},
            {"set_mask_network", tr("Choosing the mask network")},
            {"stop_tracking", tr("Stopping the tracking")},
            {"start_trial", tr("Preparing the trial of a load")},
            {"stop_trial", tr("Ending the trial of a load")},
            {"open_case", tr("Opening the case")},
            {"save_case", tr("Saving the case")},
            {"keep_copy", tr("Keeping a copy for recovery")},
            {"recover_case", tr("Opening the copy")}};
  }
  static QHash<QString, QString> stages() {
    return {{"video.seek", tr("looking for the frame")},
            {"check.frame", tr("looking through the video")},
            {"volume.read", tr("reading slices")},
            {"volume.unpack", tr("unpacking")},
            {"labels.read", tr("reading labels")},
            {"mesh.read", tr("reading the mesh")},
            {"case.read", tr("reading files")},
            {"case.write", tr("writing files")},
            {"case.verify", tr("checking what was written")},
            {"case.saved", tr("saved")},
            {"segmentation.prepare", tr("preparing")},
            {"network.read", tr("reading the network")},
            {"network.tiles", tr("running the network")},
            {"segmentation.bias", tr("taking off the coils' brightness")},
            {"segmentation.propose", tr("comparing tissues")},
            {"segmentation.start", tr("growing from the seeds")},
            {"segmentation.vesselness", tr("looking for tubes")},
            {"segmentation.contour", tr("fitting the liver's surface")},
            {"segmentation.trees", tr("growing the vessels")},
            {"segmentation.finish", tr("cleaning up")},
            {"segmentation.around", tr("looking around the click")},
            {"segmentation.edit", tr("looking at voxels")},
            {"model.labels", tr("making surfaces")},
            {"model.surfaces", tr("reading surfaces")},
            {"model.mesh.size", tr("choosing the element size")},
            {"model.mesh.field", tr("preparing the mesh")},
            {"model.mesh.refine", tr("filling with elements")},
            {"model.mesh.lloyd", tr("improving the elements")},
            {"model.mesh.odt", tr("improving the elements")},
            {"model.mesh.perturb", tr("removing flat elements")},
            {"model.mesh.exude", tr("removing flat elements")},
            {"model.skeleton", tr("finding vessel centrelines")},
            {"model.margin", tr("finding the anterior margin")},
            {"atlas.pose", tr("laying the atlas on the liver")},
            {"atlas.drift", tr("bending the atlas")},
            {"atlas.fit", tr("fitting the atlas to the surface")},
            {"atlas.correspond", tr("bringing the template onto each liver")},
            {"atlas.leave_one_out", tr("foretelling each liver by the others")},
            {"atlas.livers", tr("reading livers")},
            {"model.quality", tr("measuring the mesh")},
            {"trial.model", tr("preparing the elements")},
            {"trial.solver", tr("preparing the solver")},
            {"stereo.detect", tr("finding points")},
            {"stereo.match", tr("matching points")},
            {"stereo.refine", tr("refining matches")},
            {"stereo.surface", tr("fitting the surface")},
            {"stereo.done", tr("finishing")},
            {"registration.rigid", tr("rigid start")},
            {"registration.operations", tr("simulated operations")},
            {"registration.shape", tr("most probable shape")},
            {"registration.elastic", tr("elastic deformation")},
            {"registration.forces", tr("contact forces")},
            {"fem.step", tr("steps in time")},
            {"fem.static", tr("looking for the equilibrium")},
            {"calibrate.find_board", tr("looking for the board")},
            {"calibrate.cameras", tr("calibrating each camera")},
            {"calibrate.joint", tr("calibrating both together")},
            {"calibrate.leave_out", tr("holding each view against the others")},
            {"calibrate.done", tr("finishing")},
            {"figure.shapes", tr("shapes with altered supports")},
            {"prove.theatre", tr("placing the laparoscope")},
            {"prove.registration", tr("registering livers")},
            {"prove.pulled", tr("pulling, registering and following organs")},
            {"patient.shape", tr("shaping a synthetic liver")},
            {"patient.vessels", tr("growing its vessels")},
            {"patient.ct", tr("making its CT")},
            {"patient.scan", tr("making its CT")},
            {"patient.surfaces", tr("measuring the true surfaces")},
            {"insilico.pull", tr("pulling and pressing the organ")},
            {"insilico.handle", tr("handling the liver")},
            {"theatre.gas", tr("inflating the abdomen")},
            {"theatre.breathing", tr("letting the patient breathe")},
            {"theatre.heartbeat", tr("letting the heart beat")},
            {"theatre.camera", tr("placing the laparoscope")},
            {"theatre.ready", tr("placing the laparoscope")},
            {"theatre.film", tr("filming the liver")},
            {"demo.track", tr("following the film")},
            {"soak.frames", tr("following the film")},
            {"soak.kills", tr("killing the program at work")}};
  }
  static QHash<QString, QString> structures() {
    return {{"background", tr("Background")},   {"parenchyma", tr("Liver")},
            {"portal_vein", tr("Portal vein")}, {"hepatic_veins", tr("Hepatic veins")},
            {"vena_cava", tr("Vena cava")},     {"artery", tr("Hepatic artery")},
            {"gallbladder", tr("Gallbladder")}};
  }
  static QString lesion(int number) { return tr("Lesion %1").arg(number); }
  static QString state(engine::StageState state) {
    switch (state) {
      case engine::StageState::absent:
        return tr("Not done");
      case engine::StageState::current:
        return tr("Up to date");
      case engine::StageState::stale:
        return tr("Out of date");
    }
    return {};
  }
};

QString to_q(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

QString readable_code(std::string_view code) {
  QString text = to_q(code);
  text.replace(QLatin1Char('.'), QStringLiteral(": ")).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString command_text(std::string_view code) {
  return Texts::commands().value(to_q(code), readable_code(code));
}
QString stage_text(std::string_view code) { return Texts::stages().value(to_q(code), readable_code(code)); }

QString structure_text(Label label) {
  if (is_lesion(label)) return Texts::lesion(label - structure::kFirstLesion + 1);
  const std::string name = structure_name(label);
  return Texts::structures().value(to_q(name), readable_code(name));
}

QString stage_state_text(engine::StageState state) { return Texts::state(state); }

}  // namespace glisson::ui
