// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numeric>

namespace glisson::stereo {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double tukey(double x) {
  const double t = 1.0 - x * x;
  return std::abs(x) < 1.0 ? t * t : 0.0;
}

/// Robust plane through (x, y, value); @return its value at the origin and the residuals' deviation.
std::pair<double, double> plane_at_origin(const std::vector<Eigen::Vector3d>& samples) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(samples.size()));
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  double deviation = 0.0;
  for (int pass = 0; pass < 5; ++pass) {
    Eigen::Matrix3d normal = Eigen::Vector3d(1e-6, 1e-3, 1e-3).asDiagonal();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const Eigen::Vector3d row(1.0, samples[k].x(), samples[k].y());
      normal += weights[static_cast<Eigen::Index>(k)] * row * row.transpose();
      right += weights[static_cast<Eigen::Index>(k)] * samples[k].z() * row;
    }
    if (pass == 0) {  // the median first: least squares would follow a gross outlier
      std::vector<double> values;
      values.reserve(samples.size());
      for (const auto& s : samples) values.push_back(s.z());
      plane = Eigen::Vector3d(median(values), 0.0, 0.0);
    } else {
      plane = normal.ldlt().solve(right);
    }
    std::vector<double> residuals;
    residuals.reserve(samples.size());
    for (const auto& s : samples)
      residuals.push_back(std::abs(s.z() - plane.dot(Eigen::Vector3d(1.0, s.x(), s.y()))));
    deviation = 1.4826 * median(residuals);
    for (std::size_t k = 0; k < samples.size(); ++k)
      weights[static_cast<Eigen::Index>(k)] = tukey(residuals[k] / (4.7 * std::max(deviation, 0.1)));
  }
  return {plane[0], deviation};
}

/// The local surface of one point: w(u, v) over the plane through `origin` with axes e1, e2, normal.
struct LocalSurface {
  Eigen::Vector3d origin, e1, e2, normal;
  Eigen::Matrix<double, 6, 1> c = Eigen::Matrix<double, 6, 1>::Zero();  ///< 1 u v uu uv vv
  double sigma = 0.0;                                                   ///< of the value at the centre

  double height(double u, double v) const {
    return c[0] + c[1] * u + c[2] * v + c[3] * u * u + c[4] * u * v + c[5] * v * v;
  }
  Eigen::Vector3d normal_at(double u, double v) const {
    const double du = c[1] + 2.0 * c[3] * u + c[4] * v, dv = c[2] + c[4] * u + 2.0 * c[5] * v;
    return (normal - du * e1 - dv * e2).normalized();
  }
};

struct Samples {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> sigma, weights;  ///< weights: distance only
};

LocalSurface plane_of(const Samples& s, const std::vector<double>& weights) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double total = 0.0;
  for (std::size_t k = 0; k < s.points.size(); ++k) mean += weights[k] * s.points[k], total += weights[k];
  mean /= total;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < s.points.size(); ++k)
    covariance += weights[k] * (s.points[k] - mean) * (s.points[k] - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  LocalSurface surface;
  surface.origin = mean;
  surface.normal = axes.eigenvectors().col(0);
  // Where noise along the ray outweighs the patch's extent, principal axes mean nothing: face the camera.
  if (std::abs(surface.normal.dot(mean.normalized())) < 0.17) surface.normal = mean.normalized();
  if (surface.normal.dot(mean) > 0.0) surface.normal = -surface.normal;
  surface.e1 = surface.normal.unitOrthogonal();
  surface.e2 = surface.normal.cross(surface.e1);
  return surface;
}

