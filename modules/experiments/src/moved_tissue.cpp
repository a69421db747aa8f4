// SPDX-License-Identifier: GPL-3.0-or-later
#include "moved_tissue.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "cv_picture.h"
#include "glisson/core/statistics.h"
#include "glisson/insilico/ray_caster.h"
#include "glisson/model/build.h"
#include "glisson/stereo/reconstruct_pair.h"
#include "glisson/stereo/source.h"

namespace glisson::experiments {
namespace {

constexpr double kFrameRate = 30.0;
constexpr double kTurn = 2.0 * std::numbers::pi;
/// Of the films' noise: no seed is another film's.
constexpr std::uint64_t kLiftedNoise = 1000000, kCutNoise = 2000000, kFastNoise = 3000000;

/// The tissue as it moves before a laparoscope that stands.
struct Handled {
  Eigen::Vector3d pressed_at;
  bool is_lifted = false, is_cut = false;
};

/// How far from the middle of what is seen tissue is lifted by a tool, seconds after the first frame.
double lift(const Eigen::Vector3d& p, const Eigen::Vector3d& middle, double seconds) {
  constexpr double kLift = 30e-3, kAside = 20e-3, kWide = 22e-3;
  const double t = std::clamp(seconds - 1.0, 0.0, 1.0);
  const double away = (p - middle - Eigen::Vector3d(kAside, 0.0, 0.0)).head<2>().squaredNorm();
  return kLift * t * t * (3.0 - 2.0 * t) * std::exp(-away / (2.0 * kWide * kWide));
}

/// How far what lies to the right of a cut has gone aside, seconds after the first frame: the cut gapes from
/// one vertex of the sheet to the next, between them its rims are drawn out.
Eigen::Vector3d gape(const Eigen::Vector3d& p, const Eigen::Vector3d& middle, double seconds) {
  constexpr double kAside = 8e-3;
  const double t = std::clamp(seconds - 1.0, 0.0, 1.0);
  if (p.x() / p.z() < (middle.x() + kAside) / middle.z()) return Eigen::Vector3d::Zero();
  return t * t * (3.0 - 2.0 * t) * Eigen::Vector3d(15e-3, 0.0, 4e-3);
}

/// Where the tissue of the first frame is `seconds` later.
Eigen::Vector3d deformed(const Eigen::Vector3d& p, const Handled& handled, double seconds) {
  constexpr double kWide = 18e-3;
  const Eigen::Vector3d& pressed_at = handled.pressed_at;
  const Eigen::Vector3d breathed =
      p + (0.5 - 0.5 * std::cos(kTurn * seconds / 4.0)) * Eigen::Vector3d(0.0, 5e-3, 2e-3);
  if (handled.is_lifted) return breathed - Eigen::Vector3d(0.0, 0.0, lift(p, pressed_at, seconds));
  if (handled.is_cut) return breathed + gape(p, pressed_at, seconds);
  const double press = 0.5 - 0.5 * std::cos(kTurn * seconds / 2.7);
  const double near = std::exp(-(p - pressed_at).squaredNorm() / (2.0 * kWide * kWide));
  return breathed + press * near * Eigen::Vector3d(0.0, 0.0, 4e-3);
}

/// What a hand does: turns about a trocar 80 mm behind the lens, rolls, slides in and out.
Eigen::Isometry3d hand(double seconds) {
  const auto swing = [&](double degrees, double period, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees / 360.0 * kTurn * std::sin(kTurn * seconds / period), axis);
  };
  const Eigen::Translation3d trocar(0.0, 0.0, -80e-3);
  return Eigen::Translation3d(0.0, 0.0, 8e-3 * std::sin(kTurn * seconds / 4.0)) * trocar *
         (swing(5.0, 3.0, Eigen::Vector3d::UnitY()) * swing(3.0, 3.7, Eigen::Vector3d::UnitX()) *
          swing(8.0, 5.0, Eigen::Vector3d::UnitZ())) *
         trocar.inverse();
}

/// The same at more than twice the pace, up to some 30 degrees a second, from standing to it in half a
/// second.
Eigen::Isometry3d fast_hand(double seconds) {
  constexpr double kPace = 2.2, kEase = 0.5;
  return hand(kPace * (seconds < kEase ? seconds * seconds / (2.0 * kEase) : seconds - 0.5 * kEase));
}

/// The depth that the pair shows, smooth and everywhere: planes (inverse depth is linear on a plane) fitted
/// to the points around.
class Relief {
 public:
  explicit Relief(const LabelledCloud& cloud) {
    for (int i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d p = cloud.points.row(i).transpose();
      samples_.push_back({p.x() / p.z(), p.y() / p.z(), 1.0 / p.z()});
      box_.extend(samples_.back().head<2>());
    }
    wide_ = 0.03 * box_.diagonal().norm();
  }
  const Eigen::AlignedBox2d& box() const { return box_; }

