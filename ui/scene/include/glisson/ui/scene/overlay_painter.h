// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/guidance/lesion_meter.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "glisson/ui/scene/drawable_model.h"

namespace glisson::scene {

/// How depth is told.
enum class Look {
  tubes,     ///< shaded, fainter with depth
  focus,     ///< a window around what is looked at: opaque and in depth order inside, outlines outside
  contours,  ///< tubes with a line at every 10 mm of depth, bands lighter and darker in turns
  outlines   ///< silhouettes alone: they hide least
};
inline constexpr Look kLooks[] = {Look::tubes, Look::focus, Look::contours, Look::outlines};
/// "tubes"; for files and the command line.
const char* look_code(Look look);

/// What of the model is drawn on the laparoscope's picture, and how strongly.
struct OverlayStyle {
  bool portal_vein = true, hepatic_veins = true, arteries = true, lesions = true;
  bool outline = true, anterior_margin = true;
  bool bold_outline = false;  ///< seen at a glance: where the outline is all that there is
  bool legend = true, status = true;
  bool ruler = true;           ///< from the surface to the chosen lesion
  bool thin_branches = false;  ///< vessels as they were segmented; else DrawableModel::tubes
  Look look = Look::focus;     ///< while nothing is looked at, it is drawn as tubes
  double window = 0.2;         ///< radius of the focus, share of the picture's height, in (0, 1]
  double opacity = 0.85;       ///< of a vessel at the liver's surface, in [0, 1]
  double fade_depth = 0.03;    ///< metres below the surface at which a vessel has lost most of its opacity
  /// @throws InputError
  void validate() const;
};

/// What the status line says beside the frame's own figures.
struct OverlayStatus {
  double age_seconds = 0.0;        ///< since the picture was taken; 0: not live, not shown
  double frames_per_second = 0.0;  ///< of the live view; 0: not shown
  bool model_unchecked = false;    ///< nobody has said that the model is right: said in the picture
  /// The picture is not of now (stopped, paused, looked at again): no word may say that it is valid.
  bool stands = false;
  bool landmarks_open = false;             ///< nobody has said of all of them whether they lie there
  bool landmarks_from_statistics = false;  ///< one that no image shows was accepted
  bool refused = false;                    ///< the registration: that is why there is no overlay
};

/// What a person looks at.
struct OverlayInterest {
  Label lesion = 0;  ///< the chosen one; 0: none
  /// Marked on the organ's surface as it is drawn (see place_at()); moves with its tissue.
  std::optional<guidance::SurfacePlace> place;
  std::optional<Eigen::Vector2d> pointer;  ///< pixel; the focus follows it, else the chosen lesion
};

/// The place of the organ's surface, as it is drawn, at a pixel of the left picture. None: beside the organ,
/// or the overlay is withdrawn.
std::optional<guidance::SurfacePlace> place_at(const DrawableModel& model, const Camera& camera,
                                               const OverlayFrame& overlay, const Eigen::Vector2d& pixel);

/// The same as the right camera has it: nodes and lesions in its frame, for a painter of its pictures.
OverlayFrame seen_from_right(OverlayFrame overlay, const StereoRig& rig);

/// Draws the deformed model into a frame of the laparoscope, through the camera's own matrix and lens.
/// - Vessels have their structures' colours and fade with depth below the liver's surface. Hepatic veins are
///   hatched, so that colour is not the only cue. Lesions have a contour; the liver's outline and anterior
///   margin are lines.
/// - A degraded frame shows the outline and the lesions' regions only, a withdrawn one nothing of the model;
///   both show the reason and a coloured border.
/// - A lesion has a verdict of its own. A degraded one is drawn as the region that holds it in 95 of 100
///   cases, one that is withdrawn or was not judged is not drawn; the reason is written.
/// Fine surfaces are bound to the mesh once, here. Needs no OpenGL. Not thread-safe. Text needs a
/// QGuiApplication (see HeadlessGui).
class OverlayPainter {
 public:
  /// @param model CT frame. @pre it has tetrahedra. @param camera as calibrated; overlays are in its frame.
  /// @throws InputError bad style.
  OverlayPainter(const PatientModel& model, const Camera& camera, const OverlayStyle& style = {});
  /// The same from what was made before, which may be shared. @param anterior_margin CT frame, metres; may be
  /// empty.
  OverlayPainter(std::shared_ptr<const DrawableModel> model, const Points& anterior_margin,
                 const Camera& camera, const OverlayStyle& style = {});
  ~OverlayPainter();

  void set_style(const OverlayStyle& style);
  const OverlayStyle& style() const;

  /// @param frame the camera's picture, distorted as it was taken. @throws InputError another size than the
  /// camera's. @pre a valid overlay has one node a node of the model.
  Picture paint(const Picture& frame, const OverlayFrame& overlay, const OverlayStatus& status = {},
                const OverlayInterest& interest = {});
  /// Of the lesion that was chosen in the last picture; empty: none, or it was not shown.
  const std::optional<guidance::LesionMeasures>& measures() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The sentence for a person behind a validity (translated): "too few points are tracked".
std::string validity_text(Validity validity);
/// What a person does about it (translated), whole sentences; empty for what is valid.
std::string remedy_text(Validity validity);
/// "nothing near it has been tracked for a while"
std::string lesion_reason_text(LesionReason reason);
/// What is told of a chosen lesion (translated): names and values. None of one that is withdrawn.
std::vector<std::pair<std::string, std::string>> lesion_numbers(const LesionVerdict& verdict,
                                                                const guidance::LesionMeasures& measures);

}  // namespace glisson::scene
