// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/scene/surface_shapes.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>
#include <vtkTubeFilter.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"

namespace glisson::scene {
namespace {

TriangleMesh from_poly_data(vtkPolyData& shape) {
  TriangleMesh mesh;
  mesh.vertices.resize(shape.GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < shape.GetNumberOfPoints(); ++i) {
    const double* p = shape.GetPoint(i);
    mesh.vertices.row(i) << p[0], p[1], p[2];
  }
  std::vector<std::array<int, 3>> triangles;
  vtkNew<vtkIdList> cell;
  for (vtkIdType c = 0; c < shape.GetNumberOfCells(); ++c) {
    shape.GetCellPoints(c, cell);
    if (cell->GetNumberOfIds() != 3) continue;
    triangles.push_back({static_cast<int>(cell->GetId(0)), static_cast<int>(cell->GetId(1)),
                         static_cast<int>(cell->GetId(2))});
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) = triangles[t][k];
  return mesh;
}

/// Chains of beams from fork to fork, so that a branch becomes one smooth tube. Every beam is in one chain.
std::vector<std::vector<int>> branches(const VesselTree& tree) {
  std::map<int, std::vector<std::size_t>> beams_of_node;
  for (std::size_t b = 0; b < tree.beams.size(); ++b)
    for (const int node : tree.beams[b]) beams_of_node[node].push_back(b);
  std::vector<bool> used(tree.beams.size(), false);
  const auto follow = [&](int node, std::size_t beam) {
    std::vector<int> chain{node};
    while (true) {
      used[beam] = true;
      node = tree.beams[beam][0] == node ? tree.beams[beam][1] : tree.beams[beam][0];
      chain.push_back(node);
      const auto& next = beams_of_node[node];
      if (next.size() != 2) return chain;
      const std::size_t other = next[0] == beam ? next[1] : next[0];
      if (used[other]) return chain;
      beam = other;
    }
  };
  std::vector<std::vector<int>> chains;
  for (const auto& [node, beams] : beams_of_node)
    if (beams.size() != 2)
      for (const std::size_t b : beams)
        if (!used[b]) chains.push_back(follow(node, b));
  for (std::size_t b = 0; b < tree.beams.size(); ++b)  // rings have no end to start from
    if (!used[b]) chains.push_back(follow(tree.beams[b][0], b));
  return chains;
}

TriangleMesh joined(const std::vector<const TriangleMesh*>& parts) {
  TriangleMesh all;
  Eigen::Index vertices = 0, triangles = 0;
  for (const TriangleMesh* part : parts) {
    vertices += part->vertices.rows();
    triangles += part->triangles.rows();
  }
  all.vertices.resize(vertices, 3);
  all.triangles.resize(triangles, 3);
  vertices = triangles = 0;
  for (const TriangleMesh* part : parts) {
    all.vertices.middleRows(vertices, part->vertices.rows()) = part->vertices;
    all.triangles.middleRows(triangles, part->triangles.rows()) =
        part->triangles.array() + static_cast<int>(vertices);
    vertices += part->vertices.rows();
    triangles += part->triangles.rows();
  }
  return all;
}

TriangleMesh lesion_boundary(const TetMesh& mesh, Label lesion) {
  TetMesh part;
  part.vertices = mesh.vertices;
  std::vector<Eigen::Index> chosen;
  for (std::size_t t = 0; t < mesh.labels.size(); ++t)
    if (mesh.labels[t] == lesion) chosen.push_back(static_cast<Eigen::Index>(t));
  if (chosen.empty()) return {};
  part.tetrahedra.resize(static_cast<Eigen::Index>(chosen.size()), 4);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    part.tetrahedra.row(static_cast<Eigen::Index>(i)) = mesh.tetrahedra.row(chosen[i]);
  return boundary_surface(part).mesh;
}

}  // namespace

vtkSmartPointer<vtkPolyData> make_poly_data(const TriangleMesh& mesh) {
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->SetNumberOfPoints(mesh.vertices.rows());
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i)
    points->SetPoint(i, mesh.vertices(i, 0), mesh.vertices(i, 1), mesh.vertices(i, 2));
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const vtkIdType ids[3] = {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
    cells->InsertNextCell(3, ids);
  }
  shape->SetPoints(points);
  shape->SetPolys(cells);
  return shape;
}

void add_normals(vtkPolyData& shape) {
  const vtkIdType count = shape.GetNumberOfPoints();
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> sums =
      Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>::Zero(count, 3);
  const auto* xyz = static_cast<const float*>(shape.GetPoints()->GetVoidPointer(0));
  const auto at = [&](vtkIdType i) { return Eigen::Map<const Eigen::Vector3f>(xyz + 3 * i); };
  vtkCellArray& cells = *shape.GetPolys();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType c = 0; c < cells.GetNumberOfCells(); ++c) {
    cells.GetCellAtId(c, size, ids);
    if (size != 3) continue;
    const Eigen::Vector3f a = at(ids[0]);
    const Eigen::RowVector3f normal = (at(ids[1]) - a).cross(at(ids[2]) - a).transpose();
    for (int k = 0; k < 3; ++k) sums.row(ids[k]) += normal;
  }
  auto* normals = vtkFloatArray::SafeDownCast(shape.GetPointData()->GetNormals());
  if (normals == nullptr) {
    vtkNew<vtkFloatArray> fresh;
    fresh->SetNumberOfComponents(3);
    fresh->SetNumberOfTuples(count);
    shape.GetPointData()->SetNormals(fresh);
    normals = fresh;
  }
  for (vtkIdType i = 0; i < count; ++i) {
    const float length = sums.row(i).norm();
    const Eigen::RowVector3f n = length > 0.0F ? (sums.row(i) / length).eval() : Eigen::RowVector3f(0, 0, 1);
    normals->SetTuple3(i, n[0], n[1], n[2]);
  }
  normals->Modified();
}

