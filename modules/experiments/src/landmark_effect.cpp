// SPDX-License-Identifier: GPL-3.0-or-later
#include "landmark_effect.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "glisson/core/error.h"
#include "glisson/core/random.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/parts/model.h"
#include "glisson/registration/refusal.h"
#include "of_none.h"
#include "registration_stage.h"

namespace glisson::experiments {
namespace {

constexpr std::uint64_t kFirstSeed = 9050;  // of livers that neither the built-in atlas nor the proof's has
constexpr double kNotchOff = 17.5e-3;       // metres

/// One cloud, registered with the landmarks of each source.
struct Trial {
  std::uint64_t seed = 0;
  std::string handling;
  struct Registered {
    double mean = 0.0, lesion = 0.0;  ///< errors, metres
    bool refused = false, told = false;
  };
  std::map<LandmarkSource, Registered> by;

  /// Only where no source's was refused are the sources compared: a source is not the better for having
  /// refused the hard ones.
  bool counts() const {
    return std::none_of(by.begin(), by.end(), [](const auto& one) { return one.second.refused; });
  }
};

class Study {
 public:
  Study(const LandmarkEffectOptions& options, const RunContext& context)
      : options_(options), context_(context) {}

  Cancellable<LandmarkEffect> run() {
    for (int i = 0; i < options_.patients; ++i) {
      const double width = 1.0 / options_.patients;
      if (!patient(i, context_.part(i * width, (i + 1) * width))) return {};
    }
    return summed();
  }

 private:
  bool patient(int number, const RunContext& context) {
    const auto seed = kFirstSeed + options_.seed * 100 + static_cast<std::uint64_t>(number);
    const ProofPatient patient{"synthetic", ProofSet::development, ProofPatient::Kind::synthetic,
                               static_cast<int>(seed), ""};
    const auto stage =
        build_stage(patient, {}, seed, static_cast<std::size_t>(options_.handlings), context.part(0.0, 0.3));
    if (!stage) return false;
    double done = 0.3;
    for (const LandmarkSource source : kLandmarkSources) {
      const double end = done + 0.7 / std::size(kLandmarkSources);
      if (!registered(*stage, source, seed, context.part(done, end))) return false;
      done = end;
    }
    return true;
  }

  bool registered(const RegistrationStage& stage, LandmarkSource source, std::uint64_t seed,
                  const RunContext& context) {
    const auto model = with_landmarks(stage, source, context);
    if (!model) return false;
    const Binding lesions = bind_points(model->mesh, stage.lesions, false);
    registration::KnownOperations known;
    const auto handlings = static_cast<std::size_t>(options_.handlings);
    for (std::size_t handling = 0; handling < handlings; ++handling) {
      context.progress(static_cast<double>(handling) / options_.handlings, "prove.registration");
      LabelledCloud cloud =
          faulty_cloud(stage, stage, handling, options_.share, RegistrationFault::none, seed + 10 * handling);
      if (source == LandmarkSource::none) cloud.features.clear();
      const auto made = register_model(*model, cloud, {}, context.quiet(), known);
      if (!made) return false;
      if (made->registered.operations) known = {{}, made->registered.operations};
      trial_of(seed, handling).by[source] =
          judged(made->registered.registration, stage, handling, *model, lesions);
    }
    return true;
  }

  /// The model as it would be registered. Empty: cancelled.
  Cancellable<PatientModel> with_landmarks(const RegistrationStage& stage, LandmarkSource source,
                                           const RunContext& context) {
    PatientModel model = stage.model;
    switch (source) {
      case LandmarkSource::none:
        model.landmarks = {Points(0, 3), Points(0, 3), stage.found.vena_cava};
        return model;
      case LandmarkSource::person:
        return model;
      case LandmarkSource::person_wrong:
        model.landmarks.umbilical_notch = mistaken_notch(model, context.random("prove.notch"));
        return model;
      case LandmarkSource::atlas:
        break;
    }
    model.landmarks = stage.found;
    return proposed(stage, std::move(model), context);
  }

  /// As a person gets them who accepts all that the atlas proposes.
  Cancellable<PatientModel> proposed(const RegistrationStage& stage, PatientModel model,
                                     const RunContext& context) {
    engine::CaseState state;
    state[engine::part::model] =
        std::make_shared<const model::BuiltModel>(model::BuiltModel{std::move(model), {}, {}, {}});
    auto applied = engine::ProposeLandmarks{options_.atlas}.apply(state, context.quiet());
    for (const atlas::Structure structure :
         {atlas::Structure::umbilical_notch, atlas::Structure::anterior_margin,
          atlas::Structure::vena_cava}) {
      if (!applied) return {};
      applied = engine::ReviewProposal{structure, atlas::Decision::accepted}.apply(applied->state, context);
    }
    if (!applied) return {};
    PatientModel made = engine::effective_model(applied->state);
    const Landmarks& truth = stage.handled.front().landmarks();
    if (made.landmarks.umbilical_notch.rows() > 0 && truth.umbilical_notch.rows() > 0) {
      notch_ += (made.landmarks.umbilical_notch.row(0) - truth.umbilical_notch.row(0)).norm();
      ++notches_;
    }
    return made;
  }

