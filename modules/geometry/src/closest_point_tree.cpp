// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/closest_point_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr int kStackDepth = 64;     // three a level: enough for four to the twentieth
constexpr double kMostSlack = 0.1;  ///< of a triangle's edge: larger boxes would be looked into too often
constexpr int kAbsent = std::numeric_limits<int>::min();
constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// By how much numbers move at most when they are rounded to single precision, and a little more.
Eigen::Array3f rounding(const Eigen::Array3f& values) { return 1.2e-7F * values.abs() + 1e-37F; }

Eigen::Array3f below(const Eigen::Array3d& values) {
  const Eigen::Array3f single = values.cast<float>();
  return single - rounding(single);
}

Eigen::Array3f above(const Eigen::Array3d& values) {
  const Eigen::Array3f single = values.cast<float>();
  return single + rounding(single);
}

/// A squared distance to a box in single precision that is larger than this is larger than `squared`. Finite:
/// that to the box of an absent child is not.
float limit_of(double squared) {
  return std::min(static_cast<float>(squared * (1.0 + 3e-6)) + 1e-37F, std::numeric_limits<float>::max());
}

/// The square of the sine between two edges below which a triangle is a line, as far as rounding lets one
/// see.
constexpr double kLine = 1e-24;

/// The point closest to p on the edges of a triangle that is a line or a point, as barycentric weights.
Eigen::Vector3d closest_on_edges(const Eigen::Vector3d& p, const std::array<Eigen::Vector3d, 3>& corners) {
  Eigen::Vector3d closest = Eigen::Vector3d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Eigen::Vector3d& from = corners[static_cast<std::size_t>(k)];
    const Eigen::Vector3d edge = corners[static_cast<std::size_t>(next)] - from;
    const double length2 = edge.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((p - from).dot(edge) / length2, 0.0, 1.0) : 0.0;
    const double squared = (p - from - share * edge).squaredNorm();
    if (!(squared < least)) continue;
    least = squared;
    closest.setZero();
    closest[k] = 1.0 - share;
    closest[next] = share;
  }
  return closest;
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
  // Of a line the three are rounding, their sum too, and so would be the weights.
  const double total = va + vb + vc;
  if (!(total > 0.0) || !(ab.cross(ac).squaredNorm() > kLine * ab.squaredNorm() * ac.squaredNorm()))
    return closest_on_edges(p, {a, b, c});
  return {va / total, vb / total, vc / total};
}

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh)
    : ClosestPointTree(mesh, [&] {
        std::vector<int> all(static_cast<std::size_t>(mesh.triangle_count()));
        std::iota(all.begin(), all.end(), 0);
        return all;
      }()) {}

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh, const std::vector<int>& triangles)
    : order_(triangles) {
  row_of_.assign(static_cast<std::size_t>(mesh.vertex_count()), -1);
  if (order_.empty()) return;
  std::vector<Eigen::Vector3d> centres(static_cast<std::size_t>(mesh.triangle_count()));
  for (const int t : order_)
    centres[t] = (mesh.vertex(mesh.triangles(t, 0)) + mesh.vertex(mesh.triangles(t, 1)) +
                  mesh.vertex(mesh.triangles(t, 2))) /
                 3.0;
  nodes_.reserve(order_.size() / 2 + 1);
  build(0, static_cast<int>(order_.size()), centres);
  double extent = 0.0;
  int rows = 0;
  place_of_.assign(static_cast<std::size_t>(mesh.triangle_count()), -1);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const auto corners = mesh.triangles.row(order_[k]);
    place_of_[static_cast<std::size_t>(order_[k])] = static_cast<int>(k);
    for (const int vertex : corners)
      if (int& row = row_of_[static_cast<std::size_t>(vertex)]; row < 0) row = rows++;
    const auto row = [&](int c) { return row_of_[static_cast<std::size_t>(corners[c])]; };
    corners_of_.push_back({row(0), row(1), row(2)});
    extent += (mesh.vertices.row(corners[1]) - mesh.vertices.row(corners[0])).cwiseAbs().maxCoeff();
  }
  vertices_.resize(rows, 3);
  place(mesh.vertices);
  most_slack_ = kMostSlack * extent / static_cast<double>(order_.size());
  fit_all();
}

/// Halves the entries of order_ along the longest axis of their centres. @return the first of the second
/// half.
int ClosestPointTree::split(int begin, int end, const std::vector<Eigen::Vector3d>& centres) {
  if (end - begin < 2) return end;
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
  return middle;
}

