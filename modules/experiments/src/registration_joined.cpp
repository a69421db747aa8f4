// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_joined.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
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

void add(const std::vector<JoinedTrial>& trials, JoinedTrial::Found JoinedTrial::*which,
         const std::string& prefix, RegistrationProof& proof) {
  std::vector<double> errors;
  double refused = 0.0, told = 0.0;
  for (const JoinedTrial& trial : trials) {
    const JoinedTrial::Found& one = trial.*which;
    told += one.told ? 1.0 : 0.0;
    if (one.refused)
      refused += 1.0;
    else
      errors.push_back(1e3 * one.error);
  }
  proof.figures[prefix + "refused"] = refused;
  proof.figures[prefix + "told"] = told;
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
  add(trials, &JoinedTrial::alone, prefix + "alone_", proof);
  add(trials, &JoinedTrial::joined, prefix, proof);
  add(trials, &JoinedTrial::moved, "registration_" + set + "_moved_", proof);
}

}  // namespace glisson::experiments
