// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_trials.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "glisson/core/chi_square.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/stopwatch.h"
#include "glisson/geometry/rigid.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/refusal.h"

namespace glisson::experiments {
namespace {

void add_figures(const registration::Findings& findings, Figures& figures) {
  figures["roughness_mm"] = 1e3 * findings.roughness;
  figures["misfit_mm"] = 1e3 * findings.misfit;
  figures["held_out_mm"] = 1e3 * findings.held_out;
  figures["held_out_z"] = findings.held_out_z;
  figures["strangeness"] = findings.strangeness;
  figures["forced_mm"] = 1e3 * findings.forced;
  figures["margin_off_mm"] = 1e3 * findings.margin_off;
  figures["notch_off_mm"] = 1e3 * findings.notch_off;
  figures["hidden"] = findings.hidden;
  figures["turned"] = findings.turned;
  figures["mirror_odds"] = findings.mirror_odds;
  figures["rival_odds"] = findings.rival_odds;
  figures["elsewhere"] = findings.elsewhere;
  figures["size"] = findings.size;
  figures["size_sigma"] = findings.size_sigma;
  figures["volume_change"] = findings.volume_change;
  figures["expected_mm"] = 1e3 * findings.expected;
}

/// One patient's registrations; operations are simulated once.
class Trials {
 public:
  Trials(const RegistrationStage& stage, const RegistrationProofOptions& options, TrialLog& log,
         const RunContext& context)
      : stage_(stage),
        options_(options),
        log_(log),
        context_(context),
        lesions_(bind_points(stage.model.mesh, stage.lesions, false)),
        registrar_(stage, context) {}

  bool run(const ShownLiver& shown, std::size_t handling, double share, RegistrationFault fault) {
    RegistrationTrial trial;
    trial.patient = stage_.patient.name;
    trial.set = stage_.patient.set;
    trial.handling = insilico::handling_code(insilico::kHandlings[handling]);
    trial.share = share;
    trial.fault = fault;
    if (log_.has(trial)) return true;
    registration::RegisterOptions options;
    options.looks = shown.others;
    if (fault == RegistrationFault::wrong_start) {
      options.start = registration::RegisterOptions::Start::given;
      options.given = mistaken(stage_, handling);
    }
    trial.rigid_mean = rigid_mean(handling);
    const Stopwatch watch;
    try {
      const auto examined = registrar_.run(shown.cloud, options);
      if (!examined) return false;
      const registration::Registered* made = &examined->registered;
      trial.doubts = made->registration.doubts;
      trial.refused = registration::is_refused(made->registration);
      compare(*examined, handling, fault, trial);
    } catch (const Error&) {  // no result: nobody is misled
      trial.refused = true;
      trial.mean = std::numeric_limits<double>::infinity();
      trial.lesions.assign(static_cast<std::size_t>(stage_.lesions.rows()), trial.mean);
    }
    trial.seconds = watch.seconds();
    const bool compares = fault == RegistrationFault::none && share == kFaultShare;
    if (options_.rivals && compares && !add_paper(shown.cloud, handling, trial)) return false;
    log_.add(std::move(trial));
    return true;
  }

 private:
  /// What no rigid motion explains, however the registration goes. Metres.
  double rigid_mean(std::size_t handling) const {
    const Points& rest = stage_.model.mesh.vertices;
    const Points truth = stage_.by(handling).carry(rest);
    return (fit_rigid<CameraFrame, CtFrame>(rest, truth).apply(rest) - truth).rowwise().norm().mean();
  }

  void compare(const registration::ExaminedRegistration& examined, std::size_t handling,
               RegistrationFault fault, RegistrationTrial& trial) const {
    const registration::Registered& made = examined.registered;
    const Points truth = stage_.by(handling).carry(stage_.model.mesh.vertices);
    const Points true_lesions = stage_.by(handling).carry(stage_.lesions);
    const Points found = lesions_.apply(stage_.model.mesh, made.registration.nodes_in_camera);
    const bool shown = shows_the_organ(fault);
    const double never = std::numeric_limits<double>::infinity();
    trial.mean = shown ? (made.registration.nodes_in_camera - truth).rowwise().norm().mean() : never;
    for (Eigen::Index i = 0; i < found.rows(); ++i)
      trial.lesions.push_back(shown ? (found.row(i) - true_lesions.row(i)).norm() : never);
    add_expected(*examined.error, found, true_lesions, trial);
    add_figures(examined.findings, trial.figures);
    trial.figures["seen_share"] = made.registration.seen_share;
    trial.figures["residual_mm"] = 1e3 * made.registration.residual;
    trial.figures["rigid_residual_mm"] = 1e3 * made.rigid_residual.value_or(0.0);
  }

