// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "glisson/core/error.h"

namespace glisson::atlas {
namespace {

constexpr int kMostModes = 3;     // on which a structure's place may depend
constexpr int kMembersAMode = 6;  // at least, for each of them
constexpr double kRidge = 2.0;    // prior of the slopes, in members
/// Below this nothing is known: correspondence and marks have errors of their own (metres).
constexpr double kLeastDeviation = 0.001;

/// 95 % of Fisher's F with 3 and n degrees of freedom (Abramowitz and Stegun, table 26.9), linear in 1 / n.
double fisher95(double n) {
  static constexpr std::array<std::pair<double, double>, 12> kTable = {{{1, 215.7},
                                                                        {2, 19.16},
                                                                        {3, 9.277},
                                                                        {4, 6.591},
                                                                        {5, 5.409},
                                                                        {6, 4.757},
                                                                        {8, 4.066},
                                                                        {10, 3.708},
                                                                        {15, 3.287},
                                                                        {20, 3.098},
                                                                        {30, 2.922},
                                                                        {60, 2.758}}};
  if (n <= 1.0) return kTable.front().second;
  for (std::size_t i = 1; i < kTable.size(); ++i) {
    const auto [high_n, high] = kTable[i];
    if (n > high_n) continue;
    const auto [low_n, low] = kTable[i - 1];
    const double share = (1.0 / low_n - 1.0 / n) / (1.0 / low_n - 1.0 / high_n);
    return low + share * (high - low);
  }
  return 2.605 + (kTable.back().second - 2.605) * 60.0 / n;
}

/// Rows 1, z1, z2, ... of the observations.
struct Regression {
  Eigen::MatrixXd design;  ///< n x (1 + modes)
  Eigen::MatrixXd values;  ///< n x 3K
  Eigen::VectorXd weights;

  /// (1 + modes) x 3K, without one row. @param left_out -1: none
  Eigen::MatrixXd solve(Eigen::Index left_out) const {
    Eigen::VectorXd w = weights;
    if (left_out >= 0) w[left_out] = 0.0;
    Eigen::MatrixXd normal = design.transpose() * w.asDiagonal() * design;
    normal.diagonal().tail(normal.rows() - 1).array() += kRidge;
    return normal.ldlt().solve(design.transpose() * w.asDiagonal() * values);
  }
  Eigen::MatrixXd residuals() const {
    Eigen::MatrixXd left(values.rows(), values.cols());
    for (Eigen::Index i = 0; i < values.rows(); ++i) left.row(i) = values.row(i) - design.row(i) * solve(i);
    return left;
  }
};

Regression regression(const std::vector<Observation>& observed, Eigen::Index modes) {
  const auto n = static_cast<Eigen::Index>(observed.size());
  Regression r{Eigen::MatrixXd::Ones(n, 1 + modes), Eigen::MatrixXd(n, observed.front().points.size()),
               Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Observation& one = observed[static_cast<std::size_t>(i)];
    r.design.row(i).tail(modes) = one.modes.head(modes).transpose();
    r.values.row(i) = Eigen::Map<const Eigen::RowVectorXd>(one.points.data(), one.points.size());
    r.weights[i] = one.weight;
  }
  return r;
}

Points rows_of_three(const Eigen::VectorXd& flat) {
  return Eigen::Map<const Points>(flat.data(), flat.size() / 3, 3);
}

}  // namespace

int modes_for(const std::vector<std::vector<Observation>>& structures) {
  std::vector<double> left(kMostModes + 1, 0.0);
  for (const std::vector<Observation>& observed : structures) {
    require(observed.size() >= 3, "statistics need three members");
    const int most = std::min({kMostModes, static_cast<int>(observed.size()) / kMembersAMode,
                               static_cast<int>(observed.front().modes.size())});
    left.resize(std::min(left.size(), static_cast<std::size_t>(most) + 1));
    const double without = std::max(regression(observed, 0).residuals().squaredNorm(), 1e-30);
    for (std::size_t modes = 0; modes < left.size(); ++modes)
      left[modes] +=
          regression(observed, static_cast<Eigen::Index>(modes)).residuals().squaredNorm() / without;
  }
  return static_cast<int>(std::min_element(left.begin(), left.end()) - left.begin());
}

double spread_of(const std::vector<Observation>& observed) {
  Points middles(static_cast<Eigen::Index>(observed.size()), 3);
  for (std::size_t i = 0; i < observed.size(); ++i)
    middles.row(static_cast<Eigen::Index>(i)) = observed[i].points.colwise().mean();
  const Eigen::RowVector3d mean = middles.colwise().mean();
  return std::sqrt((middles.rowwise() - mean).rowwise().squaredNorm().mean());
}

double slope_size(const StructureStatistics& statistics) {
  return std::sqrt(statistics.slopes.squaredNorm() / static_cast<double>(statistics.slopes.rows()));
}

void observe(StructureStatistics& statistics, const std::vector<Observation>& observed, int modes) {
  require(observed.size() >= 3, "statistics need three members");
  const auto n = static_cast<int>(observed.size());
  const Regression chosen = regression(observed, modes);
  const Eigen::MatrixXd best = chosen.solve(-1), residuals = chosen.residuals();
  statistics.mean = rows_of_three(best.row(0).transpose());
  statistics.slopes = best.bottomRows(best.rows() - 1).transpose();
  statistics.members.clear();
  statistics.residuals.clear();
  for (int i = 0; i < n; ++i) {
    statistics.members.push_back(observed[static_cast<std::size_t>(i)].member);
    statistics.residuals.push_back(rows_of_three(residuals.row(i).transpose()));
  }
}

void sum_up(StructureStatistics& statistics) {
  const auto n = static_cast<int>(statistics.residuals.size());
  statistics.summed.assign(static_cast<std::size_t>(statistics.mean.rows()), Eigen::Matrix3d::Zero());
  for (const Points& residual : statistics.residuals)
    for (Eigen::Index k = 0; k < residual.rows(); ++k)
      statistics.summed[static_cast<std::size_t>(k)] += residual.row(k).transpose() * residual.row(k) / n;
  statistics.summed_livers = n;
  statistics.residuals.clear();
  statistics.members.clear();
}

Points predicted(const StructureStatistics& statistics, const Eigen::VectorXd& modes) {
  Points points = statistics.mean;
  const Eigen::Index used = std::min(statistics.slopes.cols(), modes.size());
  if (used > 0)
    Eigen::Map<Eigen::VectorXd>(points.data(), points.size()) +=
        statistics.slopes.leftCols(used) * modes.head(used);
  return points;
}

namespace {

/// Of n residuals' sum of squares, with what is added.
Eigen::Matrix3d widened(const StructureStatistics& statistics, const Eigen::Matrix3d& sum, int n,
                        double growth) {
  const Eigen::Matrix3d even = Eigen::Matrix3d::Identity() * (sum.trace() / (3.0 * n));
  const Eigen::Matrix3d own = (sum + kEvenMembers * even) / (n + kEvenMembers);
  // A new residual's T^2 with the covariance of n others about a known mean is 3 n / (n - 2) F(3, n - 2).
  const double degrees = std::max(1.0, n + kEvenMembers - 2.0);
  const double widening = 3.0 * (n + kEvenMembers) / degrees * fisher95(degrees) / kEllipsoid95;
  const double beyond = std::max(1.0, growth / statistics.added_unusual);
  const double added = statistics.added_deviation * beyond;
  if (added == 0.0) growth = beyond;  // the members are the livers that it was set on
  const double even_part = added * added + growth * growth * kLeastDeviation * kLeastDeviation;
  return growth * growth * widening * own + even_part * Eigen::Matrix3d::Identity();
}

}  // namespace

Eigen::Matrix3d covariance(const StructureStatistics& of, const Dependence& on, int point, double growth) {
  return widened(of, on.livers * on.left[static_cast<std::size_t>(point)], on.livers, growth);
}

Eigen::Matrix3d covariance(const StructureStatistics& statistics, int point, int left_out, double growth) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  int n = 0;
  for (std::size_t i = 0; i < statistics.residuals.size(); ++i) {
    if (static_cast<int>(i) == left_out) continue;
    const Eigen::RowVector3d r = statistics.residuals[i].row(point);
    sum += r.transpose() * r;
    ++n;
  }
  if (statistics.summed_livers > 0) {
    n = statistics.summed_livers;
    sum = n * statistics.summed[static_cast<std::size_t>(point)];
  }
  require(n >= 1, "a covariance needs residuals");
  return widened(statistics, sum, n, growth);
}

