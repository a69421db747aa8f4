// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <cmath>

#include "glisson/patient/label_map.h"
#include "glisson/ui/common/atlas_texts.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

/// Context of these sentences for translators.
class Notes {
  Q_DECLARE_TR_FUNCTIONS(Notes)
 public:
  /// Sentences by code; %1, %2, ... are the values that follow the code, in their order; %* is all of them,
  /// a sentence.
  static QHash<QString, QString> sentences() {
    return {
        {"liver.small", tr("The liver is smaller than 400 ml: check it in the slices.")},
        {"liver.cut_off",
         tr("The image ends inside the liver: %1 cm² of its surface are a cut and no surface. Take a whole "
            "CT, or register nothing of what lies there.")},
        {"liver.cut_by_region",
         tr("The liver ends on the border of the region that was segmented: %1 cm² there are a cut and no "
            "surface. Segment a larger region.")},
        {"liver.perhaps_more",
         tr("%1 ml of tissue that looks like the liver and hangs on it were left out, as another organ. If "
            "they are liver, as a lobe behind a tumour is, click in them.")},
        {"liver.dark_body",
         tr("%1 ml of tissue in the liver are darker than it, and nobody clicked there. A tumour or cyst: "
            "click it as a lesion. Gallbladder, stomach or bowel: click it as that, or as \"not liver\".")},
        {"image.metal", tr("Something denser than any bone, as metal is, lies in %1 slices of the liver or "
                           "next to them: its streaks may have taken liver away or added to it. "
                           "Check these slices.")},
        {"seed.liver_apart",
         tr("Liver seed %1 had no effect: nothing joins its surroundings to the rest of the liver. Click "
            "between the two, or take it away.")},
        {"seed.liver_taken", tr("Liver seed %1 had no effect: %2 lies there. Take one of the two away.")},
        {"seed.not_liver_taken",
         tr("\"Not liver\" seed %1 had no effect: %2 lies there. Take one of the two away.")},
        {"seeds.proposed", tr("The seeds in the liver are a proposal: look at what is segmented from them, "
                              "slice by slice.")},
        {"liver.large", tr("The liver is larger than 4000 ml: check it in the slices.")},
        {"liver.piece_dropped", tr("A separate piece of the liver's surface was left out (%2 ml).")},
        {"liver.pieces_dropped", tr("Separate specks of liver were left out: %1 (%3 ml).")},
        {"nothing_changed", tr("Nothing changed.")},
        {"no_slices_between", tr("There is no empty slice between two that are drawn.")},
        {"level_tracing.open", tr("The region reaches the slice's edge: click where it is enclosed.")},
        {"vessel_path.radius_unseen",
         tr("The image shows no vessel on the way: it was made as thin as can be. Check it in the slices.")},
        {"vessel_path.faint",
         tr("On %1 % of the way the image shows no radius: it was taken from the rest. Check it there.")},
        {"islands_left", tr("No label was free for the smallest islands: %1 stayed as they were.")},
        {"portal_vein.not_found", tr("No portal vein was found at its seeds: what there was stays.")},
        {"portal_vein.faint",
         tr("The portal vein is hardly brighter than the liver where it was clicked: in this phase it cannot "
            "be told from it, and most or all of it is missing. Take the portal venous phase.")},
        {"hepatic_veins.faint",
         tr("The hepatic veins are hardly brighter than the liver where they were clicked: in this phase "
            "they cannot be told from it, and most or all of them are missing. Take the portal venous "
            "phase.")},
        {"portal_vein.click_without_effect",
         tr("Portal vein seed %1 had no effect: no branch of it was found within 5 mm. Click in the middle "
            "of the vein, or take the seed away.")},
        {"hepatic_veins.click_without_effect",
         tr("Hepatic vein seed %1 had no effect: no branch of them was found within 5 mm. Click in the "
            "middle of a vein, or take the seed away.")},
        {"hepatic_veins.hold_cava",
         tr("%1 ml of the hepatic veins lie outside of the liver: they have grown on into the vena cava. "
            "Click the vena cava, too, and segment again.")},
        {"hepatic_veins.beside_cava",
         tr("%1 ml of the hepatic veins lie outside of the liver: perhaps in a part of the vena cava that "
            "its "
            "seeds did not find. Click the vena cava there, too, and segment again.")},
        {"vena_cava.small",
         tr("Only %1 ml of the vena cava were found: its seeds may lie in a clot or tumour. Click it "
            "elsewhere, too, and segment again.")},
        {"gallbladder.large",
         tr("The gallbladder has %1 ml, more than a full one mostly has: it may have run on into a cyst, "
            "fluid or bowel beside it. Check it in the slices.")},
        {"vena_cava.not_found", tr("No vena cava was found at its seeds: what there was stays.")},
        {"gallbladder.not_found", tr("No gallbladder was found at its seeds: what there was stays.")},
        {"liver.perhaps_mirrored",
         tr("The liver lies to the left of the vena cava: left and right may be swapped in the image.")},
        {"liver.axes_exchanged",
         tr("By its shape this liver fits the atlas clearly better with %1 exchanged. Check in the slices, "
            "or "
            "where the file comes from, that it lies on the patient's right and its dome towards the head. "
            "If "
            "not, correct the orientation in the file's header (surfaces: export them in LPS) and import it "
            "again.")},
        {"hepatic_veins.not_found", tr("No hepatic vein was found at its seeds: what there was stays.")},
        {"vessels.pieces_dropped",
         tr("%1: loose specks left out of the vessel model: %2 (%4 ml). In 3D they are drawn, over "
            "the picture with thin branches only.")},
        {"vessels.pieces", tr("%1: separate trees in the model: %2.")},
        {"vessels.branches_pruned",
         tr("Thin side branches left out of the vessel model: %1 (%3 mm together).")},
        {"vessels.pruned_radius_mm", tr("The thickest of them has a radius of %1 mm.")},
        {"vessels.pruned_by_hand", tr("%1: cut off by hand: %3 mm, tips: %5.")},
        {"label.not_started", tr("%1: the label has not been reviewed.")},
        {"label.in_progress", tr("%1: the label's review is in progress.")},
        {"label.to_review", tr("%1: the label is still to be reviewed.")},
        {"vessels.beams", tr("Beams along the vessels: %1.")},
        {"vessels.nodes_outside_mesh", tr("Vessel nodes just outside the mesh, tied to its surface: %1.")},
        {"vessels.beams_outside",
         tr("%1 of the %2 beams along the vessels lie outside the mesh and stiffen nothing: check whether "
            "vessels and liver belong together.")},
        {"vessels.outside_liver", tr("%1 lies outside the liver and was left out.")},
        {"vessels.open_surface",
         tr("%1: its surface has holes, or triangles that face the wrong way. For the vessel model each hole "
            "was closed straight across: check the vessel's ends and branches, or mend the surface in the "
            "program that made it.")},
        {"case.former_registration_lost",
         tr("The former registration could not be read and was left out (%*).")},
        {"tissue.no_lesion", tr("%1 is no lesion of this model: what is said of its stiffness is left out.")},
        {"tissue.no_elements",
         tr("%1 has no elements of its own: its stiffness changes nothing. Build the model finer at "
            "lesions.")},
        {"lesion.outside_liver", tr("%1 lies outside the liver and was left out.")},
        {"lesion.clipped", tr("%1: %2 % of its volume lie outside the liver or in another lesion; its "
                              "elements leave that out.")},
        {"lesion.dropped", tr("%1 was left out: only %3 mm³.")},
        {"lesion.in_pieces",
         tr("%1 lies in %2 pieces more than 5 mm apart, and is judged as one, at the middle of all. Split it "
            "into islands and build the model again.")},
        {"lesion.crumbs_dropped", tr("Crumbs of lesion surfaces left out: %1.")},
        {"lesion.too_small_for_the_mesh",
         tr("%1 (%3 mm across) is too small for elements of its own; it follows the tissue around it.")},
        {"lesion.without_tetrahedra", tr("%1 got no elements of its own; it follows the tissue around it.")},
        {"mesh.boundary_not_manifold", tr("The mesh's surface is not a clean closed one.")},
        {"mesh.labels_by_number",
         tr("The mesh does not say what its labels mean. They were taken as Glisson's own: %*. If they mean "
            "something else, write Glisson's into it: 1 is the parenchyma, 16 the first lesion.")},
        {"mesh.sliver_deg", tr("The flattest element has an angle of %1°.")},
        {"mesh.vertices_off_target", tr("The mesh has %1 vertices, not as many as asked for.")},
        {"surfaces.of_one_name", tr("The file %1 was not used: %2 shows the same structure.")},
        {"surfaces.ignored", tr("The file %1 was not used: its name tells no structure.")},
        {"landmarks.no_anterior_margin",
         tr("No anterior margin was found: the registration has one feature less.")},
        {"landmarks.margin_on_cut",
         tr("The image ends inside the liver: %1 mm of what looks like its anterior margin are the edge of "
            "that cut and were left out. Check the margin there.")},
        {"landmarks.no_vena_cava",
         tr("The model has no vena cava: nothing says where the organ is held. Let the atlas propose it.")},
        {"landmarks.not_reviewed", tr("%1: nobody has reviewed what is proposed.")},
        {"landmarks.mark_stays",
         tr("%1: what was placed by hand is used instead of the proposal. Clear it to "
            "use the proposal.")},
        {"atlas.cava_from_statistics",
         tr("Where the organ is held (vena cava) comes from statistics alone, with a deviation of %1 mm.")},
        {"atlas.notch_from_statistics",
         tr("The umbilical notch comes from statistics alone, with a deviation of %1 mm.")},
        {"atlas.margin_from_statistics",
         tr("%1 % of the anterior margin that the registration uses come from statistics alone.")},
        {"atlas.margin_left_out",
         tr("%1 % of the proposed anterior margin come from statistics alone: the registration does not use "
            "them.")},
        {"atlas.unusual_shape",
         tr("This liver's shape is %1 times as unusual as the atlas knows: the proposals are uncertain.")},
        {"atlas.unusual_size",
         tr("This liver's size lies %1 deviations from the atlas' mean: the proposals are uncertain.")},
        {"atlas.poor_fit", tr("The atlas does not fit this liver: %1 mm apart on average.")},
        {"atlas.folded", tr("The atlas is folded on this liver (%1 % of its surface).")},
        {"atlas.turned", tr("This liver is turned by %1° against the atlas: check how the patient lies.")},
        {"atlas.no_whole_liver", tr("This is not the shape of a whole liver: a part is missing, it is much "
                                    "changed, or left and right "
                                    "are mixed up.")},
        {"atlas.perhaps_mirrored",
         tr("The mirror image of this liver fits the atlas nearly as well: check left and right.")},
        {"atlas.open_surface", tr("The liver's surface is open: the proposals are uncertain.")},
        {"atlas.several_pieces", tr("The liver's surface has %1 pieces; the largest was taken.")},
        {"atlas.contradiction",
         tr("%1: the image shows it %2 mm from where the atlas expects it. Check the segmentation.")},
        {"atlas.mark_contradicted",
         tr("%1: by the portal vein it lies %2 mm from where it was placed by hand. Check both.")},
        {"atlas.nothing_follows",
         tr("This atlas does not know how one landmark depends on another: none follows what was placed by "
            "hand.")},
        {"atlas.no_umbilical_part",
         tr("The segmented portal vein does not show the umbilical part of its left branch: notch and "
            "falciform ligament come from statistics. Is the left branch there?")},
        {"atlas.umbilical_part_elsewhere",
         tr("What looks like the portal vein's umbilical part does not lie where it should, and was not used "
            "for the notch: check that portal and hepatic veins are not swapped, and whether the round "
            "ligament lies on the right.")},
        {"atlas.not_approved", tr("The case %1 was left out: nobody has approved its liver, vena cava, "
                                  "gallbladder or portal vein.")},
        {"atlas.outlier", tr("The liver %1 differs from the others and counts less.")},
        {"atlas.too_few", tr("%1: too few livers show it, so that the atlas does not know it.")},
        {"atlas.taken_over", tr("%1: too few livers show it; taken over from the atlas '%2'.")},
        {"network.small_lesions", tr("Pieces too small for a lesion became parenchyma: %1.")},
        {"stereo.black", tr("Both pictures are dark.")},
        {"stereo.left_lost", tr("The left camera shows nothing.")},
        {"stereo.right_lost", tr("The right camera shows nothing.")},
        {"stereo.one_view", tr("Both pictures are the same: one camera is lost.")},
        {"stereo.swapped", tr("Left and right are swapped.")},
        {"stereo.unrelated", tr("The two pictures show nothing in common.")},
        {"stereo.other_scope", tr("The calibration is of another laparoscope: the pictures' points do not "
                                  "lie on its epipolar lines.")},
        {"stereo.duplicated", tr("The frame before comes once more.")},
        {"stereo.frozen", tr("The picture is frozen.")},
        {"stereo.left_frozen", tr("The left picture is frozen.")},
        {"stereo.right_frozen", tr("The right picture is frozen.")},
        {"stereo.out_of_order", tr("Two frames have changed places.")},
        {"stereo.interlaced",
         tr("The film is interlaced: the even and the odd rows of a picture show two moments, so that points "
            "on what moves are off by its motion in half of a frame's time. Set the device to progressive, "
            "or give --video a description of the source (.json) with \"deinterlace\": true.")},
        {"calibration.outlier", tr("The view %1 fits far worse than the others and was left out.")},
        {"calibration.proposed",
         tr("The view %1 fits far worse than the others: calibrate again without it.")},
        {"few_margin_points", tr("Few points show the anterior margin: the position along it is uncertain.")},
        {"no_notch",
         tr("The umbilical notch is not marked in both model and picture: the position along the margin is "
            "uncertain.")},
        {"rigid_residual_large", tr("The rigid start fits the points badly (more than 10 mm).")},
        {"little_surface_seen", tr("Less than a fifth of the organ's surface was seen: far from it vessels "
                                   "and tumours may be centimetres off.")},
        {"rival_chosen", tr("A person has chosen this place among several; the points alone gave it %1 %.")},
        {"shape_ambiguous", tr("Two different shapes of the organ explain the points almost equally well; "
                               "the better one was taken.")},
        {"law_ambiguous", tr("Two elastic laws explain the points almost equally well, but place the organ "
                             "differently; the better one was taken.")},
        {"forces_not_at_rest", tr("The search for contact forces ended before it had come to rest.")},
        {"forces_many", tr("The points are explained by %1 forces of tools (limit %2): by so many nearly "
                           "anything is.")},
        {"shape_unusual", tr("The organ would be bent as in hardly any simulated operation.")},
        {"shape_inverted", tr("The shape that fits the points would turn the organ inside out.")},
        {"rigid_ambiguous", tr("Two rigid positions fit almost equally well; the better one was taken.")},
        {"many_outliers", tr("Many points do not fit the model and were left aside.")},
        {"residual_large", tr("The model stays more than 5 mm from the points on average.")},
        {"inverted_elements", tr("Some elements of the mesh turned inside out.")},
        {"cloud.repeated", tr("Points of the cloud that were there twice were left out: %1.")},
        {"cloud.without_depth",
         tr("Points of the cloud at the lens itself were left out: %1. Such a point has no depth.")},
        {"cloud.normals_turned", tr("Normals of the cloud that faced away from the camera were turned: %1. "
                                    "It saw the side that faces "
                                    "it.")},
        {"cloud.behind",
         tr("Points of the cloud that lie behind the camera: %1. The organ is registered to them, but no "
            "picture shows it there. If they are from OpenGL or VTK, turn them by 180° about x.")},
        {"organ_cut",
         tr("The CT ends inside the liver (%1 cm² are a cut): there the model has a surface that the organ "
            "has not.")},
        {"size_differs",
         tr("The organ would have to be larger or smaller by %1 % (limit %2 %) to fit the points: check the "
            "calibration (distance of the cameras, zoom) and the unit of the cloud.")},
        {"cloud_noisy", tr("The cloud's points scatter by %1 mm about a smooth surface (limit %2 mm).")},
        {"expected_error_large", tr("The organ is expected to be off by %1 mm on average (limit %2 mm).")},
        {"elsewhere_probable",
         tr("With a probability of %1 % (limit %2 %) the organ lies more than 2 cm from "
            "here: other places explain the points as well. Mark the notch, show more of the organ, "
            "keep this look and add another one, or place it by hand.")},
        {"points_turned", tr("%1 % of the points face another way than the model there (limit %2 %).")},
        {"margin_off", tr("The marked margin lies %1 mm from the model's (limit %2 mm).")},
        {"shape_strange",
         tr("The organ would be bent %1 times as much as operations and tools explain (limit %2).")},
        {"looks_differ",
         tr("With a probability of %1 % (limit %2 %) the organ has moved or been bent between the looks: no "
            "one shape explains them. Forget the earlier looks and register with the present points alone.")},
        {"mirror_fits",
         tr("The cloud's mirror image fits as well or nearly so (log odds %1, limit %2): it has "
            "not been recognised as this liver.")},
        {"look.surface",
         tr("%1: one more look helps most at %2. Expected error then %4 mm instead of %3 mm.")},
        {"look.margin", tr("%1: mark the anterior margin where it is seen. Expected error then %3 mm instead "
                           "of %2 mm.")},
        {"look.notch", tr("%1: mark the umbilical notch, which is seen. Expected error then %3 mm instead of "
                          "%2 mm.")},
        {"refused", tr("The registration was refused: what is known contradicts it.")},
        {"registration.doubts_not_in_file", tr("The written file's format holds places only, none of these "
                                               "doubts: name it .vtp or .vtk and they "
                                               "go along.")},
        {"refusal_accepted", tr("The registration was refused, and somebody uses it nevertheless.")},
        {"pull_not_at_rest", tr("The organ was still moving towards the points after the last step.")},
        {"mechanics_failed", tr("The mechanical computation did not come to an end.")},
        {"simulation_not_converged", tr("The simulation had not come to rest at its last step.")},
        {"image.small", tr("The volume measures only %1 mm along its shortest side: a liver is larger.")},
        {"image.large", tr("The volume is %1 mm wide: no scanner is. Check its unit.")},
        {"image.constant_slices",
         tr("%1 of %2 slices hold nothing but one value: they may have been lost on the way.")},
        {"image.repeated_slices",
         tr("%1 of %2 slices are the one before over again: some may have been lost on the way.")},
        {"image.zeros", tr("%1 % of the voxels are exactly 0: the volume may be cut off or masked.")},
        {"image.no_tissue",
         tr("Only %1 % of the voxels have the Hounsfield units of soft tissue. Either this is no CT in "
            "Hounsfield units, or the scanner's rescale slope and intercept were lost on the way. Look at "
            "water and muscle in the slices (0 and 50 HU); if they are not so, export the CT again from its "
            "DICOM series.")},
        {"image.no_air",
         tr("Hardly a voxel has the Hounsfield units of air (%1 %). Either the CT was cropped to tissue, or "
            "the scanner's rescale intercept was lost on the way. Look at water and muscle in the slices (0 "
            "and 50 HU); if they are not so, export the CT again from its DICOM series.")},
        {"image.shifted",
         tr("Shifted by %1 HU the volume would hold air and soft tissue, as a CT does: the scanner's "
            "intercept was probably lost or added twice. Do not trust what is segmented from such values.")},
        {"case.open_for_reading",
         tr("The case is open for writing by %*. It was opened for reading here: saved now, it needs another "
            "name.")},
        {"case.folder_not_writable", tr("The folder around the case cannot be written to. It was opened for "
                                        "reading: save it elsewhere.")},
        {"case.saved_beside",
         tr("Others have saved this case since it was opened here. Theirs stays as it is; yours was saved as "
            "%*. Compare the two.")},
        {"case.kept_changed",
         tr("A file of the case was changed by another program since it was saved. What it held is kept as "
            "%*.")},
        {"case.changed_outside", tr("A file of the case was changed outside of Glisson since it was saved: "
                                    "%*. Check what it holds.")},
        {"case.video_lost",
         tr("The case was opened without its video, which the case has chosen and nobody here. If you trust "
            "it, open it yourself (Stereo > Open; on the command line --video of render and overlay). "
            "(%*)")},
        {"case.moment_lost",
         tr("The case was opened without a kept moment, which cannot be read. The others are there. Saved "
            "now, the case loses what is left of it. (%*)")},
        {"labels.other_frame", tr("The segmentation names another DICOM frame of reference than the CT, as "
                                  "one of another scan does: "
                                  "check in the slices that it lies on this liver.")},
        {"labels.segments_left_out",
         tr("Segments that the file does not say to be anything of the liver were left out: %*.")},
        {"labels.codes_left_out", tr("Labels of which the codes say nothing were left out: %*.")},
        {"labels.lesion_split",
         tr("%1 lay in %2 pieces more than 5 mm apart: each is a lesion of its own now.")},
        {"labels.lesion_not_split",
         tr("No label was free for the smallest pieces of %1: %2 stayed with it.")},
        {"labels.by_number",
         tr("The file does not say what its numbers mean. They were taken as Glisson's own: %*. If they mean "
            "something else, import it again by 'glisson model --labels FILE --codes FILE'.")},
        {"calibration.left_lens_turns_back",
         tr("By this calibration %1 % of the left picture, from its edges on, has no ray: nothing is drawn "
            "there, and points there are wrong. Calibrate with boards in the corners, too, and without k3.")},
        {"calibration.right_lens_turns_back",
         tr("By this calibration %1 % of the right picture, from its edges on, has no ray: points there are "
            "wrong. Calibrate with boards in the corners, too, and without k3.")},
        {"volume.files_missing", tr("The DICOMDIR names files that are not there: slices may be missing. "
                                    "Copy the whole medium. (%*)")},
        {"case.calibration_lost",
         tr("The case was opened without its laparoscope's calibration: load a right one and reconstruct the "
            "surface again; points and registration are out of date. Saved now, the case loses this one. "
            "(%*)")},
        {"case.cloud_lost",
         tr("The case was opened without its cloud of points: reconstruct the surface or import the cloud "
            "again. Saved now, the case loses what is left of it. (%*)")},
        {"case.points_lost",
         tr("The case was opened without the points of the whole stereo pair: reconstruct the surface again "
            "before regions are changed. Saved now, the case loses what is left of them. (%*)")},
        {"case.operations_lost",
         tr("The case was opened without the operations that were simulated on its model: the next "
            "registration simulates them anew. (%*)")}};
  }
  /// Of registration::place_on_liver().
  static QHash<QString, QString> places() {
    return {{"left_dome", tr("the left lobe's dome")},
            {"left_underside", tr("the left lobe's underside")},
            {"left_front", tr("the left lobe's front")},
            {"left_side", tr("the left lobe's side")},
            {"left_back", tr("the left lobe's back")},
            {"right_dome", tr("the right lobe's dome")},
            {"right_underside", tr("the right lobe's underside")},
            {"right_front", tr("the right lobe's front")},
            {"right_side", tr("the right lobe's side")},
            {"right_back", tr("the right lobe's back")},
            {"liver_dome", tr("the liver's dome")},
            {"liver_underside", tr("the liver's underside")},
            {"liver_front", tr("the liver's front")},
            {"liver_side", tr("the liver's side")},
            {"liver_back", tr("the liver's back")}};
  }
  /// Of atlas::orientation_doubts(): what is exchanged.
  static QHash<QString, QString> axes() {
    return {{"left_right", tr("left and right")},
            {"front_back", tr("front and back")},
            {"head_feet", tr("head and feet")},
            {"left_right+front_back", tr("left and right, front and back (as between RAS and LPS)")},
            {"left_right+head_feet", tr("left and right, head and feet")},
            {"front_back+head_feet", tr("front and back, head and feet")},
            {"left_right+front_back+head_feet", tr("left and right, front and back, head and feet")}};
  }
  /// Sentences by what a lesion's code ends in; %1 is its name, %2 the note's first value.
  static QList<std::pair<QString, QString>> of_lesions() {
    return {
        {".not_found",
         tr("%1 was not found: nothing at its seeds differs from the liver. What there was of it stays. Drag "
            "across it in a slice to tell its diameter, or paint it.")},
        {".click_without_effect",
         tr("%1: of its seeds, %2 had no effect. Nothing there differs from the liver, and what the others "
            "found does not reach there. Paint what is missing.")},
        {".goes_on", tr("%1 goes on as far as a click looks for its border, and perhaps farther: draw its "
                        "diameter.")},
        {".under_surface",
         tr("%1 comes within %2 mm of the liver's surface, where the CT does not show its border: whether "
            "liver covers it is not known. Check it in the slices.")},
        {".bright",
         tr("%1 is brighter than the liver: a vein, or a lesion that takes up contrast. Check it in "
            "the slices.")},
        {".perhaps_vein",
         tr("%1 is brighter than the liver, and a vein goes on at %2 % of its surface: it may be a "
            "piece of that vein. Check it in the slices.")},
        {".error_large", tr("%1 is expected to be off by %2 mm on average (limit %3 mm).")},
        {".as_drawn", tr("%1: no border was found where its diameter was drawn. It is a ball of that "
                         "diameter: check it "
                         "in the slices.")},
    };
  }
};

