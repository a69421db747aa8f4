// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's Figs. 5 and 6, measured again.
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
#include "output_folder.h"

namespace glisson::app {
namespace {

std::vector<ui::Plot> to_plots(const std::vector<experiments::FigurePlot>& plots) {
  std::vector<ui::Plot> told;
  for (const experiments::FigurePlot& plot : plots) {
    ui::Plot one{Cli::tr(plot.title.c_str()), Cli::tr(plot.x.c_str()), Cli::tr(plot.y.c_str()), {}, {}};
    for (const std::string& category : plot.categories) one.categories << QString::fromStdString(category);
    for (const experiments::FigureSeries& series : plot.series) {
      one.series.push_back({Cli::tr(series.name.c_str()), {}, series.low, series.high});
      for (const auto& [x, y] : series.values) one.series.back().values.emplace_back(x, y);
    }
    told.push_back(std::move(one));
  }
  return told;
}

experiments::PaperFigure transfer(const Arguments& arguments, Session& session) {
  using experiments::TransferStudyOptions;
  const bool quick = arguments.has("quick");
  if (quick) arguments.refuse_idle(QStringLiteral("--quick"), {"data"});
  TransferStudyOptions options = quick ? TransferStudyOptions::quick() : TransferStudyOptions();
  if (!quick) options.data = arguments.path("data");
  options.base = ui::built_in_atlas();
  options.seed = arguments.seed();
  const auto study = experiments::study_transfer(options, session.context());
  if (!study) throw Interrupted();
  experiments::PaperFigure figure = experiments::figure_of(*study);
  figure.command = "glisson figure 5";
  return figure;
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

experiments::PaperFigure sensitivity(const Arguments& arguments, Session& session) {
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
  experiments::PaperFigure figure = experiments::figure_of(*found);
  figure.command = "glisson figure 6 --flank " + flank.toStdString();
  if (arguments.has("case")) figure.command += " --case " + arguments.path("case").filename().string();
  return figure;
}

void tell(const experiments::PaperFigure& figure) {
  say(QString::fromStdString(figure.title));
  for (const experiments::Table* table : {&figure.table, &figure.paper}) {
    say(QString());
    for (const std::string& line : experiments::lines_of(*table)) say(QString::fromStdString(line));
  }
  for (const std::string& name : figure.absent)
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
  if (number == "5")
    arguments.refuse_idle(QStringLiteral("glisson figure 5"), {"case", "flank"});
  else
    arguments.refuse_idle(QStringLiteral("glisson figure 6"), {"data"});
  OutputFolder folder(arguments.path("out"));
  Session session(arguments);
  experiments::PaperFigure figure =
      number == "5" ? transfer(arguments, session) : sensitivity(arguments, session);
  figure.command +=
      (arguments.has("quick") ? " --quick" : "") + std::string(" --seed ") + std::to_string(arguments.seed());
  experiments::write_figure(folder.path(), figure);
  const std::string picture = "figure_" + std::to_string(figure.number) + ".png";
  stereo::write_picture(folder.path() / picture, scene::to_picture(ui::draw_plots(to_plots(figure.plots))));
  folder.commit();
  tell(figure);
  session.figures.merge(figure.figures);
  session.texts["plot"] = (arguments.path("out") / picture).string();
  session.finish();
  return 0;
}

}  // namespace glisson::app
