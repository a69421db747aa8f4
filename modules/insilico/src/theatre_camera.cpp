// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre_camera.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "glisson/core/error.h"
#include "glisson/core/random.h"
#include "glisson/core/statistics.h"
#include "glisson/insilico/ray_caster.h"
#include "tissue_noise.h"

namespace glisson::insilico {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// A small camera with the left one's field of view, to look around quickly.
Camera thumbnail(const Camera& camera) {
  constexpr int kWidth = 64;
  Camera small = camera;
  const double scale = static_cast<double>(kWidth) / camera.width;
  small.width = kWidth;
  small.height = std::max(1, static_cast<int>(std::lround(camera.height * scale)));
  small.matrix.topRows<2>() *= scale;
  return small;
}

struct View {
  CameraFromCt camera_from_ct;
  double score = -1.0;
};

class Scout {
 public:
  Scout(const TriangleMesh& liver, const Points& margin, const Points& notch, const StereoRig& rig)
      : liver_(liver), caster_(liver), margin_(margin), notch_(notch), total_(area(liver)) {
    StereoRig small = rig;
    small.left = thumbnail(rig.left);
    small.right = thumbnail(rig.right);
    camera_ = small.left;
    rays_ = left_rays(small);
  }

  /// Moves back or forth along the axis until the middle of what is seen is at `distance`.
  View look(CameraFromCt camera_from_ct, double distance) const {
    std::vector<double> depths;
    double seen_area = 0.0;
    for (int pass = 0; pass < 4; ++pass) {
      measure(camera_from_ct, depths, seen_area);
      if (depths.size() < rays_.directions.size() / 10) return {};
      const double miss = distance - upper_median(depths);
      camera_from_ct.translation.z() += miss;
      if (pass > 0 && std::abs(miss) < 1e-3) break;
    }
    measure(camera_from_ct, depths, seen_area);
    if (depths.empty()) return {};
    if (*std::min_element(depths.begin(), depths.end()) < 0.4 * distance) return {};
    const double covered = static_cast<double>(depths.size()) / static_cast<double>(rays_.directions.size());
    // A liver that fills the picture shows no outline: some background is wanted.
    const double frame_penalty = std::max(0.0, covered - 0.85);
    View view{camera_from_ct, seen_area / total_ + 0.5 * share_seen(camera_from_ct, margin_) +
                                  0.5 * share_seen(camera_from_ct, notch_) - 2.0 * frame_penalty};
    return view;
  }

 private:
  void measure(const CameraFromCt& camera_from_ct, std::vector<double>& depths, double& seen_area) const {
    const auto ct_from_camera = camera_from_ct.inverse();
    depths.clear();
    seen_area = 0.0;
    const Eigen::Vector3f origin = ct_from_camera.translation.cast<float>();
    const Eigen::Matrix3f turn = ct_from_camera.rotation.cast<float>();
    const double pixel = 1.0 / (camera_.matrix(0, 0) * camera_.matrix(1, 1));
    for (const Eigen::Vector3f& ray : rays_.directions) {
      const Eigen::Vector3f direction = turn * ray;
      const RayHit hit = caster_.cast(origin, direction);
      if (hit.thing != RayHit::Thing::organ) continue;
      depths.push_back(hit.parameter);
      const Eigen::Vector3d a = liver_.vertex(liver_.triangles(hit.triangle, 0));
      const Eigen::Vector3d n = (liver_.vertex(liver_.triangles(hit.triangle, 1)) - a)
                                    .cross(liver_.vertex(liver_.triangles(hit.triangle, 2)) - a)
                                    .normalized();
      const double cosine = -n.dot(direction.cast<double>());  // times the ray's length, as the area wants
      // What the gas lays bare counts most; the face behind is hidden by other organs in a patient.
      const double bare = n.y() < 0.0 ? 1.0 : 0.3;
      seen_area += bare * hit.parameter * hit.parameter * pixel / std::max(0.15, cosine);
    }
  }

