// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_faults.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <random>

#include "cv_picture.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/stereo/png.h"

namespace glisson::experiments {
namespace {

constexpr double kBarDepth = 0.06, kDrapeDepth = 0.08;  ///< metres before the camera
constexpr double kDrapeSpeed = 2.0;                     ///< pixels a frame
constexpr double kToolDepth = 0.08;                     ///< metres before the camera

template <class Change>
StereoFrame both(const StereoFrame& frame, const Change& change) {
  StereoFrame changed = frame;
  cv::Mat left = view_of(frame.left).clone(), right = view_of(frame.right).clone();
  change(left, false);
  change(right, true);
  changed.left = picture_of(left);
  changed.right = picture_of(right);
  return changed;
}

/// The moment of `from`, at the time of `at`.
StereoFrame shown_at(const StereoFrame& from, const StereoFrame& at) {
  StereoFrame frame = from;
  frame.index = at.index;
  frame.seconds = at.seconds;
  return frame;
}

/// Something flat, `share` of the picture wide, at a depth: in either picture at its place.
class Curtain {
 public:
  Curtain(const StereoRig& rig, double share, double depth, double speed, bool textured, std::uint64_t seed)
      : width_(static_cast<int>(share * rig.left.width)),
        disparity_(static_cast<int>(rig.left.matrix(0, 0) * rig.baseline() / depth)),
        speed_(speed),
        cloth_(rig.left.height, 2 * rig.left.width, CV_8UC3) {
    cv::RNG random(seed);
    random.fill(cloth_, cv::RNG::UNIFORM, textured ? 0 : 90, textured ? 255 : 110);
    cv::GaussianBlur(cloth_, cloth_, cv::Size(), textured ? 3.0 : 8.0);
    if (textured) cv::normalize(cloth_, cloth_, 30, 220, cv::NORM_MINMAX);
  }
  void hang(cv::Mat& picture, bool is_right, int frame) const {
    const int left = picture.cols - width_ - (is_right ? disparity_ : 0);
    const cv::Rect place =
        cv::Rect(left, 0, width_, picture.rows) & cv::Rect(0, 0, picture.cols, picture.rows);
    const int slide = static_cast<int>(speed_ * frame) % picture.cols;
    cloth_(cv::Rect(slide, 0, place.width, place.height)).copyTo(picture(place));
  }

