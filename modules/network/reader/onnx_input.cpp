// SPDX-License-Identifier: GPL-3.0-or-later
#include "onnx_input.h"

#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace glisson::network::reader {
namespace {

// Field numbers of onnx.proto.
constexpr int kGraph = 7, kInitializer = 5, kInput = 11, kTensorName = 8, kValueName = 1, kValueType = 2,
              kTensorType = 1, kTensorShape = 2, kDimension = 1, kDimensionValue = 1;

/// One field of a message: a number, or bytes.
struct Field {
  int number = 0;
  std::uint64_t value = 0;
  std::string_view bytes = {};
};

/// Goes over the fields of a message; ends at the first that is malformed.
class Message {
 public:
  explicit Message(std::string_view bytes) : left_(bytes) {}

  bool next(Field& field) {
    std::uint64_t key = 0;
    if (left_.empty() || !varint(key)) return false;
    field = {};
    field.number = static_cast<int>(key >> 3U & 0x1FFFFFFFU);
    switch (key & 7U) {
      case 0:
        return varint(field.value);
      case 1:
        return take(8, field.bytes);
      case 2:
        return varint(field.value) && take(field.value, field.bytes);
      case 5:
        return take(4, field.bytes);
      default:
        return false;
    }
  }

 private:
  bool varint(std::uint64_t& value) {
    value = 0;
    for (unsigned shift = 0; shift < 64 && !left_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(left_.front());
      left_.remove_prefix(1);
      value |= static_cast<std::uint64_t>(byte & 127U) << shift;
      if (byte < 128) return true;
    }
    return false;
  }
  bool take(std::uint64_t count, std::string_view& bytes) {
    if (count > left_.size()) return false;
    bytes = left_.substr(0, count);
    left_.remove_prefix(count);
    return true;
  }

  std::string_view left_;
};

/// The bytes of the last field of this number; protocol buffers let the last one count.
std::string_view inside(std::string_view message, int number) {
  std::string_view found;
  Field field;
  for (Message fields(message); fields.next(field);)
    if (field.number == number) found = field.bytes;
  return found;
}

void each(std::string_view message, int number, const std::function<void(std::string_view)>& work) {
  Field field;
  for (Message fields(message); fields.next(field);)
    if (field.number == number) work(field.bytes);
}

std::int32_t dimension(std::string_view bytes) {
  Field field;
  for (Message fields(bytes); fields.next(field);)
    if (field.number == kDimensionValue && field.bytes.empty() && field.value > 0 &&
        field.value <= static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max()))
      return static_cast<std::int32_t>(field.value);
  return -1;  // open, or has a name
}

}  // namespace

LoadAnswer onnx_input(std::string_view file) {
  LoadAnswer answer;
  const std::string_view graph = inside(file, kGraph);
  std::set<std::string_view> weights;
  each(graph, kInitializer, [&](std::string_view tensor) { weights.insert(inside(tensor, kTensorName)); });
  each(graph, kInput, [&](std::string_view value) {
    if (weights.contains(inside(value, kValueName)) || answer.inputs++ > 0) return;
    const std::string_view tensor = inside(inside(value, kValueType), kTensorType);
    std::vector<std::int32_t> shape;
    each(inside(tensor, kTensorShape), kDimension,
         [&](std::string_view bytes) { shape.push_back(dimension(bytes)); });
    if (shape.size() > static_cast<std::size_t>(kMostRank)) return;
    answer.rank = static_cast<std::int32_t>(shape.size());
    std::copy(shape.begin(), shape.end(), answer.shape.begin());
  });
  return answer;
}

}  // namespace glisson::network::reader
