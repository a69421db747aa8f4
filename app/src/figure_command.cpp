// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figs. 5 and 6, measured again.
#include <cmath>

#include "cli.h"
#include "commands.h"

#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/parts/model.h"
#include "glisson/experiments/sensitivity.h"
#include "glisson/experiments/synthetic_model.h"
#include "glisson/experiments/transfer_study.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "glisson/ui/common/plot.h"
#include "glisson/ui/scene/picture_image.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

/// A figure with its picture.
struct Drawn {
  experiments::PaperFigure figure;
  std::vector<ui::Plot> plots;
};

/// Millimetres; below 0 (nothing is drawn) where it is not known.
double drawn_mm(double metres) { return std::isfinite(metres) ? 1e3 * metres : -1.0; }

QString support_text(experiments::Support support) {
  switch (support) {
    case experiments::Support::notch:
      return Cli::tr("falciform ligament at the notch");
    case experiments::Support::cava:
      return Cli::tr("vena cava");
    case experiments::Support::both:
      break;
  }
  return Cli::tr("both");
}

std::vector<ui::Plot> plots_of(const experiments::Sensitivity& found) {
  const QString distance = Cli::tr("mean Hausdorff distance, mm");
  ui::Plot places{Cli::tr("(a) place of the boundary conditions"),
                  Cli::tr("shift along the surface, mm"),
                  distance,
                  {},
                  {}};
  ui::Plot stiffness{Cli::tr("(b) stiffness of the boundary conditions"),
                     Cli::tr("times the reference's stiffness"),
                     distance,
                     {},
                     {}};
  for (const experiments::Support support : experiments::kSupports) {
    ui::PlotSeries shifted{support_text(support), {}, {}, {}}, stiffened{support_text(support), {}, {}, {}};
    for (const experiments::ShiftRow& row : found.shifts) {
      if (row.support != support) continue;
      shifted.values.emplace_back(1e3 * row.shift, drawn_mm(row.mean.surface));
      shifted.low.push_back(drawn_mm(row.least));
      shifted.high.push_back(drawn_mm(row.most));
    }
    for (const experiments::StiffnessRow& row : found.stiffness) {
      if (row.support != support) continue;
      if (support == experiments::kSupports.front())
        stiffness.categories << QStringLiteral("\u00d7 %1").arg(row.factor);
      stiffened.values.emplace_back(static_cast<double>(stiffened.values.size()),
                                    drawn_mm(row.distance.surface));
    }
    places.series.push_back(std::move(shifted));
    stiffness.series.push_back(std::move(stiffened));
  }
  return {places, stiffness};
}

ui::Plot plot_of(const experiments::TransferStudy& study) {
  ui::Plot plot{Cli::tr("the atlas laid on livers"),
                Cli::tr("liver (s: synthetic; * not in the atlas)"),
                Cli::tr("mean Hausdorff distance, mm"),
                {},
                {}};
  ui::PlotSeries surface{Cli::tr("surface"), {}, {}, {}},
      notch{Cli::tr("umbilical notch (in silico)"), {}, {}, {}}, cava{Cli::tr("vena cava"), {}, {}, {}};
  for (const experiments::TransferRow& row : study.rows) {
    const auto x = static_cast<double>(plot.categories.size());
    QString name = QString::fromStdString(row.liver);
    name.replace(QLatin1String("synthetic_"), QLatin1String("s "));  // slanted, there is room for few letters
    plot.categories << name + (row.outside ? QStringLiteral(" *") : QString());
    surface.values.emplace_back(x, drawn_mm(row.surface));
    notch.values.emplace_back(x, drawn_mm(row.notch));
    cava.values.emplace_back(x, drawn_mm(row.cava));
  }
  plot.series = {surface, notch, cava};
  return plot;
}

Drawn transfer(const Arguments& arguments, Session& session) {
  using experiments::TransferStudyOptions;
  const bool quick = arguments.has("quick");
  TransferStudyOptions options = quick ? TransferStudyOptions::quick() : TransferStudyOptions();
  if (!quick) options.data = arguments.path("data");
  options.base = ui::built_in_atlas();
  options.seed = arguments.seed();
  const auto study = experiments::study_transfer(options, session.context());
  if (!study) throw Interrupted();
  Drawn drawn{experiments::figure_of(*study), {plot_of(*study)}};
  drawn.figure.command = "glisson figure 5";
  return drawn;
}

