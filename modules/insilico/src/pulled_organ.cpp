// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/pulled_organ.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "glisson/geometry/topology.h"

namespace glisson::insilico {
namespace {

constexpr double kYoungModulus = 5200.0;       // Pa
constexpr double kClearOfHeld = 0.035;         // m, between a patch's centre and what is held
constexpr double kGrowth = 1.6, kNear = 0.03;  // of the load a step; of the motion wanted
constexpr int kMostSteps = 40;

/// A place that is pulled or pressed: a share of the force on each node.
struct Grip {
  std::vector<std::pair<int, double>> shares;
  Eigen::Vector3d force;  ///< N at a load of 1
  double phase, swing;    ///< how it swells over the frames
};

class Puller {
 public:
  Puller(const TetMesh& truth, const PulledOrganOptions& options, const RunContext& context)
      : options_(options),
        context_(context),
        random_(context.random("pulled organ " + std::to_string(options.seed))),
        surface_(boundary_surface(truth)),
        model_(truth, {}, composite_options()) {
    centres_.resize(surface_.mesh.triangle_count(), 3);
    for (int t = 0; t < surface_.mesh.triangle_count(); ++t) {
      centres_.row(t).setZero();
      for (int k = 0; k < 3; ++k)
        centres_.row(t) += surface_.mesh.vertices.row(surface_.mesh.triangles(t, k)) / 3.0;
    }
    normals_ = triangle_normals(surface_.mesh);
    areas_ = triangle_areas(surface_.mesh);
  }

  Cancellable<PulledOrgan> run() {
    choose_view();
    hold();
    grip();
    organ_.patches = static_cast<int>(grips_.size());
    Points nodes = model_.mesh().vertices;
    const auto load = grow(nodes);
    if (!load) return std::nullopt;
    for (int k = 0; k < options_.frames; ++k) {
      if (k > 0) {
        const auto next = equilibrium(nodes, *load, k);
        if (context_.cancelled()) return std::nullopt;
        if (next) nodes = *next;
      }
      organ_.frames.push_back({nodes, see(nodes)});
      context_.progress((k + 1.0) / options_.frames, "insilico.pull");
    }
    return organ_;
  }

 private:
  fem::CompositeOptions composite_options() const {
    fem::CompositeOptions composite;
    composite.with_capsule = composite.with_vessels = false;
    composite.law = fem::TetrahedronLaw::neo_hookean;
    composite.parenchyma = {kYoungModulus, options_.poisson_ratio};
    return composite;
  }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  /// In the order of standard_normal3().
  Eigen::Vector3d drawn(std::normal_distribution<double>& normal) {
    const double z = normal(random_), y = normal(random_), x = normal(random_);
    return {x, y, z};
  }
  Eigen::Vector3d direction() {
    std::normal_distribution<double> normal;
    Eigen::Vector3d d;
    do d = drawn(normal);
    while (d.norm() < 1e-3);
    return d.normalized();
  }

  /// A camera far away, and the seen part of the surface around the middle of what faces it.
  void choose_view() {
    const Eigen::Vector3d towards = direction();
    organ_.towards_camera = towards;
    std::vector<int> facing;
    for (int t = 0; t < areas_.size(); ++t)
      if (normals_.row(t).dot(towards) > 0.25) facing.push_back(t);
    const int middle = facing[std::uniform_int_distribution<std::size_t>(0, facing.size() - 1)(random_)];
    const auto distance = [&](int t) { return (centres_.row(t) - centres_.row(middle)).squaredNorm(); };
    std::sort(facing.begin(), facing.end(), [&](int a, int b) { return distance(a) < distance(b); });
    double area = 0.0;
    for (const int t : facing) {
      if (area > options_.seen_share * areas_.sum()) break;
      seen_.push_back(t);
      area += areas_[t];
    }
    middle_ = middle;
  }

  /// Far from what is seen.
  void hold() {
    double farthest = 0.0;
    for (int t = 0; t < areas_.size(); ++t)
      if (const double d = (centres_.row(t) - centres_.row(middle_)).norm() * uniform(0.7, 1.0); d > farthest)
        farthest = d, organ_.held_centre = centres_.row(t).transpose();
    organ_.held_radius = 1e-3 * options_.held_radius_mm;
    fixed_ = held_nodes(model_.mesh(), organ_);
    if (fixed_.size() < 3) throw InputError("mesh", "", "is too coarse for a part that is held", "Refine it");
  }

