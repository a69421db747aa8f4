// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_contact_forces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "force_fitter.h"
#include "glisson/core/error.h"
#include "glisson/core/share_out.h"

namespace glisson::registration {
namespace {

/// Logarithm of the linear law's prior odds, 1 to 20. It takes rotations for strains, which tissue does not,
/// so it is chosen only where the cloud clearly asks for it.
constexpr double kLinearPrior = -3.0;

/// Independent fits, on one thread or two. Each is computed by one thread from start to end, so its bits do
/// not depend on the number of threads.
class Fits {
 public:
  Fits(const ForceProblem& problem, const RunContext& context) : problem_(problem), context_(context) {}

  void add(const fem::BodyMaterial& material, double ground) {
    fitters_.push_back(std::make_unique<ForceFitter>(problem_, material, ground));
  }

  /// The last one added begins where the most probable one has ended.
  void begin_at_best() { fitters_.back()->begin_at(best()); }

  /// The last one added begins in another place.
  void begin_at(std::size_t place) {
    fitters_.back()->begin_at(problem_.options.other_places[place], place + 1);
  }

  /// Runs those added since. @param from, to share of the work, for the progress. @return false: cancelled.
  bool run(double from, double to) {
    stages_ = 0;
    const std::size_t pieces = fitters_.size() - done_;
    const auto stages = static_cast<double>(pieces * problem_.options.sigmas.size());
    share_out(pieces, problem_.options.threads, [&](std::size_t piece, bool here) {
      const auto advance = [&] {
        const double share = std::min(1.0, ++stages_ / stages);
        if (here) context_.progress(from + (to - from) * share, "registration.forces");
      };
      if (!cancelled_ && !fitters_[done_ + piece]->run(context_, advance)) cancelled_ = true;
    });
    done_ = fitters_.size();
    return !cancelled_;
  }

  /// Laws that were still moving begin again where the most probable one has ended. The better of both stays.
  /// Not beside operations, as ForceFitter::settle().
  bool settle(double from, double to) {
    if (problem_.options.prior || !std::isfinite(best().law().log_evidence)) return true;
    std::vector<std::size_t> moving;
    for (std::size_t k = 0; k < done_; ++k) {
      const LawFit& law = fitters_[k]->law();
      const bool is_settled = k == best_index() || law.termination == Termination::converged;
      if (is_settled || law.ground != best().law().ground) continue;
      moving.push_back(k);
      add(law.material, law.ground);
      begin_at_best();
    }
    const std::size_t first = done_;
    if (!run(from, to)) return false;
    for (std::size_t i = 0; i < moving.size(); ++i)
      if (log_posterior(fitters_[first + i]->law()) > log_posterior(fitters_[moving[i]]->law()))
        std::swap(fitters_[first + i], fitters_[moving[i]]);
    fitters_.resize(done_ = first);
    return true;
  }

  const ForceFitter& best() const { return *fitters_[best_index()]; }

  /// The most probable law's, and what the others say of it.
  ContactForceFit chosen() const {
    ContactForceFit fit = best().result();
    fit.chosen = static_cast<int>(best_index());
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(fit.expected_error.size());
    double total = 0.0;
    for (const auto& fitter : fitters_) {
      fit.laws.push_back(fitter->law());
      if (!std::isfinite(fitter->law().log_evidence)) continue;
      const ContactForceFit other = fitter->result();
      const Eigen::VectorXd away = (other.nodes_in_camera - fit.nodes_in_camera).rowwise().norm();
      fit.laws.back().away = away.mean();
      const double probability = std::exp(log_posterior(fitter->law()) - log_posterior(best().law()));
      squares += probability * (other.expected_error.cwiseAbs2() + away.cwiseAbs2());
      total += probability;
      if (fitter.get() != &best())
        fit.others.push_back(
            {other.nodes_in_camera, log_posterior(fitter->law()) - log_posterior(best().law())});
    }
    fit.expected_error = (squares / total).cwiseSqrt();
    return fit;
  }

 private:
  std::size_t best_index() const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < done_; ++k)
      if (log_posterior(fitters_[k]->law()) > log_posterior(fitters_[best]->law())) best = k;
    return best;
  }

