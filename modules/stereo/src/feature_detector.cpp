// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_detector.h"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <tuple>

namespace glisson::stereo {
namespace {

constexpr int kCell = 24;  // pixels

/// What OpenCV has: it detects, we choose, it describes.
class OpenCvDetector : public FeatureDetector {
 public:
  /// @param reach see spread(). @param radius of a keypoint's blob per its `size`.
  OpenCvDetector(cv::Ptr<cv::Feature2D> features, int length, double reach, double radius)
      : features_(std::move(features)), length_(length), reach_(reach), radius_(radius) {}

  std::vector<Keypoint> detect(const cv::Mat& grey, const cv::Mat& usable, int wanted,
                               double angle) const override {
    std::vector<cv::KeyPoint> found;
    features_->detect(grey, found);
    drop_repeated(found);
    std::vector<Keypoint> keypoints(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      keypoints[i].pixel = {found[i].pt.x, found[i].pt.y};
      keypoints[i].scale = radius_ * found[i].size;
      keypoints[i].score = found[i].response;
    }
    std::vector<cv::KeyPoint> chosen;
    for (const std::size_t i : spread(keypoints, usable, wanted, reach_)) {
      chosen.push_back(found[i]);
      chosen.back().angle = static_cast<float>(std::fmod(angle * 180.0 / M_PI + 360.0, 360.0));
      chosen.back().class_id = found[i].class_id;
    }
    if (chosen.empty()) return {};
    cv::Mat descriptors;
    features_->compute(grey, chosen, descriptors);  // drops what it cannot describe
    return described(chosen, descriptors);
  }
  int descriptor_length() const override { return length_; }

 private:
  /// A blob of several directions comes several times; upright it is one.
  static void drop_repeated(std::vector<cv::KeyPoint>& found) {
    const auto key = [](const cv::KeyPoint& p) { return std::make_tuple(p.pt.y, p.pt.x, p.size, p.octave); };
    std::stable_sort(found.begin(), found.end(),
                     [&](const cv::KeyPoint& a, const cv::KeyPoint& b) { return key(a) < key(b); });
    found.erase(std::unique(found.begin(), found.end(),
                            [&](const cv::KeyPoint& a, const cv::KeyPoint& b) { return key(a) == key(b); }),
                found.end());
  }

  std::vector<Keypoint> described(const std::vector<cv::KeyPoint>& chosen, const cv::Mat& descriptors) const {
    std::vector<Keypoint> keypoints(chosen.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      Keypoint& k = keypoints[i];
      k.pixel = {chosen[i].pt.x, chosen[i].pt.y};
      k.scale = radius_ * chosen[i].size;
      k.score = chosen[i].response;
      const float* values = descriptors.ptr<float>(static_cast<int>(i));
      for (int c = 0; c < std::min(length_, descriptors.cols); ++c)
        k.descriptor[static_cast<std::size_t>(c)] = values[c];
    }
    return keypoints;
  }

  cv::Ptr<cv::Feature2D> features_;
  int length_;
  double reach_, radius_;
};

}  // namespace

std::vector<std::size_t> spread(const std::vector<Keypoint>& keypoints, const cv::Mat& usable, int wanted,
                                double reach) {
  std::vector<std::size_t> order(keypoints.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t i) {
    const Keypoint& k = keypoints[i];
    return std::make_tuple(-k.score, k.pixel.y(), k.pixel.x(), k.scale);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  const int columns = usable.cols / kCell + 1;
  std::vector<int> taken(
      static_cast<std::size_t>(columns) * static_cast<std::size_t>(usable.rows / kCell + 1), 0);
  std::vector<std::tuple<int, std::size_t, std::size_t>> ranks;  // within its cell, then by strength
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Keypoint& k = keypoints[order[n]];
    const int x = static_cast<int>(std::lround(k.pixel.x())), y = static_cast<int>(std::lround(k.pixel.y()));
    const int margin = static_cast<int>(reach * k.scale) + 2;
    if (x < margin || y < margin || x >= usable.cols - margin || y >= usable.rows - margin) continue;
    if (usable.at<std::uint8_t>(y, x) == 0) continue;
    ranks.emplace_back(taken[static_cast<std::size_t>(y / kCell * columns + x / kCell)]++, n, order[n]);
  }
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::size_t> kept;
  for (std::size_t n = 0; n < ranks.size() && static_cast<int>(n) < wanted; ++n)
    kept.push_back(std::get<2>(ranks[n]));
  return kept;
}

std::unique_ptr<FeatureDetector> feature_detector(Features kind) {
  // Thresholds far below the libraries' own: tissue is soft, and the strongest are chosen afterwards.
  constexpr double kSiftContrast = 0.004, kSiftEdge = 12.0, kAkazeResponse = 3e-5;
  constexpr double kSiftReach = 6.0, kAkazeReach = 5.0;
  switch (kind) {
    case Features::surf:
      break;
    case Features::sift:
      return std::make_unique<OpenCvDetector>(cv::SIFT::create(0, 3, kSiftContrast, kSiftEdge, 1.6), 128,
                                              kSiftReach, 0.5);
    case Features::akaze:
      return std::make_unique<OpenCvDetector>(
          cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_KAZE_UPRIGHT, 0, 3, static_cast<float>(kAkazeResponse), 4,
                            4, cv::KAZE::DIFF_PM_G2),
          64, kAkazeReach, 0.5);
  }
  return surf_detector();
}

}  // namespace glisson::stereo
