// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of strangers: what fits is taken, whatever the pieces in which it comes; nothing else is.
#include "incoming.h"

#include <igtl_util.h>

#include <QTest>
#include <cmath>
#include <random>

#include "message_bytes.h"

using namespace glisson;
using namespace glisson::openigtlink;
using test::image_bytes;
using test::transform_bytes;

namespace {

void put(std::string& bytes, std::size_t at, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i)
    bytes[at + static_cast<std::size_t>(i)] = static_cast<char>(value >> (8 * (count - 1 - i)));
}
/// Size and check sum as the body is.
std::string resealed(std::string bytes) {
  put(bytes, 42, bytes.size() - kHeadSize, 8);
  put(bytes, 50,
      crc64(reinterpret_cast<unsigned char*>(bytes.data()) + kHeadSize, bytes.size() - kHeadSize, 0), 8);
  return bytes;
}

struct Taken {
  std::vector<Head> heads;
  std::vector<std::string> contents;
  bool goes_on = true;
  int damaged = 0;
};
Taken take(const std::string& bytes, std::size_t piece) {
  Taken taken;
  Messages messages([](const Head&) { return true; },
                    [&](const Head& head, std::string_view content) {
                      taken.heads.push_back(head);
                      taken.contents.emplace_back(content);
                    });
  for (std::size_t at = 0; at < bytes.size() && taken.goes_on; at += piece)
    taken.goes_on = messages.feed(std::string_view(bytes).substr(at, piece));
  taken.damaged = messages.damaged();
  return taken;
}

}  // namespace

class IncomingTest : public QObject {
  Q_OBJECT
 private slots:
  void PiecesOfAnySizeGiveTheSameMessages();
  void PictureComesAsItWasSent();
  void PoseComesInMetres();
  void LaterVersionsOfTheProtocolAreRead();
  void DamagedBodiesArePassedOver();
  void HeadersThatAreNoneEndIt_data();
  void HeadersThatAreNoneEndIt();
  void PicturesThatDoNotHoldAreRefused_data();
  void PicturesThatDoNotHoldAreRefused();
  void PosesThatAreNoneAreRefused();
  void MutantsDoNoHarm();
};

void IncomingTest::PiecesOfAnySizeGiveTheSameMessages() {
  const std::string bytes = transform_bytes() + image_bytes() + transform_bytes();
  for (const std::size_t piece : {1UL, 7UL, 57UL, 58UL, 59UL, 100000UL}) {
    const Taken taken = take(bytes, piece);
    QVERIFY(taken.goes_on);
    QCOMPARE(taken.heads.size(), std::size_t{3});
    QCOMPARE(taken.heads[1].type, std::string("IMAGE"));
    QCOMPARE(taken.heads[1].device, std::string("Here"));
    QCOMPARE(taken.heads[1].seconds, 1000.5);
    QCOMPARE(taken.contents[2].size(), std::size_t{48});
  }
}

void IncomingTest::PictureComesAsItWasSent() {
  const auto picture = picture_in(take(image_bytes(), 1000).contents.at(0));
  QVERIFY(picture && picture->width == 32 && picture->height == 16 && picture->channels == 3);
  // Red, green, blue were 3, 4, 5 in the second pixel.
  QVERIFY((*picture->bytes)[3] == 5 && (*picture->bytes)[4] == 4 && (*picture->bytes)[5] == 3);
  QVERIFY(picture_in(take(image_bytes(32, 16, 1), 1000).contents.at(0))->channels == 1);
}

void IncomingTest::PoseComesInMetres() {
  const auto pose = pose_in(take(transform_bytes(), 1000).contents.at(0));
  QVERIFY(pose);
  QVERIFY((pose->translation - Eigen::Vector3d(0.01, -0.02, 0.12)).norm() < 1e-9);
  QVERIFY((pose->rotation.col(0) - Eigen::Vector3d::UnitY()).norm() < 1e-9);
  QVERIFY((pose->rotation.col(1) + Eigen::Vector3d::UnitX()).norm() < 1e-9);
}

void IncomingTest::LaterVersionsOfTheProtocolAreRead() {
  const std::string plain = transform_bytes();
  std::string bytes = plain.substr(0, kHeadSize);
  put(bytes, 0, 2, 2);
  std::string extended(12, '\0');
  put(extended, 0, 12, 2);
  put(extended, 2, 8, 2);
  put(extended, 4, 5, 4);
  const std::string body = plain.substr(kHeadSize);
  const Taken taken = take(resealed(bytes + extended + body + std::string(13, 'm')), 1000);
  QCOMPARE(taken.contents.size(), std::size_t{1});
  QVERIFY(taken.contents[0] == body);
  // Parts that are longer than the whole.
  put(extended, 4, 0xffffffff, 4);
  QCOMPARE(take(resealed(bytes + extended + body), 1000).damaged, 1);
  QCOMPARE(take(resealed(bytes + "short"), 1000).damaged, 1);
}