  /// @param at x / z and y / z; outside of what was seen the depth goes on as it is at its border.
  Eigen::Vector3d surface(const Eigen::Vector2d& at) const {
    const Eigen::Vector2d inside = at.cwiseMax(box_.min()).cwiseMin(box_.max());
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (double wide = wide_; normal(2, 2) < 20.0; wide *= 1.5) {
      normal = 1e-9 * Eigen::Matrix3d::Identity(), right.setZero();
      for (const Eigen::Vector3d& sample : samples_) {
        const Eigen::Vector2d away = sample.head<2>() - inside;
        const double weight = std::exp(-away.squaredNorm() / (2.0 * wide * wide));
        const Eigen::Vector3d row(away.x(), away.y(), 1.0);
        normal += weight * row * row.transpose();
        right += weight * sample.z() * row;
      }
    }
    return Eigen::Vector3d(at.x(), at.y(), 1.0) / normal.ldlt().solve(right).z();
  }

 private:
  std::vector<Eigen::Vector3d> samples_;  ///< x / z, y / z, 1 / z
  Eigen::AlignedBox2d box_;
  double wide_ = 0.0;
};

/// A sheet of the relief, `columns` x `rows` vertices over the box.
TriangleMesh sheet(const Relief& relief, const Eigen::AlignedBox2d& box, int columns, int rows) {
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(columns) * rows, 3);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Eigen::Vector2d share(i / (columns - 1.0), j / (rows - 1.0));
      mesh.vertices.row(static_cast<Eigen::Index>(j) * columns + i) =
          relief.surface(box.min() + share.cwiseProduct(box.sizes())).transpose();
    }
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = j * columns + i;
      triangles.push_back({a, a + columns, a + 1});
      triangles.push_back({a + 1, a + columns, a + columns + 1});
    }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  return mesh;
}

/// The sheet's vertices, moved `deep` along the rays through them.
Eigen::RowVector3d below(const Eigen::RowVector3d& p, double deep) { return p + deep * p.normalized(); }

