// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/stereo/region_drawing.h"

#include <algorithm>
#include <utility>

namespace glisson::ui {
namespace {

bool close_to(const Eigen::Vector2d& a, const RegionDrawing::Place& place) {
  return (a - place.pixel).norm() <= place.reach;
}

bool same_region(const stereo::Region& a, const stereo::Region& b) {
  return a.feature == b.feature && a.closed == b.closed && a.side == b.side &&
         a.half_width_px == b.half_width_px && a.polygon == b.polygon;
}

}  // namespace

bool same_regions(const RegionDrawing::Regions& a, const RegionDrawing::Regions& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_region);
}

int count_unchanged(const RegionDrawing::Regions& regions, const RegionDrawing::Regions& former) {
  return static_cast<int>(std::count_if(regions.begin(), regions.end(), [&](const stereo::Region& one) {
    return std::any_of(former.begin(), former.end(),
                       [&](const stereo::Region& other) { return same_region(one, other); });
  }));
}

void RegionDrawing::set_tool(const std::optional<Tool>& tool) {
  if (tool_ && tool && tool_->feature == tool->feature && tool_->closed == tool->closed) {
    tool_ = tool;  // the same tool, wider or narrower: the unfinished line stays
    if (unfinished_) unfinished_->half_width_px = tool->half_width_px;
    return;
  }
  tool_ = tool;
  unfinished_.reset();
  if (tool) selected_.reset();
}

void RegionDrawing::set_regions(const Regions& regions) {
  if (!same_regions(regions, regions_)) begin_anew(regions);
}

void RegionDrawing::begin_anew(const Regions& regions) {
  regions_ = regions;
  past_.clear();
  future_.clear();
  dragged_.reset();
  unfinished_.reset();
  selected_.reset();
}

void RegionDrawing::select(const std::optional<std::size_t>& region) {
  selected_ = region && *region < regions_.size() ? region : std::nullopt;
}

std::optional<RegionDrawing::Corner> RegionDrawing::corner_at(const Place& place) const {
  std::optional<Corner> best;
  double least = place.reach;
  for (std::size_t r = 0; r < regions_.size(); ++r)
    for (std::size_t c = 0; regions_[r].side == place.side && c < regions_[r].polygon.size(); ++c) {
      // Where corners coincide, the selected region's is taken.
      const double d = (regions_[r].polygon[c] - place.pixel).norm();
      if (d < least || (d == least && (!best || selected_ == r))) least = d, best = Corner{r, c};
    }
  return best;
}

std::optional<std::size_t> RegionDrawing::region_at(const Place& place) const {
  for (std::size_t r = regions_.size(); r-- > 0;) {
    const stereo::Region& region = regions_[r];
    if (region.side != place.side) continue;
    if (stereo::closest_on_outline(region, place.pixel).distance_px <= place.reach) return r;
    if (stereo::contains(region, place.pixel)) return r;
  }
  return std::nullopt;
}

std::optional<stereo::OutlinePlace> RegionDrawing::outline_at(const Place& place) const {
  if (!selected_ || regions_[*selected_].side != place.side) return std::nullopt;
  const stereo::OutlinePlace on = stereo::closest_on_outline(regions_[*selected_], place.pixel);
  return on.distance_px <= place.reach ? std::optional(on) : std::nullopt;
}

RegionDrawing::Click RegionDrawing::click_at(const Place& place) const {
  if (tool_ && !unfinished_) return Click::begin;
  if (tool_) {
    if (unfinished_->side != place.side) return Click::wrong_picture;
    const bool enough = unfinished_->polygon.size() >= unfinished_->fewest_vertices();
    if (enough && unfinished_->closed && close_to(unfinished_->polygon.front(), place)) return Click::close;
    if (enough && !unfinished_->closed && close_to(unfinished_->polygon.back(), place))
      return Click::end_curve;
    return Click::add;
  }
  if (corner_at(place)) return Click::drag;
  if (outline_at(place)) return Click::insert;
  return region_at(place) ? Click::select : Click::nothing;
}

