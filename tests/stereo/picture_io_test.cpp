// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/picture_io.h"

#include <QTest>
#include <fstream>
#include <iterator>

#include "full_disk.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/paced_writer.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

namespace {

/// Smooth colours that differ by position, and by frame.
Picture pattern(int width, int height, int channels, int frame = 0) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c)
        bytes->push_back(
            static_cast<std::uint8_t>(128.0 + 90.0 * std::sin(0.05 * x + 0.08 * y * (c + 1) + 0.3 * frame)));
  return {width, height, channels, std::move(bytes)};
}

/// It cannot be made small.
Picture noise(int width, int height, int frame) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  std::uint32_t state = 17U + static_cast<std::uint32_t>(frame);
  for (int i = 0; i < 3 * width * height; ++i) {
    state = state * 1664525U + 1013904223U;
    bytes->push_back(static_cast<std::uint8_t>(state >> 24U));
  }
  return {width, height, 3, std::move(bytes)};
}

double mean_difference(const Picture& a, const Picture& b, int a_x0 = 0) {
  double sum = 0.0;
  for (int y = 0; y < b.height; ++y)
    for (int x = 0; x < b.width; ++x)
      for (int c = 0; c < b.channels; ++c)
        sum += std::abs(
            static_cast<int>(
                (*a.bytes)[static_cast<std::size_t>((y * a.width + x + a_x0) * a.channels + c)]) -
            static_cast<int>((*b.bytes)[static_cast<std::size_t>((y * b.width + x) * b.channels + c)]));
  return sum / (b.width * b.height * b.channels);
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void write_video(const fs::path& path, int width, int height, int frames, double rate = 25.0) {
  VideoWriter writer(path, width, height, rate);
  for (int i = 0; i < frames; ++i) writer.write(pattern(width, height, 3, i));
  writer.close();
}

}  // namespace

class PictureIoTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;

 private slots:
  /// The first of all: a start must not wait for FFmpeg and what it brings along.
  void CodecsAreLoadedWhenTheyAreNeeded() {
    const auto is_loaded = [] {
      std::ifstream maps("/proc/self/maps");
      const std::string all{std::istreambuf_iterator<char>(maps), {}};
      return all.find("/libavcodec.so") != std::string::npos;
    };
    QVERIFY(!is_loaded());
    write_picture(folder_.path() / "first.png", pattern(37, 23, 3));
    QVERIFY(is_loaded());
  }
  void LosslessFormatsKeepEveryByte() {
    for (const int channels : {1, 3})
      for (const char* name : {"a.png", "a.bmp"}) {
        const Picture picture = pattern(37, 23, channels);
        write_picture(folder_.path() / name, picture);
        const Picture back = read_picture(folder_.path() / name);
        QCOMPARE(back.width, 37);
        QCOMPARE(back.height, 23);
        QCOMPARE(back.channels, channels);
        QVERIFY(*back.bytes == *picture.bytes);
      }
  }

  void JpegIsClose() {
    write_picture(folder_.path() / "a.jpg", pattern(64, 48, 3));
    QVERIFY(mean_difference(read_picture(folder_.path() / "a.jpg"), pattern(64, 48, 3)) < 4.0);
  }

  void TruncatedAndForeignPicturesAreRefused() {
    for (const char* name : {"b.png", "b.bmp", "b.jpg"}) {
      write_picture(folder_.path() / name, pattern(64, 48, 3));
      const std::string content = read_file(folder_.path() / name);
      write_file_atomically(folder_.path() / name, content.substr(0, content.size() / 2));
      QVERIFY_THROWS_EXCEPTION(InputError, read_picture(folder_.path() / name));
    }
    write_file_atomically(folder_.path() / "c.png", std::string("no picture"));
    QVERIFY_THROWS_EXCEPTION(InputError, read_picture(folder_.path() / "c.png"));
    write_file_atomically(folder_.path() / "c.png", std::string());
    QVERIFY_THROWS_EXCEPTION(InputError, read_picture(folder_.path() / "c.png"));
    QVERIFY_THROWS_EXCEPTION(FileError, read_picture(folder_.path() / "absent.png"));
  }

  void OddExtensionsAndSizesAreNotWritten() {
    QVERIFY_THROWS_EXCEPTION(InputError, write_picture(folder_.path() / "a.txt", pattern(4, 4, 3)));
    Picture wrong = pattern(4, 4, 3);
    wrong.width = 5;
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_picture(folder_.path() / "d.png", wrong));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, write_picture(folder_.path() / "d.png", Picture{}));
    QVERIFY_THROWS_EXCEPTION(FileError, write_picture(folder_.path() / "no" / "d.png", pattern(4, 4, 3)));
    QVERIFY(!fs::exists(folder_.path() / "d.png"));
  }

  void SideBySideVideoGivesItsHalvesInOrder() {
    const auto path = folder_.path() / "side.mkv";
    write_video(path, 128, 48, 12);
    StereoVideo video(path);
    QCOMPARE(video.width(), 64);
    QCOMPARE(video.height(), 48);
    QCOMPARE(video.frame_count(), 12);
    QVERIFY(std::abs(video.frames_per_second() - 25.0) < 1e-6);
    for (int pass = 0; pass < 2; ++pass) {
      StereoFrame frame;
      int count = 0;
      while (video.read(frame)) {
        QCOMPARE(frame.index, count);
        QVERIFY(std::abs(frame.seconds - count / 25.0) < 1e-9);
        const Picture whole = pattern(128, 48, 3, count);
        QVERIFY(mean_difference(whole, frame.left) < 8.0);
        QVERIFY(mean_difference(whole, frame.right, 64) < 8.0);
        ++count;
      }
      QCOMPARE(count, 12);
      video.rewind();
    }
  }

  void TwoFilesGiveOneStereoVideo() {
    write_video(folder_.path() / "l.mkv", 64, 48, 5);
    write_video(folder_.path() / "r.mkv", 64, 48, 5);
    StereoVideo video(folder_.path() / "l.mkv", folder_.path() / "r.mkv");
    StereoFrame frame;
    int count = 0;
    while (video.read(frame)) ++count;
    QCOMPARE(count, 5);
    QCOMPARE(frame.right.width, 64);
  }

  void TwoFilesThatDoNotBelongTogetherAreRefused() {
    write_video(folder_.path() / "one.mkv", 64, 48, 5);
    write_video(folder_.path() / "small.mkv", 32, 48, 5);
    write_video(folder_.path() / "slow.mkv", 64, 48, 5, 10.0);
    write_video(folder_.path() / "short.mkv", 64, 48, 3);
    const auto one = folder_.path() / "one.mkv";
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo(one, folder_.path() / "small.mkv"));
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo(one, folder_.path() / "slow.mkv"));
    StereoVideo video(one, folder_.path() / "short.mkv");
    StereoFrame frame;
    for (int i = 0; i < 3; ++i) QVERIFY(video.read(frame));
    QVERIFY_THROWS_EXCEPTION(InputError, video.read(frame));
  }

  void VideoThatEndsEarlyIsRecognised() {
    const auto path = folder_.path() / "cut.mkv";
    write_video(path, 128, 64, 60);
    const std::string content = read_file(path);
    write_file_atomically(path, content.substr(0, content.size() / 2));
    StereoVideo video(path);
    QCOMPARE(video.frame_count(), 60);
    StereoFrame frame;
    int count = 0;
    bool refused = false;
    try {
      while (video.read(frame)) ++count;
    } catch (const InputError& error) {
      refused = error.file() == path.string() && !error.remedy().empty();
    }
    QVERIFY(refused);
    QVERIFY(count > 10 && count < 60);
  }

  void WhatIsNoVideoIsRefused() {
    write_file_atomically(folder_.path() / "text.mkv", std::string("no video at all"));
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo(folder_.path() / "text.mkv"));
    QVERIFY_THROWS_EXCEPTION(FileError, StereoVideo(folder_.path() / "absent.mkv"));
    const TemporaryFolder empty;
    QVERIFY_THROWS_EXCEPTION(InputError, StereoVideo(empty.path()));
  }

  void RecordingThatIsNotClosedLeavesNothing() {
    TemporaryFolder own;
    write_file_atomically(own.path() / "old.mkv", std::string("the old one"));
    {
      VideoWriter writer(own.path() / "old.mkv", 64, 48, 25.0);
      writer.write(pattern(64, 48, 3));
      QCOMPARE(files_in(own.path()), std::size_t{2});
    }
    QCOMPARE(files_in(own.path()), std::size_t{1});
    QCOMPARE(read_file(own.path() / "old.mkv"), std::string("the old one"));
  }

  void RecordingReplacesTheOldOneOnlyWhenWhole() {
    TemporaryFolder own;
    write_file_atomically(own.path() / "a.mkv", std::string("the old one"));
    write_video(own.path() / "a.mkv", 64, 48, 4);
    QCOMPARE(files_in(own.path()), std::size_t{1});
    QCOMPARE(StereoVideo(own.path() / "a.mkv").frame_count(), 4);
  }

  void AFullDiskIsSaidAtOnceAndWhatWasRecordedPlays() {
    const fs::path path = folder_.path() / "full.mkv";
    int asked = 0;
    FilmPace pace(25.0);
    PacedWriter writer(path, 64, 48, 25.0, [&](const fs::path& folder) {
      return fs::equivalent(folder, folder_.path()) && ++asked <= 10 ? 1e9 : 0.0;
    });
    for (int i = 0; i < 10; ++i) writer.add(pattern(64, 48, 3, i), pace.next(i / 25.0));
    try {
      writer.add(pattern(64, 48, 3), pace.next(10 / 25.0));
      QFAIL("was written");
    } catch (const FileError& error) {
      QVERIFY2(QByteArray(error.what()).contains("the disk is full after 10 frames"), error.what());
    }
    QVERIFY(!fs::exists(path));
    QCOMPARE(writer.keep(), 10);
    QCOMPARE(StereoVideo(path).frame_count(), 10);
  }

  void OfAFileThatCouldNotGrowThePartThatPlaysIsKept() {
    const fs::path path = folder_.path() / "stuck.mkv";
    constexpr int kFrames = 60;
    int kept = 0;
    QByteArray said;
    {
      VideoWriter writer(path, 320, 240, 25.0);
      const test::FullDisk full(200000);
      for (int i = 0; i < kFrames; ++i) writer.write(noise(320, 240, i));
      try {
        writer.close();
      } catch (const PartlyRecorded& partly) {
        kept = partly.frames();
        said = partly.what();
      }
    }
    QVERIFY2(kept > 0 && kept < kFrames, qPrintable(QString::number(kept)));
    QVERIFY2(said.contains(QByteArray::number(kept) + " of 60 frames can be read back"), said);
    StereoVideo video(path);
    int played = 0;
    try {
      for (StereoFrame frame; video.read(frame);) ++played;
    } catch (const InputError&) {
      // The container may promise more than there is.
    }
    QCOMPARE(played, kept);
  }

  void OfNothingNothingIsKept() {
    const fs::path path = folder_.path() / "none.mkv";
    VideoWriter writer(path, 64, 48, 25.0);
    QVERIFY_THROWS_EXCEPTION(FileError, writer.close());
    QVERIFY(!fs::exists(path));
  }

  void AFilmRunsAsFastAsWhatWasFilmed() {
    FilmPace pace(30.0);
    const auto is = [](const FilmPace::Place& place, int repeats, int number) {
      return !place.taken && place.repeats == repeats && place.number == number;
    };
    QVERIFY(is(pace.next(5.0), 0, 0));
    QVERIFY(is(pace.next(5.0 + 1 / 30.0), 0, 1));
    QVERIFY(is(pace.next(5.0 + 4 / 30.0), 2, 4));  // two were not drawn: the one before stays
    QVERIFY(pace.next(5.0 + 4 / 30.0).taken);
    QVERIFY(is(pace.next(15.0), 0, 5));  // a jump in the source is no pause
    QVERIFY(is(pace.next(15.0 + 2 / 30.0), 1, 7));
    QCOMPARE(pace.frames(), 8);
  }

  void PicturesThatComeALittleEarlyOrLateAreAllInTheFilm() {
    FilmPace pace(30.0);
    QVERIFY(!pace.next(2.015).taken);  // late: all others seem early by nearly half a frame
    for (int n = 1; n < 200; ++n) {
      const double jitter = 3e-3 * ((7 * n) % 11 - 5) / 5.0;
      const FilmPace::Place place = pace.next(2.0 + n / 30.0 + jitter);
      QVERIFY(!place.taken && place.repeats == 0);
      QCOMPARE(place.number, n);
    }
  }

  void OfASourceThatRunsFasterSomeAreLeftOut() {
    FilmPace pace(30.0);
    int kept = 0;
    for (int n = 0; n < 240; ++n) kept += pace.next(n / 60.0).taken ? 0 : 1;
    QVERIFY2(std::abs(kept - 120) <= 2, qPrintable(QString::number(kept)));
    QVERIFY(std::abs(pace.frames() - 120) <= 2);  // as long as what was filmed
  }

  void WhatCouldNotBeBroughtToItsEndIsKeptAsFarAsItPlays() {
    const fs::path path = folder_.path() / "ended.mkv";
    constexpr int kFrames = 60;
    PacedWriter writer(path, 320, 240, 25.0);
    const test::FullDisk full(200000);
    FilmPace pace(25.0);
    for (int i = 0; i < kFrames; ++i) writer.add(noise(320, 240, i), pace.next(i / 25.0));
    QVERIFY_THROWS_EXCEPTION(PartlyRecorded, writer.close());
    const int kept = writer.keep();  // a second time, as who cleans up after an error does
    QVERIFY2(kept > 0 && kept < kFrames, qPrintable(QString::number(kept)));
  }

  void WherePicturesAreMissingTheOneBeforeStays() {
    const fs::path path = folder_.path() / "paced.mkv";
    FilmPace pace(25.0);
    PacedWriter writer(path, 64, 48, 25.0);
    for (const int frame : {0, 1, 5}) writer.add(pattern(64, 48, 3, frame), pace.next(frame / 25.0));
    writer.add(pattern(64, 48, 3, 40), pace.next(5 / 25.0));  // that moment is taken
    writer.close();
    StereoVideo video(path);
    StereoFrame frame;
    std::vector<Picture> read;
    while (video.read(frame)) read.push_back(frame.left);
    QCOMPARE(read.size(), std::size_t{6});
    for (const int standing : {2, 3, 4})
      QVERIFY(mean_difference(pattern(64, 48, 3, 1), read[static_cast<std::size_t>(standing)]) < 6.0);
    QVERIFY(mean_difference(pattern(64, 48, 3, 5), read[5]) < 6.0);
  }

  void OddSizesAndGreyPicturesAreRecorded_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("channels");
    QTest::newRow("an odd height") << 64 << 47 << 3;
    QTest::newRow("an odd width") << 63 << 48 << 3;
    QTest::newRow("grey") << 64 << 48 << 1;
  }
  void OddSizesAndGreyPicturesAreRecorded() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, channels);
    const fs::path path = folder_.path() / (std::string(QTest::currentDataTag()) + ".mkv");
    VideoWriter writer(path, width, height, 25.0);
    const Picture picture = pattern(width, height, channels);
    for (int i = 0; i < 3; ++i) writer.write(picture);
    writer.close();
    SourceOptions source;
    source.left = path.string();
    source.layout = Layout::row_interleaved;  // gives the whole picture; its first field is as it was
    StereoVideo video(source);
    QCOMPARE(video.width(), width + width % 2);
    QCOMPARE(video.height(), height + height % 2);
    StereoFrame frame;
    QVERIFY(video.read(frame));
    double sum = 0.0;
    for (int y = 0; y < frame.left.height; y += 2)
      for (int x = 0; x < frame.left.width; ++x) {
        const int from = std::min(y, height - 1) * width + std::min(x, width - 1);
        const int was = (*picture.bytes)[static_cast<std::size_t>(from * channels)],
                  is = (*frame.left.bytes)[static_cast<std::size_t>((y * frame.left.width + x) * 3)];
        sum += std::abs(is - was);
      }
    QVERIFY2(sum / (0.5 * frame.left.width * frame.left.height) < 6.0, qPrintable(QString::number(sum)));
  }

  void WriterRefusesWhatItCannotRecord() {
    QVERIFY_THROWS_EXCEPTION(InputError, VideoWriter(folder_.path() / "a.mp4", 64, 48, 25.0));
    QVERIFY_THROWS_EXCEPTION(FileError, VideoWriter(folder_.path() / "no" / "a.mkv", 64, 48, 25.0));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, VideoWriter(folder_.path() / "a.mkv", 0, 48, 25.0));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, VideoWriter(folder_.path() / "a.mkv", 64, 48, 0.0));
    VideoWriter writer(folder_.path() / "e.mkv", 64, 48, 25.0);
    QVERIFY_THROWS_EXCEPTION(PreconditionError, writer.write(pattern(32, 48, 3)));
    writer.write(pattern(64, 48, 3));
    writer.close();
    QVERIFY_THROWS_EXCEPTION(PreconditionError, writer.write(pattern(64, 48, 3)));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, writer.close());
  }
};

QTEST_APPLESS_MAIN(PictureIoTest)
#include "picture_io_test.moc"
