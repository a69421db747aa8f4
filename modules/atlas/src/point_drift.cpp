// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_drift.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace glisson::atlas {
namespace {

constexpr double kOutliers = 0.1;  // share of points that are taken to have no partner
constexpr double kNormals = 2.0;   // weight of normals: exp(kNormals (n n' - 1))
/// Of the size: half the distance between 500 points on a liver. Below it each point would run to the one
/// sample that happens to lie closest, 7 mm along the surface.
constexpr double kLeastSigma = 0.1;
constexpr int kRank = 120;                  // of the kernel
constexpr double kBends = 0.5;              // weight of bends: exp(-kBends (b - b')^2 / 2)
constexpr double kHeld = 0.5;               // weight of the expected rotation, over that of all points
constexpr std::array kRadii = {0.3, 0.65};  // of the surroundings in which a point bends: 21 and 46 mm
constexpr double kSameSide = -0.2;  // cosine of the normals, up to which two points lie on different sides
constexpr double kNormalMisfit = 0.05, kBendMisfit = 0.01;  // over squared distance

/// What the fixed points say about where each moving point should be.
struct Pull {
  Eigen::VectorXd weight;  ///< one a moving point
  Points target;           ///< their weighted mean
  double sigma2 = 0.0;     ///< of the next pass
};

Eigen::MatrixXd squared_differences(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd d = -2.0 * a * b.transpose();
  d.colwise() += a.rowwise().squaredNorm();
  d.rowwise() += b.rowwise().squaredNorm().transpose();
  return d.cwiseMax(0.0);
}
Eigen::MatrixXd squared_distances(const Points& a, const Points& b) { return squared_differences(a, b); }

/// What a moving and a fixed point have to do with each other, as one product of a row of either: the
/// exponent of -d^2 / (2 sigma^2) + kNormals (n n' - 1) - kBends (b - b')^2 / 2.
struct Affinity {
  Eigen::MatrixXd moving, fixed;

  Affinity(const Oriented& from, const Oriented& to, double sigma2) {
    const Eigen::Index bends = std::min(from.bends.cols(), to.bends.cols());  // none where one's are unknown
    const auto squares = [&](const Oriented& one) {
      Eigen::VectorXd sum = one.points.rowwise().squaredNorm() / sigma2;
      if (bends > 0) sum += kBends * one.bends.rowwise().squaredNorm();
      return Eigen::VectorXd(-0.5 * sum);
    };
    moving = Eigen::MatrixXd::Ones(from.points.rows(), 8 + bends);
    moving.leftCols(3) = from.points / sigma2;
    moving.middleCols(3, 3) = kNormals * from.normals;
    moving.col(6) = squares(from);
    fixed = Eigen::MatrixXd::Ones(to.points.rows(), 8 + bends);
    fixed.leftCols(3) = to.points;
    fixed.middleCols(3, 3) = to.normals;
    fixed.col(7) = squares(to).array() - kNormals;
    if (bends == 0) return;
    moving.rightCols(bends) = kBends * from.bends;
    fixed.rightCols(bends) = to.bends;
  }
};

/// The fixed points count as many as the moving ones, each by its share. Single precision holds probabilities
/// to 1e-5 and costs a third.
Pull expect(const Oriented& moving, const Oriented& fixed, double sigma2) {
  constexpr Eigen::Index kAtOnce = 128;  // whose table stays in the processor's cache
  constexpr float kNever = -60.0F;  // exponent; far smaller ones would be denormal numbers, which are slow
  // The mean of exp(kNormals (cos - 1)) over the sphere, so that outliers keep their share.
  const double share = (1.0 - std::exp(-2.0 * kNormals)) / (2.0 * kNormals);
  const double outliers =
      share * std::pow(2.0 * std::numbers::pi * sigma2, 1.5) * kOutliers / (1.0 - kOutliers);
  const Eigen::Index count = moving.points.rows(), all = fixed.points.rows();
  const Affinity affinity(moving, fixed, sigma2);
  Eigen::MatrixXf places(all, 4);  // of the fixed points, and 1: their sums are wanted
  places << fixed.points.cast<float>(), Eigen::VectorXf::Ones(all);
  const Eigen::MatrixXf of_moving = affinity.moving.cast<float>(), of_fixed = affinity.fixed.cast<float>();
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, 4);
  Eigen::MatrixXf p;
  double squares = 0.0;  // p |b|^2, then p |a - b|^2
  for (Eigen::Index first = 0; first < all; first += kAtOnce) {
    const Eigen::Index some = std::min(kAtOnce, all - first);
    p.noalias() = of_moving * of_fixed.middleRows(first, some).transpose();
    p = p.array().max(kNever).exp();
    for (Eigen::Index j = 0; j < some; ++j) {
      const auto sum = static_cast<double>(p.col(j).sum());
      const double scale = static_cast<double>(count) * fixed.weights[first + j] / (sum + outliers + 1e-300);
      p.col(j) *= static_cast<float>(scale);
      squares += sum * scale * fixed.points.row(first + j).squaredNorm();
    }
    sums += (p * places.middleRows(first, some)).cast<double>();
  }
  Pull pull;
  pull.weight = sums.col(3);
  squares += pull.weight.dot(moving.points.rowwise().squaredNorm()) -
             2.0 * moving.points.cwiseProduct(sums.leftCols(3)).sum();
  pull.target = pull.weight.cwiseMax(1e-12).cwiseInverse().asDiagonal() * sums.leftCols(3);
  for (Eigen::Index i = 0; i < pull.weight.size(); ++i)
    if (pull.weight[i] < 1e-10) pull.target.row(i) = moving.points.row(i);
  pull.sigma2 = std::max(0.0, squares) / std::max(1e-12, 3.0 * pull.weight.sum());
  return pull;
}

