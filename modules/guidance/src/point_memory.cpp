// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_memory.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace glisson::guidance {
namespace {

/// In followed frames, not seconds, because a followed point drifts by a little in every one. A point is
/// looked for in its first picture every kEvery of them; one that was not found in kLost is lost.
constexpr int kEvery = 6, kLost = 90;
/// Least likeness of a patch that is found; below it, it may be another place of similar tissue.
constexpr double kAlike = 0.8;
/// Pixels: farther than kMostOff from where the point was followed to, or than kMostRecalled from where the
/// model predicts it, what is found is another place.
constexpr double kMostOff = 3.0, kMostRecalled = 5.0;
/// A look that must be stretched by more than kMostStretch is not used. Where the best one is stretched by
/// more than kNewLook, the present look is kept, too.
constexpr double kMostStretch = 1.5, kNewLook = 1.2;
constexpr std::size_t kLooks = 4, kPlaces = 1500;
/// A place that is not followed is looked for every kTryAgain frames. After kMisses searches in vain (a
/// minute, in which something may have covered it) it is taken to look otherwise now, and is forgotten.
constexpr int kTryAgain = 10, kMisses = 180;

double stretch_of(const Eigen::Matrix2d& warp) {
  const Eigen::Vector2d sizes = Eigen::JacobiSVD<Eigen::Matrix2d>(warp).singularValues();
  return sizes[1] > 0.0 ? std::max(std::abs(std::log(sizes[0])), std::abs(std::log(sizes[1]))) : 1e9;
}

}  // namespace

Eigen::Matrix2d PointMemory::pixels_of(const Anchor& anchor, bool left,
                                       const registration::MovingSurface& surface) const {
  // A small step along two sides of the triangle; the size of the step cancels between two of these.
  constexpr double kStep = 0.02;
  const auto pixel = [&](double u, double v) -> Eigen::Vector2d {
    ClosestPoint at = anchor.at;
    at.barycentric += Eigen::Vector3d(-u - v, u, v);
    const Eigen::Vector3d p = surface.place(at);
    return left ? rig_.left.project(p) : rig_.right.project(in_right(p));
  };
  Eigen::Matrix2d columns;
  columns.col(0) = pixel(kStep, 0.0) - pixel(-kStep, 0.0);
  columns.col(1) = pixel(0.0, kStep) - pixel(0.0, -kStep);
  return columns;
}

void PointMemory::add_look(Place& place, const FollowedPoint& point, const StereoFollower& pictures,
                           const registration::MovingSurface& surface) const {
  const auto left = patch_at(pictures.grey(true), point.left);
  const auto right = patch_at(pictures.grey(false), point.right);
  if (!left || !right) return;
  if (place.looks.size() == kLooks) place.looks.erase(place.looks.begin() + 1);
  place.looks.push_back({{*left, pixels_of(place.anchor, true, surface).inverse()},
                         {*right, pixels_of(place.anchor, false, surface).inverse()}});
}

void PointMemory::remember(const FollowedPoint& point, const Anchor& anchor, const StereoFollower& pictures,
                           const registration::MovingSurface& surface, int frame) {
  if (places_.size() >= kPlaces) make_room();
  if (places_.size() >= kPlaces) return;
  Place place;
  place.anchor = anchor;
  place.born = frame;
  place.confirmed = confirmations_;
  add_look(place, point, pictures, surface);
  if (!place.looks.empty()) places_[point.id] = std::move(place);
}

void PointMemory::make_room() {
  const auto worst = std::max_element(places_.begin(), places_.end(), [](const auto& a, const auto& b) {
    return a.second.misses < b.second.misses;
  });
  if (worst->second.misses > 0) places_.erase(worst);
}

std::optional<PointMemory::Seen> PointMemory::find(const Place& place, const Eigen::Vector2d& left,
                                                   const Eigen::Vector2d& right, double most,
                                                   const StereoFollower& pictures,
                                                   const registration::MovingSurface& surface) const {
  const Eigen::Matrix2d left_now = pixels_of(place.anchor, true, surface);
  const Look* best = nullptr;
  double stretch = std::log(kMostStretch);
  for (const Look& look : place.looks) {
    const double s = stretch_of(left_now * look.left.surface_from_pixels);
    if (s < stretch) stretch = s, best = &look;
  }
  if (best == nullptr) return std::nullopt;
  const auto found = [&](bool is_left, const View& view, const Eigen::Vector2d& guess) {
    const Eigen::Matrix2d now = is_left ? left_now : pixels_of(place.anchor, false, surface);
    auto patch = find_patch(pictures.grey(is_left), view.patch, now * view.surface_from_pixels, guess, most);
    if (patch && patch->likeness < kAlike) patch.reset();
    return patch;
  };
  const auto in_left = found(true, best->left, left);
  if (!in_left) return std::nullopt;
  const auto in_right = found(false, best->right, right);
  if (!in_right) return std::nullopt;
  return Seen{*in_left, *in_right, stretch};
}

