// SPDX-License-Identifier: GPL-3.0-or-later
// What is recorded of the live view is there, whatever the disk does, and nobody waits for it.
#include "glisson/ui/guidance/recorder.h"

#include <QTest>
#include <atomic>
#include <future>

#include "box_patient.h"
#include "glisson/core/files.h"
#include "glisson/patient/overlay_record.h"
#include "glisson/patient/track_replay.h"
#include "glisson/stereo/picture_io.h"

using namespace glisson;
using ui::Recorded;
using ui::Recorder;
namespace fs = std::filesystem;

namespace {

constexpr int kWidth = 64, kHeight = 48;

Picture grey(int light, int channels = 3) {
  return {kWidth, kHeight, channels,
          std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(channels * kWidth * kHeight),
                                                      static_cast<std::uint8_t>(light))};
}

int light_of(const Picture& picture) { return (*picture.bytes)[picture.bytes->size() / 2]; }

/// The listener's words, to be waited for.
struct Heard {
  std::promise<ui::RecordingEnd> ended;
  std::promise<QString> trouble;
  std::atomic<int> left_out{0};
  Recorder::Listener listener() {
    return {[this](int pictures) { left_out = pictures; },
            [this](const QString& error) { trouble.set_value(error); },
            [this](const ui::RecordingEnd& end) { ended.set_value(end); }};
  }
};

}  // namespace

class RecorderTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;
  std::shared_ptr<const PatientModel> model_ = std::make_shared<const PatientModel>(box_patient());

  fs::path at(const char* name) const { return folder_.path() / name; }

  ui::RecordedFrame frame(int index, Validity validity = Validity::valid) const {
    ui::RecordedFrame frame;
    frame.drawn = grey(200);
    frame.left = grey(60);
    frame.right = grey(120);
    frame.overlay.index = 40 + index;
    frame.overlay.seconds = (40 + index) / 30.0;
    frame.overlay.validity = validity;
    frame.overlay.evidence.judged = true;
    frame.overlay.evidence.gap = 1.5;
    frame.overlay.nodes_in_camera =
        model_->mesh.vertices.rowwise() + Eigen::RowVector3d(1e-3 * index, 0.0, 0.13);
    frame.age = 0.03;
    frame.model = model_;
    return frame;
  }
  ui::RecordingOptions options(const char* name, Recorded what) const {
    ui::RecordingOptions options;
    options.path = at(name);
    options.what = what;
    options.remedy = [](Validity validity) {
      return validity == Validity::valid ? std::string() : std::string("Do this.");
    };
    return options;
  }

 private slots:
  void OverlayRawAndBoth_data();
  void OverlayRawAndBoth();
  void GreyViewsAreRecordedAsTheyCome_data();
  void GreyViewsAreRecordedAsTheyCome();
  void EachPicturesLineDrawsItAgain();
  void NobodyWaitsForTheWritingAndWhatIsLeftOutIsCounted();
  void AFullDiskIsSaidAtOnceAndWhatWasRecordedPlays();
  void WhatCannotBeBroughtToItsEndIsSaid();
  void WhatEndsEarlySaysWhyAndPlays();
  void ARecordingWithoutPicturesLeavesNothing();
};

void RecorderTest::OverlayRawAndBoth_data() {
  QTest::addColumn<int>("what");
  QTest::addColumn<bool>("raw_beside");
  QTest::newRow("overlay") << static_cast<int>(Recorded::overlay) << false;
  QTest::newRow("raw") << static_cast<int>(Recorded::raw) << false;
  QTest::newRow("both") << static_cast<int>(Recorded::both) << true;
}

