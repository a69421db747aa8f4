// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape_fits.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "cavity.h"
#include "force_rows.h"
#include "glisson/core/error.h"
#include "glisson/core/share_out.h"
#include "glisson/registration/pairs.h"
#include "glisson/registration/rivals.h"
#include "looks.h"
#include "unmarked.h"

namespace glisson::registration {
namespace {

/// Squared standardised distance at which Cauchy's weight is a half: five standard deviations.
constexpr double kTolerance = 25.0;
/// Least cosine between a model's normal and a cloud's where the cloud came without normals. Normals
/// estimated from neighbours are only good enough to tell front from back, so it is zero.
constexpr double kFacing = 0.0;
constexpr double kLargestTurn = 0.3;  // rad an iteration
/// The fit is at rest when a step changes less: amplitudes (standard deviations); pose (metres, and radians
/// times 0.1 m).
constexpr double kRestAmplitude = 2e-3, kRestPose = 2e-5;
constexpr int kFewestIterations = 10;
/// It is at rest, too, when the cost has not fallen by kLessCost, which changes no odds, for kPatience
/// iterations: where points go to and fro between two faces the steps never become small.
constexpr int kPatience = 25;
constexpr double kLessCost = 0.1;
/// After kFirstIterations fits that are hopeless end: their cost is more than kFarBehind above the best one's
/// and more than twice as large. The limit is wide (ShapeFits::places() takes fits up to 100 above the best),
/// and the factor of two keeps all of them where none is good yet.
constexpr int kFirstIterations = 20;
constexpr double kFarBehind = 500.0;

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
        model_(model),
        prior_(prior),
        rest_(model.mesh.vertices),
        cloud_(cloud),
        still_(cloud_.cloud),
        surface_(surface) {
    for (int i = 0; i < cloud_.cloud.size(); ++i)
      if (cloud_.cloud.feature(i) != Feature::surface && surface_.has(cloud_.cloud.feature(i)))
        marks_.push_back(i);
    fit_.start = start;
    fit_.start.looks = one_a_look(cloud_.cloud, start.looks);
    fit_.camera_from_ct = start.camera_from_ct;
    fit_.looks = fit_.start.looks;
    if (!fit_.looks.empty()) move_looks(still_, fit_.looks, cloud_.cloud);
    fit_.amplitudes = Eigen::VectorXd::Zero(prior.modes.cols());
  }

  /// Goes on until it is at rest, until that many iterations in all, or until it is cancelled.
  void run(int until, const RunContext& context) {
    while (!rest_reached_ && fit_.iterations < until) {
      if (context.cancelled()) return;
      context.progress(static_cast<double>(fit_.iterations) / until, "registration.shape");
      pair();
      note_cost();
      const bool rest = step();
      ++fit_.iterations;
      rest_reached_ =
          (rest && fit_.iterations >= kFewestIterations) || fit_.iterations - least_at_ > kPatience;
    }
  }

  /// Of all iterations, within kLessCost.
  double least_cost() const { return least_cost_; }

  ShapeFit finish() {
    judge_facing();
    pair();
    fit_.residual = mean_distance(pairs_);
    fit_.cost = cost() + unmarked_cost(model_, cloud_, surface_, options_.information);
    fit_.log_evidence = log_evidence();
    return fit_;
  }

 private:
  void note_cost() {
    const double now = cost();
    if (now > least_cost_ - kLessCost) return;
    least_cost_ = now;
    least_at_ = fit_.iterations;
  }

  void pair() {
    fit_.nodes_in_camera = fit_.camera_from_ct.apply(prior_.shape(rest_, fit_.amplitudes));
    surface_.move(fit_.nodes_in_camera);
    if (!pairs_.empty()) pairs_.resize(static_cast<std::size_t>(cloud_.cloud.size()));
    pairs_ = find_pairs(cloud_, surface_, pairing_, pairs_);
    for (const int mark : marks_) pairs_.push_back(on_surface(mark));
  }

  /// What lies on a landmark lies on the surface, too: the point's pair as one of the surface.
  Pair on_surface(int point) const {
    Pair pair;
    pair.point = point;
    const Eigen::Vector3d p = cloud_.cloud.points.row(point).transpose();
    pair.on_model = surface_.closest(Feature::surface, p);
    pair.gap = p - pair.on_model.point;
    pair.normal = surface_.normal(pair.on_model);
    pair.kept =
        cloud_.cloud.normals.rows() == 0 ||
        pair.normal.dot(cloud_.cloud.normals.row(point).transpose()) >= pairing_.minimum_normal_cosine;
    return pair;
  }