  const ForceProblem& problem_;
  const RunContext& context_;
  std::vector<std::unique_ptr<ForceFitter>> fitters_;
  std::size_t done_ = 0;
  std::atomic<int> stages_{0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace

double log_posterior(const LawFit& law) {
  return law.log_evidence + (law.material.law == fem::BodyLaw::linear ? kLinearPrior : 0.0);
}

void ContactForceOptions::validate() const {
  const OptionCheck demand("contact forces");
  demand(!materials.empty(), "materials", 0.0, "Give 1 or more");
  for (const auto& material : materials)
    demand(material.poisson_ratio > -1.0 && material.poisson_ratio < 0.5, "poisson_ratio",
           material.poisson_ratio, "Give a number between -1 and 0.5");
  for (const double ratio : poisson_ratios)
    demand(ratio > -1.0 && ratio < 0.5, "poisson_ratios", ratio, "Give numbers between -1 and 0.5");
  demand(!sigmas.empty(), "sigmas", 0.0, "Give 1 or more");
  for (const double sigma : sigmas)
    demand(sigma > 0.0 && std::isfinite(sigma), "sigmas", sigma, "Give positive lengths in metres");
  demand(!grounds.empty(), "grounds", 0.0, "Give 1 or more");
  for (const double ground : grounds)
    demand(ground > 0.0 && std::isfinite(ground), "grounds", ground, "Give positive numbers");
  demand(patch_spacing > 0.0, "patch_spacing", patch_spacing, "Give a positive length in metres");
  demand(patch_radius > 0.0, "patch_radius", patch_radius, "Give a positive length in metres");
  demand(patch_reach > 0.0, "patch_reach", patch_reach, "Give a positive length in metres");
  demand(!information || (*information > 0.0 && *information <= 1.0), "information",
         information.value_or(1.0), "Give a share above 0, at most 1");
  demand(patch_price >= 0.0 && std::isfinite(patch_price), "patch_price", patch_price,
         "Give a number from zero");
  demand(iterations > 0, "iterations", iterations, "Give 1 or more");
  demand(outlier_distance > 0.0, "outlier_distance", outlier_distance, "Give a positive length in metres");
  demand(max_step > 0.0, "max_step", max_step, "Give a positive length in metres");
  demand(most_points >= 10, "most_points", most_points, "Give 10 or more");
  demand(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
}

bool is_law_ambiguous(const ContactForceFit& fit) {
  constexpr double kRival = 5.0;
  constexpr double kOtherShape = 5e-3;  // m
  const LawFit& law = fit.laws[static_cast<std::size_t>(fit.chosen)];
  return std::any_of(fit.laws.begin(), fit.laws.end(), [&](const LawFit& rival) {
    return rival.material != law.material && rival.ground == law.ground && rival.place == law.place &&
           log_posterior(rival) > log_posterior(law) - kRival && rival.away > kOtherShape;
  });
}

bool is_beyond_tissue(const ContactForceFit& fit, int elements) {
  constexpr int kFew = 5, kOneIn = 1000;
  constexpr double kTorn = 0.02;
  return fit.inverted > std::max(kFew, elements / kOneIn) || fit.torn > kTorn;
}

Cancellable<ContactForceFit> fit_contact_forces(const PatientModel& model, const LabelledCloud& cloud,
                                                const CameraFromCt& start, const ContactForceOptions& options,
                                                const RunContext& context) {
  options.validate();
  const ForceProblem problem(model, cloud, start, options);
  Fits fits(problem, context);
  double ground = 0.0;
  if (problem.grounded) {
    const fem::BodyMaterial& material = options.materials.back();
    for (const double one : options.grounds) fits.add(material, one);
    if (!fits.run(0.0, 0.4)) return std::nullopt;
    ground = fits.best().law().ground;
  }
  for (const auto& material : options.materials)
    if (!problem.grounded || material != options.materials.back()) fits.add(material, ground);
  if (!fits.run(problem.grounded ? 0.4 : 0.0, 0.6) || !fits.settle(0.6, 0.7)) return std::nullopt;
  fem::BodyMaterial material = fits.best().law().material;
  if (problem.free_pose)
    for (std::size_t place = 0; place < options.other_places.size(); ++place) {
      fits.add(material, ground);
      fits.begin_at(place);
    }
  if (!fits.run(0.7, 0.9)) return std::nullopt;
  material = fits.best().law().material;
  for (const double ratio : options.poisson_ratios)
    if (ratio != material.poisson_ratio) {
      fits.add({material.law, ratio}, ground);
      fits.begin_at_best();
    }
  if (!fits.run(0.9, 1.0)) return std::nullopt;
  if (!std::isfinite(fits.best().law().log_evidence))
    throw NumericalError("No equilibrium under contact forces was found: the mesh may have flat elements.");
  ContactForceFit fit = fits.chosen();
  context.progress(1.0, "registration.forces");
  return fit;
}

}  // namespace glisson::registration
