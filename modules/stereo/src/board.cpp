// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/board.h"

#include <algorithm>
#include <cmath>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "glisson/core/error.h"
#include "picture_cv.h"
#include "size_text.h"

namespace glisson::stereo {
namespace {

constexpr int kFewestCharucoCorners = 6;

constexpr std::pair<const char*, int> kDictionaries[] = {
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
};

std::optional<int> dictionary_of(const std::string& name) {
  for (const auto& [known, code] : kDictionaries)
    if (name == known) return code;
  return std::nullopt;
}

std::optional<BoardCorners> find_chessboard(const cv::Mat& image, const Board& board) {
  // Equalising helps pictures of poor light and spoils some of good light: both are tried.
  for (const int flags : {cv::CALIB_CB_ACCURACY + 0,
                          cv::CALIB_CB_ACCURACY | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_EXHAUSTIVE}) {
    std::vector<cv::Point2f> found;
    if (!cv::findChessboardCornersSB(image, cv::Size(board.columns, board.rows), found, flags)) continue;
    BoardCorners corners;
    for (const cv::Point2f& p : found) {
      corners.ids.push_back(corners.size());
      corners.pixels.emplace_back(p.x, p.y);
    }
    return corners;
  }
  return std::nullopt;
}

/// Half the side of the window for a ChArUco board's corners: no marker may reach into it.
int window_of(const std::vector<cv::Point2f>& found, const std::vector<int>& ids, const Board& board) {
  double square = 0.0;  // the smallest seen, pixels
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t j = 0; j < ids.size(); ++j)
      if (ids[j] == ids[i] + 1 && ids[j] % board.columns != 0) {
        const double side = cv::norm(found[j] - found[i]);
        square = square > 0.0 ? std::min(square, side) : side;
      }
  return std::clamp(static_cast<int>(0.35 * square * (1.0 - board.marker / board.square)), 2, 8);
}

/// Whether corner `i` lies where its neighbours on the board put it: OpenCV's search sometimes slides along
/// an edge.
bool fits_neighbours(const BoardCorners& corners, std::size_t i, const Board& board) {
  constexpr double kFarthest = 1.5;  // pixels
  constexpr int kReach = 2;          // squares: so near, distortion is next to none
  constexpr std::size_t kFewest = 6;
  const int column = corners.ids[i] % board.columns, row = corners.ids[i] / board.columns;
  std::vector<cv::Point2d> from, to;
  for (std::size_t j = 0; j < corners.ids.size(); ++j) {
    const int across = corners.ids[j] % board.columns - column, down = corners.ids[j] / board.columns - row;
    if (j == i || std::abs(across) > kReach || std::abs(down) > kReach) continue;
    from.emplace_back(across, down);
    to.emplace_back(corners.pixels[j].x(), corners.pixels[j].y());
  }
  if (from.size() < kFewest) return false;
  const cv::Mat h = cv::findHomography(from, to, cv::LMEDS);
  if (h.empty()) return false;
  const Eigen::Vector2d expected(h.at<double>(0, 2) / h.at<double>(2, 2),
                                 h.at<double>(1, 2) / h.at<double>(2, 2));
  return (expected - corners.pixels[i]).norm() < kFarthest;
}

/// Corners made precise; ascending ids. What moves by more than two pixels, or lies at the picture's border,
/// is none.
BoardCorners refined(const cv::Mat& image, const std::vector<cv::Point2f>& found, const std::vector<int>& ids,
                     const Board& board) {
  constexpr double kFarthest = 2.0;
  const int window = window_of(found, ids, board);
  // OpenCV 4.6 leaves these corners half a pixel too far right and down (seen on an exact drawing).
  std::vector<cv::Point2f> start = found;
  for (cv::Point2f& p : start) p -= cv::Point2f(0.5F, 0.5F);
  std::vector<cv::Point2f> precise = start;
  cv::cornerSubPix(image, precise, cv::Size(window, window), cv::Size(-1, -1),
                   cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 0.01));
  std::vector<std::size_t> order(ids.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  BoardCorners corners;
  for (const std::size_t i : order) {
    const cv::Point2f p = precise[i];
    const auto inner = [&](float x, int size) { return x > window + 1.0F && x < size - window - 2.0F; };
    if (!inner(p.x, image.cols) || !inner(p.y, image.rows) || cv::norm(p - start[i]) > kFarthest) continue;
    corners.ids.push_back(ids[i]);
    corners.pixels.emplace_back(p.x, p.y);
  }
  BoardCorners kept;
  for (std::size_t i = 0; i < corners.ids.size(); ++i) {
    if (!fits_neighbours(corners, i, board)) continue;
    kept.ids.push_back(corners.ids[i]);
    kept.pixels.push_back(corners.pixels[i]);
  }
  return kept;
}

std::optional<BoardCorners> find_charuco(const cv::Mat& image, const Board& board) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(*dictionary_of(board.dictionary));
  const auto pattern =
      cv::aruco::CharucoBoard::create(board.columns + 1, board.rows + 1, static_cast<float>(board.square),
                                      static_cast<float>(board.marker), dictionary);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  std::vector<std::vector<cv::Point2f>> markers, rejected;
  std::vector<int> marker_ids, ids;
  cv::aruco::detectMarkers(image, dictionary, markers, marker_ids, parameters, rejected);
  if (marker_ids.empty()) return std::nullopt;
  std::vector<cv::Point2f> found;
  cv::aruco::interpolateCornersCharuco(markers, marker_ids, image, pattern, found, ids);
  if (static_cast<int>(ids.size()) < kFewestCharucoCorners) return std::nullopt;
  BoardCorners corners = refined(image, found, ids, board);
  if (corners.size() < kFewestCharucoCorners) return std::nullopt;
  return corners;
}

