// SPDX-License-Identifier: GPL-3.0-or-later
#include "rendered_board.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

namespace rendered {

BoardPose board_at(const glisson::stereo::Board& board, const Eigen::Vector3d& middle, double about_x,
                   double about_y, double about_z) {
  BoardPose pose;
  pose.rotation = (Eigen::AngleAxisd(about_x, Eigen::Vector3d::UnitX()) *
                   Eigen::AngleAxisd(about_y, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(about_z, Eigen::Vector3d::UnitZ()))
                      .toRotationMatrix();
  pose.translation = middle - pose.rotation *
                                  Eigen::Vector3d(0.5 * (board.columns - 1), 0.5 * (board.rows - 1), 0.0) *
                                  board.square;
  return pose;
}

std::vector<BoardPose> board_poses(const glisson::stereo::Board& board, double distance) {
  std::vector<BoardPose> poses;
  for (int i = 0; i < 12; ++i) {
    const double a = 2.0 * M_PI * i / 12.0;
    poses.push_back(board_at(board,
                             {0.12 * distance * std::cos(3.0 * a), 0.1 * distance * std::sin(2.0 * a),
                              distance * (1.0 + 0.15 * std::cos(5.0 * a))},
                             0.5 * std::sin(a), 0.5 * std::cos(a), 0.2 * std::sin(2.0 * a)));
  }
  return poses;
}

glisson::stereo::BoardView board_view(const glisson::StereoRig& rig, const glisson::stereo::Board& board,
                                      const BoardPose& pose, double noise_px, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, noise_px);
  glisson::stereo::BoardView view;
  for (int id = 0; id < board.corners(); ++id) {
    const Eigen::Vector3d p = pose.rotation * board.corner(id) + pose.translation;
    const Eigen::Vector3d q = (rig.right_from_left * glisson::Point<glisson::CameraFrame>(p)).xyz;
    view.left.ids.push_back(id);
    view.right.ids.push_back(id);
    view.left.pixels.push_back(rig.left.project(p) + Eigen::Vector2d{noise(random), noise(random)});
    view.right.pixels.push_back(rig.right.project(q) + Eigen::Vector2d{noise(random), noise(random)});
  }
  return view;
}

BoardInk chessboard_ink(const glisson::stereo::Board& board) {
  return [board](double x, double y) {
    const int column = static_cast<int>(std::floor(x / board.square)),
              row = static_cast<int>(std::floor(y / board.square));
    const bool outside = column < -1 || row < -1 || column >= board.columns || row >= board.rows;
    return outside || (column + row) % 2 != 0 ? 1.0 : 0.0;
  };
}

glisson::Picture board_picture(const glisson::StereoRig& rig, bool left, const BoardPose& pose,
                               const BoardInk& ink) {
  const glisson::Camera& camera = left ? rig.left : rig.right;
  Eigen::Matrix3d rotation = pose.rotation;
  Eigen::Vector3d translation = pose.translation;
  if (!left) {
    rotation = rig.right_from_left.rotation * pose.rotation;
    translation = rig.right_from_left.rotation * pose.translation + rig.right_from_left.translation;
  }
  const Eigen::Vector3d origin = -(rotation.transpose() * translation);
  std::mt19937 random(left ? 31 : 32);  // NOLINT: the same picture on every run
  std::normal_distribution<double> sensor(0.0, 2.0);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  constexpr int kSamples = 4;
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x) {
      // The ray varies slowly: once a pixel, linear within.
      const Eigen::Vector3d middle = rotation.transpose() * camera.ray({1.0 * x, 1.0 * y});
      const Eigen::Vector3d across = rotation.transpose() * Eigen::Vector3d(1.0 / camera.matrix(0, 0), 0, 0);
      const Eigen::Vector3d down = rotation.transpose() * Eigen::Vector3d(0, 1.0 / camera.matrix(1, 1), 0);
      double sum = 0.0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const double dx = (k % kSamples + 0.5) / kSamples - 0.5, dy = (k / kSamples + 0.5) / kSamples - 0.5;
        const Eigen::Vector3d direction = middle + dx * across + dy * down;
        const double t = -origin.z() / direction.z();
        sum += t > 0.0 ? ink(origin.x() + t * direction.x(), origin.y() + t * direction.y()) : 0.5;
      }
      bytes->push_back(static_cast<std::uint8_t>(
          std::clamp(40.0 + 170.0 * sum / (kSamples * kSamples) + sensor(random), 0.0, 255.0)));
    }
  return {camera.width, camera.height, 1, std::move(bytes)};
}

}  // namespace rendered
