// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <limits>
#include <numbers>

#include "filmed_phantom.h"
#include "followed_body.h"
#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/guidance/tracker.h"

using namespace glisson;
using namespace glisson::guidance;

class TrackerTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void ModelFollowsBreathing();
  void StillTissueKeepsTheRegisteredShape();
  void StiffBoundaryHoldsItsPlace();
  void ElementsAreNotTurnedInsideOut();
  void BlackFramesAreNotValidAndTheNextGoodOneIs();
  void PicturesTellWhyPointsAreFew_data();
  void PicturesTellWhyPointsAreFew();
  void ALampThatChangesLosesNothing();
  void PicturesOfAnotherSizeAreNotValid();
  void NoisePicturesAreNotValid();
  void ADoubtOfTheStartStaysWithEveryFrame();
  void WithoutAFirstFrameItIsNotStarted();
  void CloudsAreFollowedWithoutCorrespondences_data();
  void CloudsAreFollowedWithoutCorrespondences();
  void FewCloudPointsAreNotValid();
  void UnusableStartsAndOptionsAreRefused();

 private:
  static constexpr int kFrames = 9;
  Points at(double share) const { return phantom::breathed(model_, nodes_, share); }
  static double share(int frame) { return 0.5 - 0.5 * std::cos(std::numbers::pi * frame / (kFrames - 1)); }
  static TrackerOptions options() { return phantom::free_body(); }
  Tracker begun() const {
    Tracker tracker(model_, start_, options());
    tracker.begin(rig_, film_[0], {});
    return tracker;
  }

  StereoRig rig_ = phantom::rig();
  PatientModel model_ = phantom::model(8, 6, 3);
  Points nodes_;
  Registration start_;
  std::vector<StereoFrame> film_;
};

namespace {

/// With what noise there is in the dark.
Picture darkened(const Picture& picture) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(4.0, 2.0);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
  for (auto& byte : *bytes)
    byte = static_cast<std::uint8_t>(std::clamp(0.03 * byte + noise(random), 0.0, 255.0));
  Picture dark = picture;
  dark.bytes = bytes;
  return dark;
}

}  // namespace

void TrackerTest::initTestCase() {
  nodes_ = phantom::view().apply(model_.mesh.vertices);
  start_.nodes_in_camera = nodes_;
  start_.camera_from_ct = phantom::view();
  for (int k = 0; k < kFrames; ++k) film_.push_back(phantom::film(model_, at(share(k)), rig_, k));
}

void TrackerTest::ModelFollowsBreathing() {
  Tracker tracker = begun();
  double frozen = 0.0, tracked = 0.0;
  for (int k = 1; k < kFrames; ++k) {
    const OverlayFrame overlay = tracker.follow(film_[static_cast<std::size_t>(k)]);
    QVERIFY2(overlay.validity == Validity::valid,
             qPrintable(QString("frame %1 %2").arg(k).arg(validity_code(overlay.validity))));
    QVERIFY(overlay.pairs >= 40 && overlay.tracked_left >= overlay.pairs);
    QCOMPARE(overlay.index, k);
    const Points truth = at(share(k));
    frozen += point_errors(nodes_, truth).mean;
    tracked += point_errors(overlay.nodes_in_camera, truth).mean;
  }
  QVERIFY2(tracked < 0.4 * frozen, qPrintable(QString("tracked %1 mm, frozen %2 mm")
                                                  .arg(1e3 * tracked / (kFrames - 1))
                                                  .arg(1e3 * frozen / (kFrames - 1))));
}

void TrackerTest::StillTissueKeepsTheRegisteredShape() {
  // What stereo sees of depth at 260 pixels of focal length and a 5 mm baseline is a millimetre uncertain.
  Tracker tracker = begun();
  OverlayFrame overlay;
  for (int k = 0; k < 6; ++k) overlay = tracker.follow(film_[0]);
  QVERIFY(overlay.validity == Validity::valid);
  QVERIFY2(point_errors(overlay.nodes_in_camera, nodes_).mean < 1e-3,
           qPrintable(QString::number(1e3 * point_errors(overlay.nodes_in_camera, nodes_).mean)));
}

