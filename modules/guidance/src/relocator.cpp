// SPDX-License-Identifier: GPL-3.0-or-later
#include "relocator.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "glisson/stereo/faults.h"
#include "picture_view.h"

namespace glisson::guidance {
namespace {

constexpr int kWidth = 640;            ///< pictures are looked at in this width at most
constexpr int kFeatures = 800;         ///< of a picture, the strongest
constexpr float kRatio = 0.8F;         ///< Lowe's
constexpr int kAgreeing = 20;          ///< matches that must agree on a pose
constexpr double kReprojection = 3.0;  ///< pixels of a picture of kWidth
/// Of the matches that agree, the deviation across their narrow direction, as a share of the picture's width:
/// a pose from one corner says nothing of the rest.
constexpr double kLeastSpread = 0.04;
constexpr std::size_t kKeyFrames = 5;

struct Features {
  std::vector<cv::Point2f> pixels;  ///< of the whole picture
  cv::Mat descriptors;              ///< one a row
};

struct KeyFrame {
  int number = 0;                    ///< ascending
  std::vector<ClosestPoint> places;  ///< on the surface's material
  cv::Mat descriptors;
};

KeyFrame rebound(const KeyFrame& key,
                 const std::function<std::optional<ClosestPoint>(const ClosestPoint&)>& rebind) {
  KeyFrame result;
  result.number = key.number;
  for (std::size_t i = 0; i < key.places.size(); ++i) {
    const std::optional<ClosestPoint> now = rebind(key.places[i]);
    if (!now) continue;
    result.places.push_back(*now);
    result.descriptors.push_back(key.descriptors.row(static_cast<int>(i)));
  }
  return result;
}

/// Matches that pass the ratio test: index of the key frame's feature, of the picture's.
std::vector<std::pair<int, int>> match(const cv::Mat& key, const cv::Mat& now) {
  std::vector<std::pair<int, int>> pairs;
  if (key.rows < 2 || now.rows < 2) return pairs;
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_L2).knnMatch(now, key, nearest, 2);
  for (const auto& two : nearest)
    if (two.size() == 2 && two[0].distance < kRatio * two[1].distance)
      pairs.emplace_back(two[0].trainIdx, two[0].queryIdx);
  return pairs;
}

/// Deviation of pixels across the direction in which they vary least.
double narrow_spread(const std::vector<cv::Point2f>& pixels) {
  Eigen::MatrixX2d rows(static_cast<Eigen::Index>(pixels.size()), 2);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) << pixels[i].x, pixels[i].y;
  rows.rowwise() -= rows.colwise().mean().eval();
  const Eigen::Matrix2d covariance = rows.transpose() * rows / static_cast<double>(rows.rows());
  return std::sqrt(std::max(0.0, covariance.selfadjointView<Eigen::Lower>().eigenvalues()[0]));
}

}  // namespace

struct Relocator::Saved {
  std::vector<KeyFrame> keys;
};

struct Relocator::Impl {
  Impl(const StereoRig& given, const Picture& given_mask)
      : rig(given), scale(std::min(1.0, static_cast<double>(kWidth) / given.left.width)) {
    if (!given_mask.empty()) cv::resize(grey_of(given_mask), mask, size(), 0, 0, cv::INTER_NEAREST);
    cv::eigen2cv(Eigen::Matrix3d(rig.left.matrix), matrix);
    cv::eigen2cv(Eigen::MatrixXd(rig.left.distortion), distortion);
  }

  cv::Size size() const {
    return {static_cast<int>(std::lround(scale * rig.left.width)),
            static_cast<int>(std::lround(scale * rig.left.height))};
  }

  Features features(const Picture& left) const {
    Features found;
    if (left.empty() || !stereo::is_rig_of(rig, left)) return found;
    cv::Mat small;
    cv::resize(grey_of(left), small, size(), 0, 0, cv::INTER_AREA);
    std::vector<cv::KeyPoint> points;
    cv::SIFT::create(kFeatures)->detectAndCompute(small, mask, points, found.descriptors);
    const double x = static_cast<double>(rig.left.width) / small.cols;
    const double y = static_cast<double>(rig.left.height) / small.rows;
    for (const cv::KeyPoint& point : points)
      found.pixels.emplace_back(static_cast<float>(x * (point.pt.x + 0.5) - 0.5),
                                static_cast<float>(y * (point.pt.y + 0.5) - 0.5));
    return found;
  }

