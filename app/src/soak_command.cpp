// SPDX-License-Identifier: GPL-3.0-or-later
// The same work over and over: what a process uses must not grow with it.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numeric>

#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/core/files.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/video.h"
#include "glisson/experiments/demo.h"
#include "kill_trial.h"
#include "live_overlay.h"
#include "soak_film.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

/// What the process uses now.
struct Usage {
  double memory_mb = 0.0;  ///< resident
  double descriptors = 0.0, threads = 0.0;
};

Usage usage_now() {
  Usage usage;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double value = 0.0;
    if (word == "VmRSS:" && status >> value) usage.memory_mb = value / 1024.0;
    if (word == "Threads:" && status >> value) usage.threads = value;
  }
  std::error_code ignored;
  for (auto entry = fs::directory_iterator("/proc/self/fd", ignored); entry != fs::directory_iterator();
       entry.increment(ignored))
    usage.descriptors += 1.0;
  return usage;
}

constexpr int kSamples = 60;
/// Memory that the allocator keeps from one moment to the next is no leak; what grows by more is one.
constexpr double kGrowthMb = 24.0, kGrowthShare = 0.03;
/// What a day's work may take before a computer is short of memory.
constexpr double kDayMb = 2000.0;

/// One kind of work, over and over.
class Run {
 public:
  /// @param a_day how often it is done on a day of much work.
  Run(std::string name, int times, double a_day) : name_(std::move(name)), times_(times), a_day_(a_day) {}

