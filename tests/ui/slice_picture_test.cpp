// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <Eigen/LU>

#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "glisson/ui/scene/ellipsoid_mark.h"
#include "glisson/ui/scene/slice_picture.h"

namespace glisson {
namespace {

using scene::Plane;

/// A bright voxel-sized blob at one place of the patient, in a volume whose axes are permuted and flipped.
Image phantom(const Eigen::Matrix3d& direction, const Point<CtFrame>& bright) {
  Image image;
  image.grid.size = {30, 26, 22};
  image.grid.spacing_mm = {1.0, 1.5, 2.0};
  image.grid.direction = direction;
  // The middle of the volume at the same place of the patient whatever the axes are.
  image.grid.origin_mm =
      Eigen::Vector3d(10, -20, 30) -
      direction *
          (0.5 * (image.grid.size.cast<double>().array() - 1.0) * image.grid.spacing_mm.array()).matrix();
  auto voxels = std::make_shared<std::vector<std::int16_t>>(
      static_cast<std::size_t>(image.grid.voxel_count()), std::int16_t{-100});
  const Eigen::Vector3i at = image.grid.index_of(bright).array().round().cast<int>().matrix();
  // A place outside the volume is the test's own mistake: say so instead of writing past the voxels.
  voxels->at(static_cast<std::size_t>(image.grid.offset(at))) = 300;
  image.voxels = voxels;
  return image;
}

std::vector<Eigen::Matrix3d> all_directions() {
  std::vector<Eigen::Matrix3d> found;
  static constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (const auto& order : kOrders)
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
      for (int k = 0; k < 3; ++k) m(order[k], k) = ((signs >> k) & 1) != 0 ? -1.0 : 1.0;
      found.push_back(m);
    }
  return found;
}

Eigen::Vector2d brightest(const Picture& picture) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < picture.bytes->size(); i += 3)
    if ((*picture.bytes)[i] > (*picture.bytes)[best]) best = i;
  const auto pixel = static_cast<int>(best / 3);
  return {pixel % picture.width, pixel / picture.width};
}

}  // namespace

class SlicePictureTest : public QObject {
  Q_OBJECT
 private slots:
  void PatientsRightIsOnTheLeftForEveryAxisOrder();
  void SagittalShowsAnteriorOnTheLeft();
  void PixelAndPointAreInverse();
  void WindowMapsLevelToMiddleGrey();
  void LabelsAreOutlinedInTheirColour();
  void ProbeReadsWhatIsThere();
  void AnEllipsoidIsCutWhereTheSliceMeetsIt();
  void CoordinatesCarryAnatomicalLetters();
  void BadWindowIsRefused();
  void EmptyVolumeIsRefused();
};

void SlicePictureTest::PatientsRightIsOnTheLeftForEveryAxisOrder() {
  // LPS: right of the middle (x = 10 mm) is smaller x, anterior of -20 is smaller y, superior of 30 is larger
  // z.
  const Point<CtFrame> bright(0.004, -0.026, 0.037);
  for (const Eigen::Matrix3d& direction : all_directions()) {
    const Image image = phantom(direction, bright);
    const Eigen::Vector3i voxel = image.grid.index_of(bright).array().round().cast<int>().matrix();
    const Point<CtFrame> there = image.grid.p_in_ct(voxel.cast<double>());
    const scene::SliceGeometry axial = scene::slice_geometry(image.grid, Plane::axial, there);
    const Picture picture = scene::slice_picture(image, nullptr, axial, {});
    const Eigen::Vector2d seen = brightest(picture);
    QVERIFY2(seen.x() < 0.5 * picture.width, "the patient's right must be on the left");
    QVERIFY2(seen.y() < 0.5 * picture.height, "anterior must be on top");
    QVERIFY((seen - axial.pixel_of(there)).norm() < 1.0);
    const scene::SliceGeometry coronal = scene::slice_geometry(image.grid, Plane::coronal, there);
    const Eigen::Vector2d front = brightest(scene::slice_picture(image, nullptr, coronal, {}));
    QVERIFY2(front.x() < 0.5 * coronal.width && front.y() < 0.5 * coronal.height, "superior must be on top");
  }
  QCOMPARE(scene::edge_letters(Plane::axial).left, 'R');
  QCOMPARE(scene::edge_letters(Plane::axial).top, 'A');
  QCOMPARE(scene::edge_letters(Plane::coronal).top, 'S');
}

