// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/handled_liver.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "glisson/geometry/rigid.h"
#include "glisson/geometry/topology.h"
#include "glisson/insilico/ray_caster.h"
#include "handled_loads.h"
#include "operator_hand.h"
#include "patch.h"
#include "theatre_anatomy.h"

namespace glisson::insilico {
namespace {

constexpr double kYoungModulus = 6200.0, kPoissonRatio = 0.47;
constexpr int kFineTriangles = 12000;
constexpr double kErrorLength = 0.015;  // m over which the surface's error is alike
constexpr double kFirstWay = 0.012, kGrowth = 1.5, kNear = 0.04;
constexpr int kMostSteps = 14;
constexpr double kKindLength = 0.03;                            // m over which tissue is of one kind
constexpr double kTumourRadius = 0.017, kTumourModulus = 10.0;  // m; over the parenchyma's

/// A Gaussian field of deviation 1 by random Fourier features (Rahimi and Recht 2007), at points.
/// @param length over which it is alike, m
Eigen::VectorXd smooth_field(const Points& at, double length, Hand& hand) {
  constexpr int kWaves = 64;
  Eigen::VectorXd field = Eigen::VectorXd::Zero(at.rows());
  for (int k = 0; k < kWaves; ++k) {
    const Eigen::Vector3d wave = hand.tremor3() / length;
    const double phase = 2.0 * std::numbers::pi * hand.uniform();
    field.array() += ((at * wave).array() + phase).cos();
  }
  return std::sqrt(2.0 / kWaves) * field;
}

/// A smooth error of the surface along its normals.
void misdraw(TriangleMesh& surface, double deviation, Hand& hand) {
  if (deviation <= 0.0) return;
  const Points normals = vertex_normals(surface);
  surface.vertices += (deviation * smooth_field(surface.vertices, kErrorLength, hand)).asDiagonal() * normals;
}

/// What a handling does to the organ itself, before any tool.
struct Body {
  TetMesh mesh;  ///< free of stress
  fem::CompositeOptions tissue;
};

/// Four kinds of parenchyma by a smooth field, from half to twice the usual modulus, and a hard tumour.
void stiffen(Body& body, Hand& hand) {
  constexpr int kFirstKind = 1000, kTumour = 1100;
  constexpr std::array kModuli = {0.5, 0.8, 1.3, 2.0};
  TetMesh& mesh = body.mesh;
  Points middles = Points::Zero(mesh.tetrahedron_count(), 3);
  for (int t = 0; t < mesh.tetrahedron_count(); ++t)
    for (int k = 0; k < 4; ++k) middles.row(t) += 0.25 * mesh.vertices.row(mesh.tetrahedra(t, k));
  const Eigen::VectorXd field = smooth_field(middles, kKindLength, hand);
  const Eigen::RowVector3d tumour =
      middles.row(static_cast<Eigen::Index>(hand.draw(static_cast<std::size_t>(middles.rows()))));
  const double radius = kTumourRadius * (0.8 + 0.4 * hand.uniform());
  mesh.labels.resize(static_cast<std::size_t>(mesh.tetrahedron_count()));
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    // Quartiles of a normal distribution.
    const int kind = field[t] < -0.674 ? 0 : field[t] < 0.0 ? 1 : field[t] < 0.674 ? 2 : 3;
    mesh.labels[static_cast<std::size_t>(t)] =
        (middles.row(t) - tumour).norm() < radius ? kTumour : kFirstKind + kind;
  }
  for (std::size_t k = 0; k < kModuli.size(); ++k)
    body.tissue.by_label[static_cast<Label>(kFirstKind + static_cast<int>(k))] = {kModuli[k] * kYoungModulus,
                                                                                  kPoissonRatio};
  body.tissue.by_label[kTumour] = {kTumourModulus * kYoungModulus, kPoissonRatio};
}

/// Larger or smaller about the vena cava, which holds it. @param volume over what it was.
void resize(Body& body, const Points& cava, double volume) {
  const Eigen::RowVector3d middle = cava.colwise().mean();
  const double factor = std::cbrt(volume);
  body.mesh.vertices = (factor * (body.mesh.vertices.rowwise() - middle)).rowwise() + middle;
}

/// What lies beyond a plane across the margin goes onto the plane: a twelfth of the surface.
void resect(TriangleMesh& surface, const Points& margin, Hand& hand) {
  constexpr double kGone = 1.0 / 12.0;
  if (margin.rows() == 0) throw NumericalError("This liver has no margin from which a piece could be taken.");
  const auto at = static_cast<Eigen::Index>(hand.draw(static_cast<std::size_t>(margin.rows())));
  const Eigen::RowVector3d middle = surface.vertices.colwise().mean();
  const Eigen::Vector3d out = (margin.row(at) - middle).transpose().normalized();
  const Eigen::VectorXd along = surface.vertices * out, areas = vertex_areas(surface);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(along.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return along[a] > along[b]; });
  double gone = 0.0, plane = along.maxCoeff();
  for (const Eigen::Index v : order) {
    if (gone > kGone * areas.sum()) break;
    gone += areas[v];
    plane = along[v];
  }
  for (Eigen::Index v = 0; v < along.size(); ++v)
    if (along[v] > plane) surface.vertices.row(v) += (plane - along[v]) * out.transpose();
}

