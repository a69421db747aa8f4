// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is written over without a question about the very name that is written.
#include "glisson/ui/common/save_name.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

using namespace glisson::ui;

class SaveNameTest : public QObject {
  Q_OBJECT
 private slots:
  void ANameGetsItsEndingOnce();
  void WhatIsNotThereNeedsNoQuestion();
  void WhatIsThereGoesOnlyWhenSaid();
  void SeveralFilesAreAskedAboutAtOnce();

 private:
  /// Answers the question with this button as soon as it stands. @return what it says.
  template <class Paths>
  static QString answer(const Paths& path, const QString& button, bool* allowed) {
    QString said;
    const QObject here;  // where no question stands, the answer goes with it
    QTimer::singleShot(0, &here, [&] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      said = box->text();
      for (QAbstractButton* one : box->buttons())
        if (one->text().remove(QLatin1Char('&')) == button) one->click();
    });
    *allowed = may_be_replaced(nullptr, path);
    return said;
  }
};

void SaveNameTest::ANameGetsItsEndingOnce() {
  const QStringList yaml{QStringLiteral(".yaml"), QStringLiteral(".yml")};
  QCOMPARE(with_ending(QStringLiteral("/a/scope"), yaml), QStringLiteral("/a/scope.yaml"));
  QCOMPARE(with_ending(QStringLiteral("/a/scope.yml"), yaml), QStringLiteral("/a/scope.yml"));
  QCOMPARE(with_ending(QStringLiteral("/a/SCOPE.YAML"), yaml), QStringLiteral("/a/SCOPE.YAML"));
  QCOMPARE(with_ending(QStringLiteral("/a.b/scope"), yaml), QStringLiteral("/a.b/scope.yaml"));
}

void SaveNameTest::WhatIsNotThereNeedsNoQuestion() {
  const QTemporaryDir folder;
  bool allowed = false;
  QCOMPARE(answer(folder.filePath(QStringLiteral("new.glisson")), QStringLiteral("Cancel"), &allowed),
           QString());
  QVERIFY(allowed);
}

void SaveNameTest::WhatIsThereGoesOnlyWhenSaid() {
  const QTemporaryDir folder;
  QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("patient.glisson")));
  const QString path = folder.filePath(QStringLiteral("patient.glisson"));
  bool allowed = true;
  const QString said = answer(path, QStringLiteral("Cancel"), &allowed);
  QVERIFY2(said.contains(QStringLiteral("patient.glisson")), qPrintable(said));
  QVERIFY(!allowed);
  answer(path, QStringLiteral("Replace"), &allowed);
  QVERIFY(allowed);
}

void SaveNameTest::SeveralFilesAreAskedAboutAtOnce() {
  bool allowed = true;
  QVERIFY(may_be_replaced(nullptr, QStringList()));
  const QStringList there{QStringLiteral("/out/liver.stl"), QStringLiteral("/out/lesion_1.stl")};
  const QString said = answer(there, QStringLiteral("Cancel"), &allowed);
  QVERIFY2(said.contains(QStringLiteral("/out")) && said.contains(QStringLiteral("liver.stl, lesion_1.stl")),
           qPrintable(said));
  QVERIFY(!allowed);
  answer(there, QStringLiteral("Replace"), &allowed);
  QVERIFY(allowed);
}

QTEST_MAIN(SaveNameTest)
#include "save_name_test.moc"
