// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <future>

#include "alarm.h"
#include "frame_clock.h"
#include "fresh_noise.h"
#include "glisson/core/error.h"
#include "motion_check.h"
#include "picture_check.h"
#include "standing_parts.h"
#include "surface_check.h"

namespace glisson::guidance {
namespace {

constexpr double kLeast = 1e-6;          ///< below what is divided by
constexpr double kPictureSeconds = 0.1;  ///< contrast changes slowly
constexpr int kRefuted = 2;              ///< bad surfaces in a row, as many as raise a doubt
/// Surfaces that may neither confirm nor refute a place before it counts as not found.
constexpr int kMostUndecided = 6;
/// Over up to so many surfaces in a row the gap's mean square is held against its own, lower limit.
constexpr std::size_t kSurfacesInMean = 10;
/// So many are made one after the other at the start: it has to prove itself sooner than what was followed.
constexpr int kSurfacesAtStart = 5;
/// Regions of the picture that err on their own in one surface (JudgeOptions::mean_gap).
constexpr double kRegionsAlone = 4.5;

/// What the root mean square of so many independent normal deviates, of standard deviation one, exceeds once
/// in a thousand times: chi-square's quantile by Wilson and Hilferty (1931).
double rare_rms(double squares) {
  constexpr double kNormalQuantile = 3.0902;
  const double variance = 2.0 / (9.0 * squares);
  return std::pow(1.0 - variance + kNormalQuantile * std::sqrt(variance), 1.5);
}

}  // namespace

void JudgeOptions::validate() const {
  const OptionCheck demand("judge options");
  demand(every > 0.0, "every", every, "Give a positive number of seconds");
  demand(lag >= 0.0 && lag < every, "lag", lag, "Give less than lies between two checks");
  demand(gap > 0.0, "gap", gap, "Give a positive number");
  demand(mean_gap > 0.0, "mean_gap", mean_gap, "Give a positive number");
  demand(local > 0.0, "local", local, "Give a positive number");
  demand(lifted > 0.0 && lifted <= 1.0, "lifted", lifted, "Give a share above 0, at most 1");
  demand(behind > 0.0 && behind <= 1.0, "behind", behind, "Give a share above 0, at most 1");
  demand(pull > 0.0, "pull", pull, "Give a positive length in metres");
  demand(pull_sigmas > 0.0, "pull_sigmas", pull_sigmas, "Give a positive number");
  demand(missing > 0.0 && missing <= 1.0, "missing", missing, "Give a share above 0, at most 1");
  demand(least_supported >= 0.0 && least_supported <= 1.0, "least_supported", least_supported,
         "Give a share from 0 to 1");
  demand(unknown > 0.0, "unknown", unknown, "Give a positive length in metres");
  demand(before > 0.0 && before <= 1.0, "before", before, "Give a share above 0, at most 1");
  demand(least_signal >= 0.0, "least_signal", least_signal, "Give a number from zero");
  demand(contrast >= 0.0 && contrast <= 1.0, "contrast", contrast, "Give a share from 0 to 1");
  demand(motion >= 0.0, "motion", motion, "Give a number from zero");
  demand(repeated >= 0.0 && repeated <= fresh, "repeated", repeated, "Give a share up to that of `fresh`");
  demand(fresh <= 1.0, "fresh", fresh, "Give a share from 0 to 1");
  demand(louder > 1.0, "louder", louder, "Give more than one");
  demand(rows > 0.0, "rows", rows, "Give a positive number of pixels");
  demand(relief > 0.0 && relief <= 1.0, "relief", relief, "Give a share above 0, at most 1");
}

struct Judge::Impl {
  Impl(const PatientModel& model, const StereoRig& given_rig, const Picture& mask, const JudgeOptions& given)
      : options(given), rig(given_rig), surface(model, rig, mask), parts(rig) {
    options.validate();
  }
  ~Impl() {
    if (pending.valid()) pending.wait();  // it reads this
  }

