// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/reach.h"

#include <QTest>
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "complaint.h"
#include "glisson/core/files.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/source.h"
#include "state_folder.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

class ReachTest : public QObject {
  Q_OBJECT
 private slots:
  void OnlyListedSchemesAreOpened() {
    for (const char* good : {"device:0", "device:rtsp://h/x", "device:https://h/x", "device:/dev/video1"})
      QVERIFY2(test::complaint([&] { require_known_scheme(good); }).empty(), good);
    for (const char* bad :
         {"device:ftp://h/x", "device:file:///etc/passwd", "device:gopher://h", "device:x://"})
      QVERIFY2(!test::complaint([&] { require_known_scheme(bad); }).empty(), bad);
    QVERIFY2(test::complaint([&] { StereoVideo video("device:ftp://192.0.2.1/x"); }).find("rtsp") !=
                 std::string::npos,
             "the stream itself asks");
  }

  /// What a description names may have come from anywhere; what a person has entered once, has not.
  void DescriptionsReachOutToWhatAPersonHasEnteredOnly() {
    const TemporaryFolder folder;
    const test::StateFolder state;
    const auto told = [&folder](const std::string& left) {
      write_file_atomically(folder.path() / "s.json", "{\"left\": \"" + left + "\"}");
      return test::complaint<Error>([&] { StereoVideo video(folder.path() / "s.json"); });
    };
    const std::string refusal = "left: names a source outside this computer";
    for (const char* source : {"device:http://127.0.0.1:1/x", "igtl:127.0.0.1:1/Left,Right",
                               "device:fakesrc ! appsink", "device:/no/such/list.m3u8"}) {
      QVERIFY2(told(source).find(refusal) != std::string::npos, source);
      remember_sources({source});
      const std::string now = told(source);
      QVERIFY2(!now.empty() && now.find(refusal) == std::string::npos, now.c_str());
    }
    // Entered by opening it, whether it answers or not.
    QVERIFY(!test::complaint<Error>([] { StereoVideo video("device:http://127.0.0.1:2/x"); }).empty());
    QVERIFY(told("device:http://127.0.0.1:2/x").find(refusal) == std::string::npos);
    QVERIFY(told("device:http://127.0.0.1:3/x").find(refusal) != std::string::npos);
    QVERIFY(told("device:98").find(refusal) == std::string::npos);  // a camera of this computer
  }

  void WhatWasEnteredIsListedOnceTheLatestLast() {
    const test::StateFolder state;
    QVERIFY(!is_entered("device:0"));
    remember_sources({"device:0", "igtl:127.0.0.1:1/L,R"});
    remember_sources({"device:1", ""});
    remember_sources({"device:0", "two\nlines"});
    QCOMPARE(read_file(state.path() / "known_sources"),
             std::string("igtl:127.0.0.1:1/L,R\ndevice:1\ndevice:0\n"));
    QVERIFY(is_entered("device:1") && is_entered("device:0") && !is_entered("device:2") && !is_entered(""));
    std::vector<std::string> cameras;
    for (int camera = 0; camera < 1000; ++camera) cameras.push_back("device:" + std::to_string(camera));
    remember_sources(cameras);
    const std::string list = read_file(state.path() / "known_sources");
    QCOMPARE(std::count(list.begin(), list.end(), '\n'), std::ptrdiff_t{1000});
    QVERIFY2(list.starts_with("device:0\n") && list.ends_with("\ndevice:999\n"), "the oldest has gone");
  }

  void AFileIsTheSameHoweverItIsReached() {
    const test::StateFolder state;
    const TemporaryFolder folder;
    const fs::path real = fs::canonical(folder.path());
    fs::create_directory(real / "films");
    write_file_atomically(real / "films/a.mkv", std::string("x"));
    fs::create_directory_symlink("films", real / "link");
    remember_sources({(real / "films/../link/a.mkv").string(), (real / "films/").string(),
                      (real / "films/left_*.png").string(), (real / "gone/b.mkv").string()});
    QCOMPARE(read_file(state.path() / "known_sources"),
             (real / "films/a.mkv").string() + '\n' + (real / "films").string() + '\n' +
                 (real / "films/left_*.png").string() + '\n' + (real / "gone/b.mkv").string() + '\n');
    for (const char* name : {"films/a.mkv", "link/a.mkv", "films", "link/", "link/left_*.png", "gone/b.mkv"})
      QVERIFY2(is_entered((real / name).string()), name);
    for (const char* name : {"films/b.mkv", "link/right_*.png", "gone"})
      QVERIFY2(!is_entered((real / name).string()), name);
  }

  void TheListIsTheUsersOwn() {
    const test::StateFolder state;
    const auto mode = [](const fs::path& path) { return fs::status(path).permissions(); };
    constexpr fs::perms kOwn = fs::perms::owner_read | fs::perms::owner_write;
    remember_sources({"device:0"});
    QVERIFY(mode(state.path()) == fs::perms::owner_all);
    QVERIFY(mode(state.path() / "known_sources") == kOwn);
    // Of an earlier edition, which others may have read.
    fs::permissions(state.path() / "known_sources", kOwn | fs::perms::group_read | fs::perms::others_read);
    remember_sources({"device:1"});
    QVERIFY(mode(state.path() / "known_sources") == kOwn);
  }