/// The similarity that fits the pull while its rotation is held near `held`: six more pairs of points, on
/// arms along the axes, are fitted along with weight kHeld of the whole.
Similarity upright_similarity(const Points& moving, const Pull& pull, const Eigen::Matrix3d& held) {
  const Similarity free = fit_similarity(moving, pull.target, pull.weight);
  const double total = pull.weight.sum();
  const Eigen::RowVector3d from = pull.weight.transpose() * moving / total;
  const Eigen::RowVector3d to = pull.weight.transpose() * pull.target / total;
  Points source(moving.rows() + 6, 3), target(moving.rows() + 6, 3);
  source.topRows(moving.rows()) = moving;
  target.topRows(moving.rows()) = pull.target;
  Eigen::VectorXd weight = Eigen::VectorXd::Constant(moving.rows() + 6, kHeld * total / 6.0);
  weight.head(moving.rows()) = pull.weight;
  for (int k = 0; k < 6; ++k) {
    const Eigen::RowVector3d arm = (k < 3 ? 1.0 : -1.0) * Eigen::RowVector3d::Unit(k % 3);
    source.row(moving.rows() + k) = from + arm;
    target.row(moving.rows() + k) = to + free.scale * arm * held.transpose();
  }
  return fit_similarity(source, target, weight);
}

double least(double sigma2) { return std::max(sigma2, kLeastSigma * kLeastSigma); }

Oriented moved(const Oriented& shape, const Similarity& by) {
  return {by.apply(shape.points), shape.normals * by.rotation.transpose(), shape.bends, shape.weights};
}

