// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <queue>
#include <set>

#include "edit_naive.h"
#include "glisson/core/error.h"
#include "glisson/editing/edit.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;

namespace {

VolumeGrid cube_grid(int side, double spacing_mm) {
  VolumeGrid grid;
  grid.size.setConstant(side);
  grid.spacing_mm.setConstant(spacing_mm);
  return grid;
}

Image flat(const VolumeGrid& grid) {
  return image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
}

Edited applied(const LabelMap& labels, const Image& image, const Tool& tool,
               const EditableRegion& region = {}) {
  return apply_edit(labels, image, {tool, region}, RunContext()).value();
}

bool in_box(const Eigen::Vector3i& v, const Eigen::Vector3i& low, const Eigen::Vector3i& high) {
  return (v.array() >= low.array()).all() && (v.array() < high.array()).all();
}

std::set<std::size_t> voxels_of(const LabelMap& labels, Label label) {
  std::set<std::size_t> voxels;
  const std::vector<Label> dense = labels.voxels.dense();
  for (std::size_t n = 0; n < dense.size(); ++n)
    if (dense[n] == label) voxels.insert(n);
  return voxels;
}

/// Cost of the cheapest path from the seeds of one label to each voxel, by a plain heap in double precision.
std::vector<double> path_costs(const LabelMap& labels, const Image& image, Label label) {
  const VolumeGrid& g = image.grid;
  std::vector<double> values(image.voxels->begin(), image.voxels->end()),
      cost(static_cast<std::size_t>(g.voxel_count()), 1e30);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> former = values;
    for (int k = 0; k < g.size.z(); ++k)
      for (int j = 0; j < g.size.y(); ++j)
        for (int i = 0; i < g.size.x(); ++i) {
          std::array<double, 3> three{};
          for (int n = -1; n <= 1; ++n) {
            Eigen::Vector3i w(i, j, k);
            w[axis] = std::clamp(w[axis] + n, 0, g.size[axis] - 1);
            three[static_cast<std::size_t>(n + 1)] = former[static_cast<std::size_t>(g.offset(w))];
          }
          std::sort(three.begin(), three.end());
          values[static_cast<std::size_t>(g.offset({i, j, k}))] = three[1];
        }
  }
  const std::vector<Label> dense = labels.voxels.dense();
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  for (std::size_t n = 0; n < dense.size(); ++n)
    if (dense[n] == label) heap.emplace(cost[n] = 0.0, n);
  while (!heap.empty()) {
    const auto [c, n] = heap.top();
    heap.pop();
    if (c > cost[n]) continue;
    const auto nx = static_cast<std::size_t>(g.size.x()), ny = static_cast<std::size_t>(g.size.y());
    const Eigen::Vector3i v(static_cast<int>(n % nx), static_cast<int>(n / nx % ny),
                            static_cast<int>(n / (nx * ny)));
    for (int side = 0; side < 6; ++side) {
      Eigen::Vector3i w = v;
      w[side / 2] += side % 2 == 0 ? 1 : -1;
      if (!g.contains(w)) continue;
      const auto at = static_cast<std::size_t>(g.offset(w));
      if (dense[at] != 0) continue;
      const double next = c + std::pow(values[n] - values[at], 2) + 5.0 * g.spacing_mm[side / 2];
      if (next < cost[at]) heap.emplace(cost[at] = next, at);
    }
  }
  return cost;
}

/// Two boxes side by side with seeds in each, of 60 and 110 HU with noise.
struct TwoBoxes {
  Image image;
  LabelMap labels, truth;
};
TwoBoxes two_boxes(double noise_hu) {
  const VolumeGrid grid = cube_grid(48, 0.8);
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0.0, noise_hu);
  const auto left = [](const Eigen::Vector3i& v) { return in_box(v, {6, 8, 8}, {20, 40, 40}); };
  const auto right = [](const Eigen::Vector3i& v) { return in_box(v, {20, 8, 8}, {42, 40, 40}); };
  TwoBoxes scene;
  scene.image = image_of(grid, [&](const Eigen::Vector3i& v) {
    return (left(v) ? 60.0 : right(v) ? 110.0 : -80.0) + noise(random);
  });
  scene.truth = labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
    return left(v) ? structure::kGallbladder : right(v) ? structure::kParenchyma : Label{7};
  });
  scene.labels = labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
    if (in_box(v, {9, 12, 12}, {11, 14, 14})) return structure::kGallbladder;
    if (in_box(v, {34, 30, 30}, {37, 33, 33})) return structure::kParenchyma;
    return in_box(v, {1, 1, 1}, {3, 47, 3}) ? Label{7} : structure::kBackground;
  });
  return scene;
}

}  // namespace

