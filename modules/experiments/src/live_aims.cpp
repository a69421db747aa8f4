// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_proof.h"

#include "glisson/core/marked_text.h"

namespace glisson::experiments {

const std::vector<Aim>& live_aims() {
  using enum Aim::Sense;
  using enum Evidence;
  static const std::vector<Aim> kAims = {
      {"live_far_hidden_share", QT_TRANSLATE_NOOP("cli", "live: frames over 10 mm that are not valid, share"),
       in_silico, at_least, 0.99, 3},
      {"live_near_sound_valid_share",
       QT_TRANSLATE_NOOP("cli", "live: frames under 3 mm without a fault that are valid, share"), in_silico,
       at_least, 0.95, 3},
      {"live_latest_seconds", QT_TRANSLATE_NOOP("cli", "live: longest time until an overlay goes, s"),
       in_silico, at_most, 0.5, 2},
      {"live_scope_mean_mm",
       QT_TRANSLATE_NOOP("cli",
                         "live: largest error at a lesion with a scope in a hand, mean over frames, mm"),
       in_silico, at_most, 1.5, 2},
      {"live_return_seconds",
       QT_TRANSLATE_NOOP("cli", "live: longest time until a right overlay is back after a jump, s"),
       in_silico, at_most, 1.0, 2},
      {"live_of_frozen_share",
       QT_TRANSLATE_NOOP("cli", "live: error over that of a model that stays, in the worst scenario"),
       in_silico, at_most, 0.5, 2},
      {"live_lesion_far_hidden_share",
       QT_TRANSLATE_NOOP("cli", "live: single lesions over 10 mm off that are not drawn as such, share"),
       in_silico, at_least, 0.99, 3},
      {"live_lesion_near_sound_valid_share",
       QT_TRANSLATE_NOOP("cli", "live: single lesions under 3 mm off without a fault that are, share"),
       in_silico, at_least, 0.95, 3},
      {"following_long_moved_tre_mm",
       QT_TRANSLATE_NOOP("cli", "live, long: mean error since the start where the organ has moved, mm"),
       in_silico, at_most, 1.5, 2},
      {"following_long_moved_motion_mm",
       QT_TRANSLATE_NOOP("cli", "live, long: how far it has moved there, mean, mm"), in_silico, at_least, 2.3,
       2},
      {"following_worst_of_motion_share",
       QT_TRANSLATE_NOOP("cli",
                         "live, long: error over the organ's own motion, in the worst film (hands, tools)"),
       in_silico, at_most, 0.5, 2},
      {"following_far_shown_frames",
       QT_TRANSLATE_NOOP("cli", "live, long: frames over 10 mm at a lesion that are shown"), in_silico,
       at_most, 0.0, 0},
      {"live_tissue_far_hidden_share",
       QT_TRANSLATE_NOOP("cli", "live, tissue: frames over 10 mm that are not valid, share"), real, at_least,
       0.99, 3},
      {"live_tissue_near_sound_valid_share",
       QT_TRANSLATE_NOOP("cli", "live, tissue: frames under 3 mm without a fault that are valid, share"),
       real, at_least, 0.95, 3},
      {"live_tissue_latest_seconds",
       QT_TRANSLATE_NOOP("cli", "live, tissue: longest time until an overlay goes, s"), real, at_most, 0.5,
       2},
      {"live_tissue_scope_mean_mm",
       QT_TRANSLATE_NOOP("cli",
                         "live, tissue: largest error at a place below the surface with a scope in a "
                         "hand, mean over frames, mm"),
       real, at_most, 1.5, 2},
      {"live_tissue_return_seconds",
       QT_TRANSLATE_NOOP("cli", "live, tissue: longest time until a right overlay is back after a jump, s"),
       real, at_most, 1.0, 2},
      {"live_tissue_of_frozen_share",
       QT_TRANSLATE_NOOP("cli", "live, tissue: error over that of a model that stays, in the worst scenario"),
       real, at_most, 0.5, 2},
      {"live_heart_far_hidden_share",
       QT_TRANSLATE_NOOP("cli", "live, heart: frames over 10 mm that are not valid, share"), phantom,
       at_least, 0.99, 3},
      {"live_heart_near_sound_valid_share",
       QT_TRANSLATE_NOOP("cli", "live, heart: frames under 3 mm without a fault that are valid, share"),
       phantom, at_least, 0.95, 3},
      {"live_heart_latest_seconds",
       QT_TRANSLATE_NOOP("cli", "live, heart: longest time until an overlay goes, s"), phantom, at_most, 0.5,
       2},
      {"live_heart_scope_mean_mm",
       QT_TRANSLATE_NOOP("cli",
                         "live, heart: largest error at a place below the surface with a scope in a "
                         "hand, mean over frames, mm"),
       phantom, at_most, 1.5, 2},
      {"live_heart_return_seconds",
       QT_TRANSLATE_NOOP("cli", "live, heart: longest time until a right overlay is back after a jump, s"),
       phantom, at_most, 1.0, 2},
      {"live_heart_of_frozen_share",
       QT_TRANSLATE_NOOP("cli", "live, heart: error over that of a model that stays, in the worst scenario"),
       phantom, at_most, 0.5, 2},
  };
  return kAims;
}

}  // namespace glisson::experiments
