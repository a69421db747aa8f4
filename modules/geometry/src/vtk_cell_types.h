// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// VTK's numbers of cell types (vtkCellType.h).
namespace glisson::vtk_cell {

enum Type {
  kEmpty = 0,
  kVertex = 1,
  kPolyVertex = 2,
  kLine = 3,
  kPolyLine = 4,
  kTriangle = 5,
  kStrip = 6,
  kPolygon = 7,
  kQuad = 9,
  kTetrahedron = 10
};

}  // namespace glisson::vtk_cell