int ClosestPointTree::build(int begin, int end, const std::vector<Eigen::Vector3d>& centres) {
  const auto index = nodes_.size();
  nodes_.emplace_back();
  int bounds[5] = {begin, begin + 1, begin + 2, begin + 3, end};
  if (end - begin > 4) {
    bounds[2] = split(begin, end, centres);
    bounds[1] = split(begin, bounds[2], centres);
    bounds[3] = split(bounds[2], end, centres);
  }
  for (int k = 0; k < 4; ++k) {
    const int first = bounds[k], last = std::min(bounds[k + 1], end);
    const int child = first >= last ? kAbsent : last - first == 1 ? ~first : build(first, last, centres);
    nodes_[index].child[k] = child;
  }
  return static_cast<int>(index);
}

void ClosestPointTree::fit(Node& node) const {
  for (int k = 0; k < 4; ++k) {
    const int child = node.child[k];
    Eigen::Array3f low = Eigen::Array3f::Constant(kNowhere), high = -low;
    if (child >= 0) {
      const Node& inner = nodes_[child];
      low << inner.low[0].minCoeff(), inner.low[1].minCoeff(), inner.low[2].minCoeff();
      high << inner.high[0].maxCoeff(), inner.high[1].maxCoeff(), inner.high[2].maxCoeff();
    } else if (child != kAbsent) {
      const auto& corners = corners_of_[~child];
      const Eigen::Array3d a = vertices_.row(corners[0]), b = vertices_.row(corners[1]),
                           c = vertices_.row(corners[2]);
      low = below(a.min(b).min(c));
      high = above(a.max(b).max(c));
    }
    for (int axis = 0; axis < 3; ++axis) {
      node.low[axis][k] = low[axis];
      node.high[axis][k] = high[axis];
    }
  }
}

void ClosestPointTree::fit_all() {
  for (std::size_t i = nodes_.size(); i-- > 0;) fit(nodes_[i]);  // children come after their parent
  fitted_ = vertices_;
  slack_.setZero();
}

void ClosestPointTree::place(const Points& vertices) {
  for (std::size_t vertex = 0; vertex < row_of_.size(); ++vertex)
    if (row_of_[vertex] >= 0)
      vertices_.row(row_of_[vertex]) = vertices.row(static_cast<Eigen::Index>(vertex));
}

void ClosestPointTree::refit(const Points& vertices) {
  require(vertices.rows() == std::ssize(row_of_), "refit needs the same vertices, moved");
  if (nodes_.empty()) return;
  place(vertices);
  slack_.setZero();
  for (Eigen::Index i = 0; i < vertices_.rows(); ++i)
    slack_ = slack_.cwiseMax((vertices_.row(i) - fitted_.row(i)).transpose().cwiseAbs());
  if (!(slack_.maxCoeff() <= most_slack_)) fit_all();
}

ClosestPoint ClosestPointTree::closest(const Eigen::Vector3d& query, double radius) const {
  return search(query, radius * radius, {});
}

ClosestPoint ClosestPointTree::closest_from(int near, const Eigen::Vector3d& query) const {
  ClosestPoint best;
  double best_squared = std::numeric_limits<double>::infinity();
  const int at = near >= 0 && !nodes_.empty() ? place_of_[static_cast<std::size_t>(near)] : -1;
  if (at >= 0) offer(near, corners_of_[static_cast<std::size_t>(at)], query, best_squared, best);
  return search(query, best_squared, best);
}

void ClosestPointTree::offer(int triangle, const Corners& corners, const Eigen::Vector3d& query,
                             double& best_squared, ClosestPoint& best) const {
  const Eigen::Vector3d a = vertices_.row(corners[0]).transpose(), b = vertices_.row(corners[1]).transpose(),
                        c = vertices_.row(corners[2]).transpose();
  const Eigen::Vector3d weights = closest_on_triangle(query, a, b, c);
  const Eigen::Vector3d point = weights[0] * a + weights[1] * b + weights[2] * c;
  const double squared = (point - query).squaredNorm();
  // The lower triangle number wins a tie, so that the answer does not depend on the tree's shape.
  if (squared > best_squared || (squared == best_squared && best.triangle >= 0 && triangle >= best.triangle))
    return;
  best_squared = squared;
  best = {triangle, point, weights, 0.0};
}

