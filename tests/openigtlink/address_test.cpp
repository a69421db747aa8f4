// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/openigtlink/address.h"

#include <QTest>

#include "glisson/core/error.h"

using namespace glisson;
using openigtlink::parse_address;

class AddressTest : public QObject {
  Q_OBJECT
 private slots:
  void WithoutWordsItIsThisComputer();
  void PartsMayBeLeftOut();
  void ItIsWrittenAsItIsRead();
  void NonsenseIsRefused_data();
  void NonsenseIsRefused();
  void OnlyThisComputerIsLocal();
};

void AddressTest::WithoutWordsItIsThisComputer() {
  QCOMPARE(QString::fromStdString(parse_address("").text()), QString("127.0.0.1:18944"));
  QVERIFY(parse_address("").is_local());
}

void AddressTest::PartsMayBeLeftOut() {
  QCOMPARE(QString::fromStdString(parse_address("18945").text()), QString("127.0.0.1:18945"));
  QCOMPARE(QString::fromStdString(parse_address(":18945").text()), QString("127.0.0.1:18945"));
  QCOMPARE(QString::fromStdString(parse_address("localhost:7").text()), QString("127.0.0.1:7"));
  QCOMPARE(QString::fromStdString(parse_address("192.168.1.20").text()), QString("192.168.1.20:18944"));
  QCOMPARE(QString::fromStdString(parse_address("::1").text()), QString("[::1]:18944"));
}

void AddressTest::ItIsWrittenAsItIsRead() {
  for (const char* text : {"0.0.0.0:0", "192.168.1.20:65535", "[fe80::1]:18944"})
    QCOMPARE(QString::fromStdString(parse_address(text).text()), QString(text));
}

void AddressTest::NonsenseIsRefused_data() {
  QTest::addColumn<QString>("text");
  for (const char* text : {"plus.example.org:18944", "127.0.0.1:", "127.0.0.1:65536", "127.0.0.1:-1",
                           "127.0.0.1:1x", "99999", "1.2.3:4", "[::1", "[::1]x", "300.1.1.1:5", " 127.0.0.1"})
    QTest::newRow(text) << QString(text);
}

void AddressTest::NonsenseIsRefused() {
  QFETCH(QString, text);
  QVERIFY_THROWS_EXCEPTION(InputError, parse_address(text.toStdString()));
}

void AddressTest::OnlyThisComputerIsLocal() {
  QVERIFY(parse_address("127.1.2.3").is_local() && parse_address("[::1]:1").is_local());
  QVERIFY(!parse_address("0.0.0.0:18944").is_local() && !parse_address("192.168.1.20").is_local());
}

QTEST_APPLESS_MAIN(AddressTest)
#include "address_test.moc"
