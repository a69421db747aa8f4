// SPDX-License-Identifier: GPL-3.0-or-later
// What can be looked at: render, overlay.
#include <algorithm>
#include <string>
#include <vector>

#include "cli.h"
#include "commands.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/named_video.h"
#include "glisson/engine/parts/video.h"
#include "glisson/experiments/track_evaluation.h"
#include "glisson/guidance/lesion_meter.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/told_overlay.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reach.h"
#include "glisson/ui/scene/model_surfaces.h"
#include "glisson/ui/scene/montage.h"
#include "live_overlay.h"

namespace glisson::app {

namespace {

Label lesion_named(const QString& name) {
  const std::optional<Label> label = structure_named(name.toStdString());
  if (!label || !is_lesion(*label))
    throw UsageError("--lesion " + name.toStdString() + ": is no lesion. Give lesion_1 and so on.");
  return *label;
}

Eigen::Vector2d pixel_named(const QString& text) {
  const QStringList numbers = text.split(QLatin1Char(','));
  bool is_u = false, is_v = false;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  if (numbers.size() == 2) pixel = {numbers[0].toDouble(&is_u), numbers[1].toDouble(&is_v)};
  if (!is_u || !is_v || !pixel.allFinite())
    throw UsageError("--mark " + text.toStdString() + ": is no pixel. Give two numbers, as 480,270.");
  return pixel;
}

/// @throws UsageError the model has no such lesion: a picture without numbers would be all that says so.
void require_lesion(Label lesion, const engine::CaseState& state) {
  if (lesion == 0 || !state[part::model]) return;
  QStringList lesions;
  for (const Label label : scene::inner_structures(state[part::model]->model)) {
    if (label == lesion) return;
    if (is_lesion(label)) lesions << QString::fromStdString(structure_name(label));
  }
  throw UsageError(Cli::tr("--lesion %1: is not in this model. Its lesions: %2.")
                       .arg(QString::fromStdString(structure_name(lesion)),
                            lesions.isEmpty() ? QStringLiteral("–") : lesions.join(QStringLiteral(", ")))
                       .toStdString());
}

constexpr const char* kAllLooks = "all";  ///< side by side, for `render`

void declare_look(Arguments& arguments, bool with_all = false) {
  QStringList codes;
  for (const scene::Look look : scene::kLooks) codes << scene::look_code(look);
  if (with_all) codes << kAllLooks;
  arguments.option("look", Cli::tr("How depth is told: %1.").arg(codes.join(", ")), "NAME",
                   scene::look_code(scene::OverlayStyle().look));
  arguments.flag("thin-branches", Cli::tr("Draw thin distal branches of vessels, too."));
  arguments.option("lesion", Cli::tr("Look at this lesion and tell its numbers, as lesion_1."), "NAME");
}

scene::OverlayStyle style_of(const Arguments& arguments, bool with_all = false) {
  scene::OverlayStyle style;
  style.thin_branches = arguments.has("thin-branches");
  for (const scene::Look look : scene::kLooks) {
    style.look = look;
    if (arguments.value("look") == scene::look_code(look)) return style;
  }
  if (with_all && arguments.value("look") == kAllLooks) {
    style.look = scene::OverlayStyle().look;
    return style;
  }
  throw UsageError("--look " + arguments.value("look").toStdString() + ": is none of the looks. See --help.");
}

/// One frame in each of the looks, side by side.
Picture all_looks(OverlayDrawer& drawer, scene::OverlayStyle style, const StereoFrame& frame,
                  const OverlayFrame& overlay, const scene::OverlayInterest& interest) {
  constexpr double kScale = 0.75;  // the words stay readable
  std::vector<scene::NamedPicture> pictures;
  for (const scene::Look look : scene::kLooks) {
    style.look = look;
    drawer.set_style(style);
    pictures.push_back({scene::look_code(look), drawer.draw(frame, overlay, interest)});
  }
  return scene::montage(pictures, 2, kScale);
}

/// What the person wants to know.
struct Question {
  Label lesion = 0;
  std::optional<Eigen::Vector2d> mark;  ///< pixel

