// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessel_tubes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "glisson/ui/scene/drawable_model.h"

namespace glisson::scene {
namespace {

constexpr int kSides = 10;
constexpr double kShortestStep = 1e-3;  ///< metres between rings
constexpr std::array<double, 3> kCap = {0.5, 0.85,
                                        0.98};  ///< of the radius beyond an end: a half ball's rings

/// Nodes of a tree from where a branch begins to its tip.
struct Course {
  std::vector<int> nodes;
  bool is_branch = false;  ///< begins at another course's node
};

/// Each node's widest radius behind it, its own included. Beams run from the root outwards.
std::vector<double> widest_behind(const VesselTree& tree) {
  std::vector<double> widest = tree.radii;
  // From the last to the first, what is behind is known already.
  for (auto beam = tree.beams.rbegin(); beam != tree.beams.rend(); ++beam) {
    double& here = widest[static_cast<std::size_t>((*beam)[0])];
    here = std::max(here, widest[static_cast<std::size_t>((*beam)[1])]);
  }
  return widest;
}

/// At a fork the widest branch goes on, the others begin. Thin ones are left out.
std::vector<Course> courses_of(const VesselTree& tree) {
  const std::vector<double> widest = widest_behind(tree);
  std::vector<std::vector<int>> children(tree.radii.size());
  std::vector<bool> is_child(tree.radii.size(), false);
  for (const auto& [from, to] : tree.beams) {
    if (is_child[static_cast<std::size_t>(to)]) continue;  // a ring, which no tree has, would have no end
    is_child[static_cast<std::size_t>(to)] = true;
    if (widest[static_cast<std::size_t>(to)] >= kThin) children[static_cast<std::size_t>(from)].push_back(to);
  }
  std::vector<Course> open, done;
  for (std::size_t i = 0; i < children.size(); ++i)
    if (!is_child[i]) open.push_back({{static_cast<int>(i)}, false});
  while (!open.empty()) {
    Course course = std::move(open.back());
    open.pop_back();
    while (!children[static_cast<std::size_t>(course.nodes.back())].empty()) {
      const int at = course.nodes.back();
      const std::vector<int>& next = children[static_cast<std::size_t>(at)];
      const auto main = std::max_element(next.begin(), next.end(), [&](int a, int b) {
        return tree.radii[static_cast<std::size_t>(a)] < tree.radii[static_cast<std::size_t>(b)];
      });
      for (auto branch = next.begin(); branch != next.end(); ++branch)
        if (branch != main) open.push_back({{at, *branch}, true});
      course.nodes.push_back(*main);
    }
    if (course.nodes.size() > 1) done.push_back(std::move(course));
  }
  return done;
}

/// A place along a course: position and radius.
using Ring = VesselCourse::value_type;

VesselCourse nodes_of(const VesselTree& tree, const Course& course) {
  VesselCourse rings;
  for (const int node : course.nodes)
    rings.emplace_back(tree.nodes(node, 0), tree.nodes(node, 1), tree.nodes(node, 2),
                       tree.radii[static_cast<std::size_t>(node)]);
  if (course.is_branch) rings[0][3] = std::min(rings[0][3], rings[1][3]);
  return rings;
}

/// The curve of Catmull and Rom, centripetal (Yuksel et al. 2011: no loops, no cusps), between b and c.
Ring between(const Ring& a, const Ring& b, const Ring& c, const Ring& d, double t) {
  const auto knot = [](const Ring& from, const Ring& to) {
    return std::max(1e-4, std::sqrt((to - from).head<3>().norm()));
  };
  const double ab = knot(a, b), bc = knot(b, c), cd = knot(c, d);
  const double at = t * bc;  // b at 0, c at bc
  const Ring one = (-at * a + (at + ab) * b) / ab, two = ((bc - at) * b + at * c) / bc,
             three = ((bc + cd - at) * c + (at - bc) * d) / cd;
  const Ring low = ((bc - at) * one + (at + ab) * two) / (ab + bc),
             high = ((bc + cd - at) * two + at * three) / (bc + cd);
  return ((bc - at) * low + at * high) / bc;
}

double length_of(const VesselCourse& rings) {
  double length = 0.0;
  for (std::size_t i = 1; i < rings.size(); ++i) length += (rings[i] - rings[i - 1]).head<3>().norm();
  return length;
}

VesselCourse smoothed(const VesselCourse& nodes, double step) {
  VesselCourse rings;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Ring &b = nodes[i], &c = nodes[i + 1];
    // At an end the curve goes on as it came.
    const Ring a = i > 0 ? nodes[i - 1] : (2.0 * b - c).eval(),
               d = i + 2 < nodes.size() ? nodes[i + 2] : (2.0 * c - b).eval();
    const int steps = std::max(1, static_cast<int>(std::lround((c - b).head<3>().norm() / step)));
    for (int k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      Ring ring = between(a, b, c, d, t);
      ring[3] = b[3] + t * (c[3] - b[3]);  // a radius may not swing
      rings.push_back(ring);
    }
  }
  rings.push_back(nodes.back());
  return rings;
}

/// Half a ball at the end.
void round_off(VesselCourse& rings) {
  const Ring end = rings.back(), before = rings[rings.size() - 2];
  const Eigen::Vector3d way = (end - before).head<3>();
  if (!(way.norm() > 0.0)) return;
  for (const double share : kCap) {
    Ring ring = end;
    ring.head<3>() += share * end[3] * way.normalized();
    ring[3] *= std::sqrt(1.0 - share * share);
    rings.push_back(ring);
  }
}

/// Rings of vertices along courses, joined to closed tubes.
class Sweep {
 public:
  /// @param mesh with room for all of them: kSides vertices a ring and two more a course, 2 kSides triangles
  /// a ring.
  explicit Sweep(TriangleMesh& mesh) : mesh_(mesh) {}

