// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_votes.h"

#include <algorithm>
#include <cmath>

namespace glisson::editing {

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

Quiet::Quiet(const Block& block, const Eigen::Vector3d& spacing_mm, double radius_mm) {
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
      for (int i = 0; i < cells_.x(); ++i) quiet_[place(i, j, k)] = one_label(held, {i, j, k}, reach) ? 1 : 0;
}

bool Quiet::one_label(const std::vector<std::int32_t>& held, const Eigen::Vector3i& cell,
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

Votes::Votes(const Block& block, const std::vector<BallRow>& ball) : block_(block), ball_(ball) {
  std::vector<bool> present(65536, false);
  for (const Label label : block.labels) present[label] = true;
  for (std::size_t label = 0; label < present.size(); ++label)
    if (present[label]) labels_.push_back(static_cast<Label>(label));
  count_.resize(static_cast<std::size_t>(labels_.back()) + 1);
}

void Votes::start_row(int j, int k) {
  const Eigen::Vector3i size = block_.box.size();
  rows_.clear();
  for (const BallRow& row : ball_)
    if (j + row.j >= 0 && j + row.j < size.y() && k + row.k >= 0 && k + row.k < size.z())
      rows_.emplace_back(block_.labels.data() + block_.offset(0, j + row.j, k + row.k), row.half);
  at_ = -2;
}

void Votes::move_to(int i) {
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

Label Votes::winner(Label here) const {
  Label best = here;
  for (const Label label : labels_)
    if (count_[label] > count_[best]) best = label;
  return best;
}

}  // namespace glisson::editing
