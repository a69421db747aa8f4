// SPDX-License-Identifier: GPL-3.0-or-later
#include "rendered_pair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>

namespace rendered {

Surface plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  return [=](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    return (point - o).dot(normal) / d.dot(normal);
  };
}

Surface sphere(const Eigen::Vector3d& centre, double radius) {
  return [=](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    const Eigen::Vector3d m = o - centre;
    const double a = d.squaredNorm(), b = m.dot(d), c = m.squaredNorm() - radius * radius;
    const double root = b * b - a * c;
    return root < 0.0 ? 0.0 : (-b - std::sqrt(root)) / a;
  };
}

Surface both(const Surface& one, const Surface& other) {
  return [=](const Eigen::Vector3d& o, const Eigen::Vector3d& d) {
    const double a = one(o, d), b = other(o, d);
    return a <= 0.0 ? b : b <= 0.0 ? a : std::min(a, b);
  };
}

glisson::StereoRig rig() {
  glisson::StereoRig result;
  result.left.width = result.right.width = 640;
  result.left.height = result.right.height = 480;
  result.left.matrix << 700.0, 0, 322.0, 0, 702.0, 243.0, 0, 0, 1;
  result.right.matrix << 705.0, 0, 331.0, 0, 704.0, 238.0, 0, 0, 1;
  result.left.distortion << -0.22, 0.12, 0.001, -0.0015, 0.01;
  result.right.distortion << -0.20, 0.10, -0.001, 0.001, 0.0;
  result.right_from_left.rotation = (Eigen::AngleAxisd(0.012, Eigen::Vector3d::UnitY()) *
                                     Eigen::AngleAxisd(0.008, Eigen::Vector3d::UnitZ()))
                                        .toRotationMatrix();
  result.right_from_left.translation << -0.005, 0.0001, 0.0002;
  return result;
}

double noise(const Eigen::Vector3d& p) {
  const auto hash = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    auto h = static_cast<std::uint64_t>(x * 73856093 ^ y * 19349663 ^ z * 83492791);
    h = (h ^ (h >> 31)) * 0x9E3779B97F4A7C15ULL;
    h = (h ^ (h >> 29)) * 0xBF58476D1CE4E5B9ULL;
    return static_cast<double>(h >> 40) / static_cast<double>(1 << 23) - 1.0;
  };
  const Eigen::Vector3d base = p.array().floor();
  const Eigen::Vector3d f = p - base;
  const Eigen::Vector3d s = f.array().square() * (3.0 - 2.0 * f.array());
  double value = 0.0;
  for (int k = 0; k < 8; ++k) {
    const double w = (k & 1 ? s.x() : 1 - s.x()) * (k & 2 ? s.y() : 1 - s.y()) * (k & 4 ? s.z() : 1 - s.z());
    value += w * hash(static_cast<std::int64_t>(base.x()) + (k & 1),
                      static_cast<std::int64_t>(base.y()) + (k & 2) / 2,
                      static_cast<std::int64_t>(base.z()) + (k & 4) / 4);
  }
  return value;
}

glisson::Picture render(const glisson::StereoRig& rig, bool is_left, const Surface& surface, const Look& look,
                        std::vector<float>* depth) {
  const glisson::Camera& camera = is_left ? rig.left : rig.right;
  const Eigen::Matrix3d to_left =
      is_left ? Eigen::Matrix3d::Identity() : Eigen::Matrix3d(rig.right_from_left.rotation.transpose());
  const Eigen::Vector3d origin =
      is_left ? Eigen::Vector3d::Zero() : Eigen::Vector3d(-(to_left * rig.right_from_left.translation));
  std::mt19937 random(is_left ? 21 : 22);  // NOLINT: the same picture on every run
  std::normal_distribution<double> sensor(0.0, look.sensor);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  constexpr int kSamples = 2;
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      double grey = 0.0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const double sx = x + (k % kSamples + 0.5) / kSamples - 0.5;
        const double sy = y + (k / kSamples + 0.5) / kSamples - 0.5;
        const Eigen::Vector3d direction = to_left * camera.ray({sx, sy});
        const double t = surface(origin, direction);
        if (t <= 0.0) continue;
        const Eigen::Vector3d p = (origin + t * direction) / look.grain;
        const double texture = noise(p) + 0.6 * noise(2.1 * p) + 0.4 * noise(0.4 * p);
        // The lamp sits between the cameras; the right camera is a little darker.
        const double light =
            1.1 - 0.5 * (x - 0.5 * camera.width) * (x - 0.5 * camera.width) / (camera.width * camera.width);
        grey += light * (is_left ? 1.0 : 0.93) * (110.0 + look.contrast * texture) / (kSamples * kSamples);
      }
      for (const double tint : {0.55, 0.6, 1.0})
        bytes->push_back(static_cast<std::uint8_t>(std::clamp(tint * grey + sensor(random), 0.0, 255.0)));
      if (depth != nullptr) {
        const Eigen::Vector3d ray = camera.ray({static_cast<double>(x), static_cast<double>(y)});
        depth->push_back(static_cast<float>(std::max(0.0, surface(origin, ray))));
      }
    }
  return {camera.width, camera.height, 3, std::move(bytes)};
}

Pair pair(const Surface& surface, const Look& look) {
  Pair result;
  result.rig = rig();
  result.left = render(result.rig, true, surface, look, &result.depth);
  result.right = render(result.rig, false, surface, look, nullptr);
  return result;
}

}  // namespace rendered
