// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Random.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "glisson/core/error.h"
#include "manifold_boundary.h"

namespace glisson::model {
namespace {

namespace parameters = CGAL::parameters;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point3 = Kernel::Point_3;
using LabelledDomain = CGAL::Labeled_mesh_domain_3<Kernel>;

constexpr double kFacetAngle = 25.0;  // degrees; 30 is the limit of the theory
constexpr double kRadiusEdge = 2.0;
constexpr double kFacetDistance = 0.15;     // of the edge: chord error on a curved surface
constexpr double kLeastDihedral = 10.0;     // degrees: no worse cell is put in to mend the boundary
constexpr double kSliverBound = 12.0;       // degrees: what perturb and exude aim at
constexpr long kMostQueries = 300'000'000;  // a liver of 5000 nodes takes some ten million
constexpr int kPollEvery = 4096;            // label queries between two looks at the cancel flag

/// Leaves CGAL from inside a query; caught in fill_with_tetrahedra.
struct Cancelled {};

/// Coordinates in CGAL are millimetres about the body's centre.
struct Placement {
  Eigen::Vector3d centre;
  Eigen::Vector3d in_ct(const Point3& p) const {
    return centre + 1e-3 * Eigen::Vector3d(p.x(), p.y(), p.z());
  }
  Point3 out_of_ct(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d q = 1e3 * (p - centre);
    return {q.x(), q.y(), q.z()};
  }
};

/// 0: outside; 1: body; 2 + n: inclusion n.
int subdomain_at(const MesherInput& input, const Eigen::Vector3d& p) {
  if (input.body.at(p) <= 0.0) return 0;
  for (std::size_t n = 0; n < input.inclusions.size(); ++n) {
    const ScalarField& field = input.inclusions[n].second;
    // low() and high() are samples: the zero level lies up to a cell beyond them.
    const double cell = 1e-3 * field.grid().spacing_mm.norm();
    if ((p.array() >= field.low().array() - cell).all() && (p.array() <= field.high().array() + cell).all() &&
        field.at(p) > 0.0)
      return static_cast<int>(n) + 2;
  }
  return 1;
}

/// CGAL's own first points come from random rays about the centre, which miss small lesions. These are shot
/// from the deepest point of every sub-domain in the directions of an icosahedron.
class Domain : public LabelledDomain {
 public:
  template <class Function>
  Domain(const Function& function, double radius_mm, CGAL::Random* random,
         std::vector<std::pair<Point3, Index>> first)
      : LabelledDomain(function, Kernel::Sphere_3(CGAL::ORIGIN, radius_mm * radius_mm),
                       parameters::relative_error_bound = 1e-6, parameters::p_rng = random),
        first_(std::move(first)) {}

  struct Construct_initial_points {  // NOLINT: CGAL asks for this name
    const std::vector<std::pair<Point3, Index>>& first;
    template <class Output>
    Output operator()(Output output, int = 0) const {
      return std::copy(first.begin(), first.end(), output);
    }
  };
  Construct_initial_points construct_initial_points_object() const { return {first_}; }

