// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/calibrate.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "camera_cv.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "rectification.h"
#include "rig_check.h"

namespace glisson::stereo {
namespace {

constexpr int kFewestViews = 3;
constexpr int kFewestToLeaveOut = 5;
constexpr double kLargestFocalSigma = 0.03;  // of the focal length: more, and depth is a guess
const double kUnknown = std::nan("");

/// The views in OpenCV's form.
struct BoardPoints {
  std::vector<std::vector<cv::Point3f>> board;  ///< metres
  std::vector<std::vector<cv::Point2f>> left, right;
  cv::Size size;

  void add(const Board& pattern, const BoardView& view) {
    const auto pixels = [](const BoardCorners& corners) {
      std::vector<cv::Point2f> result;
      for (const Eigen::Vector2d& p : corners.pixels)
        result.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
      return result;
    };
    board.emplace_back();
    for (const int id : view.left.ids) {
      const Eigen::Vector3d p = pattern.corner(id);
      board.back().emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
    }
    left.push_back(pixels(view.left));
    right.push_back(pixels(view.right));
  }
};

BoardPoints points_of(const BoardViews& views, const std::vector<bool>& used) {
  BoardPoints points;
  points.size = {views.width(), views.height()};
  for (std::size_t i = 0; i < views.views().size(); ++i)
    if (used[i]) points.add(views.board(), views.views()[i]);
  return points;
}

/// One camera by Zhang's method.
struct Single {
  cv::Mat matrix, distortion;
  double rms = 0.0, focal_sigma = 0.0;
};

int flags_of(const CalibrateOptions& options) { return options.third_radial ? 0 : cv::CALIB_FIX_K3; }

Single calibrate_one(const BoardPoints& points, bool left, const CalibrateOptions& options) {
  Single single;
  cv::Mat rotations, translations, intrinsic, extrinsic, per_view;
  single.rms = cv::calibrateCamera(points.board, left ? points.left : points.right, points.size,
                                   single.matrix, single.distortion, rotations, translations, intrinsic,
                                   extrinsic, per_view, flags_of(options));
  single.focal_sigma = intrinsic.at<double>(0);
  return single;
}

/// Both cameras with their pose.
struct Joint {
  cv::Mat left, left_distortion, right, right_distortion, rotation, translation;
  cv::Mat per_view;  ///< rms of each view, left and right
  double rms = 0.0;

  StereoRig rig(const cv::Size& size) const {
    StereoRig result;
    result.left = to_camera(left, left_distortion, size.width, size.height);
    result.right = to_camera(right, right_distortion, size.width, size.height);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) result.right_from_left.rotation(r, c) = rotation.at<double>(r, c);
      result.right_from_left.translation[r] = translation.at<double>(r);
    }
    return result;
  }
};

/// Everything at once, from intrinsics that are close.
Joint refine(const Joint& start, const BoardPoints& points, const CalibrateOptions& options) {
  constexpr int kIterations = 100;
  constexpr double kChange = 1e-8;
  Joint joint;
  joint.left = start.left.clone();
  joint.left_distortion = start.left_distortion.clone();
  joint.right = start.right.clone();
  joint.right_distortion = start.right_distortion.clone();
  cv::Mat essential, fundamental;
  joint.rms = cv::stereoCalibrate(
      points.board, points.left, points.right, joint.left, joint.left_distortion, joint.right,
      joint.right_distortion, points.size, joint.rotation, joint.translation, essential, fundamental,
      joint.per_view, flags_of(options) | cv::CALIB_USE_INTRINSIC_GUESS,
      cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, kIterations, kChange));
  return joint;
}

/// rms of what is known.
class Mean {
 public:
  void add(double value, double weight) {
    if (std::isfinite(value)) sum_ += weight * value * value, weight_ += weight;
  }
  double rms() const { return weight_ > 0.0 ? std::sqrt(sum_ / weight_) : kUnknown; }

 private:
  double sum_ = 0.0, weight_ = 0.0;
};

