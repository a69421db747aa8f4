// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// Other times in a Matroska file (RFC 9559), written from the format's description: the reader under test is
/// another one.
namespace glisson::test {

/// Walks the elements and rewrites the time of each block and the stated duration, milliseconds.
class Retimer {
 public:
  Retimer(std::string content, std::vector<int> times, double duration)
      : content_(std::move(content)), times_(std::move(times)), duration_(duration) {
    walk(0, content_.size());
  }
  const std::string& content() const { return content_; }
  std::size_t blocks() const { return next_; }

 private:
  std::uint8_t byte(std::size_t at) const { return static_cast<std::uint8_t>(content_[at]); }
  /// A number of variable length. @param marked with its length's bit, as ids are told.
  std::uint64_t number(std::size_t& at, bool marked) const {
    const int length = std::countl_zero(byte(at)) + 1;
    std::uint64_t value = marked ? byte(at) : byte(at) & (0xffU >> length);
    for (int k = 1; k < length; ++k) value = value << 8U | byte(at + static_cast<std::size_t>(k));
    at += static_cast<std::size_t>(length);
    return value;
  }
  void walk(std::size_t at, std::size_t end) {
    constexpr std::uint64_t kSegment = 0x18538067, kInfo = 0x1549A966, kCluster = 0x1F43B675, kGroup = 0xA0,
                            kBlock = 0xA1, kSimpleBlock = 0xA3, kDuration = 0x4489;
    while (at + 2 < end) {
      const std::uint64_t id = number(at, true), told = number(at, false);
      const std::size_t size = std::min<std::uint64_t>(told, end - at);  // unknown: to the end
      if (id == kSegment || id == kInfo || id == kCluster || id == kGroup) walk(at, at + size);
      if ((id == kBlock || id == kSimpleBlock) && next_ < times_.size()) {
        const auto time = static_cast<std::uint16_t>(times_[next_++]);
        content_[at + 1] = static_cast<char>(time >> 8U);  // after the track's number, of one byte
        content_[at + 2] = static_cast<char>(time & 0xffU);
      }
      if (id == kDuration && size == 8) {
        const auto bits = std::bit_cast<std::uint64_t>(duration_);
        for (std::size_t k = 0; k < 8; ++k)
          content_[at + k] = static_cast<char>(bits >> (56U - 8U * k) & 0xffU);
      }
      at += size;
    }
  }

  std::string content_;
  std::vector<int> times_;
  double duration_;
  std::size_t next_ = 0;
};

}  // namespace glisson::test
