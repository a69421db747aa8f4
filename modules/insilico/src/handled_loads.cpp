// SPDX-License-Identifier: GPL-3.0-or-later
#include "handled_loads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"
#include "operator_hand.h"

namespace glisson::insilico {
namespace {

// The CT's frame: x left, y posterior, z superior.
const Eigen::Vector3d kAnterior(0.0, -1.0, 0.0), kSuperior(0.0, 0.0, 1.0);
/// The bare area lies on the diaphragm behind and above.
const Eigen::Vector3d kBareArea = Eigen::Vector3d(-0.3, 0.6, 0.75).normalized();

constexpr double kFixedRadius = 0.016, kBareRadius = 0.055;  // m, about the vena cava
constexpr double kBare = 6e4, kUnder = 1.5e5;                // N/m per m2 of the face
constexpr double kTool = 4e6;                                // N/m per m2 of tissue in it
constexpr double kWholeTurn = 0.1;                           // m of `way` at which gravity has turned
constexpr double kGas = 32e3;                                // Pa a metre of `way`: 12 mmHg at 5 cm
constexpr double kCarried = 0.4;                             // the diaphragm's way: 2 cm at 5 cm

double distance_to(const Points& points, const Eigen::Vector3d& p) {
  return std::sqrt((points.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff());
}

Eigen::Vector3d askew(const Eigen::Vector3d& along, double most, Hand& hand) {
  Eigen::Vector3d d;
  do d = hand.tremor3();
  while (d.norm() < 1e-3);
  return (along + std::tan(most * hand.uniform()) * along.cross(d).normalized()).normalized();
}

}  // namespace

HandledLoads::HandledLoads(const BoundarySurface& surface, const Landmarks& landmarks,
                           const HandlingOptions& options) {
  Hand hand(options.seed * 1009 + static_cast<std::uint64_t>(options.handling));
  const Organ organ{surface, landmarks, vertex_normals(surface.mesh), vertex_areas(surface.mesh)};
  hold(organ);
  handle(options.handling, organ, hand);
}

void HandledLoads::hold(const Organ& organ) {
  const TriangleMesh& mesh = organ.surface.mesh;
  const Points& cava = organ.landmarks.vena_cava;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Eigen::Vector3d p = mesh.vertex(v), n = organ.normals.row(v).transpose();
    const int node = organ.surface.node_of_vertex[static_cast<std::size_t>(v)];
    const double away = distance_to(cava, p);
    if (away < kFixedRadius)
      fixed_.push_back(node);
    else if (away < kBareRadius && n.dot(kBareArea) > 0.5)
      hung_.push_back({node, kBare * organ.areas[v], p});
    else if (-n.dot(kAnterior) > 0.35)
      bed_.push_back({node, kUnder * organ.areas[v], p});
  }
  if (fixed_.size() >= 3) return;
  // A coarse mesh: the vertices nearest to the vena cava.
  std::vector<int> order(static_cast<std::size_t>(mesh.vertex_count()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::partial_sort(order.begin(), order.begin() + 4, order.end(), [&](int a, int b) {
    return distance_to(cava, mesh.vertex(a)) < distance_to(cava, mesh.vertex(b));
  });
  for (int k = 0; k < 4; ++k)
    fixed_.push_back(
        organ.surface.node_of_vertex[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])]);
}

void HandledLoads::handle(Handling handling, const Organ& organ, Hand& hand) {
  switch (handling) {
    case Handling::lifted:
    case Handling::stiffened:
      return lift(organ, hand);
    case Handling::pressed:
      return press(organ, hand);
    case Handling::loosened:
      hung_.clear();
      return turn(hand);
    case Handling::turned:
      return turn(hand);
    case Handling::pulled:
      return pull(1 + hand.draw(3), organ, hand);
    case Handling::inflated:
    case Handling::emptied:
      return inflate(organ);
    case Handling::swollen:
    case Handling::resected:
      return pull(2, organ, hand);
  }
}

/// A vertex 5 cm and more from the vena cava that is accepted (by its normal).
template <class Accepts>
int HandledLoads::somewhere(const Organ& organ, Hand& hand, const Accepts& accepts) {
  const TriangleMesh& mesh = organ.surface.mesh;
  const Eigen::Vector3d cava = organ.landmarks.vena_cava.colwise().mean().transpose();
  std::vector<int> places;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if ((mesh.vertex(v) - cava).norm() > 0.05 && accepts(Eigen::Vector3d(organ.normals.row(v).transpose())))
      places.push_back(v);
  if (places.empty()) throw NumericalError("There is no place for a tool on this liver.");
  return places[hand.draw(places.size())];
}

void HandledLoads::lift(const Organ& organ, Hand& hand) {
  const Points& margin = organ.landmarks.anterior_margin;
  if (margin.rows() == 0) throw NumericalError("This liver has no margin by which a tool could lift it.");
  // Not at the ends of the line; either lobe.
  const auto count = static_cast<double>(margin.rows() - 1);
  const auto at = static_cast<Eigen::Index>(std::lround(count * (0.15 + 0.7 * hand.uniform())));
  const Eigen::Vector3d along = askew((kAnterior + 0.6 * kSuperior).normalized(), 0.5, hand);
  take(organ, margin.row(at).transpose(), 0.014 + 0.006 * hand.uniform(), along);
}

void HandledLoads::press(const Organ& organ, Hand& hand) {
  const int v = somewhere(organ, hand, [](const Eigen::Vector3d& n) { return n.dot(kAnterior) > 0.6; });
  const Eigen::Vector3d along = askew(-organ.normals.row(v).transpose(), 0.5, hand);
  take(organ, organ.surface.mesh.vertex(v), 0.022 + 0.012 * hand.uniform(), along);
}

void HandledLoads::turn(Hand& hand) {
  const double angle = (35.0 + 35.0 * hand.uniform()) * std::numbers::pi / 180.0;
  const double head = 20.0 * (2.0 * hand.uniform() - 1.0) * std::numbers::pi / 180.0;
  const Eigen::Vector3d down(std::sin(angle) * std::cos(head), std::cos(angle) * std::cos(head),
                             -std::sin(head));
  gravity_ = 9.81 * (down + kAnterior);
  farthest_ = 3.0 * kWholeTurn;  // softer tissue bends as under more gravity
}

void HandledLoads::pull(std::size_t places, const Organ& organ, Hand& hand) {
  for (std::size_t k = 0; k < places; ++k) {
    const int v = somewhere(organ, hand, [](const Eigen::Vector3d&) { return true; });
    const double sign = hand.uniform() < 0.6 ? 1.0 : -1.0;
    const Eigen::Vector3d along = askew(organ.normals.row(v).transpose(), 0.8, hand);
    const double pull = sign * (0.4 + 0.6 * hand.uniform());
    take(organ, organ.surface.mesh.vertex(v), 0.010 + 0.006 * hand.uniform(), pull * along);
  }
}

void HandledLoads::inflate(const Organ& organ) {
  const TriangleMesh& mesh = organ.surface.mesh;
  const Points normals = triangle_normals(mesh);
  for (int t = 0; t < mesh.triangle_count(); ++t)
    if (-normals.row(t).dot(kAnterior) < 0.35) under_gas_.push_back(t);
  gas_ = kGas;
  carried_ = kCarried * (kSuperior + 0.3 * kAnterior).normalized();
}

void HandledLoads::take(const Organ& organ, const Eigen::Vector3d& centre, double radius,
                        const Eigen::Vector3d& along) {
  const TriangleMesh& mesh = organ.surface.mesh;
  int nearest = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if ((mesh.vertex(v) - centre).norm() < (mesh.vertex(nearest) - centre).norm()) nearest = v;
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (v == nearest || (mesh.vertex(v) - centre).norm() < radius)
      tools_.push_back({organ.surface.node_of_vertex[static_cast<std::size_t>(v)], kTool * organ.areas[v],
                        mesh.vertex(v), along});
}

fem::Loads HandledLoads::at(const Points& x, double way) const {
  fem::Loads loads;
  loads.gravity_change = way / kWholeTurn * gravity_;
  loads.pressure = way * gas_;
  loads.pressure_triangles = under_gas_;
  const auto hold = [&](int node, double stiffness, const Eigen::Vector3d& to) {
    fem::AttachedLoad load;
    load.nodes[0] = node;
    load.weights[0] = 1.0;
    load.force = stiffness * (to - x.row(node).transpose());
    load.tangent = stiffness * Eigen::Matrix3d::Identity();
    loads.attached.push_back(load);
  };
  for (const Hold& tool : tools_) hold(tool.node, tool.stiffness, tool.rest + way * tool.along);
  for (const Rest& place : hung_) hold(place.node, place.stiffness, place.rest + way * carried_);
  for (const Rest& place : bed_) {
    // The bed presses what sinks into it, and lets go of what is lifted.
    const double sunk = x(place.node, 1) - place.rest.y();
    fem::AttachedLoad load;
    load.nodes[0] = place.node;
    load.weights[0] = 1.0;
    const double share = sunk > 0.0 ? 1.0 : 0.01;
    load.force = share * place.stiffness * sunk * kAnterior;
    load.tangent = share * place.stiffness * kAnterior * kAnterior.transpose();
    loads.attached.push_back(load);
  }
  return loads;
}

}  // namespace glisson::insilico
