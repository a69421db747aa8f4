// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gdcmImageReader.h>
#include <itkMetaDataDictionary.h>

#include <array>
#include <optional>
#include <string>

#include "raw_volume.h"

/// @file
/// How the pixels of a DICOM slice are stored, and whether all of them are there.

namespace glisson::reader {

/// What one slice says of how its pixels become intensities.
struct PixelRule {
  std::optional<double> slope, intercept;
  std::array<std::string, 4> bits;  ///< BitsAllocated, BitsStored, HighBit, PixelRepresentation
};

/// The slices of one series are of one scanner and one reconstruction: refuses one whose bits differ, one
/// that alone has or lacks a rescale, and in CT one with another rescale. MR, PET and SPECT scale each slice
/// to its own range, so that another rescale is no sign of damage there. @throws InputError naming slice and
/// field.
void check_same_rule(const Request& request, const std::string& modality, const std::string& first_file,
                     const PixelRule& first, const std::string& file, const PixelRule& rule);

/// Compares the bytes of pixels in the file with those that `bytes` pixels need: GDCM fills up what an
/// uncompressed slice lacks, passes over what is too much, and takes what there is of a compressed one that
/// was cut. @throws InputError.
void check_pixel_bytes(const Request& request, const std::filesystem::path& path, const gdcm::Image& image,
                       std::size_t bytes);

enum class StoredValue {
  whole,
  cut,      ///< fewer bytes than are announced
  shifted,  ///< what follows the last byte is no element: bytes were put in before it
};

/// How the file holds its element of pixels of that length. GDCM keeps the length that the element announces,
/// whatever it has read, and passes over what follows. The length keeps the element apart from that of an
/// icon, which has the same tag and stands before it. Whole where none is found: the file is deflated.
StoredValue value_in(const std::string& bytes, std::uint32_t length);

/// Appends a slice's intensities, row by row. By GDCM and not by ITK, which turns the numbers of MONOCHROME1
/// round: that says how to draw them only.
/// @param size pixels along a row, and rows. @throws InputError pixels that are cut, cannot be decoded, are
/// in a format that is not known or not of that size.
void append_slice(const Request& request, const std::filesystem::path& path, const Eigen::Vector2i& size,
                  std::vector<float>& voxels);

}  // namespace glisson::reader
