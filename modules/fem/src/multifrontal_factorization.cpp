// SPDX-License-Identifier: GPL-3.0-or-later
#include "multifrontal_factorization.h"

#include <algorithm>

namespace glisson::fem {
namespace {

constexpr double kWorthACompanion = 25e6;  ///< multiplications of a whole factor: about 4 ms
constexpr double kWorthAHalf = 0.5e6;      ///< of a piece: some 80 us

int round_up_8(int n) { return (n + 7) & ~7; }

}  // namespace

MultifrontalFactorization::MultifrontalFactorization(const BlockPattern& pattern, int threads,
                                                     const DenseKernels& kernels)
    : kernels_(kernels), fronts_(build_fronts(pattern)) {
  double work = 0.0;
  for (const Front& front : fronts_) work += front_work(front);
  if (threads > 1 && work > kWorthACompanion) companion_ = std::make_unique<Companion>();
  groups_ = companion_ ? share_out(fronts_) : in_one_go(fronts_);
  std::size_t panel_space = 0, most_rows = 0;
  std::vector<std::size_t> schur_sizes;
  for (const Front& front : fronts_) {
    Layout layout{};
    layout.columns = 3 * front.columns;
    layout.rows = 3 * static_cast<int>(front.rows.size());
    layout.stride_schur = round_up_8(layout.rows);
    layout.stride = round_up_8(layout.columns + layout.stride_schur);
    // Columns that lie a multiple of 4 kB apart fall into the same few cache sets.
    if (layout.stride % 256 == 0) layout.stride += 8;
    layout.panel = panel_space;
    panel_space += static_cast<std::size_t>(layout.stride) * static_cast<std::size_t>(layout.columns);
    schur_sizes.push_back(static_cast<std::size_t>(layout.stride_schur) *
                          static_cast<std::size_t>(layout.rows));
    most_rows = std::max(most_rows, static_cast<std::size_t>(layout.stride_schur));
    layout.runs = runs_.size();
    for (std::size_t r = 0; r < front.place_in_parent.size(); ++r) {
      const int to = 3 * front.place_in_parent[r];
      // A run may not cross from the parent's columns into its rows: they are stored apart.
      const bool joins = r > 0 && runs_.back().to + runs_.back().length == to &&
                         front.place_in_parent[r] != fronts_[static_cast<std::size_t>(front.parent)].columns;
      if (joins)
        runs_.back().length += 3;
      else
        runs_.push_back({3 * static_cast<int>(r), to, 3});
    }
    layout.run_count = runs_.size() - layout.runs;
    layouts_.push_back(layout);
  }
  std::size_t schur_space = 0;
  const std::vector<std::size_t> offsets = plan_memory(fronts_, groups_, schur_sizes, &schur_space);
  panels_.assign(panel_space + 64, 0.0);
  schur_.assign(schur_space + 64, 0.0);
  below_.assign(most_rows, 0.0);
  below_theirs_.assign(companion_ ? most_rows : 0, 0.0);
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    const Front& front = fronts_[f];
    layouts_[f].schur = offsets[f];
    block_start_.push_back(pattern.column_start[static_cast<std::size_t>(front.first)]);
    for (int c = 0; c < front.columns; ++c) {
      const auto column = static_cast<std::size_t>(front.first + c);
      for (int b = pattern.column_start[column]; b < pattern.column_start[column + 1]; ++b) {
        const int row = pattern.rows[static_cast<std::size_t>(b)];
        const int place = row < front.first + front.columns
                              ? row - front.first
                              : front.columns + static_cast<int>(std::lower_bound(front.rows.begin(),
                                                                                  front.rows.end(), row) -
                                                                 front.rows.begin());
        block_targets_.push_back(layouts_[f].panel + static_cast<std::size_t>(3 * place) +
                                 static_cast<std::size_t>(3 * c) *
                                     static_cast<std::size_t>(layouts_[f].stride));
      }
    }
  }
  block_start_.push_back(pattern.block_count());
}

void MultifrontalFactorization::load_panel(std::size_t f, const std::vector<double>& values) {
  const Layout& layout = layouts_[f];
  double* panel = panels_.data() + layout.panel;
  std::fill_n(panel, static_cast<std::size_t>(layout.stride) * static_cast<std::size_t>(layout.columns), 0.0);
  for (auto b = static_cast<std::size_t>(block_start_[f]); b < static_cast<std::size_t>(block_start_[f + 1]);
       ++b) {
    const double* source = values.data() + 9 * b;
    double* target = panels_.data() + block_targets_[b];
    for (int k = 0; k < 3; ++k, source += 3, target += layout.stride) {
      target[0] = source[0];
      target[1] = source[1];
      target[2] = source[2];
    }
  }
}

