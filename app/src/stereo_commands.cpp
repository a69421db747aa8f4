// SPDX-License-Identifier: GPL-3.0-or-later
// From the laparoscope's pictures to its calibration and to labelled clouds: calibrate, reconstruct.
#include <QRegularExpression>
#include <cmath>

#include "cli.h"
#include "commands.h"
#include "glisson/engine/commands/calibrate_rig.h"
#include "glisson/engine/commands/load_stereo_pair.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/stereo/board_series.h"
#include "glisson/stereo/calibrate.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/density.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/texts.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

stereo::Method method_of(const Arguments& arguments) {
  const std::string code = arguments.value("method").toStdString();
  if (const auto method = value_in(stereo::kMethodCodes, code == "auto" ? "automatic" : code)) return *method;
  throw UsageError("--method " + code + ": must be sparse, dense or auto.");
}

stereo::Features features_of(const Arguments& arguments) {
  const std::string code = arguments.value("features").toStdString();
  if (const auto features = value_in(stereo::kFeatureCodes, code)) return *features;
  throw UsageError("--features " + code + ": must be surf, sift or akaze.");
}

/// Two whole numbers with an x between, as 14x10.
std::pair<int, int> two_numbers(const Arguments& arguments, const QString& name) {
  static const QRegularExpression kSize("^(\\d{1,5})x(\\d{1,5})$");
  const QRegularExpressionMatch match = kSize.match(arguments.value(name));
  if (!match.hasMatch())
    throw UsageError("--" + name.toStdString() + " " + arguments.value(name).toStdString() +
                     ": must be two whole numbers, as in 14x10.");
  return {match.captured(1).toInt(), match.captured(2).toInt()};
}

stereo::Board board_of(const Arguments& arguments) {
  stereo::Board board;
  std::tie(board.columns, board.rows) = two_numbers(arguments, "board");
  board.square = 1e-3 * arguments.number("square-mm", 0.1, 200.0);
  if (arguments.has("charuco")) {
    board.dictionary = arguments.value("charuco").toStdString();
    board.marker = 1e-3 * arguments.number("marker-mm", 0.0, 200.0);
  }
  board.validate();
  return board;
}

/// Where the pictures of the board are.
stereo::BoardSearch search_of(const Arguments& arguments) {
  const bool sides = arguments.has("left") || arguments.has("right");
  if (arguments.has("pairs") + arguments.has("video") + sides != 1)
    throw UsageError(
        "glisson calibrate: one of --pairs, --left with --right, and --video is needed. See 'glisson "
        "calibrate --help'.");
  stereo::BoardSearch search;
  search.board = board_of(arguments);
  search.most_views = arguments.integer("most-views", 3, 200);
  search.is_video = arguments.has("video");
  if (sides) {
    search.left = arguments.required_path("left");
    search.right = arguments.required_path("right");
  } else {
    search.left = arguments.path(search.is_video ? "video" : "pairs");
    if (search.is_video) search.right = arguments.path("video-right");
  }
  return search;
}

/// Says what of the pictures shows no board.
stereo::BoardTold told_on_terminal(bool is_video) {
  const auto alone = [](const fs::path& picture) {
    say(Cli::tr("%1: has no partner").arg(QString::fromStdString(picture.string())));
  };
  const auto looked = [is_video](const std::string& name, stereo::BoardViews::Found found) {
    using Found = stereo::BoardViews::Found;
    const QString pair = QString::fromStdString(name);
    switch (found) {
      case Found::both:
        return;
      case Found::left_only:
        return say(Cli::tr("%1: the board is found in the left picture only").arg(pair));
      case Found::right_only:
        return say(Cli::tr("%1: the board is found in the right picture only").arg(pair));
      case Found::neither:
        if (!is_video) say(Cli::tr("%1: no board is found").arg(pair));
    }
  };
  return {alone, looked};
}

/// As the person gave them.
std::string pictures_of(const Arguments& arguments) {
  QStringList given;
  for (const char* option : {"pairs", "left", "right", "video", "video-right"})
    if (arguments.has(option)) given << arguments.value(option);
  return given.join(QStringLiteral(", ")).toStdString();
}

