// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "glisson/volume/dicom_source.h"
#include "glisson/volume/io.h"
#include "glisson/volume/series.h"

static_assert(EIGEN_VERSION_AT_LEAST(3, 4, 0),
              "ITK's own, older Eigen came first; see this room's CMakeLists.txt");

namespace glisson::reader {

/// What a file holds, before it becomes an image or labels. Voxels are floats: every int16 and uint16 is one.
struct RawVolume {
  VolumeGrid grid;
  int components = 1;         ///< values a voxel, next to each other in memory
  bool layers = false;        ///< the components are layers of a segmentation, not a colour or a vector
  std::vector<float> voxels;  ///< components x grid.voxel_count() values
  std::string modality;       ///< "ct", "mr", "other"; empty: the file does not say
  std::string description;
  std::map<std::string, std::string> texts;  ///< the file's own key/value pairs
  DicomSource source = {};                   ///< of a DICOM series
};

/// What is being read, and what to call it in messages.
struct Request {
  std::filesystem::path path;
  std::string name;
  std::filesystem::path scratch;  ///< a folder of our own
  std::function<void(double)> progress;
  std::string series;   ///< of a DICOM folder: UID or number; empty: the only one
  bool labels = false;  ///< labels are to be read, not an image
};

/// @throws InputError, FileError, or whatever the libraries throw (they may also abort).
RawVolume read_dicom_folder(const Request& request);
/// A series below a folder, and the file of the slice in its middle.
struct ListedSeries {
  DicomSeries series;
  std::filesystem::path middle;  ///< in the folder; empty: it has no images
};
/// The series below the folder, by UID, without pictures; those of other objects than images, too.
std::vector<ListedSeries> list_dicom_folder(const Request& request);
/// A small picture of one DICOM file. @throws InputError as read_dicom_folder.
SeriesPicture dicom_picture(const Request& request);
/// Whether a file is a DICOM object, whatever it is called.
bool is_dicom(const std::filesystem::path& path);
/// A DICOM segmentation object; its segments become keys as Slicer writes them, in one layer. Key
/// "glisson_own": written by Glisson. @throws InputError as read_dicom_folder.
RawVolume read_dicom_segmentation(const Request& request);
RawVolume read_itk_file(const Request& request);
RawVolume read_vti_file(const Request& request);

/// @throws InputError of what is being read.
[[noreturn]] void refuse(const Request& request, const std::string& field, const std::string& problem,
                         const std::string& remedy);

/// Allows for what a file and its volume need: memory 16 bytes for each byte and each value, and a second of
/// processor time for each megabyte and two million values, beyond 1 GB and 20 s. A malformed length makes a
/// parser ask for gigabytes or loop, which a small computer pays for with its other programs.
void raise_limits(double file_bytes, double values);

/// Builds the grid. @throws InputError zero or absurd size or spacing, shear, not finite.
VolumeGrid checked_grid(const Request& request, const Eigen::Vector3i& size,
                        const Eigen::Vector3d& spacing_mm, const Eigen::Vector3d& origin_mm,
                        const Eigen::Matrix3d& direction);
/// @throws InputError when a volume of so many values cannot be meant.
void check_value_count(const Request& request, const Eigen::Vector3i& size, int components);

}  // namespace glisson::reader
