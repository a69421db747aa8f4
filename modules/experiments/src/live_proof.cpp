// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/live_proof.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/statistics.h"
#include "glisson/guidance/tracker.h"
#include "glisson/stereo/picture_io.h"
#include "live_faults.h"
#include "live_stage.h"
#include "moved_tissue.h"

namespace glisson::experiments {
namespace {

constexpr double kFar = 10e-3, kNear = 3e-3;  ///< metres: frames over and under
constexpr int kInTime = 15;                   ///< frames: half a second

/// One frame of a run, judged with the truth at hand.
struct Judged {
  int frame = 0;
  double error = 0.0;  ///< metres, largest over the targets
  bool faulty = false;
  OverlayFrame overlay;
  /// Without evidence of its own the tracker would have shown it.
  bool shown_before() const {
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
};

std::vector<Judged> run(const LiveStage& stage, const LiveFault& fault, int onset) {
  Registration start;
  const Eigen::RowVector3d middle = stage.start.colwise().mean();
  start.nodes_in_camera = ((stage.start.rowwise() - middle) * fault.start_turn.transpose()).rowwise() +
                          (middle + fault.start_shift.transpose());
  guidance::Tracker tracker(stage.model, start, {});
  const auto filmed = [&](int k) -> const Filmed& {
    const bool held = fault.scope_moves || (fault.elsewhere_from >= 0 && k >= fault.elsewhere_from);
    return held ? stage.held : stage.standing;
  };
  const auto shown = [&](int k) {
    const Film& film = filmed(k).film;
    return fault.show ? fault.show(film, k) : film[static_cast<std::size_t>(k)];
  };
  tracker.begin(fault.calibration ? fault.calibration(stage.rig) : stage.rig, shown(0), {});
  const Binding targets = bind_points(stage.model.mesh, stage.targets_in_model);
  std::vector<Judged> frames;
  for (int k = 1; k < static_cast<int>(stage.standing.film.size()); ++k) {
    Judged judged;
    judged.frame = k;
    judged.overlay = tracker.follow(shown(k));
    judged.faulty = fault.name != "none" && !fault.scope_moves && (!fault.show || k >= onset);
    const Points& truth = filmed(k).targets[static_cast<std::size_t>(k)];
    const Points found = targets.apply(stage.model.mesh, judged.overlay.nodes_in_camera);
    judged.error = (found - truth).rowwise().norm().maxCoeff();
    frames.push_back(std::move(judged));
  }
  return frames;
}

/// Counts over frames.
struct Tally {
  int far = 0, far_hidden = 0, far_hidden_before = 0;
  int near = 0, near_valid = 0, near_sound = 0, near_sound_valid = 0;
  double error_sum = 0.0;  ///< metres, over all frames
  int frames = 0;
  std::map<std::string, int> shown;
  std::vector<double> milliseconds;
  int returned = -1;  ///< frames from where the picture is good again until a right overlay is shown
  int latest = -1;    ///< frames from the first over 10 mm (or the fault) to the first not valid
  bool is_in_time = true;

  /// @param good_from the frame from which the picture shows the organ well again; -1: never.
  void add_return(const std::vector<Judged>& run, int good_from) {
    if (good_from < 0) return;
    int first = run.back().frame + 1;
    for (const Judged& judged : run)
      if (judged.frame >= good_from && judged.frame < first && judged.error < kFar &&
          judged.overlay.validity == Validity::valid)
        first = judged.frame;
    returned = std::max(returned, first - good_from);
  }

