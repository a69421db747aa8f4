// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include "glisson/patient/patient_model.h"
#include "glisson/ui/scene/model_surfaces.h"

class vtkPolyData;

namespace glisson::scene {

/// The mesh for VTK, same vertex order, in the mesh's own frame and metres.
vtkSmartPointer<vtkPolyData> make_poly_data(const TriangleMesh& mesh);
/// Moves the vertices, and the normals with them when there are any. @pre as many rows as points.
void move_vertices(vtkPolyData& shape, const Points& vertices);
/// Adds smooth normals, weighted by area; move_vertices() keeps them up to date.
void add_normals(vtkPolyData& shape);
/// A ball at each point, in the points' frame. @param radius metres.
vtkSmartPointer<vtkPolyData> balls(const Points& points, double radius);
/// A tube along a line. @param line points in order. @param radius metres.
TriangleMesh polyline_tube(const Points& line, double radius);

}  // namespace glisson::scene
