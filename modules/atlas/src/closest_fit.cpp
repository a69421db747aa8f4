// SPDX-License-Identifier: GPL-3.0-or-later
#include "closest_fit.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>

#include "glisson/core/statistics.h"
#include "glisson/geometry/topology.h"

namespace glisson::atlas {
namespace {

/// Stiffness of the neighbourhoods against a vertex's pull of 1, from stiff to soft.
constexpr std::array kStiffness = {10.0, 4.0, 1.5, 0.6, 0.25};
constexpr int kPasses = 5;            // at each stiffness
constexpr double kAgreeing = 0.3;     // least cosine between the normals of a pair
constexpr double kFarDeviations = 4;  // pairs farther apart than the median by this are left out
constexpr double kBackward = 1.0;     // all samples together over all vertices together

using Triplet = Eigen::Triplet<double>;

/// The rows of one linear system: what pulls, and how hard.
class System {
 public:
  explicit System(Eigen::Index count) : right_(Points::Zero(count, 3)) {}
  void add(const std::array<int, 3>& at, const Eigen::Vector3d& share, const Eigen::RowVector3d& target,
           double weight) {
    for (int i = 0; i < 3; ++i) {
      right_.row(at[i]) += weight * share[i] * target;
      for (int j = 0; j < 3; ++j) entries_.emplace_back(at[i], at[j], weight * share[i] * share[j]);
    }
  }
  void add(int at, const Eigen::RowVector3d& target, double weight) {
    right_.row(at) += weight * target;
    entries_.emplace_back(at, at, weight);
  }
  void spring(int a, int b, const Eigen::RowVector3d& difference, double weight) {
    entries_.emplace_back(a, a, weight);
    entries_.emplace_back(b, b, weight);
    entries_.emplace_back(a, b, -weight);
    entries_.emplace_back(b, a, -weight);
    right_.row(a) += weight * difference;
    right_.row(b) -= weight * difference;
  }
  Points solve() const {
    Eigen::SparseMatrix<double> matrix(right_.rows(), right_.rows());
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    return solver.solve(Eigen::MatrixXd(right_));
  }

 private:
  std::vector<Triplet> entries_;
  Points right_;
};

/// The rotation of every neighbourhood from its rest shape.
std::vector<Eigen::Matrix3d> rotations(const Points& rest, const Points& now,
                                       const std::vector<std::vector<int>>& neighbours) {
  std::vector<Eigen::Matrix3d> turned(neighbours.size());
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
    for (const int j : neighbours[i])
      moment += (rest.row(j) - rest.row(i)).transpose() * (now.row(j) - now.row(i));
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    turned[i] = svd.matrixV() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixU().transpose();
  }
  return turned;
}

/// Farther than this a pair is none.
double far_away(const std::vector<double>& distances) {
  if (distances.empty()) return 0.0;
  const auto [middle, deviation] = robust_spread(distances);
  return middle + kFarDeviations * deviation + 1e-12;
}

class Fitter {
 public:
  Fitter(const TriangleMesh& mesh, const TriangleMesh& surface, const ClosestPointTree& tree,
         const SurfaceSamples& samples)
      : now_(mesh),
        neighbours_(vertex_neighbours(mesh)),
        own_(mesh),
        tree_(tree),
        samples_(samples),
        surface_normals_(triangle_normals(surface)) {}

  void level() { rest_ = now_.vertices; }
  void pass(double stiffness) {
    System system(now_.vertices.rows());
    forward(system);
    backward(system);
    const auto turned = rotations(rest_, now_.vertices, neighbours_);
    for (std::size_t i = 0; i < neighbours_.size(); ++i)
      for (const int j : neighbours_[i])
        if (static_cast<int>(i) < j)
          system.spring(static_cast<int>(i), j,
                        0.5 * (rest_.row(static_cast<Eigen::Index>(i)) - rest_.row(j)) *
                            (turned[i] + turned[j]).transpose(),
                        stiffness);
    now_.vertices = system.solve();
    own_.refit(now_.vertices);
  }
  const Points& vertices() const { return now_.vertices; }

 private:
  void forward(System& system) const {
    const Points normals = vertex_normals(now_);
    std::vector<ClosestPoint> found(static_cast<std::size_t>(now_.vertex_count()));
    std::vector<double> distances;
    for (int v = 0; v < now_.vertex_count(); ++v) {
      found[v] = tree_.closest(now_.vertex(v));
      if (surface_normals_.row(found[v].triangle).dot(normals.row(v)) < kAgreeing)
        found[v].triangle = -1;
      else
        distances.push_back(found[v].distance);
    }
    const double far = far_away(distances);
    for (int v = 0; v < now_.vertex_count(); ++v)
      if (found[v].triangle >= 0 && found[v].distance <= far) system.add(v, found[v].point.transpose(), 1.0);
  }
  void backward(System& system) const {
    const Points normals = triangle_normals(now_);
    std::vector<ClosestPoint> found(static_cast<std::size_t>(samples_.points.rows()));
    std::vector<double> distances;
    for (Eigen::Index s = 0; s < samples_.points.rows(); ++s) {
      found[s] = own_.closest(samples_.points.row(s).transpose());
      if (normals.row(found[s].triangle).dot(samples_.normals.row(s)) < kAgreeing)
        found[s].triangle = -1;
      else
        distances.push_back(found[s].distance);
    }
    const double far = far_away(distances);
    const double weight = kBackward * static_cast<double>(now_.vertex_count());
    for (Eigen::Index s = 0; s < samples_.points.rows(); ++s) {
      const ClosestPoint& at = found[s];
      if (at.triangle < 0 || at.distance > far) continue;
      const auto corners = now_.triangles.row(at.triangle);
      system.add({corners[0], corners[1], corners[2]}, at.barycentric, samples_.points.row(s),
                 weight * samples_.weights[s]);
    }
  }

  TriangleMesh now_;
  std::vector<std::vector<int>> neighbours_;
  ClosestPointTree own_;
  const ClosestPointTree& tree_;
  const SurfaceSamples& samples_;
  Points surface_normals_, rest_;
};

}  // namespace

Cancellable<Points> fit_closest(const TriangleMesh& mesh, const TriangleMesh& surface,
                                const ClosestPointTree& tree, const SurfaceSamples& samples,
                                const RunContext& context) {
  Fitter fitter(mesh, surface, tree, samples);
  for (std::size_t level = 0; level < kStiffness.size(); ++level) {
    fitter.level();
    for (int pass = 0; pass < kPasses; ++pass) {
      if (context.cancelled()) return {};
      fitter.pass(kStiffness[level]);
    }
    context.progress(static_cast<double>(level + 1) / kStiffness.size(), "atlas.fit");
  }
  return fitter.vertices();
}

}  // namespace glisson::atlas
