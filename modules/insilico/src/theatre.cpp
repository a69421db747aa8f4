// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/theatre.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/random.h"
#include "glisson/geometry/topology.h"
#include "glisson/insilico/ray_caster.h"
#include "patch.h"
#include "theatre_anatomy.h"
#include "theatre_camera.h"
#include "theatre_motion.h"
#include "theatre_picture.h"
#include "theatre_tool.h"

namespace glisson::insilico {
namespace {

constexpr int kDrawnTriangles = 15000;  // at least: about 2 mm a side on a liver
constexpr int kNormalRings = 3;

PaintedSurface painted_wall(const TriangleMesh& wall) {
  PaintedSurface painted;
  painted.triangles = wall.triangles;
  painted.rest_mm = (1e3 * wall.vertices).cast<float>();
  painted.moved = wall.vertices.cast<float>();
  painted.normals = vertex_normals(wall).cast<float>();
  return painted;
}

}  // namespace

void TheatreOptions::validate() const {
  const OptionCheck check("theatre");
  check(width >= 64 && width <= 4096, "width", width, "give 64 to 4096 pixels");
  check(height >= 48 && height <= 4096, "height", height, "give 48 to 4096 pixels");
  check(frames_per_second > 0.0 && frames_per_second <= 240.0, "frames_per_second", frames_per_second,
        "give more than 0, up to 240");
  check(frames >= 1, "frames", frames, "give one frame or more");
  check(camera_distance_mm >= 80.0 && camera_distance_mm <= 160.0, "camera_distance_mm", camera_distance_mm,
        "give 80 to 160 mm");
  check(horizontal_view_deg >= 30.0 && horizontal_view_deg <= 90.0, "horizontal_view_deg",
        horizontal_view_deg, "give 30 to 90 degrees");
  check(baseline_mm >= 1.0 && baseline_mm <= 20.0, "baseline_mm", baseline_mm, "give 1 to 20 mm");
  check(pneumoperitoneum_pa >= 0.0 && pneumoperitoneum_pa <= 6000.0, "pneumoperitoneum_pa",
        pneumoperitoneum_pa, "give 0 (chosen) to 6000 Pa");
  check(mean_displacement_mm >= 20.0 && mean_displacement_mm <= 60.0, "mean_displacement_mm",
        mean_displacement_mm, "give 20 to 60 mm");
  check(elastic_motion_mm >= 1.0 && elastic_motion_mm <= 20.0, "elastic_motion_mm", elastic_motion_mm,
        "give 1 to 20 mm");
  check(breathing_mm >= 0.0 && breathing_mm <= 20.0, "breathing_mm", breathing_mm, "give 0 to 20 mm");
  check(heartbeat_mm >= 0.0 && heartbeat_mm <= 5.0, "heartbeat_mm", heartbeat_mm, "give 0 to 5 mm");
  check(breathing_period_s >= 1.0, "breathing_period_s", breathing_period_s, "give 1 s or more");
  check(heartbeat_period_s >= 0.3, "heartbeat_period_s", heartbeat_period_s, "give 0.3 s or more");
  check(noise >= 0.0 && noise <= 50.0, "noise", noise, "give 0 to 50 grey levels");
  check(truth_vertices >= 200 && truth_vertices <= 20000, "truth_vertices", truth_vertices,
        "give 200 to 20000");
  check(young_modulus_pa >= 500.0 && young_modulus_pa <= 1e5, "young_modulus_pa", young_modulus_pa,
        "give 500 to 100000 Pa");
}

ScopePath ScopePath::in_a_hand() { return {.pivot_deg = 6.0, .slide_mm = 30.0, .roll_deg = 10.0}; }

ScopePath ScopePath::in_a_fast_hand() {
  return {.pivot_deg = 4.0, .roll_deg = 15.5, .period_s = 2.0, .zoom_mm = 60.0, .ease_s = 0.5};
}

void ScopePath::validate() const {
  const OptionCheck check("scope path");
  check(pivot_deg >= 0.0 && pivot_deg <= 30.0, "pivot_deg", pivot_deg, "give 0 to 30 degrees");
  check(slide_mm >= 0.0 && slide_mm <= 120.0, "slide_mm", slide_mm, "give 0 to 120 mm");
  check(roll_deg >= 0.0 && roll_deg <= 90.0, "roll_deg", roll_deg, "give 0 to 90 degrees");
  check(zoom_mm >= 0.0 && zoom_mm <= 80.0, "zoom_mm", zoom_mm, "give 0 to 80 mm");
  check(zoom_period_s >= 0.5 && zoom_period_s <= 60.0, "zoom_period_s", zoom_period_s, "give 0.5 to 60 s");
  check(ease_s >= 0.0 && ease_s <= 5.0, "ease_s", ease_s, "give 0 to 5 s");
  check(period_s >= 0.5 && period_s <= 60.0, "period_s", period_s, "give 0.5 to 60 s");
  check(trocar_mm >= 50.0 && trocar_mm <= 300.0, "trocar_mm", trocar_mm, "give 50 to 300 mm");
}

struct Theatre::Impl {
  TheatreOptions options;
  TetMesh mesh;
  TriangleMesh liver;
  Binding liver_binding, target_binding;
  std::vector<std::vector<int>> neighbours;
  Landmarks landmarks;
  std::vector<Target> targets;
  TheatreMotion motion;
  StereoRig rig;
  CameraFromCt camera_from_ct;
  ScopePath path;
  TriangleMesh behind;              ///< as in frame 0
  std::vector<VesselTree> vessels;  ///< the patient's
  struct Tool {
    ToolUse use;
    ToolPull pull;
    Binding touched;  ///< of one point
    Eigen::Vector3d port;
    TriangleMesh shaft;
  };
  std::optional<Tool> tool;

