// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/geometry/camera.h"
#include "glisson/insilico/tool_use.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"

namespace glisson::insilico {

/// What is filmed, by which laparoscope, and what moves the liver meanwhile.
struct TheatreOptions {
  std::uint64_t seed = 1;
  int width = 960, height = 540;  ///< of either picture, pixels
  double frames_per_second = 30.0;
  int frames = 300;
  double camera_distance_mm = 120.0;   ///< to the middle of what is seen, 80 to 160
  double horizontal_view_deg = 70.0;   ///< field of view
  double baseline_mm = 5.0;            ///< between both optical centres
  double pneumoperitoneum_pa = 0.0;    ///< on the anterior face; 0: chosen so that elastic_motion_mm remains
  double mean_displacement_mm = 22.0;  ///< of the first frame from the CT, 20 to 60
  double elastic_motion_mm = 8.4;      ///< of it, after the best rigid alignment: 8 and more prove something
  double breathing_mm = 6.0, breathing_period_s = 4.0;  ///< mean motion from expiration to inspiration
  double heartbeat_mm = 1.0, heartbeat_period_s = 0.9;  ///< largest motion, next to the heart
  double noise = 2.0;                                   ///< grey levels, standard deviation
  int truth_vertices = 3000;         ///< of the theatre's own mesh; the registration's has some 550
  double young_modulus_pa = 8000.0;  ///< of the truth's Neo-Hookean parenchyma (the registration's: 3500)
  /// @throws InputError naming the option.
  void validate() const;
};

/// How a hand holds the laparoscope: it turns about the trocar, slides through it, and rolls. Slow
/// oscillations of unlike periods; frame 0 is where it stood. All zero: it does not move.
struct ScopePath {
  double pivot_deg = 0.0;    ///< amplitude about the trocar, up and down and half of it sideways
  double slide_mm = 0.0;     ///< largest way out of the trocar, from the organ
  double roll_deg = 0.0;     ///< amplitude about the optical axis
  double period_s = 4.0;     ///< of the pivot; the others' are 1.3 and 1.7 times as long
  double trocar_mm = 150.0;  ///< behind the optical centre
  double zoom_mm = 0.0;      ///< amplitude along the axis, towards the organ first
  double zoom_period_s = 4.0;
  double ease_s = 0.0;  ///< from standing to full speed
  /// As a hand holds it: up to 10 degrees and 45 mm a second, a third nearer and farther.
  static ScopePath in_a_hand();
  /// As fast as one is held: up to 30 degrees and 100 mm a second, between 60 and 180 mm from what is 120 mm
  /// away.
  static ScopePath in_a_fast_hand();
  /// @throws InputError naming the option.
  void validate() const;
};

/// What the theatre did to the liver, in-silico figures.
struct TheatreFigures {
  double mean_displacement_mm = 0.0;  ///< frame 0 from the CT, mean over the truth's nodes, CT frame
  double elastic_motion_mm = 0.0;     ///< of it after the best rigid alignment (fit_rigid)
  double pressure_pa = 0.0;           ///< of the gas on the anterior face
  double breathing_mm = 0.0;          ///< mean motion from expiration to inspiration
  double heartbeat_mm = 0.0;          ///< largest
  int nodes = 0, tetrahedra = 0, static_solves = 0;
  double smallest_volume_ratio = 0.0;  ///< of any tetrahedron, deformed over rest, over all key states
};

/// What is true in one frame.
struct FrameTruth {
  Points nodes_in_camera;    ///< of the theatre's own (finer) mesh
  Points targets_in_camera;  ///< lesion centres, in the order of Theatre::targets()
};

/// A lesion whose centre is followed.
struct Target {
  Label structure = 0;
  Eigen::Vector3d centre_in_ct = Eigen::Vector3d::Zero();  ///< metres
};

/// How a patch of the surface is sampled.
struct PatchOptions {
  double share = 0.3;  ///< of the liver's surface, in (0, 1]
  double density_per_cm2 = 3.9;
  double noise_mm = 1.0;       ///< standard deviation a coordinate
  double outlier_share = 0.0;  ///< of the points, displaced by up to 15 mm
  int holes = 0;               ///< discs of hole_mm without points
  double hole_mm = 12.0;
  double margin_mm = 5.0, notch_mm = 8.0;  ///< within which distance a point is labelled so
  std::uint64_t seed = 1;
  /// @throws InputError naming the option.
  void validate() const;
};
/// Points of the liver's surface as a camera would give them.
struct Patch {
  LabelledCloud cloud;  ///< left camera's frame
  double share = 0.0;   ///< of the surface that was covered
};

/// The operating room: the patient's liver on a finer mesh of its own with a Neo-Hookean law, moved by gas,
/// gravity, breathing and heartbeat, seen by a calibrated stereo laparoscope through a ray caster (Embree)
/// with lens distortion, highlights, fall-off, vignetting and noise. Nothing of it is read by the stages,
/// only its pictures. Thread-safe; pictures are drawn one at a time, on two threads. The same patient and
/// options give the same bits. See the README for the physics and what it leaves out.
class Theatre {
 public:
  /// @param patient surfaces (liver required), lesions, landmarks of any patient, CT frame. A missing margin
  ///   is detected, a missing notch is where that margin runs in deepest, a missing vena cava is the
  ///   posterior superior medial surface.
  /// @throws InputError no closed liver surface; NumericalError no load moves it enough.
  static Cancellable<std::unique_ptr<Theatre>> build(const PatientModel& patient,
                                                     const TheatreOptions& options,
                                                     const RunContext& context);
  ~Theatre();

