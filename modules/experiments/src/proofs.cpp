// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/proofs.h"

#include <algorithm>

#include "atlas_proof.h"
#include "following_proof.h"
#include "glisson/core/marked_text.h"
#include "live_proof.h"
#include "patient_proof.h"
#include "pulled_proof.h"
#include "registration_proof.h"
#include "registration_stage.h"
#include "stereo_proof.h"

namespace glisson::experiments {
namespace fs = std::filesystem;
namespace {

template <class P>
Cancellable<Proven> proven_of(Cancellable<P> proof) {
  if (!proof) return {};
  Proven found;
  found.figures = std::move(proof->figures);
  if constexpr (requires { proof->notes; }) found.notes = std::move(proof->notes);
  found.absent = std::move(proof->absent);
  if constexpr (requires { proof->unused; }) found.unused = std::move(proof->unused);
  found.table = std::move(proof->table);
  found.page_table = found.table;
  return found;
}

Cancellable<Proven> run_patient(const ProofChoices& choices, const fs::path& folder,
                                const RunContext& context) {
  PatientProofOptions options;
  options.seed = choices.seed;
  options.data = choices.data;
  options.clicks = choices.clicks;
  options.synthetic = !choices.real_only;
  auto found = proven_of(prove_patient(options, folder, context));
  if (!found) return {};
  constexpr std::size_t kSeconds = 9;  // the last column's width
  for (std::string& line : found->page_table) line.resize(line.size() - kSeconds);
  return found;
}

std::string whom_patient(const ProofChoices& choices) {
  constexpr std::uint64_t kDevelopment = 2;
  return std::string("The settings were chosen on ct_ircad1 and on ") +
         (choices.seed == kDevelopment ? "these ill livers" : "ill livers of another seed") + "; ct_chaos3 " +
         (choices.seed == 1 ? "is for validation (and its lowest slice still shows liver)."
                            : "is for validation, with seed 1 alone.");
}

Cancellable<Proven> run_stereo(const ProofChoices& choices, const fs::path& folder,
                               const RunContext& context) {
  StereoProofOptions options;
  options.seed = choices.seed;
  options.data = choices.data;
  options.theatre = !choices.real_only;
  return proven_of(prove_stereo(options, folder, context));
}

/// Seed 1 measures on the default patients, another one on the patient of that seed alone.
std::vector<std::uint64_t> live_seeds(const ProofChoices& choices) {
  if (choices.real_only) return {};
  return choices.seed == 1 ? LiveProofOptions().seeds : std::vector<std::uint64_t>{choices.seed};
}

std::string whom_live(const ProofChoices& choices) { return told_of_patients(live_seeds(choices)); }

Cancellable<Proven> run_live(const ProofChoices& choices, const fs::path& folder, const RunContext& context) {
  LiveProofOptions options;
  options.seeds = live_seeds(choices);
  options.data = choices.data;
  const bool is_longer = choices.long_films && !options.seeds.empty();
  auto found = proven_of(prove_live(options, folder, context.part(0.0, is_longer ? 0.5 : 1.0)));
  if (!found || !is_longer) return found;
  FollowingProofOptions following;
  following.seed = options.seeds.front();
  const auto followed = prove_following(following, folder, context.part(0.5, 1.0));
  if (!followed) return {};
  found->figures.insert(followed->figures.begin(), followed->figures.end());
  for (std::vector<std::string>* table : {&found->table, &found->page_table}) {
    table->emplace_back();
    table->insert(table->end(), followed->table.begin(), followed->table.end());
  }
  return found;
}

Cancellable<Proven> run_registration(const ProofChoices& choices, const fs::path& folder,
                                     const RunContext& context) {
  RegistrationProofOptions options =
      choices.quick ? RegistrationProofOptions::quick() : RegistrationProofOptions();
  options.seed = choices.seed;
  options.data = choices.data;
  options.validation = !choices.development_only;
  options.former = choices.former;
  options.looks_alone = choices.looks;
  if (choices.looks) options.handlings = std::min(options.handlings, kMuchTriedHandlings);
  return proven_of(prove_registration(options, folder, context));
}

Cancellable<Proven> run_atlas(const ProofChoices& choices, const fs::path&, const RunContext& context) {
  AtlasProofOptions options;
  options.seed = choices.seed;
  options.data = choices.data;
  if (choices.built_in) options.built_in = choices.built_in();
  options.readings = choices.clicks / "liver_labelmaps_readings.json";
  options.synthetic = !choices.real_only;
  options.validation = !choices.development_only;
  return proven_of(prove_atlas(options, context));
}

Cancellable<Proven> run_pulled(const ProofChoices& choices, const fs::path& folder,
                               const RunContext& context) {
  PulledProofOptions options = choices.quick ? PulledProofOptions::quick() : PulledProofOptions();
  options.seed = choices.seed;
  options.data = choices.data;
  return proven_of(prove_pulled(options, folder, context));
}

constexpr Proof kProofs[] = {
    {"patient", QT_TRANSLATE_NOOP("cli", "From the CT to the model"),
     "3D-IRCADb-01 patient 1 (real CT) against its expert's labels, and the synthetic patient (in silico) "
     "against its truth, both segmented by clicks; vessels edited by twenty simulated strokes. The trials: "
     "each liver from ten random clicks, five of them in it, then with a click on each lesion.",
     whom_patient, patient_aims, "real-only", run_patient},
    {"stereo", QT_TRANSLATE_NOOP("cli", "From the laparoscope's pictures to clouds"),
     "A pair of real liver tissue against its CT surface, pairs of a chessboard and of a silicone heart "
     "(phantoms, real cameras), and pictures of the theatre (in silico), whose depth is known.",
     nullptr, stereo_aims, "real-only", run_stereo},
    {"registration", QT_TRANSLATE_NOOP("cli", "How far off a registration is, and whether it says so"),
     "Livers (synthetic, real CTs' label maps, surfaces) handled in silico in ways that the registration's "
     "prior does not know, with noisy clouds of a part of the surface; and clouds that are not of the "
     "patient, or not as they should be. Limits were set on the development patients alone.",
     nullptr, registration_aims, "development-only quick looks resume", run_registration},
    {"live", QT_TRANSLATE_NOOP("cli", "What the live overlay says of itself when something is wrong"),
     "Wrong starts, and faults put into the frames of the theatre (in silico), and into real pairs of "
     "liver tissue (for development) and of a silicone heart (for validation) that are set in motion in a "
     "known way: real texture and lens, simulated motion. A tool, blood, drops, a lamp that flickers, a "
     "lossy or stuttering video and a scope in a hand are no faults: a right overlay is to stay.",
     whom_live, live_aims, "real-only long", run_live},
    {"pulled", QT_TRANSLATE_NOOP("cli", "Bare organs that are pulled at a few places"),
     "Neo-Hookean organs (in silico) that are held somewhere and pulled or pressed at one to three places, "
     "with clouds of 500 points of a fifth of the surface: registered from rest and followed. Of loose ones "
     "nobody says what holds them nor where they are before the camera; 44 % of them is seen. And "
     "elastic_sequence (Mestdagh and Cotin 2022, linear, in silico, not ours).",
     nullptr, pulled_aims, "quick", run_pulled},
    {"atlas", QT_TRANSLATE_NOOP("cli", "Landmarks that the CT does not show"),
     "Ten livers of the synthetic population (in silico, landmarks by formula) and the real livers of the "
     "label maps (those of even numbers alone, with --development-only: they served development), each "
     "foretold by the others; the real ones by the built-in atlas, too. Truth of the real ones is what their "
     "labels show (vena cava, portal vein, gallbladder), and the middle between what two readers marked on "
     "slices and renderings of these labels (notch, falciform line, margin). The vena cava is judged twice: "
     "by its contact (mean "
     "distance between both areas, both ways) and by its course (five middle points of it), which a contact "
     "that is a little longer or shorter moves. And what landmarks are worth to a registration (in silico): "
     "the same clouds, 30 % seen, with none, with a person's, with a person's whose notch is 17.5 mm off, "
     "and with the atlas's, all accepted.",
     nullptr, atlas_aims, "real-only development-only", run_atlas},
};

}  // namespace

std::span<const Proof> proofs() { return kProofs; }

const Proof* proof_named(std::string_view name) {
  const auto* found = std::find_if(std::begin(kProofs), std::end(kProofs),
                                   [&](const Proof& one) { return name == one.name; });
  return found == std::end(kProofs) ? nullptr : found;
}

ProofPage page_of(const Proof& proof, const ProofChoices& choices, const Proven& found) {
  ProofPage page;
  page.title = proof.title;
  page.introduction = proof.introduction;
  if (const std::string whom = proof.whom != nullptr ? proof.whom(choices) : ""; !whom.empty())
    page.introduction += " " + whom;
  page.command = std::string("glisson prove ") + proof.name + (choices.real_only ? " --real-only" : "") +
                 (choices.development_only ? " --development-only" : "") + (choices.quick ? " --quick" : "") +
                 (choices.looks ? " --looks" : "") + (choices.long_films ? " --long" : "") + " --seed " +
                 std::to_string(choices.seed);
  page.aims = proof.aims();
  page.figures = found.figures;
  page.absent = found.absent;
  page.unused = found.unused;
  page.table = found.page_table;
  return page;
}

fs::path folder_for(const ProofPage& page, const std::optional<fs::path>& wanted, const fs::path& here) {
  if (wanted) return *wanted;
  // One that is missed does not make up for another that was not measured.
  const bool has_gaps = std::any_of(page.aims.begin(), page.aims.end(), [&](const Aim& aim) {
    return verdict(aim, page.figures) == Verdict::not_measured;
  });
  return has_gaps ? fs::path() : figures_of_checkout(here);
}

}  // namespace glisson::experiments