  // The stage: one frame at a time stands on it.
  mutable std::mutex mutex;
  mutable std::unique_ptr<RayCaster> caster;
  mutable PaintedScene painted;
  mutable TriangleMesh surface;
  mutable int frame = -1;
  mutable bool wall_is_moved = false;  ///< it stands as a scope that moved has put it
  std::unique_ptr<Painter> painter;

  Points nodes(int number) const {
    require(number >= 0 && number < options.frames, "the theatre has this frame");
    const double seconds = number / options.frames_per_second;
    Points there = motion.positions(seconds);
    if (tool) there += tool->pull.at(tool_moment(tool->use, seconds).share);
    return (scope_motion(path, seconds) * camera_from_ct).apply(there);
  }
  bool moves() const {
    return path.pivot_deg > 0.0 || path.slide_mm > 0.0 || path.roll_deg > 0.0 || path.zoom_mm > 0.0;
  }
  Eigen::Vector3d touches(const Points& nodes_in_camera) const {
    return tool->touched.apply(mesh, nodes_in_camera).row(0).transpose();
  }
  /// @pre the mutex is held.
  void stage_wall(int number) const {
    const auto motion_of_scope = scope_motion(path, number / options.frames_per_second);
    const TriangleMesh now{motion_of_scope.apply(behind.vertices), behind.triangles};
    const FloatPoints rest = painted.wall.rest_mm;
    painted.wall = painted_wall(now);
    painted.wall.rest_mm = rest;
    caster->set_wall(now);
    wall_is_moved = moves();
  }
  /// @pre the mutex is held.
  void stage_tool(int number, const Points& nodes_in_camera) const {
    const double seconds = number / options.frames_per_second;
    TriangleMesh now;
    if (tool)
      now = placed_tool(tool->shaft, (scope_motion(path, seconds) * Point<CameraFrame>(tool->port)).xyz,
                        touches(nodes_in_camera), tool_moment(tool->use, seconds).out);
    if (now.triangle_count() > 0 || painted.tool.triangles.rows() > 0) caster->set_tool(now);
    painted.tool = now.triangle_count() > 0 ? painted_wall(now) : PaintedSurface();
  }
  /// What lies before the lesion in the middle of the picture, somewhat beside it: triangle of the fine
  /// surface and weights. @pre the mutex is held.
  RayHit place_to_touch(const ToolUse& use) const;
  /// @pre the mutex is held.
  void stage(int number) const {
    if (number == frame) return;
    const Points there = nodes(number);
    surface.vertices = liver_binding.apply(mesh, there);
    if (!caster) caster = std::make_unique<RayCaster>(surface);
    caster->move_organ(surface.vertices);
    painted.liver.moved = surface.vertices.cast<float>();
    painted.liver.normals = shading_normals(surface, neighbours, kNormalRings).cast<float>();
    painted.liver.camera_from_rest =
        fit_rigid<CameraFrame, CtFrame>(liver.vertices, surface.vertices).rotation.cast<float>();
    if (moves() || wall_is_moved) stage_wall(number);
    stage_tool(number, there);
    frame = number;
  }
  void set_stage();
};

void Theatre::Impl::set_stage() {
  neighbours = vertex_neighbours(liver);
  painted.liver.triangles = liver.triangles;
  painted.liver.rest_mm = (1e3 * liver.vertices).cast<float>();
  surface.triangles = liver.triangles;
  painter = std::make_unique<Painter>(rig, options.seed, options.noise, 1e-3 * options.camera_distance_mm);
  stage(0);
  behind = make_wall(surface, rig, options.seed);
  painted.wall = painted_wall(behind);
  caster->set_wall(behind);
  painter->expose(*caster, painted);
}

RayHit Theatre::Impl::place_to_touch(const ToolUse& use) const {
  constexpr double kAside = 12e-3;
  std::mt19937_64 random(use.seed * 69621 + 3);
  const Points lesions = target_binding.apply(mesh, nodes(0));
  Eigen::Vector3d goal(0.0, 0.0, 1e-3 * options.camera_distance_mm);
  Eigen::Index nearest = 0;
  if (lesions.rows() > 0) {
    (lesions.leftCols<2>().rowwise().norm().array() / lesions.col(2).array()).minCoeff(&nearest);
    goal = lesions.row(nearest).transpose();
  }
  for (double reach = 1.0; reach > 0.0; reach -= 0.05) {
    const double angle = 2.0 * std::numbers::pi * uniform01(random), far = kAside * uniform01(random);
    const Eigen::Vector3d at = reach * (goal + far * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0)) +
                               (1.0 - reach) * Eigen::Vector3d(0.0, 0.0, goal.z());
    if (!rig.left.shows(at)) continue;
    const RayHit hit = caster->cast(Eigen::Vector3f::Zero(), at.cast<float>());
    if (hit.thing == RayHit::Thing::organ) return hit;
  }
  throw NumericalError("the theatre's tool finds no liver before the laparoscope");
}

