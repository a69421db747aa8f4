// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarse_space.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "glisson/core/error.h"
#include "ordering.h"

namespace glisson::fem {
namespace {

/// Smaller weights are left out: a lattice node with so little of the organ makes P^T A P nearly singular.
constexpr double kLeastWeight = 0.02;
/// Added to the diagonal, as a share of it, for lattice nodes that are hardly coupled all the same.
constexpr double kShift = 1e-9;

}  // namespace

CoarseSpace::CoarseSpace(const BlockPattern& fine, const Points& rest, int wanted) : fine_(fine) {
  const Eigen::RowVector3d size = rest.colwise().maxCoeff() - rest.colwise().minCoeff();
  double cell = std::max(1e-9, std::cbrt((size.array() + 1e-3 * size.maxCoeff()).prod() / wanted));
  int count = 0;
  for (int tries = 0; tries < 8; ++tries) {
    place(fine, rest, cell, supports_, &count);
    if (std::abs(count - wanted) <= wanted / 20) break;
    cell *= std::cbrt(static_cast<double>(count) / wanted);
  }
  build_pattern(fine, count);
  build_targets(fine);
  factorization_ = std::make_unique<MultifrontalFactorization>(pattern_);
}

void CoarseSpace::place(const BlockPattern& fine, const Points& rest, double cell,
                        std::vector<Support>& supports, int* count) const {
  const Eigen::RowVector3d low = rest.colwise().minCoeff(), high = rest.colwise().maxCoeff();
  const Eigen::RowVector3d cells = ((high - low) / cell).array().ceil().max(1.0);
  // The lattice's middle is the organ's.
  const Eigen::RowVector3d origin = 0.5 * (low + high - cell * cells);
  std::map<std::array<int, 3>, int> numbers;
  supports.assign(static_cast<std::size_t>(fine.unknowns), {});
  for (int u = 0; u < fine.unknowns; ++u) {
    Support& support = supports[static_cast<std::size_t>(u)];
    const Eigen::RowVector3d q =
        (rest.row(fine.node_of_unknown[static_cast<std::size_t>(u)]) - origin) / cell;
    std::array<int, 3> corner{}, axes{0, 1, 2};
    std::array<double, 3> inside{};
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = static_cast<int>(std::floor(q[static_cast<Eigen::Index>(k)]));
      inside[k] = q[static_cast<Eigen::Index>(k)] - corner[k];
    }
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
      return inside[static_cast<std::size_t>(a)] > inside[static_cast<std::size_t>(b)];
    });
    double before = 1.0, total = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double next = k < 3 ? inside[static_cast<std::size_t>(axes[k])] : 0.0;
      if (const double weight = before - next; weight >= kLeastWeight) {
        support.nodes[k] = numbers.try_emplace(corner, static_cast<int>(numbers.size())).first->second;
        support.weights[k] = weight;
        total += weight;
      }
      before = next;
      if (k < 3) ++corner[static_cast<std::size_t>(axes[k])];
    }
    for (double& weight : support.weights) weight /= total;
  }
  *count = static_cast<int>(numbers.size());
}

