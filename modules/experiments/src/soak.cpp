// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/soak.h"

#include <algorithm>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/video.h"
#include "glisson/engine/script.h"
#include "glisson/experiments/demo.h"
#include "kill_trial.h"
#include "soak_film.h"
#include "soak_run.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

/// On a day of much work: eight hours of frames, openings, edits.
constexpr double kFramesADay = 8.0 * 3600.0 * 30.0, kOpensADay = 100.0, kEditsADay = 5000.0;

/// Thrown inside a soak that was cancelled; never leaves it.
struct Cancelled {};

class Soak {
 public:
  Soak(const SoakOptions& options, fs::path folder, const DrawOverlay& draw, const RunContext& context)
      : options_(options), folder_(std::move(folder)), draw_(draw), context_(context), script_(context) {}

  SoakResult run() {
    try {
      work();
      result_.complete = true;
    } catch (const Cancelled&) {
      // An hour's figures are worth something, if they say what they are.
    }
    std::erase_if(runs_, [](const SoakRun& run) { return run.is_empty(); });
    if (!result_.complete && runs_.empty()) throw Cancelled();
    for (const SoakRun& run : runs_) add(run.figures());
    result_.page = page();
    // Nothing done proves nothing, nor does a program that was never caught at work.
    const bool was_tried = options_.kills == 0 ? !runs_.empty() : trial_.kills > 0;
    result_.passed =
        result_.complete && was_tried && trial_.passed() &&
        std::all_of(runs_.begin(), runs_.end(), [](const SoakRun& run) { return run.is_flat(); });
    return std::move(result_);
  }

 private:
  void work() {
    patient_ = fs::absolute(options_.patient.empty() ? made_case() : options_.patient);
    post(engine::OpenCase{patient_, engine::OpenCase::Access::read});
    if (options_.frames > 0) follow_frames();
    if (options_.opens > 0) open_and_save();
    if (options_.edits > 0) edit_and_undo();
    if (options_.kills > 0) kill();
  }
  void add(const Figures& figures) {
    for (const auto& [key, value] : figures) result_.figures[key] = value;
  }
  void post(engine::Command command) {
    const auto outcome = script_.run(std::move(command));
    if (!outcome) throw Cancelled();
    add(outcome->figures);
    result_.figures["seconds_" + outcome->command] = outcome->seconds;
  }
  const engine::CaseState& state() const { return script_.state(); }
  /// @param once does it one more time; its number is from 0. @param finish is done at the end, also of one
  /// that is cut short, before Cancelled is thrown.
  void repeat(
      SoakRun run, const std::function<void(int)>& once, const std::function<void()>& finish = [] {}) {
    const auto go_on = [&](int n) {
      if (context_.cancelled()) return false;
      try {
        once(n);
      } catch (const Cancelled&) {
        return false;
      }
      return true;
    };
    runs_.push_back(std::move(run));
    const bool complete = runs_.back().work(go_on);
    finish();
    if (!complete) throw Cancelled();
  }

  /// Where nobody names a case: the synthetic patient with a short film.
  fs::path made_case() {
    constexpr int kFilm = 40;
    DemoOptions options;
    options.theatre.frames = kFilm;
    options.scope = {};  // it stands
    options.theatre.seed = options.clicks.seed = context_.seed();
    const auto made = run_demo(options, folder_, {}, context_);
    if (!made) throw Cancelled();
    return folder_ / made->case_folder.filename();
  }

  void follow_frames() {
    const SoakFilm film(state());
    SoakLosses losses(film);
    post(engine::StartTracking{});
    const auto one = [&](int n) {
      const StereoFrame frame = film.at(n);
      const auto overlay = script_.follow(frame);
      if (!overlay) throw Cancelled();
      losses.add(n, *overlay);
      if (draw_) (void)draw_(state(), frame, *overlay);
      context_.progress((n + 1.0) / options_.frames, "soak.frames");
    };
    repeat({"frames", options_.frames, kFramesADay}, one, [&] {
      add(losses.figures());
      losses_ = losses.table();
    });
  }

  void open_and_save() {
    const fs::path place = folder_ / "soak.glisson";
    post(engine::SaveCase{place});
    repeat({"opens_and_saves", options_.opens, kOpensADay}, [&](int) {
      post(engine::OpenCase{place});
      post(engine::SaveCase{place});
    });
  }

