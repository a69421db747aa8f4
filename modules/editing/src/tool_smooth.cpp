// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/smooth.h"

#include <cmath>

#include "describe.h"
#include "edit_shape.h"

namespace glisson::editing {
namespace {

constexpr double kLargest = 0.02;  ///< metres: beyond it a slip of the unit is likelier than a wish

/// Labels (or a mask as 0 and 1) in a box of the volume.
struct Block {
  VoxelBox box;
  std::vector<Label> labels;

  std::size_t offset(int i, int j, int k) const {
    const Eigen::Vector3i size = box.size();
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(size.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(size.y()) * static_cast<std::size_t>(k));
  }
};

/// A ball as runs along i: those at (j, k) reach `half` voxels to either side.
struct BallRow {
  int j, k, half;
};
std::vector<BallRow> ball_rows(const Eigen::Vector3d& spacing_mm, double radius_mm) {
  const double radius2 = radius_mm * radius_mm * (1.0 + 1e-9);
  const int nj = static_cast<int>(radius_mm / spacing_mm.y()) + 1,
            nk = static_cast<int>(radius_mm / spacing_mm.z()) + 1;
  std::vector<BallRow> rows;
  for (int k = -nk; k <= nk; ++k)
    for (int j = -nj; j <= nj; ++j) {
      const double across2 = std::pow(j * spacing_mm.y(), 2) + std::pow(k * spacing_mm.z(), 2);
      if (across2 > radius2) continue;
      int half = 0;
      while (std::pow((half + 1) * spacing_mm.x(), 2) + across2 <= radius2) ++half;
      rows.push_back({j, k, half});
    }
  return rows;
}

/// Where nothing can change: cells of 8 voxels a side of which all neighbours within the radius hold one and
/// the same label.
class Quiet {
 public:
  Quiet(const Block& block, const Eigen::Vector3d& spacing_mm, double radius_mm) {
    const Eigen::Vector3i size = block.box.size();
    cells_ = (size.array() + (kCell - 1)) / kCell;
    std::vector<std::int32_t> held(static_cast<std::size_t>(cells_.prod()), kNothing);
    std::size_t at = 0;
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i, ++at) {
          std::int32_t& cell = held[place(i / kCell, j / kCell, k / kCell)];
          const std::int32_t label = block.labels[at];
          if (cell != label) cell = cell == kNothing ? label : kSeveral;
        }
    const Eigen::Vector3i reach = (radius_mm / (kCell * spacing_mm.array())).ceil().matrix().cast<int>();
    quiet_.assign(held.size(), 0);
    for (int k = 0; k < cells_.z(); ++k)
      for (int j = 0; j < cells_.y(); ++j)
        for (int i = 0; i < cells_.x(); ++i)
          quiet_[place(i, j, k)] = one_label(held, {i, j, k}, reach) ? 1 : 0;
  }
  bool at(int i, int j, int k) const { return quiet_[place(i / kCell, j / kCell, k / kCell)] != 0; }

 private:
  static constexpr int kCell = 8;
  static constexpr std::int32_t kNothing = -1, kSeveral = -2;
  std::size_t place(int i, int j, int k) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(cells_.x()) *
               (static_cast<std::size_t>(j) +
                static_cast<std::size_t>(cells_.y()) * static_cast<std::size_t>(k));
  }
  bool one_label(const std::vector<std::int32_t>& held, const Eigen::Vector3i& cell,
                 const Eigen::Vector3i& reach) const {
    const std::int32_t here = held[place(cell.x(), cell.y(), cell.z())];
    if (here == kSeveral) return false;
    const Eigen::Vector3i low = (cell - reach).cwiseMax(0),
                          high = (cell + reach).cwiseMin(cells_ - Eigen::Vector3i::Ones());
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i)
          if (held[place(i, j, k)] != here) return false;
    return true;
  }

  Eigen::Vector3i cells_;
  std::vector<std::uint8_t> quiet_;
};

/// Counts labels in a ball that moves along a row.
class Votes {
 public:
  Votes(const Block& block, const std::vector<BallRow>& ball) : block_(block), ball_(ball) {
    std::vector<bool> present(65536, false);
    for (const Label label : block.labels) present[label] = true;
    for (std::size_t label = 0; label < present.size(); ++label)
      if (present[label]) labels_.push_back(static_cast<Label>(label));
    count_.resize(static_cast<std::size_t>(labels_.back()) + 1);
  }
  void start_row(int j, int k) {
    const Eigen::Vector3i size = block_.box.size();
    rows_.clear();
    for (const BallRow& row : ball_)
      if (j + row.j >= 0 && j + row.j < size.y() && k + row.k >= 0 && k + row.k < size.z())
        rows_.emplace_back(block_.labels.data() + block_.offset(0, j + row.j, k + row.k), row.half);
    at_ = -2;
  }
  /// What most voxels of the ball about voxel i are; `here` unless another has more.
  Label winner(int i, Label here) {
    move_to(i);
    Label best = here;
    for (const Label label : labels_)
      if (count_[label] > count_[best]) best = label;
    return best;
  }

 private:
  void move_to(int i) {
    const int length = block_.box.size().x();
    if (i == at_ + 1) {
      for (const auto& [row, half] : rows_) {
        if (i + half < length) ++count_[row[i + half]];
        if (i - 1 - half >= 0) --count_[row[i - 1 - half]];
      }
    } else {
      for (const Label label : labels_) count_[label] = 0;
      for (const auto& [row, half] : rows_)
        for (int n = std::max(0, i - half); n <= std::min(length - 1, i + half); ++n) ++count_[row[n]];
    }
    at_ = i;
  }