void fit_quadratic(LocalSurface& surface, const Samples& s, const std::vector<double>& weights, double radius,
                   const Eigen::Vector3d& centre) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double total = 0.0, noise = 0.0;
  std::vector<Vector6> rows;
  for (std::size_t k = 0; k < s.points.size(); ++k) {
    const Eigen::Vector3d d = s.points[k] - surface.origin;
    const double u = d.dot(surface.e1) / radius, v = d.dot(surface.e2) / radius;
    rows.push_back((Vector6() << 1.0, u, v, u * u, u * v, v * v).finished());
    normal.noalias() += weights[k] * rows.back() * rows.back().transpose();
    right += weights[k] * d.dot(surface.normal) * rows.back();
    total += weights[k];
    noise += weights[k] * s.sigma[k] * s.sigma[k];
  }
  noise /= total;
  // Curvature is held near zero by what organs have (radius of 30 mm): with few neighbours a plane remains.
  const double bend = radius * radius / 0.06;
  for (int k = 3; k < 6; ++k) normal(k, k) += noise / (bend * bend);
  normal.diagonal().array() += 1e-9 * total;
  const Eigen::LDLT<Matrix6> factor(normal);
  surface.c = factor.solve(right);
  const Eigen::Vector3d d = centre - surface.origin;
  const double u = d.dot(surface.e1) / radius, v = d.dot(surface.e2) / radius;
  const Vector6 at = factor.solve((Vector6() << 1.0, u, v, u * u, u * v, v * v).finished());
  double variance = 0.0;
  for (std::size_t k = 0; k < s.points.size(); ++k) {
    const double influence = weights[k] * at.dot(rows[k]) * s.sigma[k];
    variance += influence * influence;
  }
  surface.sigma = std::sqrt(variance);
  const double r = radius;
  surface.c[1] /= r, surface.c[2] /= r;
  surface.c.tail<3>() /= r * r;
}

/// Plane, quadratic, and weights again without what lies off it.
LocalSurface fit(const Samples& s, double radius, const Eigen::Vector3d& centre) {
  std::vector<double> weights = s.weights;
  LocalSurface surface;
  for (int pass = 0; pass < 3; ++pass) {
    surface = plane_of(s, weights);
    fit_quadratic(surface, s, weights, radius, centre);
    std::vector<double> residuals;
    for (const Eigen::Vector3d& p : s.points) {
      const Eigen::Vector3d d = p - surface.origin;
      residuals.push_back(
          std::abs(d.dot(surface.normal) - surface.height(d.dot(surface.e1), d.dot(surface.e2))));
    }
    for (std::size_t k = 0; k < weights.size(); ++k)
      weights[k] = s.weights[k] * std::max(1e-6, tukey(residuals[k] / (4.7 * s.sigma[k] + 1e-4)));
  }
  return surface;
}

SurfacePoint onto(const LocalSurface& surface, const Eigen::Vector3d& point, double sigma, bool move) {
  const Eigen::Vector3d ray = point.normalized();
  double t = point.norm();
  const double start = t;
  Eigen::Vector3d normal = surface.normal;
  for (int pass = 0; pass < 4; ++pass) {
    const Eigen::Vector3d d = t * ray - surface.origin;
    const double u = d.dot(surface.e1), v = d.dot(surface.e2);
    normal = surface.normal_at(u, v);
    const double slope = ray.dot(normal);
    if (std::abs(slope) < 0.1) break;
    // Height above the surface along its axis, turned into the distance along the ray.
    t -= (d.dot(surface.normal) - surface.height(u, v)) * surface.normal.dot(normal) / slope;
  }
  SurfacePoint result;
  const bool trusted = std::abs(t - start) < 6.0 * sigma + 1e-3;
  result.point = move && trusted ? Eigen::Vector3d(t * ray) : point;
  result.normal = normal.dot(ray) > 0.0 ? Eigen::Vector3d(-normal) : normal;
  result.sigma =
      move && trusted ? std::min(sigma, surface.sigma / std::max(0.2, std::abs(normal.dot(ray)))) : sigma;
  return result;
}

}  // namespace

