// SPDX-License-Identifier: GPL-3.0-or-later
#include "rigid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <random>

#include "cavity.h"
#include "glisson/core/error.h"
#include "glisson/core/share_out.h"
#include "glisson/core/statistics.h"
#include "glisson/registration/hand_pose.h"
#include "glisson/registration/pairs.h"

namespace glisson::registration {
namespace {

/// Metres. A point's cost is capped here: what is farther belongs to nothing (a hole in the model, an
/// outlier).
constexpr double kCap = 30e-3;
/// Metres by which the model may lie in front of a seen point: the organ deforms.
constexpr double kOcclusion = 10e-3;

struct Pose {
  CameraFromCt camera_from_ct;
  double cost = 0.0;
};

/// Trimmed ICP of one cloud against a model that stands still: queries are taken into the CT's frame.
class Aligner {
 public:
  Aligner(const PatientModel& model, const PreparedCloud& cloud, const RigidOptions& options)
      : surface_(model, SurfaceDetail::fine), cloud_(cloud), options_(options) {
    surface_.stand_still();
    normals_ = cloud.cloud.normals.rows() > 0 ? cloud.cloud.normals : estimate_normals(cloud);
    weigh();
  }

  const MovingSurface& surface() const { return surface_; }
  const Points& normals() const { return normals_; }

  /// Mean capped distance over the chosen points without the worst share. @param look also along the rays:
  /// what is hidden behind the model was not seen.
  double cost(const CameraFromCt& pose, const std::vector<int>& chosen, bool look) const {
    std::vector<int> near(chosen.size(), -1);
    std::vector<Match> matches = match(pose, chosen, near);
    if (look) hide(pose, matches);
    trim(matches);
    double sum = 0.0, weights = 0.0;
    for (const Match& m : matches) {
      // The landmark's mean share, the same at every pose. By the share at each place, a pose could lower its
      // cost by laying the marks beside a piece of the landmark that is uncertain.
      const double weight = weight_[static_cast<std::size_t>(m.point)] * mean_share_[index_of(m.feature)];
      sum += weight * m.distance;
      weights += weight;
    }
    return weights > 0.0 ? sum / weights : kCap;
  }

  /// Gauss-Newton on the matches, the tangential part counting `tangential` as much as the normal one.
  CameraFromCt refine(CameraFromCt pose, const std::vector<int>& chosen, int iterations,
                      double tangential) const {
    std::vector<int> near(chosen.size(), -1);
    for (int it = 0; it < iterations; ++it) {
      std::vector<Match> matches = match(pose, chosen, near);
      trim(matches);
      Eigen::Matrix<double, 6, 6> h = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
      Eigen::Matrix<double, 6, 1> g = Eigen::Matrix<double, 6, 1>::Zero();
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      double weights = 0.0;
      for (const Match& m : matches) centre += m.weight * m.p, weights += m.weight;
      if (weights <= 0.0) return pose;
      centre /= weights;
      for (const Match& m : matches) {
        if (!m.usable) continue;
        Eigen::Matrix<double, 3, 6> j;  // of p_in_ct, by a twist about the centre; radians scaled to 0.1 m
        const Eigen::Vector3d arm = (m.p - centre) / kLever;
        j << 0, arm.z(), -arm.y(), 1, 0, 0, -arm.z(), 0, arm.x(), 0, 1, 0, arm.y(), -arm.x(), 0, 0, 0, 1;
        const double share = m.feature == Feature::surface ? tangential : 1.0;
        const Eigen::Matrix3d n = m.normal * m.normal.transpose();
        const Eigen::Matrix3d metric = n + share * (Eigen::Matrix3d::Identity() - n);
        // Geman and McClure's weight: far matches guide, near ones decide.
        const double soft = m.weight / std::pow(1.0 + std::pow(m.distance / (0.5 * kCap), 2), 2);
        h += soft * j.transpose() * metric * j;
        g += soft * j.transpose() * metric * (m.q - m.p);
      }
      Eigen::Matrix<double, 6, 1> step = h.ldlt().solve(g);
      const Eigen::Vector3d turn = step.head<3>() / kLever;
      const double angle = turn.norm();
      // The cloud is moved in the CT's frame: ct_from_camera <- twist * ct_from_camera.
      Rigid<CtFrame, CtFrame> twist;
      if (angle > 0.0)
        twist.rotation = Eigen::AngleAxisd(std::min(angle, 0.5), turn / angle).toRotationMatrix();
      twist.translation = centre - twist.rotation * centre + step.tail<3>();
      pose = (twist * pose.inverse()).inverse();
      if (angle < 1e-5 && step.tail<3>().norm() < 1e-6) break;
    }
    // After hundreds of products the matrix is no exact rotation any more.
    pose.rotation = Eigen::Quaterniond(pose.rotation).normalized().toRotationMatrix();
    return pose;
  }

