// SPDX-License-Identifier: GPL-3.0-or-later
#include "ordering.h"

#include <cholmod.h>

#include <algorithm>
#include <limits>
#include <mutex>

#include "glisson/core/error.h"

namespace glisson::fem {
namespace {

/// Appends what can be reached from `start` in breadth-first order. @return the last one reached.
int visit_from(int start, const std::vector<std::vector<int>>& neighbours, std::vector<char>& seen,
               std::vector<int>& order) {
  std::size_t at = order.size();
  order.push_back(start);
  seen[static_cast<std::size_t>(start)] = 1;
  std::vector<int> fresh;
  for (; at < order.size(); ++at) {
    fresh.clear();
    for (const int j : neighbours[static_cast<std::size_t>(order[at])])
      if (!seen[static_cast<std::size_t>(j)]) {
        seen[static_cast<std::size_t>(j)] = 1;
        fresh.push_back(j);
      }
    std::stable_sort(fresh.begin(), fresh.end(), [&](int a, int b) {
      return neighbours[static_cast<std::size_t>(a)].size() < neighbours[static_cast<std::size_t>(b)].size();
    });
    order.insert(order.end(), fresh.begin(), fresh.end());
  }
  return order.back();
}

}  // namespace

std::vector<int> breadth_first_order(const std::vector<std::vector<int>>& neighbours) {
  std::vector<int> order;
  order.reserve(neighbours.size());
  std::vector<char> seen(neighbours.size(), 0);
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    if (seen[i]) continue;
    // Twice to the far end: the rim of this component.
    int start = static_cast<int>(i);
    for (int pass = 0; pass < 2; ++pass) {
      std::vector<char> tried(seen);
      std::vector<int> reached;
      start = visit_from(start, neighbours, tried, reached);
    }
    visit_from(start, neighbours, seen, order);
  }
  return order;
}

std::vector<int> fill_reducing_order(const std::vector<std::vector<int>>& neighbours) {
  const std::size_t n = neighbours.size();
  std::size_t count = n;
  for (std::size_t i = 0; i < n; ++i)
    for (const int j : neighbours[i]) count += static_cast<std::size_t>(j) > i;
  cholmod_common common;
  cholmod_start(&common);
  cholmod_sparse* graph = cholmod_allocate_sparse(n, n, count, true, true, -1, CHOLMOD_PATTERN, &common);
  auto* start = static_cast<int*>(graph->p);
  auto* rows = static_cast<int*>(graph->i);
  int at = 0;
  for (std::size_t i = 0; i < n; ++i) {
    start[i] = at;
    rows[at++] = static_cast<int>(i);
    for (const int j : neighbours[i])
      if (static_cast<std::size_t>(j) > i) rows[at++] = j;
  }
  start[n] = at;
  graph->sorted = false;
  // METIS draws from the C library's one random generator: two analyses at once would change each other's
  // order, and with it the last bits of every result.
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  std::vector<int> best;
  double best_operations = std::numeric_limits<double>::infinity();
  for (const int ordering : {CHOLMOD_AMD, CHOLMOD_METIS}) {
    common.nmethods = 1;
    common.method[0].ordering = ordering;
    common.postorder = true;
    common.supernodal = CHOLMOD_SIMPLICIAL;
    cholmod_factor* factor = cholmod_analyze(graph, &common);
    if (factor == nullptr) continue;
    if (common.fl < best_operations) {
      best_operations = common.fl;
      const auto* order = static_cast<const int*>(factor->Perm);
      best.assign(order, order + n);
    }
    cholmod_free_factor(&factor, &common);
  }
  cholmod_free_sparse(&graph, &common);
  cholmod_finish(&common);
  if (best.size() != n) throw NumericalError("No elimination order was found for the mechanics' matrix.");
  return best;
}

}  // namespace glisson::fem