/// A camera in front of and below the liver, looking at some place on it, turned at random about its axis.
CameraFromCt look_at(const Points& surface, double distance, Hand& hand) {
  const double below = hand.uniform(), across = hand.uniform();
  const Eigen::Vector3d out = Eigen::Vector3d(1.2 * across - 0.6, -1.0, 0.3 - 1.1 * below).normalized();
  Eigen::Vector3d at = surface.colwise().mean().transpose();
  at.x() += 0.08 * hand.uniform() - 0.04;
  at.z() += 0.04 * hand.uniform() - 0.02;
  const double near = (surface * out).maxCoeff() - at.dot(out);
  const Eigen::Vector3d eye = at + (near + distance) * out;
  const Eigen::Vector3d z = -out, x = z.unitOrthogonal(), y = z.cross(x);
  CameraFromCt pose;
  pose.rotation.row(0) = x.transpose();
  pose.rotation.row(1) = y.transpose();
  pose.rotation.row(2) = z.transpose();
  const double roll = 2.0 * std::numbers::pi * hand.uniform();
  pose.rotation = Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() * pose.rotation;
  pose.translation = -pose.rotation * eye;
  return pose;
}

double bent(const Points& rest, const Points& now) {
  const auto best = fit_rigid<CtFrame, CtFrame>(rest, now);
  return (best.apply(rest) - now).rowwise().norm().mean();
}

fem::CompositeOptions tissue() {
  fem::CompositeOptions options;
  options.with_capsule = options.with_vessels = false;
  options.law = fem::TetrahedronLaw::neo_hookean;
  options.parenchyma = {kYoungModulus, kPoissonRatio};
  return options;
}

/// Goes on with the handling until the organ is bent as far as is wanted, or no further equilibrium is found.
/// @param rest where it is in the CT
Cancellable<Points> handle(const fem::CompositeModel& model, const Points& rest, const HandledLoads& loads,
                           double wanted, const RunContext& context) {
  fem::StaticOptions newton;
  newton.fixed_nodes = loads.fixed();
  newton.tolerance = 1e-4;
  newton.max_iterations = 60;
  Points nodes = model.mesh().vertices;
  for (const int node : newton.fixed_nodes) nodes.row(node) = rest.row(node);
  double way = kFirstWay, reached = 0.0, growth = kGrowth, bend = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(step) / kMostSteps, "insilico.handle");
    way = std::min(way, loads.farthest());
    const auto solved = fem::solve_static(
        model, nodes, [&](const Points& x) { return loads.at(x, way); }, newton, context.quiet());
    if (!solved) return std::nullopt;
    const bool found = solved->converged() || solved->residual < 10.0 * newton.tolerance;
    const double now = found ? bent(rest, solved->positions) : 0.0;
    if (!found || now > (1.0 + kNear) * wanted) {
      growth = std::sqrt(growth);
      if (growth < 1.02) break;
      way = reached > 0.0 ? reached * growth : way / kGrowth;
      continue;
    }
    nodes = solved->positions;
    reached = way;
    bend = now;
    if (bend > (1.0 - kNear) * wanted || way >= loads.farthest()) break;
    growth = std::min(growth, std::max(1.02, wanted / bend));
    way *= growth;
  }
  if (reached == 0.0) throw NumericalError("No equilibrium was found under the tools: take another seed.");
  return nodes;
}

}  // namespace

const char* handling_code(Handling handling) {
  switch (handling) {
    case Handling::lifted:
      return "lifted";
    case Handling::pressed:
      return "pressed";
    case Handling::turned:
      return "turned";
    case Handling::pulled:
      return "pulled";
    case Handling::loosened:
      return "loosened";
    case Handling::inflated:
      return "inflated";
    case Handling::stiffened:
      return "stiffened";
    case Handling::swollen:
      return "swollen";
    case Handling::resected:
      return "resected";
    case Handling::emptied:
      return "emptied";
  }
  return "unknown";
}

void HandlingOptions::validate() const {
  const OptionCheck demand("handled liver");
  demand(truth_vertices >= 200 && truth_vertices <= 20000, "truth_vertices", truth_vertices,
         "Give 200 to 20000");
  demand(elastic_motion_mm > 0.0 && elastic_motion_mm <= 20.0, "elastic_motion_mm", elastic_motion_mm,
         "Give up to 20 mm");
  demand(surface_error_mm >= 0.0 && surface_error_mm <= 5.0, "surface_error_mm", surface_error_mm,
         "Give 0 to 5 mm");
  demand(camera_distance_mm >= 50.0 && camera_distance_mm <= 300.0, "camera_distance_mm", camera_distance_mm,
         "Give 50 to 300 mm");
}

struct HandledLiver::Impl {
  TetMesh mesh;          ///< rest, CT frame
  Points nodes;          ///< handled, camera's frame
  TriangleMesh surface;  ///< handled, camera's frame
  Landmarks landmarks;
  CameraFromCt camera_from_ct;
  double elastic = 0.0, largest = 0.0;
};

