// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/patient_model.h"
#include "glisson/patient/picture.h"
#include "glisson/patient/registration.h"
#include "glisson/ui/scene/drawable_model.h"

namespace glisson::scene {

/// What of the model is drawn on the laparoscope's picture, and how strongly.
struct OverlayStyle {
  bool portal_vein = true, hepatic_veins = true, arteries = true, lesions = true;
  bool outline = true, anterior_margin = true;
  bool legend = true, status = true;
  double opacity = 0.85;     ///< of a vessel at the liver's surface, in [0, 1]
  double fade_depth = 0.03;  ///< metres below the surface at which a vessel has lost most of its opacity
  /// @throws InputError
  void validate() const;
};

/// What the status line says beside the frame's own figures.
struct OverlayStatus {
  double age_seconds = 0.0;        ///< since the picture was taken; 0: not live, not shown
  double frames_per_second = 0.0;  ///< of the live view; 0: not shown
  bool model_unchecked = false;    ///< nobody has said that the model is right: said in the picture
};

/// Draws the deformed model into a frame of the laparoscope: vessels in their structures' colours, fading
/// with depth below the liver's surface (hepatic veins hatched, so that colour is not the only cue), lesions
/// with a contour, the liver's outline and anterior margin, through the camera's own matrix and lens. Fine
/// surfaces are bound to the mesh once, here. A withdrawn frame is drawn without any overlay, a degraded one
/// with the outline and the lesions only, both with the reason and a coloured border. Needs no OpenGL. Not
/// thread-safe. Text needs a QGuiApplication (see HeadlessGui).
class OverlayPainter {
 public:
  /// @param model CT frame. @pre it has tetrahedra. @param camera the left one, as calibrated.
  /// @throws InputError bad style.
  OverlayPainter(const PatientModel& model, const Camera& camera, const OverlayStyle& style = {});
  /// The same from what was made before, which may be shared. @param anterior_margin CT frame, metres; may be
  /// empty.
  OverlayPainter(std::shared_ptr<const DrawableModel> model, const Points& anterior_margin,
                 const Camera& camera, const OverlayStyle& style = {});
  ~OverlayPainter();

  void set_style(const OverlayStyle& style);
  const OverlayStyle& style() const;

  /// @param frame the left picture, distorted as it was taken. @throws InputError another size than the
  /// camera's. @pre a valid overlay has one node a node of the model.
  Picture paint(const Picture& frame, const OverlayFrame& overlay, const OverlayStatus& status = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The sentence for a person behind a validity (translated): "too few points are tracked".
std::string validity_text(Validity validity);

}  // namespace glisson::scene