class EditShapeTest : public QObject {
  Q_OBJECT
 private slots:
  void InterpolationIsWhatANaiveProgramDoes();
  void BetweenTwoCirclesLiesACylinderOrACone();
  void NeighbouringSlicesHaveNothingBetween();
  void FillingHolesSparesVesselsAndLesions();
  void SmoothingRemovesABumpAndKeepsABox_data();
  void SmoothingRemovesABumpAndKeepsABox();
  void JointSmoothingLeavesNoGap();
  void WhatAVesselLosesInTheLiverIsParenchyma();
  void GrowingHasTheDistance();
  void ShrinkingWhatWasGrownContainsIt();
  void TwoContrastedBoxesAreFoundDespiteNoise();
  void SeedsWinWhatTheyReachMostCheaply();
  void GrowthKeepsWithinReachAndRegion();
  void NoToolTouchesWhatIsLocked();
};

void EditShapeTest::InterpolationIsWhatANaiveProgramDoes() {
  std::mt19937 random(2);
  for (const VolumeGrid& grid : awkward_grids())
    for (int axis = 0; axis < 3; ++axis) {
      // Blobs in a few slices, one of them in two parts, in a liver.
      std::vector<int> slices;
      for (int n = 1; n < grid.size[axis]; n += 2 + static_cast<int>(random() % 6)) slices.push_back(n);
      const LabelMap labels = labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
        const auto slice = std::find(slices.begin(), slices.end(), v[axis]);
        const Eigen::Vector3d p = place_of(grid, v) - middle_of(grid);
        const auto n = static_cast<double>(slice - slices.begin());
        Eigen::Vector3d a(3.0 * std::sin(n), 2.0 * n - 8.0, std::cos(n)), b(-6.0, 5.0, 4.0 - n);
        a[axis] = b[axis] = p[axis];
        if (slice != slices.end() && ((p - a).norm() < 5.0 || (p - b).norm() < 3.0))
          return structure::kFirstLesion;
        return p.y() > 0.0 ? structure::kParenchyma : p.x() > 9.0 ? structure::kArtery : Label{0};
      });
      const std::string fault =
          fault_of(labels, flat(grid), {InterpolateSlices{structure::kFirstLesion, axis}, {}});
      QVERIFY2(fault.empty(),
               qPrintable(QString("axis %1: %2").arg(axis).arg(QString::fromStdString(fault))));
    }
}

void EditShapeTest::BetweenTwoCirclesLiesACylinderOrACone() {
  const VolumeGrid grid = cube_grid(80, 0.5);
  const auto circles = [&](double first_mm, double last_mm) {
    return labels_of(grid, [=](const Eigen::Vector3i& v) {
      const double r = 0.5 * std::hypot(v.x() - 39.5, v.y() - 39.5);
      const bool in = (v.z() == 10 && r < first_mm) || (v.z() == 60 && r < last_mm);
      return in ? structure::kFirstLesion : structure::kBackground;
    });
  };
  const double height = 25.5;  // mm, with both slices
  const InterpolateSlices tool{structure::kFirstLesion, 2};
  const auto volume = [&](const LabelMap& labels) {
    return 0.125 * static_cast<double>(applied(labels, flat(grid), tool).labels.voxels.histogram().at(16));
  };
  const double cylinder = volume(circles(12.0, 12.0)) / (M_PI * 144.0 * height);
  QVERIFY2(std::abs(cylinder - 1.0) < 0.01, qPrintable(QString::number(cylinder)));
  const double frustum = volume(circles(15.0, 5.0)) / (M_PI / 3.0 * height * (225.0 + 75.0 + 25.0));
  QVERIFY2(std::abs(frustum - 1.0) < 0.01, qPrintable(QString::number(frustum)));
}

void EditShapeTest::NeighbouringSlicesHaveNothingBetween() {
  const VolumeGrid grid = cube_grid(40, 1.0);
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) {
    return in_box(v, {5, 5, 5}, {20, 20, 8}) ? structure::kPortalVein : structure::kBackground;
  });
  const Edited edited = applied(labels, flat(grid), InterpolateSlices{structure::kPortalVein, 2});
  QCOMPARE(edited.notes, (std::vector<std::string>{"no_slices_between", "nothing_changed"}));
}

