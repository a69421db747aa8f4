// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/camera.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/segmentation/segment.h"
#include "glisson/stereo/reconstruct.h"

namespace glisson::insilico {

struct TheatreOptions {
  std::uint64_t seed = 1;
  int width = 960, height = 540;
  double frames_per_second = 30.0;
  int frames = 300;
  double camera_distance_mm = 110.0;   ///< 80 to 160
  double pneumoperitoneum_pa = 0.0;    ///< 0: chosen so that the mean displacement meets the next line
  double mean_displacement_mm = 22.0;  ///< of the first frame from the CT, at least 20
  double breathing_mm = 6.0, breathing_period_s = 4.0, heartbeat_mm = 1.0, heartbeat_period_s = 0.9;
  double noise = 2.0;  ///< grey levels
  void validate() const;
};

/// What is true in one frame.
struct FrameTruth {
  Points nodes_in_camera;    ///< of the theatre's own (finer) mesh
  Points targets_in_camera;  ///< lesion centres, in the order of Theatre::targets()
};

/// The operating room: the patient's liver on a finer mesh of its own with a Neo-Hookean law, moved by gas,
/// gravity, breathing and heartbeat, seen by a calibrated stereo laparoscope through a ray caster (Embree)
/// with lens distortion, highlights, fall-off, vignetting and noise. Nothing of it is read by the stages,
/// only its pictures.
class Theatre {
 public:
  /// @param patient surfaces (liver required), lesions, landmarks of any patient, CT frame.
  static Cancellable<std::unique_ptr<Theatre>> build(const PatientModel& patient,
                                                     const TheatreOptions& options,
                                                     const RunContext& context);
  ~Theatre();

  const StereoRig& rig() const;
  const TetMesh& mesh() const;  ///< rest shape, CT frame
  int frame_count() const;
  FrameTruth truth(int frame) const;
  StereoFrame render(int frame) const;
  /// Depth along z of every left pixel, metres; 0 where the liver is not hit. Row-major, width * height.
  std::vector<float> depth(int frame) const;
  /// Where any points of the CT-frame liver are in a frame, carried by the truth's mesh (for nodes of another
  /// mesh).
  Points carry(const Points& points_in_ct, int frame) const;
  /// Share of the liver's surface seen by both cameras in a frame.
  double visible_share(int frame) const;
  /// A patch of about `share` of the surface, seen from the camera's side, noisy, labelled: the paper's
  /// protocol.
  LabelledCloud patch(int frame, double share, double density_per_cm2, double noise_mm,
                      std::uint64_t seed) const;

 private:
  struct Impl;
  explicit Theatre(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// A simulated operator: knows the truth, writes what a person would click, with click noise. Stages read
/// only its files.
struct OperatorOptions {
  double click_noise_mm = 1.5;  ///< in the CT
  double click_noise_px = 3.0;  ///< on the screen
  std::uint64_t seed = 1;
};
segmentation::Seeds click_seeds(const LabelMap& truth, const OperatorOptions& options);
Landmarks click_landmarks(const Landmarks& truth, const OperatorOptions& options);
stereo::Regions click_regions(const Theatre& theatre, int frame, const OperatorOptions& options);

}  // namespace glisson::insilico
