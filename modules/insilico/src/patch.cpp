// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <queue>

#include "glisson/core/error.h"
#include "glisson/geometry/topology.h"
#include "operator_hand.h"

namespace glisson::insilico {
namespace {

struct Face {
  Eigen::Vector3d centre;
  double area = 0.0;
  /// 0: seen from the camera; 1: faces it; 2: neither. Of several cameras: the first that sees it.
  int tier = 2;
  std::vector<int> neighbours;
};

constexpr double kFacing = 0.1;  ///< cosine: a flatter triangle shows nothing

/// Their tiers are not told yet.
std::vector<Face> faces_of(const TriangleMesh& surface) {
  const Eigen::VectorXd areas = triangle_areas(surface);
  std::vector<Face> faces(static_cast<std::size_t>(surface.triangle_count()));
  for (int t = 0; t < surface.triangle_count(); ++t) {
    Face& face = faces[static_cast<std::size_t>(t)];
    face.centre = (surface.vertex(surface.triangles(t, 0)) + surface.vertex(surface.triangles(t, 1)) +
                   surface.vertex(surface.triangles(t, 2))) /
                  3.0;
    face.area = areas[t];
  }
  for (const Edge& edge : edges(surface)) {
    if (edge.left < 0 || edge.right < 0) continue;
    faces[static_cast<std::size_t>(edge.left)].neighbours.push_back(edge.right);
    faces[static_cast<std::size_t>(edge.right)].neighbours.push_back(edge.left);
  }
  return faces;
}

/// Cosine of the angle under which each triangle is seen; below 0: from behind.
std::vector<double> facing(const std::vector<Face>& faces, const Points& normals,
                           const Eigen::Vector3d& eye) {
  std::vector<double> cosines;
  cosines.reserve(faces.size());
  for (std::size_t t = 0; t < faces.size(); ++t)
    cosines.push_back(-normals.row(static_cast<Eigen::Index>(t)).dot((faces[t].centre - eye).normalized()));
  return cosines;
}

int first_face(const std::vector<Face>& faces, const Eigen::Vector3d& start) {
  int best = -1;
  for (int tier = 0; tier < 3 && best < 0; ++tier) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < faces.size(); ++t) {
      const double d = (faces[t].centre - start).squaredNorm();
      if (faces[t].tier <= tier && d < nearest) nearest = d, best = static_cast<int>(t);
    }
  }
  return best;
}

/// Dijkstra over the faces; a worse tier waits until the better ones are used up. @param worst that is taken.
std::vector<int> grow(const std::vector<Face>& faces, int start, double wanted_area, int worst) {
  using Entry = std::tuple<int, double, int>;  // worst tier on the way, length of the way, face
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<char> taken(faces.size(), 0);
  std::vector<int> patch;
  open.emplace(faces[static_cast<std::size_t>(start)].tier, 0.0, start);
  double area = 0.0;
  while (!open.empty() && area < wanted_area) {
    const auto [tier, length, t] = open.top();
    open.pop();
    if (taken[static_cast<std::size_t>(t)] != 0) continue;
    taken[static_cast<std::size_t>(t)] = 1;
    const Face& face = faces[static_cast<std::size_t>(t)];
    patch.push_back(t);
    area += face.area;
    for (const int other : face.neighbours) {
      const Face& next = faces[static_cast<std::size_t>(other)];
      if (taken[static_cast<std::size_t>(other)] == 0 && next.tier <= worst)
        open.emplace(std::max(tier, next.tier), length + (next.centre - face.centre).norm(), other);
    }
  }
  std::sort(patch.begin(), patch.end());
  return patch;
}

double distance_to_line(const Points& line, const Eigen::Vector3d& p) {
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
    const Eigen::Vector3d a = line.row(i).transpose(), edge = line.row(i + 1).transpose() - a;
    const double along = std::clamp((p - a).dot(edge) / std::max(edge.squaredNorm(), 1e-18), 0.0, 1.0);
    best = std::min(best, (a + along * edge - p).norm());
  }
  return best;
}

Feature feature_of(const Eigen::Vector3d& p, const Points& margin, const Points& notch,
                   const PatchOptions& options) {
  for (Eigen::Index i = 0; i < notch.rows(); ++i)
    if ((notch.row(i).transpose() - p).norm() < 1e-3 * options.notch_mm) return Feature::umbilical_notch;
  return distance_to_line(margin, p) < 1e-3 * options.margin_mm ? Feature::anterior_margin : Feature::surface;
}

}  // namespace

void PatchOptions::validate() const {
  const OptionCheck check("patch");
  check(share > 0.0 && share <= 1.0, "share", share, "give a share of the surface in (0, 1]");
  check(density_per_cm2 > 0.0 && density_per_cm2 <= 1000.0, "density_per_cm2", density_per_cm2,
        "give more than 0, up to 1000 points per cm2");
  check(noise_mm >= 0.0 && noise_mm <= 20.0, "noise_mm", noise_mm, "give 0 to 20 mm");
  check(outlier_share >= 0.0 && outlier_share < 1.0, "outlier_share", outlier_share,
        "give a share in [0, 1)");
  check(holes >= 0 && hole_mm >= 0.0, "holes", holes, "give a number and a diameter of 0 or more");
  check(margin_mm >= 0.0 && notch_mm >= 0.0, "margin_mm", margin_mm, "give a width of 0 or more");
}

