// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/closest_point_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr int kLeafSize = 4;
constexpr int kStackDepth = 64;

double squared_distance_to_box(const Eigen::Vector3d& p, const Eigen::Vector3d& low,
                               const Eigen::Vector3d& high) {
  return (p - p.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

bool ray_meets_box(const Eigen::Vector3d& origin, const Eigen::Vector3d& inverse, const Eigen::Vector3d& low,
                   const Eigen::Vector3d& high, double t_min, double t_max) {
  for (int k = 0; k < 3; ++k) {
    double enter = (low[k] - origin[k]) * inverse[k], leave = (high[k] - origin[k]) * inverse[k];
    if (enter > leave) std::swap(enter, leave);
    // A ray in the plane of a slab gives 0 * inf; such a bound tells nothing.
    if (!std::isnan(enter)) t_min = std::max(t_min, enter);
    if (!std::isnan(leave)) t_max = std::min(t_max, leave);
  }
  return t_min <= t_max;
}

}  // namespace

Eigen::Vector3d closest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                                    const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Eigen::Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 - d3 > 0.0 ? d1 / (d1 - d3) : 0.0;
    return {1.0 - v, v, 0.0};
  }
  const Eigen::Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 - d6 > 0.0 ? d2 / (d2 - d6) : 0.0;
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double sum = (d4 - d3) + (d5 - d6), w = sum > 0.0 ? (d4 - d3) / sum : 0.0;
    return {0.0, 1.0 - w, w};
  }
  const double total = va + vb + vc;
  if (!(total > 0.0)) return {1.0, 0.0, 0.0};  // a point: any vertex is as close
  return {va / total, vb / total, vc / total};
}

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh)
    : ClosestPointTree(mesh, [&] {
        std::vector<int> all(static_cast<std::size_t>(mesh.triangle_count()));
        std::iota(all.begin(), all.end(), 0);
        return all;
      }()) {}

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh, const std::vector<int>& triangles)
    : vertices_(mesh.vertices), triangles_(mesh.triangles), order_(triangles) {
  if (order_.empty()) return;
  std::vector<Eigen::Vector3d> centres(static_cast<std::size_t>(mesh.triangle_count()));
  for (const int t : order_)
    centres[t] =
        (mesh.vertex(triangles_(t, 0)) + mesh.vertex(triangles_(t, 1)) + mesh.vertex(triangles_(t, 2))) / 3.0;
  nodes_.reserve(order_.size());
  build(0, static_cast<int>(order_.size()), centres);
  refit(mesh.vertices);
}

int ClosestPointTree::build(int begin, int end, const std::vector<Eigen::Vector3d>& centres) {
  const int index = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  if (end - begin <= kLeafSize) {
    nodes_[index].first = begin;
    nodes_[index].count = end - begin;
    return index;
  }
  Eigen::Vector3d low = centres[order_[begin]], high = low;
  for (int i = begin; i < end; ++i) {
    low = low.cwiseMin(centres[order_[i]]);
    high = high.cwiseMax(centres[order_[i]]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int s, int t) {
    return centres[s][axis] != centres[t][axis] ? centres[s][axis] < centres[t][axis] : s < t;
  });
  build(begin, middle, centres);
  nodes_[index].first = build(middle, end, centres);
  return index;
}

void ClosestPointTree::fit(Node& node) const {
  if (node.count > 0) {
    node.low.setConstant(std::numeric_limits<double>::infinity());
    node.high = -node.low;
    for (int i = node.first; i < node.first + node.count; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d p = vertices_.row(triangles_(order_[i], k)).transpose();
        node.low = node.low.cwiseMin(p);
        node.high = node.high.cwiseMax(p);
      }
    }
    return;
  }
  const Node& first = *(&node + 1);
  const Node& second = nodes_[node.first];
  node.low = first.low.cwiseMin(second.low);
  node.high = first.high.cwiseMax(second.high);
}