 private:
  int width_, disparity_;
  double speed_;
  cv::Mat cloth_;
};

/// A lens wets, `share` of the way: droplets spread its light, most of it over a good part of the picture.
/// What the sensor adds stays.
void fog(cv::Mat& picture, double share, std::uint64_t seed) {
  constexpr double kMostSpread = 0.95, kCoarse = 1.0 / 16.0;
  cv::Mat veil;
  cv::resize(picture, veil, cv::Size(), kCoarse, kCoarse, cv::INTER_AREA);
  cv::GaussianBlur(veil, veil, cv::Size(), 0.08 * veil.cols);
  cv::resize(veil, veil, picture.size(), 0.0, 0.0, cv::INTER_LINEAR);
  cv::GaussianBlur(picture, picture, cv::Size(), 1e-3 + 0.004 * share * picture.cols);
  picture = (1.0 - kMostSpread * share) * picture + kMostSpread * share * veil;
  add_noise(picture, 2.0, seed);
}

Eigen::Matrix3d turned(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis).toRotationMatrix();
}

LiveFault shifted_start(const char* name, const Eigen::Vector3d& millimetres) {
  LiveFault fault;
  fault.name = name;
  fault.start_shift = 1e-3 * millimetres;
  return fault;
}
LiveFault turned_start(const char* name, double degrees, const Eigen::Vector3d& axis) {
  LiveFault fault;
  fault.name = name;
  fault.start_turn = turned(degrees, axis);
  return fault;
}

void add_starts(std::vector<LiveFault>& faults) {
  faults.push_back(shifted_start("start_x_10mm", {10, 0, 0}));
  faults.push_back(shifted_start("start_x_20mm", {20, 0, 0}));
  faults.push_back(shifted_start("start_x_40mm", {40, 0, 0}));
  faults.push_back(shifted_start("start_y_20mm", {0, 20, 0}));
  faults.push_back(shifted_start("start_y_-20mm", {0, -20, 0}));
  faults.push_back(shifted_start("start_z_10mm", {0, 0, -10}));
  faults.push_back(shifted_start("start_z_20mm", {0, 0, -20}));
  const Eigen::Vector3d view = Eigen::Vector3d::UnitZ(), across = Eigen::Vector3d::UnitY();
  faults.push_back(turned_start("start_view_10deg", 10.0, view));
  faults.push_back(turned_start("start_view_20deg", 20.0, view));
  faults.push_back(turned_start("start_view_40deg", 40.0, view));
  faults.push_back(turned_start("start_view_180deg", 180.0, view));
  faults.push_back(turned_start("start_across_10deg", 10.0, across));
  faults.push_back(turned_start("start_across_20deg", 20.0, across));
  faults.push_back(turned_start("start_across_40deg", 40.0, across));
  LiveFault lifted;
  lifted.name = "start_lifted_30mm";
  lifted.start_lift = 30e-3;
  faults.push_back(lifted);
}

using Show = std::function<StereoFrame(const Film&, int)>;

LiveFault shown(const char* name, const Show& show) {
  LiveFault fault;
  fault.name = name;
  fault.show = show;
  return fault;
}

/// @param change of a frame that is `share` of the way from the onset to the end of a ramp.
template <class Change>
Show ramp(int onset, int last, Change change) {
  return [=](const Film& film, int k) {
    const StereoFrame& frame = film[static_cast<std::size_t>(k)];
    if (k < onset) return frame;
    const double share = std::min(1.0, (k - onset + 1.0) / (last - onset));
    return both(frame, [&](cv::Mat& picture, bool is_right) { change(picture, is_right, share, k); });
  };
}

void add_stale_views(std::vector<LiveFault>& faults, int onset, std::uint64_t seed) {
  const auto at = [](const Film& film, int k) -> const StereoFrame& {
    return film[static_cast<std::size_t>(std::max(0, k))];
  };
  const auto add = [&](const char* name, const Show& show) { faults.push_back(shown(name, show)); };
  add("frozen", [=](const Film& film, int k) { return shown_at(at(film, std::min(k, onset)), at(film, k)); });
  add("frozen_noise", [=](const Film& film, int k) {
    if (k < onset) return at(film, k);
    return both(shown_at(at(film, onset), at(film, k)), [&](cv::Mat& picture, bool is_right) {
      add_noise(picture, 2.0, seed + static_cast<std::uint64_t>(2 * k) + (is_right ? 1 : 0));
    });
  });
  add("left_frozen", [=](const Film& film, int k) {
    StereoFrame frame = at(film, k);
    frame.left = at(film, std::min(k, onset)).left;
    return frame;
  });
  add("right_frozen", [=](const Film& film, int k) {
    StereoFrame frame = at(film, k);
    frame.right = at(film, std::min(k, onset)).right;
    return frame;
  });
  for (const int late : {5, 15})
    add(late == 5 ? "right_5_late" : "right_15_late", [=](const Film& film, int k) {
      StereoFrame frame = at(film, k);
      if (k >= onset) frame.right = at(film, k - late).right;
      return frame;
    });
  add("duplicated", [=](const Film& film, int k) {
    return shown_at(at(film, k < onset ? k : k - (k - onset) % 2), at(film, k));
  });
  add("right_lost", [=](const Film& film, int k) {
    StereoFrame frame = at(film, k);
    if (k >= onset) frame.right = both(frame, [](cv::Mat& picture, bool) { picture.setTo(0); }).right;
    return frame;
  });
  add("swapped", [=](const Film& film, int k) {
    StereoFrame frame = at(film, k);
    if (k >= onset) std::swap(frame.left, frame.right);
    return frame;
  });
  faults.back().swapped_from = onset;
  add("black", [=](const Film& film, int k) {
    if (k < onset) return at(film, k);
    return both(at(film, k), [](cv::Mat& picture, bool) { picture.setTo(cv::Scalar::all(3)); });
  });
}

void add_covers(std::vector<LiveFault>& faults, const StereoRig& rig, int onset, int last,
                std::uint64_t seed) {
  const auto add = [&](const char* name, const Show& show) { faults.push_back(shown(name, show)); };
  const auto hung = [&](double share, double depth, double speed, bool textured) {
    const Curtain curtain(rig, share, depth, speed, textured, seed);
    return ramp(onset, onset + 1,
                [=](cv::Mat& picture, bool is_right, double, int k) { curtain.hang(picture, is_right, k); });
  };
  add("drape_60", hung(0.6, kDrapeDepth, kDrapeSpeed, true));
  add("bar_30", hung(0.3, kBarDepth, 0.0, false));
  add("bar_60", hung(0.6, kBarDepth, 0.0, false));
  add("smoke_ramp", ramp(onset, last, [seed](cv::Mat& picture, bool is_right, double share, int k) {
        picture = (1.0 - 0.6 * share) * picture + 0.6 * share * cv::Scalar::all(200.0);
        add_noise(picture, 2.0, seed + static_cast<std::uint64_t>(2 * k) + (is_right ? 1 : 0));
      }));
  for (const bool of_right : {false, true})
    add(of_right ? "fog_right_ramp" : "fog_left_ramp",
        ramp(onset, last, [=](cv::Mat& picture, bool is_right, double share, int k) {
          if (is_right == of_right) fog(picture, share, seed + static_cast<std::uint64_t>(2 * k));
        }));
  add("fade_ramp", ramp(onset, last, [seed](cv::Mat& picture, bool is_right, double share, int k) {
        picture = (1.0 - 0.85 * share) * picture;
        add_noise(picture, 2.0, seed + static_cast<std::uint64_t>(2 * k) + (is_right ? 1 : 0));
      }));
  add("blur", ramp(onset, onset + 1, [](cv::Mat& picture, bool, double, int) {
        cv::GaussianBlur(picture, picture, cv::Size(), 8.0);
      }));
  add("zoom_ramp", ramp(onset, last, [](cv::Mat& picture, bool, double share, int) {
        const cv::Mat grow = cv::getRotationMatrix2D(
            cv::Point2f(0.5F * static_cast<float>(picture.cols), 0.5F * static_cast<float>(picture.rows)),
            0.0, 1.0 + 0.15 * share);
        cv::warpAffine(picture.clone(), picture, grow, picture.size(), cv::INTER_LINEAR,
                       cv::BORDER_REPLICATE);
      }));
}

/// A shaft of steel that comes in from the right and sweeps over the organ: dark edges, a bright line.
class Tool {
 public:
  explicit Tool(const StereoRig& rig)
      : disparity_(rig.left.matrix(0, 0) * rig.baseline() / kToolDepth),
        width_(0.06 * rig.left.width),
        reach_(0.55 * rig.left.width) {}
  void show(cv::Mat& picture, bool is_right, double way, int frame) const {
    const double sway = 0.3 * picture.rows * std::sin(0.09 * frame);
    const double shift = is_right ? disparity_ : 0.0;
    const cv::Point2d root(picture.cols + 2.0 * width_ - shift, 0.65 * picture.rows);
    const cv::Point2d tip(picture.cols - way * reach_ - shift, 0.5 * picture.rows + sway);
    constexpr int kLayers = 6;
    for (int layer = 0; layer < kLayers; ++layer) {
      const double grey = 40.0 + 215.0 * layer / (kLayers - 1.0);
      cv::line(picture, tip, root, cv::Scalar::all(grey),
               static_cast<int>(width_ * (1.0 - layer / static_cast<double>(kLayers))) + 1, cv::LINE_AA);
    }
  }

