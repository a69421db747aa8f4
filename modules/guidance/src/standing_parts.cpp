// SPDX-License-Identifier: GPL-3.0-or-later
#include "standing_parts.h"

#include <algorithm>

#include "glisson/core/statistics.h"

namespace glisson::guidance {
namespace {

constexpr int kStep = 4;                        ///< pixels between the places that are looked at
constexpr int kDarkest = 12, kBrightest = 240;  ///< beyond them pictures are the same by themselves
constexpr double kPlain = 0.5;                  ///< share of places beyond them: the part tells nothing
constexpr double kSame = 0.99;                  ///< share of the others that must not have changed
constexpr double kSeconds = 0.3;
constexpr int kLeastFrames = 4;
constexpr int kBeside = 2;  ///< parts: what stands may end within the one that is next
constexpr int kLeastPoints = 2;
/// Metres since the part stands: tissue beside it moves, its own points do not.
constexpr double kMoves = 1e-3, kStands = 0.25e-3;

}  // namespace

std::size_t StandingParts::part_at(double x, double y, int width, int height) {
  const int column = std::clamp(static_cast<int>(kColumns * x / width), 0, kColumns - 1);
  const int row = std::clamp(static_cast<int>(kRows * y / height), 0, kRows - 1);
  return static_cast<std::size_t>(kColumns * row + column);
}

std::array<bool, StandingParts::kParts> StandingParts::same_parts(const Picture& picture, View& view) {
  const std::vector<std::uint8_t> before = std::move(view.grey);
  view.grey.clear();
  const int channel = picture.channels == 3 ? 1 : 0;
  for (int y = 0; y < picture.height; y += kStep)
    for (int x = 0; x < picture.width; x += kStep)
      view.grey.push_back(
          (*picture.bytes)[static_cast<std::size_t>((y * picture.width + x) * picture.channels + channel)]);
  std::array<bool, kParts> same{};
  if (before.size() != view.grey.size()) return same;
  std::array<int, kParts> all{}, told{}, equal{};
  std::size_t i = 0;
  for (int y = 0; y < picture.height; y += kStep)
    for (int x = 0; x < picture.width; x += kStep, ++i) {
      const std::size_t part = part_at(x, y, picture.width, picture.height);
      ++all[part];
      if (view.grey[i] <= kDarkest || view.grey[i] >= kBrightest) continue;
      ++told[part];
      equal[part] += view.grey[i] == before[i];
    }
  for (std::size_t part = 0; part < kParts; ++part)
    same[part] = told[part] > kPlain * all[part] && equal[part] >= kSame * told[part];
  return same;
}

void StandingParts::move_points(const std::vector<FollowedPoint>& points, bool is_left, View& view) const {
  const Camera& camera = is_left ? rig_.left : rig_.right;
  std::map<int, Eigen::Vector2d> now;
  std::array<std::vector<double>, kParts> right, down;
  for (const FollowedPoint& point : points) {
    const Eigen::Vector2d& pixel = is_left ? point.left : point.right;
    now[point.id] = pixel;
    const auto before = view.points.find(point.id);
    if (before == view.points.end()) continue;
    const Eigen::Vector2d way =
        point.p_in_camera.z() / camera.matrix(0, 0) * (pixel - before->second);  // metres
    const std::size_t part = part_at(pixel.x(), pixel.y(), camera.width, camera.height);
    right[part].push_back(way.x());
    down[part].push_back(way.y());
  }
  view.points = std::move(now);
  for (std::size_t part = 0; part < kParts; ++part) {
    view.followed[part] = static_cast<int>(right[part].size());
    if (view.followed[part] < kLeastPoints) continue;
    view.ways.col(static_cast<Eigen::Index>(part)) +=
        Eigen::Vector2d(upper_median(std::move(right[part])), upper_median(std::move(down[part])));
  }
}

bool StandingParts::moves_beside(const View& view, std::size_t part) {
  const auto moved = [&](std::size_t other) {
    const auto i = static_cast<Eigen::Index>(other);
    return (view.ways.col(i) - view.parts[part].then.col(i)).norm();
  };
  if (view.followed[part] < kLeastPoints || moved(part) > kStands) return false;
  const int column = static_cast<int>(part) % kColumns, row = static_cast<int>(part) / kColumns;
  for (int r = std::max(0, row - kBeside); r <= std::min(kRows - 1, row + kBeside); ++r)
    for (int c = std::max(0, column - kBeside); c <= std::min(kColumns - 1, column + kBeside); ++c) {
      const auto other = static_cast<std::size_t>(kColumns * r + c);
      if (view.followed[other] >= kLeastPoints && moved(other) > kMoves) return true;
    }
  return false;
}

bool StandingParts::look(const std::array<bool, kParts>& same, const FrameClock& clock, View& view) {
  bool any = false;
  for (std::size_t i = 0; i < kParts; ++i) {
    Part& part = view.parts[i];
    if (!same[i]) {
      part.frames = 0;
      part.is_told = false;
      continue;
    }
    if (part.frames == 0) {
      part.since = clock.now() - clock.passed();
      part.then = view.ways;
    }
    ++part.frames;
    if (part.frames >= kLeastFrames && clock.is_due(part.since, kSeconds))
      part.is_told = part.is_told || moves_beside(view, i);
    any = any || part.is_told;
  }
  return any;
}

void StandingParts::push(const StereoFrame& frame, const std::vector<FollowedPoint>& points,
                         const FrameClock& clock) {
  any_ = false;
  for (const bool is_left : {true, false}) {
    View& view = is_left ? left_ : right_;
    const auto same = same_parts(is_left ? frame.left : frame.right, view);
    move_points(points, is_left, view);
    any_ = look(same, clock, view) || any_;
  }
}

}  // namespace glisson::guidance
