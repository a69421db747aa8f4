// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessel_way.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "glisson/core/statistics.h"

namespace glisson::editing {
namespace {

constexpr std::array<double, 3> kScales = {0.8, 1.6, 3.2};  ///< mm: of vessels 1.5 to 10 mm wide
/// What a millimetre costs in the middle of a vessel, and what it costs besides where the image looks like
/// something else, or like no tube. Their ratio is how many times as long a detour through a vessel may be.
constexpr double kLength = 0.08, kUnlike = 0.5, kNoTube = 0.5;
/// Beside a click: what belongs to the vessel, and what is about it.
constexpr double kBall = 1.2, kRingFrom = 5.0, kRingTo = 10.0;  // mm
/// Soft tissue of a CT, with and without contrast agent; fat, air and bone are not.
constexpr double kLowestTissue = -20.0, kHighestTissue = 450.0;  // HU

std::ptrdiff_t stride_of(const Eigen::Vector3i& size, int axis) {
  if (axis == 0) return 1;
  return axis == 1 ? size.x() : static_cast<std::ptrdiff_t>(size.x()) * size.y();
}

/// Along one axis; at the faces the outermost voxel goes on.
void smooth_along(Part& part, int axis, double sigma_mm) {
  const double sigma = sigma_mm / part.spacing_mm[axis];
  if (sigma < 1.0 / 3.0) return;
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
  std::vector<float> weights(static_cast<std::size_t>(reach) + 1);
  double sum = 0.0;
  for (int n = 0; n <= reach; ++n) {
    const double w = std::exp(-0.5 * n * n / (sigma * sigma));
    weights[static_cast<std::size_t>(n)] = static_cast<float>(w);
    sum += n == 0 ? w : 2.0 * w;
  }
  for (float& w : weights) w /= static_cast<float>(sum);
  const std::ptrdiff_t stride = stride_of(part.size, axis);
  const int length = part.size[axis], u = (axis + 1) % 3, v = (axis + 2) % 3;
  // The row with the outermost voxels repeated before and behind it.
  std::vector<float> row(static_cast<std::size_t>(length + 2 * reach));
  for (int b = 0; b < part.size[v]; ++b)
    for (int a = 0; a < part.size[u]; ++a) {
      float* first = part.values.data() + a * stride_of(part.size, u) + b * stride_of(part.size, v);
      for (int n = -reach; n < length + reach; ++n)
        row[static_cast<std::size_t>(n + reach)] = first[std::clamp(n, 0, length - 1) * stride];
      for (int n = 0; n < length; ++n) {
        const float* middle = row.data() + n + reach;
        float value = weights[0] * middle[0];
        for (int m = 1; m <= reach; ++m)
          value += weights[static_cast<std::size_t>(m)] * (middle[m] + middle[-m]);
        first[n * stride] = value;
      }
    }
}

/// How much the second eigenvalue of the second derivatives says "tube": its curvature across, at least.
float curvature_across(const Part& part, std::size_t at, float sign) {
  const float* p = part.values.data() + at;
  Eigen::Matrix3f h;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const std::ptrdiff_t sa = stride_of(part.size, a), sb = stride_of(part.size, b);
      const auto scale = static_cast<float>(1.0 / (part.spacing_mm[a] * part.spacing_mm[b]));
      const float d = a == b ? p[sa] - 2.0F * p[0] + p[-sa]
                             : 0.25F * (p[sa + sb] - p[sa - sb] - p[sb - sa] + p[-sa - sb]);
      h(a, b) = h(b, a) = sign * d * scale;
    }
  if (h.trace() >= 0.0F) return 0.0F;  // a tube curves downwards on the whole
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(h, Eigen::EigenvaluesOnly);
  return std::max(0.0F, -solver.eigenvalues()[1]);
}

/// 0: nothing tubular, 1: as the middle of a vessel of that contrast. A round bump of the contrast C that is
/// as wide as the scale gives sigma^2 * curvature = C / 4.
/// @returns no value: cancelled
Cancellable<std::vector<float>> tubeness(const Image& image, const Part& tissue, const Looks& looks,
                                         const RunContext& context) {
  std::vector<float> most(tissue.values.size(), 0.0F);
  for (std::size_t n = 0; n < kScales.size(); ++n) {
    const Part part = smoothed_part(image, tissue.box, kScales[n]);
    const auto factor = static_cast<float>(4.0 * kScales[n] * kScales[n] / looks.contrast);
    for (int k = 1; k + 1 < part.size.z(); ++k) {
      if (context.cancelled()) return std::nullopt;
      for (int j = 1; j + 1 < part.size.y(); ++j)
        for (int i = 1; i + 1 < part.size.x(); ++i) {
          const std::size_t at = part.offset({i, j, k});
          if (!is_tissue(image, tissue.values[at])) continue;
          const float t = factor * curvature_across(part, at, static_cast<float>(looks.sign));
          most[at] = std::max(most[at], std::min(1.0F, t));
        }
    }
    context.progress((static_cast<double>(n) + 1.0) / kScales.size(), "segmentation.edit");
  }
  return most;
}

double cost_of(double value, double tube, const Looks& looks) {
  const double v = looks.sign * value;
  const double less = std::max(0.0, (looks.low - v) / looks.contrast);
  const double more = std::max(0.0, (v - looks.high) / looks.contrast - 0.5);
  const double unlike = std::min(1.0, less * less + more * more);
  return kLength + kUnlike * unlike + kNoTube * (1.0 - tube) * (1.0 - tube);
}

struct Waiting {
  float cost = 0.0F;
  std::uint32_t at = 0;
  bool operator<(const Waiting& other) const { return cost > other.cost; }  // the cheapest comes first
};

/// Values at distances from..to of a place, on a lattice of 0.8 mm.
void gather(const Image& image, const Part& part, const Eigen::Vector3d& place, double from, double to,
            std::vector<double>& values) {
  constexpr double kStep = 0.8;
  const int n = static_cast<int>(std::ceil(to / kStep));
  for (int k = -n; k <= n; ++k)
    for (int j = -n; j <= n; ++j)
      for (int i = -n; i <= n; ++i) {
        const Eigen::Vector3d off = kStep * Eigen::Vector3d(i, j, k);
        if (off.norm() < from || off.norm() > to) continue;
        const double value = part.at(place + off);
        if (is_tissue(image, value)) values.push_back(value);
      }
}

}  // namespace