 private:
  static constexpr double kLever = 0.1;

  struct Match {
    int point = -1;
    Feature feature = Feature::surface;
    Eigen::Vector3d p, q, normal;  // CT frame
    double distance = 0.0, weight = 0.0;
    bool usable = true;
  };

  static std::size_t index_of(Feature feature) { return static_cast<std::size_t>(feature) - 1; }

  /// What a mark counts for on the mean of its landmark.
  void share_out_landmarks() {
    const std::vector<double>& margin = surface_.margin_deviations();
    double sum = 0.0;
    for (const double deviation : margin) sum += landmark_share(Feature::anterior_margin, deviation);
    if (!margin.empty()) mean_share_[1] = sum / static_cast<double>(margin.size());
    mean_share_[2] =
        landmark_share(Feature::umbilical_notch, surface_.deviation(Feature::umbilical_notch, {}));
  }

  /// Surface, margin and notch weigh 1 : 1/2 : 1/4 in all, whatever their numbers.
  void weigh() {
    share_out_landmarks();
    double total[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < cloud_.cloud.size(); ++i)
      total[static_cast<int>(cloud_.cloud.feature(i)) - 1] += cloud_.weight[static_cast<std::size_t>(i)];
    static constexpr double kShare[3] = {1.0, 0.5, 0.25};
    weight_.resize(cloud_.weight.size());
    for (int i = 0; i < cloud_.cloud.size(); ++i) {
      const int f = static_cast<int>(cloud_.cloud.feature(i)) - 1;
      weight_[static_cast<std::size_t>(i)] =
          kShare[f] * cloud_.weight[static_cast<std::size_t>(i)] / std::max(total[f], 1e-12);
    }
  }

  /// @param near of each chosen point the triangle of the last match; receives that of this one.
  std::vector<Match> match(const CameraFromCt& pose, const std::vector<int>& chosen,
                           std::vector<int>& near) const {
    const auto ct_from_camera = pose.inverse();
    std::vector<Match> matches;
    matches.reserve(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const int i = chosen[k];
      Match m;
      m.point = i;
      m.feature = cloud_.cloud.feature(i);
      m.weight = weight_[static_cast<std::size_t>(i)];
      m.p = ct_from_camera.rotation * cloud_.cloud.points.row(i).transpose() + ct_from_camera.translation;
      const ClosestPoint at = surface_.closest(m.feature, m.p, near[k]);
      near[k] = at.triangle;
      m.weight *= landmark_share(m.feature, surface_.deviation(m.feature, at));
      m.q = at.point;
      m.normal = surface_.normal(at);
      m.distance = std::min(at.distance, kCap);
      if (m.feature == Feature::surface &&
          m.normal.dot(ct_from_camera.rotation * normals_.row(i).transpose()) < 0.0) {
        m.usable = false;  // the surface would be seen from within
        m.distance = kCap;
      }
      matches.push_back(m);
    }
    return matches;
  }

  void hide(const CameraFromCt& pose, std::vector<Match>& matches) const {
    const auto ct_from_camera = pose.inverse();
    for (Match& m : matches) {
      const Eigen::Vector3d eye =
          ct_from_camera.rotation * cloud_.cloud.eye(m.point) + ct_from_camera.translation;
      const double length = (m.p - eye).norm();
      const ClosestPoint hit = surface_.first_hit(eye, (m.p - eye) / length, 0.0, length - kOcclusion);
      if (hit.triangle >= 0) m.distance = std::max(m.distance, std::min(kCap, length - hit.distance));
    }
  }

