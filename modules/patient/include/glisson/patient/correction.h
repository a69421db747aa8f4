// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// @file
/// What a person has said of where a place of the tracked organ is, and how it is written: a line of JSON
/// each, in frames.jsonl and in files of their own.

namespace glisson {

/// One of the laparoscope's two pictures.
enum class StereoView { left, right };
inline constexpr StereoView kStereoViews[] = {StereoView::left, StereoView::right};

/// What of the organ was taken hold of.
enum class CorrectedFeature { surface, margin, notch, vessel };
inline constexpr CorrectedFeature kCorrectedFeatures[] = {CorrectedFeature::surface, CorrectedFeature::margin,
                                                          CorrectedFeature::notch, CorrectedFeature::vessel};

/// Somebody sees a place of the organ elsewhere than it is drawn. It says where along two directions of the
/// picture, and nothing of the depth.
struct Correction {
  CorrectedFeature feature = CorrectedFeature::surface;
  Eigen::Vector3d place_in_ct = Eigen::Vector3d::Zero();  ///< the tissue's place in the model, metres
  StereoView view = StereoView::left;
  /// Pixels of that view: where the place was drawn, and where it is seen in the same picture.
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  /// Standard deviation of `to`. A hand places a point within two or three pixels of a screen, and where
  /// exactly a margin ends is a matter of as many more.
  double sigma_px = 4.0;
  /// Pieces of one drag carry one number: each takes the place of the former. 0: it is whole.
  int gesture = 0;

  /// @throws InputError what is not finite, or no deviation.
  void validate() const;
};

/// A correction that stands.
struct CorrectionMade {
  Correction correction;
  int frame = 0;  ///< after which it was made
  double seconds = 0.0;
  double moved = 0.0;  ///< metres; mean way of the model's nodes by it
};

/// A line of a file of corrections.
struct CorrectionLine {
  int frame = 0;
  double seconds = 0.0;
  /// Empty: the last one is taken back.
  std::optional<Correction> correction;
  /// Its `feature` and `place_in_ct` were given; otherwise they are what lies at `from`.
  bool has_place = false;
};

/// Without a newline.
std::string correction_line(const CorrectionMade& made);
std::string undone_line(int frame, double seconds);
/// Lines without a correction, as frames.jsonl has them, are left out. In the order of the frames.
/// @throws FileError; InputError naming file and line.
std::vector<CorrectionLine> read_corrections(const std::filesystem::path& path);

}  // namespace glisson