void RecorderTest::OverlayRawAndBoth() {
  QFETCH(int, what);
  QFETCH(bool, raw_beside);
  const char* name = QTest::currentDataTag();
  const std::string file = std::string(name) + ".mkv";
  Heard heard;
  {
    Recorder recorder(options(file.c_str(), static_cast<Recorded>(what)), heard.listener());
    for (const int index : {0, 1, 4}) recorder.add(frame(index));  // two were not drawn
  }
  const ui::RecordingEnd end = heard.ended.get_future().get();
  QVERIFY2(end.error.isEmpty(), qPrintable(end.error));
  QVERIFY(end.frames == 5 && end.left_out == 0);
  // Each frame has its line, or shows the picture before; the record counts its lines.
  const fs::path record = Recorder::lines_path(at(file.c_str()));
  const int lines = static_cast<int>(read_overlay_record(record).frames.size());
  QVERIFY(lines == 3 && end.repeated == 2);
  QVERIFY(read_file(record).find("\"frames\":3}") != std::string::npos);
  QCOMPARE(fs::exists(Recorder::raw_path(at(file.c_str()))), raw_beside);
  const bool is_raw = static_cast<Recorded>(what) == Recorded::raw;
  const auto check = [&](const fs::path& path, bool raw) {
    stereo::StereoVideo video(path);  // side by side: of the overlay the halves of one view
    QCOMPARE(video.width(), raw ? kWidth : kWidth / 2);
    int count = 0;
    for (StereoFrame read; video.read(read); ++count) {
      QVERIFY(std::abs(light_of(read.left) - (raw ? 60 : 200)) < 6);
      QVERIFY(std::abs(light_of(read.right) - (raw ? 120 : 200)) < 6);
    }
    QCOMPARE(count, 5);
  };
  check(at(file.c_str()), is_raw);
  if (raw_beside) check(Recorder::raw_path(at(file.c_str())), true);
}

void RecorderTest::GreyViewsAreRecordedAsTheyCome_data() {
  QTest::addColumn<int>("left");
  QTest::addColumn<int>("right");
  QTest::newRow("both") << 1 << 1;
  QTest::newRow("left") << 1 << 3;
  QTest::newRow("right") << 3 << 1;
}

void RecorderTest::GreyViewsAreRecordedAsTheyCome() {
  QFETCH(int, left);
  QFETCH(int, right);
  const std::string file = std::string("grey_") + QTest::currentDataTag() + ".mkv";
  Heard heard;
  {
    Recorder recorder(options(file.c_str(), Recorded::raw), heard.listener());
    ui::RecordedFrame shown = frame(0);
    shown.left = grey(60, left);
    shown.right = grey(120, right);
    recorder.add(shown);
  }
  const ui::RecordingEnd end = heard.ended.get_future().get();
  QVERIFY2(end.error.isEmpty() && end.frames == 1, qPrintable(end.error));
  stereo::StereoVideo video(at(file.c_str()));
  StereoFrame read;
  QVERIFY(video.read(read));
  QCOMPARE(video.width(), kWidth);
  QVERIFY(std::abs(light_of(read.left) - 60) < 6 && std::abs(light_of(read.right) - 120) < 6);
}

void RecorderTest::EachPicturesLineDrawsItAgain() {
  Heard heard;
  {
    Recorder recorder(options("lines.mkv", Recorded::overlay), heard.listener());
    recorder.add(frame(0));
    recorder.add(frame(3, Validity::partly_covered));
    recorder.add(frame(4, Validity::surface_apart));
  }
  const OverlayRecord record = read_overlay_record(Recorder::lines_path(at("lines.mkv")));
  QVERIFY(record.complete && record.frames.size() == 3);
  const OverlayLine& second = record.frames[1];
  QVERIFY(second.number == 43 && second.film_frame == 3 && second.age.has_value());
  QVERIFY(second.remedy == "Do this." && second.overlay.evidence.gap == 1.5);
  QVERIFY(second.camera_from_model.has_value());
  QVERIFY(record.frames[0].remedy.empty());
  QVERIFY(!record.frames[2].nodes_here);  // withdrawn: its place is none
  const int nodes = model_->mesh.vertex_count();
  const TrackReplay replay(Recorder::lines_path(at("lines.mkv")), nodes);
  QVERIFY(replay.is_recording() && replay.first() == 40);
  const auto again = replay.at(43, 43 / 30.0, 30.0);
  QVERIFY(again && again->validity == Validity::partly_covered);
  QVERIFY((again->nodes_in_camera - frame(3).overlay.nodes_in_camera).cwiseAbs().maxCoeff() < 1e-7);
  const TrackReplay own(Recorder::lines_path(at("lines.mkv")), nodes, TrackReplay::Frames::of_the_recording);
  QVERIFY(own.at(3, 0.1, 30.0).has_value() && !own.at(2, 2 / 30.0, 30.0).has_value());
}

