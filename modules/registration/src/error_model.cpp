// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/error_model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "farthest_first.h"
#include "force_rows.h"
#include "glisson/core/chi_square.h"
#include "glisson/core/error.h"
#include "unforeseen.h"

namespace glisson::registration {
namespace {

constexpr double kTurn = 0.5, kShift = 0.05;  ///< rad, m: of the pose beforehand
constexpr double kWholeSize = 0.3;            ///< of the organ's size beforehand
constexpr double kPlace = 25e-3;              ///< m
constexpr double kTolerance = 25.0;           ///< of the robust weight, squared deviations (shape_fit.cpp)
/// Factor on the linear model's deviations. They leave out contacts, other laws, and errors of the
/// segmentation beyond its mean. With it 95 % ellipsoids held 92 % of the development patients' lesions
/// (EVIDENCE.md).
constexpr double kLeftOut = 1.6;

/// Turns every node's vector.
void turn(fem::NodalColumns& columns, const Eigen::Matrix3d& rotation) {
  for (Eigen::Index row = 0; row < columns.rows(); row += 3)
    columns.middleRows<3>(row) = (rotation * columns.middleRows<3>(row)).eval();
}

/// A twist about the middle, and at the end a change of size.
fem::NodalColumns of_pose(const Points& nodes) {
  fem::NodalColumns columns = fem::NodalColumns::Zero(nodes.size(), 7);
  const Eigen::RowVector3d middle = nodes.colwise().mean();
  for (Eigen::Index i = 0; i < nodes.rows(); ++i) {
    const Eigen::Vector3d arm = (nodes.row(i) - middle).transpose();
    Eigen::Matrix3d cross;
    cross << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    columns.block<3, 3>(3 * i, 0) = kTurn * cross;
    columns.block<3, 3>(3 * i, 3) = kShift * Eigen::Matrix3d::Identity();
    columns.block<3, 1>(3 * i, 6) = kWholeSize * arm;
  }
  return columns;
}

/// How each row answers when its own look's camera was elsewhere; the first look has the pose.
Eigen::MatrixXd of_looks(const ForceRows& rows, Eigen::Index columns, const Eigen::RowVector3d& middle) {
  Eigen::MatrixXd answers = Eigen::MatrixXd::Zero(rows.size(), columns);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const int look = rows.seen_in[static_cast<std::size_t>(i)];
    if (look == 0) continue;
    const Eigen::Vector3d n = rows.directions.row(i).transpose();
    const Eigen::Vector3d arm = (rows.points.row(i) - middle).transpose();
    answers.row(i).segment<3>(6L * (look - 1)) = kTurn * arm.cross(n).transpose();
    answers.row(i).segment<3>(6L * (look - 1) + 3) = kShift * n.transpose();
  }
  return answers;
}

}  // namespace

Eigen::Vector3d LesionError::half_axes_95() const { return registration::half_axes_95(covariance); }

Eigen::Vector3d half_axes_95(const Eigen::Matrix3d& covariance) {
  if (!covariance.allFinite()) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance, Eigen::EigenvaluesOnly);
  return (kEllipsoid95 * eigen.eigenvalues().cwiseMax(0.0)).cwiseSqrt().reverse();
}

/// Exact along a line, in a plane and in space where the deviations are alike, between them by the number of
/// directions that count: n = (tr C)^2 / tr C^2, E|x| = sqrt(2 tr C / n) Gamma((n + 1) / 2) / Gamma(n / 2).
double mean_error(const Eigen::Matrix3d& covariance) {
  const double trace = covariance.trace(), square = covariance.squaredNorm();
  if (!covariance.allFinite()) return std::numeric_limits<double>::quiet_NaN();
  if (!(trace > 0.0)) return 0.0;
  const double n = trace * trace / square;
  return std::sqrt(2.0 * trace / n) * std::exp(std::lgamma(0.5 * (n + 1.0)) - std::lgamma(0.5 * n));
}

void ErrorModelOptions::validate() const {
  const OptionCheck demand("error model");
  demand(surface >= 0.0, "surface", surface, "Give a length from zero, in metres");
  demand(information > 0.0, "information", information, "Give a positive number");
  demand(unforeseen >= 0.0, "unforeseen", unforeseen, "Give a length from zero, in metres");
}

