// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_view.h"

#include <algorithm>
#include <cmath>

namespace glisson::segmentation {
namespace {

constexpr auto kPause = std::chrono::milliseconds(200);
constexpr int kShare = 5;  // of the time at most one part in so many is spent on showing

bool same_grid(const Field& a, const Field& b) {
  return a.size == b.size && a.first_index == b.first_index && a.step == b.step;
}

/// The field's voxels that a box of the image's voxels is interpolated from.
VoxelBox sources_of(const Field& field, const VoxelBox& box) {
  VoxelBox result;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (box.low[axis] - field.first_index[axis]) / field.step[axis];
    const double high = (box.high[axis] - 1 - field.first_index[axis]) / field.step[axis];
    const int last = field.size[axis] - 1;
    result.low[axis] = std::clamp(static_cast<int>(std::floor(low)), 0, last);
    result.high[axis] = std::clamp(static_cast<int>(std::ceil(high)), 0, last) + 1;
  }
  return result;
}

}  // namespace

LiveView::LiveView(const VolumeGrid& grid, VoxelBox region, ShowLiver show)
    : region_(std::move(region)), show_(std::move(show)) {
  if (show_) liver_ = LabelVolume(grid);
}

void LiveView::update(const Field& phi) {
  if (!show_ || Clock::now() < next_) return;
  finish(phi);
}

void LiveView::finish(const Field& phi) {
  if (!show_) return;
  const auto begin = Clock::now();
  draw(phi);
  show_(liver_);
  const auto end = Clock::now();
  next_ = end + std::max<Clock::duration>(kPause, kShare * (end - begin));
}

bool LiveView::moved_within(const Field& phi, const VoxelBox& image_box) const {
  const VoxelBox box = sources_of(phi, image_box);
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i) {
        const std::size_t at = phi.offset(i, j, k);
        if ((phi.values[at] < 0.0F) != (shown_.values[at] < 0.0F)) return true;
      }
  return false;
}

void LiveView::draw(const Field& phi) {
  constexpr int kSide = LabelVolume::kSide;
  const bool everywhere = !same_grid(phi, shown_);
  for (std::size_t number = 0; number < liver_.brick_count(); ++number) {
    const Eigen::Vector3i corner = liver_.brick_place(number) * kSide;
    VoxelBox box{corner.cwiseMax(region_.low), (corner.array() + kSide).matrix().cwiseMin(region_.high)};
    if (box.empty()) continue;
    const Eigen::Vector3i inset = box.low - corner, size = box.size();
    box = {box.low - region_.low, box.high - region_.low};
    if (!everywhere && !moved_within(phi, box)) continue;
    const std::vector<float> values = on_image(phi, box);
    std::shared_ptr<LabelVolume::Brick> brick;
    std::size_t at = 0;
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i, ++at) {
          if (values[at] >= 0.0F) continue;
          if (!brick) brick = std::make_shared<LabelVolume::Brick>(LabelVolume::Brick{});
          const int place = inset.x() + i + kSide * (inset.y() + j + kSide * (inset.z() + k));
          (*brick)[static_cast<std::size_t>(place)] = 1;
        }
    liver_.set_brick(number, std::move(brick));
  }
  shown_ = phi;
}

}  // namespace glisson::segmentation