  /// Drops the worst share of the surface's points (all weights of a feature are alike but for density).
  void trim(std::vector<Match>& matches) const {
    std::vector<double> distances;
    for (const Match& m : matches)
      if (m.feature == Feature::surface) distances.push_back(m.distance);
    const auto kept = static_cast<std::size_t>(
        std::ceil((1.0 - options_.outlier_share) * static_cast<double>(distances.size())));
    if (kept >= distances.size()) return;
    const double limit = at_rank(std::move(distances), kept);
    std::erase_if(matches,
                  [&](const Match& m) { return m.feature == Feature::surface && m.distance > limit; });
  }

  MovingSurface surface_;
  const PreparedCloud& cloud_;
  const RigidOptions& options_;
  Points normals_;
  std::vector<double> weight_;
  std::array<double, 3> mean_share_ = {1.0, 1.0, 1.0};  ///< surface, margin, notch
};

/// Every feature in proportion, `count` points at most.
std::vector<int> choose(const LabelledCloud& cloud, int count) {
  std::vector<int> chosen;
  for (const Feature feature : {Feature::surface, Feature::anterior_margin, Feature::umbilical_notch}) {
    std::vector<int> all;
    for (int i = 0; i < cloud.size(); ++i)
      if (cloud.feature(i) == feature) all.push_back(i);
    const int wanted = feature == Feature::surface ? count : std::max(1, count / 4);
    const int n = std::min<int>(wanted, static_cast<int>(all.size()));
    for (int k = 0; k < n; ++k)
      chosen.push_back(
          all[static_cast<std::size_t>(static_cast<long>(k) * static_cast<long>(all.size()) / n)]);
  }
  return chosen;
}

Eigen::Matrix3d random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double z = normal(random), y = normal(random), x = normal(random), w = normal(random);
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
}

/// Start poses. Every one lays a place of the model that could be seen onto the middle of the cloud, facing
/// the camera, turned at random about the line of sight; with a labelled notch or margin every second one
/// lays that landmark instead, in any orientation.
class Starts {
 public:
  Starts(const PatientModel& model, const LabelledCloud& cloud, const Points& normals)
      : model_(model), areas_(triangle_areas(model.surface.mesh)) {
    Eigen::Vector3d middle = cloud.points.colwise().mean().transpose();
    int nearest = 0;
    for (int i = 1; i < cloud.size(); ++i)
      if ((cloud.points.row(i).transpose() - middle).norm() <
          (cloud.points.row(nearest).transpose() - middle).norm())
        nearest = i;
    middle_ = cloud.points.row(nearest).transpose();
    facing_ = normals.colwise().mean().transpose().normalized();
    if (!facing_.allFinite()) facing_ = -middle_.normalized();
    int notch = 0, margin = 0;
    for (int i = 0; i < cloud.size(); ++i) {
      if (cloud.feature(i) == Feature::umbilical_notch) notch_ += cloud.points.row(i).transpose(), ++notch;
      if (cloud.feature(i) == Feature::anterior_margin) margin_ += cloud.points.row(i).transpose(), ++margin;
    }
    if (notch > 0) notch_ /= notch;
    if (margin > 0) margin_ /= margin;
    has_notch_ = notch > 0 && model.landmarks.umbilical_notch.rows() > 0;
    has_margin_ = margin > 0 && model.landmarks.anterior_margin.rows() > 0;
  }

  CameraFromCt draw(int index, std::mt19937_64& random) const {
    if (index % 2 == 1 && (has_notch_ || has_margin_)) return on_landmark(random);
    const Points& vertices = model_.surface.mesh.vertices;
    std::discrete_distribution<int> triangle(areas_.data(), areas_.data() + areas_.size());
    const auto corners = model_.surface.mesh.triangles.row(triangle(random));
    const Eigen::Vector3d a = vertices.row(corners[0]).transpose(), b = vertices.row(corners[1]).transpose(),
                          c = vertices.row(corners[2]).transpose();
    Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    if (!normal.allFinite()) normal = Eigen::Vector3d::UnitZ();
    std::uniform_real_distribution<double> turn(-std::numbers::pi, std::numbers::pi);
    CameraFromCt pose;
    pose.rotation = Eigen::AngleAxisd(turn(random), facing_).toRotationMatrix() *
                    Eigen::Quaterniond::FromTwoVectors(normal, facing_).toRotationMatrix();
    pose.translation = middle_ - pose.rotation * ((a + b + c) / 3.0);
    return pose;
  }