/// Turned by 180 degrees where that makes the rows run as in the other picture.
void turn_like(BoardCorners& corners, const BoardCorners& other) {
  const auto direction = [](const BoardCorners& c) {
    return Eigen::Vector2d(c.pixels.back() - c.pixels.front());
  };
  if (direction(corners).dot(direction(other)) < 0.0)
    std::reverse(corners.pixels.begin(), corners.pixels.end());
}

/// What both pictures show.
void keep_common(BoardCorners& a, BoardCorners& b) {
  BoardCorners x, y;
  for (std::size_t i = 0, j = 0; i < a.ids.size() && j < b.ids.size();) {
    if (a.ids[i] == b.ids[j]) {
      x.ids.push_back(a.ids[i]);
      x.pixels.push_back(a.pixels[i++]);
      y.ids.push_back(b.ids[j]);
      y.pixels.push_back(b.pixels[j++]);
    } else {
      a.ids[i] < b.ids[j] ? ++i : ++j;
    }
  }
  a = std::move(x);
  b = std::move(y);
}

/// Place, size and slant of a board, of the order of 1.
Eigen::Matrix<double, 6, 1> pose_of(const BoardView& view, int width) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : view.left.pixels) mean += p / view.left.size();
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d skew = Eigen::Vector2d::Zero();  // perspective makes the near side's corners lie wider
  for (const auto& p : view.left.pixels) {
    spread += (p - mean) * (p - mean).transpose() / view.left.size();
    skew += (p - mean) * (p - mean).norm() / view.left.size();
  }
  const double size = std::sqrt(spread.trace());
  Eigen::Matrix<double, 6, 1> pose;
  pose << mean / width, 2.0 * size / width, spread(0, 0) / (size * size), 10.0 * skew / (size * size);
  return pose;
}

/// Inner corners of the chessboard that the picture shows, whatever its size; empty: none is seen. What tells
/// a wrong `columns` or `rows` from a picture without a board.
std::optional<std::pair<int, int>> chessboard_size(const Picture& picture) {
  const cv::Mat image = grey(picture);
  std::optional<std::pair<int, int>> best;
  // From a few seeds: the detector sometimes grows only a part of the board.
  for (const int normalise : {0, cv::CALIB_CB_NORMALIZE_IMAGE + 0})
    for (const cv::Size seed : {cv::Size(4, 4), cv::Size(5, 4), cv::Size(7, 5)}) {
      cv::Mat found, meta;
      if (!cv::findChessboardCornersSB(image, seed, found,
                                       cv::CALIB_CB_LARGER | cv::CALIB_CB_EXHAUSTIVE | normalise, meta))
        continue;
      if (best && best->first * best->second >= meta.cols * meta.rows) continue;
      best = {std::max(meta.cols, meta.rows), std::min(meta.cols, meta.rows)};
    }
  return best;
}

}  // namespace

void Board::validate() const {
  const auto refuse = [](const char* field, const std::string& problem, const char* remedy) {
    throw InputError("board", field, problem, remedy);
  };
  if (columns < 3 || rows < 3 || columns > 50 || rows > 50)
    refuse("size", "is " + size_text(columns, rows), "Count the inner corners: from 3 to 50 a side");
  if (!(square > 0.0) || square > 0.2)
    refuse("square", "is " + std::to_string(1e3 * square) + " mm",
           "Measure the side of a square: up to 200 mm");
  if (!charuco()) return;
  if (!dictionary_of(dictionary))
    refuse("dictionary", "\"" + dictionary.substr(0, 40) + "\" is not known",
           "Give OpenCV's name, such as DICT_4X4_50");
  if (!(marker > 0.0) || marker >= square)
    refuse("marker", "is " + std::to_string(1e3 * marker) + " mm", "A marker is smaller than its square");
  const auto markers = cv::aruco::getPredefinedDictionary(*dictionary_of(dictionary))->bytesList.rows;
  if ((columns + 1) * (rows + 1) / 2 > markers)
    refuse("dictionary", dictionary + " has " + std::to_string(markers) + " markers, too few for this board",
           "Check the board's size and dictionary");
}

