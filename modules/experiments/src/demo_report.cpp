// SPDX-License-Identifier: GPL-3.0-or-later
#include "demo_report.h"

#include "landmark_table.h"
#include "report.h"

namespace glisson::experiments {
namespace {

std::vector<ReportTable> tables() {
  return {
      {"Initial registration from the stereo pictures",
       "In silico. The truth comes from another, finer mesh with a non-linear law; the stages saw the "
       "theatre's pictures and the "
       "operator's clicks only. TRE: target registration error.",
       {{"motion_mean_mm", "Mean motion of the liver from the CT to the first frame"},
        {"rigid_best_mean_mm",
         "of it left by the best rigid motion (nobody knows it; a bound for rigid methods)"},
        {"tre_volume_mean_mm", "TRE, all nodes, mean"},
        {"tre_volume_max_mm", "TRE, all nodes, maximum"},
        {"tre_surface_mean_mm", "TRE, surface, mean"},
        {"tre_surface_max_mm", "TRE, surface, maximum"},
        {"tre_target_mean_mm", "TRE, tumours' centres, mean"},
        {"tre_target_max_mm", "TRE, tumours' centres, maximum"},
        {"registration_residual_mm", "Residual of the cloud to the model (not an accuracy)"},
        {"theatre_visible_share", "Share of the liver's surface that both cameras see"},
        {"cloud_points", "Points of the cloud"},
        {"cloud_density_per_cm2", "Density of the cloud"},
        {"cloud_error_median_mm", "Distance of the cloud to the true surface, median"},
        {"cloud_error_p95_mm", "Distance of the cloud to the true surface, 95th percentile"}}},
      {"Initial registration from a noisy patch of the surface",
       "In silico; the paper's protocol: a labelled part of the true surface with noise, not reconstructed "
       "from pictures.",
       {{"patch_visible_share", "Share of the surface"},
        {"patch_tre_volume_mean_mm", "TRE, all nodes, mean"},
        {"patch_tre_volume_max_mm", "TRE, all nodes, maximum"},
        {"patch_tre_surface_mean_mm", "TRE, surface, mean"},
        {"patch_tre_surface_max_mm", "TRE, surface, maximum"},
        {"patch_tre_target_mean_mm", "TRE, tumours' centres, mean"},
        {"patch_tre_target_max_mm", "TRE, tumours' centres, maximum"},
        {"patch_registration_residual_mm", "Residual of the cloud to the model (not an accuracy)"},
        {"patch_seconds_register", "Time"}}},
      {"Live",
       "In silico. A frame's time is tracking, correspondence and mechanics; drawing is software rendering "
       "and counted apart.",
       {{"frames", "Frames"},
        {"frames_late", "of them later than the next frame"},
        {"frames_valid", "of them with the whole overlay (valid)"},
        {"frames_degraded", "of them with the outline and uncertain targets only (degraded)"},
        {"frames_withdrawn", "of them without an overlay (withdrawn)"},
        {"frame_p50_ms", "Time of a frame, median"},
        {"frame_p99_ms", "Time of a frame, 99th percentile"},
        {"draw_mean_ms", "Time to draw a frame's overlay, mean"},
        {"track_tre_volume_mean_mm", "TRE over all frames, all nodes, mean"},
        {"track_tre_target_mean_mm", "TRE over all frames, tumours, mean"},
        {"track_tre_frozen_mean_mm", "The same for the model frozen after the first registration"},
        {"track_motion_mean_mm",
         "Motion since the first frame, all nodes, mean (a frozen model misses it all)"},
        {"track_motion_error_mean_mm", "Of it missed by tracking, whatever error it started with"},
        {"outline_mean_px", "Drawn outline to the organ's true edge in the picture, a frame's mean"},
        {"outline_p95_px", "The same, a frame's 95th percentile"},
        {"outline_worst_mean_px", "The same, mean of the worst frame"},
        {"outline_frames", "Frames that these are of (every fifth with an overlay; means over frames)"},
        {"margin_mean_px", "Drawn anterior margin to the true one in the picture, a frame's mean"},
        {"margin_p95_px", "The same, a frame's 95th percentile"},
        {"margin_worst_mean_px", "The same, mean of the worst frame"},
        {"margin_frames", "Frames that these are of"}}},
      {"The patient",
       "",
       {{"segmentation_dice_liver", "Liver, Dice coefficient with the truth"},
        {"label_parenchyma_ml", "Parenchyma"},
        {"model_volume_ml", "Volume of the mesh"},
        {"model_vertices", "Vertices"},
        {"model_tetrahedra", "Tetrahedra"},
        {"model_beams", "Beams"},
        {"model_lesions", "Lesions"},
        {"model_min_dihedral_deg", "Smallest dihedral angle"},
        {"model_vertices_to_fine_mean_mm", "Mesh vertices to the fine surface, mean"},
        {"model_fine_to_mesh_max_mm", "Fine surface to the mesh, maximum"}}},
      {"The theatre",
       "",
       {{"theatre_tetrahedra", "Tetrahedra of the truth's own mesh"},
        {"theatre_pressure_pa", "Gas pressure on the anterior face"},
        {"theatre_breathing_mm", "Breathing, mean motion"},
        {"theatre_heartbeat_mm", "Heartbeat, largest motion"}}},
      {"Time of each stage",
       "On the machine that made this report.",
       {{"seconds_synthetic_patient", "Synthetic patient"},
        {"seconds_import_image", "Import"},
        {"seconds_segment", "Segmentation"},
        {"seconds_build_model", "Model"},
        {"seconds_import_surfaces", "Model from surfaces"},
        {"seconds_theatre", "Theatre: deform and film"},
        {"seconds_reconstruct", "Reconstruction"},
        {"seconds_register", "Registration"},
        {"seconds_start_tracking", "Start of tracking"},
        {"seconds_save_case", "Save"}}},
  };
}

std::string caption(const std::string& name) {
  if (name == "slice") return "The CT with the segmentation, axial slice through the liver";
  if (name == "model") return "The biomechanical model: parenchyma, vessels, tumours";
  if (name == "left") return "What the left camera sees";
  return "Frame " + name.substr(name.find('_') + 1) + " with vessels and tumours";
}

}  // namespace

void write_demo_report(const std::filesystem::path& path, const std::string& patient,
                       const std::vector<std::string>& pictures,
                       const std::vector<engine::LandmarkOrigin>& landmarks, const DemoResult& result) {
  std::vector<ReportPicture> shown;
  shown.reserve(pictures.size());
  for (const std::string& name : pictures) shown.push_back({"pictures/" + name + ".png", caption(name)});
  const std::string introduction =
      "From CT to overlay: " + patient +
      ". The liver was deformed and filmed by the in-silico theatre; all errors are against its known "
      "truth. " +
      (result.overlay_video.empty() ? std::string() : "The overlay video is overlay.mkv, beside this page.");
  std::vector<ReportTable> all = tables();
  all.insert(all.begin(), landmark_table(landmarks));
  write_report(path, "Glisson demo: " + patient, introduction, all, shown, result.figures, result.notes);
}

}  // namespace glisson::experiments