  explicit Question(const Arguments& arguments, bool with_mark = true) {
    if (arguments.has("lesion")) lesion = lesion_named(arguments.value("lesion"));
    if (with_mark && arguments.has("mark")) mark = pixel_named(arguments.value("mark"));
  }
  scene::OverlayInterest interest(const OverlayDrawer& drawer, const OverlayFrame& overlay) const {
    scene::OverlayInterest interest;
    interest.lesion = lesion;
    if (mark) interest.place = drawer.place_at(*mark, overlay);
    if (mark && !interest.place && overlay.level() != Level::withdrawn)
      throw InputError("--mark", "the pixel", "is beside the organ", "Give one on it");
    return interest;
  }
};

void declare_track(Arguments& arguments) {
  arguments.option(
      "track",
      Cli::tr(
          "A folder that 'glisson track' filled for this case and video, or NAME.frames.jsonl that the "
          "window wrote beside a recording: what was known then is drawn again, and nothing is followed."),
      "DIR|FILE");
  arguments.option(
      "recording",
      Cli::tr("The raw views that were recorded with --track's file: drawn into instead of the case's video, "
              "as of a live device."),
      "V");
}

void declare_case(Arguments& arguments) {
  arguments.option("case", Cli::tr("The case's folder, NAME.glisson, with a registration and a video."),
                   "CASE");
  arguments.option(
      "video",
      Cli::tr("The case's video, where it is opened without it: it lies outside of the case, and "
              "nobody here has chosen it yet."),
      "V");
  arguments.option("video-right", Cli::tr("The right view, when it is a file of its own."), "V");
}

/// For reading. The person's own word on the video comes first, so that the case opens with it; it holds,
/// too, where the video lies elsewhere now, or nothing can be remembered.
void open_with_video(const Arguments& arguments, Session& session) {
  arguments.refuse_without("video", {"video-right"});
  const std::filesystem::path left = arguments.path("video"), right = arguments.path("video-right");
  stereo::remember_sources({left.string(), right.string()});
  session.call("case", arguments.required_path("case").string());
  session.post(engine::OpenCase{arguments.required_path("case"), engine::OpenCase::Access::read});
  const auto& held = session.state()[part::video];
  const auto is_held = [](const std::filesystem::path& view, const std::filesystem::path& given) {
    return view.empty() || given.empty() ? view == given : is_same_place(view, given);
  };
  if (arguments.has("video") && !(held && is_held(held->left, left) && is_held(held->right, right)))
    session.post(engine::SetVideo{left, right});
}

/// @throws InputError the case names a video that nobody here has chosen.
void require_chosen_video(const Arguments& arguments, const engine::CaseState& state) {
  const std::vector<std::string> named = engine::named_sources(state);
  if (named.empty() || state[part::video]) return;
  QStringList sources;
  for (const std::string& source : named) sources << QString::fromStdString(source);
  throw InputError(arguments.path("case").string(), "video",
                   "names pictures that nobody here has chosen (" + sources.join(", ").toStdString() + ")",
                   "Give them by --video, if you trust the case");
}

/// What --track and --recording name, if they are given.
struct Replayed {
  std::optional<TrackReplay> track;
  engine::VideoSource video;

