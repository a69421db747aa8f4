// SPDX-License-Identifier: GPL-3.0-or-later
// All labels evened at once: each keeps its volume and its thin branches, and what is rough gets even.
#include <QTest>

#include "edit_applied.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;

namespace {

constexpr double kRadius = 3e-3;
constexpr Label kSmallLesion = structure::kFirstLesion + 1;

/// A vessel from one place to another, millimetres from the middle of the phantom.
struct Piece {
  Label label;
  Eigen::Vector3d from, to;
  double radius_mm;
};

/// Two trees that come down to 1 mm: trunks, and branches that leave them.
std::vector<Piece> trees() {
  std::vector<Piece> pieces = {{structure::kPortalVein, {-26, -6, 0}, {26, -6, 0}, 4.5},
                               {structure::kHepaticVeins, {-24, 10, 6}, {24, 10, 6}, 4.0}};
  for (int n = 0; n < 5; ++n) {
    const double x = -20.0 + 10.0 * n, radius = 1.0 + 0.3 * n;
    pieces.push_back({structure::kPortalVein, {x, -6, 0}, {x + 3.0, -21, 4.0 - 2.0 * n}, radius});
    pieces.push_back({structure::kHepaticVeins, {x, 10, 6}, {x - 2.0, 21, -8.0 + 2.0 * n}, radius});
  }
  return pieces;
}

double distance_to(const Piece& piece, const Eigen::Vector3d& p) {
  const Eigen::Vector3d along = piece.to - piece.from;
  const double t = std::clamp((p - piece.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - piece.from - t * along).norm();
}

/// Much larger than the phantom, so that what is worked on is a box in it.
VolumeGrid phantom_grid() {
  VolumeGrid grid;
  grid.size = {140, 120, 72};
  grid.spacing_mm = {0.7, 0.7, 1.0};
  return grid;
}

/// The phantom's middle, which is not the volume's, in voxels.
const Eigen::Vector3d kMiddle(77.5, 53.5, 40.5);

/// Beyond it there is background, millimetres from the middle.
const Eigen::Array3d kReach(36.0, 29.0, 20.0);

Eigen::Vector3d from_middle(const VolumeGrid& grid, const Eigen::Vector3i& v) {
  return (v.cast<double>() - kMiddle).cwiseProduct(grid.spacing_mm);
}

/// A liver with two trees, a large and a small lesion, and the gallbladder beside it. @param rough share of
/// the voxels at a border that have the label of the other side.
LabelMap phantom(double rough) {
  const VolumeGrid grid = phantom_grid();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  const std::vector<Piece> pieces = trees();
  const auto label_at = [&](const Eigen::Vector3d& p) -> Label {
    if ((p.array().abs() > kReach).any()) return structure::kBackground;
    for (const Piece& piece : pieces)
      if (distance_to(piece, p) < piece.radius_mm) return piece.label;
    if ((p - Eigen::Vector3d(14, 2, -9)).norm() < 7.0) return structure::kFirstLesion;
    if ((p - Eigen::Vector3d(-16, 0, -9)).norm() < 2.5) return kSmallLesion;
    if (p.cwiseQuotient(Eigen::Vector3d(31, 25, 17)).norm() < 1.0) return structure::kParenchyma;
    return (p - Eigen::Vector3d(27, -20, 0)).norm() < 7.0 ? structure::kGallbladder : structure::kBackground;
  };
  return labels_of(grid, [&](const Eigen::Vector3i& v) {
    const Eigen::Vector3d p = from_middle(grid, v);
    const Label label = label_at(p);
    if (chance(random) >= rough) return label;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-1.0, 1.0}) {
        const Label other = label_at(p + side * grid.spacing_mm[axis] * Eigen::Vector3d::Unit(axis));
        if (other != label) return other;
      }
    return label;
  });
}

/// Voxels' faces between a label and another one.
long border_of(const LabelMap& labels, Label label) {
  const VolumeGrid& grid = labels.voxels.grid();
  long faces = 0;
  for (int k = 1; k < grid.size.z(); ++k)
    for (int j = 1; j < grid.size.y(); ++j)
      for (int i = 1; i < grid.size.x(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
          const bool here = labels.voxels.at({i, j, k}) == label,
                     there =
                         labels.voxels.at(Eigen::Vector3i(i, j, k) - Eigen::Vector3i::Unit(axis)) == label;
          faces += here != there;
        }
  return faces;
}

const std::vector<Label> kAll = {structure::kParenchyma,  structure::kPortalVein, structure::kHepaticVeins,
                                 structure::kFirstLesion, kSmallLesion,           structure::kGallbladder};

Edited smoothed(const LabelMap& labels, const Image& image, const EditableRegion& region = {}) {
  return applied(labels, image, Smooth{0, Smooth::Method::joint, kRadius}, region);
}
Edited smoothed(const LabelMap& labels) { return smoothed(labels, noisy(labels.voxels.grid(), 1)); }

}  // namespace

class JointSmoothingTest : public QObject {
  Q_OBJECT
 private slots:
  void EachStructureKeepsItsVolume_data();
  void EachStructureKeepsItsVolume();
  void ThinBranchesStay_data() { EachStructureKeepsItsVolume_data(); }
  void ThinBranchesStay();
  void WhatIsRoughGetsEven();
  void VolumesAreKeptWhereOnlyAPartMayChange();
  void WhatIsEvenStays();
  void ItDoesTheSameEachTime();
};

