// SPDX-License-Identifier: GPL-3.0-or-later
// A hand says where places of the organ are. The truth is the film's own: a ray caster that knows no tracker.
#include <QTest>
#include <numbers>

#include "filmed_phantom.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/guidance/place_picker.h"
#include "glisson/guidance/tracker.h"

using namespace glisson;
using namespace glisson::guidance;

class CorrectionTest : public QObject {
  Q_OBJECT
 private slots:
  void ThreeDragsBringAWrongStartHomeAndItStaysThere();
  void ADragIsMetInItsPictureAndMovesNoDepthThere_data();
  void ADragIsMetInItsPictureAndMovesNoDepthThere();
  void UndoLeavesNoTrace();
  void UndoAfterFramesTakesTheCorrectionAlone();
  void PiecesOfOneGestureCountAsOneDrag();
  void AWrongCorrectionIsWithdrawnByTheSurface();
  void AFarOrUnseenPlaceIsRefusedAndNothingChanges();
  void ADragThatTurnsElementsInsideOutIsRefusedAsOne();
  void APixelPicksWhatIsSeenThere();

 private:
  Points truth(int frame) const { return film_.truth(frame); }
  StereoFrame frame(int k) const { return film_.frame(k); }
  static TrackerOptions options() { return phantom::free_body(); }
  /// That far off where it is.
  Tracker begun(const Eigen::Vector3d& off, double turn_deg = 0.0) const {
    Registration start = film_.start;
    const Eigen::RowVector3d middle = film_.nodes.colwise().mean();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(turn_deg * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    start.nodes_in_camera =
        ((film_.nodes.rowwise() - middle) * turn.transpose()).rowwise() + (middle + off.transpose());
    Tracker tracker(film_.model, start, options());
    tracker.begin(film_.rig, film_.frame(0), {});
    return tracker;
  }
  Eigen::Vector2d pixel(const Eigen::Vector3d& p, StereoView view) const {
    if (view == StereoView::left) return film_.rig.left.project(p);
    return film_.rig.right.project(film_.rig.right_from_left.rotation * p +
                                   film_.rig.right_from_left.translation);
  }
  Eigen::Vector3d place(const Eigen::Vector3d& in_ct, const Points& nodes) const {
    return bind_points(film_.model.mesh, in_ct.transpose(), false)
        .apply(film_.model.mesh, nodes)
        .row(0)
        .transpose();
  }
  /// What a hand does that knows where that place is.
  Correction drag(const Eigen::Vector3d& in_ct, const Points& drawn, const Points& true_nodes,
                  StereoView view = StereoView::left) const {
    Correction correction;
    correction.place_in_ct = in_ct;
    correction.view = view;
    correction.from = pixel(place(in_ct, drawn), view);
    correction.to = pixel(place(in_ct, true_nodes), view);
    return correction;
  }
  /// The k-th of three places of the margin that are in sight the whole time, from its one end to the other.
  Eigen::Vector3d margin(int k) const {
    std::vector<int> in_sight;
    for (int i = 0; i < static_cast<int>(film_.model.landmarks.anterior_margin.rows()); ++i) {
      const Eigen::Vector2d one = pixel(place(rim(i), film_.nodes), StereoView::left);
      if (one.x() > 30.0 && one.x() < 290.0 && one.y() > 30.0 && one.y() < 218.0) in_sight.push_back(i);
    }
    return rim(in_sight.at((in_sight.size() - 1) * static_cast<std::size_t>(k) / 2));
  }
  Eigen::Vector3d rim(int i) const { return film_.model.landmarks.anterior_margin.row(i).transpose(); }
  static double error(const OverlayFrame& overlay, const Points& truth) {
    return point_errors(overlay.nodes_in_camera, truth).mean;
  }

  phantom::BreathingFilm film_;
};

void CorrectionTest::ThreeDragsBringAWrongStartHomeAndItStaysThere() {
  Tracker tracker = begun({6e-3, -4e-3, 3e-3}, 3.0), left_alone = begun({6e-3, -4e-3, 3e-3}, 3.0);
  OverlayFrame overlay;
  for (int k = 1; k <= 4; ++k) {
    overlay = tracker.follow(frame(k));
    left_alone.follow(frame(k));
  }
  const double before = error(overlay, truth(4));
  QVERIFY2(before > 7e-3, qPrintable(QString::number(1e3 * before)));
  for (const int k : {0, 1, 2}) overlay = tracker.correct(drag(margin(k), overlay.nodes_in_camera, truth(4)));
  const double after = error(overlay, truth(4));
  QVERIFY2(after < 0.35 * before, qPrintable(QString("%1 of %2 mm").arg(1e3 * after).arg(1e3 * before)));
  QCOMPARE(tracker.corrections().size(), std::size_t{3});
  double worst = 0.0, mean = 0.0;
  constexpr int kFrames = 120;
  for (int k = 5; k < 5 + kFrames; ++k) {
    overlay = tracker.follow(frame(k));
    left_alone.follow(frame(k));
    QVERIFY2(overlay.pairs >= 30, qPrintable(QString("frame %1: %2").arg(k).arg(overlay.pairs)));
    const double now = error(overlay, truth(k));
    worst = std::max(worst, now);
    mean += now / kFrames;
  }
  QVERIFY2(mean < 0.4 * before && worst < 0.5 * before,
           qPrintable(QString("mean %1, worst %2 mm").arg(1e3 * mean).arg(1e3 * worst)));
  // Its own evidence agrees, and would not have without the hand.
  QVERIFY2(overlay.validity == Validity::valid, validity_code(overlay.validity));
}

void CorrectionTest::ADragIsMetInItsPictureAndMovesNoDepthThere_data() {
  QTest::addColumn<bool>("left");
  QTest::newRow("left") << true;
  QTest::newRow("right") << false;
}

void CorrectionTest::ADragIsMetInItsPictureAndMovesNoDepthThere() {
  QFETCH(bool, left);
  const StereoView view = left ? StereoView::left : StereoView::right;
  Tracker tracker = begun({0.0, 0.0, 0.0});
  OverlayFrame overlay = tracker.follow(frame(1));
  Correction wanted;
  wanted.view = view;
  wanted.place_in_ct = margin(1);
  wanted.from = pixel(place(margin(1), overlay.nodes_in_camera), view);
  wanted.to = wanted.from + Eigen::Vector2d(6.0, 4.0);
  const double depth = place(margin(1), overlay.nodes_in_camera).z();
  overlay = tracker.correct(wanted);
  const double left_px = (pixel(place(margin(1), overlay.nodes_in_camera), view) - wanted.to).norm();
  QVERIFY2(left_px < 1.0, qPrintable(QString::number(left_px)));
  QVERIFY(std::abs(place(margin(1), overlay.nodes_in_camera).z() - depth) < 2.5e-3);
}

void CorrectionTest::UndoLeavesNoTrace() {
  Tracker corrected = begun({0.0, 0.0, 0.0}), plain = begun({0.0, 0.0, 0.0});
  OverlayFrame before;
  for (int k = 1; k <= 3; ++k) {
    before = corrected.follow(frame(k));
    plain.follow(frame(k));
  }
  OverlayFrame overlay = before;
  for (const int k : {0, 2}) {
    Correction wanted = drag(margin(k), overlay.nodes_in_camera, truth(3));
    wanted.to += Eigen::Vector2d(5.0, -3.0);
    overlay = corrected.correct(wanted);
  }
  QVERIFY(error(overlay, before.nodes_in_camera) > 1e-3);
  corrected.undo_correction();
  overlay = corrected.undo_correction();
  QVERIFY(overlay.nodes_in_camera == before.nodes_in_camera);  // to the bit
  QVERIFY(corrected.corrections().empty());
  QVERIFY_THROWS_EXCEPTION(InputError, corrected.undo_correction());
  for (int k = 4; k < 12; ++k) {
    const OverlayFrame one = corrected.follow(frame(k)), other = plain.follow(frame(k));
    const double apart = error(one, other.nodes_in_camera);
    QVERIFY2(apart < 0.3e-3, qPrintable(QString("frame %1: %2 mm").arg(k).arg(1e3 * apart)));
  }
}

void CorrectionTest::UndoAfterFramesTakesTheCorrectionAlone() {
  Tracker corrected = begun({0.0, 0.0, 0.0}), plain = begun({0.0, 0.0, 0.0});
  OverlayFrame overlay = corrected.follow(frame(1)), other = plain.follow(frame(1));
  Correction wanted = drag(margin(1), overlay.nodes_in_camera, truth(1));
  wanted.to += Eigen::Vector2d(7.0, 5.0);
  overlay = corrected.correct(wanted);
  const double moved = error(overlay, other.nodes_in_camera);
  for (int k = 2; k <= phantom::BreathingFilm::kFrames; ++k) {
    overlay = corrected.follow(frame(k));
    other = plain.follow(frame(k));
  }
  QVERIFY(error(overlay, other.nodes_in_camera) > 0.7 * moved);  // it persists while the organ moves
  overlay = corrected.undo_correction();
  const double apart = error(overlay, other.nodes_in_camera);
  QVERIFY2(apart < 0.1 * moved, qPrintable(QString("%1 of %2 mm").arg(1e3 * apart).arg(1e3 * moved)));
}

void CorrectionTest::PiecesOfOneGestureCountAsOneDrag() {
  Tracker in_pieces = begun({5e-3, 0.0, 0.0}), at_once = begun({5e-3, 0.0, 0.0});
  OverlayFrame overlay = in_pieces.follow(frame(1));
  at_once.follow(frame(1));
  Correction whole = drag(margin(1), overlay.nodes_in_camera, truth(1));
  whole.gesture = 7;
  for (const double part : {0.3, 0.6, 1.0}) {
    Correction piece = whole;  // from where it is drawn by then
    piece.from = pixel(place(margin(1), overlay.nodes_in_camera), StereoView::left);
    piece.to = whole.from + part * (whole.to - whole.from);
    overlay = in_pieces.correct(piece);
  }
  QCOMPARE(in_pieces.corrections().size(), std::size_t{1});
  const OverlayFrame other = at_once.correct(whole);
  QVERIFY(error(overlay, other.nodes_in_camera) < 0.1e-3);
  const Correction told = in_pieces.corrections().front().correction;  // one drag
  QVERIFY((told.from - whole.from).norm() < 0.05 && (told.to - whole.to).norm() < 0.05);
  in_pieces.undo_correction();
  QVERIFY(in_pieces.corrections().empty());
}

void CorrectionTest::AWrongCorrectionIsWithdrawnByTheSurface() {
  Tracker tracker = begun({0.0, 0.0, 0.0});
  OverlayFrame overlay;
  for (int k = 1; k <= 20; ++k) overlay = tracker.follow(frame(k));
  QVERIFY2(overlay.validity == Validity::valid, validity_code(overlay.validity));
  for (const int k : {0, 1, 2}) {  // a hand that is 25 mm off
    Correction wanted =
        drag(margin(k), overlay.nodes_in_camera, truth(20).rowwise() + Eigen::RowVector3d(0.0, -25e-3, 0.0));
    overlay = tracker.correct(wanted);
  }
  int told = -1;
  for (int k = 21; k <= 40 && told < 0; ++k)
    if (tracker.follow(frame(k)).level() == Level::withdrawn) told = k;
  QVERIFY2(told > 0 && told <= 36, qPrintable(QString::number(told)));
}

void CorrectionTest::AFarOrUnseenPlaceIsRefusedAndNothingChanges() {
  Tracker tracker(film_.model, film_.start, options());
  Correction wanted = drag(margin(1), film_.nodes, truth(2));
  QVERIFY_THROWS_EXCEPTION(InputError, tracker.correct(wanted));  // no picture
  tracker = begun({0.0, 0.0, 0.0});
  QVERIFY_THROWS_EXCEPTION(InputError, tracker.correct(wanted));  // none followed
  const OverlayFrame before = tracker.follow(frame(1));
  const auto refused = [&](auto change) {
    Correction bad = drag(margin(1), before.nodes_in_camera, truth(1));
    change(bad);
    QVERIFY_THROWS_EXCEPTION(InputError, tracker.correct(bad));
  };
  refused([](Correction& c) { c.to.x() += 400.0; });
  refused([](Correction& c) { c.to.y() -= 100.0; });
  refused([](Correction& c) { c.to.y() = std::nan(""); });
  refused([](Correction& c) { c.sigma_px = 0.0; });
  StereoFrame black = frame(2);
  black.left = phantom::plain(film_.rig.left, 0);
  black.right = phantom::plain(film_.rig.right, 0);
  tracker.follow(black);
  refused([](Correction&) {});
  QVERIFY(tracker.corrections().empty());
  QVERIFY(error(tracker.follow(frame(2)), truth(2)) < 1e-3);
}

void CorrectionTest::ADragThatTurnsElementsInsideOutIsRefusedAsOne() {
  // The rim's end, pushed far into the organ.
  Tracker tracker = begun({0.0, 0.0, 0.0}), left_alone = begun({0.0, 0.0, 0.0});
  const OverlayFrame before = tracker.follow(frame(1));
  left_alone.follow(frame(1));
  Correction wanted = drag(rim(40), before.nodes_in_camera, truth(1));
  wanted.sigma_px = 0.5;
  wanted.to += Eigen::Vector2d(-60.0, 0.0);
  try {
    tracker.correct(wanted);
    QFAIL("corrected");
  } catch (const InputError& refused) {
    QCOMPARE(QString::fromStdString(refused.file()), QString("correction"));
    QCOMPARE(QString::fromStdString(refused.remedy()), QString("Drag less far, or register again"));
  }
  QVERIFY(tracker.corrections().empty());
  QVERIFY(tracker.follow(frame(2)).nodes_in_camera == left_alone.follow(frame(2)).nodes_in_camera);
}

void CorrectionTest::APixelPicksWhatIsSeenThere() {
  const Eigen::Vector2d notch =
      pixel(place(film_.model.landmarks.umbilical_notch.row(0).transpose(), film_.nodes), StereoView::left);
  auto picked =
      pick_place(film_.model, film_.nodes, film_.rig, StereoView::left, notch + Eigen::Vector2d(2.0, 1.0));
  QVERIFY(picked && picked->feature == CorrectedFeature::notch);
  QVERIFY((picked->pixel - notch).norm() < 0.1);
  QCOMPARE(picked->sigma_px, Correction().sigma_px);
  // Six times as many pixels a side: a hand drags as exactly on the screen, not in pixels.
  StereoRig large = film_.rig;
  for (Camera* camera : {&large.left, &large.right}) {
    camera->width *= 6;
    camera->height *= 6;
    camera->matrix.topRows<2>() *= 6.0;
  }
  picked = pick_place(film_.model, film_.nodes, large, StereoView::left, 6.0 * notch);
  QVERIFY(picked && picked->feature == CorrectedFeature::notch);
  QCOMPARE(picked->sigma_px, 2.0 * Correction().sigma_px);
  const Eigen::Vector3d rim = place(margin(2), film_.nodes);
  for (const StereoView view : kStereoViews) {
    picked =
        pick_place(film_.model, film_.nodes, film_.rig, view, pixel(rim, view) + Eigen::Vector2d(0.0, 2.0));
    QVERIFY(picked && picked->feature == CorrectedFeature::margin);
    QVERIFY((picked->pixel - pixel(rim, view)).norm() < 4.0);
    const Eigen::Vector2d middle = pixel(film_.nodes.colwise().mean().transpose(), view);
    picked = pick_place(film_.model, film_.nodes, film_.rig, view, middle);
    QVERIFY(picked && picked->feature == CorrectedFeature::surface);
    QVERIFY((pixel(place(picked->place_in_ct, film_.nodes), view) - middle).norm() < 0.1);
  }
  QVERIFY(!pick_place(film_.model, film_.nodes, film_.rig, StereoView::left, {160.0, 237.0}));
}

QTEST_APPLESS_MAIN(CorrectionTest)
#include "correction_test.moc"
