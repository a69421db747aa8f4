// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of packaging/figures that proofs have written: a page that names other aims, or other bounds,
// than the program does was written by another program, and its verdicts are another's: then it says so.
#include <QFile>
#include <QTest>

#include "glisson/experiments/proofs.h"

using namespace glisson;
using namespace glisson::experiments;

namespace {

/// What is wanted and how much of it, a line each, as the page has them: "Dice of the liver: >= 0.930".
QStringList aims_on_page(const QString& page) {
  QStringList aims;
  bool is_table = false;
  for (const QString& line : page.split('\n')) {
    if (line.startsWith("| what |")) is_table = true;
    if (!line.startsWith('|')) is_table = false;
    const QStringList cells = line.split('|');
    if (is_table && cells.size() == 7 && !line.startsWith("| what") && !line.startsWith("|---"))
      aims << cells[1].trimmed() + ": " + cells[4].trimmed();
  }
  return aims;
}

QStringList aims_of_program(const std::vector<Aim>& aims) {
  QStringList lines;
  for (const Aim& aim : aims)
    lines << QString::fromStdString(aim.what) + ": " +
                 (aim.sense == Aim::Sense::at_least ? QStringLiteral("≥ ") : QStringLiteral("≤ ")) +
                 QString::number(aim.bound, 'f', aim.decimals);
  return lines;
}

}  // namespace

class FigurePagesTest : public QObject {
  Q_OBJECT
 private slots:
  void EachPageHasTheAimsOfTheProgram_data() {
    QTest::addColumn<QStringList>("aims");
    for (const Proof& proof : proofs()) QTest::newRow(proof.name) << aims_of_program(proof.aims());
  }
  void EachPageHasTheAimsOfTheProgram() {
    QFETCH(QStringList, aims);
    QVERIFY(aims.size() > 3);
    QFile file(qEnvironmentVariable("GLISSON_SOURCE_DIR") + "/packaging/figures/" + QTest::currentDataTag() +
               ".md");
    QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
    const QString page = QString::fromUtf8(file.readAll());
    const QStringList found = aims_on_page(page);
    QVERIFY(found.size() > 3);
    for (const QString& aim : aims)
      QVERIFY2(found.contains(aim), qPrintable("not on the page: " + aim + ". Run the proof again"));
    QCOMPARE(found.size(), aims.size());
  }
};

QTEST_GUILESS_MAIN(FigurePagesTest)
#include "figure_pages_test.moc"
