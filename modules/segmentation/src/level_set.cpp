// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_set.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "glisson/core/error.h"
#include "glisson/core/share_out.h"
#include "glisson/volume/voxel_neighbours.h"

namespace glisson::segmentation {
namespace {

constexpr std::size_t kSpeedCost = 3;  // a front's speed takes as long as so many samples
constexpr int kStepsPerRebuild = 4;    // 0.4 voxels a step at most: the front stays well inside the band

struct Neighbours {
  std::size_t x, y, z;
  explicit Neighbours(const Field& field)
      : x(1),
        y(static_cast<std::size_t>(field.size.x())),
        z(static_cast<std::size_t>(field.size.x()) * static_cast<std::size_t>(field.size.y())) {}
};

/// A voxel and its distance (mm, not negative) in one number: a distance's bits are in order as it is itself,
/// and of two that are alike the voxel that comes first is the less. One comparison orders a heap, of half
/// the size.
class Entry {
 public:
  /// @pre at < 2^32
  Entry(float distance, std::size_t at)
      : key_(static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(distance)) << 32 | at) {}
  float distance() const { return std::bit_cast<float>(static_cast<std::uint32_t>(key_ >> 32)); }
  std::size_t at() const { return static_cast<std::uint32_t>(key_); }
  bool operator>(const Entry& other) const { return key_ > other.key_; }

 private:
  std::uint64_t key_;
};

/// The nearest first. A heap for each stretch of the way to `limit`: few of them are touched at a time, so
/// that they stay in the processor's cache.
class Front {
 public:
  explicit Front(float limit) : stretches_(kStretches), scale_(static_cast<float>(kStretches) / limit) {}

  void push(const Entry& entry) {
    const std::size_t stretch =
        std::clamp(static_cast<std::size_t>(entry.distance() * scale_), current_, kStretches - 1);
    stretches_[stretch].push_back(entry);
    if (stretch == current_)
      std::push_heap(stretches_[stretch].begin(), stretches_[stretch].end(), std::greater<>());
  }

  /// Empty when there is none left; the front then begins anew.
  std::optional<Entry> pop() {
    while (stretches_[current_].empty()) {
      if (++current_ == kStretches) {
        current_ = 0;
        return std::nullopt;
      }
      std::make_heap(stretches_[current_].begin(), stretches_[current_].end(), std::greater<>());
    }
    std::vector<Entry>& heap = stretches_[current_];
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    const Entry nearest = heap.back();
    heap.pop_back();
    return nearest;
  }

 private:
  static constexpr std::size_t kStretches = 512;

  std::vector<std::vector<Entry>> stretches_;
  float scale_;
  std::size_t current_ = 0;  ///< what lies before it has been taken
};

/// Makes phi a signed distance again within the band around its zero, which stays where it is, and clamps it
/// beyond. Band voxels that are not on the volume's edge go to `band`, in memory order. Each side of the
/// interface is marched by a thread of its own, from the voxels beside it.
/// @pre between two calls phi changed only in the band and the front stayed in it: only voxels that were near
/// the front, or beside those, are looked at again.
class Rebuilder {
 public:
  explicit Rebuilder(const Field& phi)
      : size_(phi.size),
        step_(phi),
        h_(static_cast<float>(phi.spacing_mm.minCoeff())),
        limit_(kBandVoxels * h_),
        sides_{Side{true, Front(limit_)}, Side{false, Front(limit_)}} {
    require(phi.values.size() <= std::numeric_limits<std::uint32_t>::max(), "a voxel's number has 32 bits");
    distance_.resize(phi.values.size(), limit_);
    done_.resize(phi.values.size(), 0);
    on_edge_.resize(phi.values.size(), 1);
    for (int k = 1; k + 1 < size_.z(); ++k)
      for (int j = 1; j + 1 < size_.y(); ++j)
        for (int i = 1; i + 1 < size_.x(); ++i) on_edge_[phi.offset(i, j, k)] = 0;
  }

  void rebuild(Field& phi, std::vector<std::size_t>& band) {
    // Twice the whole volume. In the phi that is given first the front may lie between voxels whose values
    // say that they are far from it; only once these are clamped is it seen.
    const bool is_whole = rebuilds_++ < 2;
    start(phi, is_whole);
    for (const std::size_t at : near_) {
      distance_[at] = limit_;
      done_[at] = 0;
      phi.values[at] = phi.values[at] < 0.0F ? -limit_ : limit_;
    }
    for (const Entry& entry : beside_) {
      distance_[entry.at()] = entry.distance();
      sides_[phi.values[entry.at()] < 0.0F ? 0 : 1].front.push(entry);
    }
    beside_.clear();
    share_out(2, 2, [&](std::size_t side, bool) { march(phi, sides_[side]); });
    near_.clear();
    band.clear();
    for (std::size_t at = 0; at < distance_.size(); ++at) {
      if (is_whole) phi.values[at] = phi.values[at] < 0.0F ? -limit_ : limit_;
      if (distance_[at] >= limit_) continue;
      phi.values[at] = phi.values[at] < 0.0F ? -distance_[at] : distance_[at];
      near_.push_back(at);
      if (on_edge_[at] == 0) band.push_back(at);
    }
  }