Theatre::Theatre(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Theatre::~Theatre() = default;

Cancellable<std::unique_ptr<Theatre>> Theatre::build(const PatientModel& patient,
                                                     const TheatreOptions& options,
                                                     const RunContext& context) {
  options.validate();
  auto impl = std::make_unique<Impl>();
  impl->options = options;
  impl->vessels = patient.vessels;
  const TriangleMesh closed = liver_of(patient);
  auto mesh = truth_mesh(closed, options.truth_vertices, context.part(0.0, 0.15));
  if (!mesh) return std::nullopt;
  impl->mesh = std::move(*mesh);
  label_lesions(impl->mesh, patient.surfaces);
  impl->liver = refine_for_drawing(closed, kDrawnTriangles);
  impl->landmarks = complete_landmarks(patient.landmarks, closed);

  auto motion =
      TheatreMotion::solve(impl->mesh, patient.vessels, impl->landmarks, options, context.part(0.15, 0.9));
  if (!motion) return std::nullopt;
  impl->motion = std::move(*motion);
  context.progress(0.9, "theatre.camera");
  impl->liver_binding = bind_points(impl->mesh, impl->liver.vertices, false);
  for (const auto& [structure, centre] : lesion_centres(patient))
    impl->targets.push_back({structure, centre});
  Points centres(static_cast<Eigen::Index>(impl->targets.size()), 3);
  for (std::size_t i = 0; i < impl->targets.size(); ++i)
    centres.row(static_cast<Eigen::Index>(i)) = impl->targets[i].centre_in_ct.transpose();
  impl->target_binding = bind_points(impl->mesh, centres, false);

  const Points first = impl->motion.positions(0.0);
  const auto carried = [&](const Points& points) {
    return bind_points(impl->mesh, points, false).apply(impl->mesh, first);
  };
  impl->rig = make_rig(options);
  const TriangleMesh lying{impl->liver_binding.apply(impl->mesh, first), impl->liver.triangles};
  impl->camera_from_ct = place_camera(lying, carried(impl->landmarks.anterior_margin),
                                      carried(impl->landmarks.umbilical_notch), impl->rig, options);
  if (context.cancelled()) return std::nullopt;
  impl->set_stage();
  context.progress(1.0, "theatre.ready");
  return std::unique_ptr<Theatre>(new Theatre(std::move(impl)));
}

const TheatreOptions& Theatre::options() const { return impl_->options; }
const TheatreFigures& Theatre::figures() const { return impl_->motion.figures(); }
const StereoRig& Theatre::rig() const { return impl_->rig; }
const CameraFromCt& Theatre::camera_from_ct() const { return impl_->camera_from_ct; }
const TetMesh& Theatre::mesh() const { return impl_->mesh; }
const Landmarks& Theatre::landmarks() const { return impl_->landmarks; }
const std::vector<Target>& Theatre::targets() const { return impl_->targets; }
int Theatre::frame_count() const { return impl_->options.frames; }
double Theatre::seconds(int frame) const { return frame / impl_->options.frames_per_second; }

void Theatre::move_scope(const ScopePath& path) {
  path.validate();
  const std::lock_guard lock(impl_->mutex);
  impl_->path = path;
  impl_->frame = -1;
}

bool Theatre::use_tool(const ToolUse& use, const RunContext& context) {
  use.validate();
  const std::lock_guard lock(impl_->mutex);
  impl_->frame = -1;
  if (use.way_mm == 0.0) {
    impl_->tool.reset();
    return true;
  }
  const auto former = std::exchange(impl_->tool, std::nullopt);
  const ScopePath path = std::exchange(impl_->path, ScopePath());
  Impl::Tool tool;
  tool.use = use;
  try {
    impl_->stage(0);
    const RayHit hit = impl_->place_to_touch(use);
    Points touched = Points::Zero(1, 3);
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const int v = impl_->liver.triangles(hit.triangle, k);
      touched.row(0) += static_cast<double>(hit.barycentric[k]) * impl_->liver.vertices.row(v);
      outward += static_cast<double>(hit.barycentric[k]) *
                 impl_->painted.liver.normals.row(v).transpose().cast<double>();
    }
    const Eigen::Vector3d way = 1e-3 * use.way_mm * outward.normalized();
    tool.touched = bind_points(impl_->mesh, touched, false);
    tool.port = tool_port(use);
    tool.shaft = tool_shaft();
    auto pull = impl_->motion.pull(
        impl_->mesh, impl_->vessels, impl_->landmarks, impl_->options, touched.row(0).transpose(),
        impl_->camera_from_ct.rotation.transpose() * way, 1e-3 * use.tip_mm, context);
    impl_->tool = former;
    if (pull) {
      tool.pull = std::move(*pull);
      impl_->tool = std::move(tool);
    }
    impl_->path = path;
    impl_->frame = -1;
    return pull.has_value();
  } catch (...) {
    impl_->tool = former;
    impl_->path = path;
    impl_->frame = -1;
    throw;
  }
}

