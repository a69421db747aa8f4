// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_proof.h"

#include "glisson/core/marked_text.h"

namespace glisson::experiments {

const std::vector<Aim>& registration_aims() {
  using enum Aim::Sense;
  using enum Evidence;
  static const std::vector<Aim> kAims = {
      {"registration_validation_far_told_share",
       QT_TRANSLATE_NOOP("cli", "registrations over 10 mm at a lesion, refused or doubted, share"), in_silico,
       at_least, 0.99, 3},
      {"registration_validation_near_doubted_share",
       QT_TRANSLATE_NOOP("cli", "registrations under 3 mm at all lesions, doubted, share"), in_silico,
       at_most, 0.05, 3},
      {"registration_validation_expected_coverage",
       QT_TRANSLATE_NOOP("cli", "lesions within their 95 % ellipsoid, share, at least"), in_silico, at_least,
       0.90, 3},
      {"registration_validation_expected_outside",
       QT_TRANSLATE_NOOP("cli", "lesions outside of their 95 % ellipsoid, share"), in_silico, at_least, 0.02,
       3},
      {"registration_validation_expected_correlation",
       QT_TRANSLATE_NOOP("cli", "expected against true error of a lesion, correlation"), in_silico, at_least,
       0.8, 2},
      {"registration_validation_30_all_mean_mm",
       QT_TRANSLATE_NOOP("cli", "mean error, 30 % of the surface seen, mm"), in_silico, at_most, 2.5, 2},
      {"registration_validation_20_all_mean_mm",
       QT_TRANSLATE_NOOP("cli", "mean error, 20 % of the surface seen, mm"), in_silico, at_most, 4.0, 2},
      {"registration_validation_30_untold_share",
       QT_TRANSLATE_NOOP("cli", "registrations over 2.5 mm on average, 30 % seen, not doubted, share"),
       in_silico, at_most, 0.0, 2},
      {"registration_validation_20_untold_share",
       QT_TRANSLATE_NOOP("cli", "registrations over 4 mm on average, 20 % seen, not doubted, share"),
       in_silico, at_most, 0.0, 2},
      {"registration_validation_10_untold_share",
       QT_TRANSLATE_NOOP("cli", "registrations over 6 mm on average, 10 % seen, not doubted, share"),
       in_silico, at_most, 0.0, 2},
      {"registration_validation_rigid_beaten_share",
       QT_TRANSLATE_NOOP("cli", "cases in which the best rigid alignment is beaten, share"), in_silico,
       at_least, 1.0, 2},
  };
  return kAims;
}

}  // namespace glisson::experiments
