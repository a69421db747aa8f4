// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/network/runner.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <thread>
#include <utility>

#include "../reader/questions.h"
#include "glisson/core/child_process.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/stopwatch.h"

namespace glisson::network {
namespace fs = std::filesystem;
namespace {

/// By the clock, for the file and for each run.
constexpr double kPatience = 120.0;
constexpr double kPoll = 0.02;  ///< how long a cancel may go unnoticed, seconds
constexpr std::uintmax_t kMostBytes = 1000000000;
constexpr const char* kExportAgain = "Export it again as ONNX (opset 11), with its weights inside the file";

std::string runner_program() { return helper_program("glisson-run-network", "GLISSON_RUN_NETWORK").string(); }

std::string content_of(const fs::path& path) {
  std::error_code failure;
  const auto bytes = fs::file_size(path, failure);
  if (!failure && bytes > kMostBytes)
    throw InputError(path.string(), "size", "is more than 1 GB", "Use a smaller network");
  return read_file(path, kMostBytes);
}

/// Letters of the process, as far as they can be shown.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char letter) { return letter < ' ' || letter > '~'; }, ' ');
  return text;
}

enum class Heard { whole, cancelled, broken, late };

}  // namespace

std::string shape_text(const std::vector<int>& shape) {
  std::string text;
  for (const int side : shape)
    text += (text.empty() ? "" : " x ") + (side < 0 ? std::string("?") : std::to_string(side));
  return text;
}

std::size_t value_count(const std::vector<int>& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1},
                         [](std::size_t count, int side) { return count * static_cast<std::size_t>(side); });
}

struct NetworkRunner::Impl {
  std::string file;
  Conversation child;

  Impl(std::string path, int threads) : file(std::move(path)), child(runner_program(), words(threads)) {}

  static std::vector<std::string> words(int threads) {
    const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return {"run", std::to_string(threads > 0 ? threads : all)};
  }

  /// Waits for an answer and takes its head.
  template <class Answer>
  Heard hear(Answer& answer, const RunContext& context) {
    const Stopwatch since;
    while (!child.waits_for(kPoll)) {
      const bool late = since.seconds() > kPatience;
      if (!late && !context.cancelled()) continue;
      child.end();
      return late ? Heard::late : Heard::cancelled;
    }
    return child.receive(answer, kPatience) ? Heard::whole : Heard::broken;
  }

  std::string said(std::int32_t letters) {
    if (letters < 0 || letters > reader::kMostSaid) child.end();
    std::string text(static_cast<std::size_t>(std::clamp(letters, 0, reader::kMostSaid)), '\0');
    return child.receive(text.data(), text.size(), kPatience) ? printable(std::move(text)) : std::string("?");
  }

  [[noreturn]] void tell_end(Heard heard) const {
    if (heard == Heard::late)
      throw InputError(file, "", "took the network more than 120 s for one answer",
                       "Use smaller tiles (\"tile\"), or a smaller network");
    throw InputError(file, "", "broke the program that runs networks: it is damaged or needs too much memory",
                     "Copy it again, or use smaller tiles (\"tile\")");
  }
};

NetworkRunner::NetworkRunner(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NetworkRunner::~NetworkRunner() = default;

std::unique_ptr<NetworkRunner> NetworkRunner::open(const fs::path& path, const RunContext& context,
                                                   int threads) {
  if (context.cancelled()) return nullptr;
  const std::string content = content_of(path);
  std::unique_ptr<NetworkRunner> runner(new NetworkRunner(std::make_unique<Impl>(path.string(), threads)));
  Impl& impl = *runner->impl_;
  const reader::LoadQuestion question{content.size()};
  reader::LoadAnswer answer;
  Heard heard = Heard::broken;
  if (impl.child.send(question, kPatience) && impl.child.send(content.data(), content.size(), kPatience))
    heard = impl.hear(answer, context);
  if (heard == Heard::cancelled) return nullptr;
  if (heard != Heard::whole) impl.tell_end(heard);
  if (answer.loaded != 1)
    throw InputError(path.string(), "",
                     "is no ONNX network that can be run here (" + impl.said(answer.said) + ")",
                     kExportAgain);
  if (answer.inputs != 1)
    throw InputError(path.string(), "input", "are " + std::to_string(answer.inputs) + ", not one",
                     "Export a network with one input and one output");
  const int rank = std::clamp(answer.rank, 0, reader::kMostRank);
  runner->input_shape_.assign(answer.shape.begin(), answer.shape.begin() + rank);
  return runner;
}

Cancellable<Tensor> NetworkRunner::run(const Tensor& input, const std::vector<int>& expected,
                                       const RunContext& context) {
  Impl& impl = *impl_;
  if (context.cancelled()) {
    impl.child.end();
    return std::nullopt;
  }
  require(input.values.size() == value_count(input.shape) &&
              input.shape.size() <= static_cast<std::size_t>(reader::kMostRank),
          "a tensor has as many values as its shape says");
  reader::RunQuestion question{static_cast<std::int32_t>(input.shape.size()), {}};
  std::copy(input.shape.begin(), input.shape.end(), question.shape.begin());
  reader::RunAnswer answer;
  Heard heard = Heard::broken;
  if (impl.child.send(question, kPatience) &&
      impl.child.send(input.values.data(), input.values.size() * sizeof(float), kPatience))
    heard = impl.hear(answer, context);
  if (heard == Heard::cancelled) return std::nullopt;
  if (heard != Heard::whole) impl.tell_end(heard);
  if (answer.ran != 1)
    throw InputError(
        impl.file, "layers",
        "cannot be computed for an input of " + shape_text(input.shape) + " (" + impl.said(answer.said) + ")",
        "Give the size of the network's input as \"tile\", or export a network of other layers");
  Tensor output;
  output.shape.assign(answer.shape.begin(),
                      answer.shape.begin() + std::clamp(answer.rank, 0, reader::kMostRank));
  if (output.shape != expected) {
    impl.child.end();  // values would follow that nobody wants
    throw InputError(impl.file, "output", "is " + shape_text(output.shape) + ", not " + shape_text(expected),
                     "Name one label a channel in \"channels\", and export a network whose output has the "
                     "size of its input");
  }
  output.values.resize(value_count(expected));
  if (!impl.child.receive(output.values.data(), output.values.size() * sizeof(float), kPatience))
    impl.tell_end(Heard::broken);
  if (!std::all_of(output.values.begin(), output.values.end(),
                   [](float value) { return std::isfinite(value); }))
    throw InputError(impl.file, "output", "holds what is no number",
                     "Check the window (\"window_hu\") and the network's weights");
  return output;
}

std::vector<std::string> network_escapes() {
  const TemporaryFolder work;
  (void)run_child(runner_program(), {"escapes", work.path().string()}, RunContext(), {});
  std::ifstream file(work.path() / "escapes");
  if (!file) throw FileError(runner_program() + ": cannot run. Install Glisson again.");
  std::vector<std::string> words;
  for (std::string word; file >> word;) words.push_back(word);
  return words;
}

}  // namespace glisson::network
