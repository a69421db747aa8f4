// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/edit.h"

#include <QTest>
#include <set>

#include "edit_applied.h"
#include "glisson/core/error.h"
#include "glisson/editing/level_tracing.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;

namespace {

/// Smooth hills, so that regions of all sizes and forms are met, some of which run out of the slice.
Image hills(const VolumeGrid& grid) {
  return image_of(grid, [&](const Eigen::Vector3i& v) {
    const Eigen::Vector3d p = place_of(grid, v);
    return 100.0 * (std::sin(0.31 * p.x() + 0.2 * p.z()) + std::sin(0.37 * p.y()) +
                    std::cos(0.23 * p.z() - 0.1 * p.x())) +
           ((v.x() * 7 + v.y() * 13 + v.z() * 5) % 11);
  });
}

/// The line's corners in voxel coordinates along two axes.
std::vector<Eigen::Vector2d> corners_of(const TracedLevel& level, const VolumeGrid& grid, int u, int v) {
  std::vector<Eigen::Vector2d> corners;
  for (Eigen::Index n = 0; n < level.outline.rows(); ++n) {
    const Eigen::Vector3d index =
        grid.index_of(Point<CtFrame>(Eigen::Vector3d(level.outline.row(n).transpose())));
    corners.emplace_back(index[u], index[v]);
  }
  return corners;
}

/// By the crossings of a ray: knows nothing of how the line was made.
bool encloses(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& p) {
  bool inside = false;
  for (std::size_t n = 0; n < corners.size(); ++n) {
    const Eigen::Vector2d &a = corners[n], &b = corners[(n + 1) % corners.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) &&
        p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

}  // namespace

class LevelTracingTest : public QObject {
  Q_OBJECT
 private slots:
  void LevelTracingFindsADiscOfKnownSize();
  void LevelTracingOfAnErasedDiscTakesItAway();
  void TheOutlineEnclosesWhatAClickTakes();
  void TheOutlineIsOneLineAlongTheVoxelsFaces();
  void OutsideTheVolumeNothingIsTraced();
};

void LevelTracingTest::LevelTracingFindsADiscOfKnownSize() {
  for (const VolumeGrid& base : awkward_grids())
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {1.0, -1.0}) {
        VolumeGrid grid = base;
        grid.spacing_mm.setConstant(0.6);
        grid.size = {70, 66, 62};
        std::mt19937 random(8);
        std::normal_distribution<double> noise(0.0, 8.0);
        // A bar along the axis with an edge 1.2 mm wide, brighter or darker than what is about it.
        const Eigen::Vector3d c = middle_of(grid);
        const double radius = 11.0;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const Image image = image_of(grid, [&](const Eigen::Vector3i& at) {
          const Eigen::Vector3d p = place_of(grid, at) - c;
          const double inside = std::clamp((radius - std::hypot(p[u], p[v])) / 1.2 + 0.5, 0.0, 1.0);
          return 60.0 + sign * 100.0 * inside + noise(random);
        });
        Eigen::Vector3d click = c;
        click[axis] = 0.6 * 30;
        click[u] += radius;  // on the edge, half way between the two levels
        LevelTracing tool{structure::kGallbladder, false, axis, p_at(grid, click)};
        const Edited traced = applied({LabelVolume(grid), {}}, image, tool);
        const double area = static_cast<double>(traced.voxels_changed) * 0.36 / (M_PI * radius * radius);
        QVERIFY2(std::abs(area - 1.0) < 0.06, qPrintable(QString("axis %1: %2").arg(axis).arg(area)));
        QVERIFY(traced.notes.empty());
        const int slice = 30;
        for (const auto& [number, before, after] : traced.labels.voxels.changes_since(LabelVolume(grid)))
          for (int n = 0; n < LabelVolume::kSide; ++n) {
            Eigen::Vector3i place = LabelVolume::kSide * traced.labels.voxels.brick_place(number);
            place[axis] += n;
            if (grid.contains(place) && place[axis] != slice)
              QCOMPARE(traced.labels.voxels.at(place), Label{0});
          }
      }
}

void LevelTracingTest::LevelTracingOfAnErasedDiscTakesItAway() {
  const VolumeGrid grid = fine_grid(1.0);
  const Image image = image_of(grid, [&](const Eigen::Vector3i& v) {
    return (v - Eigen::Vector3i(20, 20, v.z())).norm() < 8.0 ? 100.0 : 0.0;
  });
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) {
    return v.x() < 20 ? structure::kParenchyma : structure::kPortalVein;
  });
  LevelTracing tool{structure::kParenchyma, true, 2, {0.020, 0.012, 0.010}};
  const Edited erased = applied(labels, image, tool);
  QVERIFY(erased.voxels_changed > 60 && erased.voxels_changed < 140);  // the half that is parenchyma
  QCOMPARE(erased.labels.voxels.at({15, 20, 10}), structure::kBackground);
  QCOMPARE(erased.labels.voxels.at({25, 20, 10}), structure::kPortalVein);
  QCOMPARE(erased.labels.voxels.at({15, 20, 11}), structure::kParenchyma);
  tool.label = structure::kBackground;  // of any label
  QCOMPARE(applied(labels, image, tool).labels.voxels.at({25, 20, 10}), structure::kBackground);
}