void ClosestPointTree::refit(const Points& vertices) {
  require(vertices.rows() == vertices_.rows(), "refit needs the same vertices, moved");
  vertices_ = vertices;
  for (std::size_t i = nodes_.size(); i-- > 0;) fit(nodes_[i]);  // children come after their parent
}

ClosestPoint ClosestPointTree::closest(const Eigen::Vector3d& query, double radius) const {
  return search(query, radius * radius, {});
}

ClosestPoint ClosestPointTree::closest_from(int near, const Eigen::Vector3d& query) const {
  ClosestPoint best;
  double best_squared = std::numeric_limits<double>::infinity();
  if (near >= 0) offer(near, query, best_squared, best);
  return search(query, best_squared, best);
}

void ClosestPointTree::offer(int triangle, const Eigen::Vector3d& query, double& best_squared,
                             ClosestPoint& best) const {
  const Eigen::Vector3d a = vertices_.row(triangles_(triangle, 0)).transpose(),
                        b = vertices_.row(triangles_(triangle, 1)).transpose(),
                        c = vertices_.row(triangles_(triangle, 2)).transpose();
  const Eigen::Vector3d weights = closest_on_triangle(query, a, b, c);
  const Eigen::Vector3d point = weights[0] * a + weights[1] * b + weights[2] * c;
  const double squared = (point - query).squaredNorm();
  // The lower triangle number wins a tie, so that the answer does not depend on the tree's shape.
  if (squared > best_squared || (squared == best_squared && best.triangle >= 0 && triangle >= best.triangle))
    return;
  best_squared = squared;
  best = {triangle, point, weights, 0.0};
}

ClosestPoint ClosestPointTree::search(const Eigen::Vector3d& query, double best_squared,
                                      ClosestPoint best) const {
  if (nodes_.empty()) return best;
  struct Entry {
    int node;
    double squared;  ///< to its box
  };
  Entry stack[kStackDepth];
  int depth = 0;
  stack[depth++] = {0, 0.0};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.squared > best_squared) continue;
    const Node& node = nodes_[entry.node];
    if (node.count > 0) {
      for (int i = node.first; i < node.first + node.count; ++i) offer(order_[i], query, best_squared, best);
      continue;
    }
    Entry near{entry.node + 1, 0.0}, far{node.first, 0.0};
    near.squared = squared_distance_to_box(query, nodes_[near.node].low, nodes_[near.node].high);
    far.squared = squared_distance_to_box(query, nodes_[far.node].low, nodes_[far.node].high);
    if (far.squared < near.squared) std::swap(near, far);
    if (far.squared <= best_squared) stack[depth++] = far;
    if (near.squared <= best_squared) stack[depth++] = near;
  }
  if (best.triangle >= 0) best.distance = std::sqrt(best_squared);
  return best;
}

ClosestPoint ClosestPointTree::first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                         double t_min, double t_max) const {
  ClosestPoint best;
  if (nodes_.empty()) return best;
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  double nearest = t_max;
  int stack[kStackDepth];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const int index = stack[--depth];
    const Node& node = nodes_[index];
    if (!ray_meets_box(origin, inverse, node.low, node.high, t_min, nearest)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = index + 1;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      // Möller and Trumbore 1997.
      const int t = order_[i];
      const Eigen::Vector3d a = vertices_.row(triangles_(t, 0)).transpose();
      const Eigen::Vector3d ab = vertices_.row(triangles_(t, 1)).transpose() - a;
      const Eigen::Vector3d ac = vertices_.row(triangles_(t, 2)).transpose() - a;
      const Eigen::Vector3d p = direction.cross(ac);
      const double determinant = ab.dot(p);
      if (determinant == 0.0) continue;
      const Eigen::Vector3d s = origin - a, q = s.cross(ab);
      const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant,
                   at = ac.dot(q) / determinant;
      if (u < 0.0 || v < 0.0 || u + v > 1.0 || at <= t_min || at >= nearest) continue;
      nearest = at;
      best = {t, origin + at * direction, {1.0 - u - v, u, v}, at};
    }
  }
  return best;
}

}  // namespace glisson
