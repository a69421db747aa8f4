// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

/// ONNX networks made byte by byte (protocol buffers; field numbers of onnx.proto), so small that what they
/// answer is known exactly.
namespace glisson::test {

/// One message of protocol buffers.
class Proto {
 public:
  Proto& number(int field, std::uint64_t value) {
    varint(static_cast<std::uint64_t>(field) << 3U);
    varint(value);
    return *this;
  }
  Proto& text(int field, const std::string& value) {
    varint(static_cast<std::uint64_t>(field) << 3U | 2U);
    varint(value.size());
    bytes_ += value;
    return *this;
  }
  Proto& message(int field, const Proto& value) { return text(field, value.bytes_); }
  const std::string& bytes() const { return bytes_; }

 private:
  void varint(std::uint64_t value) {
    for (; value >= 128; value >>= 7U) bytes_ += static_cast<char>((value & 127U) | 128U);
    bytes_ += static_cast<char>(value);
  }
  std::string bytes_;
};

/// A network: one input, layers in a row, one output.
class OnnxNetwork {
 public:
  /// @param shape [1, channels, ...]; -1: left open.
  explicit OnnxNetwork(const std::vector<long>& shape) : shape_(shape) {}

  /// Kernels of one side along all dimensions, padded by zeros so that the size stays.
  /// @param weights output by output, in each input by input, in each rows of the kernel; one bias an output.
  OnnxNetwork& conv(int outputs, int inputs, int side, const std::vector<float>& weights,
                    const std::vector<float>& bias) {
    const std::size_t dimensions = shape_.size() - 2;
    std::vector<long> sides(dimensions, side), dims = {outputs, inputs};
    dims.insert(dims.end(), sides.begin(), sides.end());
    const std::string name = "w" + std::to_string(layers_);
    graph_.message(5, tensor(name, dims, weights)).message(5, tensor(name + "b", {outputs}, bias));
    outputs_ = outputs;
    return node("Conv", {name, name + "b"},
                {ints("kernel_shape", sides), ints("pads", std::vector<long>(2 * dimensions, side / 2)),
                 ints("strides", std::vector<long>(dimensions, 1)),
                 ints("dilations", std::vector<long>(dimensions, 1)), integer("group", 1)});
  }
  OnnxNetwork& sigmoid() { return node("Sigmoid", {}, {}); }
  OnnxNetwork& softmax() { return node("Softmax", {}, {integer("axis", 1)}); }
  OnnxNetwork& logarithm() { return node("Log", {}, {}); }
  /// Halves each dimension: an output of another size than the input.
  OnnxNetwork& halved() {
    const std::size_t dimensions = shape_.size() - 2;
    return node("MaxPool", {},
                {ints("kernel_shape", std::vector<long>(dimensions, 2)),
                 ints("strides", std::vector<long>(dimensions, 2)),
                 ints("pads", std::vector<long>(2 * dimensions, 0))});
  }
  /// A layer of a kind that nobody knows.
  OnnxNetwork& unknown() { return node("NoSuchLayer", {}, {}); }

  std::string bytes() const {
    Proto graph = graph_;
    std::vector<long> out = shape_;
    out[1] = outputs_;
    graph.text(2, "g")
        .message(11, value("x0", shape_))
        .message(12, value("x" + std::to_string(layers_), out));
    Proto opset;
    opset.text(1, "").number(2, 11);
    return Proto().number(1, 6).message(7, graph).message(8, opset).bytes();
  }

 private:
  static Proto ints(const std::string& name, const std::vector<long>& values) {
    Proto attribute;
    attribute.text(1, name);
    for (const long value : values) attribute.number(8, static_cast<std::uint64_t>(value));
    return attribute.number(20, 7);
  }
  static Proto integer(const std::string& name, long value) {
    return Proto().text(1, name).number(3, static_cast<std::uint64_t>(value)).number(20, 2);
  }
  static Proto tensor(const std::string& name, const std::vector<long>& dims,
                      const std::vector<float>& values) {
    Proto tensor;
    for (const long dim : dims) tensor.number(1, static_cast<std::uint64_t>(dim));
    std::string raw(4 * values.size(), '\0');
    std::memcpy(raw.data(), values.data(), raw.size());
    return tensor.number(2, 1).text(8, name).text(9, raw);
  }
  static Proto value(const std::string& name, const std::vector<long>& dims) {
    Proto shape;
    for (const long dim : dims)
      shape.message(1, dim < 0 ? Proto().text(2, "n") : Proto().number(1, static_cast<std::uint64_t>(dim)));
    const Proto tensor = Proto().number(1, 1).message(2, shape);
    return Proto().text(1, name).message(2, Proto().message(1, tensor));
  }
  OnnxNetwork& node(const std::string& kind, const std::vector<std::string>& more,
                    const std::vector<Proto>& attributes) {
    Proto node;
    node.text(1, "x" + std::to_string(layers_));
    for (const std::string& name : more) node.text(1, name);
    ++layers_;
    node.text(2, "x" + std::to_string(layers_)).text(3, kind + std::to_string(layers_)).text(4, kind);
    for (const Proto& attribute : attributes) node.message(5, attribute);
    graph_.message(1, node);
    return *this;
  }

  std::vector<long> shape_;
  Proto graph_;
  int layers_ = 0;
  long outputs_ = 1;
};

}  // namespace glisson::test
