// SPDX-License-Identifier: GPL-3.0-or-later
// What the segmentation step draws: slices that follow an edit, previews, and label surfaces by blocks.
#include <QElapsedTimer>
#include <QTest>
#include <random>
#include <set>

#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/colours.h"
#include "glisson/ui/scene/difference_overlay.h"
#include "glisson/ui/scene/label_surfaces.h"
#include "glisson/ui/scene/slice_drawing.h"

namespace glisson {
namespace {

using scene::Plane;

VolumeGrid grid_of(const Eigen::Vector3i& size, const Eigen::Vector3d& spacing_mm) {
  VolumeGrid grid;
  grid.size = size;
  grid.spacing_mm = spacing_mm;
  grid.origin_mm = -0.5 * (size.cast<double>().array() - 1.0) * spacing_mm.array();
  return grid;
}

std::shared_ptr<const Image> ramp(const VolumeGrid& grid) {
  auto image = std::make_shared<Image>();
  image->grid = grid;
  auto voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(grid.voxel_count()));
  for (std::size_t i = 0; i < voxels->size(); ++i)
    (*voxels)[i] = static_cast<std::int16_t>((i * 7919) % 400) - 100;
  image->voxels = voxels;
  return image;
}

void paint_ball(LabelVolume& labels, const Eigen::Vector3d& centre, double radius, Label label) {
  const VolumeGrid& grid = labels.grid();
  const Eigen::Vector3d middle = grid.index_of(Point<CtFrame>(centre));
  const Eigen::Vector3d reach = (1e3 * radius / grid.spacing_mm.array()).matrix();
  const Eigen::Vector3i low = (middle - reach).array().floor().cast<int>().max(0).matrix();
  const Eigen::Vector3i high =
      (middle + reach).array().ceil().cast<int>().min(grid.size.array() - 1).matrix();
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j)
      for (int i = low.x(); i <= high.x(); ++i) {
        const Eigen::Vector3i v(i, j, k);
        if ((grid.p_in_ct(v.cast<double>()).xyz - centre).norm() <= radius) labels.set(v, label);
      }
}

/// All blocks of one label as one mesh, vertices at one place joined.
TriangleMesh whole(const scene::LabelSurfaces& surfaces, Label label) {
  std::map<std::array<long, 3>, int> number;
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Eigen::Vector3i> triangles;
  for (const auto& [key, block] : surfaces.blocks()) {
    if (key.first != label) continue;
    std::vector<int> id;
    for (Eigen::Index v = 0; v < block->vertices.rows(); ++v) {
      const Eigen::Vector3d p = block->vertices.row(v).cast<double>().transpose();
      const std::array<long, 3> place = {std::lround(p.x() * 1e12), std::lround(p.y() * 1e12),
                                         std::lround(p.z() * 1e12)};
      const auto [entry, fresh] = number.try_emplace(place, static_cast<int>(vertices.size()));
      if (fresh) vertices.push_back(p);
      id.push_back(entry->second);
    }
    for (Eigen::Index t = 0; t < block->triangles.rows(); ++t) {
      const Eigen::Vector3i ids(id[static_cast<std::size_t>(block->triangles(t, 0))],
                                id[static_cast<std::size_t>(block->triangles(t, 1))],
                                id[static_cast<std::size_t>(block->triangles(t, 2))]);
      triangles.push_back(ids);
    }
  }
  TriangleMesh mesh;
  mesh.vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    mesh.vertices.row(static_cast<Eigen::Index>(v)) = vertices[v].transpose();
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.row(static_cast<Eigen::Index>(t)) = triangles[t].transpose();
  return mesh;
}

double volume_of(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) {
      return Eigen::Vector3d(mesh.vertices.row(mesh.triangles(t, k)).transpose());
    };
    sum += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
  }
  return sum;
}

