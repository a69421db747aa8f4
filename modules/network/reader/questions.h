// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

/// @file
/// What glisson-run-network is asked and what it answers, as bytes of one machine.

namespace glisson::network::reader {

constexpr int kMostRank = 5;
using Shape = std::array<std::int32_t, kMostRank>;  ///< the first `rank` of them count

/// First: the ONNX file's bytes follow.
struct LoadQuestion {
  std::uint64_t bytes = 0;
};
/// `said` letters follow: why it cannot be read.
struct LoadAnswer {
  std::int32_t loaded = 0;
  std::int32_t inputs = 0;  ///< that are no weights
  std::int32_t rank = 0;    ///< of the first; 0: the file does not say it, or it is more than kMostRank
  std::int32_t said = 0;
  Shape shape = {};  ///< -1: left open
};

/// Then, again and again: the input's values follow.
struct RunQuestion {
  std::int32_t rank = 0;
  Shape shape = {};
};
/// `said` letters follow, or the output's values.
struct RunAnswer {
  std::int32_t ran = 0;
  std::int32_t rank = 0;
  std::int32_t said = 0;
  Shape shape = {};
};

constexpr std::int32_t kMostSaid = 300;  ///< letters

}  // namespace glisson::network::reader
