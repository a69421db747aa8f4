// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/density.h"

#include <QTest>
#include <numbers>

#include "glisson/core/error.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

constexpr double kDepth = 0.1;

Camera camera() {
  Camera result;
  result.width = 640;
  result.height = 480;
  result.matrix << 700, 0, 320, 0, 700, 240, 0, 0, 1;
  return result;
}

/// A grid of points on the plane z = 0.1 m, spacing in metres, where `keep` says so; it is tilted about y.
LabelledCloud grid(double spacing, const std::function<bool(const Eigen::Vector2d& pixel)>& keep,
                   double tilt = 0.0) {
  std::vector<Eigen::RowVector3d> points;
  for (double u = -0.06; u <= 0.06; u += spacing)
    for (double v = -0.06; v <= 0.06; v += spacing) {
      const Eigen::Vector3d p(u * std::cos(tilt), v, kDepth + u * std::sin(tilt));
      const Eigen::Vector2d pixel = camera().project(p);
      if (camera().sees(pixel) && keep(pixel)) points.push_back(p.transpose());
    }
  LabelledCloud cloud;
  cloud.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  cloud.normals.resize(cloud.points.rows(), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.points.row(static_cast<Eigen::Index>(i)) = points[i];
    cloud.normals.row(static_cast<Eigen::Index>(i)) << std::sin(tilt), 0.0, -std::cos(tilt);
  }
  return cloud;
}

bool everywhere(const Eigen::Vector2d&) { return true; }

}  // namespace

class DensityTest : public QObject {
  Q_OBJECT

 private slots:
  void DensityIsThatOfTheGrid_data() {
    QTest::addColumn<double>("tilt");
    QTest::newRow("facing") << 0.0;
    QTest::newRow("slanted") << 0.6;
  }
  void DensityIsThatOfTheGrid() {
    QFETCH(double, tilt);
    const double spacing = 2.5e-3;  // 16 points per cm2 of the surface
    const DensityMap map = density_map(grid(spacing, everywhere, tilt), camera(), {}, {});
    double sum = 0.0;
    int count = 0;
    for (int row = 15; row < 45; ++row)
      for (int column = 25; column < 55; ++column) sum += map.at(column, row), ++count;
    QVERIFY2(std::abs(sum / count / 16.0 - 1.0) < 0.12, QByteArray::number(sum / count).constData());
    QVERIFY(map.covered > (tilt > 0.0 ? 0.8 : 0.99));
    if (tilt > 0.0) return;
    const double area = 1e4 * 640.0 * 480.0 * std::pow(kDepth / 700.0, 2.0);
    QVERIFY(std::abs(map.area_cm2 / area - 1.0) < 0.01);
    const Figures figures = density_figures(map);
    QCOMPARE(figures.size(), std::size_t{1});
    QVERIFY(std::abs(figures.at("cloud_area_cm2") / area - 1.0) < 0.01);
  }

  void HolesAreWhereNoPointsAre() {
    const auto outside_hole = [](const Eigen::Vector2d& p) {
      return (p - Eigen::Vector2d(320, 240)).norm() > 120.0;
    };
    const DensityMap map = density_map(grid(2.5e-3, outside_hole), camera(), {}, {});
    QCOMPARE(map.at(40, 30), 0.0F);
    QVERIFY(map.at(5, 30) > 10.0F);
    // The disk of 1 cm2 (39 pixels' radius) still meets points just inside the hole's edge.
    const double hole = std::numbers::pi * std::pow(120.0 - 39.0, 2.0) / (640.0 * 480.0);
    QVERIFY2(std::abs(1.0 - map.covered - hole) < 0.025, QByteArray::number(map.covered).constData());
    const Picture grey{640, 480, 1, std::make_shared<std::vector<std::uint8_t>>(640 * 480, 128)};
    const Picture picture = density_picture(map, grey);
    const auto pixel = [&](int x, int y) {
      return &(*picture.bytes)[static_cast<std::size_t>((y * 640 + x) * 3)];
    };
    QVERIFY(pixel(320, 240)[2] > pixel(320, 240)[0] + 40);  // orange
    QVERIFY(pixel(40, 240)[0] > pixel(40, 240)[2] + 40);    // blue
  }

  void OnlyWhatIsWantedCounts() {
    Regions regions;
    regions.regions = {{Feature::surface, {{100, 100}, {300, 100}, {300, 300}, {100, 300}}}};
    const auto in_region = [&](const Eigen::Vector2d& p) { return feature_at(regions, p).has_value(); };
    const LabelledCloud cloud = grid(2.5e-3, in_region);
    const DensityMap map = density_map(cloud, camera(), {}, regions);
    QVERIFY(map.at(60, 10) < 0.0F);
    QVERIFY(map.covered > 0.99);
    const double area = 1e4 * 200.0 * 200.0 * std::pow(kDepth / 700.0, 2.0);
    QVERIFY(std::abs(map.area_cm2 / area - 1.0) < 0.05);
    QVERIFY(density_map(cloud, camera(), {}, {}).covered < 0.3);
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(640 * 480, 0);
    for (int y = 100; y < 300; ++y) std::fill_n(bytes->begin() + y * 640 + 100, 200, 255);
    QVERIFY(std::abs(density_map(cloud, camera(), {640, 480, 1, bytes}, {}).area_cm2 - map.area_cm2) < 0.1);
  }

  void NoPointsCoverNothing() {
    LabelledCloud none;
    none.points.resize(0, 3);
    none.normals.resize(0, 3);
    QCOMPARE(density_map(none, camera(), {}, {}).covered, 0.0);
    LabelledCloud bare = grid(5e-3, everywhere);
    bare.normals.resize(0, 3);
    QVERIFY_THROWS_EXCEPTION(PreconditionError, density_map(bare, camera(), {}, {}));
    DensityOptions options;
    options.cell = 1;
    QVERIFY_THROWS_EXCEPTION(PreconditionError, density_map(none, camera(), {}, {}, options));
    options = {};
    options.least_per_cm2 = 0.0;
    QVERIFY_THROWS_EXCEPTION(PreconditionError, density_map(none, camera(), {}, {}, options));
    const Picture small{2, 2, 1, std::make_shared<std::vector<std::uint8_t>>(4, 255)};
    QVERIFY_THROWS_EXCEPTION(PreconditionError, density_map(none, camera(), small, {}));
  }
};

QTEST_APPLESS_MAIN(DensityTest)
#include "density_test.moc"
