// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesion_errors.h"

#include <algorithm>

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

void sized_as(const Eigen::VectorXd& rms, SymmetricRows& covariances) {
  for (Eigen::Index i = 0; i < covariances.rows(); ++i)
    if (const double trace = covariances.row(i).head<3>().sum(); trace > 0.0)
      covariances.row(i) *= rms[i] * rms[i] / trace;
}

void size_lesions(const TetMesh& mesh, const BoundLesions& bound, const Eigen::VectorXd& rms,
                  std::vector<LesionError>& lesions) {
  const Points sizes = bound.middles.apply(mesh, rms.replicate<1, 3>());
  for (std::size_t i = 0; i < lesions.size(); ++i) {
    LesionError& lesion = lesions[i];
    const double size = sizes(static_cast<Eigen::Index>(i), 0), trace = lesion.covariance.trace();
    if (trace > 0.0) lesion.covariance *= size * size / trace;
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
