// SPDX-License-Identifier: GPL-3.0-or-later
// How long it takes to draw the live overlay at 960x540 and 1920x1080, against a plain VTK scene of the same
// meshes drawn in the same run (by Mesa where there is no GPU). The synthetic patient, breathing before the
// camera; of each look the best and the median of the frames' time, and the median of the processor's, which
// a busy machine leaves as it is.
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "canvas.h"
#include "glisson/core/statistics.h"
#include "glisson/insilico/patient.h"
#include "glisson/model/build.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/model_surfaces.h"
#include "glisson/ui/scene/offscreen_renderer.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "glisson/ui/scene/surface_shapes.h"
#include "overlay_blend.h"
#include "overlay_layers.h"

namespace {

using namespace glisson;
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

Camera laparoscope(int times = 1) {
  Camera camera;
  camera.width = 960 * times;
  camera.height = 540 * times;
  camera.matrix << 685.0 * times, 0.0, 480.0 * times, 0.0, 685.0 * times, 270.0 * times, 0.0, 0.0, 1.0;
  camera.distortion << -0.1, 0.02, 0.0, 0.0, 0.0;
  return camera;
}

PatientModel patient_model() {
  insilico::PatientOptions options;
  options.spacing_mm = {2.5, 2.5, 2.5};
  options.surface_spacing_mm = 2.0;
  auto patient = insilico::make_patient(options, RunContext());
  return model::build_from_labels(patient->truth, {}, RunContext())->model;
}

/// From the front, 120 mm before the liver's nearest point; it breathes up and down.
Points nodes_at(const PatientModel& model, int frame) {
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  Points nodes = model.mesh.vertices * turn.transpose();
  const Eigen::RowVector3d middle = nodes.colwise().mean();
  nodes.rowwise() -= Eigen::RowVector3d(middle.x(), middle.y(), nodes.col(2).minCoeff() - 0.12);
  nodes.col(1).array() += 3e-3 * std::sin(0.05 * frame);
  return nodes;
}

Picture tissue(const Camera& camera) {
  auto bytes =
      std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(3 * camera.width * camera.height));
  for (std::size_t i = 0; i < bytes->size(); ++i)
    (*bytes)[i] = static_cast<std::uint8_t>(90 + (i * 2654435761U >> 27U));
  return {camera.width, camera.height, 3, bytes};
}

std::vector<LesionVerdict> verdicts(const PatientModel& model, const Points& nodes) {
  std::vector<LesionVerdict> all;
  for (const Label label : scene::inner_structures(model)) {
    if (!is_lesion(label)) continue;
    LesionVerdict verdict;
    verdict.lesion = label;
    verdict.level = Level::valid;
    verdict.reason = LesionReason::known;
    verdict.centre = nodes.colwise().mean().transpose();
    verdict.radius = 0.01;
    all.push_back(verdict);
  }
  return all;
}

/// A scene of the same meshes as plain as VTK has it: the liver translucent, the rest opaque.
class PlainScene {
 public:
  PlainScene(const scene::DrawableModel& model, const Camera& camera)
      : model_(model), offscreen_(camera.width, camera.height) {
    for (const scene::DrawableSurface* drawn : scene::drawn_surfaces(model, false)) {
      const scene::DrawableSurface& surface = *drawn;
      if (surface.inside.triangles.rows() == 0) continue;
      TriangleMesh mesh = surface.mesh;
      mesh.triangles = surface.inside.triangles;
      auto shape = scene::make_poly_data(mesh);
      scene::add_normals(*shape);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(shape);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      const auto colour = structure_colour(surface.structure);
      actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
      if (surface.structure == structure::kParenchyma) actor->GetProperty()->SetOpacity(0.3);
      renderer_->AddActor(actor);
      shapes_.push_back({&surface, shape});
    }
    vtkCamera& view = *renderer_->GetActiveCamera();
    view.SetPosition(0.0, 0.0, 0.0);
    view.SetFocalPoint(0.0, 0.0, 1.0);
    view.SetViewUp(0.0, -1.0, 0.0);
    view.SetViewAngle(2.0 * std::atan(0.5 * camera.height / camera.matrix(1, 1)) * 180.0 / M_PI);
    view.SetClippingRange(0.01, 1.0);
  }
  Picture draw(const Points& nodes) {
    for (const auto& [surface, shape] : shapes_)
      scene::move_vertices(*shape, surface->binding.apply(model_.model->mesh, nodes));
    return offscreen_.render(*renderer_);
  }

 private:
  const scene::DrawableModel& model_;
  scene::OffscreenRenderer offscreen_;
  vtkNew<vtkRenderer> renderer_;
  std::vector<std::pair<const scene::DrawableSurface*, vtkSmartPointer<vtkPolyData>>> shapes_;
};

