// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"

/// @file
/// The DICOM series of a folder, for a person to choose from: what their files say of them, what speaks
/// against each as the CT to work on, and the likeliest first.

namespace glisson {

/// Pixels of one slice, 0 black to 255 white, i fastest.
struct SeriesPicture {
  int width = 0, height = 0;
  double pixel_aspect = 1.0;  ///< height of a pixel over its width
  std::vector<std::uint8_t> grey;
  int values = 0;  ///< different intensities in the whole slice, counted up to 256; 0: it cannot be decoded
};

/// A series of DICOM objects, as its files say it. Texts are UTF-8, and empty where the files are silent.
struct DicomSeries {
  std::string uid;     ///< SeriesInstanceUID; may be empty in broken files
  std::string number;  ///< SeriesNumber; may be empty, and need not be unique
  std::string description, modality;
  int slices = 0;      ///< files
  bool images = true;  ///< else reports, contours, plans
  std::string patient = {}, patient_id = {};
  std::string date = {};   ///< "2026-01-31", of the series, else of the study
  std::string study = {};  ///< the study's description
  std::string protocol = {};
  std::string kind = {};                               ///< ImageType: "ORIGINAL\PRIMARY\AXIAL"
  bool contrast_agent = false;                         ///< one is named
  Eigen::Vector2i pixels = Eigen::Vector2i::Zero();    ///< columns, rows
  Eigen::Vector2d pixel_mm = Eigen::Vector2d::Zero();  ///< across columns and rows; 0: unsaid
  double thickness_mm = 0.0;                           ///< of a slice; 0: unsaid
  double gap_mm = 0.0;                                 ///< from slice to slice, by their places; 0: unknown
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();    ///< of the slices, LPS; zero: unknown, or they differ
  int frames = 1;                                      ///< of a file, the most
  SeriesPicture picture = {};                          ///< the slice in the middle; empty: none could be made
};

/// What speaks against a series as the one to plan on, the gravest last.
enum class SeriesDoubt {
  derived,         ///< ImageType: made from other images
  other_modality,  ///< neither CT nor MR
  few_slices,      ///< under 20
  not_axial,       ///< slices more than 30 degrees from across the body
  reformatted,     ///< multi-planar, projections, curved
  screenshot,      ///< secondary capture, dose sheet, or colour
  localizer,       ///< scout
  frames,          ///< several frames in a file, which is not read
  mask,            ///< two values or fewer in the slice in the middle
  no_image         ///< segmentation object, contours, report
};
/// In the order of the list above, each once.
std::vector<SeriesDoubt> doubts_about(const DicomSeries& series);
/// Whether it can be read as a volume at all, as far as its headers tell.
bool can_be_read(const DicomSeries& series);

/// The phase of the contrast agent that description or protocol name, in some languages.
enum class SeriesPhase { unsaid, native, arterial, portal_venous, delayed };
SeriesPhase phase_of(const DicomSeries& series);

/// The likeliest to plan on first: without doubt before any, the less grave doubt before the graver; then CT
/// before MR; then no other phase than portal venous; then most slices; then thinnest; then number and UID.
void sort_by_likelihood(std::vector<DicomSeries>& all);

/// The series below a folder, or in an archive of one, sorted by likelihood. Pictures are of the 60
/// likeliest.
/// @throws as read_image, also when there is no DICOM image.
Cancellable<std::vector<DicomSeries>> list_series(const std::filesystem::path& path,
                                                  const RunContext& context);

}  // namespace glisson
