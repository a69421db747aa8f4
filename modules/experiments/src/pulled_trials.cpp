// SPDX-License-Identifier: GPL-3.0-or-later
#include "pulled_trials.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "glisson/core/error.h"
#include "glisson/core/numbered_files.h"
#include "glisson/core/random.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/experiments/evaluate.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/rigid.h"
#include "glisson/geometry/topology.h"
#include "glisson/insilico/pulled_organ.h"
#include "glisson/model/build.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/refusal.h"

namespace glisson::experiments {
namespace {

constexpr double kFramesPerSecond = 30.0;
constexpr double kDistance = 0.12;    ///< m, from a camera to the middle of what it sees
constexpr double kOtherMesh = 1.3;    ///< times the nodes of the mesh that is registered
constexpr double kLooseShare = 0.44;  ///< of the surface, as in the pair of LiverMatch
constexpr double kHeldShare = 0.2;

/// The sum, the most and the count of what was added.
struct Errors {
  double sum = 0.0, most = 0.0;
  int count = 0;
  void add(double error) {
    sum += error;
    most = std::max(most, error);
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0.0; }
};

Cancellable<insilico::PulledOrgan> pulled(const TetMesh& truth, const PulledKind& kind, std::uint64_t seed,
                                          double noise, int frames, const RunContext& context) {
  insilico::PulledOrganOptions options;
  options.seed = seed;
  options.smallest_patch_cm2 = kind.smallest_patch_cm2;
  options.largest_patch_cm2 = kind.largest_patch_cm2;
  options.held_radius_mm = kind.held_radius_mm;
  options.hidden_patch = kind.hidden;
  if (kind.hidden) options.patches = 2;  // one of them is seen
  options.seen_share = kind.loose ? kLooseShare : kHeldShare;
  options.noise_mm = 1e3 * noise;
  options.frames = frames;
  return pull_organ(truth, options, context);
}

/// An organ that has no place for its patches, or no equilibrium, is drawn again. @param seed becomes its
/// own.
Cancellable<insilico::PulledOrgan> pulled_somehow(const TetMesh& truth, const PulledKind& kind,
                                                  std::uint64_t& seed, double noise, int frames,
                                                  const RunContext& context) {
  constexpr int kDraws = 5;
  constexpr std::uint64_t kApart = 100000;
  for (int draw = 1;; ++draw) {
    try {
      return pulled(truth, kind, seed, noise, frames, context);
    } catch (const NumericalError&) {
      if (draw == kDraws) throw;
      seed += kApart;
    }
  }
}

/// Looks at the middle of the points from where they face it, rolled anyhow.
CameraFromCt before_a_camera(const Points& seen, const Eigen::Vector3d& towards, double roll) {
  CameraFromCt pose;
  pose.rotation = Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                  Eigen::Quaterniond::FromTwoVectors(towards, -Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation = Eigen::Vector3d(0.0, 0.0, kDistance) - pose.rotation * seen.colwise().mean().transpose();
  return pose;
}

/// An organ with its truth, in the camera's frame.
struct Scene {
  PatientModel model;
  std::vector<int> held;  ///< nodes of the model
  std::vector<LabelledCloud> clouds;
  std::vector<Points> nodes;  ///< where the model's are, truly
  double moved = 0.0, moved_most = 0.0;
  std::uint64_t seed = 0;
};

Cancellable<TetMesh> truth_of(const BareOrgan& organ, const PulledKind& kind, const RunContext& context) {
  if (!kind.other_mesh) return organ.mesh;
  model::MeshOptions finer;
  finer.target_vertices = static_cast<int>(kOtherMesh * organ.mesh.vertex_count());
  return model::mesh_surface(boundary_surface(organ.mesh).mesh, finer, context);
}

Cancellable<Scene> scene_of(const BareOrgan& organ, const PulledKind& kind, std::uint64_t seed, double noise,
                            int frames, const RunContext& context) {
  const auto truth = truth_of(organ, kind, context.part(0.0, 0.1));
  if (!truth) return std::nullopt;
  const auto made = pulled_somehow(*truth, kind, seed, noise, frames, context.part(0.1, 1.0));
  if (!made) return std::nullopt;
  Scene scene;
  scene.seed = seed;
  scene.model = model::build_from_mesh(organ.mesh).model;
  if (!kind.loose) scene.held = held_nodes(organ.mesh, *made);
  scene.moved = made->mean_motion;
  scene.moved_most = made->largest_motion;
  std::mt19937_64 random = context.random("pulled camera " + std::to_string(seed));
  const CameraFromCt camera = kind.loose ? before_a_camera(made->frames[0].cloud, made->towards_camera,
                                                           2.0 * std::numbers::pi * uniform01(random))
                                         : CameraFromCt();
  const Binding carried = kind.other_mesh ? bind_points(*truth, organ.mesh.vertices, false) : Binding();
  for (const insilico::PulledFrame& frame : made->frames) {
    LabelledCloud cloud;
    cloud.points = camera.apply(frame.cloud);
    scene.clouds.push_back(std::move(cloud));
    scene.nodes.push_back(camera.apply(kind.other_mesh ? carried.apply(*truth, frame.nodes) : frame.nodes));
  }
  return scene;
}

Eigen::VectorXd off(const Points& nodes, const Points& truth) { return (nodes - truth).rowwise().norm(); }

/// Follows clouds as `glisson track --clouds` does.
class Followed {
 public:
  Followed(const PatientModel& model, const Registration& start, const std::vector<int>& held) {
    auto built = std::make_shared<model::BuiltModel>();
    built->model = model;
    engine::CaseState state;
    state[part::model] = std::move(built);
    state[part::registration] = std::make_shared<const Registration>(start);
    engine::StartTracking command;
    command.source = engine::StartTracking::Source::clouds;
    command.options.fixed_nodes = held;
    follower_ = engine::make_follower(state, command);
  }

  Points follow(const LabelledCloud& cloud, int number) {
    const OverlayFrame frame =
        follower_->follow(engine::IndexedCloud{cloud, number, number / kFramesPerSecond});
    valid_ += frame.level() == Level::valid;
    return frame.nodes_in_camera;
  }
  int valid() const { return valid_; }

 private:
  std::unique_ptr<engine::Follower> follower_;
  int valid_ = 0;
};

Cancellable<registration::ExaminedRegistration> registered(const PatientModel& model,
                                                           const LabelledCloud& cloud,
                                                           const std::vector<int>& held,
                                                           const RunContext& context) {
  registration::RegisterOptions options;
  options.fixed_nodes = held;
  options.landmarks_are_placed = false;
  options.threads = 1;  // trials run beside each other
  if (!held.empty()) options.start = registration::RegisterOptions::Start::none;
  return register_model(model, cloud, options, context);
}

}  // namespace

Cancellable<PulledTrial> try_pulled(const BareOrgan& organ, const PulledKind& kind, std::uint64_t seed,
                                    double noise, int frames, const RunContext& context) {
  const auto scene = scene_of(organ, kind, seed, noise, frames, context.part(0.0, 0.5));
  if (!scene) return std::nullopt;
  PulledTrial trial;
  trial.organ = organ.name;
  trial.kind = &kind;
  trial.seed = scene->seed;
  trial.noise = noise;
  trial.moved = scene->moved;
  trial.moved_most = scene->moved_most;
  Cancellable<registration::ExaminedRegistration> examined;
  try {
    examined = registered(scene->model, scene->clouds[0], scene->held, context.part(0.5, 0.8));
  } catch (const Error&) {  // as one that is infinitely far off, and told
    trial.refused = true;
    trial.error = trial.worst = trial.followed = trial.followed_worst =
        std::numeric_limits<double>::infinity();
    return trial;
  }
  if (!examined) return std::nullopt;
  const Registration& found = examined->registered.registration;
  trial.error = off(found.nodes_in_camera, scene->nodes[0]).mean();
  trial.worst = off(found.nodes_in_camera, scene->nodes[0]).maxCoeff();
  trial.residual = found.residual;
  trial.doubts = found.doubts;
  trial.refused = registration::is_refused(found);
  Followed followed(scene->model, found, scene->held);
  Errors errors, frozen;
  for (std::size_t k = 1; k < scene->clouds.size(); ++k) {
    if (context.cancelled()) return std::nullopt;
    const Points nodes = followed.follow(scene->clouds[k], static_cast<int>(k));
    frozen.add(off(found.nodes_in_camera, scene->nodes[k]).mean());
    errors.add(off(nodes, scene->nodes[k]).mean());
  }
  trial.followed = errors.mean();
  trial.followed_worst = errors.most;
  trial.frozen = frozen.mean();
  trial.frames = frozen.count;
  trial.valid = followed.valid();
  return trial;
}

Cancellable<SequenceTrial> try_sequence(const std::filesystem::path& folder, const RunContext& context) {
  constexpr int kFrames = 50, kTrueEvery = 5;
  const NumberedFiles clouds = *NumberedFiles::of((folder / "cloud_%02d.ply").string());
  const NumberedFiles truths = *NumberedFiles::of((folder / "truth_%02d.xyz").string());
  const PatientModel model =
      model::build_from_mesh(read_tet_mesh(folder / "rest.vtk", LengthUnit::millimetre)).model;
  const std::vector<int> held = read_node_numbers(folder / "fixed_vertices.txt", model.mesh.vertex_count());
  const auto cloud_of = [&](int k) { return read_cloud(clouds.at(k), LengthUnit::millimetre); };
  const auto truth_of = [&](int k) { return read_true_nodes(truths.at(k), LengthUnit::millimetre); };
  const auto examined = registered(model, cloud_of(0), held, context.part(0.0, 0.2));
  if (!examined) return std::nullopt;
  const Registration& found = examined->registered.registration;
  SequenceTrial trial;
  trial.moved = off(model.mesh.vertices, truth_of(0)).mean();
  trial.error = off(found.nodes_in_camera, truth_of(0)).mean();
  Followed followed(model, found, held);
  Errors errors;
  for (int k = 0; k < kFrames; ++k) {
    if (context.cancelled()) return std::nullopt;
    context.progress(0.2 + 0.8 * k / kFrames, "prove.pulled");
    const Points nodes = followed.follow(cloud_of(k), k);
    ++trial.frames;
    if (k % kTrueEvery == 0) errors.add(off(nodes, truth_of(k)).mean());
  }
  trial.followed = errors.mean();
  trial.followed_worst = errors.most;
  trial.valid = followed.valid();
  return trial;
}

}  // namespace glisson::experiments