  void add(const std::vector<Judged>& run) {
    int first_far = -1, first_hidden = -1;
    for (const Judged& judged : run) {
      const bool valid = judged.overlay.validity == Validity::valid;
      ++shown[validity_code(judged.overlay.validity)];
      milliseconds.push_back(judged.overlay.milliseconds);
      error_sum += judged.error;
      ++frames;
      if (judged.error > kFar) {
        ++far;
        far_hidden += !valid;
        far_hidden_before += !judged.shown_before();
        if (first_far < 0) first_far = judged.frame;
      } else if (judged.error < kNear) {
        ++near;
        near_valid += valid;
        near_sound += !judged.faulty;
        near_sound_valid += !judged.faulty && valid;
      }
      if (judged.faulty && !valid && first_hidden < 0) first_hidden = judged.frame;
    }
    if (first_far < 0) return;
    const int last = run.back().frame + 1;
    latest = std::max(latest, std::max(0, (first_hidden < 0 ? last : first_hidden) - first_far));
    is_in_time = latest <= kInTime;
  }
  std::string most_shown() const {
    std::string name = "valid";
    int most = 0;
    for (const auto& [code, count] : shown)
      if (code != "valid" && count > most) {
        name = code;
        most = count;
      }
    return name;
  }
};

double share(int part, int whole) { return whole > 0 ? part / static_cast<double>(whole) : 1.0; }

std::string percent(int part, int whole) {
  if (whole == 0) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", 100.0 * part / whole);
  return text;
}

std::string csv_line(const std::string& stage, const std::string& fault, const Judged& judged) {
  const auto& e = judged.overlay.evidence;
  char line[400];
  std::snprintf(line, sizeof line,
                "%s,%s,%d,%d,%.3f,%s,%d,%.3f,%.3f,%.3f,%.4f,%.3f,%.3f,%.3f,%.3f,%.3f,%.2f\n", stage.c_str(),
                fault.c_str(), judged.frame, judged.faulty ? 1 : 0, 1e3 * judged.error,
                validity_code(judged.overlay.validity), judged.overlay.pairs, 1e3 * judged.overlay.residual,
                e.supported, e.gap, e.behind, 1e3 * e.pull, 1e3 * e.pull_sigma, e.contrast, e.motion, e.rows,
                judged.overlay.milliseconds);
  return line;
}

void add_row(const std::string& name, const Tally& tally, LiveProof& proof) {
  const std::string late = tally.latest < 0 ? "-" : std::to_string(tally.latest);
  char line[200];
  std::snprintf(line, sizeof line, "%-20s %-20s %6s %6d %9s %9s %6d %9s", name.c_str(),
                tally.most_shown().c_str(), late.c_str(), tally.far,
                percent(tally.far_hidden_before, tally.far).c_str(),
                percent(tally.far_hidden, tally.far).c_str(), tally.near,
                percent(tally.near_valid, tally.near).c_str());
  proof.table.emplace_back(line);
}

/// Of one kind of stage.
struct Gathered {
  std::vector<std::string> names;  ///< of the faults, in their order
  std::map<std::string, Tally> tallies;
  Tally& of(const std::string& name) {
    if (!tallies.contains(name)) names.push_back(name);
    return tallies[name];
  }
};

/// @param prefix of the figures' keys.
void sum_up(const Gathered& gathered, const char* title, const std::string& prefix, LiveProof& proof) {
  if (gathered.names.empty()) return;
  if (!proof.table.empty()) proof.table.emplace_back();
  char head[200];
  std::snprintf(head, sizeof head, "%-20s %-20s %6s %6s %9s %9s %6s %9s", title, "shown as", "late", ">10mm",
                "hidden was", "hidden", "<3mm", "valid %");
  proof.table.emplace_back(head);
  Tally all;
  int late = 0, returned = 0;
  for (const std::string& name : gathered.names) {
    const Tally& one = gathered.tallies.at(name);
    add_row(name, one, proof);
    all.far += one.far;
    all.far_hidden += one.far_hidden;
    all.far_hidden_before += one.far_hidden_before;
    all.near += one.near;
    all.near_valid += one.near_valid;
    all.near_sound += one.near_sound;
    all.near_sound_valid += one.near_sound_valid;
    late = std::max(late, one.latest);
    returned = std::max(returned, one.returned);
    all.milliseconds.insert(all.milliseconds.end(), one.milliseconds.begin(), one.milliseconds.end());
    if (name == "none") proof.figures[prefix + "still_mean_mm"] = 1e3 * one.error_sum / one.frames;
    if (name == "scope_moves") proof.figures[prefix + "scope_mean_mm"] = 1e3 * one.error_sum / one.frames;
  }
  add_row("all", all, proof);
  proof.figures[prefix + "far_frames"] = all.far;
  proof.figures[prefix + "far_hidden_share"] = share(all.far_hidden, all.far);
  proof.figures[prefix + "far_hidden_before_share"] = share(all.far_hidden_before, all.far);
  proof.figures[prefix + "near_valid_share"] = share(all.near_valid, all.near);
  proof.figures[prefix + "near_sound_valid_share"] = share(all.near_sound_valid, all.near_sound);
  proof.figures[prefix + "latest_seconds"] = late / 30.0;
  proof.figures[prefix + "return_seconds"] = returned / 30.0;
  proof.figures[prefix + "frame_p50_ms"] = lower_percentile(all.milliseconds, 0.5);
  proof.figures[prefix + "frame_p99_ms"] = lower_percentile(all.milliseconds, 0.99);
}

/// A real pair that is set in motion.
struct RealSet {
  const char* folder;
  const char* title;
  const char* prefix;  ///< of the figures' keys
  RealPair (*read)(const std::filesystem::path& folder);
};
constexpr RealSet kRealSets[] = {
    {"stereo_opencas", "liver tissue, moved", "live_tissue_",
     [](const std::filesystem::path& folder) { return opencas(folder, OpencasPart::tissue); }},
    {"stereo_heart", "silicone heart, moved", "live_heart_", heart}};

/// A moment of its films, to be looked at.
void write_pictures(const std::filesystem::path& folder, const std::string& set, const LiveStage& stage) {
  const std::size_t k = stage.standing.film.size() / 3;
  for (const auto& [name, filmed] : {std::pair{"standing", &stage.standing}, {"held", &stage.held}}) {
    const std::string start = set + "_" + name;
    stereo::write_picture(folder / (start + "_left.png"), filmed->film[k].left);
    stereo::write_picture(folder / (start + "_right.png"), filmed->film[k].right);
  }
}

/// Every fault on one stage. @return false: cancelled.
bool try_faults(const LiveStage& stage, const std::string& name, std::uint64_t seed,
                const LiveProofOptions& options, Gathered& gathered, std::string& csv,
                const RunContext& context) {
  const auto faults = live_faults(stage.rig, options.onset, options.frames - 1, seed);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (context.cancelled()) return false;
    context.progress(static_cast<double>(i) / static_cast<double>(faults.size()), "demo.track");
    if (faults[i].name.find(options.only) == std::string::npos) continue;
    const std::vector<Judged> frames = run(stage, faults[i], options.onset);
    Tally& tally = gathered.of(faults[i].name);
    tally.add(frames);
    tally.add_return(frames, faults[i].elsewhere_from);
    for (const Judged& judged : frames) csv += csv_line(name, faults[i].name, judged);
  }
  return true;
}

}  // namespace

void LiveProofOptions::validate() const {
  const OptionCheck demand("live proof options");
  demand(!seeds.empty() || !data.empty(), "seeds", 0.0, "Give one at least");
  demand(frames >= 60, "frames", frames, "Give 60 at least");
  demand(onset >= 10 && onset + 20 < frames, "onset", onset, "Give a frame well before the last");
}

Cancellable<LiveProof> prove_live(const LiveProofOptions& options, const std::filesystem::path& folder,
                                  const RunContext& context) {
  options.validate();
  LiveProof proof;
  std::string csv =
      "stage,fault,frame,faulty,error_mm,validity,pairs,residual_mm,supported,gap,behind,pull_mm,"
      "pull_sigma_mm,contrast,motion,rows_px,ms\n";
  Gathered theatre;
  const double part = 1.0 / (static_cast<double>(options.seeds.size()) + 1.0);
  double done = 0.0;
  for (const std::uint64_t seed : options.seeds) {
    const auto stage = theatre_stage(seed, options.frames, context.part(done, done + 0.4 * part));
    if (!stage || !try_faults(*stage, std::to_string(seed), seed, options, theatre, csv,
                              context.part(done + 0.4 * part, done + part)))
      return std::nullopt;
    done += part;
  }
  sum_up(theatre, "in the theatre", "live_", proof);
  for (const RealSet& set : kRealSets) {
    if (options.data.empty() || !std::filesystem::exists(options.data / set.folder)) {
      proof.absent.emplace_back(set.folder);
      continue;
    }
    const auto stage = pair_stage(set.read(options.data / set.folder), options.frames, 1,
                                  context.part(done, done + 0.1 * part));
    if (!stage) return std::nullopt;
    write_pictures(folder, set.folder, *stage);
    Gathered gathered;
    if (!try_faults(*stage, set.folder, 1, options, gathered, csv,
                    context.part(done + 0.1 * part, done + 0.5 * part)))
      return std::nullopt;
    sum_up(gathered, set.title, set.prefix, proof);
    done += 0.5 * part;
  }
  std::string table;
  for (const std::string& line : proof.table) table += line + "\n";
  write_file_atomically(folder / "live.csv", csv);
  write_file_atomically(folder / "live.txt", table);
  return proof;
}

}  // namespace glisson::experiments
