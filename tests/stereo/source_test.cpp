// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/source.h"

#include <sys/stat.h>

#include <QTest>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <future>
#include <thread>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reconstruct.h"
#include "picture_cv.h"
#include "rendered_pair.h"
#include "retimed.h"
#include "stream_views.h"
#include "streams.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

namespace {

using Brightness = std::function<double(int x, int y)>;

Picture drawn(int width, int height, int channels, const Brightness& brightness) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        bytes->push_back(static_cast<std::uint8_t>(std::clamp(brightness(x, y), 0.0, 255.0)));
  return {width, height, channels, std::move(bytes)};
}

/// Smooth, and other for each view and frame.
double shade(int view, int frame, double x, double y) {
  return 128.0 + 80.0 * std::sin(0.09 * x + 0.05 * y + 2.0 * view + 0.4 * frame);
}
Picture view_of(int view, int frame, int width = 64, int height = 48) {
  return drawn(width, height, 3, [&](int x, int y) { return shade(view, frame, x, y); });
}

double difference(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels) return HUGE_VAL;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.bytes->size(); ++i)
    sum += std::abs(static_cast<int>((*a.bytes)[i]) - static_cast<int>((*b.bytes)[i]));
  return sum / static_cast<double>(a.bytes->size());
}

/// A camera of 128 x 48 whose third picture is of another width.
class ChangingCamera : public PictureStream {
 public:
  explicit ChangingCamera(int third) : third_(third) {
    name = "device:0";
    width = 128;
    height = 48;
    rate = 30.0;
    live = true;
  }
  bool grab() override {
    seconds = ++taken_ / rate;
    return true;
  }
  bool retrieve(cv::Mat& image) override {
    image = cv::Mat(height, taken_ == 3 ? third_ : width, CV_8UC3, cv::Scalar::all(120));
    return true;
  }
  void rewind() override {}

 private:
  int third_, taken_ = 0;
};

}  // namespace

class SourceTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

  std::string at(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Frames of a video, each drawn by its number.
  void film(const std::string& name, int width, int height, int frames,
            const std::function<double(int frame, int x, int y)>& brightness, double rate = 25.0) const {
    VideoWriter writer(at(name), width, height, rate);
    for (int i = 0; i < frames; ++i)
      writer.write(drawn(width, height, 3, [&](int x, int y) { return brightness(i, x, y); }));
    writer.close();
  }

 private slots:
  void EveryLayoutGivesBothViews_data() {
    QTest::addColumn<int>("layout");
    QTest::newRow("side by side") << static_cast<int>(Layout::side_by_side);
    QTest::newRow("top and bottom") << static_cast<int>(Layout::top_bottom);
    QTest::newRow("separate") << static_cast<int>(Layout::separate);
  }
  void EveryLayoutGivesBothViews() {
    QFETCH(int, layout);
    SourceOptions options;
    options.layout = static_cast<Layout>(layout);
    options.left = at("layout.mkv");
    if (options.layout == Layout::side_by_side)
      film("layout.mkv", 128, 48, 4, [](int i, int x, int y) { return shade(x / 64, i, x % 64, y); });
    else if (options.layout == Layout::top_bottom)
      film("layout.mkv", 64, 96, 4, [](int i, int x, int y) { return shade(y / 48, i, x, y % 48); });
    else
      for (int view = 0; view < 2; ++view)
        film(view == 0 ? "layout.mkv" : "other.mkv", 64, 48, 4,
             [=](int i, int x, int y) { return shade(view, i, x, y); });
    if (options.layout == Layout::separate) options.right = at("other.mkv");
    for (const bool right_first : {false, true}) {
      options.right_first = right_first;
      StereoVideo video(options);
      QCOMPARE(video.width(), 64);
      QCOMPARE(video.height(), 48);
      StereoFrame frame;
      int count = 0;
      for (; video.read(frame); ++count) {
        QVERIFY(difference(frame.left, view_of(right_first ? 1 : 0, count)) < 6.0);
        QVERIFY(difference(frame.right, view_of(right_first ? 0 : 1, count)) < 6.0);
      }
      QCOMPARE(count, 4);
      QCOMPARE(video.skipped(), 0);
    }
  }

  void ARecorderThatStoppedAMomentBeforeTheOtherIsTheEnd() {
    for (int view = 0; view < 2; ++view)
      film(view == 0 ? "longer.mkv" : "shorter.mkv", 64, 48, view == 0 ? 5 : 4,
           [=](int i, int x, int y) { return shade(view, i, x, y); });
    for (const auto& [left, right] :
         {std::pair("longer.mkv", "shorter.mkv"), {"shorter.mkv", "longer.mkv"}}) {
      StereoVideo video(at(left), at(right));
      StereoFrame frame;
      int count = 0;
      while (video.read(frame)) ++count;
      QCOMPARE(count, 4);
    }
  }

  /// One frame that the other recorder dropped is no licence to end anywhere.
  void ACutFileIsToldThoughAFrameWasDroppedBefore() {
    const std::vector<int> all = {0, 40, 80, 120, 160, 200, 240, 280, 320, 360};
    std::vector<int> dropped = all;
    dropped.erase(dropped.begin() + 2);
    const auto put = [&](const std::string& name, int view, const std::vector<int>& times) {
      film(name, 64, 48, static_cast<int>(times.size()),
           [=](int i, int x, int y) { return shade(view, i, x, y); });
      const test::Retimer retimed(read_file(at(name)), times, 400.0);
      write_file_atomically(at(name), retimed.content());
    };
    put("whole.mkv", 0, dropped);
    put("cut.mkv", 1, all);
    const auto read_all = [&] {
      StereoVideo video(at("whole.mkv"), at("cut.mkv"));
      int count = 0;
      for (StereoFrame frame; video.read(frame); ++count) continue;
      return std::pair(count, video.skipped());
    };
    QCOMPARE(read_all(), std::pair(9, 1));
    const std::string whole = read_file(at("cut.mkv"));
    write_file_atomically(at("cut.mkv"), whole.substr(0, whole.size() * 6 / 10));
    QVERIFY_THROWS_EXCEPTION(InputError, read_all());
  }

  void FramesHaveTheTimesOfTheirFile_data() {
    QTest::addColumn<bool>("separate");
    QTest::newRow("both views in a file") << false;
    QTest::newRow("two files") << true;
  }
  /// A recorder of 25 pictures a second that dropped some, once eight in a row.
  void FramesHaveTheTimesOfTheirFile() {
    QFETCH(bool, separate);
    const std::vector<int> times = {0, 40, 80, 160, 240, 280, 640, 680, 760, 800};
    for (const char* name : {"uneven.mkv", "uneven_right.mkv"}) {
      film(name, 128, 48, static_cast<int>(times.size()),
           [](int i, int x, int y) { return shade(x / 64, i, x % 64, y); });
      const test::Retimer retimed(read_file(at(name)), times, 840.0);
      QCOMPARE(retimed.blocks(), times.size());
      write_file_atomically(at(name), retimed.content());
    }
    SourceOptions options;
    options.left = at("uneven.mkv");
    if (separate) options.right = at("uneven_right.mkv"), options.layout = Layout::separate;
    StereoVideo video(options);
    for (int pass = 0; pass < 2; ++pass) {
      std::size_t k = 0;
      for (StereoFrame frame; video.read(frame); ++k) {
        QVERIFY(k < times.size());
        QVERIFY2(std::abs(frame.seconds - 1e-3 * times[k]) < 2e-3,
                 qPrintable(QString("frame %1: %2 s").arg(k).arg(frame.seconds)));
      }
      QCOMPARE(k, times.size());  // and its end is no break
      video.rewind();
    }
    const std::string whole = read_file(at("uneven.mkv"));
    write_file_atomically(at("uneven.mkv"), whole.substr(0, whole.size() / 2));
    StereoVideo cut(options);
    const auto read_all = [&] {
      for (StereoFrame frame; cut.read(frame);) continue;
    };
    QVERIFY_THROWS_EXCEPTION(InputError, read_all());
  }

  void InterleavedRowsAreTakenApart() {
    fs::create_directories(folder_.path() / "rows");
    film("rows.mkv", 64, 48, 3, [](int i, int x, int y) { return shade(y % 2, i, x, y); });
    SourceOptions options;
    options.left = at("rows.mkv");
    options.layout = Layout::row_interleaved;
    StereoVideo video(options);
    StereoFrame frame;
    QVERIFY(video.read(frame));
    QCOMPARE(frame.left.height, 48);
    QVERIFY(difference(frame.left, view_of(0, 0)) < 12.0);  // the coder blurs rows that differ so
    QVERIFY(difference(frame.right, view_of(1, 0)) < 12.0);
  }

  void DeinterlacingShowsOneMoment() {
    // Two fields of something that has moved between them.
    const Picture first = view_of(0, 0), second = view_of(0, 3);
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*first.bytes);
    for (int y = 1; y < 48; y += 2)
      std::copy_n(second.bytes->begin() + y * 64 * 3, 64 * 3, bytes->begin() + y * 64 * 3);
    const Picture combed{64, 48, 3, bytes};
    QVERIFY(difference(combed, first) > 20.0);
    QVERIFY(difference(to_picture(one_field(stereo::view(combed), 0)), first) < 0.6);
  }

  void CropIsOfEachViewAndMovesTheCalibration() {
    film("crop.mkv", 128, 48, 2, [](int i, int x, int y) { return shade(x / 64, i, x % 64, y); });
    SourceOptions options;
    options.left = at("crop.mkv");
    options.crop = {10, 4, 40, 0};
    StereoVideo video(options);
    QCOMPARE(video.width(), 40);
    QCOMPARE(video.height(), 44);
    StereoFrame frame;
    QVERIFY(video.read(frame));
    QVERIFY(difference(frame.right,
                       drawn(40, 44, 3, [](int x, int y) { return shade(1, 0, x + 10, y + 4); })) < 6.0);
    const StereoRig whole = rendered::rig(), part = cropped(whole, {100, 50, 400, 300});
    const Eigen::Vector3d p(0.01, -0.005, 0.1);
    QVERIFY((whole.left.project(p) - part.left.project(p) - Eigen::Vector2d(100, 50)).norm() < 1e-9);
    QCOMPARE(part.right.width, 400);
    QVERIFY_THROWS_EXCEPTION(InputError, cropped(whole, {635, 0, 0, 0}));
    QVERIFY_THROWS_EXCEPTION(InputError, cropped(whole, {400, 0, 0, 0}));  // its principal point is cut off
    options.crop = {60, 0, 10, 0};
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo{options});
  }

  void FoldersOfPicturesAreVideos() {
    fs::create_directories(folder_.path() / "pairs");
    for (const int i : {2, 10, 1})
      for (int view = 0; view < 2; ++view)
        write_picture(
            folder_.path() / "pairs" / ((view == 0 ? "left" : "right") + std::to_string(i) + ".png"),
            view_of(view, i));
    StereoVideo video(folder_.path() / "pairs");
    QCOMPARE(video.frame_count(), 3);
    StereoFrame frame;
    for (int pass = 0; pass < 2; ++pass) {
      for (const int i : {1, 2, 10}) {
        QVERIFY(video.read(frame));
        QCOMPARE(difference(frame.left, view_of(0, i)), 0.0);
        QCOMPARE(difference(frame.right, view_of(1, i)), 0.0);
      }
      QVERIFY(!video.read(frame));
      video.rewind();
    }
    write_picture(folder_.path() / "pairs/left11.png", view_of(0, 1, 32, 48));
    write_picture(folder_.path() / "pairs/right11.png", view_of(1, 1, 32, 48));
    StereoVideo odd(folder_.path() / "pairs");
    for (int i = 0; i < 3; ++i) QVERIFY(odd.read(frame));
    QVERIFY_THROWS_EXCEPTION(InputError, odd.read(frame));
  }

  void DescriptionIsReadAsItIsWritten() {
    SourceOptions options;
    options.left = "/somewhere/left.mkv";
    options.right = "/somewhere/right.mkv";
    options.layout = Layout::separate;
    options.right_first = options.deinterlace = true;
    options.crop = {1, 2, 300, 200};
    options.pictures_per_second = 12.5;
    options.largest_skew = 0.004;
    write_source(folder_.path() / "source.json", options);
    const SourceOptions back = read_source(folder_.path() / "source.json");
    QCOMPARE(back.left, options.left);
    QCOMPARE(back.right, options.right);
    QVERIFY(back.layout == options.layout && back.right_first && back.deinterlace);
    QVERIFY(back.crop.x == 1 && back.crop.y == 2 && back.crop.width == 300 && back.crop.height == 200);
    QCOMPARE(back.pictures_per_second, 12.5);
    QCOMPARE(back.largest_skew, 0.004);
  }

  void DescriptionStandsForItsVideoAnywhere() {
    film("stack.mkv", 64, 96, 2, [](int i, int x, int y) { return shade(y / 48, i, x, y % 48); });
    write_file_atomically(folder_.path() / "stack.json", R"({"left": "stack.mkv", "layout": "top_bottom"})");
    StereoVideo video(folder_.path() / "stack.json");
    StereoFrame frame;
    QVERIFY(video.read(frame));
    QVERIFY(difference(frame.right, view_of(1, 0)) < 6.0);
  }

  void BadDescriptionsAreRefused_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("a list") << QByteArray("[]");
    QTest::newRow("nothing") << QByteArray("{}");
    QTest::newRow("unknown field") << QByteArray(R"({"left": "a.mkv", "colour": 1})");
    QTest::newRow("unknown layout") << QByteArray(R"({"left": "a.mkv", "layout": "diagonal"})");
    QTest::newRow("no right") << QByteArray(R"({"left": "a.mkv", "layout": "separate"})");
    QTest::newRow("a right too many")
        << QByteArray(R"({"left": "a.mkv", "right": "b.mkv", "layout": "top_bottom"})");
    QTest::newRow("crop of three") << QByteArray(R"({"left": "a.mkv", "crop": [1, 2, 3]})");
    QTest::newRow("negative crop") << QByteArray(R"({"left": "a.mkv", "crop": [-1, 2, 3, 4]})");
    QTest::newRow("no rate") << QByteArray(R"({"left": "a", "pictures_per_second": 0})");
    QTest::newRow("skew of a minute") << QByteArray(R"({"left": "a.mkv", "largest_skew_ms": 60000})");
    QTest::newRow("deinterlace in words") << QByteArray(R"({"left": "a.mkv", "deinterlace": "yes"})");
  }
  void BadDescriptionsAreRefused() {
    QFETCH(QByteArray, content);
    write_file_atomically(folder_.path() / "bad.json", content.toStdString());
    QVERIFY_THROWS_EXCEPTION(InputError, read_source(folder_.path() / "bad.json"));
  }

  /// No camera is needed: a pipe is as live as one for OpenCV. It cannot be wound back, has no length, and
  /// ends in the middle of a frame when what writes into it goes away.
  void ALiveSourceGivesItsFramesUntilItIsUnplugged() {
    constexpr int kFrames = 40;
    film("whole.mkv", 128, 48, kFrames, [](int i, int x, int y) { return shade(x / 64, i, x % 64, y); });
    const std::string content = read_file(at("whole.mkv"));
    QCOMPARE(::mkfifo(at("camera").c_str(), 0600), 0);
    std::jthread camera([&] {
      std::ofstream pipe(at("camera"), std::ios::binary);
      pipe.write(content.data(), static_cast<std::streamsize>(content.size() * 3 / 5));
    });
    StereoVideo video("device:" + at("camera"));
    QCOMPARE(video.width(), 64);
    QCOMPARE(video.frame_count(), 0);  // live: nobody knows
    int frames = 0;
    double before = -1.0;
    for (StereoFrame frame; video.read(frame); ++frames) {
      QCOMPARE(frame.index, frames);
      QVERIFY(frame.seconds > before && (frames > 0 || frame.seconds == 0.0));
      before = frame.seconds;
      if (frame.index == 3) {
        QVERIFY(difference(frame.left, view_of(0, 3)) < 6.0);
        QVERIFY(difference(frame.right, view_of(1, 3)) < 6.0);
      }
    }
    QVERIFY2(frames > 5 && frames < kFrames, std::to_string(frames).c_str());
    StereoFrame frame;
    QVERIFY(!video.read(frame));  // and stays unplugged
  }

  /// A camera that hangs keeps its driver: nobody else has to wait for that.
  void ADeadCameraIsLetGo() {
    film("start.mkv", 128, 48, 40, [](int i, int x, int y) { return shade(x / 64, i, x % 64, y); });
    const std::string content = read_file(at("start.mkv"));
    QCOMPARE(::mkfifo(at("dead").c_str(), 0600), 0);
    const auto cancel = std::make_shared<CancelFlag>();
    std::promise<void> let_go;
    std::atomic<bool> gave_up{false};
    std::jthread camera([&] {
      std::ofstream pipe(at("dead"), std::ios::binary);
      pipe.write(content.data(), static_cast<std::streamsize>(content.size() * 3 / 5));
      pipe.flush();
      cancel->request();
      // Dead from here on, but not unplugged. Whoever waits for it waits for long, not for ever.
      gave_up = let_go.get_future().wait_for(std::chrono::seconds(20)) == std::future_status::timeout;
    });
    const auto video = StereoVideo::open("device:" + at("dead"), {}, RunContext({}, cancel, 1));
    StereoFrame frame;
    while (video && (*video)->read(frame)) {
    }
    QVERIFY(!video || !(*video)->read(frame));
    let_go.set_value();
    camera.join();
    QVERIFY(!gave_up);
  }

  void TwoDevicesHaveOneClock() {
    // Numbered pictures, opened by OpenCV as a device is.
    for (int i = 0; i < 4; ++i) write_picture(at("still-0" + std::to_string(i) + ".png"), view_of(0, i));
    DeviceStream first(at("still-%02d.png"));
    DeviceStream second(at("still-%02d.png"));
    QVERIFY(first.live && first.frames == 0);
    for (int i = 0; i < 4; ++i) {
      QVERIFY(first.grab() && second.grab());
      const double left = first.seconds;
      QVERIFY(second.seconds >= left);  // it was grabbed later
      cv::Mat picture;
      QVERIFY(second.retrieve(picture) && picture.cols == 64);
    }
    QVERIFY(!first.grab());
  }

  void OneOfTwoDevicesUnpluggedIsTheEnd() {
    for (int i = 0; i < 6; ++i) {
      if (i < 3) write_picture(at("one-0" + std::to_string(i) + ".png"), view_of(0, i));
      write_picture(at("other-0" + std::to_string(i) + ".png"), view_of(1, i));
    }
    SourceOptions options;
    options.left = "device:" + at("one-%02d.png");
    options.right = "device:" + at("other-%02d.png");
    options.layout = Layout::separate;
    options.largest_skew = 1.0;  // these come as fast as they are read
    StereoVideo video(options);
    int frames = 0;
    for (StereoFrame frame; video.read(frame); ++frames)
      QVERIFY(difference(frame.left, view_of(0, frames)) < 1.0);
    QCOMPARE(frames, 3);
  }

  void APictureOfAnotherSizeIsRefusedWhileItIsLive_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<bool>("two");
    QTest::newRow("smaller, both views in one picture") << 64 << false;
    QTest::newRow("larger, both views in one picture") << 256 << false;
    QTest::newRow("smaller, a camera each") << 64 << true;
    QTest::newRow("larger, a camera each") << 256 << true;
  }
  void APictureOfAnotherSizeIsRefusedWhileItIsLive() {
    QFETCH(int, width);
    QFETCH(bool, two);
    const std::unique_ptr<Views> views =
        two ? views_of(std::make_unique<ChangingCamera>(128), std::make_unique<ChangingCamera>(width), 1.0)
            : views_of(std::make_unique<ChangingCamera>(width), Layout::side_by_side);
    cv::Mat left, right;
    for (int i = 0; i < 2; ++i) QVERIFY(views->read(left, right));
    QCOMPARE(right.cols, two ? 128 : 64);
    try {
      views->read(left, right);
      QFAIL("it was taken");
    } catch (const InputError& error) {
      const std::string sizes = "is " + std::to_string(width) + "x48, the pictures before 128x48";
      QVERIFY2(std::string(error.what()).find(sizes) != std::string::npos, error.what());
    }
  }

  void AbsentDevicesAndOddSizesAreRefused() {
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo("device:97"));
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo("device:"));
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo("device:front"));
    film("odd.mkv", 66, 50, 1, [](int i, int x, int y) { return shade(0, i, x, y); });
    SourceOptions options;
    options.left = at("odd.mkv");
    QCOMPARE(StereoVideo(options).width(), 33);
    options.layout = Layout::top_bottom;
    QCOMPARE(StereoVideo(options).height(), 25);
  }

  void TimesDecideWhatIsAPair() {
    QVERIFY(meeting(1.000, 1.010, 0.016) == Meeting::pair);
    QVERIFY(meeting(1.010, 1.000, 0.016) == Meeting::pair);
    QVERIFY(meeting(1.000, 1.020, 0.016) == Meeting::pass_left);
    QVERIFY(meeting(1.020, 1.000, 0.016) == Meeting::pass_right);
  }

  void ViewsThatDriftApartAreRefusedBeyondTheirSkew() {
    const auto frames = [](int i, int x, int y) { return shade(0, i, x, y); };
    film("steady.mkv", 64, 48, 80, frames, 25.0);
    film("faster.mkv", 64, 48, 80, frames, 25.02);  // 32 microseconds later each frame
    SourceOptions options;
    options.left = at("steady.mkv");
    options.right = at("faster.mkv");
    options.layout = Layout::separate;
    StereoFrame frame;
    StereoVideo loose(options);
    int count = 0;
    while (loose.read(frame)) ++count;
    QCOMPARE(count, 80);
    options.largest_skew = 0.0004;
    StereoVideo strict(options);
    bool refused = false;
    for (count = 0; !refused && count < 80; ++count) {
      try {
        if (!strict.read(frame)) break;
      } catch (const InputError& error) {
        refused = error.field() == "time";
      }
    }
    QVERIFY(refused);
    QVERIFY(count < 40);
  }
};

QTEST_APPLESS_MAIN(SourceTest)
#include "source_test.moc"
