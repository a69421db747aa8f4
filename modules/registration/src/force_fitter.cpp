// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_fitter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "glisson/core/error.h"

namespace glisson::registration {
namespace {

constexpr double kGroundLength = 0.1;                        ///< m, in the unit of the ground springs
constexpr double kPoseTranslation = 20e-3, kPoseTurn = 0.2;  ///< prior deviations of a stage's pose: m, rad
constexpr int kFirstUpdates = 12, kUpdates = 3;              ///< of the variances, an iteration
constexpr double kAtRest = 0.1e-3;                           ///< m
constexpr int kHalvings = 6;

std::vector<char> fixed_of(const fem::ElasticBody& body) {
  std::vector<char> fixed;
  for (int i = 0; i < body.node_count(); ++i) fixed.push_back(body.is_fixed(i) ? 1 : 0);
  return fixed;
}

Eigen::Matrix3d turn_by(const Eigen::Vector3d& twist) {
  const double angle = twist.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, twist / angle).toRotationMatrix()
                     : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

}  // namespace

ForceProblem::ForceProblem(const PatientModel& m, const LabelledCloud& c, const CameraFromCt& s,
                           const ContactForceOptions& o)
    : model(m),
      options(o),
      cloud(prepare_cloud(c, {3.9, o.most_points, 10})),
      surface(m, SurfaceDetail::fine),
      body(m.mesh, o.fixed_nodes, o.stiffness),
      force_surface(m.surface, m.mesh.vertices, fixed_of(body)),
      start(s),
      free_pose(o.fixed_nodes.empty()) {}

ForceFitter::ForceFitter(const ForceProblem& problem, const fem::BodyMaterial& material, double ground)
    : problem_(problem), body_(problem.body), surface_(problem.surface) {
  body_.set_material(material);
  if (ground > 0.0) springs_ = ground / (kGroundLength * kGroundLength) * body_.node_volumes();
  centre_ = body_.rest().colwise().mean().transpose();
  now_.pose = problem.start;
  now_.x = body_.rest();
  now_.law.material = material;
  now_.law.ground = ground;
  now_.law.log_evidence = -std::numeric_limits<double>::infinity();
  best_ = now_;
}

ForceFitter::Rows ForceFitter::pair(double sigma) {
  surface_.move(now_.x);
  const Points cloud = now_.pose.inverse().apply(problem_.cloud.cloud.points);
  const Eigen::Index count = cloud.rows();
  Rows rows;
  rows.points.resize(count, 3);
  rows.normals.resize(count, 3);
  rows.gap.resize(count);
  rows.sigma.resize(count);
  const double half = std::max(problem_.options.outlier_distance, 2.0 * sigma);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector3d p = cloud.row(i).transpose();
    const ClosestPoint at = surface_.closest(Feature::surface, p);
    const Eigen::Vector3d n = surface_.normal(at);
    rows.carriers.push_back(surface_.carrier(at));
    rows.points.row(i) = at.point.transpose();
    rows.normals.row(i) = n.transpose();
    rows.gap[i] = n.dot(p - at.point);
    rows.sigma[i] = sigma * std::sqrt(1.0 + at.distance * at.distance / (half * half));
  }
  return rows;
}

double ForceFitter::energy(const Points& x, Points* gradient) const {
  double sum = gradient != nullptr ? body_.energy(x, *gradient) : body_.energy(x);
  if (springs_.size() == 0) return sum;
  const Points moved = x - body_.rest();
  sum += 0.5 * springs_.dot(moved.rowwise().squaredNorm());
  if (gradient != nullptr) *gradient += springs_.asDiagonal() * moved;
  return sum;
}

