// SPDX-License-Identifier: GPL-3.0-or-later
// A lesion is drawn as a body only where it is known well enough.
#include <Eigen/Cholesky>
#include <QTest>
#include <random>

#include "box_patient.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/scene/overlay_painter.h"
#include "lesion_marks.h"

using namespace glisson;

namespace {

Picture grey_frame(const Camera& camera) {
  return {camera.width, camera.height, 3,
          std::make_shared<std::vector<std::uint8_t>>(
              static_cast<std::size_t>(3 * camera.width * camera.height), std::uint8_t{90})};
}

Eigen::Matrix3d slanted() {
  Eigen::Matrix3d root;
  root << 6e-3, 0.0, 0.0, 3e-3, 4e-3, 0.0, -2e-3, 1e-3, 7e-3;
  return root * root.transpose();
}

LesionVerdict verdict(Level level, LesionReason reason) {
  LesionVerdict lesion;
  lesion.lesion = structure::kFirstLesion;
  lesion.level = level;
  lesion.reason = reason;
  lesion.centre = {0.03, 0.0, 0.13};
  lesion.radius = 6e-3;
  lesion.covariance = slanted();
  lesion.reach = 20e-3;
  return lesion;
}

/// Pixels that differ from the frame's grey, in a square around a place.
int changed_around(const Picture& picture, const Eigen::Vector2d& middle, int half) {
  int changed = 0;
  for (int v = static_cast<int>(middle.y()) - half; v <= static_cast<int>(middle.y()) + half; ++v)
    for (int u = static_cast<int>(middle.x()) - half; u <= static_cast<int>(middle.x()) + half; ++u) {
      const auto i = static_cast<std::size_t>(3 * (v * picture.width + u));
      changed += (*picture.bytes)[i] != 90 || (*picture.bytes)[i + 1] != 90 || (*picture.bytes)[i + 2] != 90;
    }
  return changed;
}

/// Amber words in the upper left quarter.
int amber_words(const Picture& picture) {
  int amber = 0;
  for (int v = 0; v < picture.height / 4; ++v)
    for (int u = 0; u < picture.width / 2; ++u) {
      const auto i = static_cast<std::size_t>(3 * (v * picture.width + u));
      amber += (*picture.bytes)[i + 2] > 120 && (*picture.bytes)[i + 1] > 80 && (*picture.bytes)[i] < 60;
    }
  return amber;
}

}  // namespace

class LesionMarksTest : public QObject {
  Q_OBJECT
 private slots:
  void TheRegionHoldsNineteenOfTwentyPlaces();
  void TheRegionHoldsTheWholeLesion();
  void NothingIsKnownOfWhatNobodyJudged();
  void NoLesionIsBetterThanTheWhole();
  void OnlyAValidLesionIsABody();
  void ADegradedOneIsItsRegionsRim();
  void TheReasonIsWrittenUnlessTheWholeSaysIt();

 private:
  Picture paint(const OverlayFrame& overlay, bool words) {
    scene::OverlayStyle style;
    style.portal_vein = style.hepatic_veins = style.arteries = style.outline = style.anterior_margin = false;
    style.legend = style.status = words;
    return scene::OverlayPainter(model_, camera_, style).paint(grey_frame(camera_), overlay);
  }
  OverlayFrame overlay(const std::vector<LesionVerdict>& lesions, Validity validity = Validity::valid) const {
    OverlayFrame overlay;
    overlay.validity = validity;
    overlay.nodes_in_camera = model_.mesh.vertices.rowwise() + Eigen::RowVector3d(0.0, 0.0, 0.13);
    overlay.lesions = lesions;
    return overlay;
  }

  Camera camera_ = laparoscope();
  PatientModel model_ = box_patient();
  Eigen::Vector2d middle_ = camera_.project({0.03, 0.0, 0.13});
};

void LesionMarksTest::TheRegionHoldsNineteenOfTwentyPlaces() {
  LesionVerdict lesion = verdict(Level::degraded, LesionReason::start_uncertain);
  lesion.radius = 0.0;
  lesion.covariance *= 0.25;  // the projection is nearly linear over it
  const QPolygonF region = scene::region_of(lesion, camera_);
  const Eigen::Matrix3d root = lesion.covariance.llt().matrixL();
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  constexpr int kDraws = 20000;
  int inside = 0;
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d p =
        lesion.centre + root * Eigen::Vector3d{normal(random), normal(random), normal(random)};
    const Eigen::Vector2d pixel = camera_.project(p);
    inside += region.containsPoint({pixel.x() + 0.5, pixel.y() + 0.5}, Qt::OddEvenFill);
  }
  const double share = static_cast<double>(inside) / kDraws;
  QVERIFY2(std::abs(share - 0.95) < 0.01, qPrintable(QString::number(share)));
}

