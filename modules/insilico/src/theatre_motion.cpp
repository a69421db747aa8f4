// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre_motion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>

#include "glisson/core/error.h"
#include "glisson/core/random.h"
#include "glisson/fem/composite_model.h"
#include "glisson/fem/integrator.h"
#include "theatre_loads.h"

namespace glisson::insilico {
namespace {

constexpr int kBreathStates = 4;          // inspiration 0, 1/3, 2/3, 1
constexpr int kToolStates = 6;            // of a tool's way
constexpr double kToolHold = 1500.0;      // N/m, all its springs together: some ten times the tissue's
constexpr double kFirstPressure = 200.0;  // Pa, first try when it is ours to choose
constexpr double kLargestPressure = 4000.0;
/// Of the residual force, relative to the load. (A thousandth of 20 N on springs of 1000 N/m is 20 um.)
constexpr double kTolerance = 1e-4, kGoodEnough = 1e-3;
constexpr double kSmallestVolumeRatio = 0.05;

/// Solves one equilibrium after another, each from the last.
class Solver {
 public:
  Solver(const TetMesh& mesh, const std::vector<VesselTree>& vessels, const Landmarks& landmarks,
         const TheatreOptions& options)
      : model_(mesh, vessels, composite(options, vessels)),
        loads_(model_.surface(), landmarks),
        rest_volumes_(tetrahedron_volumes(mesh)) {}

  struct Outcome {
    Points positions;
    bool usable = false;  ///< converged, nothing inverted
  };
  /// @param gas_on the shape whose normals the gas presses along. @return empty when cancelled.
  Cancellable<Outcome> solve(const Points& start, const Points& gas_on, const LoadLevels& levels,
                             const RunContext& context) {
    fem::StaticOptions options;
    options.max_iterations = 40;
    options.tolerance = kTolerance;
    auto summary = fem::solve_static(
        model_, start, [&](const Points& x) { return loads_.at(x, gas_on, levels); }, options, context);
    if (!summary) return std::nullopt;
    ++count_;
    const double ratio = volume_ratio(summary->positions);
    const bool usable = summary->residual <= kGoodEnough && ratio > kSmallestVolumeRatio;
    if (usable) smallest_ratio_ = std::min(smallest_ratio_, ratio);
    return Outcome{std::move(summary->positions), usable};
  }

  double volume_ratio(const Points& x) const {
    TetMesh moved = model_.mesh();
    moved.vertices = x;
    return tetrahedron_volumes(moved).cwiseQuotient(rest_volumes_).minCoeff();
  }
  void take_hold(std::vector<ToolHold> held) { loads_.take_hold(std::move(held)); }
  BoundarySurface surface() const { return model_.surface(); }
  const Points& rest() const { return model_.mesh().vertices; }
  const TheatreLoads& loads() const { return loads_; }
  int count() const { return count_; }
  double smallest_ratio() const { return smallest_ratio_; }

 private:
  static fem::CompositeOptions composite(const TheatreOptions& options,
                                         const std::vector<VesselTree>& vessels) {
    fem::CompositeOptions materials;
    materials.law = fem::TetrahedronLaw::neo_hookean;
    materials.parenchyma.young_modulus = options.young_modulus_pa;
    for (Label lesion = structure::kFirstLesion; lesion <= structure::kFirstLesion + 63; ++lesion)
      materials.by_label[lesion] = {5.0 * options.young_modulus_pa, 0.45};
    materials.with_vessels = !vessels.empty();
    materials.with_capsule = false;  // see the README: the truth is not of the registration's kind
    return materials;
  }

