// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glisson/geometry/mesh.h"

namespace glisson {

/// The boundary of a tetrahedral mesh.
struct BoundarySurface {
  /// Its vertices are the mesh's boundary nodes, renumbered; normals point outwards.
  TriangleMesh mesh;
  /// node_of_vertex[i] is the tetrahedral mesh's node behind surface vertex i (ascending).
  std::vector<int> node_of_vertex;
  /// tetrahedron_of_triangle[t] is the tetrahedron behind triangle t.
  std::vector<int> tetrahedron_of_triangle;
};
BoundarySurface boundary_surface(const TetMesh& mesh);

/// Undirected edge between triangles.
struct Edge {
  int a = 0, b = 0;  ///< vertices, a < b
  /// The triangles on either side; -1 where there is none. More than two: non_manifold.
  int left = -1, right = -1;
  bool non_manifold = false;
};
/// Sorted by (a, b).
std::vector<Edge> edges(const TriangleMesh& mesh);
/// Whether every edge has exactly two triangles.
bool is_closed(const TriangleMesh& mesh);
/// Vertices reachable from one another through triangles. One number a vertex, 0-based, by first vertex.
std::vector<int> connected_components(const TriangleMesh& mesh, int* count = nullptr);
/// The sub-mesh of the chosen triangles; unused vertices are dropped, order is kept.
/// @param kept_vertices if given, receives for every new vertex the old one.
TriangleMesh select_triangles(const TriangleMesh& mesh, const std::vector<int>& triangles,
                              std::vector<int>* kept_vertices = nullptr);
/// The connected pieces, largest |volume| first.
std::vector<TriangleMesh> split_components(const TriangleMesh& mesh);
/// Merges vertices closer than `tolerance` (metres; 0: only equal ones), drops triangles that collapse.
TriangleMesh merge_vertices(const TriangleMesh& mesh, double tolerance,
                            std::vector<int>* new_of_old = nullptr);

/// Checks that a tetrahedral mesh can carry mechanics.
/// @throws InputError (file = `name`) naming the first element and what is wrong: index out of range,
/// coordinates that
///   are not finite, inverted or flat (volume <= 0 or a sliver below 1e-12 of its box), twice the same nodes.
void check_tetrahedra(const TetMesh& mesh, const std::string& name);
/// The same mesh with every tetrahedron positively oriented. @return how many were turned.
int orient_tetrahedra(TetMesh& mesh);

/// One-ring neighbours of each vertex, ascending.
std::vector<std::vector<int>> vertex_neighbours(const TriangleMesh& mesh);

}  // namespace glisson
