// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas: built from cases, measured, shown, and transferred to a case.
#include <algorithm>
#include <iterator>

#include "case_argument.h"
#include "cli.h"
#include "commands.h"
#include "glisson/atlas/atlas.h"
#include "glisson/engine/commands/build_atlas.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/landmark_origin.h"
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
    QStringList known;
    for (const auto& [structure, found] : left.with_notch)
      known << QStringLiteral("%1 %2").arg(ui::landmark_text(structure), mm(found.mean_error));
    if (!known.isEmpty()) line += Cli::tr("; with its notch known: %1").arg(known.join(QStringLiteral(", ")));
    say(line);
  }
}

/// @param out where the atlas is kept; empty: nowhere.
void build_of(const Arguments& arguments, Session& session, const fs::path& out) {
  engine::BuildAtlas build;
  const QStringList given = arguments.positionals();
  for (qsizetype i = 1; i < given.size(); ++i) build.cases.emplace_back(given[i].toStdString());
  build.base =
      arguments.has("fresh")
          ? std::make_shared<const atlas::Atlas>(atlas::bare_atlas(experiments::synthetic_template()))
          : atlas_of(arguments);
  build.options.name = arguments.value("name").toStdString();
  build.options.added_deviation = 1e-3 * arguments.number("added-deviation", 0.0, 50.0);
  build.options.added_unusual = arguments.number("added-unusual", 1.0, 99.0);
  build.options.keep_shape = arguments.has("keep-shape");
  build.options.summed = arguments.has("summed");
  build.unapproved = arguments.has("unapproved");
  build.out = out;
  const int synthetic = arguments.integer("synthetic", 0, 1000);
  for (int i = 0; i < synthetic; ++i)
    build.members.push_back(experiments::synthetic_member(arguments.seed() + static_cast<std::uint64_t>(i)));
  if (arguments.has("readings")) {
    auto read =
        experiments::read_livers(arguments.path("data"), arguments.path("readings"), session.context());
    if (!read) throw Interrupted();
    std::move(read->begin(), read->end(), std::back_inserter(build.members));
  }
  const engine::Outcome outcome = session.post(std::move(build));
  say_left_out(*outcome.result.as<atlas::BuildResult>());
}

void build_atlas(const Arguments& arguments, Session& session) {
  build_of(arguments, session, arguments.required_path("out"));
}

void evaluate_atlas(const Arguments& arguments, Session& session) { build_of(arguments, session, {}); }

/// The table of decisions: per structure where it comes from, how sure that is, what a person made of it.
void show_case_landmarks(const Arguments& arguments, Session& session) {
  open_case(arguments, session);
  session.need({part::model});
  const engine::CaseState& state = session.state();
  if (const auto& transfer = state[part::proposals])
    say(Cli::tr("Proposed by the atlas '%1'.").arg(QString::fromStdString(transfer->atlas)));
  for (const engine::LandmarkOrigin& one : engine::landmark_origins(state)) {
    QStringList words;
    if (one.deviation)
      words << ui::reason_text(*engine::proposal_of(state, one.structure));
    else if (one.source == atlas::Source::statistics)  // of a proposal that is gone
      words << Cli::tr("from statistics");
    else if (one.source)
      words << (*one.source == atlas::Source::person ? Cli::tr("placed by hand")
                                                     : Cli::tr("found in the CT"));
    else
      words << Cli::tr("unknown");
    if (one.decision) words << ui::decision_text(*one.decision);
    if (one.is_used) words << Cli::tr("used by the registration");
    say(QStringLiteral("%1: %2").arg(ui::landmark_text(one.structure), words.join(QStringLiteral(", "))));
    const std::string code = atlas::structure_code(one.structure);
    if (one.source) session.texts["landmark_" + code + "_source"] = atlas::source_code(*one.source);
    if (one.decision) session.texts["landmark_" + code + "_decision"] = atlas::decision_code(*one.decision);
    if (one.deviation) session.figures["landmark_" + code + "_deviation_mm"] = 1e3 * *one.deviation;
  }
}