void ForceFitter::choose_patches(const Rows& rows) {
  Points seen = Points::Zero(rows.points.rows(), 3);  // where they are on the body at rest
  for (std::size_t i = 0; i < rows.carriers.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (rows.carriers[i].nodes[k] >= 0)
        seen.row(static_cast<Eigen::Index>(i)) +=
            rows.carriers[i].weights[k] * body_.rest().row(rows.carriers[i].nodes[k]);
  const ContactForceOptions& o = problem_.options;
  now_.patches = problem_.force_surface.patches(seen, {o.patch_spacing, o.patch_radius, o.patch_reach});
  responses_.setZero(3L * body_.node_count(), 3L * static_cast<Eigen::Index>(now_.patches.size()));
  for (std::size_t j = 0; j < now_.patches.size(); ++j)
    for (const auto& [node, weight] : now_.patches[j].weights)
      for (int c = 0; c < 3; ++c) responses_(3L * node + c, 3 * static_cast<Eigen::Index>(j) + c) = weight;
  body_.solve(responses_);
}

/// What a force on each patch does to each gap; where the pose is free, a twist, too.
Eigen::MatrixXd ForceFitter::design(const Rows& rows) const {
  const Eigen::Index columns = responses_.cols(), count = rows.gap.size();
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(count, columns + (problem_.free_pose ? 6 : 0));
  Eigen::RowVectorXd row(columns);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Carrier& carrier = rows.carriers[static_cast<std::size_t>(i)];
    row.setZero();
    for (std::size_t k = 0; k < 4; ++k)
      if (carrier.nodes[k] >= 0)
        for (int c = 0; c < 3; ++c)
          row += (carrier.weights[k] * rows.normals(i, c)) * responses_.row(3L * carrier.nodes[k] + c);
    a.row(i).head(columns) = row;
    if (!problem_.free_pose) continue;
    const Eigen::Vector3d n = rows.normals.row(i).transpose();
    a.row(i).segment<3>(columns) = (rows.points.row(i).transpose() - centre_).cross(n).transpose();
    a.row(i).tail<3>() = n.transpose();
  }
  return a;
}

/// Moves the body to the equilibrium of the forces found, and the pose; shorter where the energy less the
/// forces' work would rise. @return the largest motion of a node.
double ForceFitter::step(const EvidencePosterior& found, const Points& relax, double energy_here) {
  const Eigen::Index columns = responses_.cols();
  Points forces = Points::Zero(body_.node_count(), 3);
  for (std::size_t j = 0; j < now_.patches.size(); ++j)
    for (const auto& [node, weight] : now_.patches[j].weights)
      forces.row(node) += weight * found.mean.segment<3>(3 * static_cast<Eigen::Index>(j)).transpose();
  Points change(body_.node_count(), 3);
  Eigen::Map<Eigen::VectorXd>(change.data(), change.size()).noalias() = responses_ * found.mean.head(columns);
  change -= relax;
  const double largest = change.cwiseAbs().maxCoeff();
  double share = std::min(1.0, problem_.options.max_step / std::max(largest, 1e-12));
  const double merit = energy_here - forces.cwiseProduct(now_.x).sum();
  Points next;
  for (int halving = 0; halving < kHalvings; ++halving, share *= 0.5) {
    next = now_.x + share * change;
    if (energy(next, nullptr) - forces.cwiseProduct(next).sum() <= merit + 1e-9 * std::abs(merit)) break;
  }
  now_.x = next;
  if (problem_.free_pose) {
    const Eigen::Matrix3d turn = turn_by(share * found.mean.segment<3>(columns));
    const CameraFromCt& old = now_.pose;
    const Eigen::Vector3d shift = centre_ - turn * centre_ + share * found.mean.tail<3>();
    now_.pose = {Eigen::Quaterniond(old.rotation * turn).normalized().toRotationMatrix(),
                 old.rotation * shift + old.translation};
  }
  now_.amplitudes = found.mean;
  return share * largest;
}

/// The stage is the most probable so far: notes what is told of it.
void ForceFitter::keep(const EvidencePosterior& found) {
  const Eigen::Index columns = responses_.cols();
  now_.deviations = found.root.rowwise().norm();
  // Columns without a variance add nothing.
  std::vector<Eigen::Index> active;
  for (Eigen::Index k = 0; k < columns; ++k)
    if (now_.deviations[k] > 0.0) active.push_back(k);
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(responses_.rows(), found.root.cols());
  if (!active.empty()) spread = responses_(Eigen::all, active) * found.root(active, Eigen::all);
  now_.expected_error.resize(body_.node_count());
  for (Eigen::Index i = 0; i < now_.expected_error.size(); ++i) {
    Eigen::MatrixXd of_node = spread.middleRows<3>(3 * i);
    if (problem_.free_pose) {
      const Eigen::Vector3d arm = now_.x.row(i).transpose() - centre_;
      for (Eigen::Index k = 0; k < of_node.cols(); ++k)
        of_node.col(k) +=
            Eigen::Vector3d(found.root.col(k).segment<3>(columns)).cross(arm) + found.root.col(k).tail<3>();
    }
    now_.expected_error[i] = of_node.norm();
  }
  best_ = now_;
}

