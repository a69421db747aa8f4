// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenery.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "glisson/core/statistics.h"
#include "picture_view.h"

namespace glisson::guidance {
namespace {

constexpr int kPoints = 60;  ///< wanted
/// Fewer points, or a smaller share of them, that agree say nothing.
constexpr int kLeast = 12;
constexpr double kLeastShare = 0.6;
constexpr double kAgrees = 1.0;               ///< pixels from where the scene has it
constexpr double kNoise = 0.3;                ///< pixels, of a followed point; more where they scatter more
constexpr double kCertain = 1e-3;             ///< metres at the organ, one deviation in any direction
constexpr double kMostLooks = 90.0;           ///< that count of a place: the scene breathes, too
constexpr double kBesideOrgan = 8e-3;         ///< metres: the model's outline may be off by that
constexpr double kFartherThanOrgan = 1.3;     ///< a first guess of the depth
constexpr double kLeastRoom = 0.02;           ///< of the picture, beside the organ
constexpr double kSoon = 0.5, kSeldom = 4.0;  ///< seconds between two searches

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

Eigen::Matrix3d cross(const Eigen::Vector3d& v) {
  return (Eigen::Matrix3d() << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0).finished();
}

/// A followed point's information in pixels: how far off it is in the picture.
Eigen::Matrix3d in_pixels(const FollowedPoint& point, double focal) {
  const double scale = focal / point.p_in_camera.z();
  return scale * scale * point.information;
}

struct Fit {
  RigidMotion camera_from_scene;
  Matrix6d hessian = Matrix6d::Zero();  ///< of rotation and translation in the camera's frame, per pixel^2
};

/// Gauss-Newton with Geman and McClure's weights, whose scale shrinks from what a fast hand does in a frame
/// to what noise does (graduated non-convexity: Yang et al. 2020), so that no first choice of points decides.
Fit fit_scene(const std::vector<FollowedPoint>& points, const std::vector<Eigen::Vector3d>& places,
              double focal, const RigidMotion& start) {
  Fit fit{start};
  for (const double scale : {32.0, 16.0, 8.0, 4.0, 2.0, 1.0, 0.5, 0.5}) {
    fit.hessian.setZero();
    Vector6d gradient = Vector6d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d there =
          fit.camera_from_scene.rotation * places[i] + fit.camera_from_scene.translation;
      const Eigen::Vector3d gap = points[i].p_in_camera - there;
      const Eigen::Matrix3d information = in_pixels(points[i], focal);
      const double square = scale * scale, weight = square / (square + gap.dot(information * gap));
      Eigen::Matrix<double, 3, 6> moves;
      moves << -cross(there), Eigen::Matrix3d::Identity();
      fit.hessian += weight * weight * moves.transpose() * information * moves;
      gradient += weight * weight * moves.transpose() * information * gap;
    }
    const Vector6d step = fit.hessian.ldlt().solve(gradient);
    if (!step.allFinite()) return {start};
    const Eigen::Matrix3d turn = rotation_by(step.head<3>());
    fit.camera_from_scene.rotation = turn * fit.camera_from_scene.rotation;
    fit.camera_from_scene.translation = turn * fit.camera_from_scene.translation + step.tail<3>();
  }
  return fit;
}

/// Half the size of the left view: 0 where the organ may be, as drawn.
cv::Mat beside(const TriangleMesh& organ, const Camera& camera) {
  cv::Mat room(camera.height / 2, camera.width / 2, CV_8U, cv::Scalar(255));
  double nearest = std::numeric_limits<double>::infinity();
  for (int t = 0; t < organ.triangle_count(); ++t) {
    std::array<cv::Point, 3> corners;
    bool is_before = true;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = organ.vertex(organ.triangles(t, k));
      is_before = is_before && camera.maps(p);
      if (!is_before) break;
      nearest = std::min(nearest, p.z());
      const Eigen::Vector2d pixel = 0.5 * camera.project(p);
      corners[static_cast<std::size_t>(k)] =
          cv::Point(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
    }
    if (is_before) cv::fillConvexPoly(room, corners.data(), 3, cv::Scalar(0));
  }
  if (!std::isfinite(nearest)) return room;
  const int margin = static_cast<int>(0.5 * kBesideOrgan * camera.matrix(0, 0) / std::max(nearest, 0.03));
  cv::erode(room, room, cv::Mat(), cv::Point(-1, -1), margin, cv::BORDER_CONSTANT, cv::Scalar(255));
  return room;
}

}  // namespace

void Scenery::begin() {
  points_.clear();
  places_.clear();
  camera_from_scene_ = {};
}