  void work(const std::function<void(int)>& once) {
    const int every = std::max(1, times_ / kSamples);
    const auto begin = std::chrono::steady_clock::now();
    for (int n = 0; n < times_; ++n) {
      once(n);
      if ((n + 1) % every == 0) samples_.push_back(usage_now());
    }
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  /// The first quarter fills what is kept for later use: the second is compared with the last.
  double early(double Usage::*kind) const { return mean(kind, 1); }
  double late(double Usage::*kind) const { return mean(kind, 3); }
  double most(double Usage::*kind) const {
    double most = 0.0;
    for (const Usage& sample : samples_) most = std::max(most, sample.*kind);
    return most;
  }
  bool is_empty() const { return samples_.empty(); }
  bool is_flat() const {
    return is_long_enough() && late(&Usage::memory_mb) - early(&Usage::memory_mb) < allowed_mb() &&
           late(&Usage::descriptors) < early(&Usage::descriptors) + 1.0 &&
           late(&Usage::threads) < early(&Usage::threads) + 1.0;
  }
  /// The smallest leak that this run shows, kB each time: half of it lies between the two quarters.
  double shows_kb() const { return 1e3 * allowed_mb() / (0.5 * times_); }
  /// What one more time may cost if a day's work is to fit.
  double bearable_kb() const { return 1e3 * kDayMb / a_day_; }
  /// A run that would not have shown a leak which fills the memory in a day says nothing.
  bool is_long_enough() const { return shows_kb() <= bearable_kb(); }
  const char* verdict() const {
    return !is_long_enough() ? "too short to say" : is_flat() ? "yes" : "**no**";
  }
  void tell(Figures& figures) const {
    figures["soak_" + name_] = times_;
    figures["soak_" + name_ + "_seconds"] = seconds_;
    figures["soak_" + name_ + "_growth_mb"] = late(&Usage::memory_mb) - early(&Usage::memory_mb);
    figures["soak_" + name_ + "_shows_kb"] = shows_kb();
    figures["soak_" + name_ + "_long_enough"] = is_long_enough() ? 1.0 : 0.0;
    figures["soak_" + name_ + "_flat"] = is_flat() ? 1.0 : 0.0;
  }
  std::string row() const {
    const auto number = [](double value, int digits) {
      return QString::number(value, 'f', digits).toStdString();
    };
    std::string row = "| " + name_ + " | " + std::to_string(times_) + " | " + number(seconds_, 0) + " | ";
    row += number(early(&Usage::memory_mb), 0) + " | " + number(late(&Usage::memory_mb), 0) + " | " +
           number(most(&Usage::memory_mb), 0) + " | ";
    row += number(early(&Usage::descriptors), 1) + " -> " + number(late(&Usage::descriptors), 1) + " | ";
    row += number(early(&Usage::threads), 1) + " -> " + number(late(&Usage::threads), 1) + " | ";
    row += number(shows_kb(), 1) + " of " + number(bearable_kb(), 1) + " | ";
    return row + verdict() + " |\n";
  }

 private:
  /// @param quarter from 0.
  double mean(double Usage::*kind, std::size_t quarter) const {
    const std::size_t from = samples_.size() * quarter / 4, to = samples_.size() * (quarter + 1) / 4;
    double sum = 0.0;
    for (std::size_t n = from; n < to; ++n) sum += samples_[n].*kind;
    return sum / static_cast<double>(std::max<std::size_t>(1, to - from));
  }

  double allowed_mb() const { return std::max(kGrowthMb, kGrowthShare * early(&Usage::memory_mb)); }

  std::string name_;
  int times_;
  double a_day_ = 1.0;
  double seconds_ = 0.0;
  std::vector<Usage> samples_;
};

/// Where nobody names a case: the synthetic patient with a short film.
fs::path made_case(const fs::path& folder, const Session& session) {
  constexpr int kFilm = 40;
  experiments::DemoOptions options;
  options.theatre.frames = kFilm;
  options.theatre.seed = options.clicks.seed = session.context().seed();
  const auto made = experiments::run_demo(options, folder, {}, session.context());
  if (!made) throw Interrupted();
  return folder / made->case_folder.filename();
}

/// @return what was lost, as a table.
std::string follow_frames(Session& session, Run& run, int times) {
  const SoakFilm film(session.state());
  SoakLosses losses(film);
  session.post(engine::StartTracking{});
  OverlayDrawer drawer(session.state());
  run.work([&](int n) {
    const StereoFrame frame = film.at(n);
    const OverlayFrame overlay = session.follow(frame, (n + 1.0) / times);
    losses.add(n, overlay);
    (void)drawer.draw(frame, overlay);
  });
  losses.tell(session.figures);
  return losses.table();
}

void open_and_save(Session& session, Run& run, const fs::path& place) {
  session.post(engine::SaveCase{place});
  run.work([&](int) {
    session.post(engine::OpenCase{place});
    session.post(engine::SaveCase{place});
  });
}

/// A stroke through the liver's middle, a different one each time, and back.
void edit_and_undo(Session& session, Run& run) {
  session.need({part::labels, part::model});
  const Eigen::RowVector3d middle =
      session.state()[part::model]->model.surface.mesh.vertices.colwise().mean();
  const LabelVolume before = session.state()[part::labels]->voxels;
  run.work([&](int n) {
    editing::Paint paint;
    paint.label = structure::kPortalVein;
    paint.brush = editing::Paint::Brush::ball;
    paint.radius = 4e-3;
    paint.path.resize(2, 3);
    paint.path.row(0) = middle;
    paint.path.row(1) = middle + Eigen::RowVector3d(1e-3 * (n % 20), 1e-3 * (n % 7), 0.0);
    session.post(engine::EditLabels{{paint, {}}});
    session.post(engine::UndoLabels{});
  });
  if (!(session.state()[part::labels]->voxels == before))
    throw Error("edits: the labels are not what they were after as many undos. This is a fault of Glisson.");
}

void tell(const KillTrial& trial, Figures& figures) {
  figures["kill_times"] = trial.kills;
  figures["kill_came_through"] = trial.came_through;
  figures["kill_littered"] = trial.littered;
  figures["kill_recovered"] = trial.recovered;
  figures["kill_broken"] = trial.broken;
  figures["kill_left"] = trial.left;
}

std::string page(const std::vector<Run>& runs, const std::string& losses, const KillTrial& trial,
                 const fs::path& patient) {
  std::string text =
      "# What the process uses while it works\n\nMeasured by `glisson soak`, on " +
      std::string(patient.empty() ? "the synthetic patient and a film of it (in silico)"
                                  : "a case that was given") +
      ", one process, one kind of work after the other. Sixty samples each of resident memory, file "
      "descriptors "
      "and threads; the mean of the second quarter of the run is held against that of the last. Flat: memory "
      "grows by less than 24 MB or 3 %, descriptors and threads not at all. A leak that this could hide, in "
      "kB each "
      "time, is held against what a day of much work (eight hours of frames, 100 openings, 5,000 edits) can "
      "bear in "
      "2 GB; a run that hides more is too short to say.\n\n"
      "| work | times | s | memory early, MB | late, MB | most, MB | descriptors | threads | hides, kB | "
      "flat |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Run& run : runs) text += run.row();
  text +=
      "\n`frames`: each is followed and drawn with its overlay. `opens_and_saves`: the whole case, read "
      "and written. `edits`: a stroke of the brush and its undo, after which the labels were the same "
      "to the voxel.\n" +
      losses;
  if (trial.kills == 0) return text;
  return text +
         "\n## Killed at work\n\nSIGKILL at random moments of `import` (which saves the case) and of "
         "`overlay` (a recording): " +
         std::to_string(trial.kills) + " kills, " + std::to_string(trial.littered) +
         " of which left work in progress behind. Neither the old state nor the new one afterwards: " +
         std::to_string(trial.broken) +
         ". Recordings that were cut off and kept under another name: " + std::to_string(trial.recovered) +
         ". Anything else left over after the next start: " + std::to_string(trial.left) + ".\n";
}

}  // namespace