/// The case's model with its landmarks, or the built-in synthetic patient's.
PatientModel patient_of(const Arguments& arguments, Session& session) {
  if (arguments.has("case")) {
    session.call("case", arguments.path("case").string());
    session.call("model", arguments.path("case").string());
    session.post(engine::OpenCase{arguments.path("case"), engine::OpenCase::Access::read});
    session.need({part::model});
    return engine::effective_model(session.state());
  }
  auto made = experiments::synthetic_model(arguments.seed(), session.context().part(0.0, 0.2));
  if (!made) throw Interrupted();
  made->model.landmarks = std::move(made->patient.landmarks);
  return std::move(made->model);
}

Drawn sensitivity(const Arguments& arguments, Session& session) {
  using experiments::SensitivityOptions;
  SensitivityOptions options = arguments.has("quick") ? SensitivityOptions::quick() : SensitivityOptions();
  const QString flank = arguments.value("flank");
  if (flank != "left" && flank != "right")
    throw UsageError(Cli::tr("--flank: is %1. Give left or right.").arg(flank).toStdString());
  if (flank == "right") options.flank = SensitivityOptions::Flank::right;
  const PatientModel model = patient_of(arguments, session);
  Cancellable<experiments::Sensitivity> found;
  session.with_names(
      [&] { found = experiments::boundary_sensitivity(model, options, session.context().part(0.2, 1.0)); });
  if (!found) throw Interrupted();
  Drawn drawn{experiments::figure_of(*found), plots_of(*found)};
  drawn.figure.command = "glisson figure 6 --flank " + flank.toStdString();
  if (arguments.has("case")) drawn.figure.command += " --case " + arguments.path("case").filename().string();
  return drawn;
}

void tell(const Drawn& drawn) {
  say(QString::fromStdString(drawn.figure.title));
  for (const experiments::Table* table : {&drawn.figure.table, &drawn.figure.paper}) {
    say(QString());
    for (const std::string& line : experiments::lines_of(*table)) say(QString::fromStdString(line));
  }
  for (const std::string& name : drawn.figure.absent)
    say(Cli::tr("%1 is not there and is left out.").arg(QString::fromStdString(name)));
}

}  // namespace

int run_figure(const QStringList& given) {
  Arguments arguments("figure", Cli::tr("Measures a figure of the paper again and sets it beside the paper's "
                                        "words: 5 (how well the atlas foretells surface, notch and vena "
                                        "cava), 6 (how much the shape on the flank depends on place and "
                                        "stiffness of the boundary conditions). Prints the table; writes "
                                        "page, table and plot."));
  arguments.positional("NUMBER", Cli::tr("The figure's number in the paper: 5 or 6."));
  arguments.option("data", Cli::tr("5: folder of the real data; what is not there is left out."), "DIR",
                   "../shared/data");
  arguments.option("case",
                   Cli::tr("6: a case with model, notch and vena cava, instead of the built-in "
                           "synthetic patient."),
                   "CASE");
  arguments.option("flank", Cli::tr("6: the side that is down: left or right."), "SIDE", "left");
  arguments.flag("quick", Cli::tr("Fewer trials: to see whether it runs."));
  arguments.option("out", Cli::tr("The folder for page, table and plot."), "DIR", "glisson-figure");
  if (!arguments.parse(given)) return 0;
  const QString number = arguments.positionals(1, 1).front();
  if (number != "5" && number != "6")
    throw UsageError(
        Cli::tr("NUMBER: is %1. Give 5 or 6: no other figure is measured.").arg(number).toStdString());
  OutputFolder folder(arguments.path("out"));
  Session session(arguments);
  Drawn drawn = number == "5" ? transfer(arguments, session) : sensitivity(arguments, session);
  drawn.figure.command +=
      (arguments.has("quick") ? " --quick" : "") + std::string(" --seed ") + std::to_string(arguments.seed());
  experiments::write_figure(folder.path(), drawn.figure);
  const std::string picture = "figure_" + std::to_string(drawn.figure.number) + ".png";
  stereo::write_picture(folder.path() / picture, scene::to_picture(ui::draw_plots(drawn.plots)));
  folder.commit();
  tell(drawn);
  session.figures.merge(drawn.figure.figures);
  session.texts["plot"] = (arguments.path("out") / picture).string();
  session.finish();
  return 0;
}

}  // namespace glisson::app