void MultifrontalFactorization::add_child(std::size_t child, std::size_t parent) {
  const Layout &from = layouts_[child], &to = layouts_[parent];
  const double* source = schur_.data() + from.schur;
  const Run* runs = runs_.data() + from.runs;
  for (std::size_t a = 0; a < from.run_count; ++a)
    for (int c = 0; c < runs[a].length; ++c) {
      const int column = runs[a].to + c;
      const bool in_panel = column < to.columns;
      double* target = in_panel ? panels_.data() + to.panel + static_cast<std::ptrdiff_t>(column) * to.stride
                                : schur_.data() + to.schur - to.columns +
                                      static_cast<std::ptrdiff_t>(column - to.columns) * to.stride_schur;
      const double* entries = source + static_cast<std::ptrdiff_t>(runs[a].from + c) * from.stride_schur;
      // From the diagonal down: what is above is scratch.
      for (int i = c; i < runs[a].length; ++i) target[runs[a].to + i] += entries[runs[a].from + i];
      for (std::size_t b = a + 1; b < from.run_count; ++b) {
        double* t = target + runs[b].to;
        const double* e = entries + runs[b].from;
        for (int i = 0; i < runs[b].length; ++i) t[i] += e[i];
      }
    }
}

template <class Work>
void MultifrontalFactorization::by_rows(bool shared, int from, int to, double worth, const Work& work) {
  const int middle = from + round_up_8((to - from) / 2);
  if (!shared || worth < kWorthAHalf || middle >= to)
    work(from, to);
  else
    companion_->together([&] { work(from, middle); }, [&] { work(middle, to); });
}

bool MultifrontalFactorization::factor_panel(const Layout& layout, bool shared) {
  double* panel = panels_.data() + layout.panel;
  const int stride = layout.stride;
  double inverse[kPanelBlock];
  for (int first = 0; first < layout.columns; first += kPanelBlock) {
    const int width = std::min(kPanelBlock, layout.columns - first);
    const int own = std::min(stride, round_up_8(first + width));
    const double below = stride - own;
    if (first > 0)
      by_rows(shared, first & ~7, stride, below * width * first,
              [&](int from, int to) { kernels_.update_block(panel, stride, first, width, from, to); });
    const double worth = 0.5 * below * width * width;
    const bool halves = shared && worth >= kWorthAHalf;
    if (!kernels_.factor_block(panel, stride, first, width, halves ? own : stride, inverse)) return false;
    if (halves)
      by_rows(shared, own, stride, worth, [&](int from, int to) {
        kernels_.solve_block(panel, stride, first, width, from, to, inverse);
      });
  }
  return true;
}

void MultifrontalFactorization::subtract_product(const Layout& layout, bool shared) {
  const double* panel = panels_.data() + layout.panel;
  double* schur = schur_.data() + layout.schur;
  const auto work = [&](int from, int to) {
    kernels_.subtract_product(schur, layout.stride_schur, from, to, panel, layout.stride, layout.columns);
  };
  const double size = layout.rows;
  // The first columns of a triangle are the longest: half the work is in 1 - 1/sqrt(2) of them.
  const int half = 6 * static_cast<int>(0.293 * size / 6.0);
  if (!shared || 0.5 * size * size * layout.columns < kWorthAHalf)
    work(0, layout.rows);
  else
    companion_->together([&] { work(0, half); }, [&] { work(half, layout.rows); });
}

bool MultifrontalFactorization::factorise_front(int front, const std::vector<double>& values, bool shared) {
  const auto f = static_cast<std::size_t>(front);
  const Layout& layout = layouts_[f];
  load_panel(f, values);
  std::fill_n(schur_.data() + layout.schur,
              static_cast<std::size_t>(layout.stride_schur) * static_cast<std::size_t>(layout.rows), 0.0);
  for (const int child : fronts_[f].children) add_child(static_cast<std::size_t>(child), f);
  if (!factor_panel(layout, shared)) return false;
  if (layout.rows > 0) subtract_product(layout, shared);
  return true;
}

bool MultifrontalFactorization::factorise(const std::vector<double>& values) {
  const auto in_order = [&](const std::vector<int>& group, bool shared) {
    return std::all_of(group.begin(), group.end(),
                       [&](int front) { return factorise_front(front, values, shared); });
  };
  if (!companion_) return in_order(groups_.front(), false);
  bool mine = false, theirs = false;
  companion_->together([&] { mine = in_order(groups_[0], false); },
                       [&] { theirs = in_order(groups_[1], false); });
  return mine && theirs && in_order(groups_[2], true);
}

