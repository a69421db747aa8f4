// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_stage.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "glisson/core/random.h"
#include "glisson/geometry/distance.h"
#include "glisson/insilico/operator.h"
#include "glisson/patient/label_map.h"

namespace glisson::experiments {
namespace {

constexpr double kDeep = 0.010;      // m: a lesion below the surface
constexpr double kNoise = 1.0;       // mm, of a sound cloud
constexpr double kMuchNoise = 12.0;  // mm

/// Three nodes deep inside: the first drawn, each next the farthest from those before.
Points deep_places(const PatientModel& model, std::mt19937_64 random) {
  const std::vector<double> depth = distances_to_surface(model.mesh.vertices, model.surface.mesh);
  std::vector<int> deep;
  for (std::size_t i = 0; i < depth.size(); ++i)
    if (depth[i] > kDeep) deep.push_back(static_cast<int>(i));
  Points places(3, 3);
  if (deep.empty()) return Points(0, 3);
  places.row(0) = model.mesh.vertices.row(deep[static_cast<std::size_t>(random() % deep.size())]);
  for (int k = 1; k < 3; ++k) {
    double farthest = -1.0;
    for (const int i : deep) {
      const double away =
          (places.topRows(k).rowwise() - model.mesh.vertices.row(i)).rowwise().norm().minCoeff();
      if (away > farthest) farthest = away, places.row(k) = model.mesh.vertices.row(i);
    }
  }
  return places;
}

/// An octahedron of 8 mm across: too small for elements of its own.
TriangleMesh small_lesion(const Eigen::RowVector3d& centre) {
  constexpr double kRadius = 4e-3;
  TriangleMesh lesion;
  lesion.vertices.resize(6, 3);
  for (int k = 0; k < 3; ++k) {
    lesion.vertices.row(2 * k) = centre + kRadius * Eigen::RowVector3d::Unit(k);
    lesion.vertices.row(2 * k + 1) = centre - kRadius * Eigen::RowVector3d::Unit(k);
  }
  lesion.triangles.resize(8, 3);
  lesion.triangles << 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5;
  return lesion;
}

Landmarks clicked(const Landmarks& found, const Landmarks& truth, std::uint64_t seed) {
  insilico::OperatorOptions hand;
  hand.seed = seed;
  Landmarks landmarks = insilico::click_landmarks(truth, hand);
  landmarks.anterior_margin =
      found.anterior_margin.rows() > 1 ? found.anterior_margin : truth.anterior_margin;
  return landmarks;
}

/// A bent ellipsoid of the stomach's size before the camera: what faces it, next to the nearest point.
LabelledCloud stomach(int points, std::mt19937_64 random) {
  const Eigen::Vector3d axes(0.085, 0.050, 0.042), middle(0.01, -0.01, 0.17);
  const Eigen::Vector3d axis = standard_normal3(random);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(2.0 * std::numbers::pi * uniform01(random), axis.normalized()).toRotationMatrix();
  std::vector<Eigen::Vector3d> seen;
  while (static_cast<int>(seen.size()) < 3 * points) {
    const Eigen::Vector3d u = standard_normal3(random).normalized();
    Eigen::Vector3d p = axes.cwiseProduct(u);
    p.y() += 3.0 * p.x() * p.x();  // curved like a bean
    const Eigen::Vector3d normal = turn * u.cwiseQuotient(axes).normalized(), at = turn * p + middle;
    if (normal.dot(at) < -0.15 * at.norm()) seen.push_back(at);
  }
  const Eigen::Vector3d nearest = *std::min_element(
      seen.begin(), seen.end(),
      [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.squaredNorm() < b.squaredNorm(); });
  std::sort(seen.begin(), seen.end(), [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - nearest).squaredNorm() < (b - nearest).squaredNorm();
  });
  LabelledCloud cloud;
  cloud.points.resize(points, 3);
  for (int i = 0; i < points; ++i) {
    const Eigen::Vector3d noise = standard_normal3(random);
    cloud.points.row(i) = (seen[static_cast<std::size_t>(i)] + 1e-3 * kNoise * noise).transpose();
  }
  cloud.sigma.assign(static_cast<std::size_t>(points), 1e-3 * kNoise);
  return cloud;
}

/// What a camera sees of a liver.
insilico::PatchOptions seen(double share, double noise_mm, std::uint64_t seed) {
  insilico::PatchOptions options;
  options.share = share;
  options.seed = seed;
  options.noise_mm = noise_mm;
  options.outlier_share = 0.02;
  options.holes = 3;
  return options;
}

/// Nobody tells the cloud how noisy it is.
LabelledCloud without_known_noise(LabelledCloud cloud) {
  cloud.sigma.assign(cloud.sigma.size(), 1e-3 * kNoise);
  return cloud;
}

void mirror(LabelledCloud& cloud) { cloud.points.col(0) *= -1.0; }

/// As stereo sees it by a calibration whose cameras stand `factor` times too far apart.
void scale(LabelledCloud& cloud, double factor) { cloud.points *= factor; }

/// The margin is marked across the middle of the patch, the notch at its far end.
void mislabel(LabelledCloud& cloud) {
  const Eigen::RowVector3d middle = cloud.points.colwise().mean();
  const Points away = cloud.points.rowwise() - middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Eigen::Matrix3d(away.transpose() * away));
  const Eigen::VectorXd along = away * eigen.eigenvectors().col(2);
  Eigen::Index end = 0;
  along.maxCoeff(&end);
  for (int i = 0; i < cloud.size(); ++i) {
    Feature& feature = cloud.features[static_cast<std::size_t>(i)];
    feature = std::abs(along[i]) < 4e-3 ? Feature::anterior_margin : Feature::surface;
    if ((cloud.points.row(i) - cloud.points.row(end)).norm() < 8e-3) feature = Feature::umbilical_notch;
  }
}

