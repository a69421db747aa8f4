// SPDX-License-Identifier: GPL-3.0-or-later
// A person's own network labels the CT of a case: what a hand has corrected stays until a person decides.
#include "glisson/engine/commands/segment_by_network.h"

#include <QTest>

#include "glisson/core/files.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/engine/commands/decide_segmentation.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/undo_labels.h"
#include "glisson/engine/engine.h"
#include "glisson/engine/hand_edits.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/offer.h"
#include "glisson/volume/io.h"
#include "network_files.h"

using namespace glisson;
using namespace glisson::engine;
using Choice = DecideSegmentation::Choice;

namespace {

const char* const kSheet =
    R"({"window_hu": [0, 200], "channels": ["background", "parenchyma"], "tile": [16, 16]})";

}  // namespace

class SegmentByNetworkTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void ItNeedsNoSeedsAndNoLabels();
  void CorrectionsAreReplacedOnlyWhenThatWasSaid();
  void TheOfferIsDecidedAsAnyOther();
  void SeedsAreNothingToIt();
  void WhatIsLockedAsksNobody();
  void ABadNetworkChangesNothing();

 private:
  Outcome done(Command command) { return engine_->wait(engine_->post(std::move(command))); }
  const CaseState& state() { return engine_->snapshot()->state; }
  const LabelVolume& labels() { return state()[part::labels]->voxels; }
  void correct();

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<Engine> engine_;
  std::filesystem::path network_;
};

void SegmentByNetworkTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  Image image = test::ct_of({40, 36, 30}, [](const Eigen::Vector3i& v) { return v.x() < 20 ? 110 : -100; });
  image.grid.spacing_mm = {3.0, 3.0, 3.0};
  write_image(folder_->path() / "ct.nrrd", image);
  network_ = test::write_network(folder_->path(), test::bright_or_dark({1, 1, -1, -1}), kSheet);
  Engine::Options options;
  options.runner = Runner::inline_;
  engine_ = std::make_unique<Engine>(std::move(options));
  QCOMPARE(done(ImportImage{folder_->path() / "ct.nrrd"}).status, Status::done);
}

/// A hand adds a ball where the network sees no liver.
void SegmentByNetworkTest::correct() {
  QCOMPARE(done(SegmentByNetwork{network_, {}}).status, Status::done);
  editing::Paint paint;
  paint.label = structure::kParenchyma;
  paint.brush = editing::Paint::Brush::ball;
  paint.radius = 9e-3;
  paint.path = 1e-3 * Eigen::RowVector3d(90.0, 45.0, 45.0);
  QCOMPARE(done(EditLabels{{paint, {}}}).status, Status::done);
  QCOMPARE(labels().at({30, 15, 15}), structure::kParenchyma);
}

void SegmentByNetworkTest::ItNeedsNoSeedsAndNoLabels() {
  const Outcome outcome = done(SegmentByNetwork{network_, {}});
  QVERIFY2(outcome.status == Status::done, outcome.error.c_str());
  QCOMPARE(labels().at({19, 5, 5}), structure::kParenchyma);
  QCOMPARE(labels().at({20, 5, 5}), structure::kBackground);
  QCOMPARE(outcome.figures.at("label_parenchyma_ml"), 20.0 * 36 * 30 * 0.027);
  QVERIFY(outcome.figures.at("network_tiles") >= 30.0);
  QCOMPARE(engine_->snapshot()->stage(part::labels), StageState::current);
}

void SegmentByNetworkTest::CorrectionsAreReplacedOnlyWhenThatWasSaid() {
  correct();
  const LabelVolume mine = labels();
  const Outcome refused = done(SegmentByNetwork{network_, {}});
  QVERIFY2(refused.error.find("was corrected by hand") != std::string::npos, refused.error.c_str());
  QCOMPARE(done(SegmentByNetwork{network_, {}, OverHandWork::keep_hand}).status, Status::done);
  QVERIFY(labels() == mine);
  QCOMPARE(done(SegmentByNetwork{network_, {}, OverHandWork::replace}).status, Status::done);
  QCOMPARE(labels().at({30, 15, 15}), structure::kBackground);
}

void SegmentByNetworkTest::TheOfferIsDecidedAsAnyOther() {
  correct();
  const LabelVolume mine = labels();
  const Outcome offered = done(SegmentByNetwork{network_, {}, OverHandWork::offer});
  QVERIFY(state()[part::offer] != nullptr && labels() == mine);
  QVERIFY(offered.figures.at("lost_parenchyma_ml") > 0.5);
  const Outcome decided = done(DecideSegmentation{Choice::take});
  QVERIFY2(decided.status == Status::done, decided.error.c_str());
  QCOMPARE(labels().at({30, 15, 15}), structure::kBackground);
  QCOMPARE(done(UndoLabels{}).status, Status::done);
  QVERIFY(labels() == mine);
}

void SegmentByNetworkTest::SeedsAreNothingToIt() {
  const auto click = [&](double x) {
    segmentation::Seeds seeds;
    seeds.liver = PointsIn<CtFrame>::Constant(1, 3, x);
    QCOMPARE(done(SetSeeds{seeds}).status, Status::done);
  };
  click(0.03);
  QCOMPARE(done(SegmentByNetwork{network_, {}}).status, Status::done);
  click(0.04);
  QCOMPARE(engine_->snapshot()->stage(part::labels), StageState::current);
  correct();
  QCOMPARE(done(SegmentByNetwork{network_, {}, OverHandWork::offer}).status, Status::done);
  click(0.05);
  const auto offer = state()[part::offer];
  QCOMPARE(done(DecideSegmentation{Choice::take, offer->keeps_labels, offer}).status, Status::done);
  click(0.06);
  QCOMPARE(engine_->snapshot()->stage(part::labels), StageState::current);
}

void SegmentByNetworkTest::WhatIsLockedAsksNobody() {
  correct();
  const LabelVolume mine = labels();
  QCOMPARE(done(SegmentByNetwork{network_, {structure::kParenchyma}}).status, Status::done);
  QVERIFY(labels() == mine && !state()[part::offer]);
}

void SegmentByNetworkTest::ABadNetworkChangesNothing() {
  const Outcome missing = done(SegmentByNetwork{folder_->path() / "none.onnx", {}});
  QVERIFY2(missing.error.find("none.json: does not exist") != std::string::npos, missing.error.c_str());
  write_file_atomically(network_, "This is no network.");
  const Outcome bad = done(SegmentByNetwork{network_, {}});
  QVERIFY2(bad.error.find("net.onnx: is no ONNX network") != std::string::npos, bad.error.c_str());
  QVERIFY(!state()[part::labels]);
}

QTEST_APPLESS_MAIN(SegmentByNetworkTest)
#include "segment_by_network_test.moc"