void EditShapeTest::FillingHolesSparesVesselsAndLesions() {
  const VolumeGrid grid = cube_grid(40, 1.0);
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) -> Label {
    if (!in_box(v, {5, 5, 5}, {35, 35, 35})) return structure::kBackground;
    if (in_box(v, {10, 10, 10}, {14, 14, 14})) return structure::kFirstLesion;
    if (in_box(v, {14, 10, 10}, {16, 14, 14})) return structure::kBackground;  // beside the lesion
    if (in_box(v, {20, 20, 5}, {24, 24, 35})) return structure::kBackground;   // open above and below
    return structure::kParenchyma;
  });
  FillHoles tool{structure::kParenchyma, false};
  const Edited filled = applied(labels, flat(grid), tool);
  QCOMPARE(filled.voxels_changed, 32L);
  QCOMPARE(filled.labels.voxels.at({12, 12, 12}), structure::kFirstLesion);
  QCOMPARE(filled.labels.voxels.at({15, 12, 12}), structure::kParenchyma);
  tool.in_slices = true;
  QCOMPARE(applied(labels, flat(grid), tool).voxels_changed, 32L + 16L * 30L);
}

void EditShapeTest::SmoothingRemovesABumpAndKeepsABox_data() {
  QTest::addColumn<int>("method");
  QTest::newRow("median") << static_cast<int>(Smooth::Method::median);
  QTest::newRow("opening") << static_cast<int>(Smooth::Method::opening);
  QTest::newRow("joint") << static_cast<int>(Smooth::Method::joint);
}

void EditShapeTest::SmoothingRemovesABumpAndKeepsABox() {
  QFETCH(int, method);
  const VolumeGrid grid = cube_grid(60, 1.0);
  const auto box = [](const Eigen::Vector3i& v) { return in_box(v, {10, 10, 10}, {50, 50, 40}); };
  const LabelMap labels = labels_of(grid, [&](const Eigen::Vector3i& v) {
    const bool bump = in_box(v, {29, 29, 40}, {31, 31, 43});
    return box(v) || bump ? structure::kVenaCava : structure::kBackground;
  });
  const Edited smooth =
      applied(labels, flat(grid), Smooth{structure::kVenaCava, static_cast<Smooth::Method>(method), 4e-3});
  const std::set<std::size_t> after = voxels_of(smooth.labels, structure::kVenaCava);
  // The tip of a ball in the box may fill the lowest layer of the bump.
  for (int k = 41; k < 43; ++k) QCOMPARE(smooth.labels.voxels.at({30, 30, k}), structure::kBackground);
  // Of the box only edges and corners are rounded; its faces stay where they are.
  QVERIFY2(after.size() > 0.92 * 48000 && after.size() <= 48004, qPrintable(QString::number(after.size())));
  for (const Eigen::Vector3i& face : {Eigen::Vector3i(10, 30, 25), {49, 30, 25}, {30, 30, 39}, {30, 49, 25}})
    QCOMPARE(smooth.labels.voxels.at(face), structure::kVenaCava);
}

void EditShapeTest::JointSmoothingLeavesNoGap() {
  const VolumeGrid grid = awkward_grids()[1];
  std::mt19937 random(9);
  // A block of three structures and no background inside. Their borders are ragged, by less than the radius:
  // what reaches further is a branch.
  const LabelMap labels = labels_of(grid, [&](const Eigen::Vector3i& v) -> Label {
    if (!in_box(v, {4, 4, 4}, {43, 34, 31})) return structure::kBackground;
    const int ragged = v.x() + static_cast<int>(random() % 4);
    return ragged < 18   ? structure::kParenchyma
           : ragged < 32 ? structure::kFirstLesion
                         : structure::kVenaCava;
  });
  const Edited smooth = applied(labels, flat(grid), Smooth{0, Smooth::Method::joint, 3e-3});
  QVERIFY(smooth.voxels_changed > 500);
  for (int k = 8; k < 27; ++k)
    for (int j = 8; j < 30; ++j)
      for (int i = 8; i < 39; ++i) QVERIFY(smooth.labels.voxels.at({i, j, k}) != structure::kBackground);
}

