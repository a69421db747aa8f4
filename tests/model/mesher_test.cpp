// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher.h"

#include <Eigen/Geometry>
#include <QTest>

using namespace glisson;
using model::ScalarField;

namespace {

/// A cuboid of voxels about a place, as a field without much smoothing.
ScalarField cuboid(const VolumeGrid& grid, const Eigen::Vector3i& low, const Eigen::Vector3i& size) {
  std::vector<std::uint8_t> mask(static_cast<std::size_t>(grid.voxel_count()), 0);
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i)
        mask[static_cast<std::size_t>(grid.offset(low + Eigen::Vector3i(i, j, k)))] = 1;
  return model::field_of_mask(grid, mask, 0.5);
}

}  // namespace

class MesherTest : public QObject {
  Q_OBJECT
 private slots:
  void ALesionOfThickSlicesIsFilledToItsEnds();
  void AFieldOfAPartIsThatOfTheWhole();
};

void MesherTest::ALesionOfThickSlicesIsFilledToItsEnds() {
  // Three slices of 8 mm: the lesion's ends lie 4 mm beyond the middles of the outer ones.
  VolumeGrid grid;
  grid.size = {60, 60, 12};
  grid.spacing_mm = {1.0, 1.0, 8.0};
  model::MesherInput input;
  input.body = cuboid(grid, {5, 5, 1}, {50, 50, 10});
  input.inclusions.emplace_back(Label{16}, cuboid(grid, {22, 22, 4}, {16, 16, 3}));
  const auto mesh = model::fill_with_tetrahedra(input, {0.012, {0.008}, 0.012}, 0, RunContext());
  double low = 1.0, high = 0.0;
  for (int t = 0; t < mesh->tetrahedron_count(); ++t) {
    if (mesh->labels[static_cast<std::size_t>(t)] != 16) continue;
    for (int k = 0; k < 4; ++k) {
      low = std::min(low, mesh->vertices(mesh->tetrahedra(t, k), 2));
      high = std::max(high, mesh->vertices(mesh->tetrahedra(t, k), 2));
    }
  }
  const double length_mm = 1e3 * (high - low);
  QVERIFY2(std::abs(length_mm - 24.0) < 1.0, qPrintable(QString::number(length_mm)));
}

/// To the bit, or lesions would be meshed otherwise than before.
void MesherTest::AFieldOfAPartIsThatOfTheWhole() {
  VolumeGrid grid;
  grid.size = {40, 30, 20};
  grid.spacing_mm = {0.7, 0.9, 2.5};
  grid.origin_mm = {-101.3, 33.7, -912.1};
  grid.direction = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Vector3i low(31, 0, 15), size(9, 7, 4);  // it ends on two sides of the volume
  const ScalarField whole = cuboid(grid, low, size);
  for (const int beside : {0, 3}) {  // how much more the part holds
    const Eigen::Vector3i from = low - Eigen::Vector3i(beside, 0, beside);
    Mask part(size + Eigen::Vector3i(beside, beside, beside), grid.spacing_mm);
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i) part.voxels[part.offset(beside + i, j, beside + k)] = 1;
    const ScalarField field = model::field_of_mask(grid, part, from, 0.5);
    QVERIFY(field.values() == whole.values());
    QVERIFY(field.grid().size == whole.grid().size);
    QVERIFY(field.grid().origin_mm == whole.grid().origin_mm);
  }
}

QTEST_APPLESS_MAIN(MesherTest)
#include "mesher_test.moc"
