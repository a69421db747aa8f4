// SPDX-License-Identifier: GPL-3.0-or-later
// A person's own network that masks what is not liver: its sheet, its pictures, and its life beside a loop.
#include <QElapsedTimer>
#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/network/live_mask.h"
#include "mask_network.h"
#include "network_files.h"

using namespace glisson;
using namespace glisson::network;
using test::OnnxNetwork;
namespace fs = std::filesystem;

class MaskNetworkTest : public QObject {
  Q_OBJECT
 private slots:
  void cleanup() { qunsetenv("GLISSON_RUN_NETWORK"); }
  void WhatIsNotRedIsMasked();
  void AThresholdDecidesChannelByChannel();
  void ChannelsOfOneNameAreAllMeant();
  void WhatIsWrongIsNamedByField_data();
  void WhatIsWrongIsNamedByField();
  void ANetworkOfAnotherInputIsRefused();
  void OldMasksAreNotUsed();
  void AProgramThatDiesIsToldAndNobodyWaits();
  void ItEndsWhateverTheProgramDoes();

 private:
  /// "liver" where red exceeds green and blue together, else "other"; of pictures of any size.
  fs::path red_is_liver(const std::string& more = R"(, "size": [8, 16])") const {
    return test::write_network(
        folder_.path(),
        OnnxNetwork({1, 3, -1, -1}).conv(2, 3, 1, {1.0F, -1.0F, -1.0F, -1.0F, 1.0F, 1.0F}, {0.0F, 0.0F}),
        R"({"channels": ["liver", "other"], "liver": ["liver"])" + more + "}");
  }
  /// Red, its right half blue.
  static StereoFrame frame(int index) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>();
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 32; ++x)
        for (const int level : {x < 16 ? 20 : 200, 20, x < 16 ? 200 : 20})
          bytes->push_back(static_cast<std::uint8_t>(level));
    StereoFrame one;
    one.left = {32, 16, 3, bytes};
    one.index = index;
    one.seconds = index / 10.0;
    return one;
  }
  static bool is_right_half(const Picture& mask) {
    for (std::size_t n = 0; n < mask.bytes->size(); ++n)
      if (((*mask.bytes)[n] != 0) != (n % 32 >= 16)) return false;
    return mask.width == 32 && mask.height == 16 && mask.channels == 1;
  }
  void use_program(const std::string& script) const {
    write_file_atomically(folder_.path() / "program", "#!/bin/sh\n" + script + "\n");
    fs::permissions(folder_.path() / "program", fs::perms::owner_all);
    qputenv("GLISSON_RUN_NETWORK", QByteArray::fromStdString((folder_.path() / "program").string()));
  }

  TemporaryFolder folder_;
};

void MaskNetworkTest::WhatIsNotRedIsMasked() {
  const auto network = MaskNetwork::open(red_is_liver(), RunContext(), 1);
  QVERIFY(is_right_half(*network->not_liver(frame(0).left, RunContext())));
  // In the other order of colours it is the other half.
  const auto swapped =
      MaskNetwork::open(red_is_liver(R"(, "size": [8, 16], "colours": "bgr")"), RunContext(), 1);
  QVERIFY((*swapped->not_liver(frame(0).left, RunContext())->bytes)[0] != 0);
  // What is subtracted counts.
  const auto shifted = MaskNetwork::open(
      red_is_liver(R"(, "size": [8, 16], "mean": [1, 0, 0], "sd": [1, 1, 1])"), RunContext(), 1);
  QVERIFY((*shifted->not_liver(frame(0).left, RunContext())->bytes)[0] != 0);
}

void MaskNetworkTest::AThresholdDecidesChannelByChannel() {
  MaskSheet sheet;
  sheet.is_liver = {1, 0};
  sheet.threshold = 0.5;
  const auto is_not = [&](float liver, float tool) {
    const float scores[] = {liver, tool};
    return sheet.is_not_liver(scores, 1);
  };
  QVERIFY(!is_not(0.9F, 0.1F) && is_not(0.9F, 0.6F) && is_not(0.1F, 0.1F));
  sheet.is_liver = {0, 0};  // it knows tools alone
  QVERIFY(!is_not(0.1F, 0.1F) && is_not(0.1F, 0.6F));
  sheet.is_liver = {1, 0};
  sheet.threshold.reset();
  QVERIFY(!is_not(0.3F, 0.2F) && is_not(0.2F, 0.3F));
}

void MaskNetworkTest::ChannelsOfOneNameAreAllMeant() {
  // Of two channels of the liver the second was taken for something else, and masked it.
  write_file_atomically(folder_.path() / "two.json",
                        R"({"channels": ["liver", "tool", "liver"], "liver": ["liver"]})");
  const MaskSheet sheet = read_mask_sheet(folder_.path() / "two.onnx");
  QCOMPARE(sheet.is_liver, (std::vector<char>{1, 0, 1}));
}