void TrackerTest::StiffBoundaryHoldsItsPlace() {
  const Binding cava = bind_points(model_.mesh, model_.landmarks.vena_cava);
  const auto moved = [&](double tether) {
    TrackerOptions changed = options();
    changed.boundary_young_modulus = 20e6;
    changed.boundary_tether = tether;
    changed.scope_moves = false;
    Tracker tracker(model_, start_, changed);
    tracker.begin(rig_, film_[0], {});
    OverlayFrame overlay;
    for (const StereoFrame& frame : film_) overlay = tracker.follow(frame);
    return point_errors(cava.apply(model_.mesh, overlay.nodes_in_camera), cava.apply(model_.mesh, nodes_))
        .mean;
  };
  const double held = moved(1e6), loose = moved(1.0);
  QVERIFY2(held < 0.5e-3 && loose > 2e-3,
           qPrintable(QString("%1 and %2 mm").arg(1e3 * held).arg(1e3 * loose)));
}

void TrackerTest::ElementsAreNotTurnedInsideOut() {
  FollowedBody body(model_, nodes_, options());
  body.rest_here();
  Eigen::Index node = 0;
  nodes_.col(2).minCoeff(&node);  // on top of the dome
  const auto pull_to = [&](double depth) {
    return [&body, &node, depth, this](std::vector<fem::AttachedLoad>& loads) {
      fem::AttachedLoad load;
      load.nodes[0] = static_cast<int>(node);
      load.weights[0] = 1.0;
      load.tangent = 1e5 * Eigen::Matrix3d::Identity();
      load.force =
          load.tangent *
          (nodes_.row(node) + Eigen::RowVector3d(0.0, 0.0, depth) - body.positions().row(node)).transpose();
      loads.push_back(load);
    };
  };
  QVERIFY(!body.advance(1, pull_to(60e-3)));
  QVERIFY(body.positions() == nodes_ && body.velocities().isZero(0.0));
  QVERIFY(body.advance(1, pull_to(1e-3)));
  QVERIFY(body.positions() != nodes_);
  // What a registration has left inside out does not keep it from moving.
  Points bent = nodes_;
  bent(node, 2) += 60e-3;
  body.place(bent);
  QVERIFY(body.advance(1, pull_to(59e-3)));
  QVERIFY(body.positions() != bent);
}

void TrackerTest::BlackFramesAreNotValidAndTheNextGoodOneIs() {
  Tracker tracker = begun();
  tracker.follow(film_[1]);
  StereoFrame black = film_[2];
  black.left = phantom::plain(rig_.left, 0);
  black.right = phantom::plain(rig_.right, 0);
  for (int k = 0; k < 3; ++k) {
    const OverlayFrame overlay = tracker.follow(black);
    QVERIFY(overlay.validity == Validity::picture_lost);
    QVERIFY(overlay.nodes_in_camera.allFinite());
  }
  QVERIFY(tracker.follow(film_[2]).validity == Validity::valid);
}

void TrackerTest::PicturesTellWhyPointsAreFew_data() {
  QTest::addColumn<QString>("fault");
  QTest::addColumn<Validity>("told");
  QTest::newRow("left view black") << "left" << Validity::view_lost;
  QTest::newRow("right view grey") << "right" << Validity::view_lost;
  QTest::newRow("no right view") << "none" << Validity::view_lost;
  QTest::newRow("views in the wrong order") << "swapped" << Validity::views_swapped;
  QTest::newRow("lamp out") << "dark" << Validity::picture_lost;
  // The picture is good, and something else is seen: nothing of the cameras is wrong.
  QTest::newRow("another part of another organ") << "elsewhere" << Validity::too_few_points;
}