void tell_views(const stereo::Calibration& calibration) {
  say(Cli::tr(
      "view, left px, right px, distance mm, tilt degrees, rows px by a calibration without it, rows px "
      "by the reference"));
  for (const stereo::ViewReport& view : calibration.views) {
    const auto number = [](double value) {
      return std::isfinite(value) ? QString::number(value, 'f', 2) : QStringLiteral("-");
    };
    say(QString("%1 %2 %3 %4 %5 %6 %7%8")
            .arg(QString::fromStdString(view.name), -16)
            .arg(number(view.left_rms), 6)
            .arg(number(view.right_rms), 6)
            .arg(number(1e3 * view.distance), 8)
            .arg(number(view.tilt * 180.0 / M_PI), 6)
            .arg(number(view.epipolar_left_out), 6)
            .arg(number(view.epipolar_reference), 6)
            .arg(!view.used     ? Cli::tr("  left out")
                 : view.outlier ? Cli::tr("  fits far worse than the others: leave it out (--drop-outliers)")
                                : QString()));
  }
}

/// A calibration of plain text is written as YAML.
int convert(const Arguments& arguments, const fs::path& out) {
  Session session(arguments);
  const auto [width, height] = two_numbers(arguments, "size");
  const StereoRig rig =
      stereo::read_text_calibration(arguments.path("text"), width, height, arguments.unit("unit"));
  session.figures["calibration_baseline_mm"] = 1e3 * rig.baseline();
  stereo::write_calibration(out, rig);
  session.finish();
  return 0;
}

void declare_calibrate(Arguments& arguments) {
  arguments.option(
      "pairs",
      Cli::tr("A folder of picture pairs whose names differ in left and right only, or with folders "
              "left and right in it."),
      "FOLDER");
  arguments.option("left", Cli::tr("The left pictures: a folder, or a pattern such as 'shots/left-*.png'."),
                   "P");
  arguments.option("right", Cli::tr("The right pictures, likewise."), "P");
  arguments.option("video", Cli::tr("Stereo video of the board, views side by side."), "V");
  arguments.option("video-right", Cli::tr("The right view, when it is a file of its own."), "V");
  arguments.option("board", Cli::tr("Inner corners of the board, columns and rows."), "NxM", "14x10");
  arguments.option("square-mm", Cli::tr("Side of a square, millimetres."), "MM", 3.0);
  arguments.option("charuco", Cli::tr("A ChArUco board: the dictionary of its markers, as DICT_4X4_50."),
                   "DICT");
  arguments.option("marker-mm", Cli::tr("Side of a ChArUco marker, millimetres."), "MM", 0.0);
  arguments.option("most-views", Cli::tr("Views to use at most; those that differ most are kept."), "N",
                   40.0);
  arguments.option("reference",
                   Cli::tr("Another calibration to compare with: YAML, or a folder of plain text."), "C");
  arguments.flag("drop-outliers", Cli::tr("Leave out the views that fit far worse than the others."));
  arguments.flag("k3", Cli::tr("Estimate the third radial distortion term too."));
  arguments.option("coverage", Cli::tr("Picture of where the boards were, both cameras."), "C.png");
  arguments.option(
      "text",
      Cli::tr("Instead of pictures: a calibration in plain text files (3x3, 4x4), to be written as "
              "YAML; needs --size."),
      "FOLDER");
  arguments.option("size", Cli::tr("Width and height of the pictures, for --text."), "WxH");
  arguments.option("unit", Cli::tr("Unit of the translation in --text: mm, cm or m."), "UNIT", "mm");
  arguments.option("out", Cli::tr("The calibration (OpenCV YAML, mm)."), "C.yaml");
}