QString structure_named(const QString& code) {
  for (const Label label : {structure::kParenchyma, structure::kPortalVein, structure::kHepaticVeins,
                            structure::kVenaCava, structure::kArtery, structure::kGallbladder})
    if (code == QString::fromStdString(structure_name(label))) return structure_text(label);
  if (const QString landmark = landmark_text(code); !landmark.isEmpty()) return landmark;
  const QString prefix = QStringLiteral("lesion_");
  bool number = false;
  const int lesion = code.startsWith(prefix) ? code.mid(prefix.size()).toInt(&number) : 0;
  return number ? structure_text(static_cast<Label>(structure::kFirstLesion + lesion - 1)) : QString();
}

/// "4.15e+03" -> "4150", "0.0135" -> "0.01", "portal_vein" -> "Portal vein". @param decimals of a small
/// number.
QString value_text(const QString& token, int decimals = 2) {
  bool is_number = false;
  const double value = token.toDouble(&is_number);
  if (is_number) {
    const bool whole = value == std::round(value) || std::abs(value) >= 100.0;
    return QString::number(value, 'f', whole ? 0 : std::abs(value) >= 10.0 ? 1 : decimals);
  }
  if (const QString place = Notes::places().value(token); !place.isEmpty()) return place;
  if (const QString axes = Notes::axes().value(token); !axes.isEmpty()) return axes;
  const QString structure = structure_named(token);
  return structure.isEmpty() ? QString::fromUtf8(QByteArray::fromPercentEncoding(token.toUtf8())) : structure;
}

}  // namespace