void MultifrontalFactorization::backward(const std::vector<int>& group, Eigen::VectorXd& x,
                                         std::vector<double>& below) {
  for (auto front = group.rbegin(); front != group.rend(); ++front) {
    const auto f = static_cast<std::size_t>(*front);
    const Layout& layout = layouts_[f];
    const std::vector<int>& rows = fronts_[f].rows;
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t k = 0; k < 3; ++k) below[3 * r + k] = x[3 * rows[r] + static_cast<Eigen::Index>(k)];
    kernels_.backward(panels_.data() + layout.panel, layout.stride, layout.columns, layout.rows,
                      x.data() + 3 * fronts_[f].first, below.data());
  }
}

void MultifrontalFactorization::solve(Eigen::VectorXd& x) {
  // Forward by one thread: what two subtrees add to a row above them is added in one order.
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    const Layout& layout = layouts_[f];
    const std::vector<int>& rows = fronts_[f].rows;
    std::fill_n(below_.data(), layout.rows, 0.0);
    kernels_.forward(panels_.data() + layout.panel, layout.stride, layout.columns, layout.rows,
                     x.data() + 3 * fronts_[f].first, below_.data());
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t k = 0; k < 3; ++k) x[3 * rows[r] + static_cast<Eigen::Index>(k)] += below_[3 * r + k];
  }
  backward(groups_.back(), x, below_);
  if (companion_)
    companion_->together([&] { backward(groups_[0], x, below_); },
                         [&] { backward(groups_[1], x, below_theirs_); });
}

void MultifrontalFactorization::solve_chunk(RightHandSides& b, Eigen::Index first,
                                            std::vector<double>& buffer) {
  const Eigen::Index width = std::min<Eigen::Index>(kSolveWidth, b.cols() - first);
  const auto load = [&](int unknown, double* target) {
    std::copy_n(b.data() + unknown * b.cols() + first, width, target);
    std::fill(target + width, target + kSolveWidth, 0.0);
  };
  const auto store = [&](const double* source, int unknown) {
    std::copy_n(source, width, b.data() + unknown * b.cols() + first);
  };
  std::vector<char> touched(fronts_.size(), 0);
  for (std::size_t f = 0; f < fronts_.size(); ++f) {
    const Layout& layout = layouts_[f];
    const std::vector<int>& rows = fronts_[f].rows;
    const int start = 3 * fronts_[f].first;
    double* y = buffer.data();
    for (int k = 0; k < layout.columns; ++k) load(start + k, y + k * kSolveWidth);
    if (touched[f] == 0)
      touched[f] =
          std::any_of(y, y + layout.columns * kSolveWidth, [](double value) { return value != 0.0; });
    if (touched[f] == 0) continue;
    if (fronts_[f].parent >= 0) touched[static_cast<std::size_t>(fronts_[f].parent)] = 1;
    double* below = y + layout.columns * kSolveWidth;
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (int k = 0; k < 3; ++k)
        load(3 * rows[r] + k, below + (3 * static_cast<std::ptrdiff_t>(r) + k) * kSolveWidth);
    kernels_.forward_many(panels_.data() + layout.panel, layout.stride, layout.columns, layout.rows, y);
    for (int k = 0; k < layout.columns; ++k) store(y + k * kSolveWidth, start + k);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (int k = 0; k < 3; ++k)
        store(below + (3 * static_cast<std::ptrdiff_t>(r) + k) * kSolveWidth, 3 * rows[r] + k);
  }
  for (std::size_t f = fronts_.size(); f-- > 0;) {
    const Layout& layout = layouts_[f];
    const std::vector<int>& rows = fronts_[f].rows;
    const int start = 3 * fronts_[f].first;
    double* y = buffer.data();
    double* below = y + layout.columns * kSolveWidth;
    for (int k = 0; k < layout.columns; ++k) load(start + k, y + k * kSolveWidth);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (int k = 0; k < 3; ++k)
        load(3 * rows[r] + k, below + (3 * static_cast<std::ptrdiff_t>(r) + k) * kSolveWidth);
    kernels_.backward_many(panels_.data() + layout.panel, layout.stride, layout.columns, layout.rows, y);
    for (int k = 0; k < layout.columns; ++k) store(y + k * kSolveWidth, start + k);
  }
}

void MultifrontalFactorization::solve_many(RightHandSides& b) {
  std::size_t tallest = 0;
  for (const Layout& layout : layouts_)
    tallest = std::max(tallest, static_cast<std::size_t>(layout.columns + layout.rows));
  std::vector<double> buffer(tallest * kSolveWidth);
  for (Eigen::Index first = 0; first < b.cols(); first += kSolveWidth) solve_chunk(b, first, buffer);
}

}  // namespace glisson::fem
