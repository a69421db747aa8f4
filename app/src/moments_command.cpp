// SPDX-License-Identifier: GPL-3.0-or-later
// What a case keeps of moments of the live view.
#include <cmath>

#include "case_argument.h"
#include "cli.h"
#include "commands.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/moment_export.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/moments.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/guidance/lesion_meter.h"
#include "glisson/patient/told_overlay.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "glisson/ui/common/overlay_status.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "output_folder.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

std::string name_of(const engine::KeptMoment& moment) {
  return QStringLiteral("moment_%1").arg(moment.number, 4, 10, QLatin1Char('0')).toStdString();
}

void say_row(const engine::KeptMoment& moment) {
  const OverlayFrame& overlay = moment.overlay;
  QString state = QString::fromLatin1(level_code(overlay.level()));
  if (overlay.level() != Level::valid)
    state += QStringLiteral(": ") + QString::fromStdString(scene::validity_text(overlay.validity));
  say(QStringLiteral("%1  %2  %3 s  %4  %5  %6")
          .arg(moment.number, 4)
          .arg(overlay.index, 7)
          .arg(overlay.seconds, 9, 'f', 2)
          .arg(QString::fromStdString(moment.kept_at), -20)
          .arg(state, -10)
          .arg(QString::fromStdString(moment.title)));
}

/// The same for --json: flat keys.
void tell(const engine::KeptMoment& moment, Session& session) {
  const std::string name = "moment_" + std::to_string(moment.number) + '_';
  const auto add = [&](const Figures& figures) {
    for (const auto& [key, value] : figures)
      if (std::isfinite(value)) session.figures[name + key] = value;
  };
  const ToldOverlay overlay = told(moment.overlay);
  session.figures[name + "frame"] = moment.overlay.index;
  session.figures[name + "time_s"] = moment.overlay.seconds;
  add({{"residual_mm", 1e3 * moment.overlay.residual}});
  add(overlay.figures);
  if (moment.measures) add(guidance::measure_figures(*moment.measures));
  session.texts[name + "kept_at"] = moment.kept_at;
  session.texts[name + "title"] = moment.title;
  for (const auto& [key, text] : overlay.texts) session.texts[name + key] = text;
}

/// Draws moments again, as they were.
class MomentDrawer {
 public:
  explicit MomentDrawer(const engine::CaseState& state) : state_(state) {}

  /// @pre is_drawn_as_it_was(). @param left its left picture.
  Picture draw(const engine::KeptMoment& moment, const Picture& left) {
    if (!drawable_)
      drawable_ = scene::make_drawable(std::make_shared<const PatientModel>(engine::effective_model(state_)));
    scene::OverlayPainter painter(drawable_, moment.margin, state_[part::rig]->left);
    return painter.paint(left, moment.overlay, ui::overlay_status(moment), {moment.chosen, moment.place, {}});
  }

 private:
  const engine::CaseState& state_;
  std::shared_ptr<const scene::DrawableModel> drawable_;
};

/// @return how many have no overlay, because model or calibration are others by now.
int write_moments(const Session& session, const engine::KeptMoments& kept, const fs::path& folder) {
  MomentDrawer drawer(session.state());
  stereo::PictureReader pictures;
  int without = 0;
  double done = 0.0;
  for (const auto& moment : kept.moments) {
    if (session.context().cancelled()) throw Interrupted();
    const std::string name = name_of(*moment);
    const bool is_drawn = engine::is_drawn_as_it_was(session.state(), *moment);
    engine::export_moment(folder, name, *moment, is_drawn);
    const Picture left = pictures.decode(*moment->left_png, name + "_left.png");
    if (is_drawn)
      stereo::write_picture(folder / (name + "_overlay.png"), drawer.draw(*moment, left));
    else
      ++without;
    session.context().progress(++done / static_cast<double>(kept.moments.size()), "case.write");
  }
  return without;
}

}  // namespace

int run_moments(const QStringList& given) {
  Arguments arguments("moments",
                      Cli::tr("Lists the moments of the live view that a case keeps: number, frame, time in "
                              "the video, when it was kept, level, title. With --out it writes them: of each "
                              "the picture with its overlay, both raw pictures, and what was known (JSON). "
                              "No file names the patient, but a title may."));
  declare_case(arguments);
  arguments.option("out", Cli::tr("A folder for the pictures; files of the same name are replaced."), "DIR");
  if (!arguments.parse(given)) return 0;
  std::optional<OutputFolder> out;
  if (arguments.has("out")) out.emplace(arguments.required_path("out"));
  Session session(arguments);
  session.call("case", arguments.required_path("case").string());
  session.post(engine::OpenCase{arguments.required_path("case"), engine::OpenCase::Access::read});
  const auto kept = session.state()[part::moments];
  if (out) session.need({part::moments});
  session.figures["moments"] = kept ? static_cast<double>(kept->moments.size()) : 0.0;
  if (kept)
    for (const auto& moment : kept->moments) {
      say_row(*moment);
      if (arguments.has("json")) tell(*moment, session);
    }
  if (out) {
    const int without = write_moments(session, *kept, out->path());
    if (without > 0)
      say(Cli::tr("Without an overlay, because model or calibration were made anew since: %1.").arg(without));
    session.figures["without_overlay"] = without;
    out->commit();
    session.texts["out"] = arguments.path("out").string();
  }
  session.finish();
  return 0;
}

}  // namespace glisson::app
