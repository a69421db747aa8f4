// SPDX-License-Identifier: GPL-3.0-or-later
// The brightest of a slab about a slice.
#include <QElapsedTimer>
#include <QTest>

#include <Eigen/Geometry>

#include "glisson/ui/scene/slice_drawing.h"
#include "glisson/ui/scene/slice_picture.h"

namespace glisson {
namespace {

using scene::Plane;

constexpr std::array<Plane, 3> kPlanes = {Plane::axial, Plane::coronal, Plane::sagittal};

/// Dark, with a bright ball. Voxels of three different sides, the axes as `direction` has them.
Image phantom(const Eigen::Matrix3d& direction, const Eigen::Vector3d& ball, double radius) {
  Image image;
  image.grid.size = {40, 36, 32};
  image.grid.spacing_mm = {1.0, 1.25, 1.5};
  image.grid.direction = direction;
  image.grid.origin_mm =
      -direction *
      (0.5 * (image.grid.size.cast<double>().array() - 1.0) * image.grid.spacing_mm.array()).matrix();
  auto voxels = std::make_shared<std::vector<std::int16_t>>();
  for (int k = 0; k < image.grid.size.z(); ++k)
    for (int j = 0; j < image.grid.size.y(); ++j)
      for (int i = 0; i < image.grid.size.x(); ++i) {
        const Eigen::Vector3d p = image.grid.p_in_ct({double(i), double(j), double(k)}).xyz;
        voxels->push_back((p - ball).norm() <= radius ? 300 : -100);
      }
  image.voxels = voxels;
  return image;
}

int brightest(const Picture& picture) {
  return *std::max_element(picture.bytes->begin(), picture.bytes->end());
}

scene::SliceStyle slab(double metres) {
  scene::SliceStyle style;
  style.level = 100.0;
  style.width = 400.0;
  style.slab = metres;
  return style;
}

std::vector<Eigen::Matrix3d> directions() {
  Eigen::Matrix3d turned;
  turned << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  return {Eigen::Matrix3d::Identity(), turned,
          Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, 3).normalized()).matrix(),
          Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).matrix()};
}

}  // namespace

class SliceSlabTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatLiesWithinHalfTheThicknessIsSeen();
  void ASlabIsTheBrightestOfItsSlices();
  void ASlabThinnerThanAVoxelIsItsSlice();
  void ASlabLookingOutOfTheVolumeShowsWhatIsThere();
  void TheDrawingFollowsTheThickness();
  void LabelsStayThoseOfTheSlice();
  void MeasureOnACt();
};

void SliceSlabTest::WhatLiesWithinHalfTheThicknessIsSeen() {
  for (const Eigen::Matrix3d& direction : directions())
    for (const Plane plane : kPlanes)
      for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d off = side * 1e-2 * Eigen::Vector3d::Unit(scene::normal_axis(plane));
        const Image image = phantom(direction, off, 3.5e-3);
        const scene::SliceGeometry slice =
            scene::slice_geometry(image.grid, plane, Point<CtFrame>(0.0, 0.0, 0.0));
        QCOMPARE(brightest(scene::slice_picture(image, nullptr, slice, slab(0.0))), 0);
        QCOMPARE(brightest(scene::slice_picture(image, nullptr, slice, slab(8e-3))), 0);
        const Picture seen = scene::slice_picture(image, nullptr, slice, slab(22e-3));
        QCOMPARE(brightest(seen), 255);
        const Eigen::Vector2d there = slice.pixel_of(Point<CtFrame>(off));
        QVERIFY((*seen.bytes)[static_cast<std::size_t>(
                    3 * (std::lround(there.y()) * seen.width + std::lround(there.x())))] > 200);
      }
}

/// Where the slices are layers of voxels and pixels are voxels, there is nothing to interpolate.
void SliceSlabTest::ASlabIsTheBrightestOfItsSlices() {
  Image image;
  image.grid.size = {20, 18, 16};
  auto voxels = std::make_shared<std::vector<std::int16_t>>();
  for (long n = 0; n < image.grid.voxel_count(); ++n)
    voxels->push_back(static_cast<std::int16_t>((n * 7919) % 401 - 100));
  image.voxels = voxels;
  const Point<CtFrame> middle(0.008, 0.009, 0.007);
  for (const Plane plane : kPlanes) {
    const int axis = scene::normal_axis(plane);
    std::vector<std::uint8_t> expected;
    for (int layer = -3; layer <= 3; ++layer) {
      const Point<CtFrame> p(middle.xyz + 1e-3 * layer * Eigen::Vector3d::Unit(axis));
      const Picture one =
          scene::slice_picture(image, nullptr, scene::slice_geometry(image.grid, plane, p), slab(0.0));
      if (expected.empty()) expected.assign(one.bytes->size(), 0);
      for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = std::max(expected[i], (*one.bytes)[i]);
    }
    const scene::SliceGeometry slice = scene::slice_geometry(image.grid, plane, middle);
    QVERIFY(*scene::slice_picture(image, nullptr, slice, slab(6e-3)).bytes == expected);
    QVERIFY(*scene::slice_picture(image, nullptr, slice, slab(7.9e-3)).bytes == expected);
    QVERIFY(*scene::slice_picture(image, nullptr, slice, slab(8e-3)).bytes != expected);
  }
}