double Part::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d last = (size - Eigen::Vector3i::Ones()).cast<double>();
  const Eigen::Vector3d index =
      (place.cwiseQuotient(spacing_mm) - box.low.cast<double>()).cwiseMax(0.0).cwiseMin(last);
  const Eigen::Vector3i low = index.array().floor().matrix().cast<int>();
  const Eigen::Vector3d t = index - low.cast<double>();
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3i step(corner & 1, (corner >> 1) & 1, corner >> 2);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) weight *= step[axis] == 1 ? t[axis] : 1.0 - t[axis];
    if (weight > 0.0) value += weight * static_cast<double>(values[offset(low + step)]);
  }
  return value;
}

Part smoothed_part(const Image& image, const VoxelBox& box, double sigma_mm) {
  Part part{box, box.size(), image.grid.spacing_mm, {}};
  part.values.reserve(static_cast<std::size_t>(part.size.x()) * static_cast<std::size_t>(part.size.y()) *
                      static_cast<std::size_t>(part.size.z()));
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i)
        part.values.push_back(static_cast<float>(image.at({i, j, k})));
  for (int axis = 0; axis < 3; ++axis) smooth_along(part, axis, sigma_mm);
  return part;
}

bool is_tissue(const Image& image, double value) {
  return image.modality != Modality::ct || (value >= kLowestTissue && value <= kHighestTissue);
}

