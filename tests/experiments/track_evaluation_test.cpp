// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/experiments/track_evaluation.h"

#include <QTest>

#include <cmath>

#include "../registration/phantom.h"
#include "glisson/core/error.h"
#include "glisson/experiments/evaluate.h"

using namespace glisson;
using namespace glisson::experiments;

class TrackEvaluationTest : public QObject {
  Q_OBJECT
 private slots:
  void FramesAreCountedByTimeAndValidity();
  void ErrorsAreMeansOverTheFramesComparedAndLargestMaxima();
  void AFrameWithoutAPositionIsCountedOnly();
  void MotionIsThatSinceTheTrueStart();
  void WithoutFramesNothingIsKnown();
  void WrongSizesAndRatesAreRefused();

 private:
  /// Everything shifted along x, millimetres.
  Points shifted(double mm) const {
    return start_.nodes_in_camera.rowwise() + Eigen::RowVector3d(1e-3 * mm, 0, 0);
  }
  OverlayFrame frame(double mm, double milliseconds = 1.0) const {
    OverlayFrame overlay;
    overlay.validity = Validity::valid;
    overlay.milliseconds = milliseconds;
    overlay.nodes_in_camera = shifted(mm);
    return overlay;
  }
  static bool close(double a, double b) { return std::abs(a - b) < 1e-9; }

  PatientModel model_ = phantom::model(4, 3, 2);
  Registration start_ = [this] {
    Registration registration;
    registration.nodes_in_camera = model_.mesh.vertices;
    return registration;
  }();
};

void TrackEvaluationTest::FramesAreCountedByTimeAndValidity() {
  FrameTimes times(25.0);  // 40 ms a frame
  for (const double milliseconds : {10.0, 39.0, 41.0, 20.0}) times.add(frame(0.0, milliseconds));
  OverlayFrame lost;
  lost.validity = Validity::too_few_points;
  lost.milliseconds = 90.0;
  times.add(lost);
  QCOMPARE(times.frames(), 5);
  QVERIFY((times.counts() == Figures{{"frames", 5.0},
                                     {"frames_late", 2.0},
                                     {"frames_valid", 4.0},
                                     {"frames_degraded", 0.0},
                                     {"frames_withdrawn", 1.0}}));
  QVERIFY((times.percentiles() == Figures{{"frame_p50_ms", 39.0}, {"frame_p99_ms", 90.0}}));
}

void TrackEvaluationTest::ErrorsAreMeansOverTheFramesComparedAndLargestMaxima() {
  TrackEvaluation evaluation(model_, start_, 30.0);
  for (const auto& [found, truth] : {std::pair(1.0, 2.0), {2.0, 5.0}, {3.0, 5.0}}) {
    const OverlayFrame overlay = frame(found);
    evaluation.add(overlay);
    const Figures now = evaluation.compare(overlay, shifted(truth), "truth");
    QVERIFY(close(now.at("tre_volume_mean_mm"), truth - found));
    QVERIFY(close(now.at("tre_frozen_mean_mm"), truth));
  }
  const Figures errors = evaluation.errors();
  QCOMPARE(evaluation.compared(), 3);
  QVERIFY(close(errors.at("tre_volume_mean_mm"), 2.0));
  QVERIFY(close(errors.at("tre_volume_max_mm"), 3.0));
  QVERIFY(close(errors.at("tre_frozen_mean_mm"), 4.0));
  QVERIFY(!errors.contains("motion_mean_mm"));
  QVERIFY(close(evaluation.displacement().at("displacement_mean_mm"), 2.0));
}

void TrackEvaluationTest::AFrameWithoutAPositionIsCountedOnly() {
  TrackEvaluation evaluation(model_, start_, 30.0);
  evaluation.add(frame(4.0));
  evaluation.add(OverlayFrame());
  QCOMPARE(evaluation.times().frames(), 2);
  QVERIFY(close(evaluation.displacement().at("displacement_mean_mm"), 4.0));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, evaluation.compare(OverlayFrame(), shifted(0.0), "truth"));
}

void TrackEvaluationTest::MotionIsThatSinceTheTrueStart() {
  TrackEvaluation evaluation(model_, start_, 30.0);
  evaluation.set_true_start(shifted(10.0));  // the registration was 10 mm off
  const OverlayFrame overlay = frame(3.0);
  evaluation.add(overlay);
  evaluation.compare(overlay, shifted(15.0), "truth");
  QVERIFY(close(evaluation.errors().at("motion_mean_mm"), 5.0));
  QVERIFY(close(evaluation.errors().at("motion_error_mean_mm"), 2.0));
  QVERIFY(close(evaluation.errors().at("tre_volume_mean_mm"), 12.0));
}

void TrackEvaluationTest::WithoutFramesNothingIsKnown() {
  const TrackEvaluation evaluation(model_, start_, 30.0);
  QVERIFY(std::isnan(evaluation.times().percentiles().at("frame_p50_ms")));
  QVERIFY(std::isnan(evaluation.displacement().at("displacement_mean_mm")));
  QVERIFY(evaluation.errors().empty());
}

void TrackEvaluationTest::WrongSizesAndRatesAreRefused() {
  QVERIFY_THROWS_EXCEPTION(PreconditionError, FrameTimes(0.0));
  Registration short_one = start_;
  short_one.nodes_in_camera.conservativeResize(3, 3);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, TrackEvaluation(model_, short_one, 30.0));
  TrackEvaluation evaluation(model_, start_, 30.0);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, evaluation.set_true_start(Points(3, 3)));
  QVERIFY_THROWS_EXCEPTION(InputError, evaluation.compare(frame(0.0), Points(3, 3), "truth"));
  evaluation.compare(frame(0.0), shifted(0.0), "truth");
  QVERIFY_THROWS_EXCEPTION(PreconditionError, evaluation.set_true_start(shifted(0.0)));
}

QTEST_APPLESS_MAIN(TrackEvaluationTest)
#include "track_evaluation_test.moc"