  /// What the registration expects of the lesions' errors, and whether the truth lies in the ellipsoids.
  void add_expected(const registration::ErrorModel& error, const Points& found, const Points& truth,
                    RegistrationTrial& trial) const {
    const auto covariances = error.covariances(stage_.model.mesh, lesions_);
    for (std::size_t i = 0; i < covariances.size(); ++i) {
      const Eigen::Vector3d off =
          (found.row(static_cast<Eigen::Index>(i)) - truth.row(static_cast<Eigen::Index>(i))).transpose();
      trial.expected.push_back(registration::mean_error(covariances[i]));
      const double square = off.dot(covariances[i].ldlt().solve(off));
      trial.figures["lesion_" + std::to_string(i + 1) + "_square"] = square;
    }
    trial.cover();
  }

  bool add_paper(const LabelledCloud& cloud, std::size_t handling, RegistrationTrial& trial) const {
    registration::RegisterOptions paper;
    paper.method = registration::Method::paper;
    const auto made = register_model(stage_.model, cloud, paper, context_);
    if (!made) return false;
    trial.paper_mean = (made->registered.registration.nodes_in_camera -
                        stage_.by(handling).carry(stage_.model.mesh.vertices))
                           .rowwise()
                           .norm()
                           .mean();
    return true;
  }

  const RegistrationStage& stage_;
  const RegistrationProofOptions& options_;
  TrialLog& log_;
  RunContext context_;
  Binding lesions_;
  StageRegistrar registrar_;
};

}  // namespace

double RegistrationTrial::worst_lesion() const {
  return lesions.empty() ? mean : *std::max_element(lesions.begin(), lesions.end());
}

void RegistrationTrial::cover() {
  covered.clear();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto square = figures.find("lesion_" + std::to_string(i + 1) + "_square");
    covered.push_back(square != figures.end() && square->second < kEllipsoid95 ? 1 : 0);
  }
}

TrialLog::TrialLog(std::filesystem::path csv, const std::filesystem::path& former) : csv_(std::move(csv)) {
  if (!former.empty() && std::filesystem::exists(former)) trials_ = trials_of(read_file(former), former);
}

bool TrialLog::has(const RegistrationTrial& trial) const {
  const std::lock_guard lock(mutex_);
  return std::any_of(trials_.begin(), trials_.end(), [&](const RegistrationTrial& one) {
    return one.patient == trial.patient && one.handling == trial.handling && one.fault == trial.fault &&
           std::abs(one.share - trial.share) < 1e-6;
  });
}

void TrialLog::add(RegistrationTrial trial) {
  const std::lock_guard lock(mutex_);
  trials_.push_back(std::move(trial));
  write_file_atomically(csv_, csv_of(trials_));
}

std::vector<RegistrationTrial> TrialLog::trials() const {
  const std::lock_guard lock(mutex_);
  return trials_;
}

void run_trials(const RegistrationStage& stage, const RegistrationStage& other,
                const RegistrationProofOptions& options, std::size_t number, TrialLog& log,
                const RunContext& context) {
  Trials trials(stage, options, log, context);
  const auto seed = [&](std::size_t k) { return options.seed + 1000 * (number + 1) + k; };
  for (std::size_t handling = 0; handling < stage.handled.size(); ++handling)
    for (std::size_t s = 0; s < options.shares.size(); ++s) {
      if (handling >= kMuchTriedHandlings && options.shares[s] != kFaultShare) continue;
      const ShownLiver shown = shown_liver(stage, handling, options.shares[s], seed(10 * handling + s));
      if (!trials.run(shown, handling, options.shares[s], RegistrationFault::none)) return;
    }
  for (const RegistrationFault fault : kRegistrationFaults) {
    if (fault == RegistrationFault::none) continue;
    const auto k = static_cast<std::size_t>(fault);
    const std::size_t handling = (number + k) % std::min(kMuchTriedHandlings, stage.handled.size());
    const LabelledCloud cloud = faulty_cloud(stage, other, handling, kFaultShare, fault, seed(100 + k));
    if (!trials.run({cloud, {}}, handling, kFaultShare, fault)) break;
  }
}

}  // namespace glisson::experiments