/// Mean distance to the closest point of the other shape, both ways averaged. The squared distance of two
/// points is that of their places, plus kNormalMisfit (1 - cosine of the normals), plus kBendMisfit times
/// that of the bends.
double misfit(const Oriented& a, const Oriented& b) {
  Eigen::MatrixXd d = squared_distances(a.points, b.points);
  d.array() += kNormalMisfit * (1.0 - (a.normals * b.normals.transpose()).array());
  if (a.bends.cols() > 0 && b.bends.cols() > 0) d += kBendMisfit * squared_differences(a.bends, b.bends);
  d = d.cwiseMax(0.0);
  return 0.5 * (a.weights.dot(d.rowwise().minCoeff().cwiseSqrt()) +
                b.weights.dot(d.colwise().minCoeff().cwiseSqrt().transpose()));
}

}  // namespace

Eigen::MatrixXd bends_of(const Oriented& queries, const Oriented& dense) {
  Eigen::MatrixXd bends(queries.points.rows(), static_cast<Eigen::Index>(kRadii.size()));
  for (Eigen::Index i = 0; i < queries.points.rows(); ++i) {
    const Eigen::RowVector3d p = queries.points.row(i), n = queries.normals.row(i);
    std::array<Eigen::RowVector3d, kRadii.size()> sums;
    sums.fill(Eigen::RowVector3d::Zero());
    std::array<double, kRadii.size()> counts{};
    for (Eigen::Index j = 0; j < dense.points.rows(); ++j) {
      const Eigen::RowVector3d off = dense.points.row(j) - p;
      const double squared = off.squaredNorm();
      if (squared >= kRadii.back() * kRadii.back()) continue;
      // What faces away is another side. All falls off smoothly: no point comes or goes at once.
      const double same = std::max(0.0, dense.normals.row(j).dot(n) - kSameSide) * dense.weights[j];
      for (std::size_t r = 0; r < kRadii.size(); ++r) {
        const double fall = std::max(0.0, 1.0 - squared / (kRadii[r] * kRadii[r]));
        sums[r] += same * fall * fall * off;
        counts[r] += same * fall * fall;
      }
    }
    for (std::size_t r = 0; r < kRadii.size(); ++r)
      bends(i, static_cast<Eigen::Index>(r)) =
          counts[r] > 0.0 ? -sums[r].dot(n) / counts[r] / kRadii[r] : 0.0;
  }
  return bends;
}

void over_their_deviation(Oriented& shape) {
  for (Eigen::Index c = 0; c < shape.bends.cols(); ++c) {
    const double mean = shape.weights.dot(shape.bends.col(c));
    const double variance = shape.weights.dot((shape.bends.col(c).array() - mean).square().matrix());
    shape.bends.col(c) /= std::sqrt(variance) + 1e-9;
  }
}

std::vector<int> farthest_points(const Points& points, int count) {
  std::vector<int> chosen;
  Eigen::Index next = 0;
  (points.rowwise() - points.colwise().mean()).rowwise().squaredNorm().maxCoeff(&next);
  Eigen::VectorXd distance =
      Eigen::VectorXd::Constant(points.rows(), std::numeric_limits<double>::infinity());
  while (static_cast<int>(chosen.size()) < count) {
    chosen.push_back(static_cast<int>(next));
    const Eigen::RowVector3d at = points.row(next);
    distance = distance.cwiseMin((points.rowwise() - at).rowwise().squaredNorm());
    distance.maxCoeff(&next);
  }
  return chosen;
}

