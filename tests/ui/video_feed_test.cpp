// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong on the feed's thread ends the playing, never the program.
#include "glisson/ui/guidance/video_feed.h"

#include <QSignalSpy>
#include <QTest>
#include <stdexcept>

#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"

namespace glisson {

class VideoFeedTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatALibraryThrowsIsTold();
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

}  // namespace glisson

QTEST_GUILESS_MAIN(glisson::VideoFeedTest)
#include "video_feed_test.moc"
