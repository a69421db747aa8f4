// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gdcmReader.h>

#include <optional>
#include <string>
#include <vector>

#include "raw_volume.h"

/// @file
/// What DICOM files say of themselves and of their series, for people to choose by. What is measured with is
/// read strictly, see dicom_series.cpp.

namespace glisson::reader {

constexpr int kMostPixels = 8192;  ///< a side: of no scanner

/// A DICOM file and the series that it says it belongs to.
struct DicomObject {
  std::filesystem::path path;
  DicomSeries series;
  std::optional<Eigen::Vector3d> origin_mm = {};  ///< of its first pixel
  std::string birth_date = {};                    ///< of the patient
};

/// A tag's text without the blanks about it; empty: there is none.
std::string text_of(const gdcm::DataSet& data, const gdcm::Tag& tag);
/// The same for people, in UTF-8, at most 200 bytes; names without the carets between their parts.
std::string words_of(const gdcm::DataSet& data, const gdcm::Tag& tag);
/// What one file says of its series.
DicomObject described(const std::filesystem::path& path, const gdcm::DataSet& data);
/// All below the folder. @param all other objects than images, too. @throws InputError, FileError when there
/// is no image, or a file that cannot be read.
std::vector<DicomObject> objects_below(const Request& request, bool all);
/// By UID, each once.
std::vector<ListedSeries> series_of(const Request& request, const std::vector<DicomObject>& objects);
/// Of files that are there.
double total_bytes(const std::vector<std::filesystem::path>& files);

}  // namespace glisson::reader