void SlicePictureTest::SagittalShowsAnteriorOnTheLeft() {
  const Point<CtFrame> bright(0.004, -0.026, 0.037);
  for (const Eigen::Matrix3d& direction : all_directions()) {
    const Image image = phantom(direction, bright);
    const Eigen::Vector3i voxel = image.grid.index_of(bright).array().round().cast<int>().matrix();
    const scene::SliceGeometry slice =
        scene::slice_geometry(image.grid, Plane::sagittal, image.grid.p_in_ct(voxel.cast<double>()));
    const Eigen::Vector2d seen = brightest(scene::slice_picture(image, nullptr, slice, {}));
    QVERIFY(seen.x() < 0.5 * slice.width && seen.y() < 0.5 * slice.height);
  }
  QCOMPARE(scene::edge_letters(Plane::sagittal).left, 'A');
  QCOMPARE(scene::edge_letters(Plane::sagittal).right, 'P');
}

void SlicePictureTest::PixelAndPointAreInverse() {
  const Image image = phantom(all_directions()[13], Point<CtFrame>(0.01, -0.02, 0.03));
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    const scene::SliceGeometry slice =
        scene::slice_geometry(image.grid, plane, Point<CtFrame>(0.012, -0.02, 0.03));
    const Eigen::Vector2d pixel(7.25, 3.5);
    QVERIFY((slice.pixel_of(slice.p_in_ct(pixel)) - pixel).norm() < 1e-9);
    QVERIFY(std::abs(slice.distance_of(slice.p_in_ct(pixel))) < 1e-12);
    QVERIFY(std::abs(slice.right.norm() - 1e-3) < 1e-12);  // square pixels of the finest spacing
  }
}

void SlicePictureTest::WindowMapsLevelToMiddleGrey() {
  Image image = phantom(Eigen::Matrix3d::Identity(), Point<CtFrame>(0.01, -0.02, 0.03));
  image.voxels = std::make_shared<std::vector<std::int16_t>>(
      static_cast<std::size_t>(image.grid.voxel_count()), std::int16_t{50});
  const scene::SliceGeometry slice =
      scene::slice_geometry(image.grid, Plane::axial, Point<CtFrame>(0.01, -0.02, 0.03));
  scene::SliceStyle style;
  style.level = 50;
  style.width = 100;
  QCOMPARE(int((*scene::slice_picture(image, nullptr, slice, style).bytes)[0]), 127);
  style.level = 0;
  QCOMPARE(int((*scene::slice_picture(image, nullptr, slice, style).bytes)[0]), 255);
  style.level = 100;
  QCOMPARE(int((*scene::slice_picture(image, nullptr, slice, style).bytes)[0]), 0);
}

void SlicePictureTest::LabelsAreOutlinedInTheirColour() {
  const Image image = phantom(Eigen::Matrix3d::Identity(), Point<CtFrame>(0.01, -0.02, 0.03));
  LabelVolume labels(image.grid);
  for (int j = 5; j < 15; ++j)
    for (int i = 5; i < 15; ++i) labels.set({i, j, 10}, structure::kPortalVein);
  const Point<CtFrame> middle = image.grid.p_in_ct({10, 10, 10});
  const scene::SliceGeometry slice = scene::slice_geometry(image.grid, Plane::axial, middle);
  const Picture picture = scene::slice_picture(image, &labels, slice, {});
  const auto pixel = [&](const Eigen::Vector3d& index) {
    const Eigen::Vector2d p = slice.pixel_of(image.grid.p_in_ct(index));
    return static_cast<std::size_t>(3 * (std::lround(p.y()) * picture.width + std::lround(p.x())));
  };
  const auto colour = structure_colour(structure::kPortalVein);
  const std::size_t edge = pixel({5, 10, 10}), inside = pixel({10, 10, 10}), outside = pixel({2, 10, 10});
  QVERIFY(std::abs((*picture.bytes)[edge] - 255 * colour[2]) < 20);
  QVERIFY((*picture.bytes)[inside] < (*picture.bytes)[edge]);
  QVERIFY((*picture.bytes)[inside] > (*picture.bytes)[outside]);
}