  const Block& block_;
  const std::vector<BallRow>& ball_;
  std::vector<Label> labels_;
  std::vector<int> count_;
  std::vector<std::pair<const Label*, int>> rows_;
  int at_ = -2;
};

/// The commonest label in a ball about each voxel. Balls that reach beyond the volume count what is inside.
Cancellable<std::vector<Label>> commonest(const Block& block, const Eigen::Vector3d& spacing_mm,
                                          double radius_mm, const RunContext& context) {
  const std::vector<BallRow> ball = ball_rows(spacing_mm, radius_mm);
  const Quiet quiet(block, spacing_mm, radius_mm);
  Votes votes(block, ball);
  std::vector<Label> result = block.labels;
  const Eigen::Vector3i size = block.box.size();
  for (int k = 0; k < size.z(); ++k) {
    if (context.cancelled()) return std::nullopt;
    context.progress(static_cast<double>(k) / size.z(), "segmentation.edit");
    for (int j = 0; j < size.y(); ++j) {
      votes.start_row(j, k);
      for (int i = 0; i < size.x(); ++i) {
        const std::size_t at = block.offset(i, j, k);
        if (!quiet.at(i, j, k)) result[at] = votes.winner(i, block.labels[at]);
      }
    }
  }
  return result;
}

/// All labels at once: nothing is left between them, as each voxel goes to one of them.
Cancellable<Canvas> smooth_jointly(const Smooth& tool, Task& task) {
  LabelSet any;
  for (int label = 1; label <= structure::kLastLesion; ++label) any.insert(static_cast<Label>(label));
  const double radius_mm = 1e3 * tool.radius;
  // Twice the radius: the balls about the voxels that can change are read whole.
  const VoxelBox box = grown(box_of(task.labels.voxels, any), task.grid(), 2.0 * radius_mm);
  Canvas canvas = task.canvas(box);
  if (box.empty()) return canvas;
  const Block block{box, labels_in(task.labels.voxels, box)};
  const auto after = commonest(block, task.grid().spacing_mm, radius_mm, task.context.part(0.0, 0.9));
  if (!after) return std::nullopt;
  const bool done = canvas.rewrite(box, task.context.part(0.9, 1.0), [&](int i, int j, int k, Label) {
    return (*after)[block.offset(i - box.low.x(), j - box.low.y(), k - box.low.z())];
  });
  if (!done) return std::nullopt;
  return canvas;
}

Cancellable<Mask> majority(const Mask& mask, const VoxelBox& box, double radius_mm,
                           const RunContext& context) {
  const Block block{box, std::vector<Label>(mask.voxels.begin(), mask.voxels.end())};
  const auto winners = commonest(block, mask.spacing_mm, radius_mm, context);
  if (!winners) return std::nullopt;
  Mask result(mask.size, mask.spacing_mm);
  std::copy(winners->begin(), winners->end(), result.voxels.begin());
  return result;
}

Cancellable<Canvas> apply(const Smooth& tool, Task& task) {
  if (tool.method == Smooth::Method::joint) return smooth_jointly(tool, task);
  const double radius_mm = 1e3 * tool.radius;
  const LabelSet shape = shape_of(tool.label);
  // What a closing dilates must end inside the box, and a voxel of air lie about it.
  const VoxelBox box = grown(box_of(task.labels.voxels, shape), task.grid(),
                             2.0 * radius_mm + task.grid().spacing_mm.maxCoeff());
  Canvas canvas = task.canvas(box);
  if (box.empty()) return canvas;
  const Mask mask = mask_in(task.labels.voxels, box, shape);
  Cancellable<Mask> after;
  if (tool.method == Smooth::Method::median) {
    after = majority(mask, box, radius_mm, task.context.part(0.0, 0.8));
  } else {
    const bool closing = tool.method == Smooth::Method::closing;
    const Mask between = closing ? dilated(mask, radius_mm) : eroded(mask, radius_mm);
    task.context.progress(0.4, "segmentation.edit");
    if (task.context.cancelled()) return std::nullopt;
    after = closing ? eroded(between, radius_mm) : dilated(between, radius_mm);
  }
  if (!after || !reshape(canvas, box, *after, tool.label, task.context.part(0.8, 1.0))) return std::nullopt;
  return canvas;
}

using Method = Smooth::Method;

const Names<Method>& methods() {
  static const Names<Method> kNames = {{"median", Method::median},
                                       {"closing", Method::closing},
                                       {"opening", Method::opening},
                                       {"joint", Method::joint}};
  return kNames;
}

bool has_label(const Smooth& t) { return t.method != Method::joint; }

Description<Smooth> description() {
  return {"smooth",
          80,
          {choice_field("method", &Smooth::method, methods()),
           label_field("label", &Smooth::label)
               .needed("but for `joint`", has_label)
               .checked([](const SettingsCheck& check, const Smooth& t) {
                 if (has_label(t)) check.target(t.label, "label");
               }),
           length_field("radius_mm", &Smooth::radius, kLargest)},
          steps_of("smooth", methods()),
          [](const Smooth& t) {
            return StepName{"smooth." + name_of(methods(), t.method),
                            has_label(t) ? t.label : structure::kBackground, t.radius};
          },
          apply};
}

}  // namespace

const ToolKind& Smooth::kind() {
  static const Described<Smooth> kKind(description());
  return kKind;
}
const ToolKind& smooth_tool() { return Smooth::kind(); }

}  // namespace glisson::editing