/// Proposes for removal the views that fit far worse than the others. A few tenths of a pixel never count:
/// that is the corners' noise.
void propose(std::vector<ViewReport>& views) {
  constexpr double kDeviations = 5.0, kNoise = 0.2;
  std::vector<double> errors;
  for (const ViewReport& view : views)
    if (view.used) errors.push_back(std::hypot(view.left_rms, view.right_rms) / std::sqrt(2.0));
  if (static_cast<int>(errors.size()) < kFewestToLeaveOut) return;
  const double middle = upper_median(errors);
  const double scatter = median_absolute_deviation(errors, middle);
  const double most = middle + std::max(kNoise, kDeviations * kDeviationPerMad * scatter);
  for (ViewReport& view : views)
    if (view.used)
      view.outlier =
          std::hypot(view.left_rms, view.right_rms) / std::sqrt(2.0) > std::max(most, 1.5 * middle);
}

/// Where the board is in the left camera's frame.
struct BoardPose {
  cv::Mat turn, translation;  ///< Rodrigues vector; metres
};
/// @return empty: no pose fits.
std::optional<BoardPose> pose_of(const BoardPoints& view, const Camera& camera) {
  BoardPose pose;
  if (!cv::solvePnP(view.board[0], view.left[0], to_cv(camera.matrix), to_cv(camera.distortion.transpose()),
                    pose.turn, pose.translation))
    return std::nullopt;
  return pose;
}

/// @return whether there was one.
bool drop_outliers(std::vector<ViewReport>& views) {
  bool dropped = false;
  for (ViewReport& view : views)
    if (view.used && view.outlier) view.used = false, dropped = true;
  return dropped;
}

/// @return the board's normal, towards the camera; zero where it has no pose.
Eigen::Vector3d report_pose(ViewReport& report, const Board& board, const BoardView& view,
                            const Camera& camera) {
  BoardPoints points;
  points.add(board, view);
  const auto pose = pose_of(points, camera);
  if (!pose) return Eigen::Vector3d::Zero();
  cv::Mat rotation;
  cv::Rodrigues(pose->turn, rotation);
  Eigen::Matrix3d r;
  for (int i = 0; i < 9; ++i) r(i / 3, i % 3) = rotation.at<double>(i / 3, i % 3);
  const Eigen::Vector3d t(pose->translation.at<double>(0), pose->translation.at<double>(1),
                          pose->translation.at<double>(2));
  const Eigen::Vector3d middle =
      r * Eigen::Vector3d(0.5 * (board.columns - 1), 0.5 * (board.rows - 1), 0.0) * board.square + t;
  report.distance = middle.norm();
  report.tilt = std::acos(std::min(1.0, std::abs(r.col(2).dot(middle.normalized()))));
  return r.col(2).dot(middle) > 0.0 ? Eigen::Vector3d(-r.col(2)) : Eigen::Vector3d(r.col(2));
}

/// rms of a view's corners in both pictures by a calibration that may not have used it. The board's pose is
/// found in the left picture alone.
double view_rms(const Board& board, const BoardView& view, const StereoRig& rig) {
  BoardPoints points;
  points.add(board, view);
  const auto pose = pose_of(points, rig.left);
  if (!pose) return kUnknown;
  cv::Mat turn, translation, turn_between;
  cv::Rodrigues(to_cv(rig.right_from_left.rotation), turn_between);
  const cv::Mat between = to_cv(rig.right_from_left.translation);
  cv::composeRT(pose->turn, pose->translation, turn_between, between, turn, translation);
  Mean errors;
  const auto add = [&](const cv::Mat& t, const cv::Mat& x, const Camera& camera,
                       const std::vector<cv::Point2f>& seen) {
    std::vector<cv::Point2f> expected;
    cv::projectPoints(points.board[0], t, x, to_cv(camera.matrix), to_cv(camera.distortion.transpose()),
                      expected);
    for (std::size_t i = 0; i < seen.size(); ++i) errors.add(cv::norm(expected[i] - seen[i]), 1.0);
  };
  add(pose->turn, pose->translation, rig.left, points.left[0]);
  add(turn, translation, rig.right, points.right[0]);
  return errors.rms();
}

/// Fills in where each board was. @return the normals of those in use.
std::vector<Eigen::Vector3d> report_poses(Calibration& result, const BoardViews& views) {
  std::vector<Eigen::Vector3d> normals;
  for (std::size_t i = 0; i < result.views.size(); ++i) {
    const Eigen::Vector3d normal =
        report_pose(result.views[i], views.board(), views.views()[i], result.rig.left);
    if (result.views[i].used && normal.norm() > 0.5) normals.push_back(normal);
  }
  return normals;
}