  fem::CompositeModel model_;
  TheatreLoads loads_;
  Eigen::VectorXd rest_volumes_;
  int count_ = 0;
  double smallest_ratio_ = 1.0;
};

LoadLevels deflated(double pressure) {
  LoadLevels levels;
  levels.pressure_pa = pressure;
  const double share = pressure / 600.0;
  levels.tilt = std::min(1.0, share);
  levels.bed_sinks = 0.045 * share;
  levels.ligament_lift = std::min(0.01, 0.005 * share);
  return levels;
}

struct Base {
  Points positions;
  LoadLevels levels;
};

/// Turns gas, tilt and ligament up together until the elastic part of the motion is what is wanted.
Cancellable<Base> find_base(Solver& solver, const TheatreOptions& options, const RunContext& context) {
  const bool given = options.pneumoperitoneum_pa > 0.0;
  const double wanted = 1e-3 * options.elastic_motion_mm;
  Base best{solver.rest(), deflated(0.0)};
  double reached = 0.0, pressure = 0.0, done = 0.0;
  double step = given ? std::min(options.pneumoperitoneum_pa, 800.0) : kFirstPressure;
  for (int tries = 0; tries < 40; ++tries) {
    double next = pressure + step;
    if (given) next = std::min(next, options.pneumoperitoneum_pa);
    // Progress is that of the search, not of the solves in it, and never goes back.
    done = std::max(done, std::min(0.95, given ? pressure / options.pneumoperitoneum_pa : reached / wanted));
    context.progress(done, "theatre.gas");
    auto outcome = solver.solve(best.positions, best.positions, deflated(next), context.quiet());
    // Once more with the gas along the normals of what came out.
    if (outcome && outcome->usable)
      outcome = solver.solve(outcome->positions, outcome->positions, deflated(next), context.quiet());
    if (!outcome) return std::nullopt;
    if (!outcome->usable) {  // too much at once, or too much at all
      step *= 0.5;
      if (step < 1.0) break;
      continue;
    }
    const double before = reached;
    best = {outcome->positions, deflated(next)};
    reached = mean_motion(solver.rest(), best.positions).elastic;
    const double slope = (reached - before) / (next - pressure);
    pressure = next;
    if (given ? pressure >= options.pneumoperitoneum_pa : (reached >= wanted && reached <= 1.05 * wanted))
      return best;
    if (given) continue;
    if (pressure >= kLargestPressure || !(slope > 0.0)) break;
    // Secant; a step that went too far is taken back in part.
    step = std::clamp((1.02 * wanted - reached) / slope, -0.5 * pressure, 0.7 * pressure);
  }
  throw NumericalError(
      "the theatre could not deform this liver by " + std::to_string(options.elastic_motion_mm) +
      " mm without damage to its mesh (it reached " + std::to_string(1e3 * reached) + " mm at " +
      std::to_string(pressure) + " Pa); use a finer truth_vertices or less elastic_motion_mm");
}

/// What a tool that touches the surface there takes along: all springs together kToolHold, their share by
/// area, falling off as a bell.
std::vector<ToolHold> held_around(const BoundarySurface& surface, const Points& from,
                                  const Eigen::Vector3d& touched, const Eigen::Vector3d& way, double around) {
  const Eigen::VectorXd areas = vertex_areas(surface.mesh);
  std::vector<ToolHold> held;
  double sum = 0.0;
  for (int v = 0; v < surface.mesh.vertex_count(); ++v) {
    const double away = (surface.mesh.vertex(v) - touched).norm() / around;
    if (away > 3.0) continue;
    const int node = surface.node_of_vertex[static_cast<std::size_t>(v)];
    held.push_back({node, std::exp(-0.5 * away * away) * areas[v], from.row(node).transpose(), way});
    sum += held.back().stiffness;
  }
  require(sum > 0.0, "a tool touches the surface");
  for (ToolHold& one : held) one.stiffness *= kToolHold / sum;
  return held;
}

/// Weights of Lagrange's polynomial through n values at equal steps from 0 to 1.
double lagrange(int n, int i, double at) {
  double weight = 1.0;
  for (int j = 0; j < n; ++j)
    if (j != i) weight *= (at * (n - 1) - j) / (i - j);
  return weight;
}

/// A rigid change of posture about the vena cava, as large as it must be for the wanted mean displacement.
Rigid<CtFrame, CtFrame> find_posture(const Points& rest, const Points& moved, const Eigen::Vector3d& cava,
                                     double wanted, std::mt19937_64& random) {
  const auto uniform = [&] { return 2.0 * uniform01(random) - 1.0; };
  const double z = uniform(), y = uniform(), x = uniform(), down = uniform(), across = uniform();
  const Eigen::Vector3d axis = Eigen::Vector3d(0.4 * x + 0.5, 0.4 * y, 0.4 * z - 0.5).normalized();
  const Eigen::Vector3d way = Eigen::Vector3d(0.4 * across, 0.3 * down - 0.4, -1.0).normalized();
  const auto posture = [&](double amount) {
    Rigid<CtFrame, CtFrame> change;
    change.rotation = Eigen::AngleAxisd(amount * 12.0 * std::numbers::pi / 180.0, axis).toRotationMatrix();
    change.translation = cava - change.rotation * cava + amount * 0.02 * way;
    return change;
  };
  const auto displacement = [&](double amount) {
    return mean_motion(rest, posture(amount).apply(moved)).total;
  };
  double low = 0.0, high = 0.0;
  while (displacement(high) < wanted && high < 4.0) low = high, high += 0.125;
  for (int pass = 0; pass < 40 && high > 0.0; ++pass) {
    const double middle = 0.5 * (low + high);
    (displacement(middle) < wanted ? low : high) = middle;
  }
  return posture(high);
}

}  // namespace

double inspiration(double seconds, double period) {
  const double s = std::sin(std::numbers::pi * seconds / period);
  return s * s * s * s;
}

double heartbeat(double seconds, double period) {
  const double s = std::sin(std::numbers::pi * seconds / period);
  return s * s * s * s;
}

MeanMotion mean_motion(const Points& rest, const Points& moved) {
  const auto rigid = fit_rigid<CtFrame, CtFrame>(rest, moved);
  return {(moved - rest).rowwise().norm().mean(), (moved - rigid.apply(rest)).rowwise().norm().mean()};
}

Cancellable<TheatreMotion> TheatreMotion::solve(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                                                const Landmarks& landmarks, const TheatreOptions& options,
                                                const RunContext& context) {
  Solver solver(mesh, vessels, landmarks, options);
  const auto base = find_base(solver, options, context.part(0.0, 0.6));
  if (!base) return std::nullopt;

  const auto equilibrium = [&](const Points& start, const LoadLevels& levels) -> Cancellable<Points> {
    auto outcome = solver.solve(start, base->positions, levels, context.quiet());
    if (!outcome) return std::nullopt;
    if (!outcome->usable)
      throw NumericalError("the theatre's breathing or heartbeat has no equilibrium; make it smaller");
    return std::move(outcome->positions);
  };

  TheatreMotion motion;
  motion.breathing_period_ = options.breathing_period_s;
  motion.heartbeat_period_ = options.heartbeat_period_s;
  motion.breath_.assign(1, base->positions);
  if (options.breathing_mm > 0.0) {
    // One trial tells how far the liver follows the diaphragm: nearly linear over millimetres.
    LoadLevels levels = base->levels;
    levels.diaphragm = 1.4e-3 * options.breathing_mm;
    const auto trial = equilibrium(base->positions, levels);
    if (!trial) return std::nullopt;
    const double full =
        levels.diaphragm * 1e-3 * options.breathing_mm / (*trial - base->positions).rowwise().norm().mean();
    for (int k = 1; k < kBreathStates; ++k) {
      context.progress(0.6 + 0.1 * k, "theatre.breathing");
      levels.diaphragm = full * k / (kBreathStates - 1.0);
      const auto state = equilibrium(motion.breath_.back(), levels);
      if (!state) return std::nullopt;
      motion.breath_.push_back(*state);
    }
  }
  motion.heart_ = Points::Zero(mesh.vertex_count(), 3);
  if (options.heartbeat_mm > 0.0) {
    context.progress(0.95, "theatre.heartbeat");
    LoadLevels levels = base->levels;
    levels.heart_n = 0.2;
    const auto state = equilibrium(base->positions, levels);
    if (!state) return std::nullopt;
    motion.heart_ = *state - base->positions;
    motion.heart_ *= 1e-3 * options.heartbeat_mm / motion.heart_.rowwise().norm().maxCoeff();
  }

  std::mt19937_64 random(options.seed * 7919 + 17);
  const auto posture = find_posture(solver.rest(), base->positions, solver.loads().cava(),
                                    1e-3 * options.mean_displacement_mm, random);
  motion.base_ = base->positions;
  motion.levels_ = base->levels;
  motion.posture_ = posture;
  for (Points& state : motion.breath_) state = posture.apply(state);
  motion.heart_ = motion.heart_ * posture.rotation.transpose();

  const MeanMotion first = mean_motion(solver.rest(), motion.breath_.front());
  TheatreFigures& figures = motion.figures_;
  figures.mean_displacement_mm = 1e3 * first.total;
  figures.elastic_motion_mm = 1e3 * first.elastic;
  figures.pressure_pa = base->levels.pressure_pa;
  figures.breathing_mm = 1e3 * (motion.breath_.back() - motion.breath_.front()).rowwise().norm().mean();
  figures.heartbeat_mm = 1e3 * motion.heart_.rowwise().norm().maxCoeff();
  figures.nodes = mesh.vertex_count();
  figures.tetrahedra = mesh.tetrahedron_count();
  figures.static_solves = solver.count();
  figures.smallest_volume_ratio = solver.smallest_ratio();
  for (const double share : {0.0, 0.15, 0.5, 0.85, 1.0})  // between the key states too
    figures.smallest_volume_ratio =
        std::min(figures.smallest_volume_ratio, solver.volume_ratio(motion.at(share, 1.0)));
  if (figures.smallest_volume_ratio <= 0.0)
    throw NumericalError("the theatre's motion turns an element of its mesh inside out; use a finer mesh");
  return motion;
}

Points TheatreMotion::at(double inspired, double beat) const {
  // Lagrange's polynomial through the equilibria: smooth in time, exact at each.
  const int n = static_cast<int>(breath_.size());
  Points x = beat * heart_;
  for (int i = 0; i < n; ++i) x += lagrange(n, i, inspired) * breath_[static_cast<std::size_t>(i)];
  return x;
}

Points ToolPull::at(double share) const {
  // From step to step along straight lines: a polynomial would swing where the tissue gives way at last.
  const double along = share * (static_cast<double>(steps.size()) - 1.0);
  const auto low =
      static_cast<std::size_t>(std::clamp(std::floor(along), 0.0, static_cast<double>(steps.size()) - 2.0));
  const double part = along - static_cast<double>(low);
  return (1.0 - part) * steps[low] + part * steps[low + 1];
}

Cancellable<ToolPull> TheatreMotion::pull(const TetMesh& mesh, const std::vector<VesselTree>& vessels,
                                          const Landmarks& landmarks, const TheatreOptions& options,
                                          const Eigen::Vector3d& touched, const Eigen::Vector3d& way,
                                          double around, const RunContext& context) const {
  Solver solver(mesh, vessels, landmarks, options);
  const std::vector<ToolHold> held =
      held_around(solver.surface(), base_, touched, posture_.rotation.transpose() * way, around);
  solver.take_hold(held);
  ToolPull pull;
  pull.steps.assign(1, Points::Zero(mesh.vertex_count(), 3));
  LoadLevels levels = levels_;
  Points last = base_;
  for (int k = 1; k < kToolStates; ++k) {
    const double wanted = k / (kToolStates - 1.0);
    for (double step = wanted - levels.tool; levels.tool < wanted;) {
      LoadLevels next = levels;
      next.tool = std::min(wanted, levels.tool + step);
      auto outcome = solver.solve(last, base_, next, context.quiet());
      if (!outcome) return std::nullopt;
      if (!outcome->usable) {
        if ((step *= 0.5) < 0.01)
          throw NumericalError(
              "the theatre's tool finds no equilibrium; make its way shorter or its tip wider");
        continue;
      }
      last = std::move(outcome->positions);
      levels = next;
    }
    pull.steps.push_back((last - base_) * posture_.rotation.transpose());
  }
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (const ToolHold& one : held)
    force += one.stiffness * (one.from + one.way - last.row(one.node).transpose());
  pull.force_n = force.norm();
  TetMesh moved = mesh;
  for (const double inspired : {0.0, 0.5, 1.0})
    for (const double share : {0.5, 1.0}) {
      moved.vertices = at(inspired, 1.0) + pull.at(share);
      if (tetrahedron_volumes(moved).minCoeff() <= 0.0)
        throw NumericalError(
            "the theatre's tool turns an element of its mesh inside out; make its way shorter");
    }
  return pull;
}

Points TheatreMotion::positions(double seconds) const {
  return at(inspiration(seconds, breathing_period_), heartbeat(seconds, heartbeat_period_));
}

}  // namespace glisson::insilico
