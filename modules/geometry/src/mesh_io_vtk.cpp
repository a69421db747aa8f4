// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCallbackCommand.h>
#include <vtkCell.h>
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
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
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
  vtkCallbackCommand* command() { return command_; }
  bool heard() const { return heard_; }

 private:
  vtkNew<vtkCallbackCommand> command_;
  bool heard_ = false;
};

[[noreturn]] void fail(const fs::path& path, const std::string& field, const std::string& problem) {
  throw InputError(path.string(), field, problem, "Export the mesh anew");
}

bool is_legacy(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".vtk" || extension == ".VTK";
}

template <class Reader>
vtkSmartPointer<vtkPointSet> read_legacy(const fs::path& path, const std::string& content) {
  vtkNew<Reader> reader;
  Complaints complaints;
  complaints.listen_to(*reader);
  complaints.listen_to(*reader->GetExecutive());
  reader->ReadFromInputStringOn();
  reader->SetBinaryInputString(content.data(), static_cast<int>(content.size()));
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  if (complaints.heard() || reader->GetErrorCode() != 0) fail(path, "", "is malformed or ends early");
  return vtkSmartPointer<vtkPointSet>(reader->GetOutput());
}

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
  if (is_legacy(path)) {
    if (content.rfind("# vtk DataFile", 0) != 0)
      fail(path, "line 1", "is not a legacy VTK file (no \"# vtk DataFile\")");
    if (says("UNSTRUCTURED_GRID") || says("unstructured_grid"))
      return read_legacy<vtkUnstructuredGridReader>(path, content);
    if (says("POLYDATA") || says("polydata")) return read_legacy<vtkPolyDataReader>(path, content);
    fail(path, "DATASET", "is neither POLYDATA nor UNSTRUCTURED_GRID");
  }
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

/// @param rows which tuples to keep; null: all.
NamedArrays arrays_of(vtkFieldData* data, const std::vector<vtkIdType>* rows) {
  NamedArrays arrays;
  for (int i = 0; data != nullptr && i < data->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data->GetArray(i);
    if (array == nullptr || array->GetName() == nullptr) continue;
    const Eigen::MatrixXd all = values_of(*array);
    if (rows == nullptr) {
      arrays[array->GetName()] = all;
      continue;
    }
    Eigen::MatrixXd kept(static_cast<Eigen::Index>(rows->size()), all.cols());
    bool whole = true;
    for (std::size_t r = 0; r < rows->size() && whole; ++r) {
      whole = (*rows)[r] < all.rows();
      if (whole) kept.row(static_cast<Eigen::Index>(r)) = all.row((*rows)[r]);
    }
    if (whole) arrays[array->GetName()] = kept;
  }
  return arrays;
}

/// Labels leave the arrays and become the mesh's own.
void take_labels(TetFile& file) {
  for (const char* name : {"label", "labels", "gmsh:physical", "medit:ref"}) {
    const auto found = file.cell_data.find(name);
    if (found == file.cell_data.end() || found->second.cols() != 1) continue;
    file.mesh.labels.resize(static_cast<std::size_t>(found->second.rows()));
    for (std::size_t t = 0; t < file.mesh.labels.size(); ++t)
      file.mesh.labels[t] = static_cast<int>(std::lround(found->second(static_cast<Eigen::Index>(t), 0)));
    file.cell_data.erase(found);
    return;
  }
}

struct Cells {
  std::vector<int> corners;
  std::vector<vtkIdType> source;  ///< the file's cell behind each
};

