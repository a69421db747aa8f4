// SPDX-License-Identifier: GPL-3.0-or-later
#include "parting.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "glisson/core/statistics.h"
#include "glisson/volume/voxel_neighbours.h"

namespace glisson::segmentation {
namespace {

constexpr double kSeamBlur = 1.5;  // mm
constexpr double kTypical = 0.95;  // of the tissue without seams that counts as such
constexpr float kSameBody = 0.8F;  // of the shallower body's depth that a neck within a body has
/// What a part shares with owned ones, of a half ball's flat face, where somebody clicked outside.
constexpr double kBroad = 0.8;
constexpr double kDoubtful = 0.1;
constexpr double kDoubtfulMl = 100.0;  // a pancreas has less
constexpr float kPassage = 1.9F;       // voxels of depth from which on a face counts
constexpr double kFacets = 2.0 / 3.0;  // mean area of a plane over that of the voxels' faces along it
constexpr double kBesideClick = 4.0;   // mm from a click to the tissue that it means
constexpr double kSpeck = 300.0;       // mm^3
constexpr float kThinBody = 5.0F;      // mm of depth from which on a part is a body

/// How much more the intensity curves up across the darkest direction than along the others, HU.
float sheet_response(const Field& blurred, std::size_t at) {
  const std::array<std::ptrdiff_t, 3> s = {
      1, blurred.size.x(),
      static_cast<std::ptrdiff_t>(blurred.size.x()) * static_cast<std::ptrdiff_t>(blurred.size.y())};
  const float* p = blurred.values.data() + at;
  Eigen::Matrix3f h;
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) {
      const std::ptrdiff_t sa = s[static_cast<std::size_t>(a)], sb = s[static_cast<std::size_t>(b)];
      const auto scale =
          static_cast<float>(kSeamBlur * kSeamBlur / (blurred.spacing_mm[a] * blurred.spacing_mm[b]));
      h(a, b) = h(b, a) = scale * (a == b ? p[sa] - 2.0F * p[0] + p[-sa]
                                          : 0.25F * (p[sa + sb] - p[sa - sb] - p[sb - sa] + p[-sa - sb]));
    }
  if (h.trace() <= 0.0F) return 0.0F;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(h, Eigen::EigenvaluesOnly);
  return std::max(0.0F, solver.eigenvalues()[2] - std::abs(solver.eigenvalues()[1]));
}

/// Of a half ball of that volume, mm^3.
double flat_face_mm2(double volume) {
  constexpr double kHalfBall = 1.92;  // of the volume's power 2/3
  return kHalfBall * std::pow(volume, 2.0 / 3.0);
}

/// Sets of numbers that are united.
class Unions {
 public:
  explicit Unions(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int n) {
    auto& parent = parent_;
    while (parent[static_cast<std::size_t>(n)] != n) {
      auto& up = parent[static_cast<std::size_t>(n)];
      up = parent[static_cast<std::size_t>(up)];
      n = up;
    }
    return n;
  }
  /// @return the one that stays.
  int unite(int stays, int goes) { return parent_[static_cast<std::size_t>(goes)] = stays; }

 private:
  std::vector<int> parent_;
};

/// Parts that are united, and the volume of what they make.
class Bodies {
 public:
  explicit Bodies(const std::vector<double>& volume) : unions_(volume.size()), volume_(volume) {}
  int of(int part) { return unions_.of(part); }
  void unite(int a, int b) {
    const int stays = of(a), goes = of(b);
    if (stays == goes) return;
    unions_.unite(stays, goes);
    volume_[static_cast<std::size_t>(stays)] += volume_[static_cast<std::size_t>(goes)];
  }
  double volume_of(int body) const { return volume_[static_cast<std::size_t>(body)]; }
  /// By body; of other parts what they had when they were united.
  const std::vector<double>& volume() const { return volume_; }

 private:
  Unions unions_;
  std::vector<double> volume_;
};

/// Calls visit(voxel, neighbour) for every face between two voxels.
template <class Visit>
void each_face(const Eigen::Vector3i& size, const Visit& visit) {
  const auto sy = static_cast<std::size_t>(size.x()), sz = sy * static_cast<std::size_t>(size.y());
  std::size_t at = 0;
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i, ++at) {
        if (i + 1 < size.x()) visit(at, at + 1);
        if (j + 1 < size.y()) visit(at, at + sy);
        if (k + 1 < size.z()) visit(at, at + sz);
      }
}

