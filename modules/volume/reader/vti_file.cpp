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

#include <fstream>

#include "claim.h"
#include "glisson/core/error.h"

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

}  // namespace

RawVolume read_vti_file(const Request& request) {
  const vtkNew<vtkXMLImageDataReader> reader;
  const vtkNew<ErrorWatch> watch;
  reader->AddObserver(vtkCommand::ErrorEvent, watch);
  if (reader->CanReadFile(request.path.c_str()) == 0)
    throw InputError(request.name, "", "is not a VTK image file (.vti)", "Export it again");
  check_attributes(request);
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
