// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glisson/core/error.h"
#include "glisson/guidance/tracker.h"
#include "live_truth.h"

namespace glisson::experiments {
namespace {

/// Metres, of each coordinate of a lesion's centre: what a good registration leaves. It is what the program
/// believes of its start, also of a wrong one.
constexpr double kStartSigma = 1.5e-3;
constexpr int kDriftEvery = 6;  ///< frames

/// The target that lies nearest to the middle of the first picture.
Eigen::Vector3d middle_target(const LiveStage& stage) {
  const Points& targets = stage.standing.targets.front();
  Eigen::Index nearest = 0;
  (targets.leftCols<2>().rowwise().norm().array() / targets.col(2).array()).minCoeff(&nearest);
  return targets.row(nearest).transpose();
}

/// The part of the organ about a target lies nearer to the lens than the start has it.
Points bent_away(Points nodes, const Eigen::Vector3d& target, double by) {
  constexpr double kWide = 22e-3;  // less, and elements of the model turn inside out
  for (Eigen::Index i = 0; i < nodes.rows(); ++i) {
    const double away = (nodes.row(i).transpose() - target).head<2>().squaredNorm();
    nodes(i, 2) += by * std::exp(-away / (2.0 * kWide * kWide));
  }
  return nodes;
}

Registration start_of(const LiveStage& stage, const LiveFault& fault) {
  Registration start;
  const Eigen::RowVector3d middle = stage.start.colwise().mean();
  start.nodes_in_camera = ((stage.start.rowwise() - middle) * fault.start_turn.transpose()).rowwise() +
                          (middle + fault.start_shift.transpose());
  if (fault.start_lift != 0.0)
    start.nodes_in_camera = bent_away(start.nodes_in_camera, middle_target(stage), fault.start_lift);
  for (const Label lesion : stage.lesions) {
    LesionSpread spread;
    spread.lesion = lesion;
    spread.covariance = Eigen::Matrix3d::Identity() * kStartSigma * kStartSigma;
    start.lesions.push_back(spread);
  }
  return start;
}

/// What the laparoscope shows, and where the targets truly are.
class Shown {
 public:
  Shown(const LiveStage& stage, const LiveFault& fault) : stage_(stage), fault_(fault) {}
  StereoFrame frame(int k) const {
    const Film& film = filmed(k).film;
    return fault_.show ? fault_.show(film, k) : film[static_cast<std::size_t>(k)];
  }
  /// Largest distance, metres.
  double error(const Points& found, int k) const {
    if (shows_another_organ(fault_)) return kNowhere;
    const Points there = truth(k);
    double most = 0.0;
    for (Eigen::Index i = 0; i < found.rows(); ++i)
      most = std::max(most,
                      drawn_error(fault_, stage_.rig, k, found.row(i).transpose(), there.row(i).transpose()));
    return most;
  }
  double error(const LesionVerdict& verdict, int k) const {
    const auto at = std::find(stage_.lesions.begin(), stage_.lesions.end(), verdict.lesion);
    if (shows_another_organ(fault_) || at == stage_.lesions.end()) return kNowhere;
    return drawn_error(fault_, stage_.rig, k, verdict.centre,
                       truth(k).row(at - stage_.lesions.begin()).transpose());
  }

 private:
  const Filmed& filmed(int k) const {
    if (fault_.other_patient) return stage_.other;
    if (fault_.is_lifted) return stage_.lifted;
    if (fault_.is_cut) return stage_.cut;
    if (fault_.scope_is_fast) return stage_.fast;
    if (fault_.tool_lifts) return stage_.tool_lifts;
    if (fault_.tool_presses) return stage_.tool_presses;
    const bool held = fault_.scope_moves || (fault_.elsewhere_from >= 0 && k >= fault_.elsewhere_from);
    return held ? stage_.held : stage_.standing;
  }
  const Points& truth(int k) const { return filmed(k).targets[static_cast<std::size_t>(k)]; }

