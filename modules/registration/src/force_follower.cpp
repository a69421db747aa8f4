// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/force_follower.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "fit_contact_forces.h"
#include "force_fitter.h"
#include "glisson/core/error.h"

namespace glisson::registration {
namespace {

/// How many times more a cloud must tell than all before it, for the law to be chosen again. What a cloud can
/// tell is bounded (its motion is, its noise is at least the last stage's), so there are few such searches.
constexpr double kTellsMore = 1.5;
/// @throws ForeignCloud.
void require_tissue(const ContactForceFit& fit, int elements) {
  if (is_beyond_tissue(fit, elements))
    throw ForeignCloud(
        "The cloud is explained only by a shape that no tissue has: " + std::to_string(fit.inverted) +
        " elements are inside out, " + std::to_string(100.0 * fit.torn) + " % of the volume is torn.");
}

}  // namespace

struct ForceFollower::Impl {
  PatientModel model;
  CameraFromCt start;
  ContactForceOptions options;
  std::optional<ForceProblem> problem;  ///< from the second cloud on

  /// What a cloud leaves to the next one.
  struct Ended {
    LawFit law;  ///< that the cloud which tells most made most probable; the last sigma
    CameraFromCt pose;
    Points nodes_in_ct;
    std::vector<int> strongest;  ///< nodes where forces act, the strongest first
    double told_by = 0.0;        ///< the most that a cloud told for which the law was chosen
  };
  std::optional<Ended> now, before;  ///< empty: the next cloud is the first

  /// How well a cloud tells laws apart. They differ the more the farther the organ moves, and noise hides
  /// that: mean motion of the nodes from rest over the deviation of the points. No unit.
  double telling() const {
    return (now->nodes_in_ct - model.mesh.vertices).rowwise().norm().mean() / now->law.sigma;
  }

  void take(const ContactForceFit& fit, const LawFit& of, double told_by) {
    now = {of, fit.camera_from_ct, fit.camera_from_ct.inverse().apply(fit.nodes_in_camera), {}, told_by};
    for (const ContactForce& force : fit.forces) now->strongest.push_back(force.node);
  }

  Cancellable<ContactForceFit> first(const LabelledCloud& cloud, const RunContext& context) {
    auto fit = fit_contact_forces(model, cloud, start, options, context);
    if (!fit) return {};
    require_tissue(*fit, model.mesh.tetrahedron_count());
    problem.emplace(model, cloud, start, options);
    take(*fit, fit->laws[static_cast<std::size_t>(fit->chosen)], 0.0);
    now->told_by = telling();
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
    require_tissue(fit, model.mesh.tetrahedron_count());
    take(fit, fitter.law(), from.told_by);
    if (telling() > kTellsMore * now->told_by) return choose_again(cloud, std::move(fit), context);
    return fit;
  }

  /// The law is chosen anew by a cloud that tells more than all before, which was followed already. What is
  /// found from rest is kept only where it is more probable than what was followed. What the cloud told is
  /// remembered either way, so that such a search is not repeated for each cloud.
  Cancellable<ContactForceFit> choose_again(const LabelledCloud& cloud, ContactForceFit followed,
                                            const RunContext& context) {
    const Ended there = *now;
    const double told = telling();
    Cancellable<ContactForceFit> chosen = std::move(followed);
    try {
      auto found = first(cloud, context);
      if (!found) return {};
      if (log_posterior(now->law) > log_posterior(there.law))
        chosen = std::move(found);
      else
        now = there;
    } catch (const NumericalError&) {  // nothing better is found from rest
    }
    now->told_by = std::max(told, telling());
    return chosen;
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
  auto fit = impl_->now ? impl_->next(cloud, context) : impl_->first(cloud, context);
  if (!fit) impl_->now = impl_->before;
  return fit;
}

void ForceFollower::forget_last() { impl_->now = impl_->before; }

}  // namespace glisson::registration
