// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QTest>
#include <thread>

#include "box_patient.h"
#include "glisson/core/error.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/offscreen_renderer.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "glisson/ui/scene/picture_image.h"
#include "overlay_frames.h"

namespace glisson {
namespace {

/// A bend that is no rigid motion and no affine one.
Points bent(const Points& rest, const Eigen::Vector3d& shift) {
  Points nodes = rest;
  for (Eigen::Index i = 0; i < nodes.rows(); ++i) {
    nodes(i, 2) += 1.5 * nodes(i, 0) * nodes(i, 0) - 0.1 * nodes(i, 1);
    nodes.row(i) += shift.transpose();
  }
  return nodes;
}

scene::OverlayStyle only_lesions() {
  scene::OverlayStyle style;
  style.portal_vein = style.hepatic_veins = style.arteries = style.outline = style.anterior_margin = false;
  style.legend = style.status = false;
  return style;
}

}  // namespace

class OverlayTest : public QObject {
  Q_OBJECT
 private slots:
  void RendersWithoutADisplayRepeatedly();
  void RendersOnAnotherThread();
  void DeformedLesionAppearsWhereTheCameraProjectsIt();
  void VesselsFadeWithDepthBelowTheSurface();
  void StructuresLeftOutHideNothing();
  void NothingIsDrawnWhenWithdrawn();
  void DegradedIsTheOutlineAndTheReason();
  void AProposedPlaceIsABoldOutlineAndNoFigures();
  void ADoubtIsSaidInThePicture_data();
  void ADoubtIsSaidInThePicture();
  void WhatStandsDoesNotReadAsValid();
  void InvalidFramesSayWhyAndCarryABorder();
  void TheReasonFitsIntoASmallPicture();
  void EveryReasonHasItsRemedy();
  void SamePictureFromTheSameInput();
  void VesselsThatLeaveTheLiverAreNotDrawnOutsideIt();
  void WhatTheLensFoldsBackIsNotDrawn();
  void FrameOfAnotherSizeIsRefused();
  void NodesOfAnotherModelAreRefused();
  void BadStyleIsRefused();
  void EmptySizeIsRefused();
};

void OverlayTest::RendersWithoutADisplayRepeatedly() {
  QVERIFY2(qEnvironmentVariableIsEmpty("DISPLAY"), "this test proves something only without a display");
  for (int pass = 0; pass < 5; ++pass) {
    scene::OffscreenRenderer offscreen(80 + pass, 60);
    for (int again = 0; again < 3; ++again) {
      vtkNew<vtkRenderer> renderer;
      renderer->SetBackground(again == 0 ? 1.0 : 0.0, again == 1 ? 1.0 : 0.0, again == 2 ? 1.0 : 0.0);
      const Picture picture = offscreen.render(*renderer);
      QCOMPARE(picture.width, 80 + pass);
      QCOMPARE(int((*picture.bytes)[static_cast<std::size_t>(2 - again)]), 255);  // blue, green, red
      QCOMPARE(int((*picture.bytes)[static_cast<std::size_t>((4 - again) % 3)]), 0);
    }
    offscreen.resize(33, 21);
    vtkNew<vtkRenderer> renderer;
    QCOMPARE(offscreen.render(*renderer).height, 21);
  }
}

void OverlayTest::RendersOnAnotherThread() {
  int blue = 0;
  std::thread worker([&] {
    scene::OffscreenRenderer offscreen(32, 32);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(0.0, 0.0, 1.0);
    blue = (*offscreen.render(*renderer).bytes)[0];
  });
  worker.join();
  QCOMPARE(blue, 255);
}

void OverlayTest::DeformedLesionAppearsWhereTheCameraProjectsIt() {
  const Camera camera = laparoscope();
  PatientModel model = box_patient();
  const Picture frame = grey_frame(camera);
  double worst = 0.0;
  for (const Eigen::Vector3d& lesion : {Eigen::Vector3d(0.03, 0.0, 0.0), Eigen::Vector3d(-0.05, -0.03, 0.01),
                                        Eigen::Vector3d(0.045, 0.03, -0.01)}) {
    model.surfaces.back().mesh = ball_mesh(lesion, 0.003, 16);
    scene::OverlayPainter painter(model, camera, only_lesions());
    const Points nodes = bent(model.mesh.vertices, {0.004, -0.002, 0.13});
    int changed = 0;
    const Picture picture = painter.paint(frame, at(nodes));
    const Eigen::Vector2d seen = centre_of_change(frame, picture, &changed);
    Points centre(1, 3);
    centre.row(0) = lesion.transpose();
    const Points moved = bind_points(model.mesh, centre).apply(model.mesh, nodes);
    const Eigen::Vector2d expected = camera.project(moved.row(0).transpose());
    QVERIFY(changed > 100);
    worst = std::max(worst, (seen - expected).norm());
  }
  QVERIFY2(worst < 1.0, qPrintable(QStringLiteral("missed by %1 px").arg(worst)));
}

void OverlayTest::VesselsFadeWithDepthBelowTheSurface() {
  const Camera camera = laparoscope();
  double change[2] = {0.0, 0.0};
  for (int deep = 0; deep < 2; ++deep) {
    PatientModel model = box_patient();
    model.vessels.resize(1);
    model.vessels[0].nodes.col(2).setConstant(deep != 0 ? 0.015 : -0.018);  // the camera looks along +z
    scene::OverlayStyle style = only_lesions();
    style.portal_vein = true;
    style.lesions = false;
    scene::OverlayPainter painter(model, camera, style);
    const Points nodes = model.mesh.vertices.rowwise() + Eigen::RowVector3d(0, 0, 0.13);
    const Picture frame = grey_frame(camera), picture = painter.paint(frame, at(nodes));
    const Eigen::Vector2d pixel = camera.project({0.0, -0.02, deep != 0 ? 0.145 : 0.112});
    const auto i =
        static_cast<std::size_t>(3 * (std::lround(pixel.y()) * camera.width + std::lround(pixel.x())));
    change[deep] = std::abs(double((*picture.bytes)[i]) - 90.0);
  }
  QVERIFY2(change[1] > 8.0, "a deep vessel is still seen");
  QVERIFY2(change[0] > 1.4 * change[1], "a shallow vessel is drawn clearly stronger");
}

void OverlayTest::StructuresLeftOutHideNothing() {
  const Camera camera = laparoscope();
  PatientModel model = box_patient();
  model.vessels[0].nodes.col(1) = model.vessels[1].nodes.col(1);  // the portal branch in front of the hepatic
  model.vessels[0].nodes.col(2).array() -= 0.012;
  PatientModel hepatic_only = model;
  hepatic_only.vessels.erase(hepatic_only.vessels.begin());
  scene::OverlayStyle style = only_lesions();
  style.lesions = false;
  style.hepatic_veins = true;
  const Points nodes = model.mesh.vertices.rowwise() + Eigen::RowVector3d(0, 0, 0.13);
  const Picture frame = grey_frame(camera);
  scene::OverlayPainter all(model, camera, style), one(hepatic_only, camera, style);
  QVERIFY(*all.paint(frame, at(nodes)).bytes == *one.paint(frame, at(nodes)).bytes);
  style.portal_vein = true;
  all.set_style(style);
  QVERIFY(*all.paint(frame, at(nodes)).bytes != *one.paint(frame, at(nodes)).bytes);
}

void OverlayTest::NothingIsDrawnWhenWithdrawn() {
  const Camera camera = laparoscope();
  const PatientModel model = box_patient();
  scene::OverlayStyle style;
  style.legend = style.status = false;
  scene::OverlayPainter painter(model, camera, style);
  const Picture frame = grey_frame(camera);
  OverlayFrame overlay = at(bent(model.mesh.vertices, {0, 0, 0.13}));
  int valid = 0;
  centre_of_change(frame, painter.paint(frame, overlay), &valid);
  QVERIFY(valid > 5000);
  for (const Validity why : kValidities) {
    if (level_of(why) != Level::withdrawn) continue;
    overlay.validity = why;
    const Picture picture = painter.paint(frame, overlay);
    for (int v = camera.height / 2; v < camera.height - 20; ++v)  // the reason stands in the upper half
      for (int u = 20; u < camera.width - 20; ++u)
        QCOMPARE((*picture.bytes)[static_cast<std::size_t>(3 * (v * camera.width + u))], std::uint8_t{90});
  }
}

void OverlayTest::DegradedIsTheOutlineAndTheReason() {
  const Camera camera = laparoscope();
  const PatientModel model = box_patient();
  scene::OverlayStyle style;
  style.legend = style.status = false;
  scene::OverlayPainter painter(model, camera, style);
  const Picture frame = grey_frame(camera);
  OverlayFrame overlay = at(bent(model.mesh.vertices, {0, 0, 0.13}));
  const auto changed_below = [&](const Picture& picture) {  // the reason stands in the upper half
    int changed = 0;
    for (int v = camera.height / 2; v < camera.height - 20; ++v)
      for (int u = 20; u < camera.width - 20; ++u)
        changed += (*picture.bytes)[static_cast<std::size_t>(3 * (v * camera.width + u))] != 90;
    return changed;
  };
  const int valid = changed_below(painter.paint(frame, overlay));
  for (const Validity why : kValidities) {
    if (level_of(why) != Level::degraded) continue;
    overlay.validity = why;
    const Picture picture = painter.paint(frame, overlay);
    const int degraded = changed_below(picture);
    QVERIFY2(degraded > 100 && degraded < valid, qPrintable(QString("%1 of %2").arg(degraded).arg(valid)));
    const auto left_edge = static_cast<std::size_t>(3 * (camera.height / 2 * camera.width));
    QVERIFY((*picture.bytes)[left_edge + 2] > 200 && (*picture.bytes)[left_edge + 1] > 130);  // amber
    QVERIFY(scene::validity_text(why) != scene::validity_text(Validity::valid));
  }
}

void OverlayTest::AProposedPlaceIsABoldOutlineAndNoFigures() {
  const Camera camera = laparoscope();
  const PatientModel model = box_patient();
  const Picture frame = grey_frame(camera);
  OverlayFrame overlay = at(bent(model.mesh.vertices, {0, 0, 0.13}));
  scene::OverlayPainter painter(model, camera, {});
  const auto bright = [&](const Picture& picture) {
    int count = 0;
    for (int v = camera.height / 2; v < camera.height - 20; ++v)
      for (int u = 20; u < camera.width - 20; ++u)
        count += (*picture.bytes)[static_cast<std::size_t>(3 * (v * camera.width + u))] > 200;
    return count;
  };
  scene::OverlayStyle thin = only_lesions();
  thin.lesions = false;
  thin.outline = true;
  scene::OverlayPainter thin_painter(model, camera, thin);
  const int of_thin = bright(thin_painter.paint(frame, overlay));
  overlay.validity = Validity::proposed;
  const Picture proposed = painter.paint(frame, overlay);
  QVERIFY2(bright(proposed) > of_thin + 200, qPrintable(QString("%1").arg(bright(proposed))));
  // A residual and lesions belong to a registration: of a place that is only proposed they would lie.
  overlay.residual = 7e-3;
  overlay.lesions.clear();
  QVERIFY(*painter.paint(frame, overlay).bytes == *proposed.bytes);
}

void OverlayTest::ADoubtIsSaidInThePicture_data() {
  QTest::addColumn<bool>("registration");
  QTest::addColumn<bool>("model");
  QTest::addColumn<bool>("landmarks_open");
  QTest::addColumn<bool>("landmarks_from_statistics");
  QTest::newRow("registration") << true << false << false << false;
  QTest::newRow("model that nobody checked") << false << true << false << false;
  QTest::newRow("landmarks that nobody reviewed") << false << false << true << false;
  QTest::newRow("landmarks from statistics") << false << false << false << true;
  QTest::newRow("all") << true << true << true << true;
}

void OverlayTest::ADoubtIsSaidInThePicture() {
  const Camera camera = laparoscope();
  scene::OverlayPainter painter(box_patient(), camera);
  OverlayFrame overlay = at(bent(box_patient().mesh.vertices, {0.0, 0.0, 0.13}));
  const Picture certain = painter.paint(grey_frame(camera), overlay);
  QFETCH(bool, registration);
  QFETCH(bool, model);
  overlay.doubtful = registration;
  scene::OverlayStatus status;
  status.model_unchecked = model;
  QFETCH(bool, landmarks_open);
  QFETCH(bool, landmarks_from_statistics);
  status.landmarks_open = landmarks_open;
  status.landmarks_from_statistics = landmarks_from_statistics;
  const Picture doubtful = painter.paint(grey_frame(camera), overlay, status);
  int changed = 0, amber = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto place = static_cast<std::size_t>(3 * (v * camera.width + u));
      const std::uint8_t* now = doubtful.bytes->data() + place;
      if (std::equal(now, now + 3, certain.bytes->data() + place)) continue;
      ++changed;
      amber += now[2] > 200 && now[1] > 130 && now[0] < 80;
      QVERIFY(u > camera.width / 3 && v < camera.height / 4);  // the corner, not the organ
    }
  QVERIFY(amber > 50);
  QVERIFY(changed > amber);
}