  const LiveStage& stage_;
  const LiveFault& fault_;
};

/// The registered shape creeps away, and with it what is drawn.
void drift(guidance::Tracker& tracker, const Registration& start, const Eigen::Vector3d& by) {
  Registration off = start;
  off.nodes_in_camera.rowwise() += by.transpose();
  try {
    tracker.take(off);
  } catch (const InputError&) {
    // Nothing is followed in this frame: it stays where it is.
  }
}

}  // namespace

bool JudgedFrame::shown_before() const {
  switch (overlay.validity) {
    case Validity::valid:
    case Validity::surface_apart:
    case Validity::picture_stands:
    case Validity::views_apart:
    case Validity::partly_covered:
    case Validity::poor_picture:
    case Validity::picture_still:
      return true;
    default:
      return false;
  }
}

bool can_run(const LiveStage& stage, const LiveFault& fault) {
  return (!fault.other_patient || stage.other.film.size() >= stage.standing.film.size()) &&
         (!fault.is_lifted || !stage.lifted.film.empty()) && (!fault.is_cut || !stage.cut.film.empty()) &&
         (!fault.scope_is_fast || !stage.fast.film.empty()) &&
         (!fault.tool_lifts || !stage.tool_lifts.film.empty()) &&
         (!fault.tool_presses || !stage.tool_presses.film.empty());
}

std::vector<JudgedFrame> run_live(const LiveStage& stage, const LiveFault& fault, int onset) {
  require(can_run(stage, fault), "the stage has what the fault shows");
  const Registration start = start_of(stage, fault);
  const Shown shown(stage, fault);
  guidance::Tracker tracker(stage.model, start, {});
  tracker.begin(fault.calibration ? fault.calibration(stage.rig) : stage.rig, shown.frame(0), {});
  const Binding targets = bind_points(stage.model.mesh, stage.targets_in_model);
  const Points frozen = targets.apply(stage.model.mesh, start.nodes_in_camera);
  std::vector<JudgedFrame> frames;
  for (int k = fault.every; k < static_cast<int>(stage.standing.film.size()); k += fault.every) {
    JudgedFrame judged;
    judged.frame = k;
    judged.overlay = tracker.follow(shown.frame(k));
    judged.strength = tracker.evidence_strength();
    judged.faulty = !fault.is_sound &&
                    (k >= onset || fault.is_mirrored || !(fault.show || fault.is_lifted || fault.is_cut));
    judged.error = shown.error(targets.apply(stage.model.mesh, judged.overlay.nodes_in_camera), k);
    judged.frozen = shown.error(frozen, k);
    for (const LesionVerdict& verdict : judged.overlay.lesions)
      judged.lesion_errors.push_back(shown.error(verdict, k));
    frames.push_back(std::move(judged));
    if (!fault.drift.isZero() && k % kDriftEvery == 0) drift(tracker, start, k * fault.drift);
  }
  return frames;
}

const char* const kFrameHeads =
    "stage,fault,frame,faulty,error_mm,frozen_mm,validity,pairs,residual_mm,supported,gap,local,behind,"
    "before,"
    "lifted,pull_mm,pull_sigma_mm,contrast,motion,fresh,rows_px,strength,ms\n";
const char* const kLesionHeads = "stage,fault,frame,faulty,lesion,error_mm,level,reach_mm\n";

std::string frame_line(const std::string& stage, const std::string& fault, const JudgedFrame& judged) {
  const auto& e = judged.overlay.evidence;
  char line[500];
  std::snprintf(
      line, sizeof line,
      "%s,%s,%d,%d,%.3f,%.3f,%s,%d,%.3f,%.3f,%.3f,%.3f,%.4f,%.4f,%.4f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,"
      "%.3f,%.2f\n",
      stage.c_str(), fault.c_str(), judged.frame, judged.faulty ? 1 : 0, 1e3 * judged.error,
      1e3 * judged.frozen, validity_code(judged.overlay.validity), judged.overlay.pairs,
      1e3 * judged.overlay.residual, e.supported, e.gap, e.local, e.behind, e.before, e.lifted, 1e3 * e.pull,
      1e3 * e.pull_sigma, e.contrast, e.motion, e.fresh, e.rows, judged.strength,
      judged.overlay.milliseconds);
  return line;
}

std::string lesion_lines(const std::string& stage, const std::string& fault, const JudgedFrame& judged) {
  std::string lines;
  for (std::size_t i = 0; i < judged.lesion_errors.size(); ++i) {
    const LesionVerdict& verdict = judged.overlay.lesions[i];
    char line[200];
    std::snprintf(line, sizeof line, "%s,%s,%d,%d,%d,%.3f,%s,%.3f\n", stage.c_str(), fault.c_str(),
                  judged.frame, judged.faulty ? 1 : 0, static_cast<int>(verdict.lesion),
                  1e3 * judged.lesion_errors[i], level_code(verdict.level), 1e3 * verdict.reach);
    lines += line;
  }
  return lines;
}

}  // namespace glisson::experiments
