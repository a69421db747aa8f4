// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "glisson/core/frames.h"

/// @file
/// Meshes as plain values. Coordinates are metres; the frame is said by whoever owns the mesh (a
/// PatientModel's is the CT). Indices are 0-based rows.

namespace glisson {

/// N x 3, one point a row, metres.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// Points whose declaration says their frame (CtFrame, CameraFrame). The same type: it is said to the reader,
/// the compiler does not check it.
template <class Frame>
using PointsIn = Points;
/// N x 3 vertex indices, counter-clockwise seen from outside.
using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
/// N x 4 vertex indices, positively oriented: det(b - a, c - a, d - a) > 0.
using Tetrahedra = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A surface. Nothing here asks whether it is closed or consistently oriented: see topology.h.
struct TriangleMesh {
  Points vertices;  ///< metres, in the owner's frame
  Triangles triangles;

  int vertex_count() const { return static_cast<int>(vertices.rows()); }
  int triangle_count() const { return static_cast<int>(triangles.rows()); }
  Eigen::Vector3d vertex(int i) const { return vertices.row(i).transpose(); }
};

/// A volume of linear tetrahedra. Whether they are inverted is asked by check_tetrahedra() alone.
struct TetMesh {
  Points vertices;  ///< metres, in the owner's frame
  Tetrahedra tetrahedra;
  /// One code per tetrahedron (which sub-domain it fills: see LabelMap's structures); empty means all alike.
  std::vector<int> labels;

  int vertex_count() const { return static_cast<int>(vertices.rows()); }
  int tetrahedron_count() const { return static_cast<int>(tetrahedra.rows()); }
  Eigen::Vector3d vertex(int i) const { return vertices.row(i).transpose(); }
};

/// Unit normals, one a triangle (zero for a degenerate one).
Points triangle_normals(const TriangleMesh& mesh);
/// Unit normals, one a vertex, weighted by angle (Thürmer and Wüthrich 1998).
Points vertex_normals(const TriangleMesh& mesh);
/// Square metres, one a triangle.
Eigen::VectorXd triangle_areas(const TriangleMesh& mesh);
/// A third of the area of the triangles around each vertex, square metres.
Eigen::VectorXd vertex_areas(const TriangleMesh& mesh);
/// Square metres.
double area(const TriangleMesh& mesh);
/// Signed, cubic metres: positive for a closed mesh whose normals point outwards.
double volume(const TriangleMesh& mesh);
/// Signed, cubic metres, one a tetrahedron.
Eigen::VectorXd tetrahedron_volumes(const TetMesh& mesh);
/// Sum of the signed volumes, cubic metres: inverted tetrahedra count against the others.
double volume(const TetMesh& mesh);
/// Area-weighted mean of the triangles' centres.
Eigen::Vector3d centroid(const TriangleMesh& mesh);
/// Smallest and largest dihedral angle of each tetrahedron, degrees. Shape: tetrahedra x 2.
Eigen::MatrixX2d dihedral_angles(const TetMesh& mesh);

}  // namespace glisson