  /// From here on no point is paired with a face that looks away from the camera. Before, while the shape is
  /// sought, such pairs are allowed: a shape becomes dented only by way of them.
  void judge_facing() {
    if (cloud_.cloud.normals.rows() > 0) return;
    cloud_.cloud.normals = estimate_normals(cloud_);
    pairing_.minimum_normal_cosine = kFacing;
  }

  /// Inverse variance of a pair's gap: along the normal on the surface, along each axis of a landmark.
  double precision(const Pair& pair) const {
    const auto inverse_square = [](double sigma) { return 1.0 / (sigma * sigma); };
    switch (pair.feature) {
      case Feature::umbilical_notch:  // a look's points share one gap
        return inverse_square(std::max(options_.sigma_notch, pair.deviation)) /
               cloud_.notch_points[static_cast<std::size_t>(cloud_.cloud.look(pair.point))];
      case Feature::anterior_margin:
        return share(pair) * inverse_square(std::max(options_.sigma_margin, pair.deviation));
      case Feature::surface:
        break;
    }
    return share(pair) * inverse_square(options_.sigma_surface);
  }

  /// For how many independent points a pair counts. What the cloud says of the point's own error is no error
  /// that neighbours share: with v = sigma^2 / share the variance is v + own^2, that of share v / (v +
  /// own^2).
  double share(const Pair& pair) const {
    const std::vector<double>& weight =
        pair.feature == Feature::surface ? cloud_.surface_weight : cloud_.weight;
    const double share = weight[static_cast<std::size_t>(pair.point)] * options_.information;
    const double sigma = pair.feature == Feature::surface ? options_.sigma_surface
                                                          : std::max(options_.sigma_margin, pair.deviation);
    const double own = cloud_.deviation(pair.point) / sigma;
    return share / (1.0 + share * own * own);
  }

  /// A pair's gap in standard deviations, squared.
  double square(const Pair& pair) const {
    const double gap = pair.feature == Feature::surface ? pair.normal.dot(pair.gap) : pair.gap.norm();
    return precision(pair) * gap * gap;
  }

  double cost() const {
    double sum = fit_.amplitudes.squaredNorm();
    for (const Pair& pair : pairs_) {
      if (pair.feature == Feature::umbilical_notch)
        sum += square(pair);
      else
        sum += share(pair) * kTolerance *
               (std::log1p(square(pair) / (share(pair) * kTolerance)) + (pair.kept ? 0.0 : 1.0));
      // The norm of the density, over three axes: the deviation differs from place to place of the margin.
      if (pair.feature == Feature::anterior_margin && pair.deviation > options_.sigma_margin)
        sum += share(pair) * 6.0 * std::log(pair.deviation / options_.sigma_margin);
    }
    return sum;
  }

  /// How far the paired point of the model moves along a direction with the amplitudes and a twist of the
  /// pose about the camera. @param row 1 x unknowns, all zero before.
  void motion_along(const Pair& pair, const Eigen::Vector3d& direction,
                    Eigen::Ref<Eigen::RowVectorXd> row) const {
    const Eigen::Index modes = prior_.modes.cols();
    add_along(surface_.carrier(pair.on_model), fit_.camera_from_ct.rotation.transpose() * direction,
              prior_.modes, row.head(modes));
    const Eigen::Vector3d p = pair.on_model.point;
    row.segment<3>(modes) = p.cross(direction).transpose();
    row.segment<3>(modes + 3) = direction.transpose();
    const int look = cloud_.cloud.look(pair.point);
    if (look == 0) return;
    // A look's own motion counts against the model's: moving the cloud back closes the gap, too.
    row.segment<3>(modes + 6L * look) = direction.cross(p + pair.gap).transpose();
    row.segment<3>(modes + 6L * look + 3) = -direction.transpose();
  }