void RecorderTest::NobodyWaitsForTheWritingAndWhatIsLeftOutIsCounted() {
  std::promise<void> go_on;
  std::shared_future<void> may_write = go_on.get_future().share();
  ui::RecordingOptions slow = options("slow.mkv", Recorded::overlay);
  slow.space = [may_write](const fs::path&) {
    may_write.wait();
    return 1e9;
  };
  Heard heard;
  constexpr int kAll = 40;
  {
    Recorder recorder(slow, heard.listener());
    for (int k = 0; k < kAll; ++k) recorder.add(frame(k));  // comes back at once, or this never ends
    QVERIFY(!recorder.is_done());
    const int left_out = heard.left_out;
    QVERIFY2(left_out >= kAll - 9 && left_out <= kAll - 8, qPrintable(QString::number(left_out)));
    go_on.set_value();
  }
  const ui::RecordingEnd end = heard.ended.get_future().get();
  QCOMPARE(end.left_out, heard.left_out.load());
  QVERIFY(end.error.isEmpty());
  const OverlayRecord record = read_overlay_record(Recorder::lines_path(at("slow.mkv")));
  QCOMPARE(static_cast<int>(record.frames.size()), kAll - end.left_out);
}

void RecorderTest::AFullDiskIsSaidAtOnceAndWhatWasRecordedPlays() {
  ui::RecordingOptions full = options("full.mkv", Recorded::both);
  std::atomic<int> asked{0};
  full.space = [&asked](const fs::path&) { return ++asked <= 12 ? 1e9 : 0.0; };
  Heard heard;
  auto trouble = heard.trouble.get_future();
  auto ended = heard.ended.get_future();
  Recorder recorder(full, heard.listener());
  for (int k = 0; k < 8; ++k) recorder.add(frame(k));
  QVERIFY2(trouble.get().contains("the disk is full after 6 frames"), "six of either film had room");
  const ui::RecordingEnd end = ended.get();
  QVERIFY(end.frames == 6 && !end.error.isEmpty());
  recorder.add(frame(9));  // nobody minds
  QTRY_VERIFY(recorder.is_done());
  for (const fs::path& film : {at("full.mkv"), Recorder::raw_path(at("full.mkv"))})
    QCOMPARE(stereo::StereoVideo(film).frame_count(), 6);
  const OverlayRecord record = read_overlay_record(Recorder::lines_path(at("full.mkv")));
  QVERIFY(!record.complete && record.frames.size() == 6);
}

void RecorderTest::WhatCannotBeBroughtToItsEndIsSaid() {
  const fs::path folder = at("gone");
  fs::create_directory(folder);
  ui::RecordingOptions gone = options("gone/live.mkv", Recorded::both);
  std::atomic<int> asked{0};
  gone.space = [&asked](const fs::path&) {
    ++asked;
    return 1e9;
  };
  Heard heard;
  auto trouble = heard.trouble.get_future();
  auto ended = heard.ended.get_future();
  Recorder recorder(gone, heard.listener());
  recorder.add(frame(0));
  QTRY_COMPARE(asked.load(), 2);  // both films are open
  fs::remove_all(folder);
  recorder.finish();
  QVERIFY(!trouble.get().isEmpty());
  const ui::RecordingEnd end = ended.get();
  QVERIFY(!end.error.isEmpty() && end.frames == 0);
  QTRY_VERIFY(recorder.is_done());
}

void RecorderTest::WhatEndsEarlySaysWhyAndPlays() {
  Heard heard;
  {
    Recorder recorder(options("early.mkv", Recorded::overlay), heard.listener());
    recorder.add(frame(0));
    recorder.finish(QStringLiteral("The drawing failed."));
  }
  const ui::RecordingEnd end = heard.ended.get_future().get();
  QCOMPARE(end.error, QStringLiteral("The drawing failed."));
  QCOMPARE(end.frames, 1);
  QVERIFY(fs::exists(at("early.mkv")));
}

void RecorderTest::ARecordingWithoutPicturesLeavesNothing() {
  Heard heard;
  { Recorder recorder(options("empty.mkv", Recorded::both), heard.listener()); }
  QCOMPARE(heard.ended.get_future().get().frames, 0);
  for (const fs::path& file :
       {at("empty.mkv"), Recorder::raw_path(at("empty.mkv")), Recorder::lines_path(at("empty.mkv"))})
    QVERIFY(!fs::exists(file));
}

QTEST_GUILESS_MAIN(RecorderTest)
#include "recorder_test.moc"
