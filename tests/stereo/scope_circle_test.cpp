// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <random>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/source.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

namespace {

constexpr int kWidth = 640, kHeight = 480;

/// What a laparoscope shows: tissue with a vessel in an ellipse, the sensor's noise around it.
struct Scene {
  ScopeCircle rim;
  double light = 90.0;    ///< grey levels above the surround
  double surround = 4.0;  ///< grey levels
  double noise = 3.0;     ///< standard deviation, grey levels
  double blur = 1.5;      ///< of the rim, pixels
  double fading = 0.0;    ///< share of the light that is gone at the left edge of the picture
  int dots = 0;           ///< reflections outside of the rim
};

template <class Brightness>
Picture drawn(int width, int height, const Brightness& brightness) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      bytes->push_back(static_cast<std::uint8_t>(std::clamp(brightness(x, y), 0.0, 255.0)));
  return {width, height, 1, std::move(bytes)};
}

/// Pixels beyond the rim: negative inside.
double beyond(const ScopeCircle& rim, double x, double y) {
  const Eigen::Vector2d d = Eigen::Vector2d(x, y) - rim.centre;
  return (std::hypot(d.x(), d.y() / rim.aspect) / rim.radius - 1.0) * rim.radius * std::min(1.0, rim.aspect);
}

Picture picture_of(const Scene& scene) {
  std::mt19937 random(3);  // NOLINT: the same noise on every run
  std::normal_distribution<double> noise(0.0, scene.noise);
  return drawn(kWidth, kHeight, [&](int x, int y) {
    const double texture = 1.0 + 0.5 * std::sin(0.03 * x) * std::cos(0.04 * y);
    const bool vessel = std::abs(x - 0.6 * y - 150.0) < 12.0;
    const double shade = 1.0 - scene.fading * std::max(0.0, 1.0 - x / (0.5 * kWidth));
    const bool dot =
        scene.dots > 0 && x % (kWidth / scene.dots) < 4 && y % 97 < 4 && beyond(scene.rim, x, y) > 6.0;
    return scene.light * (vessel ? 0.05 : texture * shade) /
               (1.0 + std::exp(beyond(scene.rim, x, y) / scene.blur)) +
           (dot ? 120.0 : 0.0) + scene.surround + noise(random);
  });
}

}  // namespace

class ScopeCircleTest : public QObject {
  Q_OBJECT