void JointSmoothingTest::EachStructureKeepsItsVolume_data() {
  QTest::addColumn<double>("rough");
  QTest::newRow("even") << 0.0;
  QTest::newRow("rough") << 0.3;
}

void JointSmoothingTest::EachStructureKeepsItsVolume() {
  QFETCH(double, rough);
  const LabelMap before = phantom(rough), after = smoothed(before).labels;
  for (const Label label : kAll) {
    const double was = ml_of(before, label), is = ml_of(after, label);
    QVERIFY2(std::abs(is - was) <= 0.02 * was,
             qPrintable(QStringLiteral("%1: %2 to %3 ml").arg(label).arg(was).arg(is)));
  }
}

void JointSmoothingTest::ThinBranchesStay() {
  QFETCH(double, rough);
  const LabelMap before = phantom(rough), after = smoothed(before).labels;
  const VolumeGrid& grid = before.voxels.grid();
  for (const Piece& piece : trees()) {
    long was = 0, is = 0;
    const Eigen::Vector3d way = piece.to - piece.from;
    for (double t = 0.0; t < way.norm() - 1.0; t += 0.5) {
      const Eigen::Vector3d p = piece.from + t * way.normalized();
      const Eigen::Vector3d index = p.cwiseQuotient(grid.spacing_mm) + kMiddle;
      const Eigen::Vector3i v = index.array().round().cast<int>().matrix();
      was += before.voxels.at(v) == piece.label;
      is += after.voxels.at(v) == piece.label;
    }
    QVERIFY2(is >= 0.95 * was, qPrintable(QStringLiteral("%1, radius %2 mm: %3 of %4 places of its axis")
                                              .arg(piece.label)
                                              .arg(piece.radius_mm)
                                              .arg(is)
                                              .arg(was)));
  }
}

void JointSmoothingTest::WhatIsRoughGetsEven() {
  const LabelMap even = phantom(0.0), before = phantom(0.3), after = smoothed(before).labels;
  for (const Label label : {structure::kParenchyma, structure::kFirstLesion, structure::kGallbladder}) {
    const long stairs = border_of(even, label);  // that the finest voxels have, too
    const long rough = border_of(before, label) - stairs, is = border_of(after, label) - stairs;
    QVERIFY2(is < 0.3 * rough,
             qPrintable(QStringLiteral("%1: %2 of %3 faces more").arg(label).arg(is).arg(rough)));
  }
  // The voxels are nearer to those that were roughened.
  const auto unlike = [&](const LabelMap& labels) {
    const std::vector<Label> a = labels.voxels.dense(), b = even.voxels.dense();
    long count = 0;
    for (std::size_t n = 0; n < a.size(); ++n) count += a[n] != b[n];
    return count;
  };
  QVERIFY2(unlike(after) < 0.6 * unlike(before),
           qPrintable(QStringLiteral("%1 of %2").arg(unlike(after)).arg(unlike(before))));
}

void JointSmoothingTest::VolumesAreKeptWhereOnlyAPartMayChange() {
  const LabelMap before = phantom(0.3);
  EditableRegion region;
  region.locked = {structure::kFirstLesion, structure::kHepaticVeins};
  region.intensity = {0.0, 1000.0};
  // Askew through the phantom: where voxels are counted from shows in each axis.
  const int plane = static_cast<int>(kMiddle.sum()) - 20;
  const VolumeGrid& grid = before.voxels.grid();
  const Image image = image_of(grid, [&](const Eigen::Vector3i& v) { return v.sum() - plane; });
  const VoxelBox box =
      bounding_box(grid.size, grid.spacing_mm,
                   before.voxels.mask([](Label l) { return l != structure::kBackground; }), 2e3 * kRadius);
  QVERIFY((box.low.array() > 0).all() && (box.high.array() < grid.size.array()).all());
  const Edited edited = smoothed(before, image, region);
  QVERIFY(edited.voxels_changed > 500);
  for (const Label label : kAll)
    QVERIFY(std::abs(ml_of(edited.labels, label) - ml_of(before, label)) <= 0.02 * ml_of(before, label));
  const std::vector<Label> was = before.voxels.dense(), is = edited.labels.voxels.dense();
  int nearest = 1000;
  for (std::size_t n = 0; n < was.size(); ++n) {
    if (was[n] == is[n]) continue;
    for (const Label locked : region.locked) QVERIFY(was[n] != locked && is[n] != locked);
    nearest = std::min(nearest, static_cast<int>((*image.voxels)[n]));
  }
  QVERIFY2(nearest >= 0 && nearest < 3, qPrintable(QString::number(nearest)));
}

void JointSmoothingTest::WhatIsEvenStays() {
  // A wall between two labels.
  const VolumeGrid grid = fine_grid(1.0);
  const LabelMap labels = labels_of(grid, [](const Eigen::Vector3i& v) {
    return v.x() < 20 ? structure::kParenchyma : structure::kBackground;
  });
  QCOMPARE(smoothed(labels).voxels_changed, 0L);
}

void JointSmoothingTest::ItDoesTheSameEachTime() {
  const LabelMap before = phantom(0.3);
  QVERIFY(smoothed(before).labels.voxels == smoothed(before).labels.voxels);
}

QTEST_APPLESS_MAIN(JointSmoothingTest)
#include "joint_smoothing_test.moc"