  /// A stroke through the liver's middle, a different one each time, and back.
  void edit_and_undo() {
    engine::require_parts(state(), {part::labels, part::model});
    const Eigen::RowVector3d middle = state()[part::model]->model.surface.mesh.vertices.colwise().mean();
    const LabelVolume before = state()[part::labels]->voxels;
    repeat({"edits", options_.edits, kEditsADay}, [&](int n) {
      editing::Paint paint;
      paint.label = structure::kPortalVein;
      paint.brush = editing::Paint::Brush::ball;
      paint.radius = 4e-3;
      paint.path.resize(2, 3);
      paint.path.row(0) = middle;
      paint.path.row(1) = middle + Eigen::RowVector3d(1e-3 * (n % 20), 1e-3 * (n % 7), 0.0);
      post(engine::EditLabels{{paint, {}}});
      post(engine::UndoLabels{});
    });
    if (!(state()[part::labels]->voxels == before))
      throw Error(
          "edits: the labels are not what they were after as many undos. This is a fault of Glisson.");
  }

  void kill() {
    const fs::path apart = folder_ / "kills";
    fs::create_directory(apart);
    const auto trial = kill_at_work(options_.program, apart, state()[part::video] ? patient_ : fs::path(),
                                    options_.kills, context_);
    if (!trial) throw Cancelled();
    trial_ = *trial;
    add(trial_.figures());
  }

  std::string page() const {
    std::string text =
        "# What the process uses while it works\n\nMeasured by `glisson soak`, on " +
        std::string(options_.patient.empty() ? "the synthetic patient and a film of it (in silico)"
                                             : "a case that was given") +
        ", one process, one kind of work after the other. Sixty samples each of resident memory, file "
        "descriptors and threads; the mean of the second quarter of the run is held against that of the "
        "last. Flat: memory grows by less than 24 MB or 3 %, descriptors and threads not at all. A leak that "
        "this could hide, in kB each time, is held against what a day of much work (eight hours of frames, "
        "100 openings, 5,000 edits) can bear in 2 GB; a run that hides more is too short to say.\n\n" +
        (result_.complete ? "" : "**Interrupted: these figures are of what was done until then.**\n\n") +
        SoakRun::table_head();
    for (const SoakRun& run : runs_) text += run.row();
    text +=
        "\n`frames`: each is followed and drawn with its overlay. `opens_and_saves`: the whole case, read "
        "and written. `edits`: a stroke of the brush and its undo, after which the labels were the same "
        "to the voxel.\n" +
        losses_;
    return trial_.kills == 0 ? text : text + kills_text();
  }

  std::string kills_text() const {
    return "\n## Killed at work\n\nSIGKILL at random moments of `import` (which saves the case) and of "
           "`overlay` (a recording): " +
           std::to_string(trial_.kills) + " kills, " + std::to_string(trial_.littered) +
           " of which left work in progress behind. Neither the old state nor the new one afterwards: " +
           std::to_string(trial_.broken) +
           ". Recordings that were cut off and kept under another name: " + std::to_string(trial_.recovered) +
           ". Anything else left over after the next start: " + std::to_string(trial_.left) + ".\n";
  }

  const SoakOptions& options_;
  fs::path folder_, patient_;
  const DrawOverlay& draw_;
  RunContext context_;
  engine::Script script_;
  std::vector<SoakRun> runs_;
  std::string losses_;
  KillTrial trial_;
  SoakResult result_;
};

}  // namespace

void SoakOptions::validate() const {
  const auto at_least_none = [](const char* name, int times) {
    if (times < 0) throw InputError("soak", name, "must not be negative", "Give 0 or more");
  };
  at_least_none("frames", frames);
  at_least_none("opens", opens);
  at_least_none("edits", edits);
  at_least_none("kills", kills);
  if (kills > 0 && !fs::exists(program))
    throw InputError("soak", "program", "does not exist", "Name the program that is to be killed");
}

Cancellable<SoakResult> soak(const SoakOptions& options, const fs::path& folder, const DrawOverlay& draw,
                             const RunContext& context) {
  options.validate();
  try {
    return Soak(options, folder, draw, context).run();
  } catch (const Cancelled&) {
    return {};
  }
}

}  // namespace glisson::experiments
