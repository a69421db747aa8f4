// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's figures on the command line: what is written, and what is refused.
#include <QImage>
#include <QJsonObject>
#include <QTest>

#include "glisson/geometry/mesh_io.h"
#include "program.h"

using namespace glisson;
using test::Ran;

class FigureCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void figureSixIsWrittenWhole() {
    const Ran ran = run({"figure", "6", "--quick", "--flank", "right", "--out", "f", "--json", "f.json"});
    QVERIFY2(ran.code == 0, qPrintable(ran.error));
    QVERIFY2(ran.out.contains("stiffness of cava"), qPrintable(ran.out));
    const QJsonObject found = figures("f.json");
    QCOMPARE(found["figure6_both_shift_0mm_mm"].toDouble(-1.0), 0.0);
    QVERIFY(found["figure6_both_shift_15mm_mm"].toDouble() > found["figure6_both_shift_3mm_mm"].toDouble());
    QVERIFY(found.contains("figure6_notch_exponent"));
    const std::string page = read_file(at("f/figure_6.md"));
    QVERIFY(page.find("glisson figure 6 --flank right --quick --seed 1") != std::string::npos);
    QVERIFY(page.find("below 1 (shift below 3)") != std::string::npos);
    QVERIFY(read_file(at("f/figure_6.csv")).starts_with("altered,by,"));
    const QImage plot(text_of("f/figure_6.png"));
    QVERIFY(plot.width() > 1000);
    int coloured = 0;
    for (int y = 0; y < plot.height(); ++y)
      for (int x = 0; x < plot.width(); ++x) coloured += plot.pixelColor(x, y).saturation() > 128 ? 1 : 0;
    QVERIFY2(coloured > 5000, qPrintable(QString::number(coloured)));
  }

  void whatIsStoppedLeavesNothing() {
    const int before = files();
    for (const char* number : {"5", "6"}) {
      const Ran ran = interrupted({"figure", number, "--quick", "--out", "f"});
      QVERIFY2(ran.code == 130, qPrintable(ran.error));
      QCOMPARE(files(), before);
    }
  }

  void whatCannotBeIsRefused() {
    refused({"figure", "7", "--out", "f"}, "7", 2);
    refused({"figure", "--out", "f"}, "figure", 2);
    refused({"figure", "6", "--flank", "top", "--out", "f"}, "--flank", 2);
    refused({"figure", "6", "--case", "none.glisson", "--out", "f"}, "none.glisson");
    // A case without landmarks is told by its name.
    write_triangle_mesh(at("liver.ply"), boundary_surface(test::ball()).mesh, LengthUnit::millimetre);
    const Ran built = run({"model", "--surfaces", "liver.ply", "--vertices", "200", "--case", "a.glisson"});
    QVERIFY2(built.code == 0, qPrintable(built.error));
    refused({"figure", "6", "--case", "a.glisson", "--out", "f"}, "a.glisson: umbilical notch");
  }
};

QTEST_GUILESS_MAIN(FigureCommandsTest)
#include "figure_commands_test.moc"