 private:
  std::vector<std::pair<Point3, Index>> first_;
};

using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Sequential_tag>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

std::vector<Eigen::Vector3d> icosahedron() {
  const double g = std::numbers::phi;
  std::vector<Eigen::Vector3d> directions;
  for (const double s : {-1.0, 1.0})
    for (const double t : {-g, g}) {
      directions.push_back(Eigen::Vector3d(0.0, s, t).normalized());
      directions.push_back(Eigen::Vector3d(s, t, 0.0).normalized());
      directions.push_back(Eigen::Vector3d(t, 0.0, s).normalized());
    }
  return directions;
}

/// Points on the boundaries of every sub-domain.
std::vector<std::pair<Point3, Domain::Index>> first_points(const MesherInput& input, const Placement& place,
                                                           double radius) {
  std::vector<std::pair<Point3, Domain::Index>> points;
  const auto shoot_from = [&](const Eigen::Vector3d& origin, double step) {
    const int start = subdomain_at(input, origin);
    for (const Eigen::Vector3d& direction : icosahedron()) {
      double inside = 0.0, outside = step;
      while (outside < 3.0 * radius && subdomain_at(input, origin + outside * direction) == start) {
        inside = outside;
        outside += step;
      }
      for (int pass = 0; pass < 40; ++pass) {
        const double middle = 0.5 * (inside + outside);
        (subdomain_at(input, origin + middle * direction) == start ? inside : outside) = middle;
      }
      const int beyond = subdomain_at(input, origin + outside * direction);
      points.emplace_back(
          place.out_of_ct(origin + outside * direction),
          Domain::Index(Domain::Surface_patch_index(std::min(start, beyond), std::max(start, beyond))));
    }
  };
  shoot_from(input.body.deepest(), 0.02 * radius);
  for (const auto& [label, field] : input.inclusions)
    shoot_from(field.deepest(), 0.02 * (field.high() - field.low()).norm());
  return points;
}

/// Edge length by sub-domain and place: inclusions may be finer, their boundary goes with them, and so may be
/// what lies near a vessel.
struct Sizing {
  const MesherInput* input;
  const MesherSizes* sizes;
  Placement place;
  double factor;
  using FT = double;
  template <class Point>
  double operator()(const Point& point, int, const Domain::Index& index) const {
    int domain = 1;
    if (const auto* patch = boost::get<Domain::Surface_patch_index>(&index))
      domain = std::max(patch->first, patch->second);
    else if (const auto* subdomain = boost::get<Domain::Subdomain_index>(&index))
      domain = *subdomain;
    double edge = domain >= 2 ? sizes->inclusion_edges[static_cast<std::size_t>(domain - 2)] : sizes->edge;
    if (sizes->refined_edge < edge && !input->refined.empty()) {
      const Eigen::Vector3d p = place.in_ct(Point3(point.x(), point.y(), point.z()));
      for (const ScalarField& field : input->refined)
        if (field.at(p) > 0.0) edge = sizes->refined_edge;
    }
    return factor * 1e3 * edge;
  }
};

TetMesh extract(const Complex& complex, const MesherInput& input, const Placement& place) {
  // CGAL's order depends on how its containers grew; ours on the geometry alone.
  std::vector<std::pair<std::array<double, 3>, Triangulation::Vertex_handle>> order;
  std::map<Triangulation::Vertex_handle, int> number;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell)
    for (int k = 0; k < 4; ++k) number.emplace(cell->vertex(k), -1);
  order.reserve(number.size());
  for (const auto& [vertex, unused] : number)
    order.push_back({{vertex->point().x(), vertex->point().y(), vertex->point().z()}, vertex});
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  TetMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(order.size()), 3);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& [x, y, z] = order[i].first;
    mesh.vertices.row(static_cast<Eigen::Index>(i)) = place.in_ct(Point3(x, y, z)).transpose();
    number[order[i].second] = static_cast<int>(i);
  }
  std::vector<std::array<int, 5>> cells;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
    std::array<int, 4> nodes{};
    for (int k = 0; k < 4; ++k) nodes[k] = number[cell->vertex(k)];
    // The smallest node first, then the smallest of the rest: even permutations keep the orientation.
    static constexpr int kToFront[4][4] = {{0, 1, 2, 3}, {1, 2, 0, 3}, {2, 0, 1, 3}, {3, 0, 2, 1}};
    const auto& front = kToFront[std::min_element(nodes.begin(), nodes.end()) - nodes.begin()];
    nodes = {nodes[front[0]], nodes[front[1]], nodes[front[2]], nodes[front[3]]};
    std::rotate(nodes.begin() + 1, std::min_element(nodes.begin() + 1, nodes.end()), nodes.end());
    const int domain = static_cast<int>(complex.subdomain_index(cell));
    cells.push_back({nodes[0], nodes[1], nodes[2], nodes[3], domain});
  }
  std::sort(cells.begin(), cells.end());
  mesh.tetrahedra.resize(static_cast<Eigen::Index>(cells.size()), 4);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    mesh.tetrahedra.row(static_cast<Eigen::Index>(c)) << cells[c][0], cells[c][1], cells[c][2], cells[c][3];
    mesh.labels.push_back(cells[c][4] <= 1
                              ? input.body_label
                              : input.inclusions[static_cast<std::size_t>(cells[c][4] - 2)].first);
  }
  return mesh;
}

}  // namespace

