// SPDX-License-Identifier: GPL-3.0-or-later
// Lines whose distance is known: circles of different radii, lines shifted aside.
#include "outline_distance.h"

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::experiments;

namespace {

constexpr int kWidth = 200, kHeight = 160;

template <class Light>
Picture picture(const Light& light) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u)
      for (int c = 0; c < 3; ++c) bytes->push_back(static_cast<std::uint8_t>(light(u, v)));
  return {kWidth, kHeight, 3, bytes};
}

template <class Organ>
std::vector<float> depth(const Organ& organ) {
  std::vector<float> values;
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) values.push_back(organ(u, v) ? 0.12F : 0.0F);
  return values;
}

double from_middle(int u, int v) { return std::hypot(u - 100.0, v - 80.0); }

}  // namespace

class OutlineDistanceTest : public QObject {
  Q_OBJECT
 private slots:
  void ALineOnTheEdgeIsNotOff() {
    const auto found = outline_distance(
        picture([](int u, int v) { return std::abs(from_middle(u, v) - 49.5) < 0.7 ? 117 : 0; }),
        depth([](int u, int v) { return from_middle(u, v) < 50.0; }));
    QVERIFY(found.has_value());
    QVERIFY2(found->mean < 0.4 && found->percentile_95 <= 1.0, qPrintable(QString::number(found->mean)));
  }

  void AWiderCircleIsOffByItsRadius() {
    const auto found = outline_distance(
        picture([](int u, int v) { return std::abs(from_middle(u, v) - 59.5) < 0.7 ? 117 : 0; }),
        depth([](int u, int v) { return from_middle(u, v) < 50.0; }));
    QVERIFY(found.has_value());
    QVERIFY2(std::abs(found->mean - 10.0) < 0.4, qPrintable(QString::number(found->mean)));
    QVERIFY(std::abs(found->percentile_95 - 10.0) < 1.1);
  }

  void WhatIsMissingCountsAsWhatIsTooMuch() {
    // Half of the circle is not drawn: from there it is far to the line.
    const auto organ = depth([](int u, int v) { return from_middle(u, v) < 50.0; });
    const auto half = outline_distance(
        picture([](int u, int v) { return u < 100 && std::abs(from_middle(u, v) - 49.5) < 0.7 ? 117 : 0; }),
        organ);
    QVERIFY(half.has_value());
    QVERIFY2(half->mean > 5.0 && half->percentile_95 > 20.0, qPrintable(QString::number(half->mean)));
  }

  void ThePicturesBorderIsNoEdge() {
    // The organ fills the left half; its drawn line runs 4 pixels beside the edge and along the border.
    const auto found = outline_distance(
        picture([](int u, int v) { return u == 103 || ((v == 0 || v == kHeight - 1) && u < 103) ? 117 : 0; }),
        depth([](int u, int) { return u < 100; }));
    QVERIFY(found.has_value());
    QVERIFY2(std::abs(found->mean - 4.0) < 1e-3, qPrintable(QString::number(found->mean)));
    QVERIFY(!outline_distance(picture([](int u, int v) { return u == 0 || v == 0 ? 117 : 0; }),
                              depth([](int u, int) { return u < 100; })));
    QVERIFY(!outline_distance(picture([](int u, int) { return u == 100 ? 117 : 0; }),
                              depth([](int, int) { return true; })));
  }

  void ALineBesideTheTrueOneIsOffByItsDistance() {
    const std::vector<Eigen::Vector2d> truth = {{20.0, 50.0}, {180.0, 50.0}};
    const auto shifted = line_distance({{20.0, 57.0}, {100.0, 57.0}, {180.0, 57.0}}, truth, kWidth, kHeight);
    QVERIFY(shifted && std::abs(shifted->mean - 7.0) < 1e-9 && std::abs(shifted->percentile_95 - 7.0) < 1e-9);
    // Half of it is missing: that counts, too.
    const auto half = line_distance({{20.0, 50.0}, {100.0, 50.0}}, truth, kWidth, kHeight);
    QVERIFY2(half && half->mean > 10.0 && half->percentile_95 > 60.0,
             qPrintable(QString::number(half->mean)));
  }

  void BeyondThePictureALineDoesNotCount() {
    // The true one ends at the border, the drawn one goes on far beyond it.
    const auto found =
        line_distance({{20.0, 50.0}, {900.0, 50.0}}, {{20.0, 50.0}, {199.0, 50.0}}, kWidth, kHeight);
    QVERIFY(found && found->mean < 1e-9);
    // Drawn where nobody sees it, and to be seen: as wrong as can be.
    const auto lost = line_distance({{500.0, 50.0}, {600.0, 50.0}}, {{20.0, 50.0}}, kWidth, kHeight);
    QVERIFY(lost && lost->mean == std::hypot(kWidth, kHeight));
    QVERIFY(line_distance({}, {{20.0, 50.0}}, kWidth, kHeight)->mean > 100.0);
    QVERIFY(!line_distance({{20.0, 50.0}}, {{500.0, 50.0}, {600.0, 50.0}}, kWidth, kHeight));
  }

  void FramesAreSummedUp() {
    OutlineTally tally;
    QVERIFY(tally.figures().empty());
    tally.add({2.0, 5.0});
    tally.add({4.0, 9.0});
    const Figures figures = tally.figures();
    QCOMPARE(figures.at("outline_frames"), 2.0);
    QCOMPARE(figures.at("outline_mean_px"), 3.0);
    QCOMPARE(figures.at("outline_p95_px"), 7.0);
    QCOMPARE(figures.at("outline_worst_mean_px"), 4.0);
    QCOMPARE(tally.figures("margin").at("margin_p95_px"), 7.0);
  }

  void AnotherSizeIsRefused() {
    QVERIFY_THROWS_EXCEPTION(
        InputError, outline_distance(picture([](int, int) { return 0; }), std::vector<float>(17, 0.0F)));
  }
};

QTEST_APPLESS_MAIN(OutlineDistanceTest)
#include "outline_distance_test.moc"
