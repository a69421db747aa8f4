// SPDX-License-Identifier: GPL-3.0-or-later
//
// glisson-run-network run THREADS | escapes FOLDER
//
// Parses and runs a person's own neural network (ONNX) for Glisson, by OpenCV's DNN (questions.h), because a
// parser that a file has broken or taken over must do so alone. It gives up all before the first foreign
// byte: the file and the inputs are sent to it, and it can read and write nothing else.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/dnn.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/core/child_side.h"
#include "glisson/core/confinement.h"
#include "onnx_input.h"
#include "questions.h"

namespace {

using namespace glisson;
using namespace network::reader;
using child_side::hear;
using child_side::tell;

constexpr double kSeconds = 120.0;  ///< of processor time, a question and a thread

/// The last line that says something: OpenCV puts where it happened first.
std::string reason_of(const std::exception& failure) {
  std::string text = failure.what();
  for (char& letter : text)
    if (letter < ' ' || letter > '~') letter = ' ';
  if (const auto last = text.rfind("error: ("); last != std::string::npos) text = text.substr(last + 7);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.substr(0, static_cast<std::size_t>(kMostSaid));
}

template <class Answer>
bool refuse(Answer answer, const std::exception& failure) {
  const std::string reason = reason_of(failure);
  answer.said = static_cast<std::int32_t>(reason.size());
  return tell(answer) && tell(reason.data(), reason.size());
}

/// @return false: Glisson is gone, or has been told why not.
bool load(cv::dnn::Net& net) {
  LoadQuestion question;
  if (!hear(question) || question.bytes > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
    return false;
  limit_memory(6e9 + 6.0 * static_cast<double>(question.bytes));
  std::string file(question.bytes, '\0');
  if (!hear(file.data(), file.size())) return false;
  LoadAnswer answer = onnx_input(file);
  try {
    net = cv::dnn::readNetFromONNX(file.data(), file.size());
    net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
  } catch (const std::exception& failure) {
    refuse(answer, failure);
    return false;
  }
  answer.loaded = 1;
  return tell(answer);
}

/// What the network makes of an input, as numbers in a row.
cv::Mat result_of(cv::dnn::Net& net, const cv::Mat& input) {
  net.setInput(input);
  cv::Mat output = net.forward();
  if (output.dims > kMostRank) throw std::length_error("the output has too many dimensions");
  if (output.depth() != CV_32F) output.convertTo(output, CV_32F);
  return output.isContinuous() ? output : output.clone();
}

bool answer_with(const cv::Mat& output) {
  RunAnswer answer{1, output.dims, 0, {}};
  for (int n = 0; n < output.dims; ++n) answer.shape[static_cast<std::size_t>(n)] = output.size[n];
  return tell(answer) && tell(output.data, output.total() * sizeof(float));
}

int run(int threads) {
  ::setenv("OPENCV_OPENCL_RUNTIME", "disabled", 1);  // drivers of graphics cards want files
  confine({}, {});
  cv::setNumThreads(threads);
  child_side::allow_seconds(kSeconds * threads);
  cv::dnn::Net net;
  if (!load(net)) return 0;
  for (RunQuestion question; hear(question);) {
    child_side::allow_seconds(kSeconds * threads);
    if (question.rank < 1 || question.rank > kMostRank) return 1;
    cv::Mat output;
    try {
      cv::Mat input(question.rank, question.shape.data(), CV_32F);
      if (!hear(input.data, input.total() * sizeof(float))) return 0;
      output = result_of(net, input);
    } catch (const std::exception& failure) {
      if (!refuse(RunAnswer(), failure)) return 0;
      continue;
    }
    if (!answer_with(output)) return 0;
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  const std::string_view mode = count > 1 ? words[1] : "";
  child_side::begin();
  if (mode == "run" && count == 3) return run(std::max(1, std::atoi(words[2])));
  if (mode == "escapes" && count == 3) return child_side::tell_escapes(words[2]);
  std::fprintf(stderr, "glisson-run-network MODE ...: a helper of Glisson, not run by hand\n");
  return 2;
}
