// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "glisson/core/error.h"
#include "scalar_field.h"

namespace glisson::model {

TriangleMesh zero_level(const ScalarField& field) {
  const VolumeGrid& grid = field.grid();
  vtkNew<vtkFloatArray> values;
  // VTK only reads; the field outlives the filter.
  values->SetArray(const_cast<float*>(field.values().data()), static_cast<vtkIdType>(field.values().size()),
                   1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.size.x(), grid.size.y(), grid.size.z());
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  edges->Update();
  vtkPolyData* surface = edges->GetOutput();
  TriangleMesh mesh;
  mesh.vertices.resize(surface->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    double index[3];
    surface->GetPoint(i, index);
    mesh.vertices.row(i) = grid.p_in_ct(Eigen::Vector3d(index[0], index[1], index[2])).xyz.transpose();
  }
  mesh.triangles.resize(surface->GetNumberOfCells(), 3);
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface->GetNumberOfCells(); ++t) {
    surface->GetCellPoints(t, corners);
    require(corners->GetNumberOfIds() == 3, "an isosurface is made of triangles");
    for (int k = 0; k < 3; ++k) mesh.triangles(t, k) = static_cast<int>(corners->GetId(k));
  }
  if (volume(mesh) < 0.0)
    mesh.triangles.col(1).swap(mesh.triangles.col(2));  // mirrored axes turn it inside out
  return mesh;
}

}  // namespace glisson::model
