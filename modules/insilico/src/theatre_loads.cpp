// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre_loads.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "glisson/core/error.h"

namespace glisson::insilico {
namespace {

// Directions in the CT's frame: x left, y posterior, z superior.
const Eigen::Vector3d kSuperior(0.0, 0.0, 1.0);
const Eigen::Vector3d kAnterior(0.0, -1.0, 0.0);
/// Gas lies under the abdominal wall and the front of the diaphragm.
const Eigen::Vector3d kGas = Eigen::Vector3d(0.0, -0.95, 0.3).normalized();
constexpr double kGravity = 9.81;

// Stiffness of what holds the liver, N/m3 (N/m per m2 of its face). The cava holds firmly (2 mm under 1 kPa)
// and lets go gradually, so that no element is torn. Behind lie the spine and, beside it, softer organs that
// give way under the gas (bed_gives_way). The diaphragm holds by contact only.
constexpr double kCava = 5e5, kSpine = 2e5, kBed = 1e5, kDiaphragm = 1e4, kLigament = 5e4;
constexpr double kCavaRadius = 0.018, kSpineHalfWidth = 0.03, kLigamentHalfWidth = 0.010,
                 kHeartRadius = 0.025;

/// g_new - g_supine when the table is turned 15 degrees to the left and its head raised by 20.
Eigen::Vector3d tilted_gravity(double tilt) {
  const double flank = tilt * 15.0 * std::numbers::pi / 180.0,
               head_up = tilt * 20.0 * std::numbers::pi / 180.0;
  const Eigen::Vector3d now(std::sin(flank) * std::cos(head_up), std::cos(flank) * std::cos(head_up),
                            -std::sin(head_up));
  return kGravity * (now + kAnterior);
}

double bell(double r) { return std::exp(-0.5 * r * r); }

/// Stiffness of the bed beside the spine, N/m3.
double bed(double sideways) { return kBed + (kSpine - kBed) * bell(sideways / kSpineHalfWidth); }

/// Displacement of the bed per metre of its sinking: beside the spine it goes backwards and towards the feet,
/// more on the right, where kidney and colon make room. It levels off far out, so that both lobes bend around
/// the spine without a kink.
Eigen::Vector3d bed_gives_way(double sideways) {
  constexpr double kMost = 2.0;
  const double r = sideways / 0.09;
  const double share = kMost * (1.0 - std::exp(-r * r / kMost)) * (sideways < 0.0 ? 1.0 : 0.8);
  return share * (Eigen::Vector3d(0.0, 1.0, -0.35));
}

double distance_to(const Points& points, const Eigen::Vector3d& p) {
  return std::sqrt((points.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff());
}

}  // namespace

TheatreLoads::TheatreLoads(const BoundarySurface& surface, const Landmarks& landmarks) {
  const Points normals = triangle_normals(surface.mesh);
  for (int t = 0; t < surface.mesh.triangle_count(); ++t)
    if (normals.row(t).dot(kGas) > 0.5) {
      auto& nodes = gas_.emplace_back();
      for (int k = 0; k < 3; ++k)
        nodes[static_cast<std::size_t>(k)] =
            surface.node_of_vertex[static_cast<std::size_t>(surface.mesh.triangles(t, k))];
    }
  hold(surface, landmarks);
}

void TheatreLoads::hold(const BoundarySurface& surface, const Landmarks& landmarks) {
  const Points normals = vertex_normals(surface.mesh);
  const Eigen::VectorXd node_area = vertex_areas(surface.mesh);

  const Points& cava = landmarks.vena_cava;
  require(cava.rows() > 0, "the theatre's landmarks are complete");
  cava_ = cava.colwise().mean().transpose();
  const bool ligament = landmarks.umbilical_notch.rows() > 0;
  const double ligament_x = ligament ? landmarks.umbilical_notch.col(0).mean() : 0.0;

  double heart_sum = 0.0;
  // The heart lies on the dome above the left lobe: left of the cava, at the top.
  Eigen::Index top = 0;
  const Eigen::VectorXd height = surface.mesh.vertices.col(2) + 0.5 * surface.mesh.vertices.col(0);
  height.maxCoeff(&top);
  const Eigen::Vector3d heart = surface.mesh.vertex(static_cast<int>(top));
  for (int v = 0; v < surface.mesh.vertex_count(); ++v) {
    const Eigen::Vector3d p = surface.mesh.vertex(v), n = normals.row(v).transpose();
    const int node = surface.node_of_vertex[static_cast<std::size_t>(v)];
    const double up = n.dot(kSuperior), front = n.dot(kAnterior);
    const double held = bell(distance_to(cava, p) / kCavaRadius);
    if (held > 0.01) springs_.push_back({node, held * kCava * node_area[v], p, 0.5, 0.0});
    if (up > 0.5)
      springs_.push_back({node, kDiaphragm * node_area[v], p, 1.0, 0.0});
    else if (front < -0.2)
      springs_.push_back(
          {node, bed(p.x() - cava_.x()) * node_area[v], p, 0.6, 0.0, bed_gives_way(p.x() - cava_.x())});
    const double tied = ligament && front > 0.3 ? bell((p.x() - ligament_x) / kLigamentHalfWidth) : 0.0;
    if (tied > 0.01) springs_.push_back({node, tied * kLigament * node_area[v], p, 0.6, 1.0});
    const double near_heart = bell((p - heart).norm() / kHeartRadius);
    if (near_heart > 0.05) {
      heart_.emplace_back(node, near_heart * node_area[v]);
      heart_sum += heart_.back().second;
    }
  }
  for (auto& [node, share] : heart_) share /= heart_sum;
}

fem::Loads TheatreLoads::at(const Points& x, const Points& shape, const LoadLevels& levels) const {
  fem::Loads loads;
  loads.gravity_change = tilted_gravity(levels.tilt);
  loads.attached.reserve(springs_.size() + gas_.size() + heart_.size());
  for (const auto& [a, b, c] : gas_) {
    const Eigen::Vector3d p = shape.row(a).transpose();
    const Eigen::Vector3d area = 0.5 * (shape.row(b).transpose() - p).cross(shape.row(c).transpose() - p);
    fem::AttachedLoad load;
    load.nodes = {a, b, c, -1};
    load.weights = {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0};
    load.force = -levels.pressure_pa * area;
    loads.attached.push_back(load);
  }
  for (const Spring& spring : springs_) {
    const Eigen::Vector3d anchor = spring.rest - spring.follows_diaphragm * levels.diaphragm * kSuperior +
                                   spring.follows_wall * levels.ligament_lift * kAnterior +
                                   levels.bed_sinks * spring.follows_bed;
    fem::AttachedLoad load;
    load.nodes[0] = spring.node;
    load.weights[0] = 1.0;
    load.force = spring.stiffness * (anchor - x.row(spring.node).transpose());
    load.tangent = spring.stiffness * Eigen::Matrix3d::Identity();
    loads.attached.push_back(load);
  }
  for (const ToolHold& held : tool_) {
    fem::AttachedLoad load;
    load.nodes[0] = held.node;
    load.weights[0] = 1.0;
    load.force = held.stiffness * (held.from + levels.tool * held.way - x.row(held.node).transpose());
    load.tangent = held.stiffness * Eigen::Matrix3d::Identity();
    loads.attached.push_back(load);
  }
  if (levels.heart_n != 0.0) {
    for (const auto& [node, share] : heart_) {
      fem::AttachedLoad load;
      load.nodes[0] = node;
      load.weights[0] = 1.0;
      load.force = -levels.heart_n * share * kSuperior;
      loads.attached.push_back(load);
    }
  }
  return loads;
}

}  // namespace glisson::insilico