void EditShapeTest::WhatAVesselLosesInTheLiverIsParenchyma() {
  const VolumeGrid grid = cube_grid(60, 1.0);
  // A vessel of 4 mm radius runs out of the liver; a thread of it lies inside, another outside.
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) {
    const double r = std::hypot(v.y() - 30, v.z() - 30);
    const bool thread = v.y() == 30 && v.z() >= 30 && v.z() < 42 && (v.x() == 20 || v.x() == 50);
    if (r < 4.0 || thread) return structure::kPortalVein;
    return v.x() < 40 && r < 16.0 ? structure::kParenchyma : structure::kBackground;
  });
  const Edited opened =
      applied(labels, flat(grid), Smooth{structure::kPortalVein, Smooth::Method::opening, 2e-3});
  QCOMPARE(opened.labels.voxels.at({20, 30, 38}), structure::kParenchyma);
  QCOMPARE(opened.labels.voxels.at({50, 30, 38}), structure::kBackground);
  QCOMPARE(opened.labels.voxels.at({20, 30, 31}), structure::kPortalVein);
}

void EditShapeTest::GrowingHasTheDistance() {
  const VolumeGrid grid = cube_grid(80, 0.5);
  const auto ball = [&](const Eigen::Vector3i& v, double radius_mm) {
    return 0.5 * (v.cast<double>() - Eigen::Vector3d::Constant(39.5)).norm() < radius_mm;
  };
  const LabelMap labels = labels_of(
      grid, [&](const Eigen::Vector3i& v) { return ball(v, 10.0) ? structure::kFirstLesion : Label{0}; });
  for (const double distance : {4e-3, -4e-3}) {
    const Edited moved = applied(labels, flat(grid), Margin{structure::kFirstLesion, distance});
    const double radius = 10.0 + 1e3 * distance;
    const double volume = 0.125 * static_cast<double>(moved.labels.voxels.histogram().at(16));
    const double equal = std::cbrt(volume * 0.75 / M_PI);
    // Distances are those of centres: the surface of a set of voxels lies half a voxel beyond them.
    QVERIFY2(std::abs(equal - radius) < 0.25, qPrintable(QString::number(equal)));
  }
}

void EditShapeTest::ShrinkingWhatWasGrownContainsIt() {
  for (const VolumeGrid& grid : awkward_grids()) {
    LabelMap labels = labels_of(grid, [&](const Eigen::Vector3i& v) {
      const Eigen::Vector3d p = place_of(grid, v) - middle_of(grid);
      return p.cwiseQuotient(Eigen::Vector3d(9, 5, 12)).norm() < 1.0 && p.x() * p.y() < 8.0
                 ? structure::kGallbladder
                 : structure::kBackground;
    });
    const std::set<std::size_t> before = voxels_of(labels, structure::kGallbladder);
    const LabelMap more = applied(labels, flat(grid), Margin{structure::kGallbladder, 3.3e-3}).labels;
    const LabelMap back = applied(more, flat(grid), Margin{structure::kGallbladder, -3.3e-3}).labels;
    const std::set<std::size_t> grown = voxels_of(more, structure::kGallbladder),
                                after = voxels_of(back, structure::kGallbladder);
    QVERIFY(std::includes(grown.begin(), grown.end(), before.begin(), before.end()));
    QVERIFY(std::includes(after.begin(), after.end(), before.begin(), before.end()));
    QVERIFY(after.size() < 1.3 * before.size() && grown.size() > 1.5 * before.size());
  }
}

void EditShapeTest::TwoContrastedBoxesAreFoundDespiteNoise() {
  const TwoBoxes scene = two_boxes(10.0);
  const Edited grown =
      applied(scene.labels, scene.image,
              GrowFromSeeds{{structure::kGallbladder, structure::kParenchyma}, 60e-3, {Label{7}}});
  for (const Label label : {structure::kGallbladder, structure::kParenchyma}) {
    const std::set<std::size_t> found = voxels_of(grown.labels, label), truth = voxels_of(scene.truth, label);
    std::vector<std::size_t> both;
    std::set_intersection(found.begin(), found.end(), truth.begin(), truth.end(), std::back_inserter(both));
    const double dice =
        2.0 * static_cast<double>(both.size()) / static_cast<double>(found.size() + truth.size());
    QVERIFY2(dice > 0.97, qPrintable(QString("label %1: %2").arg(label).arg(dice)));
  }
  // What only competes has given back what it won.
  QCOMPARE(voxels_of(grown.labels, 7), voxels_of(scene.labels, 7));
}