struct Face {
  int a, b;  ///< parts, a < b
  float value;
  bool operator<(const Face& other) const { return a != other.a ? a < other.a : b < other.b; }
};

/// The faces between parts, one entry a pair, with what `combine` makes of their values.
template <class ValueOf, class Combine>
std::vector<Face> faces_between(const Eigen::Vector3i& size, const std::vector<int>& part,
                                const ValueOf& value_of, const Combine& combine) {
  std::vector<Face> faces;
  each_face(size, [&](std::size_t at, std::size_t next) {
    const int a = part[at], b = part[next];
    if (a < 0 || b < 0 || a == b) return;
    faces.push_back({std::min(a, b), std::max(a, b), value_of(at, next)});
  });
  std::stable_sort(faces.begin(), faces.end());
  std::size_t count = 0;
  for (const Face& face : faces)
    if (count > 0 && faces[count - 1].a == face.a && faces[count - 1].b == face.b)
      faces[count - 1].value = combine(faces[count - 1].value, face.value);
    else
      faces[count++] = face;
  faces.resize(count);
  return faces;
}

/// What is not tissue, without specks of noise in it.
Mask beyond_of(const Mask& tissue) {
  Mask beyond = complement(tissue);
  std::vector<long> sizes;
  const std::vector<int> number = connected_components(beyond, sizes);
  const double voxel_mm3 = tissue.spacing_mm.prod();
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] > 0 &&
        static_cast<double>(sizes[static_cast<std::size_t>(number[i]) - 1]) * voxel_mm3 < kSpeck)
      beyond.voxels[i] = 0;
  return beyond;
}

class Parting {
 public:
  Parting(const Field& ct, const Mask& tissue, double wide) : ct_(ct), wide_(wide), tissue_(tissue) {
    const Mask beyond = beyond_of(tissue);
    for (std::size_t i = 0; i < beyond.voxels.size(); ++i) tissue_.voxels[i] = beyond.voxels[i] == 0 ? 1 : 0;
    depth_ = squared_distance_mm2(beyond);
    for (float& depth : depth_) depth = std::sqrt(depth);
  }

