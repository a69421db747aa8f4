// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <QTest>
#include <random>

#include "complaint.h"
#include "escapes.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/picture_reader.h"
#include "mutant.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

/// Pictures and videos that are meant to do harm, and readers that they have taken over.
class HostilePicturesTest : public QObject {
  Q_OBJECT
  TemporaryFolder folder_;
  fs::path at(const char* name) const { return folder_.path() / name; }
  std::string complaint_of(const fs::path& picture) const {
    return test::complaint<Error>([&] { (void)read_picture(picture); });
  }
  void use_reader(const std::string& script) const;

 private slots:
  void cleanup() { qunsetenv("GLISSON_READ_PICTURES"); }
  void TheReaderIsConfined();
  void ScansWithoutEndAreEnded();
  void DamagedPicturesEndNothing();
  void DamagedVideosEndNothing();
  void WhatBreaksTheReaderIsASentence();
  void AReaderThatLiesIsNotBelieved();
  void AVideoThatBreaksItsReaderIsNoShortVideo();
};

namespace {

Picture pattern(int width, int height, int shift = 0) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int i = 0; i < width * height * 3; ++i)
    bytes->push_back(static_cast<std::uint8_t>(128.0 + 90.0 * std::sin(0.02 * i + shift)));
  return {width, height, 3, std::move(bytes)};
}

template <std::size_t size>
std::string raw(const char (&bytes)[size]) {
  return std::string(bytes, size - 1);
}

/// A progressive JPEG of 1024 x 1024 grey pixels that goes over them `scans` times: twelve bytes each time.
std::string jpeg_of_scans(int scans) {
  std::string bytes = raw("\xFF\xD8\xFF\xDB\x00\x43\x00") + std::string(64, '\x01');
  bytes += raw("\xFF\xC2\x00\x0B\x08\x04\x00\x04\x00\x01\x01\x11\x00");                     // its size
  bytes += raw("\xFF\xC4\x00\x14\x00\x01") + std::string(15, '\0') + std::string(1, '\0');  // no difference
  bytes += raw("\xFF\xC4\x00\x14\x10\x01") + std::string(15, '\0') + raw("\xE0");  // 16384 blocks of zeros
  bytes += raw("\xFF\xDA\x00\x08\x01\x01\x00\x00\x00\x00") + std::string(16384 / 8, '\0');
  for (int n = 0; n < scans; ++n) bytes += raw("\xFF\xDA\x00\x08\x01\x01\x00\x01\x3F\x00\x00\x01");
  return bytes + raw("\xFF\xD9");
}

/// Grey, not packed, one strip.
std::string tiff_of(std::uint16_t width, std::uint16_t height) {
  const auto word = [](std::uint16_t value) {
    return std::string{static_cast<char>(value & 255), static_cast<char>(value >> 8)};
  };
  std::string bytes = raw("II*\0\x08\0\0\0");
  const std::vector<std::pair<std::uint16_t, std::uint16_t>> tags = {
      {256, width}, {257, height}, {258, 8},
      {259, 1},     {262, 1},      {273, 122},
      {277, 1},     {278, height}, {279, static_cast<std::uint16_t>(width * height)}};
  bytes += word(static_cast<std::uint16_t>(tags.size()));
  for (const auto& [tag, value] : tags)
    bytes += word(tag) + word(3) + raw("\1\0\0\0") + word(value) + word(0);
  bytes += raw("\0\0\0\0");
  return bytes + std::string(static_cast<std::size_t>(width) * height, '\x55');
}

void write_film(const fs::path& path, int frames) {
  VideoWriter writer(path, 64, 48, 25.0);
  for (int n = 0; n < frames; ++n) writer.write(pattern(64, 48, n));
  writer.close();
}

}  // namespace

void HostilePicturesTest::use_reader(const std::string& script) const {
  write_file_atomically(at("reader"), "#!/bin/sh\n" + script + "\n");
  fs::permissions(at("reader"), fs::perms::owner_all);
  qputenv("GLISSON_READ_PICTURES", QByteArray::fromStdString(at("reader").string()));
}

void HostilePicturesTest::TheReaderIsConfined() {
  if (!test::can_confine()) QSKIP("this kernel confines nothing, or this is a build with sanitizers");
  QCOMPARE(test::broken_out(picture_reader_escapes()), std::vector<std::string>());
}

void HostilePicturesTest::ScansWithoutEndAreEnded() {
// Sanitizers leave the reader twenty times its processor time, and do not slow the decoder.
#if defined(GLISSON_INSTRUMENTED)
  constexpr int kMany = 1600000;
#else
  constexpr int kMany = 400000;
#endif
  PictureReader reader;
  write_file_atomically(at("few.jpg"), jpeg_of_scans(3));
  const Picture few = reader.read(at("few.jpg"));
  QCOMPARE(few.width, 1024);
  QCOMPARE(few.bytes->at(500000), std::uint8_t{128});
  // A minute's work or more in 5 MB: the reader is killed, and the next picture gets another one.
  write_file_atomically(at("many.jpg"), jpeg_of_scans(kMany));
  QVERIFY_THROWS_EXCEPTION(InputError, (void)reader.read(at("many.jpg")));
  QCOMPARE(reader.read(at("few.jpg")).width, 1024);
}