  void begin(const StereoFrame& first, const Points& nodes) {
    if (pending.valid()) pending.wait();
    pending = {};
    clock = {};
    clock.tick(first.seconds);
    looked = looked_at_picture = 0.0;
    undecided = false;
    looks = 1;
    last_gaps.clear();
    is_misplaced = false;
    motion = {};
    noise = {};
    measured = {};
    parts = StandingParts(rig);
    left_signal = signal_at_start(first.left, options.least_signal);
    right_signal = signal_at_start(first.right, options.least_signal);
    shape = nodes;
    tissue.clear();
    surface.forget();
    const SurfaceEvidence seen = surface.check(first.left, first.right, nodes, shape);
    take(seen);
    if (!is_silent()) last_gaps.push_back(evidence.gap);
    tissue.add(seen.tissue, seen.eye);
    apart.set(apartness() >= 1.0);
    covered.set(coverage() >= 1.0);
    measured.poor = options.contrast / std::max(measured_contrast(first), kLeast);
    poor.set(measured.poor > 1.0);
    for (Alarm* alarm : {&stands, &views, &repeated, &not_alive, &copies, &part_stands}) alarm->set(false);
    evidence.judged = true;
    learn();
  }

  /// What is seen of the organ while nothing speaks against the overlay, by this surface nor by any other.
  void learn() {
    if (!undecided && apartness() < 1.0 && coverage() < 1.0 && verdict() == Validity::valid) surface.learn();
  }

  void take(const SurfaceEvidence& seen) {
    evidence.supported = seen.supported;
    evidence.missing = seen.missing;
    evidence.gap = seen.gap;
    evidence.local = seen.local;
    evidence.behind = seen.behind;
    evidence.before = seen.before;
    evidence.lifted = seen.lifted;
    evidence.pull = seen.pull;
    evidence.pull_sigma = seen.pull_sigma;
  }
  /// 1 and more: stereo speaks against the overlay. The largest of what it may say.
  double apartness() const {
    const double significant = evidence.pull / (options.pull_sigmas * std::max(evidence.pull_sigma, kLeast));
    return std::max({evidence.gap / options.gap, evidence.local / options.local,
                     evidence.behind / options.behind, evidence.lifted / options.lifted,
                     std::min(evidence.pull / options.pull, significant)});
  }
  /// Stereo does not tell where the organ is: that it has nothing against the overlay is no agreement.
  bool is_silent() const { return evidence.pull_sigma >= options.unknown && apartness() < 1.0; }
  /// 1 and more: too much is covered.
  double coverage() const {
    return std::max({options.least_supported / std::max(evidence.supported, kLeast),
                     evidence.missing / options.missing, evidence.before / options.before,
                     evidence.pull_sigma / options.unknown});
  }

