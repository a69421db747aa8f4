// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_fitter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "glisson/core/error.h"
#include "glisson/core/statistics.h"
#include "looks.h"
#include "unmarked.h"

namespace glisson::registration {
namespace {

constexpr double kGroundLength = 0.1;                        ///< m, in the unit of the ground springs
constexpr double kPoseTranslation = 20e-3, kPoseTurn = 0.2;  ///< prior deviations of a stage's pose: m, rad
constexpr int kFirstUpdates = 12, kUpdates = 3;              ///< of the variances, an iteration
constexpr double kAtRest = 0.1e-3;                           ///< m
constexpr double kGone = 1e-4;  ///< variance of a patch over the largest, below which nothing acts there
constexpr double kActs = 0.02;  ///< force over the strongest, above which it is told
constexpr int kRefined = 4;     ///< places of the strongest forces that get finer patches, at most
constexpr double kRadiusPerSigma = 5.0;  ///< of the finest patches
constexpr int kHalvings = 6;
constexpr double kNoiseAtMost = 2.5e-3;  ///< m
constexpr int kSettling = 5;             ///< stages after the last, at most

std::vector<char> fixed_of(const fem::ElasticBody& body) {
  std::vector<char> fixed;
  fixed.reserve(static_cast<std::size_t>(body.node_count()));
  for (int i = 0; i < body.node_count(); ++i) fixed.push_back(body.is_fixed(i) ? 1 : 0);
  return fixed;
}

/// A rotation vector about a centre, a translation.
Rigid<CtFrame, CtFrame> twist_about(const Eigen::Vector3d& centre, const Eigen::VectorXd& twist) {
  const Eigen::Matrix3d turn = rotation_by(twist.head<3>());
  return {turn, centre - turn * centre + twist.tail<3>()};
}

PreparedCloud prepared(const LabelledCloud& cloud, const ContactForceOptions& options) {
  return prepare_cloud(cloud, {3.9, options.most_points, 10});
}

/// Deviation that all points would have with as much information, m; 0: some point is told to have none.
/// Where neighbours share an error besides, the stages are of that.
double noise_told_by(const PreparedCloud& cloud, const ContactForceOptions& options) {
  if (options.information || cloud.cloud.sigma.empty()) return 0.0;
  double precision = 0.0;
  for (const double sigma : cloud.cloud.sigma) precision += 1.0 / (sigma * sigma);
  return std::sqrt(cloud.cloud.size() / precision);
}

/// See ContactForceFit::torn.
double torn_share(const TetMesh& mesh, const Points& rest, const Points& x) {
  constexpr double kLongest = 2.0;
  double torn = 0.0, all = 0.0;
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    Eigen::Matrix3d before, after;
    for (int k = 0; k < 3; ++k) {
      before.col(k) = (rest.row(mesh.tetrahedra(t, k + 1)) - rest.row(mesh.tetrahedra(t, 0))).transpose();
      after.col(k) = (x.row(mesh.tetrahedra(t, k + 1)) - x.row(mesh.tetrahedra(t, 0))).transpose();
    }
    const Eigen::Matrix3d f = after * before.inverse();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
    eigen.computeDirect(f.transpose() * f, Eigen::EigenvaluesOnly);  // squared stretches
    const double volume = std::abs(before.determinant());
    all += volume;
    if (eigen.eigenvalues().maxCoeff() > kLongest * kLongest ||
        eigen.eigenvalues().minCoeff() < 1.0 / (kLongest * kLongest))
      torn += volume;
  }
  return torn / all;
}

}  // namespace

ForceProblem::ForceProblem(const PatientModel& m, const LabelledCloud& c, const CameraFromCt& s,
                           const ContactForceOptions& o)
    : model(m),
      options(o),
      cloud(prepared(c, o)),
      surface(m, SurfaceDetail::fine),
      body(m.mesh, o.fixed_nodes, o.stiffness),
      force_surface(m.surface, m.mesh.vertices, fixed_of(body)),
      start(s),
      told_noise(noise_told_by(cloud, o)),
      grounded(o.fixed_nodes.empty()),
      free_pose(o.fixed_nodes.empty() && !o.pose_known) {
  if (!o.prior) return;
  require(o.prior->modes.rows() == m.mesh.vertices.size(),
          "a prior is used with the model that it was made from");
  require(o.amplitudes.size() == 0 || o.amplitudes.size() == o.prior->modes.cols(),
          "every mode of a prior has an amplitude");
  modes = o.prior->modes;
}

