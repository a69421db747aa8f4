// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/faults.h"

#include <QtTest>
#include <functional>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/insilico/theatre.h"
#include "glisson/stereo/picture_io.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::stereo;

namespace {

constexpr int kFrames = 24;

Picture filled(const Picture& like, std::uint8_t value) {
  return {like.width, like.height, like.channels,
          std::make_shared<std::vector<std::uint8_t>>(like.bytes->size(), value)};
}

/// The theatre's operation, rendered once.
struct Film {
  StereoRig rig;
  std::vector<StereoFrame> frames;
};
const Film& film() {
  static const Film made = [] {
    insilico::TheatreOptions options;
    options.width = 480;
    options.height = 270;
    options.frames = 121;
    options.truth_vertices = 700;
    const auto theatre =
        insilico::Theatre::build(insilico::test::small_patient(), options, RunContext()).value();
    Film result;
    result.rig = theatre->rig();
    for (int i = 0; i < kFrames; ++i) result.frames.push_back(theatre->render(i));
    return result;
  }();
  return made;
}

Picture side_by_side(const StereoFrame& frame) {
  const auto row = static_cast<std::ptrdiff_t>(3 * frame.left.width);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>();
  for (int y = 0; y < frame.left.height; ++y)
    for (const Picture* view : {&frame.left, &frame.right})
      bytes->insert(bytes->end(), view->bytes->begin() + y * row, view->bytes->begin() + (y + 1) * row);
  return {2 * frame.left.width, frame.left.height, 3, std::move(bytes)};
}

std::vector<FrameFault> faults_of(const std::vector<StereoFrame>& frames) {
  SequenceCheck check;
  std::vector<FrameFault> found;
  int index = 0;
  for (StereoFrame frame : frames) {
    frame.index = index;  // as a reader counts them
    frame.seconds = index++ / 30.0;
    for (const FrameFault& fault : check.push(frame)) found.push_back(fault);
  }
  return found;
}

/// The operation with a fault in it.
std::vector<FrameFault> with(const std::function<void(std::vector<StereoFrame>&)>& injure) {
  std::vector<StereoFrame> frames = film().frames;
  injure(frames);
  return faults_of(frames);
}

std::string text(const std::vector<FrameFault>& faults) {
  std::string result;
  for (const FrameFault& fault : faults)
    result += std::to_string(fault.frame) + ":" + std::string(fault_code(fault.fault)) + " ";
  return result;
}

PairCheck check(const Picture& left, const Picture& right, const StereoRig& rig = film().rig) {
  return check_pair(left, right, rig);
}

}  // namespace

#define COMPARE_FAULTS(found, expected) QCOMPARE(QByteArray::fromStdString(text(found)), QByteArray(expected))

class FaultsTest : public QObject {
  Q_OBJECT

 private slots:
  void SoundOperationHasNoFaults() { COMPARE_FAULTS(faults_of(film().frames), ""); }

  void BlackFramesAreRecognised() {
    COMPARE_FAULTS(with([](auto& frames) {
                     for (const int i : {5, 6}) {
                       frames[static_cast<std::size_t>(i)].left = filled(frames[0].left, 3);
                       frames[static_cast<std::size_t>(i)].right = filled(frames[0].right, 4);
                     }
                   }),
                   "5:black 6:black ");
  }

  void LostCamerasAreRecognised() {
    COMPARE_FAULTS(with([](auto& frames) {
                     frames[7].left = filled(frames[0].left, 0);      // no signal
                     frames[9].right = filled(frames[0].right, 128);  // a grabber's grey
                   }),
                   "7:left_lost 9:right_lost ");
  }

  void OneCameraOnBothInputsIsRecognised() {
    COMPARE_FAULTS(with([](auto& frames) { frames[4].right = frames[4].left; }), "4:one_view ");
  }

  void DuplicatesAndFreezesAreToldApart() {
    COMPARE_FAULTS(with([](auto& frames) { frames.insert(frames.begin() + 8, frames[7]); }), "8:duplicated ");
    const auto faults = with([](auto& frames) { frames.insert(frames.begin() + 8, 10, frames[7]); });
    QCOMPARE(faults.size(), std::size_t{10});
    QVERIFY(faults.front() == (FrameFault{8, Fault::duplicated}));
    QVERIFY(faults.back() == (FrameFault{17, Fault::frozen}));
    QVERIFY(faults[5] == (FrameFault{13, Fault::frozen}));  // a fifth of a second after frame 7
  }

  void OneFrozenViewIsRecognised() {
    const auto faults = with([](auto& frames) {
      for (std::size_t i = 11; i < 14; ++i) frames[i].right = frames[10].right;
    });
    COMPARE_FAULTS(faults, "11:right_frozen 12:right_frozen 13:right_frozen ");
  }

  void SwappedViewsAreRecognisedFromWhereTheyBegin() {
    COMPARE_FAULTS(with([](auto& frames) {
                     for (std::size_t i = 6; i < 9; ++i) std::swap(frames[i].left, frames[i].right);
                   }),
                   "6:swapped 7:swapped 8:swapped ");
  }