  void look_at_surface(const StereoFrame& frame, const std::vector<FollowedPoint>& points,
                       const Points& nodes, const Picture& not_liver) {
    compare_surface();
    // At the start, and while nothing is shown because the model was set elsewhere, one surface is made after
    // the other.
    const bool is_new = undecided || looks < kSurfacesAtStart;
    if (!pending.valid() && clock.is_due(looked, is_new ? options.lag : options.every)) {
      looked = clock.now();
      pending = std::async(std::launch::async, [this, frame, points, nodes, not_liver, now = shape] {
        return surface.check(frame.left, frame.right, nodes, now, points, not_liver);
      });
      compare_surface();
    }
  }
  /// Of `lag` ago.
  void compare_surface() {
    if (!pending.valid() || !clock.is_due(looked, options.lag)) return;
    const SurfaceEvidence seen = pending.get();
    take(seen);
    // Nothing hides the organ, both views show this moment, and it was found: what is seen is its tissue.
    const bool is_now = !shows_old() && !stands.stands() && !views.stands();
    if (!undecided && !poor.stands() && is_now) tissue.add(seen.tissue, seen.eye);
    if (!is_silent()) {
      apart.push(apartness(), 1.0, options.relief);
      look_at_mean_gap();
      against = apartness() >= 1.0 ? against + 1 : 0;
    }
    covered.push(coverage(), 1.0, options.relief);
    learn();
    ++looks;
    undecided = undecided && apart.stands() && against < kRefuted && looks < kMostUndecided;
  }
  /// Matching's errors change from picture to picture, a wrong place stays: the more surfaces since it was
  /// set, the less their mean may be off.
  void look_at_mean_gap() {
    last_gaps.push_back(evidence.gap);
    if (last_gaps.size() > kSurfacesInMean) last_gaps.pop_front();
    if (last_gaps.size() < 2) return;  // `gap` is the limit of one
    double squares = 0.0;
    for (const double gap : last_gaps) squares += gap * gap;
    const auto n = static_cast<double>(last_gaps.size());
    const double limit =
        options.mean_gap * rare_rms(kRegionsAlone * n) / rare_rms(kRegionsAlone * kSurfacesInMean);
    measured.misplaced = std::sqrt(squares / n) / limit;
    is_misplaced = measured.misplaced >= (is_misplaced ? options.relief : 1.0);
  }
  void distrust() {
    if (pending.valid()) pending.wait();
    pending = {};
    apart.set(true);
    is_misplaced = false;
    measured.misplaced = 0.0;
    last_gaps.clear();
    undecided = true;
    against = looks = 0;
    looked = clock.now() - options.every;  // the next frame is looked at
  }
  /// Each view against its own start: cameras and lamps differ.
  double measured_contrast(const StereoFrame& frame) const {
    return std::min(measure(frame.left).signal() / std::max(left_signal, kLeast),
                    measure(frame.right).signal() / std::max(right_signal, kLeast));
  }
  void look_at_pictures(const StereoFrame& frame) {
    if (!clock.is_due(looked_at_picture, kPictureSeconds)) return;
    looked_at_picture = clock.now();
    evidence.contrast = measured_contrast(frame);
    measured.poor = options.contrast / std::max(evidence.contrast, kLeast);
    poor.push(measured.poor, 1.0, options.relief);
  }
  void look_at_motion(const StereoFrame& frame, const std::vector<FollowedPoint>& points) {
    motion.push(points, rig, frame.seconds);
    noise.push(frame, clock);
    parts.push(frame, points, clock);
    measured.part_stands = parts.any() ? 1.0 : 0.0;
    part_stands.push(measured.part_stands, 1.0, options.relief, clock.passed());
    const double left = motion.motion_left(), right = motion.motion_right();
    evidence.rows = motion.rows();
    const double across = std::abs(evidence.rows) / motion.rows_limit(options.rows);
    measured.views = std::max(across, std::abs(motion.depth_off()) / options.pull);
    views.push(measured.views, 1.0, options.relief, clock.passed());
    measured.repeated = measured.not_alive = measured.copies = 0.0;
    if (left < 0.0 || right < 0.0) return look_at_copies();
    copies.set(false);
    evidence.motion = std::min(left, right);
    if (evidence.motion >= options.motion) noise.learn();
    measured.stands = options.motion / std::max(evidence.motion, kLeast);
    stands.push(measured.stands, 1.0, options.relief, clock.passed());
    evidence.fresh = noise.fresh();
    const double fresh = std::max(evidence.fresh, kLeast);
    measured.repeated = std::max(options.repeated / fresh, noise.louder() / options.louder);
    repeated.push(measured.repeated, 1.0, options.relief, clock.passed());
    // Without a time in which it moved, a picture that stood from the first could be a copy with noise.
    measured.not_alive = noise.louder() > 0.0 ? options.fresh / fresh : 1.0;
    not_alive.push(measured.not_alive, 1.0, options.relief, clock.passed());
  }

  /// Where too few points lie together to tell of motion, a picture that comes again tells by itself; and one
  /// that is new, with no more noise than is usual, is none that stood before.
  void look_at_copies() {
    if (!motion.is_whole() || noise.fresh() < 0.0) return;
    evidence.fresh = noise.fresh();
    const double fresh = std::max(evidence.fresh, kLeast);
    measured.copies = options.repeated / fresh;
    copies.push(measured.copies, 1.0, options.relief, clock.passed());
    const bool is_new = options.fresh < options.relief * fresh && noise.louder() < options.louder;
    stands.push(is_new ? 0.0 : 0.5 * (1.0 + options.relief), 1.0, options.relief, clock.passed());
  }

