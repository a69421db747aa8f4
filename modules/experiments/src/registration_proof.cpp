// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_proof.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <mutex>

#include "glisson/core/error.h"
#include "glisson/core/share_out.h"
#include "glisson/geometry/rigid.h"
#include "glisson/registration/register_model.h"
#include "registration_joined.h"
#include "registration_looks.h"
#include "registration_stage.h"
#include "registration_trials.h"

namespace glisson::experiments {
namespace {

namespace fs = std::filesystem;

/// Work in any order on one thread or two. False: cancelled.
bool on_threads(int threads, std::size_t count, const RunContext& context,
                const std::function<void(std::size_t)>& work) {
  share_out(count, threads, [&](std::size_t i, bool here) {
    if (context.cancelled()) return;
    if (here) context.progress(static_cast<double>(i) / static_cast<double>(count), "prove.registration");
    work(i);
  });
  return !context.cancelled();
}

std::vector<ProofPatient> chosen_patients(const RegistrationProofOptions& options,
                                          std::vector<std::string>& absent) {
  std::vector<ProofPatient> chosen;
  std::map<ProofSet, int> counts;
  for (const ProofPatient& patient : proof_patients()) {
    const bool wanted = patient.set == ProofSet::development ? options.development : options.validation;
    if (!wanted || std::string(patient.name).find(options.only) == std::string::npos) continue;
    if (patient.kind != ProofPatient::Kind::synthetic && !fs::exists(options.data / patient.path))
      absent.emplace_back(patient.path);
    else if (options.patients == 0 || counts[patient.set]++ < options.patients)
      chosen.push_back(patient);
  }
  return chosen;
}

/// Trials of one kind on all patients, on threads; false: cancelled.
template <class Trial, class Try>
bool prove_on(const std::vector<RegistrationStage>& stages, const RegistrationProofOptions& options,
              RegistrationProof& proof, const RunContext& context, const Try& attempt) {
  std::vector<std::vector<Trial>> found(stages.size());
  const bool all_done = on_threads(options.threads, stages.size(), context, [&](std::size_t i) {
    found[i] = attempt(stages[i], i, options, context.quiet());
  });
  for (const ProofSet set : {ProofSet::validation, ProofSet::development}) {
    std::vector<Trial> of_set;
    for (std::size_t i = 0; i < stages.size(); ++i)
      if (stages[i].patient.set == set) of_set.insert(of_set.end(), found[i].begin(), found[i].end());
    sum_up(of_set, set == ProofSet::development ? "development" : "validation", proof);
  }
  return all_done;
}

/// Empty: cancelled.
Cancellable<RegistrationProof> prove_looks(const std::vector<RegistrationStage>& stages,
                                           const RegistrationProofOptions& options, RegistrationProof proof,
                                           const RunContext& context) {
  if (!prove_on<LookTrial>(stages, options, proof, context.part(0.0, 0.5), try_looks) ||
      !prove_on<JoinedTrial>(stages, options, proof, context.part(0.5, 1.0), try_joined))
    return std::nullopt;
  return proof;
}

/// The next patient of the same set.
std::size_t another(const std::vector<RegistrationStage>& stages, std::size_t i) {
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const std::size_t j = (i + k) % stages.size();
    if (stages[j].patient.set == stages[i].patient.set) return j;
  }
  return i;
}

}  // namespace

RegistrationProofOptions RegistrationProofOptions::quick() {
  RegistrationProofOptions options;
  options.patients = 2;
  options.shares = {0.3};
  options.handlings = kMuchTriedHandlings;
  options.rivals = false;
  return options;
}

void RegistrationProofOptions::validate() const {
  const OptionCheck demand("registration proof options");
  demand(!shares.empty(), "shares", 0.0, "Give one at least");
  for (const double share : shares)
    demand(share > 0.0 && share <= 1.0, "shares", share, "Give shares in (0, 1]");
  static_assert(std::size(insilico::kHandlings) == 10);
  demand(handlings > 0 && handlings <= 10, "handlings", static_cast<double>(handlings), "Give 1 to 10");
}

Cancellable<RegistrationProof> prove_registration(const RegistrationProofOptions& options,
                                                  const fs::path& folder, const RunContext& context) {
  options.validate();
  // A file a seed: what another seed gave is no registration of this run.
  const std::string csv = "registration_" + std::to_string(options.seed) + ".csv";
  TrialLog log(folder / csv, options.former.empty() ? fs::path() : options.former / csv);
  RegistrationProof proof;
  const std::vector<ProofPatient> patients = chosen_patients(options, proof.absent);
  std::vector<std::optional<RegistrationStage>> built(patients.size());
  const bool all_built =
      on_threads(options.threads, patients.size(), context.part(0.0, 0.2), [&](std::size_t i) {
        built[i] =
            build_stage(patients[i], options.data, options.seed + i, options.handlings, context.quiet());
      });
  if (!all_built) return std::nullopt;
  std::vector<RegistrationStage> stages;
  stages.reserve(built.size());
  for (auto& stage : built) stages.push_back(std::move(*stage));
  if (options.looks_alone) return prove_looks(stages, options, std::move(proof), context.part(0.2, 1.0));
  const bool all_done =
      on_threads(options.threads, stages.size(), context.part(0.2, 1.0), [&](std::size_t i) {
        run_trials(stages[i], stages[another(stages, i)], options, i, log, context.quiet());
      });
  if (!all_done) return std::nullopt;
  const std::vector<RegistrationTrial> all = log.trials();
  for (const ProofSet set : {ProofSet::validation, ProofSet::development}) sum_up(all, set, proof);
  return proof;
}

}  // namespace glisson::experiments
