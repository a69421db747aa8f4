// SPDX-License-Identifier: GPL-3.0-or-later
// A server of OpenIGTLink as a source of stereo frames, by the same door as every other.
#include <QElapsedTimer>
#include <QTest>
#include <cmath>

#include "../openigtlink/peer_process.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reach.h"
#include "glisson/stereo/source.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

struct Server {
  explicit Server(const QString& kind) : peer({"serve", kind}) {
    const QString port = peer.wait_for([](const Words& words) { return words.value(0) == "port"; }).value(1);
    source = igtl_source(("127.0.0.1:" + port + "/Left,Right").toStdString());
  }
  PeerProcess peer;
  std::string source;
};

int pixel(const Picture& picture, int x, int y, int channel) {
  return (*picture.bytes)[static_cast<std::size_t>(3 * (y * picture.width + x) + channel)];
}

}  // namespace

class IgtlSourceTest : public QObject {
  Q_OBJECT
 private slots:
  void PairsComeAsFromAnyOtherSource();
  void GreyPicturesAreGivenAsColours();
  void DescriptionMayCropIt();
  void ServerThatClosesIsTheEnd();
  void CancelEndsOpeningAndReading();
  void NobodyThereIsSaid();
  void OtherArrangementsAreRefused();
  void NoCaseReachesIt();
};

void IgtlSourceTest::PairsComeAsFromAnyOtherSource() {
  const Server server("good");
  StereoVideo video(server.source);
  QVERIFY(video.width() == 64 && video.height() == 48 && video.frame_count() == 0);
  StereoFrame frame;
  double begin = 0.0, last = -1.0;
  for (int i = 0; i < 4; ++i) {
    QVERIFY(video.read(frame));
    QCOMPARE(frame.index, i);
    QVERIFY(frame.seconds > last);
    last = frame.seconds;
    if (i == 0) begin = pixel(frame.left, 0, 0, 2) / 25.0;  // by its pixels
    QCOMPARE(std::lround(25.0 * (begin + frame.seconds)) % 256,
             static_cast<long>(pixel(frame.left, 0, 0, 2)));
    QCOMPARE(pixel(frame.left, 9, 30, 1), 30);
    QCOMPARE(pixel(frame.right, 9, 30, 1), 37);
    QCOMPARE(pixel(frame.right, 9, 30, 0), 200);
  }
}

void IgtlSourceTest::GreyPicturesAreGivenAsColours() {
  const Server server("grey");
  StereoVideo video(server.source);
  StereoFrame frame;
  QVERIFY(video.read(frame));
  QVERIFY(frame.left.channels == 3 && frame.right.channels == 3);
  QCOMPARE(pixel(frame.left, 5, 5, 0), pixel(frame.left, 5, 5, 2));
}

void IgtlSourceTest::DescriptionMayCropIt() {
  const Server server("good");
  const TemporaryFolder folder;
  SourceOptions options;
  options.left = server.source;
  options.right_first = true;
  options.crop = {8, 4, 32, 40};
  write_source(folder.path() / "server.json", options);
  StereoVideo video(folder.path() / "server.json");
  StereoFrame frame;
  QVERIFY(video.read(frame));
  QVERIFY(frame.left.width == 32 && frame.left.height == 40);
  QCOMPARE(pixel(frame.left, 0, 0, 1), 4 + 7);
  QCOMPARE(pixel(frame.right, 0, 0, 1), 4);
}

void IgtlSourceTest::ServerThatClosesIsTheEnd() {
  const Server server("brief");
  StereoVideo video(server.source);
  StereoFrame frame;
  int frames = 0;
  while (video.read(frame)) ++frames;
  QVERIFY(frames >= 1 && frames <= 3);
}

void IgtlSourceTest::CancelEndsOpeningAndReading() {
  const auto cancel = std::make_shared<CancelFlag>();
  const RunContext context({}, cancel, 1);
  const Server good("good"), silent("silent");
  const auto video = StereoVideo::open(good.source, {}, context);
  QVERIFY(video);
  cancel->request();
  QElapsedTimer timer;
  timer.start();
  QVERIFY(!StereoVideo::open(silent.source, {}, context));
  StereoFrame frame;
  while ((*video)->read(frame) && timer.elapsed() < 5000) {
  }
  QVERIFY2(timer.elapsed() < 200, qPrintable(QString::number(timer.elapsed())));
}

void IgtlSourceTest::NobodyThereIsSaid() {
  try {
    StereoVideo video("igtl:127.0.0.1:1/Left,Right");
    QFAIL("opened");
  } catch (const InputError& error) {
    QVERIFY2(QString(error.what()).contains("no server of OpenIGTLink answers"), error.what());
  }
  QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo("igtl:plus.example.org:18944/Left,Right"));
  QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo("igtl:127.0.0.1:18944"));
}

void IgtlSourceTest::OtherArrangementsAreRefused() {
  SourceOptions options;
  options.left = "igtl:127.0.0.1:1/L,R";
  options.layout = Layout::top_bottom;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options.layout = Layout::separate;
  options.right = "igtl:127.0.0.1:1/L,R";
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options.left = "device:0";
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
}

void IgtlSourceTest::NoCaseReachesIt() {
  QVERIFY(!stays_here("igtl:127.0.0.1:18944/L,R"));
  QVERIFY(is_live("igtl:127.0.0.1:18944/L,R") && is_live("device:0") && !is_live("scope.mkv"));
  QVERIFY(!is_device("igtl:127.0.0.1:18944/L,R"));
}

QTEST_GUILESS_MAIN(IgtlSourceTest)
#include "igtl_source_test.moc"
