// SPDX-License-Identifier: GPL-3.0-or-later
// The organ is registered again while it is followed. The truth is the film's own: a ray caster that knows no
// tracker.
#include <QTest>
#include <numbers>

#include "filmed_phantom.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/guidance/tracker.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/register_again.h"
#include "tissue_map.h"

using namespace glisson;
using namespace glisson::guidance;

class AgainTest : public QObject {
  Q_OBJECT
 private slots:
  void LooksOfAMovingOrganJoinInTheShapeOfTheStart();
  void WhatPassesByIsNoTissue();
  void AnotherRegistrationIsTakenWhileTheTissueStaysWhereItIs();
  void AWrongStartIsRegisteredAgainAndShown();
  void AShownOrganGoesOverGently();
  void ALesionsRegionGoesOverWithItsOrgan();
  void ItGoesOverWhereTheSourceTellsNoTime();
  void WhatHandsHaveSaidIsKept();
  void WhatCannotBeFollowedIsRefusedAndNothingChanges();

 private:
  Points truth(int frame) const { return film_.truth(frame); }
  StereoFrame frame(int k) const { return film_.frame(k); }
  Registration off(const Eigen::Vector3d& by) const {
    Registration start = film_.start;
    start.nodes_in_camera.rowwise() += by.transpose();
    start.camera_from_ct.translation += by;
    return start;
  }
  Tracker begun(const Registration& start) const {
    Tracker tracker(film_.model, start, phantom::free_body());
    tracker.begin(film_.rig, film_.frame(0), {});
    return tracker;
  }
  /// The last of so many frames.
  OverlayFrame followed(Tracker& tracker, int from, int to) const {
    OverlayFrame overlay;
    for (int k = from; k <= to; ++k) overlay = tracker.follow(frame(k));
    return overlay;
  }
  static double error(const Points& nodes, const Points& truth) { return point_errors(nodes, truth).mean; }

  phantom::BreathingFilm film_;
};

void AgainTest::LooksOfAMovingOrganJoinInTheShapeOfTheStart() {
  // It breathes by 5 mm and more, and starts 5 mm off: the tissue is told where it was at the start.
  Tracker tracker = begun(off({3e-3, -3e-3, 3e-3}));
  QVERIFY(!tracker.tissue_at_start());
  followed(tracker, 1, 45);
  const auto tissue = tracker.tissue_at_start();
  QVERIFY(tissue && tissue->size() > 50);
  TriangleMesh surface = film_.model.surface.mesh;
  for (int i = 0; i < surface.vertex_count(); ++i)
    surface.vertices.row(i) =
        film_.nodes.row(film_.model.surface.node_of_vertex[static_cast<std::size_t>(i)]);
  const DistanceSummary away = summarise(distances_to_surface(tissue->points, surface));
  QVERIFY2(away.median < 1e-3 && away.percentile_95 < 3e-3,
           qPrintable(QString("%1, %2 mm").arg(1e3 * away.median).arg(1e3 * away.percentile_95)));
  // The scope stood still: seen from the moving organ it was about where it is.
  QVERIFY(tissue->seen_from.rows() == tissue->points.rows() &&
          tissue->seen_from.rowwise().norm().maxCoeff() < 10e-3);
}

void AgainTest::WhatPassesByIsNoTissue() {
  TissueMap map;
  std::vector<Eigen::Vector3d> places;
  const Eigen::Vector3d eye(0.01, 0.02, -0.03);
  for (int i = 0; i < 10; ++i) places.emplace_back(0.01 * i + 1e-3, 1e-3, 0.1);
  for (int look = 0; look < 5; ++look) {
    map.add(places, eye);
    if (look < 2) {
      QCOMPARE(map.places().size(), 0);
      map.add({{0.01 * look, 0.02, 0.08}}, eye);  // a tool, each time elsewhere
    }
  }
  QCOMPARE(map.places().size(), 10);
  for (const Eigen::Vector3d& place : places)
    QVERIFY((map.places().points.rowwise() - place.transpose()).rowwise().norm().minCoeff() < 1e-12);
  QVERIFY((map.places().seen_from.rowwise() - eye.transpose()).rowwise().norm().maxCoeff() < 1e-12);
  map.clear();
  QCOMPARE(map.places().size(), 0);
}

