// SPDX-License-Identifier: GPL-3.0-or-later
// From the registered model to the tracked one.
#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/core/numbered_files.h"
#include "glisson/engine/commands/correct_tracking.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_registration.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/register_again.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/undo_correction.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/placed_correction.h"
#include "glisson/experiments/again_every.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/experiments/track_record.h"
#include "glisson/guidance/each_frame.h"
#include "glisson/patient/correction.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "igtl_argument.h"
#include "model_argument.h"
#include "output_folder.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

/// @throws UsageError the pattern holds no number.
NumberedFiles numbered(const QString& pattern) {
  const auto files = NumberedFiles::of(pattern.toStdString());
  if (!files)
    throw UsageError(pattern.toStdString() + ": must hold a number such as %02d, as in 'cloud_%02d.ply'.");
  return *files;
}

/// How many numbers between the first cloud and the last have no cloud.
double missing(const std::vector<std::pair<int, fs::path>>& clouds) {
  return 1.0 + clouds.back().first - clouds.front().first - static_cast<double>(clouds.size());
}

LengthUnit cloud_unit(const Arguments& arguments, LengthUnit of_model) {
  return arguments.has("cloud-unit") ? arguments.unit("cloud-unit") : of_model;
}

/// @param faults of all clouds that were followed.
void follow_clouds(Session& session, const Arguments& arguments, const ModelArgument& argument,
                   const std::vector<std::pair<int, fs::path>>& clouds, experiments::TrackRecord& record,
                   FrameTeller& teller, CloudFaults& faults) {
  const LengthUnit unit = cloud_unit(arguments, argument.unit);
  double done = 0.0;
  for (const auto& [number, path] : clouds) {
    const OverlayFrame overlay =
        session.follow(engine::IndexedCloud{read_cloud(path, unit), number, number / 30.0},
                       ++done / static_cast<double>(clouds.size()));
    faults = overlay.cloud_faults;
    record.add(number, overlay);
    teller.tell(overlay);
  }
}

/// A file of corrections, done after the frames that they name.
class Corrections {
 public:
  /// @param frames of the video; 0: nobody knows.
  Corrections(Session& session, const fs::path& path, int frames) : session_(session), path_(path) {
    if (!path.empty()) lines_ = read_corrections(path);
    for (const CorrectionLine& line : lines_)
      if (line.frame < 0 || (frames > 0 && line.frame >= frames)) refuse(line, frames);
  }
  /// @param frames that the video turned out to have. @throws InputError a line names none of them.
  void end(int frames) const {
    if (next_ < lines_.size()) refuse(lines_[next_], frames);
  }

  void after(int frame, experiments::TrackRecord& record) {
    for (; next_ < lines_.size() && lines_[next_].frame == frame; ++next_) {
      const CorrectionLine& line = lines_[next_];
      if (line.correction) {
        session_.post(engine::CorrectTracking{engine::placed_correction(session_.state(), line, path_)});
        record.add(session_.state()[part::live]->corrections.back());
      } else {
        session_.post(engine::UndoCorrection{});
        record.add_undone(session_.state()[part::live]->overlay);
      }
    }
  }

 private:
  [[noreturn]] void refuse(const CorrectionLine& line, int frames) const {
    throw InputError(path_.string(), "frame " + std::to_string(line.frame), "is not in the video",
                     "Give frames from 0 to " + std::to_string(frames - 1));
  }

  Session& session_;
  fs::path path_;
  std::vector<CorrectionLine> lines_;
  std::size_t next_ = 0;
};

/// Says once what went wrong with a mask network: the organ is followed without it then.
class MaskTeller {
 public:
  void look(const std::optional<engine::MaskStatus>& mask) {
    if (told_ || !mask || mask->problem.empty()) return;
    told_ = true;
    say(Cli::tr("The mask network has failed; the organ is followed without it. %1")
            .arg(ui::error_text(mask->problem)));
  }

 private:
  bool told_ = false;
};

engine::RegisterAgain again_command(const Session& session, const Arguments& arguments) {
  engine::RegisterAgain command;
  command.materials = given_materials(arguments);
  command.fixed_nodes = fixed_nodes(arguments, session);
  return command;
}