void LevelTracingTest::TheOutlineEnclosesWhatAClickTakes() {
  int open = 0, closed = 0;
  for (const VolumeGrid& grid : awkward_grids()) {
    const Image image = hills(grid);
    const LabelMap none{LabelVolume(grid), {}};
    LevelTracer tracer;
    std::mt19937 random(5);
    for (int turn = 0; turn < 24; ++turn) {
      const int axis = turn / 2 % 3, u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;  // two places of a slice
      Eigen::Vector3d index;
      for (int k = 0; k < 3; ++k)
        index[k] = std::uniform_real_distribution<double>(0.0, grid.size[k] - 1.0)(random);
      const Eigen::Vector3d p = grid.p_in_ct(index).xyz;
      const TracedLevel level = tracer.trace(image, axis, Point<CtFrame>(p));
      const Edited clicked = applied(none, image, LevelTracing{structure::kGallbladder, false, axis, p});
      QCOMPARE(level.voxels, clicked.voxels_changed);
      QCOMPARE(level.open, clicked.notes == std::vector<std::string>{"level_tracing.open"});
      ++(level.open ? open : closed);
      const std::vector<Eigen::Vector2d> corners = corners_of(level, grid, u, v);
      Eigen::Vector3i at = index.array().round().cast<int>().matrix();
      for (at[v] = 0; at[v] < grid.size[v]; ++at[v])
        for (at[u] = 0; at[u] < grid.size[u]; ++at[u])
          QCOMPARE(clicked.labels.voxels.at(at) != 0, encloses(corners, {double(at[u]), double(at[v])}));
    }
  }
  QVERIFY2(open > 5 && closed > 20, qPrintable(QString("%1 open, %2 closed").arg(open).arg(closed)));
}

void LevelTracingTest::TheOutlineIsOneLineAlongTheVoxelsFaces() {
  const VolumeGrid grid = awkward_grids()[1];
  const Image image = hills(grid);
  LevelTracer tracer;
  const TracedLevel level = tracer.trace(image, 2, Point<CtFrame>(grid.p_in_ct({20.2, 17.7, 12.4}).xyz));
  const std::vector<Eigen::Vector2d> corners = corners_of(level, grid, 0, 1);
  QVERIFY(corners.size() >= 4);
  std::set<std::pair<long, long>> places;
  for (std::size_t n = 0; n < corners.size(); ++n) {
    const Eigen::Vector2d step = corners[(n + 1) % corners.size()] - corners[n];
    QVERIFY(std::abs(step.x()) < 1e-9 || std::abs(step.y()) < 1e-9);
    QVERIFY(step.norm() > 0.5);
    const Eigen::Array2d twice = 2.0 * corners[n].array();
    QVERIFY(((twice - twice.round()).abs() < 1e-9).all() && std::lround(std::abs(twice.x())) % 2 == 1);
    places.emplace(std::lround(twice.x()), std::lround(twice.y()));
  }
  QCOMPARE(places.size(), corners.size());  // it nowhere meets itself
  for (Eigen::Index n = 0; n < level.outline.rows(); ++n)
    QVERIFY(std::abs(grid.index_of(Point<CtFrame>(Eigen::Vector3d(level.outline.row(n).transpose()))).z() -
                     12.0) < 1e-9);
}

void LevelTracingTest::OutsideTheVolumeNothingIsTraced() {
  const VolumeGrid grid = awkward_grids()[0];
  const Image image = hills(grid);
  LevelTracer tracer;
  const Point<CtFrame> away(grid.p_in_ct({-3.0, 5.0, 5.0}).xyz);
  QVERIFY_THROWS_EXCEPTION(InputError, tracer.trace(image, 0, away));
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           tracer.trace(image, 3, Point<CtFrame>(grid.p_in_ct({5.0, 5.0, 5.0}).xyz)));
}

QTEST_APPLESS_MAIN(LevelTracingTest)
#include "level_tracing_test.moc"
