// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "glisson/geometry/closest_point_tree.h"
#include "glisson/guidance/tracker.h"
#include "phantom.h"

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"

/// Pictures of the phantom by a ray caster of the test's own: a texture bound to the tissue, a light at the
/// camera.
namespace glisson::phantom {

/// A small stereo laparoscope with distortion, cameras not quite parallel.
inline StereoRig rig() {
  StereoRig rig;
  for (Camera* camera : {&rig.left, &rig.right}) {
    camera->width = 320;
    camera->height = 240;
    camera->matrix << 260.0, 0.0, 158.0, 0.0, 261.0, 121.0, 0.0, 0.0, 1.0;
    camera->distortion << -0.08, 0.02, 0.0, 0.0, 0.0;
  }
  rig.right_from_left.rotation = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitY()).toRotationMatrix();
  rig.right_from_left.translation = {-0.005, 0.0001, 0.0};
  return rig;
}

inline double hashed(int x, int y, int z) {
  auto h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U +
           static_cast<std::uint32_t>(z) * 2147483647U;
  h = (h ^ (h >> 13U)) * 1274126177U;
  return static_cast<double>((h ^ (h >> 16U)) & 0xffffU) / 65535.0;
}

/// Smooth random field of cells of unit size, in [0, 1].
inline double value_noise(const Eigen::Vector3d& p) {
  const Eigen::Vector3d low = p.array().floor();
  const Eigen::Vector3d f = p - low, s = f.array().square() * (3.0 - 2.0 * f.array());
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) {
    const int a = k & 1, b = (k >> 1) & 1, c = k >> 2;
    const double w = (a ? s.x() : 1.0 - s.x()) * (b ? s.y() : 1.0 - s.y()) * (c ? s.z() : 1.0 - s.z());
    sum += w * hashed(static_cast<int>(low.x()) + a, static_cast<int>(low.y()) + b,
                      static_cast<int>(low.z()) + c);
  }
  return sum;
}

/// A textured plane behind the organ. Its right part, beyond `torn_at` metres, may move by itself.
struct Wall {
  RigidMotion camera_from_wall;  ///< the left camera's
  double depth = 0.17, torn_at = 1.0;
  Eigen::Vector3d torn_by = Eigen::Vector3d::Zero();

  /// In [0, 1], along a ray from an eye in the left camera's frame.
  double texture(const Eigen::Vector3d& eye, const Eigen::Vector3d& ray) const {
    const RigidMotion back = camera_from_wall.inverse();
    const Eigen::Vector3d from = back.rotation * eye + back.translation, along = back.rotation * ray;
    Eigen::Vector3d hit = from + along * (depth - from.z()) / along.z();
    if (hit.x() > torn_at) hit -= torn_by;
    return 0.6 * value_noise(hit / 7e-3) + 0.4 * value_noise(hit / 3e-3);
  }
};

inline Picture film(const PatientModel& model, const Points& nodes, const Camera& camera,
                    const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation, unsigned seed,
                    const Wall* wall = nullptr) {
  TriangleMesh surface = model.surface.mesh;
  for (int i = 0; i < surface.vertex_count(); ++i)
    surface.vertices.row(i) =
        (rotation * nodes.row(model.surface.node_of_vertex[static_cast<std::size_t>(i)]).transpose() +
         translation)
            .transpose();
  const ClosestPointTree tree(surface);
  const Points normals = vertex_normals(surface);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.5);
  auto bytes =
      std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(camera.width * camera.height));
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d ray = camera.ray({static_cast<double>(x), static_cast<double>(y)});
      const ClosestPoint hit = tree.first_hit(Eigen::Vector3d::Zero(), ray);
      double grey = 20.0;
      if (hit.triangle >= 0) {
        Eigen::Vector3d material = Eigen::Vector3d::Zero(), n = material;
        for (int k = 0; k < 3; ++k) {
          const int v = model.surface.mesh.triangles(hit.triangle, k);
          material += hit.barycentric[k] * model.surface.mesh.vertex(v);
          n += hit.barycentric[k] * normals.row(v).transpose();
        }
        const double texture = 0.6 * value_noise(material / 4e-3) + 0.4 * value_noise(material / 1.8e-3);
        const double light = std::max(0.2, -n.normalized().dot(ray.normalized()));
        grey = light * (50.0 + 150.0 * texture);
      } else if (wall != nullptr) {
        grey = 30.0 + 100.0 * wall->texture(-rotation.transpose() * translation, rotation.transpose() * ray);
      }
      (*bytes)[static_cast<std::size_t>(y * camera.width + x)] =
          static_cast<std::uint8_t>(std::clamp(grey + noise(random), 0.0, 255.0));
    }
  return {camera.width, camera.height, 1, bytes};
}

/// @param nodes in the left camera's frame.
inline StereoFrame film(const PatientModel& model, const Points& nodes, const StereoRig& rig, int index,
                        const Wall* wall = nullptr) {
  StereoFrame frame;
  frame.left = film(model, nodes, rig.left, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                    static_cast<unsigned>(2 * index), wall);
  frame.right = film(model, nodes, rig.right, rig.right_from_left.rotation, rig.right_from_left.translation,
                     static_cast<unsigned>(2 * index + 1), wall);
  frame.index = index;
  frame.seconds = index / 30.0;
  return frame;
}

/// Breathing: down and towards the camera, the free side more.
inline Points breathed(const PatientModel& model, Points nodes, double share) {
  for (Eigen::Index i = 0; i < nodes.rows(); ++i)
    nodes.row(i) += share * (1.0 + 4.0 * model.mesh.vertices(i, 0)) * Eigen::RowVector3d(1e-3, 5e-3, -2e-3);
  return nodes;
}

/// A film of the phantom that breathes, over and over, its rim in sight.
struct BreathingFilm {
  static constexpr int kFrames = 16;

  BreathingFilm() {
    start.camera_from_ct = view();
    start.camera_from_ct.translation.y() -= 18e-3;  // the rim in sight
    start.nodes_in_camera = nodes = start.camera_from_ct.apply(model.mesh.vertices);
    for (int k = 0; k < kFrames; ++k) frames.push_back(film(model, truth(k), rig, k));
  }
  Points at(double share) const { return breathed(model, nodes, share); }
  Points truth(int k) const { return at(0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * k / kFrames)); }
  StereoFrame frame(int k) const {
    StereoFrame one = frames[static_cast<std::size_t>(k % kFrames)];
    one.index = k;
    one.seconds = k / 30.0;
    return one;
  }

  StereoRig rig = phantom::rig();
  PatientModel model = phantom::model(8, 6, 3);
  Points nodes;  ///< in frame 0, left camera's frame
  Registration start;
  std::vector<StereoFrame> frames;
};

/// For a body that nothing holds.
inline guidance::TrackerOptions free_body() {
  guidance::TrackerOptions options;
  options.points = 80;
  options.boundary_young_modulus = 0.0;
  return options;
}

inline Picture plain(const Camera& camera, std::uint8_t grey) {
  return {camera.width, camera.height, 1,
          std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(camera.width * camera.height),
                                                      grey)};
}

}  // namespace glisson::phantom
