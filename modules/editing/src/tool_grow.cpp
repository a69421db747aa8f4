// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/grow.h"

#include <cmath>
#include <limits>

#include "describe.h"
#include "glisson/volume/voxel_neighbours.h"

namespace glisson::editing {
namespace {

constexpr double kLongest = 0.2;  ///< metres: beyond it a slip of the unit is likelier than a wish

/// A step costs the square of the difference between two neighbours (HU), and so much for each mm. Squares,
/// because many small steps of noise must not cost what one step across an edge does: with this an edge of
/// 50 HU is as far as half a metre of even tissue.
constexpr double kCostPerMm = 5.0;
/// Costs are whole numbers below this, so that buckets can take the place of a heap; 256 HU from one voxel
/// to the next is a wall already.
constexpr std::uint32_t kDearest = 65535;
constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();

/// The image in a box after a median of three along each axis in turn: noise goes, and faces, edges and
/// corners stay. (A mean would leave a rim of middling values about every bright body, and fronts run along
/// rims.)
std::vector<std::int16_t> without_noise(const Image& image, const VoxelBox& box) {
  const Eigen::Vector3i size = box.size();
  std::vector<std::int16_t> values;
  values.reserve(static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()) *
                 static_cast<std::size_t>(size.z()));
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i) values.push_back(image.at({i, j, k}));
  const std::array<std::size_t, 3> strides = {
      1, static_cast<std::size_t>(size.x()),
      static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y())};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t stride = strides[static_cast<std::size_t>(axis)];
    const int length = size[axis], a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int ib = 0; ib < size[b]; ++ib)
      for (int ia = 0; ia < size[a]; ++ia) {
        std::int16_t* at = values.data() +
                           static_cast<std::size_t>(ia) * strides[static_cast<std::size_t>(a)] +
                           static_cast<std::size_t>(ib) * strides[static_cast<std::size_t>(b)];
        std::int16_t before = *at;
        for (int n = 0; n + 1 < length; ++n, at += stride) {
          const std::int16_t here = *at, after = at[stride];
          *at = std::max(std::min(before, here), std::min(std::max(before, here), after));
          before = here;
        }
      }
  }
  return values;
}

/// Voxels in the order of their cost: a ring of buckets, each first in, first out.
class Buckets {
 public:
  Buckets() : bucket_(kDearest + 1) {}
  void push(std::uint32_t cost, std::uint32_t voxel) {
    bucket_[cost % bucket_.size()].push_back(voxel);
    ++waiting_;
  }
  bool empty() const { return waiting_ == 0; }
  /// All that wait at the lowest cost. @pre not empty
  std::vector<std::uint32_t> pop(std::uint32_t& cost) {
    while (bucket_[cost % bucket_.size()].empty()) ++cost;
    std::vector<std::uint32_t> voxels;
    voxels.swap(bucket_[cost % bucket_.size()]);
    waiting_ -= voxels.size();
    return voxels;
  }

 private:
  std::vector<std::vector<std::uint32_t>> bucket_;
  std::size_t waiting_ = 0;
};

/// Labels that race over the free voxels of a box.
class Race {
 public:
  /// @param owner labels of the competitors where they are, else background.
  Race(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing_mm, std::vector<std::int16_t> values,
       std::vector<Label> owner, const std::vector<std::uint8_t>& free)
      : size_(size), values_(std::move(values)), owner_(std::move(owner)), free_(free) {
    for (int axis = 0; axis < 3; ++axis)
      length_cost_[static_cast<std::size_t>(axis)] =
          static_cast<std::uint32_t>(std::max(1.0, std::round(kCostPerMm * spacing_mm[axis])));
    cost_.assign(values_.size(), kUnreached);
  }

  /// False when cancelled.
  bool run(const RunContext& context, std::size_t voxels_to_win) {
    Buckets waiting;
    for (std::size_t at = 0; at < owner_.size(); ++at)
      if (owner_[at] != structure::kBackground) cost_[at] = 0;
    // What is reached on the way owns something, too, but at a cost.
    for (std::size_t at = 0; at < owner_.size(); ++at)
      if (cost_[at] == 0) visit_neighbours(at, waiting);
    std::uint32_t cost = 0;
    std::size_t won = 0, next_look = 0;
    while (!waiting.empty()) {
      for (const std::uint32_t at : waiting.pop(cost)) {
        if (cost_[at] != cost) continue;  // reached more cheaply since
        visit_neighbours(at, waiting);
        if (++won < next_look) continue;
        next_look = won + 65536;
        if (context.cancelled()) return false;
        context.progress(
            static_cast<double>(won) / static_cast<double>(std::max<std::size_t>(1, voxels_to_win)),
            "segmentation.edit");
      }
    }
    return true;
  }
  Label owner(std::size_t at) const { return owner_[at]; }

 private:
  void visit_neighbours(std::size_t at, Buckets& waiting) {
    each_face_neighbour(
        size_, at, [&](std::size_t to, int axis) { reach(at, to, static_cast<std::size_t>(axis), waiting); });
  }
  void reach(std::size_t from, std::size_t to, std::size_t axis, Buckets& waiting) {
    if (free_[to] == 0 || cost_[from] > kUnreached - kDearest) return;
    const double step = values_[from] - values_[to];
    const std::uint32_t price =
        std::min(kDearest, length_cost_[axis] + static_cast<std::uint32_t>(std::min(step * step, 65535.0)));
    const std::uint32_t cost = cost_[from] + price;
    if (cost >= cost_[to]) return;
    cost_[to] = cost;
    owner_[to] = owner_[from];
    waiting.push(cost, static_cast<std::uint32_t>(to));
  }

