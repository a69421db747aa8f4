// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raw_volume.h"

/// @file
/// A second reading of a file's header, by ourselves: where a library mends, guesses or fills up without a
/// word, the two readings differ, and the file is refused.

namespace glisson::reader {

/// What a header says of itself.
struct Claim {
  Eigen::Vector3i size = Eigen::Vector3i::Zero();
  int components = 1;
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();  ///< LPS
  Eigen::Matrix3d direction = Eigen::Matrix3d::Zero();
  /// How far, as a share of the extent, two readings may lie apart: numbers of single precision.
  double precision = 1e-5;
};

/// Refuses what the libraries read without a word: two orientations that disagree, none at all, shear, axes
/// without length, sizes below one, an unknown unit, number type or encoding, data that are shorter or longer
/// than the header says, or not compressed as it says. @throws InputError naming the field; FileError.
Claim claim_of_nifti(const Request& request);
Claim claim_of_nrrd(const Request& request);
Claim claim_of_meta(const Request& request);

/// @throws InputError when the library's grid is not the claimed one.
void check_claim(const Request& request, const Claim& claim, const VolumeGrid& grid);

/// Lengths and directions of the axes, from vectors in mm. @throws InputError an axis without a finite
/// length.
void set_axes(const Request& request, const char* field, const Eigen::Matrix3d& vectors_mm, Claim& claim);

/// Whole numbers or numbers of a field, separated by blanks: exactly `count` of them, finite.
/// @throws InputError naming the field.
std::vector<double> numbers_in(const Request& request, const std::string& field, const std::string& text,
                               std::size_t count);
/// The same for sizes: whole numbers from 1 to 100000.
std::vector<int> sizes_in(const Request& request, const std::string& field, const std::string& text,
                          std::size_t count);

/// How the voxels lie in a file.
struct Stored {
  std::filesystem::path file;
  std::uintmax_t offset = 0;  ///< where they begin
  bool at_end = false;        ///< the last so many bytes are meant, wherever they begin
  bool packed = false;        ///< by zlib or gzip
  double bytes = 0.0;         ///< unpacked
  double row_bytes = 1.0;     ///< what is over by less than that is no sign of a wrong header
  const char* packed_field = "encoding";
};
/// Counts the bytes. @throws InputError too few, too many, or not packed as they should be.
void check_stored(const Request& request, const Stored& stored);

/// A file that a header names, in the header's own folder. @throws InputError elsewhere, or missing.
std::filesystem::path file_beside(const Request& request, const char* field, const std::string& named);

}  // namespace glisson::reader
