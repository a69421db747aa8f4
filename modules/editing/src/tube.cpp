// SPDX-License-Identifier: GPL-3.0-or-later
#include "tube.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "glisson/core/statistics.h"

namespace glisson::editing {
namespace {

using Places = std::vector<Eigen::Vector3d>;

constexpr double kStep = 0.4;      ///< mm between places
constexpr int kRays = 16;          ///< across, an even number
constexpr double kRayStep = 0.25;  ///< mm
constexpr double kBeyond = 4.0;    ///< mm of what is about a tube that are looked at
constexpr double kAlong = 1.2;     ///< mm before and behind over which profiles are averaged
constexpr double kThickest = 8.0;  ///< mm: the widest radius that is looked for
constexpr double kFaint = 0.4;     ///< of the contrast of the ends: less is not seen
constexpr double kOpening = 0.5;   ///< a radius grows by no more than this with each mm of the way
constexpr int kRounds = 4;         ///< of moving to the middle
constexpr double kNothing = 0.2;   ///< of the contrast: less of it leads nowhere
constexpr double kLongestBridge = 15.0, kLead = 4.0, kStump = 2.4;  ///< mm

/// Places as far apart as kStep on the line through the voxels.
Places resampled(const Places& line) {
  Places places = {line.front()};
  double left = kStep;
  for (std::size_t n = 1; n < line.size(); ++n) {
    Eigen::Vector3d from = line[n - 1];
    double length = (line[n] - from).norm();
    while (length >= left) {
      from += left / length * (line[n] - from);
      length = (line[n] - from).norm();
      places.push_back(from);
      left = kStep;
    }
    left -= length;
  }
  if ((places.back() - line.back()).norm() > 1e-6) places.push_back(line.back());
  return places;
}

/// A Gaussian along the line; the ends stay. What reaches beyond an end is the line turned about it, so that
/// a straight line stays straight.
Places smoothed(const Places& line, double sigma_mm) {
  const double sigma = sigma_mm / kStep;
  const int reach = static_cast<int>(std::ceil(3.0 * sigma)), last = static_cast<int>(line.size()) - 1;
  const auto at = [&](int n) -> Eigen::Vector3d {
    const auto inside = [&](int m) { return line[static_cast<std::size_t>(std::clamp(m, 0, last))]; };
    if (n < 0) return 2.0 * line.front() - inside(-n);
    return n > last ? Eigen::Vector3d(2.0 * line.back() - inside(2 * last - n)) : inside(n);
  };
  Places places = line;
  for (int n = 1; n < last; ++n) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (int m = -reach; m <= reach; ++m) {
      const double weight = std::exp(-0.5 * m * m / (sigma * sigma));
      sum += weight * at(n + m);
      weights += weight;
    }
    places[static_cast<std::size_t>(n)] = sum / weights;
  }
  return places;
}

/// Axes across the line at each place, turned as little as can be from one to the next.
struct Across {
  std::vector<std::array<Eigen::Vector3d, 2>> axes;