void ForceProblem::take(const LabelledCloud& next) {
  cloud = prepared(next, options);
  told_noise = noise_told_by(cloud, options);
}

ForceFitter::ForceFitter(const ForceProblem& problem, const fem::BodyMaterial& material, double ground)
    : problem_(problem),
      body_(problem.body),
      surface_(problem.surface),
      first_sigma_(std::numeric_limits<double>::infinity()) {
  body_.set_material(material);
  if (problem.modes.cols() > 0) {
    now_.modes = Eigen::VectorXd::Zero(problem.modes.cols());
    if (problem.options.amplitudes.size() > 0) now_.modes = problem.options.amplitudes;
    body_.set_rest(shape(now_.modes));
  }
  if (ground > 0.0) springs_ = ground / (kGroundLength * kGroundLength) * body_.node_volumes();
  centre_ = body_.rest().colwise().mean().transpose();
  now_.pose = problem.start;
  now_.x = body_.rest();
  now_.looks = one_a_look(problem.cloud.cloud, problem.options.looks);
  now_.law.material = material;
  now_.law.ground = ground;
  now_.law.log_evidence = -std::numeric_limits<double>::infinity();
  best_ = now_;
}

void ForceFitter::begin_at(const ForceFitter& other) {
  if (!std::isfinite(other.best_.law.log_evidence)) return;
  now_.pose = other.best_.pose;
  now_.x = other.best_.x;
  now_.modes = other.best_.modes;
  now_.looks = other.best_.looks;
  now_.law.place = other.best_.law.place;
  if (now_.modes.size() > 0) body_.set_rest(shape(now_.modes));
  strongest_ = strongest(other.best_);
  first_sigma_ = 2.0 * other.best_.law.sigma;
}

void ForceFitter::begin_at(const CameraFromCt& pose, const Points& x, const std::vector<int>& strongest,
                           double first_sigma) {
  now_.pose = pose;
  now_.x = x;
  strongest_ = strongest;
  first_sigma_ = std::max(first_sigma,
                          *std::min_element(problem_.options.sigmas.begin(), problem_.options.sigmas.end()));
}

void ForceFitter::begin_at(const ContactForceOptions::Place& place, std::size_t number) {
  now_.law.place = number;
  now_.pose = place.camera_from_ct;
  now_.modes.setZero();
  if (place.amplitudes.size() > 0) now_.modes = place.amplitudes;
  now_.looks = one_a_look(problem_.cloud.cloud, place.looks);
  if (now_.modes.size() > 0) body_.set_rest(shape(now_.modes));
  now_.x = body_.rest();
}

double ForceFitter::apart(const CameraFromCt& pose, const Points& x) {
  const State before = now_;
  now_.pose = pose;
  now_.x = x;
  const ForceRows rows = pair(problem_.options.sigmas.front());
  now_ = before;
  const Eigen::VectorXd gaps = rows.gap.head(rows.surface_count).cwiseAbs();
  return gaps.size() == 0 ? 0.0 : upper_median(std::vector<double>(gaps.begin(), gaps.end()));
}

PreparedCloud ForceFitter::onto_model() {
  surface_.move(now_.x);
  PreparedCloud cloud = problem_.cloud;
  if (!now_.looks.empty()) move_looks(problem_.cloud.cloud, now_.looks, cloud.cloud);
  const CameraFromCt& pose = now_.pose;
  cloud.cloud.points = pose.inverse().apply(cloud.cloud.points);
  cloud.cloud.normals = cloud.cloud.normals * pose.rotation;
  return cloud;
}

ForceRows ForceFitter::pair(double sigma) {
  const PreparedCloud cloud = onto_model();
  const ContactForceOptions& o = problem_.options;
  const double shared = sigma / std::sqrt(o.information.value_or(1.0));
  return find_rows(cloud, surface_, {sigma, std::max(o.outlier_distance, 2.0 * shared), o.information});
}

