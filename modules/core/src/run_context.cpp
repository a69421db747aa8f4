// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/run_context.h"

#include <algorithm>
#include <utility>

namespace glisson {

RunContext::RunContext() = default;

RunContext::RunContext(ProgressSink sink, std::shared_ptr<const CancelFlag> cancel, std::uint64_t seed)
    : sink_(std::move(sink)), cancel_(std::move(cancel)), seed_(seed) {}

void RunContext::progress(double fraction, std::string_view stage) const {
  if (sink_) sink_(from_ + (to_ - from_) * std::clamp(fraction, 0.0, 1.0), stage);
}

std::mt19937_64 RunContext::random(std::string_view purpose) const {
  // FNV-1a over the purpose, then the seed: std::hash may differ between libraries, this may not.
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : purpose) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 1099511628211ULL;
  }
  std::seed_seq sequence{static_cast<std::uint32_t>(hash), static_cast<std::uint32_t>(hash >> 32),
                         static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)};
  return std::mt19937_64(sequence);
}

RunContext RunContext::part(double from, double to) const {
  RunContext inner = *this;
  inner.from_ = from_ + (to_ - from_) * from;
  inner.to_ = from_ + (to_ - from_) * to;
  return inner;
}

RunContext RunContext::quiet() const { return RunContext({}, cancel_, seed_); }

}  // namespace glisson