bool ForceFitter::stage(double sigma, const RunContext& context) {
  const double nothing = -std::numeric_limits<double>::infinity();
  now_.law.sigma = sigma;
  now_.law.log_evidence = nothing;
  // The linear law's factor is the same everywhere.
  if (!factorised_ || body_.material().law != fem::BodyLaw::linear)
    factorised_ = body_.factorise(now_.x, springs_);
  if (!factorised_) return true;
  EvidencePosterior found;
  double motion = 0.0;
  for (int iteration = 0; iteration < problem_.options.iterations; ++iteration) {
    const Rows rows = pair(sigma);
    if (iteration == 0) choose_patches(rows);
    if (context.cancelled()) return false;
    if (now_.patches.empty()) return true;
    Points gradient;
    const double energy_here = energy(now_.x, &gradient);
    const Points relax = body_.solve(gradient);
    Eigen::VectorXd y = rows.gap;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const Carrier& carrier = rows.carriers[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < 4; ++k)
        if (carrier.nodes[k] >= 0)
          y[i] += carrier.weights[k] * rows.normals.row(i).dot(relax.row(carrier.nodes[k]));
    }
    const Eigen::MatrixXd a = design(rows);
    Eigen::VectorXd pose_variances;
    if (problem_.free_pose) {
      pose_variances.resize(6);
      pose_variances << Eigen::Vector3d::Constant(kPoseTurn * kPoseTurn),
          Eigen::Vector3d::Constant(kPoseTranslation * kPoseTranslation);
    }
    const auto groups = static_cast<int>(now_.patches.size());
    if (iteration == 0)
      variances_.setConstant(groups, y.squaredNorm() / a.leftCols(3L * groups).squaredNorm());
    const EvidenceProblem problem(a, y, rows.sigma, groups, 3, pose_variances);
    variances_ = maximise_evidence(problem, variances_, iteration == 0 ? kFirstUpdates : kUpdates);
    if (context.cancelled()) return false;
    found = posterior(problem, variances_);
    now_.law.log_evidence = found.log_evidence;
    now_.law.residual = rows.gap.cwiseAbs().mean();
    now_.outlier_share = (rows.sigma.array() > std::sqrt(2.0) * sigma).cast<double>().mean();
    motion = step(found, relax, energy_here);
    ++iterations_;
    if (!std::isfinite(motion) || !std::isfinite(found.log_evidence)) {
      now_.law.log_evidence = nothing;
      return true;
    }
    if (motion < kAtRest) break;
  }
  now_.law.termination = motion < kAtRest ? Termination::converged : Termination::step_limit;
  if (now_.law.log_evidence > best_.law.log_evidence) keep(found);
  return true;
}

bool ForceFitter::run(const RunContext& context, const std::function<void()>& advance) {
  for (const double sigma : problem_.options.sigmas) {
    if (!stage(sigma, context)) return false;
    advance();
    if (!std::isfinite(now_.law.log_evidence)) break;
  }
  return true;
}

ContactForceFit ForceFitter::result() const {
  ContactForceFit fit;
  fit.camera_from_ct = best_.pose;
  fit.nodes_in_camera = best_.pose.apply(best_.x);
  fit.patches = static_cast<int>(best_.patches.size());
  for (std::size_t j = 0; j < best_.patches.size(); ++j) {
    const auto at = 3 * static_cast<Eigen::Index>(j);
    const Eigen::Vector3d force = best_.amplitudes.segment<3>(at);
    if (force.norm() > 0.0)
      fit.forces.push_back(
          {best_.patches[j].node, force, best_.deviations.segment<3>(at).norm() / std::sqrt(3.0)});
  }
  std::sort(fit.forces.begin(), fit.forces.end(), [](const ContactForce& a, const ContactForce& b) {
    return a.force.squaredNorm() > b.force.squaredNorm();
  });
  fit.expected_error = best_.expected_error;
  fit.residual = best_.law.residual;
  fit.outlier_share = best_.outlier_share;
  fit.inverted = body_.inverted(best_.x);
  fit.iterations = iterations_;
  fit.termination = best_.law.termination;
  return fit;
}

}  // namespace glisson::registration