void SliceSlabTest::ASlabThinnerThanAVoxelIsItsSlice() {
  for (const Eigen::Matrix3d& direction : directions()) {
    const Image image = phantom(direction, Eigen::Vector3d::Zero(), 9e-3);
    for (const Plane plane : kPlanes) {
      const scene::SliceGeometry slice =
          scene::slice_geometry(image.grid, plane, Point<CtFrame>(0.0013, 0.0021, 0.0033));
      const Picture alone = scene::slice_picture(image, nullptr, slice, slab(0.0)),
                    thin = scene::slice_picture(image, nullptr, slice, slab(1e-6));
      for (std::size_t i = 0; i < alone.bytes->size(); ++i)
        QVERIFY(std::abs(int((*alone.bytes)[i]) - int((*thin.bytes)[i])) <= 1);  // single precision
    }
  }
}

void SliceSlabTest::ASlabLookingOutOfTheVolumeShowsWhatIsThere() {
  for (const Eigen::Matrix3d& direction : directions()) {
    const Image image = phantom(direction, Eigen::Vector3d::Zero(), 1.0);  // bright all over
    const scene::VolumeBox box = scene::bounding_box(image.grid);
    for (const Plane plane : kPlanes) {
      const scene::SliceGeometry slice = scene::slice_geometry(image.grid, plane, Point<CtFrame>(box.high));
      QVERIFY(*scene::slice_picture(image, nullptr, slice, slab(0.1)).bytes ==
              *scene::slice_picture(image, nullptr, slice, slab(0.0)).bytes);
    }
  }
}

void SliceSlabTest::TheDrawingFollowsTheThickness() {
  const auto image = std::make_shared<const Image>(phantom(Eigen::Matrix3d::Identity(), {0, 0, 8e-3}, 2e-3));
  const scene::SliceGeometry slice =
      scene::slice_geometry(image->grid, Plane::axial, Point<CtFrame>(0.0, 0.0, 0.0));
  scene::SliceDrawing drawing;
  drawing.draw(image, nullptr, slice, slab(0.0));
  QCOMPARE(brightest(drawing.picture()), 0);
  QVERIFY(!drawing.draw(image, nullptr, slice, slab(2e-2)).isEmpty());
  QCOMPARE(brightest(drawing.picture()), 255);
  QVERIFY(drawing.draw(image, nullptr, slice, slab(2e-2)).isEmpty());
  drawing.draw(image, nullptr, slice, slab(0.0));
  QCOMPARE(brightest(drawing.picture()), 0);
}

void SliceSlabTest::LabelsStayThoseOfTheSlice() {
  const Image image = phantom(Eigen::Matrix3d::Identity(), {0, 0, 8e-3}, 2e-3);
  LabelVolume labels(image.grid);
  const Eigen::Vector3i beside =
      image.grid.index_of(Point<CtFrame>(0, 0, 8e-3)).array().round().cast<int>().matrix();
  labels.set(beside, 5);
  const scene::SliceGeometry slice =
      scene::slice_geometry(image.grid, Plane::axial, Point<CtFrame>(0.0, 0.0, 0.0));
  QVERIFY(*scene::slice_picture(image, &labels, slice, slab(2e-2)).bytes ==
          *scene::slice_picture(image, nullptr, slice, slab(2e-2)).bytes);
}

/// Prints what a slice costs at the size of a CT; asserts no time.
void SliceSlabTest::MeasureOnACt() {
  if (!qEnvironmentVariableIsSet("GLISSON_MEASURE")) QSKIP("set GLISSON_MEASURE to see the times");
  auto image = std::make_shared<Image>();
  image->grid.size = {512, 512, 129};
  image->grid.spacing_mm = {0.7, 0.7, 2.5};
  auto voxels =
      std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(image->grid.voxel_count()));
  for (std::size_t i = 0; i < voxels->size(); ++i) (*voxels)[i] = static_cast<std::int16_t>((i * 7919) % 400);
  image->voxels = voxels;
  for (const double askew : {0.0, 0.1}) {
    image->grid.direction = Eigen::AngleAxisd(askew, Eigen::Vector3d::UnitX()).matrix();
    const std::shared_ptr<const Image> shared = std::make_shared<const Image>(*image);
    const scene::VolumeBox box = scene::bounding_box(image->grid);
    for (const Plane plane : kPlanes)
      for (const double thickness : {0.0, 1e-2, 3e-2, 0.1}) {
        scene::SliceDrawing drawing;
        QElapsedTimer clock;
        clock.start();
        constexpr int kSlices = 10;
        for (int n = 0; n < kSlices; ++n) {
          const double share = 0.4 + 0.02 * n;
          const Point<CtFrame> p((1.0 - share) * box.low + share * box.high);
          drawing.draw(shared, nullptr, scene::slice_geometry(image->grid, plane, p), slab(thickness));
        }
        qInfo("turned by %.1f, plane %d, slab of %3.0f mm: %.1f ms a slice", askew, static_cast<int>(plane),
              1e3 * thickness, 1e-6 * static_cast<double>(clock.nsecsElapsed()) / kSlices);
      }
  }
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::SliceSlabTest)
#include "slice_slab_test.moc"
