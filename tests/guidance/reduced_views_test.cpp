// SPDX-License-Identifier: GPL-3.0-or-later
// Large pictures are followed as small ones are: the same rays, the same organ.
#include "reduced_views.h"

#include <QTest>

#include "filmed_phantom.h"
#include "glisson/core/error.h"
#include "glisson/guidance/place_picker.h"
#include "glisson/guidance/tracker.h"

using namespace glisson;
using namespace glisson::guidance;

namespace {

Camera camera_of(int width, int height) {
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.matrix << 0.8 * width, 0.0, 0.49 * width, 0.0, 0.81 * width, 0.52 * height, 0.0, 0.0, 1.0;
  camera.distortion << -0.11, 0.03, 6e-4, -4e-4, 0.0;
  return camera;
}

StereoRig rig_of(int width, int height) {
  StereoRig rig = phantom::rig();
  rig.left = rig.right = camera_of(width, height);
  return rig;
}

/// Each value from its place and channel.
template <class Value>
Picture drawn(int width, int height, int channels, const Value& value) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) bytes->push_back(static_cast<std::uint8_t>(value(x, y, c)));
  return {width, height, channels, bytes};
}

int value_at(const Picture& picture, int x, int y, int channel = 0) {
  return (*picture.bytes)[static_cast<std::size_t>((y * picture.width + x) * picture.channels + channel)];
}

/// Every pixel becomes four.
Picture doubled(const Picture& small) {
  return drawn(2 * small.width, 2 * small.height, small.channels,
               [&](int x, int y, int c) { return value_at(small, x / 2, y / 2, c); });
}

/// The lens of `small` before a chip of twice as many pixels a side.
Camera doubled(Camera small) {
  small.width *= 2;
  small.height *= 2;
  small.matrix(0, 0) *= 2.0;
  small.matrix(1, 1) *= 2.0;
  small.matrix(0, 2) = 2.0 * small.matrix(0, 2) + 0.5;
  small.matrix(1, 2) = 2.0 * small.matrix(1, 2) + 0.5;
  return small;
}

}  // namespace

class ReducedViewsTest : public QObject {
  Q_OBJECT
 private slots:
  void BothViewsAreReducedByTheSameNumber();
  void APixelIsTheMeanOfThoseItStandsFor();
  void AMaskedPixelMasksWhatStandsForIt();
  void AViewOfAnotherSizeIsLeftOut();
  void UsualViewsStayAsTheyAre();
  void TheOrganIsFollowedAsInTheSmallerPicture();
};

void ReducedViewsTest::BothViewsAreReducedByTheSameNumber() {
  const StereoRig whole = rig_of(1920, 1080), small = ReducedViews(whole).rig();
  QCOMPARE(small.left.width, 960);
  QCOMPARE(small.right.height, 540);
  QVERIFY(small.left.matrix == reduced(whole.left, 2).matrix);
  QVERIFY(small.right.matrix == reduced(whole.right, 2).matrix);
  QVERIFY(small.right_from_left.translation == whole.right_from_left.translation);
}

void ReducedViewsTest::APixelIsTheMeanOfThoseItStandsFor() {
  const ReducedViews views(rig_of(1920, 8));
  const auto value = [](int x, int y, int c) { return (7 * x + 31 * y + 50 * c) % 251; };
  for (const int channels : {1, 3}) {
    const Picture large = drawn(1920, 8, channels, value);
    const StereoFrame small = views.reduced({large, large, 4, 0.5});
    QCOMPARE(small.left.width, 960);
    QCOMPARE(small.right.height, 4);
    QCOMPARE(small.left.channels, channels);
    QCOMPARE(small.index, 4);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 960; ++x)
        for (int c = 0; c < channels; ++c) {
          const int sum = value(2 * x, 2 * y, c) + value(2 * x + 1, 2 * y, c) + value(2 * x, 2 * y + 1, c) +
                          value(2 * x + 1, 2 * y + 1, c);
          QVERIFY(std::abs(value_at(small.left, x, y, c) - 0.25 * sum) <= 0.5);
        }
  }
}

void ReducedViewsTest::AMaskedPixelMasksWhatStandsForIt() {
  const ReducedViews views(rig_of(1920, 8));
  const Picture mask = drawn(1920, 8, 1, [](int x, int y, int) { return x == 101 && y == 5 ? 255 : 0; });
  const Picture small = views.reduced_mask(mask);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 960; ++x) QCOMPARE(value_at(small, x, y) != 0, x == 50 && y == 2);
  const auto masked = views.reduced(std::make_shared<PictureMask>(PictureMask{mask, 7, 0.25}));
  QVERIFY(masked && masked->index == 7 && masked->seconds == 0.25);
  QCOMPARE(*masked->not_liver.bytes, *small.bytes);
  QVERIFY(views.reduced_mask({}).empty());
}

