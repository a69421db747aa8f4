// SPDX-License-Identifier: GPL-3.0-or-later
#include <dlib/image_keypoint/surf.h>
#include <dlib/opencv/cv_image.h>

#include "feature_detector.h"

namespace glisson::stereo {
namespace {

// What descriptor and weights reach from the centre, in units of the scale.
constexpr double kReach = 18.0;
// Below this the response is the sensor's noise.
constexpr double kLeastResponse = 0.1;
constexpr int kLength = 64;

class SurfDetector : public FeatureDetector {
 public:
  std::vector<Keypoint> detect(const cv::Mat& grey, const cv::Mat& usable, int wanted,
                               double angle) const override {
    dlib::integral_image_generic<long> integral;
    integral.load(dlib::cv_image<unsigned char>(grey));
    dlib::hessian_pyramid pyramid;
    // Steps of one pixel: laparoscopes show soft, small texture that steps of two miss.
    pyramid.build_pyramid(integral, 4, 6, 1);
    std::vector<dlib::interest_point> points;
    dlib::get_interest_points(pyramid, kLeastResponse, points);
    std::vector<Keypoint> found(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      found[i].pixel = {points[i].center.x(), points[i].center.y()};
      found[i].scale = points[i].scale;
      found[i].score = points[i].score;
      found[i].bright = points[i].laplacian < 0.0;
    }
    std::vector<Keypoint> keypoints;
    for (const std::size_t i : spread(found, usable, wanted, kReach)) {
      keypoints.push_back(found[i]);
      dlib::matrix<double, kLength, 1> descriptor;
      dlib::compute_surf_descriptor(integral, points[i].center, points[i].scale, angle, descriptor);
      for (int k = 0; k < kLength; ++k)
        keypoints.back().descriptor[static_cast<std::size_t>(k)] = static_cast<float>(descriptor(k));
    }
    return keypoints;
  }
  int descriptor_length() const override { return kLength; }
};

}  // namespace

std::unique_ptr<FeatureDetector> surf_detector() { return std::make_unique<SurfDetector>(); }

}  // namespace glisson::stereo