  /// Of what is unknown: amplitudes, then a twist of the pose and of each further look.
  struct NormalEquations {
    Eigen::MatrixXd h;  ///< its lower triangle
    Eigen::VectorXd g;
  };
  NormalEquations normal_equations() const {
    const Eigen::Index modes = prior_.modes.cols();
    const Eigen::Index poses = 6L * cloud_.cloud.look_count();
    fem::NodalColumns a = fem::NodalColumns::Zero(3L * std::ssize(pairs_), modes + poses);
    Eigen::VectorXd gap(a.rows());
    Eigen::Index rows = 0;
    for (const Pair& pair : pairs_) {
      if (!pair.kept) continue;
      double weight = precision(pair);
      // The notch is clicked on purpose and has no other like it: it is never taken for an outlier.
      if (pair.feature != Feature::umbilical_notch) weight /= 1.0 + square(pair) / (share(pair) * kTolerance);
      const auto add = [&](const Eigen::Vector3d& direction) {
        motion_along(pair, std::sqrt(weight) * direction, a.row(rows));
        gap[rows++] = std::sqrt(weight) * direction.dot(pair.gap);
      };
      if (pair.feature == Feature::surface)
        add(pair.normal);
      else
        for (int axis = 0; axis < 3; ++axis) add(Eigen::Vector3d::Unit(axis));
    }
    NormalEquations normal{Eigen::MatrixXd::Zero(modes + poses, modes + poses),
                           a.topRows(rows).transpose() * gap.head(rows)};
    normal.h.selfadjointView<Eigen::Lower>().rankUpdate(a.topRows(rows).transpose());
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
  const PatientModel& model_;
  const OperationPrior& prior_;
  Points rest_;
  PreparedCloud cloud_;
  LabelledCloud still_;  ///< before its looks were moved
  PairOptions pairing_;
  MovingSurface surface_;
  std::vector<int> marks_;   ///< points of landmarks that the model has
  std::vector<Pair> pairs_;  ///< one a point, then one with the surface for each mark
  ShapeFit fit_;
  double least_cost_ = std::numeric_limits<double>::infinity();
  int least_at_ = 0;  ///< the iteration in which it last fell by kLessCost
  bool rest_reached_ = false;
};

/// Each on its own.
void run_each(const std::vector<ShapeFitter*>& fitters, int until, int threads, const RunContext& context) {
  const double share = 1.0 / static_cast<double>(fitters.size());
  share_out(fitters.size(), threads, [&](std::size_t k, bool here) {
    const auto before = static_cast<double>(k);
    fitters[k]->run(until, here ? context.part(share * before, share * (before + 1.0)) : context.quiet());
  });
}

/// All for a while, then to their ends those that are not far behind the best.
void run_all(const std::vector<std::unique_ptr<ShapeFitter>>& fitters, const ShapeFitOptions& options,
             const RunContext& context) {
  const int until = options.max_iterations;
  std::vector<ShapeFitter*> going;
  going.reserve(fitters.size());
  double least = std::numeric_limits<double>::infinity();
  for (const auto& fitter : fitters) going.push_back(fitter.get());
  run_each(going, std::min(kFirstIterations, until), options.threads, context.part(0.0, 0.5));
  for (const ShapeFitter* fitter : going) least = std::min(least, fitter->least_cost());
  std::erase_if(going, [&](const ShapeFitter* fitter) {
    return fitter->least_cost() > 2.0 * least && fitter->least_cost() > least + kFarBehind;
  });
  run_each(going, until, options.threads, context.part(0.5, 1.0));
}

}  // namespace

void ShapeFitOptions::validate() const {
  const OptionCheck demand("shape options");
  demand(sigma_surface > 0.0, "sigma_surface", sigma_surface, "Give a positive length in metres");
  demand(sigma_margin > 0.0, "sigma_margin", sigma_margin, "Give a positive length in metres");
  demand(sigma_notch > 0.0, "sigma_notch", sigma_notch, "Give a positive length in metres");
  demand(information > 0.0 && information <= 1.0, "information", information,
         "Give a share above 0, at most 1");
  demand(max_iterations > 0, "max_iterations", max_iterations, "Give 1 or more");
  demand(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
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
  std::vector<std::unique_ptr<ShapeFitter>> fitters;
  fitters.reserve(starts.size());
  for (const ShapeStart& start : starts)
    fitters.push_back(std::make_unique<ShapeFitter>(model, surface, prior, prepared, start, options));
  run_all(fitters, options, context);
  if (context.cancelled()) return std::nullopt;
  ShapeFits found;
  std::vector<ShapeFit>& fits = found.fits;
  for (const auto& fitter : fitters) fits.push_back(fitter->finish());
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ShapeFit& a, const ShapeFit& b) { return a.cost < b.cost; });
  if (options.from_cavity) {
    const Cavity cavity(model);
    const auto is_impossible = [&](const ShapeFit& fit) { return !cavity.holds(fit.camera_from_ct, cloud); };
    if (!std::all_of(fits.begin(), fits.end(), is_impossible)) std::erase_if(fits, is_impossible);
  }
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
