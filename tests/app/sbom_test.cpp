// SPDX-License-Identifier: GPL-3.0-or-later
// The list of what a package ships (packaging/sbom): what SPDX 2.3 asks for, and that it tells what is
// loaded.
#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>

namespace {

struct Ran {
  int code = -1;
  QByteArray out, error;
};

Ran run(const QString& program, const QStringList& words) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("SOURCE_DATE_EPOCH", "1700000000");
  environment.insert("LC_ALL", "C.UTF-8");
  process.setProcessEnvironment(environment);
  process.start(program, words);
  process.waitForFinished(-1);
  return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

Ran sbom(const QStringList& words) {
  return run("python3", QStringList(qEnvironmentVariable("GLISSON_SOURCE_DIR") + "/packaging/sbom") + words);
}

/// Debian's packages of the libraries that the loader takes, asked of dpkg alone.
QSet<QString> packages_of(const QString& library) {
  const QString found = QString::fromUtf8(run("dpkg-query", {"--search", "*/" + library}).out);
  QSet<QString> names;
  for (const QString& line : found.split('\n', Qt::SkipEmptyParts)) names << line.section(':', 0, 0);
  return names;
}

}  // namespace

class SbomTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    for (const char* tool : {"python3", "dpkg-query", "ldd"})
      if (QStandardPaths::findExecutable(tool).isEmpty())
        QSKIP(qPrintable(QString("there is no %1 here").arg(tool)));
    const Ran ran = sbom({GLISSON_READER});
    QVERIFY2(ran.code == 0, ran.error.constData());
    text_ = ran.out;
    document_ = QJsonDocument::fromJson(text_).object();
  }

  void ItIsAnSpdxDocument() {
    QCOMPARE(document_["spdxVersion"].toString(), QString("SPDX-2.3"));
    QCOMPARE(document_["dataLicense"].toString(), QString("CC0-1.0"));
    QCOMPARE(document_["SPDXID"].toString(), QString("SPDXRef-DOCUMENT"));
    QVERIFY(!document_["name"].toString().isEmpty());
    QVERIFY(document_["documentNamespace"].toString().startsWith("https://"));
    const QJsonObject made = document_["creationInfo"].toObject();
    QCOMPARE(made["created"].toString(), QString("2023-11-14T22:13:20Z"));
    QVERIFY(!made["creators"].toArray().isEmpty());
  }

  void EachEntryIsNamedOnceAndRelatedToGlisson() {
    const QRegularExpression name("^SPDXRef-[A-Za-z0-9.-]+$");
    QSet<QString> ids{"SPDXRef-DOCUMENT"};
    for (const char* list : {"packages", "files"})
      for (const QJsonValue& one : document_[list].toArray()) {
        const QString id = one.toObject()["SPDXID"].toString();
        QVERIFY2(name.match(id).hasMatch() && !ids.contains(id), qPrintable(id));
        ids << id;
      }
    QSet<QString> related{"SPDXRef-DOCUMENT"};
    for (const QJsonValue& one : document_["relationships"].toArray()) {
      const QJsonObject relation = one.toObject();
      QVERIFY(ids.contains(relation["spdxElementId"].toString()));
      QVERIFY(ids.contains(relation["relatedSpdxElement"].toString()));
      related << relation["relatedSpdxElement"].toString();
    }
    QCOMPARE(related, ids);
    for (const QJsonValue& one : document_["packages"].toArray())
      for (const char* field : {"name", "versionInfo", "downloadLocation", "licenseDeclared"})
        QVERIFY2(!one.toObject()[field].toString().isEmpty(), field);
  }

  void TheProgramIsTheOneThatIsShipped() {
    const QJsonArray files = document_["files"].toArray();
    QCOMPARE(files.size(), 1);
    QFile program(GLISSON_READER);
    QVERIFY(program.open(QIODevice::ReadOnly));
    const QByteArray bytes = program.readAll();
    for (const QJsonValue& one : files.first().toObject()["checksums"].toArray()) {
      const QJsonObject sum = one.toObject();
      const auto kind =
          sum["algorithm"].toString() == "SHA1" ? QCryptographicHash::Sha1 : QCryptographicHash::Sha256;
      QCOMPARE(sum["checksumValue"].toString(),
               QString::fromLatin1(QCryptographicHash::hash(bytes, kind).toHex()));
    }
  }

  void WhatItLoadsIsListed() {
    QSet<QString> listed;
    for (const QJsonValue& one : document_["packages"].toArray()) listed << one.toObject()["name"].toString();
    const QString loaded = QString::fromUtf8(run("ldd", {GLISSON_READER}).out);
    int asked = 0;
    for (const char* part : {"libc.so.6", "libstdc++.so.6", "libITKCommon-5.3.so.1"}) {
      if (!loaded.contains(part)) continue;
      ++asked;
      QVERIFY2(listed.intersects(packages_of(part)), part);
    }
    QVERIFY(asked >= 2);
  }

  void TheSameBuildGivesTheSameBytes() { QCOMPARE(sbom({GLISSON_READER}).out, text_); }

  void WhatIsNoProgramIsRefused() {
    QVERIFY(sbom({}).code != 0);
    const Ran ran = sbom({"/nowhere/glisson"});
    QVERIFY(ran.code != 0 && ran.out.isEmpty() && ran.error.contains("PROGRAM"));
  }

 private:
  QByteArray text_;
  QJsonObject document_;
};

QTEST_GUILESS_MAIN(SbomTest)
#include "sbom_test.moc"