Points ForceFitter::shape(const Eigen::VectorXd& amplitudes) const {
  Points shape = problem_.model.mesh.vertices;
  if (amplitudes.size() > 0)
    Eigen::Map<Eigen::VectorXd>(shape.data(), shape.size()) += problem_.modes * amplitudes;
  return shape;
}

double ForceFitter::energy(const Points& x, Points* gradient) const {
  double sum = gradient != nullptr ? body_.energy(x, *gradient) : body_.energy(x);
  if (springs_.size() == 0) return sum;
  const Points moved = x - body_.rest();
  sum += 0.5 * springs_.dot(moved.rowwise().squaredNorm());
  if (gradient != nullptr) *gradient += springs_.asDiagonal() * moved;
  return sum;
}

std::vector<int> ForceFitter::strongest(const State& state) {
  std::vector<std::pair<double, int>> forces;
  for (std::size_t j = 0; j < state.patches.size(); ++j)
    forces.emplace_back(state.amplitudes.segment<3>(3 * static_cast<Eigen::Index>(j)).norm(),
                        state.patches[j].node);
  std::stable_sort(forces.begin(), forces.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<int> nodes;
  nodes.reserve(forces.size());
  for (const auto& [force, node] : forces) nodes.push_back(node);
  return nodes;
}

/// Adds finer patches around the strongest forces found so far, since the size of a place on which a force
/// acts is not known. Each time half as large, as long as they are wider than a few deviations of the cloud:
/// a more precise cloud can tell smaller places apart.
void ForceFitter::refine_patches(double sigma) {
  const ContactForceOptions& o = problem_.options;
  const Points& rest = problem_.model.mesh.vertices;
  std::vector<Eigen::RowVector3d> places;
  for (const int node : strongest_) {
    if (places.size() == kRefined) break;
    if (std::none_of(places.begin(), places.end(), [&](const Eigen::RowVector3d& place) {
          return (place - rest.row(node)).norm() < 0.5 * o.patch_spacing;
        }))
      places.emplace_back(rest.row(node));
  }
  Points around(static_cast<Eigen::Index>(places.size()), 3);
  for (std::size_t k = 0; k < places.size(); ++k) around.row(static_cast<Eigen::Index>(k)) = places[k];
  if (places.empty()) return;
  for (double scale = 0.5; scale * o.patch_radius > 0.99 * kRadiusPerSigma * sigma; scale *= 0.5) {
    const auto finer = problem_.force_surface.patches(
        around, {scale * o.patch_spacing, scale * o.patch_radius, 2.0 * scale * o.patch_spacing});
    now_.patches.insert(now_.patches.end(), finer.begin(), finer.end());
  }
}

bool ForceFitter::choose_patches(const ForceRows& rows, double sigma, const RunContext& context) {
  Points seen = Points::Zero(rows.surface_count, 3);  // where the model's points are in the CT
  for (Eigen::Index i = 0; i < rows.surface_count; ++i) {
    const Carrier& carrier = rows.carriers[static_cast<std::size_t>(i)];
    for (std::size_t k = 0; k < 4; ++k)
      if (carrier.nodes[k] >= 0)
        seen.row(i) += carrier.weights[k] * problem_.model.mesh.vertices.row(carrier.nodes[k]);
  }
  const ContactForceOptions& o = problem_.options;
  now_.patches = problem_.force_surface.patches(seen, {o.patch_spacing, o.patch_radius, o.patch_reach});
  refine_patches(sigma);
  responses_ = unit_forces(now_.patches, body_.node_count());
  constexpr Eigen::Index kAtOnce = 96;  // some 50 ms on 3000 nodes
  for (Eigen::Index first = 0; first < responses_.cols(); first += kAtOnce) {
    if (context.cancelled()) return false;
    auto some = responses_.middleCols(first, std::min(kAtOnce, responses_.cols() - first));
    fem::NodalColumns solved = some;
    body_.solve(solved);
    some = solved;
  }
  return true;
}

Eigen::Index ForceFitter::pose_columns() const {
  return problem_.free_pose ? 6L * problem_.cloud.cloud.look_count() : 0;
}

/// How each gap changes with each unknown, a column each: forces on the patches, amplitudes of the modes,
/// then (where the pose is free) a twist of the model and of each further look. A look's counts the other
/// way: it moves the cloud.
Eigen::MatrixXd ForceFitter::design(const ForceRows& rows) const {
  const Eigen::Index columns = responses_.cols(), modes = now_.modes.size();
  Eigen::MatrixXd a(rows.size(), columns + modes + pose_columns());
  a.rightCols(pose_columns()).setZero();
  a.leftCols(columns) = rows.along(responses_);
  if (modes > 0) a.middleCols(columns, modes) = rows.along(problem_.modes);
  if (problem_.free_pose)
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      const Eigen::Vector3d n = rows.directions.row(i).transpose();
      Eigen::Matrix<double, 1, 6> twist;
      twist << (rows.points.row(i).transpose() - centre_).cross(n).transpose(), n.transpose();
      a.row(i).segment<6>(columns + modes) = twist;
      if (const int look = rows.seen_in[static_cast<std::size_t>(i)]; look > 0)
        a.row(i).segment<6>(columns + modes + 6L * look) = -twist;
    }
  return a;
}

