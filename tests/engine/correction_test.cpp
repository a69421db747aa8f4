// SPDX-License-Identifier: GPL-3.0-or-later
// A hand's corrections reach what follows the organ, in order with its frames, and the live part tells them.
#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/correct_tracking.h"
#include "glisson/engine/commands/start_tracking.h"
#include "glisson/engine/commands/stop_tracking.h"
#include "glisson/engine/commands/undo_correction.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/engine/placed_correction.h"
#include "glisson/geometry/topology.h"
#include "runners.h"

using namespace glisson;
using namespace glisson::engine;

namespace {

/// Its only node is moved by what hands say.
class HandledFollower : public Follower {
 public:
  OverlayFrame follow(const LiveInput& input) override {
    overlay_.index = std::get<StereoFrame>(input).index;
    return overlay();
  }
  OverlayFrame correct(const Correction& correction) override {
    if (correction.to.x() > 1000.0)
      throw InputError("correction", "the place", "would be outside of the picture", "Drag less far");
    CorrectionMade made;
    made.correction = correction;
    made.frame = overlay_.index;
    made_.push_back(made);
    return overlay();
  }
  OverlayFrame undo_correction() override {
    if (made_.empty()) return Follower::undo_correction();
    made_.pop_back();
    return overlay();
  }
  std::vector<CorrectionMade> corrections() const override { return made_; }

 private:
  OverlayFrame overlay() {
    overlay_.validity = Validity::valid;
    overlay_.nodes_in_camera = Points::Constant(1, 3, static_cast<double>(made_.size()));
    return overlay_;
  }
  OverlayFrame overlay_;
  std::vector<CorrectionMade> made_;
};

struct Plain : Follower {
  OverlayFrame follow(const LiveInput&) override { return {}; }
};

template <class Made>
Engine::Options options(Runner runner) {
  Engine::Options options;
  options.runner = runner;
  // Commands as they are, without what a real case would need.
  options.apply = [](const CaseState& state, const Command& command, const RunContext& context,
                     const Services& services) { return command.apply(state, context, services); };
  options.make_follower = [](const CaseState&, const StartTracking&) { return std::make_unique<Made>(); };
  return options;
}

StereoFrame numbered(int index) {
  StereoFrame frame;
  frame.index = index;
  return frame;
}

}  // namespace

class CorrectionTest : public QObject {
  Q_OBJECT
 private slots:
  void TheLivePartTellsWhatStands_data() { test::both_runners(); }
  void TheLivePartTellsWhatStands();
  void ARefusedOneChangesNothing_data() { test::both_runners(); }
  void ARefusedOneChangesNothing();
  void NothingIsCorrectedUnlessItIsFollowed_data() { test::both_runners(); }
  void NothingIsCorrectedUnlessItIsFollowed();
  void ALineOfAFileTakesHoldOfWhatIsDrawn();

 private:
  static void follow(Engine& engine, int index) {
    engine.submit_frame(numbered(index));
    engine.wait_for_frames();
  }
  static LiveState live(const Engine& engine) { return *engine.snapshot()->state[part::live]; }
  static Outcome ask(Engine& engine, Command command) { return engine.wait(engine.post(std::move(command))); }
};

void CorrectionTest::TheLivePartTellsWhatStands() {
  QFETCH(Runner, runner);
  Engine engine(options<HandledFollower>(runner));
  QCOMPARE(ask(engine, StartTracking{}).status, Status::done);
  follow(engine, 3);
  QVERIFY(live(engine).corrections.empty());
  const Outcome outcome = ask(engine, CorrectTracking{});
  QCOMPARE(outcome.status, Status::done);
  QCOMPARE(outcome.figures.at("corrections"), 1.0);
  QCOMPARE(live(engine).corrections.size(), std::size_t{1});
  QCOMPARE(live(engine).corrections.front().frame, 3);
  QCOMPARE(live(engine).overlay.nodes_in_camera(0, 0), 1.0);  // without another frame
  QCOMPARE(live(engine).frames, 1);
  ask(engine, CorrectTracking{});
  follow(engine, 4);
  QCOMPARE(live(engine).corrections.size(), std::size_t{2});
  ask(engine, UndoCorrection{});
  QCOMPARE(live(engine).corrections.size(), std::size_t{1});
  QCOMPARE(live(engine).overlay.nodes_in_camera(0, 0), 1.0);
  QCOMPARE(ask(engine, StartTracking{}).status, Status::done);
  QVERIFY(live(engine).corrections.empty());  // another beginning
}

