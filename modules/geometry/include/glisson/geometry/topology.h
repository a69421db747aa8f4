// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "glisson/geometry/mesh.h"

/// @file
/// How meshes hang together. Pure functions, safe from any thread; vertices and triangles are 0-based rows.

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
/// The triangles that belong to one tetrahedron only. @pre positively oriented tetrahedra.
BoundarySurface boundary_surface(const TetMesh& mesh);

/// An undirected edge of a surface.
struct Edge {
  int a = 0, b = 0;  ///< vertices, a < b
  /// The first two triangles at the edge; -1 where there is none.
  int left = -1, right = -1;
  bool non_manifold = false;  ///< more than two triangles meet there
};
/// Every edge once, sorted by (a, b).
std::vector<Edge> edges(const TriangleMesh& mesh);
/// Whether every edge has exactly two triangles.
bool is_closed(const TriangleMesh& mesh);
/// Which vertices can be reached from one another through triangles.
/// @param count if given, receives the number of components.
/// @return the number of each vertex's component, 0-based, in the order of the components' first vertices.
std::vector<int> connected_components(const TriangleMesh& mesh, int* count = nullptr);
/// The sub-mesh of the chosen triangles; unused vertices are dropped, order is kept.
/// @param kept_vertices if given, receives for every new vertex the old one.
TriangleMesh select_triangles(const TriangleMesh& mesh, const std::vector<int>& triangles,
                              std::vector<int>* kept_vertices = nullptr);
/// The connected pieces, largest |volume| first.
std::vector<TriangleMesh> split_components(const TriangleMesh& mesh);
/// Merges vertices closer than `tolerance` (metres; 0: only equal ones), drops triangles that collapse.
/// @param new_of_old if given, receives the new number of every old vertex.
TriangleMesh merge_vertices(const TriangleMesh& mesh, double tolerance,
                            std::vector<int>* new_of_old = nullptr);

/// Checks that a tetrahedral mesh can carry mechanics.
/// @param name what the mesh is called in messages.
/// @throws InputError (file = `name`) naming the first element and what is wrong: index out of range,
///   coordinates that are not finite, inverted or flat (volume <= 0, or below 1e-12 of its box's), the same
///   nodes twice.
void check_tetrahedra(const TetMesh& mesh, const std::string& name);
/// The same but for the volumes: of a deformed shape mechanics may have turned some inside out.
void check_connectivity(const TetMesh& mesh, const std::string& name);
/// Turns the tetrahedra that are negatively oriented. @return how many were turned.
int orient_tetrahedra(TetMesh& mesh);

/// One-ring neighbours of each vertex, ascending.
std::vector<std::vector<int>> vertex_neighbours(const TriangleMesh& mesh);

}  // namespace glisson