Eigen::VectorXd ForceFitter::fixed_variances() const {
  Eigen::VectorXd variances = Eigen::VectorXd::Ones(now_.modes.size() + pose_columns());
  for (Eigen::Index at = now_.modes.size(); at < variances.size(); at += 6)
    variances.segment<6>(at) << Eigen::Vector3d::Constant(kPoseTurn * kPoseTurn),
        Eigen::Vector3d::Constant(kPoseTranslation * kPoseTranslation);
  return variances;
}

/// @param twist of the model about its centre: a rotation vector, a translation.
void ForceFitter::turn_pose(const Eigen::VectorXd& twist) {
  now_.pose = now_.pose * twist_about(centre_, twist);
  now_.pose.rotation = Eigen::Quaterniond(now_.pose.rotation).normalized().toRotationMatrix();
}

/// @param twist of the look about the model's centre, CT frame.
void ForceFitter::turn_look(std::size_t look, const Eigen::VectorXd& twist) {
  auto& motion = now_.looks[look];
  motion = now_.pose * twist_about(centre_, twist) * now_.pose.inverse() * motion;
  motion.rotation = Eigen::Quaterniond(motion.rotation).normalized().toRotationMatrix();
}

/// Moves the body to the equilibrium of the forces found, the modes and the pose; shorter where the energy
/// less the forces' work would rise. @return the largest motion of a node.
double ForceFitter::step(const EvidencePosterior& found, const Points& relax) {
  const Eigen::Index columns = responses_.cols(), modes = now_.modes.size();
  Points forces = Points::Zero(body_.node_count(), 3);
  for (std::size_t j = 0; j < now_.patches.size(); ++j)
    for (const auto& [node, weight] : now_.patches[j].weights)
      forces.row(node) += weight * found.mean.segment<3>(3 * static_cast<Eigen::Index>(j)).transpose();
  Points change(body_.node_count(), 3);
  Eigen::Map<Eigen::VectorXd>(change.data(), change.size()).noalias() = responses_ * found.mean.head(columns);
  change -= relax;
  const Eigen::VectorXd mode_change = found.mean.segment(columns, modes) - now_.modes;
  Points together = change;
  if (modes > 0) together += shape(mode_change) - problem_.model.mesh.vertices;
  const double largest = together.cwiseAbs().maxCoeff();
  double share = std::min(1.0, problem_.options.max_step / std::max(largest, 1e-12));
  const Points moved = now_.x - body_.rest();
  Points next;
  for (int halving = 0; halving < kHalvings; ++halving) {
    if (halving > 0) share *= 0.5;
    if (modes > 0) body_.set_rest(shape(now_.modes + share * mode_change));
    const double merit = energy(body_.rest() + moved, nullptr) - forces.cwiseProduct(moved).sum();
    const Points further = moved + share * change;
    next = body_.rest() + further;
    if (energy(next, nullptr) - forces.cwiseProduct(further).sum() <= merit + 1e-9 * std::abs(merit)) break;
  }
  now_.x = next;
  now_.modes += share * mode_change;
  if (problem_.free_pose) {
    for (std::size_t look = 1; look < now_.looks.size(); ++look)
      turn_look(look, share * found.mean.segment<6>(columns + modes + 6 * static_cast<Eigen::Index>(look)));
    turn_pose(share * found.mean.segment<6>(columns + modes));
  }
  now_.amplitudes = found.mean.head(columns);
  return share * largest;
}

