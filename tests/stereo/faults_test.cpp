// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/stereo/faults.h"

#include <QTest>
#include <filesystem>
#include <functional>
#include <random>

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

/// Calibration of a scope whose cameras point 0.8 degrees apart in height.
StereoRig pitched() {
  StereoRig rig = film().rig;
  rig.right_from_left.rotation =
      Eigen::AngleAxisd(0.014, Eigen::Vector3d::UnitX()).toRotationMatrix() * rig.right_from_left.rotation;
  return rig;
}

/// Read back from the recorder's video.
std::vector<StereoFrame> recorded(const std::vector<StereoFrame>& frames) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "operation.mkv";
  VideoWriter writer(path, 2 * frames[0].left.width, frames[0].left.height, 30.0);
  for (const StereoFrame& frame : frames) writer.write(side_by_side(frame));
  writer.close();
  StereoVideo video(path);
  std::vector<StereoFrame> result;
  for (StereoFrame frame; video.read(frame);) result.push_back(frame);
  return result;
}

/// Seen by a camera that has gone `shift` pixels to the right, with the noise of a new exposure.
Picture seen_again(const Picture& picture, int shift, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, 2.0);
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*picture.bytes);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto row = static_cast<std::size_t>(y * picture.width);
        const auto from = static_cast<std::size_t>(std::min(x + shift, picture.width - 1));
        (*bytes)[3 * (row + static_cast<std::size_t>(x)) + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(
                std::clamp((*picture.bytes)[3 * (row + from) + static_cast<std::size_t>(c)] + noise(random),
                           0.0, 255.0));
      }
  return {picture.width, picture.height, 3, std::move(bytes)};
}

/// A scene where nothing moves but, for the first frames, the camera.
void hold_still(std::vector<StereoFrame>& frames, int moving, int pixels) {
  std::mt19937 random(5);  // NOLINT: the same noise on every run
  const StereoFrame first = frames[0];
  for (int i = 0; i < kFrames; ++i) {
    const int shift = pixels * std::min(i, moving);
    frames[static_cast<std::size_t>(i)].left = seen_again(first.left, shift, random);
    frames[static_cast<std::size_t>(i)].right = seen_again(first.right, shift, random);
  }
}

/// Even rows of one picture, odd rows of another one.
Picture woven(const Picture& even, const Picture& odd) {
  auto bytes = std::make_shared<std::vector<std::uint8_t>>(*even.bytes);
  const auto row = static_cast<std::ptrdiff_t>(3 * even.width);
  for (int y = 1; y < even.height; y += 2)
    std::copy_n(odd.bytes->begin() + y * row, row, bytes->begin() + y * row);
  return {even.width, even.height, 3, std::move(bytes)};
}

struct Injury {
  const char* name;
  std::function<void(std::vector<StereoFrame>&)> injure;
  const char* expected;
};
const std::vector<Injury>& injuries() {
  using Frames = std::vector<StereoFrame>;
  static const std::vector<Injury> all{
      {"sound", [](Frames&) {}, ""},
      {"still", [](Frames& frames) { hold_still(frames, 0, 0); }, ""},
      {"comes to rest at once", [](Frames& frames) { hold_still(frames, 8, 3); }, ""},
      {"black",
       [](Frames& frames) {
         for (std::size_t i : {5, 6}) frames[i].left = frames[i].right = filled(frames[0].left, 3);
       },
       "5:black 6:black "},
      {"left lost", [](Frames& frames) { frames[7].left = filled(frames[0].left, 0); }, "7:left_lost "},
      {"right lost", [](Frames& frames) { frames[9].right = filled(frames[0].right, 128); }, "9:right_lost "},
      {"one camera on both inputs",
       [](Frames& frames) {
         for (std::size_t i = 4; i < 7; ++i) frames[i].right = frames[i].left;
       },
       "4:one_view 5:one_view 6:one_view "},
      {"duplicated", [](Frames& frames) { frames.insert(frames.begin() + 8, frames[7]); }, "8:duplicated "},
      {"frozen", [](Frames& frames) { frames.insert(frames.begin() + 15, 7, frames[14]); },
       "15:duplicated 16:duplicated 17:duplicated 18:duplicated 19:duplicated 20:frozen 21:frozen "},
      {"left frozen",
       [](Frames& frames) {
         for (std::size_t i = 6; i < 10; ++i) frames[i].left = frames[5].left;
       },
       "6:left_frozen 7:left_frozen 8:left_frozen 9:left_frozen "},
      {"right frozen",
       [](Frames& frames) {
         for (std::size_t i = 15; i < 18; ++i) frames[i].right = frames[14].right;
       },
       "15:right_frozen 16:right_frozen 17:right_frozen "},
      {"views swapped",
       [](Frames& frames) {
         for (std::size_t i = 6; i < 9; ++i) std::swap(frames[i].left, frames[i].right);
       },
       "6:swapped 7:swapped 8:swapped "},
      {"frames exchanged",
       [](Frames& frames) {
         for (std::size_t i = 0; 3 * i < frames.size(); ++i) frames[i] = frames[3 * i];
         frames.resize(frames.size() / 3);
         std::swap(frames[3], frames[4]);
       },
       "4:out_of_order "}};
  return all;
}

}  // namespace

