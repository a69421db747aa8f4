// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesions.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "edge.h"
#include "glisson/core/statistics.h"
#include "star.h"

namespace glisson::segmentation {
namespace {

using Vec = Eigen::Vector3d;

constexpr double kReach = 65.0;                         // mm, without a diameter
constexpr double kClick = 3.0;                          // mm around a click that is read
constexpr double kLocal = 35.0;                         // mm around it where the liver is read
constexpr double kLeastSigma = 4.0, kMostSigma = 12.0;  // HU, of the liver after denoising
constexpr double kLeastOwn = 5.0, kMostOwn = 15.0;      // HU, of the lesion
constexpr double kShellFrom = 3.0, kShellTo = 10.0;     // mm outside the body: the liver next to it
constexpr double kBand = 4.0;                           // mm
constexpr int kMoves = 5, kLastMoves = 2;
constexpr double kTold = 1.5;        // sigmas of the liver from which on a click tells its own tissue
constexpr double kLeastFound = 5.0;  // mean evidence of the rays, mm: one of them as sure as can be

template <class Visit>
void each_within(const Field& ct, const Eigen::Vector3i& middle, double radius_mm, const Visit& visit) {
  const Eigen::Vector3i reach =
      (radius_mm * ct.spacing_mm.cwiseInverse()).array().floor().matrix().cast<int>();
  for (int k = -reach.z(); k <= reach.z(); ++k)
    for (int j = -reach.y(); j <= reach.y(); ++j)
      for (int i = -reach.x(); i <= reach.x(); ++i) {
        const Eigen::Vector3i v = middle + Eigen::Vector3i(i, j, k);
        if (ct.contains(v) && Vec(i, j, k).cwiseProduct(ct.spacing_mm).norm() <= radius_mm) visit(v);
      }
}

bool is_organ(const LesionScene& scene, std::size_t at) {
  return scene.organ.voxels.empty() || scene.organ.voxels[at] != 0;
}

/// So close under the organ's surface that what is outside is mixed in.
bool is_mixed(const LesionScene& scene, std::size_t at) {
  return !scene.mixed.voxels.empty() && scene.mixed.voxels[at] != 0;
}

Tissue tissue_of(std::vector<float> values, double low_sigma, double high_sigma) {
  const auto [middle, deviation] = robust_spread(std::move(values));
  return {middle, std::clamp(deviation, low_sigma, high_sigma)};
}

/// The liver around the click.
Tissue local_liver(const LesionScene& scene, const Eigen::Vector3i& click) {
  constexpr std::size_t kEnough = 200;
  const double wide = std::max(2.5 * scene.liver.sigma, 15.0);
  std::vector<float> values;
  each_within(scene.ct, click, kLocal, [&](const Eigen::Vector3i& v) {
    const std::size_t at = scene.ct.offset(v);
    if (std::abs(scene.ct.values[at] - scene.liver.mean) < wide && is_organ(scene, at))
      values.push_back(scene.ct.values[at]);
  });
  if (values.size() >= kEnough) return tissue_of(std::move(values), kLeastSigma, kMostSigma);
  return {scene.liver.mean, std::clamp(scene.liver.sigma, kLeastSigma, kMostSigma)};
}

double normal(double x, const Tissue& tissue) {
  const double z = (x - tissue.mean) / tissue.sigma;
  return std::exp(-0.5 * z * z) / (tissue.sigma * std::sqrt(2.0 * M_PI));
}

/// Logarithm of the likelihood ratio of an intensity, lesion over liver, cut off at -3 and 3. A lesion's
/// intensities are those at the click, those between them and the liver's (its border is a mixture, and
/// people draw around it) and, seldom, any (necrosis, fluid, calcification). A liver's are its parenchyma's
/// and those of brighter vessels.
class Evidence {
 public:
  static constexpr double kMost = 3.0;
  /// @param drawn a hand has said where the lesion is: its tissue counts even if it looks like liver.
  /// @param rim of the lesion, too: living tissue around a necrosis.
  Evidence(const Tissue& own, const Tissue& liver, bool drawn, const std::optional<Tissue>& rim = {})
      : own_(own), liver_(liver), drawn_(drawn), rim_(rim) {}
  double operator()(double x) const {
    const double apart = std::abs(liver_.mean - own_.mean), span = std::max(apart, 4.0 * liver_.sigma);
    const bool told = drawn_ || apart > kTold * liver_.sigma;
    const bool between = told && (x - own_.mean) * (x - liver_.mean) < 0.0;
    const double lesion =
        (drawn_ ? 0.9 : 0.4) * (told ? own(x) : kAny) + (between ? 0.3 / span : 0.0) + 0.3 * kAny;
    const double liver = 0.9 * normal(x, liver_) + (x > liver_.mean ? 0.2 : 0.005) * kAny;
    return std::clamp(std::log(lesion / liver), -kMost, kMost);
  }
  /// In a bite out of the liver that was found: only what is like the click, and that counts for less.
  double in_bite(double x) const {
    return std::clamp(std::log((normal(x, own_) + 1e-9) / kAny), -kMost, kMost / 3.0);
  }