void IncomingTest::DamagedBodiesArePassedOver() {
  std::string bytes = image_bytes();
  bytes[200] = static_cast<char>(bytes[200] ^ 4);
  const Taken taken = take(bytes + transform_bytes(), 100);
  QCOMPARE(taken.damaged, 1);
  QCOMPARE(taken.heads.size(), std::size_t{1});
  QCOMPARE(taken.heads[0].type, std::string("TRANSFORM"));
}

void IncomingTest::HeadersThatAreNoneEndIt_data() {
  QTest::addColumn<int>("at");
  QTest::addColumn<qulonglong>("value");
  QTest::addColumn<int>("count");
  QTest::newRow("version 0") << 0 << 0ULL << 2;
  QTest::newRow("version 9") << 0 << 9ULL << 2;
  QTest::newRow("no type") << 2 << 0ULL << 1;
  QTest::newRow("a type of no letters") << 3 << 7ULL << 1;
  QTest::newRow("a name of no letters") << 15 << 200ULL << 1;
  QTest::newRow("a body of 101 MB") << 42 << 101000000ULL << 8;
  QTest::newRow("a body without end") << 42 << ~0ULL << 8;
}
void IncomingTest::HeadersThatAreNoneEndIt() {
  QFETCH(int, at);
  QFETCH(qulonglong, value);
  QFETCH(int, count);
  std::string bytes = transform_bytes();
  put(bytes, static_cast<std::size_t>(at), value, count);
  const Taken taken = take(bytes + transform_bytes(), 1000);
  QVERIFY(!taken.goes_on);
  QVERIFY(taken.heads.empty());
}

void IncomingTest::PicturesThatDoNotHoldAreRefused_data() {
  QTest::addColumn<int>("at");  // in the body
  QTest::addColumn<int>("value");
  QTest::addColumn<int>("count");
  QTest::newRow("version") << 0 << 2 << 2;
  QTest::newRow("two components") << 2 << 2 << 1;
  QTest::newRow("no components") << 2 << 0 << 1;
  QTest::newRow("16 bits") << 3 << 5 << 1;
  QTest::newRow("wider") << 6 << 33 << 2;
  QTest::newRow("of no width") << 6 << 0 << 2;
  QTest::newRow("higher than high") << 8 << 65535 << 2;
  QTest::newRow("a volume") << 10 << 2 << 2;
  QTest::newRow("a part, moved") << 60 << 1 << 2;
  QTest::newRow("a part, smaller") << 66 << 31 << 2;
}
void IncomingTest::PicturesThatDoNotHoldAreRefused() {
  QFETCH(int, at);
  QFETCH(int, value);
  QFETCH(int, count);
  std::string bytes = image_bytes();
  QVERIFY(picture_in(take(bytes, 1000).contents.at(0)));
  put(bytes, kHeadSize + static_cast<std::size_t>(at), static_cast<std::uint64_t>(value), count);
  QVERIFY(!picture_in(take(resealed(bytes), 1000).contents.at(0)));
}

void IncomingTest::PosesThatAreNoneAreRefused() {
  const auto refused = [](const std::string& bytes) { return !pose_in(take(bytes, 1000).contents.at(0)); };
  QVERIFY(!refused(transform_bytes()));
  QVERIFY(refused(transform_bytes(NAN)));
  QVERIFY(refused(transform_bytes(0.0F, INFINITY)));
  QVERIFY(refused(transform_bytes(0.5F)));            // no rotation
  QVERIFY(refused(transform_bytes(0.0F, 10100.0F)));  // ten metres away
  QVERIFY(refused(resealed(transform_bytes() + "more")));
  QVERIFY(refused(resealed(transform_bytes().substr(0, kHeadSize + 47))));
}

void IncomingTest::MutantsDoNoHarm() {
  const std::string whole = image_bytes() + transform_bytes();
  std::mt19937 random(7);
  int pictures = 0, ends = 0;
  for (int turn = 0; turn < 4000; ++turn) {
    std::string bytes = whole;
    for (int change = 0; change < 1 + turn % 4; ++change)
      bytes[random() % (turn % 2 ? 140 : bytes.size())] = static_cast<char>(random());
    if (turn % 3 == 0) bytes.resize(random() % bytes.size());
    if (turn % 5 == 0 && bytes.size() > kHeadSize) bytes = resealed(bytes);  // the sum does not help then
    const Taken taken = take(bytes, 1 + random() % 700);
    ends += !taken.goes_on;
    for (std::size_t i = 0; i < taken.heads.size(); ++i) {
      const auto picture = picture_in(taken.contents[i]);
      pictures += picture.has_value();
      if (picture)
        QCOMPARE(picture->bytes->size(),
                 static_cast<std::size_t>(picture->width * picture->height * picture->channels));
      (void)pose_in(taken.contents[i]);
    }
  }
  QVERIFY(pictures > 50 && ends > 50);
}

QTEST_APPLESS_MAIN(IncomingTest)
#include "incoming_test.moc"