  /// The picture, or a part of it, is one of before.
  bool shows_old() const {
    return (stands.stands() && repeated.stands()) || copies.stands() || part_stands.stands();
  }
  bool refutes() const { return apart.stands() || is_misplaced; }
  /// As verdict() puts the reasons together, without waiting for any.
  double strength() const {
    const double still = std::min(measured.stands, std::max(measured.repeated, measured.not_alive));
    return std::max({apartness(), measured.misplaced, coverage(), measured.poor, measured.views, still,
                     measured.copies, measured.part_stands});
  }
  Validity verdict() const {
    if (views.stands()) return Validity::views_apart;
    if (shows_old()) return Validity::picture_stands;
    if (refutes()) return Validity::surface_apart;
    if (stands.stands() && not_alive.stands()) return Validity::picture_still;
    if (poor.stands()) return Validity::poor_picture;
    return covered.stands() ? Validity::partly_covered : Validity::valid;
  }

  JudgeOptions options;
  StereoRig rig;
  SurfaceCheck surface;
  MotionCheck motion;
  FreshNoise noise;
  StandingParts parts;
  Evidence evidence;
  double left_signal = 0.0, right_signal = 0.0;
  Points shape;                                  ///< tissue is kept in it
  TissueMap tissue;                              ///< since begin()
  FrameClock clock;                              ///< since begin()
  double looked = 0.0, looked_at_picture = 0.0;  ///< at the frame whose surface was made last; likewise
  bool undecided = false;  ///< set elsewhere, and surfaces have neither confirmed nor refuted it
  int against = 0;         ///< bad surfaces in a row
  int looks = 0;           ///< surfaces since begin() or distrust()
  Alarm apart{2, 3}, covered{2, 3}, poor{3, 4};  ///< by measurements
  /// By seconds. A picture that stands is a copy, or may be one.
  Alarm stands{0.0, 0.2}, views{0.1, 0.33}, repeated{0.0, 0.2}, not_alive{0.0, 0.2}, copies{0.0, 0.2},
      part_stands{0.0, 0.2};
  /// What was pushed into alarms last, as a share of its limit; apartness() and coverage() besides.
  struct Measured {
    double misplaced = 0.0, poor = 0.0, views = 0.0, stands = 0.0, repeated = 0.0, not_alive = 0.0,
           copies = 0.0, part_stands = 0.0;
  };
  Measured measured;
  bool is_misplaced = false;     ///< by the mean, which needs no more patience
  std::deque<double> last_gaps;  ///< of the surfaces since begin() or distrust(), the newest last
  std::future<SurfaceEvidence> pending;
};

Judge::Judge(const PatientModel& model, const StereoRig& rig, const Picture& mask,
             const JudgeOptions& options)
    : impl_(std::make_unique<Impl>(model, rig, mask, options)) {}
Judge::~Judge() = default;

void Judge::begin(const StereoFrame& first, const Points& nodes_in_camera) {
  impl_->begin(first, nodes_in_camera);
}

void Judge::distrust() { impl_->distrust(); }
void Judge::keep_tissue_in(const Points& shape) { impl_->shape = shape; }
const TissueMap& Judge::tissue() const { return impl_->tissue; }
bool Judge::refutes() const { return impl_->refutes(); }
double Judge::strength() const { return impl_->strength(); }
bool Judge::is_undecided() const { return impl_->undecided; }

Validity Judge::judge(const StereoFrame& frame, const std::vector<FollowedPoint>& points,
                      OverlayFrame& overlay, const Picture& not_liver) {
  impl_->clock.tick(frame.seconds);
  impl_->look_at_surface(frame, points, overlay.nodes_in_camera, not_liver);
  impl_->look_at_pictures(frame);
  impl_->look_at_motion(frame, points);
  overlay.evidence = impl_->evidence;
  return impl_->verdict();
}

}  // namespace glisson::guidance
