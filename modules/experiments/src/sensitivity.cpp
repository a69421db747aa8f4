// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/sensitivity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "glisson/core/error.h"
#include "glisson/fem/integrator.h"
#include "glisson/fem/loads_io.h"
#include "glisson/geometry/distance.h"
#include "surface_walk.h"

namespace glisson::experiments {
namespace {
using Eigen::Vector3d;

/// m: what holds a landmark of a point or two reaches so far around it.
constexpr double kLigamentRadius = 5e-3, kCavaRadius = 20e-3;
constexpr int kAround = 6;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Where a support holds the surface.
struct Held {
  Points points;
  ClosestPoint middle;
};

class Study {
 public:
  Study(const PatientModel& model, const SensitivityOptions& options, const RunContext& context)
      : model_(model),
        options_(options),
        context_(context),
        composite_(model.mesh, model.vessels, {}),
        tree_(model.surface.mesh),
        walk_(model.surface.mesh),
        notch_(held(model.landmarks.umbilical_notch, kLigamentRadius)),
        cava_(held(model.landmarks.vena_cava, kCavaRadius)) {}

  Cancellable<Sensitivity> run() {
    auto reference = solved(model_.mesh.vertices, notch_.points, cava_.points, 1.0, 1.0);
    if (context_.cancelled()) return {};
    if (!reference)
      throw NumericalError("the reference liver has no equilibrium on its flank: check mesh and vena cava");
    reference_ = std::move(*reference);
    const Eigen::VectorXd moved = (reference_ - model_.mesh.vertices).rowwise().norm();
    found_.motion_mean = moved.mean();
    found_.motion_max = moved.maxCoeff();
    for (const Support support : kSupports) {
      for (const double shift : options_.shifts) found_.shifts.push_back(shifted(support, shift));
      for (const double factor : options_.factors) found_.stiffness.push_back(stiffened(support, factor));
      found_.exponents[static_cast<std::size_t>(support)] = exponent(support);
    }
    if (context_.cancelled()) return {};
    return std::move(found_);
  }

 private:
  /// The landmark's points on the surface; of a point or two their surroundings.
  Held held(const Points& landmark, double radius) const {
    std::vector<Vector3d> points;
    for (Eigen::Index i = 0; i < landmark.rows(); ++i) {
      const ClosestPoint at = tree_.closest(landmark.row(i).transpose());
      points.push_back(at.point);
      if (landmark.rows() >= 3) continue;
      for (int k = 0; k < kAround; ++k) points.push_back(walk_.walk(at, direction(at, k, kAround), radius));
    }
    Held support;
    support.points.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
      support.points.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    support.middle = tree_.closest(landmark.colwise().mean().transpose());
    return support;
  }

  /// The k-th of n directions in the surface; the first leads to the patient's left, or else to the head.
  Vector3d direction(const ClosestPoint& at, int k, int n) const {
    const auto corner = [&](int c) {
      return model_.surface.mesh.vertex(model_.surface.mesh.triangles(at.triangle, c));
    };
    const Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    Vector3d first = Vector3d::UnitX() - normal.x() * normal;
    if (first.norm() < 0.1) first = Vector3d::UnitZ() - normal.z() * normal;
    return Eigen::AngleAxisd(2.0 * std::numbers::pi * k / n, normal) * first.normalized();
  }

  /// The support as a whole goes where its middle goes, and is laid on the surface there.
  Points shifted(const Held& support, double shift, int k) const {
    if (shift == 0.0) return support.points;
    const Vector3d to = walk_.walk(support.middle, direction(support.middle, k, options_.directions), shift);
    const Vector3d by = to - support.middle.point;
    Points points = support.points.rowwise() + by.transpose();
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      points.row(i) = tree_.closest(points.row(i).transpose()).point.transpose();
    return points;
  }

  /// Empty: no equilibrium, or cancelled.
  std::optional<Points> solved(const Points& start, const Points& notch, const Points& cava,
                               double notch_factor, double cava_factor) const {
    fem::LoadCase load;
    load.gravity_change =
        fem::gravity_in_posture(options_.flank == SensitivityOptions::Flank::left ? "left_flank"
                                                                                  : "right_flank") -
        fem::gravity_in_posture("supine");
    const auto hold = [&](const Points& points, double stiffness) {
      for (Eigen::Index i = 0; i < points.rows(); ++i) {
        fem::LoadSpring spring;
        spring.place.point = points.row(i).transpose();
        spring.stiffness = stiffness / static_cast<double>(points.rows());
        load.springs.push_back(std::move(spring));
      }
    };
    hold(notch, notch_factor * kLigamentStiffness);
    hold(cava, cava_factor * kCavaStiffness);
    const fem::AppliedLoad applied(load, composite_);
    fem::StaticOptions newton;
    newton.tolerance = 1e-6;
    auto summary = fem::solve_static(
        composite_, start, [&](const Points& x) { return applied.at(x); }, newton, context_.quiet());
    if (!summary || !summary->converged()) return std::nullopt;
    return std::move(summary->positions);
  }