/// What would be left unread without a word.
void refuse_idle_options(const Arguments& arguments) {
  if (arguments.has("text")) {
    arguments.refuse_idle(QStringLiteral("--text"),
                          {"pairs", "left", "right", "video", "video-right", "board", "square-mm", "charuco",
                           "marker-mm", "most-views", "reference", "drop-outliers", "k3", "coverage"});
    return;
  }
  arguments.refuse_without("text", {"size", "unit"});
  arguments.refuse_without("video", {"video-right"});
  arguments.refuse_without("charuco", {"marker-mm"});
}

}  // namespace

int run_calibrate(const QStringList& given) {
  Arguments arguments("calibrate",
                      Cli::tr("Calibrates a stereo laparoscope from pictures of a chessboard or ChArUco "
                              "board, and tells how far to trust it."));
  declare_calibrate(arguments);
  if (!arguments.parse(given)) return 0;
  const fs::path out = arguments.output_file("out", {".yaml", ".yml"});
  if (arguments.has("coverage")) arguments.output_file("coverage", {".png", ".jpg", ".bmp"});
  arguments.require_existing("reference");
  refuse_idle_options(arguments);
  if (arguments.has("text")) return convert(arguments, out);
  engine::CalibrateRig command;
  command.search = search_of(arguments);
  Session session(arguments);
  for (const char* name : {"board", "left and right pictures"}) session.call(name, pictures_of(arguments));
  command.told = told_on_terminal(command.search.is_video);
  command.options.third_radial = arguments.has("k3");
  command.options.drop_outliers = arguments.has("drop-outliers");
  command.reference = arguments.path("reference");
  const auto sheet = session.post(std::move(command)).result.as<engine::CalibrationSheet>();
  session.notes = stereo::calibration_doubts(sheet->calibration.rig);  // outliers: the table says them
  tell_views(sheet->calibration);
  stereo::write_calibration(out, sheet->calibration.rig);
  if (arguments.has("coverage")) stereo::write_picture(arguments.path("coverage"), sheet->coverage);
  session.finish();
  return 0;
}

namespace {

void declare_reconstruct(Arguments& arguments) {
  arguments.option("left", Cli::tr("The left picture."), "L");
  arguments.option("right", Cli::tr("The right picture."), "R");
  arguments.option("calibration",
                   Cli::tr("OpenCV YAML: M1 D1 M2 D2 R T image_width image_height unit; or a folder of plain "
                           "text files (3x3, 4x4)."),
                   "C");
  arguments.option("mask", Cli::tr("What of the left picture is tissue (non-zero)."), "M");
  arguments.option(
      "regions", Cli::tr("Clicked regions (JSON): only what lies in one is kept, with its label."), "R.json");
  arguments.option(
      "method",
      Cli::tr("Features (sparse, the paper's), semi-global matching (dense), or auto: dense where "
              "features leave fewer than 0.7 points per cm2."),
      "sparse|dense|auto", "sparse");
  arguments.flag("dense", Cli::tr("The same as --method dense."));
  arguments.option("features", Cli::tr("Kind of features."), "surf|sift|akaze", "surf");
  arguments.option("out", Cli::tr("The cloud (PLY)."), "cloud.ply");
  arguments.option("density",
                   Cli::tr("Picture of where there are enough points, and where they are missing."), "D.png");
  arguments.option("unit", Cli::tr("Unit of the cloud and of --truth: mm, cm or m."), "UNIT", "mm");
  arguments.option("truth",
                   Cli::tr("A surface in the left camera's frame, or its depth map (.pfm, mm): adds the "
                           "distances. Read after everything else."),
                   "FILE");
}

/// Brings calibration, pictures and regions into the session, under the names that the person gave them.
void bring_pair(const Arguments& arguments, Session& session) {
  const engine::SetCalibration calibration{arguments.required_path("calibration")};
  const engine::LoadStereoPair pair{arguments.required_path("left"), arguments.required_path("right"),
                                    arguments.path("mask")};
  for (const char* both : {"stereo pair", "left and right images"})
    session.call(both, pair.left.string() + ", " + pair.right.string());
  session.call("left image", pair.left.string());
  session.call("right image", pair.right.string());
  session.call("mask", pair.mask.string());
  session.call("calibration", calibration.path.string());
  session.call("regions", arguments.path("regions").string());
  // Plain text does not tell the pictures' size: they come first then.
  const bool plain_text = stereo::is_text_calibration(calibration.path);
  if (!plain_text) session.post(calibration);
  session.post(pair);
  if (plain_text) session.post(calibration);
  if (arguments.has("regions"))
    session.post(engine::SetRegions{stereo::read_regions(arguments.path("regions"))});
}

/// How far off the cloud is, where its truth is given, and where its points are dense enough.
void tell_cloud(const Arguments& arguments, Session& session) {
  const stereo::DensityMap& density = session.state()[part::points]->density;
  session.tell(stereo::density_figures(density));
  if (arguments.has("density"))
    stereo::write_picture(arguments.path("density"),
                          stereo::density_picture(density, session.state()[part::frame]->frame.left));
  if (arguments.has("truth"))
    session.attempt([&] {
      session.figures.merge(experiments::cloud_figures(*session.state()[part::cloud],
                                                       session.state()[part::rig]->left,
                                                       arguments.path("truth"), arguments.unit("unit")));
    });
}

}  // namespace