void OverlayTest::WhatStandsDoesNotReadAsValid() {
  const Camera camera = laparoscope();
  scene::OverlayPainter painter(box_patient(), camera);
  const OverlayFrame overlay = at(bent(box_patient().mesh.vertices, {0.0, 0.0, 0.13}));
  scene::OverlayStatus status;
  const Picture now = painter.paint(grey_frame(camera), overlay, status);
  status.stands = true;
  const Picture standing = painter.paint(grey_frame(camera), overlay, status);
  int amber = 0;
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto place = static_cast<std::size_t>(3 * (v * camera.width + u));
      const std::uint8_t* is = standing.bytes->data() + place;
      if (std::equal(is, is + 3, now.bytes->data() + place)) continue;
      amber += is[2] > 200 && is[1] > 130 && is[0] < 80;
      QVERIFY(v < camera.height / 4);  // its words, not the organ
    }
  QVERIFY(amber > 50);
}

void OverlayTest::InvalidFramesSayWhyAndCarryABorder() {
  const Camera camera = laparoscope();
  scene::OverlayPainter painter(box_patient(), camera);
  const Picture frame = grey_frame(camera);
  OverlayFrame overlay;
  overlay.validity = Validity::mechanics_failed;
  const Picture lost = painter.paint(frame, overlay);
  const auto left_edge = static_cast<std::size_t>(3 * (camera.height / 2 * camera.width));
  QVERIFY((*lost.bytes)[left_edge + 2] > 200 && (*lost.bytes)[left_edge + 1] < 100);  // red
  overlay.validity = Validity::too_few_points;
  const Picture few = painter.paint(frame, overlay);
  QVERIFY((*few.bytes)[left_edge + 2] > 200 && (*few.bytes)[left_edge + 1] > 130);  // amber
  const Picture refused = painter.paint(frame, overlay, {.refused = true});
  QVERIFY(*refused.bytes != *few.bytes && (*refused.bytes)[left_edge + 1] < 100);  // red again
  // Different reasons read differently.
  QVERIFY(scene::validity_text(Validity::mechanics_failed) != scene::validity_text(Validity::too_few_points));
  int words = 0;
  for (int v = 30; v < camera.height / 3; ++v)
    for (int u = 100; u < camera.width - 100; ++u)
      words += (*few.bytes)[static_cast<std::size_t>(3 * (v * camera.width + u) + 2)] > 200 ? 1 : 0;
  QVERIFY2(words > 200, "the reason is written");
}

