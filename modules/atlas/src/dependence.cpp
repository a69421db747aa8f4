// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "statistics.h"

namespace glisson::atlas {
namespace {

constexpr std::size_t kLeastShown = 5;  // members that show both
constexpr double kTiny = 1e-12;         // m2: so that places that are all alike can be divided by

/// Residuals of the members that show both structures; the k-th columns belong to the k-th member.
struct Pairs {
  std::vector<const Points*> of;
  Eigen::Matrix3Xd on;  ///< 3 x members
};

Pairs pairs(const StructureStatistics& of, const StructureStatistics& on, int point,
            const std::string& without) {
  Pairs found;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < of.residuals.size(); ++i) {
    const auto at = std::ranges::find(on.members, of.members[i]);
    if (at == on.members.end() || of.members[i] == without) continue;
    found.of.push_back(&of.residuals[i]);
    places.emplace_back(on.residuals[static_cast<std::size_t>(at - on.members.begin())].row(point));
  }
  found.on.resize(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) found.on.col(static_cast<Eigen::Index>(i)) = places[i];
  return found;
}

/// The other one's covariance of these sums of squares, inverted, and the even part that goes with it.
struct Known {
  Known(const Eigen::Matrix3d& squares, double members)
      : even(kEvenMembers / (3.0 * members)),
        inverse((squares + (even * squares.trace() + kTiny) * Eigen::Matrix3d::Identity()).inverse()) {}
  Eigen::Matrix3d gain(const Eigen::Matrix3d& products) const {
    return (products + even * products.trace() * Eigen::Matrix3d::Identity()) * inverse;
  }
  double even;
  Eigen::Matrix3d inverse;
};

double total(const Dependence& one) {
  double sum = 0.0;
  for (const Eigen::Matrix3d& left : one.left) sum += left.trace();
  return sum;
}

std::optional<Dependence> most_telling(const StructureStatistics& of, const StructureStatistics& on) {
  std::optional<Dependence> best;
  double least = std::numeric_limits<double>::infinity();
  for (int point = 0; point < static_cast<int>(on.mean.rows()); ++point) {
    auto one = dependence(of, on, point);
    if (!one || total(*one) >= least) continue;
    least = total(*one);
    best = std::move(one);
  }
  return best;
}

}  // namespace

std::optional<Dependence> dependence(const StructureStatistics& of, const StructureStatistics& on, int point,
                                     const std::string& without) {
  const Pairs shown = pairs(of, on, point, without);
  const std::size_t n = shown.of.size();
  if (n < kLeastShown) return {};
  const Eigen::Matrix3d squares = shown.on * shown.on.transpose();
  const Known all(squares, static_cast<double>(n));
  std::vector<Known> others;
  for (const auto& place : shown.on.colwise())
    others.emplace_back(squares - place * place.transpose(), static_cast<double>(n - 1));
  Dependence found{on.structure, point, static_cast<int>(n), {}, {}};
  bool tells = false;
  for (Eigen::Index k = 0; k < of.mean.rows(); ++k) {
    Eigen::Matrix3Xd own(3, static_cast<Eigen::Index>(n)), foretold = own;
    for (std::size_t i = 0; i < n; ++i) own.col(static_cast<Eigen::Index>(i)) = shown.of[i]->row(k);
    const Eigen::Matrix3d products = own * shown.on.transpose();
    for (Eigen::Index i = 0; i < own.cols(); ++i)
      foretold.col(i) =
          others[static_cast<std::size_t>(i)].gain(products - own.col(i) * shown.on.col(i).transpose()) *
          shown.on.col(i);
    const double size = foretold.squaredNorm();
    const double share = size > 0.0 ? std::clamp(own.cwiseProduct(foretold).sum() / size, 0.0, 1.0) : 0.0;
    tells = tells || share > 0.0;
    own -= share * foretold;
    found.gains.emplace_back(share * all.gain(products));
    found.left.emplace_back(own * own.transpose() / static_cast<double>(n));
  }
  if (!tells) return {};
  return found;
}

void learn_dependences(const std::vector<StructureStatistics*>& structures) {
  for (StructureStatistics* of : structures) {
    of->depends.clear();
    if (of->added_deviation > 0.0) continue;
    for (const StructureStatistics* on : structures)
      if (on != of && on->added_deviation == 0.0)
        if (auto told = most_telling(*of, *on)) of->depends.push_back(std::move(*told));
  }
}

}  // namespace glisson::atlas
