// SPDX-License-Identifier: GPL-3.0-or-later
// The proof of the live overlay on one patient without a fault, and a pair of pictures that is set in motion.
#include "live_run.h"

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/insilico/theatre.h"
#include "live_proof.h"
#include "moved_tissue.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::experiments;
namespace fs = std::filesystem;

namespace {

constexpr int kFrames = 40, kOnset = 12;

/// A pair whose depth is known, as a laparoscope shows it.
struct KnownPair {
  RealPair pair;
  std::vector<float> depth;  ///< metres along the axis, a value a pixel of the left picture
};

KnownPair known_pair() {
  insilico::TheatreOptions options;
  options.width = 480;
  options.height = 270;
  options.frames = 2;
  options.truth_vertices = 700;
  const auto theatre = insilico::Theatre::build(insilico::test::small_patient(), options, RunContext());
  const StereoFrame frame = (*theatre)->render(0);
  KnownPair known;
  known.depth = (*theatre)->depth(0);
  auto liver = std::make_shared<std::vector<std::uint8_t>>();
  for (const float z : known.depth) liver->push_back(z > 0.0F ? 255 : 0);
  known.pair = {
      frame.left, frame.right, {options.width, options.height, 1, std::move(liver)}, (*theatre)->rig()};
  return known;
}

std::size_t pixel_of(const Camera& camera, const Eigen::Vector3d& p) {
  const Eigen::Vector2d at = camera.project(p);
  return static_cast<std::size_t>(std::lround(at.y())) * static_cast<std::size_t>(camera.width) +
         static_cast<std::size_t>(std::lround(at.x()));
}

const LiveFault& fault_named(const std::vector<LiveFault>& faults, const std::string& name) {
  return *std::ranges::find(faults, name, &LiveFault::name);
}

}  // namespace

class LiveRunTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    known_ = known_pair();
    auto stage = pair_stage(known_.pair, kFrames, 1, RunContext());
    QVERIFY(stage);
    stage_ = std::move(*stage);
  }

  void WithoutAFaultTheOverlayStays();
  void TheFirstFrameIsThePair();
  void TargetsLieAsDeepAsIsSaid();
  void TheTissueMoves();
  void WhatMovesIsFollowedAndWhatIsBlackIsNot();
  void WhatTheStageCannotShowIsNotRun();
  void WrongOptionsAreRefused();
  void CancelGivesNothing();

 private:
  KnownPair known_;
  LiveStage stage_;
};

void LiveRunTest::WithoutAFaultTheOverlayStays() {
  const TemporaryFolder folder;
  LiveProofOptions options;
  options.seeds = {101};
  options.frames = 60;
  options.only = "none";
  const auto proof = prove_live(options, folder.path(), RunContext());
  QVERIFY(proof);
  QCOMPARE(proof->figures.at("live_near_sound_valid_share"), 1.0);
  QCOMPARE(proof->figures.at("live_far_frames"), 0.0);
  QVERIFY(proof->figures.at("live_of_frozen_share") < 0.5);
  QVERIFY(!proof->figures.contains("live_tissue_far_frames"));
  QVERIFY(std::ranges::count(proof->absent, "stereo_opencas") == 1 &&
          std::ranges::count(proof->absent, "stereo_heart") == 1);
  const std::string frames = read_file(folder.path() / "live.csv");
  QCOMPARE(std::ranges::count(frames, '\n'), 1 + 59);
  QVERIFY(read_file(folder.path() / "live.txt").find("none") != std::string::npos);
  QVERIFY(read_file(folder.path() / "lesions.csv").find(",none,") != std::string::npos);
}

/// Drawn anew from its own pictures where the tissue has not moved: the same but for two grey levels of
/// noise.
void LiveRunTest::TheFirstFrameIsThePair() {
  const StereoFrame& first = stage_.standing.film.front();
  for (const auto& [drawn, shown] :
       {std::pair{&first.left, &known_.pair.left}, {&first.right, &known_.pair.right}}) {
    QCOMPARE(drawn->width, shown->width);
    QCOMPARE(drawn->channels, shown->channels);
    double off = 0.0;
    int count = 0;
    const int w = shown->width, h = shown->height;
    for (int y = h / 3; y < 2 * h / 3; ++y)
      for (int x = w / 3; x < 2 * w / 3; ++x, ++count) {
        const auto i = static_cast<std::size_t>(3 * (y * w + x));
        off += std::abs(static_cast<double>((*drawn->bytes)[i]) - (*shown->bytes)[i]);
      }
    QVERIFY2(off / count < 6.0, qPrintable(QString::number(off / count)));
  }
}