  void add(const VesselCourse& rings) {
    Eigen::Vector3d along = way(rings, 0), side = along.unitOrthogonal();
    const int first = vertex_;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      // The frame goes along without a twist of its own.
      const Eigen::Vector3d now = way(rings, i);
      side = (Eigen::Quaterniond::FromTwoVectors(along, now) * side).normalized();
      along = now;
      const Eigen::Vector3d other = along.cross(side);
      for (int k = 0; k < kSides; ++k) {
        const double angle = 2.0 * M_PI * k / kSides;
        put(rings[i].head<3>() + rings[i][3] * (std::cos(angle) * side + std::sin(angle) * other));
      }
    }
    const int root = put(rings.front().head<3>()), tip = put(rings.back().head<3>());
    const int last = first + (static_cast<int>(rings.size()) - 1) * kSides;
    for (int k = 0; k < kSides; ++k) {
      const int next = (k + 1) % kSides;
      join(root, first + next, first + k);
      join(tip, last + k, last + next);
      for (int ring = first; ring < last; ring += kSides) {
        join(ring + k, ring + next, ring + kSides + k);
        join(ring + next, ring + kSides + next, ring + kSides + k);
      }
    }
  }

 private:
  static Eigen::Vector3d way(const VesselCourse& rings, std::size_t i) {
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, rings.size() - 1);
    const Eigen::Vector3d step = (rings[after] - rings[before]).head<3>();
    return step.norm() > 0.0 ? step.normalized() : Eigen::Vector3d::UnitZ().eval();
  }
  int put(const Eigen::Vector3d& p) {
    mesh_.vertices.row(vertex_) = p.transpose();
    return vertex_++;
  }
  void join(int a, int b, int c) { mesh_.triangles.row(triangle_++) << a, b, c; }

  TriangleMesh& mesh_;
  int vertex_ = 0, triangle_ = 0;
};

}  // namespace

std::vector<VesselCourse> vessel_courses(const std::vector<const VesselTree*>& trees, int triangles) {
  std::vector<VesselCourse> courses;
  double length = 0.0;
  for (const VesselTree* tree : trees)
    for (const Course& course : courses_of(*tree)) {
      courses.push_back(nodes_of(*tree, course));
      length += length_of(courses.back());
    }
  const double step = std::max(kShortestStep, length * 2 * kSides / std::max(1, triangles));
  for (VesselCourse& course : courses) course = smoothed(course, step);
  return courses;
}

TriangleMesh tubes_around(const std::vector<VesselCourse>& courses) {
  std::vector<VesselCourse> rounded = courses;
  Eigen::Index rings = 0;
  for (VesselCourse& course : rounded) {
    for (int end = 0; end < 2; ++end) {
      round_off(course);
      std::reverse(course.begin(), course.end());
    }
    rings += static_cast<Eigen::Index>(course.size());
  }
  const auto ends = static_cast<Eigen::Index>(2 * rounded.size());
  TriangleMesh mesh;
  mesh.vertices.resize(rings * kSides + ends, 3);
  mesh.triangles.resize(2 * kSides * rings, 3);
  Sweep sweep(mesh);
  for (const VesselCourse& course : rounded) sweep.add(course);
  return mesh;
}

}  // namespace glisson::scene
