// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glisson::guidance {

/// From when the evidence speaks against an overlay. Limits are in standard deviations where there are any;
/// a reason goes again below `relief` times its limit.
struct JudgeOptions {
  bool enabled = true;
  double every = 0.2;  ///< seconds of the source between two fresh surfaces, to the nearest frame
  double lag = 0.1;    ///< likewise until one is compared; it is waited for then, so that results repeat
  double gap = 2.0;    ///< standard deviations, Evidence::gap
  /// Likewise, its root mean square over the last ten surfaces (two seconds), or over all since the start if
  /// there were fewer, with a limit that is higher accordingly: each as improbable for a right overlay as
  /// `gap` in one. That is chi-square's quantile of 99.9 % if 4.5 regions err on their own in each surface, a
  /// number taken from `gap` and not measured. Of the limit right overlays of the real tissue reached 0.94.
  double mean_gap = 1.33;
  double local = 3.2;        ///< standard deviations, Evidence::local
  double behind = 0.06;      ///< share, Evidence::behind
  double lifted = 0.06;      ///< share, Evidence::lifted
  double pull = 6e-3;        ///< metres, Evidence::pull, where it is ...
  double pull_sigmas = 3.0;  ///< ... also so many of its standard deviations
  double missing = 0.4;  ///< Evidence::missing: more is covered. What a scope in a hand shows varies by 0.3.
  double least_supported = 0.1;  ///< Evidence::supported: less cannot be judged
  double unknown = 10e-3;     ///< metres, Evidence::pull_sigma: what is seen does not tell where the organ is
  double before = 0.5;        ///< Evidence::before: more is covered, at the start, too
  double contrast = 0.55;     ///< Evidence::contrast
  double least_signal = 1.0;  ///< detail over noise that a picture has at least: less at the start is no norm
  double motion = 2.5;        ///< Evidence::motion: less is none
  /// Evidence::fresh of a still picture. Up to `repeated` it is a copy; above `fresh` it is live; between
  /// them it may be either. Noise that has grown by the factor `louder` since the scene last moved makes it a
  /// copy, too: somebody adds the noise. A scene that has not moved yet is never taken for live.
  double repeated = 0.1, fresh = 0.7, louder = 1.2;
  /// Pixels, Evidence::rows: from here on the two views show different moments. If the points scattered by
  /// more about their median at first (one deviation), that is the limit. It grows with widths above 960.
  double rows = 0.35;
  double relief = 0.8;  ///< share of every limit below which a reason goes again, so that it does not flicker
  /// @throws InputError naming the option.
  void validate() const;
};

}  // namespace glisson::guidance