void OverlayTest::TheReasonFitsIntoASmallPicture() {
  const Camera camera = laparoscope(0.5);
  scene::OverlayPainter painter(box_patient(), camera, {});
  OverlayFrame overlay;
  for (const Validity validity : kValidities) {
    if (level_of(validity) != Level::withdrawn) continue;
    overlay.validity = validity;
    const Picture picture = painter.paint(grey_frame(camera), overlay);
    // Between the border and the words, left and right, the frame is what it was.
    for (int v = camera.height / 8; v < camera.height * 3 / 4; ++v)
      for (const int u : {6, camera.width - 7})
        QCOMPARE((*picture.bytes)[static_cast<std::size_t>(3 * (v * camera.width + u))], std::uint8_t{90});
  }
}

void OverlayTest::EveryReasonHasItsRemedy() {
  const Camera camera = laparoscope();
  scene::OverlayStyle style;
  style.legend = style.status = false;
  scene::OverlayPainter painter(box_patient(), camera, style);
  QVERIFY(scene::remedy_text(Validity::valid).empty());
  for (const Validity why : kValidities) {
    if (why == Validity::valid) continue;
    const std::string remedy = scene::remedy_text(why);
    QVERIFY2(!remedy.empty() && remedy.back() == '.', validity_code(why));
    QVERIFY2(remedy.find(scene::validity_text(why)) == std::string::npos, validity_code(why));
    if (level_of(why) != Level::withdrawn) continue;
    // In the picture, below the reason, in the colour of words and not of the border.
    OverlayFrame overlay;
    overlay.validity = why;
    const Picture picture = painter.paint(grey_frame(camera), overlay);
    int light = 0;
    for (int v = 0; v < camera.height / 2; ++v)
      for (int u = 20; u < camera.width - 20; ++u) {
        const auto i = static_cast<std::size_t>(3 * (v * camera.width + u));
        light += (*picture.bytes)[i] > 180 && (*picture.bytes)[i + 2] > 180;
      }
    QVERIFY2(light > 100, validity_code(why));
  }
}