HandledLiver::HandledLiver(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HandledLiver::~HandledLiver() = default;
HandledLiver::HandledLiver(HandledLiver&&) noexcept = default;
HandledLiver& HandledLiver::operator=(HandledLiver&&) noexcept = default;

Cancellable<HandledLiver> HandledLiver::build(const PatientModel& patient, const HandlingOptions& options,
                                              const RunContext& context) {
  options.validate();
  auto impl = std::make_unique<Impl>();
  const TriangleMesh closed = liver_of(patient);
  auto mesh = truth_mesh(closed, options.truth_vertices, context.part(0.0, 0.3));
  if (!mesh) return std::nullopt;
  impl->mesh = std::move(*mesh);
  impl->landmarks = complete_landmarks(patient.landmarks, closed);
  Body organ{impl->mesh, tissue()};
  Hand change(options.seed * 6007 + 5);
  if (options.handling == Handling::stiffened) stiffen(organ, change);
  if (options.handling == Handling::swollen)
    resize(organ, impl->landmarks.vena_cava, 1.06 + 0.08 * change.uniform());
  if (options.handling == Handling::emptied)  // 12 +- 7 % in people and pigs under gas (HANDLED.md)
    resize(organ, impl->landmarks.vena_cava, 0.81 + 0.14 * change.uniform());
  const fem::CompositeModel body(organ.mesh, {}, organ.tissue);
  const HandledLoads loads(boundary_surface(impl->mesh), impl->landmarks, options);
  const auto handled =
      handle(body, impl->mesh.vertices, loads, 1e-3 * options.elastic_motion_mm, context.part(0.3, 0.9));
  if (!handled) return std::nullopt;
  const auto best = fit_rigid<CtFrame, CtFrame>(impl->mesh.vertices, *handled);
  const Eigen::VectorXd motion = (best.apply(impl->mesh.vertices) - *handled).rowwise().norm();
  impl->elastic = motion.mean();
  impl->largest = motion.maxCoeff();

  Hand hand(options.seed * 7919 + 17);
  TriangleMesh fine = refine_for_drawing(closed, kFineTriangles);
  misdraw(fine, 1e-3 * options.surface_error_mm, hand);
  if (options.handling == Handling::resected) resect(fine, impl->landmarks.anterior_margin, change);
  const Binding binding = bind_points(impl->mesh, fine.vertices, false);
  impl->camera_from_ct =
      look_at(binding.apply(impl->mesh, *handled), 1e-3 * options.camera_distance_mm, hand);
  impl->nodes = impl->camera_from_ct.apply(*handled);
  impl->surface = {binding.apply(impl->mesh, impl->nodes), fine.triangles};
  context.progress(1.0, "insilico.handle");
  return HandledLiver(std::move(impl));
}

double HandledLiver::elastic_motion() const { return impl_->elastic; }
double HandledLiver::largest_motion() const { return impl_->largest; }
const CameraFromCt& HandledLiver::camera_from_ct() const { return impl_->camera_from_ct; }
const Landmarks& HandledLiver::landmarks() const { return impl_->landmarks; }

Points HandledLiver::carry(const Points& points) const {
  return bind_points(impl_->mesh, points, false).apply(impl_->mesh, impl_->nodes);
}

namespace {

/// Where the camera's axis meets the organ, or as deep as the organ lies.
Eigen::Vector3d looked_at(const TriangleMesh& surface, const RayCaster& caster) {
  const RayHit hit = caster.cast(Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ());
  return {0.0, 0.0,
          hit.thing == RayHit::Thing::organ ? static_cast<double>(hit.parameter)
                                            : surface.vertices.col(2).mean()};
}

}  // namespace

Patch HandledLiver::patch(const PatchOptions& options, const Rigid<CameraFrame, CameraFrame>& scope) const {
  options.validate();
  const TriangleMesh surface{scope.apply(impl_->surface.vertices), impl_->surface.triangles};
  const RayCaster caster(surface);
  return sample_patch(surface, caster, looked_at(surface, caster),
                      scope.apply(carry(impl_->landmarks.anterior_margin)),
                      scope.apply(carry(impl_->landmarks.umbilical_notch)), options);
}

std::vector<Patch> HandledLiver::looks(const PatchOptions& options,
                                       const std::vector<Rigid<CameraFrame, CameraFrame>>& scopes) const {
  require(!scopes.empty(), "a laparoscope looks from somewhere");
  const RayCaster caster(impl_->surface);
  std::vector<Eigen::Vector3d> eyes;
  eyes.reserve(scopes.size());
  for (const auto& scope : scopes) eyes.emplace_back(scope.inverse().translation);
  std::vector<Patch> looks = sample_looks(impl_->surface, caster, looked_at(impl_->surface, caster),
                                          carry(impl_->landmarks.anterior_margin),
                                          carry(impl_->landmarks.umbilical_notch), options, eyes);
  for (std::size_t k = 0; k < looks.size(); ++k) {
    Points& points = looks[k].cloud.points;
    points = scopes[k].apply(points);
  }
  return looks;
}

}  // namespace glisson::insilico
