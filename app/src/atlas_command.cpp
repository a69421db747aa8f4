// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas: built from cases, measured, shown, and transferred to a case.
#include <algorithm>

#include "case_argument.h"
#include "cli.h"
#include "commands.h"
#include "glisson/atlas/atlas.h"
#include "glisson/engine/atlas_member.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/experiments/atlas_livers.h"
#include "glisson/ui/common/atlas_texts.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "glisson/ui/common/texts.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

std::shared_ptr<const atlas::Atlas> atlas_of(const Arguments& arguments) {
  if (!arguments.has("atlas")) return ui::built_in_atlas();
  return std::make_shared<const atlas::Atlas>(atlas::read_atlas(arguments.path("atlas")));
}

QString mm(double metres) { return QString::number(1e3 * metres, 'f', 1); }

atlas::Member member_of_case(const fs::path& folder, Session& session) {
  session.call("case", folder.string());
  session.post(engine::OpenCase{folder});
  session.need({part::model});
  return engine::atlas_member(folder.stem().string(), session.state());
}

std::vector<atlas::Member> members_of(const Arguments& arguments, Session& session) {
  std::vector<atlas::Member> members;
  const int synthetic = arguments.integer("synthetic", 0, 1000);
  for (int i = 0; i < synthetic; ++i)
    members.push_back(experiments::synthetic_member(arguments.seed() + static_cast<std::uint64_t>(i)));
  const QStringList given = arguments.positionals();
  for (qsizetype i = 1; i < given.size(); ++i)
    members.push_back(member_of_case(given[i].toStdString(), session));
  return members;
}

/// A row a liver: surface, then each structure's mean error.
void say_left_out(const atlas::BuildResult& built) {
  say(Cli::tr("Each liver foretold by the others (mm, in silico where the livers are synthetic):"));
  for (const atlas::LeftOut& left : built.left_out) {
    QString line = QStringLiteral("%1  %2 %3")
                       .arg(QString::fromStdString(left.name), -16)
                       .arg(Cli::tr("surface"))
                       .arg(mm(left.mean_distance));
    for (const auto& [structure, found] : left.structures)
      line += QStringLiteral(", %1 %2").arg(ui::landmark_text(structure), mm(found.mean_error));
    say(line);
  }
}

atlas::BuildResult built(const Arguments& arguments, Session& session) {
  std::vector<atlas::Member> members = members_of(arguments, session);
  atlas::BuildOptions options;
  options.name = arguments.value("name").toStdString();
  options.added_deviation = 1e-3 * arguments.number("added-deviation", 0.0, 50.0);
  options.added_unusual = arguments.number("added-unusual", 1.0, 99.0);
  const atlas::Atlas base =
      arguments.has("fresh") ? atlas::bare_atlas(experiments::synthetic_template()) : *atlas_of(arguments);
  auto result = atlas::build(std::move(members), base, options, session.context());
  if (!result) throw Interrupted();
  session.figures.merge(atlas::figures_of(*result));
  session.notes.insert(session.notes.end(), result->notes.begin(), result->notes.end());
  say_left_out(*result);
  return std::move(*result);
}

void build_atlas(const Arguments& arguments, Session& session) {
  OutputFolder folder(arguments.required_path("out"));
  atlas::write_atlas(folder.path(), built(arguments, session).atlas);
  folder.commit();
}

void evaluate_atlas(const Arguments& arguments, Session& session) { built(arguments, session); }

void show_atlas(const Arguments& arguments, Session& session) {
  const auto shown = atlas_of(arguments);
  say(Cli::tr("%1: %2 livers, %3 vertices, %4 modes")
          .arg(QString::fromStdString(shown->name))
          .arg(shown->members.size())
          .arg(shown->shape.mean.rows())
          .arg(shown->shape.mode_count()));
  for (const atlas::StructureStatistics& one : shown->structures) {
    const double deviation = atlas::deviation(one);
    say(Cli::tr("%1: from %2 livers (%3), %4 mm")
            .arg(ui::landmark_text(one.structure))
            .arg(one.members.size())
            .arg(QString::fromStdString(one.origin), mm(deviation)));
    session.figures[std::string("atlas_") + atlas::structure_code(one.structure) + "_deviation_mm"] =
        1e3 * deviation;
  }
  for (const atlas::AtlasMember& member : shown->members)
    if (member.weight < 1.0)
      say(Cli::tr("%1 differs from the others: weight %2")
              .arg(QString::fromStdString(member.name))
              .arg(member.weight, 0, 'f', 2));
  session.figures["atlas_members"] = static_cast<double>(shown->members.size());
  session.figures["atlas_modes"] = shown->shape.mode_count();
}