  /// Every voxel to the part of its highest neighbour, from the deepest ones outwards.
  void flood() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < depth_.size(); ++i)
      if (tissue_.voxels[i] != 0) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return depth_[a] > depth_[b]; });
    part_.assign(depth_.size(), -1);
    for (const std::size_t at : order) {
      int best = -1;
      each_face_neighbour(ct_.size, at, [&](std::size_t other, int) {
        const int part = part_[other];
        if (part >= 0 &&
            (best < 0 || peak_[static_cast<std::size_t>(part)] > peak_[static_cast<std::size_t>(best)]))
          best = part;
      });
      if (best < 0) {
        best = static_cast<int>(peak_.size());
        peak_.push_back(depth_[at]);
      }
      part_[at] = best;
    }
  }

  /// Which parts the clicks mean: bit 1 inside, bit 2 outside.
  void mark(const LiverSeeds& seeds) {
    clicked_.assign(peak_.size(), 0);
    for (const auto& [points, bit] :
         {std::pair(&seeds.inside, 1), std::pair(&seeds.lesions, 1), std::pair(&seeds.outside, 2)})
      for (const Eigen::Vector3i& click : *points)
        if (const int part = part_near(click); part >= 0)
          clicked_[static_cast<std::size_t>(part)] =
              static_cast<std::uint8_t>(clicked_[static_cast<std::size_t>(part)] | bit);
  }

  void unite_shallow() {
    std::vector<Face> necks = faces_between(
        ct_.size, part_, [&](std::size_t a, std::size_t b) { return std::min(depth_[a], depth_[b]); },
        [](float a, float b) { return std::max(a, b); });
    std::stable_sort(necks.begin(), necks.end(),
                     [](const Face& x, const Face& y) { return x.value > y.value; });
    Unions unions(peak_.size());
    for (const Face& neck : necks) {
      auto a = static_cast<std::size_t>(unions.of(neck.a)), b = static_cast<std::size_t>(unions.of(neck.b));
      if (a == b || (clicked_[a] | clicked_[b]) == 3) continue;
      if (peak_[a] < peak_[b]) std::swap(a, b);
      if (neck.value < kSameBody * peak_[b]) continue;
      unions.unite(static_cast<int>(a), static_cast<int>(b));
      clicked_[a] |= clicked_[b];
    }
    for (int& part : part_)
      if (part >= 0) part = unions.of(part);
  }

  Sides sides() const {
    std::vector<double> volume(peak_.size(), 0.0), shared(peak_.size(), 0.0);
    const double voxel_mm3 = ct_.spacing_mm.prod();
    for (const int part : part_)
      if (part >= 0) volume[static_cast<std::size_t>(part)] += voxel_mm3;
    const auto face_mm2 = static_cast<float>(kFacets * std::pow(voxel_mm3, 2.0 / 3.0));
    // Strips of one voxel are seams that the picture does not resolve.
    const float passage_mm = kPassage * static_cast<float>(ct_.spacing_mm.minCoeff());
    const std::vector<Face> walls = faces_between(
        ct_.size, part_,
        [&](std::size_t a, std::size_t b) {
          return std::min(depth_[a], depth_[b]) > passage_mm ? face_mm2 : 0.0F;
        },
        [](float a, float b) { return a + b; });
    std::vector<std::uint8_t> owned(peak_.size(), 0);
    for (std::size_t n = 0; n < owned.size(); ++n) owned[n] = (clicked_[n] & 1) != 0 ? 1 : 0;
    own_more(
        walls, volume, [&](std::size_t n) { return clicked_[n] == 0 ? wide_ : kBroad; }, owned, shared);
    Sides sides{ct_.empty_mask(), ct_.empty_mask(), ct_.empty_mask()};
    tell_doubtful(walls, owned, volume, sides);
    for (std::size_t i = 0; i < part_.size(); ++i) {
      if (part_[i] < 0) continue;
      const auto n = static_cast<std::size_t>(part_[i]);
      sides.own.voxels[i] = owned[n];
      sides.rival.voxels[i] = owned[n] == 0 && (clicked_[n] != 0 || peak_[n] >= kThinBody);
    }
    return sides;
  }

 private:
  /// Adds every part whose face with owned ones is enough, of a half ball's flat one. What is shared only
  /// grows, so that the order does not matter. @param shared mm^2, with owned parts; counted here.
  template <class Enough>
  static void own_more(const std::vector<Face>& walls, const std::vector<double>& volume,
                       const Enough& enough, std::vector<std::uint8_t>& owned, std::vector<double>& shared) {
    std::vector<std::vector<std::pair<int, float>>> neighbours(owned.size());
    for (const Face& wall : walls) {
      neighbours[static_cast<std::size_t>(wall.a)].emplace_back(wall.b, wall.value);
      neighbours[static_cast<std::size_t>(wall.b)].emplace_back(wall.a, wall.value);
    }
    std::vector<std::size_t> waiting;
    for (std::size_t n = 0; n < owned.size(); ++n)
      if (owned[n] != 0) waiting.push_back(n);
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      for (const auto& [other, area] : neighbours[at]) {
        const auto n = static_cast<std::size_t>(other);
        shared[n] += area;
        if (owned[n] != 0 || shared[n] < enough(n) * flat_face_mm2(volume[n])) continue;
        owned[n] = 1;
        waiting.push_back(n);
      }
    }
  }

  /// A lobe may fall into parts itself: what nobody clicked and broadly belongs together is judged as one,
  /// and so is what hangs on the liver by way of others only, as the pieces of a lobe of another grey do.
  void tell_doubtful(const std::vector<Face>& walls, const std::vector<std::uint8_t>& owned,
                     const std::vector<double>& volume, Sides& sides) const {
    const auto is_nobodys = [&](int part) {
      return owned[static_cast<std::size_t>(part)] == 0 && clicked_[static_cast<std::size_t>(part)] == 0;
    };
    const auto volume_of = [&](int part) { return volume[static_cast<std::size_t>(part)]; };
    Bodies broad(volume);
    for (const Face& wall : walls)
      if (is_nobodys(wall.a) && is_nobodys(wall.b) &&
          wall.value >= wide_ * flat_face_mm2(std::min(volume_of(wall.a), volume_of(wall.b))))
        broad.unite(wall.a, wall.b);
    std::vector<Face> between;
    for (const Face& wall : walls)
      if (broad.of(wall.a) != broad.of(wall.b))
        between.push_back({broad.of(wall.a), broad.of(wall.b), wall.value});
    std::vector<std::uint8_t> hangs = owned;
    std::vector<double> shared(peak_.size(), 0.0);
    own_more(
        between, broad.volume(),
        [&](std::size_t n) { return clicked_[n] == 0 ? kDoubtful : std::numeric_limits<double>::infinity(); },
        hangs, shared);
    const auto is_doubtful = [&](int part) {
      return is_nobodys(part) && hangs[static_cast<std::size_t>(broad.of(part))] != 0;
    };
    Bodies all = broad;
    for (const Face& wall : walls)
      if (wall.value > 0.0F && is_doubtful(wall.a) && is_doubtful(wall.b)) all.unite(wall.a, wall.b);
    int found = -1;
    for (int n = 0; n < static_cast<int>(owned.size()); ++n)
      if (all.of(n) == n && is_doubtful(n) &&
          1e-3 * all.volume_of(n) >= std::max(kDoubtfulMl, sides.doubtful_ml)) {
        found = n;
        sides.doubtful_ml = 1e-3 * all.volume_of(n);
      }
    if (found < 0) return;
    int largest = -1;
    for (int n = 0; n < static_cast<int>(owned.size()); ++n)
      if (all.of(n) == found && (largest < 0 || broad.volume_of(broad.of(n)) > broad.volume_of(largest)))
        largest = broad.of(n);
    float deepest = 0.0F;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      if (part_[i] < 0 || broad.of(part_[i]) != largest) continue;
      sides.perhaps.voxels[i] = 1;
      if (depth_[i] <= deepest) continue;
      deepest = depth_[i];
      sides.doubtful = ct_.voxel_at(i);
    }
  }

  int part_near(const Eigen::Vector3i& click) const {
    const int reach = static_cast<int>(std::ceil(kBesideClick / ct_.spacing_mm.minCoeff()));
    double best = kBesideClick;
    int part = -1;
    for (int k = -reach; k <= reach; ++k)
      for (int j = -reach; j <= reach; ++j)
        for (int i = -reach; i <= reach; ++i) {
          const Eigen::Vector3i v = click + Eigen::Vector3i(i, j, k);
          const double d = Eigen::Vector3d(i, j, k).cwiseProduct(ct_.spacing_mm).norm();
          if (d >= best || !ct_.contains(v) || part_[ct_.offset(v)] < 0) continue;
          best = d;
          part = part_[ct_.offset(v)];
        }
    return part;
  }

  const Field& ct_;
  double wide_;  ///< what a part of nobody's clicks shares with owned ones
  Mask tissue_;
  std::vector<float> depth_, peak_;
  std::vector<int> part_;
  std::vector<std::uint8_t> clicked_;
};

}  // namespace

