// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/operation_prior.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/random.h"
#include "glisson/core/share_out.h"
#include "glisson/fem/integrator.h"
#include "glisson/fem/tissue.h"
#include "glisson/geometry/rigid.h"
#include "glisson/geometry/topology.h"
#include "glisson/patient/label_map.h"
#include "unforeseen.h"

namespace glisson::registration {
namespace {

constexpr int kUnforeseenModes = 60;     ///< of 270 they hold 99 % of the square motion
constexpr double kUnknownMotion = 8e-3;  ///< m, rms: operations move a node by that beyond a rigid motion
constexpr int kFewest = 30;              // operations that say anything of a distribution (twice the loads)
// Stiffness of what holds the liver, N/m per m2 of its face, before contact_spread.
constexpr double kCava = 5e5, kBed = 1e5, kDiaphragm = 1e4, kLigament = 5e4;
constexpr double kCavaRadius = 0.02, kLigamentHalfWidth = 0.01;
/// m from the vena cava to about the middle of a lobe: the unit of the bed's polynomial.
constexpr double kReach = 0.09;

/// No vessels, no capsule.
fem::CompositeOptions tissue_alone(const OperationOptions& options) {
  fem::CompositeOptions materials;
  materials.with_vessels = materials.with_capsule = false;
  materials.parenchyma = {options.young_modulus, options.poisson_ratio};
  for (const auto& [label, modulus] : options.lesions)
    materials.by_label[label] = {modulus, materials.parenchyma.poisson_ratio};
  return materials;
}

fem::NodalColumns unforeseen_of(const PatientModel& model, const OperationOptions& options, double motion,
                                const RunContext& context) {
  Unforeseen forces;
  forces.motion = motion;
  forces.modes = kUnforeseenModes;
  if (!options.lesions.empty())
    forces.stiffness = fem::stiffness_over_parenchyma(model.mesh, tissue_alone(options));
  return unforeseen_motions(model, forces, context);
}

/// One operation's loads, each in standard deviations.
struct Draw {
  /// kLoads: of those to which the organ answers about linearly.
  static constexpr int kBedTerms = 9, kLoads = 6 + kBedTerms;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  double gas = 0.0, gas_slope = 0.0, lift = 0.0, contact = 0.0, tie = 0.0;
  std::array<double, kBedTerms> bed{};

  Eigen::VectorXd loads() const {
    Eigen::VectorXd values(kLoads);
    values << gravity, gas, gas_slope, lift, Eigen::Map<const Eigen::VectorXd>(bed.data(), kBedTerms);
    return values;
  }

