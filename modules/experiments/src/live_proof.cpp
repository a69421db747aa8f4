// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/live_proof.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/guidance/tracker.h"
#include "glisson/insilico/patient.h"
#include "glisson/insilico/theatre.h"
#include "glisson/model/build.h"
#include "live_faults.h"

namespace glisson::experiments {
namespace {

constexpr double kFar = 10e-3, kNear = 3e-3;  ///< metres: frames over and under
constexpr int kInTime = 15;                   ///< frames: half a second

struct Filmed {
  Film film;
  std::vector<Points> targets;  ///< each frame's, camera's frame
};

/// A patient in the theatre, filmed by a camera that stands and by one in a hand, with the model that is to
/// follow.
struct Stage {
  PatientModel model;
  std::unique_ptr<insilico::Theatre> theatre;
  Filmed standing, held;
  Points start;  ///< the model's nodes where they truly are in the first frame
  Points targets_in_ct;
};

/// @return false: cancelled.
bool film(const insilico::Theatre& theatre, Filmed& filmed, const RunContext& context) {
  for (int k = 0; k < theatre.frame_count(); ++k) {
    if (context.cancelled()) return false;
    filmed.film.push_back(theatre.render(k));
    filmed.targets.push_back(theatre.truth(k).targets_in_camera);
    context.progress((k + 1.0) / theatre.frame_count(), "prove.theatre");
  }
  return true;
}

std::optional<Stage> build_stage(std::uint64_t seed, int frames, const RunContext& context) {
  insilico::PatientOptions patient_options;
  patient_options.shape_seed = seed;
  patient_options.spacing_mm = {2.5, 2.5, 2.5};
  patient_options.surface_spacing_mm = 2.0;
  auto patient = insilico::make_patient(patient_options, context.part(0.0, 0.15));
  if (!patient) return std::nullopt;
  auto built = model::build_from_labels(patient->truth, {}, context.part(0.15, 0.35));
  if (!built) return std::nullopt;
  PatientModel shown;
  shown.surfaces = std::move(patient->surfaces);
  shown.vessels = std::move(patient->trees);
  shown.landmarks = std::move(patient->landmarks);
  insilico::TheatreOptions theatre_options;
  theatre_options.seed = seed;
  theatre_options.frames = frames;
  auto theatre = insilico::Theatre::build(shown, theatre_options, context.part(0.35, 0.6));
  if (!theatre) return std::nullopt;
  Stage stage;
  stage.model = std::move(built->model);
  stage.theatre = std::move(*theatre);
  if (!film(*stage.theatre, stage.standing, context.part(0.6, 0.8))) return std::nullopt;
  // Up to 10 degrees and 45 mm a second, a third nearer and farther.
  stage.theatre->move_scope({.pivot_deg = 6.0, .slide_mm = 30.0, .roll_deg = 10.0});
  if (!film(*stage.theatre, stage.held, context.part(0.8, 1.0))) return std::nullopt;
  stage.start = stage.theatre->carry(stage.model.mesh.vertices, 0);
  const auto& targets = stage.theatre->targets();
  stage.targets_in_ct.resize(static_cast<Eigen::Index>(targets.size()), 3);
  for (std::size_t i = 0; i < targets.size(); ++i)
    stage.targets_in_ct.row(static_cast<Eigen::Index>(i)) = targets[i].centre_in_ct.transpose();
  return stage;
}

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
        return true;
      default:
        return false;
    }
  }
};

