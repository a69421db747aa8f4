// SPDX-License-Identifier: GPL-3.0-or-later
#include "looks.h"

#include <algorithm>
#include <string>

#include "glisson/core/error.h"
#include "glisson/registration/moving_surface.h"

namespace glisson::registration {
namespace {

constexpr int kLeastPoints = 10;
/// Places of the first look that each other place of a further one is tried with, and how many of those.
constexpr std::size_t kFirsts = 2, kOthers = 5;

bool all_have(const std::vector<LabelledCloud>& looks, bool (*has)(const LabelledCloud&)) {
  return std::all_of(looks.begin(), looks.end(), has);
}

}  // namespace

LabelledCloud joined(const std::vector<LabelledCloud>& looks, const LookMotions& into_first) {
  require(!looks.empty() && looks.size() == into_first.size(), "each look has a place");
  LabelledCloud all;
  const bool normals = all_have(looks, [](const LabelledCloud& look) { return look.normals.rows() > 0; });
  const bool sigma = all_have(looks, [](const LabelledCloud& look) { return !look.sigma.empty(); });
  const bool moved = !all_have(looks, [](const LabelledCloud& look) { return look.seen_from.rows() == 0; });
  const bool marked = !all_have(looks, [](const LabelledCloud& look) { return look.features.empty(); });
  Eigen::Index count = 0;
  for (std::size_t k = 0; k < looks.size(); ++k) {
    if (looks[k].size() < kLeastPoints)
      throw InputError("look " + std::to_string(k + 1), "points",
                       "there are " + std::to_string(looks[k].size()) + ", at least 10 are needed",
                       "Reconstruct with more features or larger regions");
    count += looks[k].size();
  }
  all.points.resize(count, 3);
  if (normals) all.normals.resize(count, 3);
  if (moved) all.seen_from.resize(count, 3);
  all.eyes = Points::Zero(static_cast<Eigen::Index>(looks.size()), 3);
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < looks.size(); ++k) {
    const LabelledCloud& look = looks[k];
    all.points.middleRows(at, look.size()) = look.points;
    if (normals) all.normals.middleRows(at, look.size()) = look.normals;
    for (int i = 0; i < look.size(); ++i) {
      if (moved) all.seen_from.row(at + i) = look.eye(i).transpose();
      if (marked) all.features.push_back(look.feature(i));
      if (sigma) all.sigma.push_back(look.sigma[static_cast<std::size_t>(i)]);
      all.looks.push_back(static_cast<int>(k));
    }
    at += look.size();
  }
  const LabelledCloud still = all;
  move_looks(still, into_first, all);
  return all;
}

LookMotions one_a_look(const LabelledCloud& cloud, LookMotions given) {
  given.resize(cloud.look_count() > 1 ? static_cast<std::size_t>(cloud.look_count()) : 0);
  return given;
}

void move_looks(const LabelledCloud& still, const LookMotions& motions, LabelledCloud& moved) {
  require(static_cast<int>(motions.size()) == still.look_count(), "each look has a place");
  for (int i = 0; i < still.size(); ++i) {
    const auto& motion = motions[static_cast<std::size_t>(still.look(i))];
    moved.points.row(i) =
        (motion.rotation * still.points.row(i).transpose() + motion.translation).transpose();
    if (still.normals.rows() > 0) moved.normals.row(i) = still.normals.row(i) * motion.rotation.transpose();
    if (still.seen_from.rows() > 0)
      moved.seen_from.row(i) =
          (motion.rotation * still.seen_from.row(i).transpose() + motion.translation).transpose();
  }
  for (Eigen::Index k = 0; k < still.eyes.rows(); ++k) {
    const auto& motion = motions[static_cast<std::size_t>(k)];
    moved.eyes.row(k) = (motion.rotation * still.eyes.row(k).transpose() + motion.translation).transpose();
  }
}