 private:
  double disparity_, width_, reach_;
};

/// What comes into every operation, and is no fault: an overlay that is right is to stay.
void add_scene(std::vector<LiveFault>& faults, const StereoRig& rig, int onset, int last,
               std::uint64_t seed) {
  const auto add = [&](const char* name, const Show& show) {
    faults.push_back(shown(name, show));
    faults.back().is_sound = true;
  };
  const Tool tool(rig);
  add("tool", ramp(onset, onset + 20, [tool](cv::Mat& picture, bool is_right, double share, int k) {
        tool.show(picture, is_right, share, k);
      }));
  add("blood_ramp", ramp(onset, last, [](cv::Mat& picture, bool is_right, double share, int) {
        cv::Mat pool = picture.clone();
        cv::ellipse(pool, cv::Point(picture.cols * 45 / 100 - (is_right ? 20 : 0), picture.rows * 55 / 100),
                    cv::Size(static_cast<int>(0.38 * share * picture.cols),
                             static_cast<int>(0.38 * share * picture.rows)),
                    20.0, 0.0, 360.0, cv::Scalar(25, 15, 95), cv::FILLED, cv::LINE_AA);
        cv::addWeighted(pool, 0.85, picture, 0.15, 0.0, picture);
      }));
  add("drops", ramp(onset, onset + 1, [seed](cv::Mat& picture, bool is_right, double, int) {
        cv::Mat soft, on = cv::Mat::zeros(picture.size(), CV_8U);
        cv::GaussianBlur(picture, soft, cv::Size(), 9.0);
        std::mt19937 random(static_cast<std::uint32_t>(seed) + (is_right ? 1U : 0U));
        for (int i = 0; i < 12; ++i) {
          const int x = static_cast<int>(random() % static_cast<unsigned>(picture.cols));
          const int y = static_cast<int>(random() % static_cast<unsigned>(picture.rows));
          cv::circle(on, cv::Point(x, y), picture.cols / 22, cv::Scalar(255), cv::FILLED);
        }
        soft.copyTo(picture, on);
      }));
  add("flicker", ramp(onset, onset + 1, [](cv::Mat& picture, bool, double, int k) {
        picture = (k % 2 == 0 ? 0.75 : 1.2) * picture;
      }));
  const auto reader = std::make_shared<stereo::PictureReader>();
  add("lossy", ramp(onset, onset + 1, [reader](cv::Mat& picture, bool, double, int) {
        const std::string bytes = stereo::jpeg_of(picture_of(picture), 12);
        view_of(reader->decode(bytes, "lossy")).copyTo(picture);
      }));
  add("stutter", [=](const Film& film, int k) {
    const int shown = k < onset ? k : k - (k - onset) % 4;
    return shown_at(film[static_cast<std::size_t>(shown)], film[static_cast<std::size_t>(k)]);
  });
}

/// Pictures that show little, always or now and then.
void add_poor(std::vector<LiveFault>& faults, int onset, std::uint64_t seed) {
  const auto add = [&](const char* name, const Show& show) { faults.push_back(shown(name, show)); };
  add("noise", ramp(onset, onset + 1, [seed](cv::Mat& picture, bool is_right, double, int k) {
        add_noise(picture, 12.0, seed + static_cast<std::uint64_t>(2 * k) + (is_right ? 1 : 0));
      }));
  add("blinks", ramp(onset, onset + 1, [](cv::Mat& picture, bool, double, int k) {
        if (k % 15 < 3) picture.setTo(cv::Scalar::all(3));
      }));
}

/// Another organ, or another laparoscope than the one that was calibrated: from the first frame on.
void add_foreign(std::vector<LiveFault>& faults) {
  LiveFault other;
  other.name = "another_patient";
  other.other_patient = true;
  faults.push_back(other);
  const Show mirrored = [](const Film& film, int k) {
    // Both views flipped and exchanged: a right pair of views, of an organ that is the mirror image.
    StereoFrame frame = both(film[static_cast<std::size_t>(k)],
                             [](cv::Mat& picture, bool) { cv::flip(picture.clone(), picture, 1); });
    std::swap(frame.left, frame.right);
    return frame;
  };
  faults.push_back(shown("mirrored", mirrored));
  faults.back().is_mirrored = true;
  const auto add = [&](const char* name, const std::function<StereoRig(const StereoRig&)>& calibration) {
    LiveFault fault;
    fault.name = name;
    fault.calibration = calibration;
    faults.push_back(fault);
  };
  add("focal_85", [](StereoRig rig) {
    for (Camera* camera : {&rig.left, &rig.right}) camera->matrix(0, 0) *= 0.85, camera->matrix(1, 1) *= 0.85;
    return rig;
  });
  add("baseline_120", [](StereoRig rig) {
    rig.right_from_left.translation *= 1.2;
    return rig;
  });
  add("centre_20px", [](StereoRig rig) {
    rig.right.matrix(0, 2) += 20.0;
    return rig;
  });
}

/// What goes wrong little by little, or is seen in half of the frames only.
void add_slow(std::vector<LiveFault>& faults) {
  LiveFault lifted;
  lifted.name = "lifted_30mm";
  lifted.is_lifted = true;
  faults.push_back(lifted);
  LiveFault cut;
  cut.name = "cut_gapes_15mm";
  cut.is_cut = true;
  faults.push_back(cut);
  LiveFault drifting;
  drifting.name = "drift";
  drifting.drift = {0.1e-3, 0.0, 0.0};
  faults.push_back(drifting);
  for (const char* name : {"right_5_late", "zoom_ramp"}) {
    const auto same = std::find_if(faults.begin(), faults.end(),
                                   [name](const LiveFault& fault) { return fault.name == name; });
    LiveFault slow = *same;
    slow.name += "_15fps";
    slow.every = 2;
    faults.push_back(slow);
  }
}

/// The laparoscope is somewhere else from one frame to the next, and moves there. It is filmed so: to shift
/// the picture aside would break the rows of two views and shear what they show.
/// @param dark frames between without a picture: it is taken out, wiped and put back.
LiveFault jump(const char* name, int onset, int dark) {
  LiveFault fault;
  fault.name = name;
  fault.elsewhere_from = onset + dark;
  fault.show = [=](const Film& film, int k) {
    const StereoFrame& frame = film[static_cast<std::size_t>(k)];
    if (k < onset || k >= onset + dark) return frame;
    return both(frame, [](cv::Mat& picture, bool) { picture.setTo(cv::Scalar::all(3)); });
  };
  return fault;
}

}  // namespace

