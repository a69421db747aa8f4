// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

namespace glisson {

/// Shares out pieces of work that do not depend on each other to the calling thread and, of two, to one
/// beside it. Which thread takes which piece depends on time: so that the result does not, a piece writes to
/// a place of its own and draws no shared random numbers. Each thread takes the pieces in ascending order.
/// @param threads 1 or 2.
/// @param work is given a piece's number and whether it runs on the calling thread, from which alone progress
/// is told.
/// @throws what a piece has thrown (of two, that of the lower number), after both threads have ended; no
/// piece is begun after it.
void share_out(std::size_t pieces, int threads,
               const std::function<void(std::size_t piece, bool here)>& work);

/// Shares out the places 0 to `count` - 1 to two threads, in runs of consecutive ones: work(first, end). What
/// becomes of a place must not depend on the run that it is in.
/// @param least of places that are worth a run; where there is but one run, no thread is begun.
/// @throws as share_out().
void share_out_runs(std::size_t count, std::size_t least,
                    const std::function<void(std::size_t first, std::size_t end)>& work);

/// The least run of places of `samples` voxels or pixels each that takes longer than to begin a thread.
constexpr std::size_t least_run(std::size_t samples) {
  constexpr std::size_t kWorth = 30000;
  return samples == 0 ? kWorth : kWorth / samples;
}

}  // namespace glisson