/// The stage is the most probable so far: notes what is told of it.
void ForceFitter::keep(const EvidencePosterior& found) {
  const Eigen::Index columns = responses_.cols();
  now_.deviations = found.root.rowwise().norm();
  // Columns without a variance add nothing.
  std::vector<Eigen::Index> active;
  for (Eigen::Index k = 0; k < columns; ++k)
    if (now_.deviations[k] > 0.0) active.push_back(k);
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(responses_.rows(), found.root.cols());
  if (!active.empty()) spread = responses_(Eigen::all, active) * found.root(active, Eigen::all);
  const Eigen::Index modes = now_.modes.size();
  if (modes > 0) spread += problem_.modes * found.root.middleRows(columns, modes);
  now_.expected_error.resize(body_.node_count());
  for (Eigen::Index i = 0; i < now_.expected_error.size(); ++i) {
    Eigen::MatrixXd of_node = spread.middleRows<3>(3 * i);
    if (problem_.free_pose) {
      const Eigen::Vector3d arm = now_.x.row(i).transpose() - centre_;
      for (Eigen::Index k = 0; k < of_node.cols(); ++k) {
        const Eigen::Matrix<double, 6, 1> twist = found.root.col(k).segment<6>(columns + modes);
        of_node.col(k) += Eigen::Vector3d(twist.head<3>()).cross(arm) + twist.tail<3>();
      }
    }
    now_.expected_error[i] = of_node.norm();
  }
  now_.inverted = body_.inverted(now_.x);
  best_ = now_;
}

bool ForceFitter::stage(double sigma, const RunContext& context) {
  const double nothing = -std::numeric_limits<double>::infinity();
  now_.law.sigma = sigma;
  now_.law.log_evidence = nothing;
  // The linear law's factor is the same wherever the body is, not whatever its rest shape.
  if (!factorised_ || body_.material().law != fem::BodyLaw::linear || now_.modes.size() > 0)
    factorised_ = body_.factorise(now_.x, springs_);
  if (!factorised_) return true;
  EvidencePosterior found;
  double motion = 0.0, before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < problem_.options.iterations; ++iteration) {
    const ForceRows rows = pair(sigma);
    if (context.cancelled()) return false;
    if (iteration == 0 && !choose_patches(rows, sigma, context)) return false;
    if (now_.patches.empty() || rows.size() == 0) return true;
    Points gradient;
    energy(now_.x, &gradient);
    const Points relax = body_.solve(gradient);
    // Forces and modes are found anew, not their changes: what they do now comes back into the gaps.
    const Eigen::Index columns = responses_.cols(), modes = now_.modes.size();
    const Eigen::MatrixXd a = design(rows);
    const Eigen::VectorXd y =
        rows.gap + rows.along(Eigen::Map<const fem::NodalColumns>(relax.data(), relax.size(), 1)).col(0) +
        a.middleCols(columns, modes) * now_.modes;
    const auto groups = static_cast<int>(now_.patches.size());
    if (iteration == 0) variances_.setConstant(groups, y.squaredNorm() / a.leftCols(columns).squaredNorm());
    const EvidenceProblem problem(a, y, rows.sigma, groups, 3, fixed_variances());
    const EvidenceProblem forces_alone = problem.of_groups();
    variances_ = maximise_evidence(forces_alone, variances_, iteration == 0 ? kFirstUpdates : kUpdates, kGone,
                                   context);
    const double price = problem_.options.patch_price * std::log(static_cast<double>(groups));
    if (price > 0.0) variances_ = keep_worth(forces_alone, variances_, price, context);
    if (context.cancelled()) return false;
    found = posterior(problem, variances_);
    const auto acting = static_cast<double>((variances_.array() > 0.0).count());
    now_.law.log_evidence = found.log_evidence - price * acting;
    now_.law.residual = rows.gap.head(rows.surface_count).cwiseAbs().mean();
    now_.outlier_share = rows.outlier_share;
    before = iteration > 0 ? motion : before;
    motion = step(found, relax);
    ++iterations_;
    if (!std::isfinite(motion) || !std::isfinite(found.log_evidence)) {
      now_.law.log_evidence = nothing;
      return true;
    }
    if (motion < kAtRest) break;
  }
  if (problem_.options.prior)
    now_.law.log_evidence -= 0.5 * unmarked_cost(problem_.model, onto_model(), surface_,
                                                 problem_.options.information.value_or(1.0));
  strongest_ = strongest(now_);
  now_.law.termination = motion < sigma    ? Termination::converged
                         : motion < before ? Termination::step_limit
                                           : Termination::stalled;
  if (now_.law.log_evidence > best_.law.log_evidence) keep(found);
  return true;
}