/// Each edge once in each direction: closed, and all triangles look to one side.
bool looks_to_one_side(const TriangleMesh& mesh) {
  std::multiset<std::pair<int, int>> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) edges.emplace(mesh.triangles(t, k), mesh.triangles(t, (k + 1) % 3));
  return std::all_of(edges.begin(), edges.end(), [&](const std::pair<int, int>& edge) {
    return edges.count(edge) == edges.count({edge.second, edge.first});
  });
}

bool same_blocks(const scene::LabelSurfaces& a, const scene::LabelSurfaces& b) {
  return a.blocks().size() == b.blocks().size() &&
         std::equal(a.blocks().begin(), a.blocks().end(), b.blocks().begin(),
                    [](const auto& one, const auto& other) {
                      return one.first == other.first && one.second->vertices == other.second->vertices &&
                             one.second->triangles == other.second->triangles;
                    });
}

}  // namespace

class SegmentationDrawingTest : public QObject {
  Q_OBJECT
 private slots:
  void DrawingAfterEditsIsThatOfTheWholeSlice();
  void OnlyPixelsOfChangedBricksAreDrawnAgain();
  void HiddenLabelsAreNotDrawn();
  void PreviewIsHatchedWhereLabelsWouldChange();
  void DifferencesHaveAColourAndAHatchingEach();
  void OutlineFollowsTheLabelsEdge();
  void BallsSurfaceIsClosedAndAsLargeAsTheBall_data();
  void BallsSurfaceIsClosedAndAsLargeAsTheBall();
  void SurfaceTouchingTheVolumesEndIsClosed();
  void EditMakesOnlyItsBlocksAgain();
  void LiverSparesItsOwnVessels();
  void CancelledSurfacesAreEmpty();
  void MeasureOnALargeVolume();
};

void SegmentationDrawingTest::DrawingAfterEditsIsThatOfTheWholeSlice() {
  VolumeGrid grid = grid_of({100, 90, 80}, {0.8, 0.8, 1.0});
  for (const bool oblique : {false, true}) {
    if (oblique) grid.direction = Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    const auto image = ramp(grid);
    auto labels = std::make_shared<LabelMap>();
    labels->voxels = LabelVolume(grid);
    std::array<scene::SliceDrawing, 3> drawings;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-0.03, 0.03);
    scene::SliceStyle style;
    for (int turn = 0; turn < 30; ++turn) {
      auto next = std::make_shared<LabelMap>(*labels);
      paint_ball(next->voxels, {place(random), place(random), place(random)}, 5e-3,
                 static_cast<Label>(turn % 4));
      labels = next;
      if (turn == 10) style.level = 30.0;
      if (turn == 20) style.hidden = {structure::kPortalVein};
      for (int plane = 0; plane < 3; ++plane) {
        const scene::SliceGeometry slice = scene::slice_geometry(
            grid, static_cast<Plane>(plane), Point<CtFrame>(0.0, turn > 25 ? 0.004 : 0.0, 0.0));
        scene::SliceDrawing& drawing = drawings[static_cast<std::size_t>(plane)];
        drawing.draw(image, labels, slice, style);
        QVERIFY(*drawing.picture().bytes ==
                *scene::slice_picture(*image, &labels->voxels, slice, style).bytes);
      }
    }
  }
}

void SegmentationDrawingTest::OnlyPixelsOfChangedBricksAreDrawnAgain() {
  const VolumeGrid grid = grid_of({128, 128, 96}, {1.0, 1.0, 1.0});
  const auto image = ramp(grid);
  auto labels = std::make_shared<LabelMap>();
  labels->voxels = LabelVolume(grid);
  const scene::SliceGeometry slice = scene::slice_geometry(grid, Plane::axial, Point<CtFrame>(0.0, 0.0, 0.0));
  scene::SliceDrawing drawing;
  QCOMPARE(drawing.draw(image, labels, slice, {}), QRect(0, 0, 128, 128));
  QVERIFY(drawing.draw(image, labels, slice, {}).isEmpty());
  const Picture former = drawing.picture();
  const std::vector<std::uint8_t> kept = *former.bytes;
  auto edited = std::make_shared<LabelMap>(*labels);
  edited->voxels.set({40, 70, 47}, structure::kParenchyma);
  const QRect drawn = drawing.draw(image, edited, slice, {});
  QVERIFY(drawn.contains(QPoint(40, 70)) && drawn.width() <= 36 && drawn.height() <= 36);
  QVERIFY(*former.bytes == kept);  // whoever holds a picture keeps it
  auto elsewhere = std::make_shared<LabelMap>(*edited);
  elsewhere->voxels.set({40, 70, 5}, structure::kParenchyma);
  QVERIFY(drawing.draw(image, elsewhere, slice, {}).isEmpty());  // another slice's brick
}