Cancellable<JoinedLooks> join_looks(const PatientModel& model, const LabelledCloud& cloud,
                                    const std::vector<LabelledCloud>& others, const RigidStart& first,
                                    const RigidOptions& options, const RunContext& context) {
  std::vector<LabelledCloud> looks{cloud};
  std::vector<RigidStart> places{first};
  JoinedLooks result;
  result.into_first.resize(1);
  const auto n = static_cast<double>(others.size());
  for (std::size_t k = 0; k < others.size(); ++k) {
    const auto done = static_cast<double>(k);
    auto place = align_rigid(model, others[k], options, context.part(done / n, (done + 1.0) / n));
    if (!place) return {};
    looks.push_back(others[k]);
    result.into_first.push_back(first.camera_from_ct * place->camera_from_ct.inverse());
    places.push_back(std::move(*place));
  }
  result.cloud = joined(looks, result.into_first);

  std::vector<CameraFromCt> firsts = first.alternatives;
  firsts.insert(firsts.begin(), first.camera_from_ct);
  // The looks go with the model, and one of them may have been seen from elsewhere.
  const auto add = [&](const CameraFromCt& start, std::size_t look, const CameraFromCt& elsewhere) {
    ShapeStart one{start, LookMotions(looks.size())};
    for (std::size_t k = 1; k < looks.size(); ++k) {
      const CameraFromCt& there = k == look ? elsewhere : places[k].camera_from_ct;
      one.looks[k] = start * there.inverse() * result.into_first[k].inverse();
    }
    result.starts.push_back(std::move(one));
  };
  for (const CameraFromCt& start : firsts) add(start, 0, {});
  for (std::size_t k = 1; k < looks.size(); ++k)
    for (std::size_t other = 0; other < std::min(kOthers, places[k].alternatives.size()); ++other)
      for (std::size_t at = 0; at < std::min(kFirsts, firsts.size()); ++at)
        add(firsts[at], k, places[k].alternatives[other]);
  return result;
}

Cancellable<double> one_shape_odds(const PatientModel& model, const OperationPrior& prior,
                                   const std::vector<LabelledCloud>& looks, const LookMotions& into_first,
                                   const ShapeFit& joint, const ShapeFitOptions& options,
                                   const RunContext& context) {
  require(looks.size() == joint.looks.size() && looks.size() == into_first.size(),
          "a joint fit of these looks has moved each of them");
  double odds = joint.log_evidence;
  const auto n = static_cast<double>(looks.size());
  for (std::size_t k = 0; k < looks.size(); ++k) {
    const CameraFromCt start = (joint.looks[k] * into_first[k]).inverse() * joint.camera_from_ct;
    const auto alone = fit_shape(model, prior, looks[k], {start, {}}, options,
                                 context.part(static_cast<double>(k) / n, static_cast<double>(k + 1) / n));
    if (!alone) return {};
    odds -= alone->log_evidence;
  }
  return odds;
}

std::vector<double> distances_of_looks(const PatientModel& model, const Points& nodes,
                                       const LabelledCloud& cloud) {
  constexpr double kNearer = 0.9;
  MovingSurface surface(model, SurfaceDetail::fine);
  surface.move(nodes);
  std::vector<std::vector<double>> distances(static_cast<std::size_t>(cloud.look_count()));
  for (int i = 0; i < cloud.size(); ++i)
    distances[static_cast<std::size_t>(cloud.look(i))].push_back(
        surface.closest(Feature::surface, cloud.points.row(i).transpose()).distance);
  std::vector<double> means;
  for (std::vector<double>& look : distances) {
    std::sort(look.begin(), look.end());
    look.resize(
        std::max<std::size_t>(1, static_cast<std::size_t>(kNearer * static_cast<double>(look.size()))));
    double sum = 0.0;
    for (const double one : look) sum += one;
    means.push_back(sum / static_cast<double>(look.size()));
  }
  return means;
}

}  // namespace glisson::registration
