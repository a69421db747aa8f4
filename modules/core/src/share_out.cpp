// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/share_out.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <thread>

namespace glisson {
namespace {

/// The piece that a thread has failed at.
struct Failure {
  std::size_t piece = 0;
  std::exception_ptr error;
};

}  // namespace

void share_out(std::size_t pieces, int threads,
               const std::function<void(std::size_t piece, bool here)>& work) {
  std::atomic<std::size_t> next{0};
  Failure own, others;
  const auto take = [&](bool here, Failure& failure) {
    for (std::size_t piece = next++; piece < pieces; piece = next++) {
      try {
        work(piece, here);
      } catch (...) {
        failure = {piece, std::current_exception()};
        next = pieces;
      }
    }
  };
  std::thread beside;
  if (threads > 1 && pieces > 1) beside = std::thread(take, false, std::ref(others));
  take(true, own);
  if (beside.joinable()) beside.join();
  const Failure& first = own.error && (!others.error || own.piece < others.piece) ? own : others;
  if (first.error) std::rethrow_exception(first.error);
}

void share_out_runs(std::size_t count, std::size_t least,
                    const std::function<void(std::size_t first, std::size_t end)>& work) {
  // Several runs a thread, so that one which has less to do takes more of them.
  constexpr std::size_t kMost = 16;
  const std::size_t length = std::max({std::size_t{1}, least, (count + kMost - 1) / kMost});
  share_out((count + length - 1) / length, 2,
            [&](std::size_t piece, bool) { work(piece * length, std::min(count, (piece + 1) * length)); });
}

}  // namespace glisson
