// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/registration/shape_fits.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/share_out.h"
#include "glisson/registration/looks.h"
#include "glisson/registration/pairs.h"
#include "glisson/registration/rivals.h"

namespace glisson::registration {
namespace {

/// Squared standardised distance at which Cauchy's weight is a half: five standard deviations.
constexpr double kTolerance = 25.0;
/// Of a cloud that comes without normals those of its neighbours' planes are good enough to say that no face
/// was seen from behind, no more.
constexpr double kFacing = 0.0;
constexpr double kLargestTurn = 0.3;  // rad an iteration
/// The fit is at rest when a step changes less: amplitudes (standard deviations); pose (metres, and radians
/// times 0.1 m).
constexpr double kRestAmplitude = 2e-3, kRestPose = 2e-5;
constexpr int kFewestIterations = 10;

/// Turned about the camera and shifted. @param twist rotation vector, translation.
template <class Source>
Rigid<CameraFrame, Source> twisted(const Rigid<CameraFrame, Source>& pose,
                                   const Eigen::Matrix<double, 6, 1>& twist) {
  const Eigen::Matrix3d rotation = rotation_by(twist.head<3>());
  return {Eigen::Quaterniond(rotation * pose.rotation).normalized().toRotationMatrix(),
          rotation * pose.translation + twist.tail<3>()};
}

class ShapeFitter {
 public:
  /// @param surface the model's, at rest.
  ShapeFitter(const PatientModel& model, const MovingSurface& surface, const OperationPrior& prior,
              const PreparedCloud& cloud, const ShapeStart& start, const ShapeFitOptions& options)
      : options_(options),
        prior_(prior),
        rest_(model.mesh.vertices),
        cloud_(cloud),
        still_(cloud_.cloud),
        surface_(surface) {
    fit_.start = start;
    fit_.start.looks = one_a_look(cloud_.cloud, start.looks);
    fit_.camera_from_ct = start.camera_from_ct;
    fit_.looks = fit_.start.looks;
    if (!fit_.looks.empty()) move_looks(still_, fit_.looks, cloud_.cloud);
    fit_.amplitudes = Eigen::VectorXd::Zero(prior.modes.cols());
  }

  Cancellable<ShapeFit> run(const RunContext& context) {
    for (fit_.iterations = 0; fit_.iterations < options_.max_iterations;) {
      if (context.cancelled()) return std::nullopt;
      context.progress(static_cast<double>(fit_.iterations) / options_.max_iterations, "registration.shape");
      pair();
      const bool rest = step();
      if (++fit_.iterations >= kFewestIterations && rest) break;
    }
    judge_facing();
    pair();
    fit_.residual = mean_distance(pairs_);
    fit_.cost = cost();
    fit_.log_evidence = log_evidence();
    return fit_;
  }

 private:
  void pair() {
    fit_.nodes_in_camera = fit_.camera_from_ct.apply(prior_.shape(rest_, fit_.amplitudes));
    surface_.move(fit_.nodes_in_camera);
    pairs_ = find_pairs(cloud_, surface_, pairing_, pairs_);
  }

  /// From here on no point is laid on a face that looks away from the camera. While the shape is sought it
  /// may be: the way to a dent leads through there.
  void judge_facing() {
    if (cloud_.cloud.normals.rows() > 0) return;
    cloud_.cloud.normals = estimate_normals(cloud_);
    pairing_.minimum_normal_cosine = kFacing;
  }

  /// Inverse covariance of a pair's gap.
  Eigen::Matrix3d information(const Pair& pair) const {
    const auto inverse_square = [](double sigma) { return 1.0 / (sigma * sigma); };
    const double weight = cloud_.weight[static_cast<std::size_t>(pair.point)] * options_.information;
    switch (pair.feature) {
      case Feature::umbilical_notch:  // a look's points share one gap
        return inverse_square(options_.sigma_notch) /
               cloud_.notch_points[static_cast<std::size_t>(cloud_.cloud.look(pair.point))] *
               Eigen::Matrix3d::Identity();
      case Feature::anterior_margin:
        return weight * inverse_square(options_.sigma_margin) * Eigen::Matrix3d::Identity();
      case Feature::surface:
        break;
    }
    return weight * inverse_square(options_.sigma_surface) * pair.normal * pair.normal.transpose();
  }

