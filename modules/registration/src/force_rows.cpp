// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_rows.h"

#include <algorithm>
#include <cmath>

namespace glisson::registration {
namespace {

constexpr double kLeastWeight = 1e-3;  ///< of a point between its neighbours, for its division

/// A landmark that the model lacks is a part of the surface like any other.
bool on_surface(const MovingSurface& surface, Feature feature) {
  return feature == Feature::surface || !surface.has(feature);
}

void resize(ForceRows& rows, Eigen::Index count) {
  rows.points.conservativeResize(count, 3);
  rows.directions.conservativeResize(count, 3);
  rows.gap.conservativeResize(count);
  rows.sigma.conservativeResize(count);
}

void add_labelled(ForceRows& rows, const PreparedCloud& cloud, const MovingSurface& surface, double sigma) {
  for (const Pair& pair : find_pairs(cloud, surface, {})) {
    if (!pair.kept || on_surface(surface, pair.feature)) continue;

    const bool notch = pair.feature == Feature::umbilical_notch;
    const double own = notch ? 0.0 : cloud.deviation(pair.point);  // the notch's points make one
    const auto look = static_cast<std::size_t>(cloud.cloud.look(pair.point));
    const double information = notch
                                   ? 1.0 / cloud.notch_points[look]
                                   : kMarginInformation * cloud.weight[static_cast<std::size_t>(pair.point)];
    const Eigen::Index first = rows.size();
    resize(rows, first + 3);
    for (int c = 0; c < 3; ++c) {
      rows.carriers.push_back(surface.carrier(pair.on_model));
      rows.seen_in.push_back(cloud.cloud.look(pair.point));
      rows.points.row(first + c) = pair.on_model.point.transpose();
      rows.directions.row(first + c) = Eigen::RowVector3d::Unit(c);
      rows.gap[first + c] = pair.gap[c];
      rows.sigma[first + c] = std::hypot(
          std::max({sigma, notch ? kNotchSigma : kMarginSigma, pair.deviation}) / std::sqrt(information),
          own);
    }
  }
}

}  // namespace

void add_along(const Carrier& carrier, const Eigen::Vector3d& direction, const fem::NodalColumns& columns,
               Eigen::Ref<Eigen::RowVectorXd> row) {
  for (std::size_t k = 0; k < 4; ++k)
    if (carrier.nodes[k] >= 0)
      for (int c = 0; c < 3; ++c)
        row += (carrier.weights[k] * direction[c]) * columns.row(3L * carrier.nodes[k] + c);
}

Eigen::MatrixXd ForceRows::along(const fem::NodalColumns& columns) const {
  Eigen::MatrixXd a(size(), columns.cols());
  Eigen::RowVectorXd row(columns.cols());
  for (Eigen::Index i = 0; i < size(); ++i) {
    row.setZero();
    add_along(carriers[static_cast<std::size_t>(i)], directions.row(i).transpose(), columns, row);
    a.row(i) = row;
  }
  return a;
}

ForceRows find_rows(const PreparedCloud& cloud, const MovingSurface& surface, const RowNoise& noise) {
  ForceRows rows;
  resize(rows, cloud.cloud.size());
  bool labelled = false;
  int outliers = 0;
  rows.carriers.resize(static_cast<std::size_t>(cloud.cloud.size()));
  rows.seen_in.resize(rows.carriers.size());
  NormalMemo normals;
  for (const int i : cloud.turn) {
    labelled = labelled || !on_surface(surface, cloud.cloud.feature(i));
    const Eigen::Vector3d p = cloud.cloud.points.row(i).transpose();
    const ClosestPoint at = surface.closest(Feature::surface, p);
    const Eigen::Vector3d n = surface.normal(at, normals);
    rows.carriers[static_cast<std::size_t>(i)] = surface.carrier(at);
    rows.seen_in[static_cast<std::size_t>(i)] = cloud.cloud.look(i);
    rows.points.row(i) = at.point.transpose();
    rows.directions.row(i) = n.transpose();
    rows.gap[i] = n.dot(p - at.point);
    const double own = cloud.deviation(i);
    const double apart = at.distance / std::max(noise.half, 2.0 * own);
    outliers += apart > 1.0;
    const double deviation =
        noise.information
            ? std::hypot(noise.sigma / std::sqrt(*noise.information *
                                                 std::max(kLeastWeight,
                                                          cloud.surface_weight[static_cast<std::size_t>(i)])),
                         own)
            : std::max(noise.sigma, own);
    rows.sigma[i] = deviation * std::sqrt(1.0 + apart * apart);
  }
  rows.surface_count = rows.size();
  if (rows.surface_count > 0) rows.outlier_share = outliers / static_cast<double>(rows.surface_count);
  if (labelled) add_labelled(rows, cloud, surface, noise.sigma);
  return rows;
}

}  // namespace glisson::registration
