// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/geometry/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "glisson/core/error.h"

namespace glisson {
namespace {

struct Face {
  std::array<int, 3> sorted;
  std::array<int, 3> outward;
  int tetrahedron;
};

int find_root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

BoundarySurface boundary_surface(const TetMesh& mesh) {
  static constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::vector<Face> faces;
  faces.reserve(static_cast<std::size_t>(mesh.tetrahedron_count()) * 4);
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    for (const auto& corner : kFaces) {
      Face face{{},
                {mesh.tetrahedra(t, corner[0]), mesh.tetrahedra(t, corner[1]), mesh.tetrahedra(t, corner[2])},
                t};
      face.sorted = face.outward;
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.tetrahedron < b.tetrahedron;
  });
  std::vector<const Face*> outer;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t j = i + 1;
    while (j < faces.size() && faces[j].sorted == faces[i].sorted) ++j;
    if (j == i + 1) outer.push_back(&faces[i]);
    i = j;
  }
  BoundarySurface surface;
  std::vector<int> vertex_of_node(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (const Face* face : outer)
    for (const int node : face->outward) vertex_of_node[node] = 0;
  for (int node = 0; node < mesh.vertex_count(); ++node) {
    if (vertex_of_node[node] < 0) continue;
    vertex_of_node[node] = static_cast<int>(surface.node_of_vertex.size());
    surface.node_of_vertex.push_back(node);
  }
  surface.mesh.vertices.resize(static_cast<Eigen::Index>(surface.node_of_vertex.size()), 3);
  for (std::size_t i = 0; i < surface.node_of_vertex.size(); ++i)
    surface.mesh.vertices.row(static_cast<Eigen::Index>(i)) = mesh.vertices.row(surface.node_of_vertex[i]);
  surface.mesh.triangles.resize(static_cast<Eigen::Index>(outer.size()), 3);
  for (std::size_t i = 0; i < outer.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      surface.mesh.triangles(static_cast<Eigen::Index>(i), k) = vertex_of_node[outer[i]->outward[k]];
    surface.tetrahedron_of_triangle.push_back(outer[i]->tetrahedron);
  }
  return surface;
}

std::vector<Edge> edges(const TriangleMesh& mesh) {
  std::vector<Edge> all;
  all.reserve(static_cast<std::size_t>(mesh.triangle_count()) * 3);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
      all.push_back({std::min(a, b), std::max(a, b), t, -1, false});
    }
  }
  std::sort(all.begin(), all.end(), [](const Edge& x, const Edge& y) {
    return std::tie(x.a, x.b, x.left) < std::tie(y.a, y.b, y.left);
  });
  std::vector<Edge> merged;
  for (const Edge& edge : all) {
    if (!merged.empty() && merged.back().a == edge.a && merged.back().b == edge.b) {
      merged.back().non_manifold = merged.back().right >= 0;
      if (merged.back().right < 0) merged.back().right = edge.left;
    } else {
      merged.push_back(edge);
    }
  }
  return merged;
}

bool is_closed(const TriangleMesh& mesh) {
  const std::vector<Edge> all = edges(mesh);
  return !all.empty() &&
         std::all_of(all.begin(), all.end(), [](const Edge& e) { return e.right >= 0 && !e.non_manifold; });
}

std::vector<int> connected_components(const TriangleMesh& mesh, int* count) {
  std::vector<int> parent(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(parent.begin(), parent.end(), 0);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 1; k < 3; ++k) {
      const int a = find_root(parent, mesh.triangles(t, 0)), b = find_root(parent, mesh.triangles(t, k));
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> number(parent.size(), -1), component(parent.size());
  int next = 0;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    int& own = number[find_root(parent, i)];
    if (own < 0) own = next++;
    component[i] = own;
  }
  if (count != nullptr) *count = next;
  return component;
}

TriangleMesh select_triangles(const TriangleMesh& mesh, const std::vector<int>& triangles,
                              std::vector<int>* kept_vertices) {
  std::vector<int> new_of_old(static_cast<std::size_t>(mesh.vertex_count()), -1);
  for (const int t : triangles)
    for (int k = 0; k < 3; ++k) new_of_old[mesh.triangles(t, k)] = 0;
  std::vector<int> kept;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    if (new_of_old[i] < 0) continue;
    new_of_old[i] = static_cast<int>(kept.size());
    kept.push_back(i);
  }
  TriangleMesh part;
  part.vertices.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
    part.vertices.row(static_cast<Eigen::Index>(i)) = mesh.vertices.row(kept[i]);
  part.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      part.triangles(static_cast<Eigen::Index>(t), k) = new_of_old[mesh.triangles(triangles[t], k)];
  if (kept_vertices != nullptr) *kept_vertices = std::move(kept);
  return part;
}

std::vector<TriangleMesh> split_components(const TriangleMesh& mesh) {
  int count = 0;
  const std::vector<int> component = connected_components(mesh, &count);
  std::vector<std::vector<int>> members(static_cast<std::size_t>(count));
  for (int t = 0; t < mesh.triangle_count(); ++t) members[component[mesh.triangles(t, 0)]].push_back(t);
  std::vector<TriangleMesh> parts;
  for (const auto& triangles : members)
    if (!triangles.empty()) parts.push_back(select_triangles(mesh, triangles));
  std::stable_sort(parts.begin(), parts.end(), [](const TriangleMesh& a, const TriangleMesh& b) {
    return std::abs(volume(a)) > std::abs(volume(b));
  });
  return parts;
}

