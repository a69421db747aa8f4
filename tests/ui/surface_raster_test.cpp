// SPDX-License-Identifier: GPL-3.0-or-later
// The rasteriser against a ray caster: every pixel's own ray (Camera::ray undoes the lens) meets the surface
// at its first hit.
#include "glisson/ui/scene/surface_raster.h"

#include <QTest>

#include "box_patient.h"
#include "glisson/core/error.h"
#include "glisson/geometry/closest_point_tree.h"

namespace glisson {
namespace {

constexpr double kHalf = 0.5;  ///< of the pictures' size: a ray for each pixel takes its time

struct Difference {
  int pixels = 0;         ///< that the surface covers
  int wrong = 0;          ///< covered in one and not in the other, away from silhouettes
  double depth_mm = 0.0;  ///< largest difference
};

bool is_covered(const ClosestPointTree& tree, const Camera& camera, double u, double v, double* depth) {
  const Eigen::Vector3d ray = camera.ray({u, v});
  const ClosestPoint hit = tree.first_hit(Eigen::Vector3d::Zero(), ray, scene::SurfaceRaster::kNear, 10.0);
  if (hit.triangle < 0) return false;
  if (depth != nullptr) *depth = hit.point.z();
  return true;
}

Difference compare(const TriangleMesh& mesh, const Camera& camera) {
  const scene::SurfaceRaster raster(camera);
  scene::SurfaceLayer layer = raster.layer();
  raster.draw(mesh.vertices, mesh.triangles, 7, layer);
  const ClosestPointTree tree(mesh);
  Difference difference;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      // A silhouette may fall on either side of a pixel's centre.
      double depth = 0.0;
      int near = 0;
      for (const auto& [du, dv] : {std::pair{0.3, 0.0}, {-0.3, 0.0}, {0.0, 0.3}, {0.0, -0.3}})
        near += is_covered(tree, camera, u + du, v + dv, nullptr) ? 1 : 0;
      if (near != 0 && near != 4) continue;
      const bool covered = is_covered(tree, camera, u, v, &depth), drawn = layer.kind[layer.at(v, u)] == 7;
      difference.pixels += covered ? 1 : 0;
      difference.wrong += covered != drawn ? 1 : 0;
      if (covered && drawn)
        difference.depth_mm =
            std::max(difference.depth_mm, 1e3 * std::abs(layer.depth(layer.at(v, u)) - depth));
    }
  return difference;
}

scene::SurfaceLayer drawn(const scene::SurfaceRaster& raster, const Points& vertices,
                          const scene::SidedTriangles& triangles) {
  scene::SurfaceLayer layer = raster.layer();
  scene::ProjectedSurface projected;
  raster.project(vertices, triangles.triangles, projected);
  layer.touched.add(raster.fill(projected, triangles, 3, {0, layer.height}, layer));
  return layer;
}

/// The triangles that begin so far from the camera.
Triangles beyond(const TriangleMesh& mesh, double z) {
  Triangles kept(mesh.triangles.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    if (mesh.vertices(mesh.triangles(t, 0), 2) > z) kept.row(count++) = mesh.triangles.row(t);
  return kept.topRows(count);
}

}  // namespace

class SurfaceRasterTest : public QObject {
  Q_OBJECT
 private slots:
  void FineSurfaceIsWhereRaysMeetIt();
  void LongTrianglesFollowTheLens();
  void SurfaceThroughTheCameraIsCutNotFolded();
  void NearerOneHidesTheOther();
  void FacingIsTheCosineToTheLineOfSight();
  void AClearedLayerIsAsGoodAsNew();
  void BandsAreTheSameAsTheWhole();
  void BandsShareTheVertices();
  void BacksThatAreHiddenNeedNoDrawing();
  void BacksAreDrawnWhereTheyAreSeen();
  void BadInputIsRefused();
};

void SurfaceRasterTest::FineSurfaceIsWhereRaysMeetIt() {
  const Difference found = compare(ball_mesh({0.015, -0.01, 0.12}, 0.03, 40), laparoscope(kHalf));
  QVERIFY(found.pixels > 8000);
  QCOMPARE(found.wrong, 0);
  QVERIFY2(found.depth_mm < 1.0, qPrintable(QStringLiteral("off by %1 mm").arg(found.depth_mm)));
}

void SurfaceRasterTest::LongTrianglesFollowTheLens() {
  TriangleMesh wall;  // fills and leaves the picture; its edges are bent by the lens
  wall.vertices.resize(4, 3);
  wall.vertices << -0.055, -0.03, 0.1, 0.06, -0.025, 0.12, 0.05, 0.04, 0.09, -0.05, 0.03, 0.11;
  wall.triangles.resize(2, 3);
  wall.triangles << 0, 1, 2, 0, 2, 3;
  const Difference found = compare(wall, laparoscope(kHalf));
  QVERIFY(found.pixels > 20000);
  QCOMPARE(found.wrong, 0);
  QVERIFY2(found.depth_mm < 0.1, qPrintable(QStringLiteral("off by %1 mm").arg(found.depth_mm)));
}

void SurfaceRasterTest::SurfaceThroughTheCameraIsCutNotFolded() {
  // A liver that surrounds the laparoscope's tip: parts lie behind it, beside it, and in front.
  const Difference found = compare(ball_mesh({0.0, 0.0, 0.05}, 0.08, 40), laparoscope(kHalf));
  QVERIFY(found.pixels > 50000);
  QCOMPARE(found.wrong, 0);
}

void SurfaceRasterTest::NearerOneHidesTheOther() {
  const Camera camera = laparoscope(kHalf);
  const scene::SurfaceRaster raster(camera);
  const TriangleMesh near = ball_mesh({0, 0, 0.1}, 0.01, 20), far = ball_mesh({0, 0, 0.2}, 0.04, 20);
  const Eigen::Vector2d centre = camera.project({0, 0, 0.1}), side = camera.project({0.03, 0, 0.19});
  const auto kinds = [&](bool far_first) {
    scene::SurfaceLayer layer = raster.layer();
    raster.draw((far_first ? far : near).vertices, near.triangles, far_first ? 2 : 1, layer);
    raster.draw((far_first ? near : far).vertices, near.triangles, far_first ? 1 : 2, layer);
    const auto kind_at = [&](const Eigen::Vector2d& p) {
      return int(
          layer.kind[layer.at(static_cast<int>(std::lround(p.y())), static_cast<int>(std::lround(p.x())))]);
    };
    return std::pair(kind_at(centre), kind_at(side));
  };
  QVERIFY(kinds(false) == std::pair(1, 2));
  QVERIFY(kinds(true) == std::pair(1, 2));
}

void SurfaceRasterTest::FacingIsTheCosineToTheLineOfSight() {
  const Camera camera = laparoscope(kHalf);
  const scene::SurfaceRaster raster(camera);
  const Eigen::Vector3d centre(0.0, 0.0, 0.1);
  constexpr double kRadius = 0.02;
  const TriangleMesh ball = ball_mesh(centre, kRadius, 60);
  scene::SurfaceLayer layer = raster.layer();
  raster.draw(ball.vertices, ball.triangles, 1, layer);
  for (const double x : {0.0, 0.006, 0.012}) {
    const Eigen::Vector3d p = centre + Eigen::Vector3d(x, 0.0, -std::sqrt(kRadius * kRadius - x * x));
    const double expected = -(p - centre).normalized().dot(p.normalized());
    const Eigen::Vector2d pixel = camera.project(p);
    const std::size_t at =
        layer.at(static_cast<int>(std::lround(pixel.y())), static_cast<int>(std::lround(pixel.x())));
    QVERIFY(std::abs(layer.facing[at] / 255.0 - expected) < 0.03);
  }
}

void SurfaceRasterTest::AClearedLayerIsAsGoodAsNew() {
  const scene::SurfaceRaster raster(laparoscope(kHalf));
  const TriangleMesh large = ball_mesh({0.01, 0.0, 0.1}, 0.04, 20),
                     small = ball_mesh({-0.02, 0.01, 0.1}, 0.01, 20);
  scene::SurfaceLayer used = raster.layer(), fresh = raster.layer(), empty;
  QVERIFY(fresh.touched.empty());
  raster.draw(large.vertices, large.triangles, 1, used);
  raster.clear(used);
  raster.clear(empty);  // has no size yet
  for (scene::SurfaceLayer* layer : {&used, &fresh, &empty})
    raster.draw(small.vertices, small.triangles, 2, *layer);
  for (const scene::SurfaceLayer* layer : {&used, &empty})
    QVERIFY(layer->kind == fresh.kind && layer->facing == fresh.facing &&
            layer->inverse_depth == fresh.inverse_depth);
  // Nothing lies outside of what is said to be touched, which is about as large as the ball.
  const scene::PixelBox& box = fresh.touched;
  for (int v = 0; v < fresh.height; ++v)
    for (int u = 0; u < fresh.width; ++u)
      if (fresh.kind[fresh.at(v, u)] != 0)
        QVERIFY(u >= box.left && u < box.right() && v >= box.top && v < box.bottom());
  QVERIFY(!box.empty() && box.width < fresh.width / 3);
  const scene::PixelBox wide = box.around(10000, fresh.width, fresh.height);
  QVERIFY(wide.left == 0 && wide.top == 0 && wide.width == fresh.width && wide.height == fresh.height);
  QVERIFY(scene::PixelBox().around(5, 100, 100).empty());
}

void SurfaceRasterTest::BandsAreTheSameAsTheWhole() {
  const scene::SurfaceRaster raster(laparoscope(kHalf));
  // Small triangles, and long ones that are divided and leave the picture.
  TriangleMesh wall;
  wall.vertices.resize(4, 3);
  wall.vertices << -0.055, -0.03, 0.1, 0.06, -0.025, 0.12, 0.05, 0.04, 0.09, -0.05, 0.03, 0.11;
  wall.triangles.resize(2, 3);
  wall.triangles << 0, 1, 2, 0, 2, 3;
  for (const TriangleMesh& mesh : {ball_mesh({0.015, -0.01, 0.12}, 0.03, 40), wall}) {
    scene::SurfaceLayer whole = raster.layer(), pieces = raster.layer();
    raster.draw(mesh.vertices, mesh.triangles, 3, whole);
    scene::ProjectedSurface projected;
    raster.project(mesh.vertices, mesh.triangles, projected);
    scene::PixelBox touched;
    for (const scene::RowBand& band : scene::row_bands({&projected}, pieces.height, 5))
      touched.add(raster.fill(projected, {mesh.triangles, 0}, 3, band, pieces));
    QVERIFY(whole.kind == pieces.kind && whole.facing == pieces.facing &&
            whole.inverse_depth == pieces.inverse_depth);
    const scene::PixelBox& box = whole.touched;
    QVERIFY(touched.left == box.left && touched.top == box.top && touched.width == box.width &&
            touched.height == box.height);
  }
}

void SurfaceRasterTest::BandsShareTheVertices() {
  const scene::SurfaceRaster raster(laparoscope(kHalf));
  const int height = raster.layer().height;
  const TriangleMesh ball = ball_mesh({0.0, 0.015, 0.12}, 0.012, 40);
  scene::ProjectedSurface projected;
  raster.project(ball.vertices, ball.triangles, projected);
  const auto bands = scene::row_bands({&projected}, height, 3);
  QCOMPARE(bands.size(), std::size_t{3});
  int end = 0;
  std::vector<int> held;
  for (const scene::RowBand& band : bands) {
    QVERIFY(band.first == end && band.end > band.first);
    end = band.end;
    int count = 0;
    for (const scene::RasterCorner& corner : projected.corners)
      count += corner.pixel.y() >= static_cast<float>(band.first) &&
               corner.pixel.y() < static_cast<float>(band.end);
    held.push_back(count);
  }
  QCOMPARE(end, height);
  const auto [least, most] = std::minmax_element(held.begin(), held.end());
  QVERIFY2(*most < 1.3 * *least, qPrintable(QString("%1 and %2").arg(*least).arg(*most)));
  // Where there is nothing one band is enough.
  QCOMPARE(scene::row_bands({}, height, 4).size(), std::size_t{1});
}

void SurfaceRasterTest::BacksThatAreHiddenNeedNoDrawing() {
  const scene::SurfaceRaster raster(laparoscope(kHalf));
  const TriangleMesh ball = ball_mesh({0.015, -0.01, 0.12}, 0.03, 40);
  TriangleMesh inside_out = ball;
  inside_out.triangles.col(1).swap(inside_out.triangles.col(2));
  scene::SurfaceLayer both = raster.layer();
  raster.draw(ball.vertices, ball.triangles, 3, both);
  for (const TriangleMesh& mesh : {ball, inside_out}) {
    const scene::SidedTriangles sided = scene::sort_by_sides(mesh, mesh.triangles);
    QCOMPARE(sided.one_sided, mesh.triangles.rows());
    QCOMPARE(sided.triangles.rows(), mesh.triangles.rows());
    const scene::SurfaceLayer one = drawn(raster, mesh.vertices, sided);
    int other = 0;
    for (std::size_t i = 0; i < both.kind.size(); ++i)
      other += both.kind[i] != one.kind[i] || both.inverse_depth[i] != one.inverse_depth[i];
    QVERIFY2(other <= 2, qPrintable(QStringLiteral("%1 pixels").arg(other)));  // on the rim
    // What is left out is left out: wound the other way round, the far half alone is drawn.
    scene::SidedTriangles away = sided;
    away.triangles.col(1).swap(away.triangles.col(2));
    const scene::SurfaceLayer back = drawn(raster, mesh.vertices, away);
    const std::size_t middle =
        back.at(static_cast<int>(both.height / 2), both.touched.left + both.touched.width / 2);
    QVERIFY(back.kind[middle] == 3 && back.depth(middle) > both.depth(middle) + 0.03F);
  }
}

void SurfaceRasterTest::BacksAreDrawnWhereTheyAreSeen() {
  const scene::SurfaceRaster raster(laparoscope(kHalf));
  const TriangleMesh ball = ball_mesh({0.0, 0.0, 0.12}, 0.03, 40);
  // All but a far cap is cut away: one looks at its inside, which is turned away.
  const Triangles cup = beyond(ball, 0.145);
  const scene::SidedTriangles sided = scene::sort_by_sides(ball, cup);
  QCOMPARE(sided.triangles.rows(), cup.rows());
  QCOMPARE(sided.one_sided, Eigen::Index{0});  // all is near its rim
  scene::SurfaceLayer all = raster.layer();
  raster.draw(ball.vertices, cup, 3, all);
  const scene::SurfaceLayer one = drawn(raster, ball.vertices, sided);
  QVERIFY(std::count(all.kind.begin(), all.kind.end(), std::uint8_t{3}) > 1000);
  QVERIFY(one.kind == all.kind && one.inverse_depth == all.inverse_depth);
  // So far one looks into it, and not farther (some rings): in the middle of a deep cup nothing is drawn.
  const scene::SidedTriangles deep = scene::sort_by_sides(ball, beyond(ball, 0.105));
  const scene::SurfaceLayer seen = drawn(raster, ball.vertices, deep);
  const std::size_t middle = seen.at(seen.height / 2, seen.touched.left + seen.touched.width / 2);
  QVERIFY(seen.kind[middle] == 0 && deep.one_sided > 0);
  // An open whole, and one that is wound in two ways, are drawn from both sides everywhere.
  QCOMPARE(scene::sort_by_sides({ball.vertices, cup}, cup).one_sided, Eigen::Index{0});
  TriangleMesh torn = ball;
  std::swap(torn.triangles(7, 1), torn.triangles(7, 2));
  QCOMPARE(scene::sort_by_sides(torn, torn.triangles).one_sided, Eigen::Index{0});
  // The camera is inside.
  TriangleMesh around = ball;
  around.vertices.rowwise() -= Eigen::RowVector3d(0, 0, 0.12);
  const scene::SurfaceLayer inside =
      drawn(raster, around.vertices, scene::sort_by_sides(around, around.triangles));
  QCOMPARE(inside.kind[inside.at(inside.height / 2, inside.width / 2)], std::uint8_t{3});
}

void SurfaceRasterTest::BadInputIsRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::SurfaceRaster(Camera{}));
  const scene::SurfaceRaster raster(laparoscope(kHalf));
  const TriangleMesh ball = ball_mesh({0, 0, 0.1}, 0.01, 8);
  scene::SurfaceLayer layer = raster.layer(), other;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, raster.draw(ball.vertices, ball.triangles, 0, layer));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, raster.draw(ball.vertices, ball.triangles, 1, other));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, raster.fill({}, {}, 1, {0, layer.height + 1}, layer));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::row_bands({}, 10, 0));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::SurfaceRasterTest)
#include "surface_raster_test.moc"