std::vector<char> PointMemory::confirm(StereoFollower& follower, const registration::MovingSurface& surface) {
  ++confirmations_;
  const std::size_t n = follower.points().size();
  std::vector<char> kept(n, 1);
  std::size_t lost = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const FollowedPoint point = follower.points()[i];
    const auto known = places_.find(point.id);
    if (known == places_.end()) continue;
    Place& place = known->second;
    if ((point.id + confirmations_) % kEvery == 0) {
      const auto seen = find(place, point.left, point.right, kMostOff, follower, surface);
      if (seen && follower.put(i, seen->left.at, seen->right.at)) {
        place.confirmed = confirmations_;
        if (seen->stretch > std::log(kNewLook)) add_look(place, follower.points()[i], follower, surface);
      }
    }
    kept[i] = confirmations_ - place.confirmed <= kLost;
    lost += kept[i] == 0;
  }
  // Where most have gone the picture has changed (smoke, light): that says nothing of single points.
  if (2 * lost > n) kept.assign(n, 1);
  return kept;
}

int PointMemory::recall(StereoFollower& follower, AnchoredPoints& anchors,
                        const registration::MovingSurface& surface, int wanted, double spacing, int frame) {
  std::vector<Eigen::Vector2d> taken;
  std::vector<int> ids;
  for (const FollowedPoint& point : follower.points()) {
    taken.push_back(point.left);
    ids.push_back(point.id);
  }
  std::sort(ids.begin(), ids.end());
  int added = 0, tried = 0;
  std::vector<int> gone;
  for (auto& [id, place] : places_) {
    if (added == wanted || tried == 3 * wanted) break;
    if (std::binary_search(ids.begin(), ids.end(), id)) continue;
    if (frame < place.try_from) continue;
    const Eigen::Vector3d p = place.anchor.place(surface), q = in_right(p);
    if (p.z() <= 0.0 || q.z() <= 0.0 || surface.normal(place.anchor.at).dot(p) > 0.0) continue;
    const Eigen::Vector2d left = rig_.left.project(p), right = rig_.right.project(q);
    if (!rig_.left.sees(left) || !rig_.right.sees(right)) continue;
    const bool is_near = std::any_of(taken.begin(), taken.end(), [&](const Eigen::Vector2d& other) {
      return (other - left).norm() < spacing;
    });
    if (is_near) continue;
    ++tried;
    place.try_from = frame + kTryAgain;
    const auto seen = find(place, left, right, kMostRecalled, follower, surface);
    if (!seen || !follower.add(id, seen->left.at, seen->right.at)) {
      if (++place.misses >= kMisses) gone.push_back(id);
      continue;
    }
    anchors.bind(id, place.anchor);
    place.misses = 0;
    place.confirmed = confirmations_;
    taken.push_back(seen->left.at);
    ++added;
  }
  for (const int id : gone) places_.erase(id);
  return added;
}

void PointMemory::rebind(const Rebind& rebind, const registration::MovingSurface& before,
                         const registration::MovingSurface& after) {
  for (auto entry = places_.begin(); entry != places_.end();) {
    Place& place = entry->second;
    const std::optional<Anchor> now = rebind(entry->first, place.anchor);
    if (!now) {
      entry = places_.erase(entry);
      continue;
    }
    // A look knows the coordinates of its triangle: those of the new one, through what both show now.
    for (const bool left : {true, false}) {
      const Eigen::Matrix2d new_from_old =
          pixels_of(*now, left, after).inverse() * pixels_of(place.anchor, left, before);
      for (Look& look : place.looks) {
        View& view = left ? look.left : look.right;
        view.surface_from_pixels = new_from_old * view.surface_from_pixels;
      }
    }
    place.anchor = *now;
    ++entry;
  }
}

std::unordered_map<int, Anchor> PointMemory::anchors() const {
  std::unordered_map<int, Anchor> anchors;
  for (const auto& [id, place] : places_) anchors.emplace(id, place.anchor);
  return anchors;
}

void PointMemory::forget(const std::vector<int>& ids) {
  for (const int id : ids) places_.erase(id);
}

void PointMemory::forget_since(int frame) {
  std::erase_if(places_, [&](const auto& entry) { return entry.second.born > frame; });
}

}  // namespace glisson::guidance
