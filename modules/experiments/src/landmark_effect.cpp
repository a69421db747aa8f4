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

/// Errors of one source's registrations, metres.
struct Sum {
  double mean = 0.0, lesion = 0.0;
  int count = 0, told = 0, refused = 0;
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
    const auto stage = build_stage(patient, {}, seed, context.part(0.0, 0.3));
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
    for (std::size_t handling = 0; handling < stage.handled.size(); ++handling) {
      context.progress(static_cast<double>(handling) / static_cast<double>(stage.handled.size()),
                       "prove.registration");
      LabelledCloud cloud =
          faulty_cloud(stage, stage, handling, options_.share, RegistrationFault::none, seed + 10 * handling);
      if (source == LandmarkSource::none) cloud.features.clear();
      const auto made = register_model(*model, cloud, {}, context.quiet(), known);
      if (!made) return false;
      if (made->registered.operations) known = {{}, made->registered.operations};
      add(made->registered.registration, stage, handling, *model, lesions, sums_[source]);
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

  static void add(const Registration& made, const RegistrationStage& stage, std::size_t handling,
                  const PatientModel& model, const Binding& lesions, Sum& sum) {
    sum.told += !made.doubts.empty();
    if (registration::is_refused(made)) {
      ++sum.refused;
      return;
    }
    const Points truth = stage.by(handling).carry(model.mesh.vertices);
    const Points off =
        lesions.apply(model.mesh, made.nodes_in_camera) - stage.by(handling).carry(stage.lesions);
    sum.mean += (made.nodes_in_camera - truth).rowwise().norm().mean();
    sum.lesion += off.rowwise().norm().maxCoeff();
    ++sum.count;
  }

  LandmarkEffect summed() {
    LandmarkEffect effect;
    effect.table.emplace_back("landmarks     trials  mean mm  lesion mm  refused  told");
    const auto mean = [](double sum, int count) { return count > 0 ? 1e3 * sum / count : std::nan(""); };
    for (const LandmarkSource source : kLandmarkSources) {
      const Sum& sum = sums_[source];
      const std::string prefix = std::string("effect_") + landmark_source_code(source) + "_";
      effect.figures[prefix + "mean_mm"] = mean(sum.mean, sum.count);
      effect.figures[prefix + "lesion_mm"] = mean(sum.lesion, sum.count);
      effect.figures[prefix + "told"] = sum.told;
      char line[120];
      std::snprintf(line, sizeof line, "%-13s %6d %8s %10s %8d %5d", landmark_source_code(source),
                    sum.count + sum.refused, figure_text("%.2f", mean(sum.mean, sum.count)).c_str(),
                    figure_text("%.2f", mean(sum.lesion, sum.count)).c_str(), sum.refused, sum.told);
      effect.table.emplace_back(line);
    }
    const Sum& none = sums_[LandmarkSource::none];
    effect.figures["effect_trials"] = none.count + none.refused;
    effect.figures["effect_atlas_over_none"] =
        effect.figures["effect_atlas_mean_mm"] / effect.figures["effect_none_mean_mm"];
    effect.figures["effect_atlas_notch_mm"] = mean(notch_, notches_);
    return effect;
  }

  const LandmarkEffectOptions& options_;
  RunContext context_;
  std::map<LandmarkSource, Sum> sums_;
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
  const Eigen::RowVector3d side(standard_normal(random), standard_normal(random), standard_normal(random));
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
  demand(share > 0.0 && share <= 1.0, "share", share, "Give a share in (0, 1]");
}

Cancellable<LandmarkEffect> measure_landmark_effect(const LandmarkEffectOptions& options,
                                                    const RunContext& context) {
  options.validate();
  return Study(options, context).run();
}

}  // namespace glisson::experiments