std::vector<LiveFault> handled_films() {
  std::vector<LiveFault> films(1);
  films.front().name = "none";
  films.front().is_sound = true;
  const LiveFault still = films.front();
  const auto add = [&](const char* name, bool LiveFault::*what, int every) {
    films.push_back(still);
    films.back().name = name;
    films.back().*what = true;
    films.back().every = every;
  };
  add("scope_moves", &LiveFault::scope_moves, 1);
  add("scope_moves_15fps", &LiveFault::scope_moves, 2);
  add("scope_fast", &LiveFault::scope_is_fast, 1);
  add("tool_lifts", &LiveFault::tool_lifts, 1);
  add("tool_presses", &LiveFault::tool_presses, 1);
  return films;
}

std::vector<LiveFault> live_faults(const StereoRig& rig, int onset, int last, std::uint64_t seed) {
  std::vector<LiveFault> faults = handled_films();
  add_starts(faults);
  add_stale_views(faults, onset, seed);
  add_covers(faults, rig, onset, last, seed);
  add_scene(faults, rig, onset, last, seed);
  add_poor(faults, onset, seed);
  add_foreign(faults);
  add_slow(faults);
  faults.push_back(jump("scope_jumps", onset, 0));
  faults.push_back(jump("scope_taken_out", onset, 20));
  return faults;
}

}  // namespace glisson::experiments