void AgainTest::AnotherRegistrationIsTakenWhileTheTissueStaysWhereItIs() {
  Tracker tracker = begun(off({6e-3, -4e-3, 3e-3}));
  const OverlayFrame before = followed(tracker, 1, 12);
  const OverlayFrame taken = tracker.take(film_.start);
  QVERIFY2(error(taken.nodes_in_camera, truth(12)) < 0.25 * error(before.nodes_in_camera, truth(12)),
           qPrintable(QString::number(1e3 * error(taken.nodes_in_camera, truth(12)))));
  // It stays there, with the same points, and its own evidence agrees in the end.
  const OverlayFrame after = followed(tracker, 13, 80);
  QVERIFY(after.pairs >= 30);
  QVERIFY2(error(after.nodes_in_camera, truth(80)) < 2e-3,
           qPrintable(QString::number(1e3 * error(after.nodes_in_camera, truth(80)))));
  QVERIFY2(after.validity == Validity::valid, validity_code(after.validity));
  // And back.
  const OverlayFrame former = tracker.take(off({6e-3, -4e-3, 3e-3}));
  QVERIFY(followed(tracker, 81, 130).validity != Validity::valid);
  QVERIFY(former.index == 80);
}

void AgainTest::AWrongStartIsRegisteredAgainAndShown() {
  const Registration wrong = off({7e-3, -4e-3, 4e-3});
  Tracker tracker = begun(wrong);
  QVERIFY(followed(tracker, 1, 45).validity == Validity::surface_apart);
  // The marks of the first cloud, as the operator set them.
  const LabelledCloud cloud = phantom::patch(film_.model, film_.nodes, {});
  registration::RegisterOptions options;
  options.operations = false;
  const auto again = registration::register_again(film_.model, cloud, *tracker.tissue_at_start(), wrong,
                                                  options, RunContext());
  QVERIFY(again->is_better);
  QVERIFY(again->gap < again->former_gap);
  tracker.take(again->examined.registered.registration);
  const OverlayFrame after = followed(tracker, 46, 100);
  QVERIFY2(after.validity == Validity::valid, validity_code(after.validity));
  QVERIFY2(error(after.nodes_in_camera, truth(100)) < 0.5 * error(wrong.nodes_in_camera, film_.nodes),
           qPrintable(QString::number(1e3 * error(after.nodes_in_camera, truth(100)))));
}

void AgainTest::AShownOrganGoesOverGently() {
  Tracker tracker = begun(film_.start), left_alone = begun(film_.start);
  QVERIFY(followed(tracker, 1, 12).validity == Validity::valid);
  followed(left_alone, 1, 12);
  const Eigen::Vector3d by(1.5e-3, 0.0, 0.0);
  const auto apart = [](const OverlayFrame& a, const OverlayFrame& b) {
    return (a.nodes_in_camera - b.nodes_in_camera).rowwise().norm().mean();
  };
  tracker.take(off(by));
  double last = 0.0;
  for (int k = 13; k <= 45; ++k) {
    const double now = apart(tracker.follow(frame(k)), left_alone.follow(frame(k)));
    QVERIFY2(std::abs(now - last) < 0.3e-3, qPrintable(QString("frame %1: %2").arg(k).arg(1e3 * now)));
    last = now;
  }
  QVERIFY2(last > 0.9e-3, qPrintable(QString::number(1e3 * last)));  // it has gone
}

void AgainTest::ALesionsRegionGoesOverWithItsOrgan() {
  PatientModel model = film_.model;
  for (int t = 0; t < 6; ++t) model.mesh.labels[static_cast<std::size_t>(200 + t)] = structure::kFirstLesion;
  Points centre(1, 3);
  centre.row(0) = lesion_centres(model).front().second.transpose();
  const Binding binding = bind_points(model.mesh, centre);
  const auto apart = [&](const OverlayFrame& overlay) {
    const Points drawn = binding.apply(model.mesh, overlay.nodes_in_camera);
    return (overlay.lesions.front().centre - drawn.row(0).transpose()).norm();
  };
  Tracker tracker(model, film_.start, phantom::free_body());
  tracker.begin(film_.rig, film_.frame(0), {});
  QVERIFY(followed(tracker, 1, 12).validity == Validity::valid);
  QVERIFY(apart(tracker.take(off({3e-3, 0.0, 0.0}))) < 1e-9);
  for (int k = 13; k <= 45; ++k) {
    const double now = apart(tracker.follow(frame(k)));
    QVERIFY2(now < 1e-9, qPrintable(QString("frame %1: %2 mm").arg(k).arg(1e3 * now)));
  }
}