DarkSheets::DarkSheets(const Field& ct, const Mask& where)
    : where_(where), response_(ct.values.size(), 0.0F) {
  Field blurred = ct;
  smooth(blurred, kSeamBlur);
  for (int k = 1; k + 1 < ct.size.z(); ++k)
    for (int j = 1; j + 1 < ct.size.y(); ++j)
      for (int i = 1; i + 1 < ct.size.x(); ++i)
        if (const std::size_t at = ct.offset(i, j, k); where.voxels[at] != 0)
          response_[at] = sheet_response(blurred, at);
}

void DarkSheets::learn(const Mask& typical) {
  std::vector<float> usual;
  for (std::size_t i = 0; i < response_.size(); ++i)
    if (where_.voxels[i] != 0 && typical.voxels[i] != 0) usual.push_back(response_[i]);
  if (!usual.empty()) limit_ = std::min(limit_, lower_percentile(std::move(usual), kTypical));
}

Mask DarkSheets::sheets() const {
  Mask sheets(where_.size, where_.spacing_mm);
  for (std::size_t i = 0; i < response_.size(); ++i) sheets.voxels[i] = response_[i] > limit_ ? 1 : 0;
  return sheets;
}

Cancellable<Sides> part_at_necks(const Field& ct, const Mask& tissue, const LiverSeeds& seeds,
                                 const RunContext& context, double wide) {
  Parting parting(ct, tissue, wide);
  if (context.cancelled()) return std::nullopt;
  parting.flood();
  parting.mark(seeds);
  if (context.cancelled()) return std::nullopt;
  parting.unite_shallow();
  return parting.sides();
}

}  // namespace glisson::segmentation