  double cost() const {
    double sum = fit_.amplitudes.squaredNorm();
    for (const Pair& pair : pairs_) {
      const double square = pair.gap.dot(information(pair) * pair.gap);
      if (pair.feature == Feature::umbilical_notch) {
        sum += square;
        continue;
      }
      const double share = cloud_.weight[static_cast<std::size_t>(pair.point)] * options_.information;
      sum += share * kTolerance * (std::log1p(square / (share * kTolerance)) + (pair.kept ? 0.0 : 1.0));
    }
    return sum;
  }

  /// How the paired point of the model moves with the amplitudes and a twist of the pose about the camera.
  void jacobian(const Pair& pair, Eigen::Matrix<double, 3, Eigen::Dynamic>& j) const {
    const Eigen::Index modes = prior_.modes.cols();
    const Carrier carrier = surface_.carrier(pair.on_model);
    j.leftCols(modes).setZero();
    for (std::size_t k = 0; k < 4; ++k)
      if (carrier.nodes[k] >= 0)
        j.leftCols(modes) += carrier.weights[k] * prior_.modes.middleRows<3>(3L * carrier.nodes[k]);
    j.leftCols(modes) = (fit_.camera_from_ct.rotation * j.leftCols(modes)).eval();
    const Eigen::Vector3d p = pair.on_model.point;
    j.rightCols(j.cols() - modes).setZero();
    j.block<3, 3>(0, modes) << 0, p.z(), -p.y(), -p.z(), 0, p.x(), p.y(), -p.x(), 0;
    j.block<3, 3>(0, modes + 3).setIdentity();
    const int look = cloud_.cloud.look(pair.point);
    if (look == 0) return;
    // The gap closes as well where the look goes the other way.
    const Eigen::Vector3d q = p + pair.gap;
    j.block<3, 3>(0, modes + 6 * look) << 0, -q.z(), q.y(), q.z(), 0, -q.x(), -q.y(), q.x(), 0;
    j.block<3, 3>(0, modes + 6 * look + 3) = -Eigen::Matrix3d::Identity();
  }

  /// Of what is unknown: amplitudes, then a twist of the pose and of each further look.
  struct NormalEquations {
    Eigen::MatrixXd h;
    Eigen::VectorXd g;
  };
  NormalEquations normal_equations() const {
    const Eigen::Index modes = prior_.modes.cols();
    const Eigen::Index poses = 6L * cloud_.cloud.look_count();
    NormalEquations normal{Eigen::MatrixXd::Zero(modes + poses, modes + poses),
                           Eigen::VectorXd::Zero(modes + poses)};
    Eigen::Matrix<double, 3, Eigen::Dynamic> j(3, modes + poses);
    for (const Pair& pair : pairs_) {
      if (!pair.kept) continue;
      Eigen::Matrix3d weight = information(pair);
      // The notch is clicked on purpose and has no other like it: it is never taken for an outlier.
      if (pair.feature != Feature::umbilical_notch) {
        const double share = cloud_.weight[static_cast<std::size_t>(pair.point)] * options_.information;
        weight /= 1.0 + pair.gap.dot(weight * pair.gap) / (share * kTolerance);
      }
      jacobian(pair, j);
      normal.h.noalias() += j.transpose() * (weight * j);
      normal.g.noalias() += j.transpose() * (weight * pair.gap);
    }
    normal.h.topLeftCorner(modes, modes).diagonal().array() += 1.0;
    normal.g.head(modes) -= fit_.amplitudes;
    normal.h.bottomRightCorner(poses, poses).diagonal().array() += 1e-3;
    return normal;
  }

  /// Laplace's approximation: the posterior is a Gaussian about its peak.
  double log_evidence() const {
    const Eigen::LLT<Eigen::MatrixXd> factor(normal_equations().h);
    return -0.5 * fit_.cost - factor.matrixLLT().diagonal().array().log().sum();
  }

  /// One step of Gauss and Newton; true when hardly anything moved.
  bool step() {
    const Eigen::Index modes = prior_.modes.cols();
    const NormalEquations normal = normal_equations();
    Eigen::VectorXd change = normal.h.ldlt().solve(normal.g);
    double turn = 0.0, shift = 0.0;
    for (Eigen::Index at = modes; at < change.size(); at += 6) {
      turn = std::max(turn, change.segment<3>(at).norm());
      shift = std::max(shift, change.segment<3>(at + 3).norm());
    }
    if (turn > kLargestTurn) change *= kLargestTurn / turn;
    fit_.amplitudes += change.head(modes);
    fit_.camera_from_ct = twisted(fit_.camera_from_ct, change.segment<6>(modes));
    for (std::size_t look = 1; look < fit_.looks.size(); ++look)
      fit_.looks[look] =
          twisted(fit_.looks[look], change.segment<6>(modes + 6 * static_cast<Eigen::Index>(look)));
    if (!fit_.looks.empty()) move_looks(still_, fit_.looks, cloud_.cloud);
    return change.head(modes).norm() < kRestAmplitude && shift + 0.1 * turn < kRestPose;
  }