  double share_seen(const CameraFromCt& camera_from_ct, const Points& points) const {
    if (points.rows() == 0) return 0.0;
    const Eigen::Vector3d eye = camera_from_ct.inverse().translation;
    int seen = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Eigen::Vector3d p = points.row(i).transpose();
      const Eigen::Vector3d q = camera_from_ct.rotation * p + camera_from_ct.translation;
      if (camera_.shows(q) && caster_.sees(eye, p, 3e-3)) ++seen;
    }
    return static_cast<double>(seen) / static_cast<double>(points.rows());
  }

  const TriangleMesh& liver_;
  RayCaster caster_;
  const Points &margin_, &notch_;
  double total_;
  Camera camera_;
  RayTable rays_;
};

}  // namespace

StereoRig make_rig(const TheatreOptions& options) {
  StereoRig rig;
  const double focal = 0.5 * options.width / std::tan(0.5 * options.horizontal_view_deg * kDegree);
  rig.left.width = rig.right.width = options.width;
  rig.left.height = rig.right.height = options.height;
  rig.left.matrix << focal, 0.0, 0.5 * (options.width - 1) + 0.008 * options.width, 0.0, 1.002 * focal,
      0.5 * (options.height - 1) - 0.006 * options.height, 0.0, 0.0, 1.0;
  rig.right.matrix << 1.004 * focal, 0.0, 0.5 * (options.width - 1) - 0.005 * options.width, 0.0,
      1.005 * focal, 0.5 * (options.height - 1) + 0.004 * options.height, 0.0, 0.0, 1.0;
  rig.left.distortion << -0.115, 0.032, 0.0006, -0.0004, 0.0;
  rig.right.distortion << -0.108, 0.027, -0.0005, 0.0007, 0.0;
  // The lenses look 1.2 degrees towards each other, and are not quite level.
  rig.right_from_left.rotation = (Eigen::AngleAxisd(1.2 * kDegree, Eigen::Vector3d::UnitY()) *
                                  Eigen::AngleAxisd(-0.25 * kDegree, Eigen::Vector3d::UnitX()) *
                                  Eigen::AngleAxisd(0.3 * kDegree, Eigen::Vector3d::UnitZ()))
                                     .toRotationMatrix();
  const Eigen::Vector3d right_centre =
      1e-3 * options.baseline_mm * Eigen::Vector3d(1.0, 0.01, -0.008).normalized();
  rig.right_from_left.translation = -(rig.right_from_left.rotation * right_centre);
  return rig;
}

CameraFromCt place_camera(const TriangleMesh& liver, const Points& margin, const Points& notch,
                          const StereoRig& rig, const TheatreOptions& options) {
  std::mt19937_64 random(options.seed * 104729 + 5);
  const auto uniform = [&] { return 2.0 * uniform01(random) - 1.0; };
  const double roll = 25.0 * kDegree * uniform();
  const Scout scout(liver, margin, notch, rig);
  const Eigen::Vector3d middle = centroid(liver);
  const Eigen::Vector3d goal =
      notch.rows() > 0 ? Eigen::Vector3d(notch.colwise().mean().transpose()) : middle;
  const double distance = 1e-3 * options.camera_distance_mm;
  View best;
  for (const double share : {0.0, 0.25, 0.5}) {  // of the way from the notch to the liver's middle
    const Eigen::Vector3d target = goal + share * (middle - goal);
    for (const double side_deg : {-35.0, -17.0, 0.0, 17.0, 35.0}) {
      for (const double rise_deg : {5.0, 22.0, 40.0, 55.0}) {
        const double side = side_deg * kDegree, rise = (rise_deg + 4.0 * uniform()) * kDegree;
        // From the front and below, towards the back and the head.
        const Eigen::Vector3d z =
            Eigen::Vector3d(std::sin(side), std::cos(side) * std::cos(rise), std::cos(side) * std::sin(rise))
                .normalized();
        const Eigen::Vector3d left = Eigen::Vector3d::UnitX() - z.x() * z;
        CameraFromCt camera_from_ct;
        camera_from_ct.rotation.row(0) = left.normalized().transpose();
        camera_from_ct.rotation.row(2) = z.transpose();
        camera_from_ct.rotation.row(1) = z.cross(left.normalized()).transpose();
        camera_from_ct.rotation =
            Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() * camera_from_ct.rotation;
        // Far away at first: look() comes nearer.
        camera_from_ct.translation = -(camera_from_ct.rotation * (target - 2.0 * distance * z));
        const View view = scout.look(camera_from_ct, distance);
        if (view.score > best.score) best = view;
      }
    }
  }
  if (best.score < 0.0)
    throw NumericalError(
        "the laparoscope finds no place from which it sees this liver; is the surface in the "
        "CT's frame (x left, y posterior, z superior), in metres?");
  return best.camera_from_ct;
}

