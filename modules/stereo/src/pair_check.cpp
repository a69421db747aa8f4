// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "feature_detector.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/stereo/faults.h"
#include "highlights.h"
#include "picture_cv.h"
#include "rectification.h"
#include "size_text.h"
#include "view_state.h"

namespace glisson::stereo {
namespace {

constexpr int kFeatures = 900;
constexpr int kFewestMatches = 20;
constexpr double kWidest = 960.0;       // pixels: no more is needed to tell
constexpr double kLargestRows = 0.006;  // of the width
constexpr double kNear = 0.02, kFar = 0.5;

struct FeaturePair {
  Eigen::Vector2d left, right;  ///< pixels as taken
};

float squared_distance(const Keypoint& a, const Keypoint& b) {
  float sum = 0.0F;
  for (std::size_t k = 0; k < 64; ++k)
    sum += (a.descriptor[k] - b.descriptor[k]) * (a.descriptor[k] - b.descriptor[k]);
  return sum;
}

/// The best of `to` for each of `from`, clearly better than the second; -1: none.
std::vector<int> best_of(const std::vector<Keypoint>& from, const std::vector<Keypoint>& to) {
  constexpr float kRatio = 0.8F * 0.8F;
  std::vector<int> best(from.size(), -1);
  for (std::size_t i = 0; i < from.size(); ++i) {
    float first = HUGE_VALF, second = HUGE_VALF;
    for (std::size_t j = 0; j < to.size(); ++j) {
      if (to[j].bright != from[i].bright) continue;
      const float d = squared_distance(from[i], to[j]);
      if (d < first) {
        if (best[i] < 0 || (to[j].pixel - to[static_cast<std::size_t>(best[i])].pixel).norm() > 4.0)
          second = first;
        first = d;
        best[i] = static_cast<int>(j);
      } else if (d < second && (to[j].pixel - to[static_cast<std::size_t>(best[i])].pixel).norm() > 4.0) {
        second = d;
      }
    }
    if (first > kRatio * second) best[i] = -1;
  }
  return best;
}

/// Matches that one epipolar geometry explains.
std::vector<FeaturePair> unguided_matches(const Picture& left, const Picture& right, double& features) {
  const auto detector = surf_detector();
  const double scale = std::min(1.0, kWidest / left.width);
  const auto detect = [&](const Picture& picture) {
    cv::Mat image, usable;
    cv::resize(grey(picture), image, cv::Size(), scale, scale, cv::INTER_AREA);
    cv::resize(highlights(picture), usable, image.size(), 0.0, 0.0, cv::INTER_NEAREST);
    return detector->detect(image, usable == 0, kFeatures, 0.0);
  };
  const std::vector<Keypoint> in_left = detect(left), in_right = detect(right);
  features = static_cast<double>(std::min(in_left.size(), in_right.size()));
  const std::vector<int> forward = best_of(in_left, in_right), backward = best_of(in_right, in_left);
  std::vector<FeaturePair> matches;
  std::vector<cv::Point2f> a, b;
  for (std::size_t i = 0; i < forward.size(); ++i) {
    if (forward[i] < 0 || backward[static_cast<std::size_t>(forward[i])] != static_cast<int>(i)) continue;
    // A pixel of the small picture covers 1 / scale of the large one.
    const auto enlarged = [&](const Eigen::Vector2d& p) {
      return Eigen::Vector2d(((p.array() + 0.5) / scale - 0.5).matrix());
    };
    matches.push_back(
        {enlarged(in_left[i].pixel), enlarged(in_right[static_cast<std::size_t>(forward[i])].pixel)});
    a.emplace_back(static_cast<float>(matches.back().left.x()), static_cast<float>(matches.back().left.y()));
    b.emplace_back(static_cast<float>(matches.back().right.x()),
                   static_cast<float>(matches.back().right.y()));
  }
  if (matches.size() < kFewestMatches) return {};
  cv::Mat inlier;
  // The tolerance leaves room for distortion: epipolar lines are curves here.
  cv::findFundamentalMat(a, b, cv::FM_RANSAC, 3.0 * std::max(1.0, left.width / 720.0), 0.999, inlier);
  if (inlier.empty()) return {};
  std::vector<FeaturePair> kept;
  for (std::size_t i = 0; i < matches.size(); ++i)
    if (inlier.at<std::uint8_t>(static_cast<int>(i)) != 0) kept.push_back(matches[i]);
  // About an eighth of wrong matches fits any geometry by chance.
  return kept.size() * 3 > matches.size() ? kept : std::vector<FeaturePair>();
}

struct Geometry {
  double rows = 0.0, plausible = 0.0;
};
Geometry geometry_of(const std::vector<FeaturePair>& matches, const Rectification& rectification,
                     bool swapped) {
  std::vector<double> rows;
  double plausible = 0.0;
  for (const FeaturePair& m : matches) {
    const auto l = rectification.rectify(Side::left, swapped ? m.right : m.left);
    const auto r = rectification.rectify(Side::right, swapped ? m.left : m.right);
    if (!l || !r) continue;
    rows.push_back(std::abs(r->y() - l->y()));
    const double d = rectification.disparity(*l, *r);
    plausible += d > rectification.disparity_at(kFar) && d < rectification.disparity_at(kNear);
  }
  if (rows.empty()) return {HUGE_VAL, 0.0};
  return {upper_median(rows), plausible / static_cast<double>(rows.size())};
}

void judge(PairCheck& check, const std::vector<FeaturePair>& matches, const StereoRig& rig) {
  const Rectification rectification(rig);
  const Geometry given = geometry_of(matches, rectification, false);
  const Geometry swapped = geometry_of(matches, rectification, true);
  check.rows_px = given.rows;
  check.plausible = given.plausible;
  const double most = kLargestRows * rig.left.width;
  const bool fits = given.rows <= most && given.plausible >= 0.6;
  const bool fits_swapped = swapped.rows <= most && swapped.plausible >= 0.6;
  if (fits && !(fits_swapped && swapped.rows < 0.5 * given.rows)) return;
  check.faults.push_back(fits_swapped ? Fault::swapped : Fault::other_scope);
}

}  // namespace

const char* fault_code(Fault fault) {
  switch (fault) {
    case Fault::black:
      return "black";
    case Fault::left_lost:
      return "left_lost";
    case Fault::right_lost:
      return "right_lost";
    case Fault::one_view:
      return "one_view";
    case Fault::swapped:
      return "swapped";
    case Fault::unrelated:
      return "unrelated";
    case Fault::other_scope:
      return "other_scope";
    case Fault::duplicated:
      return "duplicated";
    case Fault::frozen:
      return "frozen";
    case Fault::left_frozen:
      return "left_frozen";
    case Fault::right_frozen:
      return "right_frozen";
    case Fault::interlaced:
      return "interlaced";
    case Fault::out_of_order:
      return "out_of_order";
  }
  return "unknown";
}

std::string fault_note(Fault fault) { return std::string("stereo.") + fault_code(fault); }

bool PairCheck::has(Fault fault) const {
  return std::find(faults.begin(), faults.end(), fault) != faults.end();
}

PairCheck check_pair(const Picture& left, const Picture& right, const StereoRig& rig) {
  for (const auto& [picture, camera] : {std::pair(&left, &rig.left), {&right, &rig.right}})
    if (picture->empty() || picture->width != camera->width || picture->height != camera->height)
      throw InputError("stereo pair", "size",
                       "is " + size_text(picture->width, picture->height) + ", the calibration's " +
                           size_text(camera->width, camera->height),
                       "Use the calibration of this laparoscope at this image size");
  PairCheck check;
  check.faults = faults_of_views(thumbnail(left), thumbnail(right));
  if (!check.faults.empty()) return check;
  double features = 0.0;
  const std::vector<FeaturePair> matches = unguided_matches(left, right, features);
  check.matches = static_cast<int>(matches.size());
  if (check.matches >= kFewestMatches)
    judge(check, matches, rig);
  else if (features >= 0.3 * kFeatures)
    check.faults.push_back(Fault::unrelated);
  return check;
}

bool is_rig_of(const StereoRig& rig, const Picture& left) {
  return left.width == rig.left.width && left.height == rig.left.height;
}

void require_rig_of(const StereoRig& rig, const Picture& left) {
  if (is_rig_of(rig, left)) return;
  throw InputError("calibration", "image_width, image_height",
                   "is for pictures of " + size_text(rig.left.width, rig.left.height) +
                       ", the pictures are " + size_text(left.width, left.height),
                   "Use the calibration of this scope at this resolution");
}

void require_one_size(const StereoFrame& frame, const Picture& mask, const std::string& mask_name) {
  const Picture &left = frame.left, &right = frame.right;
  if (left.width != right.width || left.height != right.height)
    throw InputError("stereo pair", "size", "left and right pictures differ in size",
                     "Give two pictures of one moment of one scope");
  if (!mask.empty() && (mask.width != left.width || mask.height != left.height))
    throw InputError(mask_name, "size",
                     "is " + size_text(mask.width, mask.height) + ", the left picture " +
                         size_text(left.width, left.height),
                     "Give the mask of this left picture");
}

void require_sound(const PairCheck& check) {
  const auto refuse = [](const char* problem, const char* remedy) {
    throw InputError("stereo pair", "", problem, remedy);
  };
  for (const Fault fault : check.faults) switch (fault) {
      case Fault::black:
        refuse("is black in both views", "Check the light and the connection, or take another frame");
        break;
      case Fault::left_lost:
        refuse("shows nothing in the left view", "Check the left camera's connection, or take another frame");
        break;
      case Fault::right_lost:
        refuse("shows nothing in the right view",
               "Check the right camera's connection, or take another frame");
        break;
      case Fault::one_view:
        refuse("is the same picture in both views",
               "Give the picture of each camera; one of them may be lost");
        break;
      case Fault::swapped:
        refuse("fits the calibration better when left and right are swapped",
               "Swap the two images, or the calibration's cameras");
        break;
      case Fault::unrelated:
        refuse("shows nothing in common in its two views", "Give both views of one moment");
        break;
      case Fault::other_scope:
        refuse(("matches itself but not the calibration (its points lie " +
                std::to_string(std::lround(check.rows_px)) + " pixels from their epipolar lines, " +
                std::to_string(std::lround(100.0 * check.plausible)) +
                " % of them before the cameras): the calibration is of another laparoscope, or of another "
                "zoom or "
                "focus")
                   .c_str(),
               "Load this laparoscope's calibration, or calibrate it again");
        break;
      default:
        break;
    }
}

}  // namespace glisson::stereo
