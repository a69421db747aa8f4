// SPDX-License-Identifier: GPL-3.0-or-later
#include "scope_motion.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <random>

#include "glisson/core/statistics.h"

namespace glisson::guidance {
namespace {

constexpr double kFloor = 1.5e-3;  ///< metres: what points differ by though they move alike
constexpr double kCauchy = 2.385;  ///< of a deviation: 95 % efficient on normal errors
constexpr int kTriples = 40;       ///< one is of the majority with 99.9 %, where 45 % of the points are not
constexpr int kSteps = 12;
constexpr double kStill = 1e-6;  ///< metres, radians: a step that changes nothing
/// Of the same information, any turn and shift: three points in a line leave one free.
constexpr double kPrior = 1e-6;

class Fit {
 public:
  Fit(const std::vector<FollowedPoint>& points, const std::vector<Eigen::Vector3d>& gaps) : points_(points) {
    modelled_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) modelled_.push_back(points[i].p_in_camera - gaps[i]);
    for (const Eigen::Vector3d& p : modelled_) centre_ += p / static_cast<double>(modelled_.size());
  }

  /// All points alike, triples of them, and no motion at all.
  RigidMotion best_start() const {
    const RigidMotion still{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
    RigidMotion best = still;
    double least = median_of(residuals(still));
    const auto offer = [&](const std::vector<std::size_t>& chosen) {
      const RigidMotion motion = of_all_alike(chosen);
      const double median = median_of(residuals(motion));
      if (median < least) least = median, best = motion;
    };
    std::vector<std::size_t> all(points_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    offer(all);
    std::mt19937 random(1);
    for (int n = 0; n < kTriples && points_.size() >= 3; ++n)
      offer({random() % points_.size(), random() % points_.size(), random() % points_.size()});
    return best;
  }

  RigidMotion refined(RigidMotion motion) const {
    for (int step = 0; step < kSteps; ++step) {
      const std::vector<double> off = residuals(motion);
      const double scale = std::max(kFloor, kCauchy * kDeviationPerMad * median_of(off));
      Normal normal;
      for (std::size_t i = 0; i < points_.size(); ++i)
        add(i, motion, 1.0 / (1.0 + std::pow(off[i] / scale, 2)), normal);
      if (move(normal, motion) < kStill) break;
    }
    return motion;
  }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  struct Normal {
    Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
    Vector6 side = Vector6::Zero();
  };

  Eigen::Vector3d gap(std::size_t i, const RigidMotion& motion) const {
    return points_[i].p_in_camera - (motion.rotation * modelled_[i] + motion.translation);
  }
  std::vector<double> residuals(const RigidMotion& motion) const {
    std::vector<double> off(points_.size());
    for (std::size_t i = 0; i < off.size(); ++i) {
      const Eigen::Vector3d g = gap(i, motion);
      off[i] = std::sqrt(std::max(0.0, g.dot(points_[i].information * g)));
    }
    return off;
  }
  static double median_of(const std::vector<double>& values) {
    return values.empty() ? 0.0 : upper_median(values);
  }
  /// By a few steps without weights of their residuals.
  RigidMotion of_all_alike(const std::vector<std::size_t>& chosen) const {
    constexpr int kFew = 3;
    RigidMotion motion{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
    for (int step = 0; step < kFew; ++step) {
      Normal normal;
      for (const std::size_t i : chosen) add(i, motion, 1.0, normal);
      if (move(normal, motion) < kStill) break;
    }
    return motion;
  }
  /// The point's wish for a small shift and turn about the middle.
  void add(std::size_t i, const RigidMotion& motion, double weight, Normal& normal) const {
    const Eigen::Vector3d arm = motion.rotation * (modelled_[i] - centre_);
    Eigen::Matrix<double, 3, 6> reach;
    reach << Eigen::Matrix3d::Identity(),
        (Eigen::Matrix3d() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0).finished();
    const Eigen::Matrix<double, 6, 3> weighted = weight * reach.transpose() * points_[i].information;
    normal.matrix += weighted * reach;
    normal.side += weighted * gap(i, motion);
  }
  /// @return how far, metres and radians.
  double move(const Normal& normal, RigidMotion& motion) const {
    Vector6 prior;
    prior << Eigen::Vector3d::Constant(kPrior), Eigen::Vector3d::Constant(kPrior * 1e-2);
    const Eigen::Matrix<double, 6, 6> matrix =
        normal.matrix + Eigen::Matrix<double, 6, 6>(prior.asDiagonal());
    const Vector6 change = matrix.ldlt().solve(normal.side);
    const Eigen::Matrix3d turn = rotation_by(change.tail<3>());
    const Eigen::Vector3d middle = motion.rotation * centre_ + motion.translation + change.head<3>();
    motion.rotation = turn * motion.rotation;
    motion.translation = middle - motion.rotation * centre_;
    return change.norm();
  }

  const std::vector<FollowedPoint>& points_;
  std::vector<Eigen::Vector3d> modelled_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
};

}  // namespace

RigidMotion scope_motion(const std::vector<FollowedPoint>& points, const std::vector<Eigen::Vector3d>& gaps) {
  const Fit fit(points, gaps);
  return fit.refined(fit.best_start());
}

}  // namespace glisson::guidance
