// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/marked_text.h"
#include "pulled_proof.h"

namespace glisson::experiments {

const std::vector<Aim>& pulled_aims() {
  using enum Aim::Sense;
  using enum Evidence;
  static const std::vector<Aim> kAims = {
      {"sequence_first_mm",
       QT_TRANSLATE_NOOP("cli", "elastic_sequence: mean error of the first of its frames, mm"), in_silico,
       at_most, 0.35, 2},
      {"sequence_followed_mm",
       QT_TRANSLATE_NOOP("cli", "elastic_sequence: mean error over its 50 frames, followed, mm"), in_silico,
       at_most, 0.35, 2},
      {"pulled_held_worst_mm",
       QT_TRANSLATE_NOOP("cli", "held organs: mean error of the worst of them, clouds without noise, mm"),
       in_silico, at_most, 0.7, 2},
      {"pulled_held_followed_worst_mm",
       QT_TRANSLATE_NOOP(
           "cli", "held organs: mean error of the worst frame of any, followed, clouds without noise, mm"),
       in_silico, at_most, 0.7, 2},
      {"pulled_loose_mean_mm",
       QT_TRANSLATE_NOOP("cli", "loose organs, place unknown: mean error, clouds without noise, mm"),
       in_silico, at_most, 0.85, 2},
  };
  return kAims;
}

}  // namespace glisson::experiments
