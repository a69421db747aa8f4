// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_set.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include "glisson/volume/voxel_neighbours.h"

namespace glisson::segmentation {
namespace {

constexpr float kBandVoxels = 3.5F;  // half width of the band, in voxels
constexpr int kStepsPerRebuild = 4;  // 0.3 voxels a step at most: the front stays well inside the band

struct Neighbours {
  std::size_t x, y, z;
  explicit Neighbours(const Field& field)
      : x(1),
        y(static_cast<std::size_t>(field.size.x())),
        z(static_cast<std::size_t>(field.size.x()) * static_cast<std::size_t>(field.size.y())) {}
};

struct Entry {
  float distance;
  std::size_t at;
  bool operator>(const Entry& other) const {
    return distance != other.distance ? distance > other.distance : at > other.at;
  }
};

/// Rebuilds phi as a distance within the band, keeping its zero, and clamps it beyond. Band voxels that are
/// not on the volume's edge go to `band`, in memory order.
class Rebuilder {
 public:
  explicit Rebuilder(const Field& phi) : h_(static_cast<float>(phi.spacing_mm.minCoeff())) {
    distance_.resize(phi.values.size());
    done_.resize(phi.values.size());
  }

  void rebuild(Field& phi, std::vector<std::size_t>& band) {
    const float limit = kBandVoxels * h_;
    std::fill(distance_.begin(), distance_.end(), limit);
    std::fill(done_.begin(), done_.end(), 0);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    start(phi, queue);
    march(phi, queue, limit);
    band.clear();
    std::size_t at = 0;
    for (int k = 0; k < phi.size.z(); ++k)
      for (int j = 0; j < phi.size.y(); ++j)
        for (int i = 0; i < phi.size.x(); ++i, ++at) {
          phi.values[at] = phi.values[at] < 0.0F ? -distance_[at] : distance_[at];
          const bool inner =
              i > 0 && j > 0 && k > 0 && i + 1 < phi.size.x() && j + 1 < phi.size.y() && k + 1 < phi.size.z();
          if (inner && distance_[at] < limit) band.push_back(at);
        }
  }

 private:
  /// Voxels beside the interface: their distance by linear interpolation along each axis.
  template <class Queue>
  void start(const Field& phi, Queue& queue) {
    for (std::size_t at = 0; at < phi.values.size(); ++at) {
      const float here = phi.values[at];
      if (std::abs(here) > 4.0F * h_) continue;
      std::array<float, 3> nearest = {1e30F, 1e30F, 1e30F};
      bool crossed = false;
      each_face_neighbour(phi.size, at, [&](std::size_t other, int axis) {
        const float there = phi.values[other];
        if ((here < 0.0F) == (there < 0.0F)) return;
        crossed = true;
        const float d = h_ * std::abs(here) / std::max(1e-12F, std::abs(here - there));
        float& best = nearest[static_cast<std::size_t>(axis)];
        best = std::min(best, std::max(d, 1e-4F * h_));
      });
      if (!crossed) continue;
      float sum = 0.0F;
      for (const float d : nearest) sum += 1.0F / (d * d);
      distance_[at] = 1.0F / std::sqrt(sum);
      queue.push({distance_[at], at});
    }
  }

  /// |grad d| = 1 solved upwind from the accepted neighbours (Sethian 1996).
  float solve(const Field& phi, std::size_t at) const {
    std::array<float, 3> smallest = {1e30F, 1e30F, 1e30F};
    each_face_neighbour(phi.size, at, [&](std::size_t other, int axis) {
      if (done_[other] != 0)
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

  template <class Queue>
  void march(const Field& phi, Queue& queue, float limit) {
    while (!queue.empty()) {
      const Entry entry = queue.top();
      queue.pop();
      if (done_[entry.at] != 0) continue;
      done_[entry.at] = 1;
      each_face_neighbour(phi.size, entry.at, [&](std::size_t other, int) {
        if (done_[other] != 0) return;
        const float d = solve(phi, other);
        if (d < distance_[other] && d < limit) {
          distance_[other] = d;
          queue.push({d, other});
        }
      });
    }
  }

  float h_;
  std::vector<float> distance_;
  std::vector<std::uint8_t> done_;
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
      float fastest = 1e-6F;
      for (std::size_t b = 0; b < band.size(); ++b) {
        change[b] = speed_at(phi, forces, band[b], step, h);
        fastest = std::max(fastest, std::abs(change[b]));
      }
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