void LesionMarksTest::TheRegionHoldsTheWholeLesion() {
  LesionVerdict lesion = verdict(Level::degraded, LesionReason::start_uncertain);
  lesion.covariance = 1e-12 * Eigen::Matrix3d::Identity();
  const QRectF box = scene::region_of(lesion, camera_).boundingRect();
  const TriangleMesh ball = ball_mesh(lesion.centre, lesion.radius, 24);
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int i = 0; i < ball.vertex_count(); ++i) {
    low = low.cwiseMin(camera_.project(ball.vertex(i)));
    high = high.cwiseMax(camera_.project(ball.vertex(i)));
  }
  QVERIFY(std::abs(box.left() - 0.5 - low.x()) < 1.0 && std::abs(box.right() - 0.5 - high.x()) < 1.0);
  QVERIFY(std::abs(box.top() - 0.5 - low.y()) < 1.0 && std::abs(box.bottom() - 0.5 - high.y()) < 1.0);
  lesion.centre.z() = -0.1;
  QVERIFY(scene::region_of(lesion, camera_).isEmpty());
}

void LesionMarksTest::NothingIsKnownOfWhatNobodyJudged() {
  const auto verdicts = scene::verdicts_of({structure::kFirstLesion}, overlay({}));
  QCOMPARE(verdicts.size(), std::size_t{1});
  QVERIFY(verdicts[0].level == Level::withdrawn);
  QVERIFY(verdicts[0].reason == LesionReason::error_unknown);
  QCOMPARE(changed_around(paint(overlay({}), false), middle_, 40), 0);
}

void LesionMarksTest::NoLesionIsBetterThanTheWhole() {
  for (const Validity validity : kValidities) {
    const auto verdicts = scene::verdicts_of({structure::kFirstLesion},
                                             overlay({verdict(Level::valid, LesionReason::known)}, validity));
    QVERIFY(verdicts[0].level == level_of(validity));
  }
}

void LesionMarksTest::OnlyAValidLesionIsABody() {
  const int inside = 4;  // well within the body
  const auto at = [&](Level level, Validity validity = Validity::valid) {
    return changed_around(paint(overlay({verdict(level, LesionReason::start_uncertain)}, validity), false),
                          middle_, inside);
  };
  QCOMPARE(at(Level::valid), (2 * inside + 1) * (2 * inside + 1));
  QCOMPARE(at(Level::degraded), 0);
  QCOMPARE(at(Level::withdrawn), 0);
  QCOMPARE(at(Level::valid, Validity::partly_covered), 0);
}

void LesionMarksTest::ADegradedOneIsItsRegionsRim() {
  const LesionVerdict lesion = verdict(Level::degraded, LesionReason::far_from_points);
  const Picture picture = paint(overlay({lesion}), false);
  const QPolygonF region = scene::region_of(lesion, camera_);
  int drawn = 0;
  for (const QPointF& corner : region)
    drawn += changed_around(picture, {corner.x() - 0.5, corner.y() - 0.5}, 1) > 0;
  QVERIFY2(drawn > 0.95 * static_cast<double>(region.size()), qPrintable(QString::number(drawn)));
}

void LesionMarksTest::TheReasonIsWrittenUnlessTheWholeSaysIt() {
  const auto words = [&](Level level, LesionReason reason) {
    return amber_words(paint(overlay({verdict(level, reason)}), true));
  };
  QCOMPARE(words(Level::valid, LesionReason::known), 0);
  QCOMPARE(words(Level::degraded, LesionReason::with_the_whole), 0);
  for (const LesionReason reason :
       {LesionReason::error_unknown, LesionReason::refused_start, LesionReason::start_uncertain,
        LesionReason::far_from_points, LesionReason::long_unseen})
    QVERIFY(words(Level::degraded, reason) > 50);
  QSet<QString> texts;
  for (const LesionReason reason : kLesionReasons)
    texts << QString::fromStdString(scene::lesion_reason_text(reason));
  QCOMPARE(texts.size(), static_cast<qsizetype>(std::size(kLesionReasons)));
}

int main(int argc, char** argv) {
  const scene::HeadlessGui gui;
  LesionMarksTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "lesion_marks_test.moc"