/// Against the depth that the theatre knows: 5, 10, 15 and 20 mm along the rays from the lens.
void LiveRunTest::TargetsLieAsDeepAsIsSaid() {
  QCOMPARE(stage_.targets_in_model.rows(), 4);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Eigen::Vector3d target = stage_.targets_in_model.row(i).transpose();
    const double z = known_.depth[pixel_of(known_.pair.rig.left, target)];
    QVERIFY(z > 0.0);
    const double below = target.norm() * (1.0 - z / target.z());
    QVERIFY2(std::abs(below - 5e-3 * static_cast<double>(i + 1)) < 2e-3,
             qPrintable(QString::number(1e3 * below)));
  }
  QVERIFY((stage_.standing.targets.front() - stage_.targets_in_model).cwiseAbs().maxCoeff() < 1e-9);
}

void LiveRunTest::TheTissueMoves() {
  QCOMPARE(static_cast<int>(stage_.standing.film.size()), kFrames);
  const auto moved = [](const Filmed& filmed) {
    return (filmed.targets.back() - filmed.targets.front()).rowwise().norm().maxCoeff();
  };
  QVERIFY(moved(stage_.standing) > 1e-3 && moved(stage_.standing) < 10e-3);
  QVERIFY(moved(stage_.held) > moved(stage_.standing));
  QVERIFY(moved(stage_.lifted) > 1e-3);
  QVERIFY(*stage_.standing.film.front().left.bytes != *stage_.standing.film.back().left.bytes);
}

void LiveRunTest::WhatMovesIsFollowedAndWhatIsBlackIsNot() {
  const auto faults = live_faults(stage_.rig, kOnset, kFrames - 1, 1);
  const auto sound = run_live(stage_, fault_named(faults, "none"), kOnset);
  QCOMPARE(static_cast<int>(sound.size()), kFrames - 1);
  for (const JudgedFrame& judged : sound) {
    QVERIFY(judged.is_valid() && !judged.faulty && judged.shown_before());
    QVERIFY2(judged.error < 3e-3, qPrintable(QString::number(1e3 * judged.error)));
  }
  QVERIFY(sound.back().error < sound.back().frozen);
  const auto black = run_live(stage_, fault_named(faults, "black"), kOnset);
  QVERIFY(black[kOnset / 2].is_valid() && !black[kOnset / 2].faulty);
  QVERIFY(!black.back().is_valid() && black.back().faulty && !black.back().shown_before());
  const std::string line = frame_line("tissue", "black", black.back());
  QCOMPARE(std::ranges::count(line, ','), std::ranges::count(std::string(kFrameHeads), ','));
}

void LiveRunTest::WhatTheStageCannotShowIsNotRun() {
  const auto faults = live_faults(stage_.rig, kOnset, kFrames - 1, 1);
  const LiveFault& other = fault_named(faults, "another_patient");
  QVERIFY(!can_run(stage_, other) && can_run(stage_, fault_named(faults, "none")));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, run_live(stage_, other, kOnset));
}

void LiveRunTest::WrongOptionsAreRefused() {
  LiveProofOptions options;
  options.frames = 30;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options = {};
  options.onset = 110;
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
  options = {};
  options.seeds = {};
  QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
}

void LiveRunTest::CancelGivesNothing() {
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  const RunContext context({}, flag, 1);
  QVERIFY(!pair_stage(known_.pair, 3, 1, context));
  const TemporaryFolder folder;
  QVERIFY(!prove_live({}, folder.path(), context));
  QVERIFY(fs::is_empty(folder.path()));
}

QTEST_GUILESS_MAIN(LiveRunTest)
#include "live_run_test.moc"
