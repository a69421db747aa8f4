// SPDX-License-Identifier: GPL-3.0-or-later
#include <opencv2/imgproc.hpp>

#include "glisson/core/error.h"
#include "glisson/stereo/calibrate.h"
#include "picture_cv.h"

namespace glisson::stereo {
namespace {

/// Told apart by people who do not tell red from green (Okabe and Ito 2008), blue green red.
const cv::Scalar kUsed(178, 114, 0), kOutlier(0, 94, 213), kGround(238, 238, 238), kCovered(214, 200, 170);

void draw_side(cv::Mat& half, const BoardViews& views, const Calibration& calibration, bool left,
               double scale) {
  std::vector<std::vector<cv::Point>> outlines;
  for (const BoardView& view : views.views()) {
    std::vector<cv::Point> points;
    outlines.emplace_back();
    for (const Eigen::Vector2d& p : (left ? view.left : view.right).pixels)
      points.emplace_back(cvRound(p.x() * scale), cvRound(p.y() * scale));
    cv::convexHull(points, outlines.back());
    if (calibration.views[outlines.size() - 1].used) cv::fillConvexPoly(half, outlines.back(), kCovered);
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const ViewReport& report = calibration.views[i];
    const cv::Scalar colour = report.outlier || !report.used ? kOutlier : kUsed;
    cv::polylines(half, outlines[i], true, colour, 1, cv::LINE_AA);
    for (const Eigen::Vector2d& p : (left ? views.views()[i].left : views.views()[i].right).pixels)
      cv::circle(half, cv::Point(cvRound(p.x() * scale), cvRound(p.y() * scale)), 2, colour, cv::FILLED,
                 cv::LINE_AA);
  }
}

}  // namespace

Picture coverage_picture(const BoardViews& views, const Calibration& calibration) {
  require(views.views().size() == calibration.views.size() && views.width() > 0,
          "the coverage is that of the views that were calibrated with");
  const double scale = static_cast<double>(kCoverageWidth) / views.width();
  const int height = cvRound(views.height() * scale);
  cv::Mat image(height, 2 * kCoverageWidth + kCoverageGap, CV_8UC3, cv::Scalar::all(255));
  for (const bool left : {true, false}) {
    cv::Mat half = image.colRange(left ? 0 : kCoverageWidth + kCoverageGap,
                                  left ? kCoverageWidth : 2 * kCoverageWidth + kCoverageGap);
    half.setTo(kGround);
    draw_side(half, views, calibration, left, scale);
  }
  return to_picture(image);
}

}  // namespace glisson::stereo