void TrackerTest::PicturesTellWhyPointsAreFew() {
  QFETCH(QString, fault);
  QFETCH(Validity, told);
  Tracker tracker = begun();
  QVERIFY(tracker.follow(film_[1]).validity == Validity::valid);
  StereoFrame frame = film_[2];
  if (fault == "left") frame.left = phantom::plain(rig_.left, 0);
  if (fault == "right") frame.right = phantom::plain(rig_.right, 128);
  if (fault == "none") frame.right = {};
  if (fault == "swapped") std::swap(frame.left, frame.right);
  if (fault == "dark") {
    frame.left = darkened(frame.left);
    frame.right = darkened(frame.right);
  }
  if (fault == "elsewhere") {
    const PatientModel other = phantom::model(9, 5, 4);
    Points there = phantom::view().apply(other.mesh.vertices);
    there.rowwise() += Eigen::RowVector3d(0.04, 0.02, 0.01);
    frame = phantom::film(other, there, rig_, 2);
    frame.seconds = film_[2].seconds;
  }
  for (int k = 0; k < 3; ++k) {
    const OverlayFrame overlay = tracker.follow(frame);
    QVERIFY2(overlay.validity == told, validity_code(overlay.validity));
    QVERIFY(overlay.level() == Level::withdrawn && !is_followed(overlay.validity));
  }
  if (told == Validity::too_few_points) return;  // the organ may be looked for, and found later
  const Validity after = tracker.follow(film_[2]).validity;
  QVERIFY2(after == Validity::valid, validity_code(after));
}

void TrackerTest::ALampThatChangesLosesNothing() {
  const auto lit = [](const Picture& picture, double gain) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
    for (auto& byte : *bytes) byte = static_cast<std::uint8_t>(std::min(255.0, gain * byte));
    Picture changed = picture;
    changed.bytes = bytes;
    return changed;
  };
  Tracker tracker = begun(), plain = begun();
  for (int k = 1; k < kFrames; ++k) {
    StereoFrame frame = film_[static_cast<std::size_t>(k)];
    const int even = plain.follow(frame).pairs;
    const double gain = k % 2 == 0 ? 1.2 : 0.7;
    frame.left = lit(frame.left, gain);
    frame.right = lit(frame.right, gain);
    const OverlayFrame overlay = tracker.follow(frame);
    QVERIFY(overlay.validity == Validity::valid || overlay.validity == Validity::poor_picture);
    QVERIFY2(10 * overlay.pairs >= 9 * even, qPrintable(QString("%1 of %2").arg(overlay.pairs).arg(even)));
    QVERIFY(point_errors(overlay.nodes_in_camera, at(share(k))).mean < 2e-3);
  }
}

void TrackerTest::PicturesOfAnotherSizeAreNotValid() {
  Tracker tracker = begun();
  StereoFrame wrong = film_[1];
  wrong.left.width /= 2;
  wrong.left.height *= 2;
  QVERIFY(tracker.follow(wrong).validity == Validity::too_few_points);
  wrong = film_[1];
  wrong.right = {};
  QVERIFY(tracker.follow(wrong).validity == Validity::view_lost);
  QVERIFY(tracker.follow(film_[1]).validity == Validity::valid);
}

void TrackerTest::NoisePicturesAreNotValid() {
  Tracker tracker = begun();
  StereoFrame noise = film_[1];
  std::mt19937 random(3);
  for (Picture* picture : {&noise.left, &noise.right}) {
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(picture->bytes->size());
    for (auto& byte : *bytes) byte = static_cast<std::uint8_t>(random() & 0xffU);
    picture->bytes = bytes;
  }
  QVERIFY(tracker.follow(noise).validity != Validity::valid);
  QVERIFY(tracker.follow(film_[1]).validity == Validity::valid);
}

void TrackerTest::ADoubtOfTheStartStaysWithEveryFrame() {
  // A lesion's own doubt is told at the lesion.
  const std::vector<std::pair<std::vector<std::string>, bool>> starts = {
      {{}, false},
      {{"lesion_1.error_large 9.5 8"}, false},
      {{"expected_error_large 9 8"}, true},
      {{"lesion_1.error_large 9.5 8", "little_surface_seen"}, true}};
  for (const auto& [doubts, doubtful] : starts) {
    Registration start = start_;
    start.doubts = doubts;
    Tracker tracker(model_, start, options());
    tracker.begin(rig_, film_[0], {});
    for (int k = 1; k < 3; ++k)
      QCOMPARE(tracker.follow(film_[static_cast<std::size_t>(k)]).doubtful, doubtful);
  }
}