std::vector<atlas::Structure> accepted(const Arguments& arguments) {
  std::vector<atlas::Structure> all;
  for (const QString& name : arguments.value("accept").split(',', Qt::SkipEmptyParts)) {
    const auto structure = atlas::structure_of(name.trimmed().toStdString());
    if (!structure) throw UsageError(Cli::tr("--accept: %1 is no structure.").arg(name).toStdString());
    all.push_back(*structure);
  }
  return all;
}

void transfer_atlas(const Arguments& arguments, Session& session) {
  const std::vector<atlas::Structure> accept = accepted(arguments);
  const auto used = atlas_of(arguments);
  open_case(arguments, session);
  session.post(engine::ProposeLandmarks{used});
  for (const atlas::Structure structure : accept)
    session.post(engine::ReviewProposal{structure, atlas::Decision::accepted});
  for (const atlas::Proposal& one : session.state()[part::proposals]->proposals)
    say(QStringLiteral("%1: %2, %3")
            .arg(ui::landmark_text(one.structure), ui::reason_text(one), ui::decision_text(one.decision)));
  save_case(arguments, session);
}

struct Action {
  const char* name;
  void (*run)(const Arguments&, Session&);
};
constexpr Action kActions[] = {
    {"build", build_atlas}, {"transfer", transfer_atlas}, {"evaluate", evaluate_atlas}, {"show", show_atlas}};

}  // namespace

int run_atlas(const QStringList& given) {
  Arguments arguments(
      "atlas",
      Cli::tr("Landmarks that the CT does not show. 'build CASE... --out A' makes an atlas of reviewed "
              "cases, 'evaluate CASE...' foretells each of them by the others, 'show' tells what an "
              "atlas knows, 'transfer --case C' proposes landmarks on a patient's liver."));
  arguments.positional("ACTION", Cli::tr("build, evaluate, show or transfer."));
  arguments.positional("CASE", Cli::tr("Cases with a model, for build and evaluate: five at least."),
                       "[CASE...]");
  declare_case(arguments);
  arguments.option("atlas", Cli::tr("An atlas' folder instead of the built-in atlas."), "DIR");
  arguments.option("out", Cli::tr("Folder for the atlas that is built."), "DIR");
  arguments.option("name", Cli::tr("Name of the atlas that is built."), "NAME", "own");
  arguments.option(
      "accept", Cli::tr("Proposals to accept unseen, with commas: umbilical_notch, vena_cava, ..."), "LIST");
  arguments.option("synthetic", Cli::tr("Add this many livers of the synthetic population, from --seed on."),
                   "N", 0.0);
  arguments.option(
      "added-deviation",
      Cli::tr("What the livers do not show of how patients differ, mm, added to every landmark."), "MM", 0.0);
  arguments.option(
      "added-unusual",
      Cli::tr("How unusual the livers were that --added-deviation was set on, over what is usual: "
              "it grows only beyond that."),
      "X", 1.0);
  arguments.flag("fresh", Cli::tr("Begin with the synthetic template instead of an atlas."));
  if (!arguments.parse(given)) return 0;
  const QString name = arguments.positionals(1, 10000).front();
  const auto action = std::find_if(std::begin(kActions), std::end(kActions),
                                   [&](const Action& one) { return name == QLatin1String(one.name); });
  if (action == std::end(kActions))
    throw UsageError(Cli::tr("%1: is no action. See 'glisson atlas --help'.").arg(name).toStdString());
  Session session(arguments);
  action->run(arguments, session);
  session.finish();
  return 0;
}

}  // namespace glisson::app
