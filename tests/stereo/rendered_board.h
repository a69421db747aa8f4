// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <random>
#include <vector>

#include "glisson/geometry/camera.h"
#include "glisson/patient/picture.h"
#include "glisson/stereo/board.h"

/// Calibration boards before a rig of known truth: their corners, and pictures of them.
namespace rendered {

/// Where the board is: camera_from_board, metres.
struct BoardPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// The board's middle at `middle`, turned about the axes of the view, radians.
BoardPose board_at(const glisson::stereo::Board& board, const Eigen::Vector3d& middle, double about_x,
                   double about_y, double about_z = 0.0);

/// A dozen of slants and places.
std::vector<BoardPose> board_poses(const glisson::stereo::Board& board, double distance);

/// The exact corners of a view, with Gaussian noise.
glisson::stereo::BoardView board_view(const glisson::StereoRig& rig, const glisson::stereo::Board& board,
                                      const BoardPose& pose, double noise_px, std::mt19937& random);

/// Brightness in [0, 1] of the board's plane at (x, y), metres from corner 0.
using BoardInk = std::function<double(double x, double y)>;

BoardInk chessboard_ink(const glisson::stereo::Board& board);

/// What a camera sees of it, 4 x 4 samples a pixel.
glisson::Picture board_picture(const glisson::StereoRig& rig, bool left, const BoardPose& pose,
                               const BoardInk& ink);

}  // namespace rendered
