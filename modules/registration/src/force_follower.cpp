// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/force_follower.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "force_fitter.h"
#include "glisson/core/error.h"

namespace glisson::registration {
namespace {

constexpr double kTellsMore = 1.5;

}  // namespace

struct ForceFollower::Impl {
  PatientModel model;
  CameraFromCt start;
  ContactForceOptions options;
  std::optional<ForceProblem> problem;  ///< from the second cloud on

  /// What a cloud leaves to the next one.
  struct Ended {
    LawFit law;  ///< that the first cloud made most probable; its last sigma
    CameraFromCt pose;
    Points nodes_in_ct;
    std::vector<int> strongest;  ///< nodes where forces act, the strongest first
    double told_by = 0.0;        ///< mean motion of the nodes from rest, m, under which the law was chosen
  };
  std::optional<Ended> now, before;  ///< empty: the next cloud is the first

  double motion() const { return (now->nodes_in_ct - model.mesh.vertices).rowwise().norm().mean(); }

  void take(const ContactForceFit& fit, const LawFit& of, double told_by) {
    now = {of, fit.camera_from_ct, fit.camera_from_ct.inverse().apply(fit.nodes_in_camera), {}, told_by};
    for (const ContactForce& force : fit.forces) now->strongest.push_back(force.node);
  }

  Cancellable<ContactForceFit> first(const LabelledCloud& cloud, const RunContext& context) {
    auto fit = fit_contact_forces(model, cloud, start, options, context);
    if (!fit) return {};
    problem.emplace(model, cloud, start, options);
    take(*fit, fit->laws[static_cast<std::size_t>(fit->chosen)], 0.0);
    now->told_by = motion();
    return fit;
  }

  Cancellable<ContactForceFit> next(const LabelledCloud& cloud, const RunContext& context) {
    problem->take(cloud);
    const Ended& from = *now;
    ForceFitter fitter(*problem, from.law.material, from.law.ground);
    fitter.begin_at(from.pose, from.nodes_in_ct, from.strongest,
                    2.0 * std::max(from.law.sigma, fitter.apart(from.pose, from.nodes_in_ct)));
    double stages = 0.0;
    const auto advance = [&] {
      context.progress(++stages / static_cast<double>(options.sigmas.size()), "registration.forces");
    };
    if (!fitter.run(context, advance)) return {};
    if (!std::isfinite(fitter.law().log_evidence))
      throw NumericalError("No equilibrium under contact forces was found for this cloud.");
    ContactForceFit fit = fitter.result();
    fit.laws = {fitter.law()};
    fit.chosen = 0;
    take(fit, fitter.law(), from.told_by);
    // Laws differ the more the farther the organ moves: what a small motion chose is chosen again.
    if (motion() > kTellsMore * now->told_by) return first(cloud, context);
    return fit;
  }
};

ForceFollower::ForceFollower(const PatientModel& model, const CameraFromCt& start,
                             const ContactForceOptions& options)
    : impl_(std::make_unique<Impl>()) {
  options.validate();
  impl_->model = model;
  impl_->start = start;
  impl_->options = options;
}

ForceFollower::~ForceFollower() = default;
ForceFollower::ForceFollower(ForceFollower&&) noexcept = default;
ForceFollower& ForceFollower::operator=(ForceFollower&&) noexcept = default;

Cancellable<ContactForceFit> ForceFollower::follow(const LabelledCloud& cloud, const RunContext& context) {
  impl_->before = impl_->now;
  return impl_->now ? impl_->next(cloud, context) : impl_->first(cloud, context);
}

void ForceFollower::forget_last() { impl_->now = impl_->before; }

}  // namespace glisson::registration