Looks looks_at(const Image& image, const Part& part, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  std::array<double, 2> ends{};
  std::vector<double> around;
  int n = 0;
  for (const Eigen::Vector3d& place : {a, b}) {
    std::vector<double> ball = {part.at(place)};
    gather(image, part, place, 0.0, kBall, ball);
    ends[static_cast<std::size_t>(n++)] = upper_median(std::move(ball));
    gather(image, part, place, kRingFrom, kRingTo, around);
  }
  if (around.empty()) around = {0.5 * (ends[0] + ends[1])};
  const auto [beside, noise] = robust_spread(std::move(around));
  // The end that stands out more tells whether the vessel is bright or dark.
  const double first = ends[0] - beside, second = ends[1] - beside;
  const double difference = std::abs(first) > std::abs(second) ? first : second;
  Looks looks;
  looks.sign = difference < 0.0 ? -1.0 : 1.0;
  looks.low = std::min(looks.sign * ends[0], looks.sign * ends[1]);
  looks.high = std::max(looks.sign * ends[0], looks.sign * ends[1]);
  looks.seen = std::abs(difference) > noise && std::abs(difference) >= 1.0;
  looks.contrast = std::max({std::abs(difference), noise, 1.0});
  return looks;
}

Cancellable<std::vector<Eigen::Vector3i>> cheapest_way(
    const Image& image, const VoxelBox& box, const Eigen::Vector3i& from, const Eigen::Vector3i& to,
    const Looks& looks, const std::function<bool(const Eigen::Vector3i&)>& open, const RunContext& context) {
  constexpr float kUnreached = std::numeric_limits<float>::infinity();
  const Part tissue = smoothed_part(image, box, 0.6);
  const auto tubes = tubeness(image, tissue, looks, context.part(0.0, 0.7));
  if (!tubes) return std::nullopt;
  std::vector<float> cost(tissue.values.size(), kUnreached);
  std::vector<std::uint8_t> came(tissue.values.size(), 13), done(tissue.values.size(), 0);
  const auto price = [&](std::size_t at) { return cost_of(tissue.values[at], (*tubes)[at], looks); };
  std::priority_queue<Waiting> waiting;
  const std::size_t first = tissue.offset(from - box.low), last = tissue.offset(to - box.low);
  cost[first] = 0.0F;
  waiting.push({0.0F, static_cast<std::uint32_t>(first)});
  const auto place_of = [&](std::size_t at) {
    const auto x = static_cast<std::size_t>(tissue.size.x()), y = static_cast<std::size_t>(tissue.size.y());
    return Eigen::Vector3i(static_cast<int>(at % x), static_cast<int>(at / x % y),
                           static_cast<int>(at / (x * y)));
  };
  const auto step_of = [](int n) { return Eigen::Vector3i(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1); };
  std::size_t visited = 0;
  while (!waiting.empty() && done[last] == 0) {
    const std::size_t at = waiting.top().at;
    waiting.pop();
    if (done[at] != 0) continue;
    done[at] = 1;
    if (++visited % 65536 == 0) {
      if (context.cancelled()) return std::nullopt;
      context.progress(0.7 + 0.3 * static_cast<double>(visited) / static_cast<double>(done.size()),
                       "segmentation.edit");
    }
    const Eigen::Vector3i here = place_of(at);
    const double price_here = price(at);
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i next = here + step_of(n);
      if (n == 13 || (next.array() < 0).any() || (next.array() >= tissue.size.array()).any()) continue;
      const std::size_t there = tissue.offset(next);
      if (done[there] != 0 || !is_tissue(image, tissue.values[there])) continue;
      const double length = step_of(n).cast<double>().cwiseProduct(tissue.spacing_mm).norm();
      const auto sum = cost[at] + static_cast<float>(0.5 * length * (price_here + price(there)));
      if (sum >= cost[there] || !open(next + box.low)) continue;
      cost[there] = sum;
      came[there] = static_cast<std::uint8_t>(n);
      waiting.push({sum, static_cast<std::uint32_t>(there)});
    }
  }
  std::vector<Eigen::Vector3i> way;
  if (done[last] == 0) return way;
  for (std::size_t at = last;; at = tissue.offset(place_of(at) - step_of(came[at]))) {
    way.push_back(place_of(at) + box.low);
    if (at == first) break;
  }
  std::ranges::reverse(way);
  return way;
}

}  // namespace glisson::editing