void MaskNetworkTest::WhatIsWrongIsNamedByField_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("field");
  const auto row = [](const char* text, const char* field) { QTest::newRow(text) << text << field; };
  row(R"({"liver": []})", "channels");
  row(R"({"channels": ["a", "b"]})", "liver");
  row(R"({"channels": ["a", "b"], "liver": ["c"]})", "liver");
  row(R"({"channels": ["a", "b"], "liver": []})", "threshold");
  row(R"({"channels": ["a"], "liver": ["a"]})", "threshold");
  row(R"({"channels": ["a", "b"], "liver": ["a"], "colours": "hsv"})", "colours");
  row(R"({"channels": ["a", "b"], "liver": ["a"], "mean": [0.5]})", "mean");
  row(R"({"channels": ["a", "b"], "liver": ["a"], "mean": [0, 0, 0]})", "sd");
  row(R"({"channels": ["a", "b"], "liver": ["a"], "size": [64]})", "size");
  row(R"({"channels": ["a", "b"], "liver": ["a"], "size": [64, 64.5]})", "size");
  row(R"({"channels": ["a", "b"], "liver": ["a"], "oldest_seconds": 0})", "oldest_seconds");
  row(R"({"channels": ["a", "b"], "liver": ["a"], "tile": [8, 8]})", "tile");
}

void MaskNetworkTest::WhatIsWrongIsNamedByField() {
  QFETCH(QString, text);
  QFETCH(QString, field);
  write_file_atomically(folder_.path() / "wrong.json", text.toStdString());
  const std::string refused =
      test::refused_field([&] { (void)read_mask_sheet(folder_.path() / "wrong.onnx"); });
  QCOMPARE(QString::fromStdString(refused), field);
}

void MaskNetworkTest::ANetworkOfAnotherInputIsRefused() {
  const auto refused = [&](const OnnxNetwork& network, const char* more) {
    const fs::path file = test::write_network(
        folder_.path(), network, std::string(R"({"channels": ["a", "b"], "liver": ["a"])") + more + "}");
    return test::refused_field([&] { (void)MaskNetwork::open(file, RunContext(), 1); });
  };
  const auto made = [](const std::vector<long>& shape) {
    return OnnxNetwork(shape).conv(2, static_cast<int>(shape[1]), 1,
                                   std::vector<float>(static_cast<std::size_t>(2 * shape[1]), 1.0F),
                                   {0.0F, 0.0F});
  };
  QCOMPARE(refused(made({1, 1, 8, 16}), ""), std::string("input"));
  QCOMPARE(refused(made({1, 3, -1, -1}), ""), std::string("size"));
  QCOMPARE(refused(made({1, 3, 8, 16}), R"(, "size": [16, 8])"), std::string("size"));
}

void MaskNetworkTest::OldMasksAreNotUsed() {
  LiveMask mask(red_is_liver(R"(, "size": [8, 16], "oldest_seconds": 0.3)"), 1);
  QVERIFY(!mask.usable(0.0) && !mask.age(0.0));
  mask.offer(frame(0));
  mask.wait();
  QCOMPARE(mask.problem(), std::string());
  QVERIFY(mask.usable(0.2) && is_right_half(mask.usable(0.2)->not_liver));
  QVERIFY(!mask.usable(0.4));
  QCOMPARE(*mask.age(0.4), 0.4);
  mask.offer(frame(4));
  mask.wait();
  QCOMPARE(mask.usable(0.4)->index, 4);
}

void MaskNetworkTest::AProgramThatDiesIsToldAndNobodyWaits() {
  use_program("exit 1");
  LiveMask mask(red_is_liver(), 1);
  mask.offer(frame(0));
  mask.wait();
  QVERIFY2(mask.problem().find("broke the program that runs networks") != std::string::npos,
           mask.problem().c_str());
  QVERIFY(!mask.usable(0.0));
  QVERIFY_THROWS_EXCEPTION(InputError, mask.require_well());
  mask.offer(frame(1));
  mask.wait();
}

void MaskNetworkTest::ItEndsWhateverTheProgramDoes() {
  use_program("cat > /dev/null; sleep 60");
  QElapsedTimer since;
  {
    LiveMask mask(red_is_liver(), 1);
    for (int k = 0; k < 5; ++k) mask.offer(frame(k));  // and nothing that is offered waits
    since.start();
  }
  QVERIFY(since.elapsed() < 20000);
}

QTEST_APPLESS_MAIN(MaskNetworkTest)
#include "mask_network_test.moc"
