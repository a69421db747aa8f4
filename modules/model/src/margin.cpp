// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>

#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/topology.h"
#include "glisson/model/build.h"
#include "margin_search.h"

namespace glisson::model {
namespace {

/// Meshes with a longer mean edge (metres) are subdivided; the surface stays the same.
constexpr double kLongestEdge = 0.005;
constexpr double kSeedDeviations = 1.5, kExtensionDeviations = 0.5;  // above the mean, of the whole mesh
constexpr double kLeastSeed = 0.12;  // spread of two planes that meet at 123 degrees
constexpr double kLeastExtension = 0.06;
constexpr double kLeastLength = 0.05;  // metres; shorter ridges are dropped
constexpr double kSpacing = 0.003;     // metres, of the polyline
constexpr double kWrongSide = 0.15;    // cosine: normals farther from the wanted direction are no margin
constexpr double kPullToRidge = 8.0;   // how much dearer a path beside the ridge is

struct Reach {
  std::vector<double> cost;
  std::vector<int> from;
};

/// Dijkstra over the vertices of one ridge. @param sharp empty: plain lengths.
Reach reach(const TriangleMesh& mesh, const std::vector<std::vector<int>>& neighbours,
            const std::vector<int>& ridge_of, int start, const std::vector<double>& dearness) {
  Reach result{std::vector<double>(ridge_of.size(), std::numeric_limits<double>::infinity()),
               std::vector<int>(ridge_of.size(), -1)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  result.cost[start] = 0.0;
  heap.emplace(0.0, start);
  while (!heap.empty()) {
    const auto [cost, v] = heap.top();
    heap.pop();
    if (cost > result.cost[v]) continue;
    for (const int w : neighbours[v]) {
      if (ridge_of[w] != ridge_of[start]) continue;
      const double length = (mesh.vertex(v) - mesh.vertex(w)).norm();
      const double next = cost + length * (dearness.empty() ? 1.0 : 0.5 * (dearness[v] + dearness[w]));
      if (next >= result.cost[w]) continue;
      result.cost[w] = next;
      result.from[w] = v;
      heap.emplace(next, w);
    }
  }
  return result;
}

int farthest(const Reach& reached) {
  int best = -1;
  for (std::size_t v = 0; v < reached.cost.size(); ++v)
    if (std::isfinite(reached.cost[v]) && (best < 0 || reached.cost[v] > reached.cost[best]))
      best = static_cast<int>(v);
  return best;
}

/// Of a vertex, to where the image ends inside the organ.
enum class Place : char {
  on_cut,  ///< the patch around it may hold some of the cut: its sharpness tells nothing
  beside_cut,
  away
};

std::vector<Place> places(const TriangleMesh& mesh, const TriangleMesh& cut) {
  std::vector<Place> place(static_cast<std::size_t>(mesh.vertex_count()), Place::away);
  const ClosestPointTree tree(cut);
  if (tree.empty()) return place;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double distance = tree.closest(mesh.vertex(v), kSharpnessRadius + kLongestEdge).distance;
    if (distance <= kSharpnessRadius)
      place[static_cast<std::size_t>(v)] = Place::on_cut;
    else if (std::isfinite(distance))
      place[static_cast<std::size_t>(v)] = Place::beside_cut;
  }
  return place;
}

/// Seeds above one threshold, extended over all that is above a lower one and hangs together: the number of
/// the ridge at each vertex, -1 for none. The thresholds come from all that is not on the cut.
std::vector<int> ridges(const std::vector<std::vector<int>>& neighbours, const std::vector<double>& sharp,
                        const std::vector<Place>& place, int& count) {
  double mean = 0.0, square = 0.0, number = 0.0;
  for (std::size_t v = 0; v < sharp.size(); ++v) {
    if (place[v] == Place::on_cut) continue;
    const double s = std::max(0.0, sharp[v]);
    mean += s;
    square += s * s;
    number += 1.0;
  }
  count = 0;
  if (number == 0.0) return std::vector<int>(sharp.size(), -1);
  mean /= number;
  const double deviation = std::sqrt(std::max(0.0, square / number - mean * mean));
  const double seed = std::max(kLeastSeed, mean + kSeedDeviations * deviation);
  const double extension = std::max(kLeastExtension, mean + kExtensionDeviations * deviation);
  std::vector<int> ridge_of(sharp.size(), -1);
  for (std::size_t start = 0; start < sharp.size(); ++start) {
    if (sharp[start] < seed || ridge_of[start] >= 0) continue;
    std::vector<int> members{static_cast<int>(start)};
    ridge_of[start] = count;
    for (std::size_t next = 0; next < members.size(); ++next)
      for (const int w : neighbours[members[next]]) {
        if (ridge_of[w] >= 0 || sharp[w] < extension) continue;
        ridge_of[w] = count;
        members.push_back(w);
      }
    ++count;
  }
  return ridge_of;
}

/// Points at even distances along a polyline.
Points evenly_spaced(const std::vector<Eigen::Vector3d>& line, double spacing) {
  std::vector<double> at{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) at.push_back(at.back() + (line[i] - line[i - 1]).norm());
  const int count = std::max(1, static_cast<int>(std::lround(at.back() / spacing)));
  Points points(count + 1, 3);
  std::size_t segment = 0;
  for (int i = 0; i <= count; ++i) {
    const double wanted = at.back() * i / count;
    while (segment + 2 < at.size() && at[segment + 1] < wanted) ++segment;
    const double width = at[segment + 1] - at[segment];
    const double share = width > 0.0 ? std::clamp((wanted - at[segment]) / width, 0.0, 1.0) : 0.0;
    points.row(i) = (line[segment] + share * (line[segment + 1] - line[segment])).transpose();
  }
  return points;
}

/// Takes the vertices' zigzag away and puts the line back on the surface.
Points smoothed(Points line, const TriangleMesh& surface) {
  for (int pass = 0; pass < 4; ++pass) {
    const Points before = line;
    for (Eigen::Index i = 1; i + 1 < line.rows(); ++i)
      line.row(i) = 0.25 * before.row(i - 1) + 0.5 * before.row(i) + 0.25 * before.row(i + 1);
  }
  const ClosestPointTree tree(surface);
  for (Eigen::Index i = 0; i < line.rows(); ++i)
    line.row(i) = tree.closest(line.row(i).transpose()).point.transpose();
  return line;
}

/// A ridge that runs into the cut ends there as broad as it is, and a corner of that end lies farthest away:
/// the sharpest place beside the cut is where its crest ends.
int on_crest(const TriangleMesh& mesh, const std::vector<int>& ridge_of, const std::vector<double>& sharp,
             const std::vector<Place>& place, int end) {
  if (place[end] == Place::away) return end;
  int best = end;
  for (std::size_t v = 0; v < sharp.size(); ++v)
    if (ridge_of[v] == ridge_of[end] && place[v] == Place::beside_cut && sharp[v] > sharp[best] &&
        (mesh.vertex(static_cast<int>(v)) - mesh.vertex(end)).norm() < 2.0 * kSharpnessRadius)
      best = static_cast<int>(v);
  return best;
}

/// Along the sharpest way between the two ends of a ridge that lie farthest apart.
std::vector<int> crest(const TriangleMesh& mesh, const std::vector<std::vector<int>>& neighbours,
                       const std::vector<int>& ridge_of, int member, const std::vector<double>& sharp,
                       const std::vector<Place>& place) {
  const auto end_from = [&](int start) {
    return on_crest(mesh, ridge_of, sharp, place, farthest(reach(mesh, neighbours, ridge_of, start, {})));
  };
  const int first = end_from(member), last = end_from(first);
  double sharpest = 0.0;
  for (std::size_t v = 0; v < sharp.size(); ++v)
    if (ridge_of[v] == ridge_of[member]) sharpest = std::max(sharpest, sharp[v]);
  std::vector<double> dearness(sharp.size());
  for (std::size_t v = 0; v < sharp.size(); ++v)
    dearness[v] = std::exp(kPullToRidge * (1.0 - std::clamp(sharp[v] / sharpest, 0.0, 1.0)));
  const Reach way = reach(mesh, neighbours, ridge_of, first, dearness);
  std::vector<int> path{last};
  while (path.back() != first) path.push_back(way.from[path.back()]);
  return path;
}

}  // namespace

MarginSearch::MarginSearch(const TriangleMesh& surface, const Eigen::Vector3d& inferior_anterior)
    : surface_(surface),
      mesh_(refined(surface, kLongestEdge)),
      sharpness_(mesh_),
      neighbours_(vertex_neighbours(mesh_)),
      wanted_(inferior_anterior.norm() > 0.0 ? inferior_anterior.normalized().eval()
                                             : Eigen::Vector3d::Zero().eval()),
      sharp_(sharpness_.value()) {
  // What faces the wrong way is left out only now: the thresholds come from the whole mesh.
  if (wanted_.norm() > 0.0)
    for (std::size_t v = 0; v < sharp_.size(); ++v)
      if (sharpness_.normal(static_cast<int>(v)).dot(wanted_) < kWrongSide)
        sharp_[v] = std::min(sharp_[v], 0.0);
}

Points MarginSearch::margin(const TriangleMesh& cut) const {
  std::vector<double> sharp = sharp_;
  const std::vector<Place> place = places(mesh_, cut);
  for (std::size_t v = 0; v < sharp.size(); ++v)
    if (place[v] == Place::on_cut) sharp[v] = std::min(sharp[v], 0.0);
  int count = 0;
  const std::vector<int> ridge_of = ridges(neighbours_, sharp, place, count);

  std::vector<Eigen::Vector3d> best;
  double best_score = 0.0;
  for (int ridge = 0; ridge < count; ++ridge) {
    const auto member =
        static_cast<int>(std::find(ridge_of.begin(), ridge_of.end(), ridge) - ridge_of.begin());
    const std::vector<int> path = crest(mesh_, neighbours_, ridge_of, member, sharp, place);
    double length = 0.0, score = 0.0;
    std::vector<Eigen::Vector3d> line{mesh_.vertex(path.front())};
    for (std::size_t i = 1; i < path.size(); ++i) {
      line.push_back(mesh_.vertex(path[i]));
      const double step = (line[i] - line[i - 1]).norm();
      length += step;
      score += step * (wanted_.norm() > 0.0 ? 0.5 + sharpness_.normal(path[i]).dot(wanted_) : 1.0);
    }
    if (length < kLeastLength || score <= best_score) continue;
    best_score = score;
    best = std::move(line);
  }
  if (best.size() < 2) return Points(0, 3);
  // The end farther from the middle of the organ comes first, whatever the frame.
  const Eigen::Vector3d middle = centroid(surface_);
  if ((best.back() - middle).norm() > (best.front() - middle).norm()) std::reverse(best.begin(), best.end());
  return smoothed(evenly_spaced(best, kSpacing), surface_);
}

Points detect_anterior_margin(const TriangleMesh& surface, const Eigen::Vector3d& inferior_anterior,
                              const TriangleMesh& cut) {
  if (surface.triangle_count() == 0) return Points(0, 3);
  return MarginSearch(surface, inferior_anterior).margin(cut);
}

}  // namespace glisson::model