void CorrectionTest::ARefusedOneChangesNothing() {
  QFETCH(Runner, runner);
  Engine engine(options<HandledFollower>(runner));
  ask(engine, StartTracking{});
  follow(engine, 1);
  ask(engine, CorrectTracking{});
  CorrectTracking far;
  far.correction.to.x() = 2000.0;
  const auto before = engine.snapshot();
  const Outcome outcome = ask(engine, far);
  QCOMPARE(outcome.status, Status::failed);
  QVERIFY(outcome.error.find("outside of the picture") != std::string::npos);
  QCOMPARE(engine.snapshot()->revision, before->revision);
  QVERIFY(engine.snapshot()->tracking);  // it goes on
  follow(engine, 2);
  QCOMPARE(live(engine).corrections.size(), std::size_t{1});
}

void CorrectionTest::NothingIsCorrectedUnlessItIsFollowed() {
  QFETCH(Runner, runner);
  Engine engine(options<Plain>(runner));
  QVERIFY(obstacle(CaseState(), CorrectTracking{}));
  ask(engine, StartTracking{});
  QCOMPARE(ask(engine, CorrectTracking{}).status, Status::failed);  // such a follower takes none
  QCOMPARE(ask(engine, UndoCorrection{}).status, Status::failed);
  ask(engine, StopTracking{});
  QCOMPARE(ask(engine, CorrectTracking{}).status, Status::failed);
}

/// A tetrahedron whose front face lies at 150 mm, seen by lenses without distortion: where a pixel meets it
/// is a product.
void CorrectionTest::ALineOfAFileTakesHoldOfWhatIsDrawn() {
  constexpr double kFocal = 500.0, kFront = 0.15, kBase = 4e-3;
  const Eigen::Vector3d moved(-0.01, -0.01, kFront);
  auto built = std::make_shared<model::BuiltModel>();
  built->model.mesh.vertices.resize(4, 3);
  built->model.mesh.vertices << 0.0, 0.0, 0.0, 0.04, 0.0, 0.0, 0.0, 0.04, 0.0, 0.0, 0.0, 0.04;
  built->model.mesh.tetrahedra.resize(1, 4);
  built->model.mesh.tetrahedra << 0, 1, 2, 3;
  built->model.surface = boundary_surface(built->model.mesh);
  auto rig = std::make_shared<StereoRig>();
  for (Camera* camera : {&rig->left, &rig->right}) {
    camera->width = 640;
    camera->height = 480;
    camera->matrix << kFocal, 0.0, 320.0, 0.0, kFocal, 240.0, 0.0, 0.0, 1.0;
  }
  rig->right_from_left.translation.x() = -kBase;
  auto seen = std::make_shared<LiveState>();
  seen->overlay.nodes_in_camera = built->model.mesh.vertices.rowwise() + moved.transpose();
  CaseState state;
  state[part::model] = built;
  state[part::rig] = rig;
  state[part::live] = seen;

  CorrectionLine line;
  line.frame = 7;
  line.correction = Correction();
  line.correction->from = {345.0, 225.0};
  line.correction->to = {350.0, 226.0};
  const Correction picked = placed_correction(state, line, "c.jsonl");
  const Eigen::Vector3d met = kFront * Eigen::Vector3d(25.0 / kFocal, -15.0 / kFocal, 1.0);
  QVERIFY((picked.place_in_ct - (met - moved)).norm() < 1e-9);
  QVERIFY((picked.from - line.correction->from).norm() < 1e-6);
  QVERIFY(picked.feature == CorrectedFeature::surface && picked.to == line.correction->to);

  // Whose place is known is where that is drawn, whatever the line said of it.
  line.has_place = true;
  line.correction->place_in_ct = met - moved;
  line.correction->from = {1.0, 1.0};
  line.correction->view = StereoView::right;
  const Correction placed = placed_correction(state, line, "c.jsonl");
  QVERIFY((placed.from - Eigen::Vector2d(345.0 - kFocal * kBase / kFront, 225.0)).norm() < 1e-6);
  QVERIFY(placed.place_in_ct == line.correction->place_in_ct);

  line.has_place = false;
  const std::string told = test::complaint([&] { (void)placed_correction(state, line, "c.jsonl"); });
  QVERIFY2(told.find("c.jsonl") != std::string::npos && told.find("frame 7") != std::string::npos &&
               told.find("beside the organ") != std::string::npos,
           told.c_str());
}

QTEST_APPLESS_MAIN(CorrectionTest)
#include "correction_test.moc"
