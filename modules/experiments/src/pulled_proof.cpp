// SPDX-License-Identifier: GPL-3.0-or-later
#include "pulled_proof.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/share_out.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/model/build.h"
#include "glisson/patient/label_map.h"
#include "pulled_trials.h"
#include "registration_patients.h"

namespace glisson::experiments {
namespace {

namespace fs = std::filesystem;

constexpr double kNoise = 1e-3;  // m
constexpr const char* kSequence = "elastic_sequence";
constexpr const char* kOthers[] = {"synthetic_101", "labels_0002"};  // of proof_patients(), development

Cancellable<BareOrgan> organ_of(const ProofPatient& patient, const PulledProofOptions& options,
                                const RunContext& context) {
  const auto loaded = load(patient, options.data, context);
  if (!loaded) return std::nullopt;
  const auto& surfaces = loaded->shown.surfaces;
  const auto liver = std::find_if(surfaces.begin(), surfaces.end(), [](const NamedSurface& one) {
    return one.structure == structure::kParenchyma;
  });
  require(liver != surfaces.end(), "a patient has a liver");
  model::MeshOptions wanted;
  wanted.target_vertices = options.nodes;
  auto mesh = model::mesh_surface(liver->mesh, wanted, context);
  if (!mesh) return std::nullopt;
  return BareOrgan{patient.name, std::move(*mesh)};
}

Cancellable<std::vector<BareOrgan>> organs(const PulledProofOptions& options,
                                           std::vector<std::string>& absent, const RunContext& context) {
  std::vector<BareOrgan> all;
  if (fs::exists(options.data / kSequence))
    all.push_back({kSequence, read_tet_mesh(options.data / kSequence / "rest.vtk", LengthUnit::millimetre)});
  else
    absent.emplace_back(kSequence);
  for (const ProofPatient& patient : proof_patients()) {
    if (std::find(std::begin(kOthers), std::end(kOthers), std::string(patient.name)) == std::end(kOthers))
      continue;
    if (patient.kind != ProofPatient::Kind::synthetic && !fs::exists(options.data / patient.path)) {
      absent.emplace_back(patient.path);
      continue;
    }
    auto organ = organ_of(patient, options, context);
    if (!organ) return std::nullopt;
    all.push_back(std::move(*organ));
  }
  return all;
}

/// What is tried, in the order of the table.
struct Task {
  const PulledKind* kind;
  std::size_t organ;
  std::uint64_t seed;
  double noise;
};

std::vector<Task> tasks(const PulledProofOptions& options, std::size_t organs) {
  std::vector<Task> all;
  for (const PulledKind& kind : kPulledKinds)
    for (const double noise : {0.0, kNoise})
      for (int k = 0; k < options.organs; ++k)
        all.push_back({&kind, static_cast<std::size_t>(k) % organs,
                       100 * options.seed + static_cast<std::uint64_t>(k), noise});
  return all;
}

double mm(double metres) { return 1e3 * metres; }

std::string told(const PulledTrial& trial) {
  std::string text = trial.refused ? "refused" : "";
  for (const std::string& doubt : trial.doubts) text += (text.empty() ? "" : " ") + doubt;
  return text;
}

std::string csv_of(const std::vector<PulledTrial>& trials) {
  std::string csv =
      "kind,organ,seed,noise_mm,moved_mm,moved_most_mm,error_mm,worst_node_mm,residual_mm,followed_mm,"
      "followed_worst_mm,frozen_mm,valid,frames,told\n";
  for (const PulledTrial& trial : trials) {
    char line[300];
    std::snprintf(line, sizeof line, "%s,%s,%llu,%.1f,%.3f,%.3f,%.4f,%.3f,%.4f,%.4f,%.4f,%.3f,%d,%d,",
                  trial.kind->code, trial.organ.c_str(), static_cast<unsigned long long>(trial.seed),
                  mm(trial.noise), mm(trial.moved), mm(trial.moved_most), mm(trial.error), mm(trial.worst),
                  mm(trial.residual), mm(trial.followed), mm(trial.followed_worst), mm(trial.frozen),
                  trial.valid, trial.frames);
    csv += line + told(trial) + "\n";
  }
  return csv;
}

/// Of one kind, with noise or without.
struct Group {
  double error = 0.0, worst = 0.0, followed = 0.0, followed_worst = 0.0;  ///< metres; sums and maxima
  int count = 0;
  void add(const PulledTrial& trial) {
    error += trial.error;
    worst = std::max(worst, trial.error);
    followed += trial.followed;
    followed_worst = std::max(followed_worst, trial.followed_worst);
    ++count;
  }
};

void sum_up(const std::vector<PulledTrial>& trials, PulledProof& proof) {
  std::map<std::string, Group> groups;
  char line[300];
  proof.table.emplace_back(
      "kind        organ             noise   moved    most    error   worst node   followed   worst   "
      "frozen  valid  told");
  for (const PulledTrial& trial : trials) {
    std::string kind = trial.kind->code;
    std::replace(kind.begin(), kind.end(), ' ', '_');
    for (const std::string& key : {kind, std::string(trial.kind->loose ? "" : "held")})
      if (!key.empty()) groups["pulled_" + key + (trial.noise > 0.0 ? "_noise" : "")].add(trial);
    std::snprintf(line, sizeof line,
                  "%-11s %-16s %6.1f %7.1f %7.1f %8.2f %12.1f %10.2f %7.2f %8.2f %3d/%-3d %s",
                  trial.kind->code, trial.organ.c_str(), mm(trial.noise), mm(trial.moved),
                  mm(trial.moved_most), mm(trial.error), mm(trial.worst), mm(trial.followed),
                  mm(trial.followed_worst), mm(trial.frozen), trial.valid, trial.frames, told(trial).c_str());
    proof.table.emplace_back(line);
  }
  for (const auto& [key, group] : groups) {
    proof.figures[key + "_mean_mm"] = mm(group.error) / group.count;
    proof.figures[key + "_worst_mm"] = mm(group.worst);
    proof.figures[key + "_followed_mean_mm"] = mm(group.followed) / group.count;
    proof.figures[key + "_followed_worst_mm"] = mm(group.followed_worst);
  }
}

}  // namespace

PulledProofOptions PulledProofOptions::quick() {
  PulledProofOptions options;
  options.organs = 2;
  return options;
}

void PulledProofOptions::validate() const {
  const OptionCheck demand("pulled proof options");
  demand(organs > 0, "organs", organs, "Give one at least");
  demand(frames > 1, "frames", frames, "Give two at least");
  demand(nodes >= 200, "nodes", nodes, "Give 200 at least");
  demand(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
}

Cancellable<PulledProof> prove_pulled(const PulledProofOptions& options, const fs::path& folder,
                                      const RunContext& context) {
  options.validate();
  PulledProof proof;
  const auto shapes = organs(options, proof.absent, context.part(0.0, 0.1));
  if (!shapes) return std::nullopt;
  const std::vector<Task> all = tasks(options, shapes->size());
  std::vector<std::optional<PulledTrial>> found(all.size());
  share_out(all.size(), options.threads, [&](std::size_t i, bool here) {
    if (context.cancelled()) return;
    if (here)
      context.progress(0.1 + 0.8 * static_cast<double>(i) / static_cast<double>(all.size()), "prove.pulled");
    found[i] = try_pulled((*shapes)[all[i].organ], *all[i].kind, all[i].seed, all[i].noise, options.frames,
                          context.quiet());
  });
  std::vector<PulledTrial> trials;
  for (auto& trial : found) {
    if (!trial) return std::nullopt;
    trials.push_back(std::move(*trial));
  }
  write_file_atomically(folder / ("pulled_" + std::to_string(options.seed) + ".csv"), csv_of(trials));
  sum_up(trials, proof);
  if (!fs::exists(options.data / kSequence)) return proof;
  const auto sequence = try_sequence(options.data / kSequence, context.part(0.9, 1.0));
  if (!sequence) return std::nullopt;
  proof.figures["sequence_moved_mm"] = mm(sequence->moved);
  proof.figures["sequence_first_mm"] = mm(sequence->error);
  proof.figures["sequence_followed_mm"] = mm(sequence->followed);
  proof.figures["sequence_followed_worst_mm"] = mm(sequence->followed_worst);
  proof.figures["sequence_frames"] = sequence->frames;
  proof.figures["sequence_valid"] = sequence->valid;
  return proof;
}

}  // namespace glisson::experiments
