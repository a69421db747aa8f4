// SPDX-License-Identifier: GPL-3.0-or-later
// Epipolar lines and labels of a rendered pair whose depth is known.
#include "glisson/stereo/labelling.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/stereo/epipolar.h"
#include "rendered_pair.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

/// A grid of points on the plane z = 0.1, facing the camera.
LabelledCloud plane_of_points(double spacing) {
  LabelledCloud cloud;
  std::vector<Eigen::Vector3d> points;
  for (double y = -0.02; y <= 0.02 + 1e-9; y += spacing)
    for (double x = -0.02; x <= 0.02 + 1e-9; x += spacing) points.emplace_back(x, y, 0.1);
  cloud.points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    cloud.points.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  cloud.normals = Points::Zero(cloud.points.rows(), 3);
  cloud.normals.col(2).setConstant(-1.0);
  cloud.sigma.assign(points.size(), 1e-4);
  return cloud;
}

double distance_to(const EpipolarLine& line, const Eigen::Vector2d& pixel) {
  Region curve;
  curve.polygon = line.pixels;
  curve.closed = false;
  return closest_on_outline(curve, pixel).distance_px;
}

}  // namespace

class LabellingTest : public QObject {
  Q_OBJECT

  StereoRig rig_ = rendered::rig();

 private slots:
  void EpipolarLinePassesThroughEveryPointOfTheRay() {
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(320, 240), Eigen::Vector2d(110, 400), Eigen::Vector2d(560, 70)})
      for (const double depth : {0.05, 0.09, 0.2}) {
        const Eigen::Vector3d p = depth * rig_.left.ray(pixel);
        const Eigen::Vector3d q = (rig_.right_from_left * Point<CameraFrame>(p)).xyz;
        const Eigen::Vector2d right = rig_.right.project(q);
        if (!rig_.right.sees(right)) continue;
        QVERIFY(distance_to(epipolar_line(rig_, Side::left, pixel), right) < 0.05);
        QVERIFY(distance_to(epipolar_line(rig_, Side::right, right), pixel) < 0.05);
      }
  }

  void EpipolarLineOfADistortedPairIsNoStraightOne() {
    const EpipolarLine line = epipolar_line(rig_, Side::left, {320, 40}, 0.012, 1.0);
    QVERIFY(line.pixels.size() > 20);
    const Eigen::Vector2d a = line.pixels.front(), b = line.pixels.back();
    const Eigen::Vector2d n = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
    double bend = 0.0;
    for (const auto& p : line.pixels) bend = std::max(bend, std::abs(n.dot(p - a)));
    QVERIFY(bend > 0.5);
    QVERIFY(std::is_sorted(line.depths.begin(), line.depths.end()));
    for (const auto& p : line.pixels) QVERIFY(rig_.right.sees(p));
  }

  /// Beyond where a lens turns back its pixels show nothing, and none of the other's is shown there.
  void BeyondTheFoldThereIsNoEpipolarLine() {
    StereoRig rig = rig_;
    rig.left.distortion << -2.4, 0.0, 0.0, 0.0, 0.0;
    const Eigen::Vector2d middle(rig.left.matrix(0, 2), rig.left.matrix(1, 2));
    const Eigen::Vector2d out(0.275 * rig.left.matrix(0, 0), 0.0);
    QVERIFY(!epipolar_line(rig, Side::left, middle).pixels.empty());
    QVERIFY(rig.left.sees(middle + out));
    QVERIFY(epipolar_line(rig, Side::left, middle + out).pixels.empty());
    // Nearer than 0.11 m this ray is beyond what the left lens maps.
    const EpipolarLine line = epipolar_line(rig, Side::right, {540.0, 240.0});
    QVERIFY(line.depths.size() > 3 && line.depths.front() > 0.1);
    for (const Eigen::Vector2d& pixel : line.pixels) QVERIFY(rig.left.mapped_ray(pixel));
  }

  void PointsTakeTheFeatureOfTheRegionTheyAreSeenIn() {
    const LabelledCloud whole = plane_of_points(1e-3);
    Regions regions;
    regions.regions = {{Feature::surface, {{200, 150}, {440, 150}, {440, 330}, {200, 330}}},
                       {Feature::anterior_margin, {{200, 300}, {440, 300}}, false, 8.0},
                       {Feature::umbilical_notch, {{300, 280}, {360, 280}, {360, 320}, {300, 320}}}};
    const LabelledPart part = label(whole, rig_, {}, regions);
    QVERIFY(part.cloud.size() > 100 && part.cloud.size() < whole.size());
    std::map<Feature, int> counts;
    for (int i = 0; i < part.cloud.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      QVERIFY(part.cloud.points.row(i) == whole.points.row(part.kept[at]));
      const Eigen::Vector2d pixel = rig_.left.project(part.cloud.points.row(i).transpose());
      const bool notch = pixel.x() > 300 && pixel.x() < 360 && pixel.y() > 280 && pixel.y() < 320;
      // The curve's ends are round.
      const bool margin = std::hypot(pixel.x() - std::clamp(pixel.x(), 200.0, 440.0), pixel.y() - 300) <= 8;
      const Feature wanted = notch    ? Feature::umbilical_notch
                             : margin ? Feature::anterior_margin
                                      : Feature::surface;
      QVERIFY(part.cloud.feature(i) == wanted);
      ++counts[part.cloud.feature(i)];
    }
    QCOMPARE(counts.size(), std::size_t{3});
    QCOMPARE(part.cloud.sigma.size(), static_cast<std::size_t>(part.cloud.size()));
  }

  void RegionsOfTheRightPictureLabelTheSamePoints() {
    const LabelledCloud whole = plane_of_points(1e-3);
    Region left{Feature::surface, {{220, 170}, {420, 180}, {400, 310}, {230, 300}}};
    Region right = left;
    right.side = Side::right;
    right.feature = Feature::anterior_margin;
    for (Eigen::Vector2d& corner : right.polygon) {
      const Eigen::Vector3d p = 0.1 * rig_.left.ray(corner);
      corner = rig_.right.project((rig_.right_from_left * Point<CameraFrame>(p)).xyz);
    }
    const LabelledPart a = label(whole, rig_, {}, {0, {}, {left}});
    const LabelledPart b = label(whole, rig_, {}, {0, {}, {right}});
    // The outline's edges are straight in either picture, which bends them by parts of a pixel.
    QVERIFY(std::abs(a.cloud.size() - b.cloud.size()) <= 8);
    QVERIFY(std::abs(a.area_cm2 / b.area_cm2 - 1.0) < 0.05);
    for (int i = 0; i < b.cloud.size(); ++i) QVERIFY(b.cloud.feature(i) == Feature::anterior_margin);
  }

  void DensityIsThatOfTheGrid() {
    for (const double spacing : {1e-3, 2e-3}) {
      const LabelledPart part =
          label(plane_of_points(spacing), rig_, {},
                {0, {}, {{Feature::surface, {{230, 160}, {410, 160}, {410, 320}, {230, 320}}}}});
      QVERIFY(std::abs(part.density_per_cm2 * spacing * spacing * 1e4 - 1.0) < 0.12);
    }
  }

  void WithoutRegionsEverythingIsSurface() {
    const LabelledCloud whole = plane_of_points(2e-3);
    const LabelledPart part = label(whole, rig_, {}, {});
    QCOMPARE(part.cloud.size(), whole.size());
    QVERIFY(part.cloud.feature(0) == Feature::surface);
  }

  void RegionsBesideThePointsAreEmptyAndCloudsWithoutNormalsAreRefused() {
    LabelledCloud whole = plane_of_points(2e-3);
    const Regions corner{0, {}, {{Feature::surface, {{1, 1}, {9, 1}, {9, 9}}}}};
    QCOMPARE(label(whole, rig_, {}, corner).cloud.size(), 0);
    whole.normals.resize(0, 3);
    QVERIFY_THROWS_EXCEPTION(PreconditionError, label(whole, rig_, {}, corner));
    QVERIFY_THROWS_EXCEPTION(PreconditionError, epipolar_line(rig_, Side::left, {1, 1}, 0.1, 0.1));
  }
};

QTEST_APPLESS_MAIN(LabellingTest)
#include "labelling_test.moc"