void follow_film(Session& session, const Arguments& arguments, experiments::TrackRecord& record,
                 FrameTeller& teller) {
  const auto opened =
      stereo::StereoVideo::open(arguments.path("video"), arguments.path("video-right"), session.context());
  if (!opened) throw Interrupted();
  stereo::StereoVideo& video = **opened;
  Corrections corrections(session, arguments.path("correct"), video.frame_count());
  experiments::AgainEvery again(
      arguments.has("register-again") ? arguments.number("register-again", 1.0, 3600.0) : 0.0,
      again_command(session, arguments), [&](engine::Command command) { session.post(std::move(command)); },
      [&]() -> const engine::CaseState& { return session.state(); });
  MaskTeller mask;
  const guidance::FrameSpan whole;
  const int frames = video.frame_count();
  const auto followed = [&](const StereoFrame& frame) {
    return session.follow(frame, whole.done_with(frame.index, frames));
  };
  int reached = 0;
  const auto take = [&](const StereoFrame& frame, const OverlayFrame& overlay) {
    reached = frame.index + 1;
    record.add(frame.index, overlay);
    mask.look(session.state()[part::live]->mask);
    corrections.after(frame.index, record);
    if (const auto tried = again.after(frame.index, frame.seconds, session.context())) {
      if (tried->line.is_taken) record.go_on_from(*session.state()[part::registration]);
      if (tried->problem.empty())
        record.add(tried->line);
      else
        say(QString::fromStdString(tried->problem));  // the organ is followed from the former registration
    }
    teller.tell(session.state()[part::live]->overlay);  // as corrected
  };
  guidance::each_frame(video, whole, followed, take);
  if (session.context().cancelled()) throw Interrupted();
  session.attempt([&] { corrections.end(reached); });
}

experiments::TrackOutput output_of(const Arguments& arguments, const ModelArgument& argument,
                                   const Session& session, const fs::path& folder) {
  experiments::TrackOutput output;
  output.folder = folder;
  if (arguments.has("clouds")) output.digits = numbered(arguments.value("clouds")).digits();
  if (argument.surface) output.ending = "vtp";
  output.unit = argument.unit;
  const auto rate = session.figures.find("video_frames_per_second");
  if (rate != session.figures.end()) output.frames_per_second = rate->second;
  output.write_mesh = [&](const fs::path& path, const Registration& registration, const NamedArrays& said) {
    write_deformed(path, argument, session, registration, said);
  };
  output.remedy = scene::remedy_text;
  if (arguments.has("truth"))
    output.truth = [files = numbered(arguments.value("truth"))](int frame) { return files.at(frame); };
  return output;
}

/// @throws UsageError not one source, or an option that means nothing to it.
void require_source(const Arguments& arguments) {
  if (arguments.has("video") == arguments.has("clouds"))
    throw UsageError("--video, --clouds: one of them is needed. See 'glisson track --help'.");
  if (arguments.has("correct") && !arguments.has("video"))
    throw UsageError("--correct: needs pictures. Give --video with --calibration.");
  if (arguments.has("register-again") && !arguments.has("video"))
    throw UsageError("--register-again: needs pictures. Give --video with --calibration.");
  if (arguments.has("mask-network") && !arguments.has("video"))
    throw UsageError("--mask-network: needs pictures. Give --video with --calibration.");
  if (arguments.has("clouds"))
    arguments.refuse_idle(QStringLiteral("--clouds"), {"video-right", "calibration", "mask", "mask-every"});
  else
    arguments.refuse_idle(QStringLiteral("--video"), {"cloud-steps", "method"});
  arguments.refuse_without("mask-network", {"mask-every"});
  arguments.refuse_without("register-again", {"cloud"});
  if (!arguments.has("clouds")) arguments.refuse_without("cloud", {"cloud-unit"});
  arguments.require_existing("correct");
}

/// Starts from what was registered, with the clouds' or the video's way of following.
void start_tracking(const Arguments& arguments, Session& session, LengthUnit unit) {
  session.call("start", arguments.required_path("start").string());
  say_stiffness(arguments, session);
  session.post(engine::ImportRegistration{arguments.required_path("start"), unit});
  engine::StartTracking command;
  command.materials = given_materials(arguments);
  command.options.fixed_nodes = fixed_nodes(arguments, session);
  command.options.cloud_method = given_method(arguments);
  command.steps_per_cloud = arguments.integer("cloud-steps", 1, 10000);
  if (arguments.has("clouds")) {
    command.source = engine::StartTracking::Source::clouds;
  } else {
    const fs::path calibration = arguments.required_path("calibration");
    session.post(engine::SetVideo{arguments.path("video"), arguments.path("video-right")});
    session.post(engine::LoadVideoFrame{0, arguments.path("mask")});
    session.post(
        engine::SetCalibration{calibration});  // after the video: its size and its crop are that one's
    if (arguments.has("cloud")) {              // in the frame of this picture and calibration
      session.call("cloud", arguments.path("cloud").string());
      session.post(engine::ImportCloud{arguments.path("cloud"), cloud_unit(arguments, unit)});
    }
    command.mask = {arguments.path("mask-network"), arguments.integer("mask-every", 1, 1000)};
  }
  session.post(command);
}