int run_soak(const QStringList& given) {
  Arguments arguments("soak",
                      Cli::tr("Does the same over and over, frames, opening and saving, edits with undo, "
                              "and looks whether memory, file descriptors and threads stay what they are."));
  arguments.option("case", Cli::tr("A case with a video and a registration; else one is made."), "CASE");
  arguments.option("frames", Cli::tr("Frames to follow and draw."), "N", 100000.0);
  arguments.option("opens", Cli::tr("Times to open and save the case."), "N", 1000.0);
  arguments.option("edits", Cli::tr("Edits with their undo."), "N", 1000.0);
  arguments.option("kills",
                   Cli::tr("Times to kill the program at work (import, save, record) and look what is left."),
                   "N", 0.0);
  arguments.option("page", Cli::tr("Also write the figures here, as a page."), "FILE.md");
  if (!arguments.parse(given)) return 0;
  const int frames = arguments.integer("frames", 0, 100000000),
            opens = arguments.integer("opens", 0, 1000000), edits = arguments.integer("edits", 0, 10000000),
            kills = arguments.integer("kills", 0, 100000);
  if (arguments.has("page")) arguments.output_file("page", {".md"});
  const TemporaryFolder folder;
  Session session(arguments);
  const fs::path named = arguments.path("case");
  const fs::path patient = fs::absolute(named.empty() ? made_case(folder.path(), session) : named);
  session.post(engine::OpenCase{patient, engine::OpenCase::Access::read});
  std::vector<Run> runs = {
      {"frames", frames, 8.0 * 3600.0 * 30.0}, {"opens_and_saves", opens, 100.0}, {"edits", edits, 5000.0}};
  std::string losses;
  if (frames > 0) losses = follow_frames(session, runs[0], frames);
  if (opens > 0) open_and_save(session, runs[1], folder.path() / "soak.glisson");
  if (edits > 0) edit_and_undo(session, runs[2]);
  KillTrial trial;
  if (kills > 0) {
    const TemporaryFolder apart;
    trial = kill_at_work(apart.path(), session.state()[part::video] ? patient : fs::path(), kills,
                         session.context());
    tell(trial, session.figures);
  }
  std::erase_if(runs, [](const Run& run) { return run.is_empty(); });
  for (const Run& run : runs) run.tell(session.figures);
  session.notes.clear();
  session.finish();
  const std::string text = page(runs, losses, trial, named);
  say(QString::fromStdString(text));
  if (arguments.has("page")) write_file_atomically(arguments.path("page"), text);
  return std::all_of(runs.begin(), runs.end(), [](const Run& run) { return run.is_flat(); }) &&
                 trial.broken == 0 && trial.left == 0
             ? kDone
             : kFailed;
}

}  // namespace glisson::app
