// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/member.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/label_map.h"

namespace glisson::atlas {
namespace {

constexpr int kLeastContact = 20;       // points of an area
constexpr double kTrim = 0.02;          // share of an area's points beyond either end
constexpr double kLeastLiver = 200e-6;  // cubic metres
constexpr double kCrumb = 0.02;         // share of the area that a second piece may have unsaid
constexpr double kHanging = 0.004;      // metres, between points of one contact
constexpr int kMarginToNotch = 26;      // number of the margin's point at the notch

const TriangleMesh* surface_of(const PatientModel& model, Label structure) {
  for (const NamedSurface& surface : model.surfaces)
    if (surface.structure == structure && surface.mesh.triangle_count() > 0) return &surface.mesh;
  return nullptr;
}

/// Middles of the slabs into which an area is cut along a direction. Empty: it has no length there.
Points middle_line(const Points& area, const Eigen::Vector3d& along, int count) {
  const Eigen::VectorXd at = area * along;
  std::vector<double> sorted(at.data(), at.data() + at.size());
  std::sort(sorted.begin(), sorted.end());
  const double low = interpolated_percentile(sorted, kTrim),
               high = interpolated_percentile(sorted, 1 - kTrim);
  if (!(high > low)) return Points(0, 3);
  Points sums = Points::Zero(count, 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < area.rows(); ++i) {
    const double share = (at[i] - low) / (high - low);
    if (share < 0.0 || share > 1.0) continue;
    const int slab = std::min(count - 1, static_cast<int>(share * count));
    sums.row(slab) += area.row(i);
    weights[slab] += 1.0;
  }
  if (weights.minCoeff() < 1.0) return Points(0, 3);  // torn: two contacts, or hardly one
  return weights.cwiseInverse().asDiagonal() * sums;
}

/// The direction in which points spread most.
Eigen::Vector3d long_axis(const Points& points) {
  const Points centred = points.rowwise() - points.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centred.transpose() * centred);
  return solver.eigenvectors().col(2);
}

Points reversed_unless(bool in_order, const Points& line) {
  return in_order ? line : Points(line.colwise().reverse());
}

/// The line cut at the point closest to the notch; either side resampled.
Points margin_points(const Points& line, const Points& notch, const Eigen::Vector3d& left) {
  if (line.rows() < 10 || notch.rows() == 0) return Points(0, 3);
  const Points fine =
      resampled(reversed_unless((line.row(0) - line.row(line.rows() - 1)) * left < 0.0, line), 400);
  Eigen::Index at = 0;
  (fine.rowwise() - notch.colwise().mean()).rowwise().squaredNorm().minCoeff(&at);
  if (at < 20 || at > fine.rows() - 20) return Points(0, 3);  // does not pass the notch
  const int count = point_count(Structure::anterior_margin);
  Points points(count, 3);
  points.topRows(kMarginToNotch + 1) = resampled(fine.topRows(at + 1), kMarginToNotch + 1);
  points.bottomRows(count - kMarginToNotch) =
      resampled(fine.bottomRows(fine.rows() - at), count - kMarginToNotch);
  return points;
}

Eigen::Vector3d normal_of(const TriangleMesh& surface, int triangle) {
  const Eigen::Vector3d a = surface.vertex(surface.triangles(triangle, 0));
  return (surface.vertex(surface.triangles(triangle, 1)) - a)
      .cross(surface.vertex(surface.triangles(triangle, 2)) - a)
      .normalized();
}

/// As of one disc.
double area_of_holes(const TriangleMesh& mesh) {
  double rim = 0.0;
  for (const Edge& edge : edges(mesh))
    if (edge.right < 0) rim += (mesh.vertex(edge.a) - mesh.vertex(edge.b)).norm();
  return rim * rim / (4.0 * std::numbers::pi);
}

/// The most points that hang together.
Points largest_cluster(const Points& points) {
  std::vector<int> cluster_of(static_cast<std::size_t>(points.rows()), -1);
  std::vector<Eigen::Index> best;
  for (Eigen::Index start = 0; start < points.rows(); ++start) {
    if (cluster_of[static_cast<std::size_t>(start)] >= 0) continue;
    std::vector<Eigen::Index> cluster{start};
    cluster_of[static_cast<std::size_t>(start)] = static_cast<int>(start);
    for (std::size_t next = 0; next < cluster.size(); ++next)
      for (Eigen::Index j = 0; j < points.rows(); ++j) {
        if (cluster_of[static_cast<std::size_t>(j)] >= 0 ||
            (points.row(j) - points.row(cluster[next])).squaredNorm() > kHanging * kHanging)
          continue;
        cluster_of[static_cast<std::size_t>(j)] = static_cast<int>(start);
        cluster.push_back(j);
      }
    if (cluster.size() > best.size()) best = std::move(cluster);
  }
  Points chosen(static_cast<Eigen::Index>(best.size()), 3);
  for (std::size_t i = 0; i < best.size(); ++i)
    chosen.row(static_cast<Eigen::Index>(i)) = points.row(best[i]);
  return chosen;
}

}  // namespace

bool is_area(Structure structure) {
  return structure == Structure::vena_cava || structure == Structure::gallbladder_bed;
}

