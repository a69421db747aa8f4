// SPDX-License-Identifier: GPL-3.0-or-later
// What is taken from a server made with the library, and from one that lies.
#include "glisson/openigtlink/receiver.h"

#include <QElapsedTimer>
#include <QTest>

#include "glisson/core/error.h"
#include "peer_process.h"

using namespace glisson;
using namespace glisson::openigtlink;

namespace {

/// A server in a process of its own, and how to reach it.
struct Server {
  explicit Server(const QString& kind) : peer({"serve", kind}) {
    options = parse_pictures("127.0.0.1/Left,Right");
    options.address.port =
        peer.wait_for([](const Words& words) { return words.value(0) == "port"; }).value(1).toInt();
    options.tool = "Tip";
    options.patience = 1.0;
  }
  PeerProcess peer;
  ReceiverOptions options;
};

/// The sentence with which it ends; empty: it did not.
QString complaint(Receiver& receiver) {
  try {
    while (receiver.next_pair(RunContext())) {
    }
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class ReceiverTest : public QObject {
  Q_OBJECT
 private slots:
  void PicturesOfAMomentComeAsAPair_data();
  void PicturesOfAMomentComeAsAPair();
  void OfALostViewNoNeighbourTakesThePlace();
  void GreyPicturesComeAsTheyAre();
  void ToolComesInMetres();
  void NewestPairWins();
  void EndOfTheServerIsAnEnd();
  void CancelEndsTheWaitAtOnce();
  void ClosingDoesNotWait();
  void WhatDoesNotHoldIsComplainedOf_data();
  void WhatDoesNotHoldIsComplainedOf();
  void ToolOfNoNumbersIsNotTaken();
  void NobodyThereIsSaid();
  void AddressesWithNamesAreRead();
};

void ReceiverTest::PicturesOfAMomentComeAsAPair_data() {
  QTest::addColumn<QString>("kind");
  QTest::newRow("one after the other") << "good";
  QTest::newRow("one view a frame behind") << "lagging";
}

void ReceiverTest::PicturesOfAMomentComeAsAPair() {
  QFETCH(QString, kind);
  const Server server(kind);
  Receiver receiver(server.options);
  double last = 0.0;
  for (int turn = 0; turn < 5; ++turn) {
    const auto pair = receiver.next_pair(RunContext());
    QVERIFY(pair);
    QVERIFY(pair->seconds > last);
    last = pair->seconds;
    const int frame = static_cast<int>(std::lround((pair->seconds - 1000.0) * 25.0));
    QVERIFY(pair->left.width == 64 && pair->left.height == 48 && pair->right.width == 64);
    const auto pixel = [](const Picture& picture, int x, int y, int channel) {
      return static_cast<int>((*picture.bytes)[static_cast<std::size_t>(3 * (y * 64 + x) + channel)]);
    };
    for (const auto& [x, y] : {std::pair(0, 0), {5, 3}, {63, 47}}) {
      QCOMPARE(pixel(pair->left, x, y, 0), 200);  // blue
      QCOMPARE(pixel(pair->left, x, y, 1), y);
      QCOMPARE(pixel(pair->left, x, y, 2), (x + frame) % 256);
      QCOMPARE(pixel(pair->right, x, y, 1), y + 7);
      QCOMPARE(pixel(pair->right, x, y, 2), (x + frame + 7) % 256);
    }
  }
}

/// At 60 frames a second the next moment is 17 ms away.
void ReceiverTest::OfALostViewNoNeighbourTakesThePlace() {
  const Server server("fast");
  Receiver receiver(server.options);
  for (int turn = 0; turn < 12; ++turn) {
    const auto pair = receiver.next_pair(RunContext());
    QVERIFY(pair);
    const int frame = static_cast<int>(std::lround((pair->seconds - 1000.0) * 60.0));
    QVERIFY(frame % 3 != 0);
    QCOMPARE(static_cast<int>((*pair->left.bytes)[2]), frame % 256);
    QCOMPARE(static_cast<int>((*pair->right.bytes)[2]), (frame + 7) % 256);
  }
}

void ReceiverTest::GreyPicturesComeAsTheyAre() {
  const Server server("grey");
  Receiver receiver(server.options);
  const auto pair = receiver.next_pair(RunContext());
  QVERIFY(pair && pair->left.channels == 1 && pair->right.channels == 1);
}

void ReceiverTest::ToolComesInMetres() {
  const Server server("good");
  Receiver receiver(server.options);
  QTRY_VERIFY(receiver.tool());
  const ReceivedTool tool = *receiver.tool();
  const double frame = (tool.seconds - 1000.0) * 25.0;
  const Eigen::Vector3d expected(0.01 + 1e-3 * std::round(frame), -0.02, 0.12);
  QVERIFY((tool.camera_from_tool.translation - expected).norm() < 1e-6);
  QVERIFY((tool.camera_from_tool.rotation.col(0) - Eigen::Vector3d::UnitY()).norm() < 1e-6);
  QVERIFY(tool.age >= 0.0 && tool.age < 5.0);
}

void ReceiverTest::NewestPairWins() {
  const Server server("good");
  Receiver receiver(server.options);
  const auto first = receiver.next_pair(RunContext());
  QVERIFY(first);
  QTRY_VERIFY(receiver.passed_over() >= 5);
  const auto next = receiver.next_pair(RunContext());
  QVERIFY(next && next->seconds > first->seconds + 4.5 / 25.0);
}

void ReceiverTest::EndOfTheServerIsAnEnd() {
  const Server server("brief");
  Receiver receiver(server.options);
  QCOMPARE(complaint(receiver), QString());
  QCOMPARE(receiver.connection(), Connection::ended);
}

void ReceiverTest::CancelEndsTheWaitAtOnce() {
  Server server("silent");
  server.options.patience = 30.0;
  Receiver receiver(server.options);
  const auto cancel = std::make_shared<CancelFlag>();
  QElapsedTimer timer;
  std::thread hand([&] {
    while (receiver.connection() != Connection::connected) std::this_thread::yield();
    timer.start();
    cancel->request();
  });
  QVERIFY(!receiver.next_pair(RunContext({}, cancel, 1)));
  hand.join();
  QVERIFY2(timer.elapsed() < 200, qPrintable(QString::number(timer.elapsed())));
}

void ReceiverTest::ClosingDoesNotWait() {
  for (const QString kind : {"silent", "good", "endless"}) {
    const Server server(kind);
    auto receiver = std::make_unique<Receiver>(server.options);
    QTRY_COMPARE(receiver->connection(), Connection::connected);
    QElapsedTimer timer;
    timer.start();
    receiver.reset();
    QVERIFY2(timer.elapsed() < 200, qPrintable(kind + QString::number(timer.elapsed())));
  }
}

void ReceiverTest::WhatDoesNotHoldIsComplainedOf_data() {
  QTest::addColumn<QString>("kind");
  QTest::addColumn<QString>("words");
  QTest::newRow("views that never meet") << "skewed"
                                         << "within 20 ms";
  QTest::newRow("damaged on the way") << "damaged"
                                      << "within 20 ms";
  QTest::newRow("sizes that are none") << "lying"
                                       << "within 20 ms";
  QTest::newRow("a body that never comes") << "endless"
                                           << "no pictures";
  QTest::newRow("nothing at all") << "silent"
                                  << "no pictures";
  QTest::newRow("another protocol") << "noise"
                                    << "no message of OpenIGTLink";
}

void ReceiverTest::WhatDoesNotHoldIsComplainedOf() {
  QFETCH(QString, kind);
  QFETCH(QString, words);
  const Server server(kind);
  Receiver receiver(server.options);
  const QString said = complaint(receiver);
  QVERIFY2(said.contains(words), qPrintable(said));
  QVERIFY2(said.contains("127.0.0.1:"), qPrintable(said));
  if (kind == "damaged" || kind == "lying") QVERIFY(receiver.passed_over() > 3);
  if (kind == "lying") QVERIFY(receiver.tool());  // what holds is taken nevertheless
}

void ReceiverTest::ToolOfNoNumbersIsNotTaken() {
  const Server server("nan");
  Receiver receiver(server.options);
  for (int turn = 0; turn < 3; ++turn) QVERIFY(receiver.next_pair(RunContext()));
  QTRY_VERIFY(receiver.passed_over() >= 2);
  QVERIFY(!receiver.tool());
}

void ReceiverTest::NobodyThereIsSaid() {
  ReceiverOptions options = parse_pictures("127.0.0.1:1/Left,Right");
  Receiver receiver(options);
  const QString said = complaint(receiver);
  QVERIFY2(said.contains("no server of OpenIGTLink answers"), qPrintable(said));
  QCOMPARE(receiver.connection(), Connection::failed);
  QCOMPARE(QString::fromStdString(receiver.problem()), said);
}

void ReceiverTest::AddressesWithNamesAreRead() {
  const ReceiverOptions pictures = parse_pictures("192.168.1.20:18945/Scope_L,Scope_R");
  QCOMPARE(QString::fromStdString(pictures.address.text()), QString("192.168.1.20:18945"));
  QCOMPARE(pictures.left + "|" + pictures.right, std::string("Scope_L|Scope_R"));
  QCOMPARE(parse_tool("/TipToLeftCamera").tool, std::string("TipToLeftCamera"));
  for (const char* text :
       {"", "127.0.0.1:18944", "127.0.0.1/Left", "127.0.0.1/,R", "127.0.0.1/L,", "127.0.0.1/L,L",
        "host.example/L,R", "127.0.0.1/LongerThanTwentyLetters,R", "127.0.0.1/a,b,c"})
    QVERIFY_THROWS_EXCEPTION(InputError, parse_pictures(text));
  for (const char* text : {"", "127.0.0.1", "127.0.0.1/", "127.0.0.1/a/b"})
    QVERIFY_THROWS_EXCEPTION(InputError, parse_tool(text));
  ReceiverOptions nowhere = parse_tool("127.0.0.1:0/Tip");
  QVERIFY_THROWS_EXCEPTION(InputError, Receiver{nowhere});
}

QTEST_GUILESS_MAIN(ReceiverTest)
#include "receiver_test.moc"