 private:
  double own(double x) const { return rim_ ? 0.5 * (normal(x, own_) + normal(x, *rim_)) : normal(x, own_); }

  static constexpr double kAny = 1.0 / 200.0;  // 1 / HU
  Tissue own_, liver_;
  bool drawn_;
  std::optional<Tissue> rim_;
};

/// @param in_bite the liver's outline leaves the click out; else it is trusted.
std::vector<float> evidence_in(const LesionScene& scene, const Evidence& evidence, bool in_bite) {
  std::vector<float> result(scene.ct.values.size(), static_cast<float>(-Evidence::kMost));
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (scene.barred.voxels[i] != 0 || (scene.organ.voxels.empty() && scene.ct.values[i] < kEmptyTissue))
      continue;
    if (is_mixed(scene, i))
      result[i] = 0.0F;
    else if (is_organ(scene, i))
      result[i] = static_cast<float>(evidence(scene.ct.values[i]));
    else if (in_bite && scene.bites.voxels[i] != 0)
      result[i] = static_cast<float>(evidence.in_bite(scene.ct.values[i]));
  }
  return result;
}

/// The click itself where it is unlike the liver. Else the place within reach that is most unlike it, among
/// those that are no brighter: a brighter one near such a click is a vessel.
Eigen::Vector3i most_unlike(const LesionScene& scene, const std::vector<float>& evidence, const Tissue& liver,
                            const Eigen::Vector3i& click, double within_mm) {
  constexpr double kAround = 2.5;  // mm
  const auto mean_at = [&](const Eigen::Vector3i& p) {
    double sum = 0.0;
    int count = 0;
    each_within(scene.ct, p, kAround,
                [&](const Eigen::Vector3i& v) { sum += evidence[scene.ct.offset(v)], ++count; });
    return sum / count;
  };
  double most = mean_at(click);
  if (most > 0.0) return click;
  Eigen::Vector3i best = click;
  each_within(scene.ct, click, within_mm, [&](const Eigen::Vector3i& v) {
    if (scene.ct.values[scene.ct.offset(v)] > liver.mean) return;
    const double here = mean_at(v);
    if (here > most) most = here, best = v;
  });
  return best;
}

/// Tissue between two distances outside a body, robustly over all of its rays, so that what few of them meet
/// does not count. None where few of them end in the liver.
std::optional<Tissue> tissue_beyond(const LesionScene& scene, const Field& intensities, const Star& star,
                                    double from_mm, double to_mm) {
  std::vector<float> values;
  for (std::size_t n = 0; n < Rays::kCount; ++n)
    for (double d = from_mm; d <= to_mm; d += Rays::kStep) {
      const Vec p = star.middle + (star.radius_mm(n) + d) * rays().way(n).cwiseQuotient(scene.ct.spacing_mm);
      const Eigen::Vector3i v = p.array().round().matrix().cast<int>();
      if (!scene.ct.contains(v)) continue;
      const std::size_t at = scene.ct.offset(v);
      if (scene.barred.voxels[at] == 0 && is_organ(scene, at)) values.push_back(intensities.values[at]);
    }
  if (values.size() < Rays::kCount / 4) return {};
  return tissue_of(std::move(values), 0.0, 1e3);
}

/// How thick the bright rim around a body is, mm, to where it has fallen half way; 0: there is none. A rim
/// stands out of the liver by two of its sigmas, and is thin.
double rim_mm(const LesionScene& scene, const Star& star, const Tissue& liver) {
  constexpr double kThickest = 6.0, kFall = 3.0, kFar = 7.0, kFarEnd = 12.0;  // mm
  constexpr double kStandsOut = 2.0, kThinnest = 1.5;                         // sigmas; mm
  const auto far = tissue_beyond(scene, scene.raw, star, kFar, kFarEnd);
  if (!far) return 0.0;
  const auto above = [&](double d) {
    const auto here = tissue_beyond(scene, scene.raw, star, d, d);
    return here ? here->mean - far->mean : 0.0;
  };
  double peak = 0.0, at_peak = 0.0;
  for (double d = 0.0; d <= kThickest; d += Rays::kStep)
    if (const double here = above(d); here > peak) peak = here, at_peak = d;
  if (peak < kStandsOut * liver.sigma) return 0.0;
  for (double d = at_peak; d <= at_peak + kFall; d += 0.5 * Rays::kStep)
    if (above(d) < 0.5 * peak) return d < kThinnest ? 0.0 : d;
  return 0.0;
}

/// Counts a bright rim for the lesion: its bright voxels, and those between it and the dark core, which look
/// like liver only because they mix the two.
void take_rim(const LesionScene& scene, const Star& star, const Tissue& liver, double rim,
              std::vector<float>& evidence) {
  constexpr float kBright = 1.5F;
  constexpr double kSlack = 1.0, kCoreSide = 1.5;  // mm
  const Field phi = distance_to(star, scene.ct, rim + 2.0 * kSlack);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    if (phi.values[i] <= 0.0F || phi.values[i] > rim + kSlack) continue;
    if (scene.ct.values[i] > liver.mean + liver.sigma)
      evidence[i] = std::max(evidence[i], kBright);
    else if (phi.values[i] < rim - kCoreSide)
      evidence[i] = std::max(evidence[i], 0.0F);
  }
}