void move_vertices(vtkPolyData& shape, const Points& vertices) {
  require(vertices.rows() == shape.GetNumberOfPoints(), "a shape is moved by as many points as it has");
  auto* xyz = static_cast<float*>(shape.GetPoints()->GetVoidPointer(0));
  for (Eigen::Index i = 0; i < vertices.size(); ++i) xyz[i] = static_cast<float>(vertices.data()[i]);
  shape.GetPoints()->Modified();
  if (shape.GetPointData()->GetNormals() != nullptr) add_normals(shape);
  shape.Modified();
}

TriangleMesh simplified(const TriangleMesh& mesh, int triangles) {
  require(triangles > 0, "a surface keeps at least one triangle");
  if (mesh.triangle_count() <= triangles) return mesh;
  vtkNew<vtkQuadricDecimation> decimation;
  decimation->SetInputData(make_poly_data(mesh));
  decimation->SetTargetReduction(1.0 - static_cast<double>(triangles) / mesh.triangle_count());
  decimation->Update();
  return from_poly_data(*decimation->GetOutput());
}

TriangleMesh tube_mesh(const VesselTree& tree, int sides) {
  if (tree.beams.empty()) return {};
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius");
  for (Eigen::Index i = 0; i < tree.nodes.rows(); ++i) {
    points->InsertNextPoint(tree.nodes(i, 0), tree.nodes(i, 1), tree.nodes(i, 2));
    radii->InsertNextValue(tree.radii[static_cast<std::size_t>(i)]);
  }
  vtkNew<vtkCellArray> lines;
  for (const std::vector<int>& chain : branches(tree)) {
    lines->InsertNextCell(static_cast<int>(chain.size()));
    for (const int node : chain) lines->InsertCellPoint(node);
  }
  vtkNew<vtkPolyData> centrelines;
  centrelines->SetPoints(points);
  centrelines->SetLines(lines);
  centrelines->GetPointData()->SetScalars(radii);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(centrelines);
  tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tubes->SetNumberOfSides(sides);
  tubes->CappingOn();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(tubes->GetOutputPort());
  triangles->PassLinesOff();
  triangles->PassVertsOff();
  triangles->Update();
  return from_poly_data(*triangles->GetOutput());
}

TriangleMesh structure_surface(const PatientModel& model, Label structure) {
  std::vector<const TriangleMesh*> fine;
  for (const NamedSurface& surface : model.surfaces)
    if (surface.structure == structure) fine.push_back(&surface.mesh);
  if (!fine.empty()) return joined(fine);
  std::vector<TriangleMesh> tubes;
  for (const VesselTree& tree : model.vessels)
    if (tree.structure == structure) tubes.push_back(tube_mesh(tree));
  if (!tubes.empty()) {
    for (const TriangleMesh& tube : tubes) fine.push_back(&tube);
    return joined(fine);
  }
  if (structure == structure::kParenchyma) return model.surface.mesh;
  if (is_lesion(structure)) return lesion_boundary(model.mesh, structure);
  return {};
}

std::vector<Label> inner_structures(const PatientModel& model) {
  const auto inner = [](Label s) {
    return is_lesion(s) || s == structure::kPortalVein || s == structure::kHepaticVeins ||
           s == structure::kArtery;
  };
  std::set<Label> found;
  for (const NamedSurface& surface : model.surfaces)
    if (inner(surface.structure)) found.insert(surface.structure);
  for (const VesselTree& tree : model.vessels)
    if (inner(tree.structure)) found.insert(tree.structure);
  for (const int label : model.mesh.labels)
    if (is_lesion(label)) found.insert(static_cast<Label>(label));
  return {found.begin(), found.end()};
}

vtkSmartPointer<vtkPolyData> balls(const Points& points, double radius) {
  vtkNew<vtkAppendPolyData> all;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(points(i, 0), points(i, 1), points(i, 2));
    ball->SetRadius(radius);
    ball->SetThetaResolution(12);
    ball->SetPhiResolution(12);
    ball->Update();
    all->AddInputData(ball->GetOutput());
  }
  all->Update();
  return all->GetOutput();
}

TriangleMesh polyline_tube(const Points& line, double radius) {
  VesselTree tree;
  tree.nodes = line;
  tree.radii.assign(static_cast<std::size_t>(line.rows()), radius);
  for (int i = 0; i + 1 < line.rows(); ++i) tree.beams.push_back({i, i + 1});
  return tube_mesh(tree, 8);
}

}  // namespace glisson::scene