namespace {

double area_of(const std::vector<Face>& faces, const std::vector<int>& which) {
  double area = 0.0;
  for (const int t : which) area += faces[static_cast<std::size_t>(t)].area;
  return area;
}

double area_of(const std::vector<Face>& faces) {
  double area = 0.0;
  for (const Face& face : faces) area += face.area;
  return area;
}

/// Points of the faces named.
LabelledCloud sampled(const TriangleMesh& surface, const std::vector<Face>& faces,
                      const std::vector<int>& patch, const Points& margin, const Points& notch,
                      const PatchOptions& options, Hand& hand) {
  std::vector<double> up_to;  // area up to each face, for the lottery
  up_to.reserve(patch.size());
  for (double sum = 0.0; const int t : patch) up_to.push_back(sum += faces[static_cast<std::size_t>(t)].area);
  const auto draw_face = [&] {
    const auto hit = std::lower_bound(up_to.begin(), up_to.end(), hand.uniform() * up_to.back());
    return patch[static_cast<std::size_t>(std::min(hit - up_to.begin(), std::ssize(up_to) - 1))];
  };
  std::vector<Eigen::Vector3d> holes;
  holes.reserve(static_cast<std::size_t>(options.holes));
  for (int h = 0; h < options.holes; ++h)
    holes.push_back(faces[static_cast<std::size_t>(draw_face())].centre);

  const auto count =
      static_cast<Eigen::Index>(std::lround(1e4 * area_of(faces, patch) * options.density_per_cm2));
  LabelledCloud cloud;
  cloud.points.resize(count, 3);
  cloud.features.reserve(static_cast<std::size_t>(count));
  cloud.sigma.reserve(static_cast<std::size_t>(count));
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < count; ++i) {
    const int t = draw_face();
    const double root = std::sqrt(hand.uniform()), v = hand.uniform();
    const Eigen::Vector3d p = (1.0 - root) * surface.vertex(surface.triangles(t, 0)) +
                              root * (1.0 - v) * surface.vertex(surface.triangles(t, 1)) +
                              root * v * surface.vertex(surface.triangles(t, 2));
    const bool hole = std::any_of(holes.begin(), holes.end(), [&](const Eigen::Vector3d& h) {
      return (p - h).norm() < 0.5e-3 * options.hole_mm;
    });
    const Eigen::Vector3d noise = 1e-3 * options.noise_mm * hand.tremor3();
    const bool outlier = hand.uniform() < options.outlier_share;
    const double far = 0.005 + 0.010 * hand.uniform();
    const Eigen::Vector3d astray = far * hand.tremor3().normalized();
    if (hole) continue;
    cloud.points.row(kept++) = (p + (outlier ? astray : noise)).transpose();
    cloud.features.push_back(feature_of(p, margin, notch, options));
    cloud.sigma.push_back(1e-3 * options.noise_mm);
  }
  cloud.points.conservativeResize(kept, 3);
  return cloud;
}

}  // namespace

Patch sample_patch(const TriangleMesh& surface, const RayCaster& caster, const Eigen::Vector3d& start,
                   const Points& margin, const Points& notch, const PatchOptions& options) {
  options.validate();
  Hand hand(options.seed);
  std::vector<Face> faces = faces_of(surface);
  const std::vector<double> cosines = facing(faces, triangle_normals(surface), Eigen::Vector3d::Zero());
  for (std::size_t t = 0; t < faces.size(); ++t) {
    if (cosines[t] > 0.0) faces[t].tier = 1;
    if (cosines[t] > kFacing && caster.sees(Eigen::Vector3d::Zero(), faces[t].centre)) faces[t].tier = 0;
  }
  const double total = area_of(faces);
  const std::vector<int> patch = grow(faces, first_face(faces, start), options.share * total, 2);
  return {sampled(surface, faces, patch, margin, notch, options, hand), area_of(faces, patch) / total};
}

std::vector<Patch> sample_looks(const TriangleMesh& surface, const RayCaster& caster,
                                const Eigen::Vector3d& start, const Points& margin, const Points& notch,
                                const PatchOptions& options, const std::vector<Eigen::Vector3d>& eyes) {
  options.validate();
  Hand hand(options.seed);
  constexpr double kAdds = 0.01;  // of the surface: a look that shows less anew is not taken
  std::vector<Face> faces = faces_of(surface);
  const int count = static_cast<int>(eyes.size());
  for (Face& face : faces) face.tier = count;
  const Points normals = triangle_normals(surface);
  std::vector<std::vector<char>> seen(eyes.size(), std::vector<char>(faces.size(), 0));
  for (int look = count - 1; look >= 0; --look) {
    const Eigen::Vector3d& eye = eyes[static_cast<std::size_t>(look)];
    const std::vector<double> cosines = facing(faces, normals, eye);
    for (std::size_t t = 0; t < faces.size(); ++t)
      if (cosines[t] > kFacing && caster.sees(eye, faces[t].centre))
        seen[static_cast<std::size_t>(look)][t] = 1, faces[t].tier = look;
  }
  require(std::ranges::any_of(faces, [](const Face& face) { return face.tier == 0; }),
          "the first camera sees the organ");
  const double total = area_of(faces);
  const std::vector<int> patch = grow(faces, first_face(faces, start), options.share * total, count - 1);
  std::vector<double> anew(eyes.size(), 0.0);
  for (const int t : patch)
    anew[static_cast<std::size_t>(faces[static_cast<std::size_t>(t)].tier)] +=
        faces[static_cast<std::size_t>(t)].area;
  std::vector<Patch> looks(eyes.size());
  for (std::size_t look = 0; look < eyes.size(); ++look) {
    if (look > 0 && anew[look] < kAdds * total) continue;
    std::vector<int> mine;
    std::copy_if(patch.begin(), patch.end(), std::back_inserter(mine),
                 [&](int t) { return seen[look][static_cast<std::size_t>(t)] != 0; });
    looks[look] = {sampled(surface, faces, mine, margin, notch, options, hand), area_of(faces, mine) / total};
  }
  return looks;
}

}  // namespace glisson::insilico