/// Carries a field on from `core` outwards, voxel layer by voxel layer, each the mean of what is known beside
/// it.
void carry_on(const Mask& core, double far_mm, Field& field) {
  std::vector<std::uint8_t> known = core.voxels;
  std::vector<Eigen::Vector3i> open;
  const std::vector<float> far2 = squared_distance_mm2(core);
  std::size_t at = 0;
  for (int k = 0; k < field.size.z(); ++k)
    for (int j = 0; j < field.size.y(); ++j)
      for (int i = 0; i < field.size.x(); ++i, ++at)
        if (known[at] == 0 && far2[at] <= far_mm * far_mm) open.emplace_back(i, j, k);
  for (std::size_t before = 0; before != open.size();) {
    before = open.size();
    std::vector<std::pair<std::size_t, float>> found;
    std::erase_if(open, [&](const Eigen::Vector3i& p) {
      float sum = 0.0F;
      int count = 0;
      for (int n = 0; n < 27; ++n) {
        const Eigen::Vector3i v = p + Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        if (field.contains(v) && known[field.offset(v)] != 0) sum += field.values[field.offset(v)], ++count;
      }
      if (count > 0) found.emplace_back(field.offset(p), sum / static_cast<float>(count));
      return count > 0;
    });
    for (const auto& [place, value] : found) field.values[place] = value, known[place] = 1;
  }
}