  /// The pose that most of a key frame's matches agree on. @return how many do; 0: too few.
  int pose(const KeyFrame& key, const Features& now, const registration::MovingSurface& surface,
           RigidMotion& motion) const {
    std::vector<cv::Point3d> places;
    std::vector<cv::Point2f> pixels;
    for (const auto& [of_key, of_now] : match(key.descriptors, now.descriptors)) {
      const Eigen::Vector3d p = surface.place(key.places[static_cast<std::size_t>(of_key)]);
      places.emplace_back(p.x(), p.y(), p.z());
      pixels.push_back(now.pixels[static_cast<std::size_t>(of_now)]);
    }
    if (static_cast<int>(places.size()) < kAgreeing) return 0;
    cv::Mat turn, shift;
    std::vector<int> agreeing;
    if (!cv::solvePnPRansac(places, pixels, matrix, distortion, turn, shift, false, 400,
                            static_cast<float>(kReprojection / scale), 0.999, agreeing, cv::SOLVEPNP_EPNP) ||
        static_cast<int>(agreeing.size()) < kAgreeing)
      return 0;
    std::vector<cv::Point3d> good_places;
    std::vector<cv::Point2f> good_pixels;
    for (const int k : agreeing) {
      good_places.push_back(places[static_cast<std::size_t>(k)]);
      good_pixels.push_back(pixels[static_cast<std::size_t>(k)]);
    }
    if (narrow_spread(good_pixels) < kLeastSpread * rig.left.width) return 0;
    cv::solvePnPRefineLM(good_places, good_pixels, matrix, distortion, turn, shift);
    cv::Mat rotation;
    cv::Rodrigues(turn, rotation);
    cv::cv2eigen(rotation, motion.rotation);
    cv::cv2eigen(shift, motion.translation);
    return static_cast<int>(agreeing.size());
  }

  KeyFrame key_frame(const Picture& left, const registration::MovingSurface& surface) const {
    const Features found = features(left);
    KeyFrame key;
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
      const auto ray = rig.left.mapped_ray({found.pixels[i].x, found.pixels[i].y});
      if (!ray) continue;
      const ClosestPoint hit =
          surface.first_hit(Eigen::Vector3d::Zero(), *ray, 0.0, std::numeric_limits<double>::infinity());
      if (hit.triangle < 0) continue;
      key.places.push_back(hit);
      key.descriptors.push_back(found.descriptors.row(static_cast<int>(i)));
    }
    return key;
  }

  /// Takes the key frame that is being made, once it is.
  void take_pending() {
    if (!pending.valid()) return;
    if (keys.size() == kKeyFrames) keys.erase(keys.begin() + 1);
    keys.push_back(pending.get());
    keys.back().number = made++;
  }

  StereoRig rig;
  double scale;
  cv::Mat mask, matrix, distortion;
  std::vector<KeyFrame> keys;
  int made = 0;
  std::future<KeyFrame> pending;  ///< last: it reads the others
};

Relocator::Relocator(const StereoRig& rig, const Picture& mask) : impl_(std::make_unique<Impl>(rig, mask)) {}
Relocator::~Relocator() = default;

void Relocator::remember(const Picture& left, const registration::MovingSurface& surface) {
  impl_->take_pending();
  impl_->pending = std::async(std::launch::async,
                              [impl = impl_.get(), left, surface] { return impl->key_frame(left, surface); });
}

void Relocator::rebind(const std::function<std::optional<ClosestPoint>(const ClosestPoint&)>& rebind) {
  impl_->take_pending();
  for (KeyFrame& key : impl_->keys) key = rebound(key, rebind);
}

std::shared_ptr<const Relocator::Saved> Relocator::save() {
  impl_->take_pending();
  return std::make_shared<const Saved>(Saved{impl_->keys});
}

void Relocator::restore(const Saved& saved,
                        const std::function<std::optional<ClosestPoint>(const ClosestPoint&)>& rebind) {
  impl_->take_pending();
  for (KeyFrame& key : impl_->keys) {
    const auto same = std::find_if(saved.keys.begin(), saved.keys.end(),
                                   [&](const KeyFrame& one) { return one.number == key.number; });
    key = same == saved.keys.end() ? rebound(key, rebind) : *same;
  }
}

std::optional<RigidMotion> Relocator::find(const Picture& left, const registration::MovingSurface& surface) {
  impl_->take_pending();
  const Features now = impl_->features(left);
  std::optional<RigidMotion> best;
  int most = 0;
  for (const KeyFrame& key : impl_->keys) {
    RigidMotion motion{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
    const int agreeing = impl_->pose(key, now, surface, motion);
    if (agreeing > most) most = agreeing, best = motion;
  }
  return best;
}

}  // namespace glisson::guidance
