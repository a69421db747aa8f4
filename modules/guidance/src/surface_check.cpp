// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "anchored_points.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/rigid.h"
#include "glisson/registration/moving_surface.h"
#include "lifted_tissue.h"
#include "seen_shares.h"
#include "small_stereo.h"
#include "surface_fit.h"

namespace glisson::guidance {
namespace {

constexpr int kWidth = 640, kStep = 10;  ///< of the reduced pictures, and of the grid there
constexpr double kSupported = 3.0;       ///< standard deviations
constexpr double kApart = 8e-3;          ///< metres beyond those: something else is seen
constexpr int kInside = 2;               ///< places of the grid from the outline: well inside
constexpr int kOccluded = 4;             ///< places of the grid beside something nearer
constexpr int kRegions = 5;              ///< along each side of the picture
constexpr std::size_t kRegionCount = std::size_t{kRegions} * kRegions;
constexpr std::size_t kLeastInRegion = 6;
/// Share of stereo's error that is common to all points of a region and stays in their median (the matcher's
/// locking to whole pixels, the coarse mesh).
constexpr double kRegionStereoShare = 0.5;
constexpr int kFitEvery = 2;  ///< place of the grid, along both axes: what lies between says the same
/// Metres: a point farther than kTissue from the surface is no tissue of the organ, even if the start was
/// wrong; one farther than kBesideRim beside its rim has no place on it.
constexpr double kTissue = 20e-3, kBesideRim = 2e-3;

/// Whether a picture is not zero there. @pre it is not empty.
bool is_set(const Picture& picture, const Eigen::Vector2d& pixel) {
  const auto x = static_cast<std::size_t>(std::lround(pixel.x())),
             y = static_cast<std::size_t>(std::lround(pixel.y()));
  const auto at =
      static_cast<std::size_t>(picture.channels) * (y * static_cast<std::size_t>(picture.width) + x);
  return at < picture.bytes->size() && (*picture.bytes)[at] != 0;
}

}  // namespace

struct SurfaceCheck::Impl {
  Impl(const PatientModel& model, const StereoRig& rig, const Picture& mask_of_left)
      : surface(model, registration::SurfaceDetail::fine),
        in_shape(surface),
        stereo(rig, kWidth, kStep, SmallStereo::kNear, SmallStereo::kFar),
        mask(mask_of_left) {
    allowed.resize(static_cast<std::size_t>(stereo.columns() * stereo.rows()));
    for (int r = 0; r < stereo.rows(); ++r)
      for (int c = 0; c < stereo.columns(); ++c)
        allowed[index(c, r)] = is_allowed(stereo.pixel(c, r), rig.left);
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row * stereo.columns() + column);
  }
  bool is_allowed(const Eigen::Vector2d& pixel, const Camera& camera) const {
    return camera.sees(pixel) && (mask.empty() || is_set(mask, pixel));
  }
  int region(int column, int row) const {
    return kRegions * (kRegions * row / stereo.rows()) + kRegions * column / stereo.columns();
  }

  /// Where the organ should be seen: distance along each ray, and its inclination.
  void predict(const Points& nodes) {
    surface.move(nodes);
    const std::size_t n = allowed.size();
    hit.assign(n, {});
    depth.assign(n, 0.0);
    inclination.assign(n, 0.0);
    for (int r = 0; r < stereo.rows(); ++r)
      for (int c = 0; c < stereo.columns(); ++c) {
        const std::size_t i = index(c, r);
        if (allowed[i] == 0) continue;
        const Eigen::Vector3d& ray = stereo.ray(c, r);
        hit[i] =
            surface.first_hit(Eigen::Vector3d::Zero(), ray, 0.0, std::numeric_limits<double>::infinity());
        if (hit[i].triangle < 0) continue;
        depth[i] = hit[i].point.norm();
        inclination[i] = std::abs(surface.normal(hit[i], normals).dot(ray));
      }
  }
  /// Whether the organ is predicted here and all around.
  bool is_inside(int column, int row) const {
    for (int r = row - kInside; r <= row + kInside; ++r)
      for (int c = column - kInside; c <= column + kInside; ++c) {
        if (c < 0 || r < 0 || c >= stereo.columns() || r >= stereo.rows()) continue;
        if (allowed[index(c, r)] != 0 && depth[index(c, r)] <= 0.0) return false;
      }
    return true;
  }