/// How thick the layer under the organ's surface is in which the CT mixes it with what is outside, mm.
double mixed_mm(const LesionScene& scene) {
  constexpr double kMixed = 2.5;  // sigmas of the blur: 1 % is left
  return kMixed * scene.blur_mm;
}

/// The scene as if the organ went on beyond its surface. Close under it the CT mixes liver with what is
/// outside, and the mixture with fat or lung is as dark as a lesion. What lies beneath is carried on for
/// whoever reads a tissue there, but it is no evidence: a lesion's blurred border would be a thick layer of
/// it.
LesionScene without_surface(LesionScene scene, const LesionClick& click) {
  constexpr double kBeyond = 4.0;  // mm outside
  if (scene.organ.voxels.empty()) return scene;
  const bool in_bite = !is_organ(scene, scene.ct.offset(click.place));
  Mask outside = scene.ct.empty_mask();
  for (std::size_t i = 0; i < outside.voxels.size(); ++i)
    outside.voxels[i] = !is_organ(scene, i) && !(in_bite && scene.bites.voxels[i] != 0);
  const double margin = mixed_mm(scene);
  const Mask core = complement(dilated(outside, margin));
  scene.mixed = scene.ct.empty_mask();
  for (std::size_t i = 0; i < outside.voxels.size(); ++i)
    scene.mixed.voxels[i] = core.voxels[i] == 0 && outside.voxels[i] == 0;
  carry_on(core, margin + kBeyond, scene.raw);
  carry_on(core, margin + kBeyond, scene.ct);
  return scene;
}

/// What a click says, to begin with.
struct Beginning {
  Tissue own, liver;
  Eigen::Vector3i seed;
  bool in_bite = false;
  std::vector<float> evidence;
  StarOptions options;
};

Beginning begin(const LesionScene& scene, const LesionClick& click) {
  constexpr double kSnap = 5.0;  // mm
  const bool drawn = click.diameter_mm > 0.0;
  Beginning begun;
  begun.liver = local_liver(scene, click.place);
  begun.in_bite = !is_organ(scene, scene.ct.offset(click.place));
  begun.own = tissue_around(scene.ct, {click.place}, kClick, kLeastOwn, kMostOwn);
  begun.evidence = evidence_in(scene, Evidence(begun.own, begun.liver, drawn), begun.in_bite);
  begun.seed = drawn ? click.place : most_unlike(scene, begun.evidence, begun.liver, click.place, kSnap);
  if (begun.seed != click.place) {
    begun.own = tissue_around(scene.ct, {begun.seed}, kClick, kLeastOwn, kMostOwn);
    begun.evidence = evidence_in(scene, Evidence(begun.own, begun.liver, drawn), begun.in_bite);
  }
  begun.options.diameter_mm = click.diameter_mm;
  begun.options.reach_mm = lesion_reach_mm(click.diameter_mm);
  begun.options.against = -Evidence::kMost;
  return begun;
}

/// What lies next to a body that was found.
struct Beside {
  std::optional<Tissue> liver;  ///< none: it cannot be told there
  std::optional<Tissue> rim;    ///< of the lesion: darker than the liver that lies farther out
};

/// @return the liver in the shell next to the body. Where that is darker by a sigma than the next shell, the
/// body is a necrosis, the first shell its living rim, and the liver begins behind it.
Beside beside_of(const LesionScene& scene, const Star& star, const Beginning& begun) {
  const auto tissue = [&](double from_mm, double to_mm) {
    auto found = tissue_beyond(scene, scene.ct, star, from_mm, to_mm);
    if (found && std::abs(found->mean - begun.liver.mean) >= 2.5 * begun.liver.sigma) found.reset();
    if (found) found->sigma = std::clamp(found->sigma, kLeastSigma, kMostSigma);
    return found;
  };
  const auto near = tissue(kShellFrom, kShellTo), far = tissue(kShellTo, 2.0 * kShellTo - kShellFrom);
  const bool is_rim = near && far && begun.own.mean < near->mean && far->mean - near->mean > far->sigma;
  return is_rim ? Beside{far, near} : Beside{near, {}};
}

