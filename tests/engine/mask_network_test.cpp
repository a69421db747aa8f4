// SPDX-License-Identifier: GPL-3.0-or-later
// A person's own mask network beside what follows the organ: from its file to what a frame tells.
#include <QTest>

#include "complaint.h"
#include "filmed_phantom.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/live.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/rig.h"
#include "network_files.h"

using namespace glisson;
using namespace glisson::engine;

class MaskNetworkTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatIsAllLiverChangesNothing();
  void WhatIsNoLiverAtAllWithdrawsTheOverlay();
  void ANetworkThatIsNotThereIsAnError();

 private:
  /// Says of every pixel that it is liver, or that it is not.
  std::filesystem::path network(bool liver) const {
    const float first = liver ? 1.0F : 0.0F;
    return test::write_network(
        folder_.path(),
        test::OnnxNetwork({1, 3, -1, -1}).conv(2, 3, 1, std::vector<float>(6, 0.0F), {first, 1.0F - first}),
        R"({"channels": ["liver", "other"], "liver": ["liver"], "size": [48, 64]})");
  }
  std::unique_ptr<Follower> following(const MaskChoice& mask) const {
    CaseState state;
    auto model = std::make_shared<model::BuiltModel>();
    model->model = film_.model;
    state[part::model] = model;
    state[part::rig] = std::make_shared<StereoRig>(film_.rig);
    state[part::registration] = std::make_shared<Registration>(film_.start);
    state[part::frame] = std::make_shared<StereoInput>(StereoInput{film_.frame(0), {}});
    StartTracking start;
    start.source = StartTracking::Source::video;
    start.options = phantom::free_body();
    start.mask = mask;
    return make_follower(state, start);
  }

  TemporaryFolder folder_;
  phantom::BreathingFilm film_;
};

void MaskNetworkTest::WhatIsAllLiverChangesNothing() {
  const auto plain = following({}), masked = following({network(true), 1});
  for (int k = 1; k < 6; ++k) {
    const OverlayFrame without = plain->follow(film_.frame(k)), with = masked->follow(film_.frame(k));
    QVERIFY(!without.mask && with.mask);
    QCOMPARE(with.mask->share, 0.0);
    QCOMPARE(with.mask->age, 0.0);  // of this frame: it was waited for
    QVERIFY(with.level() == Level::valid);
    QVERIFY(with.nodes_in_camera == without.nodes_in_camera);
  }
  QVERIFY(!plain->mask_status());
  QVERIFY(masked->mask_status()->problem.empty());
}

void MaskNetworkTest::WhatIsNoLiverAtAllWithdrawsTheOverlay() {
  const auto follower = following({network(false), 2});
  OverlayFrame frame;
  for (int k = 1; k < 8; ++k) frame = follower->follow(film_.frame(k));
  QVERIFY(frame.level() == Level::withdrawn);
  QVERIFY(frame.validity == Validity::masked_out);
  QCOMPARE(frame.mask->share, 1.0);
}

void MaskNetworkTest::ANetworkThatIsNotThereIsAnError() {
  const auto path = folder_.path() / "absent.onnx";
  QVERIFY_THROWS_EXCEPTION(Error, following({path, 1}));
  // Beside a live loop it is told, and the organ is followed without it.
  const auto follower = following({path, 0});
  QVERIFY(follower->follow(film_.frame(1)).level() == Level::valid);
}

QTEST_APPLESS_MAIN(MaskNetworkTest)
#include "mask_network_test.moc"
