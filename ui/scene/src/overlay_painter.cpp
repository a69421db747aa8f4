// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/overlay_painter.h"

#include <algorithm>
#include <chrono>

#include "canvas.h"
#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/model_surfaces.h"
#include "lesion_marks.h"
#include "overlay_annotations.h"
#include "overlay_blend.h"
#include "overlay_layers.h"

namespace glisson::scene {

void OverlayStyle::validate() const {
  if (!(opacity >= 0.0 && opacity <= 1.0))
    throw InputError("overlay style", "opacity", "is " + std::to_string(opacity),
                     "Give a number from 0 to 1.");
  if (!(fade_depth > 0.0))
    throw InputError("overlay style", "fade_depth", "is " + std::to_string(fade_depth) + " m",
                     "Give a depth above 0.");
  if (!(window > 0.0 && window <= 1.0))
    throw InputError("overlay style", "window", "is " + std::to_string(window),
                     "Give a share of the picture's height, above 0 and up to 1.");
}

const char* look_code(Look look) {
  switch (look) {
    case Look::tubes:
      return "tubes";
    case Look::focus:
      return "focus";
    case Look::contours:
      return "contours";
    case Look::outlines:
      return "outlines";
  }
  return "unknown";
}

namespace {

/// Of the surfaces that are drawn.
guidance::LesionMeter meter_of(const DrawableModel& model, bool with_lesions) {
  guidance::CarriedSurface organ;
  std::vector<guidance::CarriedSurface> lesions;
  for (const DrawableSurface& surface : model.surfaces) {
    const bool is_organ = surface.structure == structure::kParenchyma;
    if (!is_organ && !(with_lesions && is_lesion(surface.structure))) continue;
    guidance::CarriedSurface carried{surface.structure, surface.mesh, surface.binding};
    if (is_organ)
      organ = std::move(carried);
    else
      lesions.push_back(std::move(carried));
  }
  return {*model.model, std::move(organ), std::move(lesions)};
}

}  // namespace

std::optional<guidance::SurfacePlace> place_at(const DrawableModel& model, const Camera& camera,
                                               const OverlayFrame& overlay, const Eigen::Vector2d& pixel) {
  if (overlay.level() == Level::withdrawn ||
      overlay.nodes_in_camera.rows() != model.model->mesh.vertex_count())
    return {};
  const auto ray = camera.mapped_ray(pixel);
  if (!ray) return {};
  guidance::LesionMeter meter = meter_of(model, false);
  meter.move(overlay.nodes_in_camera);
  return meter.place_on(*ray);
}

OverlayFrame seen_from_right(OverlayFrame overlay, const StereoRig& rig) {
  const auto& [turn, shift] = rig.right_from_left;
  overlay.nodes_in_camera =
      ((overlay.nodes_in_camera * turn.transpose()).rowwise() + shift.transpose()).eval();
  for (LesionVerdict& lesion : overlay.lesions) {
    lesion.centre = turn * lesion.centre + shift;
    lesion.covariance = turn * lesion.covariance * turn.transpose();
  }
  return overlay;
}

struct OverlayPainter::Impl {
  Impl(std::shared_ptr<const DrawableModel> surfaces, const Points& anterior_margin, const Camera& view,
       const OverlayStyle& look)
      : camera(view),
        style(look),
        drawn_by(reduced(view, reduction_of(view.width))),
        raster(drawn_by),
        drawable(std::move(surfaces)),
        model(drawable->model),
        structures(inner_structures(*model)),
        layers(drawn_by) {
    if (anterior_margin.rows() > 0) margin = bind_points(model->mesh, anterior_margin);
  }

  Camera camera;
  OverlayStyle style;
  Camera drawn_by;  ///< the camera at the size at which the layers are made
  SurfaceRaster raster;
  std::shared_ptr<const DrawableModel> drawable;
  std::shared_ptr<const PatientModel> model;
  std::vector<Label> structures;
  Binding margin;
  OverlayLayers layers;                        ///< of the last picture; their memory serves the next
  std::optional<guidance::LesionMeter> meter;  ///< made when a lesion is chosen
  std::optional<guidance::LesionMeasures> measures;