 private:
  CameraFromCt on_landmark(std::mt19937_64& random) const {
    CameraFromCt pose;
    pose.rotation = random_rotation(random);
    if (has_notch_) {
      pose.translation =
          notch_ - pose.rotation * model_.landmarks.umbilical_notch.colwise().mean().transpose();
    } else {
      std::uniform_int_distribution<Eigen::Index> which(0, model_.landmarks.anterior_margin.rows() - 1);
      pose.translation =
          margin_ - pose.rotation * model_.landmarks.anterior_margin.row(which(random)).transpose();
    }
    return pose;
  }

  const PatientModel& model_;
  Eigen::VectorXd areas_;
  Eigen::Vector3d middle_, facing_;
  Eigen::Vector3d notch_ = Eigen::Vector3d::Zero(), margin_ = Eigen::Vector3d::Zero();
  bool has_notch_ = false, has_margin_ = false;
};

/// Mean distance between where two poses put the model.
double apart(const Points& vertices, const CameraFromCt& a, const CameraFromCt& b) {
  return (a.apply(vertices) - b.apply(vertices)).rowwise().norm().mean();
}

/// Adds to `best` those of the poses, in their order, that are at least `distance` from all in it.
void add_distinct(const std::vector<Pose>& poses, const Points& vertices, double distance, std::size_t count,
                  std::vector<Pose>& best) {
  for (const Pose& pose : poses) {
    if (best.size() >= count) break;
    if (std::all_of(best.begin(), best.end(), [&](const Pose& other) {
          return apart(vertices, pose.camera_from_ct, other.camera_from_ct) >= distance;
        }))
      best.push_back(pose);
  }
}

/// How many poses are kept: the best ones, and after them some far from all others. Without the latter, a
/// cloud that fits one place well would fill the list with that place's neighbours.
struct Kept {
  double apart;        ///< m
  std::size_t near;    ///< of these, the best first
  std::size_t places;  ///< of those kElsewhere from all others, after them
};
constexpr double kElsewhere = 40e-3;
constexpr Kept kRefined{5e-3, 20, 12}, kTold{10e-3, 5, 4};

/// The best first, then other places, the best of them first.
std::vector<Pose> best_distinct(std::vector<Pose> poses, const Points& vertices, const Kept& kept) {
  std::stable_sort(poses.begin(), poses.end(), [](const Pose& a, const Pose& b) { return a.cost < b.cost; });
  std::vector<Pose> best;
  add_distinct(poses, vertices, kept.apart, kept.near, best);
  add_distinct(poses, vertices, kElsewhere, kept.near + kept.places, best);
  return best;
}

std::vector<std::string> doubts_about(const PatientModel& model, const LabelledCloud& cloud,
                                      const std::vector<Pose>& poses) {
  std::vector<std::string> doubts;
  int margin = 0;
  for (int i = 0; i < cloud.size(); ++i) margin += cloud.feature(i) == Feature::anterior_margin;
  if (margin < 5 || model.landmarks.anterior_margin.rows() == 0) doubts.emplace_back("few_margin_points");
  if (poses.front().cost > 10e-3) doubts.emplace_back("rigid_residual_large");
  if (poses.size() > 1 && poses[1].cost < 1.15 * poses[0].cost + 1e-4) doubts.emplace_back("rigid_ambiguous");
  return doubts;
}

}  // namespace