Points rows_of(const Points& points, const std::vector<int>& rows) {
  Points chosen(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    chosen.row(static_cast<Eigen::Index>(i)) = points.row(rows[i]);
  return chosen;
}

Pose drift_similarity(const Oriented& moving, const Oriented& fixed, Pose pose, int passes) {
  for (int pass = 0; pass < passes; ++pass) {
    const Pull pull = expect(moved(moving, pose.similarity), fixed, pose.sigma2);
    pose.similarity = upright_similarity(moving.points, pull, pose.held);
    pose.sigma2 = least(pull.sigma2);
  }
  pose.misfit = misfit(moved(moving, pose.similarity), fixed);
  return pose;
}

Eigen::VectorXd drift_modes(const Oriented& moving, const Eigen::MatrixXd& modes,
                            const Eigen::VectorXd& variances, const Oriented& fixed, Pose& pose, int passes) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(modes.cols());
  Points shape = moving.points;
  for (int pass = 0; pass < passes; ++pass) {
    const Pull pull = expect(moved({shape, moving.normals, moving.bends, moving.weights}, pose.similarity),
                             fixed, pose.sigma2);
    pose.similarity = upright_similarity(shape, pull, pose.held);
    pose.sigma2 = least(pull.sigma2);
    const Points wanted = pose.similarity.inverse().apply(pull.target) - moving.points;
    const Eigen::VectorXd weight = pull.weight.replicate(1, 3).transpose().reshaped();
    const Eigen::MatrixXd weighted = weight.asDiagonal() * modes;
    Eigen::MatrixXd normal = modes.transpose() * weighted;
    const double noise = pose.sigma2 / (pose.similarity.scale * pose.similarity.scale);
    normal.diagonal() += noise * variances.cwiseInverse();
    b = normal.llt().solve(weighted.transpose() *
                           Eigen::Map<const Eigen::VectorXd>(wanted.data(), wanted.size()));
    b = b.cwiseMin(3.0 * variances.cwiseSqrt()).cwiseMax(-3.0 * variances.cwiseSqrt());
    shape = moving.points;
    Eigen::Map<Eigen::VectorXd>(shape.data(), shape.size()) += modes * b;
  }
  return b;
}

Cancellable<Points> drift_smooth(const TriangleMesh& mesh, const std::vector<int>& chosen,
                                 const Eigen::MatrixXd& bends, const Oriented& fixed, double width,
                                 double stiffness, double sigma2, int passes, const RunContext& context) {
  const Points rest = rows_of(mesh.vertices, chosen);
  const double fall = -0.5 / (width * width);
  const Eigen::MatrixXd kernel = (fall * squared_distances(rest, rest).array()).exp();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(kernel);
  const Eigen::Index rank = std::min<Eigen::Index>(kRank, kernel.rows());
  const Eigen::VectorXd root = solver.eigenvalues().tail(rank).cwiseMax(1e-9).cwiseSqrt();
  const Eigen::MatrixXd vectors = solver.eigenvectors().rightCols(rank);
  const Eigen::MatrixXd basis = vectors * root.asDiagonal();
  const Eigen::MatrixXd everywhere = (fall * squared_distances(mesh.vertices, rest).array()).exp().matrix() *
                                     vectors * root.cwiseInverse().asDiagonal();
  TriangleMesh now = mesh;
  for (int pass = 0; pass < passes; ++pass) {
    if (context.cancelled()) return {};
    const Oriented moving{rows_of(now.vertices, chosen), rows_of(vertex_normals(now), chosen), bends,
                          Eigen::VectorXd::Constant(rest.rows(), 1.0 / static_cast<double>(rest.rows()))};
    const Pull pull = expect(moving, fixed, sigma2);
    const Eigen::MatrixXd weighted = pull.weight.asDiagonal() * basis;
    Eigen::MatrixXd normal = basis.transpose() * weighted;
    normal.diagonal().array() += stiffness * sigma2;
    const Eigen::MatrixXd amount = normal.llt().solve(weighted.transpose() * (pull.target - rest));
    now.vertices = mesh.vertices + everywhere * amount;
    const Points there = rest + basis * amount;
    const double spread =
        (pull.weight.array() * (pull.target - there).rowwise().squaredNorm().array()).sum() /
        std::max(1e-12, 3.0 * pull.weight.sum());
    // What the targets spread about their means, and what is left to their means.
    const double within =
        pull.sigma2 -
        (pull.weight.array() * (pull.target - moving.points).rowwise().squaredNorm().array()).sum() /
            std::max(1e-12, 3.0 * pull.weight.sum());
    sigma2 = least(std::max(0.0, within) + spread);
  }
  return std::move(now.vertices);
}

}  // namespace glisson::atlas