  /// Beside something nearer (a tool) one view sees what is hidden from the other, and matching errs there.
  /// A greater depth there does not mean that the organ is elsewhere.
  void leave_out_occluded() {
    for (int r = 0; r < stereo.rows(); ++r)
      for (int c = 0; c < stereo.columns(); ++c) {
        if (is_before[index(c, r)] == 0) continue;
        for (int y = std::max(0, r - kOccluded); y <= std::min(stereo.rows() - 1, r + kOccluded); ++y)
          for (int x = std::max(0, c - kOccluded); x <= std::min(stereo.columns() - 1, c + kOccluded); ++x)
            is_behind[index(x, y)] = 0;
      }
  }

  /// What lies within reach of the predicted surface, in one region of the picture.
  struct RegionGaps {
    std::vector<double> values;  ///< metres
    double sigmas = 0.0;         ///< their sum
    /// The median over its own deviation; 0: too little is seen.
    double off() const {
      if (values.size() < kLeastInRegion) return 0.0;
      const auto n = static_cast<double>(values.size());
      const double median = upper_median(values);
      // A median of scattered values, as wrong matches are, says little.
      const double scatter = kDeviationPerMad * median_absolute_deviation(values, median);
      return median / std::sqrt(std::pow(sigmas / n, 2) + 0.5 * std::numbers::pi * scatter * scatter / n);
    }
  };
  using Regions = std::array<RegionGaps, kRegionCount>;

  /// Sorts each point by where it lies to the predicted surface.
  Regions classify(const std::vector<SeenPoint>& points, SurfaceEvidence& evidence) {
    Regions regions;
    for (std::vector<char>* kind : {&is_behind, &is_before, &is_supported}) kind->assign(depth.size(), 0);
    for (const SeenPoint& point : points) {
      const std::size_t i = index(point.column, point.row);
      if (depth[i] <= 0.0) continue;
      ++evidence.seen;
      const double along = point.p_in_camera.norm() - depth[i];
      // Across the surface: on a slope this is less than along the ray.
      const double slope = std::max(0.2, inclination[i]), gap = along * slope;
      const double sigma = std::hypot(point.sigma * slope, kModelSigma);
      if (std::abs(gap) < kSupported * sigma)
        is_supported[i] = 1;
      else if (gap > kSupported * sigma + kApart)
        is_behind[i] = is_inside(point.column, point.row) ? 1 : 0;
      else if (gap < -kSupported * sigma - kApart)
        is_before[i] = 1;
      if (std::abs(gap) > kSupported * sigma + kApart) continue;
      RegionGaps& group = regions[static_cast<std::size_t>(region(point.column, point.row))];
      group.values.push_back(gap);
      group.sigmas += std::hypot(kRegionStereoShare * point.sigma * slope, kModelSigma);
    }
    leave_out_occluded();
    return regions;
  }

