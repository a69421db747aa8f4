// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "glisson/core/statistics.h"

namespace glisson::guidance {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kReach = 15e-3;  ///< metres; what lies farther off the model is not it
/// Metres behind the organ, beyond three standard deviations: stereo looks past it.
constexpr double kPast = 8e-3;
/// Cauchy's scale, standard deviations: a wrong match weighs little, also against what it claims to know.
constexpr double kCauchy = 3.0;
/// Before anything is seen, the organ may be anywhere within so much: what stays unknown shows as sigma.
constexpr double kPriorShift = 0.03, kPriorTurn = 0.35;  ///< metres, radians
/// Points of one region count as this many independent ones.
constexpr double kIndependentInRegion = 2.0;
/// The seen surface draws the organ to it from this many times the reach, then from less (graduated
/// non-convexity: Blake and Zisserman 1987).
constexpr double kWide[] = {3.0, 1.5};
constexpr std::size_t kWideEvery = 4;  ///< seen place: what lies between says the same of a coarse place
constexpr int kMostTrials = 16, kMostWideTrials = 6;
constexpr double kSame = 1e-3;       ///< metres: places that differ by less are one
constexpr double kPlausible = 20.0;  ///< to one: a place with worse odds against the best one is none
constexpr double kTold = 3.0;        ///< standard deviations by which two places differ

/// A rigid motion of the organ about its middle: turn, then shift.
struct Motion {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(), centre = Eigen::Vector3d::Zero();

  Eigen::Vector3d apply(const Eigen::Vector3d& p) const { return centre + turn * (p - centre) + shift; }
  Eigen::Vector3d undo(const Eigen::Vector3d& p) const {
    return centre + turn.transpose() * (p - shift - centre);
  }
  Vector6 place() const {
    const Eigen::AngleAxisd angle(turn);
    Vector6 v;
    v << shift, angle.angle() * angle.axis();
    return v;
  }
  Motion changed(const Vector6& change) const {
    Motion moved = *this;
    moved.shift += change.head<3>();
    if (const double angle = change.tail<3>().norm(); angle > 1e-9)
      moved.turn = Eigen::AngleAxisd(angle, change.tail<3>() / angle).toRotationMatrix() * turn;
    return moved;
  }
};

/// How far a place may lie off the organ, and how much it then counts.
struct Kernel {
  double reach = kReach;
  double least_sigma = 0.0;  ///< metres
  double cost(double distance, double sigma) const {
    const double off = distance / (kCauchy * sigma);
    return 0.5 * kCauchy * kCauchy * std::log1p(off * off);
  }
  double weight(double distance, double sigma) const {
    const double off = distance / (kCauchy * sigma);
    return 1.0 / (sigma * sigma * (1.0 + off * off));
  }
};

/// The cost about one motion: half the squared deviations, as Cauchy counts them.
struct Local {
  Motion motion;
  double cost = 0.0;
  Matrix6 information;
  Vector6 side;             ///< what lowers the cost
  std::vector<double> off;  ///< of the seen places that were taken for the organ, deviations from it
};

class Fit {
 public:
  Fit(const registration::MovingSurface& surface, registration::NormalMemo& normals,
      const std::vector<SeenPlace>& seen, const std::vector<LookedThrough>& through)
      : surface_(surface), normals_(normals), seen_(seen), through_(through) {
    const TriangleMesh& mesh = surface.mesh();
    const int every = std::max(1, mesh.vertex_count() / 300);
    for (int v = 0; v < mesh.vertex_count(); v += every) organ_.push_back(mesh.vertex(v));
    for (const Eigen::Vector3d& p : organ_) here_.centre += p / static_cast<double>(organ_.size());
    prior_ << Eigen::Vector3d::Constant(1.0 / (kPriorShift * kPriorShift)),
        Eigen::Vector3d::Constant(1.0 / (kPriorTurn * kPriorTurn));
  }

  SurfacePull find() {
    const Motion drawn = drawn_by_seen();
    choose_reached(drawn);
    const Local one = descend(here_, {}, kMostTrials), other = descend(drawn, {}, kMostTrials);
    const SurfacePull here = pull(one);
    if (apart(one.motion, other.motion) < kSame) return here;
    // Laplace's evidence of both, less sure by what the better one leaves.
    const double excess = std::min(misfit(one), misfit(other));
    const double better =
        (against(one.motion) - against(other.motion)) / excess +
        0.5 * (std::log(one.information.determinant()) - std::log(other.information.determinant()));
    if (better < -std::log(kPlausible)) return here;
    const SurfacePull there = pull(other);
    if (better > std::log(kPlausible)) return there;
    // What stereo cannot tell apart is one place; two must both be right.
    const bool is_one = apart(one.motion, other.motion) < kTold * std::max(here.sigma, there.sigma);
    return is_one || here.pull > there.pull ? here : there;
  }