void RigidOptions::validate() const {
  const OptionCheck demand("rigid options");
  demand(starts >= 1, "starts", starts, "Give 1 or more");
  demand(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
  demand(outlier_share >= 0.0 && outlier_share < 0.9, "outlier_share", outlier_share,
         "Give a number from 0 to 0.9");
}

namespace {

/// The best of the poses that `draw` gives, refined from each.
Cancellable<RigidStart> best_of(
    const PatientModel& model, const LabelledCloud& cloud, const RigidOptions& options,
    const RunContext& context,
    const std::function<CameraFromCt(int, const Points& normals, const PreparedCloud&)>& draw) {
  constexpr int kRedraws = 20;
  options.validate();
  require(model.surface.mesh.triangle_count() > 0, "a model needs a surface to be aligned");
  CloudOptions cloud_options;
  cloud_options.maximum_points = 1000;
  const PreparedCloud prepared = prepare_cloud(cloud, cloud_options);
  const Aligner aligner(model, prepared, options);
  const Points& vertices = model.surface.mesh.vertices;
  const std::vector<int> few = choose(prepared.cloud, 80), many = choose(prepared.cloud, 300),
                         all = choose(prepared.cloud, 1000);

  const Cavity cavity(model);
  const auto is_possible = [&](const Pose& pose) {
    return !options.from_cavity || cavity.holds(pose.camera_from_ct, prepared.cloud);
  };
  std::vector<Pose> poses;
  for (int k = 0; k < options.starts; ++k) {
    poses.push_back({draw(k, aligner.normals(), prepared), 0.0});
    for (int again = 0; again < kRedraws && !is_possible(poses.back()); ++again)
      poses.back().camera_from_ct = draw(k, aligner.normals(), prepared);
  }
  const auto refine = [&](const std::vector<int>& chosen, int iterations, double tangential, bool look,
                          const RunContext& part) {
    share_out(poses.size(), options.threads, [&](std::size_t k, bool here) {
      if (part.cancelled()) return;
      if (here)
        part.progress(static_cast<double>(k) / static_cast<double>(poses.size()), "registration.rigid");
      poses[k].camera_from_ct = aligner.refine(poses[k].camera_from_ct, chosen, iterations, tangential);
      poses[k].cost = aligner.cost(poses[k].camera_from_ct, chosen, look);
      // What no camera can see comes after all else.
      if (!is_possible(poses[k])) poses[k].cost += kCap;
    });
  };
  refine(few, 10, 0.5, false, context.part(0.0, 0.7));
  if (context.cancelled()) return std::nullopt;
  poses = best_distinct(std::move(poses), vertices, kRefined);
  refine(many, 30, 0.2, true, context.part(0.7, 0.95));
  if (context.cancelled()) return std::nullopt;
  RigidStart start;
  const std::vector<Pose> apart_by_10 = best_distinct(poses, vertices, kTold);
  for (std::size_t k = 1; k < apart_by_10.size(); ++k)
    start.alternatives.push_back(apart_by_10[k].camera_from_ct);
  poses = best_distinct(std::move(poses), vertices, {20e-3, 2, 0});
  start.camera_from_ct = aligner.refine(poses[0].camera_from_ct, all, 20, 0.2);
  start.residual = aligner.cost(start.camera_from_ct, all, false);
  start.doubts = doubts_about(model, prepared.cloud, poses);
  context.progress(1.0, "registration.rigid");
  return start;
}

}  // namespace

Cancellable<RigidStart> align_rigid(const PatientModel& model, const LabelledCloud& cloud,
                                    const RigidOptions& options, const RunContext& context) {
  std::mt19937_64 random = context.random("registration.rigid");
  std::optional<Starts> starts;
  return best_of(model, cloud, options, context,
                 [&](int k, const Points& normals, const PreparedCloud& prepared) {
                   if (!starts) starts.emplace(model, prepared.cloud, normals);
                   return starts->draw(k, random);
                 });
}

Cancellable<RigidStart> align_rigid_near(const PatientModel& model, const LabelledCloud& cloud,
                                         const CameraFromCt& near, const RigidOptions& options,
                                         const RunContext& context) {
  constexpr double kTurn = 0.25, kShift = 10e-3;  // radians, metres: deviations of a hand, each axis
  std::mt19937_64 random = context.random("registration.rigid_near");
  std::normal_distribution<double> normal;
  const auto vector = [&](double deviation) -> Eigen::Vector3d {
    const double x = normal(random), y = normal(random), z = normal(random);
    return deviation * Eigen::Vector3d(x, y, z);
  };
  const Eigen::Vector3d middle = model.mesh.vertices.colwise().mean().transpose();
  auto start = best_of(model, cloud, options, context, [&](int k, const Points&, const PreparedCloud&) {
    if (k == 0) return near;
    CameraFromCt pose = turned(near, middle, vector(kTurn));
    pose.translation += vector(kShift);
    return pose;
  });
  if (start) start->alternatives.push_back(near);
  return start;
}

}  // namespace glisson::registration
