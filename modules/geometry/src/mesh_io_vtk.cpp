// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "mesh_io_cells.h"

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
  vtkCallbackCommand* command() { return command_; }
  bool heard() const { return heard_; }

 private:
  vtkNew<vtkCallbackCommand> command_;
  bool heard_ = false;
};

[[noreturn]] void fail(const fs::path& path, const std::string& field, const std::string& problem) {
  throw InputError(path.string(), field, problem, "Export the mesh anew");
}

bool is_legacy(const fs::path& path) { return lower_extension(path) == ".vtk"; }

template <class Reader>
vtkSmartPointer<vtkPointSet> read_xml(const fs::path& path, const std::string& content) {
  vtkNew<Reader> reader;
  Complaints complaints;
  reader->SetReaderErrorObserver(complaints.command());
  reader->SetParserErrorObserver(complaints.command());
  complaints.listen_to(*reader);
  complaints.listen_to(*reader->GetExecutive());
  reader->ReadFromInputStringOn();
  reader->SetInputString(content);
  reader->Update();
  if (complaints.heard() || reader->GetErrorCode() != 0) fail(path, "", "is malformed or ends early");
  return vtkSmartPointer<vtkPointSet>(reader->GetOutput());
}

vtkSmartPointer<vtkPointSet> read_points_and_cells(const fs::path& path) {
  const std::string content = read_file(path);
  const std::string head = content.substr(0, 4096);
  const auto says = [&](const char* word) { return head.find(word) != std::string::npos; };
  if (says("type=\"UnstructuredGrid\"")) return read_xml<vtkXMLUnstructuredGridReader>(path, content);
  if (says("type=\"PolyData\"")) return read_xml<vtkXMLPolyDataReader>(path, content);
  fail(path, "VTKFile", "is of type neither UnstructuredGrid nor PolyData");
}

Points positions(vtkPointSet& data) {
  Points points(data.GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) data.GetPoint(i, points.row(i).data());
  return points;
}

Eigen::MatrixXd values_of(vtkDataArray& array) {
  Eigen::MatrixXd values(array.GetNumberOfTuples(), array.GetNumberOfComponents());
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    for (int k = 0; k < array.GetNumberOfComponents(); ++k) values(i, k) = array.GetComponent(i, k);
  return values;
}

NamedArrays arrays_of(vtkFieldData* data) {
  NamedArrays arrays;
  for (int i = 0; data != nullptr && i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    if (array != nullptr && array->GetName() != nullptr) arrays[array->GetName()] = values_of(*array);
  }
  return arrays;
}

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

MixedFile read_xml_vtk(const fs::path& path) {
  const vtkSmartPointer<vtkPointSet> data = read_points_and_cells(path);
  if (data == nullptr || data->GetNumberOfPoints() == 0) fail(path, "points", "there are none");
  CellSorter cells(path, data->GetNumberOfPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < data->GetNumberOfCells(); ++c) {
    data->GetCellPoints(c, ids);
    cells.add(data->GetCellType(c), std::vector<long>(ids->begin(), ids->end()));
  }
  return cells.finish(positions(*data), arrays_of(data->GetPointData()), arrays_of(data->GetCellData()),
                      arrays_of(data->GetFieldData()));
}

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
