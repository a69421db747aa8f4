// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/network/runner.h"

#include <signal.h>

#include <QTest>
#include <cmath>
#include <random>
#include <thread>

#include "complaint.h"
#include "escapes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "mutant.h"
#include "onnx_bytes.h"

using namespace glisson;
using namespace glisson::network;
using test::OnnxNetwork;
namespace fs = std::filesystem;

/// Networks made byte by byte, whose answers are known, and files and programs that mean harm.
class RunnerTest : public QObject {
  Q_OBJECT
  TemporaryFolder folder_;
  fs::path at(const char* name) const { return folder_.path() / name; }
  fs::path write(const OnnxNetwork& network) const {
    write_file_atomically(at("n.onnx"), network.bytes());
    return at("n.onnx");
  }
  void use_program(const std::string& script) const;
  std::string complaint_of(const fs::path& file, const Tensor& input, const std::vector<int>& output) const {
    return test::complaint<Error>([&] {
      const auto runner = NetworkRunner::open(file, RunContext());
      (void)runner->run(input, output, RunContext());
    });
  }

 private slots:
  void cleanup() { qunsetenv("GLISSON_RUN_NETWORK"); }
  void TheProgramIsConfined();
  void SlicesAreAnsweredAsTheWeightsSay();
  void BlocksAreAnsweredAsTheWeightsSay();
  void TheInputsShapeIsWhatTheFileSays();
  void WhatIsNoNetworkIsRefused();
  void WhatDoesNotFitIsRefused();
  void DamagedNetworksEndNothing();
  void WhatBreaksTheProgramIsASentence();
  void AProgramThatLiesIsNotBelieved();
  void CancelEndsTheProgram();
};

namespace {

const Tensor kFour{{1, 1, 2, 2}, {-2.0F, 0.0F, 1.0F, 3.0F}};

}  // namespace

void RunnerTest::use_program(const std::string& script) const {
  write_file_atomically(at("program"), "#!/bin/sh\n" + script + "\n");
  fs::permissions(at("program"), fs::perms::owner_all);
  qputenv("GLISSON_RUN_NETWORK", QByteArray::fromStdString(at("program").string()));
}

void RunnerTest::TheProgramIsConfined() {
  if (!test::can_confine()) QSKIP("this kernel confines nothing, or this is a build with sanitizers");
  QCOMPARE(test::broken_out(network_escapes()), std::vector<std::string>());
}

void RunnerTest::SlicesAreAnsweredAsTheWeightsSay() {
  const auto runner = NetworkRunner::open(
      write(OnnxNetwork({1, 1, -1, -1}).conv(2, 1, 1, {2.0F, -1.0F}, {0.5F, 0.0F}).sigmoid()), RunContext());
  const auto output = runner->run(kFour, {1, 2, 2, 2}, RunContext());
  for (std::size_t n = 0; n < 4; ++n) {
    const auto sigmoid = [](float x) { return 1.0F / (1.0F + std::exp(-x)); };
    QVERIFY(std::abs(output->values[n] - sigmoid(2.0F * kFour.values[n] + 0.5F)) < 1e-5F);
    QVERIFY(std::abs(output->values[4 + n] - sigmoid(-kFour.values[n])) < 1e-5F);
  }
  // Again, and of another size where the file leaves it open.
  const Tensor wide{{1, 1, 1, 6}, {1, 2, 3, 4, 5, 6}};
  QVERIFY(runner->run(wide, {1, 2, 1, 6}, RunContext())->values[11] < 0.01F);
}

void RunnerTest::BlocksAreAnsweredAsTheWeightsSay() {
  // A box of ones adds up 27 neighbours, fewer at the border.
  const auto runner = NetworkRunner::open(
      write(OnnxNetwork({1, 1, 3, 4, 5}).conv(1, 1, 3, std::vector<float>(27, 1.0F), {0.0F})), RunContext());
  const Tensor ones{{1, 1, 3, 4, 5}, std::vector<float>(60, 1.0F)};
  const auto output = runner->run(ones, {1, 1, 3, 4, 5}, RunContext());
  QVERIFY(std::abs(output->values[20 + 5 + 1] - 27.0F) < 1e-3F);
  QVERIFY(std::abs(output->values[0] - 8.0F) < 1e-3F);
}

void RunnerTest::TheInputsShapeIsWhatTheFileSays() {
  const auto shape = [&](const std::vector<long>& of) {
    return NetworkRunner::open(write(OnnxNetwork(of).conv(1, 1, 1, {1.0F}, {0.0F})), RunContext())
        ->input_shape();
  };
  QCOMPARE(shape({1, 1, 8, 16}), (std::vector<int>{1, 1, 8, 16}));
  QCOMPARE(shape({1, 1, -1, -1, 4}), (std::vector<int>{1, 1, -1, -1, 4}));
}

void RunnerTest::WhatIsNoNetworkIsRefused() {
  write_file_atomically(at("text.onnx"), "This is no network.");
  const std::string text = complaint_of(at("text.onnx"), kFour, {1, 1, 2, 2});
  QVERIFY2(text.find("text.onnx: is no ONNX network that can be run here") != std::string::npos,
           text.c_str());
  const std::string unknown = complaint_of(write(OnnxNetwork({1, 1, 2, 2}).unknown()), kFour, {1, 1, 2, 2});
  QVERIFY2(unknown.find("NoSuchLayer") != std::string::npos, unknown.c_str());
  const std::string none = complaint_of(at("none.onnx"), kFour, {1, 1, 2, 2});
  QVERIFY2(none.find("none.onnx: ") != std::string::npos, none.c_str());
  const std::string whole = OnnxNetwork({1, 1, 2, 2}).conv(1, 1, 1, {1.0F}, {0.0F}).bytes();
  write_file_atomically(at("cut.onnx"), whole.substr(0, whole.size() / 2));
  QVERIFY(complaint_of(at("cut.onnx"), kFour, {1, 1, 2, 2}).find("cut.onnx: ") == 0 ||
          complaint_of(at("cut.onnx"), kFour, {1, 1, 2, 2}).find("/cut.onnx: ") != std::string::npos);
}