  const TheatreOptions& options() const;
  const TheatreFigures& figures() const;
  const StereoRig& rig() const;
  const CameraFromCt& camera_from_ct() const;  ///< the truth: where the camera stands in frame 0
  /// From now on the camera moves so. Truths and pictures are in the camera's frame of their moment.
  /// @throws InputError naming the option.
  void move_scope(const ScopePath& path);
  /// From now on a tool is used so. What it does to the organ is an equilibrium of the same mesh, law and
  /// loads with springs at its tip; breath and heartbeat are added. A way of zero: no tool.
  /// @param context cancel. @return false: cancelled, and nothing has changed.
  /// @throws InputError naming the option; NumericalError the organ cannot be taken so far.
  bool use_tool(const ToolUse& use, const RunContext& context);
  /// Where the tool touches the organ in a frame, left camera's frame, metres, also while it is away; empty:
  /// no tool. Newton: what it pulls with at the end of its way.
  std::optional<Eigen::Vector3d> tool_touches(int frame) const;
  double tool_force_n() const;
  const TetMesh& mesh() const;         ///< rest shape, CT frame
  const Landmarks& landmarks() const;  ///< the patient's, completed; CT frame, rest
  const std::vector<Target>& targets() const;
  int frame_count() const;
  double seconds(int frame) const;

  /// @pre 0 <= frame < frame_count(), here and below.
  FrameTruth truth(int frame) const;
  StereoFrame render(int frame) const;
  /// Depth along z of every left pixel, metres; 0 where the liver is not hit. Row-major, width * height.
  std::vector<float> depth(int frame) const;
  /// Where any points of the CT-frame liver are in a frame (left camera's frame, metres), carried by the
  /// truth's mesh (for nodes of another mesh). Points outside the mesh move with the tetrahedron next to
  /// them.
  PointsIn<CameraFrame> carry(const Points& points_in_ct, int frame) const;
  /// The carried fine surface of a frame, left camera's frame.
  TriangleMesh surface(int frame) const;
  /// Which of the points (left camera's frame) the left camera sees in a frame.
  std::vector<bool> seen(const Points& points_in_camera, int frame) const;
  /// Share of the liver's surface seen by both cameras in a frame.
  double visible_share(int frame) const;
  /// A patch of about `share` of the surface, seen from the camera's side, noisy, labelled: the paper's
  /// protocol. It need not be inside the field of view. @throws InputError options.
  Patch patch(int frame, const PatchOptions& options) const;
  LabelledCloud patch(int frame, double share, double density_per_cm2, double noise_mm,
                      std::uint64_t seed) const;

 private:
  struct Impl;
  explicit Theatre(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glisson::insilico