  Replayed(const Arguments& arguments, const Session& session) {
    const bool is_recorded = arguments.has("recording");
    if (is_recorded && !arguments.has("track"))
      throw UsageError("--recording: needs what was known. Give --track NAME.frames.jsonl.");
    if (!is_recorded) require_chosen_video(arguments, session.state());
    if (is_recorded)
      video = {arguments.path("recording"), {}};
    else if (session.state()[part::video])
      video = *session.state()[part::video];
    if (!arguments.has("track")) return;
    session.need({part::model});
    if (!is_recorded) session.need({part::video});
    track.emplace(arguments.path("track"), session.state()[part::model]->model.mesh.vertex_count(),
                  is_recorded ? TrackReplay::Frames::of_the_recording : TrackReplay::Frames::of_the_source);
    first = is_recorded ? 0 : track->first();
  }
  int first = 0;  ///< number of the track's first frame
};

/// Hands over each frame with what is known of it: from a track's record, or by following the video.
void show_video(Session& session, const Replayed& replayed, int last, const guidance::FrameTaker& frame) {
  if (replayed.track)
    replay_video(session, *replayed.track, replayed.video, last, frame);
  else
    follow_video(session, {}, last, frame);
}

}  // namespace

int run_render(const QStringList& given) {
  Arguments arguments(
      "render",
      Cli::tr(
          "Draws one frame of the case's video with vessels and tumours, followed from the registered frame. "
          "Where the position is not known, the picture says so and shows no overlay."));
  declare_case(arguments);
  arguments.option("frame", Cli::tr("Number of the frame, from 0."), "N", "0");
  arguments.option("out", Cli::tr("The picture (.png, .jpg)."), "picture.png");
  declare_look(arguments, true);
  declare_track(arguments);
  arguments.option(
      "mark",
      Cli::tr("A pixel of the left picture where a tool touches the organ: the lesion's distance "
              "from there is told, too."),
      "U,V");
  if (!arguments.parse(given)) return 0;
  const std::filesystem::path out = arguments.output_file("out", {".png", ".jpg", ".jpeg"});
  const int wanted = arguments.integer("frame", 0, 10000000);
  const Question question(arguments);
  const scene::OverlayStyle style = style_of(arguments, true);
  Session session(arguments);
  open_with_video(arguments, session);
  require_lesion(question.lesion, session.state());
  Picture picture;
  const Replayed replayed(arguments, session);
  show_video(session, replayed, wanted, [&](const StereoFrame& frame, const OverlayFrame& overlay) {
    if (frame.index != wanted) return;
    OverlayDrawer drawer(session.state(), style);
    const scene::OverlayInterest interest = question.interest(drawer, overlay);
    picture = arguments.value("look") == kAllLooks ? all_looks(drawer, style, frame, overlay, interest)
                                                   : drawer.draw(frame, overlay, interest);
    if (const auto& measures = drawer.measures()) session.tell(guidance::measure_figures(*measures));
    const ToldOverlay of_frame = told(overlay);
    session.tell(of_frame.figures);
    for (const auto& [key, text] : of_frame.texts) session.texts[key] = text;
    if (overlay.level() != Level::valid) session.texts["remedy"] = scene::remedy_text(overlay.validity);
    session.figures["registration_residual_mm"] = 1e3 * overlay.residual;
  });
  if (picture.empty())
    throw InputError(arguments.path("case").string(), "frame " + std::to_string(wanted),
                     replayed.track ? "is not in the video, or was not tracked"
                                    : "is not in the video, or lies before the registered frame",
                     replayed.track ? "Choose a frame that was tracked"
                                    : "Choose a frame between the registered one and the video's end");
  stereo::write_picture(out, picture);
  session.finish();
  return 0;
}

int run_overlay(const QStringList& given) {
  Arguments arguments("overlay",
                      Cli::tr("Follows the case's video and records it with vessels and tumours drawn in."));
  declare_case(arguments);
  arguments.option("frames", Cli::tr("Record only so many frames."), "N");
  arguments.option("out", Cli::tr("The video (.mkv)."), "overlay.mkv");
  declare_look(arguments);
  declare_track(arguments);
  if (!arguments.parse(given)) return 0;
  const std::filesystem::path out = arguments.output_file("out", {".mkv"});
  const scene::OverlayStyle style = style_of(arguments);
  scene::OverlayInterest interest;
  interest.lesion = Question(arguments, false).lesion;
  Session session(arguments);
  open_with_video(arguments, session);
  require_lesion(interest.lesion, session.state());
  const Replayed replayed(arguments, session);
  if (!arguments.has("recording")) session.need({part::video});
  for (const std::filesystem::path& read : {replayed.video.left, replayed.video.right})
    if (!read.empty() && is_same_place(out, read))
      throw FileError(Cli::tr("%1: is the video that is drawn into. Choose another name.")
                          .arg(QString::fromStdString(out.string()))
                          .toStdString());
  const double rate = stereo::StereoVideo(replayed.video.left, replayed.video.right).frames_per_second();
  const std::optional<TrackReplay>& replay = replayed.track;
  OverlayRecorder recorder(session.state(), out, rate, style, interest, replay && replay->is_recording());
  const int first = replay                         ? replayed.first
                    : session.state()[part::frame] ? session.state()[part::frame]->frame.index
                                                   : 0;
  const int last = arguments.has("frames") ? first + arguments.integer("frames", 1, 10000000) - 1 : -1;
  experiments::FrameTimes times(rate);
  double drawing = 0.0;
  bool whole = false;
  try {
    whole = until_interrupted([&] {
      show_video(session, replayed, last, [&](const StereoFrame& frame, const OverlayFrame& overlay) {
        drawing += recorder.add(frame, overlay);
        times.add(overlay);
      });
    });
  } catch (const Error&) {
    if (times.frames() > 0) recorder.keep();
    throw;
  }
  if (!whole && times.frames() == 0) throw Interrupted();
  if (times.frames() == 0)
    throw InputError(arguments.path("case").string(), "video", "has no frame to be drawn",
                     "Give a track of this video, or register a frame that is not its last");
  recorder.finish(whole);
  // What was cut short is not whole when it is drawn again.
  session.figures["complete"] = whole && (!replay || replay->is_complete()) ? 1.0 : 0.0;
  session.figures.merge(times.counts());
  session.figures["draw_mean_ms"] = drawing / std::max(1, times.frames());
  session.finish();
  if (!whole) throw Interrupted(kept_text(times.frames(), recorder.unfinished()));
  return 0;
}

}  // namespace glisson::app