void read_cells(vtkPointSet& data, const fs::path& path, Cells& tetrahedra, Cells& triangles) {
  vtkNew<vtkIdList> ids;
  const vtkIdType points = data.GetNumberOfPoints();
  for (vtkIdType c = 0; c < data.GetNumberOfCells(); ++c) {
    const int type = data.GetCellType(c);
    data.GetCellPoints(c, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      if (ids->GetId(k) < 0 || ids->GetId(k) >= points)
        fail(path, "cell " + std::to_string(c), "names a point that is not there");
    const auto id = [&](vtkIdType k) { return static_cast<int>(ids->GetId(k)); };
    if (type == VTK_TETRA && ids->GetNumberOfIds() == 4) {
      tetrahedra.corners.insert(tetrahedra.corners.end(), {id(0), id(1), id(2), id(3)});
      tetrahedra.source.push_back(c);
    } else if (type == VTK_TRIANGLE || type == VTK_POLYGON || type == VTK_QUAD ||
               type == VTK_TRIANGLE_STRIP) {
      for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k) {
        const bool strip = type == VTK_TRIANGLE_STRIP;
        const vtkIdType first = strip ? k - 2 + k % 2 : 0, second = strip ? k - 1 - k % 2 : k - 1;
        triangles.corners.insert(triangles.corners.end(), {id(first), id(second), id(k)});
        triangles.source.push_back(c);
      }
    } else if (type != VTK_EMPTY_CELL && type != VTK_VERTEX && type != VTK_POLY_VERTEX && type != VTK_LINE &&
               type != VTK_POLY_LINE) {
      throw InputError(
          path.string(), "cell " + std::to_string(c),
          "is of VTK type " + std::to_string(type) + ", neither a linear tetrahedron nor a polygon",
          "Convert the mesh to linear tetrahedra");
    }
  }
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
void run(const fs::path& path, Data& data, const std::function<void(Writer&)>& configure) {
  vtkNew<Writer> writer;
  Complaints complaints;
  complaints.listen_to(*writer);
  writer->SetFileName(path.c_str());
  writer->SetInputData(&data);
  configure(*writer);
  if (writer->Write() == 0 || complaints.heard())
    throw FileError(path.string() + ": could not be written. Check permissions and free space.");
}

template <class Legacy, class Xml, class Data>
void write(const fs::path& path, Data& data) {
  if (is_legacy(path))
    // 4.2: what every reader of legacy files understands.
    run<Legacy>(path, data, std::function<void(Legacy&)>([](Legacy& writer) {
                  writer.SetFileVersion(Legacy::VTK_LEGACY_READER_VERSION_4_2);
                  writer.SetFileTypeToBinary();
                }));
  else
    run<Xml>(path, data, std::function<void(Xml&)>([](Xml& writer) { writer.SetDataModeToBinary(); }));
}

}  // namespace

MixedFile read_vtk(const fs::path& path) {
  const vtkSmartPointer<vtkPointSet> data = read_points_and_cells(path);
  if (data == nullptr || data->GetNumberOfPoints() == 0) fail(path, "points", "there are none");
  Cells tetrahedra, triangles;
  read_cells(*data, path, tetrahedra, triangles);
  MixedFile file;
  file.tets.mesh.vertices = file.triangles.mesh.vertices = positions(*data);
  file.tets.mesh.tetrahedra = Eigen::Map<const Tetrahedra>(
      tetrahedra.corners.data(), static_cast<Eigen::Index>(tetrahedra.source.size()), 4);
  file.triangles.mesh.triangles = Eigen::Map<const Triangles>(
      triangles.corners.data(), static_cast<Eigen::Index>(triangles.source.size()), 3);
  file.tets.point_data = file.triangles.point_data = arrays_of(data->GetPointData(), nullptr);
  file.tets.cell_data = arrays_of(data->GetCellData(), &tetrahedra.source);
  file.triangles.cell_data = arrays_of(data->GetCellData(), &triangles.source);
  file.tets.field_data = file.triangles.field_data = arrays_of(data->GetFieldData(), nullptr);
  take_labels(file.tets);
  return file;
}

void write_vtk(const fs::path& path, const TetFile& file) {
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
  write<vtkUnstructuredGridWriter, vtkXMLUnstructuredGridWriter>(path, *grid);
}

void write_vtk(const fs::path& path, const TriangleFile& file) {
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points_of(file.mesh.vertices));
  surface->SetPolys(cells_of(file.mesh.triangles));
  put(file.point_data, *surface->GetPointData());
  put(file.cell_data, *surface->GetCellData());
  put(file.field_data, *surface->GetFieldData());
  write<vtkPolyDataWriter, vtkXMLPolyDataWriter>(path, *surface);
}

}  // namespace glisson::formats