bool RegionDrawing::press(const Place& place) {
  press_finished_ = false;
  switch (click_at(place)) {
    case Click::begin:
      unfinished_ = stereo::Region{tool_->feature, {}, tool_->closed, tool_->half_width_px, place.side};
      [[fallthrough]];
    case Click::add:
      unfinished_->polygon.push_back(place.pixel);
      return false;
    case Click::close:
    case Click::end_curve:
      press_finished_ = true;
      return finish();
    case Click::drag:
      before_drag_ = regions_;
      dragged_ = corner_at(place);
      selected_ = dragged_->region;
      return false;
    case Click::insert: {
      before_drag_ = regions_;
      const stereo::OutlinePlace on = *outline_at(place);
      auto& polygon = regions_[*selected_].polygon;
      polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(on.edge) + 1, place.pixel);
      dragged_ = Corner{*selected_, on.edge + 1};
      return false;
    }
    case Click::select:
      selected_ = region_at(place);
      return false;
    case Click::nothing:
      selected_.reset();
      return false;
    case Click::wrong_picture:
      return false;
  }
  return false;
}

bool RegionDrawing::double_click(const Place& place) {
  if (std::exchange(press_finished_, false)) return false;  // its first press has ended the line
  // The double click's first press has put a corner here already, unless the pointer has moved far since.
  if (unfinished_ && unfinished_->side == place.side && close_to(unfinished_->polygon.back(), place) &&
      unfinished_->polygon.size() >= unfinished_->fewest_vertices())
    return finish();
  return press(place);
}

void RegionDrawing::move(const Place& place) {
  if (dragged_ && regions_[dragged_->region].side == place.side)
    regions_[dragged_->region].polygon[dragged_->corner] = place.pixel;
}

bool RegionDrawing::release() {
  if (!dragged_) return false;
  dragged_.reset();
  if (same_regions(before_drag_, regions_)) return false;
  past_.push_back(std::exchange(before_drag_, {}));
  future_.clear();
  return true;
}

bool RegionDrawing::finish() {
  if (!unfinished_ || unfinished_->polygon.size() < unfinished_->fewest_vertices()) return false;
  Regions next = regions_;
  next.push_back(*std::exchange(unfinished_, std::nullopt));
  return change(std::move(next));
}

bool RegionDrawing::take_back() {
  if (!unfinished_) return false;
  unfinished_->polygon.pop_back();
  if (unfinished_->polygon.empty()) unfinished_.reset();
  return true;
}

bool RegionDrawing::drop() {
  if (dragged_) {
    regions_ = std::exchange(before_drag_, {});
    dragged_.reset();
    return true;
  }
  if (unfinished_) {
    unfinished_.reset();
    return true;
  }
  if (tool_) {
    tool_.reset();
    return true;
  }
  return std::exchange(selected_, std::nullopt).has_value();
}

bool RegionDrawing::remove_selected() {
  if (!selected_ || dragged_) return false;
  Regions next = regions_;
  next.erase(next.begin() + static_cast<std::ptrdiff_t>(*selected_));
  return change(std::move(next));
}

bool RegionDrawing::remove_at(const Place& place) {
  if (unfinished_ || dragged_) return false;
  selected_ = region_at(place);
  return remove_selected();
}

bool RegionDrawing::clear() {
  unfinished_.reset();
  dragged_.reset();
  return !regions_.empty() && change({});
}

bool RegionDrawing::change(Regions regions) {
  past_.push_back(std::exchange(regions_, std::move(regions)));
  future_.clear();
  selected_.reset();
  return true;
}

bool RegionDrawing::undo() {
  if (dragged_ || take_back() || past_.empty()) return false;
  future_.push_back(std::exchange(regions_, std::move(past_.back())));
  past_.pop_back();
  selected_.reset();
  return true;
}

bool RegionDrawing::redo() {
  if (dragged_ || unfinished_ || future_.empty()) return false;
  past_.push_back(std::exchange(regions_, std::move(future_.back())));
  future_.pop_back();
  selected_.reset();
  return true;
}

}  // namespace glisson::ui