  explicit Draw(std::mt19937_64 random) {
    for (int k = 0; k < 3; ++k) gravity[k] = standard_normal(random);
    for (double* value : {&gas, &gas_slope, &lift, &contact, &tie}) *value = standard_normal(random);
    for (double& value : bed) value = standard_normal(random);
  }
};

/// The organs behind give way backwards and along the body, as polynomials of the place sideways (x) and
/// along the body (z) in units of kReach; x |x| and x^2 together let each lobe bend by itself.
Eigen::Vector3d bed_way(const Draw& draw, double x, double z) {
  const auto& b = draw.bed;
  const double back =
      b[0] * x * std::abs(x) + b[1] * x * x + b[2] * x * z + b[3] * z * z + b[4] * x + b[5] * z;
  return {b[6] * z, back, b[7] * x * x + b[8] * x};
}

/// The organ in its bed.
class Operations {
 public:
  Operations(const PatientModel& model, const OperationOptions& options)
      : options_(options), composite_(model.mesh, {}, tissue_alone(options)), rest_(model.mesh.vertices) {
    const TriangleMesh& surface = model.surface.mesh;
    const Points normals = vertex_normals(surface);
    const Eigen::VectorXd areas = vertex_areas(surface);
    const Points& cava = model.landmarks.vena_cava;
    const Eigen::Vector3d middle = cava.colwise().mean().transpose();
    const bool tied = model.landmarks.umbilical_notch.rows() > 0;
    const double notch_x = tied ? model.landmarks.umbilical_notch.col(0).mean() : 0.0;
    for (int v = 0; v < surface.vertex_count(); ++v) {
      Place place;
      const Eigen::Vector3d p = surface.vertex(v);
      place.node = model.surface.node_of_vertex[static_cast<std::size_t>(v)];
      place.area = areas[v];
      place.normal = normals.row(v).transpose();
      place.from_cava = (p - middle) / kReach;
      const double d2 = (cava.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff();
      place.cava = std::exp(-0.5 * d2 / (kCavaRadius * kCavaRadius));
      // LPS: anterior is -y, superior +z.
      const double front = -place.normal.y(), up = place.normal.z();
      if (up > 0.5)
        place.contact = kDiaphragm;
      else if (front < -0.2)
        place.contact = kBed;
      place.under_gas = front > 0.3 || up > 0.5;
      const double aside = (p.x() - notch_x) / kLigamentHalfWidth;
      if (tied && front > 0.3) place.tie = std::exp(-0.5 * aside * aside);
      places_.push_back(place);
    }
  }

  /// The organ in one operation, rigidly laid back on its rest shape. Empty: no equilibrium, or cancelled.
  std::optional<Points> run(const Draw& draw, const RunContext& context) const {
    fem::StaticOptions newton;
    newton.max_iterations = 40;
    newton.threads = 1;       // two operations are simulated at a time
    newton.tolerance = 1e-3;  // 20 um on the springs that hold the organ
    const auto solved = fem::solve_static(
        composite_, rest_, [&](const Points& x) { return loads(draw, x); }, newton, context);
    if (!solved || solved->residual > 10.0 * newton.tolerance) return std::nullopt;
    return fit_rigid<CtFrame, CtFrame>(solved->positions, rest_).apply(solved->positions);
  }

 private:
  struct Place {
    int node = 0;
    double area = 0.0, cava = 0.0, contact = 0.0, tie = 0.0;
    bool under_gas = false;
    Eigen::Vector3d normal, from_cava;
  };

  fem::Loads loads(const Draw& draw, const Points& x) const {
    fem::Loads loads;
    loads.gravity_change = options_.gravity * draw.gravity;
    const double contact = std::exp(options_.contact_spread * draw.contact),
                 tie = std::exp(options_.contact_spread * draw.tie);
    for (const Place& place : places_) {
      const double held = kCava * place.cava * place.area, rests = contact * place.contact * place.area,
                   tied = tie * kLigament * place.tie * place.area;
      const double k = held + rests + tied;
      const Eigen::Vector3d from_rest = (x.row(place.node) - rest_.row(place.node)).transpose();
      fem::AttachedLoad load;
      load.nodes[0] = place.node;
      load.weights[0] = 1.0;
      load.force = -k * from_rest +
                   rests * options_.bed_m * bed_way(draw, place.from_cava.x(), place.from_cava.z()) -
                   tied * options_.ligament_m * draw.lift * Eigen::Vector3d::UnitY();
      if (place.under_gas)
        load.force -=
            options_.gas_pa * (draw.gas + draw.gas_slope * place.from_cava.x()) * place.area * place.normal;
      load.tangent = k * Eigen::Matrix3d::Identity();
      if (k > 0.0 || place.under_gas) loads.attached.push_back(load);
    }
    return loads;
  }

  const OperationOptions& options_;
  fem::CompositeModel composite_;
  Points rest_;
  std::vector<Place> places_;
};

/// Principal components about the rest shape. The motion is u = L a + r, a the loads, L by regression, so its
/// covariance is L L^T + cov r. The covariance of a is known, for the loads were drawn: this is more exact
/// than estimating it from the few motions.
/// @param motions 3 N x n. @param loads Draw::kLoads x n.
Eigen::MatrixXd components(const Eigen::MatrixXd& motions, const Eigen::MatrixXd& loads, int most) {
  const Eigen::Index n = motions.cols(), k = loads.rows();
  Eigen::MatrixXd factors(motions.rows(), k + n);  // the covariance is factors factors^T
  factors.leftCols(k) = (loads * loads.transpose()).ldlt().solve(loads * motions.transpose()).transpose();
  factors.rightCols(n) = (motions - factors.leftCols(k) * loads) / std::sqrt(static_cast<double>(n - k));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(factors.transpose() * factors);
  const Eigen::Index kept = std::min<Eigen::Index>(most, n);
  return factors * eigen.eigenvectors().rightCols(kept).rowwise().reverse();
}

}  // namespace

bool OperationOptions::operator==(const OperationOptions& other) const {
  const auto all = [](const OperationOptions& o) {
    return std::tie(o.operations, o.modes, o.gravity, o.gas_pa, o.bed_m, o.ligament_m, o.contact_spread,
                    o.unforeseen_m, o.young_modulus, o.poisson_ratio, o.lesions);
  };
  return all(*this) == all(other);
}

void OperationOptions::validate() const {
  const OptionCheck demand("operation options");
  demand(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
  demand(operations >= kFewest + 10, "operations", operations, "Give 40 or more");
  demand(modes >= 1, "modes", modes, "Give 1 or more");
  demand(gravity >= 0.0 && gravity <= 20.0, "gravity", gravity, "Give a number from 0 to 20 m/s2");
  demand(gas_pa >= 0.0 && gas_pa <= 4000.0, "gas_pa", gas_pa, "Give a number from 0 to 4000 Pa");
  demand(bed_m >= 0.0 && bed_m <= 0.1, "bed_m", bed_m, "Give a number from 0 to 0.1 m");
  demand(ligament_m >= 0.0 && ligament_m <= 0.1, "ligament_m", ligament_m, "Give a number from 0 to 0.1 m");
  demand(unforeseen_m >= 0.0 && unforeseen_m <= 0.05, "unforeseen_m", unforeseen_m,
         "Give a number from 0 to 0.05 m");
  const auto is_modulus = [](double pascals) { return pascals >= 1.0 && pascals <= 1e9; };
  demand(is_modulus(young_modulus), "young_modulus", young_modulus, "Give a number from 1 to 1e9 Pa");
  demand(poisson_ratio >= 0.0 && poisson_ratio < 0.5, "poisson_ratio", poisson_ratio,
         "Give a number from 0 to below 0.5");
  for (const auto& [label, modulus] : lesions)
    demand(is_modulus(modulus), structure_name(label).c_str(), modulus, "Give a number from 1 to 1e9 Pa");
  demand(contact_spread >= 0.0 && contact_spread <= 2.0, "contact_spread", contact_spread,
         "Give a number from 0 to 2");
}

Points OperationPrior::shape(const Points& rest, const Eigen::VectorXd& amplitudes) const {
  require(amplitudes.size() == modes.cols() && 3 * rest.rows() == modes.rows(),
          "a prior moves the model that it was made from");
  const Eigen::VectorXd moved = modes * amplitudes;
  return rest + Eigen::Map<const Points>(moved.data(), rest.rows(), 3);
}

OperationPrior unknown_operations(const PatientModel& model, const OperationOptions& options,
                                  const RunContext& context) {
  OperationPrior prior;
  prior.modes = unforeseen_of(model, options, kUnknownMotion, context);
  return prior;
}

bool can_simulate_operations(const PatientModel& model) {
  return model.landmarks.vena_cava.rows() > 0 && model.surface.mesh.triangle_count() > 0;
}

Cancellable<OperationPrior> simulate_operations(const PatientModel& model, const OperationOptions& options,
                                                const RunContext& context) {
  options.validate();
  if (!can_simulate_operations(model))
    throw InputError("model", "vena cava", "its place is not known", "Place it among the landmarks");
  const Operations organ(model, options);
  const auto count = static_cast<std::size_t>(options.operations);
  // Each operation has a generator of its own, so that the two threads may take them in any order.
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < count; ++i)
    draws.emplace_back(context.random("registration.operation." + std::to_string(i)));
  std::vector<std::optional<Points>> outcomes(count);
  share_out(count, options.threads, [&](std::size_t i, bool here) {
    if (context.cancelled()) return;
    outcomes[i] = organ.run(draws[i], context.quiet());
    if (here)
      context.progress(static_cast<double>(i) / static_cast<double>(count), "registration.operations");
  });
  if (context.cancelled()) return std::nullopt;

  const auto found = static_cast<Eigen::Index>(std::count_if(
      outcomes.begin(), outcomes.end(), [](const auto& outcome) { return outcome.has_value(); }));
  if (found < kFewest)
    throw NumericalError("only " + std::to_string(found) + " of " + std::to_string(count) +
                         " simulated operations have an equilibrium: check the mesh and the vena cava");
  Eigen::MatrixXd motions(model.mesh.vertices.size(), found), loads(Draw::kLoads, found);
  OperationPrior prior;
  for (std::size_t i = 0; i < count; ++i) {
    if (!outcomes[i]) continue;
    const Points motion = *outcomes[i] - model.mesh.vertices;
    prior.mean_motion += motion.rowwise().norm().mean() / static_cast<double>(found);
    motions.col(prior.operations) = Eigen::Map<const Eigen::VectorXd>(motion.data(), motion.size());
    loads.col(prior.operations++) = draws[i].loads();
  }
  const Eigen::MatrixXd foreseen = components(motions, loads, options.modes);
  const fem::NodalColumns unforeseen = unforeseen_of(model, options, options.unforeseen_m, context);
  if (context.cancelled()) return std::nullopt;
  prior.modes.resize(foreseen.rows(), foreseen.cols() + unforeseen.cols());
  prior.modes << foreseen, unforeseen;
  return prior;
}

}  // namespace glisson::registration