void show_atlas(const Arguments& arguments, Session& session) {
  if (arguments.has("case")) return show_case_landmarks(arguments, session);
  const auto shown = atlas_of(arguments);
  say(Cli::tr("%1: %2 livers, %3 vertices, %4 modes")
          .arg(QString::fromStdString(shown->name))
          .arg(shown->members.size())
          .arg(shown->shape.mean.rows())
          .arg(shown->shape.mode_count()));
  bool follows = false;
  for (const atlas::StructureStatistics& one : shown->structures) {
    const double deviation = atlas::deviation(one);
    QString line = Cli::tr("%1: from %2 livers (%3), %4 mm")
                       .arg(ui::landmark_text(one.structure))
                       .arg(one.livers())
                       .arg(QString::fromStdString(one.origin), mm(deviation));
    QStringList others;
    for (const atlas::Dependence& other : one.depends) others << ui::landmark_text(other.on);
    if (!others.isEmpty()) line += Cli::tr("; follows: %1").arg(others.join(QStringLiteral(", ")));
    follows = follows || !others.isEmpty();
    say(line);
    session.figures[std::string("atlas_") + atlas::structure_code(one.structure) + "_deviation_mm"] =
        1e3 * deviation;
  }
  if (!follows) say(Cli::tr("No landmark follows another: this atlas does not know how they depend."));
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
  for (const atlas::Proposal& one : session.state()[part::proposals]->proposals) {
    say(QStringLiteral("%1: %2, %3")
            .arg(ui::landmark_text(one.structure), ui::reason_text(one), ui::decision_text(one.decision)));
    session.texts[std::string("atlas_") + atlas::structure_code(one.structure) + "_source"] =
        atlas::source_code(one.source());
  }
  save_case(arguments, session);
}

struct Action {
  const char* name;
  void (*run)(const Arguments&, Session&);
  bool takes_cases;  ///< else it is of one case or of none, and makes no atlas
  std::vector<const char*> idle;
};
const std::vector<Action>& actions() {
  static const std::vector<Action> kActions = {
      {"build", build_atlas, true, {"case", "accept"}},
      {"transfer", transfer_atlas, false, {"out", "name"}},
      {"evaluate", evaluate_atlas, true, {"case", "accept", "out", "name"}},
      {"show", show_atlas, false, {"out", "name", "accept"}}};
  return kActions;
}

/// What would be left unread without a word.
void refuse_idle_options(const Arguments& arguments, const Action& action) {
  QStringList idle(action.idle.begin(), action.idle.end());
  if (!action.takes_cases) {
    idle << "synthetic"
         << "added-deviation"
         << "added-unusual"
         << "unapproved"
         << "fresh"
         << "keep-shape"
         << "summed"
         << "readings"
         << "data";
    (void)arguments.positionals(1, 1);
  }
  arguments.refuse_idle(QStringLiteral("glisson atlas ") + QLatin1String(action.name), idle);
  if (arguments.has("fresh")) arguments.refuse_idle(QStringLiteral("--fresh"), {"atlas", "keep-shape"});
  arguments.refuse_without(QStringLiteral("readings"), {"data"});
  if (arguments.has("case") && std::string_view(action.name) == "show")
    arguments.refuse_idle(QStringLiteral("--case"), {"atlas"});
}

}  // namespace

int run_atlas(const QStringList& given) {
  Arguments arguments(
      "atlas",
      Cli::tr("Landmarks that the CT does not show. 'build CASE... --out A' makes an atlas of reviewed "
              "cases, 'evaluate CASE...' foretells each of them by the others, 'show' tells what an "
              "atlas knows, 'show --case C' where a case's landmarks come from, 'transfer --case C' "
              "proposes landmarks on a patient's liver."));
  arguments.positional("ACTION", Cli::tr("build, evaluate, show or transfer."));
  arguments.positional(
      "CASE", Cli::tr("Cases with a model, or folders of cases, for build and evaluate: five at least."),
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
  arguments.flag("unapproved", Cli::tr("Take cases whose labels nobody has approved, too."));
  arguments.flag("fresh", Cli::tr("Begin with the synthetic template instead of an atlas."));
  arguments.flag("keep-shape",
                 Cli::tr("Keep the atlas' mean liver and its modes, and learn from the cases where "
                         "structures lie on it."));
  arguments.flag("summed",
                 Cli::tr("Keep of the cases means and mean squares alone: no names, no single liver."));
  arguments.option("readings",
                   Cli::tr("Add the label maps of --data that served development, as this file says "
                           "where notch, falciform ligament and margin lie on them."),
                   "FILE");
  arguments.option("data", Cli::tr("Folder of the real data."), "DIR", "../shared/data");
  if (!arguments.parse(given)) return 0;
  const QString name = arguments.positionals(1, 10000).front();
  const auto action = std::find_if(actions().begin(), actions().end(),
                                   [&](const Action& one) { return name == QLatin1String(one.name); });
  if (action == actions().end())
    throw UsageError(Cli::tr("%1: is no action. See 'glisson atlas --help'.").arg(name).toStdString());
  refuse_idle_options(arguments, *action);
  Session session(arguments);
  action->run(arguments, session);
  session.finish();
  return 0;
}

}  // namespace glisson::app