  bool shown(Label label) const {
    if (label == structure::kPortalVein) return style.portal_vein;
    if (label == structure::kHepaticVeins) return style.hepatic_veins;
    if (label == structure::kArtery) return style.arteries;
    return style.lesions;
  }
  std::vector<LesionVerdict> verdicts(const OverlayFrame& overlay) const {
    std::vector<Label> lesions;
    for (const Label label : structures)
      if (is_lesion(label) && style.lesions) lesions.push_back(label);
    return verdicts_of(lesions, overlay);
  }
  /// What is looked at, on the picture.
  std::optional<Eigen::Vector2d> focus(const std::vector<LesionVerdict>& verdicts,
                                       const OverlayInterest& interest) const {
    if (interest.pointer) return interest.pointer;
    for (const LesionVerdict& verdict : verdicts)
      if (verdict.lesion == interest.lesion && verdict.level == Level::valid &&
          SurfaceRaster::is_mapped(camera, verdict.centre))
        return camera.project(verdict.centre);
    return {};
  }
  /// Of the chosen lesion. Of one that is not shown nothing is measured.
  std::optional<LesionCard> card(const Points& nodes, const std::vector<LesionVerdict>& verdicts,
                                 const OverlayInterest& interest) {
    measures.reset();
    const auto chosen = std::find_if(verdicts.begin(), verdicts.end(),
                                     [&](const LesionVerdict& one) { return one.lesion == interest.lesion; });
    if (chosen == verdicts.end()) return {};
    LesionCard card;
    card.verdict = *chosen;
    card.measures.lesion = chosen->lesion;
    if (chosen->level == Level::withdrawn) return card;
    if (!meter) meter = meter_of(*drawable, true);
    meter->move(nodes);
    card.measures = meter->measure(chosen->lesion, interest.place);
    measures = card.measures;
    if (!interest.place || !meter->has(*interest.place)) return card;
    const Eigen::Vector3d place = meter->position(*interest.place);
    if (SurfaceRaster::is_mapped(camera, place)) card.place = camera.project(place);
    return card;
  }
  Annotations annotations(const Points& nodes, std::vector<LesionVerdict> lesions,
                          const OverlayInterest& interest) {
    Annotations result;
    for (const Label label : structures)
      if (shown(label)) result.structures.push_back(label);
    for (const LesionVerdict& verdict : lesions)
      result.regions.push_back(verdict.level == Level::degraded ? region_of(verdict, camera) : QPolygonF());
    result.card = card(nodes, lesions, interest);
    result.camera = camera;
    result.lesions = std::move(lesions);
    if (margin.weights.rows() == 0) return result;
    const Points line = margin.apply(model->mesh, nodes);
    bool goes_on = false;
    for (Eigen::Index i = 0; i < line.rows(); ++i) {
      const Eigen::Vector3d p = line.row(i).transpose();
      const bool is_here = SurfaceRaster::is_mapped(camera, p);
      if (is_here && !goes_on) result.margin.emplace_back();
      if (is_here) result.margin.back().push_back(camera.project(p));
      goes_on = is_here;
    }
    return result;
  }
};

namespace {

/// What is drawn of the organ while less is known: where it is.
OverlayStyle outline_only(OverlayStyle style) {
  style.portal_vein = style.hepatic_veins = style.arteries = style.anterior_margin = false;
  style.outline = style.bold_outline = true;
  return style;
}

/// What of a proposed place is laid beside what is seen: outline and margin, which the picture shows, too.
OverlayStyle proposal_only(OverlayStyle style) {
  style = outline_only(style);
  style.anterior_margin = true;
  style.lesions = style.legend = false;
  return style;
}

/// How an overlay is drawn that is not withdrawn.
OverlayStyle style_of(const OverlayFrame& overlay, const OverlayStyle& wanted) {
  if (overlay.validity == Validity::proposed) return proposal_only(wanted);
  return overlay.level() == Level::degraded ? outline_only(wanted) : wanted;
}

}  // namespace

OverlayPainter::OverlayPainter(const PatientModel& model, const Camera& camera, const OverlayStyle& style) {
  style.validate();
  require(model.mesh.tetrahedron_count() > 0, "an overlay follows a model that has a mesh");
  impl_ = std::make_unique<Impl>(make_drawable(std::make_shared<const PatientModel>(model)),
                                 model.landmarks.anterior_margin, camera, style);
}
OverlayPainter::OverlayPainter(std::shared_ptr<const DrawableModel> model, const Points& anterior_margin,
                               const Camera& camera, const OverlayStyle& style) {
  style.validate();
  require(model != nullptr && model->model->mesh.tetrahedron_count() > 0,
          "an overlay follows a model that has a mesh");
  impl_ = std::make_unique<Impl>(model, anterior_margin, camera, style);
}
OverlayPainter::~OverlayPainter() = default;

void OverlayPainter::set_style(const OverlayStyle& style) {
  style.validate();
  impl_->style = style;
}
const OverlayStyle& OverlayPainter::style() const { return impl_->style; }

const std::optional<guidance::LesionMeasures>& OverlayPainter::measures() const { return impl_->measures; }

Picture OverlayPainter::paint(const Picture& frame, const OverlayFrame& overlay, const OverlayStatus& status,
                              const OverlayInterest& interest) {
  const Camera& camera = impl_->camera;
  if (frame.empty() || frame.width != camera.width || frame.height != camera.height)
    throw InputError("frame", "size",
                     "is " + std::to_string(frame.width) + " x " + std::to_string(frame.height) +
                         " and the calibration's is " + std::to_string(camera.width) + " x " +
                         std::to_string(camera.height),
                     "Use the calibration that belongs to this laparoscope.");
  impl_->measures.reset();
  Canvas canvas = canvas_of(frame);
  if (overlay.level() == Level::withdrawn) {
    annotate(canvas, overlay, {}, impl_->style, status);
    return picture_of(std::move(canvas));
  }
  const OverlayStyle style = style_of(overlay, impl_->style);
  const auto begin = std::chrono::steady_clock::now();
  std::vector<LesionVerdict> verdicts =
      style.lesions ? impl_->verdicts(overlay) : std::vector<LesionVerdict>();
  std::vector<Label> bodies;
  for (const LesionVerdict& verdict : verdicts)
    if (verdict.level == Level::valid) bodies.push_back(verdict.lesion);
  OverlayLayers& layers = impl_->layers;
  draw_layers(*impl_->drawable, overlay.nodes_in_camera, impl_->raster, style, bodies, layers);
  // An empty window would say that there is nothing.
  const auto focus = overlay.level() == Level::valid ? impl_->focus(verdicts, interest) : std::nullopt;
  blend_layers(canvas, layers, style, focus);
  OverlayStatus now = status;
  if (status.age_seconds > 0.0)  // a live picture grows older while it is drawn
    now.age_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  annotate(canvas, overlay, impl_->annotations(overlay.nodes_in_camera, std::move(verdicts), interest), style,
           now);
  return picture_of(std::move(canvas));
}

}  // namespace glisson::scene