 private:
  /// Where the seen surface alone draws the organ to: all of it counts alike, however far off it lies.
  Motion drawn_by_seen() {
    std::vector<SeenPlace> some;
    for (std::size_t i = 0; i < seen_.size(); i += kWideEvery) some.push_back(seen_[i]);
    use(some, {});
    Motion motion = here_;
    for (const double wide : kWide)
      motion = descend(motion, {wide * kReach, wide * kReach / kCauchy}, kMostWideTrials).motion;
    return motion;
  }

  /// Both starts are judged by the same places: those within reach of either.
  void choose_reached(const Motion& drawn) {
    std::vector<SeenPlace> reached;
    const auto reaches = [&](const Motion& motion, const Eigen::Vector3d& p, int& near) {
      const ClosestPoint at = surface_.closest(Feature::surface, motion.undo(p), near);
      near = at.triangle;
      return at.triangle >= 0 && at.distance <= kReach;
    };
    int near_here = -1, near_drawn = -1;  // of the place before, which lies beside
    for (const SeenPlace& place : seen_)
      if (reaches(here_, place.p, near_here) || reaches(drawn, place.p, near_drawn)) reached.push_back(place);
    use(std::move(reached), through_);
  }

  void use(std::vector<SeenPlace> places, std::vector<LookedThrough> through) {
    used_ = std::move(places);
    near_.assign(used_.size(), -1);
    used_through_ = std::move(through);
    std::map<int, int> count;
    for (const SeenPlace& place : used_) ++count[place.region];
    for (const LookedThrough& place : used_through_) ++count[place.region];
    share_.clear();
    for (const auto& [region, n] : count) share_[region] = std::min(1.0, kIndependentInRegion / n);
  }

  /// Adds one measurement: the organ at `at` should move by `distance` along `direction`.
  static void add(const Motion& motion, const Eigen::Vector3d& at, const Eigen::Vector3d& direction,
                  double distance, double sigma, double share, const Kernel& kernel, Local& local) {
    Vector6 row;
    row << direction, (at - motion.centre - motion.shift).cross(direction);
    const double weight = share * kernel.weight(distance, sigma);
    local.information += weight * row * row.transpose();
    local.side += weight * distance * row;
    local.cost += share * kernel.cost(distance, sigma);
  }

  void add_seen(const Motion& motion, std::size_t i, const Kernel& kernel, Local& local) {
    const SeenPlace& place = used_[i];
    const double share = share_.at(place.region);
    const Eigen::Vector3d p = motion.undo(place.p);
    const bool is_first = near_[i] < 0 && i > 0;  // the place before lies beside
    const ClosestPoint at = surface_.closest(Feature::surface, p, near_[is_first ? i - 1 : i]);
    near_[i] = at.triangle;
    if (at.triangle >= 0 && at.distance <= kernel.reach) {
      const Eigen::Vector3d normal = surface_.normal(at, normals_);
      if (normal.dot(at.point.normalized()) <= 0.2) {  // else turned away: not what is seen
        const Eigen::Vector3d on = motion.apply(at.point), gap = place.p - on, turned = motion.turn * normal;
        // Beside the outline the way to the organ is across it.
        const bool is_beside = at.distance > 1e-4 && std::abs(turned.dot(gap)) < 0.7 * gap.norm();
        const Eigen::Vector3d direction = is_beside ? Eigen::Vector3d(gap.normalized()) : turned;
        const double slope = std::abs(direction.dot(place.p.normalized()));
        const double sigma = std::max(kernel.least_sigma, std::hypot(place.sigma * slope, kModelSigma));
        local.off.push_back(std::abs(direction.dot(gap)) / sigma);
        return add(motion, on, direction, direction.dot(gap), sigma, share, kernel, local);
      }
    }
    // It is something else; as costly as the farthest that is taken for the organ.
    local.cost +=
        share * kernel.cost(kernel.reach, std::max(kernel.least_sigma, std::hypot(place.sigma, kModelSigma)));
  }