void SlicePictureTest::ProbeReadsWhatIsThere() {
  const Point<CtFrame> bright(0.004, -0.026, 0.037);
  for (const Eigen::Matrix3d& direction : all_directions()) {
    const Image image = phantom(direction, bright);
    LabelVolume labels(image.grid);
    labels.set(image.grid.index_of(bright).array().round().cast<int>().matrix(), structure::kVenaCava);
    const scene::Probe here = scene::probe(image, &labels, bright);
    QVERIFY(here.inside);
    QCOMPARE(here.value, 300.0);
    QCOMPARE(here.label, structure::kVenaCava);
    QCOMPARE(scene::probe(image, nullptr, Point<CtFrame>(0.012, -0.02, 0.03)).value, -100.0);
    QVERIFY(!scene::probe(image, &labels, Point<CtFrame>(1.0, 0.0, 0.0)).inside);
  }
}

void SlicePictureTest::CoordinatesCarryAnatomicalLetters() {
  QCOMPARE(scene::anatomical_coordinate(0, 0.0123), std::string("L 12.3"));
  QCOMPARE(scene::anatomical_coordinate(0, -0.0123), std::string("R 12.3"));
  QCOMPARE(scene::anatomical_coordinate(1, -0.04), std::string("A 40.0"));
  QCOMPARE(scene::anatomical_coordinate(1, 0.04), std::string("P 40.0"));
  QCOMPARE(scene::anatomical_coordinate(2, 0.2), std::string("S 200.0"));
  QCOMPARE(scene::anatomical_coordinate(2, -0.2), std::string("I 200.0"));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::anatomical_coordinate(3, 0.0));
}

void SlicePictureTest::AnEllipsoidIsCutWhereTheSliceMeetsIt() {
  const Image image = phantom(Eigen::Matrix3d::Identity(), Point<CtFrame>(0.01, -0.02, 0.03));
  scene::EllipsoidMark mark;
  mark.p = {0.01, -0.02, 0.03};
  Eigen::Matrix3d root;
  root << 3e-3, 0, 0, 1e-3, 2e-3, 0, -2e-3, 1e-3, 4e-3;
  mark.covariance = root * root.transpose();
  mark.distance2 = 7.8;
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    const scene::SliceGeometry slice =
        scene::slice_geometry(image.grid, plane, Point<CtFrame>(0.012, -0.018, 0.033));
    const Points line = scene::cut(mark, slice);
    QVERIFY(line.rows() > 20);
    for (Eigen::Index k = 0; k < line.rows(); ++k) {
      const Eigen::Vector3d p = line.row(k).transpose();
      QVERIFY(std::abs(slice.distance_of(Point<CtFrame>(p))) < 1e-9);
      const Eigen::Vector3d off = p - mark.p;
      QVERIFY(std::abs(off.dot(mark.covariance.inverse() * off) - mark.distance2) < 1e-6);
    }
  }
  mark.p.z() += 0.03;
  QCOMPARE(
      scene::cut(mark, scene::slice_geometry(image.grid, Plane::axial, Point<CtFrame>(0.01, -0.02, 0.03)))
          .rows(),
      0);
}

void SlicePictureTest::BadWindowIsRefused() {
  const Image image = phantom(Eigen::Matrix3d::Identity(), Point<CtFrame>(0.01, -0.02, 0.03));
  const scene::SliceGeometry slice =
      scene::slice_geometry(image.grid, Plane::axial, Point<CtFrame>(0.01, -0.02, 0.03));
  QVERIFY_THROWS_EXCEPTION(InputError, scene::slice_picture(image, nullptr, slice, {40.0, 0.0, 0.3}));
}

void SlicePictureTest::EmptyVolumeIsRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           scene::slice_geometry(VolumeGrid(), Plane::axial, Point<CtFrame>()));
  QVERIFY_THROWS_EXCEPTION(PreconditionError,
                           scene::slice_picture(Image(), nullptr, scene::SliceGeometry(), {}));
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::SlicePictureTest)
#include "slice_picture_test.moc"