void AgainTest::ItGoesOverWhereTheSourceTellsNoTime() {
  Tracker tracker = begun(film_.start), left_alone = begun(film_.start);
  const auto timeless = [&](int k) {
    StereoFrame one = frame(k);
    one.seconds = 0.0;
    return one;
  };
  for (int k = 1; k <= 12; ++k) tracker.follow(timeless(k)), left_alone.follow(timeless(k));
  tracker.take(off({1.5e-3, 0.0, 0.0}));
  OverlayFrame gone, left;
  for (int k = 13; k <= 45; ++k) gone = tracker.follow(timeless(k)), left = left_alone.follow(timeless(k));
  const double apart = (gone.nodes_in_camera - left.nodes_in_camera).rowwise().norm().mean();
  QVERIFY2(apart > 0.9e-3, qPrintable(QString::number(1e3 * apart)));
}

void AgainTest::WhatHandsHaveSaidIsKept() {
  Tracker tracker = begun(off({4e-3, 0.0, 0.0}));
  const OverlayFrame before = followed(tracker, 1, 6);
  Correction drag;
  drag.place_in_ct = film_.model.landmarks.anterior_margin.row(20).transpose();
  const auto pixel = [&](const Points& nodes) {
    const Points place =
        bind_points(film_.model.mesh, drag.place_in_ct.transpose(), false).apply(film_.model.mesh, nodes);
    return film_.rig.left.project(place.row(0).transpose());
  };
  drag.from = pixel(before.nodes_in_camera);
  drag.to = pixel(truth(6));
  tracker.correct(drag);
  const OverlayFrame taken = tracker.take(off({4e-3, 1e-3, 0.0}));  // as wrong there
  QVERIFY2((pixel(taken.nodes_in_camera) - drag.to).norm() < 0.5 * (drag.from - drag.to).norm(),
           qPrintable(QString::number((pixel(taken.nodes_in_camera) - drag.to).norm())));
  QVERIFY(tracker.corrections().empty());
  QVERIFY_THROWS_EXCEPTION(InputError, tracker.undo_correction());
}

void AgainTest::WhatCannotBeFollowedIsRefusedAndNothingChanges() {
  Tracker tracker = begun(film_.start);
  Registration foreign = film_.start;
  foreign.nodes_in_camera.conservativeResize(5, 3);
  QVERIFY_THROWS_EXCEPTION(InputError, tracker.take(film_.start));  // no frame yet
  const OverlayFrame before = followed(tracker, 1, 3);
  QVERIFY_THROWS_EXCEPTION(InputError, tracker.take(foreign));
  foreign = film_.start;
  foreign.nodes_in_camera(3, 1) = std::nan("");
  QVERIFY_THROWS_EXCEPTION(InputError, tracker.take(foreign));
  foreign = film_.start;  // inside out
  foreign.nodes_in_camera.col(2) = 2.0 * film_.nodes.col(2).mean() - foreign.nodes_in_camera.col(2).array();
  try {
    tracker.take(foreign);
    QFAIL("taken");
  } catch (const InputError& refused) {
    QCOMPARE(QString::fromStdString(refused.file()), QString("registration"));
    QVERIFY2(QString::fromStdString(refused.problem()).startsWith("cannot be followed: "), refused.what());
  }
  Tracker other = begun(film_.start);
  followed(other, 1, 3);
  QVERIFY(tracker.follow(frame(4)).nodes_in_camera == other.follow(frame(4)).nodes_in_camera);
  QVERIFY(before.validity == Validity::valid);
}

QTEST_APPLESS_MAIN(AgainTest)
#include "again_test.moc"