void RunnerTest::WhatDoesNotFitIsRefused() {
  const OnnxNetwork two = OnnxNetwork({1, 1, 2, 2}).conv(2, 1, 1, {1.0F, 1.0F}, {0.0F, 0.0F});
  const std::string channels = complaint_of(write(two), kFour, {1, 3, 2, 2});
  QVERIFY2(channels.find("output: is 1 x 2 x 2 x 2, not 1 x 3 x 2 x 2") != std::string::npos,
           channels.c_str());
  const OnnxNetwork half = OnnxNetwork({1, 1, 2, 2}).halved();
  const std::string size = complaint_of(write(half), kFour, {1, 1, 2, 2});
  QVERIFY2(size.find("output: is 1 x 1 x 1 x 1") != std::string::npos, size.c_str());
  // The logarithm of what is negative is no number.
  const std::string number = complaint_of(write(OnnxNetwork({1, 1, 2, 2}).logarithm()), kFour, {1, 1, 2, 2});
  QVERIFY2(number.find("output: holds what is no number") != std::string::npos, number.c_str());
  const OnnxNetwork three = OnnxNetwork({1, 3, 2, 2}).conv(1, 3, 1, {1.0F, 1.0F, 1.0F}, {0.0F});
  const std::string layers = complaint_of(write(three), kFour, {1, 1, 2, 2});
  QVERIFY2(layers.find("layers: cannot be computed for an input of 1 x 1 x 2 x 2") != std::string::npos,
           layers.c_str());
}

void RunnerTest::DamagedNetworksEndNothing() {
  std::mt19937 random(22);
  const std::string good =
      OnnxNetwork({1, 1, 2, 2}).conv(2, 1, 3, std::vector<float>(18, 1.0F), {0.0F, 0.0F}).softmax().bytes();
  int refused = 0;
  for (int n = 0; n < 40; ++n) {
    write_file_atomically(at("m.onnx"), test::mutant_of(good, random, 40));
    refused += complaint_of(at("m.onnx"), kFour, {1, 2, 2, 2}).empty() ? 0 : 1;
  }
  QVERIFY(refused > 10);
}

void RunnerTest::WhatBreaksTheProgramIsASentence() {
  const fs::path file = write(OnnxNetwork({1, 1, 2, 2}).conv(1, 1, 1, {1.0F}, {0.0F}));
  for (const char* script : {"exit 1", "kill -SEGV $$", "kill -KILL $$", "head -c 20 >/dev/null"}) {
    use_program(script);
    const std::string told = complaint_of(file, kFour, {1, 1, 2, 2});
    QVERIFY2(told.find("broke the program that runs networks") != std::string::npos, told.c_str());
  }
  qputenv("GLISSON_RUN_NETWORK", "/nowhere/at/all");
  QVERIFY(complaint_of(file, kFour, {1, 1, 2, 2}).empty());  // the one that was built beside this test
}

void RunnerTest::AProgramThatLiesIsNotBelieved() {
  const fs::path file = write(OnnxNetwork({1, 1, 2, 2}).conv(1, 1, 1, {1.0F}, {0.0F}));
  const auto bytes = [](std::initializer_list<int> words) {
    std::string text;
    for (const int word : words)
      for (int n = 0; n < 4; ++n) {
        char octal[8];
        std::snprintf(octal, sizeof octal, "\\%03o", static_cast<unsigned>(word) >> (8 * n) & 255U);
        text += octal;
      }
    return "printf '" + text + "'\n";
  };
  // Refused with letters without end; loaded with a rank of a billion, and an output of another size.
  use_program(bytes({0, 1, 4, 2000000000, 1, 1, 2, 2, 0}) + "yes");
  QVERIFY(complaint_of(file, kFour, {1, 1, 2, 2}).find("is no ONNX network that can be run here (?)") !=
          std::string::npos);
  use_program(bytes({1, 1, 1000000000, 0, 1, 1, 2, 2, 0}) + bytes({1, -5, 0, -1, -1, -1, -1, -1}) + "yes");
  const std::string told = complaint_of(file, kFour, {1, 1, 2, 2});
  QVERIFY2(told.find("output: is ") != std::string::npos, told.c_str());
}

void RunnerTest::CancelEndsTheProgram() {
  const fs::path file = write(OnnxNetwork({1, 1, 2, 2}).conv(1, 1, 1, {1.0F}, {0.0F}));
  use_program("echo $$ >'" + at("pid").string() + "'\nexec sleep 1000");
  const auto flag = std::make_shared<CancelFlag>();
  const RunContext context({}, flag, 1);
  // Cancelled as soon as the program has begun, while it is waited for.
  std::jthread hand([&](const std::stop_token& stop) {
    std::error_code none;
    while (!stop.stop_requested() && (!fs::exists(at("pid"), none) || fs::file_size(at("pid"), none) < 2))
      std::this_thread::yield();
    flag->request();
  });
  QVERIFY(NetworkRunner::open(file, context) == nullptr);
  QVERIFY(::kill(std::stoi(read_file(at("pid"))), 0) != 0);
  qunsetenv("GLISSON_RUN_NETWORK");
  const auto runner = NetworkRunner::open(file, RunContext());
  QVERIFY(runner->run(kFour, {1, 1, 2, 2}, RunContext()).has_value());
}

QTEST_GUILESS_MAIN(RunnerTest)
#include "runner_test.moc"
