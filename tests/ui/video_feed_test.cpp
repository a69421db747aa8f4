// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong on the feed's thread ends the playing, never the program; what is live is not held back.
#include "glisson/ui/guidance/video_feed.h"

#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "../openigtlink/peer_process.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/source.h"

namespace glisson {

class VideoFeedTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatALibraryThrowsIsTold();
  void ALiveSourceIsNeitherSlowedNorHeldBack();
  void ALiveSourceStartsAtOnceWhateverFrameWasTaken();
};

void VideoFeedTest::WhatALibraryThrowsIsTold() {
  const TemporaryFolder folder;
  const Picture grey{64, 48, 3, std::make_shared<std::vector<std::uint8_t>>(3 * 64 * 48, 120)};
  for (const char* name : {"left1.png", "right1.png"}) stereo::write_picture(folder.path() / name, grey);
  ui::VideoFeed feed([](const StereoFrame&) { throw std::runtime_error("no memory is left"); });
  QSignalSpy failed(&feed, &ui::VideoFeed::failed);
  feed.start({folder.path(), {}}, 0);
  QTRY_COMPARE(failed.count(), 1);
  const QString told = failed.front().front().toString();
  QVERIFY2(told.contains("stopped unexpectedly (no memory is left)"), qPrintable(told));
}

void VideoFeedTest::ALiveSourceIsNeitherSlowedNorHeldBack() {
  PeerProcess server({"serve", "good"});
  const QString port = server.wait_for([](const Words& words) { return words.value(0) == "port"; }).value(1);
  std::mutex mutex;
  std::vector<int> sent;
  ui::VideoFeed feed([&](const StereoFrame& frame) {
    const std::lock_guard lock(mutex);
    sent.push_back(frame.index);
  });
  const auto indices = [&] {
    const std::lock_guard lock(mutex);
    return sent;
  };
  feed.set_speed(1e-3);
  feed.start({stereo::igtl_source(("127.0.0.1:" + port + "/Left,Right").toStdString()), {}}, 0);
  QTRY_VERIFY(indices().size() > 3);
  feed.pause(true);
  QTest::qWait(300);  // some thirty frames
  const std::size_t before = indices().size();
  feed.pause(false);
  QTRY_VERIFY(indices().size() > before);
  // Those of the pause are gone, and none of them comes after it as one of now.
  QVERIFY(indices()[before] > indices()[before - 1] + 1);
  QVERIFY(feed.sent_at(indices()[before]));
  feed.pause(true);
  QTest::qWait(50);
  const std::size_t paused = indices().size();
  feed.step();
  QTRY_COMPARE(indices().size(), paused + 1);
}

void VideoFeedTest::ALiveSourceStartsAtOnceWhateverFrameWasTaken() {
  PeerProcess server({"serve", "good"});
  const QString port = server.wait_for([](const Words& words) { return words.value(0) == "port"; }).value(1);
  std::atomic<int> first = -1;
  ui::VideoFeed feed([&](const StereoFrame& frame) {
    int none = -1;
    first.compare_exchange_strong(none, frame.index);
  });
  // A quarter of an hour of its frames, were they waited for.
  feed.start({stereo::igtl_source(("127.0.0.1:" + port + "/Left,Right").toStdString()), {}}, 100'000);
  QTRY_COMPARE(first.load(), 0);
}

}  // namespace glisson

QTEST_GUILESS_MAIN(glisson::VideoFeedTest)
#include "video_feed_test.moc"