/// A step's times, milliseconds.
struct Times {
  std::vector<double> wall, processor;  ///< of all threads
  double best() const { return *std::min_element(wall.begin(), wall.end()); }
};

template <class Step>
Times timed(int frames, const Step& step) {
  Times times;
  for (int k = 0; k < frames; ++k) {
    const auto begin = Clock::now();
    const std::clock_t processor = std::clock();
    step(k);
    if (k < 3) continue;  // buffers and caches are made at first
    times.wall.push_back(milliseconds_since(begin));
    times.processor.push_back(1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
  }
  return times;
}

void say(const char* name, const Times& times, const Times& plain) {
  const double processor = upper_median(times.processor);
  std::printf("| %s | %.1f | %.1f | %.1f | %.2f |\n", name, times.best(), upper_median(times.wall), processor,
              processor / upper_median(plain.processor));
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  const int frames = quick ? 12 : 60;
  const scene::HeadlessGui gui;
  const Camera camera = laparoscope();
  const auto drawable = scene::make_drawable(std::make_shared<const PatientModel>(patient_model()));
  const PatientModel& model = *drawable->model;
  int triangles = 0;
  for (const scene::DrawableSurface* surface : scene::drawn_surfaces(*drawable, false))
    triangles += static_cast<int>(surface->inside.triangles.rows());
  const Picture frame = tissue(camera);
  std::vector<Points> nodes;
  for (int k = 0; k < frames; ++k) nodes.push_back(nodes_at(model, k));
  const auto overlay_of = [&](int k) {
    OverlayFrame overlay;
    overlay.index = k;
    overlay.validity = Validity::valid;
    overlay.nodes_in_camera = nodes[static_cast<std::size_t>(k)];
    overlay.lesions = verdicts(model, overlay.nodes_in_camera);
    return overlay;
  };
  PlainScene plain_scene(*drawable, camera);
  const Times plain = timed(frames, [&](int k) { plain_scene.draw(nodes[static_cast<std::size_t>(k)]); });
  std::printf("%d triangles\n| | best, ms | median, ms | processor, ms | over VTK |\n|---|---|---|---|---|\n",
              triangles);
  say("plain VTK scene", plain, plain);
  scene::OverlayInterest interest;
  interest.pointer = Eigen::Vector2d(480.0, 270.0);
  for (const scene::Look look : scene::kLooks) {
    scene::OverlayStyle style;
    style.look = look;
    scene::OverlayPainter painter(drawable, model.landmarks.anterior_margin, camera, style);
    say(scene::look_code(look),
        timed(frames, [&](int k) { painter.paint(frame, overlay_of(k), {}, interest); }), plain);
  }
  {
    scene::OverlayPainter painter(drawable, model.landmarks.anterior_margin, camera);
    scene::OverlayInterest chosen;
    const OverlayFrame first = overlay_of(0);
    if (!first.lesions.empty()) chosen.lesion = first.lesions.front().lesion;
    say("focus, numbers of a lesion",
        timed(frames, [&](int k) { painter.paint(frame, overlay_of(k), {}, chosen); }), plain);
  }
  {
    const Camera large = laparoscope(2);
    PlainScene large_scene(*drawable, large);
    const Times plain_large =
        timed(frames, [&](int k) { large_scene.draw(nodes[static_cast<std::size_t>(k)]); });
    say("plain VTK scene, 1920x1080", plain_large, plain_large);
    scene::OverlayPainter painter(drawable, model.landmarks.anterior_margin, large);
    scene::OverlayInterest centre;
    centre.pointer = Eigen::Vector2d(960.0, 540.0);
    const Picture picture = tissue(large);
    say("focus, 1920x1080", timed(frames, [&](int k) { painter.paint(picture, overlay_of(k), {}, centre); }),
        plain_large);
  }
  // Where the time of the default goes.
  const scene::OverlayStyle style;
  const scene::SurfaceRaster raster(camera);
  scene::OverlayLayers layers(camera);
  std::vector<Label> lesions;
  for (const LesionVerdict& verdict : verdicts(model, nodes[0])) lesions.push_back(verdict.lesion);
  say("focus: meshes to layers",
      timed(frames,
            [&](int k) {
              scene::draw_layers(*drawable, nodes[static_cast<std::size_t>(k)], raster, style, lesions,
                                 layers);
            }),
      plain);
  say("focus: layers over the picture",
      timed(frames,
            [&](int) {
              scene::Canvas canvas = scene::canvas_of(frame);
              scene::blend_layers(canvas, layers, style, interest.pointer);
            }),
      plain);
  return 0;
}
