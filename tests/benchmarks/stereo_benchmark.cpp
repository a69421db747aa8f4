// SPDX-License-Identifier: GPL-3.0-or-later
// Each step from a stereo pair to its cloud at 960x540 and 1920x1080, beside what a user would run instead:
// OpenCV's SIFT with its own threshold and a brute-force matcher, and its plain semi-global matching of the
// whole picture. One thread. The ratios are what holds on another machine. The pair is a textured sphere, ray
// by ray (tests/stereo/rendered_pair.h), so that nothing but this file is needed.
#include <benchmark/benchmark.h>

#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>

#include "dense.h"
#include "feature_detector.h"
#include "matching.h"
#include "picture_cv.h"
#include "rectification.h"
#include "refine.h"
#include "rendered_pair.h"
#include "surface_fit.h"
#include "whole_pair.h"

namespace {

using namespace glisson;
using namespace glisson::stereo;

constexpr int kFeatures = 3000;

/// A pair with everything that its steps leave to the next.
struct Bench {
  StereoRig rig;
  Picture left, right;
  cv::Mat grey_left, grey_right, usable, float_left, float_right, rectified_left, rectified_right, excluded;
  cv::Mat eight_left, eight_right;  ///< rectified, for semi-global matching
  std::unique_ptr<Rectification> rectification;
  std::vector<Keypoint> in_left, in_right;
  MatchLimits limits;
  std::vector<Match> matches, precise;
  std::unique_ptr<Refiner> refiner;