 private slots:
  void RimIsFound_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("aspect");
    QTest::addColumn<double>("light");
    QTest::addColumn<double>("surround");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("fading");
    QTest::addColumn<int>("dots");
    const auto row = [](const char* name, const Scene& s) {
      QTest::newRow(name) << s.rim.centre.x() << s.rim.centre.y() << s.rim.radius << s.rim.aspect << s.light
                          << s.surround << s.noise << s.fading << s.dots;
    };
    row("whole", {{{322, 236}, 215}});
    row("cut above and below", {{{310, 250}, 290}});
    row("cut on the right", {{{420, 240}, 230}});
    row("dim", {{{322, 236}, 215}, 20, 3, 1});
    row("dim, the surround not black", {{{322, 236}, 215}, 25, 16, 1.5});
    row("bright surround", {{{322, 236}, 215}, 120, 25, 3});
    row("much noise", {{{322, 236}, 215}, 90, 10, 8});
    row("pixels of PAL", {{{330, 240}, 200, 12.0 / 11.0}});
    row("pixels of NTSC", {{{330, 240}, 225, 10.0 / 11.0}});
    row("pixels of PAL, cut above and below, dim", {{{310, 250}, 270, 12.0 / 11.0}, 25, 9, 1});
    row("half the rows", {{{320, 240}, 300, 0.5}});
    row("half the columns", {{{320, 240}, 110, 2.0}});
    row("light fades to one side", {{{322, 236}, 215, 12.0 / 11.0}, 90, 8, 1, 1.0});
    row("reflections outside", {{{322, 236}, 215}, 60, 8, 2, 0, 7});
  }
  void RimIsFound() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, radius);
    QFETCH(double, aspect);
    QFETCH(double, light);
    QFETCH(double, surround);
    QFETCH(double, noise);
    QFETCH(double, fading);
    QFETCH(int, dots);
    Scene scene{{{x, y}, radius, aspect}, light, surround, noise};
    scene.fading = fading;
    scene.dots = dots;
    const auto found = find_scope_circle(picture_of(scene));
    QVERIFY(found.has_value());
    qInfo("centre %.1f %.1f, radius %.1f, aspect %.3f", found->centre.x(), found->centre.y(), found->radius,
          found->aspect);
    QVERIFY((found->centre - scene.rim.centre).norm() < 4.0);
    QVERIFY(std::abs(found->radius - radius) < 5.0);
    QVERIFY(std::abs(found->radius * found->aspect - radius * aspect) < 5.0);
    // Nothing outside is kept, and nothing but the rim's blur is given away.
    const Picture mask = circle_mask(*found, kWidth, kHeight);
    for (int py = 0; py < kHeight; py += 7)
      for (int px = 0; px < kWidth; px += 7) {
        const bool inside = (*mask.bytes)[static_cast<std::size_t>(py * kWidth + px)] != 0;
        if (beyond(scene.rim, px, py) < -14.0) QVERIFY(inside);
        if (beyond(scene.rim, px, py) > 3.0) QVERIFY(!inside);
      }
  }

  void NoneIsInvented() {
    const auto none = [](const auto& brightness) {
      return !find_scope_circle(drawn(kWidth, kHeight, brightness)).has_value();
    };
    std::mt19937 random(4);  // NOLINT: the same noise on every run
    std::normal_distribution<double> noise(0.0, 2.0);
    const auto centred = [](int x, int y) { return std::hypot(x - 320.0, y - 240.0); };
    QVERIFY(none([](int x, int y) { return 128.0 + 80.0 * std::sin(0.09 * x + 0.05 * y); }));  // filled
    QVERIFY(none([](int, int) { return 3.0; }));                                               // black
    QVERIFY(none([&](int, int) { return 4.0 + noise(random); }));                              // black, noise
    // Dark to the left of a straight edge, of a slanted one, and of two.
    QVERIFY(none([](int x, int) { return x < 200 ? 3.0 : 120.0; }));
    QVERIFY(none([](int x, int y) { return x + 0.5 * y < 260.0 ? 3.0 : 120.0; }));
    QVERIFY(none([](int x, int) { return x < 120 || x > 500 ? 3.0 : 120.0; }));
    // A rectangle, as of a film with black bars on all sides.
    QVERIFY(none([](int x, int y) { return x < 80 || x > 560 || y < 60 || y > 420 ? 3.0 : 120.0; }));
    // Light that fades towards the corners, without a rim; slowly and soon.
    QVERIFY(none([&](int x, int y) {
      return 4.0 + 140.0 * std::exp(-std::pow(centred(x, y) / 180.0, 2)) + noise(random);
    }));
    QVERIFY(
        none([&](int x, int y) { return 4.0 + std::max(0.0, 140.0 - 0.6 * centred(x, y)) + noise(random); }));
    // A bright organ before tissue that is darker, but lit.
    QVERIFY(none([&](int x, int y) {
      return (centred(x, y) < 180.0 ? 150.0 : 45.0 + 20.0 * std::sin(0.1 * x) * std::cos(0.13 * y)) +
             noise(random);
    }));
    // A disk before black with as much light beside it.
    QVERIFY(none([&](int x, int y) {
      return (centred(x, y) < 170.0 || (x > 520 && y > 120 && y < 420) ? 120.0 : 4.0) + noise(random);
    }));
    // The half of a disk: an arc says too little about the rest.
    QVERIFY(none([&](int x, int y) {
      return (std::hypot(x - 700.0, y - 240.0) < 480.0 ? 120.0 : 4.0) + noise(random);
    }));
  }

  void MaskIsTheEllipseLessItsMargin() {
    const ScopeCircle rim{{100.0, 60.0}, 50.0, 0.8};
    const Picture mask = circle_mask(rim, 200, 120, 5.0);
    const auto inside = [&](int x, int y) {
      return (*mask.bytes)[static_cast<std::size_t>(y * 200 + x)] != 0;
    };
    QVERIFY(inside(145, 60) && !inside(146, 60) && inside(55, 60) && !inside(54, 60));
    QVERIFY(inside(100, 95) && !inside(100, 96) && inside(100, 25) && !inside(100, 24));
    double area = 0.0;
    for (const std::uint8_t value : *mask.bytes) area += value != 0 ? 1.0 : 0.0;
    QVERIFY(std::abs(area / (M_PI * 45.0 * 35.0) - 1.0) < 0.01);
    const Picture none = circle_mask(rim, 200, 120, 41.0);
    for (const std::uint8_t value : *none.bytes) QCOMPARE(int{value}, 0);
    QVERIFY_THROWS_EXCEPTION(PreconditionError, circle_mask({{5, 5}, 0.0}, 10, 10));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, circle_mask({{5, 5}, 3.0, 0.0}, 10, 10));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, circle_mask(rim, 0, 10));
  }

  void RealPicturesWithACircleShowIt() {
    const fs::path folder = glisson::test::data_folder() / "stereo_opencas";
    if (!fs::exists(folder)) QSKIP("the real pairs are not here (see GLISSON_DATA)");
    // Measured by eye, with a ruler on the pictures (brightened three times): the rim's four ends.
    const auto left = find_scope_circle(read_picture(folder / "Stereo_SD_d_complete_22_IMG_left.bmp"));
    QVERIFY(left.has_value());
    QVERIFY(std::abs(left->centre.x() + left->radius - 636.0) < 6.0);
    QVERIFY(std::abs(left->centre.x() - left->radius - 103.0) < 8.0);
    QVERIFY(std::abs(left->centre.y() - left->radius * left->aspect - 7.0) < 6.0);
    QVERIFY(left->aspect > 1.05 && left->aspect < 1.1);  // PAL's pixels are not square
    // Its left side fades without a rim.
    const auto right = find_scope_circle(read_picture(folder / "Stereo_SD_d_complete_22_IMG_right.bmp"));
    QVERIFY(right.has_value());
    QVERIFY(std::abs(right->centre.x() + right->radius - 619.0) < 6.0);
    QVERIFY(std::abs(right->centre.y() - right->radius * right->aspect - 10.0) < 6.0);
  }

  void RealPicturesWithoutACircleShowNone() {
    const fs::path heart = glisson::test::data_folder() / "stereo_heart",
                   boards = glisson::test::data_folder() / "stereo_chessboard";
    if (!fs::exists(heart) || !fs::exists(boards)) QSKIP("the real pairs are not here (see GLISSON_DATA)");
    for (const char side : {'L', 'R'})
      QVERIFY(
          !find_scope_circle(read_picture(heart / (std::string("f7_dynamic_deint_") + side + "_0100.png"))));
    int pictures = 0;
    for (const auto& file : fs::directory_iterator(boards)) {
      if (file.path().extension() != ".png") continue;
      QVERIFY2(!find_scope_circle(read_picture(file.path())), file.path().c_str());
      ++pictures;
    }
    QCOMPARE(pictures, 18);
  }
};

QTEST_APPLESS_MAIN(ScopeCircleTest)
#include "scope_circle_test.moc"
