// SPDX-License-Identifier: GPL-3.0-or-later
#include "compressed.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

#include "glisson/core/error.h"

namespace glisson {
namespace {

constexpr int kLevel = 3;  // a CT shrinks by hardly more at 9, in five times the time
constexpr std::size_t kChunk = 1u << 20;

}  // namespace

std::string compressed(const void* data, std::size_t size, Wrapper wrapper) {
  z_stream stream{};
  const int window = wrapper == Wrapper::gzip ? 15 + 16 : 15;
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, window, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw NumericalError("zlib could not be started for lack of memory.");
  std::string result;
  std::vector<char> out(kChunk);
  const char* from = static_cast<const char*>(data);
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    const std::size_t part = std::min(size, kChunk);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(from));  // zlib only reads it
    stream.avail_in = static_cast<uInt>(part);
    from += part;
    size -= part;
    do {
      stream.next_out = reinterpret_cast<Bytef*>(out.data());
      stream.avail_out = static_cast<uInt>(out.size());
      state = deflate(&stream, size == 0 ? Z_FINISH : Z_NO_FLUSH);
      result.append(out.data(), out.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  deflateEnd(&stream);
  return result;
}

}  // namespace glisson