std::vector<Judged> run(const Stage& stage, const LiveFault& fault, int onset) {
  Registration start;
  const Eigen::RowVector3d middle = stage.start.colwise().mean();
  start.nodes_in_camera = ((stage.start.rowwise() - middle) * fault.start_turn.transpose()).rowwise() +
                          (middle + fault.start_shift.transpose());
  guidance::Tracker tracker(stage.model, start, {});
  const auto& [film, true_targets] = fault.scope_moves ? stage.held : stage.standing;
  const auto shown = [&, &frames_shown = film](int k) {
    return fault.show ? fault.show(frames_shown, k) : frames_shown[static_cast<std::size_t>(k)];
  };
  tracker.begin(stage.theatre->rig(), shown(0), {});
  const Binding targets = bind_points(stage.model.mesh, stage.targets_in_ct);
  std::vector<Judged> frames;
  for (int k = 1; k < static_cast<int>(film.size()); ++k) {
    Judged judged;
    judged.frame = k;
    judged.overlay = tracker.follow(shown(k));
    judged.faulty = fault.name != "none" && !fault.scope_moves && (!fault.show || k >= onset);
    Points truth = true_targets[static_cast<std::size_t>(k)];
    if (fault.show && k >= onset) truth = truth * fault.true_turn.transpose();
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

  /// @param good_from of the fault.
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

std::string csv_line(std::uint64_t seed, const std::string& fault, const Judged& judged) {
  const auto& e = judged.overlay.evidence;
  char line[400];
  std::snprintf(line, sizeof line,
                "%d,%s,%d,%d,%.3f,%s,%d,%.3f,%.3f,%.3f,%.4f,%.3f,%.3f,%.3f,%.3f,%.3f,%.2f\n",
                static_cast<int>(seed), fault.c_str(), judged.frame, judged.faulty ? 1 : 0,
                1e3 * judged.error, validity_code(judged.overlay.validity), judged.overlay.pairs,
                1e3 * judged.overlay.residual, e.supported, e.gap, e.behind, 1e3 * e.pull, 1e3 * e.pull_sigma,
                e.contrast, e.motion, e.rows, judged.overlay.milliseconds);
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

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void sum_up(const std::vector<std::string>& names, std::map<std::string, Tally>& tallies, LiveProof& proof) {
  proof.table.emplace_back(
      "fault                shown as               late  >10mm  hidden was    hidden   <3mm   valid %");
  Tally all;
  int late = 0, returned = 0;
  for (const std::string& name : names) {
    const Tally& one = tallies[name];
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
  }
  add_row("all", all, proof);
  proof.figures["live_far_frames"] = all.far;
  proof.figures["live_far_hidden_share"] = share(all.far_hidden, all.far);
  proof.figures["live_far_hidden_before_share"] = share(all.far_hidden_before, all.far);
  proof.figures["live_near_valid_share"] = share(all.near_valid, all.near);
  proof.figures["live_near_sound_valid_share"] = share(all.near_sound_valid, all.near_sound);
  proof.figures["live_latest_seconds"] = late / 30.0;
  for (const auto& [figure, name] :
       {std::pair{"live_still_mean_mm", "none"}, {"live_scope_mean_mm", "scope_moves"}}) {
    const Tally& one = tallies[name];
    if (one.frames > 0) proof.figures[figure] = 1e3 * one.error_sum / one.frames;
  }
  proof.figures["live_return_seconds"] = returned / 30.0;
  proof.figures["live_frame_p50_ms"] = percentile(all.milliseconds, 0.5);
  proof.figures["live_frame_p99_ms"] = percentile(all.milliseconds, 0.99);
}

}  // namespace

void LiveProofOptions::validate() const {
  const OptionCheck demand("live proof options");
  demand(!seeds.empty(), "seeds", 0.0, "Give one at least");
  demand(frames >= 60, "frames", frames, "Give 60 at least");
  demand(onset >= 10 && onset + 20 < frames, "onset", onset, "Give a frame well before the last");
}

Cancellable<LiveProof> prove_live(const LiveProofOptions& options, const std::filesystem::path& folder,
                                  const RunContext& context) {
  options.validate();
  LiveProof proof;
  std::string csv =
      "seed,fault,frame,faulty,error_mm,validity,pairs,residual_mm,supported,gap,behind,pull_mm,"
      "pull_sigma_mm,contrast,motion,rows_px,ms\n";
  std::map<std::string, Tally> tallies;
  std::vector<std::string> names;
  const double part = 1.0 / static_cast<double>(options.seeds.size());
  for (std::size_t s = 0; s < options.seeds.size(); ++s) {
    const double begin = static_cast<double>(s) * part;
    const auto stage = build_stage(options.seeds[s], options.frames, context.part(begin, begin + 0.4 * part));
    if (!stage) return std::nullopt;
    const auto faults =
        live_faults(stage->theatre->rig(), options.onset, options.frames - 1, options.seeds[s]);
    names.clear();
    const RunContext tracking = context.part(begin + 0.4 * part, begin + part);
    for (std::size_t i = 0; i < faults.size(); ++i) {
      if (context.cancelled()) return std::nullopt;
      tracking.progress(static_cast<double>(i) / static_cast<double>(faults.size()), "demo.track");
      if (faults[i].name.find(options.only) == std::string::npos) continue;
      names.push_back(faults[i].name);
      const std::vector<Judged> frames = run(*stage, faults[i], options.onset);
      tallies[faults[i].name].add(frames);
      tallies[faults[i].name].add_return(frames, faults[i].good_from);
      for (const Judged& judged : frames) csv += csv_line(options.seeds[s], faults[i].name, judged);
    }
  }
  sum_up(names, tallies, proof);
  std::string table;
  for (const std::string& line : proof.table) table += line + "\n";
  write_file_atomically(folder / "live.csv", csv);
  write_file_atomically(folder / "live.txt", table);
  return proof;
}

}  // namespace glisson::experiments
