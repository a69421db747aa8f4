// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "glisson/patient/picture.h"

namespace glisson::stereo {

/// What is held before the laparoscope to calibrate it: a chessboard, or a ChArUco board (a chessboard with a
/// marker in every white square; it may be seen in part).
struct Board {
  int columns = 14, rows = 10;  ///< inner corners: squares less one, 3 to 50
  double square = 3e-3;         ///< side of a square, metres
  std::string dictionary;       ///< of the markers, OpenCV's name ("DICT_4X4_50"); empty: a chessboard
  double marker = 0.0;          ///< side of a marker, metres; ChArUco only, less than a square

  int corners() const { return columns * rows; }
  bool charuco() const { return !dictionary.empty(); }
  /// Corner `id` (row by row) in the board's own frame, metres, z = 0.
  Eigen::Vector3d corner(int id) const {
    const int row = id / columns;
    return {(id - row * columns) * square, row * square, 0.0};
  }
  /// @throws InputError naming what is out of range, or a dictionary that OpenCV does not know.
  void validate() const;
};

/// The corners found in one picture.
struct BoardCorners {
  std::vector<int> ids;                 ///< ascending; of a chessboard all
  std::vector<Eigen::Vector2d> pixels;  ///< of each

  int size() const { return static_cast<int>(ids.size()); }
};

/// Sector-based detector (Duda and Frese 2018) for chessboards: on the real pairs it lies 0.5 to 1 pixel from
/// the classic one and fits a camera better; markers and interpolation for ChArUco.
/// @return empty where the board is not seen whole (ChArUco: fewer than 6 corners). About 1 s at 1920x1080.
std::optional<BoardCorners> find_board(const Picture& picture, const Board& board);

/// One board before both cameras.
struct BoardView {
  std::string name;  ///< of the pair, for the report
  BoardCorners left, right;
};

/// Collects the views of a board from pairs of pictures, one after another.
class BoardViews {
 public:
  enum class Found { both, left_only, right_only, neither };

  /// @throws InputError the board.
  explicit BoardViews(const Board& board);
  /// A chessboard that is found turned by 180 degrees in the right picture (it has two first corners when
  /// columns and rows are both even) is turned to match the left one.
  /// @throws InputError pictures of another size than those before, or one picture twice.
  Found add(const std::string& name, const Picture& left, const Picture& right);
  /// A view whose corners were found elsewhere. @pre the same ids in both pictures, 6 or more, all on the
  /// board; one size of pictures.
  void add_corners(BoardView view, int width, int height);
  /// Keeps at most so many views, those that differ most in place, size and slant (of a video's many).
  void keep_most_different(int most);
  /// How many views it has left out.
  int too_alike() const { return too_alike_; }
  /// @throws InputError fewer than `least` views: no board, one of another size (which is said), or too few.
  void require(int least) const;

  const Board& board() const { return board_; }
  const std::vector<BoardView>& views() const { return views_; }
  int width() const { return width_; }
  int height() const { return height_; }
  int pairs() const { return pairs_; }  ///< that were looked at
  const std::vector<std::string>& not_found() const { return not_found_; }

 private:
  Board board_;
  std::vector<BoardView> views_;
  std::vector<std::string> not_found_;
  Picture without_;  ///< one in which no board was found
  int width_ = 0, height_ = 0, pairs_ = 0, too_alike_ = 0;
};

}  // namespace glisson::stereo