int run_reconstruct(const QStringList& given) {
  Arguments arguments("reconstruct",
                      Cli::tr("Turns a stereo pair into a labelled cloud in the left camera's frame."));
  declare_reconstruct(arguments);
  if (!arguments.parse(given)) return 0;
  const fs::path out = arguments.output_file("out", {".ply"});
  if (arguments.has("density")) arguments.output_file("density", {".png", ".jpg", ".bmp"});
  if (arguments.has("dense")) arguments.refuse_idle(QStringLiteral("--dense"), {"method"});
  arguments.require_existing("truth");
  const LengthUnit unit = arguments.unit("unit");
  Session session(arguments);
  bring_pair(arguments, session);
  engine::Reconstruct command;
  command.options.method = arguments.has("dense") ? stereo::Method::dense : method_of(arguments);
  command.options.kind = features_of(arguments);
  session.post(command);
  write_cloud(out, *session.state()[part::cloud], unit);
  tell_cloud(arguments, session);
  session.finish();
  return 0;
}

int run_check(const QStringList& given) {
  Arguments arguments(
      "check",
      Cli::tr("Looks through a stereo video for faults: black, frozen, duplicated, swapped "
              "or exchanged frames, a lost camera, interlaced rows, a calibration of another scope."));
  arguments.option(
      "video", Cli::tr("Stereo video, folder of picture pairs, or description of a source (.json)."), "V");
  arguments.option("video-right", Cli::tr("The right view, when it is a file of its own."), "V");
  arguments.option("calibration", Cli::tr("OpenCV YAML of the laparoscope, or a folder of plain text."), "C");
  arguments.option("every", Cli::tr("Hold each N-th frame against the calibration."), "N", 30.0);
  if (!arguments.parse(given)) return 0;
  Session session(arguments);
  stereo::StereoVideo video(arguments.required_path("video"), arguments.path("video-right"));
  std::optional<StereoRig> rig;
  if (arguments.has("calibration"))
    rig = stereo::read_calibration_for(arguments.path("calibration"), video.width(), video.height(),
                                       video.cut());
  stereo::VideoCheckOptions options;
  options.every = arguments.integer("every", 1, 100000);
  const auto tell = [](const stereo::FrameFault& fault) {
    say(Cli::tr("frame %1: %2").arg(fault.frame).arg(ui::note_text(stereo::fault_note(fault.fault))));
  };
  const auto found = stereo::check_video(video, rig, options, session.context(), tell);
  if (!found) throw Interrupted();
  for (const stereo::FrameFault& fault : found->faults)
    session.figures["fault_" + std::string(stereo::fault_code(fault.fault))] += 1.0;
  session.figures["frames"] = found->frames;
  session.figures["frames_skipped"] = found->skipped;
  session.figures["faults"] = static_cast<double>(found->faults.size());
  session.finish();
  return found->faults.empty() ? 0 : 1;
}

}  // namespace glisson::app