void declare_track(Arguments& arguments) {
  declare_model(arguments);
  declare_materials(arguments);
  arguments.option("start", Cli::tr("What 'glisson register' wrote for this model and the first frame."),
                   "registered.vtu");
  arguments.option("video", Cli::tr("Stereo video, views side by side."), "V");
  arguments.option("video-right", Cli::tr("The right view, when it is a file of its own."), "V");
  arguments.option("calibration", Cli::tr("OpenCV YAML of the laparoscope."), "C");
  arguments.option("mask", Cli::tr("What of the left picture is tissue (non-zero)."), "M");
  arguments.option(
      "correct",
      Cli::tr("Corrections by hand, a line of JSON each: {\"frame\": 12, \"correct\": {\"view\": "
              "\"left\", \"from\": [480, 270], \"to\": [492, 274]}}: what is drawn at the one "
              "pixel is seen at the other; \"correct\": \"undo\" takes the last one back. What "
              "frames.jsonl says of corrections can be given."),
      "FILE");
  arguments.option(
      "register-again",
      Cli::tr("Registers again every so many seconds of the video, with what has been seen of the organ "
              "since; taken where it is better by tissue that neither registration has used."),
      "SECONDS");
  arguments.option("cloud",
                   Cli::tr("The cloud (PLY) that the start was registered to: --register-again goes on from "
                           "it, with what is marked in it (margin, notch)."),
                   "cloud.ply");
  arguments.option("mask-network",
                   Cli::tr("Your own network (ONNX) that says what of the left picture is not liver; "
                           "MODEL.json beside it says what it wants. It only keeps points from pulling."),
                   "MODEL.onnx");
  arguments.option("mask-every", Cli::tr("Frames between two masks, each of which is waited for."), "N", 1);
  arguments.option("clouds", Cli::tr("Series of clouds instead of a video, e.g. 'cloud_%02d.ply'."),
                   "PATTERN");
  arguments.option("cloud-unit", Cli::tr("Unit of the clouds: mm, cm or m. Without it, the model's."),
                   "UNIT");
  arguments.option(
      "method",
      Cli::tr("How clouds are followed: forces, springs, or automatic, each as in 'glisson register'."),
      "automatic|forces|springs", "automatic");
  arguments.option("cloud-steps", Cli::tr("Steps of the springs towards each cloud."), "N",
                   engine::StartTracking().steps_per_cloud);
  arguments.option("fixed", Cli::tr("Nodes that do not move (0-based numbers)."), "FILE");
  arguments.option(
      "truth",
      Cli::tr("Series of true node positions, e.g. 'truth_%02d.xyz'; may lack frames. Read after "
              "everything else."),
      "PATTERN");
  FrameTeller::declare(arguments);
  arguments.option("out", Cli::tr("The folder for the meshes."), "DIR");
}

}  // namespace

int run_track(const QStringList& given) {
  Arguments arguments("track",
                      Cli::tr("Follows a stereo video, or a series of clouds, from a registered start. "
                              "Every frame is processed; one mesh a frame is written, numbered like its "
                              "input, and a line of frames.jsonl with the level, the reason and the pose. "
                              "What Ctrl-C or an error cuts short is kept and marked INCOMPLETE."));
  declare_track(arguments);
  if (!arguments.parse(given)) return 0;
  FrameTeller teller(arguments);
  OutputFolder out(arguments.required_path("out"));
  require_source(arguments);
  std::vector<std::pair<int, fs::path>> clouds;
  if (arguments.has("clouds")) clouds = numbered(arguments.value("clouds")).existing();
  Session session(arguments);
  const ModelArgument argument = load_model(arguments, session);
  start_tracking(arguments, session, argument.unit);
  const std::shared_ptr<const model::BuiltModel> tracked = session.state()[part::model];
  experiments::TrackRecord record(tracked->model, *session.state()[part::registration],
                                  output_of(arguments, argument, session, out.path()));
  const auto keep = [&](bool whole) {
    record.finish(whole);
    if (!whole && record.frames() == 0) return;
    experiments::remove_former_meshes(arguments.path("out"), out.path());
    out.commit(whole);
  };
  bool whole = false;
  CloudFaults cloud_faults;
  try {
    whole = until_interrupted([&] {
      teller.begin(tracked, session.context());
      if (arguments.has("clouds"))
        follow_clouds(session, arguments, argument, clouds, record, teller, cloud_faults);
      else
        follow_film(session, arguments, record, teller);
    });
  } catch (const Error&) {
    // A broken frame, or a truth that cannot be compared, does not take the others along.
    keep(false);
    if (record.frames() > 0)
      say(Cli::tr("%1 holds what was finished (%2), marked as incomplete.")
              .arg(arguments.value("out"))
              .arg(record.frames()));
    throw;
  }
  keep(whole);
  session.tell(record.figures());
  if (!clouds.empty()) session.tell({{"clouds_missing", missing(clouds)}});
  for (std::string& note : cloud_faults.notes()) session.notes.push_back(std::move(note));
  session.finish();
  if (!whole) throw Interrupted(kept_text(record.frames(), arguments.path("out")));
  return 0;
}

}  // namespace glisson::app