  void compare(const std::vector<SeenPoint>& points, const std::vector<FollowedPoint>& followed,
               SurfaceEvidence& evidence) {
    for (const double z : depth) evidence.predicted += z > 0.0;
    look_at_regions(classify(points, evidence), evidence);
    evidence.missing = seen_shares.missing(hit, is_supported);
    lifted = lifted_places(grid_of(points, followed));
    int inside = 0, supported = 0, behind = 0, before = 0, organ = 0;
    for (int r = 0; r < stereo.rows(); ++r)
      for (int c = 0; c < stereo.columns(); ++c) {
        const std::size_t i = index(c, r);
        const bool is_in = depth[i] > 0.0 && is_inside(c, r);
        inside += is_in;
        supported += is_supported[i];
        behind += is_behind[i];
        before += is_in && is_before[i] != 0;
        organ += is_in && lifted[i] != 0;
      }
    if (evidence.predicted > 0) evidence.supported = supported / static_cast<double>(evidence.predicted);
    if (inside == 0) return;
    evidence.behind = behind / static_cast<double>(inside);
    evidence.before = before / static_cast<double>(inside);
    evidence.lifted = organ / static_cast<double>(inside);
  }

  static void look_at_regions(const Regions& regions, SurfaceEvidence& evidence) {
    std::array<double, kRegionCount> off{};
    double sum = 0.0;
    int known = 0;
    for (std::size_t i = 0; i < off.size(); ++i) {
      off[i] = regions[i].off();
      sum += off[i] * off[i];
      known += regions[i].values.size() >= kLeastInRegion;
    }
    evidence.gap = known > 0 ? std::sqrt(sum / known) : 0.0;
    const auto both = [&](std::size_t a, std::size_t b) {
      if (off[a] * off[b] > 0.0)
        evidence.local = std::max(evidence.local, std::min(std::abs(off[a]), std::abs(off[b])));
    };
    constexpr std::size_t kSide = kRegions;
    for (std::size_t i = 0; i < off.size(); ++i) {
      if (i % kSide + 1 < kSide) both(i, i + 1);
      if (i + kSide < off.size()) both(i, i + kSide);
    }
  }

  SeenGrid grid_of(const std::vector<SeenPoint>& points, const std::vector<FollowedPoint>& followed) const {
    SeenGrid grid{stereo.columns(), stereo.rows(), {}, {}, {}, is_before, {}};
    grid.range.assign(depth.size(), 0.0);
    grid.sigma = grid.range;
    for (const double z : depth) grid.predicted.push_back(z > 0.0 ? 1 : 0);
    grid.followed.assign(depth.size(), 0);
    for (const SeenPoint& point : points) {
      grid.range[index(point.column, point.row)] = point.p_in_camera.norm();
      grid.sigma[index(point.column, point.row)] = point.sigma;
    }
    for (const FollowedPoint& point : followed)
      if (const auto at = stereo.place(point.p_in_camera)) ++grid.followed[index(at->first, at->second)];
    return grid;
  }

  /// Where the organ is predicted but stereo sees something behind it, the organ should move to the nearest
  /// place of the picture at which stereo does see it.
  std::vector<LookedThrough> looked_through() const {
    constexpr int kFarthest = 12;  // places of the grid
    std::vector<LookedThrough> through;
    for (int r = 0; r < stereo.rows(); r += kFitEvery)
      for (int c = 0; c < stereo.columns(); c += kFitEvery) {
        const std::size_t i = index(c, r);
        if (is_behind[i] == 0) continue;
        int best = kFarthest * kFarthest + 1, best_c = -1, best_r = -1;
        for (int y = std::max(0, r - kFarthest); y <= std::min(stereo.rows() - 1, r + kFarthest); ++y)
          for (int x = std::max(0, c - kFarthest); x <= std::min(stereo.columns() - 1, c + kFarthest); ++x) {
            const int d = (x - c) * (x - c) + (y - r) * (y - r);
            if (d < best && is_supported[index(x, y)] != 0) {
              best = d;
              best_c = x;
              best_r = y;
            }
          }
        if (best_c >= 0)
          through.push_back({hit[i].point, depth[i] * stereo.ray(best_c, best_r), region(c, r)});
      }
    return through;
  }