  Local look(const Motion& motion, const Kernel& kernel) {
    Local local{motion, 0.0, prior_.asDiagonal(), Vector6::Zero(), {}};
    const Vector6 place = motion.place();
    local.cost = 0.5 * place.dot(prior_.cwiseProduct(place));
    local.side = -prior_.cwiseProduct(place);
    for (std::size_t i = 0; i < used_.size(); ++i) add_seen(motion, i, kernel, local);
    for (const LookedThrough& through : used_through_) {
      const Eigen::Vector3d at = motion.apply(through.at), gap = through.to - at;
      if (gap.norm() < 1e-4) continue;
      add(motion, at, gap.normalized(), gap.norm(), std::max(kernel.least_sigma, 2.0 * kModelSigma),
          share_.at(through.region), kernel, local);
    }
    return local;
  }

  /// Levenberg's steps: each lowers the cost. Steps that are taken as they come swing to and fro, since the
  /// places that the seen points are paired with change.
  Local descend(const Motion& start, const Kernel& kernel, int trials) {
    Local now = look(start, kernel);
    double damping = 1e-3;
    for (int trial = 0; trial < trials; ++trial) {
      Matrix6 damped = now.information;
      damped.diagonal() *= 1.0 + damping;
      const Vector6 change = damped.ldlt().solve(now.side);
      const bool is_small = change.head<3>().norm() < 2e-4 && change.tail<3>().norm() < 2e-3;
      Local next = look(now.motion.changed(change), kernel);
      if (next.cost < now.cost) {
        now = next;
        damping *= 0.1;
      } else {
        damping *= 10.0;
      }
      if (is_small) break;
    }
    return now;
  }

  /// What speaks against the organ being there: the cost, and every ray along which stereo looks past it.
  double against(const Motion& motion) {
    used_through_.clear();
    const Kernel kernel;
    double cost = look(motion, kernel).cost;
    for (const SeenPlace& place : used_) {
      const Eigen::Vector3d eye = motion.undo(Eigen::Vector3d::Zero());
      const Eigen::Vector3d ray = motion.turn.transpose() * place.p.normalized();
      const double past = 3.0 * std::hypot(place.sigma, kModelSigma) + kPast;
      const ClosestPoint hit = surface_.first_hit(eye, ray, 0.0, std::numeric_limits<double>::infinity());
      if (hit.triangle >= 0 && (hit.point - eye).norm() + past < place.p.norm())
        cost += share_.at(place.region) * kernel.cost(kReach, 2.0 * kModelSigma);
    }
    return cost;
  }

  /// How much more a fit leaves than noise does, as a variance; 1: no more (Birge 1932). By the median: wrong
  /// matches do not count.
  static double misfit(const Local& local) {
    if (local.off.empty()) return 1.0;
    return std::max(1.0, std::pow(kDeviationPerMad * upper_median(local.off), 2));
  }

  double apart(const Motion& a, const Motion& b) const {
    double sum = 0.0;
    for (const Eigen::Vector3d& p : organ_) sum += (a.apply(p) - b.apply(p)).squaredNorm();
    return std::sqrt(sum / static_cast<double>(organ_.size()));
  }

  SurfacePull pull(const Local& local) const {
    const Matrix6 covariance = misfit(local) * local.information.inverse();
    double unknown = 0.0;
    for (const Eigen::Vector3d& p : organ_) {
      Eigen::Matrix<double, 3, 6> reach;
      const Eigen::Vector3d arm = local.motion.apply(p) - local.motion.centre - local.motion.shift;
      Eigen::Matrix3d cross;
      cross << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
      reach << Eigen::Matrix3d::Identity(), cross;
      unknown += (reach * covariance * reach.transpose()).trace();
    }
    return {apart(local.motion, here_), std::sqrt(unknown / static_cast<double>(organ_.size()))};
  }

  const registration::MovingSurface& surface_;
  registration::NormalMemo& normals_;
  const std::vector<SeenPlace>& seen_;
  const std::vector<LookedThrough>& through_;
  std::vector<Eigen::Vector3d> organ_;  ///< places all over it
  Motion here_;                         ///< none
  Vector6 prior_;                       ///< its information, diagonal
  std::vector<SeenPlace> used_;
  std::vector<int> near_;  ///< the triangle that each of them was nearest to last: the search starts there
  std::vector<LookedThrough> used_through_;
  std::map<int, double> share_;  ///< of each region: what one of its measurements counts
};

}  // namespace

SurfacePull fit_to_seen(const registration::MovingSurface& surface, registration::NormalMemo& normals,
                        const std::vector<SeenPlace>& seen, const std::vector<LookedThrough>& through) {
  return Fit(surface, normals, seen, through).find();
}

}  // namespace glisson::guidance