  void grip() {
    const int count = options_.patches > 0 ? options_.patches : static_cast<int>(uniform(1.0, 3.9999));
    std::vector<char> seen(static_cast<std::size_t>(areas_.size()), 0);
    for (const int t : seen_) seen[static_cast<std::size_t>(t)] = 1;
    for (int k = 0; k < count; ++k) {
      const bool hidden = options_.hidden_patch && k + 1 == count;
      std::vector<int> places;
      for (int t = 0; t < areas_.size(); ++t)
        if ((seen[static_cast<std::size_t>(t)] == 0) == hidden &&
            (centres_.row(t).transpose() - organ_.held_centre).norm() > organ_.held_radius + kClearOfHeld)
          places.push_back(t);
      if (places.empty())
        throw NumericalError("No place for a patch clear of what is held: take another seed.");
      grip_at(places[std::uniform_int_distribution<std::size_t>(0, places.size() - 1)(random_)]);
    }
  }

  void grip_at(int triangle) {
    const double area = 1e-4 * uniform(options_.smallest_patch_cm2, options_.largest_patch_cm2);
    const double radius = std::sqrt(area / std::numbers::pi);
    Grip grip;
    std::vector<double> share(static_cast<std::size_t>(model_.node_count()), 0.0);
    double sum = 0.0;
    for (int t = 0; t < areas_.size(); ++t) {
      if ((centres_.row(t) - centres_.row(triangle)).norm() > radius && t != triangle) continue;
      if (normals_.row(t).dot(normals_.row(triangle)) < 0.0) continue;
      sum += areas_[t];
      for (int k = 0; k < 3; ++k)
        share[static_cast<std::size_t>(
            surface_.node_of_vertex[static_cast<std::size_t>(surface_.mesh.triangles(t, k))])] +=
            areas_[t] / 3.0;
    }
    for (std::size_t i = 0; i < share.size(); ++i)
      if (share[i] > 0.0) grip.shares.emplace_back(static_cast<int>(i), share[i] / sum);
    // Pulled outwards or pressed inwards, askew by up to 50 degrees.
    Eigen::Vector3d along = normals_.row(triangle).transpose();
    along = (along + uniform(0.0, 1.2) * along.cross(direction())).normalized();
    grip.force = (uniform(0.0, 1.0) < 0.6 ? 1.0 : -1.0) * uniform(0.4, 1.0) * along;
    grip.phase = uniform(0.0, 2.0 * std::numbers::pi);
    grip.swing = uniform(0.05, 0.25);
    grips_.push_back(std::move(grip));
  }

  /// @param frame the loads of frame 0 are `load` times the grips' forces.
  std::optional<Points> equilibrium(const Points& start, double load, int frame) const {
    fem::Loads loads;
    for (const Grip& grip : grips_) {
      const double turn = 2.0 * std::numbers::pi * frame / 25.0;
      const double swell = 1.0 + grip.swing * (std::sin(turn + grip.phase) - std::sin(grip.phase));
      for (const auto& [node, share] : grip.shares) {
        fem::AttachedLoad attached;
        attached.nodes[0] = node;
        attached.weights[0] = 1.0;
        attached.force = load * swell * share * grip.force;
        loads.attached.push_back(attached);
      }
    }
    fem::StaticOptions options;
    options.fixed_nodes = fixed_;
    options.tolerance = 1e-6;
    options.max_iterations = 60;
    const auto summary = solve_static(
        model_, start, [&](const Points&) { return loads; }, options, context_.quiet());
    if (!summary || !summary->converged()) return std::nullopt;
    return summary->positions;
  }