std::optional<Eigen::Vector3d> Theatre::tool_touches(int frame) const {
  if (!impl_->tool) return std::nullopt;
  return impl_->touches(impl_->nodes(frame));
}

double Theatre::tool_force_n() const { return impl_->tool ? impl_->tool->pull.force_n : 0.0; }

FrameTruth Theatre::truth(int frame) const {
  FrameTruth truth;
  truth.nodes_in_camera = impl_->nodes(frame);
  truth.targets_in_camera = impl_->target_binding.apply(impl_->mesh, truth.nodes_in_camera);
  return truth;
}

StereoFrame Theatre::render(int frame) const {
  const std::lock_guard lock(impl_->mutex);
  impl_->stage(frame);
  StereoFrame pictures;
  pictures.index = frame;
  pictures.seconds = seconds(frame);
  pictures.left = impl_->painter->picture(Painter::Eye::left, frame, *impl_->caster, impl_->painted);
  pictures.right = impl_->painter->picture(Painter::Eye::right, frame, *impl_->caster, impl_->painted);
  return pictures;
}

std::vector<float> Theatre::depth(int frame) const {
  const std::lock_guard lock(impl_->mutex);
  impl_->stage(frame);
  return impl_->caster->organ_depth(impl_->painter->rays(Painter::Eye::left));
}