void Scenery::look(std::size_t index) {
  const FollowedPoint& point = points_[index];
  Place& place = places_[index];
  const RigidMotion scene_from_camera = camera_from_scene_.inverse();
  const Eigen::Matrix3d information =
      scene_from_camera.rotation * point.information * scene_from_camera.rotation.transpose();
  const Eigen::Vector3d seen = scene_from_camera.rotation * point.p_in_camera + scene_from_camera.translation;
  // Information across the ray is 1 a look.
  if (place.information.trace() > 2.0 * kMostLooks) {
    place.information *= 1.0 - 1.0 / kMostLooks;
    place.weighted *= 1.0 - 1.0 / kMostLooks;
  }
  place.information += information;
  place.weighted += information * seen;
  place.at = place.information.ldlt().solve(place.weighted);
}

std::optional<RigidMotion> Scenery::follow(const StereoFollower& follower, const RigidMotion& guess,
                                           const Eigen::Vector3d& organ) {
  const std::vector<std::optional<FollowedPoint>> found = follower.carried(points_);
  std::vector<FollowedPoint> points;
  std::vector<Place> places;
  std::vector<Eigen::Vector3d> at;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    points.push_back(*found[i]);
    places.push_back(places_[i]);
    at.push_back(places_[i].at);
  }
  points_ = std::move(points);
  places_ = std::move(places);
  const RigidMotion before = camera_from_scene_;
  if (points_.size() < kLeast) return std::nullopt;

  const double focal = rig_.left.matrix(0, 0);
  const Fit fit = fit_scene(points_, at, focal, guess.after(before));
  std::vector<char> agrees(points_.size(), 0);
  double squares = 0.0;
  int agreeing = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d gap =
        points_[i].p_in_camera - fit.camera_from_scene.rotation * at[i] - fit.camera_from_scene.translation;
    const double square = gap.dot(in_pixels(points_[i], focal) * gap);
    agrees[i] = square < kAgrees * kAgrees;
    if (agrees[i] == 0) continue;
    ++agreeing;
    squares += square;
  }
  if (agreeing < kLeast || agreeing < kLeastShare * static_cast<double>(points_.size())) return std::nullopt;
  const double noise = std::max(kNoise * kNoise, squares / (2.0 * agreeing));
  Eigen::Matrix<double, 3, 6> moves;
  moves << -cross(organ), Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d covariance =
      noise * moves * fit.hessian.ldlt().solve(Eigen::Matrix<double, 6, 3>(moves.transpose()));
  const double largest = covariance.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
  if (!(largest < kCertain * kCertain)) return std::nullopt;

  camera_from_scene_ = fit.camera_from_scene;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (agrees[i] == 0) continue;
    points_[kept] = points_[i];
    places_[kept] = places_[i];
    look(kept++);
  }
  points_.resize(kept);
  places_.resize(kept);
  return camera_from_scene_.after(before.inverse());
}

void Scenery::replenish(const StereoFollower& follower, const TriangleMesh& organ, const Picture& masked,
                        const FrameClock& clock) {
  if (count() >= 7 * kPoints / 10 || clock.now() < look_at_) return;
  cv::Mat room = beside(organ, rig_.left);
  if (!masked.empty()) {
    cv::Mat half;
    cv::resize(view_of(masked), half, room.size(), 0, 0, cv::INTER_NEAREST);
    room.setTo(0, half);
  }
  const int before = count();
  if (cv::countNonZero(room) > kLeastRoom * static_cast<double>(room.total())) {
    double depth = 0.0;
    if (organ.vertex_count() > 0) {
      std::vector<double> depths(organ.vertices.col(2).begin(), organ.vertices.col(2).end());
      depth = kFartherThanOrgan * upper_median(depths);
    }
    // The wall is as deep as what is known of it nearby.
    const auto expected = [&](const Eigen::Vector2d& pixel) -> std::optional<Eigen::Vector3d> {
      const auto ray = rig_.left.mapped_ray(pixel);
      if (!ray || !(depth > 0.0)) return std::nullopt;
      double z = depth, least = std::numeric_limits<double>::infinity();
      for (int i = 0; i < before; ++i) {
        const FollowedPoint& point = points_[static_cast<std::size_t>(i)];
        const double distance = (point.left - pixel).squaredNorm();
        if (distance < least) {
          least = distance;
          z = point.p_in_camera.z();
        }
      }
      return Eigen::Vector3d(*ray * z);
    };
    for (const FollowedPoint& point : follower.find(expected, kPoints - before, points_, room)) {
      points_.push_back(point);
      places_.emplace_back();
      look(places_.size() - 1);
    }
  }
  wait_ = count() > before + kPoints / 10 ? kSoon : std::min(kSeldom, std::max(kSoon, 2.0 * wait_));
  look_at_ = clock.now() + wait_;
}

}  // namespace glisson::guidance