void ReducedViewsTest::AViewOfAnotherSizeIsLeftOut() {
  const ReducedViews views(rig_of(1920, 8));
  const auto grey = [](int width) { return drawn(width, 8, 1, [](int, int, int) { return 90; }); };
  // As wide as what is followed, but not what the calibration is of.
  const StereoFrame frame = views.reduced({grey(960), grey(1920), 1, 0.0});
  QVERIFY(frame.left.empty() && !frame.right.empty());
  QVERIFY_THROWS_EXCEPTION(InputError, views.require_frame({grey(960), grey(1920), 1, 0.0}));
  QVERIFY_THROWS_EXCEPTION(InputError, views.reduced_mask(grey(960)));
  QVERIFY(!views.reduced(std::make_shared<PictureMask>(PictureMask{grey(960), 1, 0.0})));
}

void ReducedViewsTest::UsualViewsStayAsTheyAre() {
  const ReducedViews views(rig_of(1280, 8));
  const Picture grey = drawn(1280, 8, 1, [](int, int, int) { return 90; });
  const StereoFrame frame = views.reduced({grey, grey, 1, 0.0});
  QVERIFY(frame.left.bytes == grey.bytes && frame.right.bytes == grey.bytes);
  const auto mask = std::make_shared<const PictureMask>(PictureMask{grey, 1, 0.0});
  QVERIFY(views.reduced(mask) == mask);
}

void ReducedViewsTest::TheOrganIsFollowedAsInTheSmallerPicture() {
  // A strip of 960 pixels' width, and the same with each of its pixels four times: nothing may differ.
  StereoRig small = phantom::rig();
  for (Camera* camera : {&small.left, &small.right}) {
    camera->matrix.topRows<2>() *= 3.0;
    camera->width = 960;
    camera->height = 260;
    camera->matrix(1, 2) = 130.0;
  }
  StereoRig large = small;
  large.left = doubled(small.left);
  large.right = doubled(small.right);
  const PatientModel model = phantom::model(8, 6, 3);
  Registration start;
  start.camera_from_ct = phantom::view();
  start.nodes_in_camera = phantom::view().apply(model.mesh.vertices);
  Tracker one(model, start, phantom::free_body()), other(model, start, phantom::free_body());
  for (int k = 0; k < 4; ++k) {
    const Points nodes = phantom::breathed(model, start.nodes_in_camera, 0.1 * k);
    const StereoFrame frame = phantom::film(model, nodes, small, k);
    const StereoFrame twice{doubled(frame.left), doubled(frame.right), frame.index, frame.seconds};
    if (k == 0) {
      one.begin(small, frame, {});
      other.begin(large, twice, {});
      continue;
    }
    const OverlayFrame expected = one.follow(frame), found = other.follow(twice);
    QCOMPARE(validity_code(found.validity), validity_code(expected.validity));
    QVERIFY2(expected.pairs >= 40, qPrintable(QString::number(expected.pairs)));
    QCOMPARE(found.pairs, expected.pairs);
    QVERIFY((found.nodes_in_camera - expected.nodes_in_camera).cwiseAbs().maxCoeff() < 1e-9);
  }
  // A hand drags in the picture as it comes.
  const StereoFrame last = phantom::film(model, start.nodes_in_camera, small, 4);
  const OverlayFrame drawn = one.follow(last);
  other.follow({doubled(last.left), doubled(last.right), last.index, last.seconds});
  const auto picked = pick_place(model, drawn.nodes_in_camera, small, StereoView::left, {480.0, 130.0});
  QVERIFY(picked.has_value());
  Correction drag;
  drag.place_in_ct = picked->place_in_ct;
  drag.from = picked->pixel;
  drag.to = drag.from + Eigen::Vector2d(9.0, -6.0);
  const OverlayFrame expected = one.correct(drag);
  QVERIFY((expected.nodes_in_camera - drawn.nodes_in_camera).cwiseAbs().maxCoeff() > 1e-3);
  for (Eigen::Vector2d* pixel : {&drag.from, &drag.to}) *pixel = 2.0 * (pixel->array() + 0.5) - 0.5;
  drag.sigma_px *= 2.0;
  QVERIFY((other.correct(drag).nodes_in_camera - expected.nodes_in_camera).cwiseAbs().maxCoeff() < 1e-9);
}

QTEST_GUILESS_MAIN(ReducedViewsTest)
#include "reduced_views_test.moc"