void CoarseSpace::build_pattern(const BlockPattern& fine, int count) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(count));
  for (int c = 0; c < fine.unknowns; ++c)
    for (int b = fine.column_start[static_cast<std::size_t>(c)];
         b < fine.column_start[static_cast<std::size_t>(c) + 1]; ++b)
      for (const int i : supports_[static_cast<std::size_t>(fine.rows[static_cast<std::size_t>(b)])].nodes)
        for (const int j : supports_[static_cast<std::size_t>(c)].nodes)
          if (i >= 0 && j >= 0 && i != j) {
            neighbours[static_cast<std::size_t>(i)].push_back(j);
            neighbours[static_cast<std::size_t>(j)].push_back(i);
          }
  for (auto& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  const std::vector<int> order = fill_reducing_order(neighbours);
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    place[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  for (Support& support : supports_)
    for (int& node : support.nodes)
      if (node >= 0) node = place[static_cast<std::size_t>(node)];
  pattern_.unknowns = count;
  pattern_.column_start.push_back(0);
  for (int c = 0; c < count; ++c) {
    const auto first = static_cast<std::ptrdiff_t>(pattern_.rows.size());
    pattern_.rows.push_back(c);
    for (const int j : neighbours[static_cast<std::size_t>(order[static_cast<std::size_t>(c)])])
      if (const int row = place[static_cast<std::size_t>(j)]; row > c) pattern_.rows.push_back(row);
    std::sort(pattern_.rows.begin() + first, pattern_.rows.end());
    pattern_.column_start.push_back(static_cast<int>(pattern_.rows.size()));
  }
  values_.assign(static_cast<std::size_t>(pattern_.block_count() + 1) * 9, 0.0);
  right_.resize(3 * static_cast<Eigen::Index>(count));
}

void CoarseSpace::build_targets(const BlockPattern& fine) {
  places_.resize(fine.rows.size());
  std::size_t most = 0;
  std::vector<int> touched;
  for (int c = 0; c < fine.unknowns; ++c) {
    touched.clear();
    for (int b = fine.column_start[static_cast<std::size_t>(c)];
         b < fine.column_start[static_cast<std::size_t>(c) + 1]; ++b) {
      const Support& support = supports_[static_cast<std::size_t>(fine.rows[static_cast<std::size_t>(b)])];
      for (std::size_t k = 0; k < 4; ++k) {
        if (support.nodes[k] < 0) continue;
        const auto found = std::find(touched.begin(), touched.end(), support.nodes[k]);
        places_[static_cast<std::size_t>(b)][k] = static_cast<unsigned char>(found - touched.begin());
        if (found == touched.end()) touched.push_back(support.nodes[k]);
      }
    }
    if (touched.size() > 255) throw NumericalError("A node of the mesh has too many neighbours.");
    most = std::max(most, touched.size());
    columns_.push_back({static_cast<int>(touched.size()), targets_.size()});
    for (const int i : touched)
      for (const int j : supports_[static_cast<std::size_t>(c)].nodes) {
        if (j < 0) {
          targets_.push_back({pattern_.block_count(), Target::as_it_is});
          continue;
        }
        const Target::Kind kind = i == j ? Target::both : i > j ? Target::as_it_is : Target::transposed;
        targets_.push_back({pattern_.find(std::max(i, j), std::min(i, j)), kind});
      }
  }
  products_.assign(9 * most, 0.0);
}

bool CoarseSpace::factorise(const std::vector<double>& fine_values) {
  using Block = Eigen::Matrix<double, 9, 1>;
  std::fill(values_.begin(), values_.end(), 0.0);
  // P^T A P = G + G^T with G = P^T (L + D/2) P, a column of L + D/2 at a time.
  for (int c = 0; c < fine_.unknowns; ++c) {
    const Column& column = columns_[static_cast<std::size_t>(c)];
    std::fill_n(products_.begin(), 9 * column.touched, 0.0);
    const int first = fine_.column_start[static_cast<std::size_t>(c)];
    for (int b = first; b < fine_.column_start[static_cast<std::size_t>(c) + 1]; ++b) {
      const Eigen::Map<const Block> block(fine_values.data() + 9L * b);
      const Support& support = supports_[static_cast<std::size_t>(fine_.rows[static_cast<std::size_t>(b)])];
      const double share = b == first ? 0.5 : 1.0;
      for (std::size_t k = 0; k < 4; ++k)
        if (support.weights[k] != 0.0)
          Eigen::Map<Block>(products_.data() + 9L * places_[static_cast<std::size_t>(b)][k]) +=
              share * support.weights[k] * block;
    }
    const Target* target = targets_.data() + column.first_target;
    const std::array<double, 4>& weights = supports_[static_cast<std::size_t>(c)].weights;
    for (int i = 0; i < column.touched; ++i) {
      const double* p = products_.data() + 9L * i;
      for (std::size_t l = 0; l < 4; ++l, ++target) {
        const double w = weights[l];
        if (w == 0.0) continue;
        double* v = values_.data() + 9L * target->block;
        if (target->kind != Target::transposed)
          for (int k = 0; k < 9; ++k) v[k] += w * p[k];
        if (target->kind != Target::as_it_is)
          for (int k = 0; k < 9; ++k) v[k] += w * p[3 * (k % 3) + k / 3];
      }
    }
  }
  for (int c = 0; c < pattern_.unknowns; ++c)
    for (int k = 0; k < 3; ++k)
      values_[9 * static_cast<std::size_t>(pattern_.column_start[static_cast<std::size_t>(c)]) +
              4 * static_cast<std::size_t>(k)] *= 1.0 + kShift;
  return factorization_->factorise(values_);
}

void CoarseSpace::correct(const double* r, double* e) {
  right_.setZero();
  for (std::size_t u = 0; u < supports_.size(); ++u)
    for (std::size_t k = 0; k < 4; ++k)
      if (const int node = supports_[u].nodes[k]; node >= 0)
        right_.segment<3>(3 * node) += supports_[u].weights[k] * Eigen::Map<const Eigen::Vector3d>(r + 4 * u);
  factorization_->solve(right_);
  for (std::size_t u = 0; u < supports_.size(); ++u) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      if (const int node = supports_[u].nodes[k]; node >= 0)
        sum += supports_[u].weights[k] * right_.segment<3>(3 * node);
    Eigen::Map<Eigen::Vector3d>(e + 4 * u) = sum;
    e[4 * u + 3] = 0.0;
  }
}

}  // namespace glisson::fem
