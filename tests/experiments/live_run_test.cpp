// SPDX-License-Identifier: GPL-3.0-or-later
// A pair of pictures that is set in motion, and runs of the live overlay on it.
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

/// The middle quarter of a picture: there tissue fills it.
template <class T>
std::vector<T> middle_of(const std::vector<T>& values, int width, int height, int channels) {
  std::vector<T> middle;
  for (int y = height / 4; y < 3 * height / 4; ++y) {
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(y) * width * channels;
    middle.insert(middle.end(), row + static_cast<std::ptrdiff_t>(width / 4) * channels,
                  row + static_cast<std::ptrdiff_t>(3 * width / 4) * channels);
  }
  return middle;
}
Picture middle_of(const Picture& picture) {
  return {picture.width / 2, picture.height / 2, picture.channels,
          std::make_shared<std::vector<std::uint8_t>>(
              middle_of(*picture.bytes, picture.width, picture.height, picture.channels))};
}

KnownPair known_pair() {
  insilico::TheatreOptions options;
  options.width = 960;
  options.height = 540;
  options.frames = 2;
  options.truth_vertices = 700;
  options.camera_distance_mm = 90.0;
  const auto theatre = insilico::Theatre::build(insilico::test::small_patient(), options, RunContext());
  const StereoFrame frame = (*theatre)->render(0);
  KnownPair known;
  known.depth = middle_of((*theatre)->depth(0), options.width, options.height, 1);
  auto liver = std::make_shared<std::vector<std::uint8_t>>();
  for (const float z : known.depth) liver->push_back(z > 0.0F ? 255 : 0);
  StereoRig rig = (*theatre)->rig();
  for (Camera* camera : {&rig.left, &rig.right}) {
    camera->matrix(0, 2) -= options.width / 4.0;
    camera->matrix(1, 2) -= options.height / 4.0;
    camera->width /= 2;
    camera->height /= 2;
  }
  known.pair = {middle_of(frame.left),
                middle_of(frame.right),
                {rig.left.width, rig.left.height, 1, std::move(liver)},
                rig};
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

  void TheFirstFrameIsThePair();
  void TargetsLieAsDeepAsIsSaid();
  void TheTissueMoves();
  void WhatMovesIsFollowedAndWhatIsBlackIsNot();
  void APartThatIsLiftedIsOneThatCounts();
  void WhatTheStageCannotShowIsNotRun();
  void WrongOptionsAreRefused();
  void CancelGivesNothing();

 private:
  KnownPair known_;
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
  QVERIFY(moved(stage_.lifted) > 1e-3);
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
