// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesion_errors.h"

#include <algorithm>
#include <cmath>

namespace glisson::registration {

BoundLesions bound_lesions(const PatientModel& model) {
  const auto centres = lesion_centres(model);
  BoundLesions bound;
  Points points(static_cast<Eigen::Index>(centres.size()), 3);
  for (std::size_t i = 0; i < centres.size(); ++i) {
    bound.labels.push_back(centres[i].first);
    points.row(static_cast<Eigen::Index>(i)) = centres[i].second.transpose();
  }
  bound.middles = bind_points(model.mesh, points);
  return bound;
}

std::vector<LesionError> lesions_of(const TetMesh& mesh, const BoundLesions& bound, const ErrorModel& error,
                                    const Registration& registration) {
  const Points found = bound.middles.apply(mesh, registration.nodes_in_camera);
  const std::vector<Eigen::Matrix3d> covariances = error.covariances(mesh, bound.middles);
  std::vector<LesionError> lesions;
  for (std::size_t i = 0; i < bound.labels.size(); ++i)
    lesions.push_back({bound.labels[i], found.row(static_cast<Eigen::Index>(i)).transpose(), covariances[i],
                       mean_error(covariances[i])});
  return lesions;
}

namespace {

/// By how much a covariance grows so that its mean error is this one.
double growth(double expected, const Eigen::Matrix3d& covariance) {
  const double now = mean_error(covariance);
  return now > 0.0 ? std::pow(expected / now, 2) : 1.0;
}

}  // namespace

void sized_as(const Eigen::VectorXd& expected, SymmetricRows& covariances) {
  for (Eigen::Index i = 0; i < covariances.rows(); ++i)
    covariances.row(i) *= growth(expected[i], symmetric_matrix(covariances.row(i)));
}

void size_lesions(const TetMesh& mesh, const BoundLesions& bound, const Eigen::VectorXd& expected,
                  std::vector<LesionError>& lesions) {
  const Points sizes = bound.middles.apply(mesh, expected.replicate<1, 3>());
  for (std::size_t i = 0; i < lesions.size(); ++i) {
    LesionError& lesion = lesions[i];
    lesion.covariance *= growth(sizes(static_cast<Eigen::Index>(i), 0), lesion.covariance);
    lesion.expected = mean_error(lesion.covariance);
  }
}

void size_looks(const std::vector<LesionError>& lesions, std::vector<LesionLooks>& looks) {
  const auto error_of = [&](Label label) { return std::ranges::find(lesions, label, &LesionError::lesion); };
  std::erase_if(looks, [&](const LesionLooks& look) {
    return error_of(look.lesion) == lesions.end() || !(look.now > 0.0);
  });
  for (LesionLooks& look : looks) {
    const double factor = error_of(look.lesion)->expected / look.now;
    look.now *= factor, look.margin *= factor, look.notch *= factor;
    look.seen *= factor;
  }
}

}  // namespace glisson::registration