#define COMPARE_FAULTS(found, expected) QCOMPARE(QByteArray::fromStdString(text(found)), QByteArray(expected))

class FaultsTest : public QObject {
  Q_OBJECT

 private slots:
  void SoundOperationHasNoFaults() { COMPARE_FAULTS(faults_of(film().frames), ""); }

  void ARigIsOfPicturesOfItsSize() {
    StereoRig rig;
    rig.left.width = 64;
    rig.left.height = 48;
    const auto picture = [](int width, int height) { return Picture{width, height, 3, nullptr}; };
    QVERIFY(is_rig_of(rig, picture(64, 48)));
    require_rig_of(rig, picture(64, 48));
    for (const auto& [width, height] : {std::pair(64, 47), {65, 48}}) {
      QVERIFY(!is_rig_of(rig, picture(width, height)));
      QVERIFY_THROWS_EXCEPTION(InputError, require_rig_of(rig, picture(width, height)));
    }
  }

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

  /// As a device takes it that makes one picture of two moments.
  void AnInterlacedOperationIsRecognised() {
    std::vector<StereoFrame> frames;
    for (std::size_t i = 0; i + 1 < film().frames.size(); i += 2) {
      StereoFrame frame = film().frames[i];
      frame.left = woven(frame.left, film().frames[i + 1].left);
      frame.right = woven(frame.right, film().frames[i + 1].right);
      frames.push_back(frame);
    }
    const auto faults = faults_of(frames);
    QCOMPARE(faults.size(), std::size_t{1});
    QVERIFY2(faults[0].fault == Fault::interlaced, text(faults).c_str());
  }

  /// As a recorder stores them: views side by side, with loss. Frames that were alike are not then.
  void FaultsAreRecognisedInARecordedVideo_data() {
    QTest::addColumn<int>("fault");
    for (int i = 0; i < static_cast<int>(injuries().size()); ++i)
      QTest::newRow(injuries()[static_cast<std::size_t>(i)].name) << i;
  }
  void FaultsAreRecognisedInARecordedVideo() {
    QFETCH(int, fault);
    const Injury& injury = injuries()[static_cast<std::size_t>(fault)];
    std::vector<StereoFrame> frames = film().frames;
    injury.injure(frames);
    COMPARE_FAULTS(faults_of(recorded(frames)), injury.expected);
  }

  /// A codec writes a standing picture anew with each key frame, here 12 and 24, and mends it in the next
  /// ones.
  void AFreezeBeginsAndLastsAroundKeyFramesOfARecordedVideo_data() {
    QTest::addColumn<int>("first");
    for (const int first : {6, 11, 12, 13, 14}) QTest::newRow(std::to_string(first).c_str()) << first;
  }
  void AFreezeBeginsAndLastsAroundKeyFramesOfARecordedVideo() {
    QFETCH(int, first);
    std::vector<StereoFrame> frames = film().frames;
    frames.insert(frames.begin() + first, 23 - first, frames[static_cast<std::size_t>(first - 1)]);
    const auto faults = faults_of(recorded(frames));
    QVERIFY2(!faults.empty() && faults.front().frame >= first && faults.front().frame <= first + 3,
             text(faults).c_str());
    QVERIFY2(static_cast<int>(faults.size()) >= 23 - first - 3, text(faults).c_str());
    QVERIFY2(faults.back() == (FrameFault{22, Fault::frozen}), text(faults).c_str());
    int frozen_from = -1;
    for (const FrameFault& fault : faults) {
      if (frozen_from < 0 && fault.fault == Fault::frozen) frozen_from = fault.frame;
      QVERIFY2(fault.fault == (frozen_from < 0 ? Fault::duplicated : Fault::frozen), text(faults).c_str());
    }
    QVERIFY2(frozen_from <= first + 3 + 5, text(faults).c_str());  // a fifth of a second: six frames
  }

  void CalibrationOfAnotherScopeIsRecognisedInARecordedVideo() {
    const StereoFrame frame = recorded({film().frames.begin(), film().frames.begin() + 4}).back();
    QVERIFY(check(frame.left, frame.right).faults.empty());
    QVERIFY(check(frame.right, frame.left).faults == std::vector{Fault::swapped});
    QVERIFY(check(frame.left, frame.right, pitched()).has(Fault::other_scope));
  }

  void RealPairsAreTwoViewsAndOneOfThemTwiceIsOne() {
    const auto data = glisson::test::data_folder();
    const auto opencas = data / "stereo_opencas", heart = data / "stereo_heart";
    if (!std::filesystem::exists(opencas)) QSKIP("the real pairs are not here (see GLISSON_DATA)");
    const std::pair<std::filesystem::path, std::filesystem::path> pairs[] = {
        {opencas / "Stereo_SD_d_complete_22_IMG_left.bmp", opencas / "Stereo_SD_d_complete_22_IMG_right.bmp"},
        {heart / "f7_dynamic_deint_L_0100.png", heart / "f7_dynamic_deint_R_0100.png"}};
    for (const auto& [left, right] : pairs) {
      StereoFrame sound;
      sound.left = read_picture(left);
      sound.right = read_picture(right);
      StereoFrame one = sound;
      one.right = one.left;
      COMPARE_FAULTS(faults_of(recorded({sound, one})), "1:one_view ");
    }
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
    QVERIFY(check(left, right, pitched()).has(Fault::other_scope));
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
