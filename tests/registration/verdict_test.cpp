// SPDX-License-Identifier: GPL-3.0-or-later
// What findings amount to: nothing, doubts, refusal.
#include "verdict.h"

#include <QTest>
#include <limits>
#include <string>
#include <vector>

using namespace glisson::registration;

namespace {

/// Of a registration that nothing speaks against.
Findings sound() {
  Findings findings;
  findings.roughness = 1e-3;
  findings.expected = 4e-3;
  findings.strangeness = 0.9;
  findings.decided = 20.0;
  findings.mirror_odds = 60.0;
  findings.size = 0.02;
  findings.size_sigma = 0.02;
  return findings;
}

}  // namespace

class VerdictTest : public QObject {
  Q_OBJECT
 private slots:
  void ASoundOneIsLeftAlone() {
    const Verdict verdict = judge(sound());
    QVERIFY(verdict.doubts.empty() && !verdict.refused);
    // What was not asked does not speak.
    Findings silent;
    QVERIFY(judge(silent).doubts.empty());
  }

  void AnExpectedErrorThatIsNoNumberIsADoubt() {
    Findings findings = sound();
    findings.expected = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(judge(findings).doubts, std::vector<std::string>{"expected_error_large inf 6"});
  }

  void ALesionMayBeLessKnownThanTheOrgan() {
    Findings findings = sound();
    findings.lesions = {{"lesion_1", 5e-3}, {"lesion_2", 9.5e-3}};
    QCOMPARE(judge(findings).doubts, std::vector<std::string>{"lesion_2.error_large 9.5 6"});
    QVERIFY(!judge(findings).refused);
    findings.lesions.back().expected = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(judge(findings).doubts, std::vector<std::string>{"lesion_2.error_large inf 6"});
    // Where the whole organ is told, its lesions are not told once more.
    findings.expected = 9e-3;
    QCOMPARE(judge(findings).doubts, std::vector<std::string>{"expected_error_large 9 6"});
  }

  void EachFindingHasItsDoubt_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<int>("finding");
    QTest::addColumn<double>("value");
    QTest::addColumn<bool>("refused");
    QTest::newRow("noisy") << "cloud_noisy 4.5 3.6" << 0 << 4.5e-3 << false;
    QTest::newRow("noise") << "cloud_noisy 12 6" << 0 << 12e-3 << true;
    QTest::newRow("far off") << "expected_error_large 9 6" << 1 << 9e-3 << false;
    QTest::newRow("hardly known") << "expected_error_large 80 6" << 1 << 80e-3 << false;
    QTest::newRow("symmetric") << "mirror_fits 5 10" << 2 << 5.0 << false;
    QTest::newRow("mirrored") << "mirror_fits -40 0" << 2 << -40.0 << true;
    QTest::newRow("turned") << "points_turned 30 15" << 3 << 0.3 << false;
    QTest::newRow("margin") << "margin_off 12 8" << 4 << 12e-3 << false;
    QTest::newRow("perhaps elsewhere") << "elsewhere_probable 3 1" << 6 << 0.03 << false;
    QTest::newRow("elsewhere") << "elsewhere_probable 30 5" << 6 << 0.3 << true;
    QTest::newRow("perhaps moved") << "looks_differ 3 1" << 7 << 0.03 << false;
    QTest::newRow("moved between looks") << "looks_differ 90 5" << 7 << 0.9 << true;
    QTest::newRow("larger") << "size_differs 6 4.8" << 8 << 0.06 << false;
    QTest::newRow("smaller") << "size_differs 6 4.8" << 8 << -0.06 << false;
    QTest::newRow("of another size") << "size_differs 12 8.25" << 8 << 0.12 << true;
    QTest::newRow("strange") << "shape_strange 1.8 1.57" << 5 << 1.8 << false;
  }
  void EachFindingHasItsDoubt() {
    QFETCH(QString, code);
    QFETCH(int, finding);
    QFETCH(double, value);
    QFETCH(bool, refused);
    Findings findings = sound();
    double* const places[] = {&findings.roughness, &findings.expected,     &findings.mirror_odds,
                              &findings.turned,    &findings.margin_off,   &findings.strangeness,
                              &findings.elsewhere, &findings.looks_differ, &findings.size};
    *places[finding] = value;
    const Verdict verdict = judge(findings);
    QCOMPARE(verdict.doubts.size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(verdict.doubts.front()), code);
    QCOMPARE(verdict.refused, refused);
  }

  void StrangestIsTheTablesChiSquare() {
    // 95 % points of chi-square, printed tables.
    const std::pair<int, double> table[] = {
        {5, 11.070}, {10, 18.307}, {20, 31.410}, {30, 43.773}, {50, 67.505}};
    for (const auto& [freedom, point] : table)
      QVERIFY(std::abs(strangest(freedom) * freedom - point) < 0.005 * point);
  }
};

QTEST_APPLESS_MAIN(VerdictTest)
#include "verdict_test.moc"
