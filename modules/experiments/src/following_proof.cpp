// SPDX-License-Identifier: GPL-3.0-or-later
#include "following_proof.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/experiments/synthetic_model.h"
#include "glisson/guidance/tracker.h"
#include "glisson/insilico/theatre.h"
#include "of_none.h"

namespace glisson::experiments {
namespace {

constexpr double kFar = 10e-3;          ///< metres, at any lesion
constexpr double kMoved = 2.3e-3;       ///< metres, mean over the organ: from here on it has moved
constexpr double kStartSigma = 1.5e-3;  ///< metres, of each coordinate of a lesion: a good registration's

/// One film of the theatre.
struct FilmKind {
  const char* name;
  insilico::ScopePath scope;
  insilico::ToolUse tool;
  bool is_long = false;
};

std::vector<FilmKind> kinds(std::uint64_t seed) {
  const auto seeded = [&](insilico::ToolUse use) {
    use.seed = seed;
    return use;
  };
  const auto hand = insilico::ScopePath::in_a_hand();
  return {{"still", {}, {}},
          {"hand", hand, {}},
          {"fast", insilico::ScopePath::in_a_fast_hand(), {}},
          {"lifted", {}, seeded(insilico::ToolUse::lifts())},
          {"pressed", {}, seeded(insilico::ToolUse::presses())},
          {"lifted_hand", hand, seeded(insilico::ToolUse::lifts())},
          {"long", hand, {}, true}};
}

/// Of one frame, metres: means over the nodes, and the largest over the lesions.
struct Followed {
  double error = 0.0, motion = 0.0, lesion = 0.0;
  bool is_shown = false;
};

struct FilmTally {
  int frames = 0, shown = 0, far = 0, far_shown = 0, moved = 0;
  double error = 0.0, motion = 0.0, lesion = 0.0;  ///< sums over the frames that are shown
  double moved_error = 0.0, moved_motion = 0.0;    ///< likewise, of those in which the organ has moved
  double worst = 0.0;                              ///< of a lesion, shown
  int last_shown = 0;
  double last_error = 0.0;  ///< sum over the last tenth, shown
  std::map<std::string, int> reasons;

  void add(const Followed& now, bool is_last) {
    ++frames;
    far += now.lesion > kFar;
    if (!now.is_shown) return;
    ++shown;
    far_shown += now.lesion > kFar;
    error += now.error;
    motion += now.motion;
    lesion += now.lesion;
    worst = std::max(worst, now.lesion);
    if (now.motion >= kMoved) ++moved, moved_error += now.error, moved_motion += now.motion;
    if (is_last) ++last_shown, last_error += now.error;
  }
  std::string why() const {
    const auto most = std::max_element(reasons.begin(), reasons.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == reasons.end() ? "-" : most->first;
  }
};

double mean_of(double sum, int count) { return count > 0 ? sum / count : std::nan(""); }

/// The patient in the theatre, and the model that is to follow.
class Stage {
 public:
  static Cancellable<Stage> make(std::uint64_t seed, int frames, const RunContext& context) {
    auto synthetic = synthetic_model(seed, context.part(0.0, 0.5));
    if (!synthetic) return std::nullopt;
    const PatientModel shown = shown_in_theatre(std::move(synthetic->patient));
    insilico::TheatreOptions options;
    options.seed = seed;
    options.frames = frames;
    auto theatre = insilico::Theatre::build(shown, options, context.part(0.5, 1.0));
    if (!theatre) return std::nullopt;
    return Stage(std::move(synthetic->model), std::move(*theatre));
  }

  /// @return false: cancelled.
  bool follow(const FilmKind& kind, int frames, FilmTally& tally, std::string& csv,
              const RunContext& context) {
    theatre_->move_scope({});
    if (!theatre_->use_tool(kind.tool, context.quiet())) return false;
    const Points first = model_nodes(0);
    std::vector<double> motion;
    for (int k = 0; k < frames; ++k) motion.push_back((model_nodes(k) - first).rowwise().norm().mean());
    theatre_->move_scope(kind.scope);
    guidance::Tracker tracker(model_, start(), {});
    tracker.begin(theatre_->rig(), theatre_->render(0), {});
    for (int k = 1; k < frames; ++k) {
      if (context.cancelled()) return false;
      context.progress(static_cast<double>(k) / frames, "prove.theatre");
      const OverlayFrame overlay = tracker.follow(theatre_->render(k));
      const Points truth = model_nodes(k);
      Followed now;
      now.error = (overlay.nodes_in_camera - truth).rowwise().norm().mean();
      now.motion = motion[static_cast<std::size_t>(k)];
      now.lesion = (lesions_.apply(model_.mesh, overlay.nodes_in_camera) - true_lesions(k))
                       .rowwise()
                       .norm()
                       .maxCoeff();
      now.is_shown = overlay.validity == Validity::valid;
      if (!now.is_shown) ++tally.reasons[validity_code(overlay.validity)];
      tally.add(now, 10 * k >= 9 * frames);
      char line[200];
      std::snprintf(line, sizeof line, "%s,%d,%.3f,%.3f,%.3f,%s,%d,%.2f\n", kind.name, k, 1e3 * now.error,
                    1e3 * now.motion, 1e3 * now.lesion, validity_code(overlay.validity), overlay.pairs,
                    overlay.milliseconds);
      csv += line;
    }
    return true;
  }

