// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_joined.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/registration/refusal.h"

namespace glisson::experiments {
namespace {

constexpr double kShare = 0.2;  ///< of the surface, each time

JoinedTrial::Found found(StageRegistrar& registrar, const LabelledCloud& cloud,
                         const registration::RegisterOptions& options, const Points& truth) {
  JoinedTrial::Found result{0.0, std::numeric_limits<double>::infinity(), true};
  try {
    const auto examined = registrar.run(cloud, options);
    if (!examined) return result;
    const Registration& made = examined->registered.registration;
    const auto is_of_looks = [](const std::string& doubt) { return doubt.starts_with("looks_differ"); };
    result = {made.seen_share, (made.nodes_in_camera - truth).rowwise().norm().mean(),
              registration::is_refused(made),
              std::any_of(made.doubts.begin(), made.doubts.end(), is_of_looks)};
  } catch (const Error&) {  // no result: nobody is misled
  }
  return result;
}

std::string shown(const JoinedTrial::Found& one) {
  char text[64];
  std::snprintf(text, sizeof text, "%6.0f %% %8.1f %-9s", 1e2 * one.seen, 1e3 * one.error,
                one.refused ? (one.told ? "refused*" : "refused")
                : one.told  ? "told"
                            : "");
  return text;
}

void add_counts(const std::vector<JoinedTrial>& trials, JoinedTrial::Found JoinedTrial::*which,
                const std::string& prefix, RegistrationProof& proof) {
  const auto count = [&](bool JoinedTrial::Found::*what) {
    return static_cast<double>(std::count_if(trials.begin(), trials.end(),
                                             [&](const JoinedTrial& trial) { return trial.*which.*what; }));
  };
  proof.figures[prefix + "refused"] = count(&JoinedTrial::Found::refused);
  proof.figures[prefix + "told"] = count(&JoinedTrial::Found::told);
}

/// Of those that were not refused.
void add_errors(const std::vector<JoinedTrial>& trials, JoinedTrial::Found JoinedTrial::*which,
                const std::string& prefix, RegistrationProof& proof) {
  std::vector<double> errors;
  for (const JoinedTrial& trial : trials)
    if (!(trial.*which).refused) errors.push_back(1e3 * (trial.*which).error);
  if (errors.empty()) return;
  double sum = 0.0;
  for (const double error : errors) sum += error / static_cast<double>(errors.size());
  proof.figures[prefix + "mean_mm"] = sum;
  proof.figures[prefix + "median_mm"] = upper_median(std::move(errors));
}

}  // namespace

std::vector<JoinedTrial> try_joined(const RegistrationStage& stage, std::size_t number,
                                    const RegistrationProofOptions& options, const RunContext& context) {
  std::vector<JoinedTrial> trials;
  StageRegistrar registrar(stage, context);
  for (std::size_t handling = 0; handling < stage.handled.size() && !context.cancelled(); ++handling) {
    const std::uint64_t seed = options.seed + 1000 * (number + 1) + 700 + handling;
    const Points truth = stage.by(handling).carry(stage.model.mesh.vertices);
    const LabelledCloud cloud = faulty_cloud(stage, stage, handling, kShare, RegistrationFault::none, seed);
    const auto with_look_of = [&](std::size_t moment) {
      registration::RegisterOptions joined;
      joined.looks = {look_from_elsewhere(stage, moment % stage.handled.size(), kShare, seed)};
      return found(registrar, cloud, joined, truth);
    };
    trials.push_back({stage.patient.name, insilico::handling_code(insilico::kHandlings[handling]),
                      found(registrar, cloud, {}, truth), with_look_of(handling),
                      with_look_of(handling + 1)});
  }
  return trials;
}

void sum_up(const std::vector<JoinedTrial>& trials, const std::string& set, RegistrationProof& proof) {
  if (trials.empty()) return;
  proof.table.push_back(set + ", a second look joined, mean error of all nodes, mm");
  proof.table.emplace_back("told, *: the looks do not show one shape, as those of two moments do not");
  proof.table.emplace_back(
      "patient        handled      seen    error             joined   error             two moments error");
  for (const JoinedTrial& trial : trials) {
    char name[64];
    std::snprintf(name, sizeof name, "%-14s %-8s ", trial.patient.c_str(), trial.handling.c_str());
    proof.table.push_back(name + shown(trial.alone) + "  " + shown(trial.joined) + "  " + shown(trial.moved));
  }
  const std::string prefix = "registration_" + set + "_joined_";
  proof.figures[prefix + "trials"] = static_cast<double>(trials.size());
  // Only where neither was refused are the two compared: joining is not the better for what it refused.
  std::vector<JoinedTrial> compared;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(compared),
               [](const JoinedTrial& trial) { return !trial.alone.refused && !trial.joined.refused; });
  proof.figures[prefix + "compared"] = static_cast<double>(compared.size());
  add_counts(trials, &JoinedTrial::alone, prefix + "alone_", proof);
  add_errors(compared, &JoinedTrial::alone, prefix + "alone_", proof);
  add_counts(trials, &JoinedTrial::joined, prefix, proof);
  add_errors(compared, &JoinedTrial::joined, prefix, proof);
  const std::string moved = "registration_" + set + "_moved_";
  add_counts(trials, &JoinedTrial::moved, moved, proof);
  add_errors(trials, &JoinedTrial::moved, moved, proof);
}

}  // namespace glisson::experiments