TriangleMesh merge_vertices(const TriangleMesh& mesh, double tolerance, std::vector<int>* new_of_old) {
  // Cells of twice the tolerance; a vertex looks into the 27 cells around its own and joins the first one
  // near enough.
  const double cell = tolerance > 0.0 ? 2.0 * tolerance : 1.0;
  const auto key_of = [&](const Eigen::Vector3d& p) {
    if (tolerance > 0.0)
      return std::array<double, 3>{std::floor(p.x() / cell), std::floor(p.y() / cell),
                                   std::floor(p.z() / cell)};
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::map<std::array<double, 3>, std::vector<int>> cells;
  std::vector<int> mapping(static_cast<std::size_t>(mesh.vertex_count()), -1);
  std::vector<int> kept;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector3d p = mesh.vertex(i);
    const auto key = key_of(p);
    int found = -1;
    const int reach = tolerance > 0.0 ? 1 : 0;
    for (int dx = -reach; dx <= reach && found < 0; ++dx)
      for (int dy = -reach; dy <= reach && found < 0; ++dy)
        for (int dz = -reach; dz <= reach && found < 0; ++dz) {
          const auto cell_found = cells.find({key[0] + dx, key[1] + dy, key[2] + dz});
          if (cell_found == cells.end()) continue;
          for (const int candidate : cell_found->second)
            if ((mesh.vertex(kept[candidate]) - p).norm() <= tolerance) {
              found = candidate;
              break;
            }
        }
    if (found < 0) {
      found = static_cast<int>(kept.size());
      kept.push_back(i);
      cells[key].push_back(found);
    }
    mapping[i] = found;
  }
  TriangleMesh merged;
  merged.vertices.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
    merged.vertices.row(static_cast<Eigen::Index>(i)) = mesh.vertices.row(kept[i]);
  merged.triangles.resize(mesh.triangle_count(), 3);
  int next = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int a = mapping[mesh.triangles(t, 0)], b = mapping[mesh.triangles(t, 1)],
              c = mapping[mesh.triangles(t, 2)];
    if (a != b && b != c && c != a) merged.triangles.row(next++) << a, b, c;
  }
  merged.triangles.conservativeResize(next, 3);
  if (new_of_old != nullptr) *new_of_old = std::move(mapping);
  return merged;
}

void check_connectivity(const TetMesh& mesh, const std::string& name) {
  if (mesh.tetrahedron_count() == 0)
    throw InputError(name, "tetrahedra", "there are none",
                     "Give a tetrahedral mesh, or a closed surface to be meshed");
  for (int i = 0; i < mesh.vertex_count(); ++i)
    if (!mesh.vertices.row(i).allFinite())
      throw InputError(name, "vertex " + std::to_string(i), "a coordinate is not a finite number",
                       "Export the mesh anew");
  std::map<std::array<int, 4>, int> seen;
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    const std::string field = "tetrahedron " + std::to_string(t);
    std::array<int, 4> nodes{};
    for (int k = 0; k < 4; ++k) {
      nodes[k] = mesh.tetrahedra(t, k);
      if (nodes[k] < 0 || nodes[k] >= mesh.vertex_count())
        throw InputError(
            name, field,
            "names vertex " + std::to_string(nodes[k]) + " of " + std::to_string(mesh.vertex_count()),
            "Export the mesh anew");
    }
    std::sort(nodes.begin(), nodes.end());
    const auto [twin, is_new] = seen.emplace(nodes, t);
    if (!is_new)
      throw InputError(name, field, "has the same nodes as tetrahedron " + std::to_string(twin->second),
                       "Remove one of them");
  }
}

void check_tetrahedra(const TetMesh& mesh, const std::string& name) {
  check_connectivity(mesh, name);
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    const std::string field = "tetrahedron " + std::to_string(t);
    const Eigen::Vector3d a = mesh.vertex(mesh.tetrahedra(t, 0));
    const Eigen::Vector3d b = mesh.vertex(mesh.tetrahedra(t, 1)) - a,
                          c = mesh.vertex(mesh.tetrahedra(t, 2)) - a,
                          d = mesh.vertex(mesh.tetrahedra(t, 3)) - a;
    const double six = b.cross(c).dot(d), longest = std::max({b.norm(), c.norm(), d.norm()});
    if (six < 0.0)
      throw InputError(name, field, "is inverted (volume " + std::to_string(six / 6.0 * 1e9) + " mm3)",
                       "Swap two of its vertices, or mesh anew");
    if (six <= 1e-12 * longest * longest * longest)
      throw InputError(name, field, "is flat",
                       "Remove it by mesh optimisation (perturb and exude), or mesh anew");
  }
}

int orient_tetrahedra(TetMesh& mesh) {
  const Eigen::VectorXd volumes = tetrahedron_volumes(mesh);
  int turned = 0;
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    if (volumes[t] >= 0.0) continue;
    std::swap(mesh.tetrahedra(t, 2), mesh.tetrahedra(t, 3));
    ++turned;
  }
  return turned;
}

std::vector<std::vector<int>> vertex_neighbours(const TriangleMesh& mesh) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(mesh.vertex_count()));
  for (const Edge& edge : edges(mesh)) {
    neighbours[edge.a].push_back(edge.b);
    neighbours[edge.b].push_back(edge.a);
  }
  for (auto& list : neighbours) std::sort(list.begin(), list.end());
  return neighbours;
}

}  // namespace glisson