  const ShapeFitOptions& options_;
  const OperationPrior& prior_;
  Points rest_;
  PreparedCloud cloud_;
  LabelledCloud still_;  ///< before its looks were moved
  PairOptions pairing_;
  MovingSurface surface_;
  std::vector<Pair> pairs_;
  ShapeFit fit_;
};

}  // namespace

void ShapeFitOptions::validate() const {
  const OptionCheck demand("shape options");
  demand(sigma_surface > 0.0, "sigma_surface", sigma_surface, "Give a positive length in metres");
  demand(sigma_margin > 0.0, "sigma_margin", sigma_margin, "Give a positive length in metres");
  demand(sigma_notch > 0.0, "sigma_notch", sigma_notch, "Give a positive length in metres");
  demand(information > 0.0 && information <= 1.0, "information", information, "Give a share in (0, 1]");
  demand(max_iterations > 0, "max_iterations", max_iterations, "Give one at least");
}

Cancellable<ShapeFit> fit_shape(const PatientModel& model, const OperationPrior& prior,
                                const LabelledCloud& cloud, const ShapeStart& start,
                                const ShapeFitOptions& options, const RunContext& context) {
  auto found = fit_shapes(model, prior, cloud, {start}, options, context);
  if (!found) return std::nullopt;
  return std::move(found->fits.front());
}

std::vector<ShapeStart> starts_of(const CameraFromCt& best, const std::vector<CameraFromCt>& others) {
  std::vector<ShapeStart> starts{{best, {}}};
  for (const CameraFromCt& other : others) starts.push_back({other, {}});
  return starts;
}

Cancellable<ShapeFits> fit_shapes(const PatientModel& model, const OperationPrior& prior,
                                  const LabelledCloud& cloud, const std::vector<ShapeStart>& starts,
                                  const ShapeFitOptions& options, const RunContext& context) {
  // A posterior e^4 times smaller is no rival.
  constexpr double kRivalCost = 8.0, kUnusual = 4.0;
  options.validate();
  require(!starts.empty(), "a shape is fitted from one start at least");
  require(prior.modes.rows() == model.mesh.vertices.size(),
          "a prior is used with the model that it was made from");
  const MovingSurface surface(model, SurfaceDetail::fine);
  const PreparedCloud prepared = prepare_cloud(cloud, {});
  std::vector<Cancellable<ShapeFit>> ended(starts.size());
  const double share = 1.0 / static_cast<double>(starts.size());
  share_out(starts.size(), 2, [&](std::size_t k, bool here) {
    if (context.cancelled()) return;
    const auto before = static_cast<double>(k);
    ShapeFitter fitter(model, surface, prior, prepared, starts[k], options);
    ended[k] = fitter.run(here ? context.part(share * before, share * (before + 1.0)) : context.quiet());
  });
  ShapeFits found;
  std::vector<ShapeFit>& fits = found.fits;
  for (Cancellable<ShapeFit>& fit : ended) {
    if (!fit) return std::nullopt;
    fits.push_back(std::move(*fit));
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ShapeFit& a, const ShapeFit& b) { return a.cost < b.cost; });
  const ShapeFit& best = fits.front();
  if (std::any_of(fits.begin(), fits.end(), [&](const ShapeFit& fit) {
        return fit.cost < best.cost + kRivalCost && are_rivals(fit.nodes_in_camera, best.nodes_in_camera);
      }))
    found.doubts.emplace_back("shape_ambiguous");
  if (best.amplitudes.cwiseAbs().maxCoeff() > kUnusual) found.doubts.emplace_back("shape_unusual");
  return found;
}

std::vector<const ShapeFit*> ShapeFits::places() const {
  // Forces that no prior knows may still explain what a shape leaves, not all of it.
  constexpr double kHopeless = 100.0;
  std::vector<const ShapeFit*> kept;
  for (const ShapeFit& fit : fits)
    if (fit.cost < best().cost + kHopeless &&
        std::none_of(kept.begin(), kept.end(), [&](const ShapeFit* other) {
          return !are_rivals(fit.nodes_in_camera, other->nodes_in_camera);
        }))
      kept.push_back(&fit);
  return kept;
}

}  // namespace glisson::registration
