// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/lesion_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "alarm.h"
#include "frame_clock.h"
#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/rigid.h"
#include "glisson/registration/error_model.h"
#include "glisson/registration/refusal.h"

namespace glisson::guidance {
namespace {

/// Points that tell how near what is tracked is: one alone may be a wrong one.
constexpr Eigen::Index kNearest = 5;
/// Support that may go without the lesion being unseen.
constexpr double kLost = 0.1;

/// Places of the lesion's own surface, or of its tetrahedra's nodes; CT frame.
Points places_of(const PatientModel& model, Label lesion) {
  for (const NamedSurface& surface : model.surfaces)
    if (surface.structure == lesion && surface.mesh.vertex_count() > 0) return surface.mesh.vertices;
  std::vector<int> nodes;
  for (int t = 0; t < static_cast<int>(model.mesh.labels.size()); ++t)
    if (model.mesh.labels[static_cast<std::size_t>(t)] == lesion)
      for (int k = 0; k < 4; ++k) nodes.push_back(model.mesh.tetrahedra(t, k));
  Points places(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    places.row(static_cast<Eigen::Index>(i)) = model.mesh.vertices.row(nodes[i]);
  return places;
}

/// Median of the distances to the nearest points; infinite where there are none.
double distance_to(const Points& points, const Eigen::Vector3d& from) {
  if (points.rows() == 0) return std::numeric_limits<double>::infinity();
  std::vector<double> squares(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    squares[static_cast<std::size_t>(i)] = (points.row(i).transpose() - from).squaredNorm();
  const auto middle = static_cast<std::size_t>(std::min(kNearest, points.rows()) / 2);
  return std::sqrt(at_rank(std::move(squares), middle));
}

double reach_of(const Eigen::Matrix3d& covariance) {
  registration::LesionError error;
  error.covariance = covariance;
  return error.half_axes_95()[0];
}

}  // namespace

void LesionOptions::validate() const {
  const OptionCheck demand("lesion options");
  demand(margin > 0.0, "margin", margin, "Give a positive length in metres");
  demand(useless >= margin, "useless", useless, "Give the margin at least");
  demand(unknown_forces >= 0.0, "unknown_forces", unknown_forces, "Give a number from zero");
  demand(reach > 0.0, "reach", reach, "Give a positive length in metres");
  demand(settle > 0.0, "settle", settle, "Give a positive number of seconds");
  demand(relief > 0.0 && relief <= 1.0, "relief", relief, "Give a share above 0, at most 1");
}

struct LesionJudge::Impl {
  struct Lesion {
    Label label = 0;
    double radius = 0.0;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    bool known = false;
    Alarm wide{2, 3}, useless{2, 3};
    bool is_renewed = false;  ///< its covariance is another one, and the alarms are of the former
    double near_at = 0.0;     ///< seconds of the clock
    double support = 0.0;     ///< of the last frame that had points
    double far_at_start = 0.0;
  };

  Impl(const PatientModel& model, const Registration& registration, const LesionOptions& given)
      : options(given), mesh(model.mesh) {
    options.validate();
    const auto found = lesion_centres(model);
    Points centres(static_cast<Eigen::Index>(found.size()), 3);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto& [label, centre] = found[i];
      centres.row(static_cast<Eigen::Index>(i)) = centre.transpose();
      Lesion lesion;
      lesion.label = label;
      const Points places = places_of(model, label);
      if (places.rows() > 0)
        lesion.radius = (places.rowwise() - centre.transpose()).rowwise().norm().maxCoeff();
      lesions.push_back(lesion);
    }
    binding = bind_points(mesh, centres);
    know(registration);
    for (Lesion& lesion : lesions) {
      const double reach = lesion.known ? reach_of(lesion.covariance) : 0.0;
      lesion.wide.set(reach >= options.margin);
      lesion.useless.set(reach >= options.useless);
    }
  }

  /// What the registration says of itself and of its lesions.
  void know(const Registration& registration) {
    require(registration.nodes_in_camera.rows() == mesh.vertex_count(),
            "a registration has the nodes of its model");
    start = registration.nodes_in_camera;
    refused = registration::is_refused(registration) ||
              registration::has_doubt(registration, registration::kRefusalAccepted);
    for (Lesion& lesion : lesions) {
      lesion.covariance.setZero();
      for (const LesionSpread& spread : registration.lesions)
        if (spread.lesion == lesion.label) lesion.covariance = spread.covariance;
      lesion.known = lesion.covariance.allFinite() && lesion.covariance.trace() > 0.0;
    }
  }

  /// What follows from the region's size and from the whole.
  LesionVerdict verdict(const Lesion& lesion, const Eigen::Vector3d& centre,
                        const Eigen::Matrix3d& covariance, Level whole) const {
    LesionVerdict result;
    result.lesion = lesion.label;
    result.centre = centre;
    result.radius = lesion.radius;
    if (!lesion.known) return result;
    result.covariance = covariance;
    result.expected = registration::mean_error(covariance);
    result.reach = reach_of(covariance);
    result.level = lesion.useless.stands() ? Level::withdrawn
                   : lesion.wide.stands()  ? Level::degraded
                                           : Level::valid;
    result.reason = LesionReason::known;
    if (refused && result.level == Level::valid) {
      result.level = Level::degraded;
      result.reason = LesionReason::refused_start;
    }
    if (whole > result.level) {
      result.level = whole;
      result.reason = LesionReason::with_the_whole;
    }
    return result;
  }

  /// Which of the three made the region, of this reach, too large.
  LesionReason cause(const Eigen::Matrix3d& at_start, double added_by_shape, double reach,
                     double limit) const {
    const double reached = reach >= limit ? limit : options.relief * limit;
    if (reach_of(at_start) >= reached) return LesionReason::start_uncertain;
    const Eigen::Matrix3d with_shape = at_start + Eigen::Matrix3d::Identity() * added_by_shape / 3.0;
    return reach_of(with_shape) >= reached ? LesionReason::far_from_points : LesionReason::long_unseen;
  }

  void look_at_reach(Lesion& lesion, double reach) const {
    const bool is_renewed = std::exchange(lesion.is_renewed, false);
    for (const auto& [alarm, limit] :
         {std::pair(&lesion.wide, options.margin), {&lesion.useless, options.useless}}) {
      const double share = reach / limit;
      if (is_renewed)
        alarm->set(share >= (alarm->stands() ? options.relief : 1.0));
      else
        alarm->push(share, 1.0, options.relief);
    }
  }

  LesionVerdict judge(Lesion& lesion, const Eigen::Vector3d& centre, const OverlayFrame& overlay,
                      const Points& tracked, const RigidMotion& motion, double changed) {
    // While nothing is tracked, the last support is what it was: the time says that it is not fresh.
    if (tracked.rows() > 0) lesion.support = distance_to(tracked, centre);
    const double ratio = lesion.support / options.reach, far = 1.0 - std::exp(-ratio * ratio);
    if (!begun) lesion.far_at_start = far;
    const double lost = std::max(0.0, far - lesion.far_at_start);
    if (!begun || (tracked.rows() > 0 && lost <= kLost)) lesion.near_at = clock.now();
    const double unseen = clock.now() - lesion.near_at;
    const Eigen::Matrix3d at_start = motion.rotation * lesion.covariance * motion.rotation.transpose();
    const double by_shape = far * changed * changed;
    const double free = options.unknown_forces * options.unknown_forces;
    const double by_time = lost * free * (1.0 - std::exp(-unseen / options.settle));
    const Eigen::Matrix3d now = at_start + Eigen::Matrix3d::Identity() * (by_shape + by_time) / 3.0;
    if (lesion.known) look_at_reach(lesion, reach_of(now));
    LesionVerdict result = verdict(lesion, centre, now, overlay.level());
    result.support = lesion.support;
    result.unseen = unseen;
    if (result.reason == LesionReason::known && result.level != Level::valid)
      result.reason = cause(at_start, by_shape, result.reach,
                            result.level == Level::withdrawn ? options.useless : options.margin);
    return result;
  }

  /// The next frame, or the last one once more, as a correction leaves it.
  void tick(const OverlayFrame& overlay) {
    const std::pair frame(overlay.index, overlay.seconds);
    if (last_frame != frame) clock.tick(overlay.seconds);
    last_frame = frame;
  }

  LesionOptions options;
  TetMesh mesh;
  Points start;
  bool refused = false, begun = false;
  FrameClock clock;
  std::optional<std::pair<int, double>> last_frame;  ///< index and seconds
  std::vector<Lesion> lesions;
  Binding binding;
};

LesionJudge::LesionJudge(const PatientModel& model, const Registration& start, const LesionOptions& options)
    : impl_(std::make_unique<Impl>(model, start, options)) {}
LesionJudge::~LesionJudge() = default;
LesionJudge::LesionJudge(LesionJudge&&) noexcept = default;
LesionJudge& LesionJudge::operator=(LesionJudge&&) noexcept = default;

void LesionJudge::take(const Registration& registration) {
  impl_->know(registration);
  for (Impl::Lesion& lesion : impl_->lesions) lesion.is_renewed = true;
}

std::vector<LesionVerdict> LesionJudge::judge(const OverlayFrame& overlay, const Points& tracked) {
  std::vector<LesionVerdict> verdicts;
  if (impl_->lesions.empty() || overlay.nodes_in_camera.rows() != impl_->start.rows()) return verdicts;
  impl_->tick(overlay);
  const RigidMotion motion = fit_rigid_motion(impl_->start, overlay.nodes_in_camera, {});
  const Points as_body =
      (impl_->start * motion.rotation.transpose()).rowwise() + motion.translation.transpose();
  const double changed = std::sqrt((overlay.nodes_in_camera - as_body).rowwise().squaredNorm().mean());
  const Points centres = impl_->binding.apply(impl_->mesh, overlay.nodes_in_camera);
  for (std::size_t i = 0; i < impl_->lesions.size(); ++i)
    verdicts.push_back(impl_->judge(impl_->lesions[i], centres.row(static_cast<Eigen::Index>(i)).transpose(),
                                    overlay, tracked, motion, changed));
  impl_->begun = impl_->begun || tracked.rows() > 0;
  return verdicts;
}

void LesionJudge::carry(OverlayFrame& overlay) const {
  if (overlay.lesions.size() != impl_->lesions.size()) return;  // none were judged
  const Points centres = impl_->binding.apply(impl_->mesh, overlay.nodes_in_camera);
  for (std::size_t i = 0; i < overlay.lesions.size(); ++i)
    overlay.lesions[i].centre = centres.row(static_cast<Eigen::Index>(i)).transpose();
}

std::vector<LesionVerdict> LesionJudge::at_start(Validity validity) const {
  std::vector<LesionVerdict> verdicts;
  const Points centres = impl_->binding.apply(impl_->mesh, impl_->start);
  for (std::size_t i = 0; i < impl_->lesions.size(); ++i) {
    const Impl::Lesion& lesion = impl_->lesions[i];
    LesionVerdict verdict = impl_->verdict(lesion, centres.row(static_cast<Eigen::Index>(i)).transpose(),
                                           lesion.covariance, level_of(validity));
    if (verdict.reason == LesionReason::known && verdict.level != Level::valid)
      verdict.reason = LesionReason::start_uncertain;
    verdicts.push_back(verdict);
  }
  return verdicts;
}

}  // namespace glisson::guidance