void EditShapeTest::SeedsWinWhatTheyReachMostCheaply() {
  const TwoBoxes scene = two_boxes(4.0);
  const LabelMap grown = applied(scene.labels, scene.image, GrowFromSeeds{{1, 6, 7}, 90e-3, {}}).labels;
  const std::vector<double> a = path_costs(scene.labels, scene.image, 1),
                            b = path_costs(scene.labels, scene.image, 6),
                            c = path_costs(scene.labels, scene.image, 7);
  const std::vector<Label> dense = grown.voxels.dense();
  long compared = 0;
  for (std::size_t n = 0; n < dense.size(); ++n) {
    const std::array<double, 3> costs = {a[n], b[n], c[n]};
    std::array<double, 3> sorted = costs;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] == 0.0 || sorted[1] - sorted[0] < 0.5) continue;  // a seed, or a draw
    ++compared;
    const Label cheapest = sorted[0] == costs[0] ? Label{1} : sorted[0] == costs[1] ? Label{6} : Label{7};
    QCOMPARE(dense[n], cheapest);
  }
  QVERIFY2(compared > 0.9 * static_cast<double>(dense.size()), qPrintable(QString::number(compared)));
}

void EditShapeTest::GrowthKeepsWithinReachAndRegion() {
  const TwoBoxes scene = two_boxes(10.0);
  EditableRegion region;
  region.intensity = std::array<double, 2>{20.0, 150.0};
  const GrowFromSeeds tool{{structure::kGallbladder, structure::kParenchyma}, 7e-3, {}};
  const LabelMap grown = applied(scene.labels, scene.image, tool, region).labels;
  const VolumeGrid& g = scene.image.grid;
  Mask seeds(g.size, g.spacing_mm);
  const std::vector<Label> before = scene.labels.voxels.dense(), after = grown.voxels.dense();
  for (std::size_t n = 0; n < before.size(); ++n) seeds.voxels[n] = before[n] == 1 || before[n] == 6;
  const std::vector<float> distance2 = squared_distance_mm2(seeds);
  long changed = 0;
  for (std::size_t n = 0; n < after.size(); ++n) {
    if (after[n] == before[n]) continue;
    ++changed;
    QVERIFY(before[n] == 0 && distance2[n] <= 49.001F);
    QVERIFY((*scene.image.voxels)[n] >= 20 && (*scene.image.voxels)[n] <= 150);
  }
  QVERIFY(changed > 1000);
}

void EditShapeTest::NoToolTouchesWhatIsLocked() {
  const VolumeGrid grid = awkward_grids()[2];
  std::mt19937 random(12);
  const Image image =
      image_of(grid, [&](const Eigen::Vector3i&) { return static_cast<double>(random() % 100); });
  const LabelMap labels = small_anatomy(grid, 3);
  const Eigen::Vector3d p = p_at(grid, middle_of(grid));
  Points path(1, 3);
  path.row(0) = p.transpose();
  EditableRegion region;
  region.locked = {structure::kPortalVein, structure::kVenaCava};
  const std::vector<Tool> tools = {Paint{1, false, Paint::Brush::ball, 20e-3, 2, path},
                                   Paint{0, true, Paint::Brush::ball, 20e-3, 2, path},
                                   Threshold{1, 0, 60, true},
                                   LevelTracing{1, false, 1, p},
                                   LevelTracing{0, true, 2, p},
                                   FillHoles{16, true},
                                   Smooth{0, Smooth::Method::joint, 3e-3},
                                   Margin{16, 8e-3},
                                   Logical{16, Logical::Operation::fill, 0},
                                   Logical{1, Logical::Operation::invert, 0},
                                   GrowFromSeeds{{1, 3}, 9e-3, {structure::kPortalVein}}};
  int changing = 0;
  for (const Tool& tool : tools) {
    const Edited edited = applied(labels, image, tool, region);
    changing += edited.voxels_changed > 0;
    for (const Label locked : region.locked)
      QCOMPARE(voxels_of(edited.labels, locked), voxels_of(labels, locked));
  }
  QVERIFY(changing >= 9);
}

QTEST_APPLESS_MAIN(EditShapeTest)
#include "edit_shape_test.moc"