/// What is still to be looked at, the nearest last.
struct ClosestPointTree::Queue {
  struct Entry {
    int child;
    float squared;  ///< distance to its box
  };
  Entry entries[kStackDepth + 1];  ///< one that is left out again lies behind the last
  int size = 0;

  /// Without a jump for each child: which of them are near enough cannot be foretold. The nearest goes last,
  /// the others as they come. @param squared of each child of the node. Those over the limit are left out.
  void add(const Node& node, const Eigen::Array4f& squared, float limit) {
    const int first = size;
    int nearest = first;
    float least = kNowhere;
    for (int k = 0; k < 4; ++k) {
      entries[size] = {node.child[k], squared[k]};
      const bool is_nearer = squared[k] < least;
      nearest = is_nearer ? size : nearest;
      least = is_nearer ? squared[k] : least;
      size += squared[k] <= limit;
    }
    if (size > first) std::swap(entries[nearest], entries[size - 1]);
  }
};

ClosestPoint ClosestPointTree::search(const Eigen::Vector3d& query, double best_squared,
                                      ClosestPoint best) const {
  if (nodes_.empty()) return best;
  // The query is as much larger as the boxes are too small.
  const Eigen::Array3f low = below(query - slack_), high = above(query + slack_);
  float limit = limit_of(best_squared);
  Queue queue;
  queue.entries[queue.size++] = {0, 0.0F};
  while (queue.size > 0) {
    const Queue::Entry entry = queue.entries[--queue.size];
    if (entry.squared > limit) continue;
    if (entry.child < 0) {
      offer(order_[~entry.child], corners_of_[~entry.child], query, best_squared, best);
      limit = limit_of(best_squared);
      continue;
    }
    const Node& node = nodes_[entry.child];
    Eigen::Array4f squared = Eigen::Array4f::Zero();
    for (int axis = 0; axis < 3; ++axis)
      squared += (node.low[axis] - high[axis]).max(low[axis] - node.high[axis]).max(0.0F).square();
    queue.add(node, squared, limit);
  }
  if (best.triangle >= 0) best.distance = std::sqrt(best_squared);
  return best;
}

ClosestPoint ClosestPointTree::first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                         double t_min, double t_max) const {
  constexpr double kAlong = 1e300;  // over a direction of zero
  ClosestPoint best;
  if (nodes_.empty()) return best;
  Eigen::Vector3d inverse;
  for (int axis = 0; axis < 3; ++axis)
    inverse[axis] = direction[axis] == 0.0 ? kAlong : 1.0 / direction[axis];
  double nearest = t_max;
  int stack[kStackDepth];
  int depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const int at = stack[--depth];
    if (at < 0) {
      meet(order_[~at], corners_of_[~at], origin, direction, t_min, nearest, best);
      continue;
    }
    const Node& node = nodes_[at];
    Eigen::Array4d enter = Eigen::Array4d::Constant(t_min), leave = Eigen::Array4d::Constant(nearest);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Array4d one = (node.low[axis].cast<double>() - (origin[axis] + slack_[axis])) *
                                 inverse[axis],
                           other = (node.high[axis].cast<double>() - (origin[axis] - slack_[axis])) *
                                   inverse[axis];
      enter = enter.max(one.min(other));
      leave = leave.min(one.max(other));
    }
    for (int k = 0; k < 4; ++k)
      if (node.child[k] != kAbsent && enter[k] <= leave[k]) stack[depth++] = node.child[k];
  }
  return best;
}

/// Möller and Trumbore 1997.
void ClosestPointTree::meet(int triangle, const Corners& corners, const Eigen::Vector3d& origin,
                            const Eigen::Vector3d& direction, double t_min, double& nearest,
                            ClosestPoint& best) const {
  const Eigen::Vector3d a = vertices_.row(corners[0]).transpose();
  const Eigen::Vector3d ab = vertices_.row(corners[1]).transpose() - a;
  const Eigen::Vector3d ac = vertices_.row(corners[2]).transpose() - a;
  const Eigen::Vector3d p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (determinant == 0.0) return;
  const Eigen::Vector3d s = origin - a, q = s.cross(ab);
  const double u = s.dot(p) / determinant, v = direction.dot(q) / determinant, at = ac.dot(q) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || !(at > t_min) || at > nearest) return;
  // The lower triangle number wins a tie, as for the closest point.
  if (at == nearest && (best.triangle < 0 || triangle >= best.triangle)) return;
  nearest = at;
  best = {triangle, origin + at * direction, {1.0 - u - v, u, v}, at};
}

}  // namespace glisson