bool ForceFitter::run(const RunContext& context, const std::function<void()>& advance) {
  const double least = problem_.told_noise;
  double last = 0.0;
  for (const double of_stage : problem_.options.sigmas) {
    const double sigma = std::max(of_stage, least);
    if (sigma > 1.01 * std::max(first_sigma_, least) || (sigma == least && last == least)) continue;
    last = sigma;
    if (!stage(sigma, context)) return false;
    advance();
    // Once sigma is below the noise, the evidence only falls. At a large sigma a single stage may have
    // failed.
    if (sigma < kNoiseAtMost && now_.law.log_evidence < best_.law.log_evidence) break;
  }
  return settle(context);
}

/// Repeats the most probable stage while it is still moving and becomes more probable. Not with a prior of
/// operations: there the last motion follows what the model does not know, not the cloud.
bool ForceFitter::settle(const RunContext& context) {
  if (problem_.options.prior) return true;
  for (int round = 0; round < kSettling && best_.law.termination != Termination::converged; ++round) {
    const double before = best_.law.log_evidence;
    if (!std::isfinite(before)) return true;
    now_ = best_;
    strongest_ = strongest(best_);
    if (!stage(best_.law.sigma, context)) return false;
    if (!(best_.law.log_evidence > before)) return true;
  }
  return true;
}

ContactForceFit ForceFitter::result() const {
  ContactForceFit fit;
  fit.camera_from_ct = best_.pose;
  fit.nodes_in_camera = best_.pose.apply(best_.x);
  fit.patches = static_cast<int>(best_.patches.size());
  double strongest = 0.0;
  for (Eigen::Index at = 0; at < best_.amplitudes.size(); at += 3)
    strongest = std::max(strongest, best_.amplitudes.segment<3>(at).norm());
  for (std::size_t j = 0; j < best_.patches.size(); ++j) {
    const auto at = 3 * static_cast<Eigen::Index>(j);
    const Eigen::Vector3d force = best_.amplitudes.segment<3>(at);
    if (force.norm() > kActs * strongest)
      fit.forces.push_back(
          {best_.patches[j].node, force, best_.deviations.segment<3>(at).norm() / std::sqrt(3.0)});
  }
  std::sort(fit.forces.begin(), fit.forces.end(), [](const ContactForce& a, const ContactForce& b) {
    return a.force.squaredNorm() > b.force.squaredNorm();
  });
  fit.expected_error = best_.expected_error;
  fit.residual = best_.law.residual;
  fit.amplitudes = best_.modes;
  fit.looks = best_.looks;
  fit.outlier_share = best_.outlier_share;
  fit.inverted = best_.inverted;
  fit.torn = torn_share(problem_.model.mesh, shape(best_.modes), best_.x);
  fit.iterations = iterations_;
  fit.termination = best_.law.termination;
  return fit;
}

}  // namespace glisson::registration