void OverlayTest::SamePictureFromTheSameInput() {
  const Camera camera = laparoscope();
  const PatientModel model = box_patient();
  const OverlayFrame overlay = at(bent(model.mesh.vertices, {0, 0, 0.13}));
  const OverlayFrame other = at(bent(model.mesh.vertices, {0.01, 0, 0.16}));
  scene::OverlayPainter first(model, camera), second(model, camera);
  const Picture frame = grey_frame(camera);
  const Picture a = first.paint(frame, overlay);
  second.paint(frame, other);  // what was drawn before leaves no trace
  QVERIFY(*a.bytes == *second.paint(frame, overlay).bytes);
  QVERIFY(*a.bytes != *second.paint(frame, other).bytes);
  if (qEnvironmentVariableIsSet("GLISSON_SAVE_PICTURES"))
    scene::view_as_image(a).save(qEnvironmentVariable("GLISSON_SAVE_PICTURES") + "/overlay.png");
}

void OverlayTest::VesselsThatLeaveTheLiverAreNotDrawnOutsideIt() {
  const Camera camera = laparoscope();
  PatientModel model = box_patient();
  model.vessels[0].nodes(0, 0) = -0.12;  // 60 mm out of the block, as the portal vein below the liver
  scene::OverlayStyle style = only_lesions();
  style.lesions = false;
  style.portal_vein = true;
  scene::OverlayPainter painter(model, camera, style);
  const Points nodes = model.mesh.vertices.rowwise() + Eigen::RowVector3d(0.03, 0, 0.16);
  const Picture frame = grey_frame(camera), picture = painter.paint(frame, at(nodes));
  const int edge = static_cast<int>(camera.project({-0.03, -0.02, 0.135}).x());
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < edge - 8; ++u)
      QCOMPARE((*picture.bytes)[static_cast<std::size_t>(3 * (v * camera.width + u))], std::uint8_t{90});
  int changed = 0;
  centre_of_change(frame, picture, &changed);
  QVERIFY(changed > 500);
}