void HostilePicturesTest::DamagedPicturesEndNothing() {
  std::mt19937 random(20);
  PictureReader reader;
  write_file_atomically(at("a.tif"), tiff_of(32, 24));
  QCOMPARE(reader.read(at("a.tif")).bytes->at(100), std::uint8_t{0x55});
  for (const char* name : {"a.png", "a.jpg", "a.bmp", "a.tif"}) {
    if (std::string(name) != "a.tif") write_picture(at(name), pattern(32, 24));
    const std::string good = read_file(at(name));
    int refused = 0;
    for (int n = 0; n < 100; ++n) {
      write_file_atomically(at(name), test::mutant_of(good, random, 40));
      try {
        const Picture picture = reader.read(at(name));
        QCOMPARE(picture.bytes->size(), static_cast<std::size_t>(picture.width) *
                                            static_cast<std::size_t>(picture.height) *
                                            static_cast<std::size_t>(picture.channels));
      } catch (const InputError&) {
        ++refused;
      }
    }
    QVERIFY2(refused > 0, name);
  }
}

void HostilePicturesTest::DamagedVideosEndNothing() {
  std::mt19937 random(21);
  write_film(at("a.mkv"), 6);
  const std::string good = read_file(at("a.mkv"));
  for (int n = 0; n < 20; ++n) {
    write_file_atomically(at("a.mkv"), test::mutant_of(good, random, 40));
    try {
      StereoVideo video(at("a.mkv"));
      int frames = 0;
      for (StereoFrame frame; frames < 100 && video.read(frame); ++frames)
        QCOMPARE(frame.left.width, video.width());
    } catch (const Error&) {
    }
  }
}

void HostilePicturesTest::WhatBreaksTheReaderIsASentence() {
  write_picture(at("a.png"), pattern(32, 24));
  write_film(at("a.mkv"), 3);
  for (const char* script :
       {"exit 1", "kill -SEGV $$", "kill -KILL $$", "timeout 0.3 head -c 4 >/dev/null"}) {
    use_reader(script);
    QVERIFY2(complaint_of(at("a.png")).find("is not a whole picture") != std::string::npos, script);
    const std::string told = test::complaint<Error>([&] { (void)StereoVideo(at("a.mkv")); });
    QVERIFY2(told.find("is not a video that can be read") != std::string::npos, told.c_str());
  }
  // Without its decoder no video can be read, which is no fault of the video.
  use_reader("printf '\\002'; head -c 31 /dev/zero");
  const std::string told = test::complaint<FileError>([&] { (void)StereoVideo(at("a.mkv")); });
  QVERIFY2(told.find("Install Glisson again") != std::string::npos, told.c_str());
  qputenv("GLISSON_READ_PICTURES", "/nowhere/at/all");
  QCOMPARE(read_picture(at("a.png")).width, 32);  // the one that was built beside this test
}

void HostilePicturesTest::AReaderThatLiesIsNotBelieved() {
  write_picture(at("a.png"), pattern(32, 24));
  write_film(at("a.mkv"), 3);
  // 33 x 24; 2000000000 x 2000000000; -1 x -1; five channels. Pixels without end behind each.
  for (const char* sizes :
       {"\\041\\0\\0\\0\\030\\0\\0\\0\\003\\0\\0\\0", "\\0\\224\\065\\167\\0\\224\\065\\167\\003\\0\\0\\0",
        "\\377\\377\\377\\377\\377\\377\\377\\377\\003\\0\\0\\0",
        "\\040\\0\\0\\0\\030\\0\\0\\0\\005\\0\\0\\0"}) {
    const std::string pixels = std::string("printf '") + sizes + "\\0\\0\\0\\0'\nyes";
    use_reader(pixels);
    QVERIFY2(complaint_of(at("a.png")).find("is not a whole picture") != std::string::npos, sizes);
    // A video of 64 x 48, 25 a second, ten frames, the first of which is of another size.
    use_reader(
        "printf '\\001\\0\\0\\0\\100\\0\\0\\0\\060\\0\\0\\0\\0\\0\\0\\0"
        "\\0\\0\\0\\0\\0\\0\\071\\100\\0\\0\\0\\0\\0\\0\\044\\100'\n"
        "printf '\\001\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0\\0'\n" +
        pixels);
    StereoVideo video(at("a.mkv"));
    QCOMPARE(video.frame_count(), 10);
    StereoFrame frame;
    const std::string told = test::complaint<Error>([&] { (void)video.read(frame); });
    QVERIFY2(told.find("breaks off after 0 frames of 10") != std::string::npos, told.c_str());
  }
}

void HostilePicturesTest::AVideoThatBreaksItsReaderIsNoShortVideo() {
  write_film(at("a.mkv"), 6);
  qunsetenv("GLISSON_READ_PICTURES");
  // The reader as it is, cut off in the middle of the third frame.
  const std::size_t two = 32 + 2 * (16 + 16 + 64 * 48 * 3);
  use_reader("'" GLISSON_PICTURE_READER "' \"$@\" | stdbuf -o0 head -c " + std::to_string(two));
  StereoVideo video(at("a.mkv"));
  StereoFrame frame;
  QVERIFY(video.read(frame) && video.read(frame));
  const std::string told = test::complaint<Error>([&] { (void)video.read(frame); });
  QVERIFY2(told.find("is damaged after 2 frames") != std::string::npos, told.c_str());
}

QTEST_GUILESS_MAIN(HostilePicturesTest)
#include "hostile_pictures_test.moc"
