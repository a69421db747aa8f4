// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/contact_forces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <memory>
#include <thread>

#include "force_fitter.h"
#include "glisson/core/error.h"

namespace glisson::registration {
namespace {

/// Fits that do not depend on each other, on one thread or two: each is one thread's from start to end, so
/// that its bits are the same. @return false: cancelled.
class Fits {
 public:
  Fits(const ForceProblem& problem, const RunContext& context, double share_done, double share)
      : problem_(problem), context_(context), from_(share_done), share_(share) {}

  bool run(const std::vector<std::pair<fem::BodyMaterial, double>>& tasks) {
    for (const auto& [material, ground] : tasks)
      fitters_.push_back(std::make_unique<ForceFitter>(problem_, material, ground));
    std::exception_ptr error;
    std::thread second;
    if (problem_.options.threads > 1 && tasks.size() > 1)
      second = std::thread([&] {
        try {
          work(false);
        } catch (...) {
          error = std::current_exception();
        }
      });
    std::exception_ptr own;
    try {
      work(true);
    } catch (...) {
      own = std::current_exception();
      next_ = fitters_.size();
    }
    if (second.joinable()) second.join();
    if (own) std::rethrow_exception(own);
    if (error) std::rethrow_exception(error);
    return !cancelled_;
  }
  std::vector<std::unique_ptr<ForceFitter>>& all() { return fitters_; }

 private:
  /// @param reports progress is told by one thread alone.
  void work(bool reports) {
    for (std::size_t k = next_++; k < fitters_.size(); k = next_++) {
      const auto advance = [&] {
        const int done = ++stages_;
        const auto all = static_cast<double>(fitters_.size() * problem_.options.sigmas.size());
        if (reports) context_.progress(from_ + share_ * std::min(1.0, done / all), "registration.forces");
      };
      if (!fitters_[k]->run(context_, advance)) cancelled_ = true;
      if (cancelled_) return;
    }
  }

  const ForceProblem& problem_;
  const RunContext& context_;
  double from_, share_;
  std::vector<std::unique_ptr<ForceFitter>> fitters_;
  std::atomic<std::size_t> next_{0};
  std::atomic<int> stages_{0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace

void ContactForceOptions::validate() const {
  const OptionCheck demand("contact forces");
  demand(!materials.empty(), "materials", 0.0, "Give one law at least");
  for (const auto& material : materials)
    demand(material.poisson_ratio > -1.0 && material.poisson_ratio < 0.5, "poisson_ratio",
           material.poisson_ratio, "Give a number between -1 and 0.5");
  demand(!sigmas.empty(), "sigmas", 0.0, "Give one stage at least");
  for (const double sigma : sigmas)
    demand(sigma > 0.0 && std::isfinite(sigma), "sigmas", sigma, "Give positive lengths in metres");
  demand(!grounds.empty(), "grounds", 0.0, "Give one stiffness at least");
  for (const double ground : grounds)
    demand(ground > 0.0 && std::isfinite(ground), "grounds", ground, "Give positive numbers");
  demand(patch_spacing > 0.0, "patch_spacing", patch_spacing, "Give a positive length in metres");
  demand(patch_radius > 0.0, "patch_radius", patch_radius, "Give a positive length in metres");
  demand(patch_reach > 0.0, "patch_reach", patch_reach, "Give a positive length in metres");
  demand(iterations > 0, "iterations", iterations, "Give one at least");
  demand(outlier_distance > 0.0, "outlier_distance", outlier_distance, "Give a positive length in metres");
  demand(max_step > 0.0, "max_step", max_step, "Give a positive length in metres");
  demand(most_points >= 10, "most_points", most_points, "Give ten at least");
  demand(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
}

Cancellable<ContactForceFit> fit_contact_forces(const PatientModel& model, const LabelledCloud& cloud,
                                                const CameraFromCt& start, const ContactForceOptions& options,
                                                const RunContext& context) {
  options.validate();
  const ForceProblem problem(model, cloud, start, options);
  std::vector<std::pair<fem::BodyMaterial, double>> tasks;
  for (const auto& material : options.materials)
    for (const double ground : problem.free_pose ? options.grounds : std::vector<double>{0.0})
      tasks.emplace_back(material, ground);
  Fits fits(problem, context, 0.0, 1.0);
  if (!fits.run(tasks)) return std::nullopt;
  const auto best = std::max_element(fits.all().begin(), fits.all().end(), [](const auto& a, const auto& b) {
    return a->law().log_evidence < b->law().log_evidence;
  });
  if (!std::isfinite((*best)->law().log_evidence))
    throw NumericalError("No equilibrium under contact forces was found: the mesh may have flat elements.");
  ContactForceFit fit = (*best)->result();
  fit.chosen = static_cast<int>(best - fits.all().begin());
  for (const auto& fitter : fits.all()) fit.laws.push_back(fitter->law());
  context.progress(1.0, "registration.forces");
  return fit;
}

}  // namespace glisson::registration