/// Where the laparoscope is when it has gone round the organ's middle by 35 degrees: from its former camera's
/// frame into its present one. @param way radians in the picture. @param shift metres.
Rigid<CameraFrame, CameraFrame> gone_round(const RegistrationStage& stage, std::size_t handling, double way,
                                           double roll, const Eigen::Vector3d& shift) {
  constexpr double kTurn = 35.0 * std::numbers::pi / 180.0;
  const Eigen::Vector3d middle =
      stage.by(handling).carry(stage.model.mesh.vertices).colwise().mean().transpose();
  const Eigen::Vector3d across(std::cos(way), std::sin(way), 0.0);
  Rigid<CameraFrame, CameraFrame> scope;
  scope.rotation = (Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(kTurn, across))
                       .toRotationMatrix();
  scope.translation = middle - scope.rotation * middle + shift;
  return scope;
}

}  // namespace

bool is_much_tried(const std::string& handling) {
  return std::ranges::any_of(
      std::span(insilico::kHandlings).first(kMuchTriedHandlings),
      [&](insilico::Handling one) { return handling == insilico::handling_code(one); });
}

Cancellable<RegistrationStage> build_stage(const ProofPatient& patient, const std::filesystem::path& data,
                                           std::uint64_t seed, std::size_t handlings,
                                           const RunContext& context) {
  auto loaded = load(patient, data, context.part(0.0, 0.4));
  if (!loaded) return std::nullopt;
  RegistrationStage stage;
  stage.patient = patient;
  stage.model = std::move(loaded->model);
  double done = 0.4;
  const double step = 0.6 / static_cast<double>(handlings);
  for (const insilico::Handling handling : std::span(insilico::kHandlings).first(handlings)) {
    insilico::HandlingOptions options;
    options.seed = seed + 100 * (static_cast<std::uint64_t>(handling) + 1);
    options.handling = handling;
    auto handled = insilico::HandledLiver::build(loaded->shown, options, context.part(done, done + step));
    if (!handled) return std::nullopt;
    stage.handled.push_back(std::move(*handled));
    done += step;
  }
  stage.found = stage.model.landmarks;
  stage.model.landmarks = clicked(stage.found, stage.handled.front().landmarks(), seed);
  stage.lesions = deep_places(stage.model, context.random("prove.lesions"));
  // The model knows of them, so that it may doubt their places; beside those that the patient has.
  for (Eigen::Index i = 0; i < stage.lesions.rows(); ++i) {
    const Label label = RegistrationStage::lesion_label(i);
    stage.model.surfaces.push_back({label, structure_name(label), small_lesion(stage.lesions.row(i))});
  }
  return stage;
}