/// Largest angle between the boards of two views, radians: parallel boards leave the focal length open.
double slant(const std::vector<Eigen::Vector3d>& normals) {
  double least = 1.0;
  for (const Eigen::Vector3d& a : normals)
    for (const Eigen::Vector3d& b : normals) least = std::min(least, a.dot(b));
  return std::acos(std::max(-1.0, least));
}

/// What a file of these cameras would be refused for. Empty: nothing.
std::optional<InputError> no_lens(const StereoRig& rig) {
  const auto check = [](const char* name, const Camera& camera) {
    check_camera("board", name, camera);
    check_distortion("board", name, camera);
  };
  try {
    check("left camera", rig.left);
    check("right camera", rig.right);
    return std::nullopt;
  } catch (const InputError& failure) {
    return InputError(failure.file(), failure.field(), failure.problem(),
                      "Take more views, with the board at the edges of the picture, too");
  }
}

/// What is wrong with the cameras that were found. Empty: nothing.
std::optional<InputError> complaint_about(const Calibration& result,
                                          const std::vector<Eigen::Vector3d>& normals, double square) {
  const double focal = result.rig.left.matrix(0, 0);
  constexpr double kLeastSlant = 0.17;  // 10 degrees
  if (!(result.focal_sigma < kLargestFocalSigma * focal) || slant(normals) < kLeastSlant)
    return InputError("board", "views",
                      "leave the focal length open (" + number_text(focal) + " px, give or take " +
                          number_text(result.focal_sigma) + "): all " + std::to_string(normals.size()) +
                          " show the board at nearly one slant",
                      "Tilt the board by 20 to 40 degrees, each time another way");
  const double x = right_in_left(result.rig).x();
  if (x < 0.0)
    return InputError("left and right pictures", "",
                      "are swapped: the right camera would lie " + number_text(-1e3 * x) +
                          " mm to the left of the left one",
                      "Give the left camera's pictures as the left ones");
  const double baseline = result.rig.baseline();
  if (baseline < kSmallestBaseline || baseline > kLargestBaseline)
    return InputError("board", "square",
                      "of " + number_text(1e3 * square) + " mm gives a baseline of " +
                          number_text(1e3 * baseline) + " mm, where a stereo laparoscope has 1 to 30 mm",
                      "Measure the side of a square");
  return no_lens(result.rig);
}

/// Share of the picture that lies within a board's outline in any view.
double coverage(const BoardViews& views, const std::vector<ViewReport>& reports, bool left) {
  constexpr double kScale = 0.125;
  cv::Mat covered = cv::Mat::zeros(static_cast<int>(views.height() * kScale) + 1,
                                   static_cast<int>(views.width() * kScale) + 1, CV_8U);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (!reports[i].used) continue;
    std::vector<cv::Point> points, outline;
    for (const Eigen::Vector2d& p : (left ? views.views()[i].left : views.views()[i].right).pixels)
      points.emplace_back(static_cast<int>(p.x() * kScale), static_cast<int>(p.y() * kScale));
    cv::convexHull(points, outline);
    cv::fillConvexPoly(covered, outline, cv::Scalar(255));
  }
  return static_cast<double>(cv::countNonZero(covered)) / static_cast<double>(covered.total());
}

/// What a calibration without one view says. NaN: not known.
struct Without {
  double rest = kUnknown;  ///< joint rms of the other views, pixels
  double view = kUnknown;  ///< rms of the view that it has not seen
};

/// Judges every view by a calibration that has not seen it. @return one for each view; empty: cancelled.
std::optional<std::vector<Without>> leave_each_out(const BoardViews& views, const CalibrateOptions& options,
                                                   const Joint& joint, Calibration& result,
                                                   const RunContext& context) {
  std::vector<bool> used;
  for (ViewReport& view : result.views) {
    used.push_back(view.used);
    view.epipolar_left_out = kUnknown;
  }
  std::vector<Without> without(used.size());
  if (std::count(used.begin(), used.end(), true) < kFewestToLeaveOut) return without;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(i) / static_cast<double>(used.size()), "calibrate.leave_out");
    const BoardView& view = views.views()[i];
    if (!used[i]) {  // was not seen by the calibration as it is
      result.views[i].epipolar_left_out = epipolar_rms(result.rig, view);
      continue;
    }
    std::vector<bool> others = used;
    others[i] = false;
    try {
      const BoardPoints points = points_of(views, others);
      const Joint left = refine(joint, points, options);
      const StereoRig rig = left.rig(points.size);
      result.views[i].epipolar_left_out = epipolar_rms(rig, view);
      without[i] = {left.rms, view_rms(views.board(), view, rig)};
    } catch (const cv::Exception&) {  // the others alone determine no cameras
    }
  }
  return without;
}