ErrorModel::ErrorModel(const PatientModel& model, const OperationPrior* prior,
                       const Eigen::VectorXd& amplitudes, const CameraFromCt& camera_from_ct,
                       const Points& nodes, const PreparedCloud& cloud, double noise,
                       const ErrorModelOptions& options, const RunContext& context) {
  options.validate();
  nodes_ = nodes;
  modes_ = prior != nullptr ? prior->modes.cols() : 0;
  Unforeseen others;
  others.motion = options.unforeseen;
  others.fixed_nodes = options.fixed_nodes;
  others.stiffness = options.stiffness;
  const fem::NodalColumns forces = unforeseen_motions(model, others, context);
  if (context.cancelled()) return;
  fem::NodalColumns motions(3L * model.mesh.vertex_count(), modes_ + forces.cols());
  if (modes_ > 0) motions.leftCols(modes_) = prior->modes;
  motions.rightCols(forces.cols()) = forces;
  turn(motions, camera_from_ct.rotation);
  // Forces and modes, the pose, where each further look was seen from; and the size.
  const Eigen::Index deforming = motions.cols(), looks = 6 * (cloud.cloud.look_count() - 1);
  const Eigen::Index unknowns = deforming + 6 + looks;
  places_of_cameras_ = 6 + looks;
  motions.conservativeResize(Eigen::NoChange, unknowns + 1);
  const fem::NodalColumns pose = of_pose(nodes);
  motions.middleCols<6>(deforming) = pose.leftCols<6>();
  if (options.pose_known) motions.middleCols<6>(deforming).setZero();
  motions.middleCols(deforming + 6, looks).setZero();
  motions.rightCols<1>() = pose.rightCols<1>();

  if (context.cancelled()) return;
  MovingSurface surface(model, SurfaceDetail::fine);
  surface.move(nodes);
  const double sigma = std::hypot(noise, options.surface);
  point_variance_ = sigma * sigma / options.information;
  const ForceRows rows =
      find_rows(cloud, surface, {sigma, std::sqrt(kTolerance) * sigma, options.information});
  if (context.cancelled()) return;
  const Eigen::MatrixXd all = rows.along(motions);
  rows_ = all.leftCols(unknowns);
  if (looks > 0) rows_.rightCols(looks) = of_looks(rows, looks, nodes.colwise().mean());
  points_ = rows.points;
  variance_ = rows.sigma.cwiseAbs2();
  Eigen::VectorXd y = rows.gap;
  if (amplitudes.size() == modes_ && modes_ > 0) y += rows_.leftCols(modes_) * amplitudes;

  if (context.cancelled()) return;
  const Eigen::MatrixXd weighted = variance_.cwiseInverse().asDiagonal() * rows_;
  Eigen::MatrixXd h = rows_.transpose() * weighted;
  h.diagonal().array() += 1.0;
  if (context.cancelled()) return;
  const Eigen::LLT<Eigen::MatrixXd> factor(h);
  root_ = factor.matrixU().solve(Eigen::MatrixXd::Identity(unknowns, unknowns));
  mean_ = factor.solve(weighted.transpose() * y);
  left_ = y - rows_ * mean_;
  if (context.cancelled()) return;
  spread_ = kLeftOut * (motions.leftCols(unknowns) * root_);

  const Eigen::VectorXd larger = all.col(unknowns);
  const auto inverse = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    return v.cwiseQuotient(variance_) - weighted * factor.solve(weighted.transpose() * v);
  };
  const double information = larger.dot(inverse(larger)) + 1.0;
  size_ = {kWholeSize * larger.dot(inverse(y)) / information, kWholeSize / std::sqrt(information)};
  points_.conservativeResize(rows.surface_count, 3);
  group(kPlace);
}

void ErrorModel::add_rival(const Points& elsewhere, double probability) {
  const Points away = std::sqrt(probability) * (elsewhere - nodes_);
  spread_.conservativeResize(Eigen::NoChange, spread_.cols() + 1);
  spread_.rightCols<1>() = Eigen::Map<const Eigen::VectorXd>(away.data(), away.size());
  ++rivals_;
}

