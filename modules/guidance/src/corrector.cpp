// SPDX-License-Identifier: GPL-3.0-or-later
#include "corrector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "node_place.h"

namespace glisson::guidance {
namespace {

/// Metres; see the class.
constexpr double kBody = 10e-3, kShape = 4e-3, kReach = 35e-3;
/// Metres: how far tracked tissue lies off the surface of a right model (stereo's depth, the coarse mesh).
constexpr double kSurface = 2e-3;
/// The points' errors are alike (calibration, the coarse mesh): all together count as so many independent
/// ones at the most.
constexpr double kIndependent = 30.0;
/// How often the closest places are looked for anew, and Newton's steps after each time.
constexpr int kPairings = 4, kSteps = 8;
constexpr double kTolerance = 1e-4, kUseless = 1e-1;

void add_body(const Points& registered, const Eigen::VectorXd& mass, double stiffness, const Points& now,
              std::vector<fem::AttachedLoad>& loads) {
  const double each = stiffness / mass.sum();
  for (Eigen::Index i = 0; i < registered.rows(); ++i) {
    fem::AttachedLoad load;
    load.nodes[0] = static_cast<int>(i);
    load.weights[0] = 1.0;
    load.tangent = each * mass[i] * Eigen::Matrix3d::Identity();
    load.force = load.tangent * (registered.row(i) - now.row(i)).transpose();
    loads.push_back(load);
  }
}

void add_pull(const SightPull& pull, double temperature, const Points& now,
              std::vector<fem::AttachedLoad>& loads) {
  fem::AttachedLoad load;
  load.nodes = pull.nodes;
  load.weights = pull.weights;
  load.tangent = temperature / (pull.sigma * pull.sigma) *
                 (Eigen::Matrix3d::Identity() - pull.sight * pull.sight.transpose());
  load.force = load.tangent * (pull.target - pull.place(now));
  loads.push_back(load);
}

/// Tracked tissue against the surface, its closest places kept.
struct Slide {
  registration::Carrier carrier;
  Eigen::Vector3d tissue, normal;
  double stiffness;
};

std::vector<Slide> slides(const registration::MovingSurface& surface, const Points& tracked,
                          double temperature) {
  std::vector<Slide> result;
  const double share = std::min(1.0, kIndependent / std::max(1.0, static_cast<double>(tracked.rows())));
  for (Eigen::Index i = 0; i < tracked.rows(); ++i) {
    const Eigen::Vector3d p = tracked.row(i).transpose();
    const ClosestPoint at = surface.closest(Feature::surface, p);
    if (at.triangle < 0) continue;
    const double off = at.distance / kSurface;
    result.push_back({surface.carrier(at), p, surface.normal(at),
                      share * temperature / (kSurface * kSurface * (1.0 + off * off))});
  }
  return result;
}

void add_slide(const Slide& slide, const Points& now, std::vector<fem::AttachedLoad>& loads) {
  fem::AttachedLoad load;
  load.nodes = slide.carrier.nodes;
  load.weights = slide.carrier.weights;
  load.tangent = slide.stiffness * slide.normal * slide.normal.transpose();
  load.force = load.tangent * (slide.tissue - place_of(load.nodes, load.weights, now));
  loads.push_back(load);
}

}  // namespace

Eigen::Vector3d SightPull::place(const Points& nodes_now) const {
  return place_of(nodes, weights, nodes_now);
}

Corrector::Corrector(std::shared_ptr<const fem::CompositeModel> at_rest, registration::MovingSurface surface)
    : composite_(std::move(at_rest)),
      surface_(std::move(surface)),
      registered_(composite_->mesh().vertices) {}

Points Corrector::solve(const std::vector<SightPull>& pulls, const Points& tracked) const {
  if (pulls.empty()) return registered_;
  const double temperature = composite_->options().parenchyma.young_modulus * kReach * kShape * kShape;
  const double body = temperature / (kBody * kBody);
  fem::StaticOptions options;
  options.max_iterations = kSteps;
  options.tolerance = kTolerance;
  registration::MovingSurface surface = surface_;
  Points now = registered_;
  for (int k = 0; k < kPairings; ++k) {
    surface.move(now);
    const std::vector<Slide> pairs = slides(surface, tracked, temperature);
    const auto loads = [&](const Points& x) {
      fem::Loads all;
      add_body(registered_, composite_->lumped_mass(), body, x, all.attached);
      for (const SightPull& pull : pulls) add_pull(pull, temperature, x, all.attached);
      for (const Slide& pair : pairs) add_slide(pair, x, all.attached);
      return all;
    };
    const auto solved = fem::solve_static(*composite_, now, loads, options, RunContext());
    if (!solved || !solved->positions.allFinite() || !(solved->residual < kUseless))
      throw InputError("correction", "the organ", "takes no shape that would meet it",
                       "Drag less far, or register again");
    now = solved->positions;
  }
  return now;
}

}  // namespace glisson::guidance