void TrackerTest::WithoutAFirstFrameItIsNotStarted() {
  Tracker tracker(model_, start_, options());
  const OverlayFrame overlay = tracker.follow(film_[1]);
  QVERIFY(overlay.validity == Validity::not_started);
  QVERIFY(overlay.nodes_in_camera == nodes_);
}

void TrackerTest::CloudsAreFollowedWithoutCorrespondences_data() {
  QTest::addColumn<int>("method");
  QTest::newRow("springs") << static_cast<int>(registration::Method::springs);
  QTest::newRow("forces") << static_cast<int>(registration::Method::forces);
}

void TrackerTest::CloudsAreFollowedWithoutCorrespondences() {
  QFETCH(int, method);
  TrackerOptions by = options();
  by.cloud_method = static_cast<registration::Method>(method);
  Tracker tracker(model_, start_, by);
  double frozen = 0.0, tracked = 0.0;
  for (int k = 1; k < kFrames; ++k) {
    phantom::PatchOptions patch;
    patch.seed = static_cast<unsigned>(k);  // other points every time
    patch.share = 0.4;
    const Points truth = at(share(k));
    const OverlayFrame overlay = tracker.follow(phantom::patch(model_, truth, patch), k, k / 30.0, 5);
    QVERIFY(overlay.validity == Validity::valid);
    QVERIFY(overlay.residual < 2e-3);
    frozen += point_errors(nodes_, truth).mean;
    tracked += point_errors(overlay.nodes_in_camera, truth).mean;
  }
  QVERIFY2(tracked < 0.8 * frozen, qPrintable(QString("tracked %1, frozen %2").arg(tracked).arg(frozen)));
}

void TrackerTest::FewCloudPointsAreNotValid() {
  Tracker tracker(model_, start_, options());
  LabelledCloud cloud;
  cloud.points = Points::Zero(5, 3);
  QVERIFY(tracker.follow(cloud, 0, 0.0, 1).validity == Validity::too_few_points);
}

void TrackerTest::UnusableStartsAndOptionsAreRefused() {
  Registration short_start = start_;
  short_start.nodes_in_camera.conservativeResize(5, 3);
  QVERIFY_THROWS_EXCEPTION(InputError, Tracker(model_, short_start, options()));
  Registration broken = start_;
  broken.nodes_in_camera(3, 1) = std::numeric_limits<double>::quiet_NaN();
  QVERIFY_THROWS_EXCEPTION(InputError, Tracker(model_, broken, options()));
  const auto refused = [&](auto change) {
    TrackerOptions changed = options();
    change(changed);
    QVERIFY_THROWS_EXCEPTION(InputError, Tracker(model_, start_, changed));
  };
  refused([](TrackerOptions& o) { o.points = 0; });
  refused([](TrackerOptions& o) { o.window_px = 16; });
  refused([](TrackerOptions& o) { o.time_step = 0.0; });
  refused([](TrackerOptions& o) { o.steps_per_frame = 0; });
  refused([](TrackerOptions& o) { o.fixed_nodes = {-1}; });
  refused([](TrackerOptions& o) { o.boundary_length = 0.0; });
  refused([](TrackerOptions& o) { o.boundary_tether = 0.0; });
  Registration inside_out = start_;
  inside_out.nodes_in_camera.col(2) =
      2.0 * start_.nodes_in_camera.col(2).mean() - start_.nodes_in_camera.col(2).array();
  Tracker mirrored(model_, inside_out, options());
  QVERIFY_THROWS_EXCEPTION(InputError, mirrored.begin(rig_, film_[0], {}));
  Tracker tracker(model_, start_, options());
  StereoFrame wrong = film_[0];
  wrong.left.width = 100;
  QVERIFY_THROWS_EXCEPTION(InputError, tracker.begin(rig_, wrong, {}));
}

QTEST_APPLESS_MAIN(TrackerTest)
#include "tracker_test.moc"