void ErrorModel::group(double width) {
  const Spread spread = farthest_first(points_, width);
  places_.resize(spread.chosen.size());
  for (std::size_t i = 0; i < spread.nearest.size(); ++i)
    places_[spread.nearest[i]].push_back(static_cast<Eigen::Index>(i));
}

Eigen::MatrixXd ErrorModel::deviations(const Eigen::Vector4i& nodes, const Eigen::Vector4d& weights) const {
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(3, spread_.cols());
  for (int k = 0; k < 4; ++k)
    if (nodes[k] >= 0) moved += weights[k] * spread_.middleRows<3>(3L * nodes[k]);
  return moved;
}

Eigen::Matrix3d ErrorModel::covariance(const Eigen::Vector4i& nodes, const Eigen::Vector4d& weights) const {
  const Eigen::MatrixXd moved = deviations(nodes, weights);
  return moved * moved.transpose();
}

Eigen::MatrixXd ErrorModel::answers(const ForceRows& rows) const {
  Eigen::MatrixXd answers = rows.along(spread_);
  answers.leftCols(spread_.cols() - rivals_) /= kLeftOut;
  return answers;
}

double ErrorModel::variance_of_area(double area) const {
  return point_variance_ / (1e4 * CloudOptions().reference_density_per_cm2 * area);
}

std::vector<Eigen::Matrix3d> ErrorModel::covariances(const TetMesh& mesh, const Binding& points) const {
  std::vector<Eigen::Matrix3d> all;
  for (std::size_t i = 0; i < points.tetrahedron.size(); ++i)
    all.push_back(covariance(mesh.tetrahedra.row(points.tetrahedron[i]).transpose(),
                             points.weights.row(static_cast<Eigen::Index>(i)).transpose()));
  return all;
}

Eigen::VectorXd ErrorModel::expected() const {
  Eigen::VectorXd errors(spread_.rows() / 3);
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    const auto of_node = spread_.middleRows<3>(3 * i);
    errors[i] = mean_error(of_node * of_node.transpose());
  }
  return errors;
}

SymmetricRows ErrorModel::node_covariances() const {
  SymmetricRows all(spread_.rows() / 3, 6);
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    const auto of_node = spread_.middleRows<3>(3 * i);
    all.row(i) = symmetric_row(of_node * of_node.transpose());
  }
  return all;
}

double ErrorModel::misfit() const {
  double sum = 0.0;
  for (const auto& place : places_) sum += std::pow(left_(place).mean(), 2);
  return places_.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(places_.size()));
}

ErrorModel::HeldOut ErrorModel::held_out(const RunContext& context) const {
  HeldOut held;
  if (places_.size() < 2) return held;
  for (const auto& place : places_) {
    if (context.cancelled()) return {};
    // Left out, the place's residual is V (V - H)^-1 e, of covariance V (V - H)^-1 V; H = A S A^T.
    const Eigen::MatrixXd a = rows_(place, Eigen::all) * root_;
    Eigen::MatrixXd m = -a * a.transpose();
    const Eigen::VectorXd v = variance_(place);
    m.diagonal() += v;
    const Eigen::LDLT<Eigen::MatrixXd> factor(m);
    const double distance =
        v.dot(factor.solve(Eigen::VectorXd(left_(place)))) / static_cast<double>(place.size());
    const double square = v.dot(factor.solve(v)) / std::pow(static_cast<double>(place.size()), 2);
    held.distance += distance * distance;
    held.z += distance * distance / square;
  }
  held.distance = std::sqrt(held.distance / static_cast<double>(places_.size()));
  held.z = std::sqrt(held.z / static_cast<double>(places_.size()));
  return held;
}

double ErrorModel::decided() const {
  const Eigen::Index count = mean_.size() - places_of_cameras_;
  return static_cast<double>(count) - root_.topRows(count).squaredNorm();
}

double ErrorModel::strangeness() const {
  const double expected = decided();
  return expected > 1e-3 ? mean_.head(mean_.size() - places_of_cameras_).squaredNorm() / expected : 0.0;
}

}  // namespace glisson::registration