  void WhereItCannotBeWrittenWorkGoesOn() {
    const test::StateFolder state;
    write_file_atomically(state.path(), std::string("no folder"));
    remember_sources({"device:0"});
    QVERIFY(!is_entered("device:0"));
    QCOMPARE(read_file(state.path()), std::string("no folder"));
  }

  void OpeningAndDescribingEnter() {
    const test::StateFolder state;
    const TemporaryFolder folder;
    const auto at = [&folder](const char* name) { return (folder.path() / name).string(); };
    QVERIFY(!test::complaint<Error>([&] { StereoVideo video(at("l.mkv"), at("r.mkv")); }).empty());
    QVERIFY(is_entered(at("l.mkv")) && is_entered(at("r.mkv")));
    // A description that was made here, and what it names relative to itself.
    SourceOptions options;
    options.left = "made.mkv";
    write_source(at("made.json"), options);
    QVERIFY(is_entered(at("made.json")) && is_entered(at("made.mkv")));
    // One from elsewhere is chosen by opening it, not by reading it.
    write_file_atomically(at("got.json"), std::string(R"({"left": "got.mkv"})"));
    (void)read_source(at("got.json"));
    QVERIFY(!is_entered(at("got.json")) && !is_entered(at("got.mkv")));
    QVERIFY(!test::complaint<Error>([&] { StereoVideo video(at("got.json")); }).empty());
    QVERIFY(is_entered(at("got.json")) && is_entered(at("got.mkv")));
  }

  void PicturesAreAskedForTheirSizeFirst_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("word");
    const QByteArray png("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16), end("\0\0\0\0IEND", 8);
    const QString large = "more than any camera", none = "is not a whole picture";
    QTest::newRow("PNG") << png + QByteArray("\0\0\xFF\xFF\0\0\xFF\xFF\x08\x02\0\0\0", 13) + end << large;
    for (const int length : {8, 11, 12, 15})
      QTest::addRow("PNG of %d bytes", length) << png.first(length) << none;
    QTest::newRow("PNG of no size") << png + QByteArray("\0\0\0\0\0\0\xFF\xFF\x08\x02\0\0\0", 13) + end
                                    << none;
    QTest::newRow("JPEG") << QByteArray("\xFF\xD8\xFF\xC0\0\x11\x08\xFF\xFF\xFF\xFF\x03\xFF\xD9", 14)
                          << large;
    QTest::newRow("BMP") << QByteArray("BM\0\0\0\0\0\0\0\0\0\0\0\0\x28\0\0\0\xFF\xFF\0\0\xFF\xFF\0\0", 26)
                         << large;
    QTest::newRow("TIFF")
        << QByteArray("II*\0\x08\0\0\0\x02\0\0\1\x04\0\1\0\0\0\xFF\xFF\0\0\1\1\x04\0\1\0\0\0\xFF\xFF\0\0", 34)
        << large;
    QTest::newRow("a format for which there is no need") << QByteArray("P5\n2 2\n255\nabcd") << none;
    QTest::newRow("TIFF that points beyond its end") << QByteArray("II*\0\xFF\xFF\xFF\xFF", 8) << none;
  }
  void PicturesAreAskedForTheirSizeFirst() {
    QFETCH(QByteArray, content);
    QFETCH(QString, word);
    const TemporaryFolder folder;
    write_file_atomically(folder.path() / "a.png", content.toStdString());
    const std::string told = test::complaint([&] { (void)read_picture(folder.path() / "a.png"); });
    QVERIFY2(QString::fromStdString(told).contains(word), told.c_str());
  }

  void PlayListsAreNoVideos_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("HLS") << QByteArray("#EXTM3U\n#EXTINF:1,\nhttp://192.0.2.1/x.ts\n");
    QTest::newRow("concat") << QByteArray("ffconcat version 1.0\nfile /etc/passwd\n");
    QTest::newRow("SDP") << QByteArray("v=0\no=- 0 0 IN IP4 192.0.2.1\n");
    QTest::newRow("DASH") << QByteArray("<?xml version=\"1.0\"?><MPD></MPD>");
    QTest::newRow("nothing") << QByteArray();
    for (const int length : {4, 7, 8, 11})
      QTest::addRow("AVI of %d bytes", length) << QByteArray("RIFF\0\0\0\0AVI ", 12).first(length);
  }
  void PlayListsAreNoVideos() {
    QFETCH(QByteArray, content);
    QVERIFY(!begins_as_video(content.toStdString()));
    const TemporaryFolder folder;
    write_file_atomically(folder.path() / "film.mkv", content.toStdString());
    const std::string told = test::complaint([&] { StereoVideo video(folder.path() / "film.mkv"); });
    QVERIFY2(told.find("is not a video") != std::string::npos, told.c_str());
  }
};

QTEST_APPLESS_MAIN(ReachTest)
#include "reach_test.moc"