  explicit Across(const Places& line) {
    Eigen::Vector3d former = Eigen::Vector3d::Zero();
    for (std::size_t n = 0; n < line.size(); ++n) {
      const std::size_t a = n < 2 ? 0 : n - 2, b = std::min(line.size() - 1, n + 2);
      const Eigen::Vector3d along = (line[b] - line[a]).normalized();
      Eigen::Vector3d u = former - along * along.dot(former);
      if (u.norm() < 1e-3) u = along.unitOrthogonal();
      u.normalize();
      axes.push_back({u, along.cross(u)});
      former = u;
    }
  }
  Eigen::Vector3d ray(std::size_t n, int number) const {
    const double angle = 2.0 * M_PI * number / kRays;
    return std::cos(angle) * axes[n][0] + std::sin(angle) * axes[n][1];
  }
};

/// Values (times the sign) on rays across the line.
class Profiles {
 public:
  Profiles(const Image& image, const Part& part, const Places& line, const Looks& looks)
      : image_(image),
        across_(line),
        steps_(static_cast<int>(std::ceil((kThickest + kBeyond) / kRayStep)) + 1),
        sign_(looks.sign) {
    values_.reserve(line.size());
    for (std::size_t n = 0; n < line.size(); ++n) {
      std::vector<float> of_place;
      of_place.reserve(static_cast<std::size_t>(kRays * steps_));
      for (int ray = 0; ray < kRays; ++ray) {
        const Eigen::Vector3d way = kRayStep * across_.ray(n, ray);
        for (int step = 0; step < steps_; ++step)
          of_place.push_back(static_cast<float>(looks.sign * part.at(line[n] + step * way)));
      }
      values_.push_back(std::move(of_place));
    }
    average();
  }
  const Across& across() const { return across_; }
  double at(std::size_t n, int ray, int step) const {
    return values_[n][static_cast<std::size_t>(ray * steps_ + step)];
  }
  double middle(std::size_t n) const {
    double sum = 0.0;
    for (int ray = 0; ray < kRays; ++ray) sum += at(n, ray, 0) + at(n, ray, 1);
    return sum / (2.0 * kRays);
  }
  /// What is about the tube within 5 mm along it: the median of the soft tissue from a little outside its
  /// radius on. Not a number where there is none.
  double around(std::size_t n, const std::vector<double>& radii) const {
    const auto reach = static_cast<std::size_t>(5.0 / kStep);
    std::vector<double> values;
    const std::size_t first = n < reach ? 0 : n - reach, last = std::min(values_.size() - 1, n + reach);
    for (std::size_t m = first; m <= last; m += 4) {
      const int from = static_cast<int>((radii[m] + 1.5) / kRayStep);
      const int to = std::min(steps_, from + static_cast<int>(3.5 / kRayStep));
      for (int ray = 0; ray < kRays; ++ray)
        for (int step = from; step < to; step += 2)
          if (is_tissue(image_, sign_ * at(m, ray, step))) values.push_back(at(m, ray, step));
    }
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : lower_percentile(values, 0.5);
  }
  /// Where a ray falls below a level; infinite: nowhere.
  double fall(std::size_t n, int ray, double level) const {
    for (int step = 1; step < steps_; ++step) {
      const double before = at(n, ray, step - 1), here = at(n, ray, step);
      if (here < level)
        return kRayStep * (step - 1 + std::clamp((before - level) / (before - here), 0.0, 1.0));
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  void average() {
    const auto reach = static_cast<std::size_t>(kAlong / kStep);
    const std::vector<std::vector<float>> raw = values_;
    for (std::size_t n = 0; n < raw.size(); ++n) {
      const std::size_t first = n < reach ? 0 : n - reach, last = std::min(raw.size() - 1, n + reach);
      for (std::size_t at = 0; at < raw[n].size(); ++at) {
        float sum = 0.0F;
        for (std::size_t m = first; m <= last; ++m) sum += raw[m][at];
        values_[n][at] = sum / static_cast<float>(last - first + 1);
      }
    }
  }

  const Image& image_;
  Across across_;
  int steps_;
  double sign_;
  std::vector<std::vector<float>> values_;
};

/// What a cross-section shows.
struct Section {
  double contrast = 0.0;                          ///< of the middle, of that of the ends
  double radius_mm = 0.0;                         ///< 0: not seen
  Eigen::Vector3d off = Eigen::Vector3d::Zero();  ///< of the middle
};

Section section_at(const Profiles& profiles, std::size_t n, double around, const Looks& looks) {
  Section section;
  const double middle = profiles.middle(n);
  section.contrast = (middle - around) / looks.contrast;
  if (!(section.contrast > kFaint)) return section;
  std::array<double, kRays> falls{};
  std::vector<double> closed;
  for (int ray = 0; ray < kRays; ++ray) {
    double& fall = falls[static_cast<std::size_t>(ray)];
    fall = profiles.fall(n, ray, 0.5 * (middle + around));
    if (fall > kThickest + 1.0) fall = std::numeric_limits<double>::infinity();
    if (std::isfinite(fall)) closed.push_back(fall);
  }
  // A ray into another vessel does not fall; where many do not, this is no tube across the way.
  if (3 * closed.size() < 2 * kRays) return section;
  const double typical = lower_percentile(closed, 0.5);
  double sum = 0.0;
  int count = 0;
  Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
  Eigen::Vector3d off = Eigen::Vector3d::Zero();
  for (int ray = 0; ray < kRays; ++ray) {
    const double fall = falls[static_cast<std::size_t>(ray)];
    if (!(fall <= 2.0 * typical + 0.5)) continue;
    sum += fall * fall;
    ++count;
    const double opposite = falls[static_cast<std::size_t>((ray + kRays / 2) % kRays)];
    if (ray >= kRays / 2 || !(opposite <= 2.0 * typical + 0.5)) continue;
    const Eigen::Vector3d way = profiles.across().ray(n, ray);
    across += way * way.transpose();
    off += 0.5 * (fall - opposite) * way;
  }
  if (count == 0) return section;
  section.radius_mm = std::sqrt(sum / count);
  // Least squares; nothing along the line, whose direction no ray has.
  across += 1e-3 * Eigen::Matrix3d::Identity();
  section.off = across.inverse() * off;
  const double most = std::min(1.0, 0.5 * typical);
  if (section.off.norm() > most) section.off *= most / section.off.norm();
  return section;
}

/// Unseen ones (0) from the nearest that are seen on both sides, between them in proportion. Nothing is seen:
/// unchanged.
void fill(std::vector<double>& radii) {
  const std::vector<double> seen = radii;
  std::size_t former = seen.size();
  for (std::size_t n = 0; n < seen.size(); ++n) {
    if (seen[n] <= 0.0) continue;
    if (former == seen.size())
      std::fill(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(n), seen[n]);
    for (std::size_t m = former + 1; m < n && former < seen.size(); ++m) {
      const double t = static_cast<double>(m - former) / static_cast<double>(n - former);
      radii[m] = (1.0 - t) * seen[former] + t * seen[n];
    }
    former = n;
  }
  if (former < seen.size())
    std::fill(radii.begin() + static_cast<std::ptrdiff_t>(former), radii.end(), seen[former]);
}

/// Medians over some millimetres of those that are seen, and then no wider than a funnel from any of them: at
/// the mouth into a trunk the trunk is across, not the branch.
std::vector<double> steadied(const std::vector<double>& radii) {
  const int reach = static_cast<int>(2.0 / kStep), last = static_cast<int>(radii.size()) - 1;
  std::vector<double> steady(radii.size(), 0.0);
  for (int n = 0; n <= last; ++n) {
    if (radii[static_cast<std::size_t>(n)] <= 0.0) continue;
    std::vector<double> near;
    for (int m = std::max(0, n - reach); m <= std::min(last, n + reach); ++m)
      if (radii[static_cast<std::size_t>(m)] > 0.0) near.push_back(radii[static_cast<std::size_t>(m)]);
    steady[static_cast<std::size_t>(n)] = lower_percentile(near, 0.5);
  }
  fill(steady);
  const double widens = kOpening * kStep;
  for (std::size_t n = 1; n < steady.size(); ++n) steady[n] = std::min(steady[n], steady[n - 1] + widens);
  for (std::size_t n = steady.size() - 1; n > 0; --n)
    steady[n - 1] = std::min(steady[n - 1], steady[n] + widens);
  return steady;
}

/// Where over some millimetres nothing leads, noise alone has led the way: there the line goes on as it comes
/// from both sides, as a cubic. @param contrasts, seen radii at the places
void bridge(Places& line, const std::vector<double>& seen, const std::vector<double>& contrasts) {
  const auto lead = static_cast<std::size_t>(kLead / kStep), stump = static_cast<std::size_t>(kStump / kStep);
  for (std::size_t first = 1; first < line.size(); ++first) {
    if (seen[first] > 0.0 || seen[first - 1] <= 0.0) continue;
    std::size_t last = first;  // one past the stretch
    double sum = 0.0;
    for (; last < line.size() && seen[last] <= 0.0; ++last) sum += contrasts[last];
    const std::size_t next = last;
    const auto missing = static_cast<double>(last - first);
    if (last >= line.size() || !(sum < kNothing * missing) || kStep * missing > kLongestBridge) {
      first = next;
      continue;
    }
    // A vessel's stump is no tube, and its middle is not where it seems.
    const std::size_t a = first - 1 - std::min(first - 1, stump);
    last = std::min(line.size() - 1, last + stump);
    const auto count = static_cast<double>(last - a);
    const Eigen::Vector3d p = line[a], q = line[last];
    const double length = (q - p).norm();
    const Eigen::Vector3d before = p - line[a - std::min(a, lead)];
    const Eigen::Vector3d after = line[std::min(line.size() - 1, last + lead)] - q;
    // At an end of the line nothing says where it comes from.
    const Eigen::Vector3d from = before.norm() > 1.0 ? before.normalized() : (q - p).normalized();
    const Eigen::Vector3d into = after.norm() > 1.0 ? after.normalized() : (q - p).normalized();
    for (std::size_t n = a + 1; n < last; ++n) {
      const double t = static_cast<double>(n - a) / count, s = 1.0 - t;
      line[n] =
          s * s * (1.0 + 2.0 * t) * p + t * t * (1.0 + 2.0 * s) * q + length * s * t * (s * from - t * into);
    }
    first = next;
  }
}

}  // namespace

Tube tube_about(const Image& image, const Part& part, const std::vector<Eigen::Vector3i>& way,
                const Looks& looks, double smallest_mm, double largest_mm) {
  Places line;
  for (const Eigen::Vector3i& v : way) line.push_back(v.cast<double>().cwiseProduct(part.spacing_mm));
  line = smoothed(resampled(line), 1.5);
  Tube tube;
  std::vector<double> radii(line.size(), 2.0), seen(line.size(), 0.0), contrasts(line.size(), 0.0);
  for (int round = 0; round < kRounds && looks.seen; ++round) {
    const Profiles profiles(image, part, line, looks);
    Places moved = line;
    for (std::size_t n = 0; n < line.size(); ++n) {
      const Section section = section_at(profiles, n, profiles.around(n, radii), looks);
      seen[n] = section.radius_mm;
      contrasts[n] = section.contrast;
      if (section.radius_mm > 0.0) moved[n] += section.off;
    }
    radii = steadied(seen);
    for (double& radius : radii) radius = std::clamp(radius, smallest_mm, kThickest);
    if (round + 1 == kRounds) break;
    bridge(moved, seen, contrasts);
    line = smoothed(moved, 1.0);
  }
  const auto count = std::ranges::count_if(seen, [](double radius) { return radius > 0.0; });
  tube.seen = static_cast<double>(count) / static_cast<double>(line.size());
  if (count == 0) radii.assign(line.size(), smallest_mm);
  for (double& radius : radii) radius = std::clamp(radius, smallest_mm, largest_mm);
  tube.places = std::move(line);
  tube.radii_mm = std::move(radii);
  return tube;
}

}  // namespace glisson::editing