void OverlayTest::WhatTheLensFoldsBackIsNotDrawn() {
  // A barrel lens of one coefficient: beyond a slope of 0.86 its polynomial turns back into the picture.
  constexpr double kBarrel = -0.45, kAcross = 0.012, kNear = 0.045;
  Camera camera = laparoscope();
  camera.distortion << kBarrel, 0.0, 0.0, 0.0, 0.0;
  PatientModel model = box_patient();
  Points margin(61, 3);  // along the front, from a slope of 1.3 on one side to the same on the other
  for (int i = 0; i < 61; ++i) margin.row(i) << -0.06 + 0.002 * i, kAcross, -0.025;
  model.landmarks.anterior_margin = margin;
  scene::OverlayStyle style = only_lesions();
  style.lesions = false;
  style.anterior_margin = true;
  Points nodes = model.mesh.vertices;
  nodes.col(2).array() += kNear + 0.025;
  const Picture frame = grey_frame(camera);
  const Picture drawn = scene::OverlayPainter(model, camera, style).paint(frame, at(nodes));
  // What the lens keeps apart is nowhere nearer to the picture's middle than where the line leaves it: there
  // 1 + 3 k u is a fifth, and a pixel lies 1 + k u as far off as without the lens.
  const double u = (0.2 - 1.0) / (3.0 * kBarrel);
  const double least = camera.matrix(1, 2) + camera.matrix(1, 1) * kAcross / kNear * (1.0 + kBarrel * u);
  int changed = 0;
  double first_row = camera.height;
  for (int v = 0; v < frame.height; ++v)
    for (int x = 0; x < frame.width; ++x) {
      const auto i = static_cast<std::size_t>(3 * (v * frame.width + x));
      if ((*frame.bytes)[i] == (*drawn.bytes)[i]) continue;
      ++changed;
      first_row = std::min(first_row, static_cast<double>(v));
    }
  QVERIFY(changed > 200);
  QVERIFY2(first_row > least - 5.0, qPrintable(QString::number(first_row)));
}

