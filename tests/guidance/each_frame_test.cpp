// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/guidance/each_frame.h"

#include <QTest>

#include "../openigtlink/peer_process.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/source.h"

using namespace glisson;
using guidance::FrameSpan;

class EachFrameTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanupTestCase() { folder_.reset(); }
  void TheSpanIsGoneThroughInItsOrder_data();
  void TheSpanIsGoneThroughInItsOrder();
  void WhatIsNotKnownIsPassedOver();
  void WhatIsThrownEndsIt();
  void ALiveSourceIsNotWaitedFor();
  void TheShareThatIsDoneIsOfTheSpan();

 private:
  static constexpr int kFrames = 6;
  /// Of a frame; its number, so that one sees whose it is.
  static std::optional<OverlayFrame> numbered(const StereoFrame& frame) {
    OverlayFrame overlay;
    overlay.index = frame.index;
    return overlay;
  }
  /// Numbers of the frames that were handed over.
  std::vector<int> taken(const FrameSpan& span, const guidance::FrameKnower& known = numbered) const {
    std::vector<int> numbers;
    stereo::StereoVideo video(folder_->path() / "film.mkv");
    guidance::each_frame(video, span, known, [&](const StereoFrame& frame, const OverlayFrame& overlay) {
      QCOMPARE(overlay.index, frame.index);
      numbers.push_back(frame.index);
    });
    return numbers;
  }

  std::unique_ptr<TemporaryFolder> folder_;
};

void EachFrameTest::initTestCase() {
  folder_ = std::make_unique<TemporaryFolder>();
  stereo::VideoWriter writer(folder_->path() / "film.mkv", 128, 32, 25.0);
  for (int n = 0; n < kFrames; ++n)
    writer.write(
        {128, 32, 3,
         std::make_shared<std::vector<std::uint8_t>>(128UL * 32 * 3, static_cast<std::uint8_t>(40 * n))});
  writer.close();
}

void EachFrameTest::TheSpanIsGoneThroughInItsOrder_data() {
  QTest::addColumn<int>("first");
  QTest::addColumn<int>("last");
  QTest::addColumn<QList<int>>("wanted");
  QTest::newRow("whole") << 0 << -1 << QList<int>{0, 1, 2, 3, 4, 5};
  QTest::newRow("from") << 4 << -1 << QList<int>{4, 5};
  QTest::newRow("between") << 2 << 3 << QList<int>{2, 3};
  QTest::newRow("beyond the end") << 5 << 99 << QList<int>{5};
  QTest::newRow("the end lies before: the first is all") << 3 << 1 << QList<int>{3};
}

void EachFrameTest::TheSpanIsGoneThroughInItsOrder() {
  QFETCH(int, first);
  QFETCH(int, last);
  QFETCH(QList<int>, wanted);
  const std::vector<int> found = taken({first, last});
  QCOMPARE(QList<int>(found.begin(), found.end()), wanted);
}

void EachFrameTest::WhatIsNotKnownIsPassedOver() {
  const auto odd = [](const StereoFrame& frame) {
    return frame.index % 2 == 1 ? numbered(frame) : std::nullopt;
  };
  QCOMPARE(taken({0, 4}, odd), (std::vector<int>{1, 3}));  // the last one ends it, known or not
}

void EachFrameTest::WhatIsThrownEndsIt() {
  int asked = 0;
  const auto stop = [&](const StereoFrame& frame) -> std::optional<OverlayFrame> {
    if (++asked == 3) throw Error("enough");
    return numbered(frame);
  };
  QVERIFY_THROWS_EXCEPTION(Error, taken({}, stop));
  QCOMPARE(asked, 3);
}

/// The first frame of the span is one of a former opening.
void EachFrameTest::ALiveSourceIsNotWaitedFor() {
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
  QSKIP("QProcess starts programs by clone(), in which clang 14's runtime of ThreadSanitizer ends itself");
#endif
#endif
  PeerProcess server({"serve", "good"});
  const QString port = server.wait_for([](const Words& words) { return words.value(0) == "port"; }).value(1);
  stereo::StereoVideo video(stereo::igtl_source("127.0.0.1:" + port.toStdString() + "/Left,Right"));
  std::vector<int> numbers;
  guidance::each_frame(video, {1000, 2}, numbered, [&](const StereoFrame& frame, const OverlayFrame&) {
    numbers.push_back(frame.index);
  });
  QCOMPARE(numbers, (std::vector<int>{0, 1, 2}));
}

void EachFrameTest::TheShareThatIsDoneIsOfTheSpan() {
  QCOMPARE(FrameSpan{}.done_with(2, 6), 0.5);
  QCOMPARE((FrameSpan{2, -1}.done_with(3, 6)), 0.5);
  QCOMPARE((FrameSpan{2, 3}.done_with(2, 6)), 0.5);
  QCOMPARE(FrameSpan{}.done_with(8, 6), 1.0);  // a container that knows of fewer frames than it has
  QCOMPARE(FrameSpan{}.done_with(0, 0), 1.0);  // a live device
  QCOMPARE((FrameSpan{7, -1}.done_with(0, 0)), 1.0);
}

QTEST_GUILESS_MAIN(EachFrameTest)
#include "each_frame_test.moc"
