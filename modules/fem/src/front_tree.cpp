// SPDX-License-Identifier: GPL-3.0-or-later
#include "front_tree.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace glisson::fem {
namespace {

/// Rows of each column of the factor below the diagonal (blocks), column by column.
std::vector<std::vector<int>> factor_rows(const BlockPattern& pattern) {
  const auto n = static_cast<std::size_t>(pattern.unknowns);
  std::vector<std::vector<int>> rows(n), children(n);
  for (std::size_t c = 0; c < n; ++c) {
    std::vector<int>& list = rows[c];
    list.assign(pattern.rows.begin() + pattern.column_start[c] + 1,
                pattern.rows.begin() + pattern.column_start[c + 1]);
    for (const int child : children[c])
      list.insert(list.end(), rows[static_cast<std::size_t>(child)].begin() + 1,
                  rows[static_cast<std::size_t>(child)].end());
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    if (!list.empty()) children[static_cast<std::size_t>(list.front())].push_back(static_cast<int>(c));
  }
  return rows;
}

/// Seconds that a front takes, about: what decides which fronts join. Measured on the kernels here.
double front_cost(double columns, double rows) {
  const double k = 3.0 * columns, m = 3.0 * rows;
  const double operations = k * k * k / 3.0 + k * k * m + k * m * m;
  return 0.5e-6 + operations / 14e9 + (k * m + 0.5 * m * m) * 0.6e-9;
}

struct Group {
  int first, columns;
  std::vector<int> rows;
};

}  // namespace

std::vector<Front> build_fronts(const BlockPattern& pattern) {
  const auto rows = factor_rows(pattern);
  std::vector<Group> groups;
  for (int c = 0; c < pattern.unknowns; ++c) {
    groups.push_back({c, 1, rows[static_cast<std::size_t>(c)]});
    while (groups.size() > 1) {
      Group& child = groups[groups.size() - 2];
      Group& parent = groups.back();
      if (child.rows.empty() || child.rows.front() != parent.first) break;
      const auto below = static_cast<double>(parent.rows.size());
      const double apart = front_cost(child.columns, static_cast<double>(child.rows.size())) +
                           front_cost(parent.columns, below);
      if (front_cost(child.columns + parent.columns, below) > apart) break;
      child.columns += parent.columns;
      child.rows = std::move(parent.rows);
      groups.pop_back();
    }
  }
  std::vector<Front> fronts(groups.size());
  std::vector<int> front_of_column(static_cast<std::size_t>(pattern.unknowns));
  for (std::size_t f = 0; f < groups.size(); ++f) {
    fronts[f].first = groups[f].first;
    fronts[f].columns = groups[f].columns;
    fronts[f].rows = std::move(groups[f].rows);
    for (int c = 0; c < fronts[f].columns; ++c)
      front_of_column[static_cast<std::size_t>(fronts[f].first + c)] = static_cast<int>(f);
  }
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    Front& front = fronts[f];
    if (front.rows.empty()) continue;
    front.parent = front_of_column[static_cast<std::size_t>(front.rows.front())];
    Front& parent = fronts[static_cast<std::size_t>(front.parent)];
    parent.children.push_back(static_cast<int>(f));
    for (const int row : front.rows) {
      if (row < parent.first + parent.columns) {
        front.place_in_parent.push_back(row - parent.first);
      } else {
        const auto at = std::lower_bound(parent.rows.begin(), parent.rows.end(), row);
        front.place_in_parent.push_back(parent.columns + static_cast<int>(at - parent.rows.begin()));
      }
    }
  }
  return fronts;
}

double front_work(const Front& front) {
  const double k = 3.0 * front.columns, m = 3.0 * static_cast<double>(front.rows.size());
  return k * k * k / 6.0 + 0.5 * k * k * m + 0.5 * k * m * m;
}

FrontGroups in_one_go(const std::vector<Front>& fronts) {
  FrontGroups groups(1, std::vector<int>(fronts.size()));
  std::iota(groups[0].begin(), groups[0].end(), 0);
  return groups;
}

FrontGroups share_out(const std::vector<Front>& fronts) {
  // Above the subtrees the threads share a front's rows, which goes less well.
  constexpr double kAbove = 0.65;
  constexpr int kMostAbove = 100;
  std::vector<double> below;  // work of a front's whole subtree
  std::vector<int> subtrees;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    below.push_back(front_work(fronts[f]));
    for (const int child : fronts[f].children) below[f] += below[static_cast<std::size_t>(child)];
    if (fronts[f].parent < 0) subtrees.push_back(static_cast<int>(f));
  }
  const auto larger = [&](int a, int b) {
    const double one = below[static_cast<std::size_t>(a)], other = below[static_cast<std::size_t>(b)];
    return one > other || (one == other && a < b);
  };
  std::vector<int> side(fronts.size(), 2), best;  // of the subtrees' roots; 2: above
  double above = 0.0, least = std::numeric_limits<double>::infinity();
  for (int split = 0; split < kMostAbove && !subtrees.empty(); ++split) {
    std::sort(subtrees.begin(), subtrees.end(), larger);
    double load[2] = {0.0, 0.0};
    for (const int root : subtrees) {
      const int to = load[1] < load[0] ? 1 : 0;
      load[to] += below[static_cast<std::size_t>(root)];
      side[static_cast<std::size_t>(root)] = to;
    }
    const double takes = std::max(load[0], load[1]) + kAbove * above;
    if (takes < least) {
      least = takes;
      best = side;
      for (std::size_t f = fronts.size(); f-- > 0;) {  // what hangs on a root goes with it
        const int parent = fronts[f].parent;
        if (parent >= 0 && best[static_cast<std::size_t>(parent)] < 2)
          best[f] = best[static_cast<std::size_t>(parent)];
      }
    }
    const int largest = subtrees.front();
    side[static_cast<std::size_t>(largest)] = 2;
    above += front_work(fronts[static_cast<std::size_t>(largest)]);
    subtrees.erase(subtrees.begin());
    const auto& children = fronts[static_cast<std::size_t>(largest)].children;
    subtrees.insert(subtrees.end(), children.begin(), children.end());
  }
  FrontGroups groups(3);
  for (std::size_t f = 0; f < fronts.size(); ++f)
    groups[static_cast<std::size_t>(best[f])].push_back(static_cast<int>(f));
  return groups;
}

std::vector<std::size_t> plan_memory(const std::vector<Front>& fronts, const FrontGroups& groups,
                                     const std::vector<std::size_t>& sizes, std::size_t* total) {
  std::vector<std::size_t> offsets(fronts.size(), 0);
  *total = 0;
  for (const std::vector<int>& group : groups) {
    const std::size_t begin = *total;
    std::map<std::size_t, std::size_t> taken;  // offset to end
    for (const int front : group) {
      const auto f = static_cast<std::size_t>(front);
      if (sizes[f] > 0) {
        std::size_t at = begin;
        for (const auto& [first, last] : taken) {
          if (first >= at + sizes[f]) break;
          at = last;
        }
        taken[at] = at + sizes[f];
        offsets[f] = at;
        *total = std::max(*total, at + sizes[f]);
      }
      for (const int child : fronts[f].children) {
        const auto c = static_cast<std::size_t>(child);
        const auto at = taken.find(offsets[c]);
        if (sizes[c] > 0 && at != taken.end()) taken.erase(at);
      }
    }
  }
  return offsets;
}

}  // namespace glisson::fem
