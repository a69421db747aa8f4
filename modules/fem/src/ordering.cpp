// SPDX-License-Identifier: GPL-3.0-or-later
#include "ordering.h"

#include <cholmod.h>

#include <limits>

#include "glisson/core/error.h"

namespace glisson::fem {

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