/// Puts the boundary on the edge of the CT before denoising. Denoising blurs faint edges most, and the
/// evidence counts intensities between lesion and liver for the lesion: both carry the boundary outwards.
void find_edge(const LesionScene& scene, const Evidence& evidence, double liver, Star& star) {
  std::vector<std::uint8_t> may(scene.raw.values.size(), 0);
  for (std::size_t i = 0; i < may.size(); ++i) may[i] = scene.barred.voxels[i] == 0 && is_organ(scene, i);
  move_to_edge({scene.raw, may, evidence, scene.blur_mm, liver}, star);
}

/// Whether a body agrees with the diameter that a hand drew: it is not so wide that the hand must have been
/// wrong, and what lies just outside its boundary differs from what lies just within.
bool ends_as_drawn(const LesionScene& scene, const Star& star, const Tissue& liver, double diameter_mm) {
  constexpr double kWidest = 0.5 + Star::kDrawnShare;  // of the diameter
  constexpr double kFrom = 1.0, kTo = 4.0;             // mm
  if (star.mean_radius_mm() > kWidest * diameter_mm) return false;
  const auto within = tissue_beyond(scene, scene.ct, star, -kTo, -kFrom);
  const auto beyond = tissue_beyond(scene, scene.ct, star, kFrom, kTo);
  return within && beyond && std::abs(within->mean - beyond->mean) > kTold * liver.sigma;
}

/// Whether more than a stray ray ends where the search does.
bool ends_at_reach(const Star& star, double reach_mm) {
  constexpr double kStray = 0.02;  // of the rays
  const auto last = static_cast<int>(reach_mm / Rays::kStep);
  const auto count = std::count_if(star.radii.begin(), star.radii.end(), [=](int r) { return r >= last; });
  return static_cast<double>(count) > kStray * static_cast<double>(star.radii.size());
}

/// Whether much of a body hangs on where its border lies in the mixed layer, of which the CT says nothing:
/// its rays that end there may as well end where they enter it, or at the organ's surface.
bool hangs_on_mixed(const LesionScene& scene, const Star& star) {
  constexpr double kMuch = 0.2;  // of the volume
  if (scene.mixed.voxels.empty()) return false;
  const auto mixed_at = [&](std::size_t n, double radius_mm) {
    const Vec p = star.middle + radius_mm * rays().way(n).cwiseQuotient(scene.ct.spacing_mm);
    const Eigen::Vector3i v = p.array().round().matrix().cast<int>();
    return scene.ct.contains(v) && is_mixed(scene, scene.ct.offset(v));
  };
  double volume = 0.0, least = 0.0, most = 0.0;
  for (std::size_t n = 0; n < Rays::kCount; ++n) {
    const double end = star.radius_mm(n);
    double in = end, out = end;
    // The last voxel within the organ ends up to a step before the boundary.
    if (mixed_at(n, end) || mixed_at(n, end - Rays::kStep)) {
      while (in > 0.0 && mixed_at(n, in - Rays::kStep)) in -= Rays::kStep;
      while (mixed_at(n, out)) out += Rays::kStep;
    }
    volume += std::pow(end, 3), least += std::pow(std::max(0.0, in), 3), most += std::pow(out, 3);
  }
  return most - least > kMuch * volume;
}

/// A ball as it was drawn, but for what is barred and what is not in the liver.
Field drawn_ball(const LesionScene& scene, const LesionClick& click) {
  const bool in_liver = is_organ(scene, scene.ct.offset(click.place));
  Field phi = scene.ct.filled(static_cast<float>(kBand));
  std::size_t at = 0;
  for (int k = 0; k < phi.size.z(); ++k)
    for (int j = 0; j < phi.size.y(); ++j)
      for (int i = 0; i < phi.size.x(); ++i, ++at) {
        if (scene.barred.voxels[at] != 0 || (in_liver && !is_organ(scene, at))) continue;
        const Vec off = (Eigen::Vector3i(i, j, k) - click.place).cast<double>().cwiseProduct(phi.spacing_mm);
        phi.values[at] = static_cast<float>(std::clamp(off.norm() - 0.5 * click.diameter_mm, -kBand, kBand));
      }
  return phi;
}

}  // namespace