std::vector<int> area_vertices(const Eigen::VectorXd& share) {
  std::vector<int> order(static_cast<std::size_t>(share.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return share[a] > share[b]; });
  order.resize(static_cast<std::size_t>(std::lround(share.sum())));
  std::sort(order.begin(), order.end());
  return order;
}

Eigen::Matrix3d local_map(const Points& from, const Points& onto, const Eigen::Vector3d& at, double reach,
                          const Eigen::Matrix3d& otherwise) {
  const Eigen::VectorXd weight =
      (-(from.rowwise() - at.transpose()).rowwise().squaredNorm() / (2.0 * reach * reach)).array().exp();
  const double total = weight.sum();
  if (!(total > 0.0)) return otherwise;
  const Eigen::RowVector3d here = weight.transpose() * from / total,
                           there = weight.transpose() * onto / total;
  const Points x = from.rowwise() - here, y = onto.rowwise() - there;
  const Eigen::Matrix3d spread = x.transpose() * weight.asDiagonal() * x;
  const Eigen::Matrix3d cross = y.transpose() * weight.asDiagonal() * x;
  // A patch is flat: across it, and where there is little, the overall map holds.
  const double hold = 0.1 * spread.trace();
  return (cross + hold * otherwise) * (spread + hold * Eigen::Matrix3d::Identity()).inverse();
}

const StructureStatistics* Atlas::find(Structure structure) const {
  for (const StructureStatistics& one : structures)
    if (one.structure == structure) return &one;
  return nullptr;
}

double unusual(const ShapeModel& model, const Points& shape) {
  const Eigen::VectorXd b = model.coefficients(shape);
  double sum = 0.0;
  for (Eigen::Index k = 0; k < b.size(); ++k) sum += b[k] * b[k] / model.variances[k];
  const double rest = (shape - model.instance(b)).squaredNorm();
  const double expected = std::max(1e-12, model.total_variance - model.variances.sum());
  return std::sqrt((sum + rest / expected) / static_cast<double>(b.size() + 1));
}

}  // namespace glisson::atlas
