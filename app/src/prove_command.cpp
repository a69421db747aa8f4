// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of packaging/figures, measured again: one proof for each part of the way.
#include "cli.h"
#include "commands.h"
#include "exit_code.h"
#include "glisson/experiments/aims.h"
#include "glisson/experiments/atlas_proof.h"
#include "glisson/experiments/live_proof.h"
#include "glisson/experiments/patient_proof.h"
#include "glisson/experiments/pulled_proof.h"
#include "glisson/experiments/registration_proof.h"
#include "glisson/experiments/stereo_proof.h"
#include "glisson/ui/common/built_in_atlas.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

struct Proof {
  const char* name;
  const char* title;
  const char* introduction;
  const std::vector<experiments::Aim>& (*aims)();
  /// Fills figures and notes of the session, and what of the page comes from the run.
  void (*run)(const Arguments&, Session&, const fs::path& folder, experiments::ProofPage& page);
};

/// One line for each aim: what, measured, aim, whether it is met.
void say_aims(const std::vector<experiments::Aim>& aims, const Figures& figures) {
  using experiments::Verdict;
  for (const experiments::Aim& aim : aims) {
    const Verdict found = experiments::verdict(aim, figures);
    const QString value =
        found == Verdict::not_measured ? QString() : QString::number(figures.at(aim.key), 'f', aim.decimals);
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

/// What any proof leaves: its table on the terminal and on the page, its figures. @throws Interrupted.
template <class P>
void tell(const Cancellable<P>& proof, Session& session, experiments::ProofPage& page) {
  if (!proof) throw Interrupted();
  for (const std::string& line : proof->table) say(QString::fromStdString(line));
  for (const auto& [key, value] : proof->figures) session.figures.emplace(key, value);
  page.absent = proof->absent;
  page.table = proof->table;
}

void prove_patient(const Arguments& arguments, Session& session, const fs::path& folder,
                   experiments::ProofPage& page) {
  experiments::PatientProofOptions options;
  options.seed = arguments.seed();
  options.data = arguments.path("data");
  options.clicks = arguments.path("clicks");
  options.synthetic = !arguments.has("real-only");
  const auto proof = experiments::prove_patient(options, folder, session.context());
  tell(proof, session, page);
  session.notes = proof->notes;
  // The page holds no times.
  constexpr std::size_t kSeconds = 9;
  for (std::string& line : page.table) line.resize(line.size() - kSeconds);
}

void prove_stereo(const Arguments& arguments, Session& session, const fs::path& folder,
                  experiments::ProofPage& page) {
  experiments::StereoProofOptions options;
  options.seed = arguments.seed();
  options.data = arguments.path("data");
  options.theatre = !arguments.has("real-only");
  const auto proof = experiments::prove_stereo(options, folder, session.context());
  tell(proof, session, page);
}

/// --seed 1 measures on the default patients, another one on the patient of that seed alone.
void prove_live(const Arguments& arguments, Session& session, const fs::path& folder,
                experiments::ProofPage& page) {
  experiments::LiveProofOptions options;
  if (arguments.seed() != 1) options.seeds.assign(1, arguments.seed());
  if (arguments.has("real-only")) options.seeds.clear();
  options.data = arguments.path("data");
  const auto proof = experiments::prove_live(options, folder, session.context());
  tell(proof, session, page);
}

void prove_registration(const Arguments& arguments, Session& session, const fs::path& folder,
                        experiments::ProofPage& page) {
  using experiments::RegistrationProofOptions;
  RegistrationProofOptions options =
      arguments.has("quick") ? RegistrationProofOptions::quick() : RegistrationProofOptions();
  options.seed = arguments.seed();
  options.data = arguments.path("data");
  options.validation = !arguments.has("development-only");
  options.resume = arguments.has("resume");
  options.looks_alone = arguments.has("looks");
  const auto proof = experiments::prove_registration(options, folder, session.context());
  tell(proof, session, page);
}

void prove_atlas(const Arguments& arguments, Session& session, const fs::path&,
                 experiments::ProofPage& page) {
  experiments::AtlasProofOptions options;
  options.seed = arguments.seed();
  options.data = arguments.path("data");
  options.built_in = ui::built_in_atlas();
  options.synthetic = !arguments.has("real-only");
  options.validation = !arguments.has("development-only");
  const auto proof = experiments::prove_atlas(options, session.context());
  tell(proof, session, page);
}

void prove_pulled(const Arguments& arguments, Session& session, const fs::path& folder,
                  experiments::ProofPage& page) {
  using experiments::PulledProofOptions;
  PulledProofOptions options = arguments.has("quick") ? PulledProofOptions::quick() : PulledProofOptions();
  options.seed = arguments.seed();
  options.data = arguments.path("data");
  const auto proof = experiments::prove_pulled(options, folder, session.context());
  tell(proof, session, page);
}

constexpr Proof kProofs[] = {
    {"patient", "From the CT to the model",
     "3D-IRCADb-01 patient 1 (real CT) against its expert's labels, and the synthetic patient (in silico) "
     "against its truth, both segmented by clicks; vessels edited by twenty simulated strokes. The trials: "
     "each liver from ten random clicks, five of them in it, then with a click on each lesion. The settings "
     "were chosen on ct_ircad1 and on ill livers of another seed; ct_chaos3 is for validation (and its "
     "lowest "
     "slice still shows liver).",
     experiments::patient_aims, prove_patient},
    {"stereo", "From the laparoscope's pictures to clouds",
     "A pair of real liver tissue against its CT surface, pairs of a chessboard and of a silicone heart "
     "(phantoms, real cameras), and pictures of the theatre (in silico), whose depth is known.",
     experiments::stereo_aims, prove_stereo},
    {"registration", "How far off a registration is, and whether it says so",
     "Livers (synthetic, real CTs' label maps, surfaces) handled in silico in ways that the registration's "
     "prior "
     "does not know, with noisy clouds of a part of the surface; and clouds that are not of the patient, or "
     "not as "
     "they should be. Limits were set on the development patients alone.",
     experiments::registration_aims, prove_registration},
    {"live", "What the live overlay says of itself when something is wrong",
     "Wrong starts, and faults put into the frames of the theatre (in silico), on patients and films that no "
     "limit was set on; and into real pairs of liver tissue (for development) and of a silicone heart (for "
     "validation) that are set in motion in a known way: real texture and lens, simulated motion.",
     experiments::live_aims, prove_live},
    {"pulled", "Bare organs that are pulled at a few places",
     "Neo-Hookean organs (in silico) that are held somewhere and pulled or pressed at one to three places, "
     "with clouds of 500 points of a fifth of the surface: registered from rest and followed. Of loose ones "
     "nobody says what holds them nor where they are before the camera; 44 % of them is seen. And "
     "elastic_sequence (Mestdagh and Cotin 2022, linear, in silico, not ours).",
     experiments::pulled_aims, prove_pulled},
    {"atlas", "Landmarks that the CT does not show",
     "Ten livers of the synthetic population (in silico, landmarks by formula) and the real livers of the "
     "label maps (those of even numbers alone, with --development-only: they served development), each "
     "foretold by the others; the real ones by the built-in atlas, too. Truth of the real ones is what their "
     "labels show: vena cava, portal vein, gallbladder. The vena cava is judged twice: by its contact (mean "
     "distance between both areas, both ways) and by its course (five middle points of it), which a contact "
     "that is a little longer or shorter moves.",
     experiments::atlas_aims, prove_atlas},
};

/// Where the page goes: where the person says, else into the checkout that the program runs in. A page with
/// gaps never takes the place of a whole one unasked. Empty: nowhere.
fs::path figures_folder(const Arguments& arguments, experiments::Verdict verdict) {
  if (arguments.has("figures")) return arguments.path("figures");
  if (verdict == experiments::Verdict::not_measured) return {};
  return experiments::figures_of_checkout(fs::current_path());
}

void write_page(const Arguments& arguments, const Proof& proof, experiments::ProofPage page,
                const Figures& figures) {
  page.title = proof.title;
  page.introduction = proof.introduction;
  page.aims = proof.aims();
  page.figures = figures;
  page.command = std::string("glisson prove ") + proof.name +
                 (arguments.has("real-only") ? " --real-only" : "") +
                 (arguments.has("development-only") ? " --development-only" : "") +
                 (arguments.has("quick") ? " --quick" : "") + (arguments.has("looks") ? " --looks" : "") +
                 " --seed " + std::to_string(arguments.seed());
  const fs::path folder = figures_folder(arguments, experiments::verdict(page.aims, figures));
  if (folder.empty()) return;
  fs::create_directories(folder);
  const fs::path file = folder / (std::string(proof.name) + ".md");
  experiments::write_page(file, page);
  say(Cli::tr("The figures were written to %1.").arg(QString::fromStdString(file.string())));
}

}  // namespace

int run_prove(const QStringList& given) {
  Arguments arguments(
      "prove", Cli::tr("Measures the proofs' figures again, against experts' labels and "
                       "known truths: patient (from the CT to the model), stereo (from pictures to "
                       "clouds), registration (how far off it is, and whether it says so), live (what "
                       "the overlay says of itself when something is wrong), atlas (landmarks that the CT "
                       "does not show), pulled (bare organs that are held somewhere and pulled at a few "
                       "places)."));
  arguments.positional("PROOF", Cli::tr("Which: patient, stereo, registration, live, atlas or pulled."));
  arguments.option("data", Cli::tr("Folder of the real data; what is not there is left out."), "DIR",
                   "../shared/data");
  arguments.option("clicks", Cli::tr("Folder of the clicks on it."), "DIR", "tests/data");
  arguments.flag("real-only", Cli::tr("Leave out what is measured in silico."));
  arguments.flag(
      "development-only",
      Cli::tr("registration, atlas: leave the validation patients alone, as when limits are set."));
  arguments.flag("quick",
                 Cli::tr("registration: two patients of either set and one share that is seen; pulled: two "
                         "organs of a kind."));
  arguments.flag("looks",
                 Cli::tr("registration: only whether one more look helps, where it is said to help most and "
                         "joined from an unknown place."));
  arguments.flag("resume", Cli::tr("registration: keep what DIR/registration_SEED.csv holds already."));
  arguments.option(
      "figures",
      Cli::tr("Folder for the page with the figures. In a checkout they go to packaging/figures, "
              "unless some could not be measured."),
      "DIR");
  arguments.option("out", Cli::tr("Folder for cases, scripts and pictures."), "DIR");
  if (!arguments.parse(given)) return 0;
  const QString name = arguments.positionals(1, 1).front();
  const auto proof = std::find_if(std::begin(kProofs), std::end(kProofs),
                                  [&](const Proof& one) { return name == QLatin1String(one.name); });
  if (proof == std::end(kProofs))
    throw UsageError(Cli::tr("%1: is no proof. See 'glisson prove --help'.").arg(name).toStdString());
  OutputFolder folder(arguments.required_path("out"));
  if (arguments.has("figures")) fs::create_directories(arguments.path("figures"));
  Session session(arguments);
  experiments::ProofPage page;
  proof->run(arguments, session, folder.path(), page);
  folder.commit();
  session.finish();
  say_absent(page.absent);
  say_aims(proof->aims(), session.figures);
  write_page(arguments, *proof, std::move(page), session.figures);
  return exit_code(experiments::verdict(proof->aims(), session.figures));
}

}  // namespace glisson::app