void SegmentationDrawingTest::HiddenLabelsAreNotDrawn() {
  const VolumeGrid grid = grid_of({40, 40, 40}, {1.0, 1.0, 1.0});
  const auto image = ramp(grid);
  LabelVolume labels(grid);
  paint_ball(labels, {0, 0, 0}, 8e-3, structure::kVenaCava);
  const scene::SliceGeometry slice = scene::slice_geometry(grid, Plane::axial, Point<CtFrame>());
  scene::SliceStyle style;
  const auto shown = scene::slice_picture(*image, &labels, slice, style);
  style.hidden = {structure::kVenaCava};
  const auto hidden = scene::slice_picture(*image, &labels, slice, style);
  QVERIFY(*shown.bytes != *hidden.bytes);
  QVERIFY(*hidden.bytes == *scene::slice_picture(*image, nullptr, slice, style).bytes);
}

void SegmentationDrawingTest::PreviewIsHatchedWhereLabelsWouldChange() {
  const VolumeGrid grid = grid_of({64, 64, 40}, {1.0, 1.0, 1.0});
  LabelVolume before(grid);
  paint_ball(before, {-0.012, 0, 0}, 6e-3, structure::kPortalVein);
  LabelVolume after = before;
  paint_ball(after, {0.012, 0, 0}, 8e-3, structure::kHepaticVeins);
  paint_ball(after, {-0.012, 0, 0}, 3e-3, structure::kBackground);
  const scene::SliceGeometry slice = scene::slice_geometry(grid, Plane::axial, Point<CtFrame>());
  const QImage overlay = scene::change_overlay(before, after, slice);
  QVERIFY(!overlay.isNull());
  const auto pixel = [&](double x, double y) {
    const Eigen::Vector2d at = slice.pixel_of(Point<CtFrame>(x, y, 0.0));
    return overlay.pixelColor(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
  };
  int strong = 0, weak = 0;
  for (int v = 0; v < overlay.height(); ++v)
    for (int u = 0; u < overlay.width(); ++u) {
      const int alpha = overlay.pixelColor(u, v).alpha();
      strong += alpha == 255 ? 1 : 0;
      weak += alpha > 0 && alpha < 255 ? 1 : 0;
    }
  QVERIFY(strong > 30 && weak > 100);  // lines, and what is between them
  QVERIFY(pixel(0.012, 0.0).alpha() > 0);
  QCOMPARE(pixel(0.0, 0.02).alpha(), 0);
  QCOMPARE(pixel(-0.0172, 0.0).alpha(), 0);  // stays portal vein
  const QColor gone = pixel(-0.0125, 0.0);
  QVERIFY(gone.alpha() > 0 && gone.red() == gone.green() && gone.green() == gone.blue());  // white
  QVERIFY(scene::change_overlay(before, before, slice).isNull());
}

void SegmentationDrawingTest::DifferencesHaveAColourAndAHatchingEach() {
  using scene::Change;
  VolumeGrid grid = grid_of({60, 60, 3}, {1.0, 1.0, 1.0});
  LabelVolume before(grid), after(grid), hand(grid);
  const auto fill = [](LabelVolume& labels, int from, Label label) {
    for (int j = 5; j < 25; ++j)
      for (int i = from; i < from + 15; ++i) labels.set({i, j, 1}, label);
  };
  fill(before, 2, 1);  // will be gone
  fill(after, 20, 1);  // will come
  fill(before, 40, 1);
  fill(after, 40, 2);  // will be another
  const auto slice = scene::slice_geometry(grid, Plane::axial, Point<CtFrame>(grid.p_in_ct({30, 30, 1})));
  const QImage drawn = scene::difference_overlay(before, after, hand, slice);
  const auto at = [&](int i, int j) {
    const auto pixel = slice.pixel_of(grid.p_in_ct({double(i), double(j), 1.0}));
    return QPoint(qRound(pixel.x()), qRound(pixel.y()));
  };
  std::map<int, QRgb> rim;
  for (const int from : {2, 20, 40}) {
    rim[from] = drawn.pixel(at(from, 15));
    QCOMPARE(qAlpha(rim[from]), 255);
    int lines = 0, between = 0;
    for (int i = from + 2; i < from + 13; ++i) ++(qAlpha(drawn.pixel(at(i, 15))) == 255 ? lines : between);
    QVERIFY(lines >= 2 && between >= 2);
  }
  // Told apart without the hue: by lightness, and by which way the lines run.
  QVERIFY(rim[2] != rim[20] && rim[20] != rim[40] && rim[2] != rim[40]);
  QImage swatches[] = {scene::difference_swatch(Change::added, false, 20, 20),
                       scene::difference_swatch(Change::removed, false, 20, 20)};
  QVERIFY(qAlpha(swatches[0].pixel(10, 5)) == 255 && qAlpha(swatches[1].pixel(10, 5)) == 255);
  QVERIFY(qAlpha(swatches[0].pixel(11, 4)) == 255 && qAlpha(swatches[1].pixel(11, 4)) < 255);
  QVERIFY(qAlpha(swatches[0].pixel(11, 6)) < 255 && qAlpha(swatches[1].pixel(11, 6)) == 255);
  QCOMPARE(drawn.pixelColor(at(18, 15)).alpha(), 0);
  QVERIFY(scene::difference_overlay(before, before, hand, slice).isNull());
  // A hand's are white at their rim.
  fill(hand, 2, 1);
  QCOMPARE(scene::difference_overlay(before, after, hand, slice).pixelColor(at(2, 15)), QColor(Qt::white));
}

void SegmentationDrawingTest::OutlineFollowsTheLabelsEdge() {
  const VolumeGrid grid = grid_of({64, 64, 40}, {1.0, 1.0, 1.0});
  LabelVolume labels(grid);
  paint_ball(labels, {0, 0, 0}, 10e-3, structure::kParenchyma);
  const scene::SliceGeometry slice = scene::slice_geometry(grid, Plane::axial, Point<CtFrame>());
  const QImage overlay = scene::outline_overlay(labels, slice);
  const Eigen::Vector2d middle = slice.pixel_of(Point<CtFrame>());
  int drawn = 0;
  for (int v = 0; v < overlay.height(); ++v)
    for (int u = 0; u < overlay.width(); ++u)
      if (overlay.pixelColor(u, v).alpha() > 0) {
        ++drawn;
        QVERIFY(std::abs((Eigen::Vector2d(u, v) - middle).norm() - 10.0) < 1.8);
        QCOMPARE(overlay.pixel(u, v), scene::colour_of(structure::kParenchyma).rgb());
      }
  QVERIFY(drawn > 80);
  QVERIFY(scene::outline_overlay(LabelVolume(grid), slice).isNull());
}

void SegmentationDrawingTest::BallsSurfaceIsClosedAndAsLargeAsTheBall_data() {
  QTest::addColumn<int>("label");
  QTest::addColumn<double>("spacing");
  QTest::addColumn<bool>("mirrored");
  QTest::newRow("liver, coarse cells") << int(structure::kParenchyma) << 0.7 << false;
  QTest::newRow("lesion, own voxels") << int(structure::kFirstLesion) << 0.7 << false;
  QTest::newRow("mirrored axes") << int(structure::kVenaCava) << 1.0 << true;
}

void SegmentationDrawingTest::BallsSurfaceIsClosedAndAsLargeAsTheBall() {
  QFETCH(int, label);
  QFETCH(double, spacing);
  QFETCH(bool, mirrored);
  VolumeGrid grid = grid_of({150, 140, 130}, {spacing, spacing, spacing});
  if (mirrored) {
    grid.direction(0, 0) = -1.0;
    grid.origin_mm[0] = -grid.origin_mm[0];
  }
  LabelVolume labels(grid);
  const Eigen::Vector3d centre(0.003, -0.002, 0.001);
  const double radius = 0.028;  // over several blocks
  paint_ball(labels, centre, radius, static_cast<Label>(label));
  const auto surfaces = scene::LabelSurfaces::of(labels, nullptr);
  QVERIFY(surfaces && surfaces->blocks().size() > 4);
  const TriangleMesh ball = whole(*surfaces, static_cast<Label>(label));
  QVERIFY(looks_to_one_side(ball));
  const double truth = 4.0 / 3.0 * M_PI * std::pow(radius, 3);
  QVERIFY2(std::abs(volume_of(ball) / truth - 1.0) < 0.03,
           qPrintable(QString::number(volume_of(ball) / truth)));
  for (const auto& [key, block] : surfaces->blocks())
    for (Eigen::Index v = 0; v < block->vertices.rows(); ++v) {
      const Eigen::Vector3d out = block->vertices.row(v).cast<double>().transpose() - centre;
      QVERIFY(std::abs(out.norm() - radius) < 1.2e-3 * 2.0 * spacing);
      QVERIFY(block->normals.row(v).cast<double>().dot(out.normalized().transpose()) > 0.75);
    }
}

void SegmentationDrawingTest::SurfaceTouchingTheVolumesEndIsClosed() {
  const VolumeGrid grid = grid_of({64, 40, 70}, {1.0, 1.0, 1.0});
  LabelVolume labels(grid);
  for (int k = 0; k < 70; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 64; ++i) labels.set({i, j, k}, structure::kVenaCava);
  const auto surfaces = scene::LabelSurfaces::of(labels, nullptr);
  const TriangleMesh box = whole(*surfaces, structure::kVenaCava);
  QVERIFY(looks_to_one_side(box));
  QVERIFY(std::abs(volume_of(box) / (64e-3 * 40e-3 * 70e-3) - 1.0) < 0.02);
}

void SegmentationDrawingTest::EditMakesOnlyItsBlocksAgain() {
  const VolumeGrid grid = grid_of({256, 256, 192}, {0.8, 0.8, 0.8});
  LabelVolume labels(grid);
  paint_ball(labels, {0, 0, 0}, 0.06, structure::kParenchyma);
  paint_ball(labels, {0.01, 0, 0}, 0.01, structure::kFirstLesion);
  const auto before = scene::LabelSurfaces::of(labels, nullptr);
  LabelVolume edited = labels;
  paint_ball(edited, {-0.0515, -0.0515, -0.0515}, 2e-3, structure::kPortalVein);
  const auto after = scene::LabelSurfaces::of(edited, &*before);
  QVERIFY(after->blocks_made() > 0);
  QVERIFY2(after->blocks_made() <= 8, qPrintable(QString::number(after->blocks_made())));
  QVERIFY(before->blocks_made() > 20);
  QVERIFY(same_blocks(*after, *scene::LabelSurfaces::of(edited, nullptr)));
  int shared = 0;
  for (const auto& [key, block] : after->blocks()) {
    const auto former = before->blocks().find(key);
    shared += former != before->blocks().end() && former->second == block ? 1 : 0;
  }
  QVERIFY(shared >= static_cast<int>(before->blocks().size()) - 8);
  // And back: nothing of the edit stays.
  QVERIFY(same_blocks(*scene::LabelSurfaces::of(labels, &*after), *before));
}

void SegmentationDrawingTest::LiverSparesItsOwnVessels() {
  const VolumeGrid grid = grid_of({96, 96, 96}, {1.0, 1.0, 1.0});
  LabelVolume labels(grid);
  paint_ball(labels, {0, 0, 0}, 0.035, structure::kParenchyma);
  paint_ball(labels, {0, 0, 0}, 0.01, structure::kFirstLesion);
  const auto surfaces = scene::LabelSurfaces::of(labels, nullptr);
  const TriangleMesh liver = whole(*surfaces, structure::kParenchyma);
  for (Eigen::Index v = 0; v < liver.vertices.rows(); ++v) QVERIFY(liver.vertices.row(v).norm() > 0.03);
  QVERIFY(whole(*surfaces, structure::kFirstLesion).triangles.rows() > 100);
}

void SegmentationDrawingTest::CancelledSurfacesAreEmpty() {
  LabelVolume labels(grid_of({64, 64, 64}, {1.0, 1.0, 1.0}));
  paint_ball(labels, {0, 0, 0}, 0.02, structure::kParenchyma);
  QVERIFY(!scene::LabelSurfaces::of(labels, nullptr, [] { return true; }));
}

/// Prints what a stroke costs at the size of a large CT; asserts no time.
void SegmentationDrawingTest::MeasureOnALargeVolume() {
  if (!qEnvironmentVariableIsSet("GLISSON_MEASURE")) QSKIP("set GLISSON_MEASURE to see the times");
  const VolumeGrid grid = grid_of({512, 512, 500}, {0.7, 0.7, 0.8});
  const auto image = ramp(grid);
  auto labels = std::make_shared<LabelMap>();
  labels->voxels = LabelVolume(grid);
  paint_ball(labels->voxels, {0, 0, 0}, 0.08, structure::kParenchyma);
  for (int branch = 0; branch < 12; ++branch)
    for (int at = 0; at < 60; ++at)
      paint_ball(
          labels->voxels,
          1e-3 * at * Eigen::Vector3d(std::cos(0.5 * branch), std::sin(0.5 * branch), 0.1 * branch - 0.5),
          3e-3, branch % 2 == 0 ? structure::kPortalVein : structure::kHepaticVeins);
  const Point<CtFrame> here(0.001, 0.001, 0.001);
  std::array<scene::SliceDrawing, 3> drawings;
  QElapsedTimer clock;
  const auto draw = [&](const char* what) {
    for (int plane = 0; plane < 3; ++plane) {
      const auto slice = scene::slice_geometry(grid, static_cast<Plane>(plane), here);
      clock.start();
      const QRect drawn = drawings[static_cast<std::size_t>(plane)].draw(image, labels, slice, {});
      const double ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
      qInfo("%s, plane %d: %d x %d of %d x %d pixels in %.2f ms", what, plane, drawn.width(), drawn.height(),
            slice.width, slice.height, ms);
    }
  };
  draw("whole slice");
  auto edited = std::make_shared<LabelMap>(*labels);
  paint_ball(edited->voxels, here.xyz, 5e-3, structure::kFirstLesion);
  const auto former = labels;
  labels = edited;
  draw("after a stroke of 5 mm");
  clock.start();
  const auto before = scene::LabelSurfaces::of(former->voxels, nullptr);
  qInfo("surfaces: %d blocks in %lld ms", before->blocks_made(), static_cast<long long>(clock.elapsed()));
  clock.start();
  const auto after = scene::LabelSurfaces::of(labels->voxels, &*before);
  qInfo("after the stroke: %d blocks in %lld ms", after->blocks_made(),
        static_cast<long long>(clock.elapsed()));
  Eigen::Index triangles = 0;
  for (const auto& [key, block] : after->blocks()) triangles += block->triangles.rows();
  qInfo("%d surfaces, %ld triangles", static_cast<int>(after->blocks().size()), static_cast<long>(triangles));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::SegmentationDrawingTest)
#include "segmentation_drawing_test.moc"