Points Theatre::carry(const Points& points_in_ct, int frame) const {
  return bind_points(impl_->mesh, points_in_ct, false).apply(impl_->mesh, impl_->nodes(frame));
}

TriangleMesh Theatre::surface(int frame) const {
  return {impl_->liver_binding.apply(impl_->mesh, impl_->nodes(frame)), impl_->liver.triangles};
}

std::vector<bool> Theatre::seen(const Points& points_in_camera, int frame) const {
  const std::lock_guard lock(impl_->mutex);
  impl_->stage(frame);
  std::vector<bool> seen;
  for (Eigen::Index i = 0; i < points_in_camera.rows(); ++i) {
    const Eigen::Vector3d p = points_in_camera.row(i).transpose();
    seen.push_back(impl_->rig.left.shows(p) && impl_->caster->sees(Eigen::Vector3d::Zero(), p, 2e-3));
  }
  return seen;
}

double Theatre::visible_share(int frame) const {
  const std::lock_guard lock(impl_->mutex);
  impl_->stage(frame);
  const TriangleMesh& surface = impl_->surface;
  const StereoRig& rig = impl_->rig;
  const Points normals = triangle_normals(surface);
  const Eigen::VectorXd areas = triangle_areas(surface);
  const Eigen::Vector3d left_eye = Eigen::Vector3d::Zero(),
                        right_eye = rig.right_from_left.inverse().translation;
  const auto sees = [&](const Camera& camera, const Eigen::Vector3d& eye, const Eigen::Vector3d& in_camera,
                        const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
    return n.dot(eye - p) > 0.0 && camera.shows(in_camera) && impl_->caster->sees(eye, p);
  };
  double seen = 0.0;
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const Eigen::Vector3d p =
        (surface.vertex(surface.triangles(t, 0)) + surface.vertex(surface.triangles(t, 1)) +
         surface.vertex(surface.triangles(t, 2))) /
        3.0;
    const Eigen::Vector3d n = normals.row(t).transpose();
    const Eigen::Vector3d in_right = rig.right_from_left.rotation * p + rig.right_from_left.translation;
    if (sees(rig.left, left_eye, p, p, n) && sees(rig.right, right_eye, in_right, p, n)) seen += areas[t];
  }
  return seen / areas.sum();
}

Patch Theatre::patch(int frame, const PatchOptions& options) const {
  options.validate();
  const Points margin = carry(impl_->landmarks.anterior_margin, frame);
  const Points notch = carry(impl_->landmarks.umbilical_notch, frame);
  const std::lock_guard lock(impl_->mutex);
  impl_->stage(frame);
  // From between the notch and what the camera looks at, so that margin, notch and face are in it.
  const RayHit hit = impl_->caster->cast(Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ());
  Eigen::Vector3d start(0.0, 0.0,
                        hit.thing == RayHit::Thing::organ ? static_cast<double>(hit.parameter)
                                                          : 1e-3 * impl_->options.camera_distance_mm);
  if (notch.rows() > 0) start = 0.5 * (start + Eigen::Vector3d(notch.colwise().mean().transpose()));
  return sample_patch(impl_->surface, *impl_->caster, start, margin, notch, options);
}

LabelledCloud Theatre::patch(int frame, double share, double density_per_cm2, double noise_mm,
                             std::uint64_t seed) const {
  PatchOptions options;
  options.share = share;
  options.density_per_cm2 = density_per_cm2;
  options.noise_mm = noise_mm;
  options.seed = seed;
  return patch(frame, options).cloud;
}

}  // namespace glisson::insilico
