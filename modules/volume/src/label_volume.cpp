// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/volume/label_volume.h"

#include <algorithm>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr int kSide = LabelVolume::kSide;

std::size_t within_brick(const Eigen::Vector3i& v) {
  return static_cast<std::size_t>((v.x() % kSide) + kSide * ((v.y() % kSide) + kSide * (v.z() % kSide)));
}

/// Calls row(first voxel of a run along i inside one brick, its length) for every run of brick `b`.
template <class Row>
void for_each_row(const VolumeGrid& grid, const Eigen::Vector3i& brick, Row&& row) {
  const Eigen::Vector3i low = kSide * brick;
  const Eigen::Vector3i high = (low.array() + kSide).min(grid.size.array()).matrix();
  for (int k = low.z(); k < high.z(); ++k)
    for (int j = low.y(); j < high.y(); ++j) row(Eigen::Vector3i(low.x(), j, k), high.x() - low.x());
}

/// Calls visit(brick coordinates, brick number) for every brick, in memory order.
template <class Visit>
void for_each_brick(const Eigen::Vector3i& bricks, Visit&& visit) {
  std::size_t number = 0;
  for (int z = 0; z < bricks.z(); ++z)
    for (int y = 0; y < bricks.y(); ++y)
      for (int x = 0; x < bricks.x(); ++x) visit(Eigen::Vector3i(x, y, z), number++);
}

bool all_zero(const LabelVolume::Brick& brick) {
  return std::all_of(brick.begin(), brick.end(), [](Label label) { return label == 0; });
}

bool same_content(const std::shared_ptr<const LabelVolume::Brick>& a,
                  const std::shared_ptr<const LabelVolume::Brick>& b) {
  if (a == b) return true;
  if (a && b) return *a == *b;
  return all_zero(a ? *a : *b);
}

}  // namespace

LabelVolume::LabelVolume(const VolumeGrid& grid) : grid_(grid) {
  require((grid.size.array() >= 0).all(), "a label volume has no negative size");
  bricks_ = (grid.size.array() + (kSide - 1)) / kSide;
  brick_.resize(static_cast<std::size_t>(bricks_.x()) * static_cast<std::size_t>(bricks_.y()) *
                static_cast<std::size_t>(bricks_.z()));
}

LabelVolume::LabelVolume(const VolumeGrid& grid, const std::vector<Label>& dense) : LabelVolume(grid) {
  require(static_cast<long>(dense.size()) == grid.voxel_count(),
          "a label volume takes one label for each voxel of its grid");
  for_each_brick(bricks_, [&](const Eigen::Vector3i& brick, std::size_t number) {
    std::shared_ptr<Brick> content;
    for_each_row(grid_, brick, [&](const Eigen::Vector3i& start, int length) {
      const auto from = dense.begin() + grid_.offset(start);
      if (!content && std::all_of(from, from + length, [](Label label) { return label == 0; })) return;
      if (!content) content = std::make_shared<Brick>(Brick{});
      std::copy(from, from + length, content->begin() + static_cast<std::ptrdiff_t>(within_brick(start)));
    });
    brick_[number] = std::move(content);
  });
}

std::size_t LabelVolume::brick_of(const Eigen::Vector3i& v) const {
  return static_cast<std::size_t>(v.x() / kSide) +
         static_cast<std::size_t>(bricks_.x()) *
             (static_cast<std::size_t>(v.y() / kSide) +
              static_cast<std::size_t>(bricks_.y()) * static_cast<std::size_t>(v.z() / kSide));
}

Label LabelVolume::at(const Eigen::Vector3i& v) const {
  require(grid_.contains(v), "a voxel that is read lies in the volume");
  const auto& brick = brick_[brick_of(v)];
  return brick ? (*brick)[within_brick(v)] : Label{0};
}

void LabelVolume::set(const Eigen::Vector3i& v, Label label) {
  require(grid_.contains(v), "a voxel that is written lies in the volume");
  std::shared_ptr<const Brick>& brick = brick_[brick_of(v)];
  const std::size_t i = within_brick(v);
  if ((brick ? (*brick)[i] : Label{0}) == label) return;
  {
    // Counted through a second reference: taking it orders us after the last reader's release of its copy.
    const std::shared_ptr<const Brick> mine = brick;
    if (mine.use_count() == 2) {
      // Ours alone, and made non-const by make_shared, so that writing through is defined.
      (*std::const_pointer_cast<Brick>(mine))[i] = label;
      return;
    }
  }
  auto copy = brick ? std::make_shared<Brick>(*brick) : std::make_shared<Brick>(Brick{});
  (*copy)[i] = label;
  brick = std::move(copy);
}

