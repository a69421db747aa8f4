// SPDX-License-Identifier: GPL-3.0-or-later
#include "stereo_proof.h"

#include "glisson/core/marked_text.h"

namespace glisson::experiments {

const std::vector<Aim>& stereo_aims() {
  using enum Aim::Sense;
  using enum Evidence;
  static const std::vector<Aim> kAims = {
      {"opencas_sparse_points", QT_TRANSLATE_NOOP("cli", "real liver, features: points"), real, at_least,
       100.0, 0},
      {"opencas_sparse_median_mm",
       QT_TRANSLATE_NOOP("cli", "real liver, features: median to the CT surface, mm"), real, at_most, 0.65,
       2},
      {"opencas_sparse_within_3mm_share", QT_TRANSLATE_NOOP("cli", "real liver, features: share within 3 mm"),
       real, at_least, 0.95, 3},
      {"opencas_sparse_without_offset_median_mm",
       QT_TRANSLATE_NOOP("cli", "real liver, features: median without the common offset, mm"), real, at_most,
       0.5, 2},
      {"opencas_dense_median_mm", QT_TRANSLATE_NOOP("cli", "real liver, dense: median to the CT surface, mm"),
       real, at_most, 0.62, 2},
      {"opencas_dense_covered_share",
       QT_TRANSLATE_NOOP("cli", "real liver, dense: share of the region covered"), real, at_least, 0.95, 3},
      {"opencas_dense_without_offset_median_mm",
       QT_TRANSLATE_NOOP("cli", "real liver, dense: median without the common offset, mm"), real, at_most,
       0.5, 2},
      {"chessboard_rms_px", QT_TRANSLATE_NOOP("cli", "real chessboards: joint stereo rms, pixels"), phantom,
       at_most, 0.65, 3},
      {"chessboard_views_better_share",
       QT_TRANSLATE_NOOP("cli", "real chessboards: views that fit better left out than by the reference"),
       phantom, at_least, 1.0, 2},
      {"heart_sparse_epipolar_rms_px", QT_TRANSLATE_NOOP("cli", "silicone heart: rows, rms, pixels"), phantom,
       at_most, 0.8, 2},
      {"theatre_largest_bias_mm", QT_TRANSLATE_NOOP("cli", "in silico: largest bias of any trial, mm"),
       in_silico, at_most, 0.1, 3},
      {"theatre_normalised_median",
       QT_TRANSLATE_NOOP("cli", "in silico: normalised error, median of the trials (1: sigma is right)"),
       in_silico, at_most, 1.5, 2},
      {"theatre_normalised_median",
       QT_TRANSLATE_NOOP("cli", "in silico: normalised error, median of the trials (1: sigma is right)"),
       in_silico, at_least, 0.5, 2},
  };
  return kAims;
}

}  // namespace glisson::experiments