  explicit Bench(int width) : rig(rendered::rig()) {
    const double scale = width / 640.0;
    for (Camera* camera : {&rig.left, &rig.right}) {
      camera->matrix.topRows<2>() *= scale;
      camera->matrix(1, 2) *= (width * 9.0 / 16.0) / (480.0 * scale);
      camera->width = width;
      camera->height = width * 9 / 16;
    }
    const auto surface = rendered::sphere({0.0, 0.0, 0.17}, 0.08);
    left = rendered::render(rig, true, surface, {}, nullptr);
    right = rendered::render(rig, false, surface, {}, nullptr);
    grey_left = grey(left), grey_right = grey(right);
    usable = cv::Mat(grey_left.size(), CV_8U, cv::Scalar(255));
    rectification = std::make_unique<Rectification>(rig);
    const auto detector = surf_detector();
    in_left = detector->detect(grey_left, usable, kFeatures, 0.0);
    in_right = detector->detect(grey_right, usable, kFeatures, 0.0);
    limits.least_disparity = rectification->disparity_at(0.3);
    limits.largest_disparity = rectification->disparity_at(0.03);
    matches = match(rectify(*rectification, Side::left, in_left, 64),
                    rectify(*rectification, Side::right, in_right, 64), limits);
    float_left = grey_float(left), float_right = grey_float(right);
    rectified_left = rectification->warp(Side::left, float_left);
    rectified_right = rectification->warp(Side::right, float_right);
    rectified_left.convertTo(eight_left, CV_8U);
    rectified_right.convertTo(eight_right, CV_8U);
    excluded = cv::Mat::zeros(grey_left.size(), CV_8U);
    refiner =
        std::make_unique<Refiner>(*rectification, rectified_left, rectified_right, excluded, excluded, 10);
    for (const Match& start : matches)
      if (const auto better = refiner->refine(start, 0.0)) {
        const double d = rectification->disparity(better->left, better->right);
        if (d < limits.least_disparity) continue;
        precise.push_back(*better);
      }
  }
};

const Bench& bench(int width) {
  static std::map<int, std::unique_ptr<Bench>> made;
  auto& one = made[width];
  if (!one) one = std::make_unique<Bench>(width);
  return *one;
}

int width_of(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

void detect(benchmark::State& state, Features kind) {
  const Bench& b = bench(width_of(state));
  const auto detector = feature_detector(kind);
  std::size_t count = 0;
  for ([[maybe_unused]] auto _ : state)
    count = detector->detect(b.grey_left, b.usable, kFeatures, 0.0).size();
  state.counters["features"] = static_cast<double>(count);
}
void detect_surf(benchmark::State& state) { detect(state, Features::surf); }
void detect_sift(benchmark::State& state) { detect(state, Features::sift); }
void detect_akaze(benchmark::State& state) { detect(state, Features::akaze); }
void plain_sift_detect(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  std::vector<cv::KeyPoint> keypoints;
  for ([[maybe_unused]] auto _ : state) {
    cv::Mat descriptors;
    cv::SIFT::create()->detectAndCompute(b.grey_left, cv::noArray(), keypoints, descriptors);
  }
  state.counters["features"] = static_cast<double>(keypoints.size());
}

void match_in_band(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  std::size_t count = 0;
  for ([[maybe_unused]] auto _ : state)
    count = match(rectify(*b.rectification, Side::left, b.in_left, 64),
                  rectify(*b.rectification, Side::right, b.in_right, 64), b.limits)
                .size();
  state.counters["matches"] = static_cast<double>(count);
}
void plain_brute_force_match(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  const auto rows = [](const std::vector<Keypoint>& keypoints) {
    cv::Mat result(static_cast<int>(keypoints.size()), 64, CV_32F);
    for (int i = 0; i < result.rows; ++i)
      std::copy_n(keypoints[static_cast<std::size_t>(i)].descriptor.begin(), 64, result.ptr<float>(i));
    return result;
  };
  const cv::Mat left = rows(b.in_left), right = rows(b.in_right);
  std::vector<cv::DMatch> found;
  for ([[maybe_unused]] auto _ : state) cv::BFMatcher(cv::NORM_L2, true).match(left, right, found);
  state.counters["matches"] = static_cast<double>(found.size());
}

void rectify_pictures(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(b.rectification->warp(Side::left, b.float_left).data);
    benchmark::DoNotOptimize(b.rectification->warp(Side::right, b.float_right).data);
  }
}

void refine_and_triangulate(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  for ([[maybe_unused]] auto _ : state)
    for (const Match& start : b.matches)
      if (const auto better = b.refiner->refine(start, 0.0))
        benchmark::DoNotOptimize(b.rectification->triangulate(
            better->left, better->right.y(), b.rectification->disparity(better->left, better->right)));
  state.counters["points"] = static_cast<double>(b.precise.size());
}
void plain_triangulate(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  const cv::Mat p = cv::Mat::eye(3, 4, CV_64F);
  cv::Mat q = p.clone();
  q.at<double>(0, 3) = -5e-3;
  std::vector<cv::Point2f> left, right;
  for (const Match& m : b.precise) {
    left.emplace_back(static_cast<float>(m.left.x()), static_cast<float>(m.left.y()));
    right.emplace_back(static_cast<float>(m.right.x()), static_cast<float>(m.right.y()));
  }
  cv::Mat found;
  for ([[maybe_unused]] auto _ : state) cv::triangulatePoints(p, q, left, right, found);
}

void surface(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(
        fit_surface(*b.rectification, b.precise, b.refiner->reach(), true).points.data());
}

void semi_global(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  MatchLimits limits = b.limits;  // as reconstruct_whole() narrows them by the features
  limits.least_disparity = b.rectification->disparity_at(0.14);
  limits.largest_disparity = b.rectification->disparity_at(0.08);
  std::size_t count = 0;
  for ([[maybe_unused]] auto _ : state)
    count = dense_matches(*b.rectification, b.eight_left, b.eight_right, b.usable, limits, 8.0).size();
  state.counters["samples"] = static_cast<double>(count);
}
void plain_semi_global(benchmark::State& state) {
  const Bench& b = bench(width_of(state));
  const auto matcher = cv::StereoSGBM::create(0, 128, 5, 200, 800);
  cv::Mat disparities;
  for ([[maybe_unused]] auto _ : state) matcher->compute(b.eight_left, b.eight_right, disparities);
}

void whole(benchmark::State& state, Method method) {
  const Bench& b = bench(width_of(state));
  ReconstructOptions options;
  options.method = method;
  int points = 0;
  for ([[maybe_unused]] auto _ : state)
    points = reconstruct_whole(b.left, b.right, b.rig, {}, options, RunContext())->cloud.size();
  state.counters["points"] = points;
}
void whole_sparse(benchmark::State& state) { whole(state, Method::sparse); }
void whole_dense(benchmark::State& state) { whole(state, Method::dense); }

}  // namespace

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  const std::pair<const char*, void (*)(benchmark::State&)> kSteps[] = {
      {"detect/surf", detect_surf},
      {"detect/sift", detect_sift},
      {"detect/akaze", detect_akaze},
      {"detect/plain_sift", plain_sift_detect},
      {"match/band", match_in_band},
      {"match/plain_brute_force", plain_brute_force_match},
      {"rectify", rectify_pictures},
      {"triangulate/refined", refine_and_triangulate},
      {"triangulate/plain", plain_triangulate},
      {"surface", surface},
      {"dense/sampled", semi_global},
      {"dense/plain", plain_semi_global},
      {"reconstruct/sparse", whole_sparse},
      {"reconstruct/dense", whole_dense}};
  for (const auto& [name, step] : kSteps)
    benchmark::RegisterBenchmark(name, step)->Arg(960)->Arg(1920)->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