std::vector<Label> LabelVolume::dense() const {
  std::vector<Label> values(static_cast<std::size_t>(grid_.voxel_count()), 0);
  for_each_brick(bricks_, [&](const Eigen::Vector3i& brick, std::size_t number) {
    if (!brick_[number]) return;
    for_each_row(grid_, brick, [&](const Eigen::Vector3i& start, int length) {
      const auto from = brick_[number]->begin() + static_cast<std::ptrdiff_t>(within_brick(start));
      std::copy(from, from + length, values.begin() + grid_.offset(start));
    });
  });
  return values;
}

std::vector<std::uint8_t> LabelVolume::mask(const std::function<bool(Label)>& wanted) const {
  std::vector<std::uint8_t> answer(65536);
  const std::vector<long> counts = histogram();
  for (std::size_t label = 0; label < counts.size(); ++label)
    answer[label] = counts[label] > 0 && wanted(static_cast<Label>(label)) ? 1 : 0;
  std::vector<std::uint8_t> values(static_cast<std::size_t>(grid_.voxel_count()), answer[0]);
  for_each_brick(bricks_, [&](const Eigen::Vector3i& brick, std::size_t number) {
    if (!brick_[number]) return;
    for_each_row(grid_, brick, [&](const Eigen::Vector3i& start, int length) {
      const auto from = brick_[number]->begin() + static_cast<std::ptrdiff_t>(within_brick(start));
      std::transform(from, from + length, values.begin() + grid_.offset(start),
                     [&](Label label) { return answer[label]; });
    });
  });
  return values;
}

std::vector<long> LabelVolume::histogram() const {
  std::vector<long> counts(65536, 0);
  for_each_brick(bricks_, [&](const Eigen::Vector3i& brick, std::size_t number) {
    for_each_row(grid_, brick, [&](const Eigen::Vector3i& start, int length) {
      if (!brick_[number]) {
        counts[0] += length;
        return;
      }
      const Label* from = brick_[number]->data() + within_brick(start);
      for (int i = 0; i < length; ++i) ++counts[from[i]];
    });
  });
  while (!counts.empty() && counts.back() == 0) counts.pop_back();
  return counts;
}

int LabelVolume::bricks_differing_from(const LabelVolume& other) const {
  require(bricks_ == other.bricks_, "volumes whose bricks are compared have one size");
  int count = 0;
  for (std::size_t i = 0; i < brick_.size(); ++i) count += brick_[i] != other.brick_[i];
  return count;
}

Eigen::Vector3i LabelVolume::brick_place(std::size_t number) const {
  require(number < brick_.size(), "a brick that is asked for is one of the volume");
  const int n = static_cast<int>(number);
  return {n % bricks_.x(), (n / bricks_.x()) % bricks_.y(), n / (bricks_.x() * bricks_.y())};
}

void LabelVolume::set_brick(std::size_t number, std::shared_ptr<const Brick> brick) {
  require(number < brick_.size(), "a brick that is replaced is one of the volume");
  brick_[number] = std::move(brick);
}

LabelChanges LabelVolume::changes_since(const LabelVolume& before) const {
  require(bricks_ == before.bricks_, "volumes whose bricks are compared have one size");
  LabelChanges changes;
  for (std::size_t i = 0; i < brick_.size(); ++i)
    if (!same_content(before.brick_[i], brick_[i])) changes.push_back({i, before.brick_[i], brick_[i]});
  return changes;
}

void LabelVolume::apply(const LabelChanges& changes, bool back) {
  for (const LabelChange& change : changes) set_brick(change.number, back ? change.before : change.after);
}

bool LabelVolume::operator==(const LabelVolume& other) const {
  if (!grid_.same_as(other.grid_)) return false;
  for (std::size_t i = 0; i < brick_.size(); ++i)
    if (!same_content(brick_[i], other.brick_[i])) return false;
  return true;
}

}  // namespace glisson