Cancellable<TetMesh> fill_with_tetrahedra(const MesherInput& input, const MesherSizes& sizes,
                                          int smoothing_passes, const RunContext& context) {
  require(sizes.inclusion_edges.size() == input.inclusions.size(), "one edge length an inclusion");
  const Placement place{0.5 * (input.body.low() + input.body.high())};
  const double radius = 0.55 * (input.body.high() - input.body.low()).norm();
  CGAL::get_default_random() = CGAL::Random(static_cast<unsigned>(context.seed()));
  CGAL::Random random(static_cast<unsigned>(context.seed()));
  auto queries = std::make_shared<long>(0);
  const auto label = [&input, &place, &context, queries](const Point3& p) {
    if (++*queries % kPollEvery == 0 && context.cancelled()) throw Cancelled();
    if (*queries > kMostQueries)
      throw NumericalError(
          "The mesher does not come to an end. Smooth the labels or ask for fewer vertices.");
    return subdomain_at(input, place.in_ct(p));
  };
  try {
    const Domain domain(label, 1e3 * radius, &random, first_points(input, place, radius));
    const Criteria criteria(parameters::facet_angle = kFacetAngle,
                            parameters::facet_size = Sizing{&input, &sizes, place, 1.0},
                            parameters::facet_distance = Sizing{&input, &sizes, place, kFacetDistance},
                            parameters::cell_radius_edge_ratio = kRadiusEdge,
                            parameters::cell_size = Sizing{&input, &sizes, place, 1.0});
    context.progress(0.0, "model.mesh.refine");
    // Where three sub-domains meet no surface is a manifold, and refinement that asks for one does not end.
    const auto topology = input.inclusions.empty() ? parameters::manifold() : parameters::non_manifold();
    Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(),
                                                 parameters::no_exude(), topology);
    if (smoothing_passes > 0) {
      // No time limits: they would make the result depend on the machine's load.
      context.progress(0.2, "model.mesh.lloyd");
      CGAL::lloyd_optimize_mesh_3(complex, domain, parameters::max_iteration_number = smoothing_passes);
      context.progress(0.4, "model.mesh.odt");
      CGAL::odt_optimize_mesh_3(complex, domain, parameters::max_iteration_number = smoothing_passes);
      context.progress(0.6, "model.mesh.perturb");
      CGAL::perturb_mesh_3(complex, domain, parameters::sliver_bound = kSliverBound);
      context.progress(0.8, "model.mesh.exude");
      CGAL::exude_mesh_3(complex, parameters::sliver_bound = kSliverBound);
    }
    const auto quality = [&complex](Triangulation::Cell_handle cell) {
      return CGAL::to_double(CGAL::Mesh_3::minimum_dihedral_angle(complex.triangulation().tetrahedron(cell)));
    };
    ManifoldBoundary(complex, kLeastDihedral, quality).repair();
    context.progress(1.0, "model.mesh.exude");
    if (context.cancelled()) return {};
    return extract(complex, input, place);
  } catch (const Cancelled&) {
    return {};
  } catch (const CGAL::Failure_exception& failure) {
    throw NumericalError(std::string("The mesher stopped (") + failure.what() +
                         "). Smooth the surface or ask for more vertices.");
  }
}

}  // namespace glisson::model