std::vector<std::vector<int>> nearest_in_picture(const std::vector<Eigen::Vector2d>& points, int k) {
  std::vector<std::vector<int>> result(points.size());
  if (points.size() < 2) return result;
  Eigen::Vector2d low = points[0], high = points[0];
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const Eigen::Vector2d extent = (high - low).cwiseMax(1.0);
  // Buckets of about two points, searched in growing rings until no farther ring can hold a nearer point.
  const double side = std::max(1.0, std::sqrt(2.0 * extent.prod() / static_cast<double>(points.size())));
  const int columns = static_cast<int>(extent.x() / side) + 1, rows = static_cast<int>(extent.y() / side) + 1;
  const auto cell = [&](const Eigen::Vector2d& p) {
    return std::pair(static_cast<int>((p.x() - low.x()) / side), static_cast<int>((p.y() - low.y()) / side));
  };
  const auto bucket = [columns](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
  };
  std::vector<std::vector<int>> buckets(bucket(0, rows));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [x, y] = cell(points[i]);
    buckets[bucket(x, y)].push_back(static_cast<int>(i));
  }
  const auto wanted = std::min(static_cast<std::size_t>(k), points.size() - 1);
  std::vector<std::pair<double, int>> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    found.clear();
    const auto [cx, cy] = cell(points[i]);
    for (int ring = 0; ring <= std::max(columns, rows); ++ring) {
      for (int y = std::max(0, cy - ring); y <= std::min(rows - 1, cy + ring); ++y)
        for (int x = std::max(0, cx - ring); x <= std::min(columns - 1, cx + ring); ++x) {
          if (std::max(std::abs(x - cx), std::abs(y - cy)) != ring) continue;
          for (const int j : buckets[bucket(x, y)])
            if (j != static_cast<int>(i))
              found.emplace_back((points[static_cast<std::size_t>(j)] - points[i]).squaredNorm(), j);
        }
      if (found.size() < wanted) continue;
      std::sort(found.begin(), found.end());
      if (found[wanted - 1].first <= side * side * ring * ring) break;
    }
    for (std::size_t m = 0; m < wanted; ++m) result[i].push_back(found[m].second);
  }
  return result;
}

std::vector<bool> agreeing(const Rectification& rectification, const std::vector<Match>& matches) {
  constexpr int kNeighbours = 12;
  std::vector<Eigen::Vector2d> places;
  places.reserve(matches.size());
  for (const Match& m : matches) places.push_back(m.left);
  const auto neighbours = nearest_in_picture(places, kNeighbours);
  const double lonely = 0.12 * rectification.width();
  std::vector<bool> kept(matches.size(), false);
  for (std::size_t i = 0; i < matches.size(); ++i) {
    std::vector<Eigen::Vector3d> samples;
    for (const int j : neighbours[i]) {
      const Match& other = matches[static_cast<std::size_t>(j)];
      const Eigen::Vector2d offset = other.left - matches[i].left;
      if (offset.norm() > lonely) continue;
      samples.emplace_back(offset.x(), offset.y(), rectification.disparity(other.left, other.right));
    }
    if (samples.size() < 4) continue;
    const auto [expected, deviation] = plane_at_origin(samples);
    const double miss = std::abs(rectification.disparity(matches[i].left, matches[i].right) - expected);
    kept[i] = miss <= std::max({0.5, 3.0 * deviation, 3.0 * matches[i].sigma});
  }
  return kept;
}

std::vector<SurfacePoint> fit_surface(const std::vector<Eigen::Vector3d>& points,
                                      const std::vector<double>& sigma,
                                      const std::vector<std::vector<int>>& neighbours, bool move) {
  std::vector<SurfacePoint> result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Samples samples;
    samples.points.push_back(points[i]);
    samples.sigma.push_back(sigma[i]);
    std::vector<double> distances;
    // Across the view only: depth is where the noise is.
    const Eigen::Vector3d ray = points[i].normalized();
    for (const int j : neighbours[i]) {
      const Eigen::Vector3d& p = points[static_cast<std::size_t>(j)];
      samples.points.push_back(p);
      samples.sigma.push_back(sigma[static_cast<std::size_t>(j)]);
      distances.push_back((p * (points[i].dot(ray) / p.dot(ray)) - points[i]).norm());
    }
    if (distances.size() < 5) {
      result[i] = {points[i], -ray, sigma[i]};
      continue;
    }
    const double radius = std::max(1e-4, 0.7 * *std::max_element(distances.begin(), distances.end()));
    const auto weigh = [&](double distance, double deviation) {
      const double mean = 0.5 * (deviation + sigma[i]);
      return std::exp(-distance * distance / (radius * radius)) * std::pow(sigma[i] / mean, 2.0);
    };
    samples.weights.push_back(1.0);
    for (std::size_t k = 0; k < distances.size(); ++k)
      samples.weights.push_back(weigh(distances[k], samples.sigma[k + 1]));
    result[i] = onto(fit(samples, radius, points[i]), points[i], sigma[i], move);
  }
  return result;
}

}  // namespace glisson::stereo