std::optional<BoardCorners> find_board(const Picture& picture, const Board& board) {
  board.validate();
  const cv::Mat image = grey(picture);
  return board.charuco() ? find_charuco(image, board) : find_chessboard(image, board);
}

BoardViews::BoardViews(const Board& board) : board_(board) { board_.validate(); }

BoardViews::Found BoardViews::add(const std::string& name, const Picture& left, const Picture& right) {
  if (left.empty() || right.empty())
    throw InputError(name, "", "has an empty picture", "Give the pictures of both cameras");
  if (pairs_ == 0) width_ = left.width, height_ = left.height;
  for (const Picture* picture : {&left, &right})
    if (picture->width != width_ || picture->height != height_)
      throw InputError(name, "size",
                       "is " + size_text(picture->width, picture->height) + " pixels, the others " +
                           size_text(width_, height_),
                       "Calibrate with pictures of one size, that of the operation");
  if (*left.bytes == *right.bytes)
    throw InputError(name, "", "holds one picture twice", "Give the picture of each camera");
  ++pairs_;
  auto in_left = find_board(left, board_), in_right = find_board(right, board_);
  if (in_left && in_right) {
    if (board_.charuco())
      keep_common(*in_left, *in_right);
    else
      turn_like(*in_right, *in_left);
    if (in_left->size() >= kFewestCharucoCorners) {
      views_.push_back({name, std::move(*in_left), std::move(*in_right)});
      return Found::both;
    }
  }
  not_found_.push_back(name);
  if (without_.empty()) without_ = in_left ? right : left;
  return in_left ? Found::left_only : in_right ? Found::right_only : Found::neither;
}

void BoardViews::add_corners(BoardView view, int width, int height) {
  glisson::require(width > 0 && height > 0 && (pairs_ == 0 || (width == width_ && height == height_)),
                   "the pictures of all views have one size");
  glisson::require(view.left.ids == view.right.ids && view.left.ids.size() == view.left.pixels.size() &&
                       view.right.ids.size() == view.right.pixels.size() &&
                       view.left.size() >= kFewestCharucoCorners,
                   "a view holds the same corners in both pictures");
  for (const int id : view.left.ids)
    glisson::require(id >= 0 && id < board_.corners(), "a corner lies on its board");
  width_ = width, height_ = height;
  ++pairs_;
  views_.push_back(std::move(view));
}

void BoardViews::keep_most_different(int most) {
  if (static_cast<int>(views_.size()) <= most) return;
  std::vector<Eigen::Matrix<double, 6, 1>> poses;
  for (const BoardView& view : views_) poses.push_back(pose_of(view, width_));
  // Farthest point first: each view taken is the one least like those taken before.
  std::vector<std::size_t> kept = {0};
  std::vector<double> distance(views_.size(), HUGE_VAL);
  while (static_cast<int>(kept.size()) < most) {
    for (std::size_t i = 0; i < views_.size(); ++i)
      distance[i] = std::min(distance[i], (poses[i] - poses[kept.back()]).norm());
    kept.push_back(
        static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin()));
  }
  std::sort(kept.begin(), kept.end());
  std::vector<BoardView> views;
  views.reserve(kept.size());
  for (const std::size_t i : kept) views.push_back(std::move(views_[i]));
  too_alike_ += static_cast<int>(views_.size() - views.size());
  views_ = std::move(views);
}

void BoardViews::require(int least) const {
  const int count = static_cast<int>(views_.size());
  if (count >= least) return;
  const std::string wanted = size_text(board_.columns, board_.rows);
  const std::pair<int, int> expected(std::max(board_.columns, board_.rows),
                                     std::min(board_.columns, board_.rows));
  std::pair<int, int> shown = expected;
  if (!without_.empty() && !board_.charuco()) shown = chessboard_size(without_).value_or(expected);
  if (shown != expected)
    throw InputError("board", "size",
                     "is seen as a board of " + size_text(shown.first, shown.second) + ", where " + wanted +
                         " inner corners are told",
                     "Count the corners where four squares meet, along each side");
  throw InputError("board", "",
                   std::to_string(count) + " of " + std::to_string(pairs_) + " pairs show a board of " +
                       wanted + " inner corners in both pictures, " + std::to_string(least) + " are needed",
                   board_.charuco()
                       ? "Check the board's size and dictionary, and take sharp pictures of it"
                       : "Take sharp pictures of the whole board, with a white border around it");
}

}  // namespace glisson::stereo