  void ExchangedFramesAreRecognised() {
    // Every third frame, so that the tissue moves enough to tell.
    std::vector<StereoFrame> frames;
    for (std::size_t i = 0; i < film().frames.size(); i += 3) frames.push_back(film().frames[i]);
    COMPARE_FAULTS(faults_of(frames), "");
    std::swap(frames[3], frames[4]);
    COMPARE_FAULTS(faults_of(frames), "4:out_of_order ");
  }

  /// As a recorder stores them: views side by side, with loss. Frames that were alike are not then.
  void FaultsAreRecognisedInARecordedVideo_data() {
    QTest::addColumn<int>("fault");
    QTest::addColumn<QByteArray>("expected");
    const char* const kExpected[] = {"", "5:black 6:black ", "7:left_lost ", "9:right_lost ",
                                     "6:swapped 7:swapped 8:swapped "};
    for (int i = 0; i < static_cast<int>(std::size(kExpected)); ++i)
      QTest::newRow(i == 0 ? "sound" : kExpected[i]) << i << QByteArray(kExpected[i]);
  }
  void FaultsAreRecognisedInARecordedVideo() {
    QFETCH(int, fault);
    QFETCH(QByteArray, expected);
    std::vector<StereoFrame> frames(film().frames.begin(), film().frames.begin() + 16);
    const auto at = [&](int i) -> StereoFrame& { return frames[static_cast<std::size_t>(i)]; };
    switch (fault) {
      case 1:
        for (const int i : {5, 6}) at(i).left = at(i).right = filled(at(0).left, 3);
        break;
      case 2:
        at(7).left = filled(at(0).left, 0);
        break;
      case 3:
        at(9).right = filled(at(0).right, 128);
        break;
      case 4:
        for (const int i : {6, 7, 8}) std::swap(at(i).left, at(i).right);
        break;
      default:
        break;
    }
    const TemporaryFolder folder;
    const auto path = folder.path() / "operation.mkv";
    VideoWriter writer(path, 2 * frames[0].left.width, frames[0].left.height, 30.0);
    for (const StereoFrame& frame : frames) writer.write(side_by_side(frame));
    writer.close();
    StereoVideo video(path);
    SequenceCheck check;
    std::vector<FrameFault> found;
    for (StereoFrame frame; video.read(frame);)
      for (const FrameFault& one : check.push(frame)) found.push_back(one);
    COMPARE_FAULTS(found, expected);
  }

  void SoundPairIsFoundSound() {
    const PairCheck sound = check(film().frames[3].left, film().frames[3].right);
    qInfo("%d matches, rows %.2f px, %.0f %% plausible", sound.matches, sound.rows_px,
          100.0 * sound.plausible);
    QVERIFY(sound.faults.empty());
    QVERIFY(sound.matches >= 20 && sound.rows_px < 1.0 && sound.plausible > 0.9);
    require_sound(sound);
  }

  void FaultsOfAPairAreRecognisedAndSaid() {
    const Picture &left = film().frames[3].left, &right = film().frames[3].right;
    const auto said = [](const PairCheck& result, Fault fault) {
      if (result.faults != std::vector<Fault>{fault}) return false;
      try {
        require_sound(result);
      } catch (const InputError& error) {
        return !error.remedy().empty();
      }
      return false;
    };
    QVERIFY(said(check(filled(left, 2), filled(right, 2)), Fault::black));
    QVERIFY(said(check(filled(left, 2), right), Fault::left_lost));
    QVERIFY(said(check(left, filled(right, 2)), Fault::right_lost));
    QVERIFY(said(check(left, left), Fault::one_view));
    QVERIFY(said(check(right, left), Fault::swapped));
  }

  void CalibrationOfAnotherScopeIsRecognised() {
    const Picture &left = film().frames[3].left, &right = film().frames[3].right;
    StereoRig pitched = film().rig;  // a scope whose cameras point 0.8 degrees apart in height
    pitched.right_from_left.rotation = Eigen::AngleAxisd(0.014, Eigen::Vector3d::UnitX()).toRotationMatrix() *
                                       pitched.right_from_left.rotation;
    QVERIFY(check(left, right, pitched).has(Fault::other_scope));
    StereoRig parallel = film().rig;  // another convergence: everything would lie behind the cameras
    parallel.right_from_left.rotation =
        Eigen::AngleAxisd(-0.12, Eigen::Vector3d::UnitY()).toRotationMatrix() *
        parallel.right_from_left.rotation;
    QVERIFY(!check(left, right, parallel).faults.empty());
    StereoRig larger = film().rig;
    larger.left.width = 960;
    QVERIFY_THROWS_EXCEPTION(InputError, check(left, right, larger));
  }

  void ViewsOfTwoPlacesAreUnrelated() {
    // The right view upside down: as much texture, nothing in common.
    const Picture& right = film().frames[3].right;
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(*right.bytes);
    for (std::size_t p = 0; p < bytes->size() / 3; ++p)
      std::copy_n(right.bytes->end() - 3 * static_cast<std::ptrdiff_t>(p + 1), 3,
                  bytes->begin() + 3 * static_cast<std::ptrdiff_t>(p));
    const PairCheck result = check(film().frames[3].left, {right.width, right.height, 3, bytes});
    QVERIFY(!result.faults.empty());
  }
};

QTEST_APPLESS_MAIN(FaultsTest)
#include "faults_test.moc"