  /// Raises the load until the organ has moved as far as is wanted. @return the load.
  std::optional<double> grow(Points& nodes) {
    const double wanted = 1e-3 * options_.mean_motion_mm;
    const double most =
        options_.largest_motion_mm > 0.0 ? 1e-3 * options_.largest_motion_mm : uniform(30e-3, 50e-3);
    const Points& rest = model_.mesh().vertices;
    double load = 0.02, reached = 0.0, growth = kGrowth;
    for (int step = 0; step < kMostSteps; ++step) {
      if (context_.cancelled()) return std::nullopt;
      const auto next = equilibrium(nodes, load, 0);
      const Eigen::VectorXd motion =
          next ? Eigen::VectorXd((*next - rest).rowwise().norm()) : Eigen::VectorXd::Zero(1);
      const bool far =
          next && (motion.mean() > (1.0 + kNear) * wanted || motion.maxCoeff() > (1.0 + kNear) * most);
      if (!next || far) {
        growth = std::sqrt(growth);
        if (growth < 1.01) break;
        load = reached > 0.0 ? reached * growth : load / kGrowth;
        continue;
      }
      nodes = *next, reached = load;
      organ_.mean_motion = motion.mean(), organ_.largest_motion = motion.maxCoeff();
      if (motion.mean() > (1.0 - kNear) * wanted || motion.maxCoeff() > (1.0 - kNear) * most) break;
      // No further than a straight line says.
      growth = std::min({growth, wanted / motion.mean(), most / motion.maxCoeff()});
      load *= std::max(growth, 1.005);
    }
    if (reached == 0.0) throw NumericalError("No equilibrium was found under the loads: take another seed.");
    return reached;
  }

  Points see(const Points& nodes) {
    TriangleMesh now = surface_.mesh;
    for (int v = 0; v < now.vertex_count(); ++v)
      now.vertices.row(v) = nodes.row(surface_.node_of_vertex[static_cast<std::size_t>(v)]);
    const Eigen::VectorXd areas = triangle_areas(now)(seen_);
    std::discrete_distribution<int> which(areas.data(), areas.data() + areas.size());
    std::normal_distribution<double> normal(0.0, 1.0);
    Points cloud(options_.points, 3);
    for (int i = 0; i < options_.points; ++i) {
      const int t = seen_[static_cast<std::size_t>(which(random_))];
      double a = uniform(0.0, 1.0), b = uniform(0.0, 1.0);
      if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
      const Eigen::Vector3d noise = drawn(normal);
      cloud.row(i) = ((1.0 - a - b) * now.vertex(now.triangles(t, 0)) + a * now.vertex(now.triangles(t, 1)) +
                      b * now.vertex(now.triangles(t, 2)) + 1e-3 * options_.noise_mm * noise)
                         .transpose();
    }
    return cloud;
  }

  const PulledOrganOptions& options_;
  const RunContext& context_;
  std::mt19937_64 random_;
  BoundarySurface surface_;
  fem::CompositeModel model_;
  Points centres_, normals_;
  Eigen::VectorXd areas_;
  std::vector<int> seen_, fixed_;
  int middle_ = 0;
  std::vector<Grip> grips_;
  PulledOrgan organ_;
};

}  // namespace

void PulledOrganOptions::validate() const {
  const OptionCheck demand("pulled organ");
  demand(patches >= 0 && patches <= 3, "patches", patches, "Give 1 to 3, or 0 to draw their number");
  demand(smallest_patch_cm2 > 0.0 && smallest_patch_cm2 <= largest_patch_cm2, "smallest_patch_cm2",
         smallest_patch_cm2, "Give a positive area up to largest_patch_cm2");
  demand(mean_motion_mm > 0.0, "mean_motion_mm", mean_motion_mm, "Give a positive length");
  demand(largest_motion_mm >= 0.0, "largest_motion_mm", largest_motion_mm, "Give a length, or 0 to draw it");
  demand(poisson_ratio > 0.0 && poisson_ratio < 0.5, "poisson_ratio", poisson_ratio,
         "Give a number between 0 and 0.5");
  demand(held_radius_mm > 0.0, "held_radius_mm", held_radius_mm, "Give a positive length");
  demand(seen_share > 0.0 && seen_share <= 1.0, "seen_share", seen_share, "Give a share in (0, 1]");
  demand(points >= 10, "points", points, "Give ten at least");
  demand(noise_mm >= 0.0, "noise_mm", noise_mm, "Give a length from zero");
  demand(frames >= 1, "frames", frames, "Give one at least");
}

std::vector<int> held_nodes(const TetMesh& mesh, const PulledOrgan& organ) {
  std::vector<int> nodes;
  for (int i = 0; i < mesh.vertex_count(); ++i)
    if ((mesh.vertex(i) - organ.held_centre).norm() < organ.held_radius) nodes.push_back(i);
  return nodes;
}

Cancellable<PulledOrgan> pull_organ(const TetMesh& truth, const PulledOrganOptions& options,
                                    const RunContext& context) {
  options.validate();
  check_tetrahedra(truth, "mesh");
  return Puller(truth, options, context).run();
}

}  // namespace glisson::insilico
