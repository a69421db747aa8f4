// SPDX-License-Identifier: GPL-3.0-or-later
#include "held_out.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "picture_view.h"

namespace glisson::guidance {
namespace {

/// Seconds that a mask may ever be old (network/mask_sheet.h). And frames, for a source that tells no time.
constexpr double kOldest = 10.0;
constexpr std::size_t kRemembered = 2000;
constexpr std::size_t kMostIds = 20000;  ///< minutes of points; later points have higher ids
constexpr double kRelief = 0.8;          ///< of the limit: below it the reason goes

}  // namespace

void HeldOut::take(const std::shared_ptr<const PictureMask>& mask, double now, const TriangleMesh& surface) {
  const bool fits = mask && !mask->not_liver.empty() && mask->not_liver.width == camera_.width &&
                    mask->not_liver.height == camera_.height;
  if (!fits) {
    mask_.reset();
    widened_ = {};
    use_.reset();
    most_masked_.set(false);
    return;
  }
  if (mask != mask_) {
    mask_ = mask;
    cv::Mat wide;
    const cv::Size side(2 * margin_ + 1, 2 * margin_ + 1);
    cv::dilate(grey_of(mask->not_liver), wide, cv::getStructuringElement(cv::MORPH_RECT, side));
    widened_ = {wide.cols, wide.rows, 1,
                std::make_shared<std::vector<std::uint8_t>>(wide.datastart, wide.dataend)};
    use_ = MaskUse{share_of(surface)};
    most_masked_.push(use_->share, most_, kRelief * most_);
  }
  use_->age = now - mask_->seconds;
  use_->held_out = 0;
}

void HeldOut::remember(int index, double seconds, const std::vector<FollowedPoint>& points) {
  if (places_.empty() || places_.back().index != index) places_.push_back({index, seconds, {}});
  for (const FollowedPoint& point : points) places_.back().points.emplace(point.id, point.left);
  const auto is_old = [&] { return places_.front().seconds < seconds - kOldest; };
  while (places_.size() > kRemembered || (places_.size() > 1 && is_old())) places_.pop_front();
}

std::vector<char> HeldOut::free(const std::vector<FollowedPoint>& points) {
  never_liver_.clear();
  std::vector<char> result(points.size(), 1);
  if (!mask_) return result;
  // The newest of that number: a live source counts anew, the registered frame has one of its own.
  const auto frame = std::find_if(places_.rbegin(), places_.rend(),
                                  [this](const Places& one) { return one.index == mask_->index; });
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int id = points[i].id;
    Eigen::Vector2d at = points[i].left;
    bool was_there = false;
    if (frame != places_.rend())
      if (const auto then = frame->points.find(id); then != frame->points.end()) {
        at = then->second;
        was_there = true;
      }
    result[i] = !is_masked(widened_, at);
    if (result[i] != 0 && was_there) liver_.insert(id);
    if (result[i] == 0 && was_there && !liver_.contains(id)) never_liver_.push_back(id);
    use_->held_out += result[i] == 0;
  }
  while (liver_.size() > kMostIds) liver_.erase(liver_.begin());
  return result;
}

bool HeldOut::is_free(const Eigen::Vector2d& left) const { return !mask_ || !is_masked(widened_, left); }

bool HeldOut::is_masked(const Picture& mask, const Eigen::Vector2d& left) const {
  if (!camera_.sees(left)) return false;
  const long column = std::clamp(std::lround(left.x()), 0L, static_cast<long>(camera_.width) - 1);
  const long row = std::clamp(std::lround(left.y()), 0L, static_cast<long>(camera_.height) - 1);
  return (*mask.bytes)[static_cast<std::size_t>(row * camera_.width + column)] != 0;
}

double HeldOut::share_of(const TriangleMesh& surface) const {
  double all = 0.0, masked = 0.0;
  for (int t = 0; t < surface.triangle_count(); ++t) {
    const Eigen::Vector3d a = surface.vertex(surface.triangles(t, 0)),
                          b = surface.vertex(surface.triangles(t, 1)),
                          c = surface.vertex(surface.triangles(t, 2)), centre = (a + b + c) / 3.0,
                          normal = (b - a).cross(c - a);
    if (!(centre.z() > 0.0) || normal.dot(centre) >= 0.0) continue;
    const Eigen::Vector2d pixel = camera_.project(centre);
    if (!camera_.sees(pixel)) continue;
    const double area = 0.5 * normal.norm();
    all += area;
    if (is_masked(mask_->not_liver, pixel)) masked += area;
  }
  return all > 0.0 ? masked / all : 0.0;
}

}  // namespace glisson::guidance
