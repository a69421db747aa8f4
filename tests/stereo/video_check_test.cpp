// SPDX-License-Identifier: GPL-3.0-or-later
// A whole video looked through: which frames are told, and when one is held against the calibration.
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/stereo/faults.h"
#include "glisson/stereo/picture_io.h"
#include "rendered_pair.h"

using namespace glisson;
using namespace glisson::stereo;
namespace fs = std::filesystem;

class VideoCheckTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void SoundPairsHaveNoFaults();
  void SwappedViewsAreToldOnceForEachFrameThatIsHeldAgainstTheCalibration();
  void WithoutACalibrationOnlyTheFramesAreLookedAt();
  void BlackFramesAreTold();
  void CancelGivesNothing();
  void ACalibrationOfAnotherSizeIsRefused();
  void OptionsOutOfRangeAreRefused();

 private:
  using Frames = std::vector<std::pair<Picture, Picture>>;
  /// The frames as files, looked through.
  static Cancellable<VideoFaults> checked(const Frames& frames, const std::optional<StereoRig>& rig,
                                          int every, const RunContext& context = {},
                                          const FaultTold& told = {}) {
    const TemporaryFolder folder;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      write_picture(folder.path() / ("left-" + std::to_string(i) + ".png"), frames[i].first);
      write_picture(folder.path() / ("right-" + std::to_string(i) + ".png"), frames[i].second);
    }
    StereoVideo video(folder.path());
    return check_video(video, rig, {every}, context, told);
  }

  std::vector<rendered::Pair> pairs_;  ///< of a scene that moves
};

void VideoCheckTest::initTestCase() {
  for (int i = 0; i < 4; ++i)
    pairs_.push_back(rendered::pair(rendered::plane({0.0, 0.0, 0.09 + 0.002 * i}, {0.1, 0.2, -1.0})));
}

void VideoCheckTest::SoundPairsHaveNoFaults() {
  Frames frames;
  for (const auto& pair : pairs_) frames.emplace_back(pair.left, pair.right);
  const auto found = checked(frames, pairs_[0].rig, 2);
  QCOMPARE(found->frames, 4);
  QCOMPARE(found->skipped, 0);
  QVERIFY(found->faults.empty());
}

void VideoCheckTest::SwappedViewsAreToldOnceForEachFrameThatIsHeldAgainstTheCalibration() {
  Frames frames;
  for (const auto& pair : pairs_) frames.emplace_back(pair.right, pair.left);
  std::vector<FrameFault> told;
  const auto found =
      checked(frames, pairs_[0].rig, 2, {}, [&](const FrameFault& fault) { told.push_back(fault); });
  QVERIFY((found->faults == std::vector<FrameFault>{{0, Fault::swapped}, {2, Fault::swapped}}));
  QVERIFY(told == found->faults);
}

void VideoCheckTest::WithoutACalibrationOnlyTheFramesAreLookedAt() {
  Frames frames;
  for (const auto& pair : pairs_) frames.emplace_back(pair.right, pair.left);
  QVERIFY(checked(frames, {}, 1)->faults.empty());
}

void VideoCheckTest::BlackFramesAreTold() {
  Frames frames;
  for (const auto& pair : pairs_) frames.emplace_back(pair.left, pair.right);
  const auto dark =
      std::make_shared<const std::vector<std::uint8_t>>(pairs_[0].left.bytes->size(), std::uint8_t{2});
  frames[2].first.bytes = frames[2].second.bytes = dark;
  // Held against nothing: it is known to be at fault.
  QVERIFY((checked(frames, pairs_[0].rig, 1)->faults == std::vector<FrameFault>{{2, Fault::black}}));
}

void VideoCheckTest::CancelGivesNothing() {
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  QVERIFY(!checked({{pairs_[0].left, pairs_[0].right}}, {}, 1, RunContext({}, cancel, 1)));
}

void VideoCheckTest::ACalibrationOfAnotherSizeIsRefused() {
  StereoRig rig = pairs_[0].rig;
  rig.left.width = rig.right.width = 320;
  QVERIFY_THROWS_EXCEPTION(InputError, checked({{pairs_[0].left, pairs_[0].right}}, rig, 1));
}

void VideoCheckTest::OptionsOutOfRangeAreRefused() {
  VideoCheckOptions{}.validate();
  QVERIFY_THROWS_EXCEPTION(PreconditionError, VideoCheckOptions{0}.validate());
}

QTEST_APPLESS_MAIN(VideoCheckTest)
#include "video_check_test.moc"
