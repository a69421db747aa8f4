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

}  // namespace glisson