 private:
  /// What is inside, or what is outside.
  struct Side {
    bool is_inside;
    Front front;

    bool holds(const Field& phi, std::size_t at) const { return (phi.values[at] < 0.0F) == is_inside; }
  };

  /// As each_face_neighbour(), without its divisions inside the volume.
  template <class Visit>
  void each_neighbour(std::size_t at, const Visit& visit) const {
    if (on_edge_[at] != 0) return each_face_neighbour(size_, at, visit);
    visit(at - step_.x, 0), visit(at + step_.x, 0);
    visit(at - step_.y, 1), visit(at + step_.y, 1);
    visit(at - step_.z, 2), visit(at + step_.z, 2);
  }

  /// Finds the voxels beside the interface. One of any two on either side of it was near it before.
  void start(const Field& phi, bool is_whole) {
    if (is_whole) {
      for (std::size_t at = 0; at < phi.values.size(); ++at) start_at(phi, at);
      return;
    }
    for (const std::size_t at : near_) {
      start_at(phi, at);
      const bool is_inside = phi.values[at] < 0.0F;
      each_neighbour(at, [&](std::size_t other, int) {
        if (distance_[other] >= limit_ && (phi.values[other] < 0.0F) != is_inside) start_at(phi, other);
      });
    }
  }

  /// A voxel beside the interface: its distance by linear interpolation along each axis.
  void start_at(const Field& phi, std::size_t at) {
    const float here = phi.values[at];
    if (std::abs(here) > 4.0F * h_) return;
    std::array<float, 3> nearest = {1e30F, 1e30F, 1e30F};
    bool crossed = false;
    each_neighbour(at, [&](std::size_t other, int axis) {
      const float there = phi.values[other];
      if ((here < 0.0F) == (there < 0.0F)) return;
      crossed = true;
      const float d = h_ * std::abs(here) / std::max(1e-12F, std::abs(here - there));
      float& best = nearest[static_cast<std::size_t>(axis)];
      best = std::min(best, std::max(d, 1e-4F * h_));
    });
    if (!crossed) return;
    float sum = 0.0F;
    for (const float d : nearest) sum += 1.0F / (d * d);
    beside_.emplace_back(1.0F / std::sqrt(sum), at);
  }

  /// |grad d| = 1 solved upwind from the side's accepted neighbours (Sethian 1996).
  float solve(const Field& phi, const Side& side, std::size_t at) const {
    std::array<float, 3> smallest = {1e30F, 1e30F, 1e30F};
    each_neighbour(at, [&](std::size_t other, int axis) {
      if (side.holds(phi, other) && done_[other] != 0)
        smallest[static_cast<std::size_t>(axis)] =
            std::min(smallest[static_cast<std::size_t>(axis)], distance_[other]);
    });
    std::sort(smallest.begin(), smallest.end());
    float d = smallest[0] + h_;
    if (d > smallest[1]) {
      const float a = smallest[0], b = smallest[1];
      d = 0.5F * (a + b + std::sqrt(std::max(0.0F, 2.0F * h_ * h_ - (a - b) * (a - b))));
      if (d > smallest[2]) {
        const float s = a + b + smallest[2];
        const float q = a * a + b * b + smallest[2] * smallest[2] - h_ * h_;
        d = (s + std::sqrt(std::max(0.0F, s * s - 3.0F * q))) / 3.0F;
      }
    }
    return d;
  }

  void march(const Field& phi, Side& side) {
    while (const auto entry = side.front.pop()) {
      const std::size_t at = entry->at();
      if (done_[at] != 0) continue;
      done_[at] = 1;
      each_neighbour(at, [&](std::size_t other, int) {
        if (!side.holds(phi, other) || done_[other] != 0) return;
        const float d = solve(phi, side, other);
        if (d < distance_[other] && d < limit_) {
          distance_[other] = d;
          side.front.push(Entry(d, other));
        }
      });
    }
  }