  Trial& trial_of(std::uint64_t seed, std::size_t handling) {
    const char* code = insilico::handling_code(insilico::kHandlings[handling]);
    for (Trial& trial : trials_)
      if (trial.seed == seed && trial.handling == code) return trial;
    trials_.push_back({seed, code, {}});
    return trials_.back();
  }

  static Trial::Registered judged(const Registration& made, const RegistrationStage& stage,
                                  std::size_t handling, const PatientModel& model, const Binding& lesions) {
    const Points truth = stage.by(handling).carry(model.mesh.vertices);
    const Points off =
        lesions.apply(model.mesh, made.nodes_in_camera) - stage.by(handling).carry(stage.lesions);
    return {(made.nodes_in_camera - truth).rowwise().norm().mean(), off.rowwise().norm().maxCoeff(),
            registration::is_refused(made), !made.doubts.empty()};
  }

  /// Means over the trials that count, and how many of all were told.
  void sum_up(LandmarkSource source, LandmarkEffect& effect) const {
    double mean = 0.0, lesion = 0.0;
    int count = 0, refused = 0, told = 0;
    for (const Trial& trial : trials_) {
      const Trial::Registered& one = trial.by.at(source);
      refused += one.refused;
      told += one.told;
      if (!trial.counts()) continue;
      mean += one.mean;
      lesion += one.lesion;
      ++count;
    }
    const auto millimetres = [&](double sum) { return count > 0 ? 1e3 * sum / count : std::nan(""); };
    const char* code = landmark_source_code(source);
    const std::string prefix = std::string("effect_") + code + "_";
    effect.figures[prefix + "mean_mm"] = millimetres(mean);
    effect.figures[prefix + "lesion_mm"] = millimetres(lesion);
    effect.figures[prefix + "told"] = told;
    effect.figures["effect_compared"] = count;
    char line[120];
    std::snprintf(line, sizeof line, "%-13s %8d %8s %10s %8d %5d", code, count,
                  figure_text("%.2f", millimetres(mean)).c_str(),
                  figure_text("%.2f", millimetres(lesion)).c_str(), refused, told);
    effect.table.emplace_back(line);
  }

  LandmarkEffect summed() const {
    LandmarkEffect effect;
    effect.table.emplace_back("landmarks     compared  mean mm  lesion mm  refused  told");
    for (const LandmarkSource source : kLandmarkSources) sum_up(source, effect);
    std::string heads = "mean mm of liver  handled ";
    for (const LandmarkSource source : kLandmarkSources)
      heads += std::string("  ") + landmark_source_code(source);
    effect.table.push_back(heads);
    for (const Trial& trial : trials_) {
      char line[160];
      std::snprintf(line, sizeof line, "%16llu  %-8s", static_cast<unsigned long long>(trial.seed),
                    trial.handling.c_str());
      std::string row = line;
      for (const LandmarkSource source : kLandmarkSources) {
        const Trial::Registered& one = trial.by.at(source);
        row += "  " + figure_text("%.1f", 1e3 * one.mean) + (one.refused ? " refused" : "");
      }
      effect.table.push_back(row);
    }
    effect.figures["effect_trials"] = static_cast<double>(trials_.size());
    effect.figures["effect_atlas_over_none"] =
        effect.figures["effect_atlas_mean_mm"] / effect.figures["effect_none_mean_mm"];
    effect.figures["effect_atlas_notch_mm"] = notches_ > 0 ? 1e3 * notch_ / notches_ : std::nan("");
    return effect;
  }

  const LandmarkEffectOptions& options_;
  RunContext context_;
  std::vector<Trial> trials_;
  double notch_ = 0.0;
  int notches_ = 0;
};

}  // namespace

const char* landmark_source_code(LandmarkSource source) {
  switch (source) {
    case LandmarkSource::none:
      return "none";
    case LandmarkSource::person:
      return "person";
    case LandmarkSource::person_wrong:
      return "person_wrong";
    case LandmarkSource::atlas:
      break;
  }
  return "atlas";
}

Points mistaken_notch(const PatientModel& model, std::mt19937_64 random) {
  const Eigen::RowVector3d notch = model.landmarks.umbilical_notch.row(0);
  const Points& nodes = model.mesh.vertices;
  const Eigen::RowVector3d side = standard_normal3(random).transpose();
  Points best(1, 3);
  double least = std::numeric_limits<double>::infinity();
  for (const int node : model.surface.node_of_vertex) {
    const Eigen::RowVector3d way = nodes.row(node) - notch;
    const double off = std::abs(way.norm() - kNotchOff);
    const double cost = way.dot(side) > 0.0 ? off : off + kNotchOff;
    if (cost < least) least = cost, best.row(0) = nodes.row(node);
  }
  return best;
}

void LandmarkEffectOptions::validate() const {
  if (!atlas) throw InputError("landmark effect", "atlas", "is not there", "Give an atlas");
  const OptionCheck demand("landmark effect");
  demand(patients > 0, "patients", patients, "Give one at least");
  static_assert(std::size(insilico::kHandlings) == 10);
  demand(handlings > 0 && handlings <= 10, "handlings", handlings, "Give 1 to 10");
  demand(share > 0.0 && share <= 1.0, "share", share, "Give a share in (0, 1]");
}

Cancellable<LandmarkEffect> measure_landmark_effect(const LandmarkEffectOptions& options,
                                                    const RunContext& context) {
  options.validate();
  return Study(options, context).run();
}

}  // namespace glisson::experiments