  /// The small rigid motion of the organ that stereo asks for, with what it cannot tell.
  void fit(const std::vector<SeenPoint>& points, SurfaceEvidence& evidence) {
    std::vector<SeenPlace> seen;
    for (const SeenPoint& point : points)
      if (point.column % kFitEvery == 0 && point.row % kFitEvery == 0)
        seen.push_back({point.p_in_camera, point.sigma, region(point.column, point.row)});
    const SurfacePull found = fit_to_seen(surface, normals, seen, looked_through());
    evidence.pull = found.pull;
    evidence.pull_sigma = found.sigma;
  }

  /// Whether the organ itself is seen there, and not something that lies before it, however long it rests.
  bool is_organ(const SeenPoint& point, const Picture& not_liver) const {
    const std::size_t i = index(point.column, point.row);
    if (depth[i] <= 0.0 || (is_before[i] != 0 && lifted[i] == 0)) return false;
    return not_liver.empty() || !is_set(not_liver, stereo.pixel(point.column, point.row));
  }

  /// Places of the material as `shape` has them. Without what lies before the organ, or far from it.
  /// @pre compare().
  std::vector<Eigen::Vector3d> tissue(const std::vector<SeenPoint>& points, const Points& shape,
                                      const Picture& not_liver) {
    std::vector<Eigen::Vector3d> places;
    if (shape.rows() == 0) return places;
    if (shape.rows() != shape_now.rows() || shape != shape_now) {
      in_shape.move(shape);
      shape_now = shape;
    }
    for (const SeenPoint& point : points) {
      if (!is_organ(point, not_liver)) continue;
      const int in_sight = hit[index(point.column, point.row)].triangle;
      const ClosestPoint at = surface.closest(Feature::surface, point.p_in_camera, in_sight);
      if (at.triangle < 0 || at.distance > kTissue) continue;
      const Eigen::Vector3d normal = surface.normal(at, normals);
      if (normal.dot(at.point) > 0.0) continue;  // turned away: not what is seen
      const Anchor anchor{at, normal.dot(point.p_in_camera - at.point)};
      if ((anchor.place(surface) - point.p_in_camera).norm() < kBesideRim)
        places.push_back(anchor.place(in_shape));
    }
    return places;
  }

  registration::MovingSurface surface, in_shape;
  SeenShares seen_shares{surface.mesh().triangle_count()};
  Points shape_now;                  ///< of in_shape
  registration::NormalMemo normals;  ///< of surface
  SmallStereo stereo;
  Picture mask;
  std::vector<char> allowed, is_behind, is_before, is_supported, lifted;
  std::vector<ClosestPoint> hit;
  std::vector<double> depth, inclination;
};

SurfaceCheck::SurfaceCheck(const PatientModel& model, const StereoRig& rig, const Picture& mask)
    : impl_(std::make_unique<Impl>(model, rig, mask)) {}
SurfaceCheck::~SurfaceCheck() = default;

SurfaceEvidence SurfaceCheck::check(const Picture& left, const Picture& right, const Points& nodes_in_camera,
                                    const Points& shape, const std::vector<FollowedPoint>& followed,
                                    const Picture& not_liver) {
  SurfaceEvidence evidence;
  std::vector<SeenPoint> points = impl_->stereo.see(left, right);
  std::erase_if(points, [&](const SeenPoint& point) {
    return impl_->allowed[impl_->index(point.column, point.row)] == 0;
  });
  impl_->predict(nodes_in_camera);
  impl_->compare(points, followed, evidence);
  impl_->fit(points, evidence);
  evidence.tissue = impl_->tissue(points, shape, not_liver);
  if (shape.rows() > 0)
    evidence.eye = fit_rigid<CameraFrame, CameraFrame>(nodes_in_camera, shape).translation;
  return evidence;
}

void SurfaceCheck::learn() { impl_->seen_shares.learn(impl_->hit, impl_->is_supported); }
void SurfaceCheck::forget() { impl_->seen_shares = SeenShares(impl_->surface.mesh().triangle_count()); }

}  // namespace glisson::guidance
