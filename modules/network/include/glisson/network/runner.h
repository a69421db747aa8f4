// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "glisson/core/run_context.h"

namespace glisson::network {

/// Numbers in a row, the last dimension fastest; [1, channels, rows, columns] or [1, channels, slices, rows,
/// columns].
struct Tensor {
  std::vector<int> shape;
  std::vector<float> values;
};
/// "1 x 2 x 64 x 64", with "?" for what is open (-1).
std::string shape_text(const std::vector<int>& shape);
/// How many values such a tensor has. @pre none is open
std::size_t value_count(const std::vector<int>& shape);

/// A person's own network, an ONNX file with one input and one output, run by OpenCV's DNN in a process of
/// its own that can do nothing else. What it answers is believed only as far as it fits. Not for two threads
/// at once; the process ends with the object.
class NetworkRunner {
 public:
  /// Reads the file and lets the process parse it.
  /// @param threads of the processor that a run may take; 0: all.
  /// @return null: cancelled.
  /// @throws FileError, InputError naming the file when it is no network that can be run.
  static std::unique_ptr<NetworkRunner> open(const std::filesystem::path& path, const RunContext& context,
                                             int threads = 0);
  ~NetworkRunner();

  /// Of its one input as the file says it; -1 where it is left open. Empty: the file does not say it.
  const std::vector<int>& input_shape() const { return input_shape_; }

  /// The network's output for one input.
  /// @param expected the output's shape.
  /// @return empty: cancelled; the process has been ended and no run is possible any more.
  /// @throws InputError naming the file when a layer fails, the output has another shape or holds what is no
  ///   number, or a run takes more than two minutes.
  Cancellable<Tensor> run(const Tensor& input, const std::vector<int>& expected, const RunContext& context);

 private:
  struct Impl;
  explicit NetworkRunner(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
  std::vector<int> input_shape_;
};

/// What the program that runs networks could do although it must not, as reader_escapes() of volumes.
/// @throws FileError the program is missing.
std::vector<std::string> network_escapes();

}  // namespace glisson::network