Points contact(const TriangleMesh& liver, const TriangleMesh& other, double reach) {
  const ClosestPointTree tree(other);
  std::vector<int> touching;
  for (int v = 0; v < liver.vertex_count(); ++v)
    if (tree.closest(liver.vertex(v), reach).triangle >= 0) touching.push_back(v);
  Points points(static_cast<Eigen::Index>(touching.size()), 3);
  for (std::size_t i = 0; i < touching.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = liver.vertices.row(touching[i]);
  return points;
}

Member member_of(const std::string& name, const PatientModel& model, const Landmarks& placed) {
  const TriangleMesh* liver = surface_of(model, structure::kParenchyma);
  if (liver == nullptr)
    throw InputError(name, "liver", "has no fine surface", "Build the model from labels or surfaces");
  Member member{name, *liver, {}};
  if (placed.umbilical_notch.rows() > 0)
    member.structures[Structure::umbilical_notch] = placed.umbilical_notch;
  if (placed.anterior_margin.rows() > 0)
    member.structures[Structure::anterior_margin] = placed.anterior_margin;
  if (const TriangleMesh* cava = surface_of(model, structure::kVenaCava))
    member.structures[Structure::vena_cava] = contact(*liver, *cava);
  else if (placed.vena_cava.rows() > 0)
    member.structures[Structure::vena_cava] = placed.vena_cava;
  if (const TriangleMesh* bladder = surface_of(model, structure::kGallbladder))
    member.structures[Structure::gallbladder_bed] = contact(*liver, *bladder);
  if (const TriangleMesh* portal = surface_of(model, structure::kPortalVein)) {
    const Points entrance = largest_cluster(contact(*liver, *portal));
    if (entrance.rows() > 0) member.structures[Structure::portal_entrance] = entrance.colwise().mean();
  }
  return member;
}

PreparedLiver prepare(const TriangleMesh& liver, const std::string& name) {
  if (liver.triangle_count() == 0)
    throw InputError(name, "liver", "has no surface", "Give the closed surface of the liver");
  check_liver_size(liver.vertices, LengthUnit::metre, name);
  PreparedLiver prepared;
  std::vector<TriangleMesh> pieces = split_components(liver);
  std::sort(pieces.begin(), pieces.end(),
            [](const TriangleMesh& a, const TriangleMesh& b) { return area(a) > area(b); });
  prepared.mesh = std::move(pieces.front());
  const double own = area(prepared.mesh);
  double left_out = 0.0;
  long large = 1;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (area(pieces[i]) <= kCrumb * own) continue;
    ++large;
    left_out += area(pieces[i]);
  }
  if (large > 1) prepared.doubts.push_back("atlas.several_pieces " + std::to_string(large));
  if (!is_closed(prepared.mesh)) {
    prepared.doubts.emplace_back("atlas.open_surface");
    left_out += area_of_holes(prepared.mesh);
  } else {
    const double inside = volume(prepared.mesh);
    if (inside < 0.0) prepared.mesh.triangles.col(1).swap(prepared.mesh.triangles.col(2));
    if (std::abs(inside) < kLeastLiver)
      throw InputError(name, "liver", "holds " + std::to_string(std::lround(std::abs(inside) * 1e6)) + " ml",
                       "Give the whole liver's surface");
  }
  prepared.lacking = left_out / (left_out + own);
  return prepared;
}

Points resampled(const Points& line, int count) {
  require(line.rows() >= 2 && count >= 2, "a line has two points at least");
  std::vector<double> at{0.0};
  for (Eigen::Index i = 1; i < line.rows(); ++i)
    at.push_back(at.back() + (line.row(i) - line.row(i - 1)).norm());
  Points points(count, 3);
  std::size_t segment = 0;
  for (int i = 0; i < count; ++i) {
    const double wanted = at.back() * i / (count - 1);
    while (segment + 2 < at.size() && at[segment + 1] < wanted) ++segment;
    const double width = at[segment + 1] - at[segment];
    const double share = width > 0.0 ? std::clamp((wanted - at[segment]) / width, 0.0, 1.0) : 0.0;
    const auto row = static_cast<Eigen::Index>(segment);
    points.row(i) = line.row(row) + share * (line.row(row + 1) - line.row(row));
  }
  return points;
}

Points ordered_points(Structure structure, const Points& raw, const Eigen::Matrix3d& upright,
                      const Points& notch) {
  const int count = point_count(structure);
  const Eigen::Vector3d left = upright.row(0), back = upright.row(1), head = upright.row(2);
  switch (structure) {
    case Structure::umbilical_notch:
    case Structure::portal_entrance:
      return raw.rows() == 0 ? raw : Points(raw.colwise().mean());
    case Structure::falciform_line:
      if (raw.rows() < 2) return Points(0, 3);
      return resampled(reversed_unless((raw.row(0) - raw.row(raw.rows() - 1)) * back < 0.0, raw), count);
    case Structure::anterior_margin:
      return margin_points(raw, notch, left);
    case Structure::vena_cava:
      return raw.rows() < kLeastContact ? Points(0, 3) : middle_line(raw, head, count);
    case Structure::gallbladder_bed: {
      if (raw.rows() < kLeastContact) return Points(0, 3);
      const Eigen::Vector3d axis = long_axis(raw);
      return middle_line(raw, axis.dot(back) < 0.0 ? axis : Eigen::Vector3d(-axis), count);
    }
  }
  return Points(0, 3);
}

Places places_of(const TriangleMesh& surface, const Points& points, double size) {
  const ClosestPointTree tree(surface);
  Places places;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = points.row(i);
    const ClosestPoint at = tree.closest(p);
    places.push_back(
        {at.triangle, at.barycentric, (p - at.point).dot(normal_of(surface, at.triangle)) / size});
  }
  return places;
}

Points points_at(const Places& places, const TriangleMesh& surface, double size) {
  Points points(static_cast<Eigen::Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& place = places[i];
    Eigen::Vector3d p = place.height * size * normal_of(surface, place.triangle);
    for (int k = 0; k < 3; ++k)
      p += place.barycentric[k] * surface.vertex(surface.triangles(place.triangle, k));
    points.row(static_cast<Eigen::Index>(i)) = p;
  }
  return points;
}

}  // namespace glisson::atlas