  ShiftRow shifted(Support support, double shift) {
    ShiftRow row{support, shift, {}, std::numeric_limits<double>::infinity(), 0.0, 0, 0};
    const int directions = shift == 0.0 ? 1 : options_.directions;
    for (int k = 0; k < directions && !context_.cancelled(); ++k) {
      ++row.tried;
      const auto shape =
          solved(reference_, support == Support::cava ? notch_.points : shifted(notch_, shift, k),
                 support == Support::notch ? cava_.points : shifted(cava_, shift, k), 1.0, 1.0);
      tick();
      if (!shape) continue;
      const ShapeDistance distance = shape_distance(model_, reference_, *shape);
      ++row.solved;
      row.mean.surface += distance.surface;
      row.mean.nodes += distance.nodes;
      row.least = std::min(row.least, distance.surface);
      row.most = std::max(row.most, distance.surface);
    }
    if (row.solved == 0) row.least = row.most = kNaN;
    row.mean.surface /= row.solved;
    row.mean.nodes /= row.solved;
    return row;
  }

  StiffnessRow stiffened(Support support, double factor) {
    if (context_.cancelled()) return {};
    const auto shape =
        solved(reference_, notch_.points, cava_.points, support == Support::cava ? 1.0 : factor,
               support == Support::notch ? 1.0 : factor);
    tick();
    return {support, factor, shape ? shape_distance(model_, reference_, *shape) : ShapeDistance{kNaN, kNaN}};
  }

  /// Least squares on logarithms.
  double exponent(Support support) const {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const ShiftRow& row : found_.shifts) {
      if (row.support != support || row.shift <= 0.0 || !(row.mean.surface > 0.0)) continue;
      const double u = std::log(row.shift), v = std::log(row.mean.surface);
      n += 1.0, x += u, y += v, xx += u * u, xy += u * v;
    }
    return n < 2.0 ? kNaN : (n * xy - x * y) / (n * xx - x * x);
  }

  void tick() {
    const auto shifts = static_cast<double>(options_.shifts.size()) * options_.directions;
    const double all =
        static_cast<double>(kSupports.size()) * (shifts + static_cast<double>(options_.factors.size()));
    context_.progress(std::min(1.0, ++done_ / all), "figure.shapes");
  }

  const PatientModel& model_;
  const SensitivityOptions& options_;
  const RunContext& context_;
  fem::CompositeModel composite_;
  ClosestPointTree tree_;
  SurfaceWalk walk_;
  Held notch_, cava_;
  Points reference_;
  Sensitivity found_;
  int done_ = 0;
};

}  // namespace

const char* support_code(Support support) {
  static constexpr std::array<const char*, kSupports.size()> kCodes = {"notch", "cava", "both"};
  return kCodes[static_cast<std::size_t>(support)];
}

SensitivityOptions SensitivityOptions::quick() {
  SensitivityOptions options;
  options.shifts = {0.0, 3e-3, 15e-3};
  options.directions = 2;
  options.factors = {0.5, 1.0};
  return options;
}

void SensitivityOptions::validate() const {
  const OptionCheck demand("sensitivity options");
  demand(directions >= 1 && directions <= 64, "directions", directions, "Give 1 to 64");
  for (const double shift : shifts)
    demand(shift >= 0.0 && shift <= 0.05, "shifts", shift, "Give metres from 0 to 0.05");
  for (const double factor : factors)
    demand(factor > 0.0 && factor <= 1e4, "factors", factor, "Give above 0, at most 10000");
}

ShapeDistance shape_distance(const PatientModel& model, const PointsIn<CtFrame>& a,
                             const PointsIn<CtFrame>& b) {
  const auto surface = [&](const Points& nodes) {
    TriangleMesh mesh = model.surface.mesh;
    for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v)
      mesh.vertices.row(v) = nodes.row(model.surface.node_of_vertex[static_cast<std::size_t>(v)]);
    return mesh;
  };
  const TriangleMesh one = surface(a), other = surface(b);
  return {0.5 * (summarise(distances_to_surface(one.vertices, other)).mean +
                 summarise(distances_to_surface(other.vertices, one)).mean),
          (a - b).rowwise().norm().mean()};
}

Cancellable<Sensitivity> boundary_sensitivity(const PatientModel& model, const SensitivityOptions& options,
                                              const RunContext& context) {
  options.validate();
  const auto demand = [](const Points& landmark, const char* name) {
    if (landmark.rows() == 0)
      throw InputError("model", name, "its place is not known", "Place it among the landmarks");
  };
  demand(model.landmarks.umbilical_notch, "umbilical notch");
  demand(model.landmarks.vena_cava, "vena cava");
  return Study(model, options, context).run();
}

}  // namespace glisson::experiments
