// SPDX-License-Identifier: GPL-3.0-or-later
#include "patient_surfaces.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "glisson/geometry/topology.h"

namespace glisson::insilico {

namespace {

VolumeGrid box_grid(const Vec& low, const Vec& high, double spacing) {
  VolumeGrid grid;
  grid.spacing_mm = Vec::Constant(spacing);
  grid.origin_mm = low;
  grid.size = ((high - low) / spacing).array().ceil().cast<int>() + 1;
  return grid;
}

TriangleMesh flying_edges(const VolumeGrid& grid, std::vector<float>& field) {
  // A sample of exactly zero would collapse triangles onto one point.
  for (float& value : field)
    if (std::abs(value) < 1e-4F) value = 1e-4F;
  vtkNew<vtkFloatArray> scalars;
  scalars->SetArray(field.data(), static_cast<vtkIdType>(field.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.size.data());
  image->SetSpacing(grid.spacing_mm.data());
  image->SetOrigin(grid.origin_mm.data());
  image->GetPointData()->SetScalars(scalars);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkPolyData* output = contour->GetOutput();

  TriangleMesh mesh;
  mesh.vertices.resize(output->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    mesh.vertices.row(i) = 1e-3 * Eigen::Map<const Eigen::RowVector3d>(output->GetPoint(i));
  mesh.triangles.resize(output->GetNumberOfPolys(), 3);
  const auto cells = vtk::TakeSmartPointer(output->GetPolys()->NewIterator());
  int row = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++row) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    mesh.triangles.row(row) << static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2]);
  }
  if (volume(mesh) < 0.0) mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return mesh;
}

/// The largest piece: where two round shapes nearly miss each other a contour may leave a crumb.
TriangleMesh largest(const TriangleMesh& mesh) {
  const std::vector<TriangleMesh> pieces = split_components(mesh);
  return pieces.empty() ? mesh : pieces.front();
}

}  // namespace

TriangleMesh contour(const Vec& low, const Vec& high, double spacing,
                     const std::function<double(const Vec&)>& field) {
  const VolumeGrid grid = box_grid(low, high, spacing);
  std::vector<float> samples(static_cast<std::size_t>(grid.voxel_count()), 1.0F);
  // Coarse blocks first: where the field's slope excludes the surface from a block, its sign is enough.
  constexpr int kBlock = 6;
  const double half = 0.5 * kBlock * spacing * std::sqrt(3.0);
  for (int bk = 0; bk < grid.size.z(); bk += kBlock)
    for (int bj = 0; bj < grid.size.y(); bj += kBlock)
      for (int bi = 0; bi < grid.size.x(); bi += kBlock) {
        const Vec corner = low + spacing * Vec(bi, bj, bk);
        const double middle = field(corner + Vec::Constant(0.5 * (kBlock - 1) * spacing));
        const bool near = std::abs(middle) < kSteepest * half;
        for (int k = bk; k < std::min(bk + kBlock, grid.size.z()); ++k)
          for (int j = bj; j < std::min(bj + kBlock, grid.size.y()); ++j)
            for (int i = bi; i < std::min(bi + kBlock, grid.size.x()); ++i)
              samples[static_cast<std::size_t>(grid.offset({i, j, k}))] =
                  static_cast<float>(near ? field(low + spacing * Vec(i, j, k)) : middle);
      }
  return largest(flying_edges(grid, samples));
}

TriangleMesh contour(const GrownTree& tree, double spacing) {
  Vec low = tree.nodes.front(), high = low;
  for (const Vec& p : tree.nodes) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double widest = *std::max_element(tree.radii.begin(), tree.radii.end());
  const Vec margin = Vec::Constant(widest + 3.0 * spacing);
  const VolumeGrid grid = box_grid(low - margin, high + margin, spacing);
  std::vector<float> samples = tree_field(grid, tree, 2.0 * spacing, static_cast<float>(2.0 * spacing));
  return largest(flying_edges(grid, samples));
}

}  // namespace glisson::insilico
