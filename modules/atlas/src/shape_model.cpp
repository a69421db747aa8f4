// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/shape_model.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <numeric>

#include "glisson/core/error.h"

namespace glisson::atlas {
namespace {

constexpr int kPasses = 100;
constexpr double kStill = 1e-12;  // change of the mean over its size at which alignment ends

Eigen::Vector3d mean_of(const Points& points, const Eigen::VectorXd& weights) {
  if (weights.size() == 0) return points.colwise().mean().transpose();
  return points.transpose() * weights / weights.sum();
}

/// x0 y0 z0 x1 ...: rows of a row-major array lie so already.
Eigen::Map<const Eigen::VectorXd> flat(const Points& points) { return {points.data(), points.size()}; }

double sum_of(const std::vector<double>& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

double mean_size(const std::vector<Points>& members, const std::vector<double>& weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < members.size(); ++i) sum += weights[i] * std::log(size_of(members[i]));
  return std::exp(sum / sum_of(weights));
}

/// Back to the wanted size, in the gauge's place and orientation.
Points normalised(const Points& mean, const Points& gauge, double size) {
  const Similarity turn = fit_similarity(mean, gauge);
  const Eigen::RowVector3d place = gauge.colwise().mean();
  const Points centred = (mean.rowwise() - mean.colwise().mean()) * turn.rotation.transpose();
  return (centred * (size / size_of(mean))).rowwise() + place;
}

}  // namespace

Points Similarity::apply(const Points& points) const {
  return (scale * points * rotation.transpose()).rowwise() + translation.transpose();
}

Similarity Similarity::inverse() const {
  Similarity back;
  back.scale = 1.0 / scale;
  back.rotation = rotation.transpose();
  back.translation = -(back.rotation * translation) / scale;
  return back;
}

Similarity fit_similarity(const Points& source, const Points& target, const Eigen::VectorXd& weights) {
  require(source.rows() == target.rows() && source.rows() >= 3, "a similarity needs three pairs of points");
  require(weights.size() == 0 || weights.size() == source.rows(), "one weight a pair");
  const Eigen::Vector3d from = mean_of(source, weights), to = mean_of(target, weights);
  const Points p = source.rowwise() - from.transpose(), q = target.rowwise() - to.transpose();
  const Points weighted = weights.size() == 0 ? p : Points(weights.asDiagonal() * p);
  const Eigen::Matrix3d moment = weighted.transpose() * q;  // P Pbar^T: sum of p q^T
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  Similarity fit;
  fit.rotation = svd.matrixV() * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * svd.matrixU().transpose();
  const double extent = weighted.cwiseProduct(p).sum();
  require(extent > 0.0, "a similarity needs points that differ");
  fit.scale = (fit.rotation * moment).trace() / extent;
  fit.translation = to - fit.scale * fit.rotation * from;
  return fit;
}

double size_of(const Points& points) {
  return std::sqrt((points.rowwise() - points.colwise().mean()).squaredNorm() /
                   static_cast<double>(points.rows()));
}

Procrustes align(const std::vector<Points>& members, const std::vector<double>& weights,
                 const Points& gauge) {
  require(members.size() >= 2 && members.size() == weights.size(), "two shapes at least, a weight each");
  for (const Points& member : members)
    require(member.rows() == gauge.rows(), "shapes correspond point by point");
  const double size = mean_size(members, weights), total = sum_of(weights);
  Procrustes result;
  result.mean = normalised(gauge, gauge, size);
  result.mean_from_member.resize(members.size());
  for (result.iterations = 1; result.iterations <= kPasses; ++result.iterations) {
    Points mean = Points::Zero(gauge.rows(), 3);
    for (std::size_t i = 0; i < members.size(); ++i)
      mean += weights[i] / total * fit_similarity(members[i], result.mean).apply(members[i]);
    mean = normalised(mean, gauge, size);
    const double change = (mean - result.mean).norm() / (size * std::sqrt(static_cast<double>(mean.rows())));
    result.mean = std::move(mean);
    if (change < kStill) break;
  }
  for (std::size_t i = 0; i < members.size(); ++i)
    result.mean_from_member[i] = fit_similarity(members[i], result.mean);
  return result;
}

Points ShapeModel::instance(const Eigen::VectorXd& b) const {
  require(b.size() == variances.size(), "one coefficient a mode");
  Points shape = mean;
  Eigen::Map<Eigen::VectorXd>(shape.data(), shape.size()) += modes * b;
  return shape;
}

Eigen::VectorXd ShapeModel::coefficients(const Points& shape) const {
  require(shape.rows() == mean.rows(), "the shape corresponds to the mean");
  return modes.transpose() * (flat(shape) - flat(mean));
}

ShapeModel shape_model(const std::vector<Points>& aligned, const std::vector<double>& weights, double share) {
  require(aligned.size() >= 2 && aligned.size() == weights.size(), "two shapes at least, a weight each");
  require(share > 0.0 && share <= 1.0, "a share lies in (0, 1]");
  const auto n = static_cast<Eigen::Index>(aligned.size());
  const double total = sum_of(weights);
  ShapeModel model;
  model.mean = Points::Zero(aligned.front().rows(), 3);
  double squares = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    model.mean += weights[i] / total * aligned[i];
    squares += weights[i] * weights[i] / (total * total);
  }
  // Columns sqrt(w) (x - mean); the small n x n Gram matrix has the covariance's eigenvalues.
  Eigen::MatrixXd data(model.mean.size(), n);
  for (Eigen::Index i = 0; i < n; ++i)
    data.col(i) = std::sqrt(weights[i] / (total * (1.0 - squares))) * (flat(aligned[i]) - flat(model.mean));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(data.transpose() * data);
  const Eigen::VectorXd values = solver.eigenvalues().reverse().cwiseMax(0.0);
  model.total_variance = values.sum();
  Eigen::Index kept = 0;
  const double floor = 1e-20 * std::max(1e-300, model.mean.squaredNorm());
  for (double sum = 0.0; kept + 1 < n && values[kept] > floor && sum < share * model.total_variance; ++kept)
    sum += values[kept];
  model.variances = values.head(kept);
  model.modes.resize(model.mean.size(), kept);
  for (Eigen::Index k = 0; k < kept; ++k) {
    Eigen::VectorXd mode = (data * solver.eigenvectors().col(n - 1 - k)).normalized();
    Eigen::Index largest = 0;
    mode.cwiseAbs().maxCoeff(&largest);
    model.modes.col(k) = mode[largest] < 0.0 ? Eigen::VectorXd(-mode) : mode;
  }
  return model;
}

}  // namespace glisson::atlas