double lesion_reach_mm(double diameter_mm) { return diameter_mm > 0.0 ? 0.75 * diameter_mm + 5.0 : kReach; }

GrownLesion grow_lesion(const LesionScene& given, const LesionClick& click) {
  const LesionScene scene = without_surface(given, click);
  Beginning begun = begin(scene, click);
  std::vector<float>& evidence = begun.evidence;
  const Vec inside = begun.seed.cast<double>();
  const bool drawn = click.diameter_mm > 0.0;
  Star star = grow_star(scene.ct, evidence, {drawn ? click.place.cast<double>() : inside, {}}, inside, kMoves,
                        begun.options);
  // The liver differs from one end to the other: what counts is what lies next to the lesion.
  const Beside beside = beside_of(scene, star, begun);
  if (beside.liver) {
    begun.liver = *beside.liver;
    evidence = evidence_in(scene, Evidence(begun.own, begun.liver, drawn, beside.rim), begun.in_bite);
    star = grow_star(scene.ct, evidence, star, inside, kLastMoves, begun.options);
  }
  const double rim = rim_mm(scene, star, begun.liver);
  if (rim > 0.0) {
    take_rim(scene, star, begun.liver, rim, evidence);
    star = grow_star(scene.ct, evidence, star, inside, kLastMoves, begun.options);
  }
  if (!drawn && gathered(scene.ct, evidence, star, begun.options) < kLeastFound) return {};
  if (drawn && rim == 0.0 && !ends_as_drawn(scene, star, begun.liver, click.diameter_mm))
    return {drawn_ball(scene, click), false, true};
  const bool goes_on = ends_at_reach(star, begun.options.reach_mm);
  if (rim == 0.0)
    find_edge(scene, Evidence(begun.own, begun.liver, drawn, beside.rim), begun.liver.mean, star);
  return {distance_to(star, scene.ct, kBand),
          rim > 0.0 || begun.own.mean > begun.liver.mean + kTold * begun.liver.sigma, false, goes_on,
          hangs_on_mixed(scene, star) ? mixed_mm(scene) : 0.0};
}

LesionGuess guess_lesion(const LesionScene& scene, const LesionClick& click) {
  constexpr double kSure = 0.1;     // of the rays may be shorter
  constexpr double kOfDrawn = 0.4;  // of the diameter
  Beginning begun = begin(scene, click);
  const bool drawn = click.diameter_mm > 0.0;
  const Vec inside = begun.seed.cast<double>(), middle = drawn ? click.place.cast<double>() : inside;
  Star star = grow_star(scene.ct, begun.evidence, {middle, {}}, inside, 1, begun.options);
  if (!drawn && gathered(scene.ct, begun.evidence, star, begun.options) < kLeastFound) return {};
  const auto sure = static_cast<std::size_t>(kSure * static_cast<double>(star.radii.size()));
  const int radius =
      drawn ? static_cast<int>(kOfDrawn * click.diameter_mm / Rays::kStep) : at_rank(star.radii, sure);
  std::fill(star.radii.begin(), star.radii.end(), std::max(1, radius));
  LesionGuess guess{distance_to(star, scene.ct, kBand), {}};
  const Evidence evidence(begun.own, begun.liver, drawn);
  for (std::size_t i = 0; i < begun.evidence.size(); ++i)
    begun.evidence[i] = static_cast<float>(
        scene.barred.voxels[i] != 0 ? -Evidence::kMost : evidence.in_bite(scene.ct.values[i]));
  guess.likely = distance_to(grow_star(scene.ct, begun.evidence, {middle, {}}, inside, kMoves, begun.options),
                             scene.ct, kBand);
  return guess;
}

}  // namespace glisson::segmentation