  Eigen::Vector3i size_;
  Neighbours step_;
  float h_, limit_;
  int rebuilds_ = 0;
  std::vector<float> distance_;
  std::vector<std::uint8_t> done_, on_edge_;
  std::vector<std::size_t> near_;  ///< closer to the front than the band is wide, in memory order
  std::vector<Entry> beside_;      ///< the interface
  std::array<Side, 2> sides_;
};

/// phi_t at an inner voxel.
float speed_at(const Field& phi, const ContourForces& forces, std::size_t at, const Neighbours& step,
               float h) {
  const float* p = phi.values.data() + at;
  const auto value = [&](std::ptrdiff_t d) { return p[d]; };
  const auto sx = static_cast<std::ptrdiff_t>(step.x), sy = static_cast<std::ptrdiff_t>(step.y),
             sz = static_cast<std::ptrdiff_t>(step.z);
  const float c = p[0];
  const float mx = c - value(-sx), px = value(sx) - c, my = c - value(-sy), py = value(sy) - c,
              mz = c - value(-sz), pz = value(sz) - c;
  // Region force, Godunov's upwind scheme: the front takes its values from the side that it comes from.
  const float s = static_cast<float>(forces.expansion) * forces.region.values[at];
  const auto square = [](float v) { return v * v; };
  const auto upwind = [&](float back, float ahead) {
    return s > 0.0F ? square(std::max(back, 0.0F)) + square(std::min(ahead, 0.0F))
                    : square(std::min(back, 0.0F)) + square(std::max(ahead, 0.0F));
  };
  float change = -s * std::sqrt(upwind(mx, px) + upwind(my, py) + upwind(mz, pz)) / h;

  // Curvature, central: kappa |grad phi|, in 1/mm.
  const float inverse = 1.0F / h;
  const float dx = 0.5F * (mx + px) * inverse, dy = 0.5F * (my + py) * inverse,
              dz = 0.5F * (mz + pz) * inverse;
  const float gradient2 = dx * dx + dy * dy + dz * dz;
  if (gradient2 > 1e-6F) {
    const float i2 = inverse * inverse;
    const float dxx = (px - mx) * i2, dyy = (py - my) * i2, dzz = (pz - mz) * i2;
    const float dxy = 0.25F * i2 * (value(sx + sy) - value(sx - sy) - value(sy - sx) + value(-sx - sy));
    const float dxz = 0.25F * i2 * (value(sx + sz) - value(sx - sz) - value(sz - sx) + value(-sx - sz));
    const float dyz = 0.25F * i2 * (value(sy + sz) - value(sy - sz) - value(sz - sy) + value(-sy - sz));
    const float mean = ((dyy + dzz) * dx * dx + (dxx + dzz) * dy * dy + (dxx + dyy) * dz * dz -
                        2.0F * (dx * dy * dxy + dx * dz * dxz + dy * dz * dyz)) /
                       gradient2;
    const float bound = 2.0F * inverse;  // no sharper than the grid can show
    change += static_cast<float>(forces.curvature_mm) * std::clamp(mean, -bound, bound);
  }
  // Attraction to edges, upwind by the sign of grad g.
  const float* g = forces.edge.values.data() + at;
  const auto attraction = static_cast<float>(forces.attraction_mm);
  const auto drawn = [&](std::ptrdiff_t stride, float back, float ahead) {
    const float slope = attraction * 0.5F * inverse * (g[stride] - g[-stride]);
    return slope * (slope > 0.0F ? ahead : back) * inverse;
  };
  return change + drawn(sx, mx, px) + drawn(sy, my, py) + drawn(sz, mz, pz);
}

}  // namespace

Field signed_distance(const Mask& mask, const Field& grid) {
  const std::vector<float> to_inside = squared_distance_mm2(mask), to_outside = squared_depth_mm2(mask);
  Field phi = grid.filled(0.0F);
  const float half = 0.5F * static_cast<float>(mask.spacing_mm.minCoeff());
  for (std::size_t i = 0; i < phi.values.size(); ++i)
    phi.values[i] = mask.voxels[i] != 0 ? half - std::sqrt(to_outside[i]) : std::sqrt(to_inside[i]) - half;
  // A mask that is all or nothing has no boundary: far away, but finite.
  for (float& v : phi.values) v = std::clamp(v, -1e4F, 1e4F);
  return phi;
}

Cancellable<ContourSummary> evolve(Field& phi, const ContourForces& forces, int iterations,
                                   const RunContext& context, const ShowContour& show) {
  const Neighbours step(phi);
  const auto h = static_cast<float>(phi.spacing_mm.minCoeff());
  Rebuilder rebuilder(phi);
  std::vector<std::size_t> band;
  std::vector<float> change;
  ContourSummary summary;
  long before = -1;
  for (int n = 0; n < iterations; n += kStepsPerRebuild) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(n) / iterations, "segmentation.contour");
    rebuilder.rebuild(phi, band);
    if (show) show(phi);
    for (int inner = 0; inner < kStepsPerRebuild; ++inner) {
      change.resize(band.size());
      share_out_runs(band.size(), least_run(kSpeedCost), [&](std::size_t first, std::size_t end) {
        for (std::size_t b = first; b < end; ++b) change[b] = speed_at(phi, forces, band[b], step, h);
      });
      float fastest = 1e-6F;
      for (const float one : change) fastest = std::max(fastest, std::abs(one));
      // Explicit curvature flow is stable below h^2 / 6 beta; nothing moves more than 0.4 voxels.
      const float dt = std::min(0.4F * h / fastest,
                                h * h / (7.0F * static_cast<float>(std::max(1e-6, forces.curvature_mm))));
      for (std::size_t b = 0; b < band.size(); ++b) phi.values[band[b]] += dt * change[b];
    }
    summary.iterations = n + kStepsPerRebuild;
    if (n % 40 == 0) {
      const long inside =
          std::count_if(phi.values.begin(), phi.values.end(), [](float v) { return v < 0.0F; });
      if (before >= 0 && std::abs(inside - before) < inside / 2000) {
        summary.converged = true;
        break;
      }
      before = inside;
    }
  }
  rebuilder.rebuild(phi, band);
  return summary;
}

}  // namespace glisson::segmentation