/// Proposes for removal the view without which all others fit far better and which itself then fits far worse
/// than they. Its own rms would not show it: among few views a wrong one bends the cameras until its error is
/// spread over all.
void propose_by_others(std::vector<ViewReport>& views, const std::vector<Without>& without) {
  constexpr double kBetter = 0.75, kWorse = 3.0, kNoise = 0.2;
  std::vector<double> rests;
  std::size_t best = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (!std::isfinite(without[i].rest)) continue;
    if (rests.empty() || without[i].rest < without[best].rest) best = i;
    rests.push_back(without[i].rest);
  }
  if (rests.empty()) return;
  const Without& one = without[best];
  if (one.rest < kBetter * upper_median(rests) && one.view > std::max(kWorse * one.rest, one.rest + kNoise))
    views[best].outlier = true;
}

void summarise_epipolar(const BoardViews& views, const CalibrateOptions& options, Calibration& result) {
  Mean all, left_out, reference;
  for (std::size_t i = 0; i < result.views.size(); ++i) {
    ViewReport& report = result.views[i];
    if (options.reference) report.epipolar_reference = epipolar_rms(*options.reference, views.views()[i]);
    if (!report.used) continue;
    const double weight = views.views()[i].left.size();
    all.add(epipolar_rms(result.rig, views.views()[i]), weight);
    left_out.add(report.epipolar_left_out, weight);
    reference.add(report.epipolar_reference, weight);
  }
  result.epipolar_rms = all.rms();
  result.epipolar_left_out = left_out.rms();
  result.epipolar_reference = reference.rms();
}

/// Calibrates with the views in use; fills all but what is left out. @return empty: cancelled.
std::optional<Joint> calibrate_used(const BoardViews& views, const CalibrateOptions& options,
                                    Calibration& result, const RunContext& context) {
  std::vector<bool> used;
  for (const ViewReport& view : result.views) used.push_back(view.used);
  const BoardPoints points = points_of(views, used);
  context.progress(0.0, "calibrate.cameras");
  const Single left = calibrate_one(points, true, options);
  if (context.cancelled()) return std::nullopt;
  const Single right = calibrate_one(points, false, options);
  if (context.cancelled()) return std::nullopt;
  context.progress(0.5, "calibrate.joint");
  Joint start;
  start.left = left.matrix, start.left_distortion = left.distortion;
  start.right = right.matrix, start.right_distortion = right.distortion;
  Joint joint = refine(start, points, options);
  result.rig = joint.rig(points.size);
  result.rms = joint.rms;
  result.left_alone = left.rms;
  result.right_alone = right.rms;
  result.focal_sigma = left.focal_sigma;
  Mean in_left, in_right;
  for (std::size_t i = 0, row = 0; i < result.views.size(); ++i) {
    if (!result.views[i].used) continue;
    result.views[i].left_rms = joint.per_view.at<double>(static_cast<int>(row), 0);
    result.views[i].right_rms = joint.per_view.at<double>(static_cast<int>(row++), 1);
    const double weight = views.views()[i].left.size();
    in_left.add(result.views[i].left_rms, weight);
    in_right.add(result.views[i].right_rms, weight);
  }
  result.left_rms = in_left.rms();
  result.right_rms = in_right.rms();
  return joint;
}

}  // namespace

void CalibrateOptions::validate() const {
  for (const std::string& name : without)
    if (name.empty())
      throw InputError("calibration options", "without", "holds a view without a name",
                       "Name views as the report does");
  if (!reference) return;
  try {
    check_camera("reference", "left camera", reference->left);
    check_camera("reference", "right camera", reference->right);
    (void)checked_rotation("reference", "R", reference->right_from_left.rotation);
    check_rig("reference", *reference);
  } catch (const InputError& failure) {
    throw InputError("calibration options, " + failure.field(), "reference", failure.problem(),
                     failure.remedy());
  }
}

