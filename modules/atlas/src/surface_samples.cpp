// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace glisson::atlas {
namespace {

constexpr int kMostCuts = 40;  // of an edge

/// What gathers in a cell.
struct Cell {
  Eigen::RowVector3d points = Eigen::RowVector3d::Zero(), normals = Eigen::RowVector3d::Zero();
  double weight = 0.0;
  Eigen::RowVectorXd values;
};

class Gathered {
 public:
  void add(const Eigen::RowVector3d& point, const Eigen::RowVector3d& normal, double weight) {
    all_.push_back({weight * point, weight * normal, weight, {}});
  }
  void add(const Cell& cell) { all_.push_back(cell); }
  SurfaceSamples samples() const {
    const auto count = static_cast<Eigen::Index>(all_.size());
    SurfaceSamples samples{Points(count, 3), Points(count, 3), Eigen::VectorXd(count),
                           Eigen::MatrixXd(count, count > 0 ? all_.front().values.size() : 0)};
    for (Eigen::Index i = 0; i < count; ++i) {
      const Cell& one = all_[static_cast<std::size_t>(i)];
      samples.points.row(i) = one.points / one.weight;
      samples.normals.row(i) = one.normals.normalized();
      samples.weights[i] = one.weight;
      if (samples.values.cols() > 0) samples.values.row(i) = one.values / one.weight;
    }
    samples.weights /= samples.weights.sum();
    return samples;
  }

 private:
  std::vector<Cell> all_;
};

/// Cell and direction: the axis that the normal follows most, and its sign.
std::array<int, 4> cell_of(const Eigen::RowVector3d& point, const Eigen::RowVector3d& normal, double cell) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  std::array<int, 4> key{};
  for (int k = 0; k < 3; ++k) key[k] = static_cast<int>(std::floor(point[k] / cell));
  key[3] = 2 * static_cast<int>(axis) + (normal[axis] < 0.0 ? 1 : 0);
  return key;
}

}  // namespace

double SurfaceSamples::size() const {
  return std::sqrt(weights.dot((points.rowwise() - centre()).rowwise().squaredNorm()));
}

SurfaceSamples dense_samples(const TriangleMesh& surface, double grain) {
  Gathered gathered;
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const auto corners = surface.triangles.row(t);
    const Eigen::RowVector3d a = surface.vertices.row(corners[0]), ab = surface.vertices.row(corners[1]) - a,
                             ac = surface.vertices.row(corners[2]) - a;
    const Eigen::RowVector3d across = ab.cross(ac);
    const double twice = across.norm();
    if (!(twice > 0.0)) continue;
    const double longest = std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()}));
    const int cuts = std::clamp(static_cast<int>(std::ceil(longest / grain)), 1, kMostCuts);
    const auto add = [&](double u, double v) {
      gathered.add(a + u * ab + v * ac, across / twice, twice / (cuts * cuts));
    };
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; i + j < cuts; ++j) {
        add((i + 1.0 / 3.0) / cuts, (j + 1.0 / 3.0) / cuts);
        if (i + j + 1 < cuts) add((i + 2.0 / 3.0) / cuts, (j + 2.0 / 3.0) / cuts);
      }
  }
  return gathered.samples();
}

SurfaceSamples cell_samples(const SurfaceSamples& dense, double cell) {
  const Eigen::RowVector3d centre = dense.centre();
  std::map<std::array<int, 4>, Cell> cells;
  for (Eigen::Index i = 0; i < dense.points.rows(); ++i) {
    Cell& into = cells[cell_of(dense.points.row(i) - centre, dense.normals.row(i), cell)];
    into.points += dense.weights[i] * dense.points.row(i);
    into.normals += dense.weights[i] * dense.normals.row(i);
    into.weight += dense.weights[i];
    if (dense.values.cols() == 0) continue;
    if (into.values.size() == 0) into.values.setZero(dense.values.cols());
    into.values += dense.weights[i] * dense.values.row(i);
  }
  Gathered gathered;
  for (const auto& [key, one] : cells) gathered.add(one);
  return gathered.samples();
}

}  // namespace glisson::atlas