Rigid<CameraFrame, CameraFrame> scope_motion(const ScopePath& path, double seconds) {
  const double eased =
      seconds < path.ease_s ? seconds * seconds / (2.0 * path.ease_s) : seconds - 0.5 * path.ease_s;
  const double phase = 2.0 * std::numbers::pi * eased / path.period_s;
  const Eigen::Vector3d trocar(0.0, 0.0, -1e-3 * path.trocar_mm);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(kDegree * path.pivot_deg * std::sin(phase), Eigen::Vector3d::UnitX()) *
       Eigen::AngleAxisd(0.5 * kDegree * path.pivot_deg * std::sin(phase / 1.3), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(kDegree * path.roll_deg * std::sin(phase / 1.7), Eigen::Vector3d::UnitZ()))
          .toRotationMatrix();
  // Where the camera is now, in its frame of the beginning.
  Rigid<CameraFrame, CameraFrame> moved;
  moved.rotation = turn;
  const double zoom = 1e-3 * path.zoom_mm * std::sin(2.0 * std::numbers::pi * eased / path.zoom_period_s);
  const double slide = 1e-3 * path.slide_mm * 0.5 * (1.0 - std::cos(phase / 1.3)) - zoom;
  moved.translation = trocar - turn * (trocar + Eigen::Vector3d(0.0, 0.0, slide));
  return moved.inverse();
}

TriangleMesh make_wall(const TriangleMesh& liver_in_camera, const StereoRig& rig, std::uint64_t seed) {
  const RayCaster caster(liver_in_camera);
  StereoRig small = rig;
  small.left = thumbnail(rig.left);
  const RayTable rays = left_rays(small);
  float farthest = 0.0F;
  for (const Eigen::Vector3f& ray : rays.directions) {
    const RayHit hit = caster.cast(rays.origin, ray);
    if (hit.thing == RayHit::Thing::organ) farthest = std::max(farthest, hit.parameter * ray.norm());
  }
  const double radius = farthest + 0.028;
  Lattice lattice;
  lattice.seed = static_cast<std::uint32_t>(seed * 2654435761U + 31U);
  const auto noise = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3f at = p.cast<float>();
    float value = 0.0F;
    gradient_noise(1, &at[0], &at[1], &at[2], lattice, &value);
    return static_cast<double>(value);
  };
  constexpr int kSteps = 96;
  constexpr double kHalfAngle = 62.0 * kDegree;
  TriangleMesh wall;
  wall.vertices.resize((kSteps + 1) * (kSteps + 1), 3);
  wall.triangles.resize(2 * kSteps * kSteps, 3);
  for (int j = 0; j <= kSteps; ++j) {
    for (int i = 0; i <= kSteps; ++i) {
      const double a = kHalfAngle * (2.0 * i / kSteps - 1.0), b = kHalfAngle * (2.0 * j / kSteps - 1.0);
      const Eigen::Vector3d ray = Eigen::Vector3d(std::tan(a), std::tan(b), 1.0).normalized();
      const Eigen::Vector3d at = ray * radius / 0.028;
      const double bumps = 0.010 * noise(at) + 0.004 * noise(2.3 * at);
      wall.vertices.row(j * (kSteps + 1) + i) = ((radius + bumps) * ray).transpose();
      if (i == kSteps || j == kSteps) continue;
      const int v = j * (kSteps + 1) + i, t = 2 * (j * kSteps + i);
      wall.triangles.row(t) << v, v + kSteps + 1, v + 1;  // faces the camera
      wall.triangles.row(t + 1) << v + 1, v + kSteps + 1, v + kSteps + 2;
    }
  }
  return wall;
}

}  // namespace glisson::insilico