void OverlayTest::FrameOfAnotherSizeIsRefused() {
  const Camera camera = laparoscope();
  scene::OverlayPainter painter(box_patient(), camera);
  Camera other = camera;
  other.width = 320;
  QVERIFY_THROWS_EXCEPTION(InputError, painter.paint(grey_frame(other), OverlayFrame()));
  QVERIFY_THROWS_EXCEPTION(InputError, painter.paint(Picture(), OverlayFrame()));
}

void OverlayTest::NodesOfAnotherModelAreRefused() {
  const Camera camera = laparoscope();
  scene::OverlayPainter painter(box_patient(), camera);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, painter.paint(grey_frame(camera), at(Points::Ones(3, 3))));
  PatientModel empty;
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::OverlayPainter(empty, camera));
}

void OverlayTest::BadStyleIsRefused() {
  scene::OverlayStyle style;
  style.opacity = 1.5;
  QVERIFY_THROWS_EXCEPTION(InputError, style.validate());
  style = {};
  style.fade_depth = 0.0;
  QVERIFY_THROWS_EXCEPTION(InputError, style.validate());
}

void OverlayTest::EmptySizeIsRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, scene::OffscreenRenderer(0, 10));
}

}  // namespace glisson

int main(int argc, char** argv) {
  qunsetenv("DISPLAY");
  const glisson::scene::HeadlessGui gui;
  glisson::OverlayTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "overlay_test.moc"
