// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "text_values.h"

namespace glisson::reader {
namespace {

/// VTK reports errors as events and goes on; this remembers that there was one (and keeps it off the screen).
class ErrorWatch : public vtkCommand {
 public:
  static ErrorWatch* New() { return new ErrorWatch; }
  void Execute(vtkObject*, unsigned long, void*) override { seen = true; }
  bool seen = false;
};

vtkDataArray* scalars_of(const Request& request, vtkImageData& image) {
  vtkPointData* points = image.GetPointData();
  if (points->GetScalars() != nullptr) return points->GetScalars();
  if (points->GetNumberOfArrays() == 1 && points->GetArray(0) != nullptr) return points->GetArray(0);
  throw InputError(request.name, "PointData", "marks no array as the scalars",
                   "Write one scalar array on the points");
}

/// VTK takes 1 mm and the origin where the file does not say.
void check_attributes(const Request& request) {
  std::ifstream stream(request.path, std::ios::binary);
  std::string head(1U << 16, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const std::size_t begin = head.find("<ImageData"), end = head.find('>', begin);
  if (begin == std::string::npos || end == std::string::npos)
    throw InputError(request.name, "ImageData", "is missing", "Export it again");
  const std::string element = head.substr(begin, end - begin);
  for (const char* name : {"WholeExtent", "Origin", "Spacing", "Direction"}) {
    const std::size_t at = element.find(std::string(name) + "=\"");
    if (at == std::string::npos && name[0] == 'D') return;  // none: along the patient's axes
    if (at == std::string::npos) throw InputError(request.name, name, "is missing", "Export it again");
    const std::size_t first = element.find('"', at) + 1;
    (void)numbers_in(request, name, element.substr(first, element.find('"', first) - first),
                     name[0] == 'W'   ? 6
                     : name[0] == 'D' ? 9
                                      : 3);
  }
}

/// The value of an attribute in an element's text, "" without one.
std::string attribute(std::string_view element, const std::string& name) {
  for (const char quote : {'"', '\''}) {
    const std::size_t at = element.find(" " + name + "=" + quote);
    if (at == std::string_view::npos) continue;
    const std::size_t begin = at + name.size() + 3;
    return std::string(element.substr(begin, element.find(quote, begin) - begin));
  }
  return {};
}

NumberType type_of(const Request& request, const std::string& name) {
  static const std::map<std::string, NumberType> kTypes = {
      {"Int8", {1, true, true}},    {"UInt8", {1, false, true}},  {"Int16", {2, true, true}},
      {"UInt16", {2, false, true}}, {"Int32", {4, true, true}},   {"UInt32", {4, false, true}},
      {"Int64", {8, true, true}},   {"UInt64", {8, false, true}}, {"Float32", {4, true, false}},
      {"Float64", {8, true, false}}};
  const auto known = kTypes.find(name);
  if (known == kTypes.end())
    throw InputError(request.name, "DataArray, type",
                     "is \"" + name.substr(0, 40) + "\", which is no number format that is known",
                     "Export it as 16-bit integers");
  return known->second;
}

/// VTK reads as many words as it needs, each into the type that it is told.
void check_text_arrays(const Request& request) {
  const std::string file = read_file(request.path);
  const std::string_view text = file;
  double points = 0.0;
  bool on_points = false;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::size_t end = std::min(text.find('>', at), text.size());
    std::string element(text.substr(at, end - at));
    std::replace_if(
        element.begin(), element.end(), [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
    if (element.starts_with("<AppendedData")) return;  // what follows is no XML
    if (element.starts_with("<Piece")) {
      const auto extent = numbers_in(request, "Piece, Extent", attribute(element, "Extent"), 6);
      points = 1.0;
      for (std::size_t axis = 0; axis < 3; ++axis) points *= extent[2 * axis + 1] - extent[2 * axis] + 1.0;
    }
    if (element.starts_with("<PointData")) on_points = true;
    if (element.starts_with("</PointData")) on_points = false;
    if (!on_points || !element.starts_with("<DataArray") || attribute(element, "format") != "ascii") continue;
    const std::string parts = attribute(element, "NumberOfComponents");
    const double components =
        parts.empty() ? 1.0 : numbers_in(request, "NumberOfComponents", parts, 1).front();
    const std::size_t begin = std::min(end + 1, text.size());
    check_text_values(request, "DataArray", text.substr(begin, text.find('<', begin) - begin),
                      points * components, type_of(request, attribute(element, "type")));
  }
}

}  // namespace

RawVolume read_vti_file(const Request& request) {
  const vtkNew<vtkXMLImageDataReader> reader;
  const vtkNew<ErrorWatch> watch;
  reader->AddObserver(vtkCommand::ErrorEvent, watch);
  if (reader->CanReadFile(request.path.c_str()) == 0)
    throw InputError(request.name, "", "is not a VTK image file (.vti)", "Export it again");
  check_attributes(request);
  check_text_arrays(request);
  reader->SetFileName(request.path.c_str());
  reader->UpdateInformation();
  if (watch->seen) throw InputError(request.name, "", "is damaged", "Export it again");
  vtkImageData* image = reader->GetOutput();
  int extent[6];
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  Eigen::Vector3i size;
  for (int axis = 0; axis < 3; ++axis) {
    const long length = static_cast<long>(extent[2 * axis + 1]) - extent[2 * axis] + 1;
    size[axis] = length > 100000 || length < 1 ? -1 : static_cast<int>(length);
  }
  check_value_count(request, size, 1);
  std::error_code failure;
  raise_limits(static_cast<double>(std::filesystem::file_size(request.path, failure)),
               2.0 * size.cast<double>().prod());
  request.progress(0.1);
  reader->Update();
  if (watch->seen) throw InputError(request.name, "", "is damaged or ends early", "Export it again");

  RawVolume raw;
  Eigen::Vector3d spacing, first_index;
  Eigen::Matrix3d direction;
  for (int axis = 0; axis < 3; ++axis) {
    spacing[axis] = image->GetSpacing()[axis];
    first_index[axis] = extent[2 * axis];
    for (int row = 0; row < 3; ++row)
      direction(row, axis) = image->GetDirectionMatrix()->GetElement(row, axis);
  }
  // VTK's origin is that of index 0, and an extent need not start there.
  const Eigen::Vector3d origin =
      Eigen::Vector3d(image->GetOrigin()) + direction * first_index.cwiseProduct(spacing);
  raw.grid = checked_grid(request, size, spacing, origin, direction);
  vtkDataArray* scalars = scalars_of(request, *image);
  if (scalars->GetNumberOfTuples() != raw.grid.voxel_count())
    throw InputError(request.name, "PointData", "holds fewer values than there are voxels",
                     "Export it again");
  raw.components = scalars->GetNumberOfComponents();
  raw.voxels.reserve(static_cast<std::size_t>(raw.components * raw.grid.voxel_count()));
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    for (int c = 0; c < raw.components; ++c)
      raw.voxels.push_back(static_cast<float>(scalars->GetComponent(i, c)));
  return raw;
}

}  // namespace glisson::reader
