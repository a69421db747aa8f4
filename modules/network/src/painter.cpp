// SPDX-License-Identifier: GPL-3.0-or-later
#include "painter.h"

namespace glisson::network {

Painter::Painter(const Oriented& oriented, const LabelSheet& sheet) : oriented_(oriented), sheet_(sheet) {
  const Three& size = oriented.volume_size();
  const auto places = [&](int axis) {
    std::vector<Between> all;
    const auto n = static_cast<std::size_t>(axis);
    for (int voxel = 0; voxel < size[n]; ++voxel)
      all.push_back(between(oriented.network_place(axis, voxel), oriented.size()[n]));
    return all;
  };
  rows_ = places(1);
  columns_ = places(2);
  labels_.resize(static_cast<std::size_t>(size[0]) * rows_.size() * columns_.size());
}

void Painter::add(std::vector<float> scores) {
  ++network_slice_;
  const std::vector<float>& former = network_slice_ == 0 ? scores : former_;
  for (; next_ < oriented_.volume_size()[0]; ++next_) {
    const double place = oriented_.network_place(0, next_);
    if (place > network_slice_) break;
    paint(next_, former, scores, static_cast<float>(place - (network_slice_ - 1)));
  }
  former_ = std::move(scores);
}

void Painter::paint(int slice, const std::vector<float>& low, const std::vector<float>& high, float part) {
  const auto across = static_cast<std::size_t>(oriented_.size()[2]);
  const std::size_t channel_size = static_cast<std::size_t>(oriented_.size()[1]) * across;
  std::vector<float> scores(sheet_.channels.size());
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const Between& r = rows_[row];
    const std::size_t above = static_cast<std::size_t>(r.low) * across,
                      below = static_cast<std::size_t>(r.high) * across;
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      const Between& c = columns_[column];
      const auto left = static_cast<std::size_t>(c.low), right = static_cast<std::size_t>(c.high);
      const auto in_slice = [&](const float* of) {
        const float up = of[above + left] + c.part * (of[above + right] - of[above + left]);
        const float down = of[below + left] + c.part * (of[below + right] - of[below + left]);
        return up + r.part * (down - up);
      };
      for (std::size_t channel = 0; channel < scores.size(); ++channel) {
        const float near = in_slice(high.data() + channel * channel_size);
        const float far = part == 1.0F ? near : in_slice(low.data() + channel * channel_size);
        scores[channel] = part == 1.0F ? near : far + part * (near - far);
      }
      labels_[oriented_.offset(slice, static_cast<int>(row), static_cast<int>(column))] = decided(scores);
    }
  }
}

Label Painter::decided(const std::vector<float>& scores) const {
  // With a threshold the background needs no channel, and where it has one, it says nothing.
  Label label = structure::kBackground;
  float most = sheet_.threshold ? static_cast<float>(*sheet_.threshold) : scores.front();
  for (std::size_t channel = 0; channel < scores.size(); ++channel) {
    const Label own = sheet_.channels[channel];
    if (sheet_.threshold ? own == structure::kBackground || scores[channel] <= most
                         : channel > 0 && scores[channel] <= most)
      continue;
    most = scores[channel];
    label = own;
  }
  return label;
}

}  // namespace glisson::network