QString note_text(std::string_view note) {
  const QStringList tokens = QString::fromUtf8(note.data(), static_cast<qsizetype>(note.size()))
                                 .split(QRegularExpression(QStringLiteral("[ :]")));
  const QString& code = tokens.front();
  // An expectation is no measurement.
  const bool is_expected =
      code.startsWith(QLatin1String("look.")) || code.endsWith(QLatin1String("error_large"));
  const int decimals = is_expected ? 1 : 2;
  const auto sentences = Notes::sentences();
  if (const auto known = sentences.find(code); known != sentences.end()) {
    QString text = *known;
    if (text.contains(QLatin1String("%*")))
      return text.replace(
          QLatin1String("%*"),
          QString::fromUtf8(note.data(), static_cast<qsizetype>(note.size())).mid(code.size() + 1));
    for (qsizetype i = 1; i < tokens.size(); ++i)
      text.replace(QStringLiteral("%%1").arg(i), value_text(tokens[i], decimals));
    return text;
  }
  for (const auto& [ending, sentence] : Notes::of_lesions())
    if (code.endsWith(ending))
      if (const QString structure = structure_named(code.chopped(ending.size())); !structure.isEmpty()) {
        QString text = sentence;
        text.replace(QLatin1String("%1"), structure);
        for (qsizetype i = 1; i < tokens.size(); ++i)
          text.replace(QStringLiteral("%%1").arg(i + 1), value_text(tokens[i], decimals));
        return text;
      }
  QString text = readable_code(code.toStdString());
  for (qsizetype i = 1; i < tokens.size(); ++i) text += QLatin1Char(' ') + value_text(tokens[i]);
  return text;
}

QString notes_text(const std::vector<std::string>& notes) {
  QStringList lines;
  for (const std::string& note : notes) lines << QStringLiteral("• ") + note_text(note);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace glisson::ui