 private:
  Stage(PatientModel model, std::unique_ptr<insilico::Theatre> theatre)
      : model_(std::move(model)),
        theatre_(std::move(theatre)),
        nodes_(bind_points(theatre_->mesh(), model_.mesh.vertices, false)) {
    Points centres(static_cast<Eigen::Index>(theatre_->targets().size()), 3);
    for (std::size_t i = 0; i < theatre_->targets().size(); ++i)
      centres.row(static_cast<Eigen::Index>(i)) = theatre_->targets()[i].centre_in_ct.transpose();
    lesions_ = bind_points(model_.mesh, centres);
  }
  Points model_nodes(int frame) const {
    return nodes_.apply(theatre_->mesh(), theatre_->truth(frame).nodes_in_camera);
  }
  Points true_lesions(int frame) const { return theatre_->truth(frame).targets_in_camera; }
  Registration start() const {
    Registration start;
    start.nodes_in_camera = model_nodes(0);
    for (const insilico::Target& target : theatre_->targets()) {
      LesionSpread spread;
      spread.lesion = target.structure;
      spread.covariance = Eigen::Matrix3d::Identity() * kStartSigma * kStartSigma;
      start.lesions.push_back(spread);
    }
    return start;
  }

  PatientModel model_;
  std::unique_ptr<insilico::Theatre> theatre_;
  Binding nodes_, lesions_;
};

std::string mm(double metres) { return figure_text("%.2f", 1e3 * metres); }

std::string row(const char* name, const FilmTally& tally) {
  char line[240];
  std::snprintf(line, sizeof line, "%-12s %6d %8s %7s %7s %7s %7s %7s %7s %6d %6d  %s", name, tally.frames,
                figure_text("%.1f", 100.0 * share_of(tally.shown, tally.frames)).c_str(),
                mm(mean_of(tally.error, tally.shown)).c_str(), mm(mean_of(tally.motion, tally.shown)).c_str(),
                mm(mean_of(tally.lesion, tally.shown)).c_str(),
                mm(tally.shown > 0 ? tally.worst : std::nan("")).c_str(),
                mm(mean_of(tally.moved_error, tally.moved)).c_str(),
                mm(mean_of(tally.last_error, tally.last_shown)).c_str(), tally.far, tally.far_shown,
                tally.why().c_str());
  return line;
}

void tell(const std::string& name, const FilmTally& tally, Figures& figures) {
  const std::string key = "following_" + name + "_";
  figures[key + "tre_mm"] = 1e3 * mean_of(tally.error, tally.shown);
  figures[key + "of_motion_share"] = tally.motion > 0.0 ? tally.error / tally.motion : std::nan("");
  figures[key + "shown_share"] = share_of(tally.shown, tally.frames);
  figures[key + "lesion_mm"] = 1e3 * mean_of(tally.lesion, tally.shown);
  figures[key + "moved_tre_mm"] = 1e3 * mean_of(tally.moved_error, tally.moved);
  figures[key + "moved_motion_mm"] = 1e3 * mean_of(tally.moved_motion, tally.moved);
  figures[key + "last_tre_mm"] = 1e3 * mean_of(tally.last_error, tally.last_shown);
}

}  // namespace

void FollowingProofOptions::validate() const {
  const OptionCheck demand("following proof options");
  demand(frames >= 30, "frames", frames, "Give 30 at least");
  demand(long_frames >= frames, "long_frames", long_frames, "Give as many as of the others at least");
}

Cancellable<FollowingProof> prove_following(const FollowingProofOptions& options,
                                            const std::filesystem::path& folder, const RunContext& context) {
  options.validate();
  auto stage = Stage::make(options.seed, options.long_frames, context.part(0.0, 0.1));
  if (!stage) return std::nullopt;
  FollowingProof proof;
  char head[240];
  std::snprintf(head, sizeof head, "%-12s %6s %8s %7s %7s %7s %7s %7s %7s %6s %6s  %s", "film", "frames",
                "shown %", "error", "motion", "lesion", "worst", "moved", "last", ">10mm", "shown",
                "otherwise");
  proof.table.emplace_back(head);
  std::string csv = "film,frame,error_mm,motion_mm,lesion_mm,validity,pairs,ms\n";
  int far = 0, far_shown = 0;
  double worst_share = std::nan("");
  const std::vector<FilmKind> films = kinds(options.seed);
  for (std::size_t i = 0; i < films.size(); ++i) {
    const FilmKind& kind = films[i];
    if (std::string(kind.name).find(options.only) == std::string::npos) continue;
    FilmTally tally;
    const double from = 0.1 + 0.9 * static_cast<double>(i) / static_cast<double>(films.size());
    const double to = 0.1 + 0.9 * static_cast<double>(i + 1) / static_cast<double>(films.size());
    if (!stage->follow(kind, kind.is_long ? options.long_frames : options.frames, tally, csv,
                       context.part(from, to)))
      return std::nullopt;
    proof.table.push_back(row(kind.name, tally));
    tell(kind.name, tally, proof.figures);
    if (tally.motion > 0.0) worst_share = std::fmax(worst_share, tally.error / tally.motion);
    far += tally.far;
    far_shown += tally.far_shown;
  }
  proof.figures["following_far_frames"] = far;
  proof.figures["following_far_shown_frames"] = far_shown;
  proof.figures["following_worst_of_motion_share"] = worst_share;
  write_file_atomically(folder / "following.csv", csv);
  return proof;
}

}  // namespace glisson::experiments
