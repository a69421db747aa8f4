// SPDX-License-Identifier: GPL-3.0-or-later
// A pair of pictures that is set in motion, and runs of the live overlay on it.
#include "live_run.h"

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "known_pair.h"
#include "live_proof.h"
#include "moved_tissue.h"

using namespace glisson;
using namespace glisson::experiments;
namespace fs = std::filesystem;

namespace {

constexpr int kFrames = 40, kOnset = 12;

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
    known_ = test::known_pair();
    auto stage = pair_stage(known_.pair, kFrames, 1, RunContext());
    QVERIFY(stage);
    stage_ = std::move(*stage);
  }

  void TheFirstFrameIsThePair();
  void TargetsLieAsDeepAsIsSaid();
  void TheTissueMoves();
  void WhatMovesIsFollowedAndWhatIsBlackIsNot();
  void APartThatIsLiftedIsOneThatCounts();
  void WhatTheStageCannotShowIsNotRun();
  void WrongOptionsAreRefused();
  void CancelGivesNothing();

 private:
  test::KnownPair known_;
  LiveStage stage_;
};

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

/// Against the depth that the theatre knows: 5, 10, 15 and 20 mm along the rays from the lens. The relief is
/// smoother than the tissue.
void LiveRunTest::TargetsLieAsDeepAsIsSaid() {
  QCOMPARE(stage_.targets_in_model.rows(), 4);
  for (Eigen::Index i = 0; i < 4; ++i) {
    const Eigen::Vector3d target = stage_.targets_in_model.row(i).transpose();
    const double z = known_.depth[pixel_of(known_.pair.rig.left, target)];
    QVERIFY(z > 0.0);
    const double below = target.norm() * (1.0 - z / target.z());
    QVERIFY2(std::abs(below - 5e-3 * static_cast<double>(i + 1)) < 3e-3,
             qPrintable(QString("%1: %2").arg(i).arg(1e3 * below)));
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
  QVERIFY(moved(stage_.lifted) > 1e-3 && moved(stage_.cut) > 1e-3);
  QVERIFY(moved(stage_.fast) > moved(stage_.standing));
  QVERIFY(*stage_.standing.film.front().left.bytes != *stage_.standing.film.back().left.bytes);
}

void LiveRunTest::WhatMovesIsFollowedAndWhatIsBlackIsNot() {
  const auto faults = live_faults(stage_.rig, kOnset, kFrames - 1, 1);
  const auto sound = run_live(stage_, fault_named(faults, "none"), kOnset);
  QCOMPARE(static_cast<int>(sound.size()), kFrames - 1);
  for (const JudgedFrame& judged : sound) {
    QVERIFY2(judged.is_valid() && !judged.faulty && judged.shown_before(),
             qPrintable(QString("frame %1: %2, %3 mm")
                            .arg(judged.frame)
                            .arg(static_cast<int>(judged.overlay.validity))
                            .arg(1e3 * judged.error)));
    QVERIFY2(judged.error < 3e-3, qPrintable(QString::number(1e3 * judged.error)));
  }
  QVERIFY(sound.back().error < sound.back().frozen);
  const auto black = run_live(stage_, fault_named(faults, "black"), kOnset);
  QVERIFY(black[kOnset / 2].is_valid() && !black[kOnset / 2].faulty);
  QVERIFY(!black.back().is_valid() && black.back().faulty && !black.back().shown_before());
  const std::string line = frame_line("tissue", "black", black.back());
  QCOMPARE(std::ranges::count(line, ','), std::ranges::count(std::string(kFrameHeads), ','));
}

/// It is where a target is, and in sight.
void LiveRunTest::APartThatIsLiftedIsOneThatCounts() {
  const auto faults = live_faults(stage_.rig, kOnset, kFrames - 1, 1);
  const auto run = run_live(stage_, fault_named(faults, "start_lifted_30mm"), kOnset);
  QVERIFY2(run.front().frozen > 25e-3, qPrintable(QString::number(1e3 * run.front().frozen)));
  for (const JudgedFrame& judged : run)
    if (judged.error > 10e-3) QVERIFY2(!judged.is_valid(), qPrintable(QString::number(judged.frame)));
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