/// Below a sheet of columns x rows vertices, in layers: each cell six tetrahedra about its diagonal (Kuhn).
TetMesh slab(const TriangleMesh& top, int columns, int rows, int layers, double deep) {
  TetMesh mesh;
  const int each = columns * rows;
  mesh.vertices.resize(static_cast<Eigen::Index>(each) * (layers + 1), 3);
  for (int l = 0; l <= layers; ++l)
    for (int n = 0; n < each; ++n)
      mesh.vertices.row(static_cast<Eigen::Index>(l) * each + n) =
          below(top.vertices.row(n), deep * l / layers);
  constexpr int kWays[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const int steps[3] = {1, columns, each};
  std::vector<Eigen::RowVector4i> all;
  for (int l = 0; l < layers; ++l)
    for (int j = 0; j + 1 < rows; ++j)
      for (int i = 0; i + 1 < columns; ++i)
        for (const auto& way : kWays) {
          Eigen::RowVector4i corners;
          corners[0] = l * each + j * columns + i;
          for (int k = 0; k < 3; ++k) corners[k + 1] = corners[k] + steps[way[k]];
          const Eigen::RowVector3d o = mesh.vertices.row(corners[0]);
          Eigen::Matrix3d edges;
          for (int k = 0; k < 3; ++k) edges.row(k) = mesh.vertices.row(corners[k + 1]) - o;
          if (edges.determinant() < 0.0) std::swap(corners[2], corners[3]);
          all.push_back(corners);
        }
  mesh.tetrahedra.resize(static_cast<Eigen::Index>(all.size()), 4);
  for (std::size_t t = 0; t < all.size(); ++t) mesh.tetrahedra.row(static_cast<Eigen::Index>(t)) = all[t];
  return mesh;
}

/// One view of the pair, drawn anew where the sheet has moved to.
class MovedView {
 public:
  MovedView(const Picture& picture, const Camera& camera, insilico::RayTable rays, TriangleMesh rest)
      : picture_(view_of(picture)),
        tissue_(picture_),
        camera_(camera),
        rays_(std::move(rays)),
        rest_(std::move(rest)),
        lens_(picture_.size(), CV_8U, cv::Scalar(0)) {
    if (const auto circle = stereo::find_scope_circle(picture)) fill_beyond(*circle);
    while (widest_ < 3.0 && radius_of(widest_ + 0.01) > radius_of(widest_)) widest_ += 0.01;
    for (int y = 0; y < lens_.rows; ++y)
      for (int x = 0; x < lens_.cols; ++x) {
        const Eigen::Vector2d pixel(x, y);
        const Eigen::Vector3d ray = camera_.ray(pixel);
        if (is_in_lens(ray) && (camera_.project(ray) - pixel).norm() < 0.5)
          lens_.at<std::uint8_t>(y, x) = 255;
      }
  }

  /// @param rest_to_camera from the first frame's left camera to this one.
  Picture draw(const insilico::RayCaster& moved, const Eigen::Isometry3d& rest_to_camera,
               std::uint64_t seed) const {
    cv::Mat map(tissue_.size(), CV_32FC2, cv::Scalar(-9.0, -9.0));
    std::vector<insilico::RayHit> hits(static_cast<std::size_t>(rays_.width));
    for (int y = 0; y < rays_.height; ++y) {
      moved.cast(rays_.origin, rays_.directions.data() + static_cast<std::size_t>(y) * hits.size(),
                 rays_.width, hits.data());
      for (int x = 0; x < rays_.width; ++x) {
        const insilico::RayHit& hit = hits[static_cast<std::size_t>(x)];
        if (hit.thing != insilico::RayHit::Thing::organ || lens_.at<std::uint8_t>(y, x) == 0) continue;
        Eigen::Vector3d p = Eigen::Vector3d::Zero();
        for (int k = 0; k < 3; ++k)
          p += static_cast<double>(hit.barycentric[k]) * rest_.vertex(rest_.triangles(hit.triangle, k));
        const Eigen::Vector2d pixel = camera_.project(mirrored_into_lens(rest_to_camera * p));
        map.at<cv::Vec2f>(y, x) = {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
      }
    }
    cv::Mat drawn;
    cv::remap(tissue_, drawn, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_CONSTANT);
    if (!outside_.empty()) picture_.copyTo(drawn, outside_);
    add_noise(drawn, 2.0, seed);
    return picture_of(drawn);
  }

 private:
  /// Tissue beyond the laparoscope's circle, which comes into sight when it moves: what is inside, mirrored
  /// at the rim. What is drawn outside of the circle stays as it is: the circle stands.
  void fill_beyond(const stereo::ScopeCircle& circle) {
    const Picture inside = stereo::circle_mask(circle, picture_.cols, picture_.rows);
    outside_ = view_of(inside) == 0;
    const double radius = circle.radius - 6.0;
    cv::Mat map(picture_.size(), CV_32FC2);
    for (int y = 0; y < map.rows; ++y)
      for (int x = 0; x < map.cols; ++x) {
        Eigen::Vector2d from(x - circle.centre.x(), (y - circle.centre.y()) / circle.aspect);
        if (const double r = from.norm(); r > radius) from *= std::max(0.0, 2.0 * radius - r) / r;
        map.at<cv::Vec2f>(y, x) = {static_cast<float>(circle.centre.x() + from.x()),
                                   static_cast<float>(circle.centre.y() + from.y() * circle.aspect)};
      }
    cv::Mat filled;
    cv::remap(picture_, filled, map, cv::noArray(), cv::INTER_LINEAR);
    tissue_ = filled;
  }
  /// Where on the picture a ray of this slope arrives, over the focal length.
  double radius_of(double slope) const {
    const double r2 = slope * slope;
    return slope *
           (1.0 + r2 * (camera_.distortion[0] + r2 * (camera_.distortion[1] + r2 * camera_.distortion[4])));
  }
  /// Beyond that the distortion's polynomial folds the picture back.
  bool is_in_lens(const Eigen::Vector3d& p) const {
    return p.z() > 0.0 && p.head<2>().norm() < widest_ * p.z();
  }

  Eigen::Vector3d mirrored_into_lens(const Eigen::Vector3d& p) const {
    const Eigen::Vector2d slope = p.head<2>() / p.z();
    const double far = slope.norm(), most = 0.99 * widest_;
    if (far < most) return p;
    const Eigen::Vector2d inside = slope * (std::max(0.0, 2.0 * most - far) / far);
    return {inside.x(), inside.y(), 1.0};
  }

  cv::Mat picture_, tissue_, outside_;
  Camera camera_;
  insilico::RayTable rays_;
  TriangleMesh rest_;
  double widest_ = 0.0;
  cv::Mat lens_;  ///< where the calibration's distortion can be undone
};

Points moved(const Points& rest, const Handled& handled, double seconds, const Eigen::Isometry3d& scope) {
  Points now(rest.rows(), 3);
  for (Eigen::Index i = 0; i < rest.rows(); ++i)
    now.row(i) = (scope * deformed(rest.row(i).transpose(), handled, seconds)).transpose();
  return now;
}

/// Where what is wanted was seen: all but the outermost twentieth on either side.
Eigen::AlignedBox2d inner_box(const LabelledCloud& cloud) {
  std::vector<double> x, y;
  for (int i = 0; i < cloud.size(); ++i) {
    x.push_back(cloud.points(i, 0) / cloud.points(i, 2));
    y.push_back(cloud.points(i, 1) / cloud.points(i, 2));
  }
  return {Eigen::Vector2d(lower_percentile(x, 0.05), lower_percentile(y, 0.05)),
          Eigen::Vector2d(lower_percentile(x, 0.95), lower_percentile(y, 0.95))};
}

}  // namespace

Cancellable<LiveStage> pair_stage(const RealPair& pair, int frames, std::uint64_t seed,
                                  const RunContext& context) {
  constexpr int kColumns = 25, kRows = 21;
  const auto seen = stereo::reconstruct_pair({{pair.left, pair.right}, pair.rig, pair.mask, {}}, {},
                                             context.part(0.0, 0.1));
  if (!seen) return std::nullopt;
  const Relief relief(seen->whole->cloud);
  // The tissue goes on beyond what the pair shows: no outline is in the picture.
  Eigen::AlignedBox2d whole = relief.box();
  const Eigen::Vector2d around = 0.6 * whole.sizes();
  whole.extend(Eigen::Vector2d(whole.min() - around));
  whole.extend(Eigen::Vector2d(whole.max() + around));
  const TriangleMesh rest = sheet(relief, whole, 73, 59);
  const Eigen::AlignedBox2d inner = inner_box(seen->whole->cloud);
  LiveStage stage;
  stage.rig = pair.rig;
  stage.model =
      model::build_from_mesh(slab(sheet(relief, whole, kColumns, kRows), kColumns, kRows, 4, 24e-3)).model;
  stage.targets_in_model.resize(4, 3);
  for (int n = 0; n < 4; ++n) {
    const Eigen::Vector2d share(n % 2 == 0 ? 0.3 : 0.7, n < 2 ? 0.3 : 0.7);
    const Eigen::Vector3d top = relief.surface(inner.min() + share.cwiseProduct(inner.sizes()));
    stage.targets_in_model.row(n) = below(top.transpose(), 5e-3 * (n + 1));
  }
  stage.start = stage.model.mesh.vertices;
  const Eigen::Vector3d pressed_at = relief.surface(inner.center());

  insilico::RayCaster caster(rest);
  const MovedView left(pair.left, pair.rig.left, insilico::left_rays(pair.rig), rest);
  const MovedView right(pair.right, pair.rig.right, insilico::right_rays(pair.rig), rest);
  Eigen::Isometry3d to_right = Eigen::Isometry3d::Identity();
  to_right.linear() = pair.rig.right_from_left.rotation;
  to_right.translation() = pair.rig.right_from_left.translation;
  for (int k = 0; k < frames; ++k)
    for (Filmed* filmed : {&stage.standing, &stage.held, &stage.lifted, &stage.cut, &stage.fast}) {
      if (context.cancelled()) return std::nullopt;
      context.progress(0.1 + 0.9 * k / frames, "prove.theatre");
      const double seconds = k / kFrameRate;
      const Handled handled{pressed_at, filmed == &stage.lifted, filmed == &stage.cut};
      const Eigen::Isometry3d scope = filmed == &stage.held ? hand(seconds)
                                      : filmed == &stage.fast
                                          ? fast_hand(seconds)
                                          : Eigen::Isometry3d(Eigen::Isometry3d::Identity());
      caster.move_organ(moved(rest.vertices, handled, seconds, scope));
      const std::uint64_t noise = seed + 4 * static_cast<std::uint64_t>(k) +
                                  (filmed == &stage.held   ? 2
                                   : handled.is_lifted     ? kLiftedNoise
                                   : handled.is_cut        ? kCutNoise
                                   : filmed == &stage.fast ? kFastNoise
                                                           : 0);
      StereoFrame frame;
      frame.left = left.draw(caster, Eigen::Isometry3d::Identity(), noise);
      frame.right = right.draw(caster, to_right, noise + 1);
      frame.index = k;
      frame.seconds = seconds;
      filmed->film.push_back(std::move(frame));
      filmed->targets.push_back(moved(stage.targets_in_model, handled, seconds, scope));
    }
  return stage;
}

}  // namespace glisson::experiments
