// SPDX-License-Identifier: GPL-3.0-or-later
// What is laid over a large picture is made at a reduced size.
#include <QTest>

#include "box_patient.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "overlay_frames.h"

namespace glisson {

class OverlaySizeTest : public QObject {
  Q_OBJECT
 private slots:
  void ALargePictureIsDrawnOverAsASmallOneAndStaysSharp();
  void ALesionLiesWhereTheCameraProjectsIt();
};

void OverlaySizeTest::ALargePictureIsDrawnOverAsASmallOneAndStaysSharp() {
  const Camera large = laparoscope(3.0), small = reduced(large, 2);
  QCOMPARE(reduction_of(large.width), 2);
  const PatientModel model = box_patient();
  scene::OverlayStyle style;
  style.anterior_margin = style.legend = style.status = false;  // lines and words of the picture's own size
  scene::OverlayPainter over_large(model, large, style), over_small(model, small, style);
  const OverlayFrame overlay = at(model.mesh.vertices.rowwise() + Eigen::RowVector3d(0, 0, 0.13));
  const Picture frame = grey_frame(large);
  auto stripes = std::make_shared<std::vector<std::uint8_t>>(*frame.bytes);
  for (std::size_t i = 0; i < stripes->size(); ++i)
    if (i / 3 % 2 == 0) (*stripes)[i] = 130;
  const Picture sharp{large.width, large.height, 3, stripes};
  scene::OverlayInterest interest;
  interest.pointer = Eigen::Vector2d(large.width / 2.0, large.height / 2.0);
  const Picture whole = over_large.paint(frame, overlay, {}, interest),
                striped = over_large.paint(sharp, overlay, {}, interest);
  interest.pointer = Eigen::Vector2d(small.width / 2.0 - 0.25, small.height / 2.0 - 0.25);
  const Picture half = over_small.paint(grey_frame(small), overlay, {}, interest);
  const auto value = [](const Picture& picture, int u, int v) {
    return static_cast<int>((*picture.bytes)[static_cast<std::size_t>(3 * (v * picture.width + u))]);
  };
  const auto is_free = [](const Picture& picture, int u, int v) {
    const auto at = picture.bytes->begin() + 3 * (v * picture.width + u);
    return std::all_of(at, at + 3, [](int channel) { return channel == 90; });
  };
  int drawn = 0, apart = 0;
  for (int v = 0; v < small.height; ++v)
    for (int u = 0; u < small.width; ++u) {
      const int mean = (value(whole, 2 * u, 2 * v) + value(whole, 2 * u + 1, 2 * v) +
                        value(whole, 2 * u, 2 * v + 1) + value(whole, 2 * u + 1, 2 * v + 1)) /
                       4;
      drawn += value(half, u, v) != 90;
      apart += std::abs(mean - value(half, u, v)) > 20;
      // Where next to nothing is drawn every pixel is the camera's.
      if (is_free(whole, 2 * u, 2 * v) && is_free(whole, 2 * u + 1, 2 * v))
        QVERIFY(value(striped, 2 * u, 2 * v) - value(striped, 2 * u + 1, 2 * v) >= 38);
    }
  QVERIFY2(drawn > 20000, qPrintable(QString::number(drawn)));
  QVERIFY2(apart < drawn / 50, qPrintable(QStringLiteral("%1 of %2").arg(apart).arg(drawn)));
}

void OverlaySizeTest::ALesionLiesWhereTheCameraProjectsIt() {
  const Camera camera = laparoscope(3.0);
  const PatientModel model = box_patient();
  scene::OverlayStyle style;
  style.portal_vein = style.hepatic_veins = style.arteries = style.outline = style.anterior_margin = false;
  style.legend = style.status = false;
  const Picture frame = grey_frame(camera);
  const Eigen::RowVector3d shift(0.004, -0.002, 0.13);
  const Picture picture =
      scene::OverlayPainter(model, camera, style).paint(frame, at(model.mesh.vertices.rowwise() + shift));
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto i = static_cast<std::size_t>(3 * (v * camera.width + u));
      if ((*picture.bytes)[i] == 90 && (*picture.bytes)[i + 1] == 90) continue;
      low = low.cwiseMin(Eigen::Vector2d(u, v));
      high = high.cwiseMax(Eigen::Vector2d(u, v));
    }
  const Eigen::Vector3d lesion = Eigen::Vector3d(0.03, 0.0, 0.0) + shift.transpose();  // of box_patient()
  // Two pixels are one of what is drawn.
  QVERIFY((0.5 * (low + high) - camera.project(lesion)).norm() < 2.0);
}

}  // namespace glisson

int main(int argc, char** argv) {
  const glisson::scene::HeadlessGui gui;
  glisson::OverlaySizeTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "overlay_size_test.moc"
