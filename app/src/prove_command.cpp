// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of packaging/figures, measured again: one proof for each part of the way.
#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/experiments/proofs.h"
#include "glisson/ui/common/built_in_atlas.h"
#include "output_folder.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

/// One line for each aim: what, measured, aim, whether it is met.
void say_aims(const experiments::ProofPage& page) {
  using experiments::Verdict;
  for (const experiments::Aim& aim : page.aims) {
    const Verdict found = experiments::verdict(aim, page.figures);
    const QString value = found == Verdict::not_measured
                              ? QString()
                              : QString::number(page.figures.at(aim.key), 'f', aim.decimals);
    say(QStringLiteral("%1  %2  (%3 %4)  %5")
            .arg(Cli::tr(aim.what.c_str()), -72)
            .arg(value, 9)
            .arg(aim.sense == experiments::Aim::Sense::at_least ? QStringLiteral("≥") : QStringLiteral("≤"))
            .arg(aim.bound, 0, 'f', aim.decimals)
            .arg(found == Verdict::met      ? Cli::tr("met")
                 : found == Verdict::missed ? Cli::tr("NOT MET")
                                            : Cli::tr("not measured")));
  }
}

void say_absent(const std::vector<std::string>& absent) {
  for (const std::string& name : absent)
    say(Cli::tr("%1 is not there and is left out.").arg(QString::fromStdString(name)));
}

bool takes(const experiments::Proof& proof, const char* option) {
  return QString::fromUtf8(proof.takes.data(), static_cast<qsizetype>(proof.takes.size()))
      .split(QLatin1Char(' '))
      .contains(QLatin1String(option));
}

/// What would be left unread without a word, though the page would name it.
void refuse_idle_options(const Arguments& arguments, const experiments::Proof& proof) {
  for (const char* name : {"real-only", "development-only", "quick", "looks", "long", "resume"})
    if (!takes(proof, name))
      arguments.refuse_idle(QStringLiteral("glisson prove ") + QLatin1String(proof.name), {name});
  if (arguments.has("real-only"))  // the long films are of the theatre
    arguments.refuse_idle(QStringLiteral("glisson prove %1 --real-only").arg(QLatin1String(proof.name)),
                          {"long"});
}

experiments::ProofChoices choices_of(const Arguments& arguments) {
  experiments::ProofChoices choices;
  choices.seed = arguments.seed();
  choices.data = arguments.path("data");
  choices.clicks = arguments.path("clicks");
  choices.real_only = arguments.has("real-only");
  choices.development_only = arguments.has("development-only");
  choices.quick = arguments.has("quick");
  choices.looks = arguments.has("looks");
  choices.long_films = arguments.has("long");
  if (arguments.has("resume")) choices.former = arguments.required_path("out");
  choices.built_in = ui::built_in_atlas;
  return choices;
}

void write_page(const Arguments& arguments, const experiments::Proof& proof,
                const experiments::ProofPage& page) {
  std::optional<fs::path> wanted;
  if (arguments.has("figures")) wanted = arguments.path("figures");
  const fs::path folder = experiments::folder_for(page, wanted, fs::current_path());
  if (folder.empty()) return;
  fs::create_directories(folder);
  const fs::path file = folder / (std::string(proof.name) + ".md");
  experiments::write_page(file, page);
  say(Cli::tr("The figures were written to %1.").arg(QString::fromStdString(file.string())));
}

/// Of all, or of those that take an option.
QString proof_names(const char* option = nullptr) {
  QStringList names;
  for (const experiments::Proof& proof : experiments::proofs())
    if (option == nullptr || takes(proof, option)) names << QLatin1String(proof.name);
  return names.join(QStringLiteral(", "));
}

/// "patient: From the CT to the model; stereo: ...".
QString proof_titles() {
  QStringList titles;
  for (const experiments::Proof& proof : experiments::proofs())
    titles << QLatin1String(proof.name) + QStringLiteral(": ") + Cli::tr(proof.title);
  return titles.join(QStringLiteral("; "));
}

void declare_prove(Arguments& arguments) {
  arguments.positional("PROOF", Cli::tr("Which: %1.").arg(proof_names()));
  arguments.option("data", Cli::tr("Folder of the real data; what is not there is left out."), "DIR",
                   "../shared/data");
  arguments.option("clicks", Cli::tr("Folder of the clicks on it."), "DIR", "tests/data");
  arguments.flag("real-only",
                 Cli::tr("%1: leave out what is measured in silico.").arg(proof_names("real-only")));
  arguments.flag("development-only",
                 Cli::tr("%1: leave the validation patients alone, as when limits are set.")
                     .arg(proof_names("development-only")));
  arguments.flag("quick",
                 Cli::tr("registration: two patients of either set and one share that is seen; pulled: two "
                         "organs of a kind."));
  arguments.flag("looks",
                 Cli::tr("%1: only whether one more look helps, where it is said to help most and joined "
                         "from an unknown place.")
                     .arg(proof_names("looks")));
  arguments.flag(
      "long", Cli::tr("%1: follow a scope in a fast hand, tools that lift and press, and 3,000 frames, too.")
                  .arg(proof_names("long")));
  arguments.flag("resume",
                 Cli::tr("%1: keep what DIR/registration_SEED.csv holds of a run that was cut short.")
                     .arg(proof_names("resume")));
  arguments.option(
      "figures",
      Cli::tr("Folder for the page with the figures. In a checkout they go to packaging/figures, "
              "unless some could not be measured."),
      "DIR");
  arguments.option("out", Cli::tr("Folder for cases, scripts and pictures."), "DIR");
}

}  // namespace

int run_prove(const QStringList& given) {
  Arguments arguments(
      "prove", Cli::tr("Measures the proofs' figures again, against experts' labels and known truths. %1.")
                   .arg(proof_titles()));
  declare_prove(arguments);
  if (!arguments.parse(given)) return 0;
  const QString name = arguments.positionals(1, 1).front();
  const experiments::Proof* proof = experiments::proof_named(name.toStdString());
  if (proof == nullptr)
    throw UsageError(Cli::tr("%1: is no proof. See 'glisson prove --help'.").arg(name).toStdString());
  refuse_idle_options(arguments, *proof);
  OutputFolder folder(arguments.required_path("out"));
  if (arguments.has("figures")) fs::create_directories(arguments.path("figures"));
  Session session(arguments);
  const experiments::ProofChoices choices = choices_of(arguments);
  const auto found = proof->run(choices, folder.path(), session.context());
  if (!found) {
    if (!fs::is_empty(folder.path())) folder.commit(false);
    throw Interrupted();
  }
  for (const std::string& line : found->table) say(QString::fromStdString(line));
  session.figures = found->figures;
  session.notes = found->notes;
  folder.commit();
  session.finish();
  const experiments::ProofPage page = experiments::page_of(*proof, choices, *found);
  say_absent(page.absent);
  say_aims(page);
  write_page(arguments, *proof, page);
  return exit_code(experiments::verdict(page));
}

}  // namespace glisson::app