double epipolar_rms(const StereoRig& rig, const BoardView& view) {
  const Rectification rectification(rig);
  Mean rows;
  for (std::size_t i = 0; i < view.left.pixels.size(); ++i) {
    const auto left = rectification.rectify(Side::left, view.left.pixels[i]);
    const auto right = rectification.rectify(Side::right, view.right.pixels[i]);
    if (left && right) rows.add(right->y() - left->y(), 1.0);
  }
  return rows.rms();
}

Cancellable<Calibration> calibrate(const BoardViews& views, const CalibrateOptions& options,
                                   const RunContext& context) {
  options.validate();
  views.require(kFewestViews);
  Calibration result;
  for (const BoardView& view : views.views()) {
    result.views.emplace_back();
    result.views.back().name = view.name;
    result.views.back().epipolar_left_out = result.views.back().epipolar_reference = kUnknown;
    if (std::find(options.without.begin(), options.without.end(), view.name) == options.without.end())
      continue;
    result.views.back().used = false;
    result.views.back().left_rms = result.views.back().right_rms = kUnknown;
  }
  const auto left =
      std::count_if(result.views.begin(), result.views.end(), [](const auto& v) { return v.used; });
  if (left < kFewestViews)
    throw InputError("board", "views", "are " + std::to_string(left) + " without those left out",
                     "Keep " + std::to_string(kFewestViews) + " or more");
  try {
    constexpr int kMostPasses = 4;
    for (int pass = 0; pass < kMostPasses; ++pass) {
      const bool may_drop = options.drop_outliers && pass + 1 < kMostPasses;
      // Another pass may follow: half of what is left of the progress.
      const double begun = 1.0 - std::pow(0.5, pass), end = may_drop ? 1.0 - std::pow(0.5, pass + 1) : 1.0;
      const RunContext own = options.drop_outliers ? context.part(begun, end) : context;
      const auto joint = calibrate_used(views, options, result, own.part(0.0, 0.4));
      if (!joint) return std::nullopt;
      propose(result.views);
      if (options.leave_one_out) {
        const auto without = leave_each_out(views, options, *joint, result, own.part(0.4, 1.0));
        if (!without) return std::nullopt;
        propose_by_others(result.views, *without);
      }
      const bool dropped = may_drop && drop_outliers(result.views);
      if (!dropped) break;
    }
    if (const auto complaint = complaint_about(result, report_poses(result, views), views.board().square)) {
      for (const ViewReport& view : result.views)
        if (view.used && view.outlier)
          throw InputError(
              "board",
              view.name + ", " + (complaint->field().empty() ? complaint->file() : complaint->field()),
              complaint->problem(), "Leave that pair out: it does not fit the others");
      throw InputError(*complaint);
    }
  } catch (const cv::Exception& failure) {
    throw NumericalError("The views of the board do not determine the cameras (" + failure.err +
                         "). Take more views, tilted each time another way.");
  }
  summarise_epipolar(views, options, result);
  result.left_coverage = coverage(views, result.views, true);
  result.right_coverage = coverage(views, result.views, false);
  context.progress(1.0, "calibrate.done");
  return result;
}

Figures calibration_figures(const Calibration& calibration) {
  Figures figures;
  figures["calibration_views"] = static_cast<double>(calibration.views.size());
  figures["calibration_outliers"] = static_cast<double>(std::count_if(
      calibration.views.begin(), calibration.views.end(), [](const auto& view) { return view.outlier; }));
  figures["calibration_rms_px"] = calibration.rms;
  figures["calibration_rms_left_px"] = calibration.left_rms;
  figures["calibration_rms_right_px"] = calibration.right_rms;
  figures["calibration_focal_sigma_px"] = calibration.focal_sigma;
  figures["calibration_baseline_mm"] = 1e3 * calibration.rig.baseline();
  figures["calibration_coverage_left"] = calibration.left_coverage;
  figures["calibration_coverage_right"] = calibration.right_coverage;
  figures["calibration_epipolar_px"] = calibration.epipolar_rms;
  figures["calibration_epipolar_left_out_px"] = calibration.epipolar_left_out;
  figures["calibration_epipolar_reference_px"] = calibration.epipolar_reference;
  return figures;
}

}  // namespace glisson::stereo