Cancellable<registration::ExaminedRegistration> StageRegistrar::run(
    const LabelledCloud& cloud, const registration::RegisterOptions& options) {
  auto examined = register_model(stage_.model, cloud, options, context_, known_);
  if (examined && examined->registered.operations)
    known_ = {options.operation, examined->registered.operations};
  return examined;
}

const char* registration_fault_code(RegistrationFault fault) {
  switch (fault) {
    case RegistrationFault::none:
      return "none";
    case RegistrationFault::noise:
      return "noise of 12 mm";
    case RegistrationFault::another_patient:
      return "another patient";
    case RegistrationFault::mirrored:
      return "mirrored";
    case RegistrationFault::foreign_organ:
      return "foreign organ";
    case RegistrationFault::wrong_labels:
      return "wrong labels";
    case RegistrationFault::wrong_start:
      return "wrong start";
    case RegistrationFault::larger:
      return "larger";
    case RegistrationFault::smaller:
      return "smaller";
  }
  return "unknown";
}

bool shows_the_organ(RegistrationFault fault) {
  return fault != RegistrationFault::another_patient && fault != RegistrationFault::mirrored &&
         fault != RegistrationFault::foreign_organ;
}

LabelledCloud faulty_cloud(const RegistrationStage& stage, const RegistrationStage& other,
                           std::size_t handling, double share, RegistrationFault fault, std::uint64_t seed) {
  const double noise_mm = fault == RegistrationFault::noise ? kMuchNoise : kNoise;
  const auto& shown = fault == RegistrationFault::another_patient ? other : stage;
  LabelledCloud cloud = shown.by(handling).patch(seen(share, noise_mm, seed)).cloud;
  if (fault == RegistrationFault::mirrored) mirror(cloud);
  if (fault == RegistrationFault::wrong_labels) mislabel(cloud);
  if (fault == RegistrationFault::larger) scale(cloud, 1.2);
  if (fault == RegistrationFault::smaller) scale(cloud, 1.0 / 1.2);
  if (fault == RegistrationFault::foreign_organ) return stomach(cloud.size(), std::mt19937_64(seed));
  return without_known_noise(std::move(cloud));
}

LabelledCloud look_from_elsewhere(const RegistrationStage& stage, std::size_t handling, double share,
                                  std::uint64_t seed) {
  constexpr double kRoll = 0.3, kShift = 15e-3;
  std::mt19937_64 random(seed);
  const double way = 2.0 * std::numbers::pi * uniform01(random), roll = kRoll * standard_normal(random);
  const Eigen::Vector3d shift = standard_normal3(random);
  return without_known_noise(
      stage.by(handling)
          .patch(seen(share, kNoise, seed), gone_round(stage, handling, way, roll, kShift * shift))
          .cloud);
}

ShownLiver shown_liver(const RegistrationStage& stage, std::size_t handling, double share,
                       std::uint64_t seed) {
  constexpr double kOneLook = 0.4;
  if (share <= kOneLook)
    return {faulty_cloud(stage, stage, handling, share, RegistrationFault::none, seed), {}};
  std::vector<Rigid<CameraFrame, CameraFrame>> scopes(1);
  for (int side = 0; side < 4; ++side)
    scopes.push_back(
        gone_round(stage, handling, 0.5 * std::numbers::pi * side, 0.0, Eigen::Vector3d::Zero()));
  ShownLiver shown;
  for (insilico::Patch& look : stage.by(handling).looks(seen(share, kNoise, seed), scopes)) {
    if (look.cloud.size() == 0) continue;
    LabelledCloud cloud = without_known_noise(std::move(look.cloud));
    if (shown.cloud.size() == 0)
      shown.cloud = std::move(cloud);
    else
      shown.others.push_back(std::move(cloud));
  }
  return shown;
}

CameraFromCt mistaken(const RegistrationStage& stage, std::size_t handling) {
  const CameraFromCt& truth = stage.by(handling).camera_from_ct();
  const Eigen::Vector3d middle = truth.apply(stage.model.mesh.vertices).colwise().mean().transpose();
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(40.0 * std::numbers::pi / 180.0, Eigen::Vector3d(0.4, 0.3, 0.866)).toRotationMatrix();
  CameraFromCt pose;
  pose.rotation = turn * truth.rotation;
  pose.translation = turn * (truth.translation - middle) + middle + Eigen::Vector3d(0.025, -0.020, 0.014);
  return pose;
}

}  // namespace glisson::experiments