  Eigen::Vector3i size_;
  std::vector<std::int16_t> values_;
  std::vector<Label> owner_;
  const std::vector<std::uint8_t>& free_;
  std::vector<std::uint32_t> cost_;
  std::array<std::uint32_t, 3> length_cost_{};
};

/// Unlabelled voxels within reach of a seed that the region lets change, and how many.
std::vector<std::uint8_t> free_voxels(const Mask& seeds, const std::vector<Label>& labels,
                                      const VoxelBox& box, const Gate& gate, double reach_mm, Label example,
                                      std::size_t& count) {
  const std::vector<float> distance2 = squared_distance_mm2(seeds);
  std::vector<std::uint8_t> free(labels.size(), 0);
  std::size_t at = 0;
  for (int k = box.low.z(); k < box.high.z(); ++k)
    for (int j = box.low.y(); j < box.high.y(); ++j)
      for (int i = box.low.x(); i < box.high.x(); ++i, ++at)
        if (labels[at] == structure::kBackground &&
            distance2[at] <= static_cast<float>(reach_mm * reach_mm * (1.0 + 1e-6)) &&
            gate.open(i, j, k, structure::kBackground, example)) {
          free[at] = 1;
          ++count;
        }
  return free;
}

Cancellable<Canvas> apply(const GrowFromSeeds& tool, Task& task) {
  LabelSet all, rivals;
  for (const Label label : tool.labels) all.insert(label);
  for (const Label label : tool.rivals) all.insert(label), rivals.insert(label);
  const double reach_mm = 1e3 * tool.reach;
  const VoxelBox box = grown(box_of(task.labels.voxels, all), task.grid(), reach_mm);
  Canvas canvas = task.canvas(box);
  if (box.empty()) return canvas;
  std::vector<Label> owner = labels_in(task.labels.voxels, box);
  std::size_t count = 0;
  std::vector<std::uint8_t> free;
  {
    const Mask seeds = mask_in(task.labels.voxels, box, all);
    // Any label that may grow stands for all: locked ones have been refused.
    Label example = structure::kBackground;
    for (const Label label : tool.labels)
      if (!rivals.contains(label)) example = label;
    free = free_voxels(seeds, owner, box, canvas.gate(), reach_mm, example, count);
  }
  task.context.progress(0.2, "segmentation.edit");
  if (task.context.cancelled()) return std::nullopt;
  for (Label& label : owner)
    if (!all.contains(label)) label = structure::kBackground;
  Race race(box.size(), task.grid().spacing_mm, without_noise(task.image, box), std::move(owner), free);
  if (!race.run(task.context.part(0.2, 0.9), count)) return std::nullopt;
  const Eigen::Vector3i low = box.low, size = box.size();
  const bool done = canvas.rewrite(box, task.context.part(0.9, 1.0), [&](int i, int j, int k, Label old) {
    const std::size_t at = static_cast<std::size_t>(i - low.x()) +
                           static_cast<std::size_t>(size.x()) *
                               (static_cast<std::size_t>(j - low.y()) +
                                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(k - low.z()));
    const Label won = race.owner(at);
    return free[at] != 0 && won != structure::kBackground && !rivals.contains(won) ? won : old;
  });
  if (!done) return std::nullopt;
  return canvas;
}

void check_labels(const SettingsCheck& check, const GrowFromSeeds& t) {
  LabelSet all;
  int different = 0, growing = 0;
  const auto count = [&](Label label, bool rival) {
    if (all.contains(label)) return;
    all.insert(label);
    ++different;
    growing += rival ? 0 : 1;
  };
  for (const Label label : t.rivals) {
    if (label == structure::kBackground || label > structure::kLastLesion)
      check.refuse("rivals", "name " + structure_name(label) + ", which is no structure",
                   "Choose structures that have voxels");
    count(label, true);
  }
  for (const Label label : t.labels) {
    check.target(label, "labels");
    count(label, false);
  }
  if (growing == 0)
    check.refuse("labels", "are none that may keep what they win", "Choose one or more to grow");
  if (different < 2)
    check.refuse("labels", "are fewer than two with the rivals", "Choose labels that compete");
}

/// The one label that seeds grow for; background when they are several.
Label grown_label(const GrowFromSeeds& tool) {
  Label only = structure::kBackground;
  for (const Label label : tool.labels) {
    if (std::find(tool.rivals.begin(), tool.rivals.end(), label) != tool.rivals.end()) continue;
    if (only != structure::kBackground && only != label) return structure::kBackground;
    only = label;
  }
  return only;
}

Description<GrowFromSeeds> description() {
  return {"grow_from_seeds",
          40,
          {labels_field("labels", &GrowFromSeeds::labels),
           labels_field("rivals", &GrowFromSeeds::rivals).with_default().checked(check_labels),
           length_field("reach_mm", &GrowFromSeeds::reach, kLongest).with_default()},
          {"grow_from_seeds"},
          [](const GrowFromSeeds& t) {
            return StepName{"grow_from_seeds", grown_label(t), t.reach};
          },
          apply};
}

}  // namespace

const ToolKind& GrowFromSeeds::kind() {
  static const Described<GrowFromSeeds> kKind(description());
  return kKind;
}
const ToolKind& grow_tool() { return GrowFromSeeds::kind(); }

}  // namespace glisson::editing
