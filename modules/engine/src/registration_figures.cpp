// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>

#include "glisson/engine/parts/proposals.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/refusal.h"
#include "glisson/registration/rivals.h"

namespace glisson::engine {
namespace {

/// Law, evidence and forces: N for a Young's modulus of 1 kPa.
void add_figures(Figures& figures, const registration::ContactForceFit& fit) {
  for (const registration::LawFit& law : fit.laws) {
    const std::string key = "forces_log_evidence_" + std::string(fem::body_law_code(law.material.law)) + "_" +
                            std::to_string(std::lround(100.0 * law.material.poisson_ratio));
    const auto [at, fresh] = figures.emplace(key, law.log_evidence);
    if (!fresh) at->second = std::max(at->second, law.log_evidence);
  }
  const registration::LawFit& chosen = fit.laws[static_cast<std::size_t>(fit.chosen)];
  figures["forces_law_" + std::string(fem::body_law_code(chosen.material.law))] = 1.0;
  figures["forces_poisson_ratio"] = chosen.material.poisson_ratio;
  figures["forces_ground"] = chosen.ground;
  figures["forces_sigma_mm"] = 1e3 * chosen.sigma;
  figures["forces_patches"] = fit.patches;
  figures["forces_active"] = static_cast<double>(fit.forces.size());
  double sum = 0.0;
  for (const registration::ContactForce& force : fit.forces) sum += 1e3 * force.force.norm();
  figures["forces_sum_n_per_kpa"] = sum;
}

/// Expected error of a place and half axes of its 95 % ellipsoid.
void add_spread(Figures& figures, const std::string& name, const Eigen::Matrix3d& covariance) {
  figures[name + "_expected_error_mm"] = 1e3 * registration::mean_error(covariance);
  const Eigen::Vector3d axes = registration::half_axes_95(covariance);
  for (int k = 0; k < 3; ++k)
    figures[name + "_half_axis_95_" + std::to_string(k + 1) + "_mm"] = 1e3 * axes[k];
}

void add_lesion(Figures& figures, const std::string& name, const Eigen::Matrix3d& covariance) {
  static constexpr std::array<const char*, 6> kTerms = {"xx", "yy", "zz", "xy", "yz", "xz"};
  add_spread(figures, name, covariance);
  const auto six = symmetric_row(covariance);
  for (int k = 0; k < 6; ++k)
    figures[name + "_covariance_" + kTerms[static_cast<std::size_t>(k)] + "_mm2"] = 1e6 * six[k];
}

/// Expected errors of nodes, lesions and forks, what one look would change, and other places.
void add_expected(Figures& figures, const Registration& registration) {
  const Eigen::VectorXd& nodes = registration.expected;
  if (nodes.size() > 0) {
    figures["expected_error_mean_mm"] = 1e3 * nodes.mean();
    figures["expected_error_max_mm"] = 1e3 * nodes.maxCoeff();
  }
  for (const LesionSpread& lesion : registration.lesions)
    add_lesion(figures, structure_name(lesion.lesion), lesion.covariance);
  for (const ForkSpread& fork : registration.forks) {
    add_spread(figures, fork_name(fork), fork.covariance);
    figures[fork_name(fork) + "_radius_mm"] = 1e3 * fork.radius;
  }
  for (const LesionLooks& looks : registration.looks)
    if (const auto best = registration::best_look(looks))
      figures[structure_name(looks.lesion) + "_expected_error_after_look_mm"] = 1e3 * best->after;
  figures["rivals"] = static_cast<double>(registration.rivals.size());
  for (std::size_t k = 0; k < registration.rivals.size(); ++k) {
    const std::string name = "rival_" + std::to_string(k + 1);
    figures[name + "_probability"] = registration.rivals[k].probability;
    figures[name + "_away_mm"] = 1e3 * registration::distance_of(registration.rivals[k], registration);
  }
}

void add_findings(Figures& figures, const registration::Findings& findings) {
  const auto set = [&](const char* key, double value) {
    if (std::isfinite(value)) figures[key] = value;
  };
  set("evidence_cloud_noise_mm", 1e3 * findings.roughness);
  set("evidence_misfit_mm", 1e3 * findings.misfit);
  set("evidence_held_out_mm", 1e3 * findings.held_out);
  set("evidence_strangeness", findings.strangeness);
  set("evidence_forced_mm", 1e3 * findings.forced);
  set("evidence_margin_off_mm", 1e3 * findings.margin_off);
  set("evidence_notch_off_mm", 1e3 * findings.notch_off);
  set("evidence_hidden_share", findings.hidden);
  set("evidence_turned_share", findings.turned);
  set("evidence_mirror_odds_ln", findings.mirror_odds);
  set("evidence_rival_odds_ln", findings.rival_odds);
  set("evidence_looks_differ_probability", findings.looks_differ);
  set("evidence_elsewhere_probability", findings.elsewhere);
  set("evidence_size", findings.size);
  set("evidence_size_sigma", findings.size_sigma);
  set("evidence_volume_change", findings.volume_change);
}

void add_figures(Figures& figures, const registration::Registered& made) {
  if (made.forces) add_figures(figures, *made.forces);
  const Registration& registration = made.registration;
  if (made.rigid_residual) figures["rigid_residual_mm"] = 1e3 * *made.rigid_residual;
  if (made.operations) {
    figures["operations_simulated"] = made.operations->operations;
    figures["operations_motion_mean_mm"] = 1e3 * made.operations->mean_motion;
  }
  figures["displacement_mean_mm"] = 1e3 * made.displacement.mean;
  figures["displacement_max_mm"] = 1e3 * made.displacement.maximum;
  for (std::size_t k = 0; k < made.look_distances.size(); ++k)
    figures["look_" + std::to_string(k + 1) + "_distance_mm"] = 1e3 * made.look_distances[k];
  figures["registration_steps"] = registration.steps;
  figures["registration_plateaus"] = registration.plateaus;
  // The word stands in registered.vtu and in "registration_ended" (--json).
  figures["registration_converged"] = registration.termination == Termination::converged ? 1.0 : 0.0;
}

}  // namespace

Figures figures_of(const Registration& registration) {
  Figures figures;
  add_expected(figures, registration);
  figures["registration_residual_mm"] = 1e3 * registration.residual;
  figures["registration_seen_share"] = registration.seen_share;
  figures["registration_refused"] = registration::is_refused(registration) ? 1.0 : 0.0;
  figures["registration_doubts"] = static_cast<double>(registration.doubts.size());
  return figures;
}

std::vector<std::string> notes_of(const CaseState& state, const PatientModel& model,
                                  const registration::RegisterOptions& options,
                                  const registration::ExaminedRegistration& examined) {
  std::vector<std::string> notes = examined.cloud_faults.notes();
  const auto add = [&notes](std::vector<std::string> more) {
    notes.insert(notes.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  };
  if (std::isnan(examined.findings.notch_off)) notes.emplace_back("no_notch");
  for (const Label gone : fem::lesions_not_there(options.tissue, model))
    notes.push_back("tissue.no_lesion " + structure_name(gone));
  add(landmark_notes(state));
  add(registration::look_notes(model, examined.registered.registration));
  return notes;
}

std::vector<std::string> told_of(const Registration& registration) {
  std::vector<std::string> told = registration.doubts;
  told.insert(told.end(), registration.notes.begin(), registration.notes.end());
  return told;
}

Figures figures_of(const registration::ExaminedRegistration& examined) {
  Figures figures = figures_of(examined.registered.registration);
  add_figures(figures, examined.registered);
  add_findings(figures, examined.findings);
  return figures;
}

}  // namespace glisson::engine
