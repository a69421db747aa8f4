// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre_tool.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/random.h"

namespace glisson::insilico {
namespace {

constexpr double kEnters = 1.0 / 3.0;  ///< seconds on the way in, as many out
constexpr double kWayOut = 0.12, kRadius = 2.5e-3, kLength = 0.35;

double smooth(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

void ToolUse::validate() const {
  const OptionCheck check("tool");
  check(way_mm >= -30.0 && way_mm <= 40.0, "way_mm", way_mm, "give -30 to 40 mm");
  check(begins_s >= 0.0, "begins_s", begins_s, "give 0 s or more");
  check(moves_s > 0.0, "moves_s", moves_s, "give more than 0 s");
  check(holds_s >= 0.0, "holds_s", holds_s, "give 0 s or more");
  check(tip_mm >= 3.0 && tip_mm <= 30.0, "tip_mm", tip_mm, "give 3 to 30 mm");
}

ToolMoment tool_moment(const ToolUse& use, double seconds) {
  const double touches = use.begins_s + kEnters;
  const double returns = touches + use.moves_s + use.holds_s, leaves = returns + use.moves_s;
  ToolMoment moment;
  moment.out = 1.0 - smooth((seconds - use.begins_s) / kEnters) + smooth((seconds - leaves) / kEnters);
  moment.share = smooth((seconds - touches) / use.moves_s) - smooth((seconds - returns) / use.moves_s);
  return moment;
}

TriangleMesh tool_shaft() {
  constexpr int kAround = 24, kRings = 6;
  std::vector<Eigen::Vector3d> vertices{Eigen::Vector3d::Zero()};
  const auto ring = [&](double radius, double z) {
    for (int i = 0; i < kAround; ++i) {
      const double a = 2.0 * std::numbers::pi * i / kAround;
      vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    }
  };
  for (int r = 1; r <= kRings; ++r) {
    const double a = 0.5 * std::numbers::pi * r / kRings;
    ring(kRadius * std::sin(a), -kRadius * (1.0 - std::cos(a)));
  }
  ring(kRadius, -kLength);
  std::vector<Eigen::RowVector3i> triangles;
  for (int i = 0; i < kAround; ++i) {
    const int next = (i + 1) % kAround;
    triangles.emplace_back(0, 1 + i, 1 + next);
    for (int r = 0; r < kRings; ++r) {
      const int a = 1 + r * kAround, b = a + kAround;
      triangles.emplace_back(a + i, b + i, b + next);
      triangles.emplace_back(a + i, b + next, a + next);
    }
  }
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    mesh.vertices.row(static_cast<Eigen::Index>(v)) = vertices[v].transpose();
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t];
  return mesh;
}

TriangleMesh placed_tool(const TriangleMesh& shaft, const Eigen::Vector3d& port, const Eigen::Vector3d& tip,
                         double out) {
  const Eigen::Vector3d axis = (tip - port).normalized();
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
  TriangleMesh placed = shaft;
  const Eigen::Vector3d end = tip - kWayOut * out * axis;
  placed.vertices = (shaft.vertices * turn.transpose()).rowwise() + end.transpose();
  return placed;
}

Eigen::Vector3d tool_port(const ToolUse& use) {
  std::mt19937_64 random(use.seed * 48271 + 11);
  const double side = uniform01(random) < 0.5 ? -1.0 : 1.0;
  const double up = uniform01(random);
  return {side * 0.11, -0.07 + 0.08 * up, -0.01};
}

}  // namespace glisson::insilico
