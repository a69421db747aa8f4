// SPDX-License-Identifier: GPL-3.0-or-later
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <limits>

#include "claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "itk_buffer.h"
#include "raw_volume.h"

namespace glisson::reader {
namespace {

enum class Format { nifti, nrrd, meta };

Format format_of(const Request& request) {
  const std::string name = lower_name(request.path);
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return Format::nifti;
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) return Format::nrrd;
  if (name.ends_with(".mha") || name.ends_with(".mhd")) return Format::meta;
  if (request.labels)
    throw InputError(
        request.name, "", "has an extension that is not known",
        "Give labels as .seg.nrrd, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd, .vti or a DICOM segmentation");
  throw InputError(
      request.name, "", "has an extension that is not known",
      "Give a folder of DICOM slices, .zip, .tar.gz, .nii, .nii.gz, .nrrd, .nhdr, .mha, .mhd or .vti");
}

itk::ImageIOBase::Pointer io_for(Format format) {
  switch (format) {
    case Format::nifti:
      return itk::NiftiImageIO::New().GetPointer();
    case Format::nrrd:
      return itk::NrrdImageIO::New().GetPointer();
    case Format::meta:
      break;
  }
  return itk::MetaImageIO::New().GetPointer();
}

/// The NIfTI library takes the voxels of a.nii for those of a.nii.gz when both lie in one folder: give it a
/// folder with nothing else.
std::filesystem::path alone(const Request& request) {
  const bool packed = lower_name(request.path).ends_with("z");
  const std::filesystem::path link = request.scratch / (packed ? "input.nii.gz" : "input.nii");
  std::filesystem::create_symlink(std::filesystem::absolute(request.path), link);
  return link;
}

std::map<std::string, std::string> texts_of(const itk::ImageIOBase& io) {
  std::map<std::string, std::string> texts;
  for (const std::string& key : io.GetMetaDataDictionary().GetKeys()) {
    std::string value;
    if (itk::ExposeMetaData<std::string>(io.GetMetaDataDictionary(), key, value)) texts[key] = value;
  }
  return texts;
}

Claim claim_of(const Request& request, Format format) {
  return format == Format::nifti  ? claim_of_nifti(request)
         : format == Format::nrrd ? claim_of_nrrd(request)
                                  : claim_of_meta(request);
}

}  // namespace

RawVolume read_itk_file(const Request& request) {
  const Format format = format_of(request);
  const Claim claim = claim_of(request, format);
  std::error_code failure;
  raise_limits(static_cast<double>(std::filesystem::file_size(request.path, failure)),
               claim.size.cast<double>().prod() * claim.components);
  const itk::ImageIOBase::Pointer io = io_for(format);
  io->SetFileName((format == Format::nifti ? alone(request) : request.path).string());
  io->ReadImageInformation();

  RawVolume raw;
  raw.texts = texts_of(*io);
  raw.components = static_cast<int>(io->GetNumberOfComponents());
  raw.layers = format == Format::nrrd && raw.components > 1 && raw.texts.contains("Segment0_ID");

  const unsigned dimensions = io->GetNumberOfDimensions();
  for (unsigned axis = 3; axis < dimensions; ++axis)
    if (io->GetDimensions(axis) > 1)
      throw InputError(
          request.name, "dimension",
          "is a series of " + std::to_string(io->GetDimensions(axis)) + " volumes, not one volume",
          "Export a single time point");
  if (dimensions < 3)
    throw InputError(request.name, "dimension", "is a flat picture, not a volume", "Name a volume");
  Eigen::Vector3i size;
  Eigen::Vector3d spacing, origin;
  Eigen::Matrix3d direction;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto length = io->GetDimensions(axis);
    size[axis] = length > 100000 ? -1 : static_cast<int>(length);
    spacing[axis] = io->GetSpacing(axis);
    origin[axis] = io->GetOrigin(axis);
    for (unsigned row = 0; row < 3; ++row) direction(row, axis) = io->GetDirection(axis)[row];
  }
  check_value_count(request, size, raw.components);
  raw.grid = checked_grid(request, size, spacing, origin, direction);
  check_claim(request, claim, raw.grid);
  if (raw.components != claim.components)
    throw InputError(request.name, "components", "are counted differently by two readers",
                     "Export the volume again");
  request.progress(0.1);
  raw.voxels = read_buffer(request, *io);
  if (const auto modality = raw.texts.find("modality"); modality != raw.texts.end())
    raw.modality = lower_case(modality->second);  // DICOM's own word is "CT"
  return raw;
}

}  // namespace glisson::reader
