// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"
#include "glisson/volume/image.h"

/// @file
/// Whose image it is and where it came from, as the slices of a DICOM series say it.

namespace glisson {

/// Texts are UTF-8, and empty where the files are silent or the image is of no DICOM series.
struct DicomSource {
  std::string patient, patient_id, birth_date;  ///< "1960-01-31"
  std::string study_uid, series_uid, frame_of_reference_uid;
  std::string slice_class_uid;          ///< SOPClassUID of the slices
  std::vector<std::string> slice_uids;  ///< SOPInstanceUID of each slice k; empty: unknown

  bool empty() const { return *this == DicomSource(); }
  bool operator==(const DicomSource&) const = default;
};

/// An image with what its files say of where it came from.
struct Scan {
  Image image;
  DicomSource source;
  /// Files that a DICOMDIR names, from its folder, and that are not there.
  std::vector<std::string> missing = {};
};
/// As read_image (io.h), with what a DICOM series says of its source. @throws as read_image, and InputError
/// for slices of several patients.
Cancellable<Scan> read_scan(const std::filesystem::path& path, const RunContext& context,
                            const std::string& series = {});

}  // namespace glisson
