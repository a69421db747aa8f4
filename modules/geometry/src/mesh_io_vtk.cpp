// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "mesh_io_formats.h"

namespace glisson::formats {
namespace fs = std::filesystem;
namespace {

/// VTK reports errors to observers and goes on. This one keeps the fact, and VTK's prose off the screen.
class Complaints {
 public:
  Complaints() {
    command_->SetClientData(&heard_);
    command_->SetCallback([](vtkObject*, unsigned long event, void* heard, void*) {
      if (event == vtkCommand::ErrorEvent) *static_cast<bool*>(heard) = true;
    });
  }
  void listen_to(vtkObject& object) {
    object.AddObserver(vtkCommand::ErrorEvent, command_);
    object.AddObserver(vtkCommand::WarningEvent, command_);
  }
  bool heard() const { return heard_; }

 private:
  vtkNew<vtkCallbackCommand> command_;
  bool heard_ = false;
};

bool is_legacy(const fs::path& path) { return lower_extension(path) == ".vtk"; }

vtkSmartPointer<vtkDoubleArray> array_of(const std::string& name, const Eigen::MatrixXd& values) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(std::max<int>(1, static_cast<int>(values.cols())));
  array->SetNumberOfTuples(values.rows());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index k = 0; k < values.cols(); ++k)
      array->SetComponent(i, static_cast<int>(k), values(i, k));
  return array;
}

void put(const NamedArrays& arrays, vtkFieldData& data) {
  for (const auto& [name, values] : arrays) data.AddArray(array_of(name, values));
}

vtkSmartPointer<vtkPoints> points_of(const Points& vertices) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(vertices.rows());
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) points->SetPoint(i, vertices.row(i).data());
  return points;
}

template <class Indices>
vtkSmartPointer<vtkCellArray> cells_of(const Indices& indices) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (Eigen::Index c = 0; c < indices.rows(); ++c) {
    cells->InsertNextCell(static_cast<int>(indices.cols()));
    for (Eigen::Index k = 0; k < indices.cols(); ++k) cells->InsertCellPoint(indices(c, k));
  }
  return cells;
}

template <class Writer, class Data>
void run(const fs::path& path, Writer& writer, Data& data) {
  Complaints complaints;
  complaints.listen_to(writer);
  writer.SetInputData(&data);
  writer.SetWriteToOutputString(true);
  if (writer.Write() == 0 || complaints.heard())
    throw FileError(path.string() + ": could not be put into this format. Choose another one.");
}

template <class Legacy, class Xml, class Data>
std::string bytes_of(const fs::path& path, Data& data) {
  if (is_legacy(path)) {
    vtkNew<Legacy> writer;
    // 4.2: what every reader of legacy files understands.
    writer->SetFileVersion(Legacy::VTK_LEGACY_READER_VERSION_4_2);
    writer->SetFileTypeToBinary();
    run(path, *writer, data);
    return writer->GetOutputStdString();
  }
  vtkNew<Xml> writer;
  writer->SetDataModeToBinary();
  run(path, *writer, data);
  return writer->GetOutputString();
}

}  // namespace

std::string vtk_bytes(const fs::path& path, const TetFile& file) {
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points_of(file.mesh.vertices));
  grid->SetCells(VTK_TETRA, cells_of(file.mesh.tetrahedra));
  put(file.point_data, *grid->GetPointData());
  put(file.cell_data, *grid->GetCellData());
  put(file.field_data, *grid->GetFieldData());
  if (!file.mesh.labels.empty()) {
    vtkNew<vtkIntArray> labels;
    labels->SetName("label");
    for (const int label : file.mesh.labels) labels->InsertNextValue(label);
    grid->GetCellData()->AddArray(labels);
  }
  return bytes_of<vtkUnstructuredGridWriter, vtkXMLUnstructuredGridWriter>(path, *grid);
}

std::string vtk_bytes(const fs::path& path, const TriangleFile& file) {
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points_of(file.mesh.vertices));
  surface->SetPolys(cells_of(file.mesh.triangles));
  put(file.point_data, *surface->GetPointData());
  put(file.cell_data, *surface->GetCellData());
  put(file.field_data, *surface->GetFieldData());
  return bytes_of<vtkPolyDataWriter, vtkXMLPolyDataWriter>(path, *surface);
}

}  // namespace glisson::formats
